//! Measures one case: compares what every method finds as a ray's first hit with the reference's
//! result, and times the methods. A [`ErrorTally`] counts a method's wrong decisions (a wrong object, root,
//! hit or miss) and collects the errors of its right ones.

use std::f64::consts::PI;
use std::time::Duration;

use web_time::Instant;

use pinhole_core::methods::{Method, MethodHit, Precision};
use pinhole_reference::{Hit, angle_between};
use rayon::ThreadPool;
use rayon::prelude::*;

use crate::report::measure::condition::Problem;
use crate::report::measure::subject::{CaseSubject, Kernel};
use crate::report::model::{Case, ConditionSpread, MethodRow, SINGLE, Times, Ulps};

/// A case that is waiting, in progress, or done.
pub(super) struct CaseRun {
    /// The case as it will appear in the report. Its results are missing until the measurement is done.
    case: Case,
    pub(super) limits: Limits,
    /// The function that creates `set`; `None` once the case has begun.
    make: Option<MakeSet>,
    /// The rays, and the methods that trace them; `None` before the case has begun and after it is done.
    set: Option<Set>,
    is_timing_next: bool,
    /// A sentence about rays that are left out, if there are any.
    pub(super) left_out: Option<String>,
}

/// A function that creates a case's rays and prepares the methods for them. It also returns a sentence
/// about rays that are left out, if there are any.
type MakeSet = Box<dyn FnOnce() -> (Set, Option<String>) + Send>;

/// The amount of work for a case. It does not depend on the machine's speed or load.
pub(super) struct Limits {
    /// Number of times that each method is timed.
    pub(super) rounds: usize,
    /// The case's share of the total in the progress display, in pieces of work.
    pub(super) pieces: usize,
}

/// Rays and the methods that trace them.
pub(super) struct Set {
    subject: CaseSubject,
    workers: Vec<Worker>,
    decided: usize,
    hits: usize,
    /// Condition numbers of `t`, for the rays that hit.
    conditions: Vec<f64>,
    /// Number of rays that are traced and compared at a time.
    chunk: usize,
    /// Number of time measurements made so far, over all methods.
    timings: usize,
}

struct Worker {
    method: Method,
    kernel: Kernel,
    tally: ErrorTally,
}

/// Target duration of a piece of work.
const PIECE: Duration = Duration::from_millis(4);

impl CaseRun {
    /// Creates the measurement of a case. `make`, which creates the rays, is called when the case
    /// begins.
    pub(super) fn new(
        case: Case,
        limits: Limits,
        make: impl FnOnce() -> (Set, Option<String>) + Send + 'static,
    ) -> CaseRun {
        let make: Option<MakeSet> = Some(Box::new(make));
        CaseRun { case, limits, make, set: None, is_timing_next: false, left_out: None }
    }

    /// Returns how many of the case's pieces of work have been done.
    pub(super) fn done(&self) -> usize {
        (self.share() * self.limits.pieces as f64) as usize
    }

    pub(super) fn has_begun(&self) -> bool {
        self.make.is_none()
    }

    /// Returns the fraction, 0 to 1, of the case's work that has been done.
    pub(super) fn share(&self) -> f64 {
        let Some(set) = &self.set else { return f64::from(u8::from(self.has_begun())) };
        let all = set.subject.len() + self.limits.rounds * set.workers.len();
        (set.decided + set.timings) as f64 / all.max(1) as f64
    }

    /// Keeps the results and frees everything else.
    pub(super) fn finish(&mut self) {
        self.case = self.report();
        self.set = None;
    }

    pub(super) fn report(&self) -> Case {
        let Some(set) = &self.set else { return self.case.clone() };
        let pixels_timed = set.subject.pixels_timed() as u64;
        let row = |w: &Worker| MethodRow { pixels_timed, ..w.tally.row(w.method) };
        let coverage = if set.decided == 0 { 0.0 } else { set.hits as f64 / set.decided as f64 };
        Case {
            coverage,
            condition: set.condition(),
            methods: set.workers.iter().map(row).collect(),
            ..self.case.clone()
        }
    }

    /// Does one piece of work. The first call creates the rays. Further calls alternate between
    /// comparing some rays' hits with the reference and timing some methods.
    pub(super) fn step(&mut self, one_thread: Option<&ThreadPool>) {
        if let Some(make) = self.make.take() {
            let (set, left_out) = make();
            (self.set, self.left_out) = (Some(set), left_out);
            return;
        }
        let Some(set) = &mut self.set else { return };
        let rounds = self.limits.rounds;
        let to_time = set.timings < rounds * set.workers.len();
        if to_time && (self.is_timing_next || set.decided == set.subject.len()) {
            set.time(rounds, one_thread);
        } else {
            set.decide();
        }
        self.is_timing_next = !self.is_timing_next;
    }
}

impl Set {
    pub(super) fn new(subject: CaseSubject, methods: impl IntoIterator<Item = Method>) -> Set {
        let worker = |method: Method| {
            let kernel = subject.kernel(method)?;
            Some(Worker { method, kernel, tally: ErrorTally::default() })
        };
        let workers = methods.into_iter().filter_map(worker).collect();
        Set { subject, workers, decided: 0, hits: 0, conditions: Vec::new(), chunk: 4, timings: 0 }
    }

