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
    /// Planes of the scene.
    pub planes: u64,
    /// Planes asked: none that is the same as an earlier one.
    pub planes_asked: u64,
    /// Blocks of spheres in the scene's index; 0 where the scene is so small that none is built.
    pub blocks: u64,
    /// Blocks of which no sphere was looked at: behind the eye or beside the picture.
    pub blocks_left_out: u64,
    /// Bands of rows that threads trace on their own.
    pub bands: u64,
    /// Bands that no object reaches: background only.
    pub bands_untouched: u64,
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
            planes: self.planes + other.planes,
            planes_asked: self.planes_asked + other.planes_asked,
            blocks: self.blocks + other.blocks,
            blocks_left_out: self.blocks_left_out + other.blocks_left_out,
            bands: self.bands + other.bands,
            bands_untouched: self.bands_untouched + other.bands_untouched,
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
