//! Highlighting of a concept: draws it again, thicker and on top, even if its overlay item is hidden. If the
//! derivation or a lesson refers to the concept, everything else is dimmed; if the pointer only hovers over
//! the concept, nothing is.
//!
//! This module has the world view's highlighting and the parts that both views share; the camera view's is in
//! `camera_view::highlighted`.

use egui::Color32;
use pinhole_core::{Camera, DVec2, DVec3, Object, Orientation, ResolvedCamera, Sphere};
use pinhole_lecture::numbers::written;
use pinhole_lecture::{BasisDerivation, Cross, RayDerivation};

use crate::model::concept::Concept;
use crate::model::observer::{UP_LENGTH, VIEW_LENGTH};
use crate::model::overlay_items::{Item, OverlayItems};
use crate::view::overlay::drawing::{Drawing, circle};
use crate::view::overlay::screen::{tangents, unit};
use crate::view::overlay::style::{POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::camera_in_space::{basis_arrows, corners};
use crate::view::overlay::world_view::sketch::{Head, LineStyle, Request, Sketch};

/// The highlighted concept, and the inputs for drawing it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highlighted {
    /// The concept.
    pub concept: Concept,
    /// The edited camera as given.
    pub camera: Camera,
    /// Significant digits of numbers.
    pub digits: usize,
    /// True if everything else is dimmed.
    pub dims: bool,
}

impl Highlighted {
    /// Formats a number for a label.
    pub(crate) fn number(&self, x: f64) -> String {
        written(x, self.digits.min(LABEL_DIGITS))
    }

    /// Returns `=` if a label shows all of these numbers exactly, otherwise `≈`.
    pub(crate) fn relation(&self, shown: &[f64]) -> char {
        let is_exact = |x: &f64| self.number(*x).parse() == Ok(*x);
        if shown.iter().all(is_exact) { '=' } else { '≈' }
    }

    /// Formats an angle, given in radians, in degrees for a label.
    pub(crate) fn degrees(&self, angle: f64) -> String {
        format!("{}°", self.number(angle.to_degrees()))
    }
}

/// Maximum number of significant digits of a label; a longer one would cover the thing that it names.
const LABEL_DIGITS: usize = 4;

/// Opacity of the other marks.
const DIMMED: f32 = 0.42;

/// Labels of the parts of a view ray's direction.
pub(crate) const ALONG: [(Concept, &str); 3] =
    [(Concept::AlongW, "−distance 𝐰"), (Concept::AlongU, "𝑢 𝐮"), (Concept::AlongV, "𝑣 𝐯")];

/// Widths of highlighted lines and of the lines that accompany them, in points.
pub(crate) const STRONG: f32 = 5.0;
pub(crate) const BESIDE: f32 = 3.0;

/// Removes the concept's own marks and labels, which are drawn again. Dims the others if `highlighted`
/// requests it.
pub(crate) fn dim(drawing: &mut Drawing, requests: &mut Vec<Request>, highlighted: Highlighted) {
    let concept = highlighted.concept;
    drawing.marks.retain(|mark| mark.concept != Some(concept));
    requests.retain(|request| request.concept != Some(concept));
    if !highlighted.dims {
        return;
    }
    for mark in &mut drawing.marks {
        mark.color = mark.color.gamma_multiply(DIMMED);
        mark.halo = mark.halo.map(|halo| halo.gamma_multiply(DIMMED));
    }
    for request in requests {
        request.label.color = request.label.color.gamma_multiply(DIMMED);
    }
}

/// Puts the concept's own labels first, so that they get the best positions, and removes other labels with
/// the same text.
pub(crate) fn first(mut own: Vec<Request>, mut others: Vec<Request>) -> Vec<Request> {
    own.iter_mut().for_each(|request| request.rank = 0);
    others.retain(|other| own.iter().all(|request| request.label.text != other.label.text));
    own.into_iter().chain(others).collect()
}

/// Returns the style of the casing and the style of the line. A polyline needs one casing as a whole, below
/// all of its lines.
pub(crate) fn cased(pen: LineStyle, halo: Color32) -> [LineStyle; 2] {
    let pen = pen.without_halo();
    [LineStyle { color: halo, width: pen.width + 2.5, ..pen }, pen]
}

/// Returns the silhouette of a sphere as seen from a point, which is a circle; `None` from inside.
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

