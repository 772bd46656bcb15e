//! The reference itself: known answers, what its families claim, and what must not change an answer.

mod cameras;
mod exact_answers;
mod families;
mod invariances;
