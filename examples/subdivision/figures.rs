//! The figures of the chapter *Subdivision*. Each function makes one, by the library's own schemes.

#[path = "figures/curves.rs"]
mod curves;

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
];
