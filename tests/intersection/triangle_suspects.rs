//! Which typical mistake does the reader's test of a triangle behave like?

use crate::common::law::LikelyMistake;
use crate::suspects;

/// Suspects for the tests of a triangle.
pub fn triangle() -> LikelyMistake {
    suspects::library()
}
