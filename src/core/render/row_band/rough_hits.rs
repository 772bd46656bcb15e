//! Decides, in `f64`, pixels that drawing has left in doubt. The hit on the sphere that a pixel
//! currently shows is kept, so that testing another sphere takes one comparison.

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
    /// The root for the stretched direction (see [`RoughHit::t_of`]), in units of `2^scale`.
    pub(crate) root: SureRoot<f64>,
    scale: i32,
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
            Ordering::Less => quadratic.sure_root(&seen.rough, true),
            _ if b < -b_doubt => return Rough::Miss,
            _ if b <= b_doubt => None,
            // If the eye lies on the sphere, the roots are 0 and 2 b / a.
            Ordering::Equal => {
                let share = 1.01 * (b_doubt / b + a_doubt) + 4.0 * UNIT;
                Some(SureRoot { t: 2.0 * b / a, share, swing: 0.0 })
            }
            Ordering::Greater if discriminant < -discriminant_doubt => return Rough::Miss,
            Ordering::Greater => quadratic.sure_root(&seen.rough, false),
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
    /// Returns `t` for the ray itself. The direction used here is longer by the factor `stretch` and in
    /// units of `2^scale`.
    pub(crate) fn t_of(&self, stretch: f64, scale: i32) -> f64 {
        ldexp(self.root.t * stretch, self.scale - scale)
    }

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

/// The hit of a pixel's ray on the sphere that the pixel shows, as it is compared with other spheres: by
/// their values at the hit's point ([`PairOrder::value_at`]), each relative to the same sphere, the
/// reference. In a crowd of nearly equal spheres, one comparison with the reference thus takes the place
/// of one with every other sphere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeptHit {
    pub(crate) hit: RoughHit,
    /// Index of the reference.
    pub(crate) reference: u32,
    /// The vector from the eye to the hit.
    point: Vector<f64>,
    /// Bound of the length of the error vector of `point`, and of the roundings in a value at the point.
    off: f64,
    /// The value of the shown sphere, plus the bound of its error.
    limit: f64,
    /// The power of two of the values' unit; `None` if the reference is the shown sphere, whose value
    /// is 0.
    scale: Option<i32>,
    /// Lower bound of half the length of the ray's chord in the shown sphere, minus the distance of its
    /// centre from that of the reference.
    room: f64,
}

impl KeptHit {
    /// Keeps a hit, given the order of the reference, if it is another sphere, and the shown sphere.
    pub(crate) fn new(
        hit: RoughHit,
        direction: &DirectionTerms<f64>,
        reference: Option<(u32, &PairOrder)>,
    ) -> KeptHit {
        let SureRoot { t, share, swing } = hit.root;
        let off = 1.05 * (share + direction.doubt + 8.0 * UNIT) * t * direction.length;
        let point = direction.d.map(|d| t * d);
        let mut kept = KeptHit {
            hit,
            reference: hit.object,
            point,
            off,
            limit: 0.0,
            scale: None,
            room: 0.99 * swing / direction.length,
        };
        // A reference too far away would decide nothing.
        let is_near =
            |order: &PairOrder| order.unit == hit.scale && order.is_within(0.25 * kept.room);
        if let Some((reference, order)) = reference.filter(|(_, order)| is_near(order)) {
            let (value, slack) = order.value_at(point, off);
            kept.reference = reference;
            (kept.limit, kept.scale) = (value + slack, Some(order.scale));
            kept.room -= order.distance();
        }
        kept
    }

    /// Returns whether `f64` is certain that the hit on another sphere, if there is one, comes later;
    /// given the order of the reference and the other sphere.
    #[inline(always)]
    pub(crate) fn is_before(&self, order: &PairOrder) -> bool {
        let (value, slack) = order.value_at(self.point, self.off);
        let is_comparable = self.scale.is_none_or(|scale| scale == order.scale);
        is_comparable && value - slack > self.limit && order.is_within(self.room)
    }
}
