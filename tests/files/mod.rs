<<<<<<< main:tests/files/main.rs
//! Built-in scenes, lesson files, and the document that is open: read, refused, saved.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]
=======
//! Scene files, lesson files, and the CSV files beside them: read, refused, saved.
>>>>>>> jt-testsb:tests/files/mod.rs

mod built_in_scenes;
mod lessons;
mod open_document;
