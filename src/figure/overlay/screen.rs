//! Projects the world, after clipping, to the pixels of the observer's picture. Also converts between
//! positions in the viewport and pixels of the camera view.

use pinhole_core::{DVec2, DVec3, ResolvedCamera};

use crate::observer::ViewSize;

/// The observer's picture plane. Positions are in screen pixels from its top left corner.
///
/// Points are first converted to *view coordinates*: x to the right, y down, and z the depth in front of
/// the observer. They are in units of [`Screen::unit`], so that products of them do not overflow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screen {
    observer: ResolvedCamera,
    /// Focal length in screen pixels, horizontally and vertically.
    focal: DVec2,
    /// Width and height in screen pixels.
    pub(crate) size: DVec2,
    /// The unit of length in view coordinates, usually the observer's distance to its target.
    unit: f64,
    /// Screen pixels per point.
    pub(crate) scale: f64,
    /// See [`ViewSize::is_directed`].
    pub(crate) is_directed: bool,
}

/// A point on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Position in screen pixels from the top left corner.
    pub(crate) at: DVec2,
    /// `1 / t` along the observer's ray. Unlike t, it varies linearly along a line on the screen.
    pub(crate) inverse_t: f64,
}

impl Spot {
    /// Interpolates linearly between `self` (`s` = 0) and `other` (`s` = 1).
    pub(crate) fn toward(self, other: Spot, s: f64) -> Spot {
        Spot {
            at: self.at.lerp(other.at, s),
            inverse_t: self.inverse_t + (other.inverse_t - self.inverse_t) * s,
        }
    }
}

/// Minimum depth of drawn points, in view coordinates.
const NEAR: f64 = 1e-7;

/// Maximum magnitude of the view coordinates of drawn points. No sensible scene exceeds it, and products of
/// smaller coordinates are far from overflow.
const FARTHEST: f64 = 1e60;

/// Distance beyond the picture's border at which lines are clipped, as a fraction of the picture's size, so
/// that the clipped ends are not visible.
const BEYOND_BORDER: f64 = 0.1;

impl Screen {
    /// Creates a screen with `scale` screen pixels per point. `unit` is the unit of view coordinates, a
    /// length of the order of magnitude of the visible scene.
    pub(crate) fn new(observer: &ResolvedCamera, unit: f64, scale: f32) -> Screen {
        let image = observer.image();
        let size = DVec2::new(f64::from(image.width()), f64::from(image.height()));
        Screen::of_size(observer, size, unit, scale)
    }

    /// Creates a screen for the observer's image stretched to `size` screen pixels.
    pub(crate) fn of_size(observer: &ResolvedCamera, size: DVec2, unit: f64, scale: f32) -> Screen {
        let viewport = observer.viewport();
        let focal = size * viewport.distance / DVec2::new(viewport.width, viewport.height);
        let unit = if unit.is_finite() && unit > 0.0 { unit } else { 1.0 };
        Screen { observer: *observer, focal, size, unit, scale: scale.into(), is_directed: false }
    }

    /// Creates a screen whose unit of length is the distance of a point.
    fn at(observer: &ResolvedCamera, point: DVec3, scale: f32) -> Screen {
        Screen::new(observer, point.distance(observer.eye()), scale)
    }

    /// Converts a point to view coordinates; `None` if it is too far away to be drawn.
    fn view(&self, point: DVec3) -> Option<DVec3> {
        let q =
            self.observer.basis().to_camera_from_world((point - self.observer.eye()) / self.unit);
        let q = DVec3::new(q.x, -q.y, -q.z);
        (q.is_finite() && q.abs().max_element() < FARTHEST).then_some(q)
    }

    fn spot_of_view(&self, q: DVec3) -> Spot {
        let at = 0.5 * self.size + self.focal * DVec2::new(q.x, q.y) / q.z;
        Spot { at, inverse_t: self.observer.viewport().distance / (q.z * self.unit) }
    }

    /// Returns the position of a point on the screen; `None` if it is behind the observer or too far
    /// outside the picture.
    pub(crate) fn spot(&self, point: DVec3) -> Option<Spot> {
        let q = self.view(point)?;
        (self.borders().iter().all(|border| border.dot(q) >= 0.0) && q.z >= NEAR)
            .then(|| self.spot_of_view(q))
    }

