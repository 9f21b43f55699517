//! The patches of this chapter in arbitrary precision: written from their definitions, apart from the library.

use num_traits::{One, Zero};

use crate::common::oracle::{Big, big, big_combination};

/// A point without rounding.
pub type Point = [Big; 3];

/// What the bilinear patch takes from its boundary at one pair of parameters.
pub struct BilinearData {
    /// `P1(u), P2(u), Q1(v), Q2(v)`.
    pub edge_points: [Point; 4],
    /// `A, B, C, D`.
    pub corners: [Point; 4],
}

/// The point of the bilinear patch.
pub fn bilinear(data: &BilinearData, u: &Big, v: &Big) -> Point {
    let [s, t] = [one() - u, one() - v];
    let in_edges = [t.clone(), v.clone(), s.clone(), u.clone()];
    let in_corners = [-(&s * &t), -(u * &t), -(u * v), -(&s * v)];
    weighted(
        [&in_edges[..], &in_corners],
        [&data.edge_points, &data.corners],
    )
}

/// The partial derivatives `[S_u, S_v]` of the bilinear patch whose edges have the given derivatives.
pub fn partials(data: &BilinearData, derivatives: &[Point; 4], u: &Big, v: &Big) -> [Point; 2] {
    let [s, t] = [one() - u, one() - v];
    let [zero, one] = [Big::zero(), one()];
    let s_u = weighted(
        [
            &[t.clone(), v.clone(), zero.clone(), zero.clone()][..],
            &[zero.clone(), zero.clone(), -&one, one.clone()],
            &[t.clone(), -&t, -v, v.clone()],
        ],
        [derivatives, &data.edge_points, &data.corners],
    );
    let s_v = weighted(
        [
            &[zero.clone(), zero.clone(), s.clone(), u.clone()][..],
            &[-&one, one.clone(), zero.clone(), zero.clone()],
            &[s.clone(), u.clone(), -u, -&s],
        ],
        [derivatives, &data.edge_points, &data.corners],
    );
    [s_u, s_v]
}

/// What the bicubically blended patch takes from its data at one pair of parameters.
pub struct BicubicData {
    /// `P1, p1_v, p2_v, P2` at u.
    pub along_u: [Point; 4],
    /// `Q1, q1_u, q2_u, Q2` at v.
    pub along_v: [Point; 4],
    /// The corner vectors, rows the u data and columns the v data; the four places of the twists do not count.
    pub vectors: [[Point; 4]; 4],
    /// The twists at A, B, C, D as the cross derivatives of P1 and P2 give them.
    pub twists_from_p: [Point; 4],
    /// The same as those of Q1 and Q2 give them.
    pub twists_from_q: [Point; 4],
}

/// The point of the bicubically blended patch, with Gregory's twists.
pub fn bicubic(data: &BicubicData, u: &Big, v: &Big) -> Point {
    let [in_u, in_v] = [hermite(u), hermite(v)];
    let twists = gregory(data, u, v);
    let mut weights = [in_v.clone(), in_u.clone()].concat();
    let mut points = [data.along_u.clone(), data.along_v.clone()].concat();
    for (i, row) in data.vectors.iter().enumerate() {
        for (j, vector) in row.iter().enumerate() {
            weights.push(-(&in_u[i] * &in_v[j]));
            let twist = TWIST_PLACES.iter().position(|&place| place == (i, j));
            points.push(twist.map_or(vector, |corner| &twists[corner]).clone());
        }
    }
    big_combination(&weights, &points)
}

/// Where the twists at A, B, C, D stand among the corner vectors.
const TWIST_PLACES: [(usize, usize); 4] = [(1, 1), (2, 1), (2, 2), (1, 2)];

/// Each twist `(x q + y p) / (x + y)`, with the distances x and y from its corner.
fn gregory(data: &BicubicData, u: &Big, v: &Big) -> [Point; 4] {
    let [s, t] = [one() - u, one() - v];
    let distances = [[u, v], [&s, v], [&s, &t], [u, &t]];
    std::array::from_fn(|corner| {
        let [x, y] = distances[corner];
        let whole = x + y;
        let [p, q] = [&data.twists_from_p[corner], &data.twists_from_q[corner]];
        if whole.is_zero() {
            return q.clone();
        }
        std::array::from_fn(|axis| (x * &q[axis] + y * &p[axis]) / &whole)
    })
}

/// Hermite's cubics, from their coefficients in the powers of t.
fn hermite(t: &Big) -> [Big; 4] {
    let [two, three] = [2.0, 3.0].map(big);
    let [square, cube] = [t * t, t * t * t];
    [
        one() - &three * &square + &two * &cube,
        t - &two * &square + &cube,
        &cube - &square,
        &three * &square - &two * &cube,
    ]
}

fn one() -> Big {
    Big::one()
}

/// The sum of weighted lists of four points.
fn weighted<const N: usize>(weights: [&[Big]; N], points: [&[Point; 4]; N]) -> Point {
    let points: Vec<Point> = points.into_iter().flatten().cloned().collect();
    big_combination(&weights.concat(), &points)
}
