//! A picture: the first hit of every pixel's view ray, in buffers that bands of rows fill side by side;
//! the number in which it keeps `t`; and the counts of what it left out.

use std::ops::{Add, AddAssign, Range};

use fearless_simd::Level;
use glam::DVec3;

use crate::camera::resolved::ResolvedCamera;
use crate::camera::viewport::{ImageSize, Pixel};
use crate::exact::steps::Steps;
use crate::scene::Scene;

/// [`Frame::object`] where the ray hits nothing.
pub const NO_OBJECT: u32 = u32::MAX;

/// Rows and columns of the image to trace, ascending. A screen smaller than the image shows
/// only some of its pixels; the others need not be traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    rows: Vec<u32>,
    columns: Vec<u32>,
}

/// The outputs to keep for every pixel. An output that is not requested is not written, and its buffer
/// stays empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Outputs {
    /// `t` of the first hit.
    pub t: bool,
    /// The object's index.
    pub object: bool,
    /// The outward unit normal there.
    pub normal: bool,
}

impl Outputs {
    /// Only steps and counts: for a picture of which only the colours are needed.
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
    /// `t` of the first hit, rounded; infinite where there is none (or, at an object, where it is beyond
    /// the range of T); empty unless requested.
    pub t: Vec<T>,
    /// Index of the object hit, or [`NO_OBJECT`]; empty unless requested.
    pub object: Vec<u32>,
    /// Outward unit normals, zero where nothing is hit; empty unless requested.
    pub normal: Vec<DVec3>,
    /// Number of decisions that each step of the ladder made. Each pixel that is asked of an object
    /// is one; a pixel that is decided by itself may make several: whether it is met, and ahead,
    /// and first.
    pub steps: Steps,
    /// Counts of the work that was left out, and of the work that remained.
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
    /// Panics outside the raster, or if `t` or the object was not requested.
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

/// Makes a frame with room for the requested outputs.
pub(crate) fn empty_frame<T: Depth>(
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
) -> Frame<T> {
    // Zeroed memory costs nothing until a band, in its own thread, fills it.
    let pixels = |asked: bool| if asked { raster.len() } else { 0 };
    Frame {
        camera: *camera,
        raster: raster.clone(),
        t: vec![T::ZERO; pixels(outputs.t)],
        object: vec![0; pixels(outputs.object)],
        normal: vec![DVec3::ZERO; pixels(outputs.normal)],
        steps: Steps::default(),
        counts: Counts::default(),
        steps_of_t: Steps::default(),
    }
}

/// A band's part of each buffer; empty if that output was not requested.
pub(crate) struct BandBuffers<'a, T> {
    pub(crate) t: &'a mut [T],
    pub(crate) object: &'a mut [u32],
    pub(crate) normal: &'a mut [DVec3],
}

/// A thread's own buffers, in place of those that were not requested.
pub(crate) struct OwnBuffers<T> {
    pub(crate) t: Vec<T>,
    pub(crate) object: Vec<u32>,
    /// `t` as it is drawn, for a frame that keeps it in another precision.
    pub(crate) drawn: Vec<f32>,
}

impl<T> OwnBuffers<T> {
    pub(crate) fn new() -> OwnBuffers<T> {
        OwnBuffers { t: Vec::new(), object: Vec::new(), drawn: Vec::new() }
    }
}

/// Splits the buffers into those of the bands, in order; the bands have the given numbers of rows and
/// columns.
pub(crate) fn band_buffers<'a, T>(
    mut t: &'a mut [T],
    mut object: &'a mut [u32],
    mut normal: &'a mut [DVec3],
    (bands, width): (&[Range<usize>], usize),
) -> Vec<BandBuffers<'a, T>> {
    let next = |rows: &Range<usize>| {
        let pixels = rows.len() * width;
        let (t, object) = (first_of(&mut t, pixels), first_of(&mut object, pixels));
        BandBuffers { t, object, normal: first_of(&mut normal, pixels) }
    };
    bands.iter().map(next).collect()
}

