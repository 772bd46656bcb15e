//! Animations. The phase of an animation runs from 0, its start, to 1, its end. The state at a phase
//! depends only on the start and the phase, never on the previous frame, so the window and exported frames
//! show the same.

use std::f64::consts::{PI, TAU};

use pinhole_core::steering::SteerError;
use pinhole_core::{Camera, DVec2, Orientation, Pixel, Scene, Selection, Viewport};
use pinhole_exchange::document::Document;
use pinhole_figure::Inspection;

use crate::model::Session;

pinhole_core::texts! {
    /// The kind of an animation: a motion of the camera, of a point on the ray, or of the selected pixel.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Kind[3];
    {
        /// Returns the kind's label in a menu.
        label,
        /// Returns the kind's name on the command line and in lesson files. It contains no spaces.
        name,
        /// Returns the name of the step that the undo history records for the animation's effect.
        step_name,
    }
    /// Up turns once about the view direction.
    SwingUp: "Roll: up turns around view", "swing-up", "roll";
    /// The eye moves once around at.
    Orbit: "Orbit the camera around at", "orbit", "orbit around at";
    /// The view direction turns upwards until it is parallel to up, and then beyond it, so that the picture
    /// flips. A camera given by at moves its eye around at; one given by view keeps its eye.
    OverTheTop: "Tilt past up: the picture flips", "over-the-top", "tilt past up";
    /// A point moves along the selected ray, from the eye to the object that the ray hits.
    Walk: "Walk along the ray", "walk", "walk along the ray";
    /// The pixels are traced one after another, as by a renderer, and the picture appears row by row.
    Scan: "Scan the pixels row by row", "scan", "scan the pixels";
}

/// The t at which [`Kind::Walk`] ends if the ray hits nothing.
const WALK_TO: f64 = 10.0;

/// Number of single steps in an animation with a full turn (15 degrees each) or with a walk along the ray.
const STEPS: u64 = 24;

impl Kind {
    /// Returns the duration at speed 1, in seconds.
    pub fn seconds(self) -> f64 {
        match self {
            Kind::SwingUp | Kind::Orbit | Kind::OverTheTop => 12.0,
            Kind::Walk => 6.0,
            Kind::Scan => 20.0,
        }
    }

    /// Returns true if the animation moves the camera, which is part of the document. Such an animation
    /// ends where it began.
    pub fn moves_camera(self) -> bool {
        matches!(self, Kind::SwingUp | Kind::Orbit | Kind::OverTheTop)
    }

    /// Returns the number of single steps of the whole animation.
    pub fn steps(self, start: &Start) -> u64 {
        if self == Kind::Scan { start.pixels() } else { STEPS }
    }

    /// Returns the phase, from 0 to 1, of frame `k` of `n`. If the animation moves the camera, its end
    /// equals its start, and the last frame is one interval before the end; otherwise the last frame shows
    /// the end.
    pub fn phase_of_frame(self, k: u32, n: u32) -> f64 {
        let intervals = if self.moves_camera() { n } else { n.saturating_sub(1) };
        let phase = |k: f64| k / f64::from(intervals.max(1));
        let phases = [phase(k.into()), phase(f64::from(k) + 0.5)];
        // When the view direction is parallel to up, there is no picture, so use the phase half a frame
        // later.
        let meets = self == Kind::OverTheTop && [0.25, 0.75].contains(&phases[0]);
        phases[usize::from(meets)]
    }
}

/// The state when an animation starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// The parameter t of the point on the selected ray.
    pub ray_point_t: Option<f64>,
    /// The t at which [`Kind::Walk`] ends.
    pub end: f64,
    /// The distance from the eye to the point around which [`Kind::Orbit`] moves the camera; `None` for the
    /// usual point, see [`Camera::orbited`].
    pub orbit: Option<f64>,
}

/// The state of an animation at a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Still {
    /// The camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// The parameter t of the point on the selected ray.
    pub ray_point_t: Option<f64>,
    /// During a scan, the number of pixels that the picture shows so far, counted row by row; `None` if it
    /// shows all.
    pub scanned_pixels: Option<u64>,
}

impl Still {
    /// Copies everything that an animation of this kind changes into the document and the session, and
    /// nothing else.
    pub fn show(&self, kind: Kind, document: &mut Document, session: &mut Session) {
        match kind {
            Kind::SwingUp | Kind::Orbit | Kind::OverTheTop => {
                let camera = &mut document.camera;
                (camera.eye, camera.orientation) = (self.camera.eye, self.camera.orientation);
            }
            Kind::Walk => session.shown.ray_point_t = self.ray_point_t,
            Kind::Scan => {
                (session.shown.selection, session.live.scanned_pixels) =
                    (self.selection, self.scanned_pixels)
            }
        }
    }
}

impl Start {
    /// Creates the start from the current state. The inspection holds the selected ray's first hit, where a
    /// walk along the ray ends.
    pub fn new(
        document: &Document,
        session: &Session,
        inspection: Option<&Inspection>,
        scene: Option<&Scene>,
    ) -> Start {
        Start {
            camera: document.camera,
            selection: session.shown.selection,
            ray_point_t: session.shown.ray_point_t,
            end: ray_point_end(inspection),
            orbit: scene.and_then(|scene| distance_ahead(&document.camera, scene)),
        }
    }

    /// Returns the cameras at all steps of an animation; empty if the animation does not move the
    /// camera.
    pub fn cameras(&self, kind: Kind) -> Vec<Camera> {
        let steps = if kind.moves_camera() { STEPS } else { 0 };
        let phases = (0..steps).map(|k| k as f64 / STEPS as f64);
        phases.filter_map(|phase| Some(self.at(kind, phase).ok()?.camera)).collect()
    }

