//! Text on the screen and in figures: fonts and theme, formulas, the derivation, labels.

pub mod derivation;
pub mod fonts;
pub mod formula;
pub mod label_layout;
pub mod label_text;
pub mod notation;
pub mod theme;
