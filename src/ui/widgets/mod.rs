//! Widgets that several panels share: number fields, marked text, and signs.

pub mod marked_text;
pub mod number;
pub mod sign;
