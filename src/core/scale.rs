//! Scaling by powers of two: exact, and it removes every overflow and underflow from a length, a
//! cross product or a discriminant.

use glam::DVec3;

/// `floor(log2 |x|)` for finite `x != 0`, subnormal numbers included.
pub(crate) fn exponent(x: f64) -> i32 {
    const SUBNORMAL_LIFT: i32 = 64;
    let biased = |x: f64| ((x.to_bits() >> 52) & 0x7ff) as i32;
    match biased(x) {
        0 => biased(x * 2f64.powi(SUBNORMAL_LIFT)) - 1023 - SUBNORMAL_LIFT,
        e => e - 1023,
    }
}

/// `x * 2^k` for any `k`, exact unless the result overflows or is subnormal.
pub(crate) fn ldexp(x: f64, k: i32) -> f64 {
    // One factor 2^k alone may not be representable; no f64 is left after +-2200.
    const STEP: i32 = 1000;
    let power_of_two = |k: i32| f64::from_bits(((1023 + k) as u64) << 52);
    let (mut x, mut k) = (x, k.clamp(-2200, 2200));
    while k.abs() > STEP {
        let step = STEP * k.signum();
        x *= power_of_two(step);
        k -= step;
    }
    x * power_of_two(k)
}

/// `v * 2^k`.
pub(crate) fn ldexp3(v: DVec3, k: i32) -> DVec3 {
    DVec3::new(ldexp(v.x, k), ldexp(v.y, k), ldexp(v.z, k))
}

/// Splits a finite, non-zero `v` into `(m, k)` with `v = m * 2^k` and the largest `|m_i|` in `[1, 2)`.
pub(crate) fn split(v: DVec3) -> (DVec3, i32) {
    let k = exponent(v.abs().max_element());
    (ldexp3(v, -k), k)
}

/// `v / |v|` for any finite, non-zero `v`, of length 1e-300 or 1e300 alike.
pub(crate) fn unit(v: DVec3) -> DVec3 {
    let (m, _) = split(v);
    m / m.length()
}

/// `|v|`, free of intermediate overflow and underflow.
pub(crate) fn length(v: DVec3) -> f64 {
    if v == DVec3::ZERO || !v.is_finite() {
        return v.length();
    }
    let (m, k) = split(v);
    ldexp(m.length(), k)
}

/// `a*b - c*d` with a relative error of at most 1.5 ulp, and so zero only where it is exactly zero
/// (as long as nothing underflows): Kahan's form, proven in Jeannerod, Louvet, Muller, *Further
/// analysis of Kahan's algorithm for the accurate computation of 2x2 determinants*, Math. Comp. 82
/// (2013).
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let error = (-c).mul_add(d, cd);
    a.mul_add(b, -cd) + error
}

/// `a x b`, each component by [`difference_of_products`].
pub(crate) fn accurate_cross(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(
        difference_of_products(a.y, b.z, a.z, b.y),
        difference_of_products(a.z, b.x, a.x, b.z),
        difference_of_products(a.x, b.y, a.y, b.x),
    )
}
