//! Values of POV-Ray's expressions: numbers and vectors, and the names that have one value.

use std::collections::HashMap;

use pinhole_core::{DVec3, ImageSize};

use super::source::{Code, words};
use crate::programs::pieces::{Piece, is_of_word};

/// The names of `colors.inc` that are read, as light.
const COLORS: [(&str, [f64; 3]); 9] = [
    ("Red", [1.0, 0.0, 0.0]),
    ("Green", [0.0, 1.0, 0.0]),
    ("Blue", [0.0, 0.0, 1.0]),
    ("White", [1.0, 1.0, 1.0]),
    ("Black", [0.0, 0.0, 0.0]),
    ("Yellow", [1.0, 1.0, 0.0]),
    ("Cyan", [0.0, 1.0, 1.0]),
    ("Magenta", [1.0, 0.0, 1.0]),
    ("Gray", [0.752941, 0.752941, 0.752941]),
];

/// Words before a colour's numbers.
const OF_COLORS: [&str; 6] = ["color", "colour", "rgb", "rgbf", "rgbt", "rgbft"];

/// A matrix has so many numbers, and nothing more.
const MOST_NUMBERS: usize = 12;

/// Brackets in brackets, and names that are made of names.
const DEEPEST: usize = 32;

/// One number, or those of a vector or colour.
pub(super) type Value = Vec<f64>;

/// The names of a text, and what they come to.
pub(super) struct Values<'t> {
    /// `None` for a name that is declared more than once, under a condition, or by anything else than
    /// plain numbers.
    names: HashMap<&'t str, Option<Value>>,
    image: ImageSize,
}

/// Returns the number of directives that are not ended behind one of this word.
pub(super) fn depth_behind(word: &str, depth: usize) -> usize {
    match word {
        "end" => depth.saturating_sub(1),
        "if" | "ifdef" | "ifndef" | "while" | "for" | "switch" | "macro" => depth + 1,
        _ => depth,
    }
}

impl<'t> Values<'t> {
    /// The values of a text where the image has this size.
    pub(super) fn new(code: &'t Code, image: ImageSize) -> Values<'t> {
        let mut values = Values { names: HashMap::new(), image };
        let mut depth = 0_usize;
        for directive in directives(code) {
            let word = directive.word();
            let behind = directive.from(word.text.len()).after_spaces();
            let name = behind.word().text;
            let rest = behind.from(name.len()).after_spaces();
            match word.text {
                "declare" | "local" | "undef" => {
                    let is_first = depth == 0 && !values.names.contains_key(name);
                    let value = rest.text.strip_prefix('=').filter(|_| is_first);
                    let value = value
                        .and_then(|rest| Reader { values: &values, rest, depth: DEEPEST }.sum());
                    values.names.insert(name, value);
                }
                "for" | "macro" => {
                    // What a loop or a macro calls its numbers.
                    let list = if name.is_empty() { behind } else { rest };
                    let inside = code.bracketed(list).map_or("", |inside| inside.text);
                    // Up to a directive, so that lists in each other are not read again and again.
                    let own = inside.split('#').next().unwrap_or_default();
                    let variables = own.split(|c| !is_of_word(c));
                    values.names.extend(variables.map(|variable| (variable, None)));
                }
                _ => (),
            }
            depth = depth_behind(word.text, depth);
        }
        values
    }

    /// Returns true for a name that is declared, and comes to nothing.
    pub(super) fn is_open(&self, name: &str) -> bool {
        self.names.get(name) == Some(&None)
    }

    /// Evaluates a piece that is one expression and nothing else.
    pub(super) fn whole(&self, piece: Piece) -> Option<Value> {
        let (value, rest) = self.prefix(piece)?;
        rest.after_spaces().text.is_empty().then_some(value)
    }

    pub(super) fn number(&self, piece: Piece) -> Option<f64> {
        match self.whole(piece)?[..] {
            [number] => Some(number),
            _ => None,
        }
    }

    pub(super) fn vector(&self, piece: Piece) -> Option<DVec3> {
        vector(&self.whole(piece)?)
    }

    /// Evaluates the expression with which a piece begins, and returns what follows it too.
    pub(super) fn prefix<'p>(&self, piece: Piece<'p>) -> Option<(Value, Piece<'p>)> {
        let mut reader = Reader { values: self, rest: piece.text, depth: DEEPEST };
        let value = reader.sum()?;
        let read = piece.text.len() - reader.rest.len();
        value.iter().all(|x| x.is_finite()).then(|| (value, piece.from(read)))
    }

    fn named(&self, name: &str) -> Option<Value> {
        match self.names.get(name) {
            Some(value) => value.clone(),
            None => {
                COLORS.iter().find(|(color, _)| *color == name).map(|(_, light)| light.to_vec())
            }
        }
    }
}

/// A number is a vector of three that are alike.
pub(super) fn vector(value: &[f64]) -> Option<DVec3> {
    match *value {
        [x] => Some(DVec3::splat(x)),
        [x, y, z] => Some(DVec3::new(x, y, z) + DVec3::ZERO),
        _ => None,
    }
}

