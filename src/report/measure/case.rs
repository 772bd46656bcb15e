//! One case under way: its rays decided by the reference and every method, its frames timed.

use std::time::{Duration, Instant};

use pinhole_core::methods::{Method, MethodHit};
use rayon::ThreadPool;
use rayon::prelude::*;

use super::condition::Problem;
use super::subject::{Kernel, Subject};
use super::tally::{Tally, quantile, sorted};
use crate::report::model::{Case, Condition, MethodRow};

/// One case: to come, under way or done.
pub(super) struct CaseRun {
    /// The case, with results once it is done.
    case: Case,
    limits: Limits,
    make: Option<Box<dyn FnOnce() -> Work + Send>>,
    work: Option<Work>,
    left_out: Option<String>,
}

/// The amount of work for a case: the same on every machine, however busy it is.
pub(super) struct Limits {
    /// Number of times that every method is timed.
    pub(super) rounds: usize,
    /// Number of pieces of work that it counts as.
    pub(super) pieces: usize,
}

/// The parts of a case, made when its turn comes.
pub(super) struct Work {
    sets: Vec<Set>,
    /// The share of rays that hit, where it is known; else that of the rays decided.
    coverage: Option<f64>,
    /// A sentence about what is not decided.
    left_out: Option<String>,
    is_timing_next: bool,
}

/// Rays and the methods that follow them.
pub(super) struct Set {
    subject: Subject,
    workers: Vec<Worker>,
    decided: usize,
    hits: usize,
    /// Condition numbers of `t`, with the stratum of each.
    conditions: Vec<(f64, usize)>,
    /// Number of rays to decide at a time.
    chunk: usize,
    /// Number of measurements of time made, of all methods together.
    timings: usize,
}

struct Worker {
    method: Method,
    kernel: Kernel,
    tally: Tally,
}

/// Aim for the time of a piece of work.
const PIECE: Duration = Duration::from_millis(4);

impl CaseRun {
    /// Will measure a case, whose parts are made when its turn comes.
    pub(super) fn new(
        case: Case,
        limits: Limits,
        make: impl FnOnce() -> Work + Send + 'static,
    ) -> CaseRun {
        CaseRun { case, limits, make: Some(Box::new(make)), work: None, left_out: None }
    }

    pub(super) fn total(&self) -> usize {
        self.limits.pieces
    }

    pub(super) fn done(&self) -> usize {
        let Limits { rounds, pieces } = self.limits;
        match &self.work {
            Some(work) => ((work.share(rounds) * pieces as f64) as usize).min(pieces),
            None if self.has_begun() => pieces,
            None => 0,
        }
    }

    pub(super) fn has_begun(&self) -> bool {
        self.make.is_none()
    }

    pub(super) fn is_done(&self) -> bool {
        let is_over = |work: &Work| work.share(self.limits.rounds) >= 1.0;
        self.work.as_ref().map_or(self.has_begun(), is_over)
    }

    /// Does one piece of work.
    pub(super) fn step(&mut self, one_thread: Option<&ThreadPool>) {
        if let Some(make) = self.make.take() {
            self.work = Some(make());
        } else if let Some(work) = &mut self.work {
            work.step(self.limits.rounds, one_thread);
        }
    }

    /// Keeps the results and drops all else.
    pub(super) fn finish(&mut self) {
        (self.case, self.left_out, self.work) = (self.report(), self.left_out(), None);
    }

    pub(super) fn left_out(&self) -> Option<String> {
        match &self.work {
            Some(work) => work.left_out.clone(),
            None => self.left_out.clone(),
        }
    }

    pub(super) fn report(&self) -> Case {
        let Some(work) = &self.work else { return self.case.clone() };
        let rows_of = |set: &Set| {
            let pixels_timed = set.subject.pixels_timed() as u64;
            let row = |w: &Worker| MethodRow { pixels_timed, ..w.tally.row(w.method) };
            set.workers.iter().map(|w| (w.method, row(w))).collect::<Vec<_>>()
        };
        let mut rows: Vec<_> = work.sets.iter().flat_map(rows_of).collect();
        let index = |method| Method::of_frames().position(|other| other == method);
        rows.sort_by_key(|(method, _)| index(*method));
        Case {
            coverage: work.coverage(),
            condition: work.sets.first().and_then(Set::condition),
            condition_f32: work.sets.get(1).and_then(Set::condition),
            methods: rows.into_iter().map(|(_, row)| row).collect(),
            ..self.case.clone()
        }
    }
}

impl Work {
    pub(super) fn new(sets: Vec<Set>, coverage: Option<f64>, left_out: Option<String>) -> Work {
        Work { sets, coverage, left_out, is_timing_next: false }
    }

