//! Animations. What is shown is a function of how it was at the start and of the phase alone: no
//! frame depends on the one before it, so that the window and exported frames show the same.

mod player;

use std::fmt;

use pinhole_core::steering::SteerError;
use pinhole_core::{Camera, Pixel};

pub use player::Player;

use crate::derive::Derived;
use crate::document::Document;
use crate::inspection::Inspection;
use crate::session::{Selection, Session};

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Up turns once round the view.
    SwingUp,
    /// The eye goes once round at.
    Orbit,
    /// A point runs along the selected ray, from the eye to what the ray hits.
    Walk,
    /// Ray after ray goes out, as a renderer sends them, and the picture appears.
    Scan,
}

/// The t that [`Kind::Walk`] runs to where the ray hits nothing.
const WALK_TO: f64 = 10.0;

/// So many steps has a turn, or a way along the ray: 15 degrees each.
const STEPS: u64 = 24;

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 4] = [Kind::SwingUp, Kind::Orbit, Kind::Walk, Kind::Scan];

    /// What a menu says.
    pub fn label(self) -> &'static str {
        match self {
            Kind::SwingUp => "Swing up round the view",
            Kind::Orbit => "Orbit the camera round at",
            Kind::Walk => "Run t along the ray",
            Kind::Scan => "Scan the pixels row by row",
        }
    }

    /// In one word, as the command line and lesson files have it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::SwingUp => "swing-up",
            Kind::Orbit => "orbit",
            Kind::Walk => "walk",
            Kind::Scan => "scan",
        }
    }

    /// The one of this [name](Kind::name).
    pub fn from_name(name: &str) -> Option<Kind> {
        Kind::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// What the step of the history is called that keeps where it stopped.
    pub fn step_name(self) -> &'static str {
        match self {
            Kind::SwingUp => "swing up round the view",
            Kind::Orbit => "orbit round at",
            Kind::Walk => "run along the ray",
            Kind::Scan => "scan the pixels",
        }
    }

    /// How long all of it takes at speed 1, in seconds.
    pub fn seconds(self) -> f64 {
        match self {
            Kind::SwingUp | Kind::Orbit => 12.0,
            Kind::Walk => 6.0,
            Kind::Scan => 20.0,
        }
    }

    /// Whether it ends where it began.
    pub fn is_round(self) -> bool {
        matches!(self, Kind::SwingUp | Kind::Orbit)
    }

    /// Whether it changes the camera, which is a part of the document.
    pub fn moves_camera(self) -> bool {
        self.is_round()
    }

    /// In how many single steps one goes through all of it.
    pub fn steps(self, start: &Start) -> u64 {
        if self == Kind::Scan { start.pixels() } else { STEPS }
    }

    /// The phase of frame `k` of `n`: the last frame of a turn is the one before the first, of the
    /// others it is the end.
    pub fn phase_of_frame(self, k: u32, n: u32) -> f64 {
        let intervals = if self.is_round() { n } else { n.saturating_sub(1) };
        f64::from(k) / f64::from(intervals.max(1))
    }
}

/// How it was at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// How far one had walked along it.
    pub walked: Option<f64>,
    /// To which t [`Kind::Walk`] runs.
    pub end: f64,
}

/// How it is at a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Still {
    /// The camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// How far one has walked along it.
    pub walked: Option<f64>,
    /// How many pixels the picture shows so far, row by row; all without a number.
    pub scanned: Option<u64>,
}

/// Why something cannot move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlayError {
    /// Up cannot be swung.
    Swing(SteerError),
    /// The camera cannot orbit.
    Orbit(SteerError),
}

impl fmt::Display for PlayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlayError::Swing(error) => error.fmt(f),
            PlayError::Orbit(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for PlayError {}

impl Still {
    /// Sets what such an animation moves, and leaves alone what it does not.
    pub fn show(&self, kind: Kind, document: &mut Document, session: &mut Session) {
        match kind {
            Kind::SwingUp | Kind::Orbit => {
                let camera = &mut document.camera;
                (camera.eye, camera.orientation) = (self.camera.eye, self.camera.orientation);
            }
            Kind::Walk => session.walked = self.walked,
            Kind::Scan => (session.selection, session.scanned) = (self.selection, self.scanned),
        }
    }
}

impl Start {
    /// How it is now. `derived` is what was made of it.
    pub fn of(document: &Document, session: &Session, derived: &Derived) -> Start {
        Start {
            camera: document.camera,
            selection: session.selection,
            walked: session.walked,
            end: walk_end(derived.inspection.as_deref()),
        }
    }

    /// The cameras that an animation shows, a step from each to the next; none where it moves none.
    pub fn cameras(&self, kind: Kind) -> Vec<Camera> {
        let steps = if kind.moves_camera() { STEPS } else { 0 };
        let phases = (0..steps).map(|k| k as f64 / STEPS as f64);
        phases.filter_map(|phase| Some(self.at(kind, phase).ok()?.camera)).collect()
    }

    fn pixels(&self) -> u64 {
        let image = self.camera.image;
        u64::from(image.width()) * u64::from(image.height())
    }

    /// Nothing has moved yet.
    pub fn still(&self) -> Still {
        let Start { camera, selection, walked, .. } = *self;
        Still { camera, selection, walked, scanned: None }
    }

    /// How it is at a phase, from 0, the start, to 1, the end.
    ///
    /// # Errors
    /// Where the camera cannot be moved so; it has no basis, say.
    pub fn at(&self, kind: Kind, phase: f64) -> Result<Still, PlayError> {
        let still = self.still();
        // Once round is the start, to the bit.
        let turn = if phase >= 1.0 { 0.0 } else { phase };
        Ok(match kind {
            Kind::SwingUp => {
                let camera = self.camera.swung(360.0 * turn).map_err(PlayError::Swing)?;
                Still { camera, ..still }
            }
            Kind::Orbit => {
                let yaw = std::f64::consts::TAU * turn;
                Still { camera: self.camera.orbited(yaw, 0.0).map_err(PlayError::Orbit)?, ..still }
            }
            Kind::Walk => Still { walked: Some(phase * self.end), ..still },
            Kind::Scan => {
                let scanned = (phase * self.pixels() as f64).round() as u64;
                let width = u64::from(self.camera.image.width());
                let last = scanned.saturating_sub(1);
                let pixel = Pixel { row: (last / width) as u32, column: (last % width) as u32 };
                Still { selection: Selection::Pixel(pixel), scanned: Some(scanned), ..still }
            }
        })
    }
}

/// To which t a ray is walked along: to what it hits.
pub(crate) fn walk_end(inspection: Option<&Inspection>) -> f64 {
    inspection.and_then(Inspection::first_hit).map_or(WALK_TO, |hit| hit.t)
}

#[cfg(test)]
mod tests;
