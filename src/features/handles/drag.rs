//! The effect of dragging a handle: the pointer's position is converted to a point in the world, and that
//! point to new values of the document.

use pinhole_core::steering::{
    DragAlong, Keep, SteerError, Steered, nice_step, pixel_in_world, rounded_to, snapped,
};
use pinhole_core::{
    Basis, Camera, CameraError, DVec2, DVec3, Object, Orientation, ResolvedCamera, Selection,
    Viewport,
};

use crate::features::handles::state::{Corner, Drag, Handle, HandleValues};
use crate::model::interaction::{STEP_POINTS, VIEW_LINE_REACH};
use crate::model::session::Settings;

/// The drag of a handle, with the observer in whose picture it is dragged and the settings that determine
/// what stays fixed.
#[derive(Clone, Copy, Debug)]
pub struct HandleDrag<'a> {
    /// The handle.
    pub handle: Handle,
    /// The drag.
    pub drag: &'a Drag,
    /// The observer, in whose picture the handle is dragged.
    pub observer: &'a ResolvedCamera,
    /// Screen pixels per point.
    pub scale: f32,
    /// The settings.
    pub settings: &'a Settings,
    /// The quantity that stays fixed when the eye moves.
    pub eye_keeps: Keep,
    /// True if values snap to multiples of a round step.
    pub snaps: bool,
}

/// The result of a drag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dragged {
    /// The changed values.
    pub values: HandleValues,
    /// Unit vector from the centre of a sphere to the point of its surface that is being dragged.
    pub toward: DVec3,
    /// True if the drag also turned the up vector, because the view direction came close to it.
    pub up_went_along: bool,
}

/// Returns the step to which values snap at a point of the world: 1, 2 or 5 times a power of ten, so that a
/// step has a sensible size on the screen.
///
/// # Errors
/// Returns an error if the point is not in front of the observer.
pub fn step_of(observer: &ResolvedCamera, at: DVec3, scale: f32) -> Result<f64, SteerError> {
    nice_step(STEP_POINTS * f64::from(scale) * pixel_in_world(observer, at)?)
}

/// Minimum cosine between the line of sight to the tip of up and u, at which the plane of up and view is seen well enough
/// to drag in it.
const LEAST_FACING: f64 = 0.25;

/// The tangent of 20 degrees, the greatest angle on the screen between a movement and a direction of the plane of up and
/// view at which it counts as one within.
const SIDEWAYS: f64 = 0.364;

