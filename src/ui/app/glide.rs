//! The glide of the observer (the world view's own camera) from one step of a lesson to the next, or to
//! another view that the user asks for, so that a class sees how one picture becomes the other; and the growth of what
//! a revealed line makes.

use egui::Context;
use pinhole_figure::Observer;
use pinhole_figure::concept::Directed;

use crate::model::OpenLesson;

/// Duration of a glide, in seconds.
const DURATION: f64 = 0.5;

/// The share of its length with which an arrow begins to grow.
const BUD: f64 = 0.05;

/// The observer that is shown while it glides from view to view.
#[derive(Default)]
pub(super) struct Glide {
    /// The lesson's step in the last frame.
    step: Option<OpenLesson>,
    /// The observer that was shown last.
    shown: Option<Observer>,
    /// The observer from which the glide began, and the time in seconds at which it did.
    from: Option<(Observer, f64)>,
    /// What the newest revealed line is about, and the time in seconds since which that grows.
    directed: Option<(Directed, f64)>,
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

    /// Returns the share of the newest line's concept that is drawn while it grows; `None` once it is whole. A press of
    /// the mouse ends the growth; with `is_still` there is none.
    pub(super) fn growth(
        &mut self,
        ctx: &Context,
        directed: Option<Directed>,
        is_still: bool,
    ) -> Option<f64> {
        let (time, is_pressed) = ctx.input(|i| (i.time, i.pointer.any_down()));
        if self.directed.map(|(before, _)| before) != directed {
            self.directed = directed.map(|directed| (directed, time));
        }
        let (_, start) = self.directed.as_mut()?;
        if is_pressed || is_still {
            *start = f64::NEG_INFINITY;
        }
        let share = (time - *start) / DURATION;
        if share >= 1.0 {
            return None;
        }
        ctx.request_repaint();
        Some(eased(share).max(BUD))
    }
}

/// Maps a share of the duration to a share of the way that starts and ends slowly.
fn eased(share: f64) -> f64 {
    share * share * (3.0 - 2.0 * share)
}
