//! Draws the objects that are not drawn by rows: spheres that are near or large, and planes. Their
//! equations are polynomials in rows and columns.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::exact::quadratic::{Quadratic, SphereTerms};

pub(crate) mod conic;
pub(crate) mod frame_rays;
pub(crate) mod object_kernel;

/// Marks a miss in a kernel's answers.
pub(crate) const MISS: f64 = f64::INFINITY;

/// Marks a pixel that a kernel cannot decide: the ladder decides it individually.
pub(crate) const DOUBT: f64 = f64::NAN;

/// Maximum relative error of the `t` that a kernel (an object's polynomials) computes. An error of 2^-27
/// is at most a quarter of an ulp of `f32`, and rounding to `f32` adds half an ulp.
pub(crate) const T_SHARE: f64 = 1.0 / (1_u64 << 27) as f64;

/// The range of `t` in a frame. It is so much smaller than the range of `f32` that values computed from
/// `t` stay within the range of `f32`, too.
pub(crate) const RANGE: (f32, f32) = (1e-37, 1e38);

/// Relative difference below which rounding may have put two `t` in the wrong order.
const TIE: f32 = 4.0 * f32::EPSILON;

/// Returns the nearest `f32`: infinity if `t` is too large, and the smallest positive number if it
/// is too small.
#[inline(always)]
pub(crate) fn to_single(t: f64) -> f32 {
    (t as f32).max(f32::from_bits(1))
}

/// Returns whether `t` is well within the range of `f32`.
#[inline(always)]
pub(crate) fn is_in_range(t: f64) -> bool {
    t > RANGE.0.into() && t < RANGE.1.into()
}

/// Writes the pixels in which the object's hits `found` are nearer than the known hits. Returns whether
/// any pixel [is in doubt](is_in_doubt); such pixels stay unchanged.
#[inline(always)]
pub(crate) fn blend<S: Simd>(
    simd: S,
    found: &[f64],
    t: &mut [f32],
    object: &mut [u32],
    index: u32,
) -> bool {
    let n = S::u32s::LEN;
    let whole = t.len() - t.len() % n;
    let mut any = false;
    let rows = t[..whole].chunks_exact_mut(n).zip(object[..whole].chunks_exact_mut(n));
    for (found, (t, object)) in found.chunks_exact(n).zip(rows) {
        any |= blend_vector(simd, found, t, object, index);
    }
    for k in whole..t.len() {
        let x = found[k] as f32;
        let in_doubt = is_in_doubt(found[k], t[k], object[k], index);
        any |= in_doubt;
        if !in_doubt && x < t[k] {
            (t[k], object[k]) = (x, index);
        }
    }
    any
}

/// Returns whether a blended pixel is in doubt: the kernel could not compute its `t`, or `t` is
/// near an end of the range, or `t` and the known hit differ by no more than their rounding errors.
#[inline(always)]
pub(crate) fn is_in_doubt(found: f64, t: f32, object: u32, index: u32) -> bool {
    let x = found as f32;
    let is_plain = (x > RANGE.0) & (x < RANGE.1);
    // A miss is infinite even in f64; a number that becomes infinite only in f32 is not a miss.
    let is_sure = (found == MISS) | (is_plain & ((x - t).abs() > TIE * x));
    // Pixels that were just written hold this t itself.
    !is_sure && object != index
}

/// Blends one SIMD vector of pixels, see [`blend`].
#[inline(always)]
fn blend_vector<S: Simd>(
    simd: S,
    found: &[f64],
    t: &mut [f32],
    object: &mut [u32],
    index: u32,
) -> bool {
    let half = S::f64s::LEN;
    let low = S::f64s::from_slice(simd, &found[..half]);
    let high = S::f64s::from_slice(simd, &found[half..]);
    let miss = S::f64s::splat(simd, MISS);
    let is_miss = low.simd_eq(miss).narrow(high.simd_eq(miss));
    let (x, known) = (low.narrow(high), S::f32s::from_slice(simd, t));
    let tie = x * TIE;
    let is_apart = (x - known).simd_gt(tie) | (known - x).simd_gt(tie);
    let is_plain =
        x.simd_gt(S::f32s::splat(simd, RANGE.0)) & x.simd_lt(S::f32s::splat(simd, RANGE.1));
    let is_sure = is_miss | (is_plain & is_apart);
    let take = is_sure & x.simd_lt(known);
    // Selecting between the new and the stored value would compile to a masked store, which is slow on
    // many processors.
    take.select(x, S::f32s::splat(simd, f32::INFINITY)).min(known).store_slice(t);
    let objects = S::u32s::from_slice(simd, object);
    let change = S::u32s::splat(simd, index) ^ objects;
    (objects ^ take.select(change, S::u32s::splat(simd, 0))).store_slice(object);
    (!is_sure).any_true()
}

/// Returns `t` if a ray from outside surely hits the sphere before the known hit, infinity if it surely
/// does not, and NaN if `f64` cannot decide.
#[inline(always)]
pub(crate) fn pixel_hit(
    quadratic: &Quadratic<f64>,
    parts: &SphereTerms<f64>,
    factor: f64,
    known: f32,
) -> f64 {
    /// Relative difference beyond which two `t` are certainly different: far more than the error of a
    /// `t` in `f64`.
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
    // The known hit may have been rounded to a subnormal number, whose relative error can be large.
    if t > known.max(RANGE.0.into()) * (1.0 + 4.0 * APART) {
        return f64::INFINITY;
    }
    let is_sure = doubt <= T_SHARE && t < known * (1.0 - 4.0 * APART) && is_in_range(t);
    if is_sure { t } else { DOUBT }
}
