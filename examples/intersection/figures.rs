//! The figures of the chapter *Intersection*. Each function makes one, from the library's own rays.

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[];
