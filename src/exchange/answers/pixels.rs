//! The pixels that are answered: each one of the image, and once.

use pinhole_core::{ImageSize, Pixel};

use super::{COLUMN, ROW, whole};
use crate::FileError;
use crate::csv::table::Row;

/// Pixels that are answered so far.
pub(super) struct Pixels {
    image: ImageSize,
    count_from: u32,
    /// A bit a pixel, with a row and a column to spare.
    seen: Vec<u64>,
    /// True once a row or column of 0 was read.
    has_zero: bool,
    /// The first row or column of H or W, which is none unless all count from 1.
    beyond: Option<FileError>,
}

impl Pixels {
    pub(super) fn new(image: ImageSize, count_from: u32) -> Pixels {
        let cells = (u64::from(image.width()) + 1) * (u64::from(image.height()) + 1);
        let seen = vec![0; (cells / 64 + 1) as usize];
        Pixels { image, count_from, seen, has_zero: false, beyond: None }
    }

    pub(super) fn read(&mut self, row: &Row) -> Result<Pixel, FileError> {
        let coordinate = |column: usize| {
            let value = whole(row, column)?;
            let below = || self.outside(row, column, None);
            value.checked_sub(self.count_from).ok_or_else(below)
        };
        let pixel = Pixel { row: coordinate(ROW)?, column: coordinate(COLUMN)? };
        let (width, height) = (self.image.width(), self.image.height());
        for (column, value, count) in [(ROW, pixel.row, height), (COLUMN, pixel.column, width)] {
            if value < count {
                continue;
            }
            let error = self.outside(row, column, Some(pixel));
            if value > count || self.count_from != 0 {
                return Err(error);
            }
            self.beyond.get_or_insert(error);
        }
        self.has_zero |= pixel.row == 0 || pixel.column == 0;
        let bit = u64::from(pixel.row) * (u64::from(width) + 1) + u64::from(pixel.column);
        let (word, bit) = ((bit / 64) as usize, 1 << (bit % 64));
        if self.seen[word] & bit != 0 {
            let twice = "this row and column is answered above: once is enough";
            return Err(row.error(ROW, twice));
        }
        self.seen[word] |= bit;
        Ok(pixel)
    }

    fn outside(&self, row: &Row, column: usize, pixel: Option<Pixel>) -> FileError {
        let (what, count) = match column {
            ROW => ("rows", self.image.height()),
            _ => ("columns", self.image.width()),
        };
        let (first, last) = (self.count_from, count - 1 + self.count_from);
        let (w, h) = (self.image.width(), self.image.height());
        let mut right = format!("{what} are {first} to {last}, as the scene's image is {w} x {h}");
        let turned = pixel.map(|pixel| Pixel { row: pixel.column, column: pixel.row });
        if turned.is_some_and(|turned| self.image.contains(turned)) {
            right += "; are rows and columns exchanged?";
        } else if self.count_from == 1 {
            right += ", and they are said to count from 1";
        }
        row.error(column, &right)
    }

    /// Checks that all that was read fits together.
    pub(super) fn finish(self) -> Result<(), FileError> {
        match self.beyond {
            Some(error) if self.has_zero => Err(error),
            _ => Ok(()),
        }
    }
}