impl HandleDrag<'_> {
    /// Returns the result of dragging the handle to the point `uv` of the observer's viewport.
    ///
    /// # Errors
    /// Returns an error if the handle cannot be dragged there.
    pub fn to(&self, uv: DVec2) -> Result<Dragged, SteerError> {
        let Drag { at, begun_at, before, toward, .. } = *self.drag;
        let point = self.observer.dragged(at, begun_at, uv, self.along()?)?;
        match self.parallel_up(point).filter(|_| self.handle == Handle::Up) {
            Some(up) => {
                let values = HandleValues { camera: self.with_up(up)?, ..before };
                Ok(Dragged { values, toward, up_went_along: false })
            }
            None => self.put(point),
        }
    }

    /// Returns the result of moving the handle to a point in the world, or as close to it as possible.
    ///
    /// # Errors
    /// Returns an error if the handle cannot be moved there.
    pub fn put(&self, point: DVec3) -> Result<Dragged, SteerError> {
        let Drag { before: values, at, toward, .. } = *self.drag;
        let mut dragged = Dragged { values, toward, up_went_along: false };
        if point == at {
            return Ok(dragged);
        }
        let camera = match self.handle {
            Handle::Eye | Handle::At => {
                let point = self.readable(at, point, 1.0)?;
                let steered = if self.handle == Handle::Eye {
                    self.led_to(values.camera.with_eye(point, self.eye_keeps), self.eye_keeps)?
                } else {
                    self.led_to(values.camera.with_at(point), Keep::At)?
                };
                dragged.up_went_along = steered.up_went_along;
                steered.camera
            }
            Handle::Up => {
                let (up, length) =
                    ((point - values.camera.eye) / self.drag.length, self.drag.length);
                self.with_up(self.readable(values.camera.up(), up, 1.0 / length)?)?
            }
            Handle::Corner(corner) => self.corner(corner, point)?,
            Handle::Distance => self.distance(point)?,
            Handle::Pixel => {
                dragged.values.selection = self.pixel(point)?;
                return Ok(dragged);
            }
            Handle::Center(_) | Handle::Radius(_) | Handle::Point(_) => {
                return self.object(point, dragged);
            }
        };
        if self.settings.setup.keep_picture {
            let (old, new) = (values.camera.viewport, camera.viewport);
            dragged.values.selection = values.selection.in_another_viewport(old, new);
        }
        dragged.values.camera = camera;
        Ok(dragged)
    }

    /// Returns the line or plane to which the drag is restricted.
    fn along(&self) -> Result<DragAlong, CameraError> {
        let camera = &self.drag.before.camera;
        Ok(match self.handle {
            Handle::Corner(_) | Handle::Distance if self.settings.setup.keep_picture => {
                DragAlong::Axis(self.drag.at - camera.eye)
            }
            Handle::Distance => DragAlong::Axis(camera.basis()?.w),
            Handle::Corner(_) | Handle::Pixel => {
                let Basis { u, v, .. } = camera.basis()?;
                DragAlong::Plane(u.cross(v))
            }
            Handle::Up if self.drag.is_beside_view == Some(true) => {
                DragAlong::Plane(camera.basis()?.u)
            }
            _ => DragAlong::ViewPlane,
        })
    }

    /// Returns true if the pointer, now at `uv`, began to move the tip of up within the plane of up and view: on the screen
    /// along one of them, or the way in which up turns towards view, rather than along u.
    pub fn begins_beside_view(&self, uv: DVec2) -> bool {
        let Drag { at: tip, begun_at, before, .. } = *self.drag;
        let Ok(Basis { u, .. }) = before.camera.basis() else { return false };
        let observer = self.observer;
        let start = observer.project(tip).uv;
        let sight = observer.ray(start).direction.normalize();
        if self.handle != Handle::Up || sight.dot(u).abs() < LEAST_FACING {
            return false;
        }
        let up = (tip - before.camera.eye).normalize();
        let small = 1e-3 * observer.eye().distance(tip);
        let way = uv - begun_at;
        let tangent = |of: DVec3| {
            let seen = observer.project(tip + small * of).uv - start;
            (seen.perp_dot(way) / seen.dot(way)).abs()
        };
        let within = [up, before.camera.view().normalize(), u.cross(up)].map(tangent);
        let nearest = within.into_iter().fold(SIDEWAYS, f64::min);
        nearest < SIDEWAYS && nearest < tangent(u)
    }

    /// Rounds a number to the precision of the pointer or, if snapping is on, to a multiple of a round
    /// step. `per` is the change of the number per unit of length in the world.
    fn number(&self, value: f64, per: f64) -> Result<f64, SteerError> {
        if self.snaps {
            return snapped(value, step_of(self.observer, self.drag.at, self.scale)?);
        }
        rounded_to(value, per * pixel_in_world(self.observer, self.drag.at)?)
    }

    /// Rounds or snaps a number if the drag changed it. A number that did not change is returned bit for
    /// bit.
    fn changed(&self, from: f64, to: f64, per: f64) -> Result<f64, SteerError> {
        if from == to { Ok(to) } else { self.number(to, per) }
    }

    fn readable(&self, from: DVec3, to: DVec3, per: f64) -> Result<DVec3, SteerError> {
        let number = |from: f64, to: f64| self.changed(from, to, per);
        Ok(DVec3::new(number(from.x, to.x)?, number(from.y, to.y)?, number(from.z, to.z)?))
    }

    /// Returns the camera after a drag that set its fields as in `set`, with up or its basis turned as in
    /// `Camera::led_to`. A camera with an up vector is returned as `set`, unchanged, in two cases: if the
    /// settings keep up fixed, or if it would have no basis (the input fields then show the fault).
    fn led_to(&self, set: Camera, keep: Keep) -> Result<Steered, SteerError> {
        let steered = self.drag.before.camera.led_to(set, keep);
        let is_at_fault = matches!(steered, Err(SteerError::Camera(_)));
        if set.orientation.has_up() && (self.settings.preferences.keep_up || is_at_fault) {
            return Ok(Steered { camera: set, up_went_along: false });
        }
        steered
    }

    /// Returns the camera with another up vector. It may be parallel to the view direction; the input
    /// fields then show the fault.
    fn with_up(&self, up: DVec3) -> Result<Camera, SteerError> {
        let camera = self.drag.before.camera;
        let orientation = match camera.orientation {
            Orientation::At { at, .. } => Orientation::At { at, up },
            Orientation::View { view, .. } => Orientation::View { view, up },
            Orientation::Basis(_) => return Err(SteerError::NoUp),
        };
        Ok(Camera { orientation, ..camera })
    }

    /// Returns an up vector parallel to the view direction if the observer sees the tip of up near the line
    /// of view; otherwise `None`. No hand would find such a vector exactly. It is the view direction times a
    /// power of two, because other multiples would be rounded and then not be parallel.
    fn parallel_up(&self, tip: DVec3) -> Option<DVec3> {
        let (camera, observer) = (self.drag.before.camera, self.observer);
        let view = camera.view();
        let (along, uv) = (self.drag.length * view, observer.project(tip).uv);
        // The foot, on the line of view, of its common perpendicular with the observer's ray to the tip.
        let ray = observer.ray(uv);
        let normal = along.cross(ray.direction);
        let share = (ray.origin - camera.eye).cross(ray.direction).dot(normal) / normal.dot(normal);
        let seen = observer.project(camera.eye + share * along);
        let pixels = f64::from(observer.image().height()) / observer.viewport().height;
        let is_near = pixels * seen.uv.distance(uv) < VIEW_LINE_REACH * f64::from(self.scale);
        let multiple = share.signum() * 2.0_f64.powi(share.abs().log2().round() as i32);
        (share.is_normal() && seen.depth > 0.0 && is_near).then_some(multiple * view)
    }

    /// Returns the camera with a corner of its viewport moved to a point, or as close to it as possible;
    /// the viewport's centre stays. If the pixels keep their shape, the corner moves along the viewport's
    /// diagonal, to the point nearest to the pointer. An invalid size is not corrected, so that the input
    /// fields show the fault.
    fn corner(&self, corner: Corner, point: DVec3) -> Result<Camera, SteerError> {
        if self.settings.setup.keep_picture {
            return self.distance(point);
        }
        let camera = self.drag.before.camera;
        let old = camera.viewport;
        let Basis { u, v, .. } = camera.basis()?;
        let p = point - camera.eye;
        let half = corner.signs() * DVec2::new(p.dot(u), p.dot(v));
        let sized = |width, height| Viewport { width, height, ..old };
        let free = sized(2.0 * half.x, 2.0 * half.y);
        let on_diagonal = || {
            // With r = width / height, the point (r y, y) of the diagonal that is nearest to (x, y0) has
            // y = (r x + y0) / (r^2 + 1).
            let ratio = old.width / old.height;
            let height = 2.0 * (ratio * half.x + half.y) / (ratio * ratio + 1.0);
            Some(sized(ratio * height, height)).filter(|viewport| viewport.check().is_ok())
        };
        let viewport = match self.settings.preferences.keep_pixel_shape.then(on_diagonal).flatten()
        {
            Some(Viewport { width, height, .. }) => {
                let ratio = width / height;
                let width = self.changed(old.width, width, 2.0)?;
                sized(width, width / ratio)
            }
            None => sized(
                self.changed(old.width, free.width, 2.0)?,
                self.changed(old.height, free.height, 2.0)?,
            ),
        };
        Ok(Camera { viewport, ..camera })
    }

    /// Returns the camera with its viewport moved along w, so that the viewport's plane passes through a
    /// point.
    fn distance(&self, point: DVec3) -> Result<Camera, SteerError> {
        let camera = self.drag.before.camera;
        let distance = self.number((camera.eye - point).dot(camera.basis()?.w), 1.0)?;
        let set = Camera { viewport: Viewport { distance, ..camera.viewport }, ..camera };
        // An invalid distance is set without keeping the picture, so that the input fields show the fault.
        let scaled = self.settings.setup.keep_picture.then(|| camera.scaled_picture(distance).ok());
        Ok(scaled.flatten().unwrap_or(set))
    }

    /// Selects the pixel nearest to a point of the viewport.
    fn pixel(&self, point: DVec3) -> Result<Selection, CameraError> {
        let HandleValues { camera, selection, .. } = self.drag.before;
        let resolved = camera.resolve()?;
        let half = 0.5 * DVec2::new(camera.viewport.width, camera.viewport.height);
        let position = resolved.pixel_of_uv(resolved.project(point).uv.clamp(-half, half));
        Ok(position.map_or(selection, |position| Selection::Pixel(position.pixel)))
    }

    /// Returns the result of moving a sphere or a plane to a point, or of changing a sphere's radius.
    fn object(&self, point: DVec3, mut dragged: Dragged) -> Result<Dragged, SteerError> {
        let at = self.drag.at;
        match (&mut dragged.values.object, self.handle) {
            (Some((_, Object::Sphere(sphere))), Handle::Radius(_)) => {
                let out = point - sphere.center;
                sphere.radius = self.number(out.length(), 1.0)?;
                dragged.toward = out.try_normalize().unwrap_or(dragged.toward);
            }
            (Some((_, Object::Sphere(sphere))), _) => {
                sphere.center = self.readable(at, point, 1.0)?
            }
            (Some((_, Object::Plane(plane))), _) => plane.point = self.readable(at, point, 1.0)?,
            (None, _) => {}
        }
        Ok(dragged)
    }
}

