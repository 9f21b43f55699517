//! Polygons that break a careless scheme for curves, and what becomes of them.

use facette::algebra::{Real, VectorSpace};
use facette::bspline::BsplineCurve;
use facette::curve::Curve;
use facette::subdivision::curve::{
    Ends, LARGEST_DEGREE, LARGEST_ROUNDS, PolygonError, chaikin_step, cubic_step, distance_bound,
    lane_riesenfeld_step, limit_curve, limit_points, limit_tangents, point_count, rounds_within,
    subdivided,
};

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::curve_inputs::ALL_ENDS;

/// **No points, one, two.** Nothing is refused by a round: it gives what the formulas give. No points stay no points. A single point is a closed polygon whose one edge leads back to it, and becomes two equal ones; open, it has no edge and vanishes. Two points make an open
/// polygon of one edge, on which Chaikin's scheme shrinks towards the middle, and a closed one of two edges, there and back. A limit curve, however, needs a span: it is refused with the number of points that would do.
#[test]
fn polygons_of_no_one_or_two_points() {
    let count = |points: &[f64]| ALL_ENDS.map(|ends| chaikin_step(points, ends).len());
    assert_eq!(
        [count(&[]), count(&[5.0]), count(&[1.0, 5.0])],
        [[0; 3], [2, 0, 2], [4, 2, 4]]
    );
    let count = |points: &[f64]| ALL_ENDS.map(|ends| cubic_step(points, ends).len());
    assert_eq!(
        [count(&[]), count(&[5.0]), count(&[1.0, 5.0])],
        [[0; 3], [2, 0, 1], [4, 1, 3]]
    );
    assert_eq!(chaikin_step(&[5.0], Ends::Closed), [5.0; 2]);
    assert_eq!(chaikin_step(&[1.0, 5.0], Ends::Open), [2.0, 4.0]);
    assert_eq!(
        chaikin_step(&[1.0, 5.0], Ends::Closed),
        [2.0, 4.0, 4.0, 2.0]
    );
    assert_eq!(cubic_step(&[1.0, 5.0], Ends::Closed), [2.0, 3.0, 4.0, 3.0]);
    assert_eq!(cubic_step(&[1.0, 5.0], Ends::Kept), [1.0, 3.0, 5.0]);
    assert_eq!(limit_points(&[1.0, 5.0], 2, Ends::Open), Ok(vec![3.0]));
    assert_eq!(limit_points(&[1.0, 5.0], 3, Ends::Open), Ok(vec![]));
    assert_eq!(limit_tangents(&[5.0], 3, Ends::Kept), Ok(vec![0.0]));
    for (points, ends, needed) in [(0, Ends::Closed, 1), (3, Ends::Open, 4), (1, Ends::Kept, 2)] {
        let refused = PolygonError::TooFewPoints {
            degree: 3,
            needed,
            found: points,
        };
        assert_eq!(limit_curve(&vec![0.0; points], 3, ends), Err(refused));
        assert!(limit_curve(&vec![0.0; needed], 3, ends).is_ok());
    }
}

/// **A closed polygon of two points.** Its limit runs from the middle of the edge towards the second point, back through the middle, and towards the first: between $\frac14$ and $\frac34$ of the edge for Chaikin, between $\frac13$ and $\frac23$ for the cubic scheme, and
/// at the turning points its derivative is zero.
#[test]
fn closed_two_gon_swings_round_its_middle() {
    let [p, q] = [0, 12].map(|place| fraction(place, 1));
    let limit = |degree| limit_curve(&[p, q], degree, Ends::Closed).expect("a closed polygon");
    let at = |curve: &BsplineCurve<Exact>, halves: i32| curve.point(fraction(halves, 2));
    let [quadratic, cubic] = [limit(2), limit(3)];
    assert_eq!(
        [0, 1, 2, 3, 4].map(|i| at(&quadratic, i)),
        [6, 9, 6, 3, 6].map(|x| fraction(x, 1))
    );
    assert_eq!(
        [0, 1, 2, 3, 4].map(|i| at(&cubic, i)),
        [4, 6, 8, 6, 4].map(|x| fraction(x, 1))
    );
    let turns = limit_tangents(&[p, q], 3, Ends::Closed);
    assert_eq!(turns, Ok(vec![fraction(0, 1); 2]));
}

