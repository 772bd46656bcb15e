//! The tests of pinhole-yardstick, in one program.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod contestants;
mod scenes;
