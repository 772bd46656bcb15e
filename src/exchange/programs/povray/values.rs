//! What POV-Ray's expressions come to: numbers and vectors, and the names that have one value.

use std::cell::RefCell;
use std::collections::HashMap;

use pinhole_core::{DVec3, ImageSize};

use super::source::{Code, Piece, after_spaces, is_of_word, words};

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

/// Declaration of a name.
#[derive(Clone, Copy)]
enum Declared<'t> {
    Once(Piece<'t>),
    /// More than once, or where it may not come to it.
    Changed,
}

/// The names of a text, and what they come to.
pub(super) struct Values<'t> {
    names: HashMap<&'t str, Declared<'t>>,
    image: ImageSize,
    known: RefCell<HashMap<&'t str, Option<Value>>>,
}

/// The directives behind which something stands up to `#end`.
pub(super) const OPENING: [&str; 7] = ["if", "ifdef", "ifndef", "while", "for", "switch", "macro"];

impl<'t> Values<'t> {
    pub(super) fn new(code: &'t Code, image: ImageSize) -> Values<'t> {
        let mut names = HashMap::new();
        let mut depth = 0_usize;
        for directive in directives(code) {
            let behind = after_spaces(directive.from(word_of(directive).text.len()));
            let name = word_of(behind).text;
            match word_of(directive).text {
                "declare" | "local" => {
                    let rest = after_spaces(behind.from(name.len()));
                    let value = rest.text.starts_with('=').then(|| rest.from(1));
                    let declared = match (value, names.contains_key(name), depth) {
                        (Some(value), false, 0) => Declared::Once(value),
                        _ => Declared::Changed,
                    };
                    names.insert(name, declared);
                }
                "undef" => {
                    names.insert(name, Declared::Changed);
                }
                "end" => depth = depth.saturating_sub(1),
                word if OPENING.contains(&word) => {
                    depth += 1;
                    let variables = after_spaces(behind.from(name.len()));
                    let list = if name.is_empty() { behind } else { variables };
                    // What a loop or a macro calls its numbers.
                    if ["for", "macro"].contains(&word)
                        && let Some(inside) = code.bracketed(list)
                    {
                        let variables = inside.text.split(|c| !is_of_word(c));
                        names.extend(variables.map(|variable| (variable, Declared::Changed)));
                    }
                }
                _ => (),
            }
        }
        Values { names, image, known: RefCell::default() }
    }

    /// Returns the names with their values where the image has this size.
    pub(super) fn with_image(self, image: ImageSize) -> Values<'t> {
        Values { image, known: RefCell::default(), ..self }
    }

    /// Returns true for a name that has more than one value.
    pub(super) fn is_changed(&self, name: &str) -> bool {
        matches!(self.names.get(name), Some(Declared::Changed))
    }

    /// Evaluates a piece that is one expression and nothing else.
    pub(super) fn whole(&self, piece: Piece) -> Option<Value> {
        let (value, rest) = self.prefix(piece)?;
        after_spaces(rest).text.is_empty().then_some(value)
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

    /// Evaluates a condition: a number that is not 0, or two that are compared. Angle brackets
    /// stand in it as square ones.
    pub(super) fn condition(&self, piece: Piece) -> Option<bool> {
        let (left, rest) = self.prefix(piece)?;
        let left = one(left)?;
        let rest = after_spaces(rest);
        if rest.text.is_empty() {
            return Some(left != 0.0);
        }
        let signs = ["!=", "[=", "]=", "=", "[", "]"];
        let sign = signs.into_iter().find(|sign| rest.text.starts_with(sign))?;
        let right = self.number(rest.from(sign.len()))?;
        Some(match sign {
            "!=" => left != right,
            "[=" => left <= right,
            "]=" => left >= right,
            "=" => left == right,
            "[" => left < right,
            _ => left > right,
        })
    }

    /// Evaluates the expression with which a piece begins, and returns what follows it too.
    pub(super) fn prefix<'p>(&self, piece: Piece<'p>) -> Option<(Value, Piece<'p>)> {
        let mut reader = Reader { values: self, rest: piece.text, depth: DEEPEST };
        let value = reader.sum()?;
        let read = piece.text.len() - reader.rest.len();
        value.iter().all(|x| x.is_finite()).then(|| (value, piece.from(read)))
    }

