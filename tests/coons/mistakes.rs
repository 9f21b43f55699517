//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{Boundary, Corners, HermiteBoundary, hermite_basis as right_basis};
use facette::curve::Curve;

pub use mistake::Mistake;
use mistake::mistake;

#[path = "../common/mistake.rs"]
mod mistake;

/// All typical mistakes of the chapter.
#[rustfmt::skip]
pub const MISTAKES: &[Mistake] = &[
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "forgotten_s3",
        "S1 + S2 counts the bilinear surface of the corners twice: subtract S3"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "added_s3",
        "S3 has the wrong sign: it is subtracted, S = S1 + S2 - S3"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "swapped_corners",
        "the corners C and D are swapped in S3: C = S(1,1) lies opposite A, D = S(0,1) above it"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "exchanged_weights_in_s3",
        "u and v are exchanged in S3: B belongs to u(1-v), D to v(1-u)"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "exchanged_parameters",
        "the curves get each other's parameter: P1 and P2 run in u, Q1 and Q2 in v"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "exchanged_parameter_of_p1_and_p2",
        "P1 and P2 run in u: take their points at u, and v as the weight between them"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "exchanged_parameter_of_p1",
        "P1 runs in u, as P2 does: take its point at u"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "exchanged_weights",
        "the ruled surfaces have each other's weights: S1 blends P1 and P2 by v, S2 blends Q1 and Q2 by u"),
    mistake(["bilinear", "patch_interpolates_its_four_corners"], "forgotten_corner_c",
        "S3 lacks its last term uvC"),
    mistake(["bilinear", "patch_interpolates_p1_and_p2"], "averaged",
        "the mean of S1 and S2 meets the corners only: a sum less S3 is needed, not a mean"),
    mistake(["bilinear", "patch_interpolates_q1_and_q2"], "only_s1",
        "S1 alone knows nothing of Q1 and Q2: add S2 and subtract S3"),
    mistake(["bilinear", "straight_edges_give_the_bilinear_patch"], "smooth_weights",
        "the weights are to be linear, 1-t and t: other weights meet the edges too, but bend a flat patch's grid"),
    mistake(["derivative", "partials_along_an_edge_are_the_edge_curves_derivatives"], "exchanged_partials",
        "S_u and S_v are exchanged: return [S_u, S_v]"),
    mistake(["derivative", "partials_along_an_edge_are_the_edge_curves_derivatives"], "forgotten_difference",
        "in S_u the weights of S2 depend on u as well: their derivative gives Q2(v) - Q1(v), in S_v likewise P2(u) - P1(u)"),
    mistake(["derivative", "partials_along_an_edge_are_the_edge_curves_derivatives"], "reversed_difference",
        "a difference has the wrong sign: d/du [(1-u)Q1 + u Q2] = Q2 - Q1"),
    mistake(["derivative", "partials_along_an_edge_are_the_edge_curves_derivatives"], "forgotten_s3_derivative",
        "S3 depends on u and on v too: subtract its derivative"),
    mistake(["derivative", "partials_along_an_edge_are_the_edge_curves_derivatives"], "frozen_s3_derivative",
        "the derivative of S3 in u is not B - A everywhere: it goes over to C - D as v goes to 1"),
    mistake(["bicubic", "hermite_basis_carries_one_datum_each"], "swapped_slopes",
        "the cubics of the two slopes are swapped: the second carries the slope at 0, the third the slope at 1"),
    mistake(["bicubic", "hermite_basis_carries_one_datum_each"], "sign_of_the_end_slope",
        "the cubic of the slope at 1 has the wrong sign: -t^2 (1-t) falls below 0 before it rises"),
    mistake(["bicubic", "bicubic_patch_interpolates_its_four_boundary_curves"], "bicubic_without_s3",
        "the tensor product of the corner vectors, S3, must be subtracted, as in the bilinear patch"),
    mistake(["bicubic", "bicubic_patch_interpolates_its_four_boundary_curves"], "transposed_corner_vectors",
        "the table of corner vectors is transposed: its rows belong to u, its columns to v"),
    mistake(["bicubic", "bicubic_patch_has_the_given_cross_derivatives"], "zero_twists",
        "the four twists are missing: the middle of the table of corner vectors is not zero"),
    mistake(["bicubic", "bicubic_patch_has_the_given_cross_derivatives"], "positions_only",
        "only the positions are blended: the cross derivatives belong into S1 and S2 with the slope cubics"),
];

