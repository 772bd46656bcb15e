//! Formulas in the lecture's notation: a tree, its layout, and its text forms.
//!
//! - this file: the tree, without fonts and colours, and its form as a line of plain text for screen
//!   readers, the clipboard and tests;
//! - `latex`: the tree as LaTeX;
//! - `layout`: the tree as positioned text and strokes, broken into lines of a given width.
//!
//! Vectors and scalars are different kinds of names. A [`Formula::Vector`] is bold and has the colour
//! that it has in the views; a [`Formula::Scalar`] is italic. Plain text writes a vector whose name is
//! one letter as a Unicode bold letter, so that `𝐮` and `u` differ. Nothing is painted here.

use std::fmt::{self, Write as _};

use crate::{Given, symbols};

pub use layout::{
    Column, Face, GivenBox, Layout, Measure, Rule, TextMeasure, TextRun, layout, left_width, lines,
};

pub(crate) mod latex;
mod layout;

/// One formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// The name of a scalar: italic.
    Scalar(&'static str),
    /// The name of a vector or point, which is bold and coloured.
    Vector(&'static str, SymbolInk),
    /// Another word: `normalize`, `sin`.
    Word(String),
    /// Digits, as written by [`number`].
    Number(String),
    /// Digits of a rounded number, as written by [`rounded`].
    Rounded(String),
    /// A given number, which the user can edit in place.
    Given(Given, Box<Formula>),
    /// An operator between two parts, or a sign before one.
    Operator(Operator),
    /// Parts side by side.
    Row(Vec<Formula>),
    /// A square root.
    Root(Box<Formula>),
    /// One part above the other.
    Fraction(Box<Formula>, Box<Formula>),
    /// A base with a superscript.
    Power(Box<Formula>, Box<Formula>),
    /// A base with a subscript.
    Index(Box<Formula>, Box<Formula>),
    /// The length of a vector, `|x|`.
    Norm(Box<Formula>),
    /// Parentheses, `(x)`.
    Parentheses(Box<Formula>),
    /// The coordinates of a vector, side by side or stacked.
    Tuple(Vec<Formula>, Arrangement),
}

/// The arrangement of a vector's coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// Side by side, `(x, y, z)`.
    Row,
    /// One below the other, in brackets.
    Column,
}

/// A colour of text, the same as in the views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolInk {
    /// The colour of ordinary text.
    Text,
    /// The colour of u.
    U,
    /// The colour of v.
    V,
    /// The colour of w.
    W,
    /// The colour of the vectors and points by which the user gives the camera: at, view, up.
    Given,
    /// The colour of the selected ray.
    Ray,
}

pinhole_core::texts! {
    /// An operator.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[allow(missing_docs, reason = "the names of the signs")]
    pub enum Operator[1];
    {
        /// Returns the operator's character.
        sign,
    }
    Equals: "=";
    Approximately: "≈";
    Plus: "+";
    Minus: "−";
    /// Minus for the first of two values, plus for the second.
    MinusOrPlus: "∓";
    /// The cross product.
    Times: "×";
    /// The dot product, and the product of two numbers.
    Dot: "·";
    Comma: ",";
    /// The negative sign of a number or vector.
    Negative: "−";
}

impl Operator {
    /// Returns true for a relation between two sides of a formula, such as `=`. A formula that is too long
    /// is broken before its relations first.
    pub fn is_relation(self) -> bool {
        matches!(self, Operator::Equals | Operator::Approximately)
    }

    /// Returns true for an operator between two terms or factors. A formula is broken before such an
    /// operator only if breaking it before its relations is not enough.
    fn is_binary(self) -> bool {
        use Operator::{Dot, Minus, MinusOrPlus, Plus, Times};
        matches!(self, Plus | Minus | MinusOrPlus | Times | Dot)
    }
}

impl From<Operator> for Formula {
    fn from(operator: Operator) -> Formula {
        Formula::Operator(operator)
    }
}

/// Returns the formula of a number, with a minus sign instead of a hyphen.
pub fn number(text: &str) -> Formula {
    signed(text, Formula::Number)
}

/// Returns the formula of a rounded number, with a minus sign instead of a hyphen.
pub fn rounded(text: &str) -> Formula {
    signed(text, Formula::Rounded)
}

