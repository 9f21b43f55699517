//! The variants of the chapter *coons*: bilinear and bicubic points, grids, edges, derivatives, and the curves below them.

use std::hint::black_box;
use std::rc::Rc;

use facette::coons::{
    Boundary, CoonsPatch, HermiteBoundary, bicubic_point, bilinear_partials, bilinear_point,
};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use glam::{DVec3, Vec3A};

use crate::coons_exact::{exact_bicubic, exact_cubics, exact_partials, exact_points};
use crate::coons_inputs::{InputSet, Scene, hard, typical};
use crate::harness::{Comparison, Effort, ExactPoint};
use crate::variants;

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
}

/// The exact values for inputs rounded to `f64` and to `f32`.
struct Exact {
    f64: Rc<[ExactPoint]>,
    f32: Rc<[ExactPoint]>,
}

impl Exact {
    fn new(f64: Vec<ExactPoint>, f32: Vec<ExactPoint>) -> Self {
        Self {
            f64: f64.into(),
            f32: f32.into(),
        }
    }
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut dyn FnMut(Comparison<'_>)) {
    for set in [typical(effort.points), hard(effort.points)] {
        let scenes = Scenes::new(&set);
        visitor(points(&scenes));
        visitor(edges(&Scenes::new(&set.on_edges())));
        visitor(bicubic(&scenes));
        visitor(partials(&scenes));
        visitor(cubics(&scenes));
        visitor(grids(&Scenes::new(&set.on_a_grid())));
    }
}
