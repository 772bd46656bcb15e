//! The tools: the translator to other programs, accuracy, and what a frame left out.

pub mod accuracy;
pub mod measuring;
pub mod translator;
