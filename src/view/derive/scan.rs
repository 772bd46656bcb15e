//! A picture of which a renderer has finished only a part so far.

use egui::Color32;

use crate::view::overlay::Picture;

/// Colours of unscanned pixels: squares in two greys, which no picture of spheres has.
const NOT_YET: [Color32; 2] = [Color32::from_gray(92), Color32::from_gray(116)];

/// Number of squares along a picture's shorter side.
const SQUARES: usize = 16;

/// Returns the picture with only the first `scanned_pixels` pixels of the image, row by row.
pub(super) fn first_pixels(picture: &Picture, scanned_pixels: u64) -> Picture {
    let mut part = picture.clone();
    let width = u64::from(picture.image.width());
    let (rows, columns) = (picture.raster.rows(), picture.raster.columns());
    let side = (rows.len().min(columns.len()) / SQUARES).max(1);
    for (i, (row, pixels)) in rows.iter().zip(part.pixels.chunks_mut(columns.len())).enumerate() {
        // Number of finished columns of this row.
        let done = scanned_pixels.saturating_sub(u64::from(*row) * width);
        let from = columns.partition_point(|column| u64::from(*column) < done);
        for (j, pixel) in pixels.iter_mut().enumerate().skip(from) {
            *pixel = NOT_YET[(i / side + j / side) % 2];
        }
    }
    part
}
