//! Counts one method's wrong decisions and collects its errors.

use std::f64::consts::PI;

use pinhole_core::Steps;
use pinhole_core::methods::{Method, MethodHit, Precision};
use pinhole_reference::{Hit, angle_between};

use super::condition::Problem;
use super::subject::Populations;
use crate::report::model::{MethodRow, SINGLE, Times, Ulps};

/// Results of one method in one case so far.
#[derive(Default)]
pub(super) struct Tally {
    /// Number of rays that each stratum stands for.
    populations: Populations,
    /// Decisions in each stratum.
    decisions: [u64; 2],
    /// Those that are wrong.
    wrong: [u64; 2],
    /// Errors, with the stratum of each.
    ulps: Vec<(f64, usize)>,
    /// Decisions that are right, but whose true t is out of range.
    t_out_of_range: u64,
    normal_error_max: Option<f64>,
    backward_error_max: Option<f64>,
    /// Nanoseconds a pixel, one a round.
    times: Vec<f64>,
    /// For decisions, and for `t`.
    steps: Option<[Steps; 2]>,
}

impl Tally {
    /// Nothing yet, of so many rays.
    pub(super) fn of(populations: Populations) -> Tally {
        Tally { populations, ..Tally::default() }
    }

    /// One more decision. Errors are taken where it is right; those of t, where the true t is a number
    /// of the method's precision at its full number of digits.
    pub(super) fn decide(
        &mut self,
        method: Method,
        stratum: usize,
        truth: Option<(&Hit, Option<&Problem>)>,
        found: Option<&MethodHit>,
    ) {
        self.decisions[stratum] += 1;
        let unit = match method.precision() {
            Precision::F32 => f64::from(f32::EPSILON),
            Precision::F64 => f64::EPSILON,
        };
        let (truth, problem, found) = match (truth, found) {
            (None, None) => return,
            (Some((truth, problem)), Some(found))
                if truth.object == found.object as usize
                    && !problem
                        .is_some_and(|problem| problem.is_other_root(truth, found.t, unit)) =>
            {
                (truth, problem, found)
            }
            _ => {
                self.wrong[stratum] += 1;
                return;
            }
        };
        let t = &truth.t;
        let (ulps, is_in_range) = match method.precision() {
            Precision::F32 => (t.ulps_from_f32(found.t as f32), t.is_representable_f32()),
            Precision::F64 => (t.ulps_from(found.t), t.is_representable()),
        };
        if is_in_range {
            self.ulps.push((ulps.min(f64::MAX), stratum));
            let backward = problem.and_then(|problem| problem.backward_error(truth, found.t));
            self.backward_error_max = match (self.backward_error_max, backward) {
                (Some(max), Some(error)) => Some(max.max(error)),
                (max, error) => max.or(error),
            };
        } else {
            self.t_out_of_range += 1;
        }
        let angle = angle_between(&truth.normal, found.normal.to_array());
        // A normal of no direction is as wrong as one the other way round.
        let angle = if angle.is_nan() { PI } else { angle };
        self.normal_error_max = Some(self.normal_error_max.map_or(angle, |max| max.max(angle)));
    }

    /// One more round, in nanoseconds a pixel.
    pub(super) fn time(&mut self, ns_per_pixel: f64) {
        self.times.push(ns_per_pixel);
    }

    /// Keeps how far up the ladder the last round had to go.
    pub(super) fn climb(&mut self, steps: Option<[Steps; 2]>) {
        self.steps = steps;
    }

    /// Number of rays that a decision of each stratum stands for.
    pub(super) fn weights(&self) -> [f64; 2] {
        [0, 1].map(|k| self.populations[k] as f64 / self.decisions[k].max(1) as f64)
    }

    /// Wrong decisions as a share of all rays, not of those that happen to be compared.
    fn wrong_share(&self, weights: [f64; 2]) -> Option<f64> {
        let weighted = |counts: [u64; 2]| -> f64 {
            counts.iter().zip(weights).map(|(count, weight)| *count as f64 * weight).sum()
        };
        let all = weighted(self.decisions);
        (all > 0.0).then(|| weighted(self.wrong) / all)
    }

    pub(super) fn row(&self, method: Method) -> MethodRow {
        let weights = self.weights();
        let ulps = sorted(self.ulps.iter().map(|(ulps, stratum)| (*ulps, weights[*stratum])));
        let times = sorted(self.times.iter().map(|time| (*time, 1.0)));
        let ulp = Ulps {
            median: quantile(&ulps, 0.5),
            p99: quantile(&ulps, 0.99),
            max: ulps.last().map(|(ulps, _)| *ulps),
        };
        MethodRow {
            name: method.name().to_owned(),
            wrong: self.wrong.iter().sum(),
            decisions: self.decisions.iter().sum(),
            wrong_share: self.wrong_share(weights),
            ulp,
            ulp_f64: ulp.times(match method.precision() {
                Precision::F32 => SINGLE,
                Precision::F64 => 1.0,
            }),
            normal_error_max: self.normal_error_max,
            backward_error_max: self.backward_error_max,
            t_out_of_range: self.t_out_of_range,
            // The subject knows.
            pixels_timed: 0,
            ns_per_pixel: Times {
                median: quantile(&times, 0.5),
                min: times.first().map(|(time, _)| *time),
                lower_quartile: quantile(&times, 0.25),
                upper_quartile: quantile(&times, 0.75),
            },
            steps: self.steps.map(|[decisions, _]| decisions),
            steps_of_t: self.steps.map(|[_, of_t]| of_t),
        }
    }
}

/// Values with their weights, ascending.
pub(super) fn sorted(values: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut values: Vec<_> = values.collect();
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    values
}

/// The smallest value that at least this share of the weight does not exceed.
pub(super) fn quantile(sorted: &[(f64, f64)], share: f64) -> Option<f64> {
    // Sums of weights that are whole numbers are exact; the others are a hair off.
    let all: f64 = sorted.iter().map(|(_, weight)| weight).sum();
    let mut below = 0.0;
    let reaches = |(_, weight): &&(f64, f64)| {
        below += weight;
        below >= share * all * (1.0 - 1e-12)
    };
    sorted.iter().find(reaches).or(sorted.last()).map(|(value, _)| *value)
}
