//! The variants of the chapter *bspline*: points of curves and surfaces one by one and many at once, partial derivatives, normals, grids.

use std::hint::black_box;

use facette::algebra::{VectorSpace, unit_vector};
use facette::bspline::{BsplineCurve, KnotVector, curve_point, de_boor_point, surface_point};
use facette::surface::Surface;

use crate::Visitor;
use crate::float_inputs::FloatPoint;
use crate::harness::{Comparison, Effort, Exact, lazily};
use inputs::{InputSet, Number, Scene, hard, typical};
use variants::{BezierPatches, BezierPieces, MonomialPatches, MonomialPieces, PowersOfU};

mod exact;
mod inputs;
#[path = "../../tests/bspline/variants.rs"]
mod variants;

/// So many points of a curve of high degree are evaluated: exact values take long.
const HIGH_POINTS: usize = 64;

/// The scenes of one set of inputs in both types of numbers.
struct Scenes {
    name: &'static str,
    f64: Scene<f64>,
    f32: Scene<f32>,
}

impl Scenes {
    fn new(set: &InputSet) -> Self {
        Self {
            name: set.name,
            f64: Scene::new(set),
            f32: Scene::new(set),
        }
    }

    fn compare<'a>(&self, quantity: &'static str) -> Comparison<'a> {
        Comparison::new(quantity, self.name, self.f64.parameters.len())
    }
}

/// A quantity with all its variants, on the scenes of one set of inputs.
type Quantity = fn(&Scenes) -> Comparison<'_>;

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let scenes = [typical(4 * effort.points), hard(4 * effort.points)];
    let scenes = scenes.each_ref().map(Scenes::new);
    for quantity in [
        curve_points as Quantity,
        high_degree,
        points,
        partials,
        normals,
        grids,
        grids_of_partials,
    ] {
        for inputs in &scenes {
            visitor(quantity(inputs));
        }
    }
    visitor(near_a_zero());
}

fn curve_points(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let wide = exact_curve(f64, &f64.curve, f64.parameters.len());
    let narrow = exact_curve(f32, &f32.curve, f32.parameters.len());
    let naive = f64.each(&f64.curve, |curve, [u, _]| {
        [variants::naive_curve_point(
            curve.knots(),
            curve.control_points(),
            u,
        )]
    });
    let comparison = scenes.compare("cubic point");
    let comparison = comparison.variant(["naive recursion", "f64"], &wide, naive);
    curve_variants(comparison, f64, &f64.curve, &wide)
        .variant(["compensated", "f64"], &wide, compensated(f64, &f64.curve))
        .variant(
            ["triangular basis", "f32"],
            &narrow,
            triangular(f32, &f32.curve),
        )
        .variant(["de Boor", "f32"], &narrow, de_boor(f32, &f32.curve))
}

/// Without the naive recursion, which calls itself a million times for each basis function.
fn high_degree(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let wide = exact_curve(f64, &f64.high, HIGH_POINTS.min(f64.parameters.len()));
    let narrow = exact_curve(f32, &f32.high, HIGH_POINTS.min(f32.parameters.len()));
    let count = HIGH_POINTS.min(f64.parameters.len());
    let comparison = Comparison::new("point of degree 20", scenes.name, count);
    curve_variants(comparison, f64, &f64.high, &wide)
        .variant(["compensated", "f64"], &wide, compensated(f64, &f64.high))
        .variant(
            ["triangular basis", "f32"],
            &narrow,
            triangular(f32, &f32.high),
        )
        .variant(["de Boor", "f32"], &narrow, de_boor(f32, &f32.high))
}

fn exact_curve<'a, S: Number>(
    scene: &'a Scene<S>,
    curve: &'a BsplineCurve<[S; 3]>,
    count: usize,
) -> Exact<'a> {
    lazily(move || {
        let parameters = scene.parameters[..count].iter();
        parameters
            .map(|&[u, _]| exact::curve_point(curve, u))
            .collect()
    })
}

/// The ways that all degrees have in common.
fn curve_variants<'a>(
    comparison: Comparison<'a>,
    scene: &'a Scene<f64>,
    curve: &'a BsplineCurve<[f64; 3]>,
    exact: &Exact<'a>,
) -> Comparison<'a> {
    let scheme = scene.each(BezierPieces::new(curve), |pieces, [u, _]| {
        [pieces.point(u, variants::de_casteljau)]
    });
    let horner = scene.each(BezierPieces::new(curve), |pieces, [u, _]| {
        [pieces.point(u, variants::bernstein_horner)]
    });
    let monomials = scene.each(MonomialPieces::new(curve), |pieces, [u, _]| {
        [pieces.point(u)]
    });
    let powers = scene.each(PowersOfU::new(curve), |pieces, [u, _]| [pieces.point(u)]);
    comparison
        .variant(["triangular basis", "f64"], exact, triangular(scene, curve))
        .variant(["de Boor", "f64"], exact, de_boor(scene, curve))
        .variant(["pieces by de Casteljau", "f64"], exact, scheme)
        .variant(["pieces by Bernstein-Horner", "f64"], exact, horner)
        .variant(["monomial pieces", "f64"], exact, monomials)
        .variant(["powers of u", "f64"], exact, powers)
}

