//! Objects that are not drawn by rows: spheres that are near or large, and planes. An object's
//! quadratic is a polynomial in rows and columns.

pub(crate) mod blend;
pub(crate) mod conic;
pub(crate) mod frame_rays;
pub(crate) mod object_kernel;
pub(crate) mod per_pixel;
