//! An animation that is open: where it is, and whether it goes on.

use pinhole_core::Camera;

use super::Kind;
use super::PlayError;
use super::Start;
use super::Still;
use crate::model::observer::Observer;

/// The longest time between two frames that counts, in seconds: a window that was hidden goes on
/// where it was.
const LONGEST: f64 = 0.5;

/// How many steps a reduced motion shows in a second.
const REDUCED: f64 = 2.0;

/// What is nearer to a step than this share of one is on it.
const ON_STEP: f64 = 1e-6;

/// An animation, running or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    /// What moves.
    pub kind: Kind,
    /// How it was when it was opened.
    pub start: Start,
    /// From 0, the start, to 1, the end.
    pub phase: f64,
    /// Whether it has gone on, or was moved, at all: one that was only opened changes nothing.
    pub begun: bool,
    /// Whether it goes on by itself.
    pub running: bool,
    /// So many times as fast as usual.
    pub speed: f64,
    /// After the end it begins again.
    pub loops: bool,
    /// Only whole steps are shown, two a second.
    pub reduced: bool,
    /// Why it does not move.
    pub fault: Option<PlayError>,
    /// The camera that it showed last; where another one is there, it was edited.
    pub(crate) shown: Camera,
    /// The observer before it stepped back to see all of it, and since.
    pub(crate) stepped_back: Option<[Observer; 2]>,
    /// When it was last moved on, in the window's seconds.
    time: Option<f64>,
}

impl Player {
    /// The speeds to choose from.
    pub const SPEEDS: [f64; 6] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0];

    /// At the start, at rest.
    pub fn new(kind: Kind, start: Start) -> Player {
        Player {
            kind,
            start,
            phase: 0.0,
            begun: false,
            running: false,
            speed: 1.0,
            loops: kind.is_round(),
            reduced: false,
            fault: None,
            shown: start.camera,
            stepped_back: None,
            time: None,
        }
    }

    /// How it is now; as at the start where it cannot move, which is remembered.
    pub fn still(&mut self) -> Still {
        if !self.begun {
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

    /// Goes on to this moment, if it runs.
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

    /// Runs, or rests. From the end it begins again.
    pub fn toggle(&mut self) {
        (self.begun, self.running) = (true, !self.running);
        self.time = None;
        if self.running && self.phase >= 1.0 {
            self.phase = 0.0;
        }
    }

    /// Rests, so many single steps on, or back.
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

    /// So many of the [speeds](Player::SPEEDS) on, or back.
    pub fn faster(&mut self, by: i32) {
        let now = Player::SPEEDS.iter().position(|speed| *speed >= self.speed);
        let last = Player::SPEEDS.len() - 1;
        let next = now.unwrap_or(last).saturating_add_signed(by as isize).min(last);
        self.speed = Player::SPEEDS[next];
    }

    /// Where it is, in words.
    pub fn place(&self) -> String {
        match self.kind {
            Kind::SwingUp | Kind::Orbit => format!("{:.0}°", 360.0 * self.phase),
            Kind::Walk => {
                format!("t = {}", crate::model::number::written(self.phase * self.start.end, 3))
            }
            Kind::Scan => {
                let of = self.kind.steps(&self.start);
                let so_far = (self.phase * of as f64).round() as u64;
                let grouped = crate::model::number::grouped;
                format!("{} of {} pixels", grouped(so_far), grouped(of))
            }
        }
    }
}
