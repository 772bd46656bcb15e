//! Keeping up with the hand: what frames take, and how coarse pictures are while it moves them.

use std::time::Duration;

use egui::{Context, Key, Vec2};

use super::App;
use crate::ui::frame_times::{FrameWork, WorkTimes};
use crate::view::adaptive_resolution::{AdaptiveResolution, REST, Subsampling};

/// Keys that move the camera, the observer or a handle as long as they are held.
const STEERING: [Key; 7] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Plus,
    Key::Equals,
    Key::Minus,
];

impl App {
    /// Has all frames timed from now on, for those who keep a log.
    pub(crate) fn time_frames(&mut self) {
        self.frame_work = Some(FrameWork::default());
    }

    /// The work of the frame presented last, if it showed a new picture and is timed.
    pub(crate) fn work_presented(&self) -> Option<WorkTimes> {
        self.frame_work.as_ref()?.work()
    }

    /// How long tracing may take while a hand moves what is traced; pictures are coarser where it
    /// would take longer. For those who want to see it happen on any scene.
    pub fn follow_within(&mut self, budget: Duration) {
        self.adaptive_resolution = AdaptiveResolution::within(budget);
    }

    /// How coarse new pictures are in this pass.
    pub(super) fn subsampling(&mut self, ctx: &Context) -> Subsampling {
        let plays = self.player.as_ref().is_some_and(|p| p.running && p.kind.moves_camera());
        let (moves, time) = ctx.input(|i| {
            let drags = i.pointer.any_down() && i.pointer.delta() != Vec2::ZERO;
            let scrolls = i.smooth_scroll_delta() != Vec2::ZERO || i.zoom_delta() != 1.0;
            let steps = STEERING.into_iter().any(|key| i.key_down(key));
            (drags || scrolls || steps, i.time)
        });
        self.adaptive_resolution.now(moves || plays, time)
    }

    /// Whether a hand moves what is seen, or did just now.
    pub(super) fn is_under_hand(&self, ctx: &Context) -> bool {
        self.adaptive_resolution.is_followed(ctx.input(|i| i.time))
    }

    /// Tracing took so long, if anything was traced. What is coarse is made finer as soon as the hand
    /// rests.
    pub(super) fn keep_pace(&mut self, ctx: &Context, was: Subsampling, traced: Option<Duration>) {
        if let Some(traced) = traced {
            self.adaptive_resolution.took(was, traced);
        }
        // A grade may have been put off, too.
        let waits = self.is_under_hand(ctx) && self.session.answers.is_some();
        let is_coarse = |shown: Subsampling| shown != Subsampling::NONE;
        if waits || self.derived.subsampling.into_iter().any(is_coarse) {
            ctx.request_repaint_after(Duration::from_secs_f64(REST));
        }
    }
}