    fn of_name(&self, name: &str, depth: usize) -> Option<Value> {
        let Some((name, declared)) = self.names.get_key_value(name) else {
            let color = COLORS.iter().find(|(color, _)| *color == name);
            return color.map(|(_, light)| light.to_vec());
        };
        let Declared::Once(piece) = declared else { return None };
        if let Some(known) = self.known.borrow().get(name) {
            return known.clone();
        }
        // Whatever is made of itself comes to nothing.
        self.known.borrow_mut().insert(name, None);
        let value = Reader { values: self, rest: piece.text, depth }.sum();
        self.known.borrow_mut().insert(name, value.clone());
        value
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

/// The word with which a piece begins.
pub(super) fn word_of(piece: Piece) -> Piece {
    let end = piece.text.find(|c| !is_of_word(c)).unwrap_or(piece.text.len());
    Piece { text: &piece.text[..end], ..piece }
}

/// Finds the text behind every `#` that stands in no string.
fn directives<'t>(code: &'t Code) -> impl Iterator<Item = Piece<'t>> {
    let mut rest = code.whole();
    std::iter::from_fn(move || {
        loop {
            let at = rest.text.find(['#', '"'])?;
            let after = rest.from(at + 1);
            if rest.text[at..].starts_with('#') {
                rest = after_spaces(after);
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
            let place = ["x", "y", "z"].iter().position(|axis| *axis == part)?;
            self.rest = &self.rest[1 + part.len()..];
            value = vec![*value.get(place)?];
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
            return self.list(']').and_then(|parts| parts.into_iter().map(one).collect());
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
            "on" | "yes" | "true" => Some(vec![1.0]),
            "off" | "no" | "false" => Some(vec![0.0]),
            _ if OF_COLORS.contains(&word) => {
                self.depth = self.depth.checked_sub(1)?;
                let color = self.factor();
                self.depth += 1;
                color
            }
            _ if self.rest.trim_start().starts_with('(') => {
                self.takes('(');
                let given = self.list(')')?;
                function(word, &given)
            }
            _ => self.values.of_name(word, self.depth),
        }
    }

    /// Values between commas, up to the bracket that closes them.
    fn list(&mut self, close: char) -> Option<Vec<Value>> {
        let mut values = Vec::new();
        while values.len() < MOST_NUMBERS {
            values.push(self.sum()?);
            if self.takes(close) {
                return Some(values);
            }
            if !self.takes(',') {
                return None;
            }
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

fn function(name: &str, given: &[Value]) -> Option<Value> {
    if let ("vnormalize", [v]) = (name, given) {
        return vector(v)?.try_normalize().map(|v| v.to_array().to_vec());
    }
    if let ("vlength", [v]) = (name, given) {
        return Some(vec![vector(v)?.length()]);
    }
    let numbers: Vec<f64> = given.iter().cloned().map(one).collect::<Option<_>>()?;
    let number = match (name, &numbers[..]) {
        ("sqrt", [x]) => x.sqrt(),
        ("sin", [x]) => x.sin(),
        ("cos", [x]) => x.cos(),
        ("tan", [x]) => x.tan(),
        ("asin", [x]) => x.asin(),
        ("acos", [x]) => x.acos(),
        ("atan2", [y, x]) => y.atan2(*x),
        ("radians", [x]) => x.to_radians(),
        ("degrees", [x]) => x.to_degrees(),
        ("abs", [x]) => x.abs(),
        ("pow", [x, y]) => x.powf(*y),
        ("min", [x, y]) => x.min(*y),
        ("max", [x, y]) => x.max(*y),
        _ => return None,
    };
    number.is_finite().then(|| vec![number])
}

/// Returns true where a word stands anywhere in a piece.
pub(super) fn has(piece: Piece, word: &str) -> bool {
    !words(piece, word).is_empty()
}
