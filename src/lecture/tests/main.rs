//! Tests of everything that is taught, against the lecture's own numbers, the reference, and
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
