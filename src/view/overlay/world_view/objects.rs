//! Objects that the world view does not trace: a plane is shown as a patch near the observer's
//! target, with a grid; a sphere around the camera is shown cut away.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Plane, Rgb, Sphere};

use crate::model::concept::Concept;
use crate::model::overlay_items::Item;
use crate::view::overlay::drawing::circle;
use crate::view::overlay::highlighted::silhouette;
use crate::view::overlay::space::flat::{Flat, Grid};
use crate::view::overlay::space::layers::{Patch, mix};
use crate::view::overlay::space::screen::{PixelRays, tangents, unit};
use crate::view::overlay::space::sketch::{Pen, Sketch};
use crate::view::overlay::style::Colors;

/// Radius of a patch, as a share of the observer's distance to the target plus the target's to the
/// plane; and the greatest distance of the plane from the target, as a multiple of the observer's
/// distance to it.
const PATCH_RADIUS: f64 = 0.5;
const PATCH_REACH: f64 = 3.0;

/// Opacity of a patch in its middle; and its opacity there if it is between the observer and the
/// camera.
const OPACITY: f32 = 0.75;
const OPACITY_BETWEEN: f32 = 0.2;

/// Maximum number of planes shown.
const SHOWN_PLANES: usize = 16;

/// The observer of a plane, and the target it looks at.
pub(crate) struct Onlooker {
    pub(crate) rays: PixelRays,
    pub(crate) target: DVec3,
    pub(crate) distance: f64,
    /// Eye of the edited camera.
    pub(crate) camera_eye: DVec3,
    /// Dots per point.
    pub(crate) scale: f64,
}

/// Returns the patches of the planes near the observer's target.
pub(crate) fn patches(
    planes: &[Plane],
    color_of: impl Fn(usize) -> Rgb,
    onlooker: &Onlooker,
    colors: &Colors,
) -> Vec<Patch> {
    let visible = planes.iter().take(SHOWN_PLANES).enumerate();
    visible.filter_map(|(index, plane)| patch(plane, color_of(index), onlooker, colors)).collect()
}

fn patch(plane: &Plane, [r, g, b]: Rgb, onlooker: &Onlooker, colors: &Colors) -> Option<Patch> {
    let normal = unit(plane.normal)?;
    let height = |p: DVec3| normal.dot(p - plane.point);
    let away = height(onlooker.target);
    if away.is_nan() || away.abs() > PATCH_REACH * onlooker.distance {
        return None;
    }
    let center = onlooker.target - away * normal;
    let (axis_a, axis_b) = tangents(normal);
    let step = grid_step(onlooker.distance);
    let shift = -DVec2::new(axis_a.dot(center) % step, axis_b.dot(center) % step);
    let between = height(onlooker.camera_eye) * height(onlooker.rays.eye) < 0.0;
    let color = Color32::from_rgb(r, g, b);
    Some(Patch {
        flat: Flat::new(&onlooker.rays, center, axis_a, axis_b)?,
        radius: PATCH_RADIUS * (onlooker.distance + away.abs()),
        color: mix(color, colors.background, 0.45),
        grid_color: mix(color, colors.ink, 0.25),
        opacity: if between { OPACITY_BETWEEN } else { OPACITY },
        grid: Grid::new(DVec2::splat(step), shift, onlooker.scale as f32),
    })
}

/// Returns a grid step of 1, 2 or 5 times a power of ten: about nine cells across a patch.
fn grid_step(distance: f64) -> f64 {
    let about = 2.0 * PATCH_RADIUS * distance / 9.0;
    let power = 10f64.powf(about.log10().floor());
    let mantissa = about / power;
    power
        * if mantissa < 1.5 {
            1.0
        } else if mantissa < 3.5 {
            2.0
        } else if mantissa < 7.5 {
            5.0
        } else {
            10.0
        }
}

impl Sketch<'_> {
    /// Draws the rim of a sphere that is cut away, and three circles on what is left of it, orthogonal
    /// to x, y and z.
    pub(crate) fn cut_away(
        &mut self,
        index: u32,
        sphere: &Sphere,
        [r, g, b]: Rgb,
        observer: DVec3,
    ) {
        let color = mix(Color32::from_rgb(r, g, b), self.colors.ink, 0.3);
        let pen = Pen::new(Item::Frustum, color, 1.2).about(Concept::Object(index)).without_halo();
        for (a, b) in [(DVec3::X, DVec3::Y), (DVec3::Y, DVec3::Z), (DVec3::Z, DVec3::X)] {
            let at = |p: DVec2| sphere.center + sphere.radius * (p.x * a + p.y * b);
            let ring: Vec<DVec3> = circle(72).map(at).collect();
            let is_left = |p: DVec3| {
                let out = p - sphere.center;
                out.dot(observer - sphere.center) <= sphere.radius * sphere.radius
            };
            for ends in ring.windows(2).filter(|ends| is_left(ends[0].midpoint(ends[1]))) {
                self.line(ends[0], ends[1], pen);
            }
        }
        let rim = silhouette(sphere, observer).unwrap_or_default();
        let pen = Pen { width: 2.0, ..pen };
        rim.windows(2).for_each(|ends| self.line(ends[0], ends[1], pen));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grid_steps_are_round_and_neither_few_nor_many() {
        for distance in [1e-6, 0.3, 1.0, 7.0, 10.0, 33.0, 9e8] {
            let step = grid_step(distance);
            let cells = 2.0 * PATCH_RADIUS * distance / step;
            assert!((5.5..16.0).contains(&cells), "{distance}: {cells}");
        }
        assert_eq!(grid_step(10.0), 1.0);
    }
}
