//! The report as text in aligned columns, for a terminal with 120 columns.

use std::fmt::Write as _;

use pinhole_lecture::numbers::{grouped, short_plain as short};

use crate::report::model::{Case, ConditionSpread, MethodRow, Report};
use crate::report::summary::{MethodOverall, Overall, least_middle_most, overall, summaries};

/// Maximum width of a line, in characters.
const WIDTH: usize = 118;

/// The names of the columns.
const COLUMNS: &str = "method,wrong,share,median,p99,max,max,max,normal,min,quartiles,× base";

/// Text that explains the columns.
const READING: &str = "wrong: hit or miss, which object is first, or another root of it (t less than half \
    as far from that as from the true one); errors are of all other rays, in t in ulps of f64, the spacing \
    of f64 numbers there, of which an ulp of f32 is 2^29, and the largest one in ulps of the method's own \
    precision: from 2^53 ulps of f64 on no digit of t is right; backward: the share of their sizes, in \
    units of 2^-53, by which centre, radius, origin and direction move to make that t exact; an error in \
    ulps of f64 is, to first order, at most the problem's condition times it; × base: the shortest rounds \
    compared";

/// The names of the summary's columns.
const SUMMARY: &str = "method,wrong,of,share,least,middle,most,least,middle,most";

/// Returns the whole report as text.
pub fn to_table(report: &Report) -> String {
    let mut out = String::new();
    let seed = report.seed.map(|seed| seed.to_string()).unwrap_or_default();
    for (name, text) in [
        ("reference", &report.reference),
        ("cpu", &report.cpu),
        ("baseline", &report.baseline),
        ("seed", &seed),
    ] {
        if !text.is_empty() {
            wrapped(&mut out, &format!("{name:<10} "), text);
        }
    }
    for note in &report.notes {
        wrapped(&mut out, "note       ", note);
    }
    if !report.cases.is_empty() {
        wrapped(&mut out, "reading    ", READING);
    }
    let summaries = summaries(report);
    if summaries.len() > 1 {
        out.push('\n');
        summary(&mut out, &overall(&summaries));
    }
    let mut family = "";
    for case in &report.cases {
        out.push('\n');
        if case.name != family && !case.about.is_empty() {
            wrapped(&mut out, "", &format!("{}: {}", case.name, case.about));
        }
        family = &case.name;
        block(&mut out, case, baseline_of(report, case));
    }
    if !report.left_out.is_empty() {
        out.push_str("\nleft out:\n");
        for line in &report.left_out {
            wrapped(&mut out, "  ", line);
        }
    }
    out
}

/// Writes the summary of all scenes or families, with one line per method.
fn summary(out: &mut String, all: &Overall) {
    let Overall { methods, noun, shared } = all;
    let about = format!(
        "the {shared} {noun} that all methods have, together: share: the mean of their cases; \
         largest errors in t in ulps of f64 (none: no digit right, or no hit alike) and times in nanoseconds \
         a pixel"
    );
    wrapped(out, "", &about);
    let cells = |method: &MethodOverall| {
        let number = |x: f64| if x.is_finite() { short(x) } else { "none".to_owned() };
        let three = |values: Option<[f64; 3]>| {
            values.map_or([(); 3].map(|()| "-".to_owned()), |v| v.map(number))
        };
        let [wrong, decisions] = [method.wrong, method.decisions].map(grouped);
        let own = vec![method.first.name.to_owned(), wrong, decisions, percent(method.share)];
        let spreads = [method.errors(), least_middle_most(&method.times)];
        own.into_iter().chain(spreads.into_iter().flat_map(three)).collect()
    };
    const HEADS: [(usize, usize, &str); 2] = [(4, 3, "largest error in t"), (7, 3, "ns a pixel")];
    headed(out, &HEADS, SUMMARY, methods.iter().map(cells));
}

