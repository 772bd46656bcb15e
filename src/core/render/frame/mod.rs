//! A picture: the first hit of every pixel's view ray.

pub(crate) mod buffers;
pub(crate) mod counts;
pub(crate) mod depth;

use glam::DVec3;

use crate::camera::image::{ImageSize, Pixel};
use crate::camera::resolved::ResolvedCamera;
use crate::exact::steps::Steps;
use crate::render::frame::counts::Counts;

/// [`Frame::object`] where the ray hits nothing.
pub const NO_OBJECT: u32 = u32::MAX;

/// Rows and columns of the image to trace, ascending. A screen smaller than the image shows
/// only some of its pixels; the others need not be traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    rows: Vec<u32>,
    columns: Vec<u32>,
}

/// The outputs to keep of every pixel. What is not asked for is not written: its buffer stays empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// `t` of the first hit.
    pub t: bool,
    /// The object's index.
    pub object: bool,
    /// The outward unit normal there.
    pub normal: bool,
}

impl Outputs {
    /// Steps and counts alone: for a picture of which only the colours are wanted.
    pub const NONE: Outputs = Outputs { t: false, object: false, normal: false };
}

impl Default for Outputs {
    /// `t` and object.
    fn default() -> Outputs {
        Outputs { t: true, object: true, normal: false }
    }
}

/// The traced pixels, row by row, with the camera and raster that they belong to.
///
/// T is what `t` is kept in, `f64` or `f32`. Which pixels are hit, and which object is first, is the
/// same for both: exact.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Frame<T = f64> {
    pub(crate) camera: ResolvedCamera,
    pub(crate) raster: Raster,
    /// `t` of the first hit, rounded; infinite where there is none (or, at an object, where it is
    /// beyond the range of T); empty unless asked for.
    pub t: Vec<T>,
    /// Index of the object hit, or [`NO_OBJECT`]; empty unless asked for.
    pub object: Vec<u32>,
    /// Outward unit normals, zero where nothing is hit; empty unless asked for.
    pub normal: Vec<DVec3>,
    /// Number of decisions that each step of the ladder made. Each pixel that is asked of an object
    /// is one; a pixel that is decided by itself may make several: whether it is met, and ahead,
    /// and first.
    pub steps: Steps,
    /// Counts of what was left out, and of what was left to do.
    pub counts: Counts,
    /// Number of [`Frame::t`] in `f64` that each step of the ladder found: more digits than `f64` has are
    /// needed to round one right, so none is found in `f64`. In `f32`, `t` comes with the decision.
    pub steps_of_t: Steps,
}

/// One traced pixel of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FramePixel<T = f64> {
    /// The pixel of the image.
    pub pixel: Pixel,
    /// `t` of the first hit; infinite where there is none.
    pub t: T,
    /// The object hit.
    pub object: Option<u32>,
}

impl Raster {
    /// Every pixel of the image.
    pub fn full(image: ImageSize) -> Raster {
        Raster { rows: (0..image.height()).collect(), columns: (0..image.width()).collect() }
    }

    /// The pixels that a nearest-neighbour display of `rows` x `columns` dots shows of the image;
    /// at most every pixel once.
    pub fn shown_on(image: ImageSize, columns: u32, rows: u32) -> Raster {
        Raster {
            rows: shown(image.height(), rows.max(1)),
            columns: shown(image.width(), columns.max(1)),
        }
    }

    /// The pixels of these rows and columns, which the image has.
    pub fn part(rows: std::ops::Range<u32>, columns: std::ops::Range<u32>) -> Raster {
        Raster { rows: rows.collect(), columns: columns.collect() }
    }

    /// These rows and columns, ascending.
    pub fn from_cells(rows: Vec<u32>, columns: Vec<u32>) -> Raster {
        Raster { rows, columns }
    }

    /// The rows traced, ascending.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// The columns traced, ascending.
    pub fn columns(&self) -> &[u32] {
        &self.columns
    }

    /// Returns, for each row of the image, the position among [`Raster::rows`] of the nearest one, and
    /// likewise for columns; of two equally near ones the first.
    pub fn nearest(&self, image: ImageSize) -> [Vec<usize>; 2] {
        let indices = |traced, count| (0..count).map(|own| nearest(traced, own)).collect();
        [indices(&self.rows, image.height()), indices(&self.columns, image.width())]
    }

    /// The position among the raster's pixels, row by row, of the one in the nearest row and column, as
    /// [`Raster::nearest`] has it for all; `None` where no pixel is traced.
    pub fn nearest_to(&self, pixel: Pixel) -> Option<usize> {
        (!self.is_empty()).then(|| {
            let row = nearest(&self.rows, pixel.row);
            row * self.columns.len() + nearest(&self.columns, pixel.column)
        })
    }

    /// Values of the raster's pixels for every pixel of the image: one that was left out gets the value
    /// of the nearest row and column ([`Raster::nearest`]). None where there are none, or not as many
    /// as pixels.
    pub fn spread<V: Copy>(&self, image: ImageSize, values: &[V]) -> Vec<V> {
        if self.is_empty() || values.len() != self.len() {
            return Vec::new();
        }
        let [rows, columns] = self.nearest(image);
        let of_row = |row: &usize| &values[row * self.columns.len()..][..self.columns.len()];
        rows.iter().flat_map(|row| columns.iter().map(|column| of_row(row)[*column])).collect()
    }

    /// Number of pixels that are traced.
    pub fn len(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Returns whether no pixel is traced.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The cells of `count` at the centres of `dots` dots across them.
fn shown(count: u32, dots: u32) -> Vec<u32> {
    if dots >= count {
        return (0..count).collect();
    }
    let (count, dots) = (u64::from(count), u64::from(dots));
    (0..dots).map(|k| ((2 * k + 1) * count / (2 * dots)) as u32).collect()
}

/// Position of the nearest traced row or column; of two equally near ones the first.
fn nearest(traced: &[u32], own: u32) -> usize {
    let after = traced.partition_point(|x| *x < own);
    let before = after.saturating_sub(1);
    let is_nearer = |x: &u32| x.abs_diff(own) < traced[before].abs_diff(own);
    if traced.get(after).is_some_and(is_nearer) { after } else { before }
}

impl<T: Copy> Frame<T> {
    /// The camera that the frame was traced for.
    pub fn camera(&self) -> &ResolvedCamera {
        &self.camera
    }

    /// The rows and columns that were traced.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// The frame as if every pixel of the image were traced, each pixel that was left out with what
    /// [`Raster::spread`] gives it: for showing a coarse frame where every pixel is asked. It is not
    /// what the ray through such a pixel meets. Steps and counts stay those of what was traced.
    pub fn spread(&self) -> Frame<T> {
        let image = self.camera.image();
        Frame {
            camera: self.camera,
            raster: Raster::full(image),
            t: self.raster.spread(image, &self.t),
            object: self.raster.spread(image, &self.object),
            normal: self.raster.spread(image, &self.normal),
            steps: self.steps,
            steps_of_t: self.steps_of_t,
            counts: self.counts,
        }
    }

    /// The traced pixel in the raster's `row`th row and `column`th column.
    ///
    /// # Panics
    /// Outside the raster, or where `t` or object was not asked for.
    pub fn at(&self, row: usize, column: usize) -> FramePixel<T> {
        let index = row * self.raster.columns.len() + column;
        let object = self.object[index];
        FramePixel {
            pixel: Pixel { row: self.raster.rows[row], column: self.raster.columns[column] },
            t: self.t[index],
            object: (object != NO_OBJECT).then_some(object),
        }
    }
}
