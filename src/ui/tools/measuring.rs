//! Measures error against run time for the current scene, a slice per frame, so that the window
//! never stalls. This is where the window meets the clock; derived values stay pure.

use std::sync::{Arc, Weak};
#[cfg(feature = "report")]
use std::time::Duration;

use egui::Context;
use pinhole_core::{Camera, Scene};

#[cfg(feature = "report")]
use crate::report::measure::Measurement;
use crate::report::model::Report;
use crate::view::derive::Derived;

/// Time without changes before measuring starts, in seconds: during a drag, each frame is another
/// scene.
#[cfg(feature = "report")]
const REST: f64 = 0.5;

/// Time between two reports while measuring, in seconds.
#[cfg(feature = "report")]
const BETWEEN: f64 = 0.3;

/// The present measurement and the last report.
#[derive(Default)]
#[cfg_attr(not(feature = "report"), expect(dead_code, reason = "nothing is measured"))]
pub(crate) struct Measuring {
    /// The scene is identified by its address, and not held: another owner would make its next
    /// change a copy.
    subject: Option<(Camera, Weak<Scene>)>,
    /// Time when the subject was first seen, in the context's seconds.
    since: f64,
    #[cfg(feature = "report")]
    run: Option<Measurement>,
    /// Progress of the run, 0 to 1; `None` if nothing is left to measure.
    share: Option<f32>,
    report: Option<Arc<Report>>,
    /// Time when the report was made, in the context's seconds.
    made_at: f64,
    /// True if the report is about the subject.
    is_current: bool,
}

impl Measuring {
    /// Does nothing in a build without the feature `report`.
    #[cfg(not(feature = "report"))]
    pub(crate) fn step(&mut self, _: &Context, _: &str, _: &Camera, _: &Derived) {}

    /// Measures a slice, if something is left to measure, and requests the next frame.
    #[cfg(feature = "report")]
    pub(crate) fn step(&mut self, ctx: &Context, name: &str, camera: &Camera, derived: &Derived) {
        // The report's methods too test every object at every pixel.
        let why_not = (derived.fault, derived.too_many);
        let (Some(scene), (None, None)) = (&derived.scene, why_not) else { return };
        let now = ctx.input(|input| input.time);
        let subject = self.subject.as_ref();
        let address = Arc::as_ptr(scene);
        if subject.is_none_or(|(known, objects)| known != camera || objects.as_ptr() != address) {
            self.subject = Some((*camera, Arc::downgrade(scene)));
            self.share = Some(0.0);
            (self.since, self.run, self.is_current) = (now, None, false);
        }
        if self.share.is_none() {
            return;
        }
        let left = REST - (now - self.since);
        if self.run.is_none() && left > 0.0 {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
            return;
        }
        if self.run.is_none() {
            // An invalid camera is a fault, for which this function returned above.
            self.run = Measurement::of_scene(name, scene, camera).ok();
        }
        let Some(run) = &mut self.run else { return };
        run.step();
        let share = run.done() as f32 / run.total().max(1) as f32;
        self.share = (!run.is_done()).then_some(share);
        if run.is_done() || now - self.made_at >= BETWEEN {
            self.report = Some(Arc::new(run.report()));
            (self.made_at, self.is_current) = (now, true);
        }
        if self.share.is_some() {
            ctx.request_repaint();
        }
    }

    /// Returns the last report, even if it is about an older scene.
    pub(crate) fn report(&self) -> Option<&Arc<Report>> {
        self.report.as_ref()
    }

    /// Returns true if the report is about the shown scene.
    pub(crate) fn is_current(&self) -> bool {
        self.is_current
    }

    /// Returns the progress, 0 to 1; `None` if nothing is left to measure.
    pub(crate) fn share(&self) -> Option<f32> {
        self.share
    }
}
