//! Widgets that several panels share: number fields, marked text, signs, and reasons; their names for
//! screen readers, and the actions that they ask for.

pub mod asking;
pub mod fault;
pub mod marked_text;
pub mod number;
pub mod sign;
pub mod spoken;
