//! Spheres of a few pixels, each of which is asked by itself, in `f64`.

use crate::exact::quadratic::{Quadratic, SphereTerms};
use crate::render::polynomial::blend::{DOUBT, RANGE, T_SHARE, is_in_range};

/// `t` where a ray surely hits a sphere, seen from outside, before what is known; infinite where it
/// surely does not; NaN in doubt.
#[inline(always)]
pub(crate) fn pixel_hit(
    quadratic: &Quadratic<f64>,
    parts: &SphereTerms<f64>,
    factor: f64,
    known: f32,
) -> f64 {
    /// Share by which two `t` are apart for sure: far more than one in `f64` is off by.
    const APART: f64 = 1e-6;
    let Quadratic { b, discriminant, b_doubt, discriminant_doubt, .. } = *quadratic;
    if discriminant < -discriminant_doubt || b < -b_doubt {
        return f64::INFINITY;
    }
    let Some((t, doubt)) = quadratic.root(parts, false) else {
        return DOUBT;
    };
    let (t, known) = (t * factor, f64::from(known));
    if b <= b_doubt || doubt > APART {
        return DOUBT;
    }
    // What is known may have been rounded to a subnormal number, of which any share may be its error.
    if t > known.max(RANGE.0.into()) * (1.0 + 4.0 * APART) {
        return f64::INFINITY;
    }
    let is_sure = doubt <= T_SHARE && t < known * (1.0 - 4.0 * APART) && is_in_range(t);
    if is_sure { t } else { DOUBT }
}