fn triangular<'a, S: Number>(
    scene: &'a Scene<S>,
    curve: &'a BsplineCurve<[S; 3]>,
) -> impl FnMut(&mut [[S; 3]]) + 'a
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    scene.each(curve, |curve, [u, _]| {
        [curve_point(curve.knots(), curve.control_points(), u)]
    })
}

fn de_boor<'a, S: Number>(
    scene: &'a Scene<S>,
    curve: &'a BsplineCurve<[S; 3]>,
) -> impl FnMut(&mut [[S; 3]]) + 'a
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    scene.each(curve, |curve, [u, _]| {
        [de_boor_point(curve.knots(), curve.control_points(), u)]
    })
}

fn compensated<'a>(
    scene: &'a Scene<f64>,
    curve: &'a BsplineCurve<[f64; 3]>,
) -> impl FnMut(&mut [[f64; 3]]) + 'a {
    scene.each(curve, |curve, [u, _]| {
        let (knots, points) = (curve.knots(), curve.control_points());
        [variants::compensated_de_boor_point(knots, points, u)]
    })
}

fn points(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let [wide, narrow] = [lazily(|| f64.exact_points()), lazily(|| f32.exact_points())];
    let naive = f64.each(&f64.surface, |surface, [u, v]| {
        [variants::naive_surface_point(surface, u, v)]
    });
    let scheme = f64.each(BezierPatches::new(&f64.surface), |patches, at| {
        [patches.point(at, variants::de_casteljau)]
    });
    let horner = f64.each(BezierPatches::new(&f64.surface), |patches, at| {
        [patches.point(at, variants::bernstein_horner)]
    });
    let monomials = f64.each(MonomialPatches::new(&f64.surface), |patches, at| {
        [patches.point(at)]
    });
    scenes
        .compare("surface point")
        .variant(["naive recursion", "f64"], &wide, naive)
        .variant(["triangular basis", "f64"], &wide, by_basis(f64))
        .variant(["patches by de Casteljau", "f64"], &wide, scheme)
        .variant(["patches by Bernstein-Horner", "f64"], &wide, horner)
        .variant(["monomial patches", "f64"], &wide, monomials)
        .variant(["prepared in lists", "f64"], &wide, in_lists(f64))
        .variant(["triangular basis", "f32"], &narrow, by_basis(f32))
        .variant(["prepared in lists", "f32"], &narrow, in_lists(f32))
}

fn by_basis<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]])
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    scene.each(&scene.surface, |surface, [u, v]| {
        [surface_point(surface, u, v)]
    })
}

fn in_lists<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]]) {
    |points| black_box(&scene.evaluator).points(&scene.parameters, points)
}

fn partials(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let [wide, narrow] = [exact_partials(f64), exact_partials(f32)];
    scenes
        .compare("point and partial derivatives")
        .with_points_each(3)
        .variant(["one by one", "f64"], &wide, each_partials(f64))
        .variant(["prepared in lists", "f64"], &wide, listed_partials(f64))
        .variant(["one by one", "f32"], &narrow, each_partials(f32))
        .variant(["prepared in lists", "f32"], &narrow, listed_partials(f32))
}

fn exact_partials<S: Number>(scene: &Scene<S>) -> Exact<'_> {
    lazily(|| all_partials(scene, &scene.parameters))
}

fn all_partials<S: Number>(scene: &Scene<S>, pairs: &[[S; 2]]) -> Vec<crate::harness::ExactPoint> {
    let triple = |&at| {
        let [s_u, s_v] = exact::partials(&scene.surface, at);
        [exact::point(&scene.surface, at), s_u, s_v]
    };
    pairs.iter().flat_map(triple).collect()
}

fn each_partials<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]])
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    scene.each(&scene.surface, |surface, [u, v]| {
        [[0, 0], [1, 0], [0, 1]].map(|orders| surface.derivative_at(orders, u, v))
    })
}

fn listed_partials<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]]) {
    |points| {
        let triples = points.as_chunks_mut::<3>().0;
        black_box(&scene.evaluator).partials(&scene.parameters, triples);
    }
}

