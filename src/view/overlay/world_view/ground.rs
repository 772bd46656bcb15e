//! The panes that stand for planes, the floor's grid, and the drop lines from spheres and eye down to the
//! floor. All of them are rectangles of whole grid cells around what they belong to, so they stay in place
//! while the observer moves and while something small is dragged.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Plane, Rgb, Scene};

use super::ASKED_SPHERES;
use crate::model::Item;
use crate::view::overlay::{
    ColoredScene, FINE, Flat, Grid, LineStyle, PixelRays, PlanePatch, Sketch, THIN, WorldView,
    corners, mix, tangents, unit,
};

/// Maximum distance from the observer's target at which a plane is drawn, as a multiple of the distance
/// from the observer to the target.
const PLANE_REACH: f64 = 3.0;
/// Maximum extent of a pane on each side of the observer's target, as a multiple of the sum of two
/// distances: from the observer to its target, and from the target to the plane.
const PANE_REACH: f64 = 1.0;

/// Opacity of a pane.
const OPACITY: f32 = 0.75;
/// Opacity of a pane that lies between the observer and the camera.
const OPACITY_BETWEEN: f32 = 0.2;
/// Opacity of the floor's grid lines.
const FLOOR_LINES: f32 = 0.3;

/// Maximum number of planes that are considered.
const SHOWN_PLANES: usize = 16;
/// Maximum number of objects in a scene with a floor. More drop lines would hide the objects.
const WITH_FLOOR: usize = 64;

/// Dash and gap of a drop line, in points.
const DROP: [f32; 2] = [2.0, 4.0];
/// Length of a drop line, as a fraction of a grid cell, below which it is left out.
const SHORTEST_DROP: f64 = 0.02;

/// A rectangle of whole grid cells in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pane {
    /// The plane's unit normal, and the directions of the rectangle's sides.
    normal: DVec3,
    axes: [DVec3; 2],
    /// The plane's distance from the world's origin, along the normal.
    height: f64,
    /// Two opposite corners, along the axes, from the world's origin.
    least: DVec2,
    most: DVec2,
    /// Length of a grid cell.
    step: f64,
}

impl Pane {
    fn at(&self, along: DVec2) -> DVec3 {
        self.height * self.normal + along.x * self.axes[0] + along.y * self.axes[1]
    }

    fn corners(&self) -> [DVec3; 4] {
        let (least, most) = (self.least, self.most);
        [least, DVec2::new(most.x, least.y), most, DVec2::new(least.x, most.y)]
            .map(|at| self.at(at))
    }

    fn contains(&self, point: DVec3) -> bool {
        let along = DVec2::new(point.dot(self.axes[0]), point.dot(self.axes[1]));
        along.cmpge(self.least).all() && along.cmple(self.most).all()
    }

    fn patch(
        &self,
        rays: &PixelRays,
        [color, grid_color]: [Color32; 2],
        line_width: f32,
    ) -> Option<PlanePatch> {
        let size = self.most - self.least;
        let center = self.at(0.5 * (self.least + self.most));
        Some(PlanePatch {
            flat: Flat::new(rays, center, size.x * self.axes[0], size.y * self.axes[1])?,
            color,
            grid_color,
            opacity: OPACITY,
            grid: Grid::new(self.step / size, DVec2::splat(-0.5), line_width),
        })
    }
}

impl WorldView {
    /// Returns the panes of the planes that pass near the observer's target.
    pub(crate) fn patches(&self, scene: ColoredScene<'_>, rays: &PixelRays) -> Vec<PlanePatch> {
        let colors = self.style.colors();
        let patch = |(pane, plane, [r, g, b]): (Pane, &Plane, Rgb)| {
            let height = |p: DVec3| pane.normal.dot(p - plane.point);
            let between = height(self.camera.eye) * height(rays.eye) < 0.0;
            let color = Color32::from_rgb(r, g, b);
            let grid = mix(color, colors.ink, 0.1);
            let patch = pane.patch(rays, [mix(color, colors.background, 0.6), grid], self.scale)?;
            Some(PlanePatch { opacity: if between { OPACITY_BETWEEN } else { OPACITY }, ..patch })
        };
        self.panes(scene).filter_map(patch).collect()
    }

