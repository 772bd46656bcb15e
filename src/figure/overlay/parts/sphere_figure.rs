//! The sphere figure: the selected ray and one sphere, as a textbook draws their intersection.
//!
//! Everything follows from the quadratic equation `a t^2 + 2 b t + c = 0` of the ray `p + t d` and the
//! sphere. Its roots are `t = (-b -+ sqrt(D)) / a`. They lie symmetrically around `t = -b / a`, the foot of
//! the perpendicular from the centre to the ray, at half a chord from it, which is `sqrt(D) / a` in t.

use pinhole_core::{DVec3, ExactRay, Ray, Sphere, SphereQuadratic};

use super::{ASKED_SPHERES, Form, Parts, Toward, When};
use crate::overlay::{LineStyle, POINT, equals, unit};
use crate::{Concept, Inspection, Item};

/// Distance from the centre to the ray, as a fraction of the radius, below which the perpendicular is not
/// drawn: it would be shorter than its own marks.
const CENTRAL: f64 = 0.02;

/// Distance from the sphere to the labels of what is inside it, as a fraction of the radius.
const OUTSIDE: f64 = 0.15;

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

impl Parts<'_> {
    /// Adds the sphere figure, on top of everything else.
    pub(super) fn sphere_figure(&mut self, inspection: &Inspection, shown: &SphereFigure) {
        let colors = self.colors;
        let ink = LineStyle::new(Item::SphereFigure, colors.hit, 1.8).on_top();
        let ray = LineStyle { color: colors.ray, ..ink };
        let pen = ink.about(Concept::Object(shown.index)).without_halo();
        self.add(Form::Outline(shown.sphere), &[], pen).when(When::Unlit);
        if !self.figure.shows(Item::Ray) {
            self.ray_line(inspection, LineStyle { width: 2.8, ..ray }.about(Concept::Ray));
        }
        if !self.figure.shows(Item::Roots) {
            self.roots(inspection, shown.foot, ray);
        }
        self.center_and_foot(shown, ink);
        self.chord(shown, ray);
    }

    /// Adds the centre, the radius, and the perpendicular from the centre to the ray with its right angle.
    fn center_and_foot(&mut self, shown: &SphereFigure, pen: LineStyle) {
        let SphereFigure { sphere, ray, foot, ref roots, .. } = *shown;
        let (center, radius, at) = (sphere.center, sphere.radius, ray.at(foot));
        let Some(forward) = unit(ray.direction) else { return };
        let perpendicular = shown.perpendicular();
        let out = perpendicular.map_or(DVec3::ZERO, |(out, _)| out);
        let part = self.point(center, 4.0, pen);
        part.labelled("centre", POINT, Toward::along(out));
        // Labels stand outside the ball, where no line strikes them through.
        let thin = LineStyle { width: 1.4, ..pen };
        let is_cut = perpendicular.is_some() && roots.len() > 1;
        let below = at - (radius - center.distance(at) + OUTSIDE * radius) * out;
        if is_cut {
            self.line([at, below], thin);
        }
        let part = self.point(at, 4.5, pen);
        // Where the line touches the sphere, the root has a label of its own.
        if roots.len() != 1 {
            let text = format!("foot: t = −b/a {}", equals(foot));
            part.labelled(text, POINT, Toward::World([(-1.0, forward), (-1.0, out)]));
            if is_cut {
                part.label_at(below);
            }
        }
        // From inside the sphere and from outside, the radius goes to the first root in front of the eye; if the ray
        // misses the sphere, it keeps off the perpendicular.
        let ahead = roots.iter().find(|t| **t > 0.0).or(roots.first());
        let rim = ahead.map_or(center - radius * forward, |t| ray.at(*t));
        let toward = Toward::World([(-1.0, forward), (1.0, out)]);
        let above = center + (1.0 + OUTSIDE) * radius * (0.8 * out - 0.6 * forward);
        if is_cut {
            self.line([center.midpoint(rim), above], thin);
        }
        let text = format!("r {}", equals(radius));
        let part = self.line([center, rim], pen).labelled(text, POINT, toward);
        if is_cut {
            part.label_at(above);
        }
        let Some((out, distance)) = perpendicular else { return };
        let side = RIGHT_ANGLE * distance.min(radius);
        let corner = at - side * forward;
        self.line([corner, corner + side * out, at + side * out], thin);
        let part = self.line([at, center], thin);
        if roots.is_empty() {
            let text = format!("distance {} > r", equals(distance));
            part.labelled(text, POINT, Toward::World([(-1.0, -forward), (0.0, out)]));
        }
    }

    /// Adds a dimension line beside the half chord from the foot of the perpendicular to the last root.
    fn chord(&mut self, shown: &SphereFigure, pen: LineStyle) {
        let Some(last) = shown.roots.last().filter(|t| **t > shown.foot) else { return };
        let ends = [*last, shown.foot].map(|t| shown.ray.at(t));
        let half = shown.terms.discriminant.sqrt() / shown.terms.a;
        let out = shown.perpendicular().map_or(DVec3::ZERO, |(out, _)| out);
        let text = format!("√D/a {}", equals(half));
        self.dimension(ends, pen).labelled(text, POINT, Toward::Onward).beside = Some(out);
    }
}
