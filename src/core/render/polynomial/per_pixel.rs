//! Spheres of a few pixels, each of which is asked by itself, in `f64`.

use crate::exact::quadratic::{Quadratic, SphereParts};
use crate::render::frame::depth::{DOUBT, Depth};

/// `t` where a ray surely hits a sphere, seen from outside, before what is known; infinite where it
/// surely does not; NaN in doubt.
#[inline(always)]
pub(crate) fn small_hit<T: Depth>(
    quadratic: &Quadratic<f64>,
    parts: &SphereParts<f64>,
    factor: f64,
    known: T,
) -> f64 {
    /// Far more than `t` in `f64` is off by where its doubt is this small.
    const APART: f64 = 1e-6;
    let Quadratic { b, discriminant, b_doubt, discriminant_doubt, .. } = *quadratic;
    if discriminant < -discriminant_doubt || b < -b_doubt {
        return f64::INFINITY;
    }
    let Some((t, doubt)) = quadratic.root(parts, false) else { return DOUBT };
    let (t, known) = (t * factor, known.widened());
    if b <= b_doubt || doubt > APART {
        return DOUBT;
    }
    if t > known * (1.0 + 4.0 * APART) {
        return f64::INFINITY;
    }
    let is_sure = doubt <= T::DOUBT && t < known * (1.0 - 4.0 * APART) && T::is_in_range(t);
    if is_sure { t } else { DOUBT }
}
