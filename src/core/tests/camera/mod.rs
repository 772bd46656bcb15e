//! The basis, (u, v) and rows and columns, and what two cameras differ in.

mod basis;
mod basis_steps;
mod difference;
mod projection;
