//! The viewport: the rectangle in front of the eye through which the view rays pass.

use std::fmt;

use crate::exact::decimal::shortest;

/// Width and height of the viewport and its distance from the eye, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Extent along u.
    pub width: f64,
    /// Extent along v.
    pub height: f64,
    /// Distance from the eye to the viewport, along -w. The lecture's scalar d.
    pub distance: f64,
}

/// A viewport measure that is not a positive, finite number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ViewportError {
    /// `width`, `height` or `distance`.
    pub field: &'static str,
    /// The value.
    pub value: f64,
}

impl fmt::Display for ViewportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ViewportError { field, value } = self;
        write!(f, "viewport {field} is {}: it must be finite and greater than 0", shortest(*value))
    }
}

impl std::error::Error for ViewportError {}

impl Viewport {
    /// The canonical camera's: 1 x 1 at distance 1.
    pub const CANONICAL: Viewport = Viewport { width: 1.0, height: 1.0, distance: 1.0 };

    /// Checks that width, height and distance are positive and finite.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn check(&self) -> Result<(), ViewportError> {
        for (field, value) in
            [("width", self.width), ("height", self.height), ("distance", self.distance)]
        {
            if !(value.is_finite() && value > 0.0) {
                return Err(ViewportError { field, value });
            }
        }
        Ok(())
    }

    /// The horizontal field of view in radians: [`fov_of_extent`] of the width.
    pub fn horizontal_fov(&self) -> f64 {
        fov_of_extent(self.width, self.distance)
    }

    /// The vertical field of view in radians: [`fov_of_extent`] of the height.
    pub fn vertical_fov(&self) -> f64 {
        fov_of_extent(self.height, self.distance)
    }

    /// The viewport with this vertical field of view (radians), the same distance, and the same
    /// ratio of width to height. Where there is no such ratio (a height of 0) the width stays.
    pub fn with_vertical_fov(&self, fov: f64) -> Viewport {
        let height = extent_of_fov(fov, self.distance);
        Viewport { width: in_proportion(self.width, self.height, height), height, ..*self }
    }

    /// The viewport with this horizontal field of view (radians), the same distance, and the same
    /// ratio of width to height. Where there is no such ratio (a width of 0) the height stays.
    pub fn with_horizontal_fov(&self, fov: f64) -> Viewport {
        let width = extent_of_fov(fov, self.distance);
        Viewport { width, height: in_proportion(self.height, self.width, width), ..*self }
    }
}

/// `x * new / old`; `x` where that is no positive, finite number.
fn in_proportion(x: f64, old: f64, new: f64) -> f64 {
    // x / old first: a square stays a square to the bit.
    let ratio = x / old;
    let scaled = if ratio.is_normal() { ratio * new } else { x * (new / old) };
    if scaled.is_finite() && scaled > 0.0 { scaled } else { x }
}

/// `2 atan(extent / (2 distance))`: the angle, in radians, under which the eye sees a width or
/// height of the viewport. In `(0, pi)` but for rounding where both are positive.
pub fn fov_of_extent(extent: f64, distance: f64) -> f64 {
    2.0 * (0.5 * extent).atan2(distance)
}

/// `2 distance tan(fov / 2)`: the width or height of a viewport at `distance` that the eye sees
/// under the angle `fov`, in radians, in `(0, pi)`.
///
/// For any other `fov` no viewport is right, and the result is 0, which [`Viewport::check`] refuses.
pub fn extent_of_fov(fov: f64, distance: f64) -> f64 {
    let is_angle = fov > 0.0 && fov <= std::f64::consts::PI;
    if is_angle { 2.0 * (distance * (0.5 * fov).tan()) } else { 0.0 }
}
