//! Spheres drawn row by row: where a row begins and ends, and `t` between, in `f32`.

pub(crate) mod draw_row;
pub(crate) mod small_spheres;
pub(crate) mod span;
pub(crate) mod vector_bounds;
