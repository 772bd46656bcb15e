//! The camera view: the traced picture, stretched without smoothing, and the selection drawn over it.

mod lens;
pub(super) mod loupe;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{DVec2, Pixel, ResolvedCamera, Scene};

use crate::overlay::{
    Colors, Drawing, Fills, Highlighted, LabelFont, LineStyle, Loupe, MARK, Mark, POINT, Picture,
    Request, Same, Shape, Style, UvLeg, dot, half_extent, mix, numbers, opposing_grey,
    place_labels, position_of, uv_legs,
};
use crate::{Concept, Inspection, Item, OverlayItems};

/// The inputs of the camera view. Equal inputs give the same picture, so they serve as the cache's key. The
/// scene is left out, because another scene has another `picture`.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraView {
    /// The edited camera.
    pub resolved: ResolvedCamera,
    /// The camera's picture.
    pub picture: Same<Picture>,
    /// The selected ray and its hits.
    pub inspection: Option<Same<Inspection>>,
    /// Width and height of the buffer in screen pixels. The whole image is stretched to fill it.
    pub size: [usize; 2],
    /// The overlay items to draw.
    pub items: OverlayItems,
    /// The number of the first row and column, 0 or 1.
    pub first_number: u32,
    /// Screen pixels per point.
    pub scale: f32,
    /// The colours.
    pub style: Style,
    /// The highlighted concept, if any.
    pub highlighted: Option<Highlighted>,
    /// The content of the loupe, if it is open.
    pub loupe: Option<Arc<Loupe>>,
    /// True if the marks are not painted into the picture, as for figures, which draw them separately.
    pub without_marks: bool,
}

/// Minimum size of an image pixel, in screen pixels, at which the edges between image pixels are drawn.
const GRID_FROM: f64 = 8.0;

/// Distance of the dimension lines of W and H from the picture's edges, in points, and the share of the edge at which their
/// labels stand.
const EDGE: f64 = 12.0;
const LABELLED: f64 = 0.3;

/// Minimum size of the picture, in points, in which its sides and corners have names.
const ROOM_FOR_NAMES: f64 = 160.0;

/// Fills the buffer with the picture and paints the overlay on it. Returns the drawing, whose labels
/// the caller must draw. If `scene` is `None`, no concept is highlighted.
pub fn camera(view: &CameraView, scene: Option<&Scene>, dots: &mut [Color32]) -> Drawing {
    let drawing = view.drawing(scene);
    let marks = if view.without_marks { Fills::default() } else { Fills::new(&drawing, view.size) };
    view.paint(&marks, dots);
    drawing
}

impl CameraView {
    fn extent(&self) -> DVec2 {
        DVec2::new(self.size[0] as f64, self.size[1] as f64)
    }

    /// Returns the number of screen pixels per pixel of the image, horizontally and vertically.
    fn dots_per_pixel(&self) -> DVec2 {
        let image = self.resolved.image();
        self.extent() / DVec2::new(image.width().into(), image.height().into())
    }

    /// Paints the picture, the edges between its pixels, and the marks.
    fn paint(&self, marks: &Fills, dots: &mut [Color32]) {
        let [width, height] = self.size;
        if dots.len() != width * height || !self.picture.is_whole() {
            return dots.fill(Color32::BLACK);
        }
        let picture = self.picture.on(self.size);
        let are_large = self.dots_per_pixel().min_element() >= GRID_FROM;
        let grid = (self.items.shows(Item::PixelGrid) && are_large).then(|| self.grid());
        marks.paint_after(width, dots, |top, dots| {
            picture.fill(top, dots);
            if let Some(grid) = &grid {
                self.paint_grid(grid, top, dots);
            }
        });
    }

    /// Returns, for each column and for each row of screen pixels, whether it lies on an edge between two
    /// pixels of the image.
    fn grid(&self) -> [Vec<bool>; 2] {
        let line = (self.scale.round() as usize).max(1);
        let (image, [width, height]) = (self.resolved.image(), self.size);
        [edges(image.width(), width, line), edges(image.height(), height, line)]
    }

    fn paint_grid(&self, [columns, rows]: &[Vec<bool>; 2], top: usize, dots: &mut [Color32]) {
        let behind = self.style.colors().background;
        let darken = |dot: &mut Color32| *dot = mix(*dot, opposing_grey(*dot, behind), 0.3);
        for (dots, on_edge) in dots.chunks_exact_mut(columns.len()).zip(&rows[top..]) {
            if *on_edge {
                dots.iter_mut().for_each(darken);
            } else {
                let on_edge = dots.iter_mut().zip(columns).filter(|(_, on)| **on);
                on_edge.for_each(|(dot, _)| darken(dot));
            }
        }
    }

