//! The way from the world to the dots of a picture, and back.
//!
//! - `screen`: projection and clipping; `flat`: its inverse, from a dot to a point of a plane.
//! - `layers`: areas filled dot by dot (planes, the picture on the viewport), and occlusion.
//! - `sketch`: lines and arrows of the world as marks, visible or hidden; `labels`: label placement.

pub(super) mod flat;
pub(super) mod labels;
pub(super) mod layers;
pub(super) mod screen;
pub(super) mod sketch;
