//! The rows and columns of a raster, and the camera's axes, as floating-point numbers for SIMD code.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::camera::resolved::ResolvedCamera;
use crate::render::frame::Raster;
use crate::render::outline::MOST_SINGLE_LANES;

/// Number of entries by which the tables extend past the last row and column.
const PADDING: usize = MOST_SINGLE_LANES;

/// The row and column numbers, in the image, of a raster's rows and columns, ascending. Padding after
/// the last ones lets a SIMD vector be loaded from any position.
pub(crate) struct RasterAxes {
    pub(crate) row_numbers: Vec<f64>,
    pub(crate) columns: Vec<f32>,
    pub(crate) height: usize,
    pub(crate) width: usize,
    /// True if the rows follow one another without a gap.
    rows_are_whole: bool,
    /// True if the columns follow one another without a gap.
    columns_are_whole: bool,
}

fn are_whole(cells: &[u32]) -> bool {
    let [first, .., last] = cells else { return true };
    (last - first) as usize == cells.len() - 1
}

impl RasterAxes {
    pub(crate) fn new(raster: &Raster) -> RasterAxes {
        let (rows, columns) = (raster.rows(), raster.columns());
        let padding = std::iter::repeat_n(f32::INFINITY, PADDING);
        RasterAxes {
            row_numbers: rows
                .iter()
                .map(|row| f64::from(*row))
                .chain(std::iter::repeat_n(0.0, PADDING))
                .collect(),
            columns: columns.iter().map(|column| *column as f32).chain(padding).collect(),
            height: rows.len(),
            width: columns.len(),
            rows_are_whole: are_whole(rows),
            columns_are_whole: are_whole(columns),
        }
    }

    /// Returns whether the rows and the columns each follow one another without a gap.
    pub(crate) fn are_whole(&self) -> bool {
        self.rows_are_whole && self.columns_are_whole
    }

    pub(crate) fn pixels(&self) -> usize {
        self.width * self.height
    }

    /// Returns the indices of the raster's columns whose numbers in the image are from `first` to
    /// `last`, which must be whole numbers.
    #[inline(always)]
    pub(crate) fn columns_range(&self, first: f64, last: f64) -> Range<usize> {
        self.columns_between(first, last).map_or(0..0, |(from, to)| from..to + 1)
    }

    /// Returns the indices of the raster's rows whose numbers in the image are from `first` to `last`,
    /// which must be whole numbers.
    #[inline(always)]
    pub(crate) fn rows_between(&self, first: f64, last: f64) -> Range<usize> {
        let rows = &self.row_numbers[..self.height];
        if self.rows_are_whole {
            // A cast saturates: at 0 before the first row.
            let from = ((first - rows[0]) as usize).min(self.height);
            let to = ((last - rows[0] + 1.0) as usize).min(self.height);
            return from..to.max(from);
        }
        let from = rows.partition_point(|row| *row < first);
        from..rows.partition_point(|row| *row <= last).max(from)
    }

    /// Returns the indices of the first and last of the raster's columns whose numbers in the image are
    /// from `first` to `last`, which must be whole numbers; `None` if there is no such column.
    #[inline(always)]
    pub(crate) fn columns_between(&self, first: f64, last: f64) -> Option<(usize, usize)> {
        let columns = &self.columns[..self.width];
        let (from, end) = if self.columns_are_whole {
            let start = f64::from(columns[0]);
            let end = ((last - start + 1.0) as usize).min(self.width);
            ((first - start) as usize, end)
        } else {
            let from = columns.partition_point(|column| f64::from(*column) < first);
            (from, columns.partition_point(|column| f64::from(*column) <= last))
        };
        (from < end).then(|| (from, end - 1))
    }

    /// Returns, for each lane of a SIMD vector of rows, the indices of the first and last of the
    /// raster's columns whose numbers in the image are from `first` to `last`, which must be whole
    /// numbers; and a mask of the lanes in which there is such a column.
    #[inline(always)]
    pub(crate) fn clip<S: Simd>(
        &self,
        simd: S,
        first: S::f64s,
        last: S::f64s,
    ) -> (S::f64s, S::f64s, u64) {
        let splat = |x: f64| S::f64s::splat(simd, x);
        if self.columns_are_whole {
            let start = splat(f64::from(self.columns[0]));
            let from = (first - start).max(splat(0.0));
            let to = (last - start).min(splat((self.width - 1) as f64));
            return (from, to, from.simd_le(to).to_bitmask());
        }
        let (mut from, mut to, mut is_there) = (splat(0.0), splat(0.0), 0);
        for lane in 0..S::f64s::LEN {
            let (first, last) = (first.as_slice()[lane], last.as_slice()[lane]);
            if let Some(columns) = self.columns_between(first, last) {
                from.as_mut_slice()[lane] = columns.0 as f64;
                to.as_mut_slice()[lane] = columns.1 as f64;
                is_there |= 1 << lane;
            }
        }
        (from, to, is_there)
    }

