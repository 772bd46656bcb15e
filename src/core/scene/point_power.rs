//! The power of a point with respect to a sphere, `|q|^2 - r^2`, with its exact sign.

use std::cmp::Ordering;

use glam::DVec3;

use crate::exact::bounded::{Number, UNIT, dot};
use crate::exact::double_double::{DoubleDouble, U2};
use crate::exact::precise::Precise;
use crate::exact::steps::{Step, sign_of};
use crate::scene::big_roots::big_c;
use crate::scene::sphere::Sphere;

/// Share of `|q|^2 + r^2` beyond which `f64` knows c's sign: 6 roundings, and one of q itself, twice.
pub(crate) const ROUGH_SHARE: f64 = 8.0 * UNIT;

/// Error of c in double-double, as a share of `|q|^2 + r^2`: r^2 is exact.
pub(crate) const FINE_SHARE: f64 = DoubleDouble::DOT + DoubleDouble::SUM;

/// `c = |q|^2 - r^2` with its exact sign.
pub(crate) struct PointPower {
    pub(crate) value: DoubleDouble,
    /// Relative error.
    pub(crate) doubt: f64,
    /// All digits of a value that is too small for sums and products of it to keep them.
    pub(crate) tiny: Option<Precise>,
    pub(crate) sign: Ordering,
    /// The step that knew the sign.
    pub(crate) step: Step,
}

impl PointPower {
    /// Computes it of q and r in units of `2^scale`: in double-double where that keeps its digits,
    /// else from the exact number: close to the sphere c is all that is left of large squares.
    pub(crate) fn new(
        sphere: &Sphere,
        origin: DVec3,
        q: [DoubleDouble; 3],
        radius: f64,
        scale: i32,
    ) -> PointPower {
        /// The share of error beyond which t would lose digits for c's sake.
        const PLENTY: f64 = 256.0 * U2;
        /// Whatever is larger loses no digits to underflow.
        const TINY: f64 = 1e-200;
        let fine_radius = DoubleDouble::from(radius);
        let (qq, rr) = (dot(q, q), fine_radius * fine_radius);
        let value = qq - rr;
        let squares = qq.hi + rr.hi;
        let doubt = FINE_SHARE * squares / value.hi.abs();
        let is_sure = value.hi.abs() > ROUGH_SHARE * squares && value.hi.abs() > TINY;
        let step = if is_sure { Step::F64 } else { Step::DoubleDouble };
        if doubt <= PLENTY && value.hi.abs() > TINY {
            return PointPower {
                value,
                doubt: 1.05 * doubt,
                tiny: None,
                sign: sign_of(value.hi),
                step,
            };
        }
        let exact = big_c(sphere, origin);
        // c may need the exact number where its sign does not.
        let step = if doubt < 0.5 && value.hi.abs() > TINY { step } else { Step::Exact };
        let sign = exact.sign();
        let (mantissa, k) = exact.to_double_double();
        let k = k - 2 * scale;
        let value = mantissa.scaled(k);
        if sign == Ordering::Equal || value.hi.abs() > TINY {
            return PointPower { value, doubt: 2.0 * U2, tiny: None, sign, step };
        }
        // D has room for an error of all of it.
        PointPower { value, doubt: 1.0, tiny: Some(Precise::new(mantissa, k)), sign, step }
    }
}
