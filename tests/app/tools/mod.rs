//! Accuracy, the counts of a frame, and the translator.

mod accuracy;
mod frame;
mod translator;