#[cfg(test)]
mod tests {
    use crate::model::session::{Preferences, Setup};
    use pinhole_core::Sphere;

    use super::*;
    use crate::features::handles::state::Grabbed;

    /// A camera whose viewport is twice as wide as it is high.
    const WIDE: Camera = Camera {
        viewport: Viewport { width: 2.0, height: 1.0, distance: 1.0 },
        ..Camera::CANONICAL
    };

    const TOP_RIGHT: Handle = Handle::Corner(Corner { is_right: true, is_top: true });

    /// Drags a handle from one point to another. `keeps` tells whether the pixels keep their shape, and
    /// whether the picture stays the same.
    fn put(
        camera: Camera,
        handle: Handle,
        [at, to]: [DVec3; 2],
        keeps: [bool; 2],
    ) -> Result<Dragged, SteerError> {
        let observer = Camera {
            eye: DVec3::new(3.0, 2.0, 4.0),
            orientation: Orientation::At { at: DVec3::new(0.0, 0.0, -1.0), up: DVec3::Y },
            ..Camera::CANONICAL
        };
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
        let object = Some((0, Object::Sphere(sphere)));
        let before = HandleValues { camera, selection: Selection::Uv(DVec2::ZERO), object };
        let (grabbed, begun_at) = (Grabbed::Handle(handle), DVec2::ZERO);
        let (length, toward, is_beside_view) = (1.0, DVec3::X, None);
        let drag = Drag { grabbed, before, begun_at, at, length, toward, is_beside_view };
        let [keep_pixel_shape, keep_picture] = keeps;
        let drag = HandleDrag {
            handle,
            drag: &drag,
            observer: &observer.resolve().expect("an observer"),
            scale: 1.0,
            settings: &Settings {
                setup: Setup { keep_picture, ..Setup::default() },
                preferences: Preferences { keep_pixel_shape, ..Preferences::default() },
            },
            eye_keeps: Keep::At,
            snaps: false,
        };
        drag.put(to)
    }

