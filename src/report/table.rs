//! The report as text, in aligned columns, for a terminal of 120 columns.

use std::fmt::Write as _;

use super::model::{Case, Condition, MethodRow, Report};
use crate::model::number::short_plain as short;
use crate::report::columns::{aligned, widths, wrapped};

/// Maximum width of a line, in characters.
const WIDTH: usize = 118;

/// The names of the columns.
const COLUMNS: [&str; 12] = [
    "method", "wrong", "share", "median", "p99", "max", "max", "max", "normal", "median", "min",
    "× base",
];

/// What the columns of errors are.
const READING: &str = "errors in t in ulps of f64, of which an ulp of f32 is 2^29, and the largest one in \
    ulps of the method's own precision; backward: the share of their sizes, in units of 2^-53, by which \
    centre, radius, origin and direction move to make that t exact; an error in ulps of f64 is, to first order, at most \
    the problem's condition times it";

/// The whole report.
pub fn to_table(report: &Report) -> String {
    let mut out = String::new();
    for (name, text) in
        [("reference", &report.reference), ("cpu", &report.cpu), ("baseline", &report.baseline)]
    {
        if !text.is_empty() {
            wrapped(&mut out, WIDTH, &format!("{name:<10} "), text);
        }
    }
    if !report.cases.is_empty() {
        wrapped(&mut out, WIDTH, "reading    ", READING);
    }
    for case in &report.cases {
        out.push('\n');
        block(&mut out, case, baseline_of(report, case));
    }
    if report.cases.len() > 1 {
        totals(&mut out, report);
    }
    if !report.left_out.is_empty() {
        out.push_str("\nleft out:\n");
        for line in &report.left_out {
            wrapped(&mut out, WIDTH, "  ", line);
        }
    }
    out
}

/// Each method's wrong decisions in all cases together: what is left when the cases have scrolled by.
fn totals(out: &mut String, report: &Report) {
    let mut totals: Vec<(&str, u64, u64)> = Vec::new();
    for row in report.cases.iter().flat_map(|case| &case.methods) {
        match totals.iter_mut().find(|(name, ..)| *name == row.name) {
            Some((_, wrong, decisions)) => {
                *wrong += row.wrong;
                *decisions += row.decisions;
            }
            None => totals.push((&row.name, row.wrong, row.decisions)),
        }
    }
    let _ = writeln!(out, "\nall {} together: wrong of decisions", report.cases.len());
    for (name, wrong, decisions) in totals {
        let _ = writeln!(out, "{name:<18}{wrong:>9} of {decisions}");
    }
}

/// The time that the others are compared with: that of the method which the baseline's text begins
/// with.
fn baseline_of(report: &Report, case: &Case) -> Option<f64> {
    let name = report.baseline.split([' ', ',', ':']).next()?;
    let row = case.methods.iter().find(|row| row.name == name)?;
    row.ns_per_pixel.median.filter(|time| *time > 0.0)
}

fn block(out: &mut String, case: &Case, baseline: Option<f64>) {
    let coverage = format!("coverage {} %", short(100.0 * case.coverage));
    let decisions = case.methods.iter().map(|row| row.decisions).max().unwrap_or(0);
    let condition = case.condition.map_or(String::new(), |Condition { median, max }| {
        format!(", condition of t: median {}, max {}", short(median), short(max))
    });
    let title = format!("{}: {decisions} decisions, {coverage}{condition}", case.title());
    wrapped(out, WIDTH, "", &title);
    let mut rows = vec![COLUMNS.map(str::to_owned)];
    rows.extend(case.methods.iter().map(|row| cells(row, baseline)));
    let mut widths = widths(&rows);
    // The heads above stand over one column or several: the first, how many, and the text.
    const HEADS: [(usize, usize, &str); 5] = [
        (3, 3, "error in t, ulps of f64"),
        (6, 1, "own ulps"),
        (7, 1, "backward"),
        (8, 1, "rad"),
        (9, 2, "ns a pixel"),
    ];
    let mut line = " ".repeat(widths[..3].iter().sum::<usize>() + 4);
    for (first, count, text) in HEADS {
        let columns = &mut widths[first..first + count];
        let least = (text.len() + 2).div_ceil(count) - 2;
        columns.iter_mut().for_each(|width| *width = (*width).max(least));
        let width = columns.iter().map(|width| width + 2).sum();
        let _ = write!(line, "{text:>width$}");
    }
    out.push_str(&line);
    out.push('\n');
    aligned(out, &rows, widths);
    for row in &case.methods {
        if let Some(text) = row.decided() {
            wrapped(out, WIDTH, "", &text);
        }
    }
}

fn cells(row: &MethodRow, baseline: Option<f64>) -> [String; COLUMNS.len()] {
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short);
    let share = match row.wrong_share {
        None => "-".to_owned(),
        Some(0.0) => "0 %".to_owned(),
        Some(share) => format!("{} %", short(100.0 * share)),
    };
    let ratio = baseline.zip(row.ns_per_pixel.median).map(|(base, time)| time / base);
    [
        row.name.clone(),
        row.wrong.to_string(),
        share,
        number(row.ulp_f64.median),
        number(row.ulp_f64.p99),
        number(row.ulp_f64.max),
        number(row.ulp.max),
        number(row.backward_error_max),
        number(row.normal_error_max),
        number(row.ns_per_pixel.median),
        number(row.ns_per_pixel.min),
        number(ratio),
    ]
}
