//! Boundaries that nearly meet, and boundaries that are none: what is accepted, what is refused, and how it is said.

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{
    Boundary, CoonsError, Corner, Corners, CrossDerivatives, FergusonPatch, HermiteBoundary,
    bilinear_point,
};
use facette::curve::{BezierCurve, BoxedCurve, Curve, FunctionCurve};
use num_traits::Zero;

use crate::common::exact::{Exact, fraction};
use crate::hard_cases::line;
use crate::inputs::{Point, SurfaceData, bezier, surface_data, twists_of};

/// **Ends that meet up to an ulp.** Curves that are evaluated on their own seldom agree in the last bit: the cosine of a
/// right angle, once computed as $\cos\frac\pi2$ and once written as $0$, leaves a gap of $6\cdot10^{-17}$. A boundary accepts gaps of 64 unit roundoffs of the largest
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

/// **What is not finite is refused.** A curve that ends at infinity or nowhere bounds nothing; the message names the end.
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

/// **Exact corners.** Over the fractions the default tolerance is zero: the smallest gap is refused, with its corner.
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

/// **Every corner is checked.** Whatever end of a cross derivative is moved, the refusal names it and its corner; and so for the twist at every corner.
#[test]
fn data_that_do_not_fit_are_refused_at_every_corner() {
    let net: Vec<Vec<_>> = (0..4)
        .map(|i| {
            (0..4)
                .map(|j| [fraction(i, 1), fraction(j, 1), fraction(i * j * j, 2)])
                .collect()
        })
        .collect();
    let moved = |curve: &BezierCurve<Point>, at_end: bool| {
        let mut points = curve.control_points().to_vec();
        let place = if at_end { points.len() - 1 } else { 0 };
        points[place][2] = points[place][2] + fraction(1, 9);
        bezier(&points)
    };
    let refusal = |which: usize, at_end: bool| {
        let SurfaceData {
            edges: [p1, p2, q1, q2],
            mut cross,
        } = surface_data(&net);
        let curves = [
            &mut cross.p1_v,
            &mut cross.p2_v,
            &mut cross.q1_u,
            &mut cross.q2_u,
        ];
        let curve = curves.into_iter().nth(which).expect("one of four");
        *curve = moved(curve, at_end);
        let boundary = Boundary::new(p1, p2, q1, q2).expect("a surface's edges meet");
        match HermiteBoundary::gregory(boundary, cross) {
            Err(CoonsError::DoNotMeet {
                corner, first, gap, ..
            }) => Some((corner, first, gap)),
            _ => None,
        }
    };
    let expected = [
        [(Corner::A, "p1_v(0)"), (Corner::B, "p1_v(1)")],
        [(Corner::D, "p2_v(0)"), (Corner::C, "p2_v(1)")],
        [(Corner::A, "q1_u(0)"), (Corner::D, "q1_u(1)")],
        [(Corner::B, "q2_u(0)"), (Corner::C, "q2_u(1)")],
    ];
    for (which, ends) in expected.into_iter().enumerate() {
        for ((corner, name), at_end) in ends.into_iter().zip([false, true]) {
            assert_eq!(refusal(which, at_end), Some((corner, name, fraction(1, 9))));
        }
    }
    for corner in [Corner::A, Corner::B, Corner::C, Corner::D] {
        let mut twists = twists_of(&net);
        let Corners { a, b, c, d } = &mut twists;
        let twist = match corner {
            Corner::A => a,
            Corner::B => b,
            Corner::C => c,
            Corner::D => d,
        };
        twist[0] = twist[0] + fraction(2, 7);
        let SurfaceData {
            edges: [p1, p2, q1, q2],
            cross,
        } = surface_data(&net);
        let boundary = Boundary::new(p1, p2, q1, q2).expect("a surface's edges meet");
        let refused = HermiteBoundary::new(boundary, cross, twists).err();
        let found = match refused {
            Some(CoonsError::DoNotMeet { corner, .. }) => Some(corner),
            _ => None,
        };
        assert_eq!(found, Some(corner));
    }
}

/// **Only over $[0,1]$.** A curve over another interval is refused by its name, whichever end differs, be it an edge or a cross derivative.
#[test]
fn curves_over_other_intervals_are_refused_by_name() {
    struct Over(BezierCurve<[f64; 3]>, [f64; 2]);
    impl Curve for Over {
        type Scalar = f64;
        type Point = [f64; 3];

        fn domain(&self) -> [f64; 2] {
            self.1
        }

        fn point(&self, t: f64) -> [f64; 3] {
            self.0.point(t)
        }

        fn derivative(&self, t: f64) -> Option<[f64; 3]> {
            self.0.derivative(t)
        }
    }
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let [in_u, in_v] = [[1., 0., 0.], [0., 1., 0.]];
    let names = ["P1", "P2", "Q1", "Q2", "p1_v", "p2_v", "q1_u", "q2_u"];
    let ends = [
        (a, b),
        (d, c),
        (a, d),
        (b, c),
        (in_v, in_v),
        (in_v, in_v),
        (in_u, in_u),
        (in_u, in_u),
    ];
    for domain in [[0.0, 7.0], [-1.0, 1.0], [0.5, 1.0]] {
        for (wrong, name) in names.into_iter().enumerate() {
            let curve = |index: usize| {
                let (start, end) = ends[index];
                Over(
                    line(start, end),
                    if index == wrong { domain } else { [0.0, 1.0] },
                )
            };
            let cross = CrossDerivatives {
                p1_v: curve(4),
                p2_v: curve(5),
                q1_u: curve(6),
                q2_u: curve(7),
            };
            let refused = Boundary::new(curve(0), curve(1), curve(2), curve(3))
                .and_then(|boundary| HermiteBoundary::gregory(boundary, cross))
                .err();
            let [start, end] = domain;
            assert_eq!(
                refused,
                Some(CoonsError::DomainIsNotUnit {
                    curve: name,
                    start,
                    end
                })
            );
        }
    }
}

/// **The largest corner counts.** The tolerance follows the largest coordinate of all corners, wherever it is: one far corner lets a rounding gap of its size pass.
#[test]
fn tolerance_follows_the_farthest_corner() {
    let [b, c, d] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let ulp_at_1e8 = 2.0_f64.powi(-26);
    let [a, parted] = [[1e8, 0.0, 0.0], [1e8 + ulp_at_1e8, 0.0, 0.0]];
    assert!(Boundary::new(line(a, b), line(d, c), line(parted, d), line(b, c)).is_ok());
}
