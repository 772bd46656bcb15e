//! Scene files, lesson files, and the CSV files beside them: read, refused, saved.

mod bad_scenes;
mod code;
mod csv;
mod good_scenes;
mod lessons;
mod molecules;
mod open_document;
mod round_trip;
mod saving;
