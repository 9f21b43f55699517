//! What the control net of a part of the patch tells: no root, one root at most, a point, edge-on, or nothing yet.

use super::net::{Seen, evaluate};
use super::search::Root;
use crate::algebra::{Scalar, VectorSpace, larger};
use crate::curve::count;

/// A part of a patch counts as seen edge-on when its image is no thicker than the rounding and so many times as long.
///
/// At a pole the image is a sector, which is thin, too, when it is small enough; it is told from a part edge-on by not being long, and halving it
/// 4 times more, until it is a point, costs little. At a silhouette the image is as long as the square root of its thickness, far more than 64 times.
pub const EDGE_ON: i32 = 64;

/// A part whose image is at most so many times as large as the rounding is a point.
const POINT: i32 = 4;

/// Newton's method starts at most 1/2 away and leaves 2/3 of the distance: after so many steps less than 2⁻³⁷ of it, where convergence has long been quadratic.
const NEWTON_STEPS: usize = 64;

/// What is known of a part of the patch.
pub(super) enum Finding<S> {
    /// It has no root that counts.
    Nothing,
    /// It has this root and no other.
    Root(Root<S>),
    /// Halve it, across u (0) or v (1).
    Halve(usize),
}

/// A part of the patch: where it is, and how far its control points may be wrong.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<S> {
    /// The lower corner in the unit square.
    pub(super) corner: [S; 2],
    /// The lengths of the sides.
    pub(super) sides: [S; 2],
    /// A bound on the error of every coordinate of a control point.
    pub(super) rounding: S,
}

/// The smallest and the largest of some numbers.
fn range<S: Scalar>(numbers: impl Iterator<Item = S>) -> [S; 2] {
    let mut numbers = numbers;
    let first = numbers.next().unwrap_or_else(S::zero);
    numbers.fold([first; 2], |[low, high], x| {
        [
            if x < low { x } else { low },
            if x > high { x } else { high },
        ]
    })
}

fn width<S: Scalar>([low, high]: [S; 2]) -> S {
    high - low
}

fn product<S: Scalar>(row: [S; 2], f: &Seen<S>) -> S {
    row[0] * f[0] + row[1] * f[1]
}

/// The equations `G = Y F` of a part, nearly the identity, of which a root is certain to be the only one.
struct Certificate<S> {
    rows: [[S; 2]; 2],
    /// A bound on the error of a value of G.
    rounding: S,
}

/// A part with its control net.
pub(super) struct Examined<'a, S> {
    pub(super) part: Part<S>,
    pub(super) net: &'a [Seen<S>],
    pub(super) degrees: [usize; 2],
    /// The depths between which a root counts, the second one where there is an end.
    pub(super) depths: (S, Option<S>),
}

