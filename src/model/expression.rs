//! Evaluates the arithmetic that users type in number fields: `sqrt(2)/2`, `1/3`, `2*pi`.

use std::f64::consts::{E, PI, TAU};

use pinhole_exchange::legible;

/// The name of a function of one variable, and the function itself.
type NamedFunction = (&'static str, fn(f64) -> f64);

/// The supported functions of one number.
const FUNCTIONS: [NamedFunction; 9] = [
    ("abs", f64::abs),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sqrt", f64::sqrt),
    ("cbrt", f64::cbrt),
];

const CONSTANTS: [(&str, f64); 7] =
    [("pi", PI), ("PI", PI), ("π", PI), ("e", E), ("E", E), ("tau", TAU), ("τ", TAU)];

/// Maximum nesting depth of brackets and signs, far beyond that of any sensible input.
const DEEPEST: usize = 64;

/// Maximum number of characters of the typed text.
const LONGEST: usize = 1000;

/// Evaluates the text of a number field: a number, or arithmetic with `+ - * / ^`, brackets, functions
/// such as `sqrt`, `sin`, `cos` and `tan`, and `pi`. Pasted Unicode symbols (`−`, `×`, `·`, `√`, `π`)
/// are accepted, too.
///
/// # Errors
/// Returns a sentence for the user if the text is not an expression, is too long, or its value is not
/// finite.
pub fn evaluate(text: &str) -> Result<f64, String> {
    let typed = text.trim();
    if typed.chars().nth(LONGEST).is_some() {
        let shown = shown(typed);
        return Err(format!("“{shown}” is too long: at most {LONGEST} characters are read"));
    }
    let plain = typed.replace('−', "-").replace(['×', '·'], "*").replace('√', "sqrt");
    let plain = plain.replace('²', "^2").replace('³', "^3");
    if plain.is_empty() {
        return Err("type a number, such as 0.5, 1/3 or sqrt(2)/2".to_owned());
    }
    // Try a plain number first: this keeps every digit and accepts exponents such as `1e-300`.
    let value = plain.parse::<f64>().ok().or_else(|| Parser { rest: &plain }.whole());
    let shown = shown(typed);
    let value =
        value.ok_or_else(|| format!("“{shown}” is not a number: try 0.5, 1/3 or sqrt(2)/2"))?;
    if value.is_finite() { Ok(value) } else { Err(format!("“{shown}” is not a finite number")) }
}

/// Shortens the typed text, for use in a message.
fn shown(typed: &str) -> String {
    const ROOM: usize = 60;
    let begin: String = typed.chars().take(ROOM).collect();
    legible(&if begin.len() < typed.len() { begin + "..." } else { begin })
}

/// A recursive-descent parser. Its methods return `None` for a syntax error.
struct Parser<'a> {
    rest: &'a str,
}

impl<'a> Parser<'a> {
    fn whole(mut self) -> Option<f64> {
        let value = self.sum(0)?;
        self.rest.trim_start().is_empty().then_some(value)
    }

    fn sum(&mut self, depth: usize) -> Option<f64> {
        let mut value = self.product(depth)?;
        while let Some(sign) = self.take(['+', '-']) {
            let term = self.product(depth)?;
            value = if sign == '+' { value + term } else { value - term };
        }
        Some(value)
    }

    fn product(&mut self, depth: usize) -> Option<f64> {
        let mut value = self.signed(depth)?;
        while let Some(sign) = self.take(['*', '/']) {
            let factor = self.signed(depth)?;
            value = if sign == '*' { value * factor } else { value / factor };
        }
        Some(value)
    }

    /// Parses a power, with any signs before it: `-2^2` is -4.
    fn signed(&mut self, depth: usize) -> Option<f64> {
        if depth > DEEPEST {
            return None;
        }
        match self.take(['+', '-']) {
            Some('-') => self.signed(depth + 1).map(|value| -value),
            Some(_) => self.signed(depth + 1),
            None => self.power(depth),
        }
    }

    /// Parses a value or a power. Powers associate to the right: `2^3^2` is 2 to the ninth.
    fn power(&mut self, depth: usize) -> Option<f64> {
        let base = self.value(depth)?;
        if self.take(['^']).is_none() {
            return Some(base);
        }
        self.signed(depth + 1).map(|power| base.powf(power))
    }

