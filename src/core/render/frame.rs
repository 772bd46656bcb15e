//! Frames: the first hit of every pixel's view ray, in buffers that bands of rows fill in parallel; the
//! floating-point types that can hold `t`; and counts of the work that was left out.

use std::ops::Range;

use fearless_simd::Level;
use glam::DVec3;

use crate::camera::resolved::ResolvedCamera;
use crate::camera::viewport::{ImageSize, Pixel};
use crate::exact::steps::Steps;
use crate::scene::Scene;

/// The value of [`Frame::object`] where the ray hits nothing.
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
pub struct Outputs {
    /// True to keep `t` of the first hit.
    pub t: bool,
    /// True to keep the index of the object hit.
    pub object: bool,
    /// True to keep the outward unit normal at the hit.
    pub normal: bool,
}

impl Outputs {
    /// Keeps no output, only steps and counts: for a picture of which only the colours are needed.
    pub const NONE: Outputs = Outputs { t: false, object: false, normal: false };
}

impl Default for Outputs {
    /// Keeps `t` and the object.
    fn default() -> Outputs {
        Outputs { t: true, object: true, normal: false }
    }
}

/// The traced pixels, row by row, with the camera and raster that they belong to.
///
/// T is the type in which `t` is kept, `f64` or `f32`. The type does not affect which pixels are hit and
/// which object is first: these decisions are exact.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Frame<T = f64> {
    pub(crate) camera: ResolvedCamera,
    pub(crate) raster: Raster,
    /// `t` of the first hit, rounded; infinite where nothing is hit, or where `t` is beyond the range of
    /// T; empty unless requested.
    pub t: Vec<T>,
    /// Index of the object hit, or [`NO_OBJECT`]; empty unless requested.
    pub object: Vec<u32>,
    /// Outward unit normals, zero where nothing is hit; empty unless requested.
    pub normal: Vec<DVec3>,
    /// Number of decisions that each step of [the ladder](crate#the-ladder) made. Testing a pixel
    /// against an object is one decision; a pixel that the ladder decides individually may take several:
    /// whether the object is hit, whether the hit is in front of the eye, and whether it is first. On which
    /// side of an object the eye is, is decided once, and counted if `f64` does not decide it;
    /// a [`Certificate`](crate::Certificate) names this decision for each pixel that depends on it.
    pub steps: Steps,
    /// Numbers of spheres and rows, in all and left out.
    pub counts: Counts,
    /// Number of values of [`Frame::t`] that each step of the ladder computed, for `t` in `f64`.
    /// Rounding `t` correctly takes more digits than `f64` has, so the `f64` step computes none. For `t`
    /// in `f32`, which is a by-product of the decisions, all counts are 0.
    pub steps_of_t: Steps,
}

/// One traced pixel of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FramePixel<T = f64> {
    /// The pixel of the image.
    pub pixel: Pixel,
    /// `t` of the first hit; infinite if nothing is hit.
    pub t: T,
    /// The object hit; `None` if nothing is hit.
    pub object: Option<u32>,
}

impl Raster {
    /// Returns the raster of all pixels of the image.
    pub fn full(image: ImageSize) -> Raster {
        Raster { rows: (0..image.height()).collect(), columns: (0..image.width()).collect() }
    }

    /// Returns the raster of the pixels that are visible when the image is shown on `rows` x `columns`
    /// screen pixels without interpolation (nearest neighbour). Each pixel occurs at most once.
    pub fn shown_on(image: ImageSize, columns: u32, rows: u32) -> Raster {
        Raster {
            rows: shown(image.height(), rows.max(1)),
            columns: shown(image.width(), columns.max(1)),
        }
    }

    /// Returns the raster of these rows and columns, all of which must lie in the image.
    pub fn part(rows: std::ops::Range<u32>, columns: std::ops::Range<u32>) -> Raster {
        Raster { rows: rows.collect(), columns: columns.collect() }
    }