impl<S: Scalar> Examined<'_, S> {
    // ANCHOR: examine
    pub(super) fn finding(&self, buffer: &mut Vec<Seen<S>>) -> Finding<S> {
        let [a, b, depth] = [0, 1, 2].map(|axis| range(self.net.iter().map(|f| f[axis])));
        let rounding = self.part.rounding;
        let misses = |[low, high]: [S; 2]| low > rounding || high < -rounding;
        if misses(a) || misses(b) || self.is_out_of_reach(depth) {
            return Finding::Nothing;
        }
        let size = [b, depth].map(width).into_iter().fold(width(a), larger);
        if size <= S::from_i32(POINT) * rounding {
            return Finding::Root(self.as_a_point(depth));
        }
        let jacobian = self.mean_jacobian();
        match self.certificate(jacobian) {
            Ok(Some(certificate)) => return self.newton(&certificate, buffer),
            Ok(None) => {}
            Err(NoRoot) => return Finding::Nothing,
        }
        if self.is_passed_or_edge_on(jacobian, size) {
            return Finding::Nothing;
        }
        Finding::Halve(self.longer_side())
    }
    // ANCHOR_END: examine

    /// Whether the part lies before the ray's interval or after it, for certain.
    fn is_out_of_reach(&self, [nearest, farthest]: [S; 2]) -> bool {
        let rounding = self.part.rounding;
        let (start, end) = self.depths;
        farthest + rounding < start || end.is_some_and(|end| nearest - rounding > end)
    }

    /// The root that a part of the size of the rounding is: its middle.
    fn as_a_point(&self, depth: [S; 2]) -> Root<S> {
        let half = S::ratio(1, 2);
        Root {
            parameters: [0, 1].map(|i| self.part.corner[i] + half * self.part.sides[i]),
            depth: half * (depth[0] + depth[1]),
            depth_error: width(depth) + self.part.rounding,
        }
    }

    /// The mean of `∂F/∂s` over the net, and of `∂F/∂t`: differences of opposite sides.
    fn mean_jacobian(&self) -> [Seen<S>; 2] {
        let [columns, rows] = self.degrees.map(|degree| degree + 1);
        let mean = |points: usize, from: &dyn Fn(usize) -> usize, to: &dyn Fn(usize) -> usize| {
            let differences = (0..points).map(|i| self.net[to(i)].minus(self.net[from(i)]));
            let sum = differences.fold([S::zero(); 3], Seen::plus);
            sum.times(S::one() / S::from_i32(count(points)))
        };
        let last_row = (rows - 1) * columns;
        [
            mean(rows, &|j| j * columns, &|j| j * columns + columns - 1),
            mean(columns, &|i| i, &|i| last_row + i),
        ]
    }

    /// Proof that the part has at most one root, where the net gives it; that it has none; or nothing.
    // ANCHOR: certificate
    fn certificate(&self, [f_s, f_t]: [Seen<S>; 2]) -> Result<Option<Certificate<S>>, NoRoot> {
        let determinant = f_s[0] * f_t[1] - f_t[0] * f_s[1];
        let rows = [[f_t[1], -f_t[0]], [-f_s[1], f_s[0]]];
        let rows = rows.map(|row| row.map(|entry| entry / determinant));
        if !rows.as_flattened().iter().all(|entry| entry.is_finite()) {
            return Ok(None);
        }
        let mut is_one_to_one = true;
        let mut largest_rounding = S::zero();
        for (i, row) in rows.into_iter().enumerate() {
            let rounding = self.rounding_of_values(row);
            largest_rounding = larger(largest_rounding, rounding);
            let [low, high] = range(self.net.iter().map(|f| product(row, f)));
            if low > rounding || high < -rounding {
                return Err(NoRoot);
            }
            is_one_to_one &= self.distance_from_identity(row, i, rounding) <= S::ratio(1, 4);
        }
        Ok(is_one_to_one.then_some(Certificate {
            rows,
            rounding: largest_rounding,
        }))
    }
    // ANCHOR_END: certificate

    /// A bound on the error of `row · F` at a control point or at a point of the part. F is at most 2 in each coordinate. Its error is that of the control points;
    /// `p + q` interpolations have three roundoffs of 2 each; the two products and their sum four of the row, and one for the second order.
    fn rounding_of_values(&self, row: [S; 2]) -> S {
        let [p, q] = self.degrees;
        let roundoffs = S::from_i32(count(6 * (p + q) + 5)) * S::unit_roundoff();
        (row[0].magnitude() + row[1].magnitude()) * (self.part.rounding + roundoffs)
    }

    /// The largest sum of the absolute values in a row of `G' − I` on the part, rounding included: derivatives lie between the differences of control points.
    fn distance_from_identity(&self, row: [S; 2], index: usize, rounding: S) -> S {
        let [p, q] = self.degrees;
        let columns = p + 1;
        let value = |place: usize| product(row, &self.net[place]);
        let expected = [0, 1].map(|i| if i == index { S::one() } else { S::zero() });
        let mut largest = [S::zero(); 2];
        for place in 0..self.net.len() {
            let here = value(place);
            let mut note = |direction: usize, degree: usize, next: usize| {
                let slope = S::from_i32(count(degree)) * (value(next) - here);
                let off = (slope - expected[direction]).magnitude();
                largest[direction] = larger(largest[direction], off);
            };
            if place % columns < p {
                note(0, p, place + 1);
            }
            if place / columns < q {
                note(1, q, place + columns);
            }
        }
        largest[0] + largest[1] + S::from_i32(count(2 * (p + q))) * rounding
    }

    /// Newton's method from the middle of a part that has at most one root, every step clamped to the part: a root in it is found, and where none is, the
    /// steps run into a side and stay there.
    // ANCHOR: newton
    fn newton(&self, certificate: &Certificate<S>, buffer: &mut Vec<Seen<S>>) -> Finding<S> {
        let goal = S::from_i32(4) * certificate.rounding;
        let mut place = [S::ratio(1, 2); 2];
        let mut best: Option<(S, [S; 2], S)> = None;
        for _ in 0..NEWTON_STEPS {
            let [f, f_s, f_t] = evaluate(self.net, self.degrees, place, buffer);
            let values = certificate.rows.map(|row| product(row, &f).magnitude());
            let residual = larger(values[0], values[1]);
            let improves = best.is_none_or(|(least, ..)| residual < least);
            if improves && residual <= goal {
                best = Some((residual, place, f[2]));
            } else if best.is_some() {
                break;
            }
            let determinant = f_s[0] * f_t[1] - f_t[0] * f_s[1];
            let steps = [
                (f[0] * f_t[1] - f_t[0] * f[1]) / determinant,
                (f_s[0] * f[1] - f[0] * f_s[1]) / determinant,
            ];
            let next = [0, 1].map(|i| clamped(place[i] - steps[i]));
            if next == place {
                break;
            }
            place = next;
        }
        let found = best.map(|(residual, place, depth)| {
            self.root(place, depth, residual + certificate.rounding)
        });
        found.map_or(Finding::Nothing, Finding::Root)
    }
    // ANCHOR_END: newton

    /// The root near a place where G is so small. As `|G(x)| >= 3/4 |x − root|`, the root is at most 4/3 of that away; the depth changes by at most its
    /// largest derivatives times that.
    fn root(&self, place: [S; 2], depth: S, residual: S) -> Root<S> {
        let [p, q] = self.degrees;
        let columns = p + 1;
        let mut slopes = [S::zero(); 2];
        for at in 0..self.net.len() {
            let step = |next: usize| (self.net[next][2] - self.net[at][2]).magnitude();
            if at % columns < p {
                slopes[0] = larger(slopes[0], step(at + 1));
            }
            if at / columns < q {
                slopes[1] = larger(slopes[1], step(at + columns));
            }
        }
        let change = S::from_i32(count(p)) * slopes[0] + S::from_i32(count(q)) * slopes[1];
        let evaluation = S::from_i32(count(3 * (p + q))) * S::unit_roundoff();
        Root {
            parameters: [0, 1].map(|i| self.part.corner[i] + place[i] * self.part.sides[i]),
            depth,
            depth_error: S::ratio(4, 3) * residual * change + self.part.rounding + evaluation,
        }
    }

    /// Whether, across its length, the image of the part lies beside the ray, or is thinner than the rounding and long: edge-on.
    fn is_passed_or_edge_on(&self, jacobian: [Seen<S>; 2], size: S) -> bool {
        let sizes = jacobian.map(|column| larger(column[0].magnitude(), column[1].magnitude()));
        let longer = usize::from(sizes[1] > sizes[0]);
        let across = if sizes[longer].is_zero() {
            [S::one(), S::zero()]
        } else {
            let column = jacobian[longer];
            [-column[1] / sizes[longer], column[0] / sizes[longer]]
        };
        // The row is at most 2 in sum: twice the rounding of the points, and that of its own products.
        let rounding = self.rounding_of_values(across);
        let [low, high] = range(self.net.iter().map(|f| product(across, f)));
        let passes = low > rounding || high < -rounding;
        let is_thin = high <= rounding && low >= -rounding;
        passes || (is_thin && size >= S::from_i32(EDGE_ON) * self.part.rounding)
    }

    /// The direction, u (0) or v (1), across which the part's image is to be halved: that of the longest step between its control points.
    fn longer_side(&self) -> usize {
        let [p, q] = self.degrees;
        let columns = p + 1;
        let mut longest = [S::zero(); 2];
        for at in 0..self.net.len() {
            let step = |next: usize| self.net[next].minus(self.net[at]).largest_coordinate();
            if at % columns < p {
                longest[0] = larger(longest[0], step(at + 1) * S::from_i32(count(p)));
            }
            if at / columns < q {
                longest[1] = larger(longest[1], step(at + columns) * S::from_i32(count(q)));
            }
        }
        usize::from(longest[1] > longest[0])
    }
}

/// There is no root, for certain.
struct NoRoot;

/// The number, moved to the nearer end of `[0, 1]` where it lies outside.
fn clamped<S: Scalar>(x: S) -> S {
    if x < S::zero() {
        S::zero()
    } else if x > S::one() {
        S::one()
    } else {
        x
    }
}