/// What the mistake makes of the bilinear patch; `None` for a mistake of another function.
pub fn bilinear_point<C: Curve>(
    mistake: &str,
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<C::Point> {
    let Corners { a, b, c, d } = boundary.corners();
    let [p1, p2, q1, q2] = [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()];
    let s1 = p1.point(u).lerp(p2.point(u), v);
    let s2 = q1.point(v).lerp(q2.point(v), u);
    let s3 = |a: C::Point, b: C::Point, c: C::Point, d: C::Point, u, v| {
        a.lerp(b, u).lerp(d.lerp(c, u), v)
    };
    let right_s3 = s3(a, b, c, d, u, v);
    let whole = |s1: C::Point, s2: C::Point, s3: C::Point| s1.plus(s2).minus(s3);
    Some(match mistake {
        "forgotten_s3" => s1.plus(s2),
        "added_s3" => s1.plus(s2).plus(right_s3),
        "swapped_corners" => whole(s1, s2, s3(a, b, d, c, u, v)),
        "exchanged_weights_in_s3" => whole(s1, s2, s3(a, b, c, d, v, u)),
        "exchanged_parameters" => {
            let s1 = p1.point(v).lerp(p2.point(v), v);
            whole(s1, q1.point(u).lerp(q2.point(u), u), right_s3)
        }
        "exchanged_parameter_of_p1_and_p2" => whole(p1.point(v).lerp(p2.point(v), v), s2, right_s3),
        "exchanged_parameter_of_p1" => whole(p1.point(v).lerp(p2.point(u), v), s2, right_s3),
        "exchanged_weights" => {
            let s1 = p1.point(u).lerp(p2.point(u), u);
            whole(s1, q1.point(v).lerp(q2.point(v), v), right_s3)
        }
        "forgotten_corner_c" => whole(s1, s2, right_s3.minus(c.times(u * v))),
        "averaged" => s1.lerp(s2, C::Scalar::ratio(1, 2)),
        "only_s1" => s1,
        "smooth_weights" => {
            let smooth = |t: C::Scalar| t * t * (C::Scalar::from_i32(3) - t - t);
            let [x, y] = [smooth(u), smooth(v)];
            let s1 = p1.point(u).lerp(p2.point(u), y);
            whole(s1, q1.point(v).lerp(q2.point(v), x), s3(a, b, c, d, x, y))
        }
        _ => return None,
    })
}

/// What the mistake makes of the partial derivatives; the outer `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "of which the inner one is the answer of the function that is imitated"
)]
pub fn bilinear_partials<C: Curve>(
    mistake: &str,
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<Option<[C::Point; 2]>> {
    let is_mine = MISTAKES
        .iter()
        .any(|m| m.name == mistake && m.exercise == "derivative");
    is_mine.then(|| wrong_partials(mistake, boundary, u, v))
}

fn wrong_partials<C: Curve>(
    mistake: &str,
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<[C::Point; 2]> {
    let Corners { a, b, c, d } = boundary.corners();
    let [p1, p2, q1, q2] = [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()];
    let along = [
        p1.derivative(u)?.lerp(p2.derivative(u)?, v),
        q1.derivative(v)?.lerp(q2.derivative(v)?, u),
    ];
    let across = [
        q2.point(v).minus(q1.point(v)),
        p2.point(u).minus(p1.point(u)),
    ];
    let corners = [
        b.minus(a).lerp(c.minus(d), v),
        d.minus(a).lerp(c.minus(b), u),
    ];
    let each = |make: &dyn Fn(usize) -> C::Point| [make(0), make(1)];
    Some(match mistake {
        "exchanged_partials" => each(&|i| along[1 - i].plus(across[1 - i]).minus(corners[1 - i])),
        "forgotten_difference" => each(&|i| along[i].minus(corners[i])),
        "reversed_difference" => each(&|i| along[i].minus(across[i]).minus(corners[i])),
        "forgotten_s3_derivative" => each(&|i| along[i].plus(across[i])),
        _ => {
            let frozen = [b.minus(a), d.minus(a)];
            each(&|i| along[i].plus(across[i]).minus(frozen[i]))
        }
    })
}

/// What the mistake makes of Hermite's cubics; `None` for a mistake of another function.
pub fn hermite_basis<S: Scalar>(mistake: &str, t: S) -> Option<[S; 4]> {
    let s = S::one() - t;
    let [two, three] = [2, 3].map(S::from_i32);
    let [start, end] = [(S::one() + two * t) * s * s, t * t * (three - two * t)];
    let [slope_at_0, slope_at_1] = [t * s * s, -(t * t * s)];
    match mistake {
        "swapped_slopes" => Some([start, slope_at_1, slope_at_0, end]),
        "sign_of_the_end_slope" => Some([start, slope_at_0, -slope_at_1, end]),
        _ => None,
    }
}

/// What the mistake makes of the bicubically blended patch; `None` for a mistake of another function.
pub fn bicubic_point<C: Curve>(
    mistake: &str,
    data: &HermiteBoundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<C::Point> {
    let boundary = data.boundary();
    let [p1, p2, q1, q2] = [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()];
    let [h, k] = [right_basis(u), right_basis(v)];
    let vectors = data.corner_vectors(u, v);
    let column = |vectors: [[C::Point; 4]; 4], j: usize| vectors.map(|row| row[j]);
    let tensor = |vectors: [[C::Point; 4]; 4]| {
        let columns = [0, 1, 2, 3].map(|j| C::Point::combination(h, column(vectors, j)));
        C::Point::combination(k, columns)
    };
    let s1 = [
        p1.point(u),
        data.p1_v().point(u),
        data.p2_v().point(u),
        p2.point(u),
    ];
    let s2 = [
        q1.point(v),
        data.q1_u().point(v),
        data.q2_u().point(v),
        q2.point(v),
    ];
    let ruled = C::Point::combination(k, s1).plus(C::Point::combination(h, s2));
    Some(match mistake {
        "bicubic_without_s3" => ruled,
        "transposed_corner_vectors" => {
            let transposed = [0, 1, 2, 3].map(|j| column(vectors, j));
            ruled.minus(tensor(transposed))
        }
        "zero_twists" => {
            let mut vectors = vectors;
            for (i, j) in [(1, 1), (1, 2), (2, 1), (2, 2)] {
                vectors[i][j] = C::Point::origin();
            }
            ruled.minus(tensor(vectors))
        }
        "positions_only" => {
            let Corners { a, b, c, d } = boundary.corners();
            let [x, y] = [h[3], k[3]];
            let corners = a.lerp(b, x).lerp(d.lerp(c, x), y);
            s1[0]
                .lerp(s1[3], y)
                .plus(s2[0].lerp(s2[3], x))
                .minus(corners)
        }
        _ => return None,
    })
}

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
