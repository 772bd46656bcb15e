//! A report as plain data, in the very shape in which `report --json` writes it.
//!
//! Numbers that do not exist, such as the error in t where no hit is in common with the truth, are
//! `None`, which is `null` in JSON. No number is NaN or infinite: a method that answers so for a ray
//! that hits has decided wrong, and is counted there.

use serde::{Deserialize, Serialize};

/// Error against run time, of every method in every case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The arithmetic that says what is true.
    pub reference: String,
    /// The processor, and which of its features were used.
    pub cpu: String,
    /// The cases measured, in order; the cases of a family follow each other.
    pub cases: Vec<Case>,
    /// Sentences about what the cases do not need and so was not run.
    pub left_out: Vec<String>,
    /// The method and the loop that times are to be compared with.
    pub baseline: String,
}

/// One scene, or a stress family at one setting of its knob.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// The scene, or the family, whose cases share the name.
    pub name: String,
    /// The setting that makes the family easier or harder; a scene has none.
    pub knob: Option<f64>,
    /// The share of rays that hit, 0 to 1.
    pub coverage: f64,
    /// Results of each method.
    pub methods: Vec<MethodRow>,
    /// Name of the knob; empty without one.
    #[serde(default)]
    pub knob_name: String,
}

/// Results of one method in one case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodRow {
    /// The method's name, such as `half-b-f32`.
    pub name: String,
    /// Decisions (hit or miss, which object is first) that are not what exact arithmetic gives.
    pub wrong: u64,
    /// All decisions.
    pub decisions: u64,
    /// The error in t, in ulps of the method's own precision, over the rays that truth and method
    /// decide alike.
    pub ulp: Ulps,
    /// The largest angle between the method's normal and the true one, in radians.
    pub normal_error_max: Option<f64>,
    /// Nanoseconds a pixel.
    pub ns_per_pixel: Times,
    /// Decisions by each step of the ladder; the ladder alone has steps.
    pub steps: Option<Steps>,
}

/// Spread of the errors in t, in ulps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ulps {
    /// Half of the errors are at most this.
    pub median: Option<f64>,
    /// 99 of 100 are at most this.
    pub p99: Option<f64>,
    /// All are at most this.
    pub max: Option<f64>,
}

/// Run times of interleaved rounds, in nanoseconds a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// The middle one.
    pub median: Option<f64>,
    /// The shortest one.
    pub min: Option<f64>,
}

/// Decisions by each step of the ladder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Steps {
    /// Decided in `f64`.
    pub f64: u64,
    /// Decided in double-double.
    pub double_double: u64,
    /// Decided exactly.
    pub exact: u64,
}

impl Report {
    /// Takes in what another run measured on the same machine.
    pub fn append(&mut self, other: Report) {
        let Report { reference, cpu, cases, left_out, baseline } = other;
        (self.reference, self.cpu, self.baseline) = (reference, cpu, baseline);
        self.cases.extend(cases);
        for line in left_out {
            if !self.left_out.contains(&line) {
                self.left_out.push(line);
            }
        }
    }

    /// The cases by name, in order: a scene alone, a family with all its knobs.
    pub fn families(&self) -> Vec<Vec<&Case>> {
        let mut families: Vec<Vec<&Case>> = Vec::new();
        for case in &self.cases {
            match families.iter_mut().find(|family| family[0].name == case.name) {
                Some(family) if case.knob.is_some() => family.push(case),
                _ => families.push(vec![case]),
            }
        }
        families
    }
}

impl Case {
    /// Returns the name, with the knob where it has one: `tiny far sphere, radius / distance = 1e-6`.
    pub fn title(&self) -> String {
        let Some(knob) = self.knob else { return self.name.clone() };
        let what = if self.knob_name.is_empty() { "knob" } else { &self.knob_name };
        format!("{}, {what} = {}", self.name, crate::model::number::short_plain(knob))
    }
}

impl MethodRow {
    /// A sentence that says by which steps of the ladder the method decided, where it has steps.
    pub fn decided(&self) -> Option<String> {
        let steps = self.steps?;
        Some(format!(
            "{} decided {} in f64, {} in double-double, {} exactly, in all that was timed",
            self.name, steps.f64, steps.double_double, steps.exact
        ))
    }

    /// Wrong decisions as a share of all, 0 to 1; `None` where there are none at all.
    pub fn wrong_share(&self) -> Option<f64> {
        (self.decisions > 0).then(|| self.wrong as f64 / self.decisions as f64)
    }

    /// Returns whether it computes in single precision.
    pub fn is_single(&self) -> bool {
        self.name.ends_with("-f32")
    }

    /// The name without the precision: `half-b`.
    pub fn family(&self) -> &str {
        self.name.strip_suffix("-f32").or(self.name.strip_suffix("-f64")).unwrap_or(&self.name)
    }
}
