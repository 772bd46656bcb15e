//! What the window's frames take, measured only while somebody looks: this is where the Frame view
//! meets the clock.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use egui::Context;

use crate::ui::program::FrameTimes;
use crate::view::derive::Work;

/// So many frames are kept.
pub(crate) const KEPT: usize = 200;

/// So long after a new picture the view is shown once more, with the times of that frame, if nothing
/// else has shown it by then.
const AFTERWARDS: Duration = Duration::from_millis(100);

/// What a frame took until it was ready to be painted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct WorkTimes {
    pub(crate) plan: Duration,
    pub(crate) trace: Duration,
    pub(crate) overlay: Duration,
    /// All else that is derived from the document.
    pub(crate) readouts: Duration,
    /// Everything else, as far as it was measured.
    pub(crate) interface: Duration,
    /// Whether a picture was made.
    pub(crate) is_new: bool,
}

/// Tells apart what the time goes into.
pub(crate) struct Stopwatch(Mutex<(Instant, WorkTimes)>);

impl Stopwatch {
    pub(crate) fn start() -> Stopwatch {
        Stopwatch(Mutex::new((Instant::now(), WorkTimes::default())))
    }

    /// The time since the last call was spent on this.
    pub(crate) fn tell(&self, work: Work) {
        let now = Instant::now();
        let (since, times) = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let of_work = match work {
            Work::Plan => &mut times.plan,
            Work::Trace => &mut times.trace,
            Work::Overlay => &mut times.overlay,
            Work::Rest => &mut times.interface,
        };
        *of_work += now - *since;
        *since = now;
        times.is_new |= work != Work::Rest;
    }

    /// All that was done until now was deriving.
    pub(crate) fn derived(&self) {
        self.tell(Work::Rest);
        let (_, times) = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        times.readouts = std::mem::take(&mut times.interface);
    }

    /// How long tracing took until now; `None` where nothing was traced.
    pub(crate) fn traced(&self) -> Option<Duration> {
        let (_, times) = &*self.0.lock().unwrap_or_else(PoisonError::into_inner);
        Some(times.plan + times.trace).filter(|traced| !traced.is_zero())
    }

    fn stop(self) -> WorkTimes {
        self.tell(Work::Rest);
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner).1
    }
}

/// One frame that showed a new picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FrameRecord {
    /// The context's number of the frame.
    frame: u64,
    pub(crate) work: WorkTimes,
    /// What came after, once it is known.
    presented: Option<FrameTimes>,
}

/// The parts of a frame, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    Plan,
    Trace,
    Overlay,
    Readouts,
    Interface,
    Upload,
    Paint,
}

impl Part {
    pub(crate) const ALL: [Part; 7] = [
        Part::Plan,
        Part::Trace,
        Part::Overlay,
        Part::Readouts,
        Part::Interface,
        Part::Upload,
        Part::Paint,
    ];
}

impl FrameRecord {
    pub(crate) fn of(frame: u64, work: WorkTimes) -> FrameRecord {
        FrameRecord { frame, work, presented: None }
    }

    /// How long a part took; `None` where nothing presents the frame.
    pub(crate) fn time(&self, part: Part) -> Option<Duration> {
        let WorkTimes { plan, trace, overlay, readouts, interface, .. } = self.work;
        match part {
            Part::Plan => Some(plan),
            Part::Trace => Some(trace),
            Part::Overlay => Some(overlay),
            Part::Readouts => Some(readouts),
            // With what is around the program's own part.
            Part::Interface => Some(self.presented.map_or(interface, |times| {
                times.ui.saturating_sub(plan + trace + overlay + readouts)
            })),
            Part::Upload => self.presented.map(|times| times.upload),
            Part::Paint => self.presented.map(|times| times.paint),
        }
    }

    /// All parts together.
    pub(crate) fn total(&self) -> Duration {
        Part::ALL.iter().filter_map(|part| self.time(*part)).sum()
    }
}

/// The last frames that showed a new picture. Others, such as those that follow a mouse over the
/// panels, are not kept, so that what a picture took stays to be read.
#[derive(Debug, Default)]
pub(crate) struct FrameHistory {
    records: VecDeque<FrameRecord>,
    /// The frame that is being made or was made last.
    frame: u64,
}

