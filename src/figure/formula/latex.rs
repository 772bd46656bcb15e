//! Formulas as LaTeX with amsmath, in a form that Markdown's `$...$` also accepts.

use pinhole_exchange::is_hidden;

use super::layout::{self, FRACTION, pieces, upright};
use super::{Arrangement, Face, Formula, Operator, TextMeasure, left_width};

/// Writes a formula for LaTeX's math mode.
pub(crate) fn math(formula: &Formula) -> String {
    match formula {
        Formula::Scalar(name) => named("mathit", name),
        Formula::Vector(name, _) => format!(r"\mathbf{{{name}}}"),
        Formula::Word(text) => word(text),
        Formula::Number(digits) | Formula::Rounded(digits) => number(digits),
        Formula::Operator(o) => sign(o.sign()).unwrap_or(o.sign()).to_owned(),
        Formula::Given(_, inner) => math(inner),
        Formula::Row(parts) => row(parts),
        Formula::Root(inner) => format!(r"\sqrt{{{}}}", math(inner)),
        Formula::Fraction(above, below) => format!(r"\frac{{{}}}{{{}}}", math(above), math(below)),
        Formula::Power(base, small) => format!("{{{}}}^{{{}}}", math(base), math(small)),
        Formula::Index(base, small) => format!("{{{}}}_{{{}}}", math(base), math(small)),
        Formula::Norm(inner) => format!(r"\left| {} \right|", math(inner)),
        Formula::Parentheses(inner) => format!(r"\left( {} \right)", math(inner)),
        Formula::Tuple(coordinates, direction) => {
            let coordinates: Vec<String> = coordinates.iter().map(math).collect();
            match direction {
                Arrangement::Row => format!(r"\left( {} \right)", coordinates.join(", ")),
                Arrangement::Column => {
                    format!(r"\begin{{bmatrix}} {} \end{{bmatrix}}", coordinates.join(r" \\ "))
                }
            }
        }
    }
}

/// Width of the text on a page of the class `article` at 10 pt, in ems.
const PAGE: f32 = 34.5;

/// The widths of LaTeX's own font, Computer Modern, rounded up.
struct ComputerModern;

impl TextMeasure for ComputerModern {
    fn width(&mut self, text: &str, face: Face, size: f32) -> f32 {
        let is_number = text.starts_with(|c: char| c.is_ascii_digit());
        let em = |c: char| match c {
            '0'..='9' => 0.5,
            'e' if is_number => 2.0,
            '(' | ')' => 0.39,
            '.' | ',' | ' ' | '·' => 0.34,
            '=' | '≈' | '+' | '−' | '∓' | '×' => 0.78,
            'm' | 'w' => 0.85,
            _ if face == Face::Bold => 0.6,
            _ => 0.55,
        };
        size * text.chars().map(em).sum::<f32>()
    }
}

/// Writes formulas, each with a note, which may be empty, as the lines of an `align*` environment. They are
/// aligned at their first relations. Formulas that are too wide for a page are broken before relations,
/// then before operators; then their vectors are written as columns.
pub(crate) fn aligned<'a>(lines: impl Iterator<Item = (&'a Formula, &'a str)> + Clone) -> String {
    let left = |formula| left_width(formula, 1.0, &mut ComputerModern);
    let room = PAGE - lines.clone().map(|(formula, _)| left(formula)).fold(0.0, f32::max);
    let rows = lines.flat_map(|(formula, note)| {
        let mut rows = Rows { done: Vec::new(), open: String::new(), used: 0.0, room };
        rows.formula(formula.parts());
        rows.note(note);
        rows.done.push(rows.open);
        rows.done
    });
    rows.map(|row| format!("  {row}")).collect::<Vec<_>>().join(" \\\\\n")
}

/// Builds the rows of one line in an `align*` environment.
struct Rows {
    done: Vec<String>,
    /// The unfinished row.
    open: String,
    /// Width of the unfinished row after its `&`, in ems.
    used: f32,
    /// Maximum width of a row after its `&`, in ems.
    room: f32,
}

impl Rows {
    fn formula(&mut self, parts: &[Formula]) {
        let at = parts.iter().position(Formula::is_relation).unwrap_or(0);
        self.open = if at > 0 { format!("{} &", row(&parts[..at])) } else { "&".to_owned() };
        // A fraction in a displayed formula has text of full size.
        let is_fraction = |part: &Formula| matches!(part, Formula::Fraction(..));
        let width = |parts: &[Formula]| {
            let width = layout::row(parts, 1.0, &mut ComputerModern).width;
            if parts.iter().any(|part| part.has(&is_fraction)) { width / FRACTION } else { width }
        };
        for side in pieces(&parts[at..], Formula::is_relation) {
            if width(side) <= self.room {
                self.add(&row(side), width(side), "&");
                continue;
            }
            if self.used > 0.0 {
                self.end_row("&");
            }
            for (k, term) in pieces(side, Formula::is_binary).into_iter().enumerate() {
                let indent = if k == 0 { "&" } else { r"&\qquad " };
                let columns: Vec<Formula> = term.iter().map(upright).collect();
                let is_wide = width(term) + 2.0 > self.room;
                let term = if is_wide { &columns } else { term };
                self.add(&row(term), width(term), indent);
            }
        }
    }

