//! Many points at once: the prepared surface gives what the surface gives.

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{BsplineSurface, Direction, KnotVector, SurfaceEvaluator};
use facette::surface::Surface;
use num_traits::AsPrimitive;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::error_theorems::float_surfaces::{
    Float, FloatSurface, float_surfaces, hard_float_surfaces,
};
use crate::error_theorems::{Bound, bits};
use crate::inputs::{SurfaceCase, hard_surfaces, surfaces};
use crate::suspects;

/// To a byte as the floating-point types convert: without the fraction, and with saturation.
impl AsPrimitive<u8> for Exact {
    fn as_(self) -> u8 {
        let mut below = (1..=255_u8)
            .rev()
            .filter(|&n| fraction(n.into(), 1) <= self);
        below.next().unwrap_or(0)
    }
}

/// **A prepared surface is the surface.** Table of spans, Bézier patches and Bernstein's polynomials give the point that the double sum over all pairs of basis
/// functions defines, and the partial derivatives of the surface, everywhere in the closed domain; and on a grid as in a list.
///
/// Course: B11, slide 19, evaluation.
#[test]
fn prepared_surface_is_the_surface() {
    let name = "bspline::prepared_surface_is_the_surface";
    Law::new(name, suspects::library).holds(surfaces(), hard_surfaces(), |case| {
        let surface = case.surface();
        let evaluator = SurfaceEvaluator::new(case.surface());
        let [u, v] = case.at;
        let tangents = [[1, 0], [0, 1]].map(|orders| surface.derivative_at(orders, u, v));
        let mut point = [VectorSpace::origin()];
        evaluator.points(&[case.at], &mut point);
        expect_equal(&case.expected(), &point[0])?;
        let mut partials = [[VectorSpace::origin(); 3]; 2];
        evaluator.partials(&[case.at], &mut partials[..1]);
        evaluator.partials_on_grid(&[u], &[v], &mut partials[1..]);
        let expected = [case.expected(), tangents[0], tangents[1]];
        expect_equal(&[expected; 2], &partials)
    });
}

/// **Outside the domain the same polynomials go on.** A prepared surface extrapolates as the surface does, before the domain and behind it, however far.
#[test]
fn prepared_surface_extrapolates_like_the_surface() {
    let name = "bspline::prepared_surface_extrapolates_like_the_surface";
    let law = Law::new(name, suspects::library).on_cases(32);
    law.holds(surfaces(), hard_surfaces(), |case: &SurfaceCase| {
        let surface = case.surface();
        let [[u0, u1], [v0, v1]] = surface.domain();
        let far = fraction(1000, 1);
        let us = [u0 - far, u0 - fraction(1, 3), u1 + fraction(1, 3), u1 + far];
        let vs = [case.at[1], v0 - far, v1 + fraction(1, 2)];
        let mut points = [VectorSpace::origin(); 12];
        SurfaceEvaluator::new(case.surface()).points_on_grid(&us, &vs, &mut points);
        let pairs = vs.iter().flat_map(|&v| us.map(|u| surface.point(u, v)));
        expect_equal(&pairs.collect::<Vec<_>>(), &points.to_vec())
    });
}

/// **The error of many points at once.** Each coordinate of a point is within $(16p+16q+2)\,\mathbf u\cdot M$ of the exact point, $M$ the largest absolute value of that
/// coordinate among the $(p+1)(q+1)$ control points that count; each coordinate of a partial derivative within $(16p+16q-10)\,\mathbf u$ of the largest one of
/// the derivative's control points there.
///
/// In each direction: the Bézier points are de Boor's points, within $6p\,\mathbf u\cdot M$ like all of them. The place $t$ in the span has a rounded difference, a
/// rounded inverse and a rounded product, $3\mathbf u\,t$, which moves the point by at most $3\mathbf u$ times the length of the patch's derivative, $2p\cdot M$: another
/// $6p\,\mathbf u\cdot M$. Bernstein's polynomials take $3\mathbf u$ a degree, for $1-t$, a product and a sum, and the weighted sum $p+1$. Together $16p+1$. The control points of
/// a derivative are differences times quotients, $4\mathbf u$, and the rest is as for a surface whose degree is one less in that direction.
///
/// The sum of that many roundings, each at its worst, is far from what happens: rarely more than a twentieth of the bound is used.
#[test]
fn batch_error_stays_below_its_bound() {
    let bounds: [Bound; 4] = Default::default();
    let name = "bspline::batch_error_stays_below_its_bound";
    let law = Law::new(name, suspects::library).on_cases(128);
    law.holds(float_surfaces(), hard_float_surfaces(), |case| {
        batch_error::<f64>(case, &bounds[..2])?;
        batch_error::<f32>(case, &bounds[2..])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.02);
    }
}

