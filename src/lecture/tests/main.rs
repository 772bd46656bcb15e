//! Tests of the lecture's calculations, against the lecture's own numbers, the exact reference, and
//! students' programs.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../core/tests/common/mod.rs"]
mod common;
mod derivation;
mod exercises;
mod forms;
mod grading;
mod lines;
mod mistakes;

use common::seed::config;
