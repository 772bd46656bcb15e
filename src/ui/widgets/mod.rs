//! Parts that several panels are made of: number fields, notation, marked text, colours.

pub mod marked_text;
pub mod number;
pub mod sign;
