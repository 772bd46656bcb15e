//! The player of an animation: its phase, its speed, and whether it is running.

use pinhole_core::Camera;
use pinhole_core::steering::SteerError;
use pinhole_figure::observer::Observer;
use pinhole_lecture::numbers::{equated, grouped};

use super::state::{Kind, Start, Still};

/// Maximum time in seconds by which one frame advances the animation. An animation thus goes on where it
/// was after the window has been hidden.
const LONGEST: f64 = 0.5;

/// Number of steps per second with reduced motion.
const REDUCED: f64 = 2.0;

/// Tolerance, as a fraction of a step, within which a phase counts as lying on a step.
const ON_STEP: f64 = 1e-6;

/// The player of an animation, which may be running or paused.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    /// The kind of animation.
    pub kind: Kind,
    /// The state when the animation was opened.
    pub start: Start,
    /// The phase, from 0, the start, to 1, the end.
    pub phase: f64,
    /// True once the user has started the animation or moved it by hand. Until then, nothing moves.
    pub begun: bool,
    /// True while the animation is running.
    pub running: bool,
    /// The speed, as a multiple of the usual one.
    pub speed: f64,
    /// True if the animation begins again after its end.
    pub loops: bool,
    /// True if the user wants reduced motion: only whole steps are shown, two per second.
    pub reduced: bool,
    /// The reason why the animation cannot move the camera, if it cannot.
    pub fault: Option<SteerError>,
    /// The camera that the player set last. If the document has another camera, the user has edited it
    /// since.
    pub(crate) shown: Camera,
    /// The observer of the world view before and after it was moved back to see the whole animation; `None`
    /// if it was not moved.
    pub(crate) stepped_back: Option<[Observer; 2]>,
    /// Time of the last advance in seconds, on the window's clock.
    time: Option<f64>,
}

impl Player {
    /// The available speeds.
    pub const SPEEDS: [f64; 6] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0];

    /// Creates a paused player at the start.
    pub fn new(kind: Kind, start: Start) -> Player {
        Player {
            kind,
            start,
            phase: 0.0,
            begun: false,
            running: false,
            speed: 1.0,
            loops: kind.moves_camera(),
            reduced: false,
            fault: None,
            shown: start.camera,
            stepped_back: None,
            time: None,
        }
    }

    /// Returns the current state. If the animation cannot move the camera, stores the error and returns
    /// the state at the start.
    pub fn still(&mut self) -> Still {
        if !self.begun {
            // Nothing has moved yet, and the picture is whole.
            return self.start.still();
        }
        let steps = self.kind.steps(&self.start) as f64;
        let phase = match self.reduced && self.running {
            true => (self.phase * steps + ON_STEP).floor() / steps,
            false => self.phase,
        };
        match self.start.at(self.kind, phase) {
            Ok(still) => {
                self.fault = None;
                still
            }
            Err(fault) => {
                (self.fault, self.running) = (Some(fault), false);
                self.start.still()
            }
        }
    }

    /// Advances the animation to the time `now` if it is running.
    pub fn go_on(&mut self, now: f64) {
        let before = self.time.replace(now);
        let (true, Some(before)) = (self.running, before) else { return };
        let seconds = match self.reduced {
            true => self.kind.steps(&self.start) as f64 / REDUCED,
            false => self.kind.seconds(),
        };
        let phase = self.phase + (now - before).clamp(0.0, LONGEST) * self.speed / seconds;
        (self.phase, self.running) = match (phase < 1.0, self.loops) {
            (true, _) => (phase, true),
            (false, true) => (phase.fract(), true),
            (false, false) => (1.0, false),
        };
    }

    /// Starts or pauses the animation. An animation at its end starts again from the beginning.
    pub fn toggle(&mut self) {
        (self.begun, self.running) = (true, !self.running);
        self.time = None;
        if self.running && self.phase >= 1.0 {
            self.phase = 0.0;
        }
    }

    /// Pauses the animation and moves it by `by` single steps.
    pub fn step(&mut self, by: i64) {
        (self.begun, self.running) = (true, false);
        let steps = self.kind.steps(&self.start) as f64;
        let at = self.phase * steps;
        let on_step = (at - at.round()).abs() < ON_STEP;
        let from = match by {
            _ if on_step => at.round(),
            1.. => at.floor(),
            _ => at.ceil(),
        };
        let to = from + by as f64;
        let to = if self.loops { to.rem_euclid(steps) } else { to.clamp(0.0, steps) };
        self.phase = to / steps;
    }

    /// Returns the current phase as text.
    pub fn position(&self) -> String {
        match self.kind {
            Kind::SwingUp | Kind::Orbit => format!("{:.0}°", 360.0 * self.phase),
            // Its four quarters are different angles.
            Kind::OverTheTop => format!("{:.0} %", 100.0 * self.phase),
            Kind::Walk => format!("t {}", equated(self.phase * self.start.end, 3)),
            Kind::Scan => {
                let steps = self.kind.steps(&self.start);
                // Before it begins, the picture is whole.
                let share = if self.begun { self.phase } else { 1.0 };
                let so_far = (share * steps as f64).round() as u64;
                format!("{} of {} pixels", grouped(so_far), grouped(steps))
            }
        }
    }
}