/// **Points that stand several times.** Two equal points are an edge of length zero, and Chaikin's limit touches every edge in its middle: it passes through the point. Its derivative is zero there, and the directions on both sides may differ: a corner. The cubic scheme
/// needs three equal points for it. This is how a designer makes a corner; points that are doubled by accident make one as well.
#[test]
fn repeated_points_make_a_corner() {
    let at = |x: i32, y: i32| [fraction(x, 1), fraction(y, 1)];
    let [before, corner, after] = [at(0, 0), at(4, 0), at(4, 8)];
    for (degree, times) in [(2, 2), (3, 3)] {
        let points = [vec![before], vec![corner; times], vec![after]].concat();
        let limit = limit_curve(&points, degree, Ends::Open).expect("enough points");
        let knots = limit_points(&points, degree, Ends::Open).expect("a degree");
        let tangents = limit_tangents(&points, degree, Ends::Open).expect("a degree");
        assert_eq!([knots[1], tangents[1]], [corner, at(0, 0)]);
        // On either side the curve is on the edge itself.
        for step in 1..=8 {
            let [left, right] = [8 - step, 8 + step].map(|u| limit.point(fraction(u, 8)));
            assert_eq!([left[1], right[0]], [fraction(0, 1), fraction(4, 1)]);
        }
    }
}

/// **A polygon that stands still.** Where all points are equal, Chaikin's rounds leave them as they are, bit for bit, denormal numbers excepted: $\frac34c$ is off by at most half a unit in the last place of $c$, by a half only where $c$ is even there, and the sum rounds back to $c$. So a wall that is level before remains level.
/// The cubic scheme can be off by a unit, since the sum of three terms is rounded twice.
#[test]
fn equal_points_stay_equal() {
    let mut dice = Dice::new(59);
    let mut moved = 0;
    for _ in 0..2000 {
        let c = dice.roll() * 1e8;
        assert_eq!(chaikin_step(&[c; 3], Ends::Closed), [c; 6]);
        let finer = cubic_step(&[c; 3], Ends::Closed);
        assert!(
            finer
                .iter()
                .all(|p| (p - c).abs() <= c.abs() * f64::EPSILON),
            "{c}"
        );
        moved += usize::from(finer[0] != c);
    }
    assert!(moved > 0, "the cubic scheme never moved a point");
}

/// **Ends that are kept.** A kept end is copied, not computed: whatever the degree, it is the same bits after every round and in the limit. As a mean of itself and its mirror images it would be off by a unit in the last place here and there.
#[test]
fn kept_ends_are_kept_bit_for_bit() {
    let mut dice = Dice::new(63);
    let mut moved = 0;
    for _ in 0..50 {
        let points: Vec<f64> = (0..5).map(|_| dice.roll()).collect();
        for degree in [1, 2, 3, 5, 7] {
            let finer = subdivided(&points, degree, Ends::Kept, 3).expect("few points");
            let limits = limit_points(&points, degree, Ends::Kept).expect("a degree");
            for others in [finer, limits] {
                assert_eq!(
                    [others.first(), others.last()],
                    [points.first(), points.last()]
                );
            }
        }
        let [end, next] = [points[0], points[1]];
        let mirrored = end + (end - next);
        moved += usize::from((mirrored + 4.0 * end + next) / 6.0 != end);
    }
    assert!(moved > 0, "the mean was never off");
}

/// **Integers lose nothing.** A round of Chaikin divides by four: it needs two bits more. Integers of $b$ bits therefore stay exact for $(53-b)/2$ rounds in `f64` and for $(24-b)/2$ in `f32`, and not longer.
#[test]
fn integers_lose_nothing_for_as_long_as_their_bits_last() {
    assert_eq!(rounds_without_loss::<f64>(37, 10), 8);
    assert_eq!(rounds_without_loss::<f32>(8, 10), 8);
    assert_eq!(rounds_without_loss::<f32>(12, 10), 6);
}

