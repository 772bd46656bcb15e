//! The measured errors and run times as plain data, which `pinhole report --json` writes.
//!
//! A missing number is `None`, or `null` in JSON. For example, a method's error in t is missing if it
//! has no hit in common with the exact reference. No number is NaN or infinite: if a method returns
//! such a number for a ray that hits, this counts as a wrong decision.

use pinhole_core::Steps;
use pinhole_lecture::numbers::{grouped, short_plain};
use serde::Serialize;

/// The errors and run times of every method in every case.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Report {
    /// Description of the reference arithmetic, which computes the true results.
    pub reference: String,
    /// Description of the processor and of the vector instructions used.
    pub cpu: String,
    /// The measured cases, in order. The cases of a family are consecutive.
    pub cases: Vec<Case>,
    /// Sentences about measurements that were omitted, with the reason.
    pub left_out: Vec<String>,
    /// Description of the method to whose time the others' times are compared, and of how all were
    /// timed.
    pub baseline: String,
    /// Sentences needed to interpret the numbers.
    pub notes: Vec<String>,
    /// The seed of the families' random numbers; `None` for a scene.
    pub seed: Option<u64>,
}

/// The results for a scene, or for a stress family at one setting of its knob, the parameter that makes
/// it easier or harder.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Case {
    /// The name of the scene or of the family. All cases of a family have the same name.
    pub name: String,
    /// The setting of the knob, the parameter that makes the family easier or harder; `None` for a
    /// scene.
    pub knob: Option<f64>,
    /// The fraction of rays that hit, 0 to 1.
    pub coverage: f64,
    /// The results of each method.
    pub methods: Vec<MethodRow>,
    /// The name of the knob; empty for a scene.
    pub knob_name: String,
    /// How sensitive t is to small changes of the input, over all rays that hit.
    pub condition: Option<ConditionSpread>,
    /// A sentence about the family; empty for a scene.
    pub about: String,
}

/// Median and maximum of the condition number of t. If centre, radius, origin and direction each change
/// by a small fraction of their sizes, then t changes, relative to its size, by at most this fraction
/// times the condition number. Tangents, whose condition number is infinite, are excluded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ConditionSpread {
    /// The median: half of the condition numbers are less than or equal to it.
    pub median: f64,
    /// The largest condition number.
    pub max: f64,
}

/// The results of one method in one case.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct MethodRow {
    /// The method's name, such as `half-b-f32`.
    pub name: String,
    /// Number of rays for which the method decides differently from exact arithmetic: hit or miss,
    /// which object is first, or which of a sphere's two roots t is. The root is wrong if t is less
    /// than half as far from the other root as from the true one. Two roots that the method's precision
    /// can hardly distinguish count as one.
    pub wrong: u64,
    /// Number of all decisions.
    pub decisions: u64,
    /// The error in t, in ulps of the method's own precision, over the rays for which it decides right.
    /// [`MethodRow::ulp_f64`] contains the same errors in a common unit.
    pub ulp: Ulps,
    /// The largest angle between the method's normal and the true one, in radians.
    pub normal_error_max: Option<f64>,
    /// Run times in nanoseconds per pixel.
    pub ns_per_pixel: Times,
    /// For the ladder, the program's own exact method: number of decisions that it made in `f64`, in
    /// double-double and in exact integers. `None` for other methods.
    pub steps: Option<Steps>,
    /// The error in t, in ulps of `f64` whatever the method's precision, for comparing methods. An ulp
    /// of `f32` is 2^29 ulps of `f64`.
    pub ulp_f64: Ulps,
    /// For the ladder: number of values of `t` that it computed in `f64`, in double-double and in exact
    /// integers, if they are counted separately from decisions. A `t` that is the exact value rounded
    /// once is computed in double-double or exactly.
    pub steps_of_t: Option<Steps>,
    /// The fraction of decisions that are wrong, 0 to 1.
    pub wrong_share: Option<f64>,
    /// The largest backward error, in units of 2^-53: the method's t would be exact if centre, radius,
    /// origin and direction were each changed by at most this fraction of their sizes. To first order,
    /// the backward error times the condition number is an upper bound of the error in ulps of `f64`.
    pub backward_error_max: Option<f64>,
    /// Number of rays for which the method decides right, but whose true t is outside the range of its
    /// precision. They are excluded from the errors.
    pub t_out_of_range: u64,
    /// Number of pixels (or rays) traced in each round; [`MethodRow::steps`] counts the decisions for
    /// them.
    pub pixels_timed: u64,
}

