//! The forms of a report: table, JSON, CSV, and the plot as SVG and as pixels.

mod measure;
mod plot;
mod sample;
mod text;