/// The number of rounds for which a triangle of integers of so many bits agrees with the exact one.
fn rounds_without_loss<S: Real>(bits: i32, rounds: u32) -> u32 {
    // Odd numbers with all bits set, or all but one: nothing is divisible by more than one.
    let largest = (1..=bits).fold(fraction(1, 1), |power, _| power + power) - fraction(1, 1);
    let corners = [largest, fraction(1, 1) - largest, largest - fraction(2, 1)];
    let half = S::ratio(1, 2);
    let [one, two] = [S::from_i32(1), S::from_i32(2)];
    let as_float = (1..=bits).fold(one, |power, _| power / half) - one;
    let mut rounded = vec![as_float, one - as_float, as_float - two];
    let mut exact = corners.to_vec();
    for round in 0..rounds {
        rounded = chaikin_step(&rounded, Ends::Closed);
        exact = chaikin_step(&exact, Ends::Closed);
        let scale = (0..2 * (round + 1)).fold(fraction(1, 1), |power, _| power + power);
        let float_scale = (0..2 * (round + 1)).fold(one, |power, _| power + power);
        // Times 4ᵏ both are integers, which the float holds without rounding where it holds the fraction.
        let agree = rounded.iter().zip(&exact).all(|(&r, &e)| {
            let integer = r * float_scale;
            same_integer(integer.to_f64(), e * scale)
        });
        if !agree {
            return round;
        }
    }
    rounds
}

/// Whether a float is the integer that an exact number is, by its halves: no conversion rounds.
fn same_integer(float: f64, exact: Exact) -> bool {
    let low = float % 67_108_864.0;
    let high = (float - low) / 67_108_864.0;
    let part = |value: f64| {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "28 bits at most, or no integer at all"
        )]
        let integer = value as i32;
        (f64::from(integer) == value).then(|| fraction(integer, 1))
    };
    match (part(high), part(low)) {
        (Some(high), Some(low)) => high * fraction(67_108_864, 1) + low == exact,
        _ => false,
    }
}

/// **Many rounds are not the limit.** Three points make three points of the open cubic scheme, round after round: the neighbourhood of one vertex. What it lacks to its limit is divided by four each time, exactly, so that after 12 rounds there are still $6\cdot10^{-8}$ of it left. The mask $\frac16(1,4,1)$ gives the limit at once. Nor do more
/// rounds harm: after 31 the error in `f32` and `f64` is within $3k\,\mathbf u$, and was measured to be far less; but it is no better than the mask's.
#[test]
fn many_rounds_are_not_the_limit() {
    let corner = [1, 7, -4].map(|height| fraction(height, 3));
    let limit = limit_points(&corner, 3, Ends::Open).expect("a degree")[0];
    let mut lacking = corner[1] - limit;
    for rounds in 1..=12 {
        let finer = subdivided(&corner, 3, Ends::Open, rounds).expect("few points");
        assert_eq!(finer.len(), 3);
        assert_eq!(finer[1] - limit, lacking / fraction(4, 1));
        lacking = finer[1] - limit;
    }
    assert_eq!(lacking * fraction(1 << 24, 1), corner[1] - limit);
    assert!(error_after_31_rounds::<f64>() <= 3.0 * 31.0 * f64::EPSILON / 2.0 * 7.0 / 3.0);
    assert!(
        error_after_31_rounds::<f32>() <= 3.0 * 31.0 * f64::from(f32::EPSILON) / 2.0 * 7.0 / 3.0
    );
}

/// How far the middle of three points is from the limit after 31 rounds, less the 4⁻³¹ that rounds cannot help.
fn error_after_31_rounds<S: Real>() -> f64 {
    let corner = [1, 7, -4].map(|height| S::ratio(height, 3));
    let finer = subdivided(&corner, 3, Ends::Open, LARGEST_ROUNDS).expect("few points");
    // (1 + 28 − 4)/18, to the roundoff of f64, which is below that of one round.
    (finer[1].to_f64() - 25.0 / 18.0).abs()
}

/// **Far from the origin.** At an offset of $2^{27}$ the shape keeps its accuracy in units of the offset: every point is within $2k\,\mathbf u$ times $2^{27}$ of the shape near the origin, shifted.
#[test]
fn far_polygons_keep_what_their_digits_hold() {
    let near = [[0.125, 3.0], [2.5, -1.0], [4.0, 0.75], [1.0, 5.0]];
    let shift = [2.0_f64.powi(27); 2];
    let far = near.map(|p| p.plus(shift));
    let rounds = 10;
    let [near, far] =
        [near, far].map(|points| subdivided(&points, 2, Ends::Closed, rounds).expect("few points"));
    let bound = 2.0 * 10.0 * f64::EPSILON / 2.0 * (shift[0] + 5.0);
    for (near, far) in near.iter().zip(far) {
        assert!(far.minus(shift).minus(*near).largest_coordinate() <= bound);
    }
}

