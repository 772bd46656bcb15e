//! Measures error against run time for the current scene, a slice per frame, so that the window
//! never stalls. This is where the window meets the clock; derived values stay pure.

use std::sync::{Arc, Weak};
use std::time::Duration;

use egui::Context;
use pinhole_core::{Camera, Scene};

#[cfg(feature = "report")]
use crate::report::measure::Run;
use crate::report::model::Report;
use crate::view::derive::Derived;

/// Time without changes before measuring starts, in seconds: during a drag, each frame is another
/// scene.
const REST: f64 = 0.5;

/// Time between two reports while measuring, in seconds.
const BETWEEN: f64 = 0.3;

/// A run that there is none of, in a build without the feature `report`.
#[cfg(not(feature = "report"))]
enum Run {}

#[cfg(not(feature = "report"))]
impl Run {
    fn of_scene(_: &str, _: &Scene, _: &Camera) -> Result<Run, ()> {
        Err(())
    }

    fn step(&mut self) {
        match *self {}
    }

    fn is_done(&self) -> bool {
        match *self {}
    }

    fn report(&self) -> Report {
        match *self {}
    }

    fn total(&self) -> usize {
        match *self {}
    }

    fn done(&self) -> usize {
        match *self {}
    }
}

/// The present measurement and the last report.
#[derive(Default)]
pub(crate) struct Measuring {
    /// The scene is identified by its address, and not held: another owner would make its next
    /// change a copy.
    subject: Option<(Camera, Weak<Scene>)>,
    /// Time when the subject was first seen, in the context's seconds.
    since: f64,
    run: Option<Run>,
    report: Option<Arc<Report>>,
    /// Time when the report was made, in the context's seconds.
    typeset_message: f64,
    /// True if the report is about the subject.
    is_current: bool,
    /// True if nothing is left to measure.
    is_done: bool,
}

impl Measuring {
    /// Measures a slice, if something is left to measure, and requests the next frame.
    pub(crate) fn step(&mut self, ctx: &Context, name: &str, camera: &Camera, derived: &Derived) {
        // The report's methods too test every object at every pixel.
        let why_not = (derived.fault, derived.too_many);
        let (Some(scene), (None, None)) = (&derived.scene, why_not) else { return };
        let now = ctx.input(|input| input.time);
        let subject = self.subject.as_ref();
        let place = Arc::as_ptr(scene);
        if subject.is_none_or(|(known, of)| known != camera || of.as_ptr() != place) {
            self.subject = Some((*camera, Arc::downgrade(scene)));
            (self.since, self.run, self.is_done, self.is_current) = (now, None, false, false);
        }
        if self.is_done {
            return;
        }
        let left = REST - (now - self.since);
        if self.run.is_none() && left > 0.0 {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
            return;
        }
        if self.run.is_none() {
            // An invalid camera is a fault, for which this function returned above.
            self.run = Run::of_scene(name, scene, camera).ok();
        }
        let Some(run) = &mut self.run else { return };
        run.step();
        self.is_done = run.is_done();
        if self.is_done || now - self.typeset_message >= BETWEEN {
            self.report = Some(Arc::new(run.report()));
            (self.typeset_message, self.is_current) = (now, true);
        }
        if !self.is_done {
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
        match &self.run {
            _ if self.is_done => None,
            Some(run) => Some(run.done() as f32 / run.total().max(1) as f32),
            None => Some(0.0),
        }
    }
}
