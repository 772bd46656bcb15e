//! Highlights a concept in the camera view. Seen from the camera, w points at the observer, and the whole
//! ray is a single point.

use pinhole_core::{
    DVec2, DVec3, Object, Orientation, Outputs, Pixel, Raster, Scene, Sphere, trace,
};
use pinhole_lecture::Cross;

use crate::model::{Concept, Item, OverlayItems};
use crate::view::overlay::{
    ACCOMPANYING, ALONG, CameraSketch, CameraView, Colors, Highlighted, LabelFont, LineStyle,
    POINT, STRONG, Screen, Shape, VECTOR, cased, cross_of, dim, dot, first, position_of,
    silhouette, unit,
};

/// Length at which a unit vector in the image plane is drawn, as a fraction of the picture's shorter side.
const ARROW: f64 = 0.3;

/// Distance between two strokes of a plane's hatching, in points.
const HATCH: f64 = 20.0;
/// Distance between the positions along a stroke at which it is tested whether the plane is visible, in
/// points.
const CELL: f64 = 3.0;

impl CameraSketch<'_> {
    /// Highlights a concept on top of everything already drawn. Does nothing if the camera cannot see
    /// the concept.
    pub(super) fn highlight(&mut self, highlighted: Highlighted, scene: &Scene) {
        let (shown, before) = (self.items, self.requests.len());
        let object = match highlighted.concept {
            Concept::Object(index) => scene.object(index).map(|object| (index, object)),
            _ => None,
        };
        if let Some((index, Object::Plane(_))) = object {
            if highlighted.dims {
                self.highlight_plane(scene, index);
            }
            return;
        }
        let others = std::mem::take(&mut self.drawing.marks);
        self.items = OverlayItems::ALL;
        let pen = LineStyle::new(Item::Ray, self.colors.ray, STRONG).about(highlighted.concept);
        self.highlight_camera(highlighted, pen);
        self.highlight_selected(highlighted, pen);
        if let Some((_, Object::Sphere(sphere))) = object {
            self.highlight_sphere(&sphere, pen);
        }
        self.items = shown;
        let mut marks = std::mem::replace(&mut self.drawing.marks, others);
        let labels = self.requests.split_off(before);
        if !marks.is_empty() {
            dim(&mut self.drawing, &mut self.requests, highlighted, self.colors);
        }
        self.drawing.marks.append(&mut marks);
        self.requests = first(labels, std::mem::take(&mut self.requests));
    }

    /// Returns the arrow of a unit vector, projected onto the image. It is foreshortened unless the vector
    /// is orthogonal to w.
    fn arrow_of(&self, vector: DVec3) -> DVec2 {
        let basis = self.view.resolved.basis();
        let in_image = DVec2::new(basis.u.dot(vector), -basis.v.dot(vector));
        ARROW * self.view.extent().min_element() * in_image
    }

    fn arrow(&mut self, from: DVec2, along: DVec2, pen: LineStyle, text: &str, font: LabelFont) {
        let tip = from + along;
        let head = f64::from(self.view.scale * (4.0 + 2.6 * pen.width)).min(0.8 * along.length());
        let Some(direction) = along.try_normalize() else { return };
        let (back, side) = (tip - head * direction, 0.42 * head * direction.perp());
        self.line(&[from, tip - 0.7 * head * direction], pen);
        self.add(pen, Shape::polygon(&[tip, back + side, back - side]));
        self.label(pen, text, tip, direction, font);
    }

    fn disc(&mut self, at: DVec2, pen: LineStyle) {
        self.add(pen, Shape::Disc { center: dot(at), radius: 6.0 * self.view.scale });
    }

    fn point(&mut self, at: DVec2, pen: LineStyle, text: &str, toward: DVec2) {
        self.disc(at, pen);
        self.label(pen, text, at, toward, POINT);
    }

    /// Draws the symbol of a vector along the line of sight, in the middle of the picture: a ring with a
    /// dot if the vector points towards the observer, or with a cross if it points away.
    fn end_on(&mut self, away: bool, pen: LineStyle, text: &str, toward: DVec2, font: LabelFont) {
        let (at, scale) = (0.5 * self.view.extent(), f64::from(self.view.scale));
        let ring = LineStyle { width: 2.4, ..pen };
        let radius = 9.0 * scale;
        self.add(ring, Shape::ring(at, radius, 32, ring.width * self.view.scale));
        if away {
            let arm = radius * std::f64::consts::FRAC_1_SQRT_2 * DVec2::ONE;
            self.line(&[at - arm, at + arm], ring);
            self.line(&[at - arm.perp(), at + arm.perp()], ring);
        } else {
            self.add(ring, Shape::Disc { center: dot(at), radius: (3.6 * scale) as f32 });
        }
        self.label(pen, text, at, toward, font);
    }

    /// Highlights a concept of the camera: a value that the user gives, a vector of its basis, its viewport
    /// or the viewport's distance.
    fn highlight_camera(&mut self, highlighted: Highlighted, pen: LineStyle) {
        let (resolved, extent) = (self.view.resolved, self.view.extent());
        let (middle, below) = (0.5 * extent, DVec2::new(0.6, 1.0));
        let Colors { basis: [u, v, w], patterns, given, ink, .. } = *self.colors;
        let basis = resolved.basis();
        let pen = |color| LineStyle { color, ..pen };
        match (highlighted.concept, highlighted.camera.orientation) {
            (Concept::Eye, _) => {
                // All rays begin at the eye, which is straight behind the middle of the picture.
                let text = "eye: straight behind this point";
                self.end_on(false, pen(ink), text, below, POINT);
            }
            (Concept::At, Orientation::At { .. }) => self.point(middle, pen(given), "at", below),
            (Concept::View, _) => self.end_on(true, pen(given), "view", below, POINT),
            (Concept::Backwards, _) => self.end_on(false, pen(given), "−view", below, POINT),
            (Concept::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let along = self.arrow_of(unit(up).unwrap_or_default());
                self.arrow(middle, along, pen(given), "up", POINT);
            }
            (Concept::U, _) => {
                let pen = pen(u).patterned(patterns[0]);
                self.arrow(middle, self.arrow_of(basis.u), pen, "u", VECTOR);
            }
            (Concept::V, _) => {
                let pen = pen(v).patterned(patterns[1]);
                self.arrow(middle, self.arrow_of(basis.v), pen, "v", VECTOR);
            }
            (Concept::W, _) => self.end_on(false, pen(w), "w", below, VECTOR),
            (Concept::UpCrossW | Concept::WCrossU, _) => {
                if let Some((cross, names, colors)) = cross_of(highlighted, self.colors) {
                    self.highlight_cross(&cross, names, colors.map(pen));
                }
            }
            (Concept::Viewport, _) if self.view.inspection.is_some() => {
                let inset = DVec2::splat(2.0 * f64::from(self.view.scale));
                self.frame(inset, extent - inset, pen(ink));
            }
            (Concept::Distance, _) => {
                let text = highlighted.distance(&resolved);
                self.end_on(true, pen(ink), &text, below, POINT);
            }
            _ => {}
        }
    }

    /// Draws a cross product. One factor is always w, which points at the observer; the other factor and
    /// the product are arrows in the image.
    fn highlight_cross(&mut self, cross: &Cross, names: [&str; 3], pens: [LineStyle; 3]) {
        let middle = 0.5 * self.view.extent();
        let along = |s: &Self, vector: DVec3| s.arrow_of(unit(vector).unwrap_or_default());
        let (other, vector, w) = match names[0] {
            "w" => (1, cross.second.vector, 0),
            _ => (0, cross.first.vector, 1),
        };
        let thin = LineStyle { width: ACCOMPANYING, ..pens[other] };
        self.arrow(middle, along(self, vector), thin, names[other], POINT);
        let product = cross.sine.unwrap_or_default() * along(self, cross.product);
        self.arrow(middle, product, pens[2], names[2], VECTOR);
        self.end_on(false, pens[w], "w", DVec2::new(-1.0, 1.0), VECTOR);
    }

    /// Highlights a concept of the selected ray.
    fn highlight_selected(&mut self, highlighted: Highlighted, pen: LineStyle) {
        let Some(inspection) = &self.view.inspection else { return };
        let at = position_of(&self.view.resolved, self.view.size, inspection.uv);
        let toward = DVec2::new(0.4, 1.0);
        match highlighted.concept {
            Concept::Pixel => {
                for pixel in inspection.touched(&self.view.resolved) {
                    self.pixel(pixel, LineStyle { width: ACCOMPANYING, ..pen });
                }
                self.point(at, pen, "(𝑢, 𝑣)", toward);
            }
            Concept::Direction => self.point(at, pen, "𝐝", toward),
            Concept::Ray => self.point(at, pen, "𝐩 + 𝑡 𝐝", toward),
            Concept::Root { object, number } => {
                let root = inspection.root_of(object, number).filter(|root| root.t > 0.0);
                if let Some(root) = root {
                    self.point(at, pen, &format!("𝑡 {}", highlighted.equated(root.t)), toward);
                }
            }
            Concept::AlongU | Concept::AlongV | Concept::AlongW => {
                self.highlight_parts(highlighted.concept, inspection.uv, pen);
            }
            Concept::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let pen = LineStyle { color: self.colors.hit, ..pen };
                self.disc(at, pen);
                self.arrow(at, self.arrow_of(hit.normal), pen, "n", VECTOR);
            }
            _ => {}
        }
    }

    /// Draws the components of the selected ray's direction: along w as a symbol in the middle of the
    /// picture, and along u and v as arrows.
    fn highlight_parts(&mut self, concept: Concept, uv: DVec2, pen: LineStyle) {
        let to_dots = |uv: DVec2| position_of(&self.view.resolved, self.view.size, uv);
        let middle = 0.5 * self.view.extent();
        let (at, corner) = (to_dots(uv), to_dots(DVec2::new(uv.x, 0.0)));
        let [w, u, v] = ALONG;
        let [color_u, color_v, color_w] = self.colors.basis;
        for ((part, text), from, to, color) in
            [(u, middle, corner, color_u), (v, corner, at, color_v)]
        {
            let width = if part == concept { STRONG } else { ACCOMPANYING };
            let pen = LineStyle { color, width, ..pen }.about(part);
            self.arrow(from, to - from, pen, text, POINT);
        }
        if concept == Concept::AlongW {
            let pen = LineStyle { color: color_w, ..pen };
            self.end_on(true, pen, w.1, DVec2::new(-0.6, -1.0), POINT);
        }
    }

    /// Draws a sphere's outline.
    fn highlight_sphere(&mut self, sphere: &Sphere, pen: LineStyle) {
        let CameraView { resolved, scale, .. } = self.view;
        let unit = (sphere.center - resolved.eye()).length();
        let screen = Screen::of_size(resolved, self.view.extent(), unit, *scale);
        let pen = LineStyle { color: self.colors.hit, width: 4.0, ..pen };
        let outline = silhouette(sphere, resolved.eye()).unwrap_or_default();
        for pen in cased(pen, self.colors.halo) {
            for cut in outline.windows(2).filter_map(|pair| screen.line(pair[0], pair[1])) {
                self.line(&[cut.from.at, cut.to.at], pen);
            }
        }
    }

    /// Hatches the pixels that show a plane. The hatching is drawn below all other marks: the plane may
    /// fill the picture, and the marks on it must stay visible and respond to the pointer.
    fn highlight_plane(&mut self, scene: &Scene, index: u32) {
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 1.5);
        let (resolved, extent) = (&self.view.resolved, self.view.extent());
        let (scale, per_pixel) = (f64::from(self.view.scale), self.view.dots_per_pixel());
        // The objects are traced only at the resolution that the hatching needs.
        let [columns, rows] = (extent / (CELL * scale)).to_array().map(|cells| cells.ceil() as u32);
        let raster = Raster::shown_on(resolved.image(), columns, rows);
        let frame = trace(scene, resolved, &raster, Outputs { object: true, ..Outputs::NONE });
        let shows_plane = |at: DVec2| {
            let cell = at / per_pixel;
            // The cast saturates, so positions left of or above the picture give index 0.
            let pixel = Pixel { row: cell.y as u32, column: cell.x as u32 };
            let offset = raster.nearest_to(pixel);
            offset.and_then(|offset| frame.object.get(offset)) == Some(&index)
        };
        let strokes = hatch(extent, HATCH * scale, CELL * scale, shows_plane);
        let shown = std::mem::replace(&mut self.items, OverlayItems::ALL);
        let mut others = std::mem::take(&mut self.drawing.marks);
        for pen in cased(pen, self.colors.halo.gamma_multiply(0.6)) {
            strokes.iter().for_each(|stroke| self.line(stroke, pen));
        }
        self.drawing.marks.append(&mut others);
        self.items = shown;
    }
}

/// Returns the strokes of a hatching, `apart` from each other and rising to the right. They cover the
/// positions for which `inside` returns true, which is tested at intervals of `step`.
fn hatch(extent: DVec2, apart: f64, step: f64, inside: impl Fn(DVec2) -> bool) -> Vec<[DVec2; 2]> {
    let mut strokes = Vec::new();
    let direction = DVec2::new(std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2);
    let (reach, apart) = (extent.x + extent.y, apart * std::f64::consts::SQRT_2);
    for k in 1..(reach / apart).ceil() as u32 {
        // x + y is constant along a stroke, which starts at the left or at the lower edge.
        let sum = f64::from(k) * apart;
        let start = DVec2::new((sum - extent.y).max(0.0), sum.min(extent.y));
        let end = sum.min(extent.x) - start.x;
        let steps = (end / direction.x / step).floor() as u32;
        let mut open: Option<[DVec2; 2]> = None;
        for at in (0..=steps).map(|n| start + f64::from(n) * step * direction) {
            open = match (open, inside(at)) {
                (Some([from, _]), true) => Some([from, at]),
                (None, true) => Some([at, at]),
                (done, false) => {
                    strokes.extend(done);
                    None
                }
            };
        }
        strokes.extend(open);
    }
    strokes
}
