//! Formulas as LaTeX with amsmath, in a form that Markdown's `$...$` also accepts.

use pinhole_exchange::is_hidden;

use super::{Arrangement, Formula, Operator};

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

/// Writes a formula for math mode. Puts `&` before its first relation, where an `align` environment aligns
/// lines.
pub(crate) fn aligned(formula: &Formula) -> String {
    let parts = formula.parts();
    match parts.iter().position(Formula::is_relation) {
        Some(at) => format!("{} &{}", row(&parts[..at]), row(&parts[at..])),
        None => format!("& {}", row(parts)),
    }
}

/// Writes text for LaTeX's text mode. Escapes special characters, and replaces characters that LaTeX's
/// fonts lack.
pub(crate) fn text(text: &str) -> String {
    text.chars().map(letter).collect()
}

/// Signs that LaTeX has only in math mode, each with its command there.
const SIGNS: [(&str, &str); 16] = [
    ("−", "-"),
    ("×", r"\times"),
    ("·", r"\cdot"),
    ("√", r"\surd"),
    ("±", r"\pm"),
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
    if let Some(degrees) = text_of.strip_suffix('°') {
        return format!(r"{}^{{\circ}}", number(degrees));
    }
    let is_name = !text_of.is_empty() && text_of.chars().all(|c| c.is_ascii_alphabetic());
    if is_name {
        format!(r"\operatorname{{{text_of}}}")
    } else {
        format!(r"\text{{{}}}", text(text_of))
    }
}

/// Writes digits, possibly with an exponent.
fn number(digits: &str) -> String {
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
        assert_eq!(aligned(&chain), r"\mathbf{up} &= \mathbf{up} = \mathbf{up}");
        assert_eq!(aligned(&UP), r"& \mathbf{up}");
    }

    #[test]
    fn text_has_nothing_that_latex_takes_for_a_command() {
        assert_eq!(
            text("50 % of {a_b} \\ “x” − 𝐮 𝑡"),
            r"50 \% of \{a\_b\} \textbackslash{} ``x'' $-$ $\mathbf{u}$ $t$"
        );
    }
}
