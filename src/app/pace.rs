//! Keeping up with the hand: what frames take, and how coarse pictures are while it moves them.

use std::time::Duration;

use egui::{Context, Vec2};

use super::App;
use crate::coarseness::{Coarseness, Governor, REST};
use crate::frame_times::WorkTimes;
use crate::session::ViewLayout;

impl App {
    /// Has all frames timed from now on, for those who keep a log.
    pub(crate) fn time_frames(&mut self) {
        self.logs_frame_times = true;
    }

    /// Whether somebody looks at what frames take.
    pub fn times_frames(&self) -> bool {
        self.logs_frame_times || self.session.settings.layout == ViewLayout::Frame
    }

    /// What went into the frame presented last, if it showed a new picture and is timed.
    pub(crate) fn work_presented(&self) -> Option<WorkTimes> {
        self.frames.work_presented()
    }

    /// How long tracing may take while a hand moves what is traced; pictures are coarser where it
    /// would take longer. For those who want to see it happen on any scene.
    pub fn follow_within(&mut self, budget: Duration) {
        self.governor = Governor::within(budget);
    }

    /// How coarse new pictures are in this pass.
    pub(super) fn coarseness(&self, ctx: &Context) -> Coarseness {
        let plays = self.plays_camera();
        let (is_down, moves, scrolls, time) = ctx.input(|i| {
            let scrolls = i.smooth_scroll_delta() != Vec2::ZERO || i.zoom_delta() != 1.0;
            (i.pointer.any_down(), i.pointer.delta() != Vec2::ZERO, scrolls, i.time)
        });
        self.governor.now(is_down || scrolls || plays, moves || scrolls || plays, time)
    }

    /// Tracing took so long, if anything was traced. What is coarse is made finer as soon as the hand
    /// rests.
    pub(super) fn keep_pace(&mut self, ctx: &Context, was: Coarseness, traced: Option<Duration>) {
        if let Some(traced) = traced {
            self.governor.took(was, traced, ctx.input(|i| i.time));
        }
        if self.derived.coarseness.into_iter().any(|shown| shown != Coarseness::NONE) {
            ctx.request_repaint_after(Duration::from_secs_f64(REST));
        }
    }
}
