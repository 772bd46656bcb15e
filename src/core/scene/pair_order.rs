//! The order in which rays from one origin hit two spheres, or two planes, by the difference between the
//! two objects, however small it is.

use std::cmp::Ordering;

use glam::DVec3;

use crate::exact::bounded::{Number, UNIT, Vector, dot, length, near};
use crate::exact::double_double::{DoubleDouble, U2, difference_with_rest, two_sum};
use crate::exact::dyadic::{Dyadic, Exact3, exact3, minus, times};
use crate::exact::quadratic::{DirectionTerms, SureRoot};
use crate::exact::scale::ldexp;
use crate::scene::big_roots::{big_c, big_offset};
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::plane_predicates::{PlaneFromOrigin, Rate};
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The order in which rays from one origin hit two objects of a kind.
///
/// Sphere i is met where `f_i(t) = a t^2 - 2 (q_i.d) t + c_i` is 0. At the root t of the first sphere,
/// the terms in a cancel:
///
/// ```text
/// g = f_2(t) = f_2(t) - f_1(t) = C - 2 (e.d) t     with  e = q_2 - q_1,  C = c_2 - c_1
/// ```
///
/// The vector e and C are the same for all rays. They are computed exactly and then rounded, so large
/// terms never cancel, and spheres that nearly coincide are told apart in `f64`.
///
/// - *Outside both spheres*, both are hit at their near roots. If g < 0, the first sphere's root lies
///   inside the second sphere, which is hit first. If g > 0, it lies before the chord in the second
///   sphere or after it; it lies before it if it lies before the chord's middle, where
///   `f_2'(t) / 2 = a t - q_2.d = -(sqrt D_1 + e.d)` is negative.
/// - *Inside both*, both are hit at their far roots. If g < 0, the first sphere's root lies inside the
///   second sphere, which the ray leaves later.
/// - *On both*, `t_i = 2 (q_i.d) / a` and C = 0; the first sphere is first if e.d > 0.
/// - *Planes*, with normals n, n' and offsets `o = n.(point - origin)`, o', neither of which is 0: the
///   first one is first if `|o| / |n.d| < |o'| / |n'.d|`, that is, if e.d > 0 for
///   `e = s s' (o' n - o n')`, with the signs s and s' of o and o', which n.d and n'.d have at a hit, too.
///
/// # The error of g
///
/// Let u be the unit roundoff, p the relative error of d, and s that of t. The computed e.d is off by
/// `|e||d| (DOT + p + u)`, where the last term is the rounding of e. The product with t adds
/// `|e.d| t (s + PRODUCT)`, the difference adds SUM times each of its two terms, and C is rounded. So g
/// is off by at most
///
/// ```text
/// (2 u + doubt of C) |C| + 2 t (|e||d| (DOT + p + u) + |e.d| (s + PRODUCT + SUM))
/// ```
///
/// times 1.05 for the products of these errors, which in `f64`, for a camera's rays (p = 7 u) and an
/// accurate t (s = 8 u), is below 2.5e-15 (|C| + 2 |e||d| t). In double-double, u stands for SUM, which
/// covers the rounding of e and C to 105 bits. The coefficients e and C are scaled by one power of two,
/// after which the largest is at least 2^-256. One that is then below [`PairOrder::TINY`] is taken for 0:
/// that changes C by at most TINY, and `2 (e.d) t` by less than the error above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairOrder {
    /// The vector e, in units of `2^scale` and of the first sphere's unit of length. The signs of e and C
    /// are such that the first object is first if g > 0.
    e: Vector<DoubleDouble>,
    /// C, in units of `2^scale` and of the square of the first sphere's unit of length.
    c: DoubleDouble,
    c_doubt: f64,
    /// `|e|`, rounded.
    length: f64,
    /// A multiple of [`PairOrder::STEP`], so that nearly equal spheres mostly have the same.
    pub(crate) scale: i32,
    /// The power of two of the first sphere's unit of length.
    pub(crate) unit: i32,
    /// The side of both spheres that the origin is on; `Equal` if C = 0.
    side: Ordering,
}

impl PairOrder {
    const STEP: i32 = 512;

