//! A plane with the values precomputed for all rays from one origin: decides exactly whether a ray hits
//! it, and computes `t`.

use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::ExactRay;
use crate::exact::bounded::{Number, UNIT, Vector, dot, length, scaled};
use crate::exact::double_double::{DoubleDouble, U2, difference_with_rest};
use crate::exact::dyadic::{Dyadic, cross, exact3};
use crate::exact::precise::Precise;
use crate::exact::quadratic::DirectionTerms;
use crate::exact::scale::{ldexp, split, unit};
use crate::exact::steps::{Step, Steps, sign_by_steps};
use crate::scene::big_roots::big_offset;
use crate::scene::plane::{Plane, PlaneTerms};

/// A plane with the values precomputed for all rays from one origin. For each ray,
/// `t = offset / (normal . direction)`.
#[derive(Clone, Debug)]
pub(crate) struct PlaneFromOrigin {
    pub(crate) plane: Plane,
    origin: DVec3,
    /// The normal in units of `2^normal_scale`. The digits that scaling may lose are negligible.
    pub(crate) normal: Vector<f64>,
    pub(crate) normal_length: f64,
    pub(crate) normal_scale: i32,
    /// `normal . (point - origin)` in units of `2^scale`.
    pub(crate) offset: DoubleDouble,
    /// `offset / (|normal| |point - origin|)`, rounded.
    pub(crate) offset_share: f64,
    /// Relative error of the offset.
    pub(crate) offset_doubt: f64,
    /// The power of two of the offset's unit; 0 except at extreme distances.
    pub(crate) scale: i32,
    /// The exact sign of the offset: `Greater` if the normal points from the origin's side of the
    /// plane to the other, `Equal` if the origin lies in the plane.
    pub(crate) side: Ordering,
    pub(crate) side_step: Step,
}

/// The value of `normal . direction` for a ray, and a bound of its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate<T> {
    pub(crate) value: T,
    pub(crate) doubt: f64,
}

impl<T: Number> Rate<T> {
    /// Computes the dot product and the bound, which includes the error of the direction.
    pub(crate) fn new(
        normal: Vector<T>,
        normal_length: f64,
        direction: &DirectionTerms<T>,
    ) -> Rate<T> {
        const SECOND_ORDER_AND_UNDERFLOW: (f64, f64) = (1.05, 1e-250);
        let (factor, least) = SECOND_ORDER_AND_UNDERFLOW;
        let value = dot(normal, direction.d);
        let share = T::DOT + direction.doubt;
        Rate { value, doubt: factor * share * normal_length * direction.length + least }
    }

    fn bounded(&self) -> (T, f64) {
        (self.value, self.doubt)
    }
}

impl PlaneFromOrigin {
    /// Bounds of the error of [`PlaneFromOrigin::offset_share`], in `f64` and in double-double.
    pub(crate) const SIDE_SHARES: [f64; 2] = [8.0 * UNIT, 1.05 * DoubleDouble::DOT];

    pub(crate) fn new(plane: &Plane, origin: DVec3) -> PlaneFromOrigin {
        let (normal, normal_scale) = split(plane.normal);
        let (to, rest, quartered) = difference_with_rest(plane.point, origin);
        let to: Vector<DoubleDouble> =
            std::array::from_fn(|i| DoubleDouble { hi: to[i], lo: rest[i] });
        let (to, more) = scaled(to);
        let scale = quartered + more;
        let normal = normal.to_array();
        let normal_length = length(normal);
        let offset = dot(normal.map(DoubleDouble::from), to);
        let reach = normal_length * length(to.map(DoubleDouble::near));
        let [rough, fine] = PlaneFromOrigin::SIDE_SHARES;
        let mut seen = PlaneFromOrigin {
            plane: *plane,
            origin,
            normal,
            normal_length,
            normal_scale,
            offset,
            offset_share: offset.hi / reach,
            offset_doubt: fine * reach / offset.hi.abs(),
            scale,
            side: (offset.hi + 0.0).total_cmp(&0.0),
            side_step: Step::F64,
        };
        if seen.offset.hi.abs() <= rough * reach {
            seen.side_step = Step::DoubleDouble;
        }
        /// The relative error of the offset above which t would lose digits.
        const PLENTY: f64 = 256.0 * U2;
        let is_sure = seen.offset_doubt <= PLENTY && offset.hi.abs() > 1e-200;
        if !is_sure {
            seen.set_exact();
        }
        seen
    }

    /// Recomputes the offset in exact numbers, for use when double-double has lost its digits.
    fn set_exact(&mut self) {
        let exact = big_offset(&self.plane, &exact3(self.origin));
        self.side = exact.sign();
        // The sign may be certain even if the offset has to be recomputed.
        if !(self.offset_doubt < 0.5 && self.offset.hi.abs() > 1e-200) {
            self.side_step = Step::Exact;
        }
        let (value, k) = exact.to_double_double();
        // The offset gets its own scale, so that nothing underflows.
        self.scale = k - self.normal_scale;
        self.offset = value;
        self.offset_doubt = 2.0 * U2;
    }

