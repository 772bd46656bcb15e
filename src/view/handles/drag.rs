//! Drags: from the pointer to a point of the world, and from there to the values that the handle
//! changes. They are always computed from the values at the start of the drag, so that dragging
//! back to the start changes nothing.

use std::f64::consts::PI;

use pinhole_core::steering::{
    CornerKeeps, DistanceKeeps, Drag, DragAlong, Keep, SteerError, Steered, ViewportCorner,
    nice_step, pixel_in_world, rounded_to, snapped,
};
use pinhole_core::{Camera, DVec2, DVec3, Orientation, ResolvedCamera, Viewport};

use super::magnet;
use super::{HandleValues, Solid};
use crate::model::session::hand::{Along, Axis, Grasp, Handle};

/// The state at the start of a drag.
#[derive(Clone, Copy, Debug)]
pub struct DragStart {
    /// The values that the handle changes.
    pub before: HandleValues,
    /// The camera at the start, if it had a basis.
    pub resolved: Option<ResolvedCamera>,
    /// The grasp of the handle.
    pub grasp: Grasp,
    /// Position of the handle in the world.
    pub at: DVec3,
    /// Position in the observer's viewport where the pointer took the handle.
    pub begun_at: DVec2,
}

/// The options of a drag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DragOptions {
    /// The direction or plane of the drag.
    pub along: Along,
    /// True if values snap to multiples of a round step.
    pub snaps: bool,
    /// The quantity that stays when the eye moves.
    pub eye: Keep,
    /// True if up stays as it is given, also where a moved eye or at brings the view near it.
    pub keeps_up: bool,
    /// The quantity that stays when a corner of the viewport moves.
    pub corner: CornerKeeps,
    /// The quantity that stays when the viewport's distance changes.
    pub distance: DistanceKeeps,
}

/// The result of a drag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dragged {
    /// The changed values.
    pub part: HandleValues,
    /// The current grasp of the handle.
    pub grasp: Grasp,
    /// True if up was turned, too, because the view came near it.
    pub up_went_along: bool,
    /// The step that values were snapped to.
    pub step: Option<f64>,
    /// Angle in degrees by which the camera was rolled, if it was.
    pub rolled: Option<f64>,
}

/// A drag in progress, with its observer and options.
#[derive(Clone, Copy, Debug)]
pub struct HandleDrag<'a> {
    /// The start of the drag.
    pub start: &'a DragStart,
    /// The observer.
    pub observer: &'a ResolvedCamera,
    /// Dots per point.
    pub scale: f32,
    /// The options.
    pub options: DragOptions,
}

/// Least length, in points, of a step to which values snap and by which keys move a handle.
const STEP_POINTS: f64 = 10.0;

/// Step to which angles snap, in degrees.
const STEP_DEGREES: f64 = 15.0;

/// Returns the step for values at a point of the world: 1, 2 or 5 times a power of ten.
pub fn step_of(observer: &ResolvedCamera, at: DVec3, scale: f32) -> Option<f64> {
    nice_step(STEP_POINTS * f64::from(scale) * pixel_in_world(observer, at).ok()?).ok()
}

/// Returns the position of the tip of v after a roll of the camera by `degrees`.
pub fn turned_by(start: &DragStart, degrees: f64) -> Option<DVec3> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (eye, basis) = (start.before.camera.eye, start.resolved?);
    Some(eye + start.grasp.length * (cos * basis.basis().v - sin * basis.basis().u))
}

/// Returns the vector whose arrow, drawn `length` times as long, goes from `base` to `tip`.
fn of_tip(tip: DVec3, base: DVec3, length: f64) -> DVec3 {
    (tip - base) / length
}

