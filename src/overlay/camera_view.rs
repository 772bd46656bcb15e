//! The camera view: the traced picture, pixels as pixels, with what is selected in it.

use std::borrow::Cow;

use egui::Color32;
use pinhole_core::{DVec2, ImageSize, Pixel, ResolvedCamera};

use crate::inspection::Inspection;
use crate::overlay::camera_in_space::MARK_TEXT;
use crate::overlay::drawing::{Drawing, Mark, Shape, dot};
use crate::overlay::items::{Item, OverlayItems};
use crate::overlay::labels::{self, Request};
use crate::overlay::layers::{contrast, mix};
use crate::overlay::lit::Lit;
use crate::overlay::loupe::{self, Loupe};
use crate::overlay::picture::Picture;
use crate::overlay::sketch::Pen;
use crate::overlay::style::{Colors, Style};
use crate::thing::Thing;

/// Everything that the camera view shows.
#[derive(Clone, Copy, Debug)]
pub struct CameraView<'a> {
    /// The edited camera.
    pub resolved: &'a ResolvedCamera,
    /// What it sees.
    pub picture: &'a Picture,
    /// The selected ray.
    pub inspection: Option<&'a Inspection>,
    /// Width and height of the buffer in dots. All of the image is stretched over it.
    pub size: [usize; 2],
    /// What to draw.
    pub items: OverlayItems,
    /// Dots per point.
    pub scale: f32,
    /// The colours.
    pub style: Style,
    /// What is lit, if anything.
    pub lit: Option<Lit<'a>>,
    /// What is under the loupe.
    pub loupe: Option<&'a Loupe>,
}

/// Pixels smaller than this many dots have no grid.
const GRID_FROM: f64 = 8.0;

/// Fills the buffer with the picture and paints over it; what was painted, and which text belongs
/// where.
pub fn camera(view: &CameraView, dots: &mut [Color32]) -> Drawing {
    let drawing = camera_apart(view, dots);
    drawing.paint(view.size[0], dots);
    drawing
}

/// The same without painting the drawing.
pub fn camera_apart(view: &CameraView, dots: &mut [Color32]) -> Drawing {
    let [width, height] = view.size;
    if width == 0 || dots.len() != width * height {
        return Drawing::default();
    }
    view.picture.show_on(width, dots);
    if view.has_grid() {
        view.paint_grid(dots);
    }
    view.drawing()
}

/// The (u, v) at a place of the camera view, in dots; also beside the picture.
pub fn camera_uv_at(resolved: &ResolvedCamera, size: [usize; 2], position: [f32; 2]) -> DVec2 {
    let share = |k: usize| f64::from(position[k]) / size[k].max(1) as f64;
    let viewport = resolved.viewport();
    DVec2::new(viewport.width * (share(0) - 0.5), viewport.height * (0.5 - share(1)))
}

/// Where in the camera view, in dots, a (u, v) is: the inverse of [`camera_uv_at`].
pub fn camera_position_of_uv(resolved: &ResolvedCamera, size: [usize; 2], uv: DVec2) -> [f32; 2] {
    dot(place_of(resolved, size, uv))
}

pub(super) fn place_of(resolved: &ResolvedCamera, [width, height]: [usize; 2], uv: DVec2) -> DVec2 {
    let viewport = resolved.viewport();
    DVec2::new(
        width as f64 * (0.5 + uv.x / viewport.width),
        height as f64 * (0.5 - uv.y / viewport.height),
    )
}

impl CameraView<'_> {
    pub(super) fn extent(&self) -> DVec2 {
        DVec2::new(self.size[0] as f64, self.size[1] as f64)
    }

    /// Dots per pixel, across and down.
    pub(super) fn dots_per_pixel(&self) -> DVec2 {
        let image = self.resolved.image();
        self.extent() / DVec2::new(image.width().into(), image.height().into())
    }

    /// Whether the edges between pixels are painted.
    fn has_grid(&self) -> bool {
        self.items.shows(Item::PixelGrid) && self.dots_per_pixel().min_element() >= GRID_FROM
    }

    fn paint_grid(&self, dots: &mut [Color32]) {
        let [width, height] = self.size;
        let line = (self.scale.round() as usize).max(1);
        let image: ImageSize = self.resolved.image();
        let (columns, rows) =
            (edges(image.width(), width, line), edges(image.height(), height, line));
        let behind = self.style.colors().background;
        let darken = |dot: &mut Color32| *dot = mix(*dot, contrast(*dot, behind), 0.3);
        for (row, dots) in dots.chunks_exact_mut(width).enumerate() {
            if rows[row] {
                dots.iter_mut().for_each(darken);
            } else {
                let on_edge = dots.iter_mut().zip(&columns).filter(|(_, on)| **on);
                on_edge.for_each(|(dot, _)| darken(dot));
            }
        }
    }

    /// The marks and labels, without painting them.
    pub fn drawing(&self) -> Drawing {
        let colors = self.style.colors();
        let mut sheet = Sheet {
            view: self,
            items: self.items,
            colors,
            drawing: Drawing { scale: self.scale, ..Drawing::default() },
            requests: Vec::new(),
        };
        sheet.uv_axes();
        sheet.marks();
        sheet.selected();
        if let Some(lit) = self.lit {
            sheet.light(lit);
        }
        let placed = labels::place(&sheet.requests, &sheet.drawing, self.extent(), colors.halo);
        sheet.loupe();
        let mut drawing = sheet.drawing;
        drawing.labels = placed;
        loupe::label(self, &mut drawing);
        drawing
    }
}

