//! Converts the pointer's position in an observer's picture to a point of the world, for drags, and
//! snaps or rounds numbers to the resolution of a pixel.

use glam::{DVec2, DVec3};

use crate::camera::basis::BasisError;
use crate::camera::resolved::ResolvedCamera;
use crate::exact::scale::unit;
use crate::steering::{SteerError, check_finite, check_positive};

/// The smallest angle, in radians, between the line of sight and the axis or plane of a drag: 5 degrees.
/// At smaller angles, moving the pointer by one pixel would move the point more than ten times as far as
/// when seen from the side.
pub const LEAST_ANGLE: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Maximum depth of a drag, as a multiple of the depth at which the drag began. At greater depths, near
/// the horizon of the axis or plane, the size of a pixel grows without bound.
pub const FARTHEST: f64 = 1000.0;

/// The line or plane along which a point is dragged, through the anchor, the point's position at the
/// start. Vectors are directions in world coordinates, of any length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DragAlong {
    /// The plane through the anchor that is parallel to the observer's picture.
    ViewPlane,
    /// The line through the anchor in the given direction, which must not be zero.
    Axis(DVec3),
    /// The plane through the anchor at right angles to the given direction, which must not be zero.
    Plane(DVec3),
}

impl ResolvedCamera {
    /// Returns the point of the world to which a drag from `begun_at` to `uv`, in the viewport of this
    /// observer, moves an anchor. `anchor` is its position at the start of the drag; the observer must
    /// not have moved since then.
    ///
    /// The pointer keeps its distance from the anchor in the picture: a handle grabbed 3 pixels from its
    /// middle stays 3 pixels from the pointer. A drag back to the start restores the anchor exactly.
    ///
    /// Let `(x, y, -z)` be the anchor in the observer's coordinates, `p = (x, y) distance / z` its
    /// image, `m = uv - begun_at` the pointer's movement, and `r = (p + m, -distance)` a ray. The result
    /// is
    ///
    /// ```text
    /// view plane   anchor + (m.u U + m.v V) z / distance
    /// plane        where the ray eye + t r meets it
    /// axis         the point of the axis whose image is nearest to p + m
    /// ```
    ///
    /// The image of `anchor + s a`, with `a = (a_x, a_y, -a_z)` of length 1, is
    /// `p + g s z / (z + s a_z)`, with `g = distance ((a_x, a_y) z - (x, y) a_z) / z^2`. This is a line
    /// along g, on which the point nearest to `p + m` is `l = m . g / |g|` away from p. So
    ///
    /// ```text
    /// s = l z / (|g| z - l a_z)
    /// ```
    ///
    /// Apart from rounding, the observer sees the result at `p + m`, the pointer's position minus its
    /// offset from the anchor at the start; for an axis, at the point of the axis' image nearest to
    /// `p + m`.
    ///
    /// # Errors
    /// Returns an error if the anchor is not in front of the observer, or if the point would move to
    /// infinity.
    pub fn dragged(
        &self,
        anchor: DVec3,
        begun_at: DVec2,
        uv: DVec2,
        along: DragAlong,
    ) -> Result<DVec3, SteerError> {
        let seen = ObserverAnchor::new(anchor, self)?;
        let way = finite("pointer", (uv - begun_at).extend(0.0))?.truncate();
        let offset = match along {
            DragAlong::ViewPlane => seen.in_view_plane(way),
            DragAlong::Axis(axis) => seen.along_axis(way, unit(finite("axis", axis)?))?,
            DragAlong::Plane(normal) => seen.in_plane(way, unit(finite("normal", normal)?))?,
        };
        finite("point", anchor + offset)
    }
}

/// Returns the size in the world of a pixel of the observer's picture, in the plane through a point that
/// is parallel to the picture: `depth / distance * height / H`.
///
/// # Errors
/// Returns an error if the point is not in front of the observer.
pub fn pixel_in_world(observer: &ResolvedCamera, point: DVec3) -> Result<f64, SteerError> {
    let ObserverAnchor { depth, distance, .. } = ObserverAnchor::new(point, observer)?;
    let height = observer.viewport().height / f64::from(observer.image().height());
    Ok(depth / distance * height)
}

/// An anchor in the observer's coordinates.
struct ObserverAnchor<'a> {
    observer: &'a ResolvedCamera,
    /// Position of the anchor in the observer's camera coordinates, `(x, y, -z)`.
    position: DVec3,
    /// The anchor's depth z.
    depth: f64,
    distance: f64,
}

