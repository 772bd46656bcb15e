//! The panes that stand for planes, the floor's grid, and the drop lines from spheres and eye down to the
//! floor. All of them are rectangles of whole grid cells around what they belong to. They follow from the
//! scene and the camera alone, so they stay in place while the observer moves, and while something small is
//! dragged.

use egui::Color32;
use pinhole_core::{Camera, DVec2, DVec3, Orientation, PixelRays, Plane, ResolvedCamera};

use crate::Item;
use crate::observer::{Bound, Surroundings};
use crate::overlay::{
    ColoredScene, FINE, Flat, Grid, LineStyle, PlanePatch, Sketch, THIN, WorldView, corners, mix,
    opaque, tangents, unit,
};

/// Maximum extent of a pane on each side of the scene's middle, as a multiple of the sum of two lengths: the
/// scene's extent, and the distance from its middle to the plane.
const PANE_REACH: f64 = 1.5;

/// Number of grid cells across the scene's extent, about.
const CELLS: f64 = 6.0;
/// Number of steps, about, in which the floor's height changes with the height of what stands on it.
const HEIGHT_STEPS: f64 = 9.0;

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

/// The panes, the floor and what stands on it.
pub(crate) struct Ground<'a> {
    panes: Vec<(Pane, &'a Plane, Color32)>,
    /// The floor: the pane of the scene's highest level plane below the eye, or else one of its own, below all
    /// spheres and the camera.
    floor: Option<Pane>,
    /// True if the floor has no pane, so that its grid must be drawn.
    is_bare: bool,
    spheres: Vec<Bound>,
}

impl WorldView {
    /// Finds the panes of the planes that are drawn, and the floor. There is no floor if it is switched off, if
    /// a sphere is the ground, or if there are many objects.
    pub(crate) fn ground<'a>(&self, scene: ColoredScene<'a>) -> Ground<'a> {
        let ColoredScene { scene: objects, .. } = scene;
        let has_floor = self.figure.items.shows(Item::Floor) && objects.len() <= WITH_FLOOR;
        let shown = if self.figure.items.shows(Item::Planes) { SHOWN_PLANES } else { 0 };
        let planes = &objects.planes()[..shown.min(objects.planes().len())];
        let mut ground =
            Ground { panes: Vec::new(), floor: None, is_bare: false, spheres: Vec::new() };
        if planes.is_empty() && !has_floor {
            return ground;
        }
        let around = Surroundings::new(&self.figure.camera, objects);
        let first = objects.spheres().len();
        ground.panes.extend((first..).zip(planes).filter_map(|(index, plane)| {
            Some((self.pane(&around, plane)?, plane, opaque(scene.color_of(index as u32))))
        }));
        if has_floor && around.planets.is_empty() {
            let is_level = |pane: &&Pane| {
                pane.normal.y.abs() == 1.0 && pane.height * pane.normal.y < self.figure.camera.eye.y
            };
            let level = ground.panes.iter().map(|(pane, ..)| pane).filter(is_level);
            let height = |pane: &Pane| pane.height * pane.normal.y;
            let highest = level.max_by(|a, b| height(a).total_cmp(&height(b))).copied();
            ground.is_bare = highest.is_none();
            ground.floor = highest.or_else(|| self.bare_floor(&around));
        }
        ground.spheres = around.spheres;
        ground
    }

    /// Returns the layers of the panes, and that of the floor if it has no pane.
    pub(crate) fn ground_layers(
        &self,
        ground: &Ground<'_>,
        rays: &PixelRays,
    ) -> (Vec<PlanePatch>, Option<PlanePatch>) {
        let colors = self.figure.style.colors();
        let patch = |(pane, plane, color): &(Pane, &Plane, Color32)| {
            let height = |p: DVec3| pane.normal.dot(p - plane.point);
            let between = height(self.figure.camera.eye) * height(rays.eye) < 0.0;
            let grid = mix(*color, colors.ink, 0.1);
            let patch =
                pane.patch(rays, [mix(*color, colors.background, 0.6), grid], self.scale)?;
            let opacity = if between { OPACITY_BETWEEN } else { OPACITY };
            Some(PlanePatch { opacity, ..patch })
        };
        let lines = [Color32::TRANSPARENT, colors.ink];
        let floor = ground.floor.filter(|_| ground.is_bare);
        let floor = floor.and_then(|floor| floor.patch(rays, lines, self.scale));
        let floor = floor.map(|patch| PlanePatch { opacity: FLOOR_LINES, ..patch });
        (ground.panes.iter().filter_map(patch).collect(), floor)
    }

    /// Returns the camera without its roll, so that the ground stays while the camera rolls or loses its basis.
    fn level_camera(&self) -> Option<ResolvedCamera> {
        let camera = self.figure.camera;
        let orientation = Orientation::View { view: camera.view(), up: DVec3::Y };
        Camera { orientation, ..camera }.resolve().ok().or(self.figure.resolved)
    }

    /// Returns the pane of a plane: in front of the spheres, and as large as what the camera sees of it.
    fn pane(&self, around: &Surroundings, plane: &Plane) -> Option<Pane> {
        let normal = unit(plane.normal)?;
        let height = normal.dot(plane.point);
        let seen = self.level_camera().into_iter().flat_map(|resolved| {
            let rays = corners(&resolved).map(|uv| resolved.ray(uv));
            rays.into_iter().filter_map(|ray| Some(ray.at(plane.roots(&ray).first_positive()?)))
        });
        let spheres = around.spheres.iter().copied();
        pane_around(around, normal, height, spheres.chain(seen.map(Bound::point)))
    }

    /// Returns a floor below all spheres and the camera.
    fn bare_floor(&self, around: &Surroundings) -> Option<Pane> {
        let resolved = self.level_camera().into_iter();
        let viewport =
            resolved.flat_map(|camera| corners(&camera).map(|uv| camera.viewport_point(uv)));
        let points = viewport.chain([around.eye]).map(Bound::point);
        let parts: Vec<Bound> = around.spheres.iter().copied().chain(points).collect();
        let bottoms = || parts.iter().map(|ball| ball.center.y - ball.radius);
        let tops = parts.iter().map(|ball| ball.center.y + ball.radius);
        let lowest = bottoms().fold(f64::INFINITY, f64::min);
        let step = grid_step((tops.fold(f64::NEG_INFINITY, f64::max) - lowest) / HEIGHT_STEPS);
        pane_around(around, DVec3::Y, (lowest / step).floor() * step, parts.into_iter())
    }
}

