//! Highlights a concept: draws it again, thicker and on top, even if its overlay item is switched off. If
//! the derivation or a lesson refers to the concept, everything else is dimmed. If the pointer only hovers
//! over it in a view, nothing is dimmed.
//!
//! This module contains the world view's highlighting and the parts that both views share. The camera
//! view's highlighting is in `camera_view::highlighted`.

use egui::Color32;
use pinhole_core::{Camera, DVec2, DVec3, Object, Orientation, ResolvedCamera, Selection, Sphere};
use pinhole_lecture::Rounding;
use pinhole_lecture::numbers::{equated, written};
use pinhole_lecture::{BasisDerivation, Cross, RayDerivation};

use crate::model::observer::{UP_LENGTH, VIEW_LENGTH};
use crate::model::{Concept, Item, OverlayItems};
use crate::view::overlay::{
    BASIS, Colors, DIMMED, Drawing, Head, LABEL_DIGITS, LEGIBLE, LineStyle, POINT, Request, Sketch,
    VECTOR, VISIBLE, circle, corners, tangents, unit,
};

/// The highlighted concept, and the inputs for drawing it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highlighted {
    /// The concept.
    pub concept: Concept,
    /// The edited camera as the user gives it.
    pub camera: Camera,
    /// Number of significant digits.
    pub digits: usize,
    /// True if everything else is dimmed.
    pub dims: bool,
}

impl Highlighted {
    /// Formats a number for a label.
    pub(crate) fn number(&self, x: f64) -> String {
        written(x, self.digits.min(LABEL_DIGITS))
    }

    /// Formats a number for a label as the right side of an equation: `= 0.5`, `≈ 0.3333`.
    pub(crate) fn equated(&self, x: f64) -> String {
        equated(x, self.digits.min(LABEL_DIGITS))
    }

    /// Returns the sign to write before numbers: `=` if a label shows all of them exactly, otherwise `≈`.
    pub(crate) fn relation(&self, shown: &[f64]) -> char {
        Rounding::Significant(self.digits.min(LABEL_DIGITS)).relation(shown)
    }

    /// Returns a label with the distance from the eye to the viewport.
    pub(crate) fn distance(&self, resolved: &ResolvedCamera) -> String {
        format!("distance {}", self.equated(resolved.viewport().distance))
    }
}

/// The three components of a view ray's direction, with their concepts and labels.
pub(crate) const ALONG: [(Concept, &str); 3] =
    [(Concept::AlongW, "−distance 𝐰"), (Concept::AlongU, "𝑢 𝐮"), (Concept::AlongV, "𝑣 𝐯")];

/// Width of highlighted lines, in points.
pub(crate) const STRONG: f32 = 5.0;
/// Width of the lines that are drawn together with a highlighted line, in points.
pub(crate) const ACCOMPANYING: f32 = 3.0;

/// Removes the marks and labels of the highlighted concept, which will be drawn again. Dims all others if
/// `highlighted.dims` is true.
pub(crate) fn dim(
    drawing: &mut Drawing,
    requests: &mut Vec<Request>,
    highlighted: Highlighted,
    colors: &Colors,
) {
    let concept = highlighted.concept;
    drawing.marks.retain(|mark| mark.concept != Some(concept));
    requests.retain(|request| request.concept != Some(concept));
    if !highlighted.dims {
        return;
    }
    for mark in &mut drawing.marks {
        mark.color = match mark.color.is_opaque() {
            true => colors.dimmed(mark.color, VISIBLE),
            false => mark.color.gamma_multiply(DIMMED),
        };
    }
    for request in requests {
        request.label.color = colors.dimmed(request.label.color, LEGIBLE);
    }
}

/// Puts the labels of the highlighted concept before the others, so that they get the best positions, and
/// removes others with the same text.
pub(crate) fn first(mut labels: Vec<Request>, mut others: Vec<Request>) -> Vec<Request> {
    labels.iter_mut().for_each(|request| request.rank = 0);
    others.retain(|other| labels.iter().all(|request| request.label.text != other.label.text));
    labels.into_iter().chain(others).collect()
}

