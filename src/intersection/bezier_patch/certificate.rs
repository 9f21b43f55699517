//! What the control net of a part of the patch tells: no root, one root at most, a point, edge-on, or nothing yet.

use super::ROUNDOFF;
use super::net::{Seen, evaluate};
use super::search::Root;
use crate::algebra::VectorSpace;

/// A part of a patch counts as seen edge-on when its image is no thicker than the rounding and so many times as long.
///
/// At a pole the image is a sector, which is thin, too, when it is small enough; it is told from a part edge-on by not being long, and halving it
/// 4 times more, until it is a point, costs little. At a silhouette the image is as long as the square root of its thickness, far more than 64 times.
pub const EDGE_ON: f64 = 64.0;

/// A part whose image is at most so many times as large as the rounding is a point.
const POINT: f64 = 4.0;

/// Newton's method starts at most 1/2 away and leaves 2/3 of the distance: after so many steps less than 2⁻³⁷ of it, where convergence has long been quadratic.
const NEWTON_STEPS: usize = 64;

/// What is known of a part of the patch.
pub(super) enum Finding {
    /// It has no root that counts.
    Nothing,
    /// It has this root and no other.
    Root(Root),
    /// Halve it, across u (0) or v (1).
    Halve(usize),
}

/// A part of the patch: where it is, and how far its control points may be wrong.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The lower corner in the unit square.
    pub(super) corner: [f64; 2],
    /// The lengths of the sides.
    pub(super) sides: [f64; 2],
    /// A bound on the error of every coordinate of a control point.
    pub(super) rounding: f64,
}

/// The smallest and the largest of some numbers.
fn range(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    })
}

fn width([low, high]: [f64; 2]) -> f64 {
    high - low
}

fn product(row: [f64; 2], f: &Seen) -> f64 {
    row[0] * f[0] + row[1] * f[1]
}

/// The equations `G = Y F` of a part, nearly the identity, of which a root is certain to be the only one.
struct Certificate {
    rows: [[f64; 2]; 2],
    /// A bound on the error of a value of G.
    rounding: f64,
}

/// A part with its control net.
pub(super) struct Examined<'a> {
    pub(super) part: Part,
    pub(super) net: &'a [Seen],
    pub(super) degrees: [usize; 2],
    /// The depths between which a root counts, the second one where there is an end.
    pub(super) depths: (f64, Option<f64>),
}