    /// Returns the marks and labels without painting them.
    pub fn drawing(&self, scene: Option<&Scene>) -> Drawing {
        let mut overlay = CameraSketch::new(self, self.items);
        overlay.uv_axes();
        overlay.uv_legs();
        overlay.marks();
        overlay.pixel_numbers();
        overlay.selected();
        if let (Some(highlighted), Some(scene)) = (self.highlighted, scene) {
            overlay.highlight(highlighted, scene);
        }
        let requests = std::mem::take(&mut overlay.requests);
        place_labels(requests, &mut overlay.drawing, self.extent(), &[]);
        overlay.loupe();
        overlay.drawing
    }
}

/// Returns, for each of `dots` screen pixels in a row, whether it lies on an edge between two of `count`
/// cells. The edges are `width` screen pixels wide.
fn edges(count: u32, dots: usize, width: usize) -> Vec<bool> {
    let mut on = vec![false; dots];
    for k in 1..count as usize {
        // The first screen pixel that shows cell k; see `StretchedPicture`.
        let first = (2 * k * dots).saturating_sub(count as usize).div_ceil(2 * count as usize);
        let from = first.saturating_sub(width / 2);
        on[from.min(dots)..(from + width).min(dots)].fill(true);
    }
    on
}

/// The camera view's drawing while it is built.
pub(super) struct CameraSketch<'a> {
    view: &'a CameraView,
    items: OverlayItems,
    colors: &'static Colors,
    drawing: Drawing,
    requests: Vec<Request>,
}

