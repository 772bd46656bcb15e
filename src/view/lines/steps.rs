//! The substitution in words and numbers, step by step.

use std::cmp::Ordering;

use pinhole_lecture::lines::{Crossing, Meeting, Substitution};
use pinhole_lecture::numbers::written as number;

/// One step of the substitution.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LabStep {
    /// The name of the step.
    pub(crate) what: &'static str,
    /// The formula, in the form that [`formula`](crate::view::typesetting::notation::formula)
    /// takes.
    pub(crate) text: String,
}

/// Formats a number behind a multiplication sign: negative ones in parentheses.
fn factor(x: f64, digits: usize) -> String {
    let text = number(x, digits);
    if text.starts_with('−') { format!("({text})") } else { text }
}

/// Returns `+ x` or `− |x|`.
fn added(x: f64, digits: usize) -> String {
    let sign = if x < 0.0 { '−' } else { '+' };
    format!("{sign} {}", number(x.abs(), digits))
}

/// Returns all steps with the current numbers.
pub(crate) fn steps(s: &Substitution, digits: usize) -> Vec<LabStep> {
    let (n, m, plus) = (|x| number(x, digits), |x| factor(x, digits), |x| added(x, digits));
    let (line, p, d) = (s.line, s.ray.p, s.ray.d);
    let coordinate = |p: f64, d: f64| format!("{} {} t", n(p), added(d, digits));
    let (x, y) = (coordinate(p.x, d.x), coordinate(p.y, d.y));
    let (a, b, c) = (n(line.a), line.b, plus(line.c));
    let sign = if b < 0.0 { '−' } else { '+' };
    let b_size = n(b.abs());
    vec![
        LabStep { what: "implicit", text: format!("f(x, y) = {a} x {sign} {b_size} y {c}") },
        LabStep { what: "parametric", text: format!("x = {x},   y = {y}") },
        LabStep {
            what: "put in",
            text: format!("f(p + t d) = {a} ({x}) {sign} {b_size} ({y}) {c}"),
        },
        LabStep {
            what: "sorted by t",
            text: format!(
                "= ({a}·{} {sign} {b_size}·{}) t + ({a}·{} {sign} {b_size}·{} {c})",
                m(d.x),
                m(d.y),
                m(p.x),
                m(p.y)
            ),
        },
        LabStep { what: "added up", text: format!("= {} t {}", n(s.rate), plus(s.offset)) },
        LabStep { what: "zero where", text: zero(s, digits) },
    ]
}

fn zero(s: &Substitution, digits: usize) -> String {
    let (rate, offset) = (number(s.rate, digits), number(s.offset, digits));
    match s.meeting {
        Meeting::Parallel => format!("0 t = {}: for no t", number(-s.offset, digits)),
        Meeting::Coincident => "0 t = 0: for every t".to_owned(),
        Meeting::At(Crossing { t, .. }) => {
            let over = factor(s.rate, digits);
            format!("t = −({offset}) / {over} = {}", number(t, digits))
        }
        Meeting::TooFar { .. } => format!("t = −({offset}) / ({rate}), too large"),
    }
}

/// Describes whether and where the lines meet.
pub(crate) fn verdict(s: &Substitution, digits: usize) -> String {
    let n = |x| number(x, digits);
    match s.meeting {
        Meeting::Parallel => {
            format!("Parallel: f(p + t d) is {} at every t, never 0. They never meet.", n(s.offset))
        }
        Meeting::Coincident => {
            "Coincident: f(p + t d) is 0 at every t. Both are the same line.".to_owned()
        }
        Meeting::At(Crossing { t, point, ray_hits }) => {
            let (t_text, x, y) = (n(t), n(point.x), n(point.y));
            if ray_hits {
                format!("They meet at t = {t_text}, at ({x}, {y}). t > 0: the ray hits.")
            } else if t.partial_cmp(&0.0) == Some(Ordering::Less) {
                format!("Line met but ray missed: t = {t_text} < 0, at ({x}, {y}), behind p.")
            } else {
                format!("They meet at p itself, ({x}, {y}): t = 0 is no hit.")
            }
        }
        Meeting::TooFar { ray_hits } => {
            let side = if ray_hits { "ahead of p" } else { "behind p" };
            format!("They meet {side}, too far away for a number.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::lines::LinesLab;

    fn said(example: usize) -> (Vec<String>, String) {
        let (_, lab) = &LinesLab::examples()[example];
        let s = Substitution::new(lab.line(), lab.ray).expect("two lines");
        let lines = steps(&s, 5).into_iter().map(|step| step.text).collect();
        (lines, verdict(&s, 5))
    }

    #[test]
    fn a_ray_that_misses_line_by_line() {
        let (lines, verdict) = said(1);
        assert_eq!(
            lines,
            [
                "f(x, y) = 2 x − 1 y + 1",
                "x = 0 + 1 t,   y = 0 + 1 t",
                "f(p + t d) = 2 (0 + 1 t) − 1 (0 + 1 t) + 1",
                "= (2·1 − 1·1) t + (2·0 − 1·0 + 1)",
                "= 1 t + 1",
                "t = −(1) / 1 = −1",
            ]
        );
        assert_eq!(verdict, "Line met but ray missed: t = −1 < 0, at (−1, −1), behind p.");
    }

    #[test]
    fn the_other_verdicts() {
        assert_eq!(said(0).1, "They meet at t = 1, at (1, 1). t > 0: the ray hits.");
        let (lines, verdict) = said(2);
        assert_eq!(lines[5], "0 t = −2: for no t");
        assert_eq!(verdict, "Parallel: f(p + t d) is 2 at every t, never 0. They never meet.");
        let (lines, verdict) = said(3);
        assert_eq!(lines[4], "= 0 t + 0");
        assert_eq!(verdict, "Coincident: f(p + t d) is 0 at every t. Both are the same line.");
    }
}
