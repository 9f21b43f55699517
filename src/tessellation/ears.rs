//! Simple polygons of the parameter plane cut into triangles.

use crate::algebra::Scalar;

/// Twice the signed area of a triangle, where its sign is certain; zero where rounding may have made it.
///
/// Each product carries three roundings and the difference one more: the error is below `4u` of the sum of their absolute values, to first
/// order; the fifth unit covers the rest.
pub(super) fn turn<S: Scalar>(a: [S; 2], b: [S; 2], c: [S; 2]) -> S {
    let left = (b[0] - a[0]) * (c[1] - a[1]);
    let right = (b[1] - a[1]) * (c[0] - a[0]);
    let area = left - right;
    let rounding = S::from_i32(5) * S::unit_roundoff() * (left.magnitude() + right.magnitude());
    if area.magnitude() > rounding {
        area
    } else {
        S::zero()
    }
}

/// The triangles of a simple polygon that runs anticlockwise, corner by corner the ear whose smallest angle is largest; fewer than
/// `corners.len() − 2` where rounding hides the last ears, which then have no area that could be told.
///
/// # Cost
///
/// O(n³) in the worst case, O(n²) for most: for loops of some hundreds of corners.
///
/// # Source
///
/// Meisters 1975: every simple polygon with more than three corners has two ears.
// ANCHOR: ears
pub(super) fn ears<S: Scalar>(corners: &[[S; 2]]) -> Vec<[u32; 3]> {
    let mut left: Vec<u32> = (0..).take(corners.len()).collect();
    let mut triangles = Vec::new();
    while left.len() >= 3 {
        let count = left.len();
        let around = |at: usize| {
            [
                left[(at + count - 1) % count],
                left[at],
                left[(at + 1) % count],
            ]
        };
        let quality = |at: usize| {
            let ear = around(at);
            let points = ear.map(|corner| corners[corner as usize]);
            let is_free =
                |&&other: &&u32| !ear.contains(&other) && covers(points, corners[other as usize]);
            let area = turn(points[0], points[1], points[2]);
            (area > S::zero() && left.iter().find(is_free).is_none()).then(|| shape(points, area))
        };
        let ears = (0..count).filter_map(|at| Some((at, quality(at)?)));
        let best = ears.reduce(|best, next| if next.1 > best.1 { next } else { best });
        let Some((at, _)) = best else { break };
        triangles.push(around(at));
        left.remove(at);
    }
    triangles
}
// ANCHOR_END: ears

/// Area over the square of the longest side: the higher, the better shaped.
fn shape<S: Scalar>([a, b, c]: [[S; 2]; 3], area: S) -> S {
    let square =
        |p: [S; 2], q: [S; 2]| (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
    let longest = [square(b, c), square(c, a)]
        .into_iter()
        .fold(
            square(a, b),
            |longest, side| if side > longest { side } else { longest },
        );
    area / longest
}

/// Whether a triangle, its edges included, covers the point.
fn covers<S: Scalar>([a, b, c]: [[S; 2]; 3], point: [S; 2]) -> bool {
    [[a, b], [b, c], [c, a]]
        .into_iter()
        .all(|[from, to]| turn(from, to, point) >= S::zero())
}