    fn pixels(&self) -> u64 {
        let image = self.camera.image;
        u64::from(image.width()) * u64::from(image.height())
    }

    /// Returns the state before anything has moved.
    pub fn still(&self) -> Still {
        let Start { camera, selection, ray_point_t, .. } = *self;
        Still { camera, selection, ray_point_t, scanned_pixels: None }
    }

    /// Returns the state at a phase from 0, the start, to 1, the end.
    ///
    /// # Errors
    /// Returns an error if the camera cannot be moved in this way, for example because it has no basis.
    pub fn at(&self, kind: Kind, phase: f64) -> Result<Still, SteerError> {
        let still = self.still();
        // A full turn ends bit for bit at the start.
        let turn = if phase >= 1.0 { 0.0 } else { phase };
        Ok(match kind {
            Kind::SwingUp => Still { camera: self.camera.swung(360.0 * turn)?, ..still },
            Kind::Orbit => Still { camera: self.orbited(TAU * turn)?, ..still },
            Kind::OverTheTop => Still { camera: over_the_top(&self.camera, turn)?, ..still },
            Kind::Walk => Still { ray_point_t: Some(phase * self.end), ..still },
            Kind::Scan => {
                let scanned_pixels = (phase * self.pixels() as f64).round() as u64;
                let width = u64::from(self.camera.image.width());
                let last = scanned_pixels.saturating_sub(1);
                let pixel = Pixel { row: (last / width) as u32, column: (last % width) as u32 };
                let (selection, scanned_pixels) = (Selection::Pixel(pixel), Some(scanned_pixels));
                Still { selection, scanned_pixels, ..still }
            }
        })
    }

    /// Returns the camera after it has orbited by an angle, in radians, around the point that it looks at.
    /// Vectors by which the camera is given keep their lengths.
    fn orbited(&self, yaw: f64) -> Result<Camera, SteerError> {
        let camera = self.camera;
        match (camera.orientation, self.orbit) {
            (Orientation::View { view, up }, Some(distance)) if yaw != 0.0 => {
                let times = distance / view.length();
                let ahead = Orientation::View { view: times * view, up };
                let orbited = Camera { orientation: ahead, ..camera }.orbited(yaw, 0.0)?;
                let view = orbited.view() / times;
                Ok(Camera { orientation: Orientation::View { view, up }, ..orbited })
            }
            (Orientation::Basis(_), Some(distance)) => {
                let viewport = Viewport { distance, ..camera.viewport };
                let orbited = Camera { viewport, ..camera }.orbited(yaw, 0.0)?;
                Ok(Camera { viewport: camera.viewport, ..orbited })
            }
            _ => camera.orbited(yaw, 0.0),
        }
    }
}

/// Returns the camera at a fraction `turn`, from 0 to 1, of its turn over the top. With e, a unit vector
/// perpendicular to up, and an angle b, the backward direction is
///
/// ```text
/// -view = |view| (cos(b) up/|up| + sin(b) e).
/// ```
///
/// b falls from its initial value to 0 at a quarter of the turn, where the view is parallel to up, to -pi
/// at three quarters, and on to the initial value minus 2 pi. The results at these two points and at the
/// end are not rounded.
fn over_the_top(camera: &Camera, turn: f64) -> Result<Camera, SteerError> {
    let (view, up) = (camera.view(), camera.up());
    if let Orientation::Basis(_) = camera.orientation {
        return Err(SteerError::NoUp);
    }
    camera.basis()?;
    if turn == 0.0 {
        return Ok(*camera);
    }
    let (top, length) = (up.normalize(), view.length());
    let across = (-view).reject_from_normalized(top).normalize();
    let first = (-view).dot(across).atan2((-view).dot(top));
    let back = match turn {
        0.25 | 0.75 => {
            // The factor is rounded to few digits, so that its product with an up vector of few digits is
            // exact.
            let factor = length / up.length();
            let digit = 2_f64.powf(factor.log2().floor() - 8.0);
            let factor = digit * (factor / digit).round();
            if turn < 0.5 { factor * up } else { -factor * up }
        }
        _ => {
            let angle = match turn {
                ..0.25 => first * (1.0 - 4.0 * turn),
                ..0.75 => -TAU * (turn - 0.25),
                _ => -PI - 4.0 * (PI - first) * (turn - 0.75),
            };
            length * (angle.cos() * top + angle.sin() * across)
        }
    };
    let moved = match camera.orientation {
        Orientation::At { at, .. } => Camera { eye: at + back, ..*camera },
        Orientation::View { up, .. } => {
            Camera { orientation: Orientation::View { view: -back, up }, ..*camera }
        }
        Orientation::Basis(_) => *camera,
    };
    let is_finite = moved.eye.is_finite() && moved.view().is_finite();
    is_finite.then_some(moved).ok_or(SteerError::OutOfRange)
}

/// Returns how far ahead of the camera, along view, the object is that it looks at: the first hit in the
/// middle of its picture. Returns `None` if nothing is there, and for a camera given by at, which already is
/// the point that it looks at.
pub(super) fn distance_ahead(camera: &Camera, scene: &Scene) -> Option<f64> {
    if camera.orientation.has_at() {
        return None;
    }
    let resolved = camera.resolve().ok()?;
    let middle = resolved.exact_ray_at(DVec2::ZERO).ok()?;
    let distance = scene.first_hit_of(&middle)?.t * camera.viewport.distance;
    distance.is_finite().then_some(distance)
}

/// Returns the t at which a walk along a ray ends: that of its first hit, or `WALK_TO` if it hits nothing.
pub(crate) fn ray_point_end(inspection: Option<&Inspection>) -> f64 {
    inspection.and_then(Inspection::first_hit).map_or(WALK_TO, |hit| hit.t)
}
