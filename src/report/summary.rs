//! Summaries of the measurements of a scene, of a stress family over all settings of its knob (the
//! parameter that makes it easier or harder), and of all scenes or families together.

use super::model::{Case, Digits, MethodRow, NO_DIGIT, Report};

/// The summary of a scene or a family.
pub(crate) struct Summary<'a> {
    pub(crate) cases: Vec<&'a Case>,
    /// The methods' summaries, in the order in which the methods first occur in the cases.
    pub(crate) methods: Vec<MethodSummary<'a>>,
}

/// The summary of a method over all cases of a family: its largest error, its total number of wrong
/// decisions, and its median time. A scene has a single case.
pub(crate) struct MethodSummary<'a> {
    pub(crate) name: &'a str,
    pub(crate) formula: &'a str,
    pub(crate) digits: Digits,
    pub(crate) outcome: Option<Outcome>,
    /// The time in nanoseconds per pixel: the median, over the cases, of the fastest round's time.
    pub(crate) time: Option<f64>,
    /// The shortest and the longest time. For a family, these are the extremes, over the cases, of the
    /// fastest round's time. For a scene, they are the fastest round's time and the upper quartile.
    pub(crate) times: Option<[f64; 2]>,
    pub(crate) wrong: u64,
    pub(crate) decisions: u64,
}

/// A method's largest error in t, or the reason why it has none. The variants are in ascending order of
/// severity.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) enum Outcome {
    /// There is no error, because every true t is outside the range of the method's precision.
    OutOfRange,
    /// An error, in ulps of `f64`.
    Error(f64),
    /// An error at least as large as t.
    NoDigit,
    /// No hit in common with the reference.
    NoHit,
}

/// Returns a method's largest error in t in a case, or the reason why it has none; `None` if no ray
/// hits anything and the method finds no hit either.
pub(crate) fn outcome(row: &MethodRow) -> Option<Outcome> {
    match row.ulp_f64.max {
        Some(error) if error >= NO_DIGIT => Some(Outcome::NoDigit),
        Some(error) => Some(Outcome::Error(error)),
        None if row.t_out_of_range > 0 => Some(Outcome::OutOfRange),
        None => (row.wrong > 0).then_some(Outcome::NoHit),
    }
}

/// Returns the first one of all that have the same key, in order.
pub(crate) fn distinct<T, K: PartialEq>(
    all: impl Iterator<Item = T>,
    key: impl Fn(&T) -> K,
) -> Vec<T> {
    let mut distinct: Vec<T> = Vec::new();
    for one in all {
        if distinct.iter().all(|known| key(known) != key(&one)) {
            distinct.push(one);
        }
    }
    distinct
}

/// Returns the summaries of a report's scenes and families, in order.
pub(crate) fn summaries(report: &Report) -> Vec<Summary<'_>> {
    report.families().into_iter().map(Summary::new).collect()
}

impl<'a> Summary<'a> {
    pub(crate) fn new(mut cases: Vec<&'a Case>) -> Summary<'a> {
        cases.sort_by(|a, b| a.knob.unwrap_or(0.0).total_cmp(&b.knob.unwrap_or(0.0)));
        let names = cases.iter().flat_map(|case| &case.methods).map(|row| row.name.as_str());
        let names = distinct(names, |name| *name);
        let mut methods: Vec<MethodSummary> =
            names.into_iter().map(|name| MethodSummary::new(name, &cases)).collect();
        // If there are only planes, double-double is counted as another precision of the textbook
        // formula.
        let is_double_double = |worst: &MethodSummary| worst.digits == Digits::DoubleDouble;
        if methods.iter().all(|worst| worst.formula != "half-b" || is_double_double(worst)) {
            let alone = methods.iter_mut().filter(|worst| is_double_double(worst));
            alone.for_each(|worst| worst.formula = "textbook");
        }
        Summary { cases, methods }
    }

    /// Returns true if there are several settings of a knob, so that the error can be plotted against
    /// the knob.
    pub(crate) fn has_knob(&self) -> bool {
        self.cases.len() > 1
    }

    /// Returns all outcomes that occur in the panels.
    pub(crate) fn outcomes(&self) -> impl Iterator<Item = Outcome> {
        self.cases.iter().flat_map(|case| &case.methods).filter_map(outcome)
    }

    fn method(&self, name: &str) -> Option<&MethodSummary<'a>> {
        self.methods.iter().find(|worst| worst.name == name)
    }

    /// Returns the share of rays that hit something as text: the lowest and the highest share of the
    /// cases, or a single value if they are equal.
    pub(crate) fn coverage(&self) -> String {
        let percent =
            |share: f64| pinhole_lecture::numbers::short_plain((100.0 * share * 1e3).round() / 1e3);
        let shares = self.cases.iter().map(|case| case.coverage);
        let low = shares.clone().fold(f64::INFINITY, f64::min);
        let high = shares.fold(0.0, f64::max);
        if percent(low) == percent(high) {
            return format!("{} %", percent(low));
        }
        format!("{} to {} %", percent(low), percent(high))
    }
}

