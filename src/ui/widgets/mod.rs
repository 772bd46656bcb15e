//! Widgets that several panels share: number fields, marked text, signs, and reasons; and their names
//! for screen readers.

pub mod fault;
pub mod marked_text;
pub mod number;
pub mod sign;
pub mod spoken;