impl ObserverAnchor<'_> {
    fn new(anchor: DVec3, observer: &ResolvedCamera) -> Result<ObserverAnchor<'_>, SteerError> {
        finite("anchor", anchor)?;
        let position = finite("anchor", anchor - observer.eye())?;
        let position = observer.basis().to_camera_from_world(position);
        let depth = -position.z;
        if depth > 0.0 {
            return Ok(ObserverAnchor {
                observer,
                position,
                depth,
                distance: observer.viewport().distance,
            });
        }
        Err(SteerError::NotInFront { depth })
    }

    fn in_view_plane(&self, way: DVec2) -> DVec3 {
        let moved = (self.depth / self.distance) * way;
        self.observer.basis().to_world_from_camera(moved.extend(0.0))
    }

    fn along_axis(&self, way: DVec2, axis: DVec3) -> Result<DVec3, SteerError> {
        let a = self.observer.basis().to_camera_from_world(axis);
        let sight = unit(self.position);
        let sine = sight.cross(a).length();
        check_angle(sine.atan2(sight.dot(a).abs()))?;
        // g z / distance: the image of a unit length of the axis, scaled to the anchor's depth.
        let seen = a.truncate() + self.position.truncate() * (a.z / self.depth);
        let length = seen.length();
        // l z / distance, in the world. It would be 0 if the image of the axis were a point, which the
        // least angle excludes.
        let moved = way.dot(seen) / length * (self.depth / self.distance);
        let deeper = 1.0 + moved * a.z / (length * self.depth);
        if deeper * FARTHEST <= 1.0 {
            return Err(SteerError::PastHorizon);
        }
        Ok(moved / (length * deeper) * axis)
    }

    fn in_plane(&self, way: DVec2, normal: DVec3) -> Result<DVec3, SteerError> {
        // From the point of the ray at the anchor's depth, along the ray, to the plane.
        let beside = self.in_view_plane(way);
        let image = self.position.truncate() * (self.distance / self.depth) + way;
        let ray = self.observer.basis().to_world_from_camera(image.extend(-self.distance));
        let sight = unit(ray);
        let steep = normal.dot(sight);
        check_angle(steep.abs().clamp(0.0, 1.0).asin())?;
        let back = normal.dot(beside) / normal.dot(ray);
        let t = self.depth / self.distance - back;
        if t <= 0.0 || t >= FARTHEST * self.depth / self.distance {
            return Err(SteerError::PastHorizon);
        }
        Ok(beside - back * ray)
    }
}

fn check_angle(angle: f64) -> Result<(), SteerError> {
    if angle >= LEAST_ANGLE { Ok(()) } else { Err(SteerError::OnEdge { angle }) }
}

fn finite(field: &'static str, value: DVec3) -> Result<DVec3, SteerError> {
    if value.is_finite() { Ok(value) } else { Err(BasisError::NotFinite { field, value }.into()) }
}

/// Returns the multiple of `step` nearest to a value. For a decimal step such as 0.05, the result is the
/// exact decimal (0.15, not 0.15000000000000002).
///
/// ```
/// use pinhole_core::steering::snapped;
/// assert_eq!(snapped(0.16, 0.05)?, 0.15);
/// assert_eq!(snapped(-40.0, 15.0)?, -45.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if the value is not finite or the step not positive and finite.
pub fn snapped(value: f64, step: f64) -> Result<f64, SteerError> {
    check_finite("value", value)?;
    check_positive("step", step)?;
    let count = (value / step).round();
    if !count.is_finite() || count.abs() > 2_f64.powi(53) {
        // The step is finer than the value's last digit.
        return Ok(value);
    }
    // If the step is 1 / n for a whole n, the result is a quotient of whole numbers, which is rounded
    // once.
    let parts = (1.0 / step).round();
    let is_part = step < 1.0 && parts <= 1e22 && 1.0 / parts == step;
    // Added to 0, a negative zero is 0.
    Ok(if is_part { count / parts } else { count * step } + 0.0)
}

/// Returns the smallest number of the form 1, 2 or 5 times a power of ten that is not less than
/// `at_least`. If `at_least` is the size of a few pixels in the world, the result is a suitable step for
/// snapping.
///
/// ```
/// use pinhole_core::steering::nice_step;
/// assert_eq!(nice_step(0.013)?, 0.02);
/// assert_eq!(nice_step(50.0)?, 50.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if `at_least` is not positive and finite, or there is no such number.
pub fn nice_step(at_least: f64) -> Result<f64, SteerError> {
    check_positive("step", at_least)?;
    let power = at_least.log10().floor() as i32;
    // One power to either side, for rounding of the logarithm.
    let steps =
        (power - 1..=power + 1).flat_map(|k| [1, 2, 5].map(|m| decimal(&format!("{m}e{k}"))));
    steps
        .filter(|step| step.is_finite())
        .find(|step| *step >= at_least)
        .ok_or(SteerError::NotPositive { field: "step", value: f64::INFINITY })
}

/// Returns the decimal with the fewest digits that is within a tenth of a pixel of a value; of several
/// such decimals, the one nearest to the value. `pixel` is the size of a pixel in the world there, see
/// [`pixel_in_world`].
///
/// ```
/// use pinhole_core::steering::rounded_to;
/// assert_eq!(rounded_to(1.2296875, 0.01)?, 1.23);
/// assert_eq!(rounded_to(-0.0004, 0.01)?, 0.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if the value is not finite or the pixel size is not positive and finite.
pub fn rounded_to(value: f64, pixel: f64) -> Result<f64, SteerError> {
    check_finite("value", value)?;
    check_positive("pixel", pixel)?;
    let near = 0.1 * pixel;
    if value.abs() <= near {
        return Ok(0.0);
    }
    // 17 digits distinguish all f64.
    let rounded = (0..17).map(|digits| decimal(&format!("{value:.digits$e}")));
    Ok(rounded.into_iter().find(|x| (x - value).abs() <= near).unwrap_or(value))
}

/// Parses a decimal as the nearest `f64`. The text comes from `format!`, so parsing cannot fail.
fn decimal(text: &str) -> f64 {
    text.parse().unwrap_or(f64::NAN)
}
