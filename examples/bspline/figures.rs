//! The figures of the chapter *B-spline surfaces*. Each function makes one, from the library's own curves and surfaces.

#[path = "figures/basis.rs"]
mod basis;
#[path = "figures/continuity.rs"]
mod continuity;
#[path = "figures/curves.rs"]
mod curves;
#[path = "figures/periodic.rs"]
mod periodic;
#[path = "figures/rational.rs"]
mod rational;
#[path = "figures/shapes.rs"]
pub mod shapes;
#[path = "figures/spans.rs"]
mod spans;
#[path = "figures/speed.rs"]
mod speed;
#[path = "figures/trimmed.rs"]
mod trimmed;
#[path = "figures/variation.rs"]
mod variation;

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        name: "control_net",
        make: spans::control_net,
    },
    FigureMaker {
        name: "basis_u",
        make: basis::basis_u,
    },
    FigureMaker {
        name: "basis_v",
        make: basis::basis_v,
    },
    FigureMaker {
        name: "basis_domain",
        make: basis::basis_domain,
    },
    FigureMaker {
        name: "surface_basis",
        make: basis::surface_basis,
    },
    FigureMaker {
        name: "coloured_spans",
        make: spans::coloured_spans,
    },
    FigureMaker {
        name: "continuity",
        make: continuity::continuity,
    },
    FigureMaker {
        name: "repeated_knots",
        make: spans::repeated_knots,
    },
    FigureMaker {
        name: "local_control",
        make: spans::local_control,
    },
    FigureMaker {
        name: "two_islands",
        make: variation::two_islands,
    },
    FigureMaker {
        name: "isoparametric",
        make: curves::isoparametric,
    },
    FigureMaker {
        name: "de_boor",
        make: curves::de_boor,
    },
    FigureMaker {
        name: "knot_insertion",
        make: curves::knot_insertion,
    },
    FigureMaker {
        name: "degree_elevation",
        make: curves::degree_elevation,
    },
    FigureMaker {
        name: "closed_surfaces",
        make: periodic::closed_surfaces,
    },
    FigureMaker {
        name: "repeated_points",
        make: periodic::repeated_points,
    },
    FigureMaker {
        name: "carried_normals",
        make: periodic::carried_normals,
    },
    FigureMaker {
        name: "weights",
        make: rational::weights,
    },
    FigureMaker {
        name: "rational_circle",
        make: rational::rational_circle,
    },
    FigureMaker {
        name: "rational_sphere",
        make: rational::rational_sphere,
    },
    FigureMaker {
        name: "trimmed_corner",
        make: trimmed::trimmed_corner,
    },
    FigureMaker {
        name: "speed_against_error",
        make: speed::speed_against_error,
    },
];
