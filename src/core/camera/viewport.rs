//! The image plane. The viewport is the rectangle in front of the eye through which the view rays pass;
//! the image is the grid of pixels into which it is divided. Computer vision describes both by K, the
//! matrix of focal lengths and principal point.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::exact::scale::shortest;

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

/// The error of a viewport's width, height or distance that is not a positive, finite number.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("viewport {field} is {}: it must be finite and greater than 0", shortest(*.value))]
#[non_exhaustive]
pub struct ViewportError {
    /// `width`, `height` or `distance`.
    pub field: &'static str,
    /// The invalid measure.
    pub value: f64,
}

impl Viewport {
    /// The canonical camera's viewport: 1 x 1 at distance 1.
    pub const CANONICAL: Viewport = Viewport { width: 1.0, height: 1.0, distance: 1.0 };

    /// Checks that width, height and distance are positive and finite.
    ///
    /// # Errors
    /// Returns an error for the first measure that is not positive and finite.
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

    /// Returns the horizontal field of view in radians: [`fov_of_extent`] of the width.
    pub fn horizontal_fov(&self) -> f64 {
        fov_of_extent(self.width, self.distance)
    }

    /// Returns the vertical field of view in radians: [`fov_of_extent`] of the height.
    pub fn vertical_fov(&self) -> f64 {
        fov_of_extent(self.height, self.distance)
    }

    /// Returns the viewport with this vertical field of view (radians), the same distance, and the same
    /// ratio of width to height. If there is no such ratio (the height is 0), the width is kept.
    pub fn with_vertical_fov(&self, fov: f64) -> Viewport {
        let height = extent_of_fov(fov, self.distance);
        Viewport { width: in_proportion(self.width, self.height, height), height, ..*self }
    }

    /// Returns the viewport with this horizontal field of view (radians), the same distance, and the
    /// same ratio of width to height. If there is no such ratio (the width is 0), the height is kept.
    pub fn with_horizontal_fov(&self, fov: f64) -> Viewport {
        let width = extent_of_fov(fov, self.distance);
        Viewport { width, height: in_proportion(self.height, self.width, width), ..*self }
    }
}

/// Returns `x * new / old`, or `x` if the result would not be a positive, finite number.
fn in_proportion(x: f64, old: f64, new: f64) -> f64 {
    // x / old is computed first, so that a square viewport stays exactly square.
    let ratio = x / old;
    let scaled = if ratio.is_normal() { ratio * new } else { x * (new / old) };
    if scaled.is_finite() && scaled > 0.0 { scaled } else { x }
}

/// Returns `2 atan(extent / (2 distance))`: the angle, in radians, that a width or height of the
/// viewport subtends at the eye. If both arguments are positive, the angle lies in `(0, pi)`, apart from
/// rounding.
pub fn fov_of_extent(extent: f64, distance: f64) -> f64 {
    2.0 * (0.5 * extent).atan2(distance)
}

/// Returns `2 distance tan(fov / 2)`: the width or height of a viewport at `distance` that subtends the
/// angle `fov` at the eye, in radians, in `(0, pi)`.
///
/// For any other `fov` there is no viewport. The result is then 0, which [`Viewport::check`] rejects.
pub fn extent_of_fov(fov: f64, distance: f64) -> f64 {
    let is_angle = fov > 0.0 && fov <= std::f64::consts::PI;
    if is_angle { 2.0 * (distance * (0.5 * fov).tan()) } else { 0.0 }
}

/// The image's width W and height H in pixels, each from 1 to [`ImageSize::MAX`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ImageSize {
    width: u32,
    height: u32,
}

/// A pixel, given by its row (0 at the top) and its column (0 at the left).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Pixel {
    /// Row, from 0 at the top to H - 1.
    pub row: u32,
    /// Column, from 0 at the left to W - 1.
    pub column: u32,
}

