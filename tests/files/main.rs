//! Scene files, lesson files, and the CSV files beside them: read, refused, saved.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod bad_scenes;
mod code;
mod csv;
mod good_scenes;
mod lessons;
mod open_document;
mod round_trip;
mod saving;
