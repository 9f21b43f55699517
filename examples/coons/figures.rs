//! The figures of the chapter *Coons patches*. Each function makes one, from the library's own surfaces.

#[path = "figures/bicubic.rs"]
mod bicubic;
#[path = "figures/bilinear.rs"]
mod bilinear;
#[path = "figures/shapes.rs"]
pub mod shapes;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "four_curves",
        make: bilinear::four_curves,
    },
    FigureMaker {
        name: "ruled_surfaces",
        make: bilinear::ruled_surfaces,
    },
    FigureMaker {
        name: "gallery",
        make: bilinear::gallery,
    },
    FigureMaker {
        name: "outside_the_hull",
        make: bilinear::outside_the_hull,
    },
    FigureMaker {
        name: "crease_and_cure",
        make: bicubic::crease_and_cure,
    },
    FigureMaker {
        name: "hermite_basis",
        make: bicubic::hermite_basis,
    },
    FigureMaker {
        name: "twists",
        make: bicubic::twists,
    },
    FigureMaker {
        name: "missed_edges",
        make: bilinear::missed_edges,
    },
    FigureMaker {
        name: "speed_against_error",
        make: bilinear::speed_against_error,
    },
];
