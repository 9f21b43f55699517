//! Nets of points in rows, refined by a mask in both directions: uniform B-splines without a mesh.
#![allow(
    dead_code,
    reason = "the tests and the exercises use their part of these"
)]

use facette::algebra::{Scalar, VectorSpace};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::meshes::{Cage, Topology, grid, triangle_grid};

/// Rows of points, all of one length.
pub type Rows<P> = Vec<Vec<P>>;

/// A point of space, and the column and row where it stands.
pub type Placed = [Exact; 5];

/// A grid of quadrilaterals with points at random, each of which knows its column and row.
pub fn grid_of(columns: u32, rows: u32) -> impl Strategy<Value = Cage<Placed>> {
    placed(grid(columns, rows), columns)
}

/// As [`grid_of`], each quadrilateral cut into two triangles.
pub fn triangle_grid_of(columns: u32, rows: u32) -> impl Strategy<Value = Cage<Placed>> {
    placed(triangle_grid(columns, rows), columns)
}

fn placed(topology: Topology, columns: u32) -> impl Strategy<Value = Cage<Placed>> {
    vec(point(), topology.vertex_count).prop_map(move |points| {
        let width = i32::try_from(columns).expect("a small grid") + 1;
        let at = |(index, [x, y, z]): (i32, [Exact; 3])| {
            [
                x,
                y,
                z,
                fraction(index % width, 1),
                fraction(index / width, 1),
            ]
        };
        Cage {
            name: topology.name.clone(),
            mesh: topology.with_points((0..).zip(points).map(at).collect()),
        }
    })
}

/// The points row by row, as their places say.
pub fn in_rows(points: &[Placed]) -> Rows<Placed> {
    let mut sorted = points.to_vec();
    let place = |point: &Placed| [point[4], point[3]];
    sorted.sort_by(|a, b| {
        place(a)
            .partial_cmp(&place(b))
            .expect("exact numbers are ordered")
    });
    sorted
        .chunk_by(|a, b| a[4] == b[4])
        .map(<[Placed]>::to_vec)
        .collect()
}

/// Columns for rows.
pub fn transposed<P: VectorSpace>(rows: &Rows<P>) -> Rows<P> {
    let columns = 0..rows[0].len();
    columns
        .map(|i| rows.iter().map(|row| row[i]).collect())
        .collect()
}

/// A net refined in both directions by a rule for one row.
pub fn refined_rows<P: VectorSpace>(rows: &Rows<P>, row: impl Fn(&[P]) -> Vec<P>) -> Rows<P> {
    let along: Rows<P> = rows.iter().map(|points| row(points)).collect();
    let across: Rows<P> = transposed(&along)
        .iter()
        .map(|points| row(points))
        .collect();
    transposed(&across)
}

/// Every second place is empty, then each point spreads over its neighbours by the mask, `weights` over `sum`: the knots of a uniform
/// B-spline inserted half way between the old ones. Only what the mask covers on both sides is left.
pub fn halved<P: VectorSpace>(points: &[P], weights: &[i32], sum: i32) -> Vec<P> {
    let (length, reach) = (2 * points.len() - 1, weights.len());
    let full = length + reach - 1;
    let mut spread = vec![P::origin(); full];
    for (index, point) in points.iter().enumerate() {
        for (offset, &weight) in weights.iter().enumerate() {
            let place = &mut spread[2 * index + offset];
            *place = place.plus(point.times(P::Scalar::ratio(weight, sum)));
        }
    }
    // A new point is complete where all old points that count for it are there.
    let incomplete = reach - 2;
    spread[incomplete..full - incomplete].to_vec()
}

/// A row refined as a cubic B-spline whose ends are those of the row: beyond each end stands the reflection of the point next to it.
pub fn cubic_row<P: VectorSpace>(points: &[P]) -> Vec<P> {
    let beyond = |end: P, next: P| end.plus(end.minus(next));
    let last = points.len() - 1;
    let longer = [
        &[beyond(points[0], points[1])],
        points,
        &[beyond(points[last], points[last - 1])],
    ]
    .concat();
    without_ends(&halved(&longer, &[1, 4, 6, 4, 1], 8))
}

/// A row refined as a quadratic B-spline whose end points stand twice.
pub fn quadratic_row<P: VectorSpace>(points: &[P]) -> Vec<P> {
    let longer = [&points[..1], points, &points[points.len() - 1..]].concat();
    without_ends(&halved(&longer, &[1, 3, 3, 1], 4))
}

/// The refined row ends as the old one does; what stands beyond makes the same ending anew.
fn without_ends<P: VectorSpace>(points: &[P]) -> Vec<P> {
    points[1..points.len() - 1].to_vec()
}

#[test]
fn rows_are_refined_by_their_masks() {
    // Four points of a cubic leave the five control points of its two halves.
    assert_eq!(
        halved(&[0.0, 8.0, 16.0, 24.0], &[1, 4, 6, 4, 1], 8),
        [4.0, 8.0, 12.0, 16.0, 20.0]
    );
    assert_eq!(
        halved(&[0.0, 4.0, 8.0], &[1, 3, 3, 1], 4),
        [1.0, 3.0, 5.0, 7.0]
    );
    assert_eq!(cubic_row(&[0.0, 8.0]), [0.0, 4.0, 8.0]);
    assert_eq!(quadratic_row(&[0.0, 8.0]), [0.0, 2.0, 6.0, 8.0]);
}
