//! Adaptive resolution. While the user drags something, a scene that is too slow to trace in one frame
//! is traced with fewer pixels. Once the pointer rests, all pixels are traced, unless that would make
//! the window stop responding.

use std::time::Duration;

use pinhole_core::{ImageSize, Raster};

use crate::model::with_defaults;

/// The distance between traced rows, and between traced columns, in pixels: 1 traces all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Subsampling(u32);

impl Default for Subsampling {
    fn default() -> Subsampling {
        Subsampling::NONE
    }
}

impl Subsampling {
    /// Full resolution: every pixel that the screen can show is traced.
    pub const NONE: Subsampling = Subsampling(1);

    /// Lowest resolution: every 8th row and column is traced, which is enough to follow a motion.
    pub const MOST: Subsampling = Subsampling(8);

    /// Returns the pixels to trace for an image that is shown on `columns` x `rows` screen pixels.
    pub(crate) fn raster(self, image: ImageSize, [columns, rows]: [u32; 2]) -> Raster {
        let some = |dots: u32, count: u32| dots.min(count).div_ceil(self.0);
        Raster::shown_on(image, some(columns, image.width()), some(rows, image.height()))
    }

    /// Returns the step in words: `one in 3 rows and columns`.
    fn words(self) -> String {
        let Subsampling(step) = self;
        format!("one in {step} rows and columns")
    }
}

/// Maximum time to trace a picture during a drag. It leaves time for the rest of a frame at 60 Hz.
const BUDGET: Duration = Duration::from_millis(8);

/// Maximum fraction of the budget that a finer picture may be expected to take. If it were near 1, the next
/// frame would often have to be coarser again.
const COMFORT: f64 = 0.6;

/// Maximum time to trace a picture at rest. The window does not respond during this time.
const LONGEST: Duration = Duration::from_secs(1);

/// Number of objects from which on tracing all pixels may take longer than [`LONGEST`].
const MANY: usize = 200;

/// Seconds without movement after which a drag counts as resting.
pub(crate) const REST: f64 = 0.15;

with_defaults! {
    /// Chooses the subsampling from the time that earlier pictures took.
    #[derive(Debug)]
    pub(crate) struct AdaptiveResolution {
        budget: Duration = BUDGET,
        /// The subsampling during a drag.
        moving: Subsampling = Subsampling::NONE,
        /// The subsampling at rest.
        resting: Subsampling = Subsampling::NONE,
        /// Estimated time to trace a picture at full resolution; the real time may be shorter.
        full: Duration = Duration::ZERO,
        /// Number of objects in the scene that was measured.
        objects: usize = 0,
        /// Time of the last move, in seconds.
        moved_at: f64 = f64::NEG_INFINITY,
    }
}

impl AdaptiveResolution {
    /// Creates an instance with a time budget for pictures during a drag.
    pub(crate) fn within(budget: Duration) -> AdaptiveResolution {
        AdaptiveResolution { budget, ..AdaptiveResolution::default() }
    }

    /// Returns the subsampling for a frame at `time`. `moves` is true if the view is changing in this
    /// frame.
    pub(crate) fn now(&mut self, moves: bool, time: f64, objects: usize) -> Subsampling {
        if moves {
            self.moved_at = time;
        }
        if objects != self.objects {
            self.objects = objects;
            // The first picture of a large scene is coarse; its time predicts the time at full resolution.
            if objects >= MANY {
                (self.moving, self.resting) = (Subsampling::MOST, Subsampling::MOST);
            }
        }
        if self.is_followed(time) { self.moving } else { self.resting }
    }

    /// Returns true if a picture with this subsampling will be traced more finely once the pointer rests.
    pub(crate) fn is_made_finer(&self, shown: Subsampling) -> bool {
        shown > self.resting
    }

    /// Returns the note to show next to a picture with this subsampling; `None` at full resolution.
    pub(crate) fn message(&self, shown: Subsampling) -> Option<String> {
        if shown == Subsampling::NONE {
            None
        } else if self.is_made_finer(shown) {
            Some(format!("coarser while it moves: {}", shown.words()))
        } else {
            let seconds = self.full.as_secs_f64().ceil();
            Some(format!("{}: all of them would take up to {seconds} s", shown.words()))
        }
    }

    /// Returns true if the view changed less than [`REST`] seconds before `time`.
    pub(crate) fn is_followed(&self, time: f64) -> bool {
        time - self.moved_at < REST
    }