    /// Returns the inward normals, in view coordinates, of the four planes through the observer's eye that
    /// bound the region in which lines are drawn.
    fn borders(&self) -> [DVec3; 4] {
        let slope = (0.5 + BEYOND_BORDER) * self.size / self.focal;
        [
            DVec3::new(1.0, 0.0, slope.x),
            DVec3::new(-1.0, 0.0, slope.x),
            DVec3::new(0.0, 1.0, slope.y),
            DVec3::new(0.0, -1.0, slope.y),
        ]
    }

    /// Returns the corners of the visible part of a flat convex polygon; empty if no part is visible
    /// (Sutherland, Hodgman, *Reentrant polygon clipping*, 1974).
    pub(crate) fn polygon(&self, corners: &[DVec3]) -> Vec<Spot> {
        let in_view = corners.iter().map(|corner| self.view(*corner));
        let mut inside: Vec<DVec3> = in_view.collect::<Option<_>>().unwrap_or_default();
        inside = clipped(&inside, |q| q.z - NEAR);
        for border in self.borders() {
            inside = clipped(&inside, |q| border.dot(q));
        }
        let spots: Vec<Spot> = inside.into_iter().map(|q| self.spot_of_view(q)).collect();
        if spots.iter().all(|spot| self.is_near(*spot)) { spots } else { Vec::new() }
    }

    /// Returns the visible part of the line from `a` to `b`; `None` if no part is visible. The line is
    /// clipped before the division by depth (Blinn, Newell, *Clipping using homogeneous coordinates*,
    /// 1978).
    pub(crate) fn line(&self, a: DVec3, b: DVec3) -> Option<CutLine> {
        let (a, b) = (self.view(a)?, self.view(b)?);
        let (mut s0, mut s1) = (0.0f64, 1.0f64);
        let near = (a.z - NEAR, b.z - NEAR);
        let sides = self.borders().map(|border| (border.dot(a), border.dot(b)));
        for (from, to) in sides.into_iter().chain([near]) {
            if from < 0.0 && to < 0.0 {
                return None;
            }
            if from < 0.0 {
                s0 = s0.max(from / (from - to));
            } else if to < 0.0 {
                s1 = s1.min(from / (from - to));
            }
        }
        if s0 > s1 {
            return None;
        }
        let spot = |s: f64| {
            let mut q = a.lerp(b, s);
            q.z = q.z.max(NEAR);
            self.spot_of_view(q)
        };
        let (from, to) = (spot(s0), spot(s1));
        (self.is_near(from) && self.is_near(to)).then_some(CutLine {
            from,
            to,
            whole_to: s1 == 1.0,
        })
    }

    /// Returns true if a spot lies within the region to which lines are clipped, with a margin for
    /// rounding. Other spots are rejected, to protect the rasterizer from extreme positions.
    fn is_near(&self, spot: Spot) -> bool {
        let reach = 2.0 * self.size;
        (spot.at - 0.5 * self.size).abs().cmple(reach).all() && spot.inverse_t.is_finite()
    }

    /// Returns the number of screen pixels that a length of 1 in the world covers at this point; `None` if
    /// the point is too far away to be drawn.
    pub(crate) fn dots_per_unit(&self, point: DVec3) -> Option<f64> {
        let q = self.view(point)?;
        let dots = self.focal.min_element() / (q.z.max(NEAR) * self.unit);
        dots.is_finite().then_some(dots)
    }

    /// Returns the length in the world at which something at the point `at` is drawn: 1, unless that covers
    /// fewer than `least` or more than `most` points on the screen; then the length that covers this limit.
    /// Returns 0 if `at` cannot be drawn.
    pub(crate) fn length_of_points(&self, at: DVec3, (least, most): (f64, f64)) -> f64 {
        let Some(dots) = self.dots_per_unit(at) else { return 0.0 };
        let points = dots / self.scale;
        points.clamp(least, most) / points
    }

    /// Returns the length in the world at which basis arrows are drawn at a point; 0 if the point cannot be
    /// drawn.
    pub(crate) fn arrow_length(&self, at: DVec3) -> f64 {
        self.length_of_points(at, self.arrow_points())
    }

