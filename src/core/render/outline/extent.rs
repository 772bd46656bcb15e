//! Which pixels of a raster a sphere can cover.

use std::ops::Range;

use crate::camera::resolved::PosedCamera;
use crate::render::frame::Raster;
use crate::render::outline::bounds::{Bounds, PixelBounds};
use crate::scene::sphere::Sphere;

/// Rows and columns of a raster, not of the image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    rows: [u16; 2],
    columns: [u16; 2],
}

impl Extent {
    pub(crate) fn rows(&self) -> Range<usize> {
        usize::from(self.rows[0])..usize::from(self.rows[1])
    }

    pub(crate) fn columns(&self) -> Range<usize> {
        usize::from(self.columns[0])..usize::from(self.columns[1])
    }
}

/// The extents of all spheres of a frame.
pub(crate) struct Extents<'a> {
    bounds: Bounds<'a>,
    raster: &'a Raster,
}

impl<'a> Extents<'a> {
    pub(crate) fn new(camera: &'a PosedCamera, raster: &'a Raster) -> Extents<'a> {
        Extents { bounds: Bounds::new(camera), raster }
    }

    /// `None` for a sphere that covers no pixel of the raster.
    pub(crate) fn of(&self, sphere: &Sphere) -> Option<Extent> {
        let part_of = |cells: &Range<u32>, of: &[u32]| {
            let place = |cell: u32| of.partition_point(|x| *x < cell) as u16;
            [place(cells.start), place(cells.end)]
        };
        let PixelBounds { rows, columns } = self.bounds.of(sphere)?;
        let (rows, columns) =
            (part_of(&rows, self.raster.rows()), part_of(&columns, self.raster.columns()));
        let is_seen = rows[0] < rows[1] && columns[0] < columns[1];
        is_seen.then_some(Extent { rows, columns })
    }
}
