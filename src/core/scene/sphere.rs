//! Spheres, and the quadratic equation of a ray and a sphere.

use glam::DVec3;

use crate::scene::error::ObjectError;

/// A sphere: all points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre c.
    pub center: DVec3,
    /// The radius r, greater than 0.
    pub radius: f64,
}

/// The quadratic equation `a t^2 + 2 b t + c = 0` of a ray and a sphere, with
///
/// ```text
/// a = d.d     b = d.(p - center)     c = |p - center|^2 - r^2     D = b^2 - a c
/// ```
///
/// so that `t = (-b -+ sqrt D) / a`. p is the ray's origin, d its direction, r the radius, and b is
/// *half* the linear coefficient; the textbook's `b^2 - 4ac` is four times this D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereQuadratic {
    /// `d.d`
    pub a: f64,
    /// `d.(p - center)`, half the linear coefficient.
    pub b: f64,
    /// `|p - center|^2 - r^2`: negative inside the sphere, 0 on it.
    pub c: f64,
    /// `b^2 - a c`, with its exact sign. If p is farther from the centre than `sqrt(2) r`, it is computed
    /// as `r^2 a - |(p - center) x d|^2`, which is equal (Lagrange's identity).
    pub discriminant: f64,
}

impl Sphere {
    /// Creates a sphere and checks it. The centre may be of any type that converts into [`DVec3`].
    ///
    /// # Errors
    /// Returns an error if the centre is not finite, or if the radius is not positive and finite.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ball = Sphere::new([0.0, 0.0, -5.0], 1.0)?;
    /// let (center, radius) = ([0.5_f32, 0.0, -5.0], 1.5_f32);
    /// let of_f32 = Sphere::new(center.map(f64::from), f64::from(radius))?;
    /// assert_eq!(of_f32.center.x, 0.5);
    /// assert_eq!(Sphere::new([0.0; 3], -1.0), Err(ObjectError::Radius { value: -1.0 }));
    /// # assert_eq!(ball.radius, 1.0);
    /// # Ok::<(), ObjectError>(())
    /// ```
    pub fn new(center: impl Into<DVec3>, radius: f64) -> Result<Sphere, ObjectError> {
        let sphere = Sphere { center: center.into(), radius };
        sphere.check().map(|()| sphere)
    }

    /// Checks that the centre is finite and the radius positive and finite.
    ///
    /// # Errors
    /// Returns an error if the sphere is invalid.
    pub fn check(&self) -> Result<(), ObjectError> {
        if !self.center.is_finite() {
            return Err(ObjectError::NotFinite { field: "center", value: self.center });
        }
        if !(self.radius.is_finite() && self.radius > 0.0) {
            return Err(ObjectError::Radius { value: self.radius });
        }
        Ok(())
    }
}