    /// Coefficients below this number are set to 0. The largest one is at least 2^-256.
    const TINY: f64 = 1e-290;

    /// Returns the order of two objects, or `None` if it does not follow from their difference: for a
    /// sphere and a plane, and for spheres of which the origin is on different sides.
    pub(crate) fn new(
        one: &ObjectFromOrigin,
        other: &ObjectFromOrigin,
        origin: DVec3,
    ) -> Option<PairOrder> {
        match (one, other) {
            (ObjectFromOrigin::Sphere(one), ObjectFromOrigin::Sphere(other))
                if one.side == other.side =>
            {
                Some(PairOrder::of_spheres(one, other, origin))
            }
            (ObjectFromOrigin::Plane(one), ObjectFromOrigin::Plane(other)) => {
                Some(PairOrder::of_planes(one, other, origin))
            }
            _ => None,
        }
    }

    fn of_planes(one: &PlaneFromOrigin, other: &PlaneFromOrigin, origin: DVec3) -> PairOrder {
        let origin = exact3(origin);
        let terms = |of: &PlaneFromOrigin, beside: &PlaneFromOrigin| {
            times(&exact3(of.plane.normal), &big_offset(&beside.plane, &origin))
        };
        let (own, others) = (terms(one, other), terms(other, one));
        let e = if one.side == other.side { minus(&own, &others) } else { minus(&others, &own) };
        PairOrder::exact(&e, &Dyadic::zero(), 0, Ordering::Equal)
    }

    fn of_spheres(one: &SphereFromOrigin, other: &SphereFromOrigin, origin: DVec3) -> PairOrder {
        PairOrder::fine(one, other).unwrap_or_else(|| {
            let origin = exact3(origin);
            let [c, others] = [one, other].map(|seen| big_c(&seen.sphere, &origin));
            let e = minus(&exact3(other.sphere.center), &exact3(one.sphere.center));
            PairOrder::exact(&e, &(&others - &c), one.scale, one.side)
        })
    }

    /// Returns the order of two spheres by double-double, in which e is exact, and
    /// `C = e.(q_1 + q_2) - (r_2 - r_1) (r_2 + r_1)` loses few digits; `None` if it loses many.
    fn fine(one: &SphereFromOrigin, other: &SphereFromOrigin) -> Option<PairOrder> {
        type T = DoubleDouble;
        const PLENTY: f64 = 1e-22;
        let (e, rest, k) = difference_with_rest(other.sphere.center, one.sphere.center);
        let e: Vector<T> = std::array::from_fn(|i| T { hi: e[i], lo: rest[i] });
        let [wider, both] = [-one.sphere.radius, one.sphere.radius].map(|radius| {
            let (hi, lo) = two_sum(other.sphere.radius, radius);
            T { hi, lo }
        });
        let middle: Vector<T> = std::array::from_fn(|i| one.fine.q[i] + other.fine.q[i]);
        let (length, rr) = (length(near(e)), wider * both);
        let c = dot(e, middle) - rr;
        let reach = length * (one.fine.distance + other.fine.distance);
        let doubt = (T::DOT + 2.0 * T::SUM) * reach + (T::PRODUCT + T::SUM) * rr.hi.abs();
        let c_doubt = 1.05 * (doubt / c.hi.abs() + T::SUM);
        let is_plain = (k, one.scale, other.scale) == (0, 0, 0) && c.hi.abs() > 1e-150;
        let is_sure = is_plain && c_doubt < PLENTY;
        is_sure.then(|| PairOrder::rounded((e, c, c_doubt), [0, 0], one.side))
    }

    /// Returns the order for exact e and C, for lengths in units of `2^unit`.
    fn exact(e: &Exact3, c: &Dyadic, unit: i32, side: Ordering) -> PairOrder {
        let top = e.iter().map(|x| x.log2() - unit).fold(c.log2() - 2 * unit, i32::max);
        let scale = PairOrder::STEP * (top + PairOrder::STEP / 2).div_euclid(PairOrder::STEP);
        let near = |x: &Dyadic, unit: i32| {
            let (mantissa, k) = x.to_double_double();
            let x = mantissa.scaled(k - unit - scale);
            // Where products underflow, many processors take a hundred times as long.
            if x.hi.abs() < PairOrder::TINY { DoubleDouble::default() } else { x }
        };
        let (e, c) = (e.each_ref().map(|x| near(x, unit)), near(c, 2 * unit));
        PairOrder::rounded((e, c, 2.0 * U2), [scale, unit], side)
    }

