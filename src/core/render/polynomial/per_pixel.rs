//! Spheres of a few pixels, each of which is asked by itself, in `f64`.

use std::ops::Range;

use crate::exact::quadratic::{Quadratic, SphereParts};
use crate::render::frame::depth::Depth;
use crate::render::polynomial::kernel::DOUBT;
use crate::render::row_band::Band;

impl<T: Depth> Band<'_, T> {
    /// Adds a sphere that covers too few pixels to be worth polynomials: each pixel's ray is asked by
    /// itself, in `f64`.
    pub(crate) fn add_small_sphere(
        &mut self,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        parts: &SphereParts<f64>,
        factor: f64,
    ) {
        let rays = &self.plan.rays;
        let width = rays.n.len();
        let mut own = None;
        for row in rows {
            self.steps.f64 += columns.len() as u64;
            for column in columns.clone() {
                let quadratic = Quadratic::new(parts, &rays.rough_direction(row, column));
                let place = (row - self.rows.start) * width + column;
                let found = small_hit::<T>(&quadratic, parts, factor, self.t[place]);
                if found.is_nan() {
                    let seen = own.get_or_insert_with(|| self.seen(index));
                    self.settle(index, seen, row, column);
                } else if found < f64::INFINITY {
                    (self.t[place], self.object[place]) = (T::of(found), index);
                }
            }
        }
    }
}

/// `t` where a ray surely hits a sphere, seen from outside, before what is known; infinite where it
/// surely does not; NaN in doubt.
#[inline(always)]
fn small_hit<T: Depth>(
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
