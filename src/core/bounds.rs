//! Which pixels a sphere can cover, so that the others need not be asked.

use std::ops::Range;

use glam::DVec3;

use crate::posed::PosedCamera;
use crate::sphere::Sphere;

/// A rectangle of pixels: half-open ranges of rows and columns of the image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PixelBounds {
    pub rows: Range<u32>,
    pub columns: Range<u32>,
}

/// Rounding in the bounds stays far below this share of a coordinate, also for a basis by hand
/// that is off by its tolerance; one pixel is added besides.
const RELATIVE_MARGIN: f64 = 1e-7;

/// A rectangle that contains every pixel whose view ray can hit the sphere at `t > 0`; `None` where
/// no pixel's can.
///
/// In camera coordinates the view rays tangent to the sphere's outline in the u-w plane have
///
/// ```text
/// u / distance = (x z -+ r sqrt(x^2 + z^2 - r^2)) / (z^2 - r^2)
/// ```
///
/// with z the centre's depth; likewise for v. They bound the sphere while it lies wholly in front
/// of the eye (z > r). A sphere that crosses the eye's plane can be anywhere in the image.
pub(crate) fn sphere_bounds(camera: &PosedCamera, sphere: &Sphere) -> Option<PixelBounds> {
    let image = camera.image();
    let whole = PixelBounds { rows: 0..image.height(), columns: 0..image.width() };
    let to_center = sphere.center - camera.eye();
    let q = camera.basis().to_camera_from_world(to_center);
    let (depth, radius) = (-q.z, sphere.radius);
    let doubt = RELATIVE_MARGIN * (radius + to_center.abs().element_sum());
    if depth + radius < -doubt {
        return None;
    }
    if !(depth - radius > doubt && in_plain_range(q, radius)) {
        return Some(whole);
    }
    let viewport = camera.viewport();
    let (u0, u1) = tangents(q.x, depth, radius);
    let (v0, v1) = tangents(q.y, depth, radius);
    let scale = |extent: f64, count: u32| viewport.distance / extent * f64::from(count);
    let (per_u, per_v) =
        (scale(viewport.width, image.width()), scale(viewport.height, image.height()));
    let columns = pixels(u0 * per_u, u1 * per_u, image.width());
    let rows = pixels(-v1 * per_v, -v0 * per_v, image.height());
    (!columns.is_empty() && !rows.is_empty()).then_some(PixelBounds { rows, columns })
}

fn in_plain_range(q: DVec3, radius: f64) -> bool {
    q.abs().max_element() < 1e100 && radius > 1e-100
}

/// The slopes of the two tangents from the eye to a circle of `radius` around `(x, depth)`,
/// `depth > radius`.
fn tangents(x: f64, depth: f64, radius: f64) -> (f64, f64) {
    let denominator = (depth - radius) * (depth + radius);
    let swing = radius * (x * x + denominator).sqrt();
    ((x * depth - swing) / denominator, (x * depth + swing) / denominator)
}

/// The cells of `count` whose centres can lie between two positions, which are measured in cells
/// from the middle; with the margin for rounding.
fn pixels(from: f64, to: f64, count: u32) -> Range<u32> {
    let margin = 1.0 + RELATIVE_MARGIN * (from.abs() + to.abs());
    let middle = 0.5 * f64::from(count);
    let (from, to) = (middle + from - margin, middle + to + margin);
    if from.is_nan() || to.is_nan() {
        return 0..count;
    }
    // A cast from float saturates at both ends of u32.
    (from.floor() as u32).min(count)..(to.ceil() as u32).min(count)
}