    /// Returns the exact sign of `normal . direction`, `Equal` for a ray parallel to the plane.
    pub(crate) fn rate(&self, ray: &ExactRay, steps: &mut Steps) -> Ordering {
        let (sign, step) = sign_by_steps(
            self.rate_of(&ray.rough).bounded(),
            || self.rate_of(&ray.fine).bounded(),
            || ray.big().rate(&self.plane),
        );
        steps.count(step);
        sign
    }

    /// Returns `normal . direction` in the direction's precision.
    pub(crate) fn rate_of<T: Number>(&self, direction: &DirectionTerms<T>) -> Rate<T> {
        Rate::new(self.normal.map(T::from), self.normal_length, direction)
    }

    /// Returns whether the ray hits the plane at a `t > 0`.
    pub(crate) fn is_hit(&self, ray: &ExactRay, steps: &mut Steps) -> bool {
        self.rate(ray, steps) == self.side && self.side != Ordering::Equal
    }

    /// Returns `t` of a line that is not parallel to the plane, with a relative error of at most
    /// `doubt`, and the step that computed it.
    pub(crate) fn t(&self, ray: &ExactRay, doubt: f64) -> (Precise, Step) {
        if self.side == Ordering::Equal {
            return (Precise::ZERO, Step::DoubleDouble);
        }
        let rate = self.rate_of(&ray.fine);
        let off = self.offset_doubt
            + 1.05
                * (rate.doubt / rate.value.hi.abs()
                    + DoubleDouble::QUOTIENT
                    + DoubleDouble::PRODUCT);
        let t = self.offset / rate.value;
        if off <= doubt && (1e-250..1e250).contains(&t.hi.abs()) {
            let t = Precise::new(t.times(ray.stretch), self.scale - ray.scale);
            return (t, Step::DoubleDouble);
        }
        let big = ray.big();
        (big.t(&big.plane_root(&self.plane)), Step::Exact)
    }

    /// Returns `t` in `f64`, in units of `stretch 2^(scale of the plane - scale of the ray)`, where
    /// `stretch` is the factor of the ray's direction; and its relative error. Returns `None` if the
    /// line may be parallel to the plane.
    pub(crate) fn rough_t(&self, direction: &DirectionTerms<f64>) -> Option<(f64, f64)> {
        let rate = self.rate_of(direction);
        let share = rate.doubt / rate.value.abs();
        (share < 0.25).then(|| (self.offset.hi / rate.value, 2.0 * share + 4.0 * UNIT))
    }

    /// Returns `normal . direction`, rounded, with its exact sign, in the units of the inputs.
    pub(crate) fn rate_given(&self, ray: &ExactRay) -> f64 {
        let rate = (self.rate_of(&ray.fine).value / DoubleDouble::from(ray.stretch)).hi.abs();
        let rate = ldexp(rate, self.normal_scale + ray.scale).max(f64::MIN_POSITIVE);
        match self.rate(ray, &mut Steps::default()) {
            Ordering::Less => -rate,
            Ordering::Equal => 0.0,
            Ordering::Greater => rate,
        }
    }

    /// Returns `normal . (point - origin)`, rounded, in the units of the inputs.
    pub(crate) fn offset_given(&self) -> f64 {
        ldexp(self.offset.hi, self.scale + self.normal_scale)
    }
}

impl Plane {
    /// Returns the terms of the intersection for display, each rounded once from more digits. They may
    /// overflow or underflow even if `t` does not. For an invalid plane, they are NaN.
    pub fn terms_of(&self, ray: &ExactRay) -> PlaneTerms {
        if self.check().is_err() {
            return PlaneTerms { rate: f64::NAN, offset: f64::NAN };
        }
        let seen = PlaneFromOrigin::new(self, ray.origin());
        PlaneTerms { rate: seen.rate_given(ray), offset: seen.offset_given() }
    }

    /// Returns whether two planes are the same set of points, exactly: the normals are parallel, and
    /// each plane's point lies in the other plane. Returns false if either plane does not pass
    /// [`Plane::check`].
    pub fn is_same(&self, other: &Plane) -> bool {
        if self.check().is_err() || other.check().is_err() {
            return false;
        }
        // Most planes differ by far more than rounding errors. Only the others need exact numbers.
        let (n, m) = (unit(self.normal), unit(other.normal));
        if n.cross(m).length_squared() > 1e-20 {
            return false;
        }
        if PlaneFromOrigin::new(self, other.point).side != Ordering::Equal {
            return false;
        }
        let normals = cross(&exact3(self.normal), &exact3(other.normal));
        normals.iter().all(Dyadic::is_zero)
    }
}
