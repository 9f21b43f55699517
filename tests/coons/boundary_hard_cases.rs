//! Boundaries that nearly meet, and boundaries that are none: what is accepted, what is refused, and how it is said.

use crate::common::exact::{Exact, fraction};
use crate::inputs::bezier;
use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{
    Boundary, CoonsError, Corner, CrossDerivatives, FergusonPatch, HermiteBoundary, bilinear_point,
};
use facette::curve::{BezierCurve, BoxedCurve, Curve, FunctionCurve};
use num_traits::Zero;

use crate::hard_cases::line;

/// **Ends that meet up to an ulp.** Curves that are evaluated on their own seldom agree in the last bit: $\cos$ and $\sin$ of the same
/// angle, computed as $\cos\frac\pi2$ and as $0$, leave a gap of $6\cdot10^{-17}$. A boundary accepts gaps of 64 unit roundoffs of the largest
/// corner coordinate. The corners come from $P_1$ and $P_2$ alone, so that $Q_1$ and $Q_2$ are met exactly and $P_1$, $P_2$ up to the gap.
#[test]
fn ends_that_meet_up_to_an_ulp_are_accepted() {
    use std::f64::consts::FRAC_PI_2;
    let arc: BoxedCurve<[f64; 3]> = Box::new(FunctionCurve::new(|t: f64| {
        [(FRAC_PI_2 * t).cos(), (FRAC_PI_2 * t).sin(), 0.0]
    }));
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [b, c, d] = [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]];
    let gap = arc.point(1.0)[0];
    assert!(gap > 0.0, "the cosine of a rounded right angle is not 0");
    let boundary = Boundary::new(
        arc,
        straight(d, c),
        straight([1.0, 0.0, 0.0], d),
        straight(b, c),
    )
    .expect("a gap of less than an ulp of 1 is rounding");
    assert_eq!(boundary.corners().b[0], gap);
    for t in [0.0, 0.25, 0.7, 1.0] {
        assert_eq!(bilinear_point(&boundary, 1.0, t), boundary.q2().point(t));
        let miss = bilinear_point(&boundary, t, 0.0).minus(boundary.p1().point(t));
        assert!(
            miss.largest_coordinate() <= gap,
            "at u = {t} the edge is missed by {miss:?}"
        );
    }
}