/// Returns the pane, in a plane with this unit normal and height, with all of the given balls in front
/// of it, and a margin. It is limited to the surroundings of the scene's middle.
fn pane_around(
    around: &Surroundings,
    normal: DVec3,
    height: f64,
    balls: impl Iterator<Item = Bound>,
) -> Option<Pane> {
    let away = (normal.dot(around.middle) - height).abs();
    if !away.is_finite() {
        return None;
    }
    let (axis_a, axis_b) = tangents(normal);
    let along = |point: DVec3| DVec2::new(point.dot(axis_a), point.dot(axis_b));
    let (middle, limit) = (along(around.middle), DVec2::splat(PANE_REACH * (around.extent + away)));
    let step = grid_step(around.extent.max(away) / CELLS);
    let (mut least, mut most) = (middle, middle);
    let inside = |Bound { center, radius }| {
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
    let is_drawn = least.is_finite() && most.is_finite() && (most - least).cmpgt(DVec2::ZERO).all();
    let axes = [axis_a, axis_b];
    is_drawn.then_some(Pane { normal, axes, height, least, most, step })
}

/// Returns the length of a grid's cells: of 1, 2 and 5 times a power of ten, one that is near this length.
fn grid_step(about: f64) -> f64 {
    let power = 10f64.powf(about.log10().floor());
    let below = |(limit, _): &(f64, f64)| about / power < *limit;
    let step = [(1.5, 1.0), (3.5, 2.0), (7.5, 5.0)].into_iter().find(below);
    power * step.map_or(10.0, |(_, step)| step)
}

impl Sketch<'_> {
    /// Draws the edges of the panes, and the drop lines down to the floor.
    pub(crate) fn ground(&mut self, scene: ColoredScene<'_>) {
        let view = self.view;
        let ground = view.ground(scene);
        for (pane, _, color) in &ground.panes {
            let color = mix(*color, self.colors.ink, 0.4);
            let pen = LineStyle::new(Item::Planes, color, THIN).without_halo().where_visible();
            self.sides(&pane.corners(), pen);
        }
        let Some(floor) = ground.floor else { return };
        let color = self.colors.ink.gamma_multiply(0.6);
        let pen = LineStyle::new(Item::Floor, color, FINE).without_halo().where_visible();
        let pen = pen.patterned(Some(DROP));
        let eye = Bound::point(view.figure.camera.eye);
        for Bound { center, radius } in ground.spheres.into_iter().chain([eye]) {
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
    fn grid_steps_are_round_and_near_what_is_wanted() {
        for about in [1e-6, 0.3, 1.0, 7.0, 10.0, 33.0, 9e8] {
            let ratio = grid_step(about) / about;
            assert!((0.6..1.6).contains(&ratio), "{about}: {ratio}");
        }
        assert_eq!(grid_step(1.1), 1.0);
    }
}