/// **Huge coordinates.** Means of numbers as large as `f64` holds do not overflow, because the points are multiplied before they are added. $P_-+6P+P_+$, divided by eight afterwards, would.
#[test]
fn largest_numbers_do_not_overflow() {
    let huge = [f64::MAX, -f64::MAX, f64::MAX, f64::MAX];
    assert!((huge[2] + 6.0 * huge[3] + huge[0]).is_infinite());
    for ends in ALL_ENDS {
        for degree in [2, 3] {
            let finer = subdivided(&huge, degree, ends, 4).expect("few points");
            assert!(
                finer.iter().all(|p| p.is_finite()),
                "degree {degree}, {ends:?}: {finer:?}"
            );
        }
    }
}

/// **A point that is not a number.** It spoils the new points that it has a part in, the two on each of its edges, and no others; a limit curve refuses it and says which point it is.
#[test]
fn nan_stays_where_it_is() {
    let mut points = [0.0, 1.0, 4.0, 9.0, 16.0];
    points[2] = f64::NAN;
    let spoilt: Vec<usize> = chaikin_step(&points, Ends::Closed)
        .iter()
        .enumerate()
        .filter_map(|(index, p)| p.is_nan().then_some(index))
        .collect();
    assert_eq!(spoilt, [2, 3, 4, 5]);
    let refused = limit_curve(&points, 2, Ends::Closed).expect_err("NaN");
    assert_eq!(
        refused.to_string(),
        "point 2 is NaN: every coordinate must be finite"
    );
    assert!(distance_bound(&points, 2, Ends::Closed, 1).is_ok_and(f64::is_nan));
    assert!(rounds_within(&points, 2, Ends::Closed, 1.0).is_err());
}

/// **Requests that cannot be met.** Degrees that there are not, ends that cannot be kept, more rounds than 31, more points than 32 bits number or the memory holds: each is refused before anything is computed, and the refusal says what would be possible.
#[test]
fn impossible_requests_are_refused() {
    let message =
        |refused: Result<usize, PolygonError>| refused.expect_err("impossible").to_string();
    let counted = |degree, ends, rounds| point_count(1000, degree, ends, rounds);
    assert_eq!(
        message(counted(0, Ends::Open, 1)),
        "degree 0: expected one from 1 to 33"
    );
    assert_eq!(
        message(counted(LARGEST_DEGREE + 1, Ends::Open, 1)),
        "degree 34: expected one from 1 to 33"
    );
    assert_eq!(
        message(counted(4, Ends::Kept, 1)),
        "degree 4: ends are kept for degree 2 and for odd degrees; expected one of these, or a polygon that is closed or open"
    );
    assert_eq!(
        message(counted(2, Ends::Closed, 32)),
        "32 rounds: at most 31 are possible, since each doubles the points"
    );
    assert_eq!(
        message(counted(2, Ends::Closed, 30)),
        "30 rounds make 1073741824000 points of 1000: at most 4294967295 are possible, so fewer rounds are"
    );
    assert!(point_count(usize::MAX, 3, Ends::Open, 31).is_err());
    assert!(limit_tangents(&[0.0, 1.0], 1, Ends::Open).is_err());
    assert!(lane_riesenfeld_step(&[0.0, 1.0], 4, Ends::Kept).is_err());
    assert!(rounds_within(&[0.0, 1.0, 5.0], 2, Ends::Open, f64::NAN).is_err());
    // 64 KB a point: more than any processor addresses.
    #[allow(clippy::large_stack_arrays, reason = "two of them fit")]
    let wide = [[0.0_f64; 8192]; 2];
    let refused = subdivided(&wide, 2, Ends::Closed, 30);
    assert!(matches!(
        refused,
        Err(PolygonError::OutOfMemory {
            points: 2_147_483_648
        })
    ));
}
