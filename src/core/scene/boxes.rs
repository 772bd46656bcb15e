//! Axis-aligned boxes around spheres.

use crate::scene::sphere::Sphere;

/// One box with what is known of the spheres inside.
///
/// On each axis the box is `middle - half ..= middle + half`, in real numbers and rounded alike: what
/// is inside lies between the two whichever way they are computed. A half extent is infinite where
/// it is beyond the range of `f64`; nothing else is but the sum of squares, and nothing is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bound {
    pub(crate) middle: [f64; 3],
    pub(crate) half: [f64; 3],
    /// The sum of r^2 of the spheres inside.
    pub(crate) area: f64,
    /// The largest r of the spheres inside.
    pub(crate) radius: f64,
    /// Number of spheres inside.
    pub(crate) count: u32,
}

impl Bound {
    /// A box with nothing inside.
    pub(crate) const EMPTY: Bound =
        Bound { middle: [0.0; 3], half: [0.0; 3], area: 0.0, radius: 0.0, count: 0 };

    /// The box of a sphere, not rounded outward: for [`Bound::around`].
    pub(crate) fn of_sphere(sphere: &Sphere) -> Bound {
        let Sphere { center, radius } = *sphere;
        let (middle, half) = (center.to_array(), [radius; 3]);
        Bound { middle, half, area: radius * radius, radius, count: 1 }
    }

    /// The box around all of these.
    pub(crate) fn around(boxes: impl Iterator<Item = Bound>) -> Bound {
        let mut all = Bound::EMPTY;
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for bound in boxes {
            for axis in 0..3 {
                low[axis] = low[axis].min(bound.middle[axis] - bound.half[axis]);
                high[axis] = high[axis].max(bound.middle[axis] + bound.half[axis]);
            }
            all.area += bound.area;
            all.radius = all.radius.max(bound.radius);
            all.count += bound.count;
        }
        if all.count > 0 {
            for axis in 0..3 {
                // Each was rounded once: the next number beyond is outside.
                let ends = (low[axis].next_down(), high[axis].next_up());
                (all.middle[axis], all.half[axis]) = middle_and_half(ends);
            }
        }
        all
    }
}

/// `(middle, half)` with `middle - half <= low` and `high <= middle + half`.
fn middle_and_half((low, high): (f64, f64)) -> (f64, f64) {
    // Halved before the sum, which then cannot overflow.
    let middle = 0.5 * low.max(f64::MIN) + 0.5 * high.min(f64::MAX);
    (middle, (high - middle).max(middle - low).next_up())
}
