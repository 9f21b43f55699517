//! Inputs on which closed surfaces crack, lose their way or must be refused.

use facette::bspline::{
    BsplineError, BsplineSurface, Closing, Direction, KnotVector, PeriodicError, PeriodicSurface,
    closed_surface,
};
use facette::surface::Surface;

const CLOSED: [Closing; 2] = [Closing::Closed; 2];
const BAND: [Closing; 2] = [Closing::Flipped, Closing::Open];

/// Numbers with all bits in use, the same in every run.
fn scattered(count: u32) -> Vec<[f64; 3]> {
    let number = |k: u32| (f64::from(k) * 0.754_877_666_246_692_7).fract() * 3.0 - 1.0;
    (0..count)
        .map(|k| [number(3 * k), number(3 * k + 1), number(3 * k + 2)])
        .collect()
}

/// Knots of a torus whose spacings have no short binary form.
fn torus() -> PeriodicSurface<[f64; 3]> {
    let u = KnotVector::periodic(3, &[0.0, 0.3, 0.7, 1.1, 1.2, 1.9]).expect("increasing");
    let v = KnotVector::periodic(2, &[0.1, 0.2, 0.5, 0.9]).expect("increasing");
    closed_surface([u, v], &scattered(15), CLOSED).expect("the spacings repeat up to rounding")
}

/// **Cracks at the seam.** Evaluated with the basis functions of the last span, the points at the end of a period are not the bits of those at its start: each side rounds in
/// its own order, and a picture shows cracks. The closed surface brings the end back to the start first, and both seams of a torus are the same bits everywhere. On a Möbius
/// band the mirrored parameter $7-v$ is rounded itself: the seam is one where $7-v$ is exact, and a mesh joins the vertices elsewhere.
#[test]
fn seams_are_the_same_bits() {
    let torus = torus();
    let [[u0, u1], [v0, v1]] = torus.domain();
    let mut cracks = 0;
    for step in 0..200 {
        let share = f64::from(step) / 199.0;
        let [u, v] = [u0 + share * (u1 - u0), v0 + share * (v1 - v0)];
        assert_eq!(torus.point(u0, v), torus.point(u1, v), "v = {v}");
        assert_eq!(torus.point(u, v0), torus.point(u, v1), "u = {u}");
        cracks += u32::from(torus.surface().point(u0, v) != torus.surface().point(u1, v));
    }
    assert!(
        cracks > 100,
        "only {cracks} of 200 points of the open surface crack"
    );
    let u = KnotVector::uniform(3, 15).expect("15 columns");
    let v = KnotVector::clamped(2, &[0., 1., 2., 3., 4., 5., 6., 7.]).expect("increasing");
    let band = closed_surface([u, v], &scattered(108), BAND).expect("the slides' knots");
    for eighth in 0..=56 {
        let v = f64::from(eighth) / 8.0;
        assert_eq!(band.point(12.0, v), band.point(0.0, 7.0 - v), "v = {v}");
    }
}

/// **A grid across the seam.** The points on a grid are the bits of single points, also where the grid reaches beyond the seam, with a flip and without.
#[test]
fn grid_is_wrapped_as_points_are() {
    let u = KnotVector::uniform(2, 8).expect("8 columns");
    let v = KnotVector::bezier(2);
    let band = closed_surface([u, v], &scattered(18), BAND).expect("symmetric knots");
    let us = [-0.3, 0.0, 2.5, 6.0, 6.1, 13.0];
    let vs = [0.0, 0.2, 1.0];
    for surface in [&band, &torus()] {
        let mut points = [[0.0; 3]; 18];
        surface.points_on_grid(&us, &vs, &mut points);
        let single = vs
            .iter()
            .flat_map(|&v| us.iter().map(move |&u| surface.point(u, v)));
        assert_eq!(points.to_vec(), single.collect::<Vec<_>>());
    }
}

/// **A thousand million turns.** However many periods away, a parameter is brought back without adding rounding: what is left of $10^9$ turns and a quarter is the quarter. The smallest step
/// before the start is the start itself. NaN and infinity give NaN, and nothing hangs at $10^{300}$.
#[test]
fn far_parameters_come_home() {
    let u = KnotVector::uniform(3, 15).expect("15 columns");
    let tube = closed_surface(
        [u, KnotVector::bezier(1)],
        &scattered(24),
        [Closing::Closed, Closing::Open],
    );
    let tube = tube.expect("a cylinder");
    let home = |u: f64| tube.wrapped(u, 0.5);
    assert_eq!(home(12e9 + 0.25), ([0.25, 0.5], false));
    assert_eq!(home(-12e9 + 0.25), ([0.25, 0.5], false));
    assert_eq!(home(12.0), ([0.0, 0.5], false));
    assert_eq!(home(-f64::from_bits(1)), ([0.0, 0.5], false));
    let [far, _] = home(1e300).0;
    assert_eq!(far, 1e300 % 12.0);
    for lost in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(
            tube.point(lost, 0.5)
                .iter()
                .all(|coordinate| coordinate.is_nan())
        );
    }
}

