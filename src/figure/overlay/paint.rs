//! Painting of pixels: marks are painted directly into a picture, and the edited camera's picture is stretched
//! over a view without smoothing.

use egui::Color32;
use pinhole_core::{DVec2, ImageSize, Raster};
use rayon::prelude::*;
use tiny_skia::{LineCap, LineJoin, PathSegment, Stroke, StrokeDash};
use vello_common::fearless_simd::Level;
use vello_common::geometry::RectU16;
use vello_common::kurbo::{Affine, PathEl, Point, flatten};
use vello_common::peniko::Fill;
use vello_common::strip::{StripFillSegment, visit_strip_fill_segments};
use vello_common::strip_generator::{StripGenerator, StripStorage};
use vello_common::tile::Tile;

use crate::overlay::drawing::{Drawing, Ink, Path};
use crate::painter::{Rgba, UNIT, fill, over, unpack};

/// Number of rows painted at a time, few enough that their pixels fit into the cache.
const BAND: usize = 32;

/// Number of rows of a strip.
const ROWS: usize = Tile::HEIGHT as usize;

/// Maximum distance of a curve from the lines that are painted for it, in screen pixels.
const FLATNESS: f64 = 0.02;

/// Paths prepared for painting: which part of each pixel a path covers, and its colour.
#[derive(Debug, Default)]
pub(super) struct Fills(Vec<(StripStorage, Rgba)>);

impl Fills {
    /// Prepares the marks of a drawing for a picture of this width and height.
    pub(super) fn new(drawing: &Drawing, size: [usize; 2]) -> Fills {
        Fills::of_paths(&drawing.paths().collect::<Vec<_>>(), size)
    }

    fn of_paths(paths: &[Path], size: [usize; 2]) -> Fills {
        let [width, height] = size.map(|n| u16::try_from(n).unwrap_or(u16::MAX));
        let generator = || StripGenerator::new(width, height, Level::new());
        let fills = paths.par_iter().with_min_len(8).map_init(generator, |generator, path| {
            let mut strips = StripStorage::default();
            let (fill, unmoved) = (Fill::NonZero, Affine::IDENTITY);
            let lines = outlined(path).map(|outline| lines_of(&outline)).unwrap_or_default();
            generator.generate_filled_path(lines, fill, unmoved, None, &mut strips, None);
            (strips, unpack(path.color))
        });
        Fills(fills.collect())
    }

    /// Paints the paths over a picture of `width` screen pixels per row, in parallel bands of rows. For
    /// each band, first calls `before` with the band's first row and its pixels.
    pub(super) fn paint_after(
        &self,
        width: usize,
        dots: &mut [Color32],
        before: impl Fn(usize, &mut [Color32]) + Sync,
    ) {
        if width == 0 {
            return;
        }
        dots.par_chunks_mut(BAND * width).enumerate().for_each(|(band, dots)| {
            before(band * BAND, dots);
            for (strips, color) in &self.0 {
                paint_strips(strips, *color, band * BAND, width, dots);
            }
        });
    }
}

/// Blends a colour over the pixels that a path covers in a band of rows, of which `top` is the first.
fn paint_strips(
    StripStorage { strips, alphas, .. }: &StripStorage,
    color: Rgba,
    top: usize,
    width: usize,
    mut dots: &mut [Color32],
) {
    let tile = |dots: usize| dots.div_ceil(ROWS) as u16;
    let bounds = RectU16::new(0, tile(top), tile(width), tile(top + dots.len() / width));
    let first = strips.partition_point(|strip| usize::from(strip.y) < top);
    visit_strip_fill_segments(
        &strips[first..],
        bounds,
        &mut dots,
        |dots, segment| {
            let columns = alphas[segment.alpha_idx as usize..].chunks_exact(ROWS);
            for (row, run) in runs(dots, width, top, segment.fill).enumerate() {
                for (dot, column) in run.iter_mut().zip(columns.clone()) {
                    let share = f32::from(column[row]) * UNIT;
                    if share > 0.0 {
                        *dot = over(*dot, color.map(|channel| channel * share));
                    }
                }
            }
        },
        |dots, segment| runs(dots, width, top, segment).for_each(|run| fill(run, color)),
    );
}

/// Returns the pixels of a segment row by row, in a band of rows of which `top` is the first.
fn runs(
    dots: &mut [Color32],
    width: usize,
    top: usize,
    segment: StripFillSegment,
) -> impl Iterator<Item = &mut [Color32]> {
    let rows = dots.chunks_mut(width).skip(usize::from(segment.y()) - top).take(ROWS);
    let run = usize::from(segment.x0())..usize::from(segment.x1()).min(width);
    rows.map(move |row| &mut row[run.clone()])
}

