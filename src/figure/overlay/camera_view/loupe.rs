//! The loupe (a magnifier) of the camera view. It enlarges the pixels around the selected (u, v) to show
//! whether that position lies in the middle of a pixel, on an edge or on a corner.

use std::ops::Range;

use egui::Color32;
use pinhole_core::{DVec2, ImageSize, Pixel, PixelOfUv};

use crate::overlay::{
    CameraSketch, CameraView, Colors, Label, LineStyle, Picture, Shape, dot, position_of, wide,
};
use crate::{Concept, Item};

/// Maximum side of the square of magnified pixels, in points.
const CELLS: f64 = 240.0;
/// Maximum fractions of the view's width and height that the loupe takes. It takes less than half of the
/// height, so that it does not cover the selected position, and no large part of an object.
const SHARE: DVec2 = DVec2::new(0.6, 0.42);
/// Distance of the loupe from the view's edges, in points.
const MARGIN: f64 = 10.0;
/// Half the length of the cross at the selected position, as a fraction of a magnified pixel's side.
const ARM: f64 = 0.22;
/// Height of the loupe's text, in points.
const TEXT: f32 = 15.0;
/// Size of the loupe's rim, in points: its width at the left, for the row labels, and its height at the top
/// and bottom, for a line of text.
const RIM: DVec2 = DVec2::new(62.0, 23.0);

/// The content of the loupe.
#[derive(Clone, Debug, PartialEq)]
pub struct Loupe {
    /// The pixels around the selected position, all of them traced.
    pub picture: Picture,
    /// Number of pixels shown across and down; odd.
    pub shown_pixels: u32,
    /// True if rows and columns are counted from 1, as some courses do.
    pub count_from_one: bool,
}

/// Returns the rows and columns that the loupe shows, clipped to the image. The selected position lies in
/// the middle pixel or, if it lies on an edge, between the two middle pixels.
pub fn loupe_window(position: &PixelOfUv, image: ImageSize, pixels: u32) -> [Range<u32>; 2] {
    let around = |edge: Option<u32>, index: u32, count: u32| {
        let half = pixels / 2;
        let (middle, end) = edge.map_or((index, index + 1), |edge| (edge, edge));
        middle.saturating_sub(half)..(end + half).min(count)
    };
    [
        around(position.row_edge, position.pixel.row, image.height()),
        around(position.column_edge, position.pixel.column, image.width()),
    ]
}

/// The position and size of the loupe in the view.
struct Inset {
    /// Upper left corner, in screen pixels. The rims are included.
    from: DVec2,
    /// Size in screen pixels. The rims are included.
    size: DVec2,
    /// The position in the image that is shown at the middle of the magnified pixels: x in columns, y in
    /// rows, both with fractions.
    middle: DVec2,
    /// Position of the middle of the cells, in screen pixels.
    center: DVec2,
    /// Side of a cell, in screen pixels.
    cell: f64,
}

impl Inset {
    /// Returns the open loupe, the selected position in the image and in screen pixels, and the loupe's
    /// place in the view. Returns `None` if no loupe is open.
    fn open(view: &CameraView) -> Option<(&Loupe, PixelOfUv, DVec2, Inset)> {
        let loupe = view.loupe.as_deref().filter(|loupe| loupe.picture.is_whole())?;
        let inspection = view.inspection.as_ref().filter(|_| view.items.shows(Item::Loupe))?;
        let (position, at) =
            (inspection.image_position?, position_of(&view.resolved, view.size, inspection.uv));
        Some((loupe, position, at, Inset::new(view, loupe.shown_pixels, &position, at)))
    }