/// **Odd and even turns.** On a Möbius band the parameter across is mirrored after an odd number of turns only, backwards too.
#[test]
fn band_is_mirrored_after_odd_turns_only() {
    let u = KnotVector::uniform(2, 7).expect("5 distinct columns");
    let band = closed_surface([u, KnotVector::bezier(2)], &scattered(15), BAND).expect("symmetric");
    for (turns, is_flipped) in [
        (-3, true),
        (-2, false),
        (-1, true),
        (0, false),
        (1, true),
        (2, false),
        (1001, true),
    ] {
        let u = 1.5 + 5.0 * f64::from(turns);
        let v = if is_flipped { 0.75 } else { 0.25 };
        assert_eq!(
            band.wrapped(u, 0.25),
            ([1.5, v], is_flipped),
            "{turns} turns"
        );
    }
}

/// **What does not close.** Too few or too many distinct points, unequal spacings at the seam, a flip over knots that are not symmetric, a flip where the other direction closes
/// too, and bad points are refused, each with its place and its numbers.
#[test]
fn what_cannot_close_is_refused() {
    let uniform = |degree, count| KnotVector::<f64>::uniform(degree, count).expect("enough points");
    let message = |knots, points: u32, closing| {
        let refused = closed_surface(knots, &scattered(points), closing);
        refused.expect_err("this does not close").to_string()
    };
    let open = [Closing::Closed, Closing::Open];
    assert_eq!(
        message([uniform(3, 15), KnotVector::bezier(1)], 30, open),
        "the knots ask for 12 x 2 distinct control points (in a direction that closes, the last p are made from the first), but there are 30"
    );
    let clamped = KnotVector::clamped_uniform(2, 6).expect("enough points");
    assert_eq!(
        message([clamped.clone(), KnotVector::bezier(1)], 8, open),
        "the spacing between the knots 1 and 2 in u is 0.0, and one period later 0.25: a surface closes where they are equal"
    );
    let lopsided = KnotVector::clamped(1, &[0.0, 1.0, 3.0]).expect("increasing");
    assert_eq!(
        message([uniform(2, 6), lopsided], 12, BAND),
        "to flip u, the knots in the other direction must be symmetric: the spacing after knot 1 is 1.0, its mirror image 2.0"
    );
    let both = [Closing::Closed, Closing::Flipped];
    assert_eq!(
        message([uniform(2, 6), uniform(2, 6)], 16, both),
        "v can close with a flip only where the other direction is open"
    );
    let mut points = scattered(8);
    points[5][1] = f64::NAN;
    let refused = closed_surface([uniform(2, 6), KnotVector::bezier(1)], &points, open);
    assert!(matches!(
        refused,
        Err(PeriodicError::Bspline(BsplineError::PointNotFinite {
            index: 7,
            ..
        }))
    ));
    let error = PeriodicError::<f64>::FlipNeedsOpenSides {
        flipped: Direction::V,
    };
    assert_eq!(
        error.to_string(),
        message([uniform(2, 6), uniform(2, 6)], 16, both)
    );
}

/// **Rounded spacings.** Knots at multiples of 0.1 have spacings that differ in the last bits, and so have those that continue them beyond the ends: they close all the same. A
/// spacing that is wrong by a millionth does not.
#[test]
fn spacings_may_differ_by_rounding_only() {
    let tenths: Vec<f64> = (-3..=13).map(|k| f64::from(k) * 0.1).collect();
    let widths: Vec<f64> = tenths.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(
        widths.iter().any(|&width| width != widths[0]),
        "the spacings are rounded"
    );
    let close = |tenths: Vec<f64>| {
        let u = KnotVector::new(3, tenths).expect("increasing");
        closed_surface(
            [u, KnotVector::bezier(1)],
            &scattered(20),
            [Closing::Closed, Closing::Open],
        )
    };
    assert!(close(tenths.clone()).is_ok());
    let mut wrong = tenths;
    wrong[14] += 1e-6;
    assert!(matches!(
        close(wrong),
        Err(PeriodicError::SpacingsDiffer { .. })
    ));
}

/// **The open surface behind.** The net with its repeated points is an ordinary B-spline surface: it is what the closed one shows inside its domain, and what a file format without
/// closed surfaces can store.
#[test]
fn surface_behind_is_an_ordinary_one() {
    let torus = torus();
    let open = torus.surface();
    let knots = [Direction::U, Direction::V].map(|direction| open.knots(direction).clone());
    let again = BsplineSurface::new(knots, open.control_points().to_vec());
    assert_eq!(again.as_ref(), Ok(open));
    assert_eq!(torus.point(0.4, 0.6), open.point(0.4, 0.6));
    assert_eq!(torus.normal_vector(0.4, 0.6), open.normal_vector(0.4, 0.6));
}
