//! Rays in parametric form: [`Ray`], with a direction in `f64`, and [`ExactRay`], which is either such a
//! ray, taken as exact, or a camera's view ray, whose exact direction does not fit into `f64`.

use glam::{DVec2, DVec3};
use serde::Serialize;
use thiserror::Error;

use crate::camera::resolved::ResolvedCamera;
use crate::camera::selection::Selection;
use crate::camera::viewport::Pixel;
use crate::exact::big_ray::BigRay;
use crate::exact::bounded::{Number, Vector, length, near, scaled};
use crate::exact::double_double::DoubleDouble;
use crate::exact::quadratic::DirectionTerms;
use crate::exact::scale::{ldexp, split, triple};

/// A ray: the points `origin + t * direction`. The direction is not normalized; `t` is in units of its
/// length.
///
/// The fields may have any values; a ray that does not pass [`Ray::check`] hits nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ray {
    /// The point at `t = 0`, the lecture's p.
    pub origin: DVec3,
    /// The ray's direction, the lecture's **d**.
    pub direction: DVec3,
}

/// The reason why a ray is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RayError {
    /// A coordinate of the named field is NaN or infinite.
    #[error("{field} is {}: every coordinate must be a finite number", triple(*.value))]
    NotFinite {
        /// `origin` or `direction`.
        field: &'static str,
        /// The invalid vector.
        value: DVec3,
    },
    /// The direction is `(0, 0, 0)`.
    #[error("direction is (0, 0, 0): it must point somewhere")]
    DirectionIsZero,
}

impl Ray {
    /// Creates a ray and checks it. The arguments may be of any type that converts into [`DVec3`], such
    /// as `[f64; 3]` or `(f64, f64, f64)`. Convert `f32` numbers to `f64` first, which is exact.
    ///
    /// # Errors
    /// Returns an error if a coordinate is not finite or the direction is zero.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ray = Ray::new([0.0, 0.0, 0.0], [0.0, 0.0, -2.0])?;
    /// assert_eq!(ray.at(2.0), DVec3::new(0.0, 0.0, -4.0));
    /// // Of f32, by number or by vector.
    /// let direction = [0.25_f32, -0.5, -1.0];
    /// let ray = Ray::new([0.0; 3], direction.map(f64::from))?;
    /// assert_eq!(ray.direction, DVec3::new(0.25, -0.5, -1.0));
    /// assert_eq!(Ray::new([0.0; 3], [0.0; 3]), Err(RayError::DirectionIsZero));
    /// # Ok::<(), RayError>(())
    /// ```
    pub fn new(origin: impl Into<DVec3>, direction: impl Into<DVec3>) -> Result<Ray, RayError> {
        let ray = Ray { origin: origin.into(), direction: direction.into() };
        ray.check().map(|()| ray)
    }

    /// Checks that origin and direction are finite and the direction is not zero.
    ///
    /// # Errors
    /// Returns an error if the ray is invalid.
    pub fn check(&self) -> Result<(), RayError> {
        for (field, value) in [("origin", self.origin), ("direction", self.direction)] {
            if !value.is_finite() {
                return Err(RayError::NotFinite { field, value });
            }
        }
        if self.direction == DVec3::ZERO { Err(RayError::DirectionIsZero) } else { Ok(()) }
    }

    /// Returns the point `origin + t * direction`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// Returns `t * |direction|`, the distance from the origin to the point at `t`, in world units.
    pub fn distance_along(&self, t: f64) -> f64 {
        if self.check().is_err() {
            return t * self.direction.length();
        }
        let (direction, k) = split(self.direction);
        ldexp(t * direction.length(), k)
    }
}

/// A ray for which every decision equals that of exact real arithmetic.
///
/// - For a [`Ray`], origin and direction count as exact, to the bit ([`ExactRay::from_ray`]).
/// - For a camera's view ray, eye, at (or view), up, viewport and image count as exact, and no
///   intermediate result is rounded: neither the basis nor (u, v) nor the direction
///   ([`ResolvedCamera::exact_ray`](ResolvedCamera::exact_ray)).
///
/// The intersection code treats the two kinds alike: it uses the direction in double-double with an
/// error bound and, if that does not suffice, the direction in exact numbers.
#[derive(Clone, Copy, Debug)]
pub struct ExactRay<'a> {
    origin: DVec3,
    source: Source<'a>,
    /// The direction times [`ExactRay::stretch`], in units of `2^scale`; its largest coordinate is
    /// between 1e-30 and 1e30.
    pub(crate) fine: DirectionTerms<DoubleDouble>,
    /// The same direction as in `fine`, rounded to `f64`.
    pub(crate) rough: DirectionTerms<f64>,
    pub(crate) scale: i32,
    /// A whole number by which the direction is multiplied to avoid divisions. For a pixel, it is a
    /// multiple of `2 W` and `2 H`, the denominators of u and v; otherwise it is 1.
    pub(crate) stretch: f64,
}