impl Sketch<'_> {
    /// Highlights a concept over everything that is already drawn.
    pub(crate) fn highlight(&mut self, highlighted: Highlighted) {
        dim(&mut self.drawing, &mut self.requests, highlighted);
        let (shown, before) = (self.items, self.requests.len());
        self.items = OverlayItems::ALL;
        self.highlight_given(highlighted);
        if let Some(resolved) = &self.view.resolved {
            self.highlight_camera(resolved, highlighted);
            self.highlight_selected(resolved, highlighted);
        }
        if let Concept::Object(index) = highlighted.concept {
            self.highlight_object(index);
        }
        self.items = shown;
        let own = self.requests.split_off(before);
        self.requests = first(own, std::mem::take(&mut self.requests));
    }

    fn highlighted_pen(&self, highlighted: Highlighted, color: Color32) -> LineStyle {
        LineStyle::new(Item::Ray, color, STRONG).about(highlighted.concept).on_top()
    }

    fn highlighted_arrow(
        &mut self,
        from: DVec3,
        to: DVec3,
        head: Head,
        pen: LineStyle,
        text: &str,
        size: f32,
    ) {
        let tip = self.arrow(from, to, head, pen);
        let bold = size == VECTOR_TEXT;
        self.label_tip(pen, text.to_owned(), tip, (pen.color, size, bold));
    }

    fn highlighted_point(&mut self, at: DVec3, pen: LineStyle, text: String) {
        if let Some(spot) = self.point(at, 8.0, pen) {
            let font = (pen.color, POINT_TEXT, false);
            self.label(pen, text, spot.at, DVec2::new(0.4, 1.0), font);
        }
    }

    fn highlighted_line(&mut self, from: DVec3, to: DVec3, pen: LineStyle, text: Option<String>) {
        self.line(from, to, pen);
        if let (Some(text), Some(spot)) = (text, self.screen.spot(from.midpoint(to))) {
            let font = (pen.color, POINT_TEXT, false);
            self.label(pen, text, spot.at, DVec2::new(0.0, 1.0), font);
        }
    }

    /// Highlights the inputs of the camera, which exist even if it has no basis.
    fn highlight_given(&mut self, highlighted: Highlighted) {
        let view = self.view;
        let eye = view.camera.eye;
        let arrow = self.arrow_length(eye);
        let (given, ink) = (self.colors.given, self.colors.ink);
        let looks = unit(view.camera.view());
        match (highlighted.concept, view.camera.orientation) {
            (Concept::Eye, _) => self.highlighted_point(
                eye,
                self.highlighted_pen(highlighted, ink),
                "eye".to_owned(),
            ),
            (Concept::At, Orientation::At { at, .. }) => {
                self.highlighted_point(
                    at,
                    self.highlighted_pen(highlighted, given),
                    "at".to_owned(),
                );
            }
            (Concept::View | Concept::Backwards, _) => {
                let Some(looks) = looks else { return };
                let pen = self.highlighted_pen(highlighted, given);
                let tip = eye + arrow * VIEW_LENGTH * looks;
                if highlighted.concept == Concept::View {
                    self.highlighted_arrow(eye, tip, Head::Filled, pen, "view", POINT_TEXT);
                } else {
                    let thin = LineStyle { width: BESIDE, ..pen };
                    self.highlighted_arrow(eye, tip, Head::Filled, thin, "view", POINT_TEXT);
                    let tip = eye - arrow * VIEW_LENGTH * looks;
                    self.highlighted_arrow(eye, tip, Head::Filled, pen, "−view", POINT_TEXT);
                }
            }
            (Concept::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let Some(up) = unit(up) else { return };
                let pen = self.highlighted_pen(highlighted, given);
                let tip = eye + arrow * UP_LENGTH * up;
                self.highlighted_arrow(eye, tip, Head::Filled, pen, "up", POINT_TEXT);
            }
            (Concept::UpCrossW | Concept::WCrossU, _) => {
                let BasisDerivation::FromUp(from_up) = BasisDerivation::new(&view.camera) else {
                    return;
                };
                let [u, v, w] = self.colors.basis;
                let cross = |s: &mut Self, cross: Option<Cross>, names, colors| {
                    if let Some(cross) = cross {
                        s.highlight_cross(eye, arrow, &cross, highlighted, (names, colors));
                    }
                };
                if highlighted.concept == Concept::UpCrossW {
                    cross(self, from_up.up_cross_w, ["up", "w", "up × w"], [given, w, u]);
                } else {
                    cross(self, from_up.w_cross_u, ["w", "u", "w × u = v"], [w, u, v]);
                }
            }
            _ => {}
        }
    }

    /// Draws both factors, the parallelogram between them, and the product with its length `|first|
    /// sin(angle)`; the second factor has length 1. If the first factor is too short or too long to be drawn
    /// next to the second, it too is drawn with length 1.
    fn highlight_cross(
        &mut self,
        eye: DVec3,
        arrow: f64,
        cross: &Cross,
        highlighted: Highlighted,
        (names, colors): ([&str; 3], [Color32; 3]),
    ) {
        let (Some(a), Some(b)) = (unit(cross.first.vector), unit(cross.second.vector)) else {
            return;
        };
        let own = cross.first.length;
        let length = if (0.4..=2.0).contains(&own) { own } else { 1.0 };
        let (a, b) = (arrow * length * a, arrow * b);
        let pen = self.highlighted_pen(highlighted, colors[2]);
        let fill = LineStyle { color: colors[2].gamma_multiply(0.3), ..pen }.without_halo();
        self.polygon(&[eye, eye + a, eye + a + b, eye + b], fill);
        let edge = LineStyle { width: 1.6, ..pen }.without_halo();
        self.line(eye + a, eye + a + b, edge);
        self.line(eye + b, eye + a + b, edge);
        for ((vector, name), color) in [(a, names[0]), (b, names[1])].into_iter().zip(colors) {
            let pen = LineStyle { color, width: BESIDE + 1.0, ..pen };
            let size = if name == "up" { POINT_TEXT } else { VECTOR_TEXT };
            self.highlighted_arrow(eye, eye + vector, Head::Filled, pen, name, size);
        }
        let Some((angle, sine)) = cross.angle.zip(cross.sine) else { return };
        if let Some(product) = unit(cross.product) {
            let tip = eye + arrow * length * sine * product;
            self.highlighted_arrow(eye, tip, Head::Filled, pen, names[2], VECTOR_TEXT);
        }
        if let Some(spot) = self.screen.spot(eye + 0.5 * (a + b)) {
            let sine_of = format!("sin({})", highlighted.degrees(angle));
            let area = length * sine;
            let is = highlighted.relation(&[length, angle.to_degrees(), area]);
            let text = if highlighted.number(length) == highlighted.number(1.0) {
                format!("{sine_of} {is} {}", highlighted.number(sine))
            } else {
                let (length, area) = (highlighted.number(length), highlighted.number(area));
                format!("{length} · {sine_of} {is} {area}")
            };
            self.label(pen, text, spot.at, DVec2::ZERO, (colors[2], POINT_TEXT, false));
        }
    }

    /// Highlights the concepts that need the basis: its vectors, the viewport and its distance.
    fn highlight_camera(&mut self, resolved: &ResolvedCamera, highlighted: Highlighted) {
        let eye = resolved.eye();
        let arrow = self.arrow_length(eye);
        let inks = self.colors.basis.into_iter().zip(self.colors.patterns);
        let arrows = basis_arrows(resolved.basis());
        for ((concept, name, vector, head), (color, pattern)) in arrows.zip(inks) {
            if concept == highlighted.concept {
                let pen = self.highlighted_pen(highlighted, color).patterned(pattern);
                self.highlighted_arrow(eye, eye + arrow * vector, head, pen, name, VECTOR_TEXT);
            }
        }
        let pen = self.highlighted_pen(highlighted, self.colors.ink);
        match highlighted.concept {
            Concept::Viewport => {
                self.sides(corners(resolved).map(|uv| resolved.viewport_point(uv)), pen);
            }
            Concept::Distance => {
                let text =
                    format!("distance = {}", highlighted.number(resolved.viewport().distance));
                self.highlighted_line(eye, resolved.viewport_point(DVec2::ZERO), pen, Some(text));
            }
            _ => {}
        }
    }

    /// Highlights the parts of the selected ray.
    fn highlight_selected(&mut self, resolved: &ResolvedCamera, highlighted: Highlighted) {
        let view = self.view;
        let Some(inspection) = &view.inspection else { return };
        let ray = &inspection.ray;
        let pen = self.highlighted_pen(highlighted, self.colors.ray);
        match highlighted.concept {
            Concept::Pixel => {
                let touched = inspection
                    .image_position
                    .map(|image_position| image_position.touching(resolved.image()));
                touched.into_iter().flatten().for_each(|pixel| self.pixel(resolved, pixel));
                self.highlighted_point(ray.at(1.0), pen, "(𝑢, 𝑣)".to_owned());
            }
            Concept::AlongU | Concept::AlongV | Concept::AlongW => {
                if let Ok(parts) = RayDerivation::of_uv(resolved, inspection.uv) {
                    self.highlight_chain(resolved.eye(), &parts, pen);
                }
            }
            Concept::Direction => {
                self.highlighted_arrow(
                    ray.origin,
                    ray.at(1.0),
                    Head::Filled,
                    pen,
                    "d",
                    VECTOR_TEXT,
                );
            }
            Concept::Ray => {
                let far = 100.0 * view.observer.distance();
                let end = unit(ray.direction).map(|d| ray.origin + far * d);
                self.line(ray.origin, end.unwrap_or(ray.origin), pen);
                self.highlighted_line(ray.origin, ray.at(1.0), pen, Some("𝐩 + 𝑡 𝐝".to_owned()));
            }
            Concept::Root { object, number } => {
                let Some(root) = inspection.root_of(object, number) else { return };
                self.line(ray.origin, root.point, LineStyle { width: BESIDE, ..pen });
                self.highlighted_point(
                    root.point,
                    pen,
                    format!("𝑡 = {}", highlighted.number(root.t)),
                );
            }
            Concept::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let length = self.normal_length(hit.point);
                let pen = LineStyle { color: self.colors.hit, ..pen };
                let tip = hit.point + 1.3 * length * hit.normal;
                self.highlighted_arrow(hit.point, tip, Head::Filled, pen, "n", VECTOR_TEXT);
            }
            _ => {}
        }
    }

    /// Draws the parts of the direction as a chain from the eye: forwards, right and up.
    fn highlight_chain(&mut self, eye: DVec3, parts: &RayDerivation, pen: LineStyle) {
        let [u, v, w] = self.colors.basis;
        let vectors = [(parts.along_w, w), (parts.along_u, u), (parts.along_v, v)];
        let mut from = eye;
        for ((vector, color), (concept, text)) in vectors.into_iter().zip(ALONG) {
            let width = if pen.concept == Some(concept) { STRONG } else { BESIDE };
            let pen = LineStyle { color, width, ..pen }.about(concept);
            self.arrow(from, from + vector, Head::Filled, pen);
            if let Some(spot) = self.screen.spot(from + 0.5 * vector) {
                let font = (color, POINT_TEXT, false);
                self.label(pen, text, spot.at, DVec2::new(0.0, 1.0), font);
            }
            from += vector;
        }
        let ray = LineStyle { color: self.colors.ray, width: 2.0, concept: None, ..pen };
        self.line(eye, from, ray);
    }

    /// Draws a sphere's silhouette, or a square in a plane and the plane's normal.
    fn highlight_object(&mut self, index: u32) {
        let view = self.view;
        let Some(object) = self.scene.object(index) else { return };
        let pen =
            LineStyle::new(Item::Ray, self.colors.hit, 4.0).about(Concept::Object(index)).on_top();
        match object {
            Object::Sphere(sphere) => {
                let from = view.frame.camera().eye();
                let outline = silhouette(&sphere, from).unwrap_or_default();
                for pen in cased(pen, self.colors.halo) {
                    outline.windows(2).for_each(|pair| self.line(pair[0], pair[1], pen));
                }
            }
            Object::Plane(plane) => {
                let Some(normal) = unit(plane.normal) else { return };
                let (target, size) = (view.observer.target(), 0.3 * view.observer.distance());
                let center = target - normal.dot(target - plane.point) * normal;
                let (a, b) = tangents(normal);
                let corner = |x: f64, y: f64| center + size * (x * a + y * b);
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                self.sides(corners.map(|(x, y)| corner(x, y)), pen);
                let tip = center + 0.5 * size * normal;
                self.highlighted_arrow(center, tip, Head::Filled, pen, "n", VECTOR_TEXT);
            }
        }
    }
}