/// Splits off the first part of a buffer; empty if the buffer is empty.
fn first_of<'a, T>(buffer: &mut &'a mut [T], size: usize) -> &'a mut [T] {
    buffer.split_off_mut(..size).unwrap_or_default()
}

/// Returns a buffer's part or, if that was not requested, as much of the thread's own buffer.
pub(crate) fn or_own<'a, T: Copy>(
    part: &'a mut [T],
    own: &'a mut Vec<T>,
    len: usize,
    zero: T,
) -> &'a mut [T] {
    if part.len() == len {
        return part;
    }
    own.resize(len.max(own.len()), zero);
    &mut own[..len]
}

/// Counts of how much of a scene a frame had to examine. Rows and columns are those of the traced raster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// Spheres of the scene.
    pub spheres: u64,
    /// Spheres dropped because they lie wholly behind the eye.
    pub behind: u64,
    /// Spheres dropped because they lie outside the picture, or between two of its rows.
    pub outside: u64,
    /// All remaining spheres, hidden or not.
    pub in_view: u64,
    /// Number of times that a band of rows skipped a sphere because nearer spheres hide all of it there.
    /// The count depends on the drawing order, and so on the width of the processor's vectors; the picture
    /// does not.
    pub hidden: u64,
    /// Rows of the picture.
    pub rows: u64,
    /// Rows that no object's outline can reach: they show only the background.
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

/// The number that a frame keeps `t` in: `f64`, rounded from the exact one, or `f32`, within
/// an ulp, at a fraction of the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug + sealed::Sealed {
    /// 0
    #[doc(hidden)]
    const ZERO: Self;
    /// The `t` of a pixel where nothing is hit.
    const NONE: Self;
    /// True if frames are drawn in it; `t` in `f64` is found when the objects are known.
    #[doc(hidden)]
    const IS_DRAWN: bool;

    /// Returns the number as `f64`, exactly.
    fn widened(self) -> f64;

    /// Returns the numbers that are drawn: `t` itself, or as many of the thread's own.
    #[doc(hidden)]
    fn drawn<'a>(t: &'a mut [Self], own: &'a mut Vec<f32>) -> &'a mut [f32];

    /// Returns the numbers that are found when the objects are known: `t` itself, or none.
    #[doc(hidden)]
    fn found(t: &mut [Self]) -> &mut [f64];
}

impl Depth for f32 {
    const ZERO: f32 = 0.0;
    const NONE: f32 = f32::INFINITY;
    const IS_DRAWN: bool = true;

    #[inline(always)]
    fn widened(self) -> f64 {
        self.into()
    }

    fn drawn<'a>(t: &'a mut [f32], _: &'a mut Vec<f32>) -> &'a mut [f32] {
        t
    }

    fn found(_: &mut [f32]) -> &mut [f64] {
        &mut []
    }
}

impl Depth for f64 {
    const ZERO: f64 = 0.0;
    const NONE: f64 = f64::INFINITY;
    const IS_DRAWN: bool = false;

    #[inline(always)]
    fn widened(self) -> f64 {
        self
    }

    fn drawn<'a>(t: &'a mut [f64], own: &'a mut Vec<f32>) -> &'a mut [f32] {
        own.resize(t.len().max(own.len()), 0.0);
        &mut own[..t.len()]
    }

    fn found(t: &mut [f64]) -> &mut [f64] {
        t
    }
}

/// A callback for the rows of a band as soon as they are traced: rows, `t`, objects.
pub(crate) type Finish<'a, T> = &'a (dyn Fn(Range<usize>, &[T], &[u32]) + Sync);

pub(crate) mod sealed {
    use super::*;

    /// The tracer of one precision.
    pub trait Sealed: Sized {
        /// See [`fill`](crate::render::fill). Neither generic nor inlined, it is compiled with this crate,
        /// once, and not again with each crate that calls a function generic over [`Depth`].
        fn fill(
            frame: &mut Frame<Self>,
            level: Level,
            scene: &Scene,
            finish: Option<Finish<'_, Self>>,
            done: &(dyn Fn(usize) + Sync),
        );
    }
}