/// Finds the text behind every `#` that stands in no string.
fn directives<'t>(code: &'t Code) -> impl Iterator<Item = Piece<'t>> {
    let mut rest = code.whole();
    std::iter::from_fn(move || {
        loop {
            let at = rest.text.find(['#', '"'])?;
            let after = rest.from(at + 1);
            if rest.text[at..].starts_with('#') {
                rest = after.after_spaces();
                return Some(rest);
            }
            rest = after.from(after.text.find(['"', '\n']).map_or(after.text.len(), |at| at + 1));
        }
    })
}

/// Reads an expression as POV-Ray does: as far as it goes.
struct Reader<'v, 'r, 't> {
    values: &'v Values<'t>,
    rest: &'r str,
    depth: usize,
}

impl Reader<'_, '_, '_> {
    fn takes(&mut self, sign: char) -> bool {
        self.rest = self.rest.trim_start();
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Option<Value> {
        self.depth = self.depth.checked_sub(1)?;
        let mut sum = self.product()?;
        loop {
            if self.takes('+') {
                sum = together(sum, self.product()?, |a, b| a + b)?;
            } else if self.takes('-') {
                sum = together(sum, self.product()?, |a, b| a - b)?;
            } else {
                self.depth += 1;
                return Some(sum);
            }
        }
    }

    fn product(&mut self) -> Option<Value> {
        let mut product = self.factor()?;
        loop {
            if self.takes('*') {
                product = together(product, self.factor()?, |a, b| a * b)?;
            } else if self.takes('/') {
                product = together(product, self.factor()?, |a, b| a / b)?;
            } else {
                return Some(product);
            }
        }
    }

    fn factor(&mut self) -> Option<Value> {
        let mut sign = 1.0;
        loop {
            if self.takes('-') {
                sign = -sign;
            } else if !self.takes('+') {
                break;
            }
        }
        let mut value = self.atom()?;
        if let Some(part) = self.rest.strip_prefix('.').map(word_at) {
            let k = ["x", "y", "z"].iter().position(|axis| *axis == part)?;
            self.rest = &self.rest[1 + part.len()..];
            value = vec![*value.get(k)?];
        }
        Some(value.into_iter().map(|x| sign * x).collect())
    }

    fn atom(&mut self) -> Option<Value> {
        self.rest = self.rest.trim_start();
        if self.takes('(') {
            let inside = self.sum()?;
            return self.takes(')').then_some(inside);
        }
        if self.takes('[') {
            return self.list(']');
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.literal();
        }
        let word = word_at(self.rest);
        self.rest = &self.rest[word.len()..];
        let axis = |v: DVec3| Some(v.to_array().to_vec());
        match word {
            "" => None,
            "x" => axis(DVec3::X),
            "y" => axis(DVec3::Y),
            "z" => axis(DVec3::Z),
            "pi" => Some(vec![std::f64::consts::PI]),
            "image_width" => Some(vec![f64::from(self.values.image.width())]),
            "image_height" => Some(vec![f64::from(self.values.image.height())]),
            _ if OF_COLORS.contains(&word) => {
                self.depth = self.depth.checked_sub(1)?;
                let color = self.factor();
                self.depth += 1;
                color
            }
            _ => self.values.named(word),
        }
    }

    /// Numbers up to the bracket that closes them. A comma may stand between two, or none.
    fn list(&mut self, close: char) -> Option<Value> {
        let mut values = Vec::new();
        while values.len() < MOST_NUMBERS {
            values.push(one(self.sum()?)?);
            if self.takes(close) {
                return Some(values);
            }
            self.takes(',');
        }
        None
    }

    fn literal(&mut self) -> Option<Value> {
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
        let mut end = digits(self.rest);
        if self.rest[end..].starts_with('.') {
            end += 1 + digits(&self.rest[end + 1..]);
        }
        if let Some(exponent) = self.rest[end..].strip_prefix(['e', 'E']) {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            let count = digits(&exponent[sign..]);
            end += if count > 0 { 1 + sign + count } else { 0 };
        }
        let number = self.rest[..end].parse().ok()?;
        self.rest = &self.rest[end..];
        Some(vec![number])
    }
}

fn word_at(text: &str) -> &str {
    &text[..text.find(|c| !is_of_word(c)).unwrap_or(text.len())]
}

fn one(value: Value) -> Option<f64> {
    if let [number] = value[..] { Some(number) } else { None }
}

/// Part by part; a number stands for a vector of such.
fn together(a: Value, b: Value, with: impl Fn(f64, f64) -> f64) -> Option<Value> {
    match (&a[..], &b[..]) {
        (a, [b]) => Some(a.iter().map(|a| with(*a, *b)).collect()),
        ([a], b) => Some(b.iter().map(|b| with(*a, *b)).collect()),
        (a, b) if a.len() == b.len() => Some(a.iter().zip(b).map(|(a, b)| with(*a, *b)).collect()),
        _ => None,
    }
}

/// Returns true where a word stands anywhere in a piece.
pub(super) fn has(piece: Piece, word: &str) -> bool {
    !words(piece, word).is_empty()
}
