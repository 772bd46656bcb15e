//! What is lit, in the camera view: there, w points at whoever looks, and all of a ray is one point.

use egui::Color32;
use pinhole_core::{
    DVec2, DVec3, Frame, NO_OBJECT, Object, Orientation, Outputs, Pixel, PosedCamera, Raster,
    Scene, trace,
};
use pinhole_lecture::{BasisDerivation, Cross};

use crate::overlay::camera_in_space::{POINT_TEXT, VECTOR_TEXT};
use crate::overlay::camera_view::{Sheet, place_of};
use crate::overlay::drawing::{Shape, dot};
use crate::overlay::items::{Item, OverlayItems};
use crate::overlay::lit::{ALONG, BESIDE, Lit, STRONG, cased, dim, first, silhouette};
use crate::overlay::screen::{Screen, unit};
use crate::overlay::sketch::Pen;
use crate::thing::Thing;

/// The length of an arrow of length 1, as a share of the picture's shorter side.
const ARROW: f64 = 0.3;

/// From one stroke of a plane's hatching to the next, and how finely its border is followed, in
/// points.
const HATCH: f64 = 20.0;
const CELL: f64 = 3.0;

impl Sheet<'_> {
    /// Lights a thing over everything that is drawn already; one that the camera cannot see leaves
    /// the picture as it is.
    pub(super) fn light(&mut self, lit: Lit) {
        let (shown, before) = (self.items, self.requests.len());
        if let Thing::Object(index) = lit.thing
            && let Some(Object::Plane(_)) = lit.scene.object(index)
        {
            return self.light_plane(lit, index);
        }
        let others = std::mem::take(&mut self.drawing.marks);
        self.items = OverlayItems::ALL;
        self.light_given(lit);
        self.light_basis(lit);
        self.light_selected(lit);
        if let Thing::Object(index) = lit.thing {
            self.light_object(lit, index);
        }
        self.items = shown;
        let mut own = std::mem::replace(&mut self.drawing.marks, others);
        let labels = self.requests.split_off(before);
        if !own.is_empty() {
            dim(&mut self.drawing, &mut self.requests, lit.thing);
        }
        self.drawing.marks.append(&mut own);
        self.requests = first(labels, std::mem::take(&mut self.requests));
    }

    fn middle(&self) -> DVec2 {
        0.5 * self.view.extent()
    }

    fn pen(lit: Lit, color: Color32) -> Pen {
        Pen::new(Item::Ray, color, STRONG).of(lit.thing)
    }

    /// A direction of the world as it lies in the image; of length 1 if it is at right angles to w.
    fn in_image(&self, direction: DVec3) -> DVec2 {
        let basis = self.view.posed.basis();
        DVec2::new(basis.u.dot(direction), -basis.v.dot(direction))
    }

    /// The arrow of a vector of length 1 at right angles to w; of another one what is seen of it.
    fn arrow_of(&self, vector: DVec3) -> DVec2 {
        ARROW * self.view.extent().min_element() * self.in_image(vector)
    }

    fn arrow(&mut self, from: DVec2, along: DVec2, pen: Pen, text: &str, size: f32) {
        let tip = from + along;
        let head = f64::from(self.view.scale * (4.0 + 2.6 * pen.width)).min(0.8 * along.length());
        let Some(direction) = along.try_normalize() else { return };
        let (back, side) = (tip - head * direction, 0.42 * head * direction.perp());
        self.line(&[from, tip - 0.7 * head * direction], pen);
        let points = [tip, back + side, back - side].map(dot).to_vec();
        self.add(pen, Shape::Polygon { points });
        let font = (size, size == VECTOR_TEXT);
        self.label(pen, text.to_owned(), tip, direction, font);
    }

    /// The sign for what points at whoever looks, a dot in a ring, or away, a cross in one.
    fn along_view(&mut self, at: DVec2, away: bool, pen: Pen, text: &str, toward: DVec2) {
        let scale = f64::from(self.view.scale);
        let pen = Pen { width: 2.4, ..pen };
        let radius = 9.0 * scale;
        let ring = (0..=32)
            .map(|k| at + radius * DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 32.0));
        let ring: Vec<DVec2> = ring.collect();
        self.line(&ring, pen);
        if away {
            let arm = radius * std::f64::consts::FRAC_1_SQRT_2 * DVec2::ONE;
            self.line(&[at - arm, at + arm], pen);
            self.line(&[at - arm.perp(), at + arm.perp()], pen);
        } else {
            self.add(pen, Shape::Disc { center: dot(at), radius: (3.6 * scale) as f32 });
        }
        self.label(pen, text.to_owned(), at, toward, (POINT_TEXT, false));
    }

    /// Eye, at, view and up, and what is made of view.
    fn light_given(&mut self, lit: Lit) {
        let (middle, below) = (self.middle(), DVec2::new(0.6, 1.0));
        let pen = Self::pen(lit, self.colors.given);
        match (lit.thing, lit.camera.orientation) {
            (Thing::Eye, _) => {
                // All rays begin there: it is behind the picture's middle.
                let pen = Pen { color: self.colors.ink, ..pen };
                self.along_view(middle, false, pen, "eye: straight behind this point", below);
            }
            (Thing::At, Orientation::At { .. }) => {
                let radius = 6.0 * self.view.scale;
                self.add(pen, Shape::Disc { center: dot(middle), radius });
                self.label(pen, "at", middle, below, (POINT_TEXT, false));
            }
            (Thing::View, _) => self.along_view(middle, true, pen, "view", below),
            (Thing::Backwards, _) => self.along_view(middle, false, pen, "−view", below),
            (Thing::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let along = self.arrow_of(unit(up).unwrap_or_default());
                self.arrow(middle, along, pen, "up", POINT_TEXT);
            }
            _ => {}
        }
    }

    fn light_basis(&mut self, lit: Lit) {
        let middle = self.middle();
        let [u, v, w] = self.colors.basis;
        let given = self.colors.given;
        let basis = *self.view.posed.basis();
        let below = DVec2::new(0.6, 1.0);
        match lit.thing {
            Thing::W => self.along_view(middle, false, Self::pen(lit, w), "𝐰", below),
            Thing::U | Thing::V => {
                let (vector, color, name, k) =
                    if lit.thing == Thing::U { (basis.u, u, "u", 0) } else { (basis.v, v, "v", 1) };
                let pen = Self::pen(lit, color).patterned(self.colors.patterns[k]);
                self.arrow(middle, self.arrow_of(vector), pen, name, VECTOR_TEXT);
            }
            Thing::UpCrossW | Thing::WCrossU => {
                let BasisDerivation::FromUp(from_up) = BasisDerivation::new(lit.camera) else {
                    return;
                };
                if let (Thing::UpCrossW, Some(cross)) = (lit.thing, from_up.up_cross_w) {
                    self.light_cross(lit, &cross, cross.first, ("up", given), ("up × 𝐰", u));
                } else if let Some(cross) = from_up.w_cross_u {
                    self.light_cross(lit, &cross, cross.second, ("u", u), ("𝐰 × 𝐮 = 𝐯", v));
                }
            }
            Thing::Distance => {
                let text =
                    format!("distance = {}", lit.number(self.view.posed.viewport().distance));
                self.along_view(middle, true, Self::pen(lit, self.colors.ink), &text, below);
            }
            _ => {}
        }
    }

    /// w towards whoever looks, the other factor and the product beside it.
    fn light_cross(
        &mut self,
        lit: Lit,
        cross: &Cross,
        factor: pinhole_lecture::VectorAndLength,
        (name, color): (&str, Color32),
        (product, product_color): (&str, Color32),
    ) {
        let middle = self.middle();
        let (pen, w) = (Self::pen(lit, product_color), self.colors.basis[2]);
        let along = |s: &Self, vector: DVec3| s.arrow_of(unit(vector).unwrap_or_default());
        let beside = Pen { width: BESIDE, color, ..pen };
        self.arrow(middle, along(self, factor.vector), beside, name, POINT_TEXT);
        let sine = cross.sine.unwrap_or_default();
        self.arrow(middle, sine * along(self, cross.product), pen, product, VECTOR_TEXT);
        let below = DVec2::new(-1.0, 1.0);
        self.along_view(middle, false, Pen { color: w, ..pen }, "𝐰", below);
    }

    fn light_selected(&mut self, lit: Lit) {
        let Some(inspection) = self.view.inspection else { return };
        let (posed, size) = (self.view.posed, self.view.size);
        let at = place_of(posed, size, inspection.uv);
        let pen = Self::pen(lit, self.colors.ray);
        let radius = 6.0 * self.view.scale;
        let point = |s: &mut Self, text: String| {
            s.add(pen, Shape::Disc { center: dot(at), radius });
            s.label(pen, text, at, DVec2::new(0.4, 1.0), (POINT_TEXT, false));
        };
        match lit.thing {
            Thing::Viewport => {
                let inset = DVec2::splat(2.0 * f64::from(self.view.scale));
                self.frame(
                    inset,
                    self.view.extent() - inset,
                    Pen { color: self.colors.ink, ..pen },
                );
            }
            Thing::Pixel => {
                let per_pixel = self.view.dots_per_pixel();
                let touched = inspection.place.map(|place| place.touching(posed.image()));
                for pixel in touched.into_iter().flatten() {
                    let corner = |k: u32| {
                        DVec2::new((pixel.column + k).into(), (pixel.row + k).into()) * per_pixel
                    };
                    self.frame(corner(0), corner(1), Pen { width: BESIDE, ..pen });
                }
                point(self, "(𝑢, 𝑣)".to_owned());
            }
            Thing::Direction => point(self, "𝐝".to_owned()),
            Thing::Ray => point(self, "𝐩 + 𝑡 𝐝".to_owned()),
            Thing::Root { object, number } => {
                let root = inspection.root_of(object, number).filter(|root| root.t > 0.0);
                if let Some(root) = root {
                    point(self, format!("𝑡 = {}", lit.number(root.t)));
                }
            }
            Thing::AlongU | Thing::AlongV | Thing::AlongW => self.light_parts(lit, inspection.uv),
            Thing::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let along = self.arrow_of(hit.normal);
                let pen = Pen { color: self.colors.hit, ..pen };
                self.add(pen, Shape::Disc { center: dot(at), radius });
                self.arrow(at, along, pen, "n", VECTOR_TEXT);
            }
            _ => {}
        }
    }

    /// The parts of the selected ray's direction: along w from the picture's middle, u and v in it.
    fn light_parts(&mut self, lit: Lit, uv: DVec2) {
        let (posed, size, middle) = (self.view.posed, self.view.size, self.middle());
        let place = |uv: DVec2| place_of(posed, size, uv);
        let (at, corner) = (place(uv), place(DVec2::new(uv.x, 0.0)));
        let [w, u, v] = ALONG;
        let [color_u, color_v, color_w] = self.colors.basis;
        let pen = Self::pen(lit, color_w);
        let sides = [(u, middle, corner, color_u), (v, corner, at, color_v)];
        for ((thing, text), from, to, color) in sides {
            let width = if thing == lit.thing { STRONG } else { BESIDE };
            self.arrow(from, to - from, Pen { color, width, ..pen }.of(thing), text, POINT_TEXT);
        }
        if lit.thing == Thing::AlongW {
            self.along_view(middle, true, pen, w.1, DVec2::new(-0.6, -1.0));
        }
    }

    /// A sphere's outline.
    fn light_object(&mut self, lit: Lit, index: u32) {
        let Some(Object::Sphere(sphere)) = lit.scene.object(index) else { return };
        let posed = self.view.posed;
        let unit = (sphere.center - posed.eye()).length();
        let screen = Screen::of_size(posed, self.view.extent(), unit);
        let pen = Pen { width: 4.0, ..Self::pen(lit, self.colors.hit) };
        let outline = silhouette(&sphere, posed.eye()).unwrap_or_default();
        for pen in cased(pen, self.colors.halo) {
            for cut in outline.windows(2).filter_map(|pair| screen.line(pair[0], pair[1])) {
                self.line(&[cut.from.at, cut.to.at], pen);
            }
        }
    }

    /// Hatches the pixels at which a plane is seen, below all else: it may be all of the picture,
    /// and what lies on it can still be seen and pointed at.
    fn light_plane(&mut self, lit: Lit, index: u32) {
        let pen = Pen::new(Item::Ray, self.colors.hit, 1.5);
        let (extent, scale) = (self.view.extent(), f64::from(self.view.scale));
        let cells = Cells::of(self.view.posed, lit.scene, extent, CELL * scale);
        let strokes = hatch(extent, HATCH * scale, CELL * scale, |at| cells.object_at(at) == index);
        let shown = std::mem::replace(&mut self.items, OverlayItems::ALL);
        let mut others = std::mem::take(&mut self.drawing.marks);
        for pen in cased(pen, self.colors.halo.gamma_multiply(0.6)) {
            strokes.iter().for_each(|stroke| self.line(stroke, pen));
        }
        self.drawing.marks.append(&mut others);
        self.items = shown;
    }
}

