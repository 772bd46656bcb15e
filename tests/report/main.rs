//! The forms of a report: table, JSON, CSV, and the plot as SVG and as pixels.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod measure;
mod plot;
mod sample;
mod text;