impl<'a> MethodSummary<'a> {
    fn new(name: &'a str, cases: &[&'a Case]) -> MethodSummary<'a> {
        let row_of = |case: &&'a Case| case.methods.iter().find(|row| row.name == name);
        let rows: Vec<&MethodRow> = cases.iter().filter_map(row_of).collect();
        let mut times: Vec<f64> = rows.iter().filter_map(|row| row.ns_per_pixel.min).collect();
        times.retain(|time| *time > 0.0);
        times.sort_by(f64::total_cmp);
        let last = match rows.as_slice() {
            [one] => one.ns_per_pixel.upper_quartile,
            _ => times.last().copied(),
        };
        // In a case without hits, a false hit says nothing about the accuracy of t.
        let hit = cases.iter().filter(|case| case.coverage > 0.0).filter_map(row_of);
        let worse = |a, b| if a > b { a } else { b };
        MethodSummary {
            name,
            formula: rows.first().map_or(name, |row| row.formula()),
            digits: rows.first().map_or(Digits::Double, |row| row.digits()),
            outcome: hit.filter_map(outcome).reduce(worse),
            time: middle(&times),
            times: times.first().copied().zip(last).map(|(low, high)| [low, high]),
            wrong: rows.iter().map(|row| row.wrong).sum(),
            decisions: rows.iter().map(|row| row.decisions).sum(),
        }
    }
}

/// Returns the median of ascending values. For an even number of values, it is the geometric mean of
/// the middle two.
pub(crate) fn middle(sorted: &[f64]) -> Option<f64> {
    let (low, high) = (sorted.get(sorted.len().saturating_sub(1) / 2)?, sorted[sorted.len() / 2]);
    // The geometric mean with 0 is not meaningful, so the smaller value is returned.
    Some(if *low == high || *low == 0.0 { *low } else { low.sqrt() * high.sqrt() })
}

/// The summary of all scenes or families together.
pub(crate) struct Overall<'a> {
    /// The methods, each of which is one row in the table.
    pub(crate) methods: Vec<MethodOverall<'a>>,
    /// The noun for what is summarized: `families` or `scenes`.
    pub(crate) noun: &'static str,
    /// Number of scenes or families that are summarized: those for which every method has results.
    pub(crate) shared: usize,
}

/// The summary of a method over all scenes or families. Shares, errors and times include only those for
/// which every method has results, since results of different ones cannot be compared.
pub(crate) struct MethodOverall<'a> {
    /// The method's summary for the first scene or family in which it was measured.
    pub(crate) first: &'a MethodSummary<'a>,
    pub(crate) wrong: u64,
    pub(crate) decisions: u64,
    /// The fraction of wrong decisions, averaged over the cases.
    pub(crate) share: Option<f64>,
    /// The method's largest error, or the reason why there is none, for each scene or family, in
    /// ascending order.
    pub(crate) outcomes: Vec<Outcome>,
    /// The method's time for each scene or family, in nanoseconds per pixel, in ascending order.
    pub(crate) times: Vec<f64>,
}

/// Returns the summary of every method over all scenes or families.
pub(crate) fn overall<'a>(summaries: &'a [Summary<'a>]) -> Overall<'a> {
    let all = summaries.iter().flat_map(|summary| &summary.methods);
    let all: Vec<&MethodSummary> = distinct(all, |worst| worst.name);
    let has = |summary: &Summary, worst: &&MethodSummary| summary.method(worst.name).is_some();
    let has_all = |summary: &&Summary| all.iter().all(|worst| has(summary, worst));
    let shared: Vec<&Summary> = summaries.iter().filter(has_all).collect();
    let method = |first| MethodOverall::new(first, summaries, &shared);
    let mut methods: Vec<MethodOverall> = all.iter().copied().map(method).collect();
    // The precisions of a formula are adjacent. The formulas keep the order in which they first occur.
    let place = |formula: &str| all.iter().position(|method| method.formula == formula);
    methods.sort_by_key(|method| (place(method.first.formula), method.first.digits));
    let has_knobs = summaries.iter().any(|summary| summary.cases[0].knob.is_some());
    let noun = if has_knobs { "families" } else { "scenes" };
    Overall { methods, noun, shared: shared.len() }
}

impl<'a> MethodOverall<'a> {
    fn new(
        first: &'a MethodSummary<'a>,
        summaries: &[Summary],
        shared: &[&Summary],
    ) -> MethodOverall<'a> {
        let everywhere = || summaries.iter().filter_map(|summary| summary.method(first.name));
        let cases = shared.iter().flat_map(|summary| &summary.cases);
        let rows = cases.flat_map(|case| &case.methods).filter(|row| row.name == first.name);
        let shares: Vec<f64> = rows.filter_map(|row| row.wrong_share).collect();
        let own = || shared.iter().filter_map(|summary| summary.method(first.name));
        let mut outcomes: Vec<Outcome> = own().filter_map(|worst| worst.outcome).collect();
        outcomes.retain(|outcome| *outcome != Outcome::OutOfRange);
        outcomes.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        let mut times: Vec<f64> = own().filter_map(|worst| worst.time).collect();
        times.sort_by(f64::total_cmp);
        MethodOverall {
            first,
            wrong: everywhere().map(|method| method.wrong).sum(),
            decisions: everywhere().map(|method| method.decisions).sum(),
            share: (!shares.is_empty()).then(|| shares.iter().sum::<f64>() / shares.len() as f64),
            outcomes,
            times,
        }
    }

    /// Returns the smallest, the median and the largest of the errors in `outcomes`. An error is
    /// infinite if no digit of t is correct or no hit is in common with the reference.
    pub(crate) fn errors(&self) -> Option<[f64; 3]> {
        let number = |outcome: &Outcome| match outcome {
            Outcome::Error(error) => *error,
            _ => f64::INFINITY,
        };
        least_middle_most(&self.outcomes.iter().map(number).collect::<Vec<_>>())
    }
}