    /// Drags the top right corner of [`WIDE`] in the plane of its viewport; returns the new viewport.
    fn corner(to: [f64; 2], keeps: [bool; 2]) -> Viewport {
        let [from, to] = [[1.0, 0.5], to].map(|[x, y]| DVec3::new(x, y, -1.0));
        put(WIDE, TOP_RIGHT, [from, to], keeps).expect("a drag").values.camera.viewport
    }

    #[track_caller]
    fn assert_near(a: f64, b: f64) {
        assert!((a - b).abs() < 0.02, "{a} is not near {b}");
    }

    #[test]
    fn a_free_corner_follows_the_pointer() {
        let viewport = corner([1.5, 0.75], [false, false]);
        assert_near(viewport.width, 3.0);
        assert_near(viewport.height, 1.5);
        assert_eq!(viewport.distance, 1.0);
    }

    #[test]
    fn a_corner_that_keeps_the_pixels_shape_stays_on_the_diagonal() {
        // The nearest point of the diagonal to (1.5, 0.5) is (1.4, 0.7).
        let viewport = corner([1.5, 0.5], [true, false]);
        assert_near(viewport.width, 2.8);
        assert_eq!(viewport.width, 2.0 * viewport.height);
        // Each corner has its own diagonal.
        let lower_left = Handle::Corner(Corner { is_right: false, is_top: false });
        let ends = [DVec3::new(-1.0, -0.5, -1.0), DVec3::new(-1.5, -0.5, -1.0)];
        let dragged = put(WIDE, lower_left, ends, [true, false]).expect("a drag");
        assert_near(dragged.values.camera.viewport.height, 1.4);
    }

