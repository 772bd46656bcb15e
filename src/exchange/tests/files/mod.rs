//! Scene files, the CSV files beside them, pictures, and code: read, refused, saved.

mod bad_scenes;
mod code;
mod csv;
mod fuzz;
mod good_scenes;
mod images;
mod limits;
mod round_trip;
mod saving;
