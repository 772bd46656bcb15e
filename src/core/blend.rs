//! A row's answers into the frame's buffers, nearest first.

use fearless_simd::Simd;

use crate::frame::Depth;

/// Takes over what is nearer than what is there, and tells whether anything is in doubt: afterwards
/// `found` is NaN there. In doubt are a `t` that the kernel could not give, one beyond the range
/// of T, and two that are closer than their rounding.
#[inline(always)]
pub(crate) fn blend<S: Simd, T: Depth>(
    _: S,
    found: &mut [f64],
    t: &mut [T],
    object: &mut [u32],
    index: u32,
) -> bool {
    let mut any = false;
    for ((found, t), object) in found.iter_mut().zip(t).zip(object) {
        let (x, known) = (*found, t.widened());
        let is_sure = x == f64::INFINITY || (T::is_in_range(x) && (x - known).abs() > T::TIE * x);
        let is_nearer = is_sure && x < known;
        *t = if is_nearer { T::of(x) } else { *t };
        *object = if is_nearer { index } else { *object };
        *found = if is_sure { 0.0 } else { f64::NAN };
        any |= !is_sure;
    }
    any
}
