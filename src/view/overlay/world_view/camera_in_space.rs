//! Draws the edited camera in the world view as lines: the eye, the arrows, the frustum, the viewport and
//! the selected ray. Also draws each sphere around the camera, cut away, which is not traced there.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Orientation, Pixel, ResolvedCamera, Rgb, Root, Sphere};

use super::ASKED_SPHERES;
use crate::model::observer::{AXIS_LENGTH, UP_LENGTH, VIEW_LENGTH};
use crate::model::{Concept, Inspection, Item, OverlayItems};
use crate::view::overlay::{
    BOLD_POINT, FINE, Head, LineStyle, MARK, MEDIUM, POINT, Sketch, SphereFigure, THICK, THIN,
    VECTOR, equals, mix, silhouette, unit,
};

/// Size of the viewport on the screen, in points, below which a box is drawn for the camera. In a
/// smaller viewport, the handles would overlap and the frustum could hardly be seen.
pub const SMALL_VIEWPORT: f64 = 52.0;

/// Size of the box that stands for a small camera, in points: the larger of its width and height, then its
/// depth.
const BODY: (f64, f64) = (30.0, 34.0);

/// Opacity of the sides of the frustum, up to the viewport.
const SOLID: f32 = 0.1;

/// Shorter side of a view, in points, below which the camera's box shrinks with the view.
const LOW: f64 = 300.0;

