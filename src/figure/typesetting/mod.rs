//! Text on the screen and in figures: fonts and colours, formulas, the derivation, labels.

pub mod derivation;
pub mod labels;
pub mod notation;
pub mod theme;