/// Returns the smallest, the median and the largest of ascending values; `None` if there are no values.
pub(crate) fn least_middle_most(sorted: &[f64]) -> Option<[f64; 3]> {
    Some([*sorted.first()?, middle(sorted)?, *sorted.last()?])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::report::model::{Times, Ulps};

    fn row(name: &str, wrong: u64, error: Option<f64>, time: f64) -> MethodRow {
        let ulp_f64 = Ulps { max: error, ..Ulps::default() };
        let ns_per_pixel = Times { min: Some(time), median: Some(9.0 * time), ..Times::default() };
        let (name, wrong_share) = (name.to_owned(), Some(wrong as f64 / 100.0));
        MethodRow {
            name,
            wrong,
            decisions: 100,
            wrong_share,
            ulp_f64,
            ns_per_pixel,
            ..MethodRow::default()
        }
    }

    fn case(name: &str, knob: f64, methods: Vec<MethodRow>) -> Case {
        Case { name: name.to_owned(), knob: Some(knob), coverage: 0.5, methods, ..Case::default() }
    }

    /// Shares of wrong decisions are averaged only over families that all methods have. A family of
    /// planes has fewer methods, and must not worsen their shares.
    #[test]
    fn shares_are_of_what_all_have() {
        let both =
            |wrong: u64| vec![row("a-f64", wrong, None, 1.0), row("b-f64", wrong, None, 1.0)];
        let cases = vec![
            case("spheres", 1.0, both(10)),
            case("spheres", 2.0, both(30)),
            case("planes", 1.0, vec![row("a-f64", 90, None, 1.0)]),
        ];
        let report = Report { cases, ..Report::default() };
        let summaries = summaries(&report);
        let all = overall(&summaries);
        assert_eq!((all.noun, all.shared), ("families", 1));
        assert!(all.methods.iter().all(|m| (m.share.unwrap() - 0.2).abs() < 1e-12));
        assert_eq!(all.methods[0].wrong, 130);
    }

    #[test]
    fn of_two_in_the_middle_it_is_their_mean() {
        assert_eq!(middle(&[]), None);
        assert_eq!(middle(&[3.0]), Some(3.0));
        assert_eq!(middle(&[1.0, 4.0, 9.0, 10.0]), Some(6.0));
        assert_eq!(middle(&[0.0, f64::INFINITY]), Some(0.0));
        assert_eq!(middle(&[f64::INFINITY; 2]), Some(f64::INFINITY));
    }

    /// The summary has the worst outcome over all settings, except those in which no ray hits anything,
    /// and the median time.
    #[test]
    fn the_worst_setting_counts_and_the_middle_time() {
        let settings = [(Some(2.0), 1.0), (None, 4.0), (Some(1e17), 9.0), (None, 16.0)];
        let mut cases: Vec<Case> = (0..4)
            .map(|k| {
                let (error, time) = settings[k];
                case("hard", k as f64, vec![row("a-f64", 1, error, time)])
            })
            .collect();
        cases[3].coverage = 0.0;
        let worst_of = |cases: &[Case]| {
            let report = Report { cases: cases.to_vec(), ..Report::default() };
            let worst = summaries(&report).remove(0).methods.remove(0);
            (worst.outcome, worst.time, worst.times)
        };
        let expected = (Some(Outcome::NoHit), Some(6.0), Some([1.0, 16.0]));
        assert_eq!(worst_of(&cases), expected);
        cases.remove(1);
        assert_eq!(worst_of(&cases).0, Some(Outcome::NoDigit));
        cases.remove(1);
        assert_eq!(worst_of(&cases).0, Some(Outcome::Error(2.0)));
    }
}
