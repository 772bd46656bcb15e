//! The sphere figure: the selected ray and one sphere, as a textbook draws their intersection.
//!
//! Everything follows from the quadratic equation `a t^2 + 2 b t + c = 0` of the ray `p + t d` and the
//! sphere. Its roots are `t = (-b -+ sqrt(D)) / a`. They lie symmetrically around `t = -b / a`, the foot of
//! the perpendicular from the centre to the ray, at half a chord from it, which is `sqrt(D) / a` in t.

use pinhole_core::{DVec2, DVec3, ExactRay, Ray, Sphere, SphereQuadratic};

use super::ASKED_SPHERES;
use crate::model::inspection::ObjectTerms;
use crate::model::{Concept, Inspection, Item};
use crate::view::overlay::{
    BOLD_POINT, Head, LineStyle, MARK, POINT, Shape, Sketch, VECTOR, dot, equals, silhouette, unit,
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
    /// The t of the ray's first hit, if the hit is on this sphere.
    first: Option<f64>,
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
        let terms = match inspection.terms.get(index as usize) {
            Some(ObjectTerms::Sphere(terms)) => *terms,
            _ => sphere.quadratic_of(&ExactRay::from_ray(&ray).ok()?),
        };
        let foot = -terms.b / terms.a;
        let own = inspection.roots.iter().filter(|root| root.object == index);
        let roots: Vec<f64> = own.map(|root| root.t).filter(|t| t.is_finite()).collect();
        let first = inspection.first_hit().filter(|hit| hit.object == index).map(|hit| hit.t);
        let is_finite = foot.is_finite() && ray.at(foot).is_finite();
        is_finite.then_some(SphereFigure { index, sphere, ray, terms, foot, roots, first })
    }

    /// Returns the foot of the perpendicular and the points where the ray's line meets the sphere.
    pub(crate) fn points(&self) -> impl Iterator<Item = DVec3> {
        self.roots.iter().chain([&self.foot]).map(|t| self.ray.at(*t))
    }

    /// Returns true if the figure labels the point at this t with its t.
    pub(crate) fn names(&self, t: f64) -> bool {
        self.roots.contains(&t)
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
    /// If that object is a sphere, the line ends one radius beyond it; a ray that hits nothing has no end.
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
        let beyond = sphere.map_or(0.0, |sphere| sphere.radius / ray.direction.length());
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
        self.behind_the_eye(figure, ray);
        if !self.items.shows(Item::Ray) {
            self.ray_line(inspection, LineStyle { width: 2.8, ..ray }.about(Concept::Ray));
        }
        let strong = LineStyle { width: 3.6, ..ray }.about(Concept::Direction);
        let ends = [figure.ray.origin, figure.ray.at(1.0)];
        self.named_arrow(ends, Head::Filled, strong, "d", VECTOR);
        self.roots(inspection, figure, ray);
        self.center_and_foot(figure, ink);
        self.chord(figure, ray);
    }

    /// Draws the points where the ray's line meets the sphere: the first hit as a disc, others as rings.
    fn roots(&mut self, inspection: &Inspection, figure: &SphereFigure, pen: LineStyle) {
        for &t in &figure.roots {
            let at = figure.ray.at(t);
            let is_first = figure.first == Some(t);
            let own = inspection.roots.iter().find(|r| r.object == figure.index && r.t == t);
            let pen = own.map_or(pen, |root| pen.about(inspection.concept_of(root)));
            let text = format!("t {}{}", equals(t), if is_first { ", first hit" } else { "" });
            let Some(spot) = self.point(at, 6.0, pen) else { continue };
            if !is_first {
                let radius = 3.6 * self.drawing.scale;
                let hole = Shape::Disc { center: dot(spot.at), radius };
                let pen = LineStyle { color: self.colors.halo, ..pen }.without_halo();
                self.drawing.marks.push(pen.mark(hole, self.colors.halo));
            }
            let outward = self.on_screen(at, at - figure.sphere.center);
            let along = self.on_screen(at, (t - figure.foot) * figure.ray.direction);
            self.label(pen, &text, [spot.at, along + 0.5 * outward], BOLD_POINT);
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
        let SphereFigure { sphere, ray, terms, foot, ref roots, .. } = *figure;
        let (center, radius, at) = (sphere.center, sphere.radius, ray.at(foot));
        let perpendicular = figure.perpendicular();
        let out = perpendicular.map_or(DVec3::ZERO, |(out, _)| out);
        let to_center = self.on_screen(at, out);
        self.mark_point_at(center, 4.0, pen, ("c", BOLD_POINT), to_center);
        let text = format!("t = −b/a {}", equals(foot));
        self.mark_point_at(at, 4.5, pen, (&text, POINT), -to_center);
        // From inside the sphere and from outside, the radius goes to the first root in front of the eye; if
        // the ray misses the sphere, it goes to the surface straight towards the ray.
        let rim = match roots.iter().find(|t| **t > 0.0).or(roots.first()) {
            Some(t) => ray.at(*t),
            None => center - radius * out,
        };
        let middle = self.screen.spot(center.midpoint(rim));
        self.line(center, rim, pen);
        if let Some(spot) = middle {
            let text = format!("r {}", equals(radius));
            self.label(pen, &text, [spot.at, to_center], POINT);
        }
        let Some((out, distance)) = perpendicular else { return };
        let thin = LineStyle { width: 1.4, ..pen };
        self.line(at, if roots.is_empty() { rim } else { center }, thin);
        let side = RIGHT_ANGLE * distance.min(radius);
        if let Some(forward) = unit(ray.direction) {
            let back = at - side * forward;
            self.line(back, back + side * out, thin);
            self.line(back + side * out, at + side * out, thin);
        }
        if roots.is_empty()
            && let Some(spot) = self.screen.spot(at + 0.5 * (distance - radius) * out)
        {
            // The exact sign of D decides the comparison, not the rounded distance.
            let sign = if terms.discriminant < 0.0 { '>' } else { '=' };
            let text = format!("distance {} {sign} r", equals(distance));
            self.label(pen, &text, [spot.at, -to_center], POINT);
        }
    }

    fn mark_point_at(
        &mut self,
        at: DVec3,
        radius: f32,
        pen: LineStyle,
        (text, font): (&str, (f32, bool)),
        toward: DVec2,
    ) {
        if let Some(spot) = self.point(at, radius, pen) {
            self.label(pen, text, [spot.at, toward], font);
        }
    }

    /// Labels the half chord, from the foot of the perpendicular to the last root.
    fn chord(&mut self, figure: &SphereFigure, pen: LineStyle) {
        let Some(last) = figure.roots.last().filter(|t| **t > figure.foot) else { return };
        let middle = figure.ray.at(0.5 * (figure.foot + last));
        let half = figure.terms.discriminant.sqrt() / figure.terms.a;
        if let Some(spot) = self.screen.spot(middle) {
            let out = figure.perpendicular().map_or(DVec3::ZERO, |(out, _)| out);
            let toward = -self.on_screen(middle, out);
            self.label(pen, &format!("√D/a {}", equals(half)), [spot.at, toward], POINT);
        }
    }

    /// Draws, dotted, the ray's line behind its origin: to what the figure marks there, or a short piece.
    fn behind_the_eye(&mut self, figure: &SphereFigure, pen: LineStyle) {
        let ray = &figure.ray;
        let shortest = self.screen.arrow_length(ray.origin) / ray.direction.length();
        let marked = figure.roots.iter().copied().chain([figure.foot]).fold(0.0, f64::min);
        let end = ray.at(marked - 0.8 * shortest);
        if !end.is_finite() {
            return;
        }
        self.line(ray.origin, end, pen.patterned(Some(DOTS)));
        if let Some(spot) = self.screen.spot(end) {
            let toward = self.on_screen(end, -ray.direction);
            self.label(pen, "t < 0", [spot.at, toward], MARK);
        }
    }
}
