//! The summary that a row of panels shows: of a scene, or of a family over all settings of its knob.

use crate::report::model::{Case, Digits, MethodRow, Report};

/// A scene or a family.
pub(crate) struct Summary<'a> {
    pub(crate) cases: Vec<&'a Case>,
    /// The methods, in their order.
    pub(crate) methods: Vec<Worst<'a>>,
}

/// A method over all cases of a family: errors at their worst, wrong decisions all together, the
/// time in the middle. One case is its own worst.
pub(crate) struct Worst<'a> {
    pub(crate) name: &'a str,
    pub(crate) formula: &'a str,
    pub(crate) digits: Digits,
    /// Ulps of `f64`.
    pub(crate) max: Option<f64>,
    /// Nanoseconds a pixel.
    pub(crate) time: Option<f64>,
    /// The least lower and the greatest upper quartile of the rounds of all cases.
    pub(crate) spread: Option<[f64; 2]>,
    pub(crate) wrong: u64,
    pub(crate) decisions: u64,
}

/// Returns the summaries of a report, in order.
pub(crate) fn summaries(report: &Report) -> Vec<Summary<'_>> {
    report.families().into_iter().map(Summary::new).collect()
}

impl<'a> Summary<'a> {
    fn new(mut cases: Vec<&'a Case>) -> Summary<'a> {
        cases.sort_by(|a, b| a.knob.unwrap_or(0.0).total_cmp(&b.knob.unwrap_or(0.0)));
        let mut names: Vec<&str> = Vec::new();
        for row in cases.iter().flat_map(|case| &case.methods) {
            if !names.contains(&row.name.as_str()) {
                names.push(&row.name);
            }
        }
        let methods = names.into_iter().map(|name| Worst::new(name, &cases)).collect();
        Summary { cases, methods }
    }

    /// Returns whether there is a curve over a knob to show.
    pub(crate) fn has_knob(&self) -> bool {
        self.cases.len() > 1
    }

    /// Every error that some panel shows, in ulps of `f64`.
    pub(crate) fn errors(&self) -> impl Iterator<Item = f64> {
        let rows = self.cases.iter().flat_map(|case| &case.methods);
        rows.filter_map(|row| row.ulp_f64.max)
    }

    /// A method in every case that has it, by the knob.
    pub(crate) fn along_knob(&self, name: &str) -> impl Iterator<Item = (f64, &'a MethodRow)> {
        self.cases.iter().filter_map(move |case| {
            let row = case.methods.iter().find(|row| row.name == name)?;
            Some((case.knob?, row))
        })
    }

    /// Coverage, from the least to the most, as text.
    pub(crate) fn coverage(&self) -> String {
        let percent =
            |share: f64| crate::model::number::short_plain((100.0 * share * 1e3).round() / 1e3);
        let shares = self.cases.iter().map(|case| case.coverage);
        let low = shares.clone().fold(f64::INFINITY, f64::min);
        let high = shares.fold(0.0, f64::max);
        if percent(low) == percent(high) {
            return format!("{} %", percent(low));
        }
        format!("{} to {} %", percent(low), percent(high))
    }
}

impl<'a> Worst<'a> {
    fn new(name: &'a str, cases: &[&'a Case]) -> Worst<'a> {
        let rows: Vec<&MethodRow> = cases
            .iter()
            .filter_map(|case| case.methods.iter().find(|row| row.name == name))
            .collect();
        let all =
            |number: fn(&MethodRow) -> Option<f64>| rows.iter().filter_map(move |row| number(row));
        let mut times: Vec<f64> = all(|row| row.ns_per_pixel.median).collect();
        times.sort_by(f64::total_cmp);
        let low = all(|row| row.ns_per_pixel.lower_quartile).reduce(f64::min);
        let high = all(|row| row.ns_per_pixel.upper_quartile).reduce(f64::max);
        Worst {
            name,
            formula: rows.first().map_or(name, |row| row.formula()),
            digits: rows.first().map_or(Digits::Double, |row| row.digits()),
            max: all(|row| row.ulp_f64.max).reduce(f64::max),
            time: times.get(times.len() / 2).copied().filter(|time| *time > 0.0),
            spread: low.zip(high).map(|(low, high)| [low, high]),
            wrong: rows.iter().map(|row| row.wrong).sum(),
            decisions: rows.iter().map(|row| row.decisions).sum(),
        }
    }

    /// Returns whether the other is at least as fast and as close, and better in one of them; both
    /// decide all right.
    fn is_beaten_by(&self, other: &Worst) -> bool {
        let numbers = |worst: &Worst| worst.time.zip(worst.max).filter(|_| worst.wrong == 0);
        let (Some(own), Some(others)) = (numbers(self), numbers(other)) else { return false };
        others.0 <= own.0 && others.1 <= own.1 && others != own
    }
}

/// The Pareto front: of the methods that decide all right, those that no other one beats in both time
/// and error; the fastest first.
pub(crate) fn front<'a, 'b>(methods: &'b [Worst<'a>]) -> Vec<&'b Worst<'a>> {
    let is_first = |method: &&Worst| {
        let is_right = method.wrong == 0 && method.time.is_some() && method.max.is_some();
        is_right && !methods.iter().any(|other| method.is_beaten_by(other))
    };
    let mut front: Vec<&Worst> = methods.iter().filter(is_first).collect();
    front.sort_by(|a, b| a.time.unwrap_or(0.0).total_cmp(&b.time.unwrap_or(0.0)));
    front
}

/// A method over all families: for the summary, a line each.
pub(crate) struct Overall<'a> {
    pub(crate) name: &'a str,
    pub(crate) formula: &'a str,
    pub(crate) digits: Digits,
    pub(crate) wrong: u64,
    pub(crate) decisions: u64,
    /// The largest error of each family that all methods share, ascending; ulps of `f64`.
    pub(crate) errors: Vec<f64>,
    /// The time of each of those families, ascending; nanoseconds a pixel.
    pub(crate) times: Vec<f64>,
}

/// Returns every method over all families, and the number of families that all of them share: errors
/// and times of different families are not compared.
pub(crate) fn overall<'a>(summaries: &[Summary<'a>]) -> (Vec<Overall<'a>>, usize) {
    let mut methods: Vec<Overall> = Vec::new();
    for worst in summaries.iter().flat_map(|summary| &summary.methods) {
        let known = methods.iter_mut().find(|method| method.name == worst.name);
        match known {
            Some(method) => {
                method.wrong += worst.wrong;
                method.decisions += worst.decisions;
            }
            None => methods.push(Overall {
                name: worst.name,
                formula: worst.formula,
                digits: worst.digits,
                wrong: worst.wrong,
                decisions: worst.decisions,
                errors: Vec::new(),
                times: Vec::new(),
            }),
        }
    }
    let is_shared = |summary: &&Summary| summary.methods.len() == methods.len();
    let shared: Vec<&Summary> = summaries.iter().filter(is_shared).collect();
    for method in &mut methods {
        let own = || shared.iter().flat_map(|s| &s.methods).filter(|m| m.name == method.name);
        let mut errors: Vec<f64> = own().filter_map(|worst| worst.max).collect();
        let mut times: Vec<f64> = own().filter_map(|worst| worst.time).collect();
        errors.sort_by(f64::total_cmp);
        times.sort_by(f64::total_cmp);
        (method.errors, method.times) = (errors, times);
    }
    // Each formula's precisions beside each other, the formulas in the order in which they came.
    let order: Vec<&str> = methods.iter().map(|method| method.formula).collect();
    methods.sort_by_key(|m| (order.iter().position(|formula| *formula == m.formula), m.digits));
    (methods, shared.len())
}