    /// Records how long it took to trace new pictures.
    pub(crate) fn took(&mut self, subsampling: Subsampling, traced_in: Duration) {
        let step = f64::from(subsampling.0);
        // The number of pixels is proportional to 1 / step^2, and the time grows at most in proportion to
        // it.
        let share = traced_in.as_secs_f64() / self.budget.as_secs_f64().max(1e-9);
        let next = if share > 1.0 {
            (step * share.sqrt()).ceil()
        } else {
            let finer = (step - 1.0).max(1.0);
            if share * (step / finer).powi(2) <= COMFORT { finer } else { step }
        };
        let in_range =
            |step: f64| Subsampling(step.clamp(1.0, f64::from(Subsampling::MOST.0)) as u32);
        self.moving = in_range(next);
        self.full = traced_in.mul_f64(step * step);
        self.resting = in_range(self.full.div_duration_f64(LONGEST).sqrt().ceil());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    #[test]
    fn what_fits_into_a_frame_is_never_coarse() {
        let mut adaptive_resolution = AdaptiveResolution::default();
        for k in 0..10 {
            let now = f64::from(k);
            assert_eq!(adaptive_resolution.now(true, now, 1), Subsampling::NONE);
            adaptive_resolution.took(Subsampling::NONE, 7 * MS);
        }
    }

    #[test]
    fn what_is_too_heavy_is_coarse_as_long_as_the_hand_moves() {
        let mut adaptive_resolution = AdaptiveResolution::default();
        adaptive_resolution.took(Subsampling::NONE, 70 * MS);
        assert_eq!(adaptive_resolution.now(false, 0.0, 1), Subsampling::NONE, "nothing moves");
        // With a step three times as coarse, tracing takes a ninth: 7.8 ms.
        assert_eq!(adaptive_resolution.now(true, 5.0, 1), Subsampling(3));
        adaptive_resolution.took(Subsampling(3), 78 * MS / 10);
        assert_eq!(adaptive_resolution.now(false, 5.1, 1), Subsampling(3), "between two moves");
        assert_eq!(adaptive_resolution.now(false, 5.2, 1), Subsampling::NONE, "the hand rests");
    }

    #[test]
    fn it_comes_to_rest_at_one_step_for_every_weight() {
        for full in 1..2000 {
            let mut adaptive_resolution = AdaptiveResolution::default();
            let time = |c: Subsampling| MS * full / (c.0 * c.0);
            let mut steps = Vec::new();
            for k in 0..30 {
                let now = adaptive_resolution.now(true, f64::from(k), 1);
                adaptive_resolution.took(now, time(now));
                steps.push(now);
            }
            assert!(steps[20..].iter().all(|step| *step == steps[20]), "{full} ms: {steps:?}");
            assert!(time(steps[20]) <= BUDGET || steps[20] == Subsampling::MOST, "{full} ms");
        }
    }

    #[test]
    fn what_would_take_long_stays_coarse_at_rest_and_says_so() {
        let mut adaptive_resolution = AdaptiveResolution::default();
        assert_eq!(adaptive_resolution.now(false, 0.0, 10_000), Subsampling::MOST, "not known yet");
        // One eighth of the rows and columns takes 100 ms, so all take 6.4 s, and one third takes 0.7 s.
        adaptive_resolution.took(Subsampling::MOST, 100 * MS);
        let now = adaptive_resolution.now(false, 0.2, 10_000);
        assert_eq!(now, Subsampling(3));
        assert!(!adaptive_resolution.is_made_finer(now));
        assert_eq!(
            adaptive_resolution.message(now).as_deref(),
            Some("one in 3 rows and columns: all of them would take up to 7 s")
        );
        // A scene that turns out to be fast is traced finely again.
        adaptive_resolution.took(now, MS);
        assert!(adaptive_resolution.is_made_finer(now));
        assert_eq!(adaptive_resolution.now(false, 0.4, 10_000), Subsampling::NONE);
        assert_eq!(adaptive_resolution.message(Subsampling::NONE), None);
    }

    #[test]
    fn a_coarse_raster_has_pixels_of_the_fine_one_all_over_it() {
        let image = ImageSize::new(400, 300).expect("a size");
        let full = Subsampling::NONE.raster(image, [800, 800]);
        assert_eq!(full, Raster::full(image));
        let coarse = Subsampling(3).raster(image, [800, 800]);
        assert_eq!([coarse.columns().len(), coarse.rows().len()], [134, 100]);
        let small = Subsampling(8).raster(image, [1, 5]);
        assert_eq!([small.columns().len(), small.rows().len()], [1, 1]);
    }
}
