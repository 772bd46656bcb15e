//! A pbrt scene's words, strings and numbers, and the parameters that follow a directive.

use std::collections::HashMap;

use pinhole_core::DVec3;

use crate::FileError;
use crate::format::Input;

/// A word, a string without its quotes, a number, or a bracket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'t> {
    Word(&'t str),
    Quoted(&'t str),
    Number(f64),
    Open,
    Close,
}

/// A directive's string, as a shape's kind, and its values by name.
pub(super) struct Parameters<'t> {
    pub(super) kind: Option<&'t str>,
    values: HashMap<&'t str, (&'t str, Vec<Token<'t>>)>,
}

impl<'t> Parameters<'t> {
    /// The numbers of a parameter; none where it is not there.
    pub(super) fn numbers(&self, name: &str) -> Vec<f64> {
        let number = |token: &Token| match token {
            Token::Number(number) => Some(*number),
            _ => None,
        };
        let values = self.values.get(name).map(|(_, values)| values.iter().filter_map(number));
        values.into_iter().flatten().collect()
    }

    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.numbers(name).first().copied()
    }

    /// Three numbers of a parameter that is declared as a colour.
    pub(super) fn color(&self, name: &str) -> Option<[f64; 3]> {
        let is_color = ["rgb", "color"].contains(&self.values.get(name)?.0);
        is_color.then(|| self.numbers(name).try_into().ok())?
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }
}

/// Goes through a text, token after token.
pub(super) struct Reader<'t> {
    text: &'t Input<'t>,
    tokens: Vec<(Token<'t>, usize)>,
    next: usize,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t Input<'t>) -> Result<Reader<'t>, FileError> {
        Ok(Reader { text, tokens: tokens(text)?, next: 0 })
    }

    pub(super) fn error(&self, at: usize, problem: impl Into<String>) -> FileError {
        self.text.error_at(at, problem)
    }

    pub(super) fn take(&mut self) -> Option<(Token<'t>, usize)> {
        let token = self.tokens.get(self.next).copied();
        self.next += usize::from(token.is_some());
        token
    }

    fn peek(&self) -> Option<Token<'t>> {
        self.tokens.get(self.next).map(|(token, _)| *token)
    }

    pub(super) fn numbers<const N: usize>(
        &mut self,
        word: &str,
        at: usize,
    ) -> Result<[f64; N], FileError> {
        let mut numbers = Vec::new();
        while let Some(Token::Number(_) | Token::Open | Token::Close) = self.peek() {
            if let Some((Token::Number(number), _)) = self.take() {
                numbers.push(number);
            }
        }
        let count = numbers.len();
        numbers
            .try_into()
            .map_err(|_| self.error(at, format!("{word} has {count} numbers: it must have {N}")))
    }

    pub(super) fn vector(&mut self, word: &str, at: usize) -> Result<DVec3, FileError> {
        Ok(DVec3::from_array(self.numbers(word, at)?))
    }

    /// The word or string that a directive has behind it.
    pub(super) fn name(&mut self, word: &str, at: usize) -> Result<&'t str, FileError> {
        match self.take() {
            Some((Token::Quoted(name) | Token::Word(name), _)) => Ok(name),
            _ => Err(self.error(at, format!("{word} has no name: it must have one"))),
        }
    }

    /// The string after a directive, and its parameters: each a type and a name in quotes, and a value or
    /// a list of them.
    pub(super) fn parameters(&mut self, has_kind: bool) -> Result<Parameters<'t>, FileError> {
        let mut parameters = Parameters { kind: None, values: HashMap::new() };
        if let (true, Some(Token::Quoted(kind))) = (has_kind, self.peek()) {
            self.next += 1;
            parameters.kind = Some(kind);
        }
        while let Some(Token::Quoted(declared)) = self.peek() {
            self.next += 1;
            let mut words = declared.split_whitespace();
            let (of, name) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            let mut values = Vec::new();
            match self.peek() {
                Some(Token::Open) => values = self.list()?,
                Some(Token::Quoted(_) | Token::Number(_) | Token::Word("true" | "false")) => {
                    values.extend(self.take().map(|(token, _)| token));
                }
                _ => (),
            }
            parameters.values.insert(name, (of, values));
        }
        Ok(parameters)
    }

    fn list(&mut self) -> Result<Vec<Token<'t>>, FileError> {
        let open = self.take().map_or(0, |(_, at)| at);
        let mut values = Vec::new();
        loop {
            match self.take() {
                Some((Token::Close, _)) => return Ok(values),
                Some((value @ (Token::Number(_) | Token::Quoted(_)), _)) => values.push(value),
                Some((value @ Token::Word("true" | "false"), _)) => values.push(value),
                _ => return Err(self.error(open, "a list is not closed: its ] is missing")),
            }
        }
    }
}

fn tokens<'t>(text: &Input<'t>) -> Result<Vec<(Token<'t>, usize)>, FileError> {
    let mut tokens = Vec::new();
    let source = text.text;
    let mut at = 0;
    while let Some(c) = source[at..].chars().next() {
        let rest = &source[at..];
        let length = match c {
            '#' => rest.find('\n').unwrap_or(rest.len()),
            '[' | ']' => {
                tokens.push((if c == '[' { Token::Open } else { Token::Close }, at));
                1
            }
            '"' => {
                let end = rest[1..].find('"').ok_or_else(|| {
                    text.error_at(at, "a string is not closed: its \" is missing")
                })?;
                tokens.push((Token::Quoted(rest[1..=end].trim()), at));
                end + 2
            }
            c if c.is_whitespace() => c.len_utf8(),
            _ => {
                let end = rest.find(|c: char| c.is_whitespace() || "[]\"#".contains(c));
                let word = &rest[..end.unwrap_or(rest.len())];
                let number = word.parse::<f64>().ok().filter(|x| x.is_finite());
                tokens.push((number.map_or(Token::Word(word), Token::Number), at));
                word.len()
            }
        };
        at += length;
    }
    Ok(tokens)
}
