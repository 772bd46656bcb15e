//! The plot of f(p + t d), where f(x) = 0 is an object's surface and p + t d the selected ray.

pub mod curves;
pub mod ui;
