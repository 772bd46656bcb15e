//! The viewport in pixels, as computer vision has it: K, the matrix of focal lengths and principal
//! point.

use crate::camera::image::ImageSize;
use crate::camera::viewport::Viewport;

/// Focal lengths and principal point in pixels; x to the right, y *down*, from the image's upper left
/// *corner*, so that pixel (row i, column j) has its centre at `(j + 0.5, i + 0.5)`.
///
/// ```text
///     fx  0 cx        x = fx X / Z + cx
/// K =  0 fy cy        y = fy Y / Z + cy       X = q.u, Y = -q.v, Z = -q.w
///      0  0  1
/// ```
///
/// (Hartley, Zisserman, *Multiple View Geometry*, 2nd ed., section 6.1, with y down.) Where pixel
/// centres are whole numbers, as in OpenCV, cx and cy are a half less.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// `distance W / width`
    pub fx: f64,
    /// `distance H / height`; the same as fx where pixels are square.
    pub fy: f64,
    /// Column at which the view direction meets the image: W / 2 for every camera here.
    pub cx: f64,
    /// H / 2, likewise.
    pub cy: f64,
}

impl Intrinsics {
    /// Computes those of a viewport that is cut into so many pixels.
    pub fn from_viewport(viewport: &Viewport, image: ImageSize) -> Intrinsics {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        Intrinsics {
            fx: viewport.distance * (w / viewport.width),
            fy: viewport.distance * (h / viewport.height),
            cx: 0.5 * w,
            cy: 0.5 * h,
        }
    }

    /// The viewport at `distance` with these focal lengths; the principal point is not regarded.
    pub fn viewport(&self, image: ImageSize, distance: f64) -> Viewport {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        Viewport { width: distance * w / self.fx, height: distance * h / self.fy, distance }
    }

    /// Returns how far right and down of the image's middle the principal point is, in pixels.
    pub fn off_centre(&self, image: ImageSize) -> [f64; 2] {
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        [self.cx - 0.5 * w, self.cy - 0.5 * h]
    }
}
