//! Many spheres: groups and blocks of them that can be seen, drawn near to far, and those that nearer
//! ones hide left out.

pub(crate) mod draw;
pub(crate) mod occlusion;
pub(crate) mod visible;
