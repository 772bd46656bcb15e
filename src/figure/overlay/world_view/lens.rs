//! Draws the parts of the figure as the observer of the world view sees them.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, ResolvedCamera, Sphere};

use crate::observer::{Length, Place};
use crate::overlay::{
    DrawnPart, Emphasis, Form, Head, LineStyle, MARK, POINT, Part, Shape, Sketch, Toward, circle,
    corners, first, half_extent, numbers, tangents, unit,
};

/// Size of the viewport on the screen, in points, below which a box is drawn for the camera. In a smaller viewport, the
/// handles would overlap and the frustum could hardly be seen.
pub const SMALL_VIEWPORT: f64 = 52.0;

/// Size of the box that stands for a small camera, in points: the larger of its width and height, then its depth.
const BODY: (f64, f64) = (30.0, 34.0);

/// Shorter side of a view, in points, below which the camera's box shrinks with the view.
const LOW: f64 = 300.0;

/// Distance between the arrows of view and -view, and between a line and its dimension line, in points.
const APART: f64 = 14.0;

/// Distance between the viewport and the numbers of its rows and columns, in points.
const NUMBER_GAP: f64 = 2.0;

impl Sketch<'_> {
    /// Draws parts: those with emphasis last, on top of all others but the points that they lead to. The labels of parts
    /// behind come last, so that the camera's own labels have precedence if space is short.
    pub(crate) fn parts(&mut self, parts: Vec<DrawnPart>) {
        let has_emphasis = parts.iter().any(|drawn| drawn.emphasis.is_on_top());
        let is_point =
            |part: &Part| has_emphasis && matches!(part.form, Form::Point(_) | Form::Hole(_));
        let (mut on_top, others): (Vec<_>, Vec<_>) = parts.into_iter().partition(|drawn| {
            drawn.emphasis.is_on_top() || drawn.emphasis == Emphasis::Plain && is_point(&drawn.part)
        });
        on_top.sort_by_key(|drawn| is_point(&drawn.part));
        let mut of_behind = 0;
        for DrawnPart { part, emphasis, is_behind } in &others {
            self.fades = *emphasis == Emphasis::Faded;
            self.part(part);
            if *is_behind {
                of_behind = self.requests.len();
            }
        }
        (self.fades, self.has_labels) = (false, true);
        self.requests.rotate_left(of_behind);
        let others = std::mem::take(&mut self.requests);
        on_top.iter().for_each(|drawn| self.part(&drawn.part));
        self.requests = first(std::mem::take(&mut self.requests), others);
    }

    fn part(&mut self, part: &Part) {
        let (pen, aside) = (part.pen, self.aside(part));
        let points = part.places.iter().map(|place| self.place(*place) + aside);
        let points: Vec<DVec3> = points.collect();
        let middle = points.first().zip(points.last()).map(|(a, b)| a.midpoint(*b));
        let mut shown = middle.and_then(|middle| self.screen.spot(middle));
        let mut onward = DVec2::ZERO;
        match (part.form, &points[..]) {
            (Form::Line, _) => points.windows(2).for_each(|ends| self.line(ends[0], ends[1], pen)),
            (Form::Arrow(head), [from, tip]) => {
                let drawn = self.arrow([*from, *tip], head, pen);
                onward = drawn.map_or(onward, |[_, direction]| direction);
                shown = drawn.and_then(|_| self.screen.spot(*tip));
            }
            (Form::Dimension, [a, b]) => {
                for end in [a, b] {
                    self.arrow([a.midpoint(*b), *end], Head::Filled, pen);
                }
            }
            (Form::Sides, _) => self.sides(&points, pen),
            (Form::Area, _) => {
                let fill = LineStyle { color: pen.color.gamma_multiply(0.3), ..pen };
                self.polygon(&points, fill.without_halo());
                self.sides(&points, pen);
            }
            (Form::Face(inside), _) => self.face(&points, inside, pen),
            (Form::Point(radius), [at]) => shown = self.point(*at, radius, pen),
            (Form::Ring(radius), [at]) => self.ring(*at, radius + 2.0, pen),
            (Form::Hole(radius), [at]) => {
                shown = self.point(*at, radius, pen);
                let hole = LineStyle { color: self.colors.background, ..pen }.without_halo();
                self.point(*at, 0.6 * radius, hole);
            }
            (Form::Outline(sphere), _) => self.outline(&sphere, pen),
            (form, _) => {
                if let Some(resolved) = &self.view.figure.resolved {
                    match form {
                        Form::Body => self.body(resolved, pen),
                        Form::Marks => self.marks(resolved, pen),
                        _ => self.pixel_numbers(resolved, pen),
                    }
                }
            }
        }
        let Some(label) = &part.label else { return };
        let at = label.at.map(|at| self.place(at) + aside);
        let Some(spot) = at.map_or(shown, |at| self.screen.spot(at)) else { return };
        let world = at.or(middle).unwrap_or_default();
        let toward = match label.toward {
            Toward::Screen(direction) => direction,
            Toward::World(sum) => {
                sum.into_iter().map(|(weight, vector)| weight * self.on_screen(world, vector)).sum()
            }
            Toward::Onward if part.beside.is_some() => self.on_screen(world, aside),
            Toward::Onward => onward,
        };
        self.label(pen, &label.text, [spot.at, toward], label.font);
    }

    /// Returns where a place is in the world.
    fn place(&self, Place { at, along, length }: Place) -> DVec3 {
        match length {
            _ if along == DVec3::ZERO => at,
            Length::Arrow => at + self.screen.arrow_length(at) * along,
            Length::Normal => at + self.screen.normal_length(at) * along,
        }
    }

    /// Returns how far a part is drawn beside its place: across its line and the line of sight.
    fn aside(&self, part: &Part) -> DVec3 {
        let (Some(other), [a, b]) = (part.beside, &part.places[..]) else { return DVec3::ZERO };
        let [a, b] = [a, b].map(|end| self.place(*end));
        let middle = a.midpoint(b);
        let sight = middle - self.view.frame.camera().eye();
        let Some(across) = unit((a - b).cross(sight)) else { return DVec3::ZERO };
        let across = if other.dot(across) > 0.0 { -across } else { across };
        self.screen.length_of_points(middle, (APART, APART)) * across
    }

    fn ring(&mut self, at: DVec3, radius: f32, pen: LineStyle) {
        if let Some(spot) = self.screen.spot(at) {
            let scale = self.drawing.scale;
            self.add(pen, Shape::ring(spot.at, (radius * scale).into(), 24, 2.4 * scale));
        }
    }

    fn outline(&mut self, sphere: &Sphere, pen: LineStyle) {
        let outline = silhouette(sphere, self.view.frame.camera().eye()).unwrap_or_default();
        let pens = cased(pen, self.colors.background);
        for pen in if pen.halo { &pens[..] } else { &pens[1..] } {
            outline.windows(2).for_each(|ends| self.line(ends[0], ends[1], *pen));
        }
    }

    /// Fills a side of a solid if it faces the observer.
    fn face(&mut self, corners: &[DVec3], inside: DVec3, pen: LineStyle) {
        let normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
        let height = |point: DVec3| normal.dot(point - corners[2]);
        if height(self.view.frame.camera().eye()) * height(inside) < 0.0 {
            self.polygon(corners, pen);
        }
    }

    /// Returns the direction on the screen of a vector at a point, as a unit vector; zero if it points along the line of
    /// sight, or if the point is not in the picture.
    pub(crate) fn on_screen(&self, at: DVec3, vector: DVec3) -> DVec2 {
        let length = self.screen.length_of_points(at, (10.0, 10.0));
        let tip = unit(vector).map(|vector| at + length * vector);
        let spots = self.screen.spot(at).zip(tip.and_then(|tip| self.screen.spot(tip)));
        spots.map_or(DVec2::ZERO, |(from, to)| (to.at - from.at).normalize_or_zero())
    }

    /// Draws the camera's body in place of a viewport that is too small to be seen, unless arrows or the frustum
    /// show where the camera looks. The body is a box of constant size on the screen, with the eye in the middle of its
    /// front.
    ///
    /// The box stands behind the eye, where the viewport can never be. The frustum, the viewport, the
    /// picture and the ray are always drawn to scale: an enlarged frustum would show the viewport in the
    /// wrong place.
    fn body(&mut self, resolved: &ResolvedCamera, pen: LineStyle) {
        let spots = corners(resolved).map(|uv| self.screen.spot(resolved.viewport_point(uv)));
        let [Some(a), Some(b), Some(c), Some(d)] = spots else { return };
        let diagonal = a.at.distance(c.at).max(b.at.distance(d.at));
        if diagonal >= SMALL_VIEWPORT * self.screen.scale {
            return;
        }
        let (eye, basis, viewport) = (resolved.eye(), resolved.basis(), resolved.viewport());
        // In a small view, the body shrinks in proportion to the view.
        let low = (self.screen.size.min_element() / (LOW * self.screen.scale)).clamp(0.4, 1.0);
        let point = low * self.screen.length_of_points(eye, (1.0, 1.0));
        let larger = viewport.width.max(viewport.height);
        let half = 0.5 * BODY.0 * point / larger;
        let (u, v) = (half * viewport.width * basis.u, half * viewport.height * basis.v);
        let depth = BODY.1 * point * basis.w;
        let front = [eye - u + v, eye + u + v, eye + u - v, eye - u - v];
        let back = front.map(|corner| corner + depth);
        let fill = LineStyle { color: self.colors.ink.gamma_multiply(0.12), ..pen }.without_halo();
        for side in [front, back] {
            self.polygon(&side, fill);
            self.sides(&side, pen);
        }
        for (from, to) in front.into_iter().zip(back) {
            self.line(from, to, pen);
        }
        // A triangle marks the image's top edge, as on the viewport's outline.
        let rise = 0.4 * BODY.0 * point * basis.v;
        let top = eye + v;
        let mark = LineStyle { color: self.colors.mark, ..pen };
        self.polygon(&[top - 0.5 * u, top + 0.5 * u, top + rise], mark);
    }

    /// Draws marks that show how the image lies on the viewport: a thick top edge with a triangle on it,
    /// and a triangle in the corner of pixel (0, 0).
    fn marks(&mut self, resolved: &ResolvedCamera, pen: LineStyle) {
        let viewport = resolved.viewport();
        let (w, h) = (viewport.width, viewport.height);
        let side = w.min(h);
        let middle = resolved.viewport_point(DVec2::ZERO);
        let Some(dots) = self.screen.dots_per_unit(middle) else { return };
        let points = dots * side / self.screen.scale;
        let size = (0.09 * points).clamp(8.0, 22.0) / points * side;
        if !size.is_finite() {
            return;
        }
        let at = |u: f64, v: f64| resolved.viewport_point(DVec2::new(u, v));
        self.line(at(-0.5 * w, 0.5 * h), at(0.5 * w, 0.5 * h), pen.without_halo());
        let tip = 0.5 * h + 1.1 * size;
        self.polygon(&[at(-0.7 * size, 0.5 * h), at(0.7 * size, 0.5 * h), at(0.0, tip)], pen);
        let corner =
            [at(-0.5 * w, 0.5 * h), at(-0.5 * w + size, 0.5 * h), at(-0.5 * w, 0.5 * h - size)];
        self.polygon(&corner, pen.without_halo());
        let on_screen =
            |s: &Self, uv: DVec2| s.screen.spot(resolved.viewport_point(uv)).map(|spot| spot.at);
        let center = on_screen(self, DVec2::ZERO);
        let named = [("top", DVec2::new(0.0, tip)), ("(0, 0)", DVec2::new(-0.5 * w, 0.5 * h))];
        for (text, uv) in named {
            if let (Some(center), Some(spot)) = (center, on_screen(self, uv))
                && points > 90.0
                && self.view.figure.names_all
            {
                self.label(pen, text, [spot, spot - center], MARK);
            }
        }
    }

    /// Writes the numbers of columns above the viewport and those of rows to its left, and W and H at the
    /// opposite sides.
    pub(crate) fn pixel_numbers(&mut self, resolved: &ResolvedCamera, pen: LineStyle) {
        if !self.has_labels {
            return;
        }
        let (image, viewport, scale) = (resolved.image(), resolved.viewport(), self.screen.scale);
        let half = 0.5 * DVec2::new(viewport.width, viewport.height);
        let at = |uv: DVec2| resolved.viewport_point(uv);
        let sides = [(DVec2::Y, "W", image.width()), (DVec2::NEG_X, "H", image.height())];
        for (out, name, count) in sides {
            let outward = at(out) - at(DVec2::ZERO);
            let beside = |k: u32, text: &str| {
                let along = DVec2::new(resolved.u_of_column(k), resolved.v_of_row(k));
                let edge = at((DVec2::ONE - out.abs()) * along + out * half);
                let room = half_extent(text, scale) + NUMBER_GAP * scale;
                let direction = self.on_screen(edge, outward);
                Some(self.screen.spot(edge)?.at + direction * direction.abs().dot(room))
            };
            let (ink, first) = ((pen, self.colors.background), self.view.first_number);
            for request in numbers(ink, count, first, scale, beside) {
                self.request(request);
            }
            let middle = at(-out * half);
            let outward = self.on_screen(middle, -outward);
            if let Some(spot) = self.screen.spot(middle) {
                self.label(pen, &format!("{name} = {count}"), [spot.at, outward], POINT);
            }
        }
    }
}

/// Returns two styles for a polyline: that of its casing (a wider line below it), and that of the line itself. All
/// casings must be drawn before the lines, so that they do not cut into them.
pub(crate) fn cased(pen: LineStyle, halo: Color32) -> [LineStyle; 2] {
    let pen = pen.without_halo();
    [LineStyle { color: halo, width: pen.width + 2.5, ..pen }, pen]
}

/// Returns the silhouette of a sphere seen from a point, as a closed polyline; `None` if the point lies inside the
/// sphere.
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
