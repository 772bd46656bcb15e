//! The parts of the selected ray: its pixel, its direction and its components, the ray itself, all its roots, the first
//! hit and the normal there.

use pinhole_core::{DVec2, DVec3, Object, Ray, ResolvedCamera, Root, Selection, Sphere};
use pinhole_lecture::RayDerivation;

use super::sphere_figure::SphereFigure;
use super::{CutAway, Form, Length, Parts, Place, Toward, When};
use crate::overlay::{
    ACCOMPANYING, BOLD_POINT, FINE, Head, Highlighted, LineStyle, MARK, MEDIUM, POINT, THICK, THIN,
    VECTOR, equals, tangents, unit,
};
use crate::{Concept, EquationStep, Inspection, Item};

/// The three components of a view ray's direction, with their concepts and labels.
const ALONG: [(Concept, &str); 3] =
    [(Concept::AlongW, "−distance 𝐰"), (Concept::AlongU, "𝑢 𝐮"), (Concept::AlongV, "𝑣 𝐯")];

/// Dash and gap of the ray's line behind its origin, in points.
const DOTS: [f32; 2] = [2.0, 4.0];

impl Parts<'_> {
    /// Adds the selected pixel on the viewport, its ray, the hit, and the normal at the hit.
    pub(super) fn selected(&mut self, resolved: &ResolvedCamera, inspection: &Inspection) {
        let (figure, ray) = (self.figure, &inspection.ray);
        let color = self.colors.ray;
        self.pixels(resolved, inspection);
        let pen = LineStyle::new(Item::Ray, color, THICK).about(Concept::Ray);
        self.ray_line(inspection, pen);
        self.ray_point(inspection);
        // The figure of ray and sphere has d in it.
        let item = match figure.shows(Item::Direction) {
            true => Item::Direction,
            false => Item::SphereFigure,
        };
        let pen = LineStyle::new(item, color, 3.6).about(Concept::Direction).on_top();
        self.arrow([ray.origin, ray.at(1.0)], Head::Filled, pen).named("d", VECTOR);
        self.along(resolved, inspection);
        let shown = figure.shows(Item::SphereFigure);
        let sphere_figure = shown.then(|| SphereFigure::new(inspection, self.scene.spheres()));
        let sphere_figure = sphere_figure.flatten();
        if figure.shows(Item::Roots) {
            self.roots(inspection, 0.0, LineStyle::new(Item::Roots, color, 1.8).on_top());
        }
        if let Some(shown) = &sphere_figure {
            self.sphere_figure(inspection, shown);
        }
        if let Some(t) = figure.ray_point_t {
            let has_label = sphere_figure.is_some() || figure.shows(Item::Roots);
            let is_root = inspection.roots.iter().any(|root| root.t == t);
            self.ray_point_t(inspection, t, !(has_label && is_root));
        }
        self.lit_root(inspection);
        self.hit(inspection);
    }

    /// Adds a frame around the cells of the touched pixels, and the legs of the point's u and v from the viewport's
    /// middle.
    fn pixels(&mut self, resolved: &ResolvedCamera, inspection: &Inspection) {
        let colors = self.colors;
        let pen = LineStyle::new(Item::Ray, colors.ray, MEDIUM).about(Concept::Pixel).on_viewport();
        for pixel in inspection.touched(resolved) {
            let u = [pixel.column, pixel.column + 1].map(|edge| resolved.u_of_column_edge(edge));
            let v = [pixel.row, pixel.row + 1].map(|edge| resolved.v_of_row_edge(edge));
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
                .map(|(i, j)| resolved.viewport_point(DVec2::new(u[i], v[j])));
            self.sides(corners, pen).as_wide();
        }
        let at = |uv: DVec2| resolved.viewport_point(uv);
        for UvLeg { text, axis, ends, outward } in uv_legs(inspection.uv) {
            let pen = LineStyle::new(Item::UvLegs, colors.basis[axis], 3.2).on_top();
            let outward = Toward::along(at(outward) - at(DVec2::ZERO));
            self.line(ends.map(at), pen).labelled(text, POINT, outward);
        }
    }

    /// Adds the point where the ray passes through the viewport and, while it is highlighted, the ray: as far as the hit, or
    /// without an end.
    fn ray_point(&mut self, inspection: &Inspection) {
        let (ray, color) = (&inspection.ray, self.colors.ray);
        let pen = LineStyle::new(Item::Ray, color, THICK);
        let point = pen.about(Concept::Pixel);
        self.point(ray.at(1.0), 3.6, point.on_viewport()).when(When::Unlit);
        self.point(ray.at(1.0), 3.6, point).named_toward("(𝑢, 𝑣)", 0.4, 1.0).when(When::Lit);
        let pen = pen.about(Concept::Ray);
        let hit = self.drawn_hit(inspection);
        let end = hit.map_or(self.end_of(ray), |hit| hit.point);
        self.line([ray.origin, end], pen).when(When::Lit).is_endless = hit.is_none();
        if hit.is_some() && self.figure.shows(Item::Hit) {
            self.point(end, 6.0, pen).named_toward("hit", 0.3, 1.0).when(When::Lit);
        }
        let toward = Toward::Screen(DVec2::Y);
        let part = self.line([ray.origin, ray.at(1.0)], pen);
        part.labelled("𝐩 + 𝑡 𝐝", POINT, toward).when(When::Lit);
    }

    /// Returns the end of a ray that hits nothing.
    pub(super) fn end_of(&self, ray: &Ray) -> DVec3 {
        unit(ray.direction).map_or(ray.origin, |d| ray.origin + self.figure.far() * d)
    }

    /// Adds the components of the ray's direction as a chain of arrows from the eye: forwards, then right, then up.
    fn along(&mut self, resolved: &ResolvedCamera, inspection: &Inspection) {
        let Some(Highlighted { concept: lit, spoken, .. }) = self.figure.highlighted else {
            return;
        };
        let grows = lit == Concept::Direction && spoken.contains(Concept::AlongW);
        if !grows && ALONG.iter().all(|(along, _)| *along != lit) {
            return;
        }
        let Ok(parts) = RayDerivation::new(resolved, Selection::Uv(inspection.uv)) else { return };
        let [u, v, w] = self.colors.basis;
        let vectors = [(parts.along_w, w), (parts.along_u, u), (parts.along_v, v)];
        let mut from = resolved.eye();
        for ((vector, color), (concept, text)) in vectors.into_iter().zip(ALONG) {
            let pen = LineStyle::new(Item::Ray, color, ACCOMPANYING).about(concept);
            let (middle, toward) = (from + 0.5 * vector, Toward::Screen(DVec2::Y));
            let part = self.arrow([from, from + vector], Head::Filled, pen);
            part.labelled(text, POINT, toward).label_at(middle).when(When::Lit);
            from += vector;
        }
        if !grows {
            let pen = LineStyle::new(Item::Ray, self.colors.ray, 2.0).about(lit);
            self.line([resolved.eye(), from], pen).when(When::Lit).as_wide();
        }
    }

    /// Returns the first hit, unless neither it nor the plane that is hit is drawn: a ray that ended there would end in
    /// empty air.
    fn drawn_hit<'r>(&self, inspection: &'r Inspection) -> Option<&'r Root> {
        inspection.first_hit().filter(|hit| self.is_drawn(hit))
    }

    /// Returns true if a root's point is drawn, or the object that it is on.
    fn is_drawn(&self, root: &Root) -> bool {
        let are_planes = self.figure.items.shows_any(&[Item::Planes, Item::Hit]);
        are_planes || (root.object as usize) < self.scene.spheres().len()
    }

    /// Adds the selected ray: up to its first hit, and dashed from there to the farthest object on its line. If that
    /// object is a sphere, the line ends half a radius beyond it; a ray that hits nothing has no end.
    pub(super) fn ray_line(&mut self, inspection: &Inspection, pen: LineStyle) {
        let ray = &inspection.ray;
        let Some(hit) = self.drawn_hit(inspection).copied() else {
            self.line([ray.origin, self.end_of(ray)], pen).endless().when(When::Unlit);
            return;
        };
        self.line([ray.origin, hit.point], pen).when(When::Unlit);
        let mut drawn = inspection.roots.iter().rev().filter(|root| self.is_drawn(root));
        let Some(last) = drawn.find(|root| root.t.is_finite()) else { return };
        let sphere = self.scene.spheres().get(last.object as usize);
        let beyond = sphere.map_or(0.0, |sphere| 0.5 * sphere.radius / ray.direction.length());
        let (end, is_behind) = (ray.at(last.t + beyond), beyond > 0.0 || last.t > hit.t);
        if is_behind {
            let pen = LineStyle { width: 0.6 * pen.width, ..pen }.dashed().on_top();
            self.line([hit.point, end], pen).as_wide();
        }
    }

    /// Adds the point p + t d, with the value of t if `is_named` is true; and a line to the point if the ray up to its
    /// first hit does not reach it.
    fn ray_point_t(&mut self, inspection: &Inspection, t: f64, is_named: bool) {
        let (ray, color) = (&inspection.ray, self.colors.ray);
        let at = ray.at(t);
        let thin = LineStyle::new(Item::Ray, color.gamma_multiply(0.7), FINE);
        if t < 0.0 {
            self.line([ray.origin, at], thin);
        } else if let Some(hit) = self.drawn_hit(inspection).filter(|hit| t > hit.t) {
            self.line([hit.point, at], thin);
        }
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 2.0);
        let edge = LineStyle { color, ..pen };
        let part = self.point(at, 7.5, edge);
        if is_named {
            let toward = Toward::Screen(DVec2::new(-0.3, -1.0));
            part.labelled(format!("t {}", equals(t)), BOLD_POINT, toward);
        }
        self.point(at, 4.5, pen);
    }

    /// Adds the points where the ray's line meets objects, each with its t: the first hit as a disc, others as rings;
    /// and, dotted, the line behind the eye as far as the last of them there, or to `marked`.
    pub(super) fn roots(&mut self, inspection: &Inspection, marked: f64, pen: LineStyle) {
        let ray = &inspection.ray;
        let is_drawn = |root: &&Root| root.t.is_finite() && self.is_drawn(root);
        let mut roots: Vec<Root> = inspection.roots.iter().filter(is_drawn).copied().collect();
        // Objects that the line meets at one point share its label.
        roots.dedup_by_key(|root| root.t);
        self.behind_the_eye(ray, roots.iter().fold(marked, |t, root| t.min(root.t)), pen);
        let first = inspection.first_hit().map(|hit| hit.t);
        let is_alone = roots.iter().all(|root| root.object == roots[0].object);
        for root in &roots {
            let is_first = first == Some(root.t);
            let pen = pen.about(inspection.concept_of(root));
            // Where the line meets several objects, there is room for the numbers alone.
            let text = match (is_first, is_alone) {
                (true, _) => format!("t {}, first hit", equals(root.t)),
                (false, true) => format!("t {}", equals(root.t)),
                (false, false) => equals(root.t).trim_start_matches("= ").to_owned(),
            };
            let along = root.normal.dot(ray.direction) * ray.direction;
            let toward = match is_alone {
                true => Toward::World([(1.0, along), (0.5, root.normal)]),
                false => Toward::Screen(-DVec2::Y),
            };
            let form = if is_first { Form::Point(6.0) } else { Form::Hole(6.0) };
            let part = self.add(form, &[root.point.into()], pen);
            part.labelled(text, BOLD_POINT, toward).when(When::Unlit);
        }
    }

    /// Adds, dotted, the ray's line behind its origin: a short piece, and as far as the point at `marked`.
    fn behind_the_eye(&mut self, ray: &Ray, marked: f64, pen: LineStyle) {
        const SHORT: f64 = 0.8;
        let Some(back) = unit(-ray.direction) else { return };
        let pen = pen.patterned(Some(DOTS));
        let short = Place { at: ray.origin, along: SHORT * back, length: Length::Arrow };
        let mut ends = vec![short];
        ends.extend(
            Some(ray.at(marked)).filter(|at| marked < 0.0 && at.is_finite()).map(Place::from),
        );
        let last = ends[ends.len() - 1];
        for end in ends {
            self.line([ray.origin.into(), end], pen);
        }
        if let Some(part) = self.list.last_mut() {
            part.labelled("t < 0", MARK, Toward::along(back)).label_at(last);
        }
    }

    /// Adds the highlighted root: a point, and the ray as far as that.
    fn lit_root(&mut self, inspection: &Inspection) {
        let Some(lit) = self.figure.highlighted else { return };
        let Concept::Root { object, number } = lit.concept else { return };
        let Some(root) = inspection.root_of(object, number) else { return };
        let pen = LineStyle::new(Item::Ray, self.colors.ray, ACCOMPANYING).about(lit.concept);
        let part = self.line([inspection.ray.origin, root.point], pen);
        part.when(When::Lit).as_wide();
        let text = format!("𝑡 {}", lit.equated(root.t));
        self.point(root.point, 6.0, pen).named_toward(text, 0.4, 1.0).when(When::Lit);
    }

    fn hit(&mut self, inspection: &Inspection) {
        let (figure, Some(hit)) = (self.figure, inspection.first_hit().copied()) else { return };
        let pen = LineStyle::new(Item::Hit, self.colors.hit, MEDIUM);
        let is_drawn = self.is_drawn(&hit);
        let when = if figure.shows_normal && is_drawn { When::Shown } else { When::Lit };
        let (times, font) = match figure.is_lit(Concept::Normal) {
            true => (1.3, VECTOR),
            false => (1.0, BOLD_POINT),
        };
        let tip = Place { at: hit.point, along: times * hit.normal, length: Length::Normal };
        let part = self.arrow([hit.point.into(), tip], Head::Filled, pen.about(Concept::Normal));
        part.named("n", font).when(when);
        if !is_drawn || figure.is_lit(Concept::Ray) {
            return;
        }
        let pen = LineStyle { color: self.colors.ray, ..pen }.about(inspection.concept_of(&hit));
        self.point(hit.point, 5.0, pen).named_toward("hit", 0.3, 1.0).when(When::Unlit);
    }

    /// Adds the highlighted object: the outline of a sphere, or a square in a plane with the plane's normal; or the
    /// vector between it and the eye.
    pub(super) fn object(&mut self) {
        let figure = self.figure;
        let Some(lit) = figure.highlighted.map(|lit| lit.concept) else { return };
        let (Concept::Object(index) | Concept::Equation { object: index, .. }) = lit else {
            return;
        };
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 3.2).about(lit);
        match (self.scene.object(index), lit) {
            (Some(Object::Sphere(sphere)), Concept::Object(_)) => {
                self.add(Form::Outline(sphere), &[], pen).when(When::Lit).as_wide();
            }
            // From the eye, what leads to the eye is a point.
            (Some(Object::Sphere(sphere)), Concept::Equation { step, .. }) if !figure.is_flat => {
                self.center_to_eye(sphere, step, pen);
            }
            (Some(Object::Plane(plane)), _) => {
                let Some(normal) = unit(plane.normal) else { return };
                let (target, size) = (figure.observer.target(), 0.3 * figure.observer.distance());
                let center = target - normal.dot(target - plane.point) * normal;
                let (a, b) = tangents(normal);
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                    .map(|(x, y)| center + size * (x * a + y * b));
                self.sides(corners, pen).when(When::Lit).as_wide();
                let ends = [center, center + 0.5 * size * normal];
                let part = self.arrow(ends, Head::Filled, pen).named("n", VECTOR);
                part.when(When::Lit).as_wide();
                if lit != Concept::Object(index) {
                    let part = self.arrow([figure.camera.eye, plane.point], Head::Filled, pen);
                    let part = part.labelled("point − p", POINT, Toward::Screen(-DVec2::Y));
                    part.label_at(figure.camera.eye.midpoint(plane.point));
                    part.when(When::Lit).as_wide();
                }
            }
            _ => {}
        }
    }

    /// Adds the vector from a sphere's centre to the eye; with the square of its length, the radius and the outline.
    fn center_to_eye(&mut self, sphere: Sphere, step: EquationStep, pen: LineStyle) {
        let (center, eye) = (sphere.center, self.figure.camera.eye);
        let middle = center.midpoint(eye);
        let is_squared = step == EquationStep::OffsetSquared;
        let text = if is_squared { "|p − centre|" } else { "p − centre" };
        let part = self.arrow([center, eye], Head::Filled, pen).as_wide().when(When::Lit);
        part.labelled(text, POINT, Toward::Screen(-DVec2::Y)).label_at(middle);
        if is_squared {
            self.add(Form::Outline(sphere), &[], pen).when(When::Lit).as_wide();
            let v = self.figure.resolved.as_ref().map_or(DVec3::Y, |resolved| resolved.basis().v);
            let up = sphere.radius * v;
            let part = self.line([center, center + up], pen).as_wide().when(When::Lit);
            part.labelled("r", POINT, Toward::Screen(DVec2::X)).label_at(center + 0.5 * up);
        }
    }

    /// Adds the rims of the spheres that are cut away for the observer.
    pub(super) fn cut_away(&mut self, spheres: &[CutAway]) {
        for (index, sphere, color) in spheres {
            let pen = LineStyle::new(Item::Frustum, *color, THIN).about(Concept::Object(*index));
            self.add(Form::Outline(*sphere), &[], pen.without_halo()).when(When::Unlit);
        }
    }
}

/// One of the two legs that lead from the middle of the viewport to the selected point.
#[derive(Clone, Debug)]
pub(crate) struct UvLeg {
    /// The label, such as `u = 0.2`.
    pub(crate) text: String,
    /// Index of the leg's axis: 0 for u, 1 for v.
    pub(crate) axis: usize,
    /// Both ends, as (u, v).
    pub(crate) ends: [DVec2; 2],
    /// The direction from the leg to its label.
    pub(crate) outward: DVec2,
}

/// Returns the legs of a point: along u first, then along v.
pub(crate) fn uv_legs(uv: DVec2) -> [UvLeg; 2] {
    let corner = DVec2::new(uv.x, 0.0);
    let side = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
    let leg = |axis: usize, ends, outward| {
        let text = format!("{} {}", ["u", "v"][axis], equals(uv[axis]));
        UvLeg { text, axis, ends, outward }
    };
    [
        leg(0, [DVec2::ZERO, corner], -side(uv.y) * DVec2::Y),
        leg(1, [corner, uv], side(uv.x) * DVec2::X),
    ]
}