    /// Places the loupe in the corner of the view where it hides the fewest outlines in the picture, and not
    /// the selected position. Among equal corners, it takes the one farthest from that position.
    fn new(view: &CameraView, pixels: u32, position: &PixelOfUv, at: DVec2) -> Inset {
        let (extent, scale) = (view.extent(), f64::from(view.scale));
        // On a corner, as many pixels are shown on either side, so one fewer each way.
        let is_corner = position.row_edge.is_some() && position.column_edge.is_some();
        let pixels = f64::from(if is_corner { pixels - 1 } else { pixels });
        let rim = scale * RIM;
        let room = SHARE * extent - DVec2::new(rim.x, 2.0 * rim.y);
        let cell = (scale * CELLS).min(room.min_element()) / pixels;
        let cell = cell.max(4.0 * scale);
        let cells = DVec2::splat(pixels * cell);
        let size = cells + DVec2::new(rim.x + 6.0 * scale, 2.0 * rim.y);
        let margin = DVec2::splat(scale * MARGIN);
        let corners = [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE];
        let mut places = corners.map(|corner| margin + corner * (extent - size - 2.0 * margin));
        let distance = |from: &DVec2| at.distance(at.clamp(*from, *from + size));
        places.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
        let picture = view.picture.0.on(view.size);
        let free = places.into_iter().filter(|from| distance(from) >= margin.x);
        let from = free.min_by_key(|from| picture.outlines_in(*from, *from + size));
        let from = from.unwrap_or(places[0]);
        let middle = |edge: Option<u32>, index: u32| edge.map_or(f64::from(index) + 0.5, f64::from);
        let pixel = position.pixel;
        Inset {
            from,
            size,
            middle: DVec2::new(
                middle(position.column_edge, pixel.column),
                middle(position.row_edge, pixel.row),
            ),
            center: from + rim + 0.5 * cells,
            cell,
        }
    }

    /// Returns the middle of the rim, in screen pixels: the x of the row labels and the y of the column
    /// labels.
    fn rim(&self, scale: f64) -> DVec2 {
        self.from + 0.5 * scale * RIM
    }

    /// Returns the position on the screen at which the loupe shows a point of the image. `x` and `y` are in
    /// pixels of the image, from its upper left corner.
    fn to_screen(&self, x: f64, y: f64) -> DVec2 {
        self.center + self.cell * (DVec2::new(x, y) - self.middle)
    }
}