    /// Returns the spread of the condition numbers.
    fn condition(&self) -> Option<ConditionSpread> {
        let sorted = sorted(&self.conditions);
        Some(ConditionSpread { median: quantile(&sorted, 0.5)?, max: *sorted.last()? })
    }

    /// Traces the next rays with the reference and with every method, and compares their hits.
    fn decide(&mut self) {
        let start = Instant::now();
        let end = (self.decided + self.chunk).min(self.subject.len());
        let follow = |index: usize| {
            let found = self.workers.iter().map(|worker| worker.kernel.compared.hit(index));
            (self.subject.truth(index), found.collect::<Vec<Option<MethodHit>>>())
        };
        let answers: Vec<_> = (self.decided..end).into_par_iter().map(follow).collect();
        for (truth, found) in answers {
            self.hits += usize::from(truth.is_some());
            self.conditions.extend(truth.as_ref().and_then(|(_, problem)| problem.condition()));
            for (worker, found) in self.workers.iter_mut().zip(found) {
                worker.tally.decide(worker.method, truth.as_ref(), found.as_ref());
            }
        }
        self.decided = end;
        let took = start.elapsed().max(Duration::from_micros(1));
        let fitting = self.chunk as f64 * PIECE.div_duration_f64(took);
        self.chunk = (fitting as usize).clamp(1, 2 * self.chunk + 2);
    }

    /// Times the next methods, in turn.
    fn time(&mut self, rounds: usize, one_thread: Option<&ThreadPool>) {
        let start = Instant::now();
        while start.elapsed() < PIECE && self.timings < rounds * self.workers.len() {
            let index = self.timings % self.workers.len();
            let worker = &mut self.workers[index];
            worker.tally.times.push(self.subject.time(&mut worker.kernel, one_thread));
            let row = &mut worker.tally.row;
            (row.steps, row.steps_of_t) = worker.kernel.timed.steps().map(|[a, b]| (a, b)).unzip();
            self.timings += 1;
        }
    }
}

/// The results of one method in one case so far.
#[derive(Default)]
struct ErrorTally {
    /// The counts and the largest errors. Quantiles and shares are those of all results, at the end.
    row: MethodRow,
    /// Errors of `t` in ulps.
    ulps: Vec<f64>,
    /// Nanoseconds per pixel in each round.
    times: Vec<f64>,
}

impl ErrorTally {
    /// Counts what a method found for one ray as a right or wrong decision and, if it is right and a
    /// hit, records the errors of t and of the normal. The error of t is recorded only if the true t is
    /// a normal number in the method's precision.
    fn decide(
        &mut self,
        method: Method,
        truth: Option<&(Hit, Problem)>,
        found: Option<&MethodHit>,
    ) {
        self.row.decisions += 1;
        let unit = match method.precision() {
            Precision::F32 => f64::from(f32::EPSILON),
            Precision::F64 => f64::EPSILON,
        };
        let both = truth.zip(found).filter(|((truth, problem), found)| {
            truth.object == found.object as usize && !problem.is_other_root(truth, found.t, unit)
        });
        let Some(((truth, problem), found)) = both else {
            self.row.wrong += u64::from(truth.is_some() || found.is_some());
            return;
        };
        let t = &truth.t;
        let (ulps, is_in_range) = match method.precision() {
            Precision::F32 => (t.ulps_from_f32(found.t as f32), t.is_representable_f32()),
            Precision::F64 => (t.ulps_from(found.t), t.is_representable()),
        };
        if is_in_range {
            self.ulps.push(ulps.min(f64::MAX));
            let backward = problem.backward_error(truth, found.t).into_iter();
            self.row.backward_error_max =
                backward.chain(self.row.backward_error_max).reduce(f64::max);
        } else {
            self.row.t_out_of_range += 1;
        }
        let angle = angle_between(&truth.normal, found.normal.to_array());
        // A normal that is NaN or zero gets the largest possible error, that of the opposite of the
        // true normal.
        let angle = if angle.is_nan() { PI } else { angle };
        let largest = self.row.normal_error_max.map_or(angle, |max| max.max(angle));
        self.row.normal_error_max = Some(largest);
    }

    fn row(&self, method: Method) -> MethodRow {
        let (ulps, times) = (sorted(&self.ulps), sorted(&self.times));
        let ulp = Ulps {
            median: quantile(&ulps, 0.5),
            p99: quantile(&ulps, 0.99),
            max: ulps.last().copied(),
        };
        let MethodRow { wrong, decisions, .. } = self.row;
        MethodRow {
            name: method.name().to_owned(),
            wrong_share: (decisions > 0).then(|| wrong as f64 / decisions as f64),
            ulp,
            ulp_f64: ulp.times(match method.precision() {
                Precision::F32 => SINGLE,
                Precision::F64 => 1.0,
            }),
            ns_per_pixel: Times {
                median: quantile(&times, 0.5),
                min: times.first().copied(),
                lower_quartile: quantile(&times, 0.25),
                upper_quartile: quantile(&times, 0.75),
            },
            ..self.row.clone()
        }
    }
}

/// Returns the values in ascending order.
fn sorted(values: &[f64]) -> Vec<f64> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values
}

/// Returns the quantile of these ascending values: the smallest value such that at least a fraction
/// `share` of all values is less than or equal to it. Returns `None` if there are no values.
fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    // The product may be slightly too large because of rounding.
    let count = (share * sorted.len() as f64 * (1.0 - 1e-12)).ceil() as usize;
    sorted.get(count.max(1) - 1).copied()
}
