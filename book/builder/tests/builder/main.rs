//! Builds a small book, whole and broken.

mod refusals;
mod sample;
mod whole_book;
