//! What is lit, in the camera view: there, w points at whoever looks, and all of a ray is one point.

use egui::Color32;
use pinhole_core::lecture::{BasisDerivation, Cross};
use pinhole_core::{DVec2, DVec3, Object, Orientation};

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

impl Sheet<'_> {
    /// Lights a thing over everything that is drawn already; one that the camera cannot see leaves
    /// the picture as it is.
    pub(super) fn light(&mut self, lit: Lit) {
        let (shown, before) = (self.items, self.requests.len());
        let others = std::mem::take(&mut self.drawing.marks);
        self.items = OverlayItems::ALL;
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

    fn light_basis(&mut self, lit: Lit) {
        let middle = self.middle();
        let length = ARROW * self.view.extent().min_element();
        let [u, v, w] = self.colors.basis;
        let given = self.colors.given;
        let basis = *self.view.posed.basis();
        let below = DVec2::new(0.6, 1.0);
        match lit.thing {
            Thing::At if matches!(lit.camera.orientation, Orientation::At { .. }) => {
                let pen = Self::pen(lit, given);
                let radius = 6.0 * self.view.scale;
                self.add(pen, Shape::Disc { center: dot(middle), radius });
                self.label(pen, "at", middle, below, (POINT_TEXT, false));
            }
            Thing::View => self.along_view(middle, true, Self::pen(lit, given), "view", below),
            Thing::Backwards => {
                self.along_view(middle, false, Self::pen(lit, given), "−view", below);
            }
            Thing::W => self.along_view(middle, false, Self::pen(lit, w), "𝐰", below),
            Thing::U | Thing::V => {
                let (vector, color, name) =
                    if lit.thing == Thing::U { (basis.u, u, "u") } else { (basis.v, v, "v") };
                let along = length * self.in_image(vector);
                self.arrow(middle, along, Self::pen(lit, color), name, VECTOR_TEXT);
            }
            Thing::Up => {
                let (Orientation::At { up, .. } | Orientation::View { up, .. }) =
                    lit.camera.orientation
                else {
                    return;
                };
                let along = length * self.in_image(unit(up).unwrap_or_default());
                self.arrow(middle, along, Self::pen(lit, given), "up", POINT_TEXT);
            }
            Thing::UpCrossW | Thing::WCrossU => {
                let BasisDerivation::FromUp(from_up) = BasisDerivation::of(lit.camera) else {
                    return;
                };
                if let (Thing::UpCrossW, Some(cross)) = (lit.thing, from_up.up_cross_w) {
                    self.light_cross(lit, &cross, cross.first, ("up", given), ("up × w", u));
                } else if let Some(cross) = from_up.w_cross_u {
                    self.light_cross(lit, &cross, cross.second, ("u", u), ("w × u = v", v));
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
        factor: pinhole_core::lecture::Measured,
        (name, color): (&str, Color32),
        (product, product_color): (&str, Color32),
    ) {
        let middle = self.middle();
        let length = ARROW * self.view.extent().min_element();
        let (pen, w) = (Self::pen(lit, product_color), self.colors.basis[2]);
        let along = |s: &Self, vector: DVec3| length * s.in_image(unit(vector).unwrap_or_default());
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
            Thing::AlongU | Thing::AlongV | Thing::AlongW => {
                let [_, u, v] = ALONG;
                let corner = place_of(posed, size, DVec2::new(inspection.uv.x, 0.0));
                let middle = self.middle();
                let [color_u, color_v, color_w] = self.colors.basis;
                let sides = [(u, middle, corner, color_u), (v, corner, at, color_v)];
                for ((thing, text), from, to, color) in sides {
                    let width = if thing == lit.thing { STRONG } else { BESIDE };
                    let pen = Pen { color, width, ..pen }.of(thing);
                    self.arrow(from, to - from, pen, text, POINT_TEXT);
                }
                if lit.thing == Thing::AlongW {
                    let toward = DVec2::new(-0.6, -1.0);
                    let pen = Pen { color: color_w, ..pen };
                    self.along_view(middle, true, pen, ALONG[0].1, toward);
                }
            }
            Thing::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let along = ARROW * self.view.extent().min_element() * self.in_image(hit.normal);
                let pen = Pen { color: self.colors.hit, ..pen };
                self.add(pen, Shape::Disc { center: dot(at), radius });
                self.arrow(at, along, pen, "n", VECTOR_TEXT);
            }
            _ => {}
        }
    }

    /// A sphere's outline.
    fn light_object(&mut self, lit: Lit, index: u32) {
        let Some(Object::Sphere(sphere)) = lit.scene.objects().nth(index as usize) else { return };
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
}