fn signed(text: &str, digits: impl Fn(String) -> Formula) -> Formula {
    // A negative exponent has a minus sign, too.
    let written = |text: &str| digits(text.replace('-', "−"));
    match text.strip_prefix(['-', '−']) {
        Some(positive) => row([Operator::Negative.into(), written(positive)]),
        None => written(text),
    }
}

/// Returns an upright word.
pub fn word(text: impl Into<String>) -> Formula {
    Formula::Word(text.into())
}

/// Creates a row of formulas. A part that is itself a row is replaced by its parts, and a single part is
/// returned as it is.
pub fn row(parts: impl IntoIterator<Item = Formula>) -> Formula {
    let mut flat = Vec::new();
    for part in parts {
        match part {
            Formula::Row(inner) => flat.extend(inner),
            other => flat.push(other),
        }
    }
    if flat.len() == 1
        && let Some(only) = flat.pop()
    {
        return only;
    }
    Formula::Row(flat)
}

/// Returns `√x`.
pub fn square_root(inner: Formula) -> Formula {
    Formula::Root(Box::new(inner))
}

/// Returns `above / below`.
pub fn fraction(above: Formula, below: Formula) -> Formula {
    Formula::Fraction(Box::new(above), Box::new(below))
}

/// Returns a power such as `base²`.
pub fn power(base: Formula, exponent: &str) -> Formula {
    Formula::Power(Box::new(base), Box::new(number(exponent)))
}

/// Returns `base` with a subscript.
pub fn index(base: Formula, index: Formula) -> Formula {
    Formula::Index(Box::new(base), Box::new(index))
}

/// Returns `|x|`.
pub fn norm(inner: Formula) -> Formula {
    Formula::Norm(Box::new(inner))
}

/// Returns `(x)`.
pub fn parentheses(inner: Formula) -> Formula {
    Formula::Parentheses(Box::new(inner))
}

/// Returns `−x`.
pub fn negative(inner: Formula) -> Formula {
    row([Operator::Negative.into(), inner])
}

/// Returns a number that the user can edit in place.
pub fn given(given: Given, inner: Formula) -> Formula {
    Formula::Given(given, Box::new(inner))
}

/// Returns `(x, y, z)`.
pub fn tuple(coordinates: impl IntoIterator<Item = Formula>) -> Formula {
    Formula::Tuple(coordinates.into_iter().collect(), Arrangement::Row)
}

impl Formula {
    /// Returns true if the formula begins with a minus sign and therefore needs parentheses after an
    /// operator.
    pub fn is_negative(&self) -> bool {
        match self {
            Formula::Operator(Operator::Negative) => true,
            Formula::Given(_, inner) => inner.is_negative(),
            Formula::Row(parts) => parts.first().is_some_and(Formula::is_negative),
            _ => false,
        }
    }

    /// Puts the formula in parentheses if it begins with a minus sign.
    #[must_use]
    pub fn guarded(self) -> Formula {
        if self.is_negative() { parentheses(self) } else { self }
    }

    /// Returns true if a rounded number occurs before the formula's first relation, such as `=`.
    pub fn begins_rounded(&self) -> bool {
        self.parts().iter().take_while(|part| !part.is_relation()).any(Formula::is_rounded)
    }

    /// Returns the sides of an equation, without the relations between them.
    pub fn sides(&self) -> Vec<Formula> {
        self.parts().split(Formula::is_relation).map(|side| row(side.iter().cloned())).collect()
    }

    /// Returns true if a rounded number occurs after the formula's last relation.
    pub fn ends_rounded(&self) -> bool {
        self.parts().iter().rev().take_while(|part| !part.is_relation()).any(Formula::is_rounded)
    }

    fn is_rounded(&self) -> bool {
        self.has(&|part| matches!(part, Formula::Rounded(_)))
    }

    /// Returns true if the formula contains the coordinates of a vector.
    fn has_tuple(&self) -> bool {
        self.has(&|part| matches!(part, Formula::Tuple(..)))
    }

    /// Returns true if `is_such` returns true for the formula or for any part of it.
    fn has(&self, is_such: &dyn Fn(&Formula) -> bool) -> bool {
        let has = |part: &Formula| part.has(is_such);
        is_such(self)
            || match self {
                Formula::Row(parts) | Formula::Tuple(parts, _) => parts.iter().any(has),
                Formula::Fraction(a, b) | Formula::Power(a, b) | Formula::Index(a, b) => {
                    has(a) || has(b)
                }
                Formula::Root(inner)
                | Formula::Norm(inner)
                | Formula::Parentheses(inner)
                | Formula::Given(_, inner) => has(inner),
                _ => false,
            }
    }