/// Which object is seen where, as finely as hatching needs it.
struct Cells {
    frame: Frame<f64>,
    /// Dots of a pixel of the image.
    per_pixel: DVec2,
}

impl Cells {
    fn of(posed: &PosedCamera, scene: &Scene, extent: DVec2, cell: f64) -> Cells {
        let image = posed.image();
        let [columns, rows] = (extent / cell).to_array().map(|cells| cells.ceil() as u32);
        let raster = Raster::shown_on(image, columns, rows);
        let outputs = Outputs { t: false, object: true, normal: false };
        Cells {
            frame: trace(scene, posed, &raster, outputs),
            per_pixel: extent / DVec2::new(image.width().into(), image.height().into()),
        }
    }

    /// The object seen at a place, in dots.
    fn object_at(&self, at: DVec2) -> u32 {
        let cell = at / self.per_pixel;
        // A cast saturates: at the first beside the picture.
        let pixel = Pixel { row: cell.y as u32, column: cell.x as u32 };
        let Some(place) = self.frame.raster().nearest_to(pixel) else { return NO_OBJECT };
        self.frame.object.get(place).copied().unwrap_or(NO_OBJECT)
    }
}

/// Strokes rising to the right, `apart` from each other, over the places of a picture that are
/// `inside`; looked at every `step`.
fn hatch(extent: DVec2, apart: f64, step: f64, inside: impl Fn(DVec2) -> bool) -> Vec<[DVec2; 2]> {
    let mut strokes = Vec::new();
    let direction = DVec2::new(std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2);
    let (reach, apart) = (extent.x + extent.y, apart * std::f64::consts::SQRT_2);
    for k in 1..(reach / apart).ceil() as u32 {
        // Where x + y is the same, from the left edge or the lower one.
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
