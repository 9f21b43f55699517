//! The theorems of curved surfaces that rays meet as triangles. The book shows their doc comments.

use facette::algebra::{Vector3, VectorSpace, length};
use facette::bspline::BsplineSurface;
use facette::intersection::Intersect;
use facette::intersection::bezier_patch::PatchIntersector;
use facette::intersection::hierarchy::Hierarchy;
use facette::ray::Ray;
use facette::surface::Surface;
use facette::tessellation::{Tessellation, tessellate};
use glam::Vec3;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, expect_at_most};
use crate::patch_inputs::{ThroughAPoint, hard, patch, wild};
use crate::suspects;

type Point = [f64; 3];

fn single(point: Point) -> Vec3 {
    glam::DVec3::from(point).as_vec3()
}

fn to_hierarchy(tessellation: &Tessellation<Point>) -> Hierarchy {
    Hierarchy::of_mesh(&tessellation.mesh).expect("finite corners")
}

/// A graph z = f(x, y) over a rectangle with corners at whole numbers, met from above.
fn as_graph(mut input: ThroughAPoint) -> ThroughAPoint {
    let columns = input.degrees[0] + 1;
    for (place, point) in input.control_points.iter_mut().enumerate() {
        let [i, j] = [place % columns, place / columns];
        point[0] = i32::try_from(i).expect("a small degree");
        point[1] = i32::try_from(j).expect("a small degree");
        point[2] /= 4;
    }
    input.direction = [0, 0, -1];
    input
}

/// The largest of `|f_x| + |f_y|`, from differences of control points.
fn steepness(patch: &PatchIntersector<Point>) -> f64 {
    let points = patch.surface().control_points();
    let heights = points.iter().map(|p| p[2]);
    let [low, high] = [
        heights.clone().fold(f64::INFINITY, f64::min),
        heights.fold(f64::NEG_INFINITY, f64::max),
    ];
    (high - low) * patch.degrees().iter().sum::<usize>() as f64
}

/// **Triangles within $\tau$.** A surface is cut into triangles within a tolerance $\tau$, rounded to single precision, and met by rays through a hierarchy of boxes. The point of a hit is within $\tau$, and the rounding, of the surface's point at the parameters that the hit's weights
/// give between those of the corners. For a graph $z=f(x,y)$ and a vertical ray these are the same $x$ and $y$: then $t$ itself is within $\tau$.
///
/// Rounding moves a corner by $\mathbf u\,M$ in each coordinate, $M$ the largest, and so the triangle's height by $\mathbf u\,M$ times one and its slope; the hit's weights, each rounded, as much again. Eight such are allowed for.
#[test]
fn hit_on_triangles_is_within_the_tolerance() {
    let law = Law::new(
        "intersection::hit_on_triangles_is_within_the_tolerance",
        suspects::library,
    );
    let tolerances = || prop::sample::select(vec![1.0, 0.1, 0.01]);
    let [ordinary, difficult] = [
        (wild().prop_map(as_graph), tolerances()).boxed(),
        (hard().prop_map(as_graph), tolerances()).boxed(),
    ];
    law.on_cases(200)
        .holds(ordinary, difficult, |(input, tolerance)| {
            let patch = input.patch::<f64>();
            let surface: &BsplineSurface<Point> = patch.surface();
            let tessellation = tessellate(surface, *tolerance).expect("a usable tolerance");
            let mesh = &tessellation.mesh;
            let hierarchy = to_hierarchy(&tessellation);
            let ray = input.ray();
            let single_ray = Ray::new(single(ray.origin), single(ray.direction));
            let Some((triangle, hit)) = hierarchy.query().nearest_hit(&single_ray) else {
                return Err(Broken {
                    expected: "a hit".to_owned(),
                    got: "none".to_owned(),
                });
            };
            let largest = f64::from(input.t) + 40.0;
            let rounding =
                8.0 * f64::from(f32::EPSILON) / 2.0 * largest * (1.0 + steepness(&patch));
            let bound = tolerance + rounding;
            expect_at_most(
                "a distance in t",
                bound,
                (f64::from(hit.t) - f64::from(input.t)).abs(),
            )?;
            let corners = mesh
                .triangles()
                .nth(triangle as usize)
                .expect("one of its triangles");
            let [v, w] = hit
                .parameters
                .expect("a triangle has weights")
                .map(f64::from);
            let of_corners = corners.map(|vertex| mesh.parameters[vertex as usize]);
            let [u, v] = VectorSpace::combination([1.0 - v - w, v, w], of_corners);
            let point = hit.point.as_dvec3().to_array();
            expect_at_most(
                "a distance",
                bound,
                length(surface.point(u, v).minus(point)),
            )
        });
}