/// Returns two styles for a polyline: that of its casing (a wider line below it), and that of the line
/// itself. All casings must be drawn before the lines, so that they do not cut into them.
pub(crate) fn cased(pen: LineStyle, halo: Color32) -> [LineStyle; 2] {
    let pen = pen.without_halo();
    [LineStyle { color: halo, width: pen.width + 2.5, ..pen }, pen]
}

/// Returns the silhouette of a sphere seen from a point, as a closed polyline; `None` if the point lies
/// inside the sphere.
pub(crate) fn silhouette(sphere: &Sphere, from: DVec3) -> Option<Vec<DVec3>> {
    let out = from - sphere.center;
    let distance = out.length();
    let share = sphere.radius / distance;
    if share.is_nan() || share >= 1.0 {
        return None;
    }
    let axis = out / distance;
    let (a, b) = tangents(axis);
    let center = sphere.center + sphere.radius * share * axis;
    let radius = sphere.radius * (1.0 - share * share).sqrt();
    Some(circle(96).map(|p| center + radius * (p.x * a + p.y * b)).collect())
}

/// Returns the cross product that a concept stands for, with the names and colours of its two factors and
/// of the product. Returns `None` for any other concept, and if the camera has no such product.
pub(crate) fn cross_of(
    Highlighted { concept, camera, .. }: Highlighted,
    Colors { basis: [u, v, w], given, .. }: &Colors,
) -> Option<(Cross, [&'static str; 3], [Color32; 3])> {
    let BasisDerivation::FromUp(from_up) = BasisDerivation::new(&camera) else { return None };
    match concept {
        Concept::UpCrossW => Some((from_up.up_cross_w?, ["up", "w", "up × w"], [*given, *w, *u])),
        Concept::WCrossU => Some((from_up.w_cross_u?, ["w", "u", "w × u = v"], [*w, *u, *v])),
        _ => None,
    }
}

impl Sketch<'_> {
    /// Highlights a concept on top of everything already drawn.
    pub(crate) fn highlight(&mut self, highlighted: Highlighted) {
        dim(&mut self.drawing, &mut self.requests, highlighted, self.colors);
        let (shown, before) = (self.items, self.requests.len());
        self.items = OverlayItems::ALL;
        let pen = LineStyle::new(Item::Ray, self.colors.ray, STRONG);
        let pen = pen.about(highlighted.concept).on_top();
        self.highlight_given(highlighted, pen);
        if let Some(resolved) = &self.view.resolved {
            self.highlight_camera(resolved, highlighted, pen);
            self.highlight_selected(resolved, highlighted, pen);
        }
        if let Concept::Object(index) = highlighted.concept {
            self.highlight_object(index, pen);
        }
        self.items = shown;
        let labels = self.requests.split_off(before);
        self.requests = first(labels, std::mem::take(&mut self.requests));
    }

    fn highlight_point(&mut self, at: DVec3, pen: LineStyle, text: &str) {
        self.named_point(at, 8.0, pen, text, [0.4, 1.0]);
    }

    pub(crate) fn label_middle(&mut self, ends: [DVec3; 2], pen: LineStyle, text: &str) {
        self.label_at(ends[0].midpoint(ends[1]), pen, text, DVec2::Y, POINT);
    }

    /// Highlights a value that the user gives for the camera, such as the eye. These values exist even if
    /// the camera has no basis.
    fn highlight_given(&mut self, highlighted: Highlighted, pen: LineStyle) {
        let camera = &self.view.camera;
        let eye = camera.eye;
        let arrow = self.screen.arrow_length(eye);
        let pen = LineStyle { color: self.colors.given, ..pen };
        match (highlighted.concept, camera.orientation) {
            (Concept::Eye, _) => {
                self.highlight_point(eye, LineStyle { color: self.colors.ink, ..pen }, "eye");
            }
            (Concept::At, Orientation::At { at, .. }) => self.highlight_point(at, pen, "at"),
            (Concept::View | Concept::Backwards, Orientation::At { .. })
                if self.view.items.shows(Item::ViewVector) =>
            {
                self.view_vector(arrow);
            }
            (Concept::View | Concept::Backwards, _) => {
                let Some(looks) = unit(camera.view()) else { return };
                let along = arrow * VIEW_LENGTH * looks;
                if highlighted.concept == Concept::View {
                    self.named_arrow([eye, eye + along], Head::Filled, pen, "view", POINT);
                } else {
                    let thin = LineStyle { width: ACCOMPANYING, ..pen };
                    self.named_arrow([eye, eye + along], Head::Filled, thin, "view", POINT);
                    self.named_arrow([eye, eye - along], Head::Filled, pen, "−view", POINT);
                }
            }
            (Concept::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let Some(up) = unit(up) else { return };
                let tip = eye + arrow * UP_LENGTH * up;
                self.named_arrow([eye, tip], Head::Filled, pen, "up", POINT);
            }
            (Concept::UpCrossW | Concept::WCrossU, _) => {
                if let Some((cross, names, colors)) = cross_of(highlighted, self.colors) {
                    self.highlight_cross((eye, arrow), &cross, highlighted, pen, (names, colors));
                }
            }
            _ => {}
        }
    }

    /// Draws a cross product: both factors, the parallelogram that they span, and the product, whose length
    /// is `|first| sin(angle)`, since the second factor has length 1. If the first factor is much shorter
    /// or longer, it is drawn with length 1, too. `arrow` is the length at which a unit vector is drawn.
    fn highlight_cross(
        &mut self,
        (eye, arrow): (DVec3, f64),
        cross: &Cross,
        highlighted: Highlighted,
        pen: LineStyle,
        (names, colors): ([&str; 3], [Color32; 3]),
    ) {
        let pen = LineStyle { color: colors[2], ..pen };
        let shown = self.cross_area((eye, arrow), cross, highlighted, pen, names);
        let Some((factors, area)) = shown else { return };
        for ((vector, name), color) in factors.into_iter().zip(names).zip(colors) {
            let pen = LineStyle { color, width: ACCOMPANYING + 1.0, ..pen };
            let font = if name == "up" { POINT } else { VECTOR };
            self.named_arrow([eye, eye + vector], Head::Filled, pen, name, font);
        }
        if let Some(product) = unit(cross.product) {
            let tip = eye + arrow * area * product;
            self.named_arrow([eye, tip], Head::Filled, pen, names[2], VECTOR);
        }
    }

    /// Highlights a concept for which the camera needs a basis: a vector of it, the viewport or the
    /// viewport's distance.
    fn highlight_camera(&mut self, resolved: &ResolvedCamera, shown: Highlighted, pen: LineStyle) {
        let eye = resolved.eye();
        let arrow = self.screen.arrow_length(eye);
        let inks = self.colors.basis.into_iter().zip(self.colors.patterns);
        let basis = resolved.basis();
        let vectors = [basis.u, basis.v, basis.w].into_iter().zip(BASIS);
        for ((vector, (concept, name, head)), (color, pattern)) in vectors.zip(inks) {
            if concept == shown.concept {
                let pen = LineStyle { color, pattern, ..pen };
                self.named_arrow([eye, eye + arrow * vector], head, pen, name, VECTOR);
            }
        }
        let pen = LineStyle { color: self.colors.ink, ..pen };
        match shown.concept {
            Concept::Viewport => {
                self.sides(corners(resolved).map(|uv| resolved.viewport_point(uv)), pen);
            }
            Concept::Distance => {
                let ends = [eye, resolved.viewport_point(DVec2::ZERO)];
                self.line(ends[0], ends[1], pen);
                self.label_middle(ends, pen, &shown.distance(resolved));
            }
            _ => {}
        }
    }

    /// Highlights a concept of the selected ray.
    fn highlight_selected(&mut self, resolved: &ResolvedCamera, lit: Highlighted, pen: LineStyle) {
        let view = self.view;
        let Some(inspection) = &view.inspection else { return };
        let ray = &inspection.ray;
        match lit.concept {
            Concept::Pixel => {
                for pixel in inspection.touched(resolved) {
                    self.pixel(resolved, pixel);
                }
                self.highlight_point(ray.at(1.0), pen, "(𝑢, 𝑣)");
            }
            Concept::AlongU | Concept::AlongV | Concept::AlongW => {
                if let Ok(parts) = RayDerivation::new(resolved, Selection::Uv(inspection.uv)) {
                    self.highlight_chain(resolved.eye(), &parts, pen);
                }
            }
            Concept::Direction => {
                self.named_arrow([ray.origin, ray.at(1.0)], Head::Filled, pen, "d", VECTOR);
            }
            Concept::Ray => {
                let far = 100.0 * view.observer.distance();
                let end = unit(ray.direction).map(|d| ray.origin + far * d);
                self.line(ray.origin, end.unwrap_or(ray.origin), pen);
                self.line(ray.origin, ray.at(1.0), pen);
                self.label_middle([ray.origin, ray.at(1.0)], pen, "𝐩 + 𝑡 𝐝");
            }
            Concept::Root { object, number } => {
                let Some(root) = inspection.root_of(object, number) else { return };
                self.line(ray.origin, root.point, LineStyle { width: ACCOMPANYING, ..pen });
                let text = format!("𝑡 {}", lit.equated(root.t));
                self.highlight_point(root.point, pen, &text);
            }
            Concept::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let length = self.screen.normal_length(hit.point);
                let pen = LineStyle { color: self.colors.hit, ..pen };
                let tip = hit.point + 1.3 * length * hit.normal;
                self.named_arrow([hit.point, tip], Head::Filled, pen, "n", VECTOR);
            }
            _ => {}
        }
    }

    /// Draws the components of the ray's direction as a chain of arrows from the eye: forwards, then right,
    /// then up.
    fn highlight_chain(&mut self, eye: DVec3, parts: &RayDerivation, pen: LineStyle) {
        let [u, v, w] = self.colors.basis;
        let vectors = [(parts.along_w, w), (parts.along_u, u), (parts.along_v, v)];
        let mut from = eye;
        for ((vector, color), (concept, text)) in vectors.into_iter().zip(ALONG) {
            let width = if pen.concept == Some(concept) { STRONG } else { ACCOMPANYING };
            let pen = LineStyle { color, width, ..pen }.about(concept);
            self.arrow([from, from + vector], Head::Filled, pen);
            self.label_at(from + 0.5 * vector, pen, text, DVec2::Y, POINT);
            from += vector;
        }
        let ray = LineStyle { color: self.colors.ray, width: 2.0, concept: None, ..pen };
        self.line(eye, from, ray);
    }

    /// Draws the silhouette of a sphere, or a square in a plane together with the plane's normal.
    fn highlight_object(&mut self, index: u32, pen: LineStyle) {
        let view = self.view;
        let pen = LineStyle { color: self.colors.hit, width: 4.0, ..pen };
        match self.scene.object(index) {
            Some(Object::Sphere(sphere)) => {
                let outline = silhouette(&sphere, view.frame.camera().eye()).unwrap_or_default();
                for pen in cased(pen, self.colors.halo) {
                    outline.windows(2).for_each(|pair| self.line(pair[0], pair[1], pen));
                }
            }
            Some(Object::Plane(plane)) => {
                let Some(normal) = unit(plane.normal) else { return };
                let (target, size) = (view.observer.target(), 0.3 * view.observer.distance());
                let center = target - normal.dot(target - plane.point) * normal;
                let (a, b) = tangents(normal);
                let corner = |x: f64, y: f64| center + size * (x * a + y * b);
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                self.sides(corners.map(|(x, y)| corner(x, y)), pen);
                let tip = center + 0.5 * size * normal;
                self.named_arrow([center, tip], Head::Filled, pen, "n", VECTOR);
            }
            None => {}
        }
    }
}
