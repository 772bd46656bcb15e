//! Accuracy, and the translator.

mod accuracy;
mod translator;