    /// Returns the floor's grid.
    pub(crate) fn floor_patch(&self, scene: &Scene, rays: &PixelRays) -> Option<PlanePatch> {
        let floor = self.floor(scene).filter(|_| self.level_pane(scene).is_none())?;
        let colors = [Color32::TRANSPARENT, self.style.colors().ink];
        let patch = floor.patch(rays, colors, self.scale)?;
        Some(PlanePatch { opacity: FLOOR_LINES, ..patch })
    }

    fn panes<'a>(
        &'a self,
        scene: ColoredScene<'a>,
    ) -> impl Iterator<Item = (Pane, &'a Plane, Rgb)> {
        let first = scene.scene.spheres().len();
        let planes = self.shown_planes(scene.scene).iter().enumerate();
        planes.filter_map(move |(index, plane)| {
            let pane = self.pane(scene.scene, plane)?;
            Some((pane, plane, scene.color_of((first + index) as u32)))
        })
    }

    /// Returns the pane of a plane: in front of the spheres, and as large as what the camera sees of it.
    fn pane(&self, scene: &Scene, plane: &Plane) -> Option<Pane> {
        let normal = unit(plane.normal)?;
        let height = normal.dot(plane.point);
        let seen = self.resolved.iter().flat_map(|resolved| {
            let rays = corners(resolved).map(|uv| resolved.ray(uv));
            rays.into_iter().filter_map(|ray| Some(ray.at(plane.roots(&ray).first_positive()?)))
        });
        let spheres = self.near_spheres(scene).take(ASKED_SPHERES);
        self.around(normal, height, spheres.chain(seen.map(|point| (point, 0.0))))
    }

    /// Returns the floor: the pane of the scene's highest level plane below the eye, or else one of its own,
    /// below all spheres and the camera. Returns `None` if it is switched off, or if a sphere is the ground.
    fn floor(&self, scene: &Scene) -> Option<Pane> {
        let is_ground = |radius: f64| radius > self.observer.distance();
        if !self.items.shows(Item::Floor)
            || scene.len() > WITH_FLOOR
            || scene.spheres().iter().any(|sphere| is_ground(sphere.radius))
        {
            return None;
        }
        if let Some(pane) = self.level_pane(scene) {
            return Some(pane);
        }
        let frame = self
            .resolved
            .iter()
            .flat_map(|resolved| corners(resolved).map(|uv| (resolved.viewport_point(uv), 0.0)));
        let parts: Vec<(DVec3, f64)> =
            self.near_spheres(scene).chain(frame).chain([(self.camera.eye, 0.0)]).collect();
        let bottoms = || parts.iter().map(|(center, radius)| center.y - radius);
        let tops = parts.iter().map(|(center, radius)| center.y + radius);
        let lowest = bottoms().fold(f64::INFINITY, f64::min);
        let step = grid_step(tops.fold(f64::NEG_INFINITY, f64::max) - lowest);
        self.around(DVec3::Y, (lowest / step).floor() * step, parts.into_iter())
    }

    /// Returns the pane of the scene's highest level plane that is drawn below the eye.
    fn level_pane(&self, scene: &Scene) -> Option<Pane> {
        let is_floor = |plane: &&Plane| {
            plane.point.y < self.camera.eye.y
                && unit(plane.normal).is_some_and(|n| n.y.abs() == 1.0)
        };
        let planes = self.shown_planes(scene).iter().filter(is_floor);
        let heights = planes.filter_map(|plane| Some((plane.point.y, self.pane(scene, plane)?)));
        heights.max_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, pane)| pane)
    }

    /// Returns the planes that are drawn.
    fn shown_planes<'a>(&self, scene: &'a Scene) -> &'a [Plane] {
        let shown = if self.items.shows(Item::Planes) { SHOWN_PLANES } else { 0 };
        &scene.planes()[..shown.min(scene.planes().len())]
    }

    /// Returns the centres and radii of the spheres that the observer sees in their surroundings.
    fn near_spheres(&self, scene: &Scene) -> impl Iterator<Item = (DVec3, f64)> {
        let (target, distance) = (self.observer.target(), self.observer.distance());
        let spheres = scene.spheres().iter().map(|sphere| (sphere.center, sphere.radius));
        spheres.filter(move |(center, radius)| {
            *radius <= distance && center.distance(target) <= PLANE_REACH * distance
        })
    }

    /// Returns the pane, in a plane with this unit normal and height, with all of the given balls in front
    /// of it, and a margin. It is limited to the surroundings of the observer's target.
    fn around(
        &self,
        normal: DVec3,
        height: f64,
        balls: impl Iterator<Item = (DVec3, f64)>,
    ) -> Option<Pane> {
        let (target, distance) = (self.observer.target(), self.observer.distance());
        let away = (normal.dot(target) - height).abs();
        if away.is_nan() || away > PLANE_REACH * distance {
            return None;
        }
        let (axis_a, axis_b) = tangents(normal);
        let along = |point: DVec3| DVec2::new(point.dot(axis_a), point.dot(axis_b));
        let (middle, limit) = (along(target), DVec2::splat(PANE_REACH * (distance + away)));
        let step = grid_step(distance);
        let (mut least, mut most) = (middle, middle);
        let inside = |(center, radius): (DVec3, f64)| {
            let center = along(center);
            (center - middle).abs().cmple(limit).all().then_some((center, radius))
        };
        for (k, (center, radius)) in balls.filter_map(inside).enumerate() {
            let (low, high) = (center - radius, center + radius);
            (least, most) = if k == 0 { (low, high) } else { (least.min(low), most.max(high)) };
        }
        let (least, most) = (least.max(middle - limit), most.min(middle + limit));
        let cells = |at: DVec2, round: fn(DVec2) -> DVec2| step * round(at / step);
        let least = cells(least - 0.5 * step, DVec2::floor);
        let most = cells(most + 0.5 * step, DVec2::ceil);
        let is_drawn =
            least.is_finite() && most.is_finite() && (most - least).cmpgt(DVec2::ZERO).all();
        let axes = [axis_a, axis_b];
        is_drawn.then_some(Pane { normal, axes, height, least, most, step })
    }
}