/// Writes a table: a line of group headings, then the names of the columns, then the rows. A group
/// heading spans one or more columns; it is given by its first column, its number of columns and its
/// text. The first column is left-aligned, the others are right-aligned.
fn headed(
    out: &mut String,
    heads: &[(usize, usize, &str)],
    columns: &str,
    rows: impl Iterator<Item = Vec<String>>,
) {
    let mut table: Vec<Vec<String>> = vec![columns.split(',').map(str::to_owned).collect()];
    table.extend(rows);
    let width = |k: usize| table.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let mut widths: Vec<usize> = (0..table[0].len()).map(width).collect();
    let before = heads.first().map_or(0, |(first, ..)| *first);
    let mut line =
        " ".repeat(widths[..before].iter().sum::<usize>() + 2 * before.saturating_sub(1));
    for &(first, count, text) in heads {
        let columns = &mut widths[first..first + count];
        let least = (text.len() + 2).div_ceil(count) - 2;
        columns.iter_mut().for_each(|width| *width = (*width).max(least));
        let width = columns.iter().map(|width| width + 2).sum();
        let _ = write!(line, "{text:>width$}");
    }
    let _ = writeln!(out, "{line}");
    for row in table {
        let mut line = format!("{:<width$}", row[0], width = widths[0]);
        for (cell, width) in row.iter().zip(&widths).skip(1) {
            let _ = write!(line, "  {cell:>width$}");
        }
        let _ = writeln!(out, "{}", line.trim_end());
    }
}

/// Returns the time of the baseline method, with which the other methods' times are compared. The first
/// word of the report's baseline is the name of that method.
fn baseline_of(report: &Report, case: &Case) -> Option<f64> {
    let name = report.baseline.split([' ', ',', ':']).next()?;
    let row = case.methods.iter().find(|row| row.name == name)?;
    row.ns_per_pixel.min.filter(|time| *time > 0.0)
}

fn block(out: &mut String, case: &Case, baseline: Option<f64>) {
    let coverage = format!("coverage {} %", short(100.0 * case.coverage));
    let decisions = case.methods.iter().map(|row| row.decisions).max().unwrap_or(0);
    let condition = case.condition.map_or(String::new(), |ConditionSpread { median, max }| {
        format!(", condition of t: median {}, max {}", short(median), short(max))
    });
    let title =
        format!("{}: {} decisions, {coverage}{condition}", case.title(), grouped(decisions));
    wrapped(out, "", &title);
    const HEADS: [(usize, usize, &str); 5] = [
        (3, 3, "error in t, ulps of f64"),
        (6, 1, "own ulps"),
        (7, 1, "backward"),
        (8, 1, "rad"),
        (9, 2, "ns a pixel"),
    ];
    headed(out, &HEADS, COLUMNS, case.methods.iter().map(|row| cells(row, baseline)));
    for row in &case.methods {
        if let Some(text) = row.decided() {
            wrapped(out, "", &text);
        }
    }
}

fn percent(share: Option<f64>) -> String {
    share.map_or("-".to_owned(), |share| format!("{} %", short(100.0 * share)))
}

fn cells(row: &MethodRow, baseline: Option<f64>) -> Vec<String> {
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short);
    let times = row.ns_per_pixel;
    let quartiles = match (times.lower_quartile, times.upper_quartile) {
        (Some(low), Some(high)) => format!("{}–{}", short(low), short(high)),
        _ => "-".to_owned(),
    };
    let ratio = baseline.zip(times.min).map(|(base, time)| time / base);
    vec![
        row.name.clone(),
        grouped(row.wrong),
        percent(row.wrong_share),
        number(row.ulp_f64.median),
        number(row.ulp_f64.p99),
        number(row.ulp_f64.max),
        number(row.ulp.max),
        number(row.backward_error_max),
        number(row.normal_error_max),
        number(times.min),
        quartiles,
        number(ratio),
    ]
}

/// Writes a text after the prefix `head`, in lines of at most [`WIDTH`] characters. The second and
/// later lines are indented by the width of the prefix.
fn wrapped(out: &mut String, head: &str, text: &str) {
    let indent = head.chars().count();
    for (k, line) in lines(text, WIDTH - indent).into_iter().enumerate() {
        let head = if k == 0 { head } else { "" };
        let _ = writeln!(out, "{head:indent$}{line}");
    }
}

/// Splits a text into lines of at most `width` characters.
pub(crate) fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
