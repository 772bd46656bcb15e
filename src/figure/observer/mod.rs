//! The observer of the world view, and the scene that is traced for its picture. The observer is a second
//! camera, independent of the edited one, which moves around a target.

use pinhole_core::{
    Camera, DVec3, ImageSize, Object, Orientation, Scene, Sphere, Viewport, extent_of_fov,
};
use pinhole_exchange::document::StoredObserver;

pub use fit::ORDINARY_ASPECT;
pub use subject::{Bound, Drawn, Length, Place, Surroundings};
pub use view_size::{Area, ViewSize};

mod fit;
mod subject;
mod view_size;

/// The observer of the world view, which orbits around a target. World y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer {
    /// The point at which the observer looks and around which it turns.
    target: DVec3,
    /// Angle from +z towards +x, in radians.
    azimuth: f64,
    /// Angle above the target's level, in radians; its magnitude is less than 90 degrees.
    elevation: f64,
    /// Distance from the target, in world units.
    distance: f64,
}

/// The vertical field of view.
const FOV: f64 = 35.0 * std::f64::consts::PI / 180.0;

/// Maximum elevation. Straight above or below the target, up would be parallel to the view
/// direction.
const STEEPEST: f64 = 89.0 * std::f64::consts::PI / 180.0;

/// The elevation from which on the observer stands farther away and sees a narrower field, so that its view grows flat; and
/// how many times as far it stands at the steepest elevation.
const FLAT_FROM: f64 = 84.0 * std::f64::consts::PI / 180.0;
const FLAT: f64 = 12.0;

/// The height of the view, in diameters of a sphere that fills it.
const MARGIN_AROUND: f64 = 1.3;

/// Minimum and maximum distance of an observer from its target.
const DISTANCES: (f64, f64) = (1e-9, 1e12);

/// Maximum magnitude of the target's coordinates.
const FARTHEST_TARGET: f64 = 1e12;

impl From<StoredObserver> for Observer {
    fn from(stored: StoredObserver) -> Observer {
        let StoredObserver { target, azimuth, elevation, distance } = stored;
        Observer::new(target, azimuth.to_radians(), elevation.to_radians(), distance)
    }
}

impl Observer {
    /// Returns the observer as files write it, rounded to digits that move no pixel of the view.
    pub fn stored(&self) -> StoredObserver {
        let round = |x: f64, digits: usize| format!("{x:.digits$}").parse().unwrap_or(x) + 0.0;
        let digits = (4.0 - self.distance.log10().floor()).max(0.0) as usize;
        StoredObserver {
            target: self.target.map(|x| round(x, digits)),
            azimuth: round(self.azimuth.to_degrees().rem_euclid(360.0), 2),
            elevation: round(self.elevation.to_degrees(), 2),
            distance: round(self.distance, digits),
        }
    }

    /// Creates an observer at `distance` from `target`. Values that are out of range are clamped.
    pub fn new(target: DVec3, azimuth: f64, elevation: f64, distance: f64) -> Observer {
        Observer { target, azimuth, elevation, distance }.in_range()
    }

    /// Returns the point at which the observer looks and around which it turns.
    pub fn target(&self) -> DVec3 {
        self.target
    }

    /// Returns the distance of the observer from the target.
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Clamps all values to their ranges.
    fn in_range(&self) -> Observer {
        let finite = |x: f64, otherwise: f64| if x.is_finite() { x } else { otherwise };
        Observer {
            target: self.target.map(|x| finite(x, 0.0).clamp(-FARTHEST_TARGET, FARTHEST_TARGET)),
            azimuth: finite(self.azimuth, 0.0) % std::f64::consts::TAU,
            elevation: finite(self.elevation, 0.0).clamp(-STEEPEST, STEEPEST),
            distance: finite(self.distance, 10.0).clamp(DISTANCES.0, DISTANCES.1),
        }
    }

    /// Returns the unit vector from the target to the observer.
    fn back(&self) -> DVec3 {
        let (sin, cos) = self.azimuth.sin_cos();
        let (rise, run) = self.elevation.sin_cos();
        DVec3::new(run * sin, rise, run * cos)
    }

    /// Returns the unit vectors that point to the right and upwards in the observer's picture.
    fn right_and_up(&self) -> (DVec3, DVec3) {
        let (sin, cos) = self.azimuth.sin_cos();
        let right = DVec3::new(cos, 0.0, -sin);
        (right, self.back().cross(right))
    }

    /// Returns the observer as a camera with an image of this size in pixels.
    pub fn camera(&self, width: u32, height: u32) -> Camera {
        let size = |x: u32| x.clamp(1, ImageSize::MAX);
        let image = ImageSize::new(size(width), size(height)).unwrap_or(Camera::CANONICAL.image);
        // Seen from above, a figure in the plane is flat: what is at the target keeps its size.
        let steepness = (self.elevation.abs() - FLAT_FROM) / (STEEPEST - FLAT_FROM);
        let far = 1.0 + (FLAT - 1.0) * steepness.max(0.0);
        let extent = extent_of_fov(FOV, 1.0) / far;
        let viewport = Viewport { width: extent * image.aspect(), height: extent, distance: 1.0 };
        let back = self.back();
        let eye = self.target + far * self.distance * back;
        Camera {
            eye,
            orientation: Orientation::View { view: -back, up: DVec3::Y },
            viewport,
            image,
        }
    }

