//! The tests of pinhole-core, in one program.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells its seed and its levels"
)]

mod common;
mod support;

mod along;
mod camera;
mod certificates;
mod counts;
mod crowds;
mod crowds_alike;
mod errors;
mod everyday;
mod exact_answers;
mod invalid_input;
mod ladder;
mod levels;
mod methods;
mod painted;
mod picture;
mod readme;
mod reference;
mod roots;
mod shading;
mod steering;
mod steps;
mod yardstick;