    /// Returns true if the formula is a relation, such as `=`. The lines of a derivation are aligned at
    /// their first relation.
    fn is_relation(&self) -> bool {
        matches!(self, Formula::Operator(operator) if operator.is_relation())
    }

    /// Returns true if the formula is an operator between two terms or factors.
    fn is_binary(&self) -> bool {
        matches!(self, Formula::Operator(operator) if operator.is_binary())
    }

    /// Returns the parts of a row; of any other formula, the formula itself as the only part.
    fn parts(&self) -> &[Formula] {
        match self {
            Formula::Row(parts) => parts,
            only => std::slice::from_ref(only),
        }
    }
}

/// Gap between two factors, in ems.
const THIN: f32 = 0.17;
/// Gap around `+` and after a comma, in ems.
const MEDIUM: f32 = 0.24;
/// Gap around `=`, in ems.
const WIDE: f32 = 0.34;

/// Returns the gap between a part of a row and the next one, in ems.
fn gap(before: &Formula, after: &Formula) -> f32 {
    match (before, after) {
        (_, Formula::Operator(Operator::Comma))
        | (Formula::Operator(Operator::Negative), _)
        | (Formula::Word(_), Formula::Parentheses(_)) => 0.0,
        (Formula::Operator(o), _) | (_, Formula::Operator(o)) if o.is_relation() => WIDE,
        (Formula::Operator(_), _) => MEDIUM,
        (_, Formula::Operator(Operator::Negative)) => THIN,
        (_, Formula::Operator(_)) => MEDIUM,
        (Formula::Word(_), _) | (_, Formula::Word(_)) => MEDIUM,
        // The word is slanted over its end.
        (Formula::Scalar(name), _) if name.len() > 1 => WIDE,
        _ => THIN,
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // A single letter is replaced by its bold form in the Unicode block *Mathematical Alphanumeric
            // Symbols*.
            Formula::Vector(name, _) if name.len() == 1 => {
                name.chars().try_for_each(|letter| f.write_char(symbols::bold(letter)))
            }
            Formula::Scalar(name) | Formula::Vector(name, _) => f.write_str(name),
            Formula::Word(text) | Formula::Number(text) | Formula::Rounded(text) => {
                f.write_str(text)
            }
            Formula::Operator(operator) => f.write_str(operator.sign()),
            Formula::Given(_, inner) => inner.fmt(f),
            Formula::Row(parts) => parts.iter().enumerate().try_for_each(|(k, part)| {
                let has_gap = k > 0 && gap(&parts[k - 1], part) > 0.0;
                write!(f, "{}{part}", if has_gap { " " } else { "" })
            }),
            Formula::Root(inner) => write_guarded("√", inner, f),
            Formula::Fraction(above, below) => {
                write_numerator(above, f)?;
                write_guarded("/", below, f)
            }
            Formula::Power(base, exponent) => write_script(base, exponent, '^', &SUPERSCRIPTS, f),
            Formula::Index(base, index) => write_script(base, index, '_', &SUBSCRIPTS, f),
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

/// Writes a sign, such as `√` or `/`, and its operand. The sign applies only to what directly follows it,
/// so an operand with several parts gets parentheses.
fn write_guarded(sign: &str, inner: &Formula, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match inner {
        Formula::Given(_, inner) => write_guarded(sign, inner, f),
        Formula::Row(_) | Formula::Fraction(..) => write!(f, "{sign}({inner})"),
        _ => write!(f, "{sign}{inner}"),
    }
}

/// Writes the numerator of a fraction written with `/`. A product needs no parentheses there.
fn write_numerator(inner: &Formula, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let joins = |part: &Formula| matches!(part, Formula::Operator(operator) if *operator != Operator::Negative);
    match inner {
        Formula::Row(parts) if !parts.iter().any(joins) => write!(f, "{inner}"),
        other => write_guarded("", other, f),
    }
}

fn write_script(
    base: &Formula,
    small: &Formula,
    sign: char,
    digits: &[char; 10],
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    write_guarded("", base, f)?;
    if let Formula::Number(text) = small
        && let Some(text) =
            text.chars().map(|c| Some(digits[c.to_digit(10)? as usize])).collect::<Option<String>>()
    {
        return f.write_str(&text);
    }
    f.write_char(sign)?;
    write_guarded("", small, f)
}

#[cfg(test)]
mod tests;
