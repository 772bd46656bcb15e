//! The tools: the translator to other programs, and accuracy.

pub mod accuracy;
pub mod translator;
