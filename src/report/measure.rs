//! Measures the error and the run time of every intersection method, in short slices: [`Measurement`].
//!
//! A measurement is a list of cases: a scene, or a stress family at each setting of its knob (the
//! parameter that makes it easier or harder). In each case, the exact reference and every [`Method`]
//! trace some rays, and the results are compared. Separately, the methods are timed in rounds, on whole
//! frames or lists of rays. Each round times all methods in turn, so a temporary slowdown of the
//! machine affects all of them.

use std::fs;
use std::time::Duration;

use web_time::Instant;

use pinhole_core::methods::{Formula, Method, Precision};
use pinhole_core::{Camera, CameraError, Level, Scene};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::report::measure::case::CaseRun;
use crate::report::model::Report;

mod case;
mod condition;
mod families;
mod scenes;
mod subject;

/// Duration after which [`Measurement::step`] starts no further piece of work.
const SLICE: Duration = Duration::from_millis(8);

/// The method with whose times the others are compared.
pub(super) const BASELINE: Method = Method::Known(Formula::Textbook, Precision::F32);

/// A note for readers of the results.
const NOTE: &str =
    "an f32 method rounds what it is given to f32 first, and what that changes is in its error";

/// A measurement in progress. Work is done only in calls of [`Measurement::step`], each of which takes
/// about 10 ms.
///
/// ```
/// use pinhole::report::measure::Measurement;
/// use pinhole_core::*;
///
/// let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
/// let camera = Camera { image: ImageSize::new(8, 8)?, ..Camera::CANONICAL };
/// let mut run = Measurement::of_scene("ball", &Scene::new(vec![ball], vec![])?, &camera)?;
/// while !run.is_done() {
///     run.step();
/// }
/// assert_eq!(run.report().cases[0].name, "ball");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Measurement {
    cases: Vec<CaseRun>,
    /// Index of the current case; all cases before it are done.
    current: usize,
    /// The report without its cases.
    head: Report,
    /// A thread pool with a single thread, in which all methods are timed, since the ladder, the
    /// program's own exact method, traces in parallel otherwise. If the pool cannot be created, this is
    /// `None`, and the ladder is timed on all threads of the default pool.
    one_thread: Option<ThreadPool>,
}

impl Measurement {
    /// Creates the measurement of a scene seen by a camera. The same pixels are compared with the
    /// reference on every machine.
    ///
    /// # Errors
    /// Returns an error if the camera is invalid.
    pub fn of_scene(
        name: &str,
        scene: &Scene,
        camera: &Camera,
    ) -> Result<Measurement, CameraError> {
        let (case, left_out) = scenes::case(name, scene, camera)?;
        Ok(Measurement::new((vec![case], left_out), "a frame of the scene", None))
    }

    /// Creates the measurement of all stress families, which takes a minute or two on two cores. The
    /// seed determines the cases, on every machine alike, and every ray is compared with the reference.
    pub fn of_families(seed: u64) -> Measurement {
        let timed = "the family's rays one by one";
        Measurement::new(families::cases(seed), timed, Some(seed))
    }

    fn new(
        (cases, left_out): (Vec<CaseRun>, Vec<String>),
        timed: &str,
        seed: Option<u64>,
    ) -> Measurement {
        let head = Report {
            reference: subject::REFERENCE.to_owned(),
            cpu: describe_cpu(),
            baseline: format!(
                "{BASELINE}, both roots, timed as all are: {timed}, one thread; ladder-f32 is how pictures \
                 on the screen are traced; the ladder has the same objects, and every t rounded once \
                 from more digits than f64 has, pixel by pixel; the others' time is that of their formula"
            ),
            cases: Vec::new(),
            left_out,
            notes: vec![NOTE.to_owned()],
            seed,
        };
        let one_thread = ThreadPoolBuilder::new().num_threads(1).build().ok();
        Measurement { cases, current: 0, head, one_thread }
    }

    /// Returns the total amount of work, in pieces of roughly equal length.
    pub fn total(&self) -> usize {
        self.cases.iter().map(|case| case.limits.pieces).sum()
    }

    /// Returns the number of pieces of work that have been done.
    pub fn done(&self) -> usize {
        self.cases.iter().map(CaseRun::done).sum()
    }

    /// Returns true if no work is left.
    pub fn is_done(&self) -> bool {
        self.current == self.cases.len()
    }

    /// Does about 10 ms of work.
    pub fn step(&mut self) {
        let start = Instant::now();
        while let Some(case) = self.cases.get_mut(self.current) {
            case.step(self.one_thread.as_ref());
            if case.share() >= 1.0 {
                case.finish();
                self.current += 1;
            }
            if start.elapsed() >= SLICE {
                return;
            }
        }
    }

    /// Returns a report of all cases that have been begun, with the results obtained so far.
    pub fn report(&self) -> Report {
        let begun = self.cases.iter().filter(|case| case.has_begun());
        let mut report = self.head.clone();
        report.left_out.extend(begun.clone().filter_map(|case| case.left_out.clone()));
        report.cases.extend(begun.map(CaseRun::report));
        report
    }
}

/// Describes the processor: its name, if known, and the SIMD instructions for which every method was
/// compiled.
fn describe_cpu() -> String {
    let arch = std::env::consts::ARCH;
    let name = cpu_name().unwrap_or_else(|| arch.to_owned());
    let level = format!("{:?}", Level::new()).to_lowercase();
    let level = level.split('(').next().unwrap_or_default();
    format!("{name} ({arch}; every method compiled for {level})")
}

fn cpu_name() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    let name = line.split_once(':')?.1.trim();
    (!name.is_empty()).then(|| name.to_owned())
}