fn batch_error<S: Float>(case: &FloatSurface, bounds: &[Bound]) -> Verdict {
    let rounded = case.rounded::<S>();
    let surface = &rounded.surface;
    let [p, q] = [Direction::U, Direction::V].map(|d| surface.knots(d).degree() as f64);
    let mut partials = [[[S::zero(); 3]; 3]];
    SurfaceEvaluator::new(surface.clone()).partials(&[rounded.at], &mut partials);
    let [point, tangents @ ..] = partials[0];
    let factor = 16.0 * (p + q);
    bounds[0].holds_for_point(point, &rounded.exact_point(), factor + 2.0, rounded.sizes())?;
    for (direction, tangent) in [Direction::U, Direction::V].into_iter().zip(tangents) {
        let (exact, sizes) = rounded.exact_partial(direction);
        bounds[1].holds_for_point(tangent, &exact, factor - 10.0, sizes)?;
    }
    Ok(())
}

/// **A grid has the same bits, and so has a list of any length.** Points and partial derivatives do not depend on what they are evaluated with: alone, in a list,
/// or on a grid whose columns lie in the same span or not, inside the domain or not.
#[test]
fn batch_gives_the_same_bits_in_any_company() {
    let name = "bspline::batch_gives_the_same_bits_in_any_company";
    let law = Law::new(name, suspects::library);
    law.holds(float_surfaces(), hard_float_surfaces(), |case| {
        same_bits::<f64>(case)?;
        same_bits::<f32>(case)
    });
}

/// Compares a grid of 13 by 11 parameters with the list of its points and with each of them alone.
fn same_bits<S: Float>(case: &FloatSurface) -> Verdict {
    let rounded = case.rounded::<S>();
    let evaluator = SurfaceEvaluator::new(rounded.surface.clone());
    let line = |direction: Direction, extra: S, count: i32| {
        let [start, end] = rounded.surface.knots(direction).domain();
        let steps = (-1..count - 2).map(|k| start.lerp(end, S::ratio(k, count - 4)));
        steps.chain([extra]).collect::<Vec<S>>()
    };
    let us = line(Direction::U, rounded.at[0], 13);
    let vs = line(Direction::V, rounded.at[1], 11);
    let pairs = vs.iter().flat_map(|&v| us.iter().map(move |&u| [u, v]));
    let pairs: Vec<[S; 2]> = pairs.collect();
    let mut points = vec![[S::zero(); 3]; pairs.len()];
    let mut partials = [(); 2].map(|()| vec![[[S::zero(); 3]; 3]; pairs.len()]);
    evaluator.points(&pairs, &mut points);
    evaluator.partials(&pairs, &mut partials[0]);
    let all = |partials: &[[[S; 3]; 3]]| {
        let bits = partials.iter().map(|partials| partials.map(bits));
        bits.collect::<Vec<_>>()
    };
    let listed = all(&partials[0]);
    evaluator.partials_on_grid(&us, &vs, &mut partials[1]);
    expect_equal(&listed, &all(&partials[1]))?;
    let as_list: Vec<_> = points.iter().map(|&point| bits(point)).collect();
    let firsts: Vec<_> = listed.iter().map(|partials| partials[0]).collect();
    expect_equal(&firsts, &as_list)?;
    evaluator.points_on_grid(&us, &vs, &mut points);
    expect_equal(&as_list, &points.iter().map(|&point| bits(point)).collect())?;
    for (pair, expected) in pairs.iter().zip(&as_list) {
        let mut alone = [[S::zero(); 3]];
        evaluator.points(&[*pair], &mut alone);
        expect_equal(expected, &bits(alone[0]))?;
    }
    Ok(())
}

/// **Normals in a list.** Each has the direction of the normal that the surface gives, up to the rounding of the two products; where the surface gives none, the normal is
/// the zero vector, and where the tangents vanish it is the surface's own.
#[test]
fn batch_normals_have_the_direction_of_the_surface() {
    let name = "bspline::batch_normals_have_the_direction_of_the_surface";
    Law::new(name, suspects::library).holds(surfaces(), hard_surfaces(), |case: &SurfaceCase| {
        let surface = case.surface();
        let mut normals = [VectorSpace::origin()];
        SurfaceEvaluator::new(case.surface()).normals(&[case.at], &mut normals);
        let [u, v] = case.at;
        let expected: [Exact; 3] = surface.normal_vector(u, v).unwrap_or(VectorSpace::origin());
        expect_equal(&VectorSpace::origin(), &expected.cross(normals[0]))?;
        let points_alike = expected.dot(normals[0]) > fraction(0, 1);
        let has_normal = expected != <[Exact; 3]>::origin();
        expect_equal(&has_normal, &points_alike)
    });
}

/// A bilinear patch with an edge of length 0 at v = 1 and a bicubic one, as tests of single places need them.
fn bicubic(knots: [KnotVector<f64>; 2]) -> BsplineSurface<[f64; 3]> {
    let columns = knots[0].control_point_count();
    let count = columns * knots[1].control_point_count();
    let point = |k: usize| {
        let [i, j] = [k % columns, k / columns].map(|index| index as f64);
        [i, j, ((k * 7) % 5) as f64]
    };
    BsplineSurface::new(knots, (0..count).map(point).collect()).expect("one point for each pair")
}