    /// Returns the raster of these rows and columns, which must be ascending.
    pub fn from_cells(rows: Vec<u32>, columns: Vec<u32>) -> Raster {
        Raster { rows, columns }
    }

    /// Returns the traced rows, ascending.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// Returns the traced columns, ascending.
    pub fn columns(&self) -> &[u32] {
        &self.columns
    }

    /// Returns the traced pixel with this index, counted row by row.
    pub fn pixel(&self, index: usize) -> Pixel {
        let (row, column) = (index / self.columns.len(), index % self.columns.len());
        Pixel { row: self.rows[row], column: self.columns[column] }
    }

    /// Returns, for each row of the image, the index in [`Raster::rows`] of the nearest traced row, and
    /// likewise for columns. Of two equally near rows or columns, the first is taken.
    pub fn nearest(&self, image: ImageSize) -> [Vec<usize>; 2] {
        let indices = |traced, count| (0..count).map(|own| nearest(traced, own)).collect();
        [indices(&self.rows, image.height()), indices(&self.columns, image.width())]
    }

    /// Returns the index, counted row by row, of the traced pixel in the row and column nearest to
    /// `pixel`, chosen as in [`Raster::nearest`]. Returns `None` if no pixel is traced.
    pub fn nearest_to(&self, pixel: Pixel) -> Option<usize> {
        (!self.is_empty()).then(|| {
            let row = nearest(&self.rows, pixel.row);
            row * self.columns.len() + nearest(&self.columns, pixel.column)
        })
    }

    /// Spreads the values of the raster's pixels over the whole image. A pixel that was not traced gets
    /// the value from the nearest traced row and column ([`Raster::nearest`]). Returns an empty vector
    /// if no pixel is traced, or if `values` does not have one value for each pixel of the raster.
    pub fn spread<V: Copy>(&self, image: ImageSize, values: &[V]) -> Vec<V> {
        if self.is_empty() || values.len() != self.len() {
            return Vec::new();
        }
        let [rows, columns] = self.nearest(image);
        let of_row = |row: &usize| &values[row * self.columns.len()..][..self.columns.len()];
        rows.iter().flat_map(|row| columns.iter().map(|column| of_row(row)[*column])).collect()
    }