    /// Adds a note, in as many rows as it needs.
    fn note(&mut self, note: &str) {
        let width = |text: &str| 1.0 + ComputerModern.width(text, Face::Upright, 1.0);
        if note.is_empty() {
            return;
        }
        if self.used + width(note) <= self.room {
            return self.add(&format!(r"\quad \text{{{}}}", text(note)), width(note), "&");
        }
        let mut line = String::new();
        for word in note.split(' ').chain([""]) {
            if !line.is_empty() && (word.is_empty() || width(&line) + width(word) > self.room) {
                self.end_row(r"&\quad ");
                self.open.push_str(&format!(r"\text{{{}}}", text(line.trim_end())));
                line.clear();
            }
            line.extend([word, " "]);
        }
    }

    /// Begins a new row with `indent`.
    fn end_row(&mut self, indent: &str) {
        self.done.push(std::mem::replace(&mut self.open, indent.to_owned()));
        self.used = if indent == "&" { 0.0 } else { 2.0 };
    }

    /// Adds text of this width, in ems, to the row if it fits; otherwise begins a new row with `indent`.
    fn add(&mut self, text: &str, width: f32, indent: &str) {
        if self.used > 0.0 && self.used + width > self.room {
            self.end_row(indent);
        } else if self.used > 0.0 {
            self.open.push(' ');
        }
        self.open.push_str(text);
        self.used += width;
    }
}

/// Writes text for LaTeX's text mode. Escapes special characters, and replaces characters that LaTeX's
/// fonts lack.
pub(crate) fn text(text: &str) -> String {
    text.chars().map(letter).collect()
}

/// Signs that LaTeX has only in math mode, each with its command there.
const SIGNS: [(&str, &str); 17] = [
    ("−", "-"),
    ("×", r"\times"),
    ("·", r"\cdot"),
    ("√", r"\surd"),
    ("±", r"\pm"),
    ("∓", r"\mp"),
    ("≈", r"\approx"),
    ("≤", r"\le"),
    ("≥", r"\ge"),
    ("≠", r"\ne"),
    ("→", r"\to"),
    ("∞", r"\infty"),
    ("°", r"^{\circ}"),
    ("²", "^{2}"),
    ("<", "<"),
    (">", ">"),
    ("|", "|"),
];

/// Returns the math-mode command of a sign; `None` for a sign that text mode has as well.
fn sign(text: &str) -> Option<&'static str> {
    SIGNS.iter().find(|(sign, _)| *sign == text).map(|(_, latex)| *latex)
}

fn letter(c: char) -> String {
    if let Some(sign) = sign(c.encode_utf8(&mut [0; 4])) {
        return format!("${sign}$");
    }
    let plain = |from: u32, first: char| {
        char::from_u32(c as u32 - from + first as u32).unwrap_or(c).to_string()
    };
    match c {
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!(r"\{c}"),
        '\\' => r"\textbackslash{}".to_owned(),
        '~' => r"\textasciitilde{}".to_owned(),
        '^' => r"\textasciicircum{}".to_owned(),
        '“' => "``".to_owned(),
        '”' => "''".to_owned(),
        '\u{1d400}'..='\u{1d419}' => format!(r"$\mathbf{{{}}}$", plain(0x1d400, 'A')),
        '\u{1d434}'..='\u{1d44d}' => format!("${}$", plain(0x1d434, 'A')),
        'ℎ' => "$h$".to_owned(),
        '\u{1d41a}'..='\u{1d433}' => format!(r"$\mathbf{{{}}}$", plain(0x1d41a, 'a')),
        '\u{1d44e}'..='\u{1d467}' => format!("${}$", plain(0x1d44e, 'a')),
        c if is_hidden(c) => String::new(),
        c => c.to_string(),
    }
}

/// Writes a name: a single letter unchanged, several letters as the argument of the LaTeX command `style`.
fn named(style: &str, name: &str) -> String {
    match name.len() {
        1 => name.to_owned(),
        _ => format!(r"\{style}{{{name}}}"),
    }
}

fn word(text_of: &str) -> String {
    match text_of {
        "sin" => return r"\sin".to_owned(),
        "cos" => return r"\cos".to_owned(),
        _ => {}
    }
    if text_of.ends_with('°') {
        return number(text_of);
    }
    let is_name = !text_of.is_empty() && text_of.chars().all(|c| c.is_ascii_alphabetic());
    if is_name {
        format!(r"\operatorname{{{text_of}}}")
    } else {
        format!(r"\text{{{}}}", text(text_of))
    }
}

