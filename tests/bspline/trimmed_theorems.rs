//! The theorems of trimmed surfaces. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::bspline::{
    BsplineSurface, KnotVector, Place, RationalCurve, TrimError, TrimmedSurface, circle,
};
use facette::curve::Curve;
use facette::surface::Surface;
use num_traits::{One, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::common::law::{Law, expect_equal};
use crate::suspects;

type Parameters = [Exact; 2];
type Sheet = BsplineSurface<[Exact; 3]>;

fn integer(value: i32) -> Exact {
    fraction(value, 1)
}

/// A bilinear surface over `[−8, 8]²`.
fn sheet() -> Sheet {
    let knots = KnotVector::bezier(1)
        .reparametrised([-8, 8].map(integer))
        .expect("a domain");
    let corners = [[0, 0, 0], [3, 0, 1], [0, 3, 1], [3, 3, 0]].map(|corner| corner.map(integer));
    BsplineSurface::new([knots.clone(), knots], corners.to_vec()).expect("2 x 2 points")
}

/// The closed polygon through these corners, as a curve of degree 1.
fn outline(corners: &[Parameters]) -> RationalCurve<Parameters> {
    let closed = [corners, &corners[..1]].concat();
    let knots = KnotVector::clamped_uniform(1, closed.len()).expect("at least two points");
    RationalCurve::new(knots, &closed, &vec![Exact::one(); closed.len()]).expect("weights of 1")
}

fn trimmed(corners: &[Parameters]) -> Result<TrimmedSurface<Sheet>, Box<TrimError<Exact>>> {
    TrimmedSurface::new(sheet(), outline(corners), fraction(1, 1000)).map_err(Box::new)
}

/// The eight directions in which the corners of the test polygons lie, anticlockwise.
const DIRECTIONS: [[i32; 2]; 8] = [
    [1, 0],
    [1, 1],
    [0, 1],
    [-1, 1],
    [-1, 0],
    [-1, -1],
    [0, -1],
    [1, -1],
];

/// Eight corners in these directions from the origin, which sees them all: star-shaped, and in general not convex.
fn star(radii: &[i32]) -> Vec<Parameters> {
    let corner =
        |(direction, &radius): (&[i32; 2], &i32)| direction.map(|axis| fraction(axis * radius, 4));
    DIRECTIONS.iter().zip(radii).map(corner).collect()
}

fn cross(a: Parameters, b: Parameters) -> Exact {
    a[0] * b[1] - a[1] * b[0]
}

/// Where a point lies with respect to a star, by its triangles with the origin: the weights of the three corners decide.
fn place_in_star(corners: &[Parameters], point: Parameters) -> Place {
    let mut place = Place::Outside;
    for (index, &a) in corners.iter().enumerate() {
        let b = corners[(index + 1) % corners.len()];
        let whole = cross(a, b);
        let [of_a, of_b] = [cross(point, b) / whole, cross(a, point) / whole];
        let of_origin = Exact::one() - of_a - of_b;
        if [of_a, of_b, of_origin]
            .iter()
            .any(|&weight| weight < Exact::zero())
        {
            continue;
        }
        if of_origin.is_zero() {
            return Place::Edge;
        }
        place = Place::Inside;
    }
    place
}

/// **Inside.** A pair of parameters belongs to the surface if the loop's polygon winds around it, or passes through it. For a star-shaped polygon this is the union of its triangles with the
/// centre. Exact numbers leave no doubt, on corners, on sides, and at the height of a corner.
#[test]
fn polygon_contains_what_its_triangles_contain() {
    let law = Law::new(
        "bspline::polygon_contains_what_its_triangles_contain",
        suspects::library,
    )
    .on_cases(128);
    let radii = || vec(1..16_i32, 8);
    let ordinary = (radii(), -24..24_i32, -24..24_i32)
        .prop_map(|(radii, u, v)| (star(&radii), [u, v].map(|x| fraction(x, 6))));
    let hard = (radii(), 0..8_usize, 0..=4_i32, prop::bool::ANY).prop_map(
        |(radii, side, share, beside)| {
            let corners = star(&radii);
            let on_side = corners[side].lerp(corners[(side + 1) % 8], fraction(share, 4));
            let tiny = if beside {
                fraction(1, 1 << 30)
            } else {
                Exact::zero()
            };
            (corners, [on_side[0] + tiny, on_side[1]])
        },
    );
    law.holds(ordinary, hard, |(corners, point)| {
        let surface = trimmed(corners).expect("a star is a simple polygon");
        let expected = place_in_star(corners, *point);
        let [u, v] = *point;
        expect_equal(&expected, &surface.place_of(u, v))?;
        expect_equal(&(expected != Place::Outside), &surface.contains(u, v))
    });
}

/// **Within the tolerance.** The polygon's corners lie on the loop, and no point of the loop is farther from the polygon than the tolerance. On the unit circle the corners satisfy $u^2+v^2=1$ exactly, and the middle of a side is
/// farther from the centre than $1-\varepsilon$. A quarter of the tolerance takes about twice as many sides.
#[test]
fn polygon_follows_the_circle_within_the_tolerance() {
    let mut counts = Vec::new();
    for denominator in [4, 16, 64, 256, 1024] {
        let tolerance = fraction(1, denominator);
        let surface =
            TrimmedSurface::new(sheet(), circle(), tolerance).expect("the circle is a loop");
        let polygon = surface.polygon();
        for (index, &corner) in polygon.iter().enumerate() {
            let next = polygon[(index + 1) % polygon.len()];
            let middle = corner.lerp(next, fraction(1, 2));
            let squared = |p: Parameters| p[0] * p[0] + p[1] * p[1];
            assert_eq!(squared(corner), Exact::one());
            let least = Exact::one() - tolerance;
            assert!(squared(middle) >= least * least, "{polygon:?}");
        }
        counts.push(polygon.len());
    }
    for pair in counts.windows(2) {
        assert!(
            (3 * pair[0]..=5 * pair[0]).contains(&(2 * pair[1])),
            "{counts:?} sides"
        );
    }
}

/// The squared distance of a point from a segment.
fn squared_distance(point: Parameters, [a, b]: [Parameters; 2]) -> Exact {
    let dot = |a: Parameters, b: Parameters| a[0] * b[0] + a[1] * b[1];
    let along = b.minus(a);
    let share = dot(point.minus(a), along) / dot(along, along);
    let share = if share < Exact::zero() {
        Exact::zero()
    } else {
        share
    };
    let nearest = if share > Exact::one() {
        b
    } else {
        a.lerp(b, share)
    };
    let gap = point.minus(nearest);
    dot(gap, gap)
}

/// **Any loop.** The same holds for any closed rational curve, because its pieces lie in the convex hulls of their control points: here for closed cubics with random control points around the origin and random weights, at parameters all
/// round.
#[test]
fn polygon_follows_any_loop_within_the_tolerance() {
    let law = Law::new(
        "bspline::polygon_follows_any_loop_within_the_tolerance",
        suspects::library,
    )
    .on_cases(24);
    let input = |radius: std::ops::Range<i32>| (vec(radius, 8), vec(1..4_i32, 8));
    law.holds(input(8..14), input(4..16), |(radii, weights)| {
        let ring: Vec<_> = star(radii).into_iter().cycle().take(11).collect();
        let weights: Vec<_> = weights
            .iter()
            .cycle()
            .take(11)
            .map(|&w| integer(w))
            .collect();
        let knots = KnotVector::uniform(3, 11).expect("11 points");
        let curve = RationalCurve::new(knots, &ring, &weights).expect("positive weights");
        let tolerance = fraction(1, 20);
        let surface = TrimmedSurface::new(sheet(), curve.clone(), tolerance)
            .expect("a loop round the origin");
        let polygon = surface.polygon();
        for part in 0..40 {
            let point = curve.point(fraction(part, 5));
            let sides =
                (0..polygon.len()).map(|side| [polygon[side], polygon[(side + 1) % polygon.len()]]);
            let near = sides
                .map(|side| squared_distance(point, side))
                .any(|gap| gap <= tolerance * tolerance);
            expect_equal(&(part, true), &(part, near))?;
        }
        Ok(())
    });
}

/// **Left of the loop.** What is kept lies on the left of the loop: it must run anticlockwise. The same corners in the opposite order are refused as clockwise, wherever the loop starts.
#[test]
fn loop_must_run_anticlockwise() {
    let law = Law::new("bspline::loop_must_run_anticlockwise", suspects::library);
    let input = |radii: std::ops::Range<i32>| (vec(radii, 8), 0..8_usize);
    law.holds(input(1..30), input(1..3), |(radii, start)| {
        let mut corners = star(radii);
        corners.rotate_left(*start);
        expect_equal(&true, &trimmed(&corners).is_ok())?;
        corners.reverse();
        expect_equal(
            &Some(Box::new(TrimError::Clockwise)),
            &trimmed(&corners).err(),
        )
    });
}

fn meets_itself(corners: &[Parameters]) -> bool {
    let error = trimmed(corners).err();
    error.is_some_and(|error| matches!(*error, TrimError::MeetsItself { .. }))
}

/// **Simple loops only.** Exchange two corners of a convex loop that are not neighbours, and it crosses itself; the refusal names the two sides. A loop that touches itself in a point or runs back along itself is refused too: then there would be no inside that
/// a winding number of 1 describes.
#[test]
fn loop_that_meets_itself_is_refused() {
    let law = Law::new(
        "bspline::loop_that_meets_itself_is_refused",
        suspects::library,
    );
    // Two exchanged neighbours among eight corners cross, opposite ones too.
    let input = || (8..12_i32, 0..8_usize, 1..8_usize);
    law.holds(input(), input(), |&(radius, first, gap)| {
        let radii: Vec<i32> = (0..8)
            .map(|k| if k % 2 == 0 { radius * 7 / 5 } else { radius })
            .collect();
        let mut corners = star(&radii);
        corners.swap(first, (first + gap) % 8);
        let refused = meets_itself(&corners);
        expect_equal(&true, &refused)
    });
    let touching = [[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]].map(|corner| corner.map(integer));
    assert!(meets_itself(&touching));
    let folded = [[0, 0], [4, 0], [4, 4], [4, 2], [6, 2], [4, 2]].map(|corner| corner.map(integer));
    assert!(meets_itself(&folded));
}

/// **A trimmed surface is the surface.** Trimming changes no point: it only says which parameters count. The surface, its loop and its domain remain at hand.
#[test]
fn trimming_moves_no_point() {
    let law = Law::new("bspline::trimming_moves_no_point", suspects::library);
    law.holds(vec(point(), 4), vec(point(), 4), |corners| {
        let knots = KnotVector::bezier(1)
            .reparametrised([-8, 8].map(integer))
            .expect("a domain");
        let whole = BsplineSurface::new([knots.clone(), knots], corners.clone()).expect("2 x 2");
        let part = TrimmedSurface::new(whole.clone(), circle(), fraction(1, 10)).expect("a loop");
        for &[u, v] in part.polygon() {
            expect_equal(&whole.point(u, v), &part.surface().point(u, v))?;
        }
        expect_equal(&circle(), part.outline())
    });
}