impl Sketch<'_> {
    /// Draws the whole camera, from back to front.
    pub(crate) fn camera_in_space(&mut self) {
        let view = self.view;
        let arrow = self.screen.arrow_length(view.camera.eye);
        self.axes();
        if let Some(resolved) = &view.resolved {
            self.frustum(resolved);
            self.body(resolved);
            self.outline(resolved);
            self.marks(resolved);
            if let Some(inspection) = &view.inspection {
                self.selected(resolved, inspection);
            }
        }
        self.areas(arrow);
        self.given(arrow);
        self.view_vector(arrow);
        if let Some(resolved) = &view.resolved {
            self.basis(resolved, arrow);
            self.order_and_angles(resolved, arrow);
            self.measures(resolved);
            self.pixel_numbers(resolved);
        }
        self.eye_and_at();
    }

    fn axes(&mut self) {
        let length = AXIS_LENGTH * self.screen.arrow_length(DVec3::ZERO);
        let names = ["x", "y", "z"];
        for ((axis, name), color) in DVec3::AXES.into_iter().zip(names).zip(self.colors.axes) {
            let pen = LineStyle::new(Item::Axes, color, THIN);
            self.named_arrow([DVec3::ZERO, length * axis], Head::Open, pen, name, POINT);
        }
    }

    /// Returns the t up to which the frustum's edges are drawn. It lies beyond every sphere of ordinary
    /// size and distance.
    fn reach(&self, resolved: &ResolvedCamera) -> f64 {
        const LEAST: f64 = 2.2;
        let distance = resolved.viewport().distance;
        let limit = 8.0 * self.view.observer.distance() / distance;
        let far_sides = self.scene.spheres().iter().take(ASKED_SPHERES).filter_map(|sphere| {
            let depth = resolved.project(sphere.center).depth;
            (sphere.radius < depth).then_some((depth + sphere.radius) / distance)
        });
        let planes = if self.scene.planes().is_empty() { 1.0 } else { 1.2 };
        far_sides.filter(|t| *t < limit).fold(LEAST, f64::max) * 1.1 * planes
    }

    /// Draws the edges of the frustum, which are rays from the eye through the viewport's corners. Each
    /// edge ends at the nearest plane or, without one, beyond the spheres.
    fn frustum(&mut self, resolved: &ResolvedCamera) {
        let ink = self.colors.ink;
        let near = LineStyle::new(Item::Frustum, ink, THIN);
        let far = LineStyle::new(Item::Frustum, ink.gamma_multiply(0.55), FINE).without_halo();
        let (scene, reach) = (self.scene, self.reach(resolved));
        let rays = corners(resolved).map(|uv| resolved.ray(uv));
        let ends = rays.map(|ray| {
            let planes = scene.planes().iter().take(64);
            let hits = planes.filter_map(|plane| plane.roots(&ray).first_positive());
            let wall = hits.fold(f64::INFINITY, f64::min);
            (ray.at(wall.min(reach)), wall <= reach)
        });
        let viewport = rays.map(|ray| ray.at(1.0));
        self.frustum_sides([resolved.eye(); 4], viewport, ink.gamma_multiply(SOLID));
        for (ray, (end, _)) in rays.iter().zip(ends) {
            self.line(ray.origin, ray.at(1.0), near);
            self.line(ray.at(1.0), end, far);
        }
        if ends.iter().all(|(_, on_plane)| *on_plane) {
            let ends = ends.map(|(end, _)| end);
            self.sides(ends, far);
        }
    }

    /// Fills those sides of a part of the frustum that face the observer. `front` and `back` are its
    /// corners, in the order of [`corners`].
    fn frustum_sides(&mut self, front: [DVec3; 4], back: [DVec3; 4], color: Color32) {
        let fill = LineStyle::new(Item::Frustum, color, FINE).without_halo();
        let (observer, middle) = (self.view.frame.camera().eye(), back.iter().sum::<DVec3>() / 4.0);
        for k in 0..4 {
            let next = (k + 1) % 4;
            let side = [front[k], front[next], back[next], back[k]];
            let normal = (side[2] - side[0]).cross(side[3] - side[1]);
            let is_outside = |point: DVec3| normal.dot(point - side[2]);
            if is_outside(observer) * is_outside(middle) < 0.0 {
                self.polygon(&side, fill);
            }
        }
    }

    /// Draws the camera's body in place of a viewport that is too small to be seen, unless arrows or the frustum
    /// show where the camera looks. The body is a box of constant size on the screen, with the eye in the middle of its
    /// front.
    ///
    /// The box stands behind the eye, where the viewport can never be. The frustum, the viewport, the
    /// picture and the ray are always drawn to scale: an enlarged frustum would show the viewport in the
    /// wrong place.
    fn body(&mut self, resolved: &ResolvedCamera) {
        if shows_where_it_looks(self.items) || !self.items.shows(Item::Viewport) {
            return;
        }
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
        let pen = LineStyle::new(Item::Eye, self.colors.ink, THIN).about(Concept::Eye);
        let fill = LineStyle { color: self.colors.ink.gamma_multiply(0.12), ..pen }.without_halo();
        for side in [front, back] {
            self.polygon(&side, fill);
            self.sides(side, pen);
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

    fn outline(&mut self, resolved: &ResolvedCamera) {
        let pen = LineStyle::new(Item::Viewport, self.colors.ink, MEDIUM)
            .about(Concept::Viewport)
            .on_viewport();
        self.sides(corners(resolved).map(|uv| resolved.viewport_point(uv)), pen);
    }

    /// Draws marks that show how the image lies on the viewport: a thick top edge with a triangle on it,
    /// and a triangle in the corner of pixel (0, 0).
    fn marks(&mut self, resolved: &ResolvedCamera) {
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
        let color = self.colors.mark;
        let pen = LineStyle::new(Item::Marks, color, THICK).on_viewport();
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
                && self.view.names_all
            {
                self.label(pen, text, [spot, spot - center], MARK);
            }
        }
    }

    /// Returns the first hit, unless neither it nor the plane that is hit is drawn: a ray that ended there
    /// would end in empty air.
    pub(crate) fn drawn_hit<'a>(&self, inspection: &'a Inspection) -> Option<&'a Root> {
        inspection.first_hit().filter(|hit| self.is_drawn(hit))
    }

    /// Returns true if a root's point is drawn, or the object that it is on.
    pub(crate) fn is_drawn(&self, root: &Root) -> bool {
        let are_planes =
            [Item::Planes, Item::Hit].into_iter().any(|item| self.view.items.shows(item));
        are_planes || (root.object as usize) < self.scene.spheres().len()
    }

    /// Draws the selected pixel on the viewport, its ray, the hit, and the normal at the hit.
    fn selected(&mut self, resolved: &ResolvedCamera, inspection: &Inspection) {
        let view = self.view;
        let ray = &inspection.ray;
        let color = self.colors.ray;
        for pixel in inspection.touched(resolved) {
            self.pixel(resolved, pixel);
        }
        self.uv_legs(resolved, inspection);
        let pen = LineStyle::new(Item::Ray, color, THICK).about(Concept::Ray);
        self.ray_line(inspection, pen);
        self.point(ray.at(1.0), 3.6, pen.about(Concept::Pixel).on_viewport());
        // The figure of ray and sphere has d in it.
        let item = match self.items.shows(Item::Direction) {
            true => Item::Direction,
            false => Item::SphereFigure,
        };
        let pen = LineStyle::new(item, color, 3.6).about(Concept::Direction).on_top();
        self.named_arrow([ray.origin, ray.at(1.0)], Head::Filled, pen, "d", VECTOR);
        if self.items.shows(Item::Roots) {
            self.roots(inspection, 0.0, LineStyle::new(Item::Roots, color, 1.8).on_top());
        }
        let figure = || SphereFigure::new(inspection, self.scene.spheres());
        let figure = self.items.shows(Item::SphereFigure).then(figure).flatten();
        if let Some(figure) = &figure {
            self.sphere_figure(inspection, figure);
        }
        if let Some(t) = view.ray_point_t {
            let has_label = figure.is_some() || self.items.shows(Item::Roots);
            let is_root = inspection.roots.iter().any(|root| root.t == t);
            self.ray_point_t(inspection, t, !(has_label && is_root));
        }
        let Some(hit) = self.drawn_hit(inspection) else { return };
        let ink = self.colors.hit;
        let pen = LineStyle::new(Item::Hit, ink, MEDIUM).about(Concept::Normal);
        if self.view.shows_normal {
            let tip = hit.point + self.screen.normal_length(hit.point) * hit.normal;
            self.named_arrow([hit.point, tip], Head::Filled, pen, "n", BOLD_POINT);
        }
        let pen = LineStyle { color, ..pen }.about(inspection.concept_of(hit));
        self.named_point(hit.point, 5.0, pen, "hit", [0.3, 1.0]);
    }

    /// Draws the point p + t d, with the value of t if `is_named` is true. Draws a line to the point if the
    /// ray up to its first hit does not reach it.
    fn ray_point_t(&mut self, inspection: &Inspection, t: f64, is_named: bool) {
        let ray = &inspection.ray;
        let at = ray.at(t);
        let color = self.colors.ray;
        let thin = LineStyle::new(Item::Ray, color.gamma_multiply(0.7), FINE);
        if t < 0.0 {
            self.line(ray.origin, at, thin);
        } else if let Some(hit) = self.drawn_hit(inspection).filter(|hit| t > hit.t) {
            self.line(hit.point, at, thin);
        }
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 2.0);
        let edge = LineStyle { color, ..pen };
        self.point(at, 7.5, edge);
        if let Some(spot) = self.point(at, 4.5, pen)
            && is_named
        {
            let text = format!("t {}", equals(t));
            self.label(edge, &text, [spot.at, DVec2::new(-0.3, -1.0)], BOLD_POINT);
        }
    }

    /// Draws a frame around a pixel's cell on the viewport.
    pub(crate) fn pixel(&mut self, resolved: &ResolvedCamera, Pixel { row, column }: Pixel) {
        let u = [resolved.u_of_column_edge(column), resolved.u_of_column_edge(column + 1)];
        let v = [resolved.v_of_row_edge(row), resolved.v_of_row_edge(row + 1)];
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
            .map(|(i, j)| resolved.viewport_point(DVec2::new(u[i], v[j])));
        let pen =
            LineStyle::new(Item::Ray, self.colors.ray, MEDIUM).about(Concept::Pixel).on_viewport();
        self.sides(corners, pen);
    }

    /// Draws the view and up vectors that the user gives. A camera given by its basis has neither.
    fn given(&mut self, arrow: f64) {
        let view = self.view;
        let given = view.camera.orientation;
        let (Orientation::At { up, .. } | Orientation::View { up, .. }) = given else { return };
        let color = self.colors.given;
        let eye = view.camera.eye;
        let vectors = [
            ("view", view.camera.view(), arrow * VIEW_LENGTH, Concept::View),
            ("up", up, view.handles.up.unwrap_or(arrow * UP_LENGTH), Concept::Up),
        ];
        let is_whole = self.items.shows(Item::ViewVector) && view.camera.orientation.has_at();
        let drawn = vectors.into_iter().filter(|given| !(is_whole && given.3 == Concept::View));
        for (name, vector, length, concept) in drawn {
            if let Some(direction) = unit(vector) {
                let pen = LineStyle::new(Item::ViewAndUp, color, MEDIUM).about(concept);
                let ends = [eye, eye + length * direction];
                if self.view.names_all || concept == Concept::Up {
                    self.named_arrow(ends, Head::Filled, pen, name, POINT);
                } else {
                    self.arrow(ends, Head::Filled, pen);
                }
            }
        }
    }

    fn basis(&mut self, resolved: &ResolvedCamera, arrow: f64) {
        let (eye, basis) = (resolved.eye(), resolved.basis());
        let inks = self.colors.basis.into_iter().zip(self.colors.patterns);
        let vectors = [basis.u, basis.v, basis.w].into_iter().zip(BASIS);
        let items = self.items.of_basis();
        for (((vector, (concept, name, head)), (color, pattern)), item) in
            vectors.zip(inks).zip(items)
        {
            let pen = LineStyle::new(item, color, THICK).about(concept).patterned(pattern);
            self.named_arrow([eye, eye + arrow * vector], head, pen, name, VECTOR);
        }
    }

    fn eye_and_at(&mut self) {
        let view = self.view;
        if let Orientation::At { at, .. } = view.camera.orientation {
            let pen = LineStyle::new(Item::At, self.colors.given, 2.0).about(Concept::At);
            self.named_point(at, 4.5, pen, "at", [0.5, 1.0]);
        }
        let pen = LineStyle::new(Item::Eye, self.colors.ink, 2.0).about(Concept::Eye);
        self.named_point(view.camera.eye, 6.0, pen, "eye", [-0.6, 1.0]);
    }
}