    /// Returns the number of pixels that are traced.
    pub fn len(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Returns whether no pixel is traced.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Returns the rows or columns, of `count` in an image, that are visible on `dots` screen pixels: the
/// one at each screen pixel's centre, or all if there are enough screen pixels.
fn shown(count: u32, dots: u32) -> Vec<u32> {
    if dots >= count {
        return (0..count).collect();
    }
    let (count, dots) = (u64::from(count), u64::from(dots));
    (0..dots).map(|k| ((2 * k + 1) * count / (2 * dots)) as u32).collect()
}

/// Returns the index of the nearest traced row or column; of two equally near ones, the first.
fn nearest(traced: &[u32], own: u32) -> usize {
    let after = traced.partition_point(|x| *x < own);
    let before = after.saturating_sub(1);
    let is_nearer = |x: &u32| x.abs_diff(own) < traced[before].abs_diff(own);
    if traced.get(after).is_some_and(is_nearer) { after } else { before }
}

impl<T: Copy> Frame<T> {
    /// Returns the camera that the frame was traced for.
    pub fn camera(&self) -> &ResolvedCamera {
        &self.camera
    }

    /// Returns the rows and columns that were traced.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// Returns the frame enlarged to all pixels of the image, for showing a coarse frame where every
    /// pixel is needed. A pixel that was not traced gets the values of a traced one (see
    /// [`Raster::spread`]), not the hit of its own ray. Steps and counts remain those of the traced
    /// pixels.
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

    /// Returns the traced pixel in the raster's `row`th row and `column`th column.
    ///
    /// # Panics
    /// Panics if the row or column is outside the raster, or if `t` or the object was not requested.
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

/// Makes a frame with buffers for the requested outputs.
pub(crate) fn empty_frame<T: Depth>(
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
) -> Frame<T> {
    // Allocating zeroed memory takes no time; the cost arises when a band's thread fills it.
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

/// A thread's own buffers, which stand in for outputs that were not requested.
pub(crate) struct OwnBuffers<T> {
    pub(crate) t: Vec<T>,
    pub(crate) object: Vec<u32>,
    /// `t` in `f32`, as it is drawn, if the frame keeps `t` in `f64`.
    pub(crate) drawn: Vec<f32>,
}

/// Splits a buffer of rows of `width` pixels into one part for each band. All parts are empty if the
/// buffer is.
pub(crate) fn parts<'a, T>(
    mut buffer: &'a mut [T],
    bands: &[Range<usize>],
    width: usize,
) -> Vec<&'a mut [T]> {
    let next = |rows: &Range<usize>| buffer.split_off_mut(..rows.len() * width).unwrap_or_default();
    bands.iter().map(next).collect()
}

/// Returns the band's part of an output buffer or, if that output was not requested, `len` elements of
/// the thread's own buffer.
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

/// Numbers of spheres and rows that a frame had to draw and could leave out. Rows are those of the
/// traced raster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// Number of spheres in the scene.
    pub spheres: u64,
    /// Number of spheres that were left out, because they lie wholly behind the eye, outside the picture,
    /// or between two of its rows.
    pub spheres_left_out: u64,
    /// Number of rows of the picture.
    pub rows: u64,
    /// Number of rows that no object's outline can reach; they show only the background.
    pub rows_untouched: u64,
}

/// The floating-point type in which a frame keeps `t`: `f64`, correctly rounded from the exact value, or
/// `f32`, within an ulp of it, which takes a fraction of the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug {
    /// Zero.
    #[doc(hidden)]
    const ZERO: Self;
    /// True for `f32`, the type in which frames are drawn. In `f64`, `t` is computed afterwards, when
    /// each pixel's object is known.
    #[doc(hidden)]
    const IS_DRAWN: bool;

    /// Converts the number to `f64`, exactly.
    fn widened(self) -> f64;

    /// Returns the buffer to draw into: `t` itself for `f32`; for `f64`, as many elements of the
    /// thread's own buffer.
    #[doc(hidden)]
    fn drawn<'a>(t: &'a mut [Self], own: &'a mut Vec<f32>) -> &'a mut [f32];

    /// Returns the buffer to fill when each pixel's object is known: `t` itself for `f64`, an empty one
    /// for `f32`.
    #[doc(hidden)]
    fn found(t: &mut [Self]) -> &mut [f64];

    /// Traces a frame, see `render::fill`. This function is neither generic nor inlined, so it is compiled
    /// once, with this crate, and not again with each crate that calls a function generic over
    /// [`Depth`].
    #[doc(hidden)]
    fn fill(
        frame: &mut Frame<Self>,
        level: Level,
        scene: &Scene,
        finish: Option<Finish<'_, Self>>,
        done: &(dyn Fn(usize) + Sync),
    );
}

/// Implements [`Depth::fill`] for one type.
macro_rules! fill {
    () => {
        #[inline(never)]
        fn fill(
            frame: &mut Frame<Self>,
            level: Level,
            scene: &Scene,
            finish: Option<Finish<'_, Self>>,
            done: &(dyn Fn(usize) + Sync),
        ) {
            crate::render::fill(frame, level, scene, finish, done);
        }
    };
}

impl Depth for f32 {
    const ZERO: f32 = 0.0;
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

    fill!();
}

impl Depth for f64 {
    const ZERO: f64 = 0.0;
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

    fill!();
}

/// A callback for each band, called as soon as the band is traced, with its rows and with the `t` and
/// the objects of their pixels.
pub(crate) type Finish<'a, T> = &'a (dyn Fn(Range<usize>, &[T], &[u32]) + Sync);