impl Examined<'_> {
    // ANCHOR: examine
    pub(super) fn finding(&self, buffer: &mut Vec<Seen>) -> Finding {
        let [a, b, depth] = [0, 1, 2].map(|axis| range(self.net.iter().map(|f| f[axis])));
        let rounding = self.part.rounding;
        let misses = |[low, high]: [f64; 2]| low > rounding || high < -rounding;
        if misses(a) || misses(b) || self.is_out_of_reach(depth) {
            return Finding::Nothing;
        }
        let size = width(a).max(width(b)).max(width(depth));
        if size <= POINT * rounding {
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
    fn is_out_of_reach(&self, [nearest, farthest]: [f64; 2]) -> bool {
        let rounding = self.part.rounding;
        let (start, end) = self.depths;
        farthest + rounding < start || end.is_some_and(|end| nearest - rounding > end)
    }

    /// The root that a part of the size of the rounding is: its middle.
    fn as_a_point(&self, depth: [f64; 2]) -> Root {
        Root {
            parameters: [0, 1].map(|i| self.part.corner[i] + 0.5 * self.part.sides[i]),
            depth: 0.5 * (depth[0] + depth[1]),
            depth_error: width(depth) + self.part.rounding,
            is_point: true,
        }
    }

    /// The mean of `∂F/∂s` over the net, and of `∂F/∂t`: differences of opposite sides.
    fn mean_jacobian(&self) -> [Seen; 2] {
        let [columns, rows] = self.degrees.map(|degree| degree + 1);
        let mean = |points: usize, from: &dyn Fn(usize) -> usize, to: &dyn Fn(usize) -> usize| {
            let differences = (0..points).map(|i| self.net[to(i)].minus(self.net[from(i)]));
            let sum = differences.fold([0.0; 3], Seen::plus);
            sum.times(1.0 / points as f64)
        };
        let last_row = (rows - 1) * columns;
        [
            mean(rows, &|j| j * columns, &|j| j * columns + columns - 1),
            mean(columns, &|i| i, &|i| last_row + i),
        ]
    }

    /// Proof that the part has at most one root, where the net gives it; that it has none; or nothing.
    // ANCHOR: certificate
    fn certificate(&self, [f_s, f_t]: [Seen; 2]) -> Result<Option<Certificate>, NoRoot> {
        let determinant = f_s[0] * f_t[1] - f_t[0] * f_s[1];
        let rows = [[f_t[1], -f_t[0]], [-f_s[1], f_s[0]]];
        let rows = rows.map(|row| row.map(|entry| entry / determinant));
        if !rows.as_flattened().iter().all(|entry| entry.is_finite()) {
            return Ok(None);
        }
        let mut is_one_to_one = true;
        let mut largest_rounding = 0.0_f64;
        for (i, row) in rows.into_iter().enumerate() {
            let rounding = self.rounding_of_values(row);
            largest_rounding = largest_rounding.max(rounding);
            let [low, high] = range(self.net.iter().map(|f| product(row, f)));
            if low > rounding || high < -rounding {
                return Err(NoRoot);
            }
            is_one_to_one &= self.distance_from_identity(row, i, rounding) <= 0.25;
        }
        Ok(is_one_to_one.then_some(Certificate {
            rows,
            rounding: largest_rounding,
        }))
    }
    // ANCHOR_END: certificate

    /// A bound on the error of `row · F` at a control point or at a point of the part. F is at most 2 in each coordinate. Its error is that of the control points;
    /// `p + q` interpolations have three roundoffs of 2 each; the two products and their sum four of the row, and one for the second order.
    fn rounding_of_values(&self, row: [f64; 2]) -> f64 {
        let [p, q] = self.degrees;
        let roundoffs = (6 * (p + q) + 5) as f64 * ROUNDOFF;
        (row[0].abs() + row[1].abs()) * (self.part.rounding + roundoffs)
    }

    /// The largest sum of the absolute values in a row of `G' − I` on the part, rounding included: derivatives lie between the differences of control points.
    fn distance_from_identity(&self, row: [f64; 2], index: usize, rounding: f64) -> f64 {
        let [p, q] = self.degrees;
        let value = |place: usize| product(row, &self.net[place]);
        let expected = [0, 1].map(|i| if i == index { 1.0 } else { 0.0 });
        let largest = self.largest_slopes(|direction, degree, from, to| {
            (degree * (value(to) - value(from)) - expected[direction]).abs()
        });
        largest[0] + largest[1] + (2 * (p + q)) as f64 * rounding
    }

    /// The largest of the numbers that `slope(direction, degree, from, to)` makes of neighbouring control points, along u and along v.
    fn largest_slopes(&self, slope: impl Fn(usize, f64, usize, usize) -> f64) -> [f64; 2] {
        let [p, q] = self.degrees;
        let columns = p + 1;
        let mut largest = [0.0_f64; 2];
        for from in 0..self.net.len() {
            if from % columns < p {
                largest[0] = largest[0].max(slope(0, p as f64, from, from + 1));
            }
            if from / columns < q {
                largest[1] = largest[1].max(slope(1, q as f64, from, from + columns));
            }
        }
        largest
    }

    /// Newton's method from the middle of a part that has at most one root, every step clamped to the part: a root in it is found, and where none is, the
    /// steps run into a side and stay there.
    // ANCHOR: newton
    fn newton(&self, certificate: &Certificate, buffer: &mut Vec<Seen>) -> Finding {
        let goal = 4.0 * certificate.rounding;
        let mut place = [0.5; 2];
        let mut best: Option<(f64, [f64; 2], f64)> = None;
        for _ in 0..NEWTON_STEPS {
            let [f, f_s, f_t] = evaluate(self.net, self.degrees, place, buffer);
            let values = certificate.rows.map(|row| product(row, &f).abs());
            let residual = values[0].max(values[1]);
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
            let next = [0, 1].map(|i| (place[i] - steps[i]).clamp(0.0, 1.0));
            if next.map(f64::to_bits) == place.map(f64::to_bits) {
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
    fn root(&self, place: [f64; 2], depth: f64, residual: f64) -> Root {
        let [p, q] = self.degrees;
        let slopes = self.largest_slopes(|_, degree, from, to| {
            degree * (self.net[to][2] - self.net[from][2]).abs()
        });
        let change = slopes[0] + slopes[1];
        let evaluation = (3 * (p + q)) as f64 * ROUNDOFF;
        Root {
            parameters: [0, 1].map(|i| self.part.corner[i] + place[i] * self.part.sides[i]),
            depth,
            depth_error: 4.0 / 3.0 * residual * change + self.part.rounding + evaluation,
            is_point: false,
        }
    }

    /// Whether, across its length, the image of the part lies beside the ray, or is thinner than the rounding and long: edge-on.
    fn is_passed_or_edge_on(&self, jacobian: [Seen; 2], size: f64) -> bool {
        let sizes = jacobian.map(|column| column[0].abs().max(column[1].abs()));
        let longer = usize::from(sizes[1] > sizes[0]);
        let across = if sizes[longer] == 0.0 {
            [1.0, 0.0]
        } else {
            let column = jacobian[longer];
            [-column[1] / sizes[longer], column[0] / sizes[longer]]
        };
        // The row is at most 2 in sum: twice the rounding of the points, and that of its own products.
        let rounding = self.rounding_of_values(across);
        let [low, high] = range(self.net.iter().map(|f| product(across, f)));
        let passes = low > rounding || high < -rounding;
        let is_thin = high <= rounding && low >= -rounding;
        passes || (is_thin && size >= EDGE_ON * self.part.rounding)
    }

    /// The direction, u (0) or v (1), across which the part's image is to be halved: that of the longest step between its control points.
    fn longer_side(&self) -> usize {
        let longest = self.largest_slopes(|_, degree, from, to| {
            let step = self.net[to].minus(self.net[from]);
            degree * step[0].abs().max(step[1].abs())
        });
        usize::from(longest[1] > longest[0])
    }
}

/// There is no root, for certain.
struct NoRoot;