/// Returns the length of a grid's cells: 1, 2 or 5 times a power of ten, with about nine cells across what
/// is seen from this distance.
fn grid_step(distance: f64) -> f64 {
    let about = distance / 9.0;
    let power = 10f64.powf(about.log10().floor());
    let below = |(limit, _): &(f64, f64)| about / power < *limit;
    let step = [(1.5, 1.0), (3.5, 2.0), (7.5, 5.0)].into_iter().find(below);
    power * step.map_or(10.0, |(_, step)| step)
}

impl Sketch<'_> {
    /// Draws the edges of the panes, and the drop lines down to the floor.
    pub(crate) fn ground(&mut self, scene: ColoredScene<'_>) {
        let view = self.view;
        for (pane, _, [r, g, b]) in view.panes(scene) {
            let color = mix(Color32::from_rgb(r, g, b), self.colors.ink, 0.4);
            let pen = LineStyle::new(Item::Planes, color, THIN).without_halo().where_visible();
            self.sides(pane.corners(), pen);
        }
        let Some(floor) = view.floor(scene.scene) else { return };
        let color = self.colors.ink.gamma_multiply(0.5);
        let pen = LineStyle::new(Item::Floor, color, FINE).without_halo().where_visible();
        let pen = pen.patterned(Some(DROP));
        let spheres = view.near_spheres(scene.scene).chain([(view.camera.eye, 0.0)]);
        for (center, radius) in spheres {
            let (bottom, foot) = (center - radius * DVec3::Y, center.with_y(floor.corners()[0].y));
            if bottom.y - foot.y > SHORTEST_DROP * floor.step && floor.contains(foot) {
                self.line(bottom, foot, pen);
                self.point(foot, FINE, pen);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grid_steps_are_round_and_neither_few_nor_many() {
        for distance in [1e-6, 0.3, 1.0, 7.0, 10.0, 33.0, 9e8] {
            let step = grid_step(distance);
            let cells = distance / step;
            assert!((5.5..16.0).contains(&cells), "{distance}: {cells}");
        }
        assert_eq!(grid_step(10.0), 1.0);
    }
}
