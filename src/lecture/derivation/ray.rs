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
    /// The pixel that the ray goes through; `None` of a ray that is given by (u, v).
    pub pixel: Option<Pixel>,
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

impl RayDerivation {
    /// The view ray through a pixel's centre.
    pub fn of_pixel(camera: &ResolvedCamera, pixel: Pixel) -> RayDerivation {
        let direction = camera.exact_ray(pixel).rounded();
        let parts = camera.direction_terms_of_pixel(pixel);
        RayDerivation::new(parts, Some(pixel), camera.uv_of_pixel(pixel), direction)
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
        pixel: Option<Pixel>,
        uv: DVec2,
        ray: Ray,
    ) -> RayDerivation {
        RayDerivation {
            pixel,
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
