//! From the world to the dots of the observer's picture: projection, and clipping before it.

use pinhole_core::{DVec2, DVec3, ResolvedCamera};

/// The observer's picture plane, measured in dots from its top left corner.
///
/// Points pass through *view coordinates*: x to the right, y down, z the depth in front of the
/// observer, all in units of [`Screen::unit`], so that no product of them overflows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screen {
    observer: ResolvedCamera,
    /// Dots per unit slope, across and down.
    focal: DVec2,
    /// Width and height in dots.
    pub(crate) size: DVec2,
    /// The observer's distance to what it looks at: the length that counts as 1.
    unit: f64,
}

/// A point on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// In dots from the top left corner.
    pub(crate) at: DVec2,
    /// `1 / t` along the observer's ray: linear along a line on the screen, as t is not.
    pub(crate) inverse_t: f64,
}

impl Spot {
    /// The point a share `s` of the way from `self` to `other`, on the screen.
    pub(crate) fn toward(self, other: Spot, s: f64) -> Spot {
        Spot {
            at: self.at.lerp(other.at, s),
            inverse_t: self.inverse_t + (other.inverse_t - self.inverse_t) * s,
        }
    }
}

/// Nearer than this, in units of the observer's distance to its target, nothing is drawn.
const NEAR: f64 = 1e-7;

/// Coordinates in view units above which a point is not drawn at all: nothing a person can mean,
/// and products of coordinates below it are far from overflow.
const FARTHEST: f64 = 1e60;

/// Lines are cut this share of the picture beyond its border, so that their ends stay out of sight.
const BEYOND_BORDER: f64 = 0.1;

impl Screen {
    /// `unit` is a length of about the size of what is seen.
    pub(crate) fn new(observer: &ResolvedCamera, unit: f64) -> Screen {
        let image = observer.image();
        let size = DVec2::new(f64::from(image.width()), f64::from(image.height()));
        Screen::of_size(observer, size, unit)
    }

    /// The same with the image stretched over so many dots.
    pub(crate) fn of_size(observer: &ResolvedCamera, size: DVec2, unit: f64) -> Screen {
        let viewport = observer.viewport();
        let focal = size * viewport.distance / DVec2::new(viewport.width, viewport.height);
        let unit = if unit.is_finite() && unit > 0.0 { unit } else { 1.0 };
        Screen { observer: *observer, focal, size, unit }
    }

    /// The point in view coordinates; `None` where it is too far away to be drawn.
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

    /// Where a point appears; `None` behind the observer or outside the picture.
    pub(crate) fn spot(&self, point: DVec3) -> Option<Spot> {
        let q = self.view(point)?;
        (self.borders().iter().all(|border| border.dot(q) >= 0.0) && q.z >= NEAR)
            .then(|| self.spot_of_view(q))
    }

    /// The inward normals, in view coordinates, of the four planes through the observer's eye that
    /// bound what is drawn.
    fn borders(&self) -> [DVec3; 4] {
        let slope = (0.5 + BEYOND_BORDER) * self.size / self.focal;
        [
            DVec3::new(1.0, 0.0, slope.x),
            DVec3::new(-1.0, 0.0, slope.x),
            DVec3::new(0.0, 1.0, slope.y),
            DVec3::new(0.0, -1.0, slope.y),
        ]
    }

    /// The visible part of the line from `a` to `b`, and whether its ends are `a` and `b`
    /// themselves. It is cut before the division by depth (Blinn, Newell, *Clipping using
    /// homogeneous coordinates*, 1978).
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
            whole_from: s0 == 0.0,
            whole_to: s1 == 1.0,
        })
    }

    /// Whether a spot lies where cut lines end, give or take rounding: a guard for what is handed
    /// to the rasteriser.
    fn is_near(&self, spot: Spot) -> bool {
        let reach = 2.0 * self.size;
        (spot.at - 0.5 * self.size).abs().cmple(reach).all() && spot.inverse_t.is_finite()
    }

    /// How many dots a world unit at this point covers; `None` where the point is not seen.
    pub(crate) fn dots_per_unit(&self, point: DVec3) -> Option<f64> {
        let q = self.view(point)?;
        let dots = self.focal.min_element() / (q.z.max(NEAR) * self.unit);
        dots.is_finite().then_some(dots)
    }

    /// The direction of the observer's ray through a place on the screen, as
    /// `at.x * across + at.y * down + corner`.
    pub(crate) fn ray_parts(&self) -> RayParts {
        let (basis, viewport) = (self.observer.basis(), self.observer.viewport());
        let across = basis.u * (viewport.width / self.size.x);
        let down = basis.v * (-viewport.height / self.size.y);
        let corner = -0.5 * viewport.width * basis.u + 0.5 * viewport.height * basis.v
            - viewport.distance * basis.w;
        RayParts { eye: self.observer.eye(), across, down, corner }
    }
}

/// What is left of a line after it was cut to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CutLine {
    pub(crate) from: Spot,
    pub(crate) to: Spot,
    /// Whether `from` is where the line itself begins.
    pub(crate) whole_from: bool,
    /// Whether `to` is where the line itself ends.
    pub(crate) whole_to: bool,
}

/// The observer's rays, see [`Screen::ray_parts`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayParts {
    pub(crate) eye: DVec3,
    pub(crate) across: DVec3,
    pub(crate) down: DVec3,
    pub(crate) corner: DVec3,
}

/// `v / |v|`; `None` for zero and for what is not finite. Lengths from 1e-300 to 1e300 are right.
pub(crate) fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    if !(largest.is_finite() && largest > 0.0) {
        return None;
    }
    Some((v / largest).normalize())
}
