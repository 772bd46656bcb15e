//! Tests of cameras: the basis, conversions between pixels and (u, v), projection, and the differences
//! between two cameras.

mod basis;
mod basis_steps;
mod difference;
mod projection;
