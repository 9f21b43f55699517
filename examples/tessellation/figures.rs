//! The figures of the chapter *Tessellation*. Each function makes one, from the library's own triangles.

#[path = "figures/chords.rs"]
mod chords;
#[path = "figures/meshes.rs"]
pub mod meshes;

use std::collections::HashSet;

use facette::mesh::Mesh;
use facette_figure::FigureMaker;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, Triangles};
use glam::DVec3;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "adaptive_and_uniform",
        make: meshes::adaptive_and_uniform,
    },
    FigureMaker {
        name: "chord_error",
        make: chords::chord_error,
    },
    FigureMaker {
        name: "crack",
        make: meshes::crack,
    },
    FigureMaker {
        name: "triangles_in_the_parameter_plane",
        make: meshes::triangles_in_the_parameter_plane,
    },
    FigureMaker {
        name: "error_against_triangles",
        make: chords::error_against_triangles,
    },
];

/// A scene with a mesh and the edges of its triangles.
pub fn wires(scene: Scene, mesh: &Mesh<DVec3>, colour: Colour, radius: f64) -> Scene {
    let mut seen = HashSet::new();
    let mut scene = scene.surface(mesh, Material::matte(colour));
    for [a, b, c] in mesh.triangles() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if seen.insert([from.min(to), from.max(to)]) {
                let ends = [from, to].map(|vertex| mesh.positions[vertex as usize]);
                scene = scene.surface(Triangles::tube(&ends, radius), Material::matte(Colour::Ink));
            }
        }
    }
    scene
}
