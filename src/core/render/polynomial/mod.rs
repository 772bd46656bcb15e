//! What is not drawn by rows: spheres that are near or large, planes, and every object of a frame of
//! `f64`. An object's quadratic is a polynomial in rows and columns.

pub(crate) mod conic;
pub(crate) mod exact_conic;
pub(crate) mod frame_rays;
pub(crate) mod kernel;
pub(crate) mod object_kernel;
pub(crate) mod per_pixel;
