//! The figures of the chapter *Cameras*. Each function makes one; what is drawn in space is projected by the library's own cameras.

#[path = "figures/numerics.rs"]
mod numerics;
#[path = "figures/pixels.rs"]
mod pixels;
#[path = "figures/projections.rs"]
mod projections;
#[path = "figures/space.rs"]
mod space;
#[path = "figures/stage.rs"]
mod stage;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "frame_and_rectangle",
        make: space::frame_and_rectangle,
    },
    FigureMaker {
        name: "two_projections",
        make: space::two_projections,
    },
    FigureMaker {
        name: "pixel_grid",
        make: pixels::pixel_grid,
    },
    FigureMaker {
        name: "field_of_view",
        make: projections::field_of_view,
    },
    FigureMaker {
        name: "vanishing_points",
        make: projections::vanishing_points,
    },
    FigureMaker {
        name: "shifted_rectangle",
        make: projections::shifted_rectangle,
    },
    FigureMaker {
        name: "up_near_the_view",
        make: numerics::up_near_the_view,
    },
    FigureMaker {
        name: "far_eye",
        make: numerics::far_eye,
    },
    FigureMaker {
        name: "drift",
        make: numerics::drift,
    },
    FigureMaker {
        name: "speed_against_error",
        make: numerics::speed_against_error,
    },
];