/// Paints paths over a picture of `width` screen pixels per row.
pub fn paint_paths(paths: &[Path], width: usize, dots: &mut [Color32]) {
    let height = dots.len() / width.max(1);
    Fills::of_paths(paths, [width, height]).paint_after(width, dots, |_, _| ());
}

/// Returns an outline without curves.
fn lines_of(outline: &tiny_skia::Path) -> Vec<PathEl> {
    let at = |p: tiny_skia::Point| Point::new(p.x.into(), p.y.into());
    let elements = outline.segments().map(|segment| match segment {
        PathSegment::MoveTo(to) => PathEl::MoveTo(at(to)),
        PathSegment::LineTo(to) => PathEl::LineTo(at(to)),
        PathSegment::QuadTo(a, to) => PathEl::QuadTo(at(a), at(to)),
        PathSegment::CubicTo(a, b, to) => PathEl::CurveTo(at(a), at(b), at(to)),
        PathSegment::Close => PathEl::ClosePath,
    });
    let mut lines = Vec::new();
    flatten(elements, FLATNESS, |element| lines.push(element));
    lines
}

/// Returns the outline of the area to fill: that of the path or, for a stroke, that of the stroked line.
/// Returns `None` if it is empty.
fn outlined(path: &Path) -> Option<tiny_skia::Path> {
    let outline = path.outline.to_path()?;
    let Ink::Stroke { width, round, dash } = path.ink else { return Some(outline) };
    let outline = match dash.and_then(|dash| StrokeDash::new(dash.to_vec(), 0.0)) {
        Some(dash) => outline.dash(&dash, 1.0)?,
        None => outline,
    };
    let stroke = Stroke {
        width,
        line_cap: if round { LineCap::Round } else { LineCap::Butt },
        line_join: LineJoin::Round,
        ..Stroke::default()
    };
    outline.stroke(&stroke, 1.0)
}

/// The picture of the edited camera, with one colour for each traced pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The traced rows and columns of the image.
    pub raster: Raster,
    /// The size of the image to which the raster belongs.
    pub image: ImageSize,
    /// The colours of the raster's pixels, row by row.
    pub pixels: Vec<Color32>,
}

impl Picture {
    /// Returns true if at least one pixel is traced and every traced pixel has a colour.
    pub(crate) fn is_whole(&self) -> bool {
        !self.raster.is_empty() && self.pixels.len() == self.raster.len()
    }

    /// Prepares the picture for stretching over a buffer of `columns` x `rows` screen pixels.
    pub(crate) fn on(&self, [columns, rows]: [usize; 2]) -> StretchedPicture<'_> {
        let [nearest_row, nearest_column] = self.raster.nearest(self.image);
        let pixel = |k: usize, dots: usize, count: u32| (2 * k + 1) * count as usize / (2 * dots);
        let width = self.raster.columns().len();
        let column_of = |k| nearest_column[pixel(k, columns, self.image.width())];
        let row_of = |k| nearest_row[pixel(k, rows, self.image.height())] * width;
        StretchedPicture {
            picture: self,
            columns: (0..columns).map(column_of).collect(),
            rows: (0..rows).map(row_of).collect(),
        }
    }
}

/// Distance of the screen pixels that are compared in search of outlines.
const SAMPLE: usize = 8;
/// Change of a colour's component from which it is an outline.
const OUTLINE: u8 = 32;

/// A picture stretched over a buffer of screen pixels, nearest-neighbour. Of n screen pixels in a row,
/// number k shows the pixel `floor((2k + 1) W / (2n))` of the image's W: the one that [`Raster::shown_on`]
/// traces for it.
pub(crate) struct StretchedPicture<'a> {
    picture: &'a Picture,
    /// The traced column that each column of screen pixels shows.
    columns: Vec<usize>,
    /// The index of the first pixel of the traced row that each row of screen pixels shows.
    rows: Vec<usize>,
}

