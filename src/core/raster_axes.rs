//! The rows and columns of a raster as numbers that vectors can be made of.

use std::ops::Range;

use crate::frame::Raster;

/// The widest vector of `f32` that any level has: as far as the tables go on.
const PADDING: usize = 16;

/// The numbers of a raster's rows and columns in the image, ascending, with entries behind the last
/// so that a vector can begin anywhere.
pub(crate) struct RasterAxes {
    pub(crate) row_numbers: Vec<f64>,
    pub(crate) columns: Vec<f32>,
    height: usize,
    width: usize,
    /// Whether rows, and columns, follow one another without a gap.
    rows_are_whole: bool,
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

    pub(crate) fn width(&self) -> usize {
        self.width
    }

    pub(crate) fn height(&self) -> usize {
        self.height
    }

    pub(crate) fn pixels(&self) -> usize {
        self.width * self.height
    }

    /// The raster's columns with a number from `first` to `last`, both whole.
    #[inline(always)]
    pub(crate) fn columns_range(&self, first: f64, last: f64) -> Range<usize> {
        self.columns_between(first, last).map_or(0..0, |(from, to)| from..to + 1)
    }

    /// The raster's rows with a number from `first` to `last`, both whole.
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

    /// The raster's row with this number.
    #[inline(always)]
    pub(crate) fn row_at(&self, number: f64) -> Option<usize> {
        let rows = self.rows_between(number, number);
        (!rows.is_empty()).then_some(rows.start)
    }

    /// The raster's first and last column with a number from `first` to `last`, both whole.
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
}
