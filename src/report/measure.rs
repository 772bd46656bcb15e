//! Measures error against run time, a slice at a time: [`Measurement`].
//!
//! A measurement is a list of cases (a scene, or a stress family at one setting of its knob). For
//! each case, the reference and every [`Method`] trace some rays. Whole frames or lists of rays are
//! timed in rounds. Each round times all methods in turn, so a slow moment of the machine affects
//! every method.

use std::fs;
use std::time::{Duration, Instant};

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

/// Time after which a slice starts no further piece of work.
const SLICE: Duration = Duration::from_millis(8);

/// The method that times are compared with.
pub(super) const BASELINE: Method = Method::Known(Formula::Textbook, Precision::F32);

/// A measurement in progress. Work is only done in [`Measurement::step`].
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
    /// Index of the current case; all earlier cases are done.
    current: usize,
    left_out: Vec<String>,
    notes: &'static str,
    seed: Option<u64>,
    timed_what: &'static str,
    /// Restricts the ladder's parallel tracer to one thread while it is timed.
    one_thread: Option<ThreadPool>,
}

impl Measurement {
    /// Creates the measurement of a scene as seen by a camera: the same pixels on every machine.
    ///
    /// # Errors
    /// Returns an error if a camera sees nothing.
    pub fn of_scene(
        name: &str,
        scene: &Scene,
        camera: &Camera,
    ) -> Result<Measurement, CameraError> {
        let (cases, left_out) = scenes::cases(name, scene, camera)?;
        let timed_what = "a frame of the scene";
        let (notes, seed) = (scenes::NOTE, None);
        Ok(Measurement {
            cases,
            current: 0,
            left_out,
            notes,
            seed,
            timed_what,
            one_thread: one_thread(),
        })
    }

    /// Creates the measurement of all stress families, which takes about two minutes on two cores. The same
    /// seed gives the same cases on every machine, and all of them are compared with the truth.
    pub fn of_families(seed: u64) -> Measurement {
        let (cases, left_out) = families::cases(seed);
        let timed_what = "the family's rays one by one, or its frames at some 8000 pixels";
        let (notes, seed) = (families::NOTE, Some(seed));
        Measurement {
            cases,
            current: 0,
            left_out,
            notes,
            seed,
            timed_what,
            one_thread: one_thread(),
        }
    }

    /// Returns the total amount of work, in pieces of roughly equal length.
    pub fn total(&self) -> usize {
        self.cases.iter().map(CaseRun::total).sum()
    }

    /// Returns the number of pieces of work that are done.
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
            if case.is_done() {
                case.finish();
                self.current += 1;
            }
            if start.elapsed() >= SLICE {
                return;
            }
        }
    }

    /// Returns a report of the cases begun so far, each with the decisions made so far.
    pub fn report(&self) -> Report {
        let begun = self.cases.iter().filter(|case| case.has_begun());
        let mut left_out = self.left_out.clone();
        left_out.extend(begun.clone().filter_map(CaseRun::left_out));
        Report {
            reference: subject::REFERENCE.to_owned(),
            cpu: describe("every method"),
            baseline: format!(
                "{BASELINE}, both roots, timed as all are: {}, one thread; ladder-f32 is how pictures \
                 on the screen are traced; the ladder has the same objects, and every t rounded once \
                 from more digits than f64 has, pixel by pixel; the others' time is that of their \
                 formula",
                self.timed_what
            ),
            cases: begun.map(CaseRun::report).collect(),
            left_out,
            notes: vec![self.notes.to_owned()],
            seed: self.seed,
        }
    }
}

/// Returns a pool of one thread for the ladder; `None` if the pool cannot be created, in which case
/// the ladder is timed on all threads of the default pool.
fn one_thread() -> Option<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(1).build().ok()
}

/// Describes the processor: its name if known, the vector instructions by which programs choose
/// their code, and the instructions that `what` was compiled for.
pub(crate) fn describe(what: &str) -> String {
    let name = name().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let features = features();
    let features = if features.is_empty() {
        "no vector instructions asked for".to_owned()
    } else {
        features.join(", ")
    };
    format!("{name} ({}; {features}; {what} compiled for {})", std::env::consts::ARCH, level())
}

/// Returns the name of the vector instructions that `pinhole_core` chose.
fn level() -> &'static str {
    match Level::new() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(_) => "avx512",
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) => "avx2 and fma",
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Sse4_2(_) => "sse4.2",
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => "neon",
        _ => "the architecture's least",
    }
}

fn name() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    let name = line.split_once(':')?.1.trim();
    (!name.is_empty()).then(|| name.to_owned())
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn features() -> Vec<&'static str> {
    let found = [
        ("sse2", std::is_x86_feature_detected!("sse2")),
        ("sse4.2", std::is_x86_feature_detected!("sse4.2")),
        ("avx2", std::is_x86_feature_detected!("avx2")),
        ("fma", std::is_x86_feature_detected!("fma")),
        ("avx512f", std::is_x86_feature_detected!("avx512f")),
    ];
    found.into_iter().filter_map(|(name, is_there)| is_there.then_some(name)).collect()
}

#[cfg(target_arch = "aarch64")]
fn features() -> Vec<&'static str> {
    vec!["neon"]
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
fn features() -> Vec<&'static str> {
    Vec::new()
}
