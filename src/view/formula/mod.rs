//! Formulas as the lecture writes them: a tree, its layout, and what else it can be written as.
//!
//! - this file: the tree, free of fonts and colours;
//! - `text`: the tree in one line of plain text, for screen readers, the clipboard and tests;
//! - `latex`: the tree as LaTeX writes it;
//! - `layout`: the tree as text and strokes with places, given what measures text; `breaking`: the
//!   same in lines of a given width.
//!
//! Vectors and scalars are different kinds of names: a [`Formula::Vector`] is bold and has the colour
//! that it has in the views, a [`Formula::Scalar`] is italic. Nothing here paints.

mod breaking;
pub(crate) mod latex;
mod layout;
mod text;

#[cfg(test)]
mod tests;

pub use breaking::{Column, lines};
pub use layout::{Face, Layout, Measure, Rule, Run, layout};

/// One formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// A scalar's name: italic.
    Scalar(&'static str),
    /// A vector's or a point's name: bold, in a colour of its own.
    Vector(&'static str, Ink),
    /// What is neither: `normalize`, `sin`.
    Word(String),
    /// Digits, as [`number`] writes them.
    Number(String),
    /// The same, but not all that there are.
    Rounded(String),
    /// A sign between two parts, or before one.
    Operator(Operator),
    /// Parts one behind the other.
    Row(Vec<Formula>),
    /// A square root.
    Root(Box<Formula>),
    /// One part above the other.
    Fraction(Box<Formula>, Box<Formula>),
    /// A small part at the upper right.
    Power(Box<Formula>, Box<Formula>),
    /// A small part at the lower right.
    Index(Box<Formula>, Box<Formula>),
    /// `|x|`: a vector's length.
    Norm(Box<Formula>),
    /// `(x)`
    Parentheses(Box<Formula>),
    /// The coordinates of a vector, side by side or one below the other.
    Tuple(Vec<Formula>, Direction),
}

/// How a vector's coordinates are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// `(x, y, z)`
    Row,
    /// One below the other, in brackets.
    Column,
}

/// Which of the views' colours something has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// That of other text.
    Text,
    /// The vector u's.
    U,
    /// The vector v's.
    V,
    /// The vector w's.
    W,
    /// What the camera is given by: at, view, up.
    Given,
    /// The selected ray's.
    Ray,
}

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the signs' own names")]
pub enum Operator {
    Equals,
    Approximately,
    Plus,
    Minus,
    /// The cross product.
    Times,
    /// The dot product, and the product of two numbers.
    Dot,
    Comma,
    /// The minus before a number or vector.
    Negative,
}

impl Operator {
    /// The sign itself.
    pub fn sign(self) -> &'static str {
        match self {
            Operator::Equals => "=",
            Operator::Approximately => "≈",
            Operator::Plus => "+",
            Operator::Minus | Operator::Negative => "−",
            Operator::Times => "×",
            Operator::Dot => "·",
            Operator::Comma => ",",
        }
    }

    /// Whether it says how two sides are related: where a line is broken first.
    pub fn is_relation(self) -> bool {
        matches!(self, Operator::Equals | Operator::Approximately)
    }

    /// Whether it joins two terms or factors: where a line is broken if it must be.
    fn is_binary(self) -> bool {
        use Operator::{Dot, Minus, Plus, Times};
        matches!(self, Plus | Minus | Times | Dot)
    }
}

impl From<Operator> for Formula {
    fn from(operator: Operator) -> Formula {
        Formula::Operator(operator)
    }
}

/// A number as text, its minus the real one.
pub fn number(text: &str) -> Formula {
    signed(text, Formula::Number)
}

/// The same of digits that are not all that the number has.
pub fn rounded(text: &str) -> Formula {
    signed(text, Formula::Rounded)
}

fn signed(text: &str, digits: impl Fn(String) -> Formula) -> Formula {
    // An exponent has a minus, too.
    let written = |text: &str| digits(text.replace('-', "−"));
    match text.strip_prefix(['-', '−']) {
        Some(positive) => row([Operator::Negative.into(), written(positive)]),
        None => written(text),
    }
}