impl<'a> CameraSketch<'a> {
    fn new(view: &'a CameraView, items: OverlayItems) -> CameraSketch<'a> {
        let drawing = Drawing { scale: view.scale, ..Drawing::default() };
        CameraSketch { view, items, colors: view.style.colors(), drawing, requests: Vec::new() }
    }

    fn add(&mut self, pen: LineStyle, shape: Shape) {
        if self.items.shows(pen.item) {
            let mark = pen.mark(shape, self.colors.background);
            self.drawing.marks.push(Mark { pattern: pen.pattern, ..mark });
        }
    }

    fn line(&mut self, points: &[DVec2], pen: LineStyle) {
        let points = points.iter().copied().map(dot).collect();
        self.add(pen, Shape::Line { points, width: pen.width * self.view.scale });
    }

    fn label(&mut self, pen: LineStyle, text: &str, anchor: DVec2, toward: DVec2, font: LabelFont) {
        if self.items.shows(Item::Labels) && self.items.shows(pen.item) {
            let (anchors, halo) = ([anchor, toward], self.colors.background);
            self.requests.push(Request::new(pen, text.to_owned(), anchors, font, halo));
        }
    }

    fn uv_axes(&mut self) {
        let (size, color) = (self.view.extent(), self.colors.ink);
        let middle = 0.5 * size;
        let across = [DVec2::new(0.0, middle.y), DVec2::new(size.x, middle.y)];
        let down = [DVec2::new(middle.x, 0.0), DVec2::new(middle.x, size.y)];
        let axes = [
            ("u", across, DVec2::new(size.x - 1.0, middle.y), Concept::U),
            ("v", down, DVec2::new(middle.x, 1.0), Concept::V),
        ];
        for (name, points, end, concept) in axes {
            let pen = LineStyle::new(Item::UvAxes, color, 1.0).about(concept);
            self.line(&points, pen);
            self.label(pen, name, end, middle - end, MARK);
        }
    }

    /// Draws the selected point's u and v, as two legs from the middle of the picture to the point.
    fn uv_legs(&mut self) {
        let Some(inspection) = &self.view.inspection else { return };
        let to_dots = |uv: DVec2| position_of(&self.view.resolved, self.view.size, uv);
        for UvLeg { text, axis, ends, outward } in uv_legs(inspection.uv) {
            let pen = LineStyle::new(Item::UvLegs, self.colors.basis[axis], 3.2);
            let [from, to] = ends.map(to_dots);
            self.line(&[from, to], pen);
            let outward = to_dots(outward) - to_dots(DVec2::ZERO);
            self.label(pen, &text, from.midpoint(to), outward, POINT);
        }
    }

    /// Draws the same marks as the world view: a thick top edge with a triangle on it, and a triangle
    /// at pixel (0, 0).
    fn marks(&mut self) {
        let (size, color) = (self.view.extent(), self.colors.mark);
        let scale = f64::from(self.view.scale);
        let side = (0.045 * size.min_element()).clamp(7.0 * scale, 18.0 * scale);
        let bar = 3.0 * scale;
        let rectangle =
            [DVec2::ZERO, DVec2::new(size.x, 0.0), DVec2::new(size.x, bar), DVec2::new(0.0, bar)];
        let middle = DVec2::new(0.5 * size.x, 0.0);
        let up =
            [middle, middle + DVec2::new(0.7, 1.1) * side, middle + DVec2::new(-0.7, 1.1) * side];
        let corner = [DVec2::ZERO, DVec2::new(side, 0.0), DVec2::new(0.0, side)];
        let pen = LineStyle::new(Item::Marks, color, 1.0);
        for polygon in [&rectangle[..], &up, &corner] {
            self.add(pen, Shape::polygon(polygon));
        }
        if size.min_element() > ROOM_FOR_NAMES * scale {
            let below = DVec2::new(0.0, 1.2 * side);
            self.label(pen, "top", middle + below, DVec2::Y, MARK);
            self.label(pen, "(0, 0)", DVec2::splat(0.4 * side), DVec2::ONE, MARK);
        }
    }

    /// Writes the numbers of columns and rows into the first row and column, and W and H at the opposite sides.
    fn pixel_numbers(&mut self) {
        if !self.items.shows(Item::Labels) || !self.items.shows(Item::PixelNumbers) {
            return;
        }
        let (size, cell) = (self.view.extent(), self.view.dots_per_pixel());
        let (image, scale) = (self.view.resolved.image(), f64::from(self.view.scale));
        let pen = LineStyle::new(Item::PixelNumbers, self.colors.ink, 1.0);
        let axes = [(DVec2::X, "W", image.width()), (DVec2::Y, "H", image.height())];
        for (axis, name, count) in axes {
            let other = DVec2::ONE - axis;
            let place = |k: u32, text: &str| {
                let inside = 0.5 * cell.max(2.0 * half_extent(text, scale) + 2.0 * scale);
                Some((f64::from(k) + 0.5) * cell * axis + inside.min(0.5 * size) * other)
            };
            let (ink, first) = ((pen, self.colors.background), self.view.first_number);
            self.requests.extend(numbers(ink, count, first, scale, place));
            if size.min_element() > ROOM_FOR_NAMES * scale {
                // A dimension line along the edge, whose label keeps off the axes of u and v.
                let [from, label, to] = [0.0, LABELLED, 1.0]
                    .map(|share| share * size * axis + (size - EDGE * scale) * other);
                for tip in [from, to] {
                    self.arrow([label, tip], LineStyle { width: 1.6, ..pen }, ("", POINT));
                }
                self.label(pen, &format!("{name} = {count}"), label, -other, POINT);
            }
        }
    }

    /// Draws a frame around the pixels that the selected ray touches, and a cross if the ray does not pass
    /// through the centre of a pixel. If the image's pixels are too small to be distinguished, draws only a
    /// frame around the ray's position.
    fn selected(&mut self) {
        let Some(inspection) = &self.view.inspection else { return };
        let pen = LineStyle::new(Item::Ray, self.colors.ray, 1.8).about(Concept::Pixel);
        let frame = LineStyle { width: 2.2, ..pen };
        let scale = f64::from(self.view.scale);
        let resolved = &self.view.resolved;
        let at = position_of(resolved, self.view.size, inspection.uv);
        let pixel_size = self.view.dots_per_pixel().min_element() / scale;
        let touched = inspection.touched(resolved);
        let centered = touched.len() == 1
            && position_of(resolved, self.view.size, resolved.uv_of_pixel(touched[0])).distance(at)
                < 0.01;
        if pixel_size >= 5.0 {
            touched.iter().for_each(|pixel| self.pixel(*pixel, frame));
        } else if !touched.is_empty() {
            let half = DVec2::splat(8.0 * scale);
            self.frame(at - half, at + half, frame);
        }
        let inside = at.cmpge(DVec2::ZERO).all() && at.cmple(self.view.extent()).all();
        if !inside || pixel_size < 5.0 {
            return;
        }
        if !centered {
            // Diagonal, as upright arms would lie on the frames of adjacent pixels.
            for diagonal in [DVec2::ONE, DVec2::new(1.0, -1.0)] {
                let arm = 6.5 * scale * diagonal;
                self.line(&[at - arm, at + arm], pen);
            }
        }
        if let (Some(hit), true) = (inspection.first_hit(), pixel_size >= 12.0) {
            let radius = 3.2 * self.view.scale;
            let pen = LineStyle { item: Item::Hit, ..pen }.about(inspection.concept_of(hit));
            self.add(pen, Shape::Disc { center: dot(at), radius });
        }
    }

    fn pixel(&mut self, Pixel { row, column }: Pixel, pen: LineStyle) {
        let per_pixel = self.view.dots_per_pixel();
        let corner = |row: u32, column: u32| DVec2::new(column.into(), row.into()) * per_pixel;
        self.frame(corner(row, column), corner(row + 1, column + 1), pen);
    }

    fn frame(&mut self, from: DVec2, to: DVec2, pen: LineStyle) {
        let points = [from, DVec2::new(to.x, from.y), to, DVec2::new(from.x, to.y), from];
        self.line(&points, pen);
    }
}
