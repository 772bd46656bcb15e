//! Scaling by powers of two, which is exact and avoids overflow and underflow in lengths, cross products
//! and discriminants. Also formats numbers as the shortest text that reads back to the same number.

use glam::DVec3;

/// Range of a squared length in which neither the length nor its reciprocal overflows or loses digits to
/// underflow.
pub(crate) const PLAIN_LENGTH_SQUARED: std::ops::Range<f64> = 1e-200..1e200;

/// Returns whether the direction's squared length is far enough from 0 and infinity for an intersection
/// to neither overflow nor underflow.
pub(crate) fn is_plain_direction(direction: DVec3) -> bool {
    (1e-120..1e120).contains(&direction.length_squared())
}

/// Returns `2^k` for k from -1022 to 1023.
fn power_of_two(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// Returns `floor(log2 |x|)` for finite `x != 0`, subnormal numbers included.
pub(crate) fn exponent(x: f64) -> i32 {
    const SUBNORMAL_LIFT: i32 = 64;
    let biased = |x: f64| ((x.to_bits() >> 52) & 0x7ff) as i32;
    match biased(x) {
        0 => biased(x * power_of_two(SUBNORMAL_LIFT)) - 1023 - SUBNORMAL_LIFT,
        e => e - 1023,
    }
}

/// Returns `x * 2^k` for any `k`, rounded once; exact unless the result overflows or is subnormal.
pub(crate) fn ldexp(x: f64, k: i32) -> f64 {
    // 2^k may be beyond the range of f64, so it is split into several factors. Downwards, each factor
    // but the last leaves 53 bits of room above the smallest exponent. Digits are then lost before the
    // last step only if the result is below half the smallest number, and so 0 anyway.
    const UP: i32 = 1023;
    const DOWN: i32 = -1022 + 53;
    let (mut x, mut k) = (x, k.clamp(-4000, 4000));
    while k > UP {
        x *= power_of_two(UP);
        k -= UP;
    }
    while k < -1022 {
        x *= power_of_two(DOWN);
        k -= DOWN;
    }
    x * power_of_two(k)
}

/// Returns `v * 2^k`.
pub(crate) fn ldexp3(v: DVec3, k: i32) -> DVec3 {
    DVec3::new(ldexp(v.x, k), ldexp(v.y, k), ldexp(v.z, k))
}

/// Splits a finite, non-zero `v` into `(m, k)` with `v = m * 2^k` and the largest `|m_i|` in `[1, 2)`. A
/// coordinate more than 2^1000 times smaller than the largest loses digits.
pub(crate) fn split(v: DVec3) -> (DVec3, i32) {
    let k = exponent(v.abs().max_element());
    (ldexp3(v, -k), k)
}

/// Returns `v / |v|` for any finite, non-zero `v`, however long or short.
pub fn unit(v: DVec3) -> DVec3 {
    if PLAIN_LENGTH_SQUARED.contains(&v.length_squared()) {
        // This gives the same bits as the code below: powers of two cancel in the quotient.
        return v / v.length();
    }
    let (m, _) = split(v);
    m / m.length()
}

/// Returns `|v|`, without intermediate overflow or underflow.
pub fn length(v: DVec3) -> f64 {
    let squared = v.length_squared();
    if PLAIN_LENGTH_SQUARED.contains(&squared) || v == DVec3::ZERO || !v.is_finite() {
        return squared.sqrt();
    }
    let (m, k) = split(v);
    ldexp(m.length(), k)
}

/// Returns the angle between two unit vectors in radians, accurate even for small angles.
pub(crate) fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Returns the shortest decimal that reads back to the same `f64`: `1`, `0.1`, `1e300`.
///
/// Unlike `{}`, it never prints hundreds of zeros; unlike `{:?}`, it prints no trailing `.0`. Negative
/// zero is printed as `0`.
pub fn shortest(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{x:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// Formats a point or direction as `(1, 2, 3)`.
pub fn triple(p: DVec3) -> String {
    format!("({}, {}, {})", shortest(p.x), shortest(p.y), shortest(p.z))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::test_seed::config;

    /// Computes `x * 2^k`, rounded to nearest, ties to even, in integer arithmetic on the mantissa m of
    /// `|x| = m * 2^e`.
    fn by_integers(x: f64, k: i32) -> f64 {
        let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
        let fraction = x.to_bits() & ((1 << 52) - 1);
        let m = if biased == 0 { fraction } else { fraction | 1 << 52 };
        // In units of the smallest number, 2^-1074: m * 2^shift.
        let shift = biased.max(1) - 1 + k;
        let sign = if x.is_sign_negative() { -1.0 } else { 1.0 };
        if shift < 0 {
            let (m, down) = (u128::from(m), (-shift).min(100) as u32);
            let (whole, rest, half) = (m >> down, m & ((1 << down) - 1), 1_u128 << (down - 1));
            let up = rest > half || (rest == half && whole & 1 == 1);
            return sign * f64::from_bits((whole + u128::from(up)) as u64);
        }
        // A number of at most 53 bits, times 2^shift of those units.
        let leading = 63 - m.leading_zeros() as i32;
        let result_exponent = leading + shift;
        if result_exponent < 53 {
            return sign * f64::from_bits(m << shift);
        }
        if result_exponent - 52 > 2045 {
            return sign * f64::INFINITY;
        }
        let fraction = (m << (52 - leading)) & ((1 << 52) - 1);
        sign * f64::from_bits(((result_exponent - 51) as u64) << 52 | fraction)
    }

    #[test]
    fn just_above_half_the_smallest_number_rounds_up() {
        assert_eq!(ldexp(-(1.0 + f64::EPSILON), -1075), -5e-324);
        assert_eq!(ldexp(1.0, -1075), 0.0);
        assert_eq!(by_integers(1.5, -1075), 5e-324);
        assert_eq!(by_integers(f64::MAX, 1), f64::INFINITY);
    }

    proptest! {
        #![proptest_config(config(256))]

        /// Checks that `ldexp` rounds once, also where the result is subnormal.
        #[test]
        fn ldexp_rounds_once(bits in any::<u64>(), to in -1080..1025_i32, far in -2100..2100_i32) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite() && x != 0.0);
            // Half of the values of k lead to a result that is an ordinary or a subnormal number.
            for k in [far, to - exponent(x)] {
                prop_assert_eq!(ldexp(x, k).to_bits(), by_integers(x, k).to_bits());
            }
        }

        #[test]
        fn exponent_is_that_of_the_leading_bit(bits in any::<u64>()) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite() && x != 0.0);
            let mantissa = ldexp(x, -exponent(x)).abs();
            prop_assert!((1.0..2.0).contains(&mantissa), "{mantissa}");
        }
    }
}
