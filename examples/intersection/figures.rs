//! The figures of the chapter *Intersection*. Each function makes one, from the library's own rays.

#[path = "figures/boxes.rs"]
mod boxes;
#[path = "figures/facets.rs"]
mod facets;
#[path = "first_programs.rs"]
pub mod first_programs;
#[path = "figures/hierarchy.rs"]
mod hierarchy;
#[path = "figures/hit_points.rs"]
mod hit_points;
#[path = "figures/pictures.rs"]
pub mod pictures;
#[path = "figures/spheres.rs"]
mod spheres;
#[path = "figures/surfaces.rs"]
mod surfaces;
#[path = "figures/triangles.rs"]
mod triangles;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "nearest_of_many",
        make: spheres::nearest_of_many,
    },
    FigureMaker {
        name: "quadratic",
        make: spheres::quadratic,
    },
    FigureMaker {
        name: "lost_digits",
        make: spheres::lost_digits,
    },
    FigureMaker {
        name: "slabs",
        make: boxes::slabs,
    },
    FigureMaker {
        name: "half_planes",
        make: triangles::half_planes,
    },
    FigureMaker {
        name: "barycentric_areas",
        make: triangles::barycentric_areas,
    },
    FigureMaker {
        name: "leaks",
        make: facets::leaks,
    },
    FigureMaker {
        name: "shear",
        make: triangles::shear,
    },
    FigureMaker {
        name: "fan",
        make: triangles::fan,
    },
    FigureMaker {
        name: "bilinear",
        make: facets::bilinear,
    },
    FigureMaker {
        name: "acne_and_leaks",
        make: hit_points::acne_and_leaks,
    },
    FigureMaker {
        name: "error_box",
        make: hit_points::error_box,
    },
    FigureMaker {
        name: "offset_against_scale",
        make: hit_points::offset_against_scale,
    },
    FigureMaker {
        name: "silhouette",
        make: surfaces::silhouette,
    },
    FigureMaker {
        name: "as_the_ray_sees_it",
        make: surfaces::as_the_ray_sees_it,
    },
    FigureMaker {
        name: "direct_against_triangles",
        make: surfaces::error_against_triangles,
    },
    FigureMaker {
        name: "first_programs",
        make: pictures::first_programs,
    },
    FigureMaker {
        name: "normals",
        make: pictures::normals,
    },
    FigureMaker {
        name: "boxes_level_by_level",
        make: hierarchy::boxes_level_by_level,
    },
    FigureMaker {
        name: "visits_of_pixels",
        make: hierarchy::visits_of_pixels,
    },
    FigureMaker {
        name: "visits_against_n",
        make: hierarchy::visits_against_n,
    },
];
