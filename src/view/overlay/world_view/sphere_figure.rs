//! The sphere figure: the selected ray and one sphere, as a textbook draws their intersection.
//!
//! Everything follows from the quadratic equation `a t^2 + 2 b t + c = 0` of the ray `p + t d` and the
//! sphere. Its roots are `t = (-b -+ sqrt(D)) / a`. They lie symmetrically around `t = -b / a`, the foot of
//! the perpendicular from the centre to the ray, at half a chord from it, which is `sqrt(D) / a` in t.

use pinhole_core::{DVec2, DVec3, ExactRay, Ray, Root, Sphere, SphereQuadratic};

use super::ASKED_SPHERES;
use super::whiteboard::APART;
use crate::model::{Concept, Inspection, Item};
use crate::view::overlay::{
    BOLD_POINT, LineStyle, MARK, POINT, Shape, Sketch, dot, equals, silhouette, unit,
};

/// Dash and gap of the ray's line behind its origin, in points.
const DOTS: [f32; 2] = [2.0, 4.0];

/// Distance from the centre to the ray, as a fraction of the radius, below which the perpendicular is not
/// drawn: it would be shorter than its own marks.
const CENTRAL: f64 = 0.02;

/// Side of the square that marks the right angle, as a fraction of the shorter of the perpendicular and the
/// radius.
const RIGHT_ANGLE: f64 = 0.2;

/// The selected ray and the sphere of the figure.
#[derive(Clone, Debug)]
pub(crate) struct SphereFigure {
    index: u32,
    sphere: Sphere,
    ray: Ray,
    terms: SphereQuadratic,
    /// The t of the foot of the perpendicular.
    foot: f64,
    /// The t of the points where the ray's line meets the sphere, in ascending order.
    roots: Vec<f64>,
}

impl SphereFigure {
    /// Returns the figure of the sphere that the selected ray hits first, whatever else is in front of it. If
    /// it hits none, the figure is that of the sphere that it comes closest to.
    pub(crate) fn new(inspection: &Inspection, spheres: &[Sphere]) -> Option<SphereFigure> {
        let ray = inspection.ray;
        let is_sphere = |index: u32| (index as usize) < spheres.len();
        let hit = inspection.roots.iter().find(|root| root.t > 0.0 && is_sphere(root.object));
        let index = hit.map(|root| root.object).or_else(|| closest(&ray, spheres))?;
        let sphere = *spheres.get(index as usize)?;
        let terms = sphere.quadratic_of(&ExactRay::from_ray(&ray).ok()?);
        let foot = -terms.b / terms.a;
        let own = inspection.roots.iter().filter(|root| root.object == index);
        let roots: Vec<f64> = own.map(|root| root.t).filter(|t| t.is_finite()).collect();
        let is_finite = foot.is_finite() && ray.at(foot).is_finite();
        is_finite.then_some(SphereFigure { index, sphere, ray, terms, foot, roots })
    }

    /// Returns the foot of the perpendicular.
    pub(crate) fn foot(&self) -> DVec3 {
        self.ray.at(self.foot)
    }

    /// Returns the unit vector from the foot of the perpendicular to the centre, and the distance between
    /// them; `None` if the ray passes through the centre.
    fn perpendicular(&self) -> Option<(DVec3, f64)> {
        let along = self.sphere.center - self.ray.at(self.foot);
        let distance = along.length();
        (distance > CENTRAL * self.sphere.radius).then(|| Some((unit(along)?, distance)))?
    }
}

/// Returns the index of the sphere with the smallest distance between its surface and the ray.
fn closest(ray: &Ray, spheres: &[Sphere]) -> Option<u32> {
    let distance = |sphere: &Sphere| {
        let d = ray.direction;
        let t = d.dot(sphere.center - ray.origin) / d.length_squared();
        ray.at(t.max(0.0)).distance(sphere.center) - sphere.radius
    };
    let distances = (0..).zip(spheres).take(ASKED_SPHERES).map(|(k, s)| (k, distance(s)));
    let finite = distances.filter(|(_, distance)| distance.is_finite());
    finite.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}

