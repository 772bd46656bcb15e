//! The practice of a student: exercises, classic mistakes, and answers to be graded.

pub mod answer_marks;
pub mod exercises;
pub mod mistakes_view;
pub mod student_answers;

/// Largest seed of a question or a vote. Its field calculates in `f64`, which is exact up to 2^53.
pub const LARGEST_SEED: u64 = 1_000_000_000;

/// Returns the seed after this one; after the largest comes 0.
pub(crate) fn next_seed(seed: u64) -> u64 {
    if seed < LARGEST_SEED { seed + 1 } else { 0 }
}
