//! Rays in parametric form.

use glam::DVec3;

use crate::scale;

/// `origin + t * direction`. The direction is not normalized: `t` is in units of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point at `t = 0`, the lecture's p.
    pub origin: DVec3,
    /// The lecture's **d**.
    pub direction: DVec3,
}

impl Ray {
    /// `origin + t * direction`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// `t * |direction|`: how far from the origin, in world units, `t` is.
    pub fn distance_along(&self, t: f64) -> f64 {
        t * scale::length(self.direction)
    }
}
