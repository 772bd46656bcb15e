//! Sums and products together with their rounding error, and what they give: dot products as if in
//! twice the precision.

use glam::DVec3;

/// `(s, e)` with `s = fl(a + b)` and `a + b = s + e` exactly, unless the sum overflows (Knuth, *The
/// Art of Computer Programming* vol. 2, section 4.2.2, theorem B).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// `(d, e)` with `d = fl(a - b)` and `a - b = d + e` exactly, of each coordinate: [`two_sum`].
fn two_difference(a: DVec3, b: DVec3) -> (DVec3, DVec3) {
    let (x, y, z) = (two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z));
    (DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1))
}

/// `(d, e, k)` with `a - b = (d + e) * 2^k` and `d` rounded, of finite vectors: `k` is 0 unless the
/// difference overflows.
pub(crate) fn difference_with_rest(a: DVec3, b: DVec3) -> (DVec3, DVec3, i32) {
    let (shrink, k) = if (a - b).is_finite() { (1.0, 0) } else { (0.25, 2) };
    let (difference, rest) = two_difference(shrink * a, shrink * b);
    (difference, rest, k)
}

/// `(p, e)` with `p = fl(a * b)` and `a * b = p + e` exactly, for factors below 2^996 and products
/// of at least 2^-969 (Dekker, *A floating-point technique for extending the available precision*,
/// Numerische Mathematik 18, 1971; plain operations, so that every processor gives the same bits at
/// the same cost).
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, error)
}

/// Veltkamp's splitting of `x` into two halves of at most 26 bits each.
fn halves(x: f64) -> (f64, f64) {
    const SPLITTER: f64 = (1_u32 << 27) as f64 + 1.0;
    let shifted = SPLITTER * x;
    let high = shifted - (shifted - x);
    (high, x - high)
}

/// `sum of a*b + small`, as if computed in twice the precision and then rounded: the error is below
/// `ulp + 1e-30 * sum |a*b|`, where `small` is a correction far below the sum of `|a*b|` (Ogita,
/// Rump, Oishi, *Accurate sum and dot product*, SIAM J. Sci. Comput. 26, 2005, algorithm 5.3). The
/// range is that of [`two_product`].
pub(crate) fn dot2<const N: usize>(factors: [(f64, f64); N], small: f64) -> f64 {
    let (mut sum, mut error) = (0.0, small);
    for (a, b) in factors {
        let (product, product_error) = two_product(a, b);
        let (next, sum_error) = two_sum(sum, product);
        sum = next;
        error += product_error + sum_error;
    }
    sum + error
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use dashu_float::FBig;
    use dashu_float::round::mode::HalfEven;
    use proptest::prelude::*;

    use super::*;

    fn big(x: f64) -> FBig<HalfEven, 2> {
        FBig::try_from(x).unwrap().with_precision(5000).value()
    }

    /// Any bits, with an exponent between -400 and 400.
    fn number() -> impl Strategy<Value = f64> {
        (any::<u64>(), -400..400_i32).prop_map(|(bits, exponent)| {
            let mantissa = f64::from_bits(bits & !(0x7ff << 52) | (1023 << 52));
            mantissa * 2_f64.powi(exponent)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..Default::default() })]

        #[test]
        fn sums_are_exact(a in number(), b in number(), close in any::<bool>()) {
            let b = if close { a * 1e-9 + b * 1e-200 } else { b };
            let (sum, error) = two_sum(a, b);
            prop_assert_eq!(sum, a + b);
            prop_assert_eq!(big(sum) + big(error), big(a) + big(b));
        }

        #[test]
        fn products_are_exact(a in number(), b in number()) {
            let (product, error) = two_product(a, b);
            prop_assert_eq!(product, a * b);
            prop_assert_eq!(big(product) + big(error), big(a) * big(b));
        }

        /// Terms that cancel to the last digit leave what exact arithmetic leaves.
        #[test]
        fn dot_products_that_cancel(a in 1.0..2.0_f64, b in 1.0..2.0_f64, c in 1.0..2.0_f64, d in 1.0..2.0_f64) {
            let small = 1e-25;
            let factors = [(a, b), (c, d), (-a, b), (-c, d)];
            prop_assert!((dot2(factors, small) - small).abs() <= 1e-30);
            let exact = big(a) * big(b) - big(c) * big(d);
            let found = dot2([(a, b), (-c, d)], 0.0);
            let error = (big(found) - exact.clone()).to_f64().value().abs();
            let size = exact.to_f64().value().abs();
            prop_assert!(error <= f64::EPSILON * size + 1e-30, "{error:e}");
        }
    }
}
