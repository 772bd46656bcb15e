//! The summary that a row of panels shows: of a scene, or of a family over all settings of its knob.

use crate::report::model::{Case, MethodRow, Report};

/// An ulp of `f32` in ulps of `f64`: 2^(52 - 23), wherever both are normal numbers.
pub(crate) const SINGLE: f64 = (1u64 << 29) as f64;

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
    /// Without the precision.
    pub(crate) family: &'a str,
    pub(crate) single: bool,
    /// Ulps of `f64`.
    pub(crate) p99: Option<f64>,
    /// Ulps of `f64`.
    pub(crate) max: Option<f64>,
    /// Nanoseconds a pixel.
    pub(crate) time: Option<f64>,
    pub(crate) wrong: u64,
    pub(crate) decisions: u64,
}

/// Returns the summaries of a report, in order.
pub(crate) fn summaries(report: &Report) -> Vec<Summary<'_>> {
    report.families().into_iter().map(Summary::new).collect()
}

/// An error in ulps of `f64`, so that all methods stand on one scale.
pub(crate) fn in_ulps_of_f64(row: &MethodRow, error: Option<f64>) -> Option<f64> {
    let unit = if row.is_single() { SINGLE } else { 1.0 };
    error.map(|error| error * unit).filter(|error| error.is_finite())
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
        rows.flat_map(|row| [row.ulp.p99, row.ulp.max].map(|error| in_ulps_of_f64(row, error)))
            .flatten()
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
        let worst = |error: fn(&MethodRow) -> Option<f64>| {
            rows.iter().filter_map(|row| in_ulps_of_f64(row, error(row))).reduce(f64::max)
        };
        let mut times: Vec<f64> = rows.iter().filter_map(|row| row.ns_per_pixel.median).collect();
        times.sort_by(f64::total_cmp);
        Worst {
            name,
            family: rows.first().map_or(name, |row| row.family()),
            single: rows.first().is_some_and(|row| row.is_single()),
            p99: worst(|row| row.ulp.p99),
            max: worst(|row| row.ulp.max),
            time: times.get(times.len() / 2).copied(),
            wrong: rows.iter().map(|row| row.wrong).sum(),
            decisions: rows.iter().map(|row| row.decisions).sum(),
        }
    }
}