/// Writes digits, possibly with an exponent or a degree sign.
fn number(digits: &str) -> String {
    if let Some(degrees) = digits.strip_suffix('°') {
        return format!(r"{}^{{\circ}}", number(degrees));
    }
    let digits = digits.replace('−', "-");
    match digits.split_once('e') {
        _ if digits.contains(' ') => format!(r"\text{{{digits}}}"),
        Some((mantissa, exponent)) => format!(r"{mantissa} \cdot 10^{{{exponent}}}"),
        None => digits,
    }
}

fn row(parts: &[Formula]) -> String {
    let mut out = String::new();
    for (k, part) in parts.iter().enumerate() {
        let close = matches!(part, Formula::Operator(Operator::Comma))
            || k > 0 && matches!(parts[k - 1], Formula::Operator(Operator::Negative));
        if k > 0 && !close {
            out.push(' ');
        }
        // A minus sign after another operator is unary, so it must not get the spacing of a subtraction.
        let after_sign = k > 0 && matches!(parts[k - 1], Formula::Operator(o) if o.is_binary());
        match part {
            Formula::Operator(Operator::Negative) if after_sign => out.push_str("{-}"),
            _ => out.push_str(&math(part)),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::{
        SymbolInk, fraction, index, negative, norm, number, parentheses, power, row, square_root,
        tuple, word,
    };
    use super::*;

    const UP: Formula = Formula::Vector("up", SymbolInk::Given);

    #[test]
    fn every_kind_of_formula() {
        for (formula, latex) in [
            (Formula::Scalar("t"), "t"),
            (Formula::Scalar("distance"), r"\mathit{distance}"),
            (norm(UP), r"\left| \mathbf{up} \right|"),
            (row([word("sin"), parentheses(word("90.5°"))]), r"\sin \left( 90.5^{\circ} \right)"),
            (
                row([word("normalize"), parentheses(negative(UP))]),
                r"\operatorname{normalize} \left( -\mathbf{up} \right)",
            ),
            (number("81.189°"), r"81.189^{\circ}"),
            (word("no ray & no_hit"), r"\text{no ray \& no\_hit}"),
            (number("-1.5e-7"), r"-1.5 \cdot 10^{-7}"),
            (number("beyond f64"), r"\text{beyond f64}"),
            (fraction(square_root(number("2")), number("4")), r"\frac{\sqrt{2}}{4}"),
            (power(parentheses(Formula::Scalar("b")), "2"), r"{\left( b \right)}^{2}"),
            (index(Formula::Scalar("t"), number("1")), "{t}_{1}"),
            (tuple([number("1"), number("-2")]), r"\left( 1, -2 \right)"),
            (
                Formula::Tuple(vec![number("1"), number("2")], Arrangement::Column),
                r"\begin{bmatrix} 1 \\ 2 \end{bmatrix}",
            ),
            (
                row([UP, Operator::Times.into(), negative(UP), Operator::Approximately.into(), UP]),
                r"\mathbf{up} \times {-}\mathbf{up} \approx \mathbf{up}",
            ),
        ] {
            assert_eq!(math(&formula), latex);
        }
    }

    #[test]
    fn lines_meet_at_their_first_relation() {
        let chain = row([UP, Operator::Equals.into(), UP, Operator::Equals.into(), UP]);
        assert_eq!(
            aligned([(&chain, ""), (&UP, "a note")].into_iter()),
            "  \\mathbf{up} &= \\mathbf{up} = \\mathbf{up} \\\\\n  &\\mathbf{up} \\quad \\text{a note}"
        );
    }

    #[test]
    fn a_formula_wider_than_a_page_is_broken() {
        let vector = || tuple(["-0.67542", "0.012464", "-0.0089027"].map(number));
        let sum = row([vector(), Operator::Plus.into(), vector(), Operator::Plus.into(), vector()]);
        let chain = row([UP, Operator::Equals.into(), UP, Operator::Approximately.into(), sum]);
        let vector = math(&vector());
        let note = "a note that has a row of its own";
        let expected = [
            r"\mathbf{up} &= \mathbf{up}".to_owned(),
            format!(r"&\approx {vector} + {vector}"),
            format!(r"&\qquad + {vector}"),
        ];
        let rows = aligned([(&chain, "")].into_iter());
        assert_eq!(rows.split(" \\\\\n").map(str::trim).collect::<Vec<_>>(), expected);
        let rows = aligned([(&chain, note)].into_iter());
        assert!(rows.ends_with(&format!(r"&\quad \text{{{note}}}")), "{rows}");
        let digits = || number("-0.6754249051872036");
        let wide =
            row([UP, Operator::Equals.into(), tuple([digits(), digits(), digits(), digits()])]);
        assert!(aligned([(&wide, "")].into_iter()).contains(r"\begin{bmatrix}"));
    }

    #[test]
    fn text_has_nothing_that_latex_takes_for_a_command() {
        assert_eq!(
            text("50 % of {a_b} \\ “x” − 𝐮 𝐔 𝑡 𝐷 ℎ"),
            r"50 \% of \{a\_b\} \textbackslash{} ``x'' $-$ $\mathbf{u}$ $\mathbf{U}$ $t$ $D$ $h$"
        );
    }
}