    /// Parses a number, a constant, an expression in brackets, or a function with its argument.
    fn value(&mut self, depth: usize) -> Option<f64> {
        if depth > DEEPEST {
            return None;
        }
        if self.take(['(']).is_some() {
            let value = self.sum(depth + 1)?;
            return self.take([')']).map(|_| value);
        }
        if let Some(number) = self.number() {
            return Some(number);
        }
        let name = self.name();
        if let Some((_, constant)) = CONSTANTS.iter().find(|(known, _)| *known == name) {
            return Some(*constant);
        }
        let (_, function) = FUNCTIONS.iter().find(|(known, _)| *known == name)?;
        self.value(depth + 1).map(function)
    }

    /// Consumes the next character if it is one of `signs`, and returns it.
    fn take<const N: usize>(&mut self, signs: [char; N]) -> Option<char> {
        let text = self.rest.trim_start();
        let sign = text.chars().next().filter(|sign| signs.contains(sign))?;
        self.rest = &text[sign.len_utf8()..];
        Some(sign)
    }

    /// Parses digits with an optional decimal point and an optional exponent.
    fn number(&mut self) -> Option<f64> {
        let text = self.rest.trim_start();
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let mut end = digits(text);
        if text[end..].starts_with('.') {
            end += 1 + digits(&text[end + 1..]);
        }
        let exponent = &text[end..];
        if let Some(power) = exponent.strip_prefix(['e', 'E']) {
            let power = power.strip_prefix(['+', '-']).unwrap_or(power);
            if digits(power) > 0 {
                end += exponent.len() - power.len() + digits(power);
            }
        }
        let number = text[..end].parse().ok()?;
        self.rest = &text[end..];
        Some(number)
    }

    /// Parses a run of letters.
    fn name(&mut self) -> &'a str {
        let text = self.rest.trim_start();
        let letters = text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len());
        let (name, rest) = text.split_at(letters);
        self.rest = rest;
        name
    }
}

#[cfg(test)]
mod tests {
    use super::evaluate;

    #[test]
    fn numbers_keep_every_digit() {
        for x in [0.1, -2.5, 1e-300, 1.797e308, 5e-324, 0.7123456789012345, -0.0] {
            assert_eq!(evaluate(&format!("{x:?}")), Ok(x));
        }
    }

    #[test]
    fn arithmetic_is_what_one_expects() {
        let cases = [
            ("sqrt(2)/2", 2f64.sqrt() / 2.0),
            ("1/3", 1.0 / 3.0),
            ("-1/sqrt(2)", -1.0 / 2f64.sqrt()),
            ("−√(2)/2", -(2f64.sqrt()) / 2.0),
            ("2*pi", std::f64::consts::TAU),
            ("(1+2)*3", 9.0),
            ("2^10", 1024.0),
            ("1e3+1", 1001.0),
            ("1e-3*2", 0.002),
            ("tan(0.5)", 0.5f64.tan()),
            (" 7 ", 7.0),
            ("5*√2", 5.0 * 2f64.sqrt()),
            ("-2²", -4.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("1-2-3", -4.0),
            ("8/4/2", 1.0),
            ("2 * ( 1 + .5 )", 3.0),
            ("cbrt(8) + abs(-3)", 5.0),
            ("--1", 1.0),
            ("2*e", 2.0 * std::f64::consts::E),
        ];
        for (text, value) in cases {
            assert_eq!(evaluate(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_told() {
        for text in [
            "",
            "abc",
            "1/",
            "sqrt(",
            "1,5",
            "x+1",
            "1/0",
            "0/0",
            "sqrt(-1)",
            "1e999",
            "nan",
            "inf",
            "2 3",
            "2e",
            "(1",
            "1)",
            "sin",
            "..",
            "1+*2",
            "sinus(1)",
            &"(".repeat(100_000),
            &"-".repeat(100_000),
            &"1+".repeat(40_000),
            &format!("1+{}", "x".repeat(900)),
        ] {
            let said = evaluate(text).expect_err(text);
            assert!(said.len() < 200, "{said}");
        }
    }
}