    /// Clips like [`RasterAxes::clip`], for twice as many lanes. Returns the image's numbers of the
    /// first and last columns, their indices in the raster, and a mask of the lanes in which there is
    /// such a column.
    #[inline(always)]
    pub(crate) fn clip_singles<S: Simd>(
        &self,
        simd: S,
        first: S::f32s,
        last: S::f32s,
    ) -> (S::f32s, S::f32s, [S::i32s; 2], u64) {
        let splat = |x: f32| S::f32s::splat(simd, x);
        if self.columns_are_whole {
            let (begin, end) = (splat(self.columns[0]), splat(self.columns[self.width - 1]));
            let (from, to) = (first.max(begin), last.min(end));
            let index = [S::i32s::truncate_from(from - begin), S::i32s::truncate_from(to - begin)];
            return (from, to, index, from.simd_le(to).to_bitmask());
        }
        let (mut from, mut to, mut is_there) = (splat(0.0), splat(0.0), 0);
        let mut index = [S::i32s::splat(simd, 0); 2];
        for lane in 0..S::f32s::LEN {
            let (first, last) = (first.as_slice()[lane], last.as_slice()[lane]);
            if let Some(columns) = self.columns_between(f64::from(first), f64::from(last)) {
                from.as_mut_slice()[lane] = self.columns[columns.0];
                to.as_mut_slice()[lane] = self.columns[columns.1];
                index[0].as_mut_slice()[lane] = columns.0 as i32;
                index[1].as_mut_slice()[lane] = columns.1 as i32;
                is_there |= 1 << lane;
            }
        }
        (from, to, index, is_there)
    }
}

/// The camera's coordinate system, in which spheres are drawn: the eye and the axes, and the slopes
/// `x = u / distance` and `y = v / distance` of view rays as functions of column and row.
///
/// ```text
/// x = column_slope (column - middle_column)      y = row_slope (middle_row - row)
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct CameraSpace {
    pub(crate) eye: [f64; 3],
    pub(crate) u: [f64; 3],
    pub(crate) v: [f64; 3],
    pub(crate) w: [f64; 3],
    pub(crate) distance: f64,
    pub(crate) column_slope: f64,
    pub(crate) row_slope: f64,
    /// Columns per unit of slope.
    pub(crate) per_column: f64,
    /// Rows per unit of slope.
    pub(crate) per_row: f64,
    /// The inverse of `distance`.
    pub(crate) per_distance: f64,
    /// Slope of a row divided by the slope of a column.
    pub(crate) ratio: f64,
    /// The inverse of the square of `ratio`.
    pub(crate) inverse_ratio_squared: f64,
    pub(crate) middle_column: f64,
    pub(crate) middle_row: f64,
    /// Upper bounds of the slopes `|x|` and `|y|` at any pixel's centre, with a small margin.
    pub(crate) widest: [f64; 2],
    /// `sqrt(1 + widest^2)` for x and for y.
    pub(crate) border_lengths: [f64; 2],
    /// Relative error of centres and rays, see [`CameraSpace::new`].
    pub(crate) doubt: f64,
    /// True if no product of a few lengths and slopes overflows, and the basis is so close to
    /// orthonormal that `doubt` is small.
    pub(crate) is_plain: bool,
}

impl CameraSpace {
    /// Computes the coordinate system of a camera. The field `doubt`, a relative error, is derived as
    /// follows. The rays are exact, but here they are computed from the rounded basis, as if it were
    /// orthonormal. With `u = 2^-53`, the error of `q = center - eye` is `u |q|`, that of its three dot
    /// products `3 u |q|` each, that of the basis its rounding (or its defect, if it is given by hand),
    /// and that of the slopes `3 u`: together less than 12 u plus the defect. So a ray that hits a
    /// sphere of radius r hits, as computed, a sphere around the computed centre whose radius is larger
    /// by `doubt (|q| + r)`; and a ray that hits, as computed, one whose radius is smaller by as much
    /// hits the true sphere.
    pub(crate) fn new(camera: &ResolvedCamera) -> CameraSpace {
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let basis = camera.basis();
        let (u, v, w) = (basis.u, basis.v, basis.w);
        let (viewport, image) = (camera.viewport(), camera.image());
        let (columns, rows) = (f64::from(image.width()), f64::from(image.height()));
        let column_slope = viewport.width / (viewport.distance * columns);
        let row_slope = viewport.height / (viewport.distance * rows);
        let doubt = ROUNDING + 4.0 * basis.defect();
        let plain = 1e-12..1e12;
        let is_plain = plain.contains(&column_slope)
            && plain.contains(&row_slope)
            && (1e-5..1e5).contains(&(column_slope / row_slope))
            && plain.contains(&viewport.distance)
            && camera.eye().abs().max_element() < 1e12
            && doubt < 1e-12;
        let ratio = row_slope / column_slope;
        let widest = [0.5001 * columns * column_slope, 0.5001 * rows * row_slope];
        CameraSpace {
            eye: camera.eye().to_array(),
            u: u.to_array(),
            v: v.to_array(),
            w: w.to_array(),
            distance: viewport.distance,
            column_slope,
            row_slope,
            per_column: 1.0 / column_slope,
            per_row: 1.0 / row_slope,
            per_distance: 1.0 / viewport.distance,
            ratio,
            inverse_ratio_squared: 1.0 / (ratio * ratio),
            middle_column: 0.5 * columns - 0.5,
            middle_row: 0.5 * rows - 0.5,
            widest,
            border_lengths: widest.map(|widest| (1.0 + widest * widest).sqrt()),
            doubt,
            is_plain,
        }
    }
}