impl FrameHistory {
    /// The records, the oldest first.
    pub(crate) fn records(&self) -> impl ExactSizeIterator<Item = &FrameRecord> {
        self.records.iter()
    }

    /// The last one.
    pub(crate) fn last(&self) -> Option<&FrameRecord> {
        self.records.back()
    }

    /// What went into the frame presented last, if it showed a new picture.
    pub(crate) fn work_presented(&self) -> Option<WorkTimes> {
        self.records.back().filter(|last| last.frame == self.frame).map(|last| last.work)
    }

    /// The program is done with a pass. Without a stopwatch nobody looks, and nothing is kept.
    pub(crate) fn end(&mut self, ctx: &Context, stopwatch: Option<Stopwatch>) {
        let Some(stopwatch) = stopwatch else {
            self.records = VecDeque::new();
            return;
        };
        let work = stopwatch.stop();
        self.frame = ctx.cumulative_frame_nr();
        if let Some(last) = self.records.back_mut()
            && last.frame == self.frame
        {
            // One more pass of the same frame.
            last.work.plan += work.plan;
            last.work.trace += work.trace;
            last.work.overlay += work.overlay;
            last.work.readouts += work.readouts;
            last.work.interface += work.interface;
        } else if work.is_new {
            if self.records.len() == KEPT {
                self.records.pop_front();
            }
            self.records.push_back(FrameRecord::of(self.frame, work));
        } else {
            return;
        }
        ctx.request_repaint_after(AFTERWARDS);
    }

    /// The frame was handed to the display.
    pub(crate) fn presented(&mut self, times: &FrameTimes) {
        if let Some(last) = self.records.back_mut()
            && last.frame == self.frame
        {
            last.presented = Some(*times);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    /// A pass of a frame in which this was done.
    fn pass(history: &mut FrameHistory, ctx: &Context, work: &[Work]) {
        let stopwatch = Stopwatch::start();
        work.iter().for_each(|work| stopwatch.tell(*work));
        history.end(ctx, Some(stopwatch));
    }

    fn frame(history: &mut FrameHistory, ctx: &Context, work: &[Work]) {
        ctx.run_ui(egui::RawInput::default(), |ui| pass(history, ui.ctx(), work))
            .drop_without_applying_deltas();
    }

    #[test]
    fn frames_with_a_new_picture_are_kept_and_only_so_many() {
        let (mut history, ctx) = (FrameHistory::default(), Context::default());
        frame(&mut history, &ctx, &[Work::Plan, Work::Trace]);
        frame(&mut history, &ctx, &[]);
        frame(&mut history, &ctx, &[Work::Rest]);
        assert_eq!(history.records().len(), 1);
        for _ in 0..KEPT + 7 {
            frame(&mut history, &ctx, &[Work::Overlay]);
        }
        assert_eq!(history.records().len(), KEPT);
        ctx.run_ui(egui::RawInput::default(), |ui| history.end(ui.ctx(), None))
            .drop_without_applying_deltas();
        assert_eq!(history.records().len(), 0);
    }

    #[test]
    fn two_passes_are_one_frame_and_what_is_presented_belongs_to_it() {
        let (mut history, ctx) = (FrameHistory::default(), Context::default());
        ctx.run_ui(egui::RawInput::default(), |ui| {
            pass(&mut history, ui.ctx(), &[Work::Plan, Work::Trace]);
            pass(&mut history, ui.ctx(), &[Work::Overlay]);
        })
        .drop_without_applying_deltas();
        let before = *history.last().expect("one record");
        assert_eq!((history.records().len(), before.time(Part::Upload)), (1, None));
        let times = FrameTimes {
            since_input: None,
            frame: ms(95),
            ui: before.work.plan
                + before.work.trace
                + before.work.overlay
                + before.work.readouts
                + ms(30),
            upload: ms(2),
            paint: ms(5),
            wait: ms(9),
        };
        history.presented(&times);
        let after = *history.last().expect("the same record");
        assert_eq!(after.time(Part::Interface), Some(ms(30)));
        assert_eq!((after.time(Part::Upload), after.time(Part::Paint)), (Some(ms(2)), Some(ms(5))));
        assert_eq!(after.total(), times.ui + ms(7));
        // The next frame makes no picture: its times are nobody's.
        frame(&mut history, &ctx, &[]);
        history.presented(&FrameTimes { upload: ms(50), ..times });
        assert_eq!(history.last(), Some(&after));
    }
}