/// Which of `dots` lie on an edge between two of `count` cells, lines `width` dots wide.
fn edges(count: u32, dots: usize, width: usize) -> Vec<bool> {
    let mut on = vec![false; dots];
    for k in 1..count as usize {
        // The first dot that shows cell k, see `Picture::show_on`.
        let first = (2 * k * dots).saturating_sub(count as usize).div_ceil(2 * count as usize);
        let from = first.saturating_sub(width / 2);
        on[from.min(dots)..(from + width).min(dots)].fill(true);
    }
    on
}

/// The camera view's drawing in the making.
pub(super) struct Sheet<'a> {
    pub(super) view: &'a CameraView<'a>,
    pub(super) items: OverlayItems,
    pub(super) colors: &'static Colors,
    pub(super) drawing: Drawing,
    pub(super) requests: Vec<Request>,
}

impl Sheet<'_> {
    pub(super) fn add(&mut self, pen: Pen, shape: Shape) {
        let Pen { item, thing, color, pattern, .. } = pen;
        if self.items.shows(item) {
            let halo = pen.halo.then_some(self.colors.halo);
            let hidden = false;
            self.drawing.marks.push(Mark { item, thing, shape, color, halo, hidden, pattern });
        }
    }

    pub(super) fn line(&mut self, points: &[DVec2], pen: Pen) {
        let points = points.iter().copied().map(dot).collect();
        self.add(pen, Shape::Line { points, width: pen.width * self.view.scale });
    }

    pub(super) fn label(
        &mut self,
        pen: Pen,
        text: impl Into<Cow<'static, str>>,
        anchor: DVec2,
        toward: DVec2,
        (size, bold): (f32, bool),
    ) {
        let Pen { item, thing, color, .. } = pen;
        if self.items.shows(Item::Labels) && self.items.shows(item) {
            let text = text.into();
            let request = Request { item, text, thing, anchor, toward, color, size, bold };
            self.requests.push(request);
        }
    }

    fn uv_axes(&mut self) {
        let (size, color) = (self.view.extent(), self.colors.ink);
        let middle = 0.5 * size;
        let across = [DVec2::new(0.0, middle.y), DVec2::new(size.x, middle.y)];
        let down = [DVec2::new(middle.x, 0.0), DVec2::new(middle.x, size.y)];
        let axes = [
            ("u", across, DVec2::new(size.x - 1.0, middle.y), Thing::U),
            ("v", down, DVec2::new(middle.x, 1.0), Thing::V),
        ];
        for (name, points, end, thing) in axes {
            let pen = Pen::new(Item::UvAxes, color, 1.0).of(thing);
            self.line(&points, pen);
            self.label(pen, name, end, middle - end, (MARK_TEXT, false));
        }
    }

    /// As in the world view: a thick top edge with a triangle at it, a triangle at pixel (0, 0).
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
        let pen = Pen::new(Item::Marks, color, 1.0);
        for polygon in [&rectangle[..], &up, &corner] {
            let points = polygon.iter().copied().map(dot).collect();
            self.add(pen, Shape::Polygon { points });
        }
        if size.min_element() > 160.0 * scale {
            let below = DVec2::new(0.0, 1.2 * side);
            self.label(pen, "top", middle + below, DVec2::Y, (MARK_TEXT, false));
            let font = (MARK_TEXT, false);
            self.label(pen, "(0, 0)", DVec2::splat(0.4 * side), DVec2::ONE, font);
        }
    }

    /// The pixels that the selected ray touches, and a cross where it passes them other than
    /// through the centre of one. Of pixels too small to be told apart, only the place.
    fn selected(&mut self) {
        let Some(inspection) = self.view.inspection else { return };
        let pen = Pen::new(Item::Ray, self.colors.ray, 1.8).of(Thing::Pixel);
        let frame = Pen { width: 2.2, ..pen };
        let scale = f64::from(self.view.scale);
        let resolved = self.view.resolved;
        let at = place_of(resolved, self.view.size, inspection.uv);
        let pixel_size = self.view.dots_per_pixel().min_element() / scale;
        let touched = inspection.place.map(|place| place.touching(resolved.image()));
        let touched = touched.unwrap_or_default();
        let centered = touched.len() == 1
            && place_of(resolved, self.view.size, resolved.uv_of_pixel(touched[0])).distance(at)
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
            for axis in [DVec2::X, DVec2::Y] {
                let arm = 9.0 * scale * axis;
                self.line(&[at - arm, at + arm], pen);
            }
        }
        if let (Some(hit), true) = (inspection.first_hit(), pixel_size >= 12.0) {
            let radius = 3.2 * self.view.scale;
            let pen = Pen { item: Item::Hit, ..pen }.of(inspection.thing_of(hit));
            self.add(pen, Shape::Disc { center: dot(at), radius });
        }
    }

    fn pixel(&mut self, Pixel { row, column }: Pixel, pen: Pen) {
        let per_pixel = self.view.dots_per_pixel();
        let corner = |row: u32, column: u32| DVec2::new(column.into(), row.into()) * per_pixel;
        self.frame(corner(row, column), corner(row + 1, column + 1), pen);
    }

    pub(super) fn frame(&mut self, from: DVec2, to: DVec2, pen: Pen) {
        let points = [from, DVec2::new(to.x, from.y), to, DVec2::new(from.x, to.y), from];
        self.line(&points, pen);
    }
}
