//! The error map and the comparison of methods by their errors and run times.

pub mod comparison;
pub mod ui;