impl Sketch<'_> {
    /// Draws the selected ray: up to its first hit, and dashed from there to the farthest object on its line.
    /// If that object is a sphere, the line ends half a radius beyond it; a ray that hits nothing has no end.
    pub(crate) fn ray_line(&mut self, inspection: &Inspection, pen: LineStyle) {
        let ray = &inspection.ray;
        let Some(hit) = self.drawn_hit(inspection) else {
            let far = 100.0 * self.view.observer.distance();
            let end = unit(ray.direction).map(|d| ray.origin + far * d);
            return self.line(ray.origin, end.unwrap_or(ray.origin), pen);
        };
        self.line(ray.origin, hit.point, pen);
        let mut drawn = inspection.roots.iter().rev().filter(|root| self.is_drawn(root));
        let Some(last) = drawn.find(|root| root.t.is_finite()) else { return };
        let sphere = self.scene.spheres().get(last.object as usize);
        let beyond = sphere.map_or(0.0, |sphere| 0.5 * sphere.radius / ray.direction.length());
        let end = ray.at(last.t + beyond);
        if beyond > 0.0 || last.t > hit.t {
            let width = 0.6 * pen.width;
            self.line(hit.point, end, LineStyle { width, ..pen }.dashed().on_top());
        }
    }

    /// Draws the sphere figure, on top of everything else.
    pub(crate) fn sphere_figure(&mut self, inspection: &Inspection, figure: &SphereFigure) {
        let item = Item::SphereFigure;
        let ink = LineStyle::new(item, self.colors.hit, 1.8).on_top();
        let ray = LineStyle { color: self.colors.ray, ..ink };
        let outline = silhouette(&figure.sphere, self.view.frame.camera().eye());
        for ends in outline.unwrap_or_default().windows(2) {
            let pen = ink.about(Concept::Object(figure.index)).without_halo();
            self.line(ends[0], ends[1], pen);
        }
        if !self.items.shows(Item::Ray) {
            self.ray_line(inspection, LineStyle { width: 2.8, ..ray }.about(Concept::Ray));
        }
        if !self.items.shows(Item::Roots) {
            self.roots(inspection, figure.foot, ray);
        }
        self.center_and_foot(figure, ink);
        self.chord(figure, ray);
    }

    /// Draws the points where the ray's line meets objects, each with its t: the first hit as a disc, others
    /// as rings; and, dotted, the line behind the eye as far as the last of them there, or to `marked`.
    pub(crate) fn roots(&mut self, inspection: &Inspection, marked: f64, pen: LineStyle) {
        let ray = &inspection.ray;
        let mut roots: Vec<&Root> = inspection
            .roots
            .iter()
            .filter(|root| root.t.is_finite() && self.is_drawn(root))
            .collect();
        // Objects that the line meets at one point share its label.
        roots.dedup_by_key(|root| root.t);
        self.behind_the_eye(ray, roots.iter().fold(marked, |t, root| t.min(root.t)), pen);
        let first = inspection.first_hit();
        let is_alone = roots.iter().all(|root| root.object == roots[0].object);
        for root in roots {
            let (at, t) = (root.point, root.t);
            let is_first = first.is_some_and(|hit| hit.t == t);
            let pen = pen.about(inspection.concept_of(root));
            // Where the line meets several objects, there is room for the numbers alone.
            let text = match (is_first, is_alone) {
                (true, _) => format!("t {}, first hit", equals(t)),
                (false, true) => format!("t {}", equals(t)),
                (false, false) => equals(t).trim_start_matches("= ").to_owned(),
            };
            let Some(spot) = self.point(at, 6.0, pen) else { continue };
            if !is_first {
                let radius = 3.6 * self.drawing.scale;
                let hole = Shape::Disc { center: dot(spot.at), radius };
                let pen = LineStyle { color: self.colors.halo, ..pen }.without_halo();
                self.drawing.marks.push(pen.mark(hole, self.colors.halo));
            }
            let along = self.on_screen(at, root.normal.dot(ray.direction) * ray.direction);
            let toward = match is_alone {
                true => along + 0.5 * self.on_screen(at, root.normal),
                false => -DVec2::Y,
            };
            self.label(pen, &text, [spot.at, toward], BOLD_POINT);
        }
    }

    /// Returns the direction on the screen of a vector at a point, as a unit vector; zero if it points along
    /// the line of sight, or if the point is not in the picture.
    pub(crate) fn on_screen(&self, at: DVec3, vector: DVec3) -> DVec2 {
        let length = self.screen.length_of_points(at, (10.0, 10.0));
        let tip = unit(vector).map(|vector| at + length * vector);
        let spots = self.screen.spot(at).zip(tip.and_then(|tip| self.screen.spot(tip)));
        spots.map_or(DVec2::ZERO, |(from, to)| (to.at - from.at).normalize_or_zero())
    }

    /// Draws the centre, the radius, and the perpendicular from the centre to the ray with its right angle.
    fn center_and_foot(&mut self, figure: &SphereFigure, pen: LineStyle) {
        let SphereFigure { sphere, ray, foot, ref roots, .. } = *figure;
        let (center, radius, at) = (sphere.center, sphere.radius, ray.at(foot));
        let Some(forward) = unit(ray.direction) else { return };
        let perpendicular = figure.perpendicular();
        let to_center = perpendicular.map_or(DVec2::ZERO, |(out, _)| self.on_screen(at, out));
        let back = -self.on_screen(at, forward);
        self.point(center, 4.0, pen);
        self.label_at(center, pen, "centre", to_center, POINT);
        self.point(at, 4.5, pen);
        // Where the line touches the sphere, the root has a label of its own.
        if roots.len() != 1 {
            let text = format!("foot: t = −b/a {}", equals(foot));
            self.label_at(at, pen, &text, back - to_center, POINT);
        }
        // From inside the sphere and from outside, the radius goes to the first root in front of the eye; if
        // the ray misses the sphere, it keeps off the perpendicular.
        let ahead = roots.iter().find(|t| **t > 0.0).or(roots.first());
        let rim = ahead.map_or(center - radius * forward, |t| ray.at(*t));
        self.line(center, rim, pen);
        let text = format!("r {}", equals(radius));
        self.label_at(center.midpoint(rim), pen, &text, back + to_center, POINT);
        let Some((out, distance)) = perpendicular else { return };
        let thin = LineStyle { width: 1.4, ..pen };
        self.line(at, center, thin);
        let side = RIGHT_ANGLE * distance.min(radius);
        let corner = at - side * forward;
        self.line(corner, corner + side * out, thin);
        self.line(corner + side * out, at + side * out, thin);
        if roots.is_empty() {
            let text = format!("distance {} > r", equals(distance));
            self.label_at(at.midpoint(center), pen, &text, -back, POINT);
        }
    }

    /// Draws a dimension line beside the half chord from the foot of the perpendicular to the last root.
    fn chord(&mut self, figure: &SphereFigure, pen: LineStyle) {
        let Some(last) = figure.roots.last().filter(|t| **t > figure.foot) else { return };
        let ends = [figure.foot, *last].map(|t| figure.ray.at(t));
        let half = figure.terms.discriminant.sqrt() / figure.terms.a;
        let middle = ends[0].midpoint(ends[1]);
        let sight = middle - self.view.frame.camera().eye();
        let Some(across) = unit(figure.ray.direction.cross(sight)) else { return };
        let out = figure.perpendicular().map_or(DVec3::ZERO, |(out, _)| out);
        let below = if out.dot(across) > 0.0 { -across } else { across };
        let apart = self.screen.length_of_points(middle, (APART, APART)) * below;
        let text = format!("√D/a {}", equals(half));
        self.dimension(ends.map(|end| end + apart), pen, &text, below);
    }

    /// Draws, dotted, the ray's line behind its origin: a short piece, or as far as the point at `marked`.
    fn behind_the_eye(&mut self, ray: &Ray, marked: f64, pen: LineStyle) {
        let shortest = self.screen.arrow_length(ray.origin) / ray.direction.length();
        let end = ray.at(marked.min(-0.8 * shortest));
        if !end.is_finite() {
            return;
        }
        self.line(ray.origin, end, pen.patterned(Some(DOTS)));
        self.label_at(end, pen, "t < 0", self.on_screen(end, -ray.direction), MARK);
    }
}
