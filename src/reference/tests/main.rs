//! The tests of pinhole-reference, in one program.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod cameras;
mod exact_answers;
mod families;
mod invariances;
