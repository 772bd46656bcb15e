//! The parts of a figure, in dots from its upper left corner.

use egui::{Color32, ColorImage};

use super::typeface::Face;
use crate::view::overlay::Path;

/// A figure as vector formats are written from it; lengths in dots.
#[derive(Clone, Debug)]
pub(in crate::figures) struct Page<'a> {
    /// The title: what it shows, in words.
    pub(in crate::figures) title: &'a str,
    pub(in crate::figures) size: [usize; 2],
    /// The background, unless it is transparent.
    pub(in crate::figures) ground: Option<Color32>,
    /// All that is drawn, from the back to the front.
    pub(in crate::figures) primitives: Vec<Primitive>,
}

/// A primitive of a vector figure.
#[derive(Clone, Debug)]
pub(in crate::figures) enum Primitive {
    /// Pixels, stretched over the whole figure, nearest-neighbour.
    Picture(Picture),
    /// A fill or a stroke.
    Path(Path<'static>),
    /// Text.
    Text(Text),
}

/// Text that is written in one go.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figures) struct Text {
    pub(super) runs: Vec<Run>,
    /// A casing around all letters: its colour, and how far it reaches.
    pub(super) halo: Option<(Color32, f32)>,
}

/// Letters on one baseline, all of one font and colour.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub(super) text: String,
    pub(super) face: Face,
    /// The font's em.
    pub(super) size: f32,
    /// Start of the baseline.
    pub(super) at: [f32; 2],
    /// Distance of each letter from the next.
    pub(super) advances: Vec<f32>,
    pub(super) color: Color32,
    /// Lean of a letter to the right, for each unit of height.
    pub(super) slant: f32,
}

impl Run {
    pub(super) fn width(&self) -> f32 {
        self.advances.iter().sum()
    }
}

/// A picture that is stretched over the figure.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figures) struct Picture {
    pub(super) size: [usize; 2],
    /// Premultiplied, row by row from the top.
    pub(super) pixels: Vec<Color32>,
}

/// Programs that smooth what they enlarge get each pixel as several: the smaller side has at least so
/// many.
const LEAST_SIDE: usize = 600;

impl Picture {
    /// The picture with as few pixels as show the same: large ones need not be stored dot by dot.
    pub(in crate::figures) fn new(image: &ColorImage) -> Picture {
        let whole = Picture { size: image.size, pixels: image.pixels.clone() };
        let [width, height] = image.size;
        let [columns, rows] = [Picture::steps(image, false), Picture::steps(image, true)];
        let (Some(column), Some(row)) = (columns, rows) else { return whole };
        let (w, h) = (width / column, height / row);
        // So many for one, across and down.
        let times = LEAST_SIDE.div_ceil(w.min(h).max(1));
        if times >= column.min(row) {
            return whole;
        }
        let pixel = |k: usize, l: usize| image.pixels[k / times * row * width + l / times * column];
        let pixels = (0..h * times).flat_map(|k| (0..w * times).map(move |l| (k, l)));
        Picture { size: [w * times, h * times], pixels: pixels.map(|(k, l)| pixel(k, l)).collect() }
    }

    /// The side of the equal squares that a picture consists of, along rows or down columns; none if
    /// they are single dots.
    fn steps(image: &ColorImage, down: bool) -> Option<usize> {
        let [width, height] = image.size;
        let count = if down { height } else { width };
        // Where a line of dots differs from the one before it.
        let differs = |k: usize| match down {
            true => image.pixels[k * width..][..width] != image.pixels[(k - 1) * width..][..width],
            false => (0..height)
                .any(|row| image.pixels[row * width + k] != image.pixels[row * width + k - 1]),
        };
        let side = (1..count).filter(|k| differs(*k)).fold(count, gcd);
        (side > 1).then_some(side)
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of `w` x `h` different pixels, each so many dots wide and high.
    fn enlarged([w, h]: [usize; 2], [across, down]: [usize; 2]) -> ColorImage {
        let dots = (0..h * down).flat_map(|k| (0..w * across).map(move |l| (k / down, l / across)));
        let color = |(k, l): (usize, usize)| Color32::from_rgb(k as u8, l as u8, 9);
        ColorImage::new([w * across, h * down], dots.map(color).collect())
    }

    #[test]
    fn large_pixels_are_stored_once_each_where_they_are_many() {
        let picture = Picture::new(&enlarged([700, 650], [3, 2]));
        assert_eq!(picture.size, [700, 650]);
        assert_eq!(picture.pixels, enlarged([700, 650], [1, 1]).pixels);
        // Where they are few, as several, so that smoothing does not blur them.
        let few = Picture::new(&enlarged([4, 3], [300, 400]));
        assert_eq!(few.size, [800, 600]);
        assert_eq!(few.pixels, enlarged([4, 3], [200, 200]).pixels);
    }

    #[test]
    fn what_is_no_enlarged_picture_is_stored_dot_by_dot() {
        for image in
            [enlarged([40, 30], [1, 1]), enlarged([40, 30], [1, 5]), enlarged([4, 3], [5, 5])]
        {
            let picture = Picture::new(&image);
            assert_eq!((picture.size, picture.pixels), (image.size, image.pixels));
        }
    }
}
