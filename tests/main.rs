//! The tests of the program, but for those in a real window: one program, since linking one costs as much
//! as many tests.
//!
//! `cargo test --test pinhole app::` runs those of one room.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod app;
mod commands;
mod doors;
mod fault_injection;
mod files;
mod layout;
mod licences;
#[path = "../src/exchange/tests/common/mutants.rs"]
mod mutants;
mod painter;
mod report;
mod support;

use app::harness;
