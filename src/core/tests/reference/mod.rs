//! Tests of the reference itself: known answers, the properties of its families, and changes that must
//! not change an answer.

mod cameras;
mod exact_answers;
mod families;
mod invariances;
