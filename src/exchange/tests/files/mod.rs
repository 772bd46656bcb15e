//! Tests of reading, rejecting and saving scene files, CSV files, pictures and code.

mod bad_scenes;
mod code;
mod csv;
mod fuzz;
mod good_scenes;
mod images;
mod limits;
mod link;
mod round_trip;
mod saving;
