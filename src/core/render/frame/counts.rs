//! Counts of what a frame left out, and of what was left to do.

use std::ops::{Add, AddAssign};

/// Counts of how much of a scene a frame had to look at. Rows and columns are those of the traced
/// raster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// Spheres of the scene.
    pub spheres: u64,
    /// Spheres dropped because they lie wholly behind the eye.
    pub behind: u64,
    /// Spheres dropped because they lie beside the picture, or between two of its rows.
    pub outside: u64,
    /// The other spheres, whether or not anything hides them.
    pub in_view: u64,
    /// Times that a band of rows passed over a sphere because nearer ones hide all of it there. Which
    /// are hidden when their turn comes depends on the order of drawing, and that on the width of the
    /// processor's vectors; the picture does not.
    pub hidden: u64,
    /// Rows of the picture.
    pub rows: u64,
    /// Rows that the bounds of no object's outline reach: background only.
    pub rows_untouched: u64,
}

impl Add for Counts {
    type Output = Counts;

    fn add(self, other: Counts) -> Counts {
        Counts {
            spheres: self.spheres + other.spheres,
            behind: self.behind + other.behind,
            outside: self.outside + other.outside,
            in_view: self.in_view + other.in_view,
            hidden: self.hidden + other.hidden,
            rows: self.rows + other.rows,
            rows_untouched: self.rows_untouched + other.rows_untouched,
        }
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Counts) {
        *self = *self + other;
    }
}