impl CameraSketch<'_> {
    /// Draws the loupe on top of everything else.
    pub(super) fn loupe(&mut self) {
        let (view, colors) = (self.view, self.colors);
        let Some((loupe, position, at, inset)) = Inset::open(view) else { return };
        let end = inset.from + inset.size;
        let pen = |color: Color32, width: f32| LineStyle::new(Item::Loupe, color, width);
        // A leader along a row or a column would look like a leg of u or v.
        self.line(&[at, 0.5 * (inset.from + end)], pen(colors.ray, 1.5));
        self.filled(inset.from, end, pen(colors.background, 1.0));
        self.frame(inset.from, end, pen(colors.ink, 2.0));
        self.cells(&inset, loupe);
        let touched = position.touching(view.resolved.image());
        // One frame around all of them leaves the pixels themselves in sight.
        if let (Some(first), Some(last)) = (touched.first(), touched.last()) {
            let corner = |pixel: &Pixel, k: u32| {
                inset.to_screen(f64::from(pixel.column + k), f64::from(pixel.row + k))
            };
            let pen = pen(colors.ray, 2.5).about(Concept::Pixel);
            self.frame(corner(first, 0), corner(last, 1), pen);
        }
        let per_pixel = view.dots_per_pixel();
        let spot = inset.to_screen(at.x / per_pixel.x, at.y / per_pixel.y);
        for axis in [DVec2::X, DVec2::Y] {
            let arm = ARM * inset.cell * axis;
            self.line(&[spot - arm, spot + arm], pen(colors.ray, 2.5).about(Concept::Pixel));
        }
        self.loupe_labels(loupe, &touched, &inset);
    }

    /// Adds the loupe's texts (row and column numbers, and whether the position is on an edge or corner),
    /// and removes labels that the loupe covers.
    fn loupe_labels(&mut self, loupe: &Loupe, touched: &[Pixel], inset: &Inset) {
        let CameraView { resolved, scale, size, inspection, .. } = self.view;
        let (low, high) = (inset.from, inset.from + inset.size);
        self.drawing.labels.retain(|label| {
            let offset = wide(label.position) - 0.5 * (low + high);
            offset.abs().cmpgt(0.5 * (high - low) + wide(label.half_extent(*scale))).any()
        });
        let mut texts = texts(touched, loupe, inset, f64::from(*scale));
        let is_centre = |pixel: &Pixel| {
            let centre = resolved.uv_of_pixel(*pixel);
            inspection.as_ref().is_some_and(|inspection| inspection.uv == centre)
        };
        let kind = match touched {
            [_, _, _, _] => "corner of 4 pixels",
            [_, _] => "between 2 pixels",
            [only] if is_centre(only) => "centre of a pixel",
            _ => "inside a pixel",
        };
        let below = high.y - 0.5 * f64::from(*scale) * RIM.y;
        texts.push((kind.to_owned(), DVec2::new(0.5 * (low.x + high.x), below)));
        let (width, Colors { ink, background, .. }) = (size[0] as f32, self.colors);
        self.drawing.labels.extend(texts.into_iter().map(|(text, center)| {
            let (item, position, bold) = (Item::Loupe, dot(center), false);
            let (color, halo) = (*ink, *background);
            let mut label = Label { item, position, text, color, halo, size: TEXT, bold };
            // A small loupe, which is narrower than its text, may lie at the edge of the view.
            let [half, _] = label.half_extent(*scale);
            label.position[0] = label.position[0].min(width - half).max(half);
            label
        }));
    }

    fn filled(&mut self, from: DVec2, to: DVec2, pen: LineStyle) {
        let corners = [from, DVec2::new(to.x, from.y), to, DVec2::new(from.x, to.y)];
        self.add(pen, Shape::polygon(&corners));
    }

    fn cells(&mut self, inset: &Inset, loupe: &Loupe) {
        let raster = &loupe.picture.raster;
        let columns = raster.columns();
        for (row, pixels) in raster.rows().iter().zip(loupe.picture.pixels.chunks(columns.len())) {
            for (column, color) in columns.iter().zip(pixels) {
                let corner = |k: u32| inset.to_screen(f64::from(column + k), f64::from(row + k));
                let edge = LineStyle::new(Item::Loupe, self.colors.ink.gamma_multiply(0.6), 1.0);
                let (from, to) = (corner(0), corner(1));
                self.filled(from, to, LineStyle::new(Item::Loupe, *color, 1.0));
                self.frame(from, to, edge);
                // Cells have no halo, since pixels have none.
                self.drawing.marks.iter_mut().rev().take(2).for_each(|mark| mark.halo = None);
            }
        }
    }
}

/// Returns the loupe's texts with their centres: at the left, the numbers of the rows that the position
/// touches; at the top, the numbers of the columns, and the word `column`.
fn texts(touched: &[Pixel], loupe: &Loupe, inset: &Inset, scale: f64) -> Vec<(String, DVec2)> {
    let mut rows: Vec<u32> = touched.iter().map(|pixel| pixel.row).collect();
    let mut columns: Vec<u32> = touched.iter().map(|pixel| pixel.column).collect();
    rows.dedup();
    columns.sort_unstable();
    columns.dedup();
    let (rim, text, first) = (inset.rim(scale), f64::from(TEXT), u32::from(loupe.count_from_one));
    let row = |row: &u32| {
        // Two labels next to each other may need more space than the two magnified pixels have.
        let offset = inset.to_screen(0.0, f64::from(*row) + 0.5).y - inset.center.y;
        let y = if rows.len() == 1 {
            offset
        } else {
            offset.signum() * offset.abs().max(0.64 * text * scale)
        };
        (format!("row {}", row + first), DVec2::new(rim.x, inset.center.y + y))
    };
    let column = |(k, column): (usize, &u32)| {
        let name = (column + first).to_string();
        let half = scale * text * (0.3 * name.len() as f64 + 0.25);
        let shift = if columns.len() == 1 { 0.0 } else { half * (2.0 * k as f64 - 1.0) };
        (name, DVec2::new(inset.center.x + shift, rim.y))
    };
    let columns = columns.iter().enumerate().map(column);
    rows.iter().map(row).chain(columns).chain([("column".to_owned(), rim)]).collect()
}
