//! Built-in scenes, lesson files, and the document that is open: read, refused, saved.

mod built_in_scenes;
mod fuzz;
mod lessons;
mod open_document;