/// Returns true if arrows or the frustum show where the camera looks, so that it needs no body.
pub(crate) fn shows_where_it_looks(items: OverlayItems) -> bool {
    [Item::Basis, Item::ViewAndUp, Item::Frustum].into_iter().any(|item| items.shows(item))
}

/// The concepts, the names and the arrowheads of u, v and w.
pub(crate) const BASIS: [(Concept, &str, Head); 3] = [
    (Concept::U, "u", Head::Filled),
    (Concept::V, "v", Head::Open),
    (Concept::W, "w", Head::Double),
];

/// Returns the (u, v) of the viewport's corners, clockwise in the image, starting at the corner of
/// pixel (0, 0).
pub(crate) fn corners(resolved: &ResolvedCamera) -> [DVec2; 4] {
    let half = 0.5 * DVec2::new(resolved.viewport().width, resolved.viewport().height);
    [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, y)| half * DVec2::new(x, y))
}

impl Sketch<'_> {
    /// Draws the rim of a sphere that is cut away for the observer.
    pub(crate) fn cut_away(&mut self, index: u32, sphere: &Sphere, [r, g, b]: Rgb) {
        let color = mix(Color32::from_rgb(r, g, b), self.colors.ink, 0.3);
        let pen =
            LineStyle::new(Item::Frustum, color, THIN).about(Concept::Object(index)).without_halo();
        let rim = silhouette(sphere, self.view.frame.camera().eye()).unwrap_or_default();
        rim.windows(2).for_each(|ends| self.line(ends[0], ends[1], pen));
    }
}