/// Upright words.
pub fn word(text: impl Into<String>) -> Formula {
    Formula::Word(text.into())
}

/// A row; rows within it become part of it.
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

/// `√x`
pub fn root(of: Formula) -> Formula {
    Formula::Root(Box::new(of))
}

/// `above / below`
pub fn fraction(above: Formula, below: Formula) -> Formula {
    Formula::Fraction(Box::new(above), Box::new(below))
}

/// `base²` and the like.
pub fn power(base: Formula, exponent: &str) -> Formula {
    Formula::Power(Box::new(base), Box::new(number(exponent)))
}

/// `base` with a small number or name at its lower right.
pub fn index(base: Formula, index: Formula) -> Formula {
    Formula::Index(Box::new(base), Box::new(index))
}

/// `|x|`
pub fn norm(of: Formula) -> Formula {
    Formula::Norm(Box::new(of))
}

/// `(x)`
pub fn parentheses(of: Formula) -> Formula {
    Formula::Parentheses(Box::new(of))
}

/// `−x`
pub fn negative(of: Formula) -> Formula {
    row([Operator::Negative.into(), of])
}

/// `(x, y, z)`
pub fn tuple(coordinates: impl IntoIterator<Item = Formula>) -> Formula {
    Formula::Tuple(coordinates.into_iter().collect(), Direction::Row)
}

impl Formula {
    /// Whether it begins with a minus, and so needs parentheses behind another sign.
    pub fn is_negative(&self) -> bool {
        match self {
            Formula::Operator(Operator::Negative) => true,
            Formula::Row(parts) => parts.first().is_some_and(Formula::is_negative),
            _ => false,
        }
    }

    /// In parentheses if it begins with a minus.
    #[must_use]
    pub fn guarded(self) -> Formula {
        if self.is_negative() { parentheses(self) } else { self }
    }

    /// Whether digits are left out in it, up to the first sign that relates it to what follows.
    pub fn begins_rounded(&self) -> bool {
        let relates =
            |part: &&Formula| matches!(part, Formula::Operator(sign) if sign.is_relation());
        self.parts().iter().take_while(|part| !relates(part)).any(Formula::is_rounded)
    }

    fn is_rounded(&self) -> bool {
        match self {
            Formula::Rounded(_) => true,
            Formula::Row(parts) | Formula::Tuple(parts, _) => parts.iter().any(Formula::is_rounded),
            Formula::Fraction(a, b) | Formula::Power(a, b) | Formula::Index(a, b) => {
                a.is_rounded() || b.is_rounded()
            }
            Formula::Root(of) | Formula::Norm(of) | Formula::Parentheses(of) => of.is_rounded(),
            Formula::Scalar(_)
            | Formula::Vector(..)
            | Formula::Word(_)
            | Formula::Number(_)
            | Formula::Operator(_) => false,
        }
    }

    /// Its parts, or itself as the only one.
    fn parts(&self) -> &[Formula] {
        match self {
            Formula::Row(parts) => parts,
            only => std::slice::from_ref(only),
        }
    }
}

/// The room between two parts of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Gap {
    None,
    /// Between two factors.
    Thin,
    /// Around `+` and behind a comma.
    Medium,
    /// Around `=`.
    Wide,
}

/// The room between a part of a row and the next one.
fn gap(before: &Formula, after: &Formula) -> Gap {
    match (before, after) {
        (_, Formula::Operator(Operator::Comma))
        | (Formula::Operator(Operator::Negative), _)
        | (Formula::Word(_), Formula::Parentheses(_)) => Gap::None,
        (Formula::Operator(o), _) | (_, Formula::Operator(o)) if o.is_relation() => Gap::Wide,
        (Formula::Operator(_), _) => Gap::Medium,
        (_, Formula::Operator(Operator::Negative)) => Gap::Thin,
        (_, Formula::Operator(_)) => Gap::Medium,
        (Formula::Word(_), _) | (_, Formula::Word(_)) => Gap::Medium,
        _ => Gap::Thin,
    }
}
