//! The variants of the chapter *coons*: bilinear and bicubic points, edges, grids, derivatives, and the curves below them.

use std::hint::black_box;

use facette::coons::{CoonsPatch, bicubic_point, bilinear_partials, bilinear_point};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use glam::{DVec3, Vec3A};

use crate::Visitor;
use crate::float_inputs::FloatPoint;
use crate::harness::{Comparison, Effort, Exact, lazily};
use inputs::{InputSet, Scene, hard, typical};
use variants::HandWrittenPatch;

mod exact;
#[path = "../../tests/coons/error_theorems/exact_patch.rs"]
mod exact_patch;
mod inputs;
#[path = "../../tests/coons/variants.rs"]
mod variants;

/// The scenes of one set of inputs in all types of points.
struct Scenes {
    name: &'static str,
    f64: Scene<[f64; 3]>,
    f32: Scene<[f32; 3]>,
    dvec3: Scene<DVec3>,
    vec3a: Scene<Vec3A>,
}

impl Scenes {
    fn new(set: &InputSet) -> Self {
        Self {
            name: set.name,
            f64: Scene::new(set),
            f32: Scene::new(set),
            dvec3: Scene::new(set),
            vec3a: Scene::new(set),
        }
    }

    fn compare<'a>(&self, quantity: &'static str) -> Comparison<'a> {
        Comparison::new(quantity, self.name, self.f64.evaluations())
    }
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let sets = [typical(effort.points), hard(effort.points)];
    let scenes = sets.each_ref().map(Scenes::new);
    let on_edges = sets.each_ref().map(|set| Scenes::new(&set.on_edges()));
    let on_grids = sets.each_ref().map(|set| Scenes::new(&set.on_a_grid()));
    for (scenes, quantity) in [
        (&scenes, points as Quantity),
        (&on_edges, edges),
        (&on_grids, grids),
        (&scenes, bicubic),
        (&scenes, partials),
        (&scenes, cubics),
        (&scenes, high_degree),
    ] {
        for inputs in scenes {
            visitor(quantity(inputs));
        }
    }
}

/// A quantity with all its variants, on the scenes of one set of inputs.
type Quantity = fn(&Scenes) -> Comparison<'_>;

fn points(scenes: &Scenes) -> Comparison<'_> {
    let exact = [
        lazily(|| exact::points(&scenes.f64)),
        lazily(|| exact::points(&scenes.f32)),
    ];
    point_variants(scenes.compare("bilinear point"), scenes, &exact)
}

/// The patch on its own edges: how far it is from the computed points of the curves, which a neighbour has too.
fn edges(scenes: &Scenes) -> Comparison<'_> {
    let exact = [
        lazily(|| exact::computed_edges(&scenes.f64)),
        lazily(|| exact::computed_edges(&scenes.f32)),
    ];
    point_variants(scenes.compare("gap at an edge"), scenes, &exact)
}

fn point_variants<'a>(
    comparison: Comparison<'a>,
    scenes: &'a Scenes,
    [wide, narrow]: &[Exact<'a>; 2],
) -> Comparison<'a> {
    let Scenes {
        f64,
        f32,
        dvec3,
        vec3a,
        ..
    } = scenes;
    let by_hand: Vec<_> = f64.bilinear.iter().map(hand_written).collect();
    let by_hand = f64.each(by_hand, |patch, u, v| [patch.point(u, v)]);
    comparison
        .variant(["direct", "f64"], wide, direct(f64))
        .variant(["compensated", "f64"], wide, compensated(f64))
        .variant(["compensated by hand", "f64"], wide, by_hand)
        .variant(["fused", "f64"], wide, fused(f64))
        .variant(["short lerp", "f64"], wide, short_lerp(f64))
        .variant(["direct", "f32"], narrow, direct(f32))
        .variant(["compensated", "f32"], narrow, compensated(f32))
        .variant(["fused", "f32"], narrow, fused(f32))
        .variant(["compensated", "DVec3"], wide, compensated(dvec3))
        .variant(["compensated", "Vec3A"], narrow, compensated(vec3a))
}

fn direct<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], |patch, u, v| {
        [variants::direct_point(patch.boundary(), u, v)]
    })
}

fn compensated<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], |patch, u, v| {
        [bilinear_point(patch.boundary(), u, v)]
    })
}

fn fused<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], |patch, u, v| {
        [variants::fused_point(patch.boundary(), u, v)]
    })
}

fn short_lerp<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], |patch, u, v| {
        [variants::short_lerp_point(patch.boundary(), u, v)]
    })
}

fn hand_written(patch: &CoonsPatch<BezierCurve<[f64; 3]>>) -> HandWrittenPatch {
    let boundary = patch.boundary();
    let edges = [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()];
    HandWrittenPatch::new(edges.map(|edge| edge.control_points().to_vec()))
}

fn grids(scenes: &Scenes) -> Comparison<'_> {
    let Scenes {
        f64,
        f32,
        dvec3,
        vec3a,
        ..
    } = scenes;
    let [wide, narrow] = [lazily(|| exact::points(f64)), lazily(|| exact::points(f32))];
    let by_hand = hand_written(&f64.bilinear[0]);
    let [us, vs] = f64.grid_lines();
    let by_hand = move |points: &mut [[f64; 3]]| {
        black_box(&by_hand).points_on_grid(black_box(&us), &vs, points);
    };
    let mut count = 0.0;
    let write_once = move |points: &mut [[f64; 3]]| {
        count += 1.0;
        points.fill([black_box(count); 3]);
    };
    let one_by_one = f64.each(&f64.bilinear[..], |patch, u, v| [patch.point(u, v)]);
    scenes
        .compare("bilinear grid")
        .variant(["point by point", "f64"], &wide, one_by_one)
        .variant(["row-wise", "f64"], &wide, row_wise(f64))
        .variant(["row-wise by hand", "f64"], &wide, by_hand)
        .variant(["row-wise", "f32"], &narrow, row_wise(f32))
        .variant(["row-wise", "DVec3"], &wide, row_wise(dvec3))
        .variant(["row-wise", "Vec3A"], &narrow, row_wise(vec3a))
        .yardstick(["writing the grid once", "f64"], write_once)
}

