//! The traced picture of the edited camera, shown with sharp pixels.

use egui::Color32;
use pinhole_core::{ImageSize, Raster};

/// The picture of the edited camera: one colour per traced pixel of its image.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The traced rows and columns of the image.
    pub raster: Raster,
    /// The image that the raster samples.
    pub image: ImageSize,
    /// The colours of the raster, row by row; opaque.
    pub pixels: Vec<Color32>,
}

impl Picture {
    /// Returns true if there is a colour for every traced pixel, and at least one.
    pub(crate) fn is_whole(&self) -> bool {
        !self.raster.is_empty() && self.pixels.len() == self.raster.len()
    }

    /// Prepares the picture for a buffer of `columns` x `rows` dots.
    pub(crate) fn on(&self, [columns, rows]: [usize; 2]) -> StretchedPicture<'_> {
        let [nearest_row, nearest_column] = self.raster.nearest(self.image);
        let pixel = |k: usize, dots: usize, count: u32| (2 * k + 1) * count as usize / (2 * dots);
        let column_of = |k| nearest_column[pixel(k, columns, self.image.width())];
        let row_of = |k| nearest_row[pixel(k, rows, self.image.height())];
        StretchedPicture {
            picture: self,
            columns: (0..columns).map(column_of).collect(),
            rows: (0..rows).map(row_of).collect(),
        }
    }
}

/// A picture stretched over a buffer of dots, nearest-neighbour: dot `k` of `n` shows pixel
/// `floor((2k + 1) W / (2n))`, the pixel that [`Raster::shown_on`] traces for it.
pub(crate) struct StretchedPicture<'a> {
    picture: &'a Picture,
    /// The column, and the row, of the traced pixel that each column and row of dots shows.
    columns: Vec<usize>,
    rows: Vec<usize>,
}

impl StretchedPicture<'_> {
    /// Fills a band of the buffer whose first row of dots is `top`.
    pub(crate) fn fill(&self, top: usize, dots: &mut [Color32]) {
        let (dots_a_row, width) = (self.columns.len(), self.picture.raster.columns().len());
        for (k, row) in (top..self.rows.len()).take(dots.len() / dots_a_row.max(1)).enumerate() {
            let own = self.rows[row];
            // All rows of dots that show one row of pixels are equal: copy the first.
            if k > 0 && self.rows[row - 1] == own {
                dots.copy_within((k - 1) * dots_a_row..k * dots_a_row, k * dots_a_row);
                continue;
            }
            let source = &self.picture.pixels[own * width..][..width];
            for (dot, column) in dots[k * dots_a_row..].iter_mut().zip(&self.columns) {
                *dot = source[*column];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use pinhole_core::Pixel;

    use super::*;

    fn counted(image: ImageSize, raster: Raster) -> Picture {
        let color = |row: &u32, column: &u32| Color32::from_rgb(*row as u8, *column as u8, 7);
        let pixels = raster
            .rows()
            .iter()
            .flat_map(|row| raster.columns().iter().map(move |column| color(row, column)))
            .collect();
        Picture { raster, image, pixels }
    }

    #[test]
    fn dots_show_what_the_raster_for_them_traced() {
        for (w, h, columns, rows) in [(7, 5, 3, 4), (7, 5, 23, 17), (100, 60, 9, 60), (1, 1, 4, 4)]
        {
            let image = ImageSize::new(w, h).expect("a size");
            let full = counted(image, Raster::full(image));
            let some = counted(image, Raster::shown_on(image, columns, rows));
            let (columns, rows) = (columns as usize, rows as usize);
            let mut from_full = vec![Color32::BLACK; columns * rows];
            let mut from_some = from_full.clone();
            full.on([columns, rows]).fill(0, &mut from_full);
            some.on([columns, rows]).fill(0, &mut from_some);
            assert_eq!(from_full, from_some);
            let last = from_full[columns * rows - 1];
            let middle = |n: usize, count: u32| ((2 * n - 1) * count as usize / (2 * n)) as u8;
            assert_eq!((last.r(), last.g()), (middle(rows, h), middle(columns, w)));
        }
    }

    #[test]
    fn a_pixel_left_out_has_the_colour_of_its_neighbour() {
        let image = ImageSize::new(10, 10).expect("a size");
        let picture = counted(image, Raster::shown_on(image, 2, 2));
        assert_eq!(picture.raster.rows(), [2, 7]);
        let row_of = |row| {
            let offset = picture.raster.nearest_to(Pixel { row, column: 0 })?;
            picture.pixels.get(offset).map(|c| c.r())
        };
        assert_eq!(row_of(0), Some(2));
        assert_eq!(row_of(4), Some(2));
        assert_eq!(row_of(5), Some(7));
        assert_eq!(row_of(9), Some(7));
        let [rows, _] = picture.raster.nearest(image);
        assert!((0..10).all(|row| {
            let nearest = picture.raster.rows()[rows[row as usize]];
            row_of(row) == Some(nearest as u8)
        }));
    }
}
