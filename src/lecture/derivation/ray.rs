//! The derivation of a view ray: from a pixel to (u, v), from there to the direction.

use pinhole_core::arithmetic::length;
use pinhole_core::{DVec2, DVec3, Pixel, Ray, RayError, ResolvedCamera};

/// A view ray with every value on the way to it:
///
/// ```text
/// u = width ((column + 0.5) / W - 0.5)     v = height (0.5 - (row + 0.5) / H)
/// p = eye     d = u U + v V - distance W
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., sections 4.3.1 and 4.3.2.)
/// The direction and its three parts are computed from the basis before rounding and rounded once,
/// so the parts' sum may differ from the direction in the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RayDerivation {
    /// The pixel that the ray goes through and its shares of the image; `None` of a ray that is
    /// given by (u, v).
    pub shares: Option<PixelShares>,
    /// The position where the ray passes through the viewport, in world units, as
    /// [`ResolvedCamera::uv_of_pixel`] says.
    pub uv: DVec2,
    /// `u U`, in world units.
    pub along_u: DVec3,
    /// `v V`, in world units.
    pub along_v: DVec3,
    /// `-distance W`, in world units.
    pub along_w: DVec3,
    /// d, the sum of the three: that of
    /// [`ExactRay::rounded`](pinhole_core::ExactRay::rounded).
    pub direction: DVec3,
    /// `|d|`: how far in the world one unit of t is.
    pub length: f64,
    /// p, the eye.
    pub origin: DVec3,
}

/// A pixel's centre in the image, as shares of its width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PixelShares {
    /// The pixel.
    pub pixel: Pixel,
    /// `(column + 0.5) / W`: 0 at the image's left edge, 1 at the right one.
    pub across: f64,
    /// `(row + 0.5) / H`: 0 at the image's upper edge, 1 at the lower one.
    pub down: f64,
    /// `(column + 0.5) / W - 0.5`: u as a share of the viewport's width.
    pub right: f64,
    /// `0.5 - (row + 0.5) / H`: v as a share of the viewport's height.
    pub up: f64,
}

impl RayDerivation {
    /// The view ray through a pixel's centre.
    pub fn of_pixel(camera: &ResolvedCamera, pixel: Pixel) -> RayDerivation {
        let direction = camera.exact_ray(pixel).rounded();
        let parts = camera.direction_terms_of_pixel(pixel);
        let shares = Some(PixelShares::new(camera, pixel));
        RayDerivation::new(parts, shares, camera.uv_of_pixel(pixel), direction)
    }

    /// The view ray through a (u, v).
    ///
    /// # Errors
    /// Returns an error if u or v is not finite.
    pub fn of_uv(camera: &ResolvedCamera, uv: DVec2) -> Result<RayDerivation, RayError> {
        let direction = camera.exact_ray_at(uv)?.rounded();
        Ok(RayDerivation::new(camera.direction_terms_at(uv), None, uv, direction))
    }

    fn new(
        [along_u, along_v, along_w]: [DVec3; 3],
        shares: Option<PixelShares>,
        uv: DVec2,
        ray: Ray,
    ) -> RayDerivation {
        RayDerivation {
            shares,
            uv,
            along_u,
            along_v,
            along_w,
            direction: ray.direction,
            length: length(ray.direction),
            origin: ray.origin,
        }
    }

    /// The ray: p + t d.
    pub fn ray(&self) -> Ray {
        Ray { origin: self.origin, direction: self.direction }
    }
}

impl PixelShares {
    /// Each rounded once: numerators and denominators are whole.
    fn new(camera: &ResolvedCamera, pixel: Pixel) -> PixelShares {
        let image = camera.image();
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        let (row, column) = (f64::from(pixel.row), f64::from(pixel.column));
        PixelShares {
            pixel,
            across: (2.0 * column + 1.0) / (2.0 * w),
            down: (2.0 * row + 1.0) / (2.0 * h),
            right: (2.0 * column + 1.0 - w) / (2.0 * w),
            up: (h - 2.0 * row - 1.0) / (2.0 * h),
        }
    }
}
