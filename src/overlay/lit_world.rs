//! What is lit, in the world view.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Object, Orientation, PosedCamera};
use pinhole_lecture::{BasisDerivation, Cross, RayDerivation};

use crate::overlay::camera_in_space::{
    ARROW_POINTS, NORMAL_POINTS, POINT_TEXT, UP_LENGTH, VECTOR_TEXT, VIEW_LENGTH, corners,
};
use crate::overlay::items::{Item, OverlayItems};
use crate::overlay::lit::{ALONG, BESIDE, Lit, STRONG, cased, dim, first, silhouette};
use crate::overlay::objects::tangents;
use crate::overlay::screen::unit;
use crate::overlay::sketch::{Head, Pen, Sketch};
use crate::overlay::world_view::WorldView;
use crate::thing::Thing;

impl Sketch<'_> {
    /// Lights a thing over everything that is drawn already.
    pub(crate) fn light(&mut self, view: &WorldView, lit: Lit) {
        dim(&mut self.drawing, &mut self.requests, lit.thing);
        let (shown, before) = (self.items, self.requests.len());
        self.items = OverlayItems::ALL;
        self.light_given(view, lit);
        if let Some(posed) = view.posed {
            self.light_camera(posed, lit);
            self.light_selected(posed, view, lit);
        }
        if let Thing::Object(index) = lit.thing {
            self.light_object(view, index);
        }
        self.items = shown;
        let own = self.requests.split_off(before);
        self.requests = first(own, std::mem::take(&mut self.requests));
    }

    fn lit_pen(&self, lit: Lit, color: Color32) -> Pen {
        Pen::new(Item::Ray, color, STRONG).of(lit.thing).on_top()
    }

    fn lit_arrow(&mut self, from: DVec3, to: DVec3, head: Head, pen: Pen, text: &str, size: f32) {
        let tip = self.arrow(from, to, head, pen);
        let bold = size == VECTOR_TEXT;
        self.label_tip(pen, text.to_owned(), tip, (pen.color, size, bold));
    }

    fn lit_point(&mut self, at: DVec3, pen: Pen, text: String) {
        if let Some(spot) = self.point(at, 8.0, pen) {
            let font = (pen.color, POINT_TEXT, false);
            self.label(pen, text, spot.at, DVec2::new(0.4, 1.0), font);
        }
    }

    fn lit_line(&mut self, from: DVec3, to: DVec3, pen: Pen, text: Option<String>) {
        self.line(from, to, pen);
        if let (Some(text), Some(spot)) = (text, self.screen.spot(from.midpoint(to))) {
            let font = (pen.color, POINT_TEXT, false);
            self.label(pen, text, spot.at, DVec2::new(0.0, 1.0), font);
        }
    }

    /// What the camera is given by, which is there without a basis too.
    fn light_given(&mut self, view: &WorldView, lit: Lit) {
        let eye = view.camera.eye;
        let arrow = self.length_of_points(eye, ARROW_POINTS);
        let (given, ink) = (self.colors.given, self.colors.ink);
        let looks = unit(view.camera.view());
        match (lit.thing, view.camera.orientation) {
            (Thing::Eye, _) => self.lit_point(eye, self.lit_pen(lit, ink), "eye".to_owned()),
            (Thing::At, Orientation::At { at, .. }) => {
                self.lit_point(at, self.lit_pen(lit, given), "at".to_owned());
            }
            (Thing::View | Thing::Backwards, _) => {
                let Some(looks) = looks else { return };
                let pen = self.lit_pen(lit, given);
                let tip = eye + arrow * VIEW_LENGTH * looks;
                if lit.thing == Thing::View {
                    self.lit_arrow(eye, tip, Head::Filled, pen, "view", POINT_TEXT);
                } else {
                    let thin = Pen { width: BESIDE, ..pen };
                    self.lit_arrow(eye, tip, Head::Filled, thin, "view", POINT_TEXT);
                    let tip = eye - arrow * VIEW_LENGTH * looks;
                    self.lit_arrow(eye, tip, Head::Filled, pen, "−view", POINT_TEXT);
                }
            }
            (Thing::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let Some(up) = unit(up) else { return };
                let pen = self.lit_pen(lit, given);
                let tip = eye + arrow * UP_LENGTH * up;
                self.lit_arrow(eye, tip, Head::Filled, pen, "up", POINT_TEXT);
            }
            (Thing::UpCrossW | Thing::WCrossU, _) => {
                let BasisDerivation::FromUp(from_up) = BasisDerivation::new(view.camera) else {
                    return;
                };
                let [u, v, w] = self.colors.basis;
                let cross = |s: &mut Self, cross: Option<Cross>, names, colors| {
                    if let Some(cross) = cross {
                        s.light_cross(eye, arrow, &cross, lit, (names, colors));
                    }
                };
                if lit.thing == Thing::UpCrossW {
                    cross(self, from_up.up_cross_w, ["up", "w", "up × w"], [given, w, u]);
                } else {
                    cross(self, from_up.w_cross_u, ["w", "u", "w × u = v"], [w, u, v]);
                }
            }
            _ => {}
        }
    }

    /// Both factors, the parallelogram between them, and the product as long as that is large:
    /// `|first| sin(angle)`, the second being 1 long. A first factor too short or too long to be drawn
    /// beside the second has length 1 here, too.
    fn light_cross(
        &mut self,
        eye: DVec3,
        arrow: f64,
        cross: &Cross,
        lit: Lit,
        (names, colors): ([&str; 3], [Color32; 3]),
    ) {
        let (Some(a), Some(b)) = (unit(cross.first.vector), unit(cross.second.vector)) else {
            return;
        };
        let own = cross.first.length;
        let length = if (0.4..=2.0).contains(&own) { own } else { 1.0 };
        let (a, b) = (arrow * length * a, arrow * b);
        let pen = self.lit_pen(lit, colors[2]);
        let fill = Pen { color: colors[2].gamma_multiply(0.3), ..pen }.without_halo();
        self.polygon(&[eye, eye + a, eye + a + b, eye + b], fill);
        let edge = Pen { width: 1.6, ..pen }.without_halo();
        self.line(eye + a, eye + a + b, edge);
        self.line(eye + b, eye + a + b, edge);
        for ((vector, name), color) in [(a, names[0]), (b, names[1])].into_iter().zip(colors) {
            let pen = Pen { color, width: BESIDE + 1.0, ..pen };
            let size = if name == "up" { POINT_TEXT } else { VECTOR_TEXT };
            self.lit_arrow(eye, eye + vector, Head::Filled, pen, name, size);
        }
        let Some((angle, sine)) = cross.angle.zip(cross.sine) else { return };
        if let Some(product) = unit(cross.product) {
            let tip = eye + arrow * length * sine * product;
            self.lit_arrow(eye, tip, Head::Filled, pen, names[2], VECTOR_TEXT);
        }
        if let Some(spot) = self.screen.spot(eye + 0.5 * (a + b)) {
            let sine_of = format!("sin({})", lit.degrees(angle));
            let text = if lit.number(length) == lit.number(1.0) {
                format!("{sine_of} = {}", lit.number(sine))
            } else {
                format!("{} · {sine_of} = {}", lit.number(length), lit.number(length * sine))
            };
            self.label(pen, text, spot.at, DVec2::ZERO, (colors[2], POINT_TEXT, false));
        }
    }

    /// What comes with the basis.
    fn light_camera(&mut self, posed: &PosedCamera, lit: Lit) {
        let eye = posed.eye();
        let arrow = self.length_of_points(eye, ARROW_POINTS);
        let basis = posed.basis();
        let vectors = [
            (Thing::U, "u", basis.u, Head::Filled),
            (Thing::V, "v", basis.v, Head::Open),
            (Thing::W, "w", basis.w, Head::Double),
        ];
        let inks = self.colors.basis.into_iter().zip(self.colors.patterns);
        for ((thing, name, vector, head), (color, pattern)) in vectors.into_iter().zip(inks) {
            if thing == lit.thing {
                let pen = self.lit_pen(lit, color).patterned(pattern);
                self.lit_arrow(eye, eye + arrow * vector, head, pen, name, VECTOR_TEXT);
            }
        }
        let pen = self.lit_pen(lit, self.colors.ink);
        match lit.thing {
            Thing::Viewport => {
                let corners = corners(posed).map(|uv| posed.viewport_point(uv));
                for k in 0..4 {
                    self.line(corners[k], corners[(k + 1) % 4], pen);
                }
            }
            Thing::Distance => {
                let text = format!("distance = {}", lit.number(posed.viewport().distance));
                self.lit_line(eye, posed.viewport_point(DVec2::ZERO), pen, Some(text));
            }
            _ => {}
        }
    }

    /// What belongs to the selected ray.
    fn light_selected(&mut self, posed: &PosedCamera, view: &WorldView, lit: Lit) {
        let Some(inspection) = view.inspection else { return };
        let ray = &inspection.ray;
        let pen = self.lit_pen(lit, self.colors.ray);
        match lit.thing {
            Thing::Pixel => {
                let touched = inspection.place.map(|place| place.touching(posed.image()));
                touched.into_iter().flatten().for_each(|pixel| self.pixel(posed, pixel));
                self.lit_point(ray.at(1.0), pen, "(𝑢, 𝑣)".to_owned());
            }
            Thing::AlongU | Thing::AlongV | Thing::AlongW => {
                if let Ok(parts) = RayDerivation::of_uv(posed, inspection.uv) {
                    self.light_chain(posed.eye(), &parts, pen);
                }
            }
            Thing::Direction => {
                self.lit_arrow(ray.origin, ray.at(1.0), Head::Filled, pen, "d", VECTOR_TEXT);
            }
            Thing::Ray => {
                let far = 100.0 * view.observer.distance();
                let end = unit(ray.direction).map(|d| ray.origin + far * d);
                self.line(ray.origin, end.unwrap_or(ray.origin), pen);
                self.lit_line(ray.origin, ray.at(1.0), pen, Some("𝐩 + 𝑡 𝐝".to_owned()));
            }
            Thing::Root { object, number } => {
                let Some(root) = inspection.root_of(object, number) else { return };
                self.line(ray.origin, root.point, Pen { width: BESIDE, ..pen });
                self.lit_point(root.point, pen, format!("𝑡 = {}", lit.number(root.t)));
            }
            Thing::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let length = self.length_of_points(hit.point, (NORMAL_POINTS, NORMAL_POINTS));
                let pen = Pen { color: self.colors.hit, ..pen };
                let tip = hit.point + 1.3 * length * hit.normal;
                self.lit_arrow(hit.point, tip, Head::Filled, pen, "n", VECTOR_TEXT);
            }
            _ => {}
        }
    }

    /// From the eye forwards, to the right and up, as far as each part of the direction goes.
    fn light_chain(&mut self, eye: DVec3, parts: &RayDerivation, pen: Pen) {
        let [u, v, w] = self.colors.basis;
        let vectors = [(parts.along_w, w), (parts.along_u, u), (parts.along_v, v)];
        let mut from = eye;
        for ((vector, color), (thing, text)) in vectors.into_iter().zip(ALONG) {
            let width = if pen.thing == Some(thing) { STRONG } else { BESIDE };
            let pen = Pen { color, width, ..pen }.of(thing);
            self.arrow(from, from + vector, Head::Filled, pen);
            if let Some(spot) = self.screen.spot(from + 0.5 * vector) {
                let font = (color, POINT_TEXT, false);
                self.label(pen, text, spot.at, DVec2::new(0.0, 1.0), font);
            }
            from += vector;
        }
        let ray = Pen { color: self.colors.ray, width: 2.0, thing: None, ..pen };
        self.line(eye, from, ray);
    }

    /// A sphere's silhouette; of a plane a square and its normal.
    fn light_object(&mut self, view: &WorldView, index: u32) {
        let Some(object) = view.scene.objects().nth(index as usize) else { return };
        let pen = Pen::new(Item::Ray, self.colors.hit, 4.0).of(Thing::Object(index)).on_top();
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
                let corners =
                    [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
                for k in 0..4 {
                    self.line(corners[k], corners[(k + 1) % 4], pen);
                }
                self.lit_arrow(
                    center,
                    center + 0.5 * size * normal,
                    Head::Filled,
                    pen,
                    "n",
                    VECTOR_TEXT,
                );
            }
        }
    }
}
