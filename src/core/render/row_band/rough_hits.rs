//! Decides, in `f64`, pixels that drawing has left in doubt. The hit on the sphere that a pixel
//! currently shows is cached, so that testing another sphere takes one comparison.

use std::cmp::Ordering;

use crate::exact::bounded::{UNIT, Vector, dot};
use crate::exact::quadratic::{DirectionTerms, LARGEST_SHARE, Quadratic};
use crate::exact::scale::ldexp;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The first hit of a pixel's ray on a sphere, in `f64`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoughHit {
    /// Index of the sphere.
    pub(crate) object: u32,
    /// `t` for the stretched direction (see [`RoughHit::t_of`]), in units of `2^scale`.
    pub(crate) t: f64,
    /// The relative error of `t`.
    pub(crate) share: f64,
    scale: i32,
    /// The side of the sphere that the eye is on.
    side: Ordering,
    /// The vector from the sphere's centre to the hit, in units of `2^scale`.
    from_center: Vector<f64>,
    /// Bound of the length of the error vector of `from_center`.
    off: f64,
    /// Lower bound of half the length of the ray's chord in the sphere.
    half_chord: f64,
}

/// The result of intersecting a pixel's ray with a sphere in `f64`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rough {
    Miss,
    Hit(RoughHit),
    Doubt,
}

/// Range of lengths for which no computation here overflows or underflows.
const LENGTHS: std::ops::Range<f64> = 1e-60..1e60;

impl Rough {
    /// Intersects the ray with a sphere.
    pub(crate) fn new(
        object: u32,
        seen: &SphereFromOrigin,
        direction: &DirectionTerms<f64>,
    ) -> Rough {
        let quadratic = Quadratic::new(&seen.rough, direction);
        let Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt } = quadratic;
        let found = match seen.side {
            Ordering::Less => quadratic.root(&seen.rough, true),
            _ if b < -b_doubt => return Rough::Miss,
            _ if b <= b_doubt => None,
            // If the eye lies on the sphere, the roots are 0 and 2 b / a.
            Ordering::Equal => Some((2.0 * b / a, 1.01 * (b_doubt / b + a_doubt) + 4.0 * UNIT)),
            Ordering::Greater if discriminant < -discriminant_doubt => return Rough::Miss,
            Ordering::Greater => quadratic.root(&seen.rough, false),
        };
        let Some((t, share)) = found else { return Rough::Doubt };
        let reach = t * direction.length;
        if !(share < LARGEST_SHARE && LENGTHS.contains(&t) && LENGTHS.contains(&reach)) {
            return Rough::Doubt;
        }
        let off = 1.05
            * ((share + direction.doubt + 2.0 * UNIT) * reach
                + (seen.rough.q_doubt + 2.0 * UNIT) * seen.rough.distance);
        let q = seen.rough.q;
        let reach_to_middle = t * (1.0 + share) * a * (1.0 + a_doubt + 8.0 * UNIT);
        Rough::Hit(RoughHit {
            object,
            t,
            share,
            scale: seen.scale,
            side: seen.side,
            from_center: std::array::from_fn(|i| t * direction.d[i] - q[i]),
            off,
            half_chord: (b - b_doubt - reach_to_middle) / direction.length,
        })
    }
}

impl RoughHit {
    /// Returns `t` for the ray itself. The direction used here is longer by the factor `stretch` and in
    /// units of `2^scale`.
    pub(crate) fn t_of(&self, stretch: f64, scale: i32) -> f64 {
        ldexp(self.t * stretch, self.scale - scale)
    }

    /// Compares the `t` of two hits of one ray; returns `None` if they are too close to call.
    pub(crate) fn compare_t(&self, other: &RoughHit) -> Option<Ordering> {
        // Both t are between 1e-60 and 1e60.
        let k = self.scale - other.scale;
        if k.abs() > 500 {
            return Some(k.cmp(&0));
        }
        let (t, other_t) = (ldexp(self.t, k), other.t);
        let doubt = 1.01 * (self.share * t + other.share * other_t);
        ((t - other_t).abs() > doubt).then(|| t.total_cmp(&other_t))
    }

    /// Compares `t` with the `t` at which the ray hits another sphere, by the power of this hit's point
    /// with respect to the other sphere, which the ray must be known to hit. Returns `None` if `f64`
    /// cannot decide.
    ///
    /// Let r and r' be the radii of this and the other sphere, o the vector from this sphere's centre to
    /// the hit, and e the vector from this centre to the other one. Since `|o| = r`, the quadratic terms
    /// of the power cancel:
    ///
    /// ```text
    /// |o - e|^2 - r'^2  =  |e|^2 - 2 e.o - (r' - r) (r' + r)
    /// ```
    ///
    /// This is linear in o, and every term is as small as the difference between the spheres, so `f64`
    /// can distinguish nearly equal spheres, and nested ones.
    ///
    /// - If the power is negative, the hit lies inside the other sphere. If the eye is outside, the ray
    ///   has already entered that sphere, so the other hit is first. If the eye is inside, the ray
    ///   leaves that sphere later, so this hit is first.
    /// - If the power is positive, the hit lies before or after the other sphere's chord. If the eye is
    ///   outside, it lies before, provided that `|e|` is less than half the chord in this sphere, as the
    ///   chords' middles are no farther apart than the centres. If the eye is inside, it lies after, as
    ///   the other chord begins behind the eye.
    #[inline]
    pub(crate) fn compare_by_power(
        &self,
        own: &Sphere,
        other: &SphereFromOrigin,
    ) -> Option<Ordering> {
        if self.scale != 0 || other.scale != 0 || self.side != other.side {
            return None;
        }
        let others = &other.sphere;
        let e = (others.center - own.center).to_array();
        let (wider, both) = (others.radius - own.radius, others.radius + own.radius);
        let (ee, eo) = (dot(e, e), dot(e, self.from_center));
        let power = ee - 2.0 * eo - wider * both;
        let largest = e.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let products: f64 = (0..3).map(|i| (e[i] * self.from_center[i]).abs()).sum();
        let rounding = 16.0 * UNIT * (ee + 2.0 * products + wider.abs() * both);
        let off = 2.0 * 1.74 * largest * self.off + rounding + f64::MIN_POSITIVE;
        let is_inside = power < -off;
        if !is_inside && power <= off {
            return None;
        }
        match self.side {
            Ordering::Greater if is_inside => Some(Ordering::Greater),
            Ordering::Greater => (1.74 * largest < self.half_chord).then_some(Ordering::Less),
            Ordering::Less if is_inside => Some(Ordering::Less),
            Ordering::Less => Some(Ordering::Greater),
            Ordering::Equal => None,
        }
    }
}