    fn rounded(
        (e, c, c_doubt): (Vector<DoubleDouble>, DoubleDouble, f64),
        [scale, unit]: [i32; 2],
        side: Ordering,
    ) -> PairOrder {
        let turned = if side == Ordering::Greater { (e, c) } else { (e.map(|x| -x), -c) };
        PairOrder { e: turned.0, c: turned.1, c_doubt, length: length(near(e)), scale, unit, side }
    }

    /// Compares the `t` at which a ray hits the two objects; returns `None` if rounding could change the
    /// order. If C = 0, the root does not matter.
    pub(crate) fn compare<T: Number>(
        &self,
        direction: &DirectionTerms<T>,
        root: Option<SureRoot<T>>,
    ) -> Option<Ordering> {
        let (g, doubt, rate) = self.difference(direction, root)?;
        if g > doubt && self.side == Ordering::Greater {
            let slope = ldexp(rate.value.near() - rate.doubt, self.scale);
            return (slope + root?.swing > 0.0).then_some(Ordering::Less);
        }
        (g.abs() > doubt).then(|| 0_f64.total_cmp(&g))
    }

    /// Returns g, the bound of its error, and e.d.
    pub(crate) fn difference<T: Number>(
        &self,
        direction: &DirectionTerms<T>,
        root: Option<SureRoot<T>>,
    ) -> Option<(f64, f64, Rate<T>)> {
        // The error of e is its rounding.
        let direction = DirectionTerms { doubt: direction.doubt + T::SUM, ..*direction };
        let rate = Rate::new(self.e.map(T::of), self.length, &direction);
        let none = SureRoot { t: T::from(1.0), share: 0.0, swing: 0.0 };
        let SureRoot { t, share, .. } = if self.side == Ordering::Equal { none } else { root? };
        let (c, swing) = (T::of(self.c), rate.value * t);
        let g = (c - (swing + swing)).near();
        let doubt = (self.c_doubt + 2.0 * T::SUM) * c.near().abs()
            + 2.0 * (t.near() * rate.doubt + (share + T::PRODUCT + T::SUM) * swing.near().abs());
        Some((g, 1.05 * doubt + PairOrder::TINY, rate))
    }

    /// Returns a lower bound of `g = C - 2 e.p` over the points p of a box, each of which is known with an
    /// error of up to `off`, including 12 u |p| for the roundings here. At a point where a ray hits a third
    /// sphere (from the origin, in units of the first one), g compares the first and the second sphere:
    /// of several second spheres, one with a larger g is hit later.
    #[inline(always)]
    pub(crate) fn least(&self, [low, high]: [Vector<f64>; 2], off: f64) -> f64 {
        let [x, y, z] = std::array::from_fn(|i| {
            let e = self.e[i].hi;
            (e * low[i]).max(e * high[i])
        });
        self.c.hi - 2.0 * (x + y + z) - self.slack(off)
    }

    /// Returns the bound of the error of `C - 2 e.p`, see [`PairOrder::least`].
    #[inline(always)]
    pub(crate) fn slack(&self, off: f64) -> f64 {
        let doubt = (self.c_doubt + 4.0 * UNIT) * self.c.hi.abs() + 2.0 * self.length * off;
        1.05 * doubt + PairOrder::TINY
    }

    /// Returns `|e|` in units of the first sphere; 0 if no chord's middle matters, because the origin is
    /// not outside the spheres.
    #[inline(always)]
    pub(crate) fn apart(&self) -> f64 {
        match (self.side, self.scale) {
            (Ordering::Greater, 0) => self.length,
            (Ordering::Greater, scale) => ldexp(self.length, scale),
            _ => 0.0,
        }
    }
}
