//! The figures of the chapter *Subdivision*. Each function makes one, by the library's own schemes.

#[path = "figures/cages.rs"]
pub mod cages;
#[path = "figures/curves.rs"]
mod curves;
#[path = "figures/evaluation.rs"]
mod evaluation;
#[path = "figures/limits.rs"]
mod limits;
#[path = "figures/masks.rs"]
mod masks;
#[path = "figures/meshes.rs"]
mod meshes;
#[path = "figures/pictures.rs"]
pub mod pictures;
#[path = "figures/refinement.rs"]
mod refinement;
#[path = "scheme.rs"]
pub mod scheme;
#[path = "solids.rs"]
mod solids;
#[path = "figures/topology.rs"]
mod topology;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "piggy_bank",
        make: pictures::piggy_bank_becomes_smooth,
    },
    FigureMaker {
        name: "corner_cutting",
        make: curves::corner_cutting,
    },
    FigureMaker {
        name: "curve_masks",
        make: curves::curve_masks,
    },
    FigureMaker {
        name: "polygon_ends",
        make: curves::polygon_ends,
    },
    FigureMaker {
        name: "polygon_convergence",
        make: curves::polygon_convergence,
    },
    FigureMaker {
        name: "half_edges",
        make: topology::half_edges,
    },
    FigureMaker {
        name: "refused_meshes",
        make: topology::refused_meshes,
    },
    FigureMaker {
        name: "doo_sabin_masks",
        make: masks::doo_sabin_masks,
    },
    FigureMaker {
        name: "steps_of_polygons",
        make: topology::steps_of_polygons,
    },
    FigureMaker {
        name: "biquadratic_matrix",
        make: masks::biquadratic_matrix,
    },
    FigureMaker {
        name: "catmull_clark_masks",
        make: masks::catmull_clark_masks,
    },
    FigureMaker {
        name: "triangle_masks",
        make: masks::triangle_masks,
    },
    FigureMaker {
        name: "steps_of_triangles",
        make: topology::steps_of_triangles,
    },
    FigureMaker {
        name: "triangle_counts",
        make: topology::triangle_counts,
    },
    FigureMaker {
        name: "eigenvalues",
        make: limits::eigenvalues,
    },
    FigureMaker {
        name: "doo_sabin_normals",
        make: limits::doo_sabin_normals,
    },
    FigureMaker {
        name: "curvature_growth",
        make: limits::curvature_growth,
    },
    FigureMaker {
        name: "curvature_by_level",
        make: limits::curvature_by_level,
    },
    FigureMaker {
        name: "mesh_convergence",
        make: limits::mesh_convergence,
    },
    FigureMaker {
        name: "four_limits",
        make: pictures::four_limits,
    },
    FigureMaker {
        name: "level_by_level",
        make: pictures::level_by_level,
    },
    FigureMaker {
        name: "corners",
        make: pictures::sharp_and_smooth_corners,
    },
    FigureMaker {
        name: "patch_of_points",
        make: refinement::patch_of_points,
    },
    FigureMaker {
        name: "nested_patches",
        make: evaluation::nested_patches,
    },
    FigureMaker {
        name: "shrinking_modes",
        make: evaluation::shrinking_modes,
    },
    FigureMaker {
        name: "isoparametric_lines",
        make: evaluation::isoparametric_lines,
    },
];