/// Unit normals, so that normals of different lengths can be compared.
fn normals(scenes: &Scenes) -> Comparison<'_> {
    let f64 = &scenes.f64;
    let exact = lazily(|| {
        let pairs = f64.parameters.iter();
        pairs.map(|&at| exact::normal(&f64.surface, at)).collect()
    });
    let unit = |normal: [f64; 3]| unit_vector(normal).unwrap_or_else(VectorSpace::origin);
    let one_by_one = f64.each(&f64.surface, move |surface, [u, v]| {
        let normal = surface.normal_vector(u, v);
        [unit(normal.unwrap_or_else(VectorSpace::origin))]
    });
    let in_lists = move |normals: &mut [[f64; 3]]| {
        black_box(&f64.evaluator).normals(&f64.parameters, normals);
        for normal in normals {
            *normal = unit(*normal);
        }
    };
    scenes
        .compare("unit normal")
        .variant(["one by one", "f64"], &exact, one_by_one)
        .variant(["prepared in lists", "f64"], &exact, in_lists)
}

fn grids(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let [wide, narrow] = [exact_grid(f64), exact_grid(f32)];
    let pairs = f64.grid();
    let one_by_one = move |points: &mut [[f64; 3]]| {
        for (point, &[u, v]) in points.iter_mut().zip(black_box(&pairs)) {
            *point = f64.surface.point(u, v);
        }
    };
    let mut count = 0.0;
    let write_once = move |points: &mut [[f64; 3]]| {
        count += 1.0;
        points.fill([black_box(count); 3]);
    };
    Comparison::new("surface grid", scenes.name, f64.grid().len())
        .variant(["point by point", "f64"], &wide, one_by_one)
        .variant(["row by row", "f64"], &wide, row_wise(f64))
        .variant(["prepared", "f64"], &wide, prepared_grid(f64))
        .variant(["row by row", "f32"], &narrow, row_wise(f32))
        .variant(["prepared", "f32"], &narrow, prepared_grid(f32))
        .yardstick(["writing the grid once", "f64"], write_once)
}

fn exact_grid<S: Number>(scene: &Scene<S>) -> Exact<'_>
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    lazily(|| {
        let pairs = scene.grid().into_iter();
        pairs.map(|at| exact::point(&scene.surface, at)).collect()
    })
}

fn row_wise<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]]) {
    let [us, vs] = &scene.lines;
    move |points| black_box(&scene.surface).points_on_grid(us, vs, points)
}

fn prepared_grid<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]]) {
    let [us, vs] = &scene.lines;
    move |points| black_box(&scene.evaluator).points_on_grid(us, vs, points)
}

fn grids_of_partials(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let wide = lazily(|| all_partials(f64, &f64.grid()));
    let narrow = lazily(|| all_partials(f32, &f32.grid()));
    Comparison::new("grid of partial derivatives", scenes.name, f64.grid().len())
        .with_points_each(3)
        .variant(["prepared", "f64"], &wide, prepared_partials(f64))
        .variant(["prepared", "f32"], &narrow, prepared_partials(f32))
}

fn prepared_partials<S: Number>(scene: &Scene<S>) -> impl FnMut(&mut [[S; 3]]) {
    let [us, vs] = &scene.lines;
    move |points| {
        let triples = points.as_chunks_mut::<3>().0;
        black_box(&scene.evaluator).partials_on_grid(us, vs, triples);
    }
}

/// The cubic `8 (u − 1/2)³` in each coordinate, close to its zero: cancellation, and what its cure costs.
fn near_a_zero<'a>() -> Comparison<'a> {
    let knots = KnotVector::clamped(3, &[0.0, 0.3, 0.7, 1.0]).expect("increasing breaks");
    let blossom = |arguments: &[f64]| arguments.iter().map(|u| 2.0 * (u - 0.5)).product();
    let points = knots.knots()[1..9].windows(3).map(|u| [blossom(u); 3]);
    let curve = BsplineCurve::new(knots.clone(), points.collect()).expect("six finite points");
    let us: Vec<f64> = (1..=256).map(|k| 0.5 + f64::from(k) * 1e-7).collect();
    let at_all = us.clone();
    let of_exact = curve.clone();
    let exact = lazily(move || {
        let points = at_all.iter();
        points.map(|&u| exact::curve_point(&of_exact, u)).collect()
    });
    let work = |evaluate: fn(&BsplineCurve<[f64; 3]>, f64) -> [f64; 3]| {
        let (curve, us) = (curve.clone(), us.clone());
        move |points: &mut [[f64; 3]]| {
            for (point, &u) in points.iter_mut().zip(black_box(&us)) {
                *point = evaluate(&curve, u);
            }
        }
    };
    let basis =
        |curve: &BsplineCurve<[f64; 3]>, u| curve_point(curve.knots(), curve.control_points(), u);
    let de_boor =
        |curve: &BsplineCurve<[f64; 3]>, u| de_boor_point(curve.knots(), curve.control_points(), u);
    let compensated = |curve: &BsplineCurve<[f64; 3]>, u| {
        variants::compensated_de_boor_point(curve.knots(), curve.control_points(), u)
    };
    Comparison::new("cubic point near a zero", "hard", us.len())
        .variant(["triangular basis", "f64"], &exact, work(basis))
        .variant(["de Boor", "f64"], &exact, work(de_boor))
        .variant(["compensated", "f64"], &exact, work(compensated))
}
