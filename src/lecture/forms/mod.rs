//! Numbers such as `5 sqrt 2` and vectors such as `(5, 0, -7)/sqrt 74`, recognised.

mod number;
mod vector;

pub use number::NumberForm;
pub use vector::VectorForm;
