//! A ray in two dimensions, and as a plot.

mod lines;
mod plot;