impl StretchedPicture<'_> {
    /// Returns the colour of a screen pixel.
    #[inline(always)]
    pub(crate) fn color(&self, row: usize, column: usize) -> Color32 {
        self.picture.pixels[self.rows[row] + self.columns[column]]
    }

    /// Returns how many outlines, that is, abrupt changes of colour, are met on lines across and down a
    /// rectangle of screen pixels.
    pub(crate) fn outlines_in(&self, from: DVec2, to: DVec2) -> usize {
        let samples = |from: f64, to: f64, count: usize| -> Vec<usize> {
            let [from, to] = [from, to].map(|at| at.clamp(0.0, count as f64) as usize);
            (from..to).step_by(SAMPLE).collect()
        };
        let rows = samples(from.y, to.y, self.rows.len());
        let columns = samples(from.x, to.x, self.columns.len());
        let differs = |a: [usize; 2], b: [usize; 2]| {
            let [a, b] = [a, b].map(|[row, column]| self.color(row, column).to_array());
            a.iter().zip(b).any(|(a, b)| a.abs_diff(b) > OUTLINE)
        };
        let across = rows.iter().flat_map(|row| {
            columns.windows(2).filter(move |pair| differs([*row, pair[0]], [*row, pair[1]]))
        });
        let down = columns.iter().flat_map(|column| {
            rows.windows(2).filter(move |pair| differs([pair[0], *column], [pair[1], *column]))
        });
        across.count() + down.count()
    }

    /// Fills a band of rows of the buffer, of which `top` is the first.
    pub(crate) fn fill(&self, top: usize, dots: &mut [Color32]) {
        let dots_a_row = self.columns.len();
        for (k, row) in (top..self.rows.len()).take(dots.len() / dots_a_row.max(1)).enumerate() {
            let start = self.rows[row];
            // Rows of the screen that show the same row of the image are equal, so the previous one is
            // copied.
            if k > 0 && self.rows[row - 1] == start {
                dots.copy_within((k - 1) * dots_a_row..k * dots_a_row, k * dots_a_row);
                continue;
            }
            let source = &self.picture.pixels[start..];
            for (dot, column) in dots[k * dots_a_row..].iter_mut().zip(&self.columns) {
                *dot = source[*column];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::overlay::drawing::PathOutline;

    const WIDTH: usize = 40;

    /// Paints a path in white on 40 x 100 black pixels, which span several bands, and returns the covered
    /// fraction of each pixel.
    fn covered(points: &[[f32; 2]], ink: Ink) -> Vec<f32> {
        let outline = PathOutline::Chain { points: points.into(), closed: true };
        let path = Path { outline, color: Color32::WHITE, ink };
        let mut dots = vec![Color32::BLACK; WIDTH * 100];
        paint_paths(&[path], WIDTH, &mut dots);
        dots.into_iter().map(|dot| f32::from(dot.r()) / 255.0).collect()
    }

    #[test]
    fn bands_have_no_seam() {
        let shares = covered(&[[5.5, 3.0], [35.5, 3.0], [35.5, 97.0], [5.5, 97.0]], Ink::Fill);
        for (row, shares) in shares.chunks(WIDTH).enumerate() {
            let inside = if (3..97).contains(&row) { 1.0 } else { 0.0 };
            assert!(shares[6..35].iter().all(|share| *share == inside), "{row}");
            assert!((shares[5] - 0.5 * inside).abs() < 0.01, "{row}");
        }
    }

    #[test]
    fn a_small_disc_covers_its_area() {
        for radius in [2.0_f32, 3.0, 9.0] {
            let outline = PathOutline::Circle { center: [20.3, 31.6], radius };
            let path = Path { outline, color: Color32::WHITE, ink: Ink::Fill };
            let mut dots = vec![Color32::BLACK; WIDTH * 100];
            paint_paths(&[path], WIDTH, &mut dots);
            let covered: f32 = dots.iter().map(|dot| f32::from(dot.r()) / 255.0).sum();
            let area = std::f32::consts::PI * radius * radius;
            assert!((covered / area - 1.0).abs() < 0.02, "{radius}: {covered}, not {area}");
        }
    }

    #[test]
    fn a_strokes_overlaps_are_painted_once() {
        let ink = Ink::Stroke { width: 4.0, round: true, dash: None };
        let shares = covered(&[[8.0, 8.0], [30.0, 8.0], [30.0, 22.0], [8.0, 22.0]], ink);
        let at = |x: usize, y: usize| shares[y * WIDTH + x];
        assert_eq!([at(8, 7), at(20, 8), at(29, 21), at(8, 15)], [1.0; 4]);
        assert_eq!([at(20, 15), at(2, 2), at(35, 15)], [0.0; 3], "inside and beside it");
    }

    #[test]
    fn what_lies_beside_the_picture_or_is_no_number_leaves_it_alone() {
        for far in [-100.0, 100.0, 1e9, -1e30, f32::INFINITY, f32::NAN] {
            for [x, y] in [[far, 10.0], [10.0, far]] {
                let shares = covered(&[[x, y], [x + 9.0, y], [x + 9.0, y + 9.0]], Ink::Fill);
                assert!(shares.iter().all(|share| *share == 0.0), "{x} {y}");
            }
        }
    }
}

#[cfg(test)]
mod picture_tests {
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