    /// Returns an observer on the way to another one: this one for a share of 0, the other one for 1. It
    /// turns the shorter way round, and its distance grows by equal factors in equal shares.
    #[must_use]
    pub fn toward(&self, other: &Observer, share: f64) -> Observer {
        const TURN: f64 = std::f64::consts::TAU;
        let turn = (other.azimuth - self.azimuth + 0.5 * TURN).rem_euclid(TURN) - 0.5 * TURN;
        Observer {
            target: self.target.lerp(other.target, share),
            azimuth: self.azimuth + share * turn,
            elevation: self.elevation + share * (other.elevation - self.elevation),
            distance: self.distance * (other.distance / self.distance).powf(share),
        }
        .in_range()
    }

    /// Turns the observer around the target by two angles in radians: to the right and upwards.
    pub fn orbit(&mut self, right: f64, up: f64) {
        self.azimuth += right;
        self.elevation += up;
        *self = self.in_range();
    }

    /// Moves the observer sideways, as if a hand dragged the picture: its content moves to the right and
    /// down by these fractions of the picture's height.
    pub fn pan(&mut self, right: f64, down: f64) {
        let per_height = extent_of_fov(FOV, self.distance);
        let (to_right, to_up) = self.right_and_up();
        self.target += per_height * (down * to_up - right * to_right);
        *self = self.in_range();
    }

    /// Divides the observer's distance from a point by a factor. The direction stays the same, so the point
    /// keeps its place in the picture. The observer does not come closer to the point than `limits[0]`, nor
    /// farther from the target than `limits[1]`.
    pub fn zoom(&mut self, point: DVec3, factor: f64, limits: [f64; 2]) {
        if factor > 0.0 && factor.is_finite() && point.is_finite() {
            let reach = (self.target + self.distance * self.back()).distance(point);
            // An observer that is beyond a limit does not jump back.
            let most = (reach / limits[0]).max(1.0);
            let least = (self.distance / limits[1]).min(1.0);
            let factor = factor.max(least).min(most);
            self.target = point + (self.target - point) / factor;
            self.distance /= factor;
        }
        *self = self.in_range();
    }

    /// Returns the observer that looks along one of the world's axes: from the side, from above as steeply as it
    /// can, or from the front; if it does so already, from the other side. Its target and distance stay the same.
    #[must_use]
    pub fn along(&self, axis: WorldAxis) -> Observer {
        let [azimuth, elevation] = match axis {
            WorldAxis::X => [std::f64::consts::FRAC_PI_2, 0.0],
            WorldAxis::Y => [0.0, STEEPEST],
            WorldAxis::Z => [0.0, 0.0],
        };
        let along = Observer { azimuth, elevation, ..*self };
        match axis {
            _ if along != *self => along,
            WorldAxis::Y => Observer { elevation: -elevation, ..along },
            _ => Observer { azimuth: azimuth + std::f64::consts::PI, ..along },
        }
    }

    /// Returns the observer that looks at a sphere from the same direction, and sees all of it in a view of this
    /// size.
    #[must_use]
    pub fn framing_sphere(&self, sphere: &Sphere, size: ViewSize) -> Observer {
        let half_angle = (size.aspect().min(1.0) * (0.5 * FOV).tan()).atan();
        let distance = MARGIN_AROUND * sphere.radius / half_angle.sin();
        Observer { target: sphere.center, distance, ..*self }.in_range()
    }
}

/// One of the world's axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorldAxis {
    /// The x axis, which points to the right for the canonical camera.
    X,
    /// The y axis, which points up.
    Y,
    /// The z axis, which points backwards for the canonical camera.
    Z,
}

/// Returns the indices, ascending, of the spheres that would hide the camera from the observer: those
/// that contain the camera's eye but not the observer's.
pub fn enclosing(scene: &Scene, camera_eye: DVec3, observer_eye: DVec3) -> Vec<u32> {
    let mut around = scene.spheres_around(camera_eye);
    around.retain(|index| scene.spheres()[*index as usize].implicit(observer_eye) >= 0.0);
    around
}

/// Returns the scene that is traced for the world view: the spheres without the planes. The indices of the
/// spheres are unchanged.
///
/// A plane is infinite. If it were traced, it would fill the picture up to its horizon and, seen from
/// behind, hide the camera. The overlay draws a part of the plane near the target instead. A sphere [around
/// the camera](enclosing) would hide the camera, too. It is replaced by a [`hidden`] sphere, so that the
/// other spheres keep their indices, and the overlay draws its outline.
pub fn traced_scene(scene: &Scene, enclosing: &[u32]) -> Scene {
    let mut seen = scene.without_planes();
    for &index in enclosing {
        if let Some(sphere) = scene.spheres().get(index as usize) {
            // Replacing a valid sphere by its hidden form cannot fail. If it did, the picture would still
            // be correct.
            let _ = seen.replace(index, Object::Sphere(hidden(sphere)));
        }
    }
    seen
}

/// Returns the sphere shrunk to a point at its centre.
pub fn hidden(sphere: &Sphere) -> Sphere {
    Sphere { radius: f64::MIN_POSITIVE, ..*sphere }
}

#[cfg(test)]
mod tests;
