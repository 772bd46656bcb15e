//! Scene files, the CSV files beside them, and code: read, refused, saved.

mod bad_scenes;
mod code;
mod csv;
mod good_scenes;
mod round_trip;
mod saving;
