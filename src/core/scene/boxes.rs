//! Axis-aligned boxes around spheres, side by side, so that several are looked at together.

/// Maximum number of boxes that are loaded at once; see [`Boxes`].
pub(crate) const BOX_LANES: usize = 8;

/// Boxes, array by array. There is always a whole number of [`BOX_LANES`]; a box that is only there
/// to fill up has count 0, and zeros everywhere.
///
/// On each axis the box is `middle - half ..= middle + half`, in real numbers and rounded alike: what
/// is inside lies between the two whichever way they are computed. A half extent is infinite where
/// it is beyond the range of `f64`; nothing else is but the sum of squares, and nothing is NaN.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Boxes {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) z: Vec<f64>,
    pub(crate) half_x: Vec<f64>,
    pub(crate) half_y: Vec<f64>,
    pub(crate) half_z: Vec<f64>,
    /// The sum of r^2 of the spheres inside.
    pub(crate) area: Vec<f64>,
    /// The largest r of the spheres inside.
    pub(crate) radius: Vec<f64>,
    /// Number of spheres inside.
    pub(crate) count: Vec<u32>,
}

/// One box with what is known of the spheres inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bound {
    pub(crate) middle: [f64; 3],
    pub(crate) half: [f64; 3],
    pub(crate) area: f64,
    pub(crate) radius: f64,
    pub(crate) count: u32,
}

impl Bound {
    /// A box with nothing inside.
    pub(crate) const EMPTY: Bound =
        Bound { middle: [0.0; 3], half: [0.0; 3], area: 0.0, radius: 0.0, count: 0 };

    /// The box of a sphere, not rounded outward: for [`Bound::around`].
    pub(crate) fn of_sphere(middle: [f64; 3], radius: f64) -> Bound {
        Bound { middle, half: [radius; 3], area: radius * radius, radius, count: 1 }
    }

    /// The box around all of these; empty ones do not count.
    pub(crate) fn around(parts: impl Iterator<Item = Bound>) -> Bound {
        let mut all = Bound::EMPTY;
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for part in parts.filter(|part| part.count > 0) {
            for axis in 0..3 {
                low[axis] = low[axis].min(part.middle[axis] - part.half[axis]);
                high[axis] = high[axis].max(part.middle[axis] + part.half[axis]);
            }
            all.area += part.area;
            all.radius = all.radius.max(part.radius);
            all.count += part.count;
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

impl Boxes {
    /// These boxes, filled up to a whole number of [`BOX_LANES`].
    pub(crate) fn new(bounds: &[Bound]) -> Boxes {
        let count = bounds.len().next_multiple_of(BOX_LANES);
        let values = |part: fn(&Bound) -> f64| -> Vec<f64> {
            let mut values = Vec::with_capacity(count);
            values.extend(bounds.iter().map(part));
            values.resize(count, 0.0);
            values
        };
        let mut counts = Vec::with_capacity(count);
        counts.extend(bounds.iter().map(|bound| bound.count));
        counts.resize(count, 0);
        Boxes {
            x: values(|bound| bound.middle[0]),
            y: values(|bound| bound.middle[1]),
            z: values(|bound| bound.middle[2]),
            half_x: values(|bound| bound.half[0]),
            half_y: values(|bound| bound.half[1]),
            half_z: values(|bound| bound.half[2]),
            area: values(|bound| bound.area),
            radius: values(|bound| bound.radius),
            count: counts,
        }
    }

    /// Number of boxes, with those that only fill up.
    pub(crate) fn len(&self) -> usize {
        self.count.len()
    }

    pub(crate) fn get(&self, index: usize) -> Bound {
        Bound {
            middle: [self.x[index], self.y[index], self.z[index]],
            half: [self.half_x[index], self.half_y[index], self.half_z[index]],
            area: self.area[index],
            radius: self.radius[index],
            count: self.count[index],
        }
    }

    pub(crate) fn set(&mut self, index: usize, bound: Bound) {
        [self.x[index], self.y[index], self.z[index]] = bound.middle;
        [self.half_x[index], self.half_y[index], self.half_z[index]] = bound.half;
        self.area[index] = bound.area;
        self.radius[index] = bound.radius;
        self.count[index] = bound.count;
    }
}