/// **What is not a number stays none.** A parameter that is NaN gives a point and derivatives that are NaN, and no normal; the others in the list are as if it were not there.
#[test]
fn batch_keeps_nan_to_itself() {
    let knots = || KnotVector::clamped_uniform(3, 7).expect("more points than the degree");
    let evaluator = SurfaceEvaluator::new(bicubic([knots(), knots()]));
    let pairs = [[0.3, 0.6], [f64::NAN, 0.6], [0.3, f64::NAN], [1.0, 1.0]];
    let mut partials = [[[0.0; 3]; 3]; 4];
    evaluator.partials(&pairs, &mut partials);
    for index in [1, 2] {
        assert!(partials[index].as_flattened().iter().all(|x| x.is_nan()));
    }
    assert_eq!(partials[3][0], evaluator.surface().control_point(6, 6));
    assert!(partials[0].as_flattened().iter().all(|x| x.is_finite()));
    let mut normals = [[1.0; 3]; 4];
    evaluator.normals(&pairs, &mut normals);
    assert_eq!(normals[1..3], [[0.0; 3]; 2]);
    assert!(normals[0][2] > 0.0 && normals[3] != [0.0; 3]);
}

/// **Knots that no inverse can hold.** Where a span is so short that one over its length overflows, or so long that the length does, the prepared surface gives
/// the bits of the surface itself; and so it does for degrees without loops of their own.
#[test]
fn extreme_knots_and_high_degrees_are_left_to_the_surface() {
    let ordinary = || KnotVector::clamped_uniform(3, 6).expect("more points than the degree");
    let denormal = [0.0, 5e-324, 1e-323, 1.5e-323, 1.0];
    let wide = [-1.7e308, 1.7e308];
    let high = || KnotVector::clamped_uniform(5, 9).expect("more points than the degree");
    for knots in [
        [
            KnotVector::clamped(3, &denormal).expect("valid"),
            ordinary(),
        ],
        [ordinary(), KnotVector::clamped(3, &wide).expect("valid")],
        [high(), ordinary()],
    ] {
        let surface = bicubic(knots);
        let [[u0, u1], [v0, v1]] = surface.domain();
        let evaluator = SurfaceEvaluator::new(surface.clone());
        let pairs = [
            [u0, v1],
            [5e-324, v0 * 0.5 + v1 * 0.5],
            [u1, v0],
            [u1 * 0.25, v0],
        ];
        let mut points = [[0.0; 3]; 4];
        evaluator.points(&pairs, &mut points);
        let expected = pairs.map(|[u, v]| surface.point(u, v));
        assert_eq!(expected.map(bits), points.map(bits));
        assert!(points.as_flattened().iter().all(|x| x.is_finite()));
    }
}

/// **Many breaks in one part of the table.** Knots that nearly coincide fall into the same part of the domain: the span is found among them all the same, and a parameter at a break
/// belongs to the piece behind it.
#[test]
fn table_of_spans_survives_knots_close_together() {
    let mut breaks = vec![0.0];
    breaks.extend((0..40).map(|k| 0.5 + f64::from(k) * f64::EPSILON));
    breaks.extend([0.75, 1.0]);
    let knots = KnotVector::clamped(1, &breaks).expect("increasing breaks");
    let points = (0..breaks.len()).map(|k| [k as f64, ((k * k) % 7) as f64, 0.0]);
    let net: Vec<[f64; 3]> = points
        .clone()
        .chain(points.map(|[x, y, _]| [x, y, 1.0]))
        .collect();
    let surface = BsplineSurface::new([knots, KnotVector::bezier(1)], net).expect("two rows");
    let evaluator = SurfaceEvaluator::new(surface);
    let pairs: Vec<[f64; 2]> = breaks.iter().map(|&u| [u, 0.0]).collect();
    let mut found = vec![[0.0; 3]; pairs.len()];
    evaluator.points(&pairs, &mut found);
    for (k, point) in found.iter().enumerate() {
        assert_eq!(*point, evaluator.surface().control_point(k, 0));
    }
    let mut partials = vec![[[0.0; 3]; 3]; pairs.len()];
    evaluator.partials(&pairs, &mut partials);
    for ([_, s_u, _], &[u, v]) in partials.iter().zip(&pairs) {
        // The slopes differ from piece to piece.
        assert_eq!(*s_u, evaluator.surface().derivative_at([1, 0], u, v));
    }
}

/// **A buffer of the wrong length.** It is a bug of the caller, and the message says both lengths.
#[test]
#[should_panic(expected = "2 pairs of parameters need as many places, not 1")]
fn buffer_of_the_wrong_length_is_refused() {
    let evaluator = SurfaceEvaluator::new(bicubic([KnotVector::bezier(3), KnotVector::bezier(3)]));
    evaluator.points(&[[0.5; 2]; 2], &mut [[0.0; 3]]);
}