/// The error of an image's width or height that is not between 1 and [`ImageSize::MAX`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("image {field} is {value}: it must be 1 to {} pixels", ImageSize::MAX)]
#[non_exhaustive]
pub struct ImageError {
    /// `width` or `height`.
    pub field: &'static str,
    /// The invalid measure.
    pub value: u32,
}

impl ImageSize {
    /// The largest width and height of an image.
    pub const MAX: u32 = 16_384;

    /// Creates the size of an image of `width` x `height` pixels.
    ///
    /// # Errors
    /// Returns an error if the width or height is 0 or above [`ImageSize::MAX`].
    pub const fn new(width: u32, height: u32) -> Result<ImageSize, ImageError> {
        ImageSize::within(ImageSize::MAX, width, height)
    }

    /// Creates the size of an image of which at most [`ImageSize::MAX`] rows and columns are ever
    /// traced. Its width and height may be up to four times [`ImageSize::MAX`]; the error margins in
    /// `render/outline` allow for that.
    #[doc(hidden)]
    pub const fn partly_traced(width: u32, height: u32) -> Result<ImageSize, ImageError> {
        ImageSize::within(4 * ImageSize::MAX, width, height)
    }

    const fn within(most: u32, width: u32, height: u32) -> Result<ImageSize, ImageError> {
        if width == 0 || width > most {
            return Err(ImageError { field: "width", value: width });
        }
        if height == 0 || height > most {
            return Err(ImageError { field: "height", value: height });
        }
        Ok(ImageSize { width, height })
    }

    /// Returns the width W, in pixels.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Returns the height H, in pixels.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Returns the aspect ratio W / H.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// Returns the number of pixels: W H.
    pub fn pixel_count(self) -> u64 {
        u64::from(self.width()) * u64::from(self.height())
    }

    /// Returns whether the pixel lies in the image.
    pub fn contains(self, pixel: Pixel) -> bool {
        pixel.row < self.height && pixel.column < self.width
    }
}

/// Focal lengths and principal point in pixels. x points to the right and y *down*, from the image's
/// upper left *corner*, so that pixel (row i, column j) has its centre at `(j + 0.5, i + 0.5)`.
///
/// ```text
///     fx  0 cx        x = fx X / Z + cx
/// K =  0 fy cy        y = fy Y / Z + cy       X = q.u, Y = -q.v, Z = -q.w
///      0  0  1
/// ```
///
/// q is the vector from the eye to the point that is projected. (Hartley, Zisserman, *Multiple View
/// Geometry*, 2nd ed., section 6.1, with y down.) If pixel centres are at whole numbers, as in OpenCV,
/// cx and cy are smaller by 0.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// Horizontal focal length in pixels, `distance W / width`.
    pub fx: f64,
    /// Vertical focal length in pixels, `distance H / height`; equal to fx if pixels are square.
    pub fy: f64,
    /// Column at which the view direction meets the image: W / 2 for every [`Camera`](crate::Camera).
    pub cx: f64,
    /// Row at which the view direction meets the image: H / 2 for every [`Camera`](crate::Camera).
    pub cy: f64,
}

impl Intrinsics {
    /// Computes the intrinsics of a viewport that is divided into an image of this size.
    pub fn from_viewport(viewport: &Viewport, image: ImageSize) -> Intrinsics {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        Intrinsics {
            fx: viewport.distance * (w / viewport.width),
            fy: viewport.distance * (h / viewport.height),
            cx: 0.5 * w,
            cy: 0.5 * h,
        }
    }

    /// Returns the viewport at `distance` with these focal lengths; the principal point is ignored.
    pub fn viewport(&self, image: ImageSize, distance: f64) -> Viewport {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        Viewport { width: distance * w / self.fx, height: distance * h / self.fy, distance }
    }

    /// Returns how far the principal point lies to the right of the image's middle and below it, in
    /// pixels.
    pub fn off_centre(&self, image: ImageSize) -> [f64; 2] {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        [self.cx - 0.5 * w, self.cy - 0.5 * h]
    }
}
