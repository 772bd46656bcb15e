//! Which of two planes the rays of one origin hit first.

use std::cmp::Ordering;

use crate::exact::bounded::{Number, UNIT, Vector, dot, length};
use crate::exact::dyadic::{Dyadic, exact3, times};
use crate::exact::quadratic::DirectionTerms;
use crate::scene::big_roots::big_offset;
use crate::scene::plane_predicates::PlaneFromOrigin;

/// Two planes as the rays of one origin see them. With offsets o and o', both not 0, and normals n and
/// n', a ray along d that hits both meets the first one before the other where
///
/// ```text
/// |o| / |n.d| < |o'| / |n'.d|     that is     e.d < 0     with  e = s s' (o n' - o' n)
/// ```
///
/// and s and s' the signs of o and o', which are those of n.d and n'.d at a hit. e is exact and then
/// rounded, so that planes that nearly coincide are told apart as surely as others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaneOrder {
    /// e, its largest coordinate near 1.
    e: Vector<f64>,
    length: f64,
}

impl PlaneOrder {
    pub(crate) fn new(one: &PlaneFromOrigin, other: &PlaneFromOrigin) -> PlaneOrder {
        let terms = |of: &PlaneFromOrigin, beside: &PlaneFromOrigin| {
            times(&exact3(of.plane().normal), &big_offset(beside.plane(), beside.origin()))
        };
        let (plus, minus) = (terms(other, one), terms(one, other));
        let exact: [Dyadic; 3] = std::array::from_fn(|i| &plus[i] - &minus[i]);
        let largest = exact.iter().map(Dyadic::log2).max().unwrap_or_default();
        let sign = if one.side == other.side { 1.0 } else { -1.0 };
        let e = exact.map(|x| if x.is_zero() { 0.0 } else { sign * x.rounded_times(-largest) });
        PlaneOrder { e, length: length(e) }
    }

    /// Compares the `t` of a ray that hits both planes; `None` in doubt.
    pub(crate) fn compare(&self, direction: &DirectionTerms<f64>) -> Option<Ordering> {
        // What is so small beside the largest coordinate that it is rounded to 0 is within the bound.
        const SECOND_ORDER_AND_UNDERFLOW: (f64, f64) = (1.05, 1e-250);
        let (factor, least) = SECOND_ORDER_AND_UNDERFLOW;
        let value = dot(self.e, direction.d);
        let share = f64::DOT + direction.doubt + 2.0 * UNIT;
        let doubt = factor * share * self.length * direction.length + least;
        (value.abs() > doubt).then(|| value.total_cmp(&0.0))
    }
}