impl HandleDrag<'_> {
    /// Returns the result of a drag to `uv` in the observer's viewport.
    ///
    /// # Errors
    /// Returns the reason, in words, if the handle cannot be dragged there.
    pub fn to(&self, uv: DVec2) -> Result<Dragged, String> {
        let DragStart { at, begun_at, before, .. } = *self.start;
        // An axis that is held, or round steps, lead past the magnet.
        let is_free = self.options.along == Along::View && !self.options.snaps;
        if let Some(camera) = is_free.then(|| magnet::drawn_on(self, uv)).flatten() {
            let part = HandleValues { camera, ..before };
            return Ok(Dragged { part, ..self.unchanged() });
        }
        let drag = Drag { anchor: at, begun_at };
        let point = drag.to(self.observer, uv, self.along()?).map_err(|e| e.to_string())?;
        self.put(point)
    }

    /// Returns the result of moving the handle to a point of the world, or as near to it as it can
    /// be.
    ///
    /// # Errors
    /// Returns the reason, in words, if it cannot be there.
    pub fn put(&self, point: DVec3) -> Result<Dragged, String> {
        let DragStart { before, grasp, at, .. } = *self.start;
        let unchanged = self.unchanged();
        if point == at {
            return Ok(unchanged);
        }
        let camera =
            |camera: Camera| Dragged { part: HandleValues { camera, ..before }, ..unchanged };
        let steered = match grasp.handle {
            Handle::Eye => self.eye(self.readable(at, point, 1.0)?),
            Handle::At => self.look_at(self.readable(at, point, 1.0)?),
            Handle::Up => self.up(point).map(|camera| (camera, false)),
            Handle::Roll => {
                let (rolled, degrees) = self.roll(point)?;
                let rolled = Dragged { rolled: Some(degrees), ..camera(rolled) };
                return Ok(self.snapped_by(rolled));
            }
            Handle::Dolly => self.dolly(point).map(|camera| (camera, false)),
            Handle::Corner(corner) => self.corner(corner, point).map(|camera| (camera, false)),
            Handle::Distance => self.distance(point).map(|camera| (camera, false)),
            Handle::Pixel => return Ok(Dragged { part: self.pixel(point), ..unchanged }),
            _ => return self.solid(point).map(|pulled| self.snapped_by(pulled)),
        };
        let (after, up_went_along) = steered?;
        let mut pulled = Dragged { up_went_along, ..camera(after) };
        if self.options.distance == DistanceKeeps::Picture {
            let (old, new) = (before.camera.viewport, after.viewport);
            pulled.part.selection = before.selection.in_another_viewport(old, new);
        }
        Ok(self.snapped_by(pulled))
    }

    fn unchanged(&self) -> Dragged {
        let DragStart { before: part, grasp, .. } = *self.start;
        Dragged { part, grasp, up_went_along: false, step: None, rolled: None }
    }

    fn snapped_by(&self, pulled: Dragged) -> Dragged {
        Dragged { step: self.step().filter(|_| self.options.snaps), ..pulled }
    }

    /// Returns the step to which this drag snaps, in the unit of the changed value.
    fn step(&self) -> Option<f64> {
        match self.start.grasp.handle {
            Handle::Roll => Some(STEP_DEGREES),
            Handle::Pixel => None,
            _ => step_of(self.observer, self.start.at, self.scale),
        }
    }

    /// Returns the direction or plane of the drag.
    fn along(&self) -> Result<DragAlong, String> {
        let no_basis = || "the camera has no basis".to_owned();
        let DragStart { resolved, grasp, at, before, .. } = self.start;
        let axis = |axis: Axis| axis.direction(resolved.as_ref()).ok_or_else(no_basis);
        if grasp.handle.is_free() {
            return Ok(match self.options.along {
                Along::View => DragAlong::ViewPlane,
                Along::Axis(one) => DragAlong::Axis(axis(one)?),
                Along::Without(one) => {
                    let [a, b] = one.others();
                    DragAlong::Plane(axis(a)?, axis(b)?)
                }
            });
        }
        let (u, v, w) = (axis(Axis::U)?, axis(Axis::V)?, axis(Axis::W)?);
        let keeps_picture = self.options.distance == DistanceKeeps::Picture;
        Ok(match grasp.handle {
            Handle::Corner(_) | Handle::Distance if keeps_picture => {
                DragAlong::Axis(*at - before.camera.eye)
            }
            Handle::Distance | Handle::Dolly => DragAlong::Axis(w),
            Handle::Corner(_) | Handle::Pixel if self.options.along == Along::Axis(Axis::U) => {
                DragAlong::Axis(u)
            }
            Handle::Corner(_) | Handle::Pixel if self.options.along == Along::Axis(Axis::V) => {
                DragAlong::Axis(v)
            }
            _ => DragAlong::Plane(u, v),
        })
    }

    /// Returns the size of a pixel of the picture at the handle, in world units.
    fn pixel_size(&self) -> Result<f64, String> {
        pixel_in_world(self.observer, self.start.at).map_err(|e| e.to_string())
    }

    /// Rounds a number to the digits that a hand can set, or snaps it; `per` is its change per
    /// world unit.
    fn number(&self, value: f64, per: f64) -> Result<f64, String> {
        let number = match self.step().filter(|_| self.options.snaps) {
            Some(step) => snapped(value, step),
            None => rounded_to(value, per * self.pixel_size()?),
        };
        number.map_err(|e| e.to_string())
    }

    /// Rounds or snaps a point or vector. Coordinates that the drag did not change stay the same to
    /// the bit. Along the camera's axes the displacement is snapped, not the end point.
    fn readable(&self, from: DVec3, to: DVec3, per: f64) -> Result<DVec3, String> {
        let camera_axes: &[Axis] = match self.options.along {
            Along::Axis(Axis::U) => &[Axis::U],
            Along::Axis(Axis::V) => &[Axis::V],
            Along::Axis(Axis::W) => &[Axis::W],
            Along::Without(axis @ (Axis::U | Axis::V | Axis::W)) => &axis.others(),
            _ => &[],
        };
        if self.options.snaps && !camera_axes.is_empty() {
            let mut point = from;
            for axis in camera_axes {
                let direction = axis.direction(self.start.resolved.as_ref()).unwrap_or_default();
                point += self.number((to - from).dot(direction), per)? * direction;
            }
            return Ok(point);
        }
        let number = |from: f64, to: f64| if from == to { Ok(to) } else { self.number(to, per) };
        Ok(DVec3::new(number(from.x, to.x)?, number(from.y, to.y)?, number(from.z, to.z)?))
    }

    fn eye(&self, point: DVec3) -> Result<(Camera, bool), String> {
        let camera = self.start.before.camera;
        let by = point - camera.eye;
        let orientation = match (camera.orientation, self.options.eye) {
            (Orientation::At { at, up }, Keep::View) => Orientation::At { at: at + by, up },
            (Orientation::View { view, up }, Keep::At) => Orientation::View { view: view - by, up },
            (given, _) => given,
        };
        let set = Camera { eye: point, orientation, ..camera };
        self.aimed(set, camera.with_eye_at(point, self.options.eye))
    }

    fn look_at(&self, point: DVec3) -> Result<(Camera, bool), String> {
        let camera = self.start.before.camera;
        let orientation = match camera.orientation {
            Orientation::At { up, .. } => Orientation::At { at: point, up },
            Orientation::View { up, .. } => Orientation::View { view: point - camera.eye, up },
            basis => basis,
        };
        self.aimed(Camera { orientation, ..camera }, camera.with_at(point))
    }

    /// Returns the steered camera, and whether up was turned, too. A camera without a basis is replaced
    /// by `set`, whose fields then show the fault; with up kept, it is `set` in any case.
    fn aimed(
        &self,
        set: Camera,
        steered: Result<Steered, SteerError>,
    ) -> Result<(Camera, bool), String> {
        let has_up = !matches!(set.orientation, Orientation::Basis(_));
        match steered {
            _ if has_up && self.options.keeps_up => Ok((set, false)),
            Ok(steered) => Ok((steered.camera, steered.up_went_along)),
            Err(SteerError::Camera(_)) if has_up => Ok((set, false)),
            Err(reason) => Err(reason.to_string()),
        }
    }

    /// Returns the camera with up as it is dragged, even if it is parallel to the view: the fields
    /// then show the fault.
    fn up(&self, tip: DVec3) -> Result<Camera, String> {
        let (camera, length) = (self.start.before.camera, self.start.grasp.length);
        let new = of_tip(tip, camera.eye, length);
        let new = self.readable(camera.up(), new, 1.0 / length)?;
        let orientation = match camera.orientation {
            Orientation::At { at, .. } => Orientation::At { at, up: new },
            Orientation::View { view, .. } => Orientation::View { view, up: new },
            Orientation::Basis(_) => return Err(SteerError::NoUp.to_string()),
        };
        Ok(Camera { orientation, ..camera })
    }

    /// Returns the camera rolled until v points to the tip, and the angle in degrees.
    fn roll(&self, tip: DVec3) -> Result<(Camera, f64), String> {
        let DragStart { before, resolved, grasp, .. } = self.start;
        let basis = *resolved.as_ref().ok_or("the camera has no basis")?.basis();
        let along = tip - before.camera.eye;
        let degrees = (-along.dot(basis.u)).atan2(along.dot(basis.v)).to_degrees();
        let per = 180.0 / (PI * grasp.length);
        let degrees = self.number(degrees, per)?;
        Ok((before.camera.swung(degrees).map_err(|e| e.to_string())?, degrees))
    }

    /// Returns the camera moved along w by as much as the tip of w.
    fn dolly(&self, tip: DVec3) -> Result<Camera, String> {
        let DragStart { before: HandleValues { camera, .. }, resolved, at, .. } = self.start;
        let w = resolved.as_ref().ok_or("the camera has no basis")?.basis().w;
        let back = self.number((tip - *at).dot(w), 1.0)?;
        let reach = camera.pivot().map_err(|e| e.to_string())?.distance(camera.eye);
        let forward = match camera.orientation {
            Orientation::At { .. } if reach + back <= 0.0 => {
                return Err("the eye is moved towards at and never reaches it".to_owned());
            }
            Orientation::At { .. } => (reach / (reach + back)).ln(),
            _ => -back / reach,
        };
        camera.dollied(forward).map_err(|e| e.to_string())
    }

    fn corner(&self, corner: ViewportCorner, point: DVec3) -> Result<Camera, String> {
        if self.options.distance == DistanceKeeps::Picture {
            return self.distance(point);
        }
        let camera = self.start.before.camera;
        let (ratio, viewport) =
            match camera.with_viewport_corner(corner, point, self.options.corner) {
                Ok(moved) => (moved.viewport.width / moved.viewport.height, moved.viewport),
                Err(SteerError::Camera(_)) => {
                    let resolved = self.start.resolved.ok_or("the camera has no basis")?;
                    let size = 2.0 * corner.signs() * resolved.project(point).uv;
                    let fallen = Viewport { width: size.x, height: size.y, ..camera.viewport };
                    (f64::NAN, fallen)
                }
                Err(reason) => return Err(reason.to_string()),
            };
        let read =
            |before: f64, now: f64| if before == now { Ok(now) } else { self.number(now, 2.0) };
        let width = read(camera.viewport.width, viewport.width)?;
        let height = if self.options.corner == CornerKeeps::Nothing || ratio.is_nan() {
            read(camera.viewport.height, viewport.height)?
        } else {
            width / ratio
        };
        Ok(Camera { viewport: Viewport { width, height, ..viewport }, ..camera })
    }

    fn distance(&self, point: DVec3) -> Result<Camera, String> {
        let camera = self.start.before.camera;
        let distance = match camera.with_viewport_through(point, DistanceKeeps::Size) {
            Ok(moved) => moved.viewport.distance,
            Err(_) => {
                let w = self.start.resolved.ok_or("the camera has no basis")?.basis().w;
                (camera.eye - point).dot(w)
            }
        };
        let distance = self.number(distance, 1.0)?;
        let set = Camera { viewport: Viewport { distance, ..camera.viewport }, ..camera };
        Ok(match self.options.distance {
            DistanceKeeps::Size => set,
            // An invalid distance is reported as it is without the lock.
            DistanceKeeps::Picture => camera.scaled_picture(distance).unwrap_or(set),
        })
    }

    /// Selects the pixel nearest to a point of the viewport.
    fn pixel(&self, point: DVec3) -> HandleValues {
        let DragStart { before, resolved, .. } = self.start;
        let position = resolved.as_ref().and_then(|resolved| {
            let half = 0.5 * DVec2::new(resolved.viewport().width, resolved.viewport().height);
            resolved.pixel_of_uv(resolved.project(point).uv.clamp(-half, half))
        });
        match position {
            Some(position) => HandleValues {
                selection: pinhole_core::Selection::Pixel(position.pixel),
                ..*before
            },
            None => *before,
        }
    }

    /// Moves or changes a sphere or a plane.
    fn solid(&self, point: DVec3) -> Result<Dragged, String> {
        let DragStart { before, grasp, at, .. } = *self.start;
        let mut now = self.unchanged();
        let Some((k, solid)) = before.object else { return Ok(now) };
        let solid = match (solid, grasp.handle) {
            (Solid::Sphere(mut sphere), Handle::Radius(_)) => {
                let out = point - sphere.center;
                let radius = sphere.with_surface_through(point).map_or(0.0, |moved| moved.radius);
                sphere.radius = self.number(radius, 1.0)?;
                now.grasp.toward = out.try_normalize().unwrap_or(grasp.toward);
                Solid::Sphere(sphere)
            }
            (Solid::Sphere(mut sphere), _) => {
                sphere.center = self.readable(at, point, 1.0)?;
                Solid::Sphere(sphere)
            }
            (Solid::Plane(mut plane), Handle::Normal(_)) => {
                let normal = of_tip(point, plane.point, grasp.length);
                plane.normal = self.readable(plane.normal, normal, 1.0 / grasp.length)?;
                Solid::Plane(plane)
            }
            (Solid::Plane(mut plane), _) => {
                plane.point = self.readable(at, point, 1.0)?;
                Solid::Plane(plane)
            }
        };
        now.part.object = Some((k, solid));
        Ok(now)
    }
}
