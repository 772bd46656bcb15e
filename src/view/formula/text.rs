//! Formulas in one line of plain text. Names of vectors that have one letter are written with
//! Unicode's bold letters, so that `𝐮` and `u` differ.

use std::fmt::{self, Write as _};

use super::{Formula, Gap, Operator, gap};
use crate::model::letters;

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Formula::Scalar(name) => f.write_str(name),
            Formula::Vector(name, _) => bold(name, f),
            Formula::Word(text) | Formula::Number(text) | Formula::Rounded(text) => {
                f.write_str(text)
            }
            Formula::Operator(operator) => f.write_str(operator.sign()),
            Formula::Given(_, inner) => inner.fmt(f),
            Formula::Row(parts) => row(parts, f),
            Formula::Root(inner) => guarded("√", inner, f),
            Formula::Fraction(above, below) => {
                numerator(above, f)?;
                guarded("/", below, f)
            }
            Formula::Power(base, exponent) => script(base, exponent, '^', &SUPERSCRIPTS, f),
            Formula::Index(base, index) => script(base, index, '_', &SUBSCRIPTS, f),
            Formula::Norm(inner) => write!(f, "|{inner}|"),
            Formula::Parentheses(inner) => write!(f, "({inner})"),
            Formula::Tuple(coordinates, _) => {
                for (k, coordinate) in coordinates.iter().enumerate() {
                    write!(f, "{}{coordinate}", if k == 0 { "(" } else { ", " })?;
                }
                f.write_char(')')
            }
        }
    }
}

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
const SUBSCRIPTS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

/// Writes one letter in bold, from the block *Mathematical Alphanumeric Symbols*; a word stays as
/// it is.
fn bold(name: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match name.len() {
        1 => name.chars().try_for_each(|letter| f.write_char(letters::bold(letter))),
        _ => f.write_str(name),
    }
}

fn row(parts: &[Formula], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (k, part) in parts.iter().enumerate() {
        if k > 0 && gap(&parts[k - 1], part) != Gap::None {
            f.write_char(' ')?;
        }
        write!(f, "{part}")?;
    }
    Ok(())
}

/// Writes an operator that applies only to the next part, with parentheses around several parts.
fn guarded(sign: &str, inner: &Formula, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match inner {
        Formula::Given(_, inner) => guarded(sign, inner, f),
        Formula::Row(_) | Formula::Fraction(..) => write!(f, "{sign}({inner})"),
        _ => write!(f, "{sign}{inner}"),
    }
}

/// Writes the numerator of `/`; a product needs no parentheses there.
fn numerator(inner: &Formula, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let joins = |part: &Formula| matches!(part, Formula::Operator(operator) if *operator != Operator::Negative);
    match inner {
        Formula::Row(parts) if !parts.iter().any(joins) => write!(f, "{inner}"),
        other => guarded("", other, f),
    }
}

fn script(
    base: &Formula,
    small: &Formula,
    sign: char,
    digits: &[char; 10],
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    guarded("", base, f)?;
    if let Formula::Number(text) = small
        && let Some(text) =
            text.chars().map(|c| Some(digits[c.to_digit(10)? as usize])).collect::<Option<String>>()
    {
        return f.write_str(&text);
    }
    f.write_char(sign)?;
    guarded("", small, f)
}
