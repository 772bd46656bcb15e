//! A ray's line against boxes: which of them it surely passes by.

use crate::camera::exact_ray::ExactRay;
use crate::exact::bounded::Vector;

/// The whole line of a ray, roughly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    origin: [f64; 3],
    /// A direction of any length that is neither near 0 nor near infinity.
    direction: Vector<f64>,
    /// Error bound of a cross product with the direction, as a share of the other's size.
    doubt: f64,
}

impl Line {
    pub(crate) fn from_ray(ray: &ExactRay) -> Line {
        let rough = &ray.rough;
        let doubt = rough.length * (Line::DOUBT + 4.0 * rough.doubt);
        Line { origin: ray.origin().to_array(), direction: rough.d, doubt }
    }

    /// Returns whether the line may meet the box `middle +- half`. Of one that it does meet, always.
    ///
    /// With q from the line's origin to the middle, the box seen along the line is a hexagon whose
    /// sides have the normals `e_i x d`. It lies to one side of the line where, on one of them,
    ///
    /// ```text
    /// |(q x d)_i| > h_j |d_k| + h_k |d_j|
    /// ```
    ///
    /// Either side is off by less than 16 u of `|d| (|q|_1 + |h|_1)`, for two products and a sum, and
    /// q rounded once; and by as much of it as d is in doubt. [`Line::DOUBT`] is far more than 16 u,
    /// as boxes that are nearly met cost no more than those that are. What underflows is below the
    /// smallest normal number; what overflows decides nothing.
    pub(crate) fn may_meet(&self, middle: [f64; 3], half: [f64; 3]) -> bool {
        let d = self.direction;
        let q: [f64; 3] = std::array::from_fn(|i| middle[i] - self.origin[i]);
        let size: f64 = (0..3).map(|i| q[i].abs() + half[i]).sum();
        let doubt = self.doubt * size + f64::MIN_POSITIVE;
        let is_beside = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let off = (q[j] * d[k] - q[k] * d[j]).abs();
            off.is_finite() && off > half[j] * d[k].abs() + half[k] * d[j].abs() + doubt
        };
        !(0..3).any(is_beside)
    }

    /// Share of `|d| (|q|_1 + |h|_1)` by which a box may be off and still be taken for met.
    const DOUBT: f64 = 1e-12;
}
