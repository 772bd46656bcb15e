//! Counts one method's wrong decisions and collects its errors.

use std::f64::consts::PI;

use pinhole_core::methods::{Method, MethodHit, Precision};
use pinhole_reference::{Hit, angle_between};

use crate::report::model::{MethodRow, Steps, Times, Ulps};

/// Results of one method in one case so far.
#[derive(Default)]
pub(super) struct Tally {
    decisions: u64,
    wrong: u64,
    ulps: Vec<f64>,
    normal_error_max: Option<f64>,
    /// Nanoseconds a pixel, one a round.
    times: Vec<f64>,
    steps: Option<Steps>,
}

impl Tally {
    /// One more decision. Errors are taken where it is right; that of t, where the true t is a number
    /// of the method's precision at its full number of digits.
    pub(super) fn decide(
        &mut self,
        method: Method,
        truth: Option<&Hit>,
        found: Option<&MethodHit>,
    ) {
        self.decisions += 1;
        let (truth, found) = match (truth, found) {
            (None, None) => return,
            (Some(truth), Some(found)) if truth.object == found.object as usize => (truth, found),
            _ => {
                self.wrong += 1;
                return;
            }
        };
        match method.precision() {
            Precision::F32 if truth.t.is_representable_f32() => {
                self.ulps.push(truth.t.ulps_from_f32(found.t as f32));
            }
            Precision::F64 if truth.t.is_representable() => {
                self.ulps.push(truth.t.ulps_from(found.t));
            }
            _ => {}
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
    pub(super) fn climb(&mut self, steps: Option<pinhole_core::Steps>) {
        self.steps = steps.map(|steps| Steps {
            f64: steps.f64,
            double_double: steps.double_double,
            exact: steps.exact,
        });
    }

    pub(super) fn row(&self, method: Method) -> MethodRow {
        let ulps = sorted(&self.ulps);
        let times = sorted(&self.times);
        MethodRow {
            name: method.name().to_owned(),
            wrong: self.wrong,
            decisions: self.decisions,
            ulp: Ulps {
                median: quantile(&ulps, 0.5),
                p99: quantile(&ulps, 0.99),
                max: ulps.last().copied(),
            },
            normal_error_max: self.normal_error_max,
            ns_per_pixel: Times { median: quantile(&times, 0.5), min: times.first().copied() },
            steps: self.steps,
        }
    }
}

fn sorted(values: &[f64]) -> Vec<f64> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values
}

/// The smallest value that at least this share of them do not exceed.
fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied()
}
