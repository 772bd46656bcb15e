//! The ray workspace: the plot of f(p + t d), where f(x) = 0 is an object's surface and p + t d the selected
//! ray, and the lab of lines, which intersects two lines in the plane.

pub mod lines;
pub mod plot;
