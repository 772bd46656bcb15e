//! Tests of reading, rejecting and writing scene files, tables, code and other programs' cameras.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]
#![allow(clippy::print_stdout, reason = "which programs were there, and what agrees, is told")]

mod common;
mod files;
mod programs;
