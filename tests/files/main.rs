//! Built-in scenes, lesson files, and the document that is open: read, refused, saved.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod built_in_scenes;
mod lessons;
mod open_document;
