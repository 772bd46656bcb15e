//! Highlighting in the camera view, where w points at the observer and a whole ray is a single point.

use egui::Color32;
use pinhole_core::{
    DVec2, DVec3, Frame, NO_OBJECT, Object, Orientation, Outputs, Pixel, Raster, ResolvedCamera,
    Scene, trace,
};
use pinhole_lecture::{BasisDerivation, Cross};

use crate::model::concept::Concept;
use crate::model::overlay_items::{Item, OverlayItems};

use crate::view::overlay::camera_view::CameraSketch;
use crate::view::overlay::drawing::{Shape, circle, dot};
use crate::view::overlay::screen::{Screen, position_of, unit};
use crate::view::overlay::style::{POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::highlighted::{
    ALONG, BESIDE, Highlighted, STRONG, cased, dim, first, silhouette,
};
use crate::view::overlay::world_view::sketch::LineStyle;

/// Length of the arrow of a unit vector, as a share of the picture's shorter side.
const ARROW: f64 = 0.3;

/// Distance between two strokes of a plane's hatching, and the distance between tests of a stroke against the
/// plane's border; both in points.
const HATCH: f64 = 20.0;
const CELL: f64 = 3.0;

impl CameraSketch<'_> {
    /// Highlights a concept on top of everything already drawn. If the camera cannot see it, the picture
    /// stays as it is.
    pub(super) fn highlight(&mut self, highlighted: Highlighted, scene: &Scene) {
        let (shown, before) = (self.items, self.requests.len());
        if let Concept::Object(index) = highlighted.concept
            && let Some(Object::Plane(_)) = scene.object(index)
        {
            if highlighted.dims {
                self.highlight_plane(scene, index);
            }
            return;
        }
        let others = std::mem::take(&mut self.drawing.marks);
        self.items = OverlayItems::ALL;
        self.highlight_given(highlighted);
        self.highlight_basis(highlighted);
        self.highlight_selected(highlighted);
        if let Concept::Object(index) = highlighted.concept {
            self.highlight_object(highlighted, scene, index);
        }
        self.items = shown;
        let mut own = std::mem::replace(&mut self.drawing.marks, others);
        let labels = self.requests.split_off(before);
        if !own.is_empty() {
            dim(&mut self.drawing, &mut self.requests, highlighted);
        }
        self.drawing.marks.append(&mut own);
        self.requests = first(labels, std::mem::take(&mut self.requests));
    }

    fn middle(&self) -> DVec2 {
        0.5 * self.view.extent()
    }

    fn pen(highlighted: Highlighted, color: Color32) -> LineStyle {
        LineStyle::new(Item::Ray, color, STRONG).about(highlighted.concept)
    }

    /// Projects a direction of the world into the image. For a unit vector orthogonal to w, the result has
    /// length 1.
    fn in_image(&self, direction: DVec3) -> DVec2 {
        let basis = self.view.resolved.basis();
        DVec2::new(basis.u.dot(direction), -basis.v.dot(direction))
    }

    /// Returns the arrow of a unit vector, foreshortened unless it is orthogonal to w.
    fn arrow_of(&self, vector: DVec3) -> DVec2 {
        ARROW * self.view.extent().min_element() * self.in_image(vector)
    }

    fn arrow(&mut self, from: DVec2, along: DVec2, pen: LineStyle, text: &str, size: f32) {
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

    /// Draws the symbol of a vector along the line of sight: a dot in a ring if it points towards the
    /// observer, a cross in a ring if it points away.
    fn along_view(&mut self, at: DVec2, away: bool, pen: LineStyle, text: &str, toward: DVec2) {
        self.ring_along_view(at, away, pen);
        self.label(pen, text.to_owned(), at, toward, (POINT_TEXT, false));
    }

    /// Draws w, which points at the observer.
    fn w_at_middle(&mut self, pen: LineStyle, toward: DVec2) {
        let middle = self.middle();
        self.ring_along_view(middle, false, pen);
        self.label(pen, "w".to_owned(), middle, toward, (VECTOR_TEXT, true));
    }

    fn ring_along_view(&mut self, at: DVec2, away: bool, pen: LineStyle) {
        let scale = f64::from(self.view.scale);
        let pen = LineStyle { width: 2.4, ..pen };
        let radius = 9.0 * scale;
        let ring: Vec<DVec2> = circle(32).map(|point| at + radius * point).collect();
        self.line(&ring, pen);
        if away {
            let arm = radius * std::f64::consts::FRAC_1_SQRT_2 * DVec2::ONE;
            self.line(&[at - arm, at + arm], pen);
            self.line(&[at - arm.perp(), at + arm.perp()], pen);
        } else {
            self.add(pen, Shape::Disc { center: dot(at), radius: (3.6 * scale) as f32 });
        }
    }

    /// Highlights eye, at, view, up and -view.
    fn highlight_given(&mut self, highlighted: Highlighted) {
        let (middle, below) = (self.middle(), DVec2::new(0.6, 1.0));
        let pen = Self::pen(highlighted, self.colors.given);
        match (highlighted.concept, highlighted.camera.orientation) {
            (Concept::Eye, _) => {
                // All rays begin at the eye, which is behind the middle of the picture.
                let pen = LineStyle { color: self.colors.ink, ..pen };
                self.along_view(middle, false, pen, "eye: straight behind this point", below);
            }
            (Concept::At, Orientation::At { .. }) => {
                let radius = 6.0 * self.view.scale;
                self.add(pen, Shape::Disc { center: dot(middle), radius });
                self.label(pen, "at", middle, below, (POINT_TEXT, false));
            }
            (Concept::View, _) => self.along_view(middle, true, pen, "view", below),
            (Concept::Backwards, _) => self.along_view(middle, false, pen, "−view", below),
            (Concept::Up, Orientation::At { up, .. } | Orientation::View { up, .. }) => {
                let along = self.arrow_of(unit(up).unwrap_or_default());
                self.arrow(middle, along, pen, "up", POINT_TEXT);
            }
            _ => {}
        }
    }

    fn highlight_basis(&mut self, highlighted: Highlighted) {
        let middle = self.middle();
        let [u, v, w] = self.colors.basis;
        let given = self.colors.given;
        let basis = *self.view.resolved.basis();
        let below = DVec2::new(0.6, 1.0);
        match highlighted.concept {
            Concept::W => self.w_at_middle(Self::pen(highlighted, w), below),
            Concept::U | Concept::V => {
                let (vector, color, name, k) = if highlighted.concept == Concept::U {
                    (basis.u, u, "u", 0)
                } else {
                    (basis.v, v, "v", 1)
                };
                let pen = Self::pen(highlighted, color).patterned(self.colors.patterns[k]);
                self.arrow(middle, self.arrow_of(vector), pen, name, VECTOR_TEXT);
            }
            Concept::UpCrossW | Concept::WCrossU => {
                let BasisDerivation::FromUp(from_up) = BasisDerivation::new(&highlighted.camera)
                else {
                    return;
                };
                if let (Concept::UpCrossW, Some(cross)) = (highlighted.concept, from_up.up_cross_w)
                {
                    self.highlight_cross(
                        highlighted,
                        &cross,
                        cross.first,
                        ("up", given),
                        ("up × w", u),
                    );
                } else if let Some(cross) = from_up.w_cross_u {
                    self.highlight_cross(
                        highlighted,
                        &cross,
                        cross.second,
                        ("u", u),
                        ("w × u = v", v),
                    );
                }
            }
            Concept::Distance => {
                let text = format!(
                    "distance = {}",
                    highlighted.number(self.view.resolved.viewport().distance)
                );
                self.along_view(
                    middle,
                    true,
                    Self::pen(highlighted, self.colors.ink),
                    &text,
                    below,
                );
            }
            _ => {}
        }
    }

    /// Draws w towards the observer, and the other factor and the product in the image.
    fn highlight_cross(
        &mut self,
        highlighted: Highlighted,
        cross: &Cross,
        factor: pinhole_lecture::VectorAndLength,
        (name, color): (&str, Color32),
        (product, product_color): (&str, Color32),
    ) {
        let middle = self.middle();
        let (pen, w) = (Self::pen(highlighted, product_color), self.colors.basis[2]);
        let along = |s: &Self, vector: DVec3| s.arrow_of(unit(vector).unwrap_or_default());
        let beside = LineStyle { width: BESIDE, color, ..pen };
        self.arrow(middle, along(self, factor.vector), beside, name, POINT_TEXT);
        let sine = cross.sine.unwrap_or_default();
        self.arrow(middle, sine * along(self, cross.product), pen, product, VECTOR_TEXT);
        let below = DVec2::new(-1.0, 1.0);
        self.w_at_middle(LineStyle { color: w, ..pen }, below);
    }

    fn highlight_selected(&mut self, highlighted: Highlighted) {
        let Some(inspection) = &self.view.inspection else { return };
        let (resolved, size) = (&self.view.resolved, self.view.size);
        let at = position_of(resolved, size, inspection.uv);
        let pen = Self::pen(highlighted, self.colors.ray);
        let radius = 6.0 * self.view.scale;
        let point = |s: &mut Self, text: String| {
            s.add(pen, Shape::Disc { center: dot(at), radius });
            s.label(pen, text, at, DVec2::new(0.4, 1.0), (POINT_TEXT, false));
        };
        match highlighted.concept {
            Concept::Viewport => {
                let inset = DVec2::splat(2.0 * f64::from(self.view.scale));
                self.frame(
                    inset,
                    self.view.extent() - inset,
                    LineStyle { color: self.colors.ink, ..pen },
                );
            }
            Concept::Pixel => {
                let per_pixel = self.view.dots_per_pixel();
                let touched =
                    inspection.image_position.map(|position| position.touching(resolved.image()));
                for pixel in touched.into_iter().flatten() {
                    let corner = |k: u32| {
                        DVec2::new((pixel.column + k).into(), (pixel.row + k).into()) * per_pixel
                    };
                    self.frame(corner(0), corner(1), LineStyle { width: BESIDE, ..pen });
                }
                point(self, "(𝑢, 𝑣)".to_owned());
            }
            Concept::Direction => point(self, "𝐝".to_owned()),
            Concept::Ray => point(self, "𝐩 + 𝑡 𝐝".to_owned()),
            Concept::Root { object, number } => {
                let root = inspection.root_of(object, number).filter(|root| root.t > 0.0);
                if let Some(root) = root {
                    point(self, format!("𝑡 = {}", highlighted.number(root.t)));
                }
            }
            Concept::AlongU | Concept::AlongV | Concept::AlongW => {
                self.highlight_parts(highlighted, inspection.uv)
            }
            Concept::Normal => {
                let Some(hit) = inspection.first_hit() else { return };
                let along = self.arrow_of(hit.normal);
                let pen = LineStyle { color: self.colors.hit, ..pen };
                self.add(pen, Shape::Disc { center: dot(at), radius });
                self.arrow(at, along, pen, "n", VECTOR_TEXT);
            }
            _ => {}
        }
    }

    /// Draws the parts of the selected ray's direction: the part along w at the middle of the picture, and
    /// the parts along u and v in the picture.
    fn highlight_parts(&mut self, highlighted: Highlighted, uv: DVec2) {
        let (resolved, size, middle) = (&self.view.resolved, self.view.size, self.middle());
        let to_dots = |uv: DVec2| position_of(resolved, size, uv);
        let (at, corner) = (to_dots(uv), to_dots(DVec2::new(uv.x, 0.0)));
        let [w, u, v] = ALONG;
        let [color_u, color_v, color_w] = self.colors.basis;
        let pen = Self::pen(highlighted, color_w);
        let sides = [(u, middle, corner, color_u), (v, corner, at, color_v)];
        for ((concept, text), from, to, color) in sides {
            let width = if concept == highlighted.concept { STRONG } else { BESIDE };
            self.arrow(
                from,
                to - from,
                LineStyle { color, width, ..pen }.about(concept),
                text,
                POINT_TEXT,
            );
        }
        if highlighted.concept == Concept::AlongW {
            self.along_view(middle, true, pen, w.1, DVec2::new(-0.6, -1.0));
        }
    }

    /// Draws a sphere's outline.
    fn highlight_object(&mut self, highlighted: Highlighted, scene: &Scene, index: u32) {
        let Some(Object::Sphere(sphere)) = scene.object(index) else { return };
        let resolved = &self.view.resolved;
        let unit = (sphere.center - resolved.eye()).length();
        let screen = Screen::of_size(resolved, self.view.extent(), unit);
        let pen = LineStyle { width: 4.0, ..Self::pen(highlighted, self.colors.hit) };
        let outline = silhouette(&sphere, resolved.eye()).unwrap_or_default();
        for pen in cased(pen, self.colors.halo) {
            for cut in outline.windows(2).filter_map(|pair| screen.line(pair[0], pair[1])) {
                self.line(&[cut.from.at, cut.to.at], pen);
            }
        }
    }

    /// Hatches the pixels that show a plane. The hatching lies below everything else, because the plane may
    /// fill the picture, and the marks on it must stay visible and hoverable.
    fn highlight_plane(&mut self, scene: &Scene, index: u32) {
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 1.5);
        let (extent, scale) = (self.view.extent(), f64::from(self.view.scale));
        let cells = Cells::trace(&self.view.resolved, scene, extent, CELL * scale);
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

/// The object seen at each position, at the resolution that hatching needs.
struct Cells {
    frame: Frame<f64>,
    /// Dots per pixel of the image.
    per_pixel: DVec2,
}

impl Cells {
    fn trace(resolved: &ResolvedCamera, scene: &Scene, extent: DVec2, cell: f64) -> Cells {
        let image = resolved.image();
        let [columns, rows] = (extent / cell).to_array().map(|cells| cells.ceil() as u32);
        let raster = Raster::shown_on(image, columns, rows);
        let outputs = Outputs { t: false, object: true, normal: false };
        Cells {
            frame: trace(scene, resolved, &raster, outputs),
            per_pixel: extent / DVec2::new(image.width().into(), image.height().into()),
        }
    }

    /// Returns the object seen at a position, in dots.
    fn object_at(&self, at: DVec2) -> u32 {
        let cell = at / self.per_pixel;
        // The cast saturates: positions left of or above the picture give index 0.
        let pixel = Pixel { row: cell.y as u32, column: cell.x as u32 };
        let Some(offset) = self.frame.raster().nearest_to(pixel) else { return NO_OBJECT };
        self.frame.object.get(offset).copied().unwrap_or(NO_OBJECT)
    }
}

/// Returns strokes that rise to the right, at a distance of `apart`, where positions of the picture are
/// `inside`. Each stroke is tested at intervals of `step`.
fn hatch(extent: DVec2, apart: f64, step: f64, inside: impl Fn(DVec2) -> bool) -> Vec<[DVec2; 2]> {
    let mut strokes = Vec::new();
    let direction = DVec2::new(std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2);
    let (reach, apart) = (extent.x + extent.y, apart * std::f64::consts::SQRT_2);
    for k in 1..(reach / apart).ceil() as u32 {
        // x + y is constant along a stroke, which starts at the left or the lower edge.
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
