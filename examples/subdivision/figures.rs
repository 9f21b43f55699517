//! The figures of the chapter *Subdivision*. Each function makes one, by the library's own schemes.

use facette_figure::FigureMaker;

/// All figures of the chapter, in the order of the text.
pub const FIGURES: &[FigureMaker] = &[];
