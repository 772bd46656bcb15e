//! The view rays of a frame, as a linear function of two whole numbers, one for the column and one for
//! the row.

use std::ops::Range;

use crate::camera::resolved::ResolvedCamera;
use crate::camera::viewport::Pixel;
use crate::exact::bounded::{Number, UNIT, Vector, length, near};
use crate::exact::double_double::DoubleDouble;
use crate::exact::quadratic::DirectionTerms;
use crate::exact::scale::ldexp;
use crate::render::frame::Raster;

/// All view rays of a frame. With the whole numbers `n = 2 column + 1 - W` and `l = H - 2 row - 1`, the
/// camera's basis u, v, w and the image's size W x H, a view ray's direction times `2 W H` is
///
/// ```text
/// n (width H u) + l (height W v) - 2 W H distance w  =  n e + l g + z
/// ```
#[derive(Clone, Debug)]
pub(crate) struct FrameRays<'a> {
    pub(crate) camera: &'a ResolvedCamera,
    raster: &'a Raster,
    /// n of each column of the raster.
    pub(crate) n: Vec<f64>,
    /// l of each row of the raster.
    pub(crate) l: Vec<f64>,
    /// The term `n e` of each column, in `f64`.
    column_terms: Vec<Vector<f64>>,
    /// Whether e, g and z have ordinary lengths, so that scaling them by the same power of two has lost
    /// no digits.
    pub(crate) is_plain: bool,
    /// Upper bound of the length of every direction.
    longest: f64,
    pub(crate) steppers: Steppers,
    /// `2 W H`
    pub(crate) stretch: f64,
    /// The vectors e, g and z are in units of `2^scale`.
    pub(crate) scale: i32,
}

/// The vectors e, g and z of [`FrameRays`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steppers {
    pub(crate) e: Vector<f64>,
    pub(crate) g: Vector<f64>,
    pub(crate) z: Vector<f64>,
    /// Relative error of each of the vectors e, g and z.
    vector_doubt: f64,
    /// A lower bound of the length of every direction, slightly less than `|z|`.
    pub(crate) least_length: f64,
}

impl<'a> FrameRays<'a> {
    pub(crate) fn new(camera: &'a ResolvedCamera, raster: &'a Raster) -> FrameRays<'a> {
        let image = camera.image();
        let (w, h) = (f64::from(image.width()), f64::from(image.height()));
        let viewport = camera.viewport();
        let measures = [viewport.width, viewport.height, viewport.distance];
        let (_, scale) = crate::exact::bounded::scaled(measures.map(DoubleDouble::from));
        let basis = camera.fine_basis();
        let along = |v: Vector<DoubleDouble>, measure: f64, count: f64| {
            let step = DoubleDouble::product(ldexp(measure, -scale), count);
            v.map(|x| x * step)
        };
        let z = near(along(basis.w, viewport.distance, -2.0 * w * h));
        let steppers = Steppers {
            e: near(along(basis.u, viewport.width, h)),
            g: near(along(basis.v, viewport.height, w)),
            z,
            vector_doubt: basis.doubt + DoubleDouble::PRODUCT + UNIT,
            least_length: 0.99 * length(z),
        };
        let n: Vec<f64> = raster.columns().iter().map(|c| 2.0 * f64::from(*c) + 1.0 - w).collect();
        let l: Vec<f64> = raster.rows().iter().map(|r| h - 2.0 * f64::from(*r) - 1.0).collect();
        let plain = 1e-60..1e60;
        let parts = [w * length(steppers.e), h * length(steppers.g), length(steppers.z)];
        FrameRays {
            camera,
            raster,
            column_terms: n.iter().map(|n| steppers.e.map(|x| n * x)).collect(),
            is_plain: [steppers.e, steppers.g, z].iter().all(|v| plain.contains(&length(*v))),
            longest: 1.01 * parts.iter().sum::<f64>(),
            n,
            l,
            steppers,
            stretch: 2.0 * w * h,
            scale,
        }
    }

    /// Returns the patch (the rectangle of pixels) of these rows and columns of the raster.
    pub(crate) fn patch(&self, rows: &Range<usize>, columns: &Range<usize>) -> Patch {
        let (n, l) = (&self.n[columns.clone()], &self.l[rows.clone()]);
        let (n0, l0) = (n[n.len() / 2], l[l.len() / 2]);
        let reach = |values: &[f64], from: f64| {
            (values[0] - from).abs().max((values[values.len() - 1] - from).abs())
        };
        Patch { n: n0, l: l0, columns: reach(n, n0), rows: reach(l, l0) }
    }

    /// Returns a pixel's direction in `f64`. The returned length is an upper bound.
    #[inline(always)]
    pub(crate) fn rough_direction(&self, row: usize, column: usize) -> DirectionTerms<f64> {
        let Steppers { g, z, .. } = &self.steppers;
        let (part, l) = (self.column_terms[column], self.l[row]);
        let d = std::array::from_fn(|i| part[i] + (l * g[i] + z[i]));
        DirectionTerms { d, length: self.longest, doubt: self.steppers.doubt() }
    }

    /// Returns the pixel in the raster's `row`th row and `column`th column.
    pub(crate) fn pixel(&self, row: usize, column: usize) -> Pixel {
        Pixel { row: self.raster.rows()[row], column: self.raster.columns()[column] }
    }
}

impl Steppers {
    /// Returns the relative error of a direction made of e, g and z. The three vectors are perpendicular
    /// (within 1e-9 if the basis is given by hand), so the lengths of the three terms add up to at most
    /// `sqrt 3` times the length of the direction.
    pub(crate) fn doubt(&self) -> f64 {
        1.74 * (self.vector_doubt + f64::DOT)
    }

    /// Returns the direction `n e + l g + z`.
    pub(crate) fn direction(&self, n: f64, l: f64) -> Vector<f64> {
        std::array::from_fn(|i| n * self.e[i] + l * self.g[i] + self.z[i])
    }
}

/// A rectangle of pixels over which an object's polynomials are evaluated. Its middle is the pixel at
/// `(n, l)`, the whole numbers of [`FrameRays`]; in its other pixels, n differs by up to `columns`, and
/// l by up to `rows`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(crate) n: f64,
    pub(crate) l: f64,
    pub(crate) columns: f64,
    pub(crate) rows: f64,
}

impl Patch {
    /// Returns `x0 + m x1 + k x2` at the patch's corner, which for lengths x0, x1 and x2 is the largest
    /// value in the patch.
    pub(crate) fn corner(&self, [x0, x1, x2]: [f64; 3]) -> f64 {
        x0 + self.columns * x1 + self.rows * x2
    }
}
