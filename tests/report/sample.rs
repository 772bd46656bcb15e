//! A report as it may come out of a run: a scene, and a family with a knob.

use pinhole::report::model::{Case, ConditionSpread, MethodRow, Report, SINGLE, Times, Ulps};
use pinhole_core::Steps;

/// Name, ns a pixel, and what it is like at its best and its worst.
const METHODS: [(&str, f64, f64); 17] = [
    ("ladder-f32", 2.1, 0.9),
    ("ladder", 10.2, 0.5),
    ("double-double", 24.7, 0.5),
    ("textbook-f32", 3.9, 65_000.0),
    ("textbook-f64", 4.4, 65_000.0),
    ("half-b-f32", 5.0, 64_000.0),
    ("half-b-f64", 5.3, 64_000.0),
    ("kahan-f32", 5.2, 61_000.0),
    ("kahan-f64", 5.6, 61_000.0),
    ("perpendicular-f32", 7.0, 310.0),
    ("perpendicular-f64", 7.6, 290.0),
    ("closest-point-f32", 5.1, 420.0),
    ("closest-point-f64", 5.5, 450.0),
    ("recentred-f32", 6.0, 95.0),
    ("recentred-f64", 6.5, 99.0),
    ("lagrange-f32", 6.2, 21.0),
    ("lagrange-f64", 6.7, 24.0),
];

/// A scene that is easy, and tiny far spheres, ever smaller.
pub(crate) fn report() -> Report {
    let mut cases = vec![case("canonical", None, 0.0)];
    let knobs = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12];
    cases.extend(
        knobs
            .iter()
            .enumerate()
            .map(|(hardness, knob)| case("tiny far sphere", Some(*knob), hardness as f64)),
    );
    Report {
        reference: "dashu-float, 420 bits".to_owned(),
        cpu: "Some processor, AVX2 and FMA there, one thread".to_owned(),
        cases,
        left_out: vec![
            "planes: canonical has none".to_owned(),
            "rays from inside a sphere: the eye is outside".to_owned(),
        ],
        baseline: "textbook-f32: both roots, the same loop over the same rays".to_owned(),
        notes: vec!["an f32 method rounds what it is given".to_owned()],
        seed: Some(7),
    }
}

fn steps(f64: u64, double_double: u64, exact: u64) -> Steps {
    let mut steps = Steps::default();
    (steps.f64, steps.double_double, steps.exact) = (f64, double_double, exact);
    steps
}

fn case(name: &str, knob: Option<f64>, hardness: f64) -> Case {
    let row = |&(method, time, error): &(&str, f64, f64)| {
        let growth = if error < 1.0 { 1.0 } else { (1.0 + 0.3 * error).powf(0.35 * hardness) };
        let max = if error < 1.0 { error } else { 2.0 * growth };
        let lost = method == "textbook-f32" && hardness > 4.0;
        let wrong = if error > 1.0 { (hardness * error.log10() * 30.0) as u64 } else { 0 };
        let some = |x: f64| (!lost).then_some(x);
        let ulp = Ulps {
            median: if knob.is_none() { some(0.0) } else { some(0.2 * max) },
            p99: some(0.8 * max),
            max: if method == "lagrange-f64" && knob.is_none() { Some(0.0) } else { some(max) },
        };
        let wrong = if method.ends_with("f32") { wrong } else { wrong / 40 };
        MethodRow {
            name: method.to_owned(),
            wrong,
            backward_error_max: some(0.3 * error),
            wrong_share: Some(wrong as f64 / 4096.0),
            decisions: 4096,
            ulp,
            ulp_f64: ulp.times(if method.ends_with("f32") { SINGLE } else { 1.0 }),
            normal_error_max: some(3e-16 * max),
            ns_per_pixel: Times {
                median: Some(time),
                min: Some(0.9 * time),
                lower_quartile: Some(0.95 * time),
                upper_quartile: Some(1.1 * time),
            },
            steps: method
                .starts_with("ladder")
                .then(|| steps(4096 - 10 * hardness as u64, 9 * hardness as u64, hardness as u64)),
            steps_of_t: (method == "ladder")
                .then(|| steps(0, 800 - 7 * hardness as u64, 7 * hardness as u64)),
            pixels_timed: 4096,
            t_out_of_range: 0,
        }
    };
    Case {
        name: name.to_owned(),
        knob,
        coverage: 0.196 / (1.0 + hardness),
        methods: METHODS.iter().map(row).collect(),
        condition: Some(ConditionSpread { median: 9.5, max: 1.0 / (0.1 + hardness) + 40.0 }),
        knob_name: knob.map_or("", |_| "radius / distance").to_owned(),
        about: knob.map_or("", |_| "A sphere that is tiny for its distance.").to_owned(),
    }
}
