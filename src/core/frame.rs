//! A picture: the first hit of every pixel's view ray.

use glam::DVec3;

use crate::image::{ImageSize, Pixel};
use crate::posed::PosedCamera;
use crate::steps::Steps;

/// [`Frame::object`] where the ray hits nothing.
pub const NO_OBJECT: u32 = u32::MAX;

/// What a frame keeps `t` in: `f64`, within half an ulp and 2^-40 of one, or `f32`, within half an
/// ulp and 2^-15 of one at less than half the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug + sealed::Sealed {
    /// 0
    #[doc(hidden)]
    const ZERO: Self;
    /// Where nothing is hit.
    const NONE: Self;
    /// How exact the row kernels' `t` must be, as a share.
    #[doc(hidden)]
    const DOUBT: f64;
    /// Two `t` that are closer than this share may be in the wrong order for their rounding.
    #[doc(hidden)]
    const TIE: f64;

    /// The nearest one; infinite or the smallest positive one where it is beyond the range.
    #[doc(hidden)]
    fn of(t: f64) -> Self;

    /// Whether it is far from the ends of the range.
    #[doc(hidden)]
    fn is_in_range(t: f64) -> bool;

    /// As `f64`, exactly.
    fn widened(self) -> f64;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for f32 {}
}

impl Depth for f64 {
    const ZERO: f64 = 0.0;
    const NONE: f64 = f64::INFINITY;
    const DOUBT: f64 = crate::precise::T_DOUBT;
    const TIE: f64 = 4.0 * f64::EPSILON;

    #[inline(always)]
    fn of(t: f64) -> f64 {
        t
    }

    #[inline(always)]
    fn is_in_range(t: f64) -> bool {
        t > 1e-290 && t < 1e290
    }

    #[inline(always)]
    fn widened(self) -> f64 {
        self
    }
}

impl Depth for f32 {
    const ZERO: f32 = 0.0;
    const NONE: f32 = f32::INFINITY;
    /// 2^-39
    const DOUBT: f64 = 1.0 / (1_u64 << 39) as f64;
    const TIE: f64 = 4.0 * f32::EPSILON as f64;

    #[inline(always)]
    fn of(t: f64) -> f32 {
        (t as f32).max(f32::from_bits(1))
    }

    #[inline(always)]
    fn is_in_range(t: f64) -> bool {
        t > 1e-37 && t < 1e38
    }

    #[inline(always)]
    fn widened(self) -> f64 {
        self.into()
    }
}

/// Which rows and columns of the image to trace, ascending. A screen smaller than the image shows
/// only some of its pixels; the others need not be traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    rows: Vec<u32>,
    columns: Vec<u32>,
}

/// What to compute besides `t` and object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// The outward unit normal of every hit.
    pub normal: bool,
}

/// The traced pixels, row by row, with the camera and raster that they belong to.
///
/// T is what `t` is kept in, `f64` or `f32`. Which pixels are hit, and which object is first, is the
/// same for both: exact.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame<T = f64> {
    pub(crate) camera: PosedCamera,
    pub(crate) raster: Raster,
    /// `t` of the first hit, rounded; infinite where there is none (or, at an object, where it is
    /// beyond the range of T).
    pub t: Vec<T>,
    /// Index of the object hit, or [`NO_OBJECT`].
    pub object: Vec<u32>,
    /// Outward unit normals, zero where nothing is hit; empty unless asked for.
    pub normal: Vec<DVec3>,
    /// How far up the ladder the decisions had to go. Each pixel that is asked of an object is one.
    pub steps: Steps,
}

/// One traced pixel of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramePixel<T = f64> {
    /// Which pixel of the image it is.
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

    /// The rows traced, ascending.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// The columns traced, ascending.
    pub fn columns(&self) -> &[u32] {
        &self.columns
    }

    /// How many pixels are traced.
    pub fn len(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Whether no pixel is traced.
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

impl<T: Depth> Frame<T> {
    /// The camera that the frame was traced for.
    pub fn camera(&self) -> &PosedCamera {
        &self.camera
    }

    /// The rows and columns that were traced.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// The traced pixel in the raster's `row`th row and `column`th column.
    ///
    /// # Panics
    /// Outside the raster.
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
