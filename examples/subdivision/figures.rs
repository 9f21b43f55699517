//! The figures of the chapter *Subdivision*. Each function makes one, by the library's own schemes.

#[path = "figures/curves.rs"]
mod curves;
#[path = "figures/limits.rs"]
mod limits;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
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
];
