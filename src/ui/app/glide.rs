//! The glide of the observer (the world view's own camera) from one step of a lesson to the next, or to
//! another view that the user asks for, so that a class sees how one picture becomes the other; and the growth of what
//! a revealed line makes.

use egui::Context;
use pinhole_figure::Observer;
use pinhole_figure::concept::{Concepts, Directed};

use crate::model::OpenLesson;

/// Duration of a glide, in seconds.
const DURATION: f64 = 0.5;

/// The observer that is shown while it glides from view to view.
#[derive(Default)]
pub(super) struct Glide {
    /// The lesson's step in the last frame.
    step: Option<OpenLesson>,
    /// The observer that was shown last.
    shown: Option<Observer>,
    /// The observer from which the glide began, and the time in seconds at which it did.
    from: Option<(Observer, f64)>,
    growing: Growing,
}

/// What grows because a line was revealed, or goes back because one was taken back.
#[derive(Default)]
struct Growing {
    /// The lesson's step to which the line belongs.
    step: Option<OpenLesson>,
    /// What the newest revealed line is about.
    directed: Option<Directed>,
    /// What the line was about that was taken back.
    taken_back: Option<Directed>,
    /// The time in seconds since which it grows.
    since: f64,
}

impl Glide {
    /// Begins a glide from the observer that is shown now.
    pub(super) fn begin(&mut self, ctx: &Context) {
        self.from = self.shown.map(|shown| (shown, ctx.input(|i| i.time)));
    }

    /// Returns the observer to show, which is on its way to `to` after a step to another view of the same
    /// scene, or after [`Glide::begin`]. A press of the mouse or another step ends the glide; with `is_still`
    /// there is none.
    pub(super) fn follow(
        &mut self,
        ctx: &Context,
        step: Option<&OpenLesson>,
        to: Option<Observer>,
        is_still: bool,
    ) -> Option<Observer> {
        let (time, is_pressed) = ctx.input(|i| (i.time, i.pointer.any_down()));
        if self.step.as_ref() != step {
            let both = self.step.as_ref().zip(step);
            let same_scene = both.is_some_and(|(before, now)| before.shares_scene_with(now));
            self.from = self.shown.filter(|_| same_scene).map(|shown| (shown, time));
            self.step = step.cloned();
        }
        let share = |start: f64| (time - start) / DURATION;
        self.from = self.from.filter(|(_, start)| share(*start) < 1.0 && !is_pressed && !is_still);
        self.shown = match (self.from, to) {
            (Some((from, start)), Some(to)) if from != to => {
                ctx.request_repaint();
                Some(from.toward(&to, eased(share(start))))
            }
            _ => to,
        };
        self.shown
    }

    /// Returns what the figure is directed to while it grows, and the share of its growth that is over; `None` once it
    /// is whole. What a line made goes back into what it was made from when the line is taken back. A press of the
    /// mouse ends the growth; with `is_still` there is none.
    pub(super) fn growth(
        &mut self,
        ctx: &Context,
        directed: Option<Directed>,
        is_still: bool,
    ) -> Option<(Directed, f64)> {
        let (time, is_pressed) = ctx.input(|i| (i.time, i.pointer.any_down()));
        let growing = &mut self.growing;
        if growing.directed != directed {
            let of_line = directed.filter(|directed| !directed.is_of_step);
            let spoken = of_line.map_or(Concepts::default(), |directed| directed.spoken);
            let same_step = growing.step == self.step;
            let taken_back = growing.directed.filter(|before| {
                let is_fewer = spoken != before.spoken && spoken.is_within(before.spoken);
                same_step && is_fewer && !before.is_of_step
            });
            *growing = Growing { step: self.step.clone(), directed, taken_back, since: time };
        }
        if is_pressed || is_still {
            growing.since = f64::NEG_INFINITY;
        }
        let share = (time - growing.since) / DURATION;
        if share >= 1.0 {
            return None;
        }
        let (shown, growth) = match growing.taken_back {
            Some(taken_back) => (taken_back, 1.0 - eased(share)),
            None => (directed.filter(|directed| !directed.is_of_step)?, eased(share)),
        };
        ctx.request_repaint();
        Some((shown, growth))
    }
}

/// Maps a share of the duration to a share of the way that starts and ends slowly.
fn eased(share: f64) -> f64 {
    share * share * (3.0 - 2.0 * share)
}
