//! Builds a small book, whole and broken.

mod refusals;
mod sample;
mod several_pages;
mod whole_book;