/// **Ends that meet at a far offset.** At $10^8$ one ulp is $1.5\cdot10^{-8}$: a tolerance that is fixed in metres refuses what rounding alone
/// has parted. Ours grows with the coordinates: a gap of one ulp is accepted at $10^8$, and the same gap refused at 1.
#[test]
fn tolerance_grows_with_the_offset() {
    let boundary_at = |offset: f64, gap: f64| {
        let at = |x: f64, y: f64| [offset + x, y, 0.0];
        let parted = [offset + gap, 0.0, 0.0];
        let [b, c, d] = [at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        Boundary::new(
            line(at(0.0, 0.0), b),
            line(d, c),
            line(parted, d),
            line(b, c),
        )
    };
    let ulp_at_1e8 = 2.0_f64.powi(-26);
    assert_ne!(1e8 + ulp_at_1e8, 1e8);
    assert!(boundary_at(1e8, ulp_at_1e8).is_ok());
    let refused = boundary_at(0.0, ulp_at_1e8).expect_err("a gap of 1.5e-8 between unit lengths");
    assert_eq!(
        refused.to_string(),
        "at corner A, P1(0) = [0.0, 0.0, 0.0] and Q1(0) = [1.4901161193847656e-8, 0.0, 0.0] must agree, but are \
         1.4901161193847656e-8 apart, where the tolerance is 7.105427357601002e-15"
    );
}

/// **The tolerance is what it says.** A gap of exactly the tolerance is accepted, the next larger one refused; a tolerance of zero accepts
/// equal ends only; a negative one and NaN accept nothing.
#[test]
fn given_tolerance_is_kept_to_the_bit() {
    let curves = |gap: f64| {
        let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        [line(a, b), line(d, c), line(a, d), line([1.0, gap, 0.0], c)]
    };
    let accepts = |gap, tolerance| Boundary::with_tolerance(curves(gap), tolerance).is_ok();
    assert!(accepts(1e-3, 1e-3));
    assert!(!accepts(1e-3_f64.next_up(), 1e-3));
    assert!(accepts(0.0, 0.0));
    assert!(!accepts(f64::from_bits(1), 0.0));
    assert!(!accepts(0.0, -1e-300));
    assert!(!accepts(0.0, f64::NAN));
}

/// A line that takes seven units of the parameter.
#[derive(Clone)]
struct Longer(BezierCurve<[f64; 3]>);
impl Curve for Longer {
    type Scalar = f64;
    type Point = [f64; 3];

    fn domain(&self) -> [f64; 2] {
        [0.0, 7.0]
    }

    fn point(&self, t: f64) -> [f64; 3] {
        self.0.point(t / 7.0)
    }

    fn derivative(&self, _: f64) -> Option<[f64; 3]> {
        None
    }
}

/// **What is not finite is refused, and what is not over $[0,1]$.** A curve that ends at infinity or nowhere bounds nothing; the message names the
/// end.
#[test]
fn boundaries_of_unusable_curves_are_refused() {
    let bad: BoxedCurve<[f64; 3]> =
        Box::new(FunctionCurve::new(|t: f64| [1.0 / (1.0 - t), 0., 0.]));
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [a, b, c, d] = [[1., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.]];
    let refused = Boundary::new(bad, straight(d, c), straight(a, d), straight(b, c));
    let message = refused
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    assert_eq!(
        message,
        "P1(1) is [inf, 0.0, 0.0]: every coordinate must be finite"
    );

    let longer = [(a, b), (d, c), (a, d), (b, c)].map(|(start, end)| Longer(line(start, end)));
    let [p1, p2, q1, q2] = longer;
    let refused = Boundary::new(p1, p2, q1, q2)
        .err()
        .map(|error| error.to_string());
    let expected = "the curve P1 runs over [0.0, 7.0], where a patch needs [0, 1]";
    assert_eq!(refused.as_deref(), Some(expected));
}

/// **Cross derivatives without a derivative.** Twists are read off the cross derivatives; a closure that does not know its own derivative cannot give them, and the error
/// names it.
#[test]
fn unknown_derivative_is_named() {
    let unknown = |value: [f64; 3]| -> BoxedCurve<[f64; 3]> {
        Box::new(FunctionCurve::new(move |_: f64| value))
    };
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let boundary = Boundary::new(
        straight(a, b),
        straight(d, c),
        straight(a, d),
        straight(b, c),
    );
    let [along_u, along_v] = [[1., 0., 0.], [0., 1., 0.]];
    let cross = CrossDerivatives {
        p1_v: straight(along_v, along_v),
        p2_v: unknown(along_v),
        q1_u: straight(along_u, along_u),
        q2_u: straight(along_u, along_u),
    };
    let refused = HermiteBoundary::gregory(boundary.expect("a square"), cross);
    let message = refused
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    let expected = "the derivative of p2_v is not known at 0.0, but smooth blending needs it";
    assert_eq!(message, expected);
}

/// **Numbers that are none.** The Ferguson patch refuses vectors that are not finite.
#[test]
fn ferguson_patch_refuses_what_is_not_finite() {
    let mut vectors = [[[0.0; 3]; 4]; 4];
    vectors[2][1][0] = f64::NAN;
    let refused = FergusonPatch::new(vectors);
    assert!(matches!(
        refused,
        Err(CoonsError::NotFinite {
            what: "a corner vector",
            ..
        })
    ));
}

/// **Exact corners.** Over a field the default tolerance is zero: the smallest gap is refused, with its corner.
#[test]
fn exact_boundaries_have_no_tolerance() {
    let [zero, one] = [Exact::zero(), Exact::from_i32(1)];
    let at = |x, y| [x, y, zero];
    let edge = |start, end| bezier::<[Exact; 3]>(&[start, end]);
    let [a, b, c, d] = [at(zero, zero), at(one, zero), at(one, one), at(zero, one)];
    let nearly = at(fraction(1, i32::MAX), one);
    let refused = Boundary::new(edge(a, b), edge(d, c), edge(a, nearly), edge(b, c));
    assert!(matches!(
        refused,
        Err(CoonsError::DoNotMeet {
            corner: Corner::D,
            ..
        })
    ));
}