/// The inputs from which a ray's exact numbers are computed.
#[derive(Clone, Copy, Debug)]
enum Source<'a> {
    Given(DVec3),
    View(&'a ResolvedCamera, Selection),
}

impl ResolvedCamera {
    /// Returns the view ray through a pixel's centre, with nothing rounded: neither
    /// `u = width ((column + 0.5) / W - 0.5)` nor `v = height (0.5 - (row + 0.5) / H)` nor the basis.
    /// The camera's inputs count as exact.
    pub fn exact_ray(&self, pixel: Pixel) -> ExactRay<'_> {
        ExactRay::from_view(self, Selection::Pixel(pixel))
    }

    /// Returns the view ray through (u, v), with nothing rounded. (u, v) and the camera's inputs count
    /// as exact.
    ///
    /// # Errors
    /// Returns an error if u or v is not finite.
    pub fn exact_ray_at(&self, uv: DVec2) -> Result<ExactRay<'_>, RayError> {
        if !uv.is_finite() {
            return Err(RayError::NotFinite { field: "uv", value: uv.extend(0.0) });
        }
        Ok(ExactRay::from_view(self, Selection::Uv(uv)))
    }
}

impl<'a> ExactRay<'a> {
    /// Converts a ray to an exact ray: its origin and direction count as exact.
    ///
    /// # Errors
    /// Returns an error if a coordinate is not finite or the direction is zero.
    pub fn from_ray(ray: &Ray) -> Result<ExactRay<'static>, RayError> {
        ray.check()?;
        let (direction, scale) = scaled(ray.direction.to_array().map(DoubleDouble::from));
        Ok(ExactRay::new(ray.origin, Source::Given(ray.direction), direction, 0.0, scale, 1.0))
    }

    /// Returns a camera's view ray through a point of its viewport.
    pub(crate) fn from_view(camera: &'a ResolvedCamera, point: Selection) -> ExactRay<'a> {
        let (direction, scale) = camera.fine_direction(point);
        let (direction, more) = scaled(direction);
        let doubt = camera.fine_basis().direction_doubt();
        let (source, stretch) = (Source::View(camera, point), point.stretch(camera.image()));
        ExactRay::new(camera.eye(), source, direction, doubt, scale + more, stretch)
    }

    fn new<'b>(
        origin: DVec3,
        source: Source<'b>,
        d: Vector<DoubleDouble>,
        doubt: f64,
        scale: i32,
        stretch: f64,
    ) -> ExactRay<'b> {
        let rounded = near(d);
        let length = length(rounded);
        let fine = DirectionTerms { d, length, doubt };
        // A given direction is not rounded.
        let rounding = if doubt == 0.0 { 0.0 } else { 0.5 * f64::EPSILON };
        let rough = DirectionTerms { d: rounded, length, doubt: doubt + rounding };
        ExactRay { origin, source, fine, rough, scale, stretch }
    }

    /// Returns the ray's point at `t = 0`.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// Returns the direction of a ray that was given by its direction; `None` for a camera's view ray.
    pub(crate) fn given_direction(&self) -> Option<DVec3> {
        match self.source {
            Source::Given(direction) => Some(direction),
            Source::View(..) => None,
        }
    }

    /// Returns the ray in `f64`: each coordinate of the direction is the exact one, rounded.
    pub fn rounded(&self) -> Ray {
        let direction = match self.source {
            Source::Given(direction) => direction,
            Source::View(camera, point) => self.rounded_direction(camera, point),
        };
        Ray { origin: self.origin, direction }
    }

    fn rounded_direction(&self, camera: &ResolvedCamera, point: Selection) -> DVec3 {
        let stretch = DoubleDouble::from(self.stretch);
        let share = self.fine.doubt + DoubleDouble::QUOTIENT;
        let mut big = None;
        DVec3::from_array(std::array::from_fn(|i| {
            let x = self.fine.d[i] / stretch;
            let rounded = ldexp(x.hi, self.scale);
            if x.rounds_surely(share * self.fine.length / self.stretch) && rounded.is_normal() {
                return rounded;
            }
            let big = big.get_or_insert_with(|| camera.big_ray(point));
            big.value(&big.direction[i], &big.scale).to_f64() + 0.0
        }))
    }

    /// Returns the ray in exact numbers.
    pub(crate) fn big(&self) -> BigRay {
        match self.source {
            Source::Given(direction) => BigRay::given(self.origin, direction),
            Source::View(camera, point) => camera.big_ray(point),
        }
    }
}