    /// Share of the work that is done, up to 1.
    fn share(&self, rounds: usize) -> f64 {
        let sum = |count: &dyn Fn(&Set) -> usize| self.sets.iter().map(count).sum::<usize>();
        let all = sum(&|set| set.subject.len() + rounds * set.workers.len());
        let done = sum(&|set| set.decided + set.timings);
        if all == 0 { 1.0 } else { done as f64 / all as f64 }
    }

    fn coverage(&self) -> f64 {
        if let Some(coverage) = self.coverage {
            return coverage;
        }
        let sum = |count: fn(&Set) -> usize| self.sets.iter().map(count).sum::<usize>() as f64;
        let decided = sum(|set| set.decided);
        if decided == 0.0 { 0.0 } else { sum(|set| set.hits) / decided }
    }

    /// Decides some rays and takes some times, in turn.
    fn step(&mut self, rounds: usize, one_thread: Option<&ThreadPool>) {
        let to_time = self.sets.iter().any(|set| set.timings < rounds * set.workers.len());
        let to_decide = self.sets.iter().any(|set| set.decided < set.subject.len());
        if to_time && (self.is_timing_next || !to_decide) {
            // The set that is behind, so that all of them are timed in turn.
            let behind = self.sets.iter_mut().min_by_key(|set| set.round());
            if let Some(set) = behind {
                set.time(rounds, one_thread);
            }
        } else {
            let behind = self.sets.iter_mut().filter(|set| set.decided < set.subject.len());
            if let Some(set) = behind.min_by_key(|set| set.decided) {
                set.decide();
            }
        }
        self.is_timing_next = !self.is_timing_next;
    }
}

impl Set {
    pub(super) fn new(subject: Subject, methods: impl IntoIterator<Item = Method>) -> Set {
        let worker = |method: Method| {
            let kernel = subject.kernel(method)?;
            Some(Worker { method, kernel, tally: Tally::of(subject.populations()) })
        };
        let workers = methods.into_iter().filter_map(worker).collect();
        Set { subject, workers, decided: 0, hits: 0, conditions: Vec::new(), chunk: 4, timings: 0 }
    }

    /// Spread of the condition numbers.
    fn condition(&self) -> Option<Condition> {
        let weights = self.workers.first()?.tally.weights();
        let weighted = self.conditions.iter().map(|(x, stratum)| (*x, weights[*stratum]));
        let sorted = sorted(weighted);
        let (max, _) = sorted.last()?;
        Some(Condition { median: quantile(&sorted, 0.5)?, max: *max })
    }

    /// Number of the round that it is in.
    fn round(&self) -> usize {
        self.timings / self.workers.len().max(1)
    }

    /// Follows the next rays by the reference and all methods.
    fn decide(&mut self) {
        let start = Instant::now();
        let end = (self.decided + self.chunk).min(self.subject.len());
        let follow = |index: usize| {
            let found = |worker: &Worker| self.subject.found(&worker.kernel, index);
            let found: Vec<Option<MethodHit>> = self.workers.iter().map(found).collect();
            let truth = self.subject.truth(index);
            let problem = truth.as_ref().and_then(|truth| self.subject.problem(index, truth));
            (truth, problem, found)
        };
        let answers: Vec<_> = (self.decided..end).into_par_iter().map(follow).collect();
        for (index, (truth, problem, found)) in (self.decided..end).zip(answers) {
            self.hits += usize::from(truth.is_some());
            let stratum = self.subject.stratum(index);
            if let Some(condition) = problem.as_ref().and_then(Problem::condition) {
                self.conditions.push((condition, stratum));
            }
            let truth = truth.as_ref().map(|truth| (truth, problem.as_ref()));
            for (worker, found) in self.workers.iter_mut().zip(found) {
                worker.tally.decide(worker.method, stratum, truth, found.as_ref());
            }
        }
        self.decided = end;
        let took = start.elapsed().max(Duration::from_micros(1));
        let fitting = self.chunk as f64 * PIECE.div_duration_f64(took);
        self.chunk = (fitting as usize).clamp(1, 2 * self.chunk + 2);
    }

    /// Takes the times of the next methods in turn.
    fn time(&mut self, rounds: usize, one_thread: Option<&ThreadPool>) {
        let start = Instant::now();
        while start.elapsed() < PIECE && self.timings < rounds * self.workers.len() {
            let index = self.timings % self.workers.len();
            let worker = &mut self.workers[index];
            worker.tally.time(self.subject.time(&mut worker.kernel, one_thread));
            worker.tally.climb(worker.kernel.steps());
            self.timings += 1;
        }
    }
}