/// The error in ulps of `f64` from which t has no correct digit, because the error is as large as t. It
/// is the same for a t computed in `f32`.
pub const NO_DIGIT: f64 = (1u64 << 53) as f64;

/// The size of an ulp of `f32` in ulps of `f64`, 2^(52 - 23), for normal numbers.
pub const SINGLE: f64 = (1u64 << 29) as f64;

/// Spread of the errors in t, in ulps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Ulps {
    /// The median: half of the errors are less than or equal to it.
    pub median: Option<f64>,
    /// The 99th percentile: 99 % of the errors are less than or equal to it.
    pub p99: Option<f64>,
    /// The largest error.
    pub max: Option<f64>,
}

impl Ulps {
    /// Multiplies each error by `count`, the number of new units in an old one, to convert it to ulps
    /// of another precision. The results are limited to [`f64::MAX`].
    pub fn times(self, count: f64) -> Ulps {
        let times = |error: Option<f64>| error.map(|error| (error * count).min(f64::MAX));
        Ulps { median: times(self.median), p99: times(self.p99), max: times(self.max) }
    }
}

/// Run times of interleaved rounds, in nanoseconds per pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// The median of the rounds.
    pub median: Option<f64>,
    /// The time of the fastest round. It is used to compare methods, since disturbances only make
    /// rounds slower.
    pub min: Option<f64>,
    /// The lower quartile: a quarter of the rounds take at most this long.
    pub lower_quartile: Option<f64>,
    /// The upper quartile: three quarters of the rounds take at most this long.
    pub upper_quartile: Option<f64>,
}

/// The precision in which a method computes. The variants are in ascending order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Digits {
    /// `f32`
    Single,
    /// `f64`
    Double,
    /// Double-double: the sum of two `f64` numbers.
    DoubleDouble,
}

/// The name of the method that computes the half-b formula in double-double.
const DOUBLE_DOUBLE: &str = "double-double";

impl Report {
    /// Appends the results of another measurement made on the same machine.
    pub fn append(&mut self, other: Report) {
        let Report { reference, cpu, cases, left_out, baseline, notes, seed } = other;
        (self.reference, self.cpu, self.baseline, self.seed) = (reference, cpu, baseline, seed);
        self.cases.extend(cases);
        for (own, lines) in [(&mut self.left_out, left_out), (&mut self.notes, notes)] {
            for line in lines {
                if !own.contains(&line) {
                    own.push(line);
                }
            }
        }
    }

    /// Returns the cases grouped by name, in order. A group is a single scene, or a family at all
    /// settings of its knob.
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
    /// Returns the case's name, followed by the setting of its knob, if any: `tiny far sphere, radius /
    /// distance = 1e-6`.
    pub fn title(&self) -> String {
        let Some(knob) = self.knob else { return self.name.clone() };
        let what = if self.knob_name.is_empty() { "knob" } else { &self.knob_name };
        format!("{}, {what} = {}", self.name, short_plain(knob))
    }
}

impl MethodRow {
    /// Returns a sentence that says how many decisions the ladder made in `f64`, in double-double and
    /// in exact integers; `None` for other methods.
    pub fn decided(&self) -> Option<String> {
        let steps = self.steps?;
        let of_t = match self.steps_of_t.unwrap_or_default() {
            Steps { double_double: 0, exact: 0, .. } => String::new(),
            of_t => {
                let [double_double, exact] = [of_t.double_double, of_t.exact].map(grouped);
                format!("; t: {double_double} in double-double, {exact} exactly")
            }
        };
        Some(format!(
            "{} decided {} in f32 or f64, {} in double-double, {} exactly{of_t}; in the {} pixels timed",
            self.name,
            grouped(steps.f64),
            grouped(steps.double_double),
            grouped(steps.exact),
            grouped(self.pixels_timed)
        ))
    }

    /// Returns the method's name without its precision, such as `half-b`; for the method
    /// `double-double`, returns `half-b`, which is the formula that it evaluates.
    pub fn formula(&self) -> &str {
        match self.name.as_str() {
            DOUBLE_DOUBLE => "half-b",
            name => name.strip_suffix("-f32").or(name.strip_suffix("-f64")).unwrap_or(name),
        }
    }

    /// Returns the precision in which the method computes.
    pub fn digits(&self) -> Digits {
        match self.name.as_str() {
            DOUBLE_DOUBLE => Digits::DoubleDouble,
            name if name.ends_with("-f32") => Digits::Single,
            _ => Digits::Double,
        }
    }
}