/// **Normals.** The normal of a triangle is wrong by the square root of the tolerance or so; the surface's own normal at the parameters of the hit is wrong by no more than the parameters are. On a dome cut within $10^{-4}$ the first is off by more than half a degree
/// somewhere, the second by less than a twentieth of one everywhere.
#[test]
fn normal_at_the_parameters_is_better_than_that_of_the_triangle() {
    let bend = [-1.0, 1.0, -1.0];
    let points = (0..9).map(|k| {
        [
            (k % 3) as f64 - 1.0,
            (k / 3) as f64 - 1.0,
            bend[k % 3] + bend[k / 3],
        ]
    });
    let dome = patch::<f64>([2, 2], points.collect());
    let tessellation = tessellate(dome.surface(), 1e-4).expect("a usable tolerance");
    let corners: Vec<[u32; 3]> = tessellation.mesh.triangles().collect();
    let hierarchy = to_hierarchy(&tessellation);
    let [mut flat, mut exact] = [0.0_f64; 2];
    for k in 0..400 {
        let [x, y] = [k % 20, k / 20].map(|i| f64::from(i) / 10.5 - 0.9);
        let ray = Ray::new([x, y, 3.0], [0.0, 0.0, -1.0]);
        let truth = dome.intersect(&ray).expect("above the dome").normal;
        let ray = Ray::new(single(ray.origin), single(ray.direction));
        let (triangle, hit) = hierarchy.query().nearest_hit(&ray).expect("above the dome");
        let [v, w] = hit.parameters.expect("weights").map(f64::from);
        let of_corners =
            corners[triangle as usize].map(|vertex| tessellation.mesh.parameters[vertex as usize]);
        let [u, v] = VectorSpace::combination([1.0 - v - w, v, w], of_corners);
        let at = dome
            .surface()
            .normal_vector(u, v)
            .expect("a dome has normals");
        let degrees = |normal: Point| {
            let sine = length(normal.cross(truth)) / length(normal);
            sine.asin().to_degrees()
        };
        flat = flat.max(degrees(hit.normal.as_dvec3().to_array()));
        exact = exact.max(degrees(at));
    }
    println!("{flat} degrees, {exact} degrees");
    assert!(
        flat > 0.5 && exact < 0.05,
        "{flat} degrees, {exact} degrees"
    );
}

/// **What triangles lose.** A ray that passes below the outline of the dome by a tenth of the tolerance meets the dome, and passes over its triangles: most of a hundred such rays are lost. Silhouettes become polygons, and so do the shadows they cast. Ten tolerances below the outline
/// all rays meet both.
#[test]
fn triangles_lose_rays_at_the_silhouette() {
    let bend = [-1.0, 1.0, -1.0];
    let points = (0..9).map(|k| {
        [
            (k % 3) as f64 - 1.0,
            (k / 3) as f64 - 1.0,
            bend[k % 3] + bend[k / 3],
        ]
    });
    let dome = patch::<f64>([2, 2], points.collect());
    let tolerance = 0.01;
    let hierarchy = to_hierarchy(&tessellate(dome.surface(), tolerance).expect("a tolerance"));
    let meet = |below: f64| {
        let mut counts = [0, 0];
        for k in 0..100 {
            let y = f64::from(k) / 60.0 - 0.8;
            let ray = Ray::new([-3.0, y, -y * y - below], [1.0, 0.0, 0.0]);
            counts[0] += u32::from(dome.is_hit_by(&ray));
            let ray = Ray::new(single(ray.origin), single(ray.direction));
            counts[1] += u32::from(hierarchy.query().is_hit(&ray));
        }
        counts
    };
    let near = meet(0.1 * tolerance);
    println!("{near:?}");
    assert!(near[0] == 100 && near[1] <= 80, "{near:?}");
    assert_eq!(meet(10.0 * tolerance), [100, 100]);
}
