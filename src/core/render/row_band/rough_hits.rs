//! Decides, in `f64`, pixels that drawing has left in doubt. The hit on the sphere that a pixel
//! currently shows is kept, so that testing another sphere takes one comparison, or one for several
//! pixels.

use std::cmp::Ordering;

use crate::exact::bounded::{UNIT, Vector};
use crate::exact::quadratic::{DirectionTerms, LARGEST_SHARE, Quadratic, SureRoot};
use crate::exact::scale::ldexp;
use crate::scene::pair_order::PairOrder;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The first hit of a pixel's ray on a sphere, in `f64`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoughHit {
    /// Index of the sphere.
    pub(crate) object: u32,
    /// The root for the direction of [`FrameRays`](crate::render::polynomial::frame_rays::FrameRays), which
    /// is longer than the ray's by its `stretch`, in units of `2^scale` of the sphere and of the rays.
    pub(crate) root: SureRoot<f64>,
    pub(crate) scale: i32,
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
        let Quadratic { b, discriminant, b_doubt, discriminant_doubt, .. } = quadratic;
        let is_outside = seen.side == Ordering::Greater;
        let found = match seen.side {
            Ordering::Less => quadratic.sure_root(&seen.rough, true),
            _ if b < -b_doubt => return Rough::Miss,
            _ if b <= b_doubt => None,
            _ if is_outside && discriminant < -discriminant_doubt => return Rough::Miss,
            _ => quadratic.sure_root(&seen.rough, !is_outside),
        };
        let is_plain = |root: &SureRoot<f64>| {
            root.share < LARGEST_SHARE
                && LENGTHS.contains(&root.t)
                && LENGTHS.contains(&(root.t * direction.length))
        };
        match found.filter(is_plain) {
            Some(root) => Rough::Hit(RoughHit { object, root, scale: seen.scale }),
            None => Rough::Doubt,
        }
    }
}

impl RoughHit {
    /// Compares the `t` of two hits of one ray; returns `None` if they are too close to call.
    pub(crate) fn compare_t(&self, other: &RoughHit) -> Option<Ordering> {
        // Both t are between 1e-60 and 1e60.
        let k = self.scale - other.scale;
        if k.abs() > 500 {
            return Some(k.cmp(&0));
        }
        let (t, other_t) = (ldexp(self.root.t, k), other.root.t);
        let doubt = 1.01 * (self.root.share * t + other.root.share * other_t);
        ((t - other_t).abs() > doubt).then(|| t.total_cmp(&other_t))
    }
}

/// The hit of a pixel's ray on the sphere that the pixel shows, as it is compared with other spheres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeptHit {
    pub(crate) hit: RoughHit,
    pub(crate) bounds: HitBounds,
}

/// Bounds of the hits in one or several pixels, by which they are compared with spheres that are drawn
/// later: all spheres are compared with the same one, the reference, at the hits' points
/// ([`PairOrder::least`]). In a crowd of nearly equal spheres, this takes the place of a comparison with
/// every sphere that is shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HitBounds {
    /// Index of the reference.
    pub(crate) reference: u32,
    /// A box that contains the vectors from the eye to the hits.
    points: [Vector<f64>; 2],
    /// Bound of the errors of the points, and of the roundings in a comparison.
    off: f64,
    /// Upper bound of g for the shown spheres.
    limit: f64,
    /// The power of two of the unit of g; `None` if the reference itself is shown, for which g = 0.
    scale: Option<i32>,
    /// Lower bound of half the length of the ray's chord in the shown sphere, minus the distance of its
    /// centre from that of the reference.
    room: f64,
}

impl HitBounds {
    /// Computes the bounds of one hit, given the order of the reference, if it is another sphere, and the
    /// shown sphere. A reference that is too far away is replaced by the shown sphere.
    pub(crate) fn new(
        hit: &RoughHit,
        direction: &DirectionTerms<f64>,
        reference: Option<(u32, &PairOrder)>,
    ) -> HitBounds {
        let SureRoot { t, share, swing } = hit.root;
        let points = [direction.d.map(|d| t * d); 2];
        let off = 1.05 * (share + direction.doubt + 12.0 * UNIT) * t * direction.length;
        let room = 0.99 * swing / direction.length;
        let is_near = |order: &PairOrder| order.unit == hit.scale && 4.0 * order.apart() <= room;
        match reference.filter(|(_, order)| is_near(order)) {
            Some((reference, order)) => {
                let limit = order.least(points, off) + 2.0 * order.slack(off);
                let (scale, room) = (Some(order.scale), room - order.apart());
                HitBounds { reference, points, off, limit, scale, room }
            }
            None => HitBounds { reference: hit.object, points, off, limit: 0.0, scale: None, room },
        }
    }

    /// Returns bounds of the hits that either of two bounds contains; `None` if there are none.
    pub(crate) fn with(self, other: HitBounds) -> Option<HitBounds> {
        let is_alike = self.scale.zip(other.scale).is_none_or(|(one, other)| one == other);
        let ([low, high], [other_low, other_high]) = (self.points, other.points);
        (is_alike && self.reference == other.reference).then(|| HitBounds {
            reference: self.reference,
            points: [
                std::array::from_fn(|i| low[i].min(other_low[i])),
                std::array::from_fn(|i| high[i].max(other_high[i])),
            ],
            off: self.off.max(other.off),
            limit: self.limit.max(other.limit),
            scale: self.scale.or(other.scale),
            room: self.room.min(other.room),
        })
    }

    /// Returns whether `f64` is certain that no ray hits another sphere before the shown ones, given the
    /// order of the reference and the other sphere.
    #[inline(always)]
    pub(crate) fn are_before(&self, order: &PairOrder) -> bool {
        self.scale.is_none_or(|scale| scale == order.scale)
            && order.least(self.points, self.off) > self.limit
            && order.apart() <= self.room
    }
}