fn row_wise<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    let [us, vs] = scene.grid_lines();
    move |points| black_box(&scene.bilinear[0]).points_on_grid(&us, &vs, points)
}

fn bicubic(scenes: &Scenes) -> Comparison<'_> {
    let Scenes {
        f64,
        f32,
        dvec3,
        vec3a,
        ..
    } = scenes;
    let [wide, narrow] = [
        lazily(|| exact::bicubic_points(f64)),
        lazily(|| exact::bicubic_points(f32)),
    ];
    let direct = f64.each(&f64.hermite[..], |data, u, v| {
        [variants::direct_bicubic_point(data, u, v)]
    });
    scenes
        .compare("bicubic point")
        .variant(["direct", "f64"], &wide, direct)
        .variant(["compensated", "f64"], &wide, bicubic_compensated(f64))
        .variant(["compensated", "f32"], &narrow, bicubic_compensated(f32))
        .variant(["compensated", "DVec3"], &wide, bicubic_compensated(dvec3))
        .variant(
            ["compensated", "Vec3A"],
            &narrow,
            bicubic_compensated(vec3a),
        )
}

fn bicubic_compensated<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.hermite[..], |data, u, v| [bicubic_point(data, u, v)])
}

fn partials(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let [wide, narrow] = [
        lazily(|| exact::partials(f64)),
        lazily(|| exact::partials(f32)),
    ];
    scenes
        .compare("partial derivatives")
        .with_points_each(2)
        .variant(["formula", "f64"], &wide, formula(f64))
        .variant(
            ["central difference", "f64"],
            &wide,
            differences(f64, f64::EPSILON.cbrt()),
        )
        .variant(["formula", "f32"], &narrow, formula(f32))
        .variant(
            ["central difference", "f32"],
            &narrow,
            differences(f32, f32::EPSILON.cbrt()),
        )
}

fn formula<P: FloatPoint>(scene: &Scene<P>) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], |patch, u, v| {
        let known = bilinear_partials(patch.boundary(), u, v);
        known.unwrap_or([P::origin(); 2])
    })
}

/// Central differences; the step balances the rounding error against the neglected third derivative.
fn differences<P: FloatPoint>(scene: &Scene<P>, step: P::Scalar) -> impl FnMut(&mut [P]) {
    scene.each(&scene.bilinear[..], move |patch, u, v| {
        variants::central_differences(|u, v| patch.point(u, v), [u, v], step)
    })
}

fn cubics(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let [wide, narrow] = [
        lazily(|| exact::edge_points(f64)),
        lazily(|| exact::edge_points(f32)),
    ];
    let [first, second] = [edge_curves(f64), edge_curves(f64)];
    let looped = f64.each(edge_curves(f64), |curve, u, _| {
        let control_points = curve.control_points();
        [variants::looped_de_casteljau(control_points, u)]
    });
    let [third, fourth] = [edge_curves(f32), edge_curves(f32)];
    scenes
        .compare("cubic point")
        .variant(["de Casteljau", "f64"], &wide, de_casteljau(f64, first))
        .variant(["de Casteljau in loops", "f64"], &wide, looped)
        .variant(["Horner", "f64"], &wide, horner(f64, &second))
        .variant(["de Casteljau", "f32"], &narrow, de_casteljau(f32, third))
        .variant(["Horner", "f32"], &narrow, horner(f32, &fourth))
}

fn edge_curves<P: FloatPoint>(scene: &Scene<P>) -> Vec<BezierCurve<P>> {
    let edges = scene.bilinear.iter().map(|patch| patch.boundary().p1());
    edges.cloned().collect()
}

fn high_degree(scenes: &Scenes) -> Comparison<'_> {
    let Scenes { f64, f32, .. } = scenes;
    let wide = lazily(|| exact::curve_points(f64));
    let narrow = lazily(|| exact::curve_points(f32));
    scenes
        .compare("point of degree 20")
        .variant(
            ["de Casteljau", "f64"],
            &wide,
            de_casteljau(f64, &f64.curves[..]),
        )
        .variant(["Horner", "f64"], &wide, horner(f64, &f64.curves))
        .variant(
            ["de Casteljau", "f32"],
            &narrow,
            de_casteljau(f32, &f32.curves[..]),
        )
        .variant(["Horner", "f32"], &narrow, horner(f32, &f32.curves))
}

fn de_casteljau<'a, P: FloatPoint>(
    scene: &'a Scene<P>,
    curves: impl AsRef<[BezierCurve<P>]> + 'a,
) -> impl FnMut(&mut [P]) + 'a {
    scene.each(curves, |curve, u, _| [curve.point(u)])
}

/// Horner's rule on monomial coefficients that are computed once a curve, outside the measured time.
fn horner<'a, P: FloatPoint>(
    scene: &'a Scene<P>,
    curves: &[BezierCurve<P>],
) -> impl FnMut(&mut [P]) + use<'a, P> {
    let coefficients = curves
        .iter()
        .map(|curve| variants::monomial_coefficients(curve.control_points()));
    let coefficients: Vec<Vec<P>> = coefficients.collect();
    scene.each(coefficients, |coefficients, u, _| {
        [variants::horner_point(coefficients, u)]
    })
}
