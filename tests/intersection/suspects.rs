//! Which typical mistake does the code under test behave like?

use crate::common::law::LikelyMistake;

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}

/// Suspects for the slides' quadratic and its nearest root.
pub fn sphere() -> LikelyMistake {
    library()
}

/// Suspects for the roots by projection.
pub fn stable() -> LikelyMistake {
    library()
}