    /// Returns the length in the world at which a normal is drawn at a point; 0 if the point cannot be
    /// drawn.
    pub(crate) fn normal_length(&self, at: DVec3) -> f64 {
        let (points, _) = self.arrow_points();
        self.length_of_points(at, (points, points))
    }

    fn arrow_points(&self) -> (f64, f64) {
        let (width, height) = (self.size.x / self.scale, self.size.y / self.scale);
        let is_directed = self.is_directed;
        ViewSize { is_directed, ..ViewSize::new(width, height) }.arrow_points()
    }
}

/// Returns the length in the world that covers `points` points on the screen at the point `at`; 0 if
/// `at` cannot be drawn.
pub fn length_of_points(observer: &ResolvedCamera, at: DVec3, points: f64, scale: f32) -> f64 {
    Screen::at(observer, at, scale).length_of_points(at, (points, points))
}

/// Returns the length in the world of the basis arrows that the world view draws at a camera's eye. A view that is
/// directed to a part of the figure may draw longer ones.
pub fn arrow_length(observer: &ResolvedCamera, eye: DVec3, scale: f32, is_directed: bool) -> f64 {
    Screen { is_directed, ..Screen::at(observer, eye, scale) }.arrow_length(eye)
}

/// Returns the position of a point of the world in the observer's picture, in screen pixels; `None` if it is
/// behind the observer or outside the picture. Objects in front of the point are ignored.
pub fn world_position_of(observer: &ResolvedCamera, point: DVec3) -> Option<DVec2> {
    Some(Screen::at(observer, point, 1.0).spot(point)?.at)
}

/// A line clipped to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CutLine {
    pub(crate) from: Spot,
    pub(crate) to: Spot,
    /// True if `to` is the line's own end, false if the line was clipped there.
    pub(crate) whole_to: bool,
}

/// Returns `v / |v|`; `None` if `v` is zero or not finite. Neither overflows nor underflows for lengths
/// from 1e-300 to 1e300.
pub(crate) fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    if !(largest.is_finite() && largest > 0.0) {
        return None;
    }
    Some((v / largest).normalize())
}

/// Returns two orthogonal unit vectors that span the plane with this normal, along the world's axes if
/// possible.
pub(crate) fn tangents(normal: DVec3) -> (DVec3, DVec3) {
    let axis = DVec3::AXES[normal.abs().min_position()];
    let a = (axis - axis.dot(normal) * normal).normalize();
    (a, normal.cross(a))
}

/// Returns the corners of the part of a convex polygon where `depth` is at least 0.
fn clipped(corners: &[DVec3], depth: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (k, &corner) in corners.iter().enumerate() {
        let before = corners[(k + corners.len() - 1) % corners.len()];
        let (from, to) = (depth(before), depth(corner));
        if (from < 0.0) != (to < 0.0) {
            kept.push(before.lerp(corner, from / (from - to)));
        }
        if to >= 0.0 {
            kept.push(corner);
        }
    }
    kept
}

/// Returns the (u, v) at a position in the camera view, which is in screen pixels and may lie outside the
/// picture.
pub fn camera_uv_at(resolved: &ResolvedCamera, size: [usize; 2], position: [f32; 2]) -> DVec2 {
    let share = |k: usize| f64::from(position[k]) / size[k].max(1) as f64;
    let viewport = resolved.viewport();
    DVec2::new(viewport.width * (share(0) - 0.5), viewport.height * (0.5 - share(1)))
}

/// Returns the position of a (u, v) in the camera view, in screen pixels. Inverse of [`camera_uv_at`].
pub(crate) fn position_of(camera: &ResolvedCamera, [w, h]: [usize; 2], uv: DVec2) -> DVec2 {
    let viewport = camera.viewport();
    DVec2::new(w as f64 * (0.5 + uv.x / viewport.width), h as f64 * (0.5 - uv.y / viewport.height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_on_level_planes_follow_the_axes() {
        assert_eq!(tangents(DVec3::Z), (DVec3::X, DVec3::Y));
        assert_eq!(tangents(DVec3::Y), (DVec3::X, DVec3::NEG_Z));
    }
}