    #[test]
    fn an_inverted_corner_is_set_as_it_is() {
        for keeps_shape in [true, false] {
            let viewport = corner([-0.5, -0.2], [keeps_shape, false]);
            assert_near(viewport.width, -1.0);
            assert_near(viewport.height, -0.4);
            assert!(viewport.check().is_err());
        }
    }

    #[test]
    fn a_distance_scales_the_viewport_only_if_the_picture_is_kept() {
        let distance = |z: f64, keep_picture: bool| {
            let ends = [-1.0, z].map(|z| DVec3::new(0.0, -0.5, z));
            let dragged = put(WIDE, Handle::Distance, ends, [true, keep_picture]);
            dragged.expect("a drag").values.camera.viewport
        };
        let free = distance(-2.0, false);
        assert_near(free.distance, 2.0);
        assert_eq!((free.width, free.height), (2.0, 1.0));
        let kept = distance(-2.0, true);
        assert_near(kept.width, 4.0);
        assert_near(kept.height, 2.0);
        // Behind the eye.
        for keep_picture in [true, false] {
            let viewport = distance(1.0, keep_picture);
            assert_near(viewport.distance, -1.0);
            assert_eq!((viewport.width, viewport.height), (2.0, 1.0));
        }
        // With the picture kept, a corner changes the distance, too.
        let kept = corner([2.0, 1.0], [true, true]);
        assert_eq!(kept.distance, 1.0);
    }

    #[test]
    fn a_radius_is_the_distance_from_the_centre() {
        let at = DVec3::new(1.0, 0.0, -5.0);
        let radius = |to: DVec3| {
            let dragged = put(WIDE, Handle::Radius(0), [at, to], [true, false]).expect("a drag");
            match dragged.values.object {
                Some((_, Object::Sphere(sphere))) => (sphere.radius, dragged.toward),
                other => panic!("{other:?}"),
            }
        };
        let (length, toward) = radius(DVec3::new(0.0, 2.0, -5.0));
        assert_near(length, 2.0);
        assert_eq!(toward, DVec3::Y);
        assert_eq!(radius(DVec3::new(0.0, 0.0, -5.0)), (0.0, DVec3::X), "in the centre");
    }

    #[test]
    fn without_a_basis_only_objects_can_be_resized() {
        let orientation = Orientation::At { at: WIDE.eye, up: DVec3::Y };
        let camera = Camera { orientation, ..WIDE };
        let ends = [DVec3::new(1.0, 0.5, -1.0), DVec3::new(1.5, 0.75, -1.0)];
        for handle in [TOP_RIGHT, Handle::Distance, Handle::Pixel] {
            let dragged = put(camera, handle, ends, [true, false]);
            assert!(matches!(dragged, Err(SteerError::Camera(_))), "{handle:?}: {dragged:?}");
        }
        assert!(put(camera, Handle::Radius(0), ends, [true, false]).is_ok());
    }
}
