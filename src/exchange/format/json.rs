//! Fields of JSON texts, each with the path that messages call it by.

use serde_json::Value;

use super::Input;
use crate::{FileError, Location};

/// A value, and its path: `cameras[0].perspective.yfov`.
#[derive(Clone)]
pub(crate) struct Node<'a> {
    text: &'a Input<'a>,
    pub(crate) path: String,
    pub(crate) value: &'a Value,
}

/// Reads the text.
///
/// # Errors
/// Returns an error if the text is no JSON.
pub(crate) fn parse(text: &Input) -> Result<Value, FileError> {
    serde_json::from_str(text.text).map_err(|error| {
        let said = error.to_string();
        let problem = match (error.is_eof(), said.split(" at line ").next().unwrap_or_default()) {
            (true, said) => match said.strip_prefix("EOF while parsing ") {
                Some(inside) => format!("the text ends inside {inside}: is all of the file there?"),
                None => said.to_owned(),
            },
            (false, "recursion limit exceeded") => {
                "brackets are nested more than 127 deep here".to_owned()
            }
            (false, said) => said.to_owned(),
        };
        FileError::at(text.path, location(text.text, &error), format!("no JSON: {problem}"))
    })
}

/// Position of serde_json's error: its columns are bytes, and 0 before the first one.
fn location(text: &str, error: &serde_json::Error) -> Location {
    let lines = text.split_inclusive('\n').take(error.line().saturating_sub(1));
    let start: usize = lines.map(str::len).sum();
    Location::of_byte(text.as_bytes(), start + error.column().saturating_sub(1))
}

/// Returns true for a text that begins as an object of JSON.
pub(crate) fn looks_like(text: &str) -> bool {
    text.trim_start().starts_with('{')
}

impl<'a> Node<'a> {
    pub(crate) fn root(text: &'a Input<'a>, value: &'a Value) -> Node<'a> {
        Node { text, path: String::new(), value }
    }

    pub(crate) fn get(&self, key: &str) -> Option<Node<'a>> {
        let value = self.value.get(key)?;
        let path =
            if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        Some(Node { text: self.text, path, value })
    }

    pub(crate) fn need(&self, key: &str, right: &str) -> Result<Node<'a>, FileError> {
        self.get(key).ok_or_else(|| {
            let within =
                if self.path.is_empty() { String::new() } else { format!("{}.", self.path) };
            let problem = format!("{within}{key} is missing: {right}");
            FileError::of_file(self.text.path, problem)
        })
    }

    pub(crate) fn items(&self) -> Vec<Node<'a>> {
        let items = self.value.as_array().map_or(&[][..], Vec::as_slice).iter().enumerate();
        items
            .map(|(k, value)| Node { text: self.text, path: format!("{}[{k}]", self.path), value })
            .collect()
    }

    /// `path is value: right`, at the last of the path's names where it stands but once.
    pub(crate) fn fault(&self, right: &str) -> FileError {
        let value: String = self.value.to_string().chars().take(60).collect();
        let problem = format!("{} is {value}: {right}", self.path);
        let name = self.path.rsplit('.').next().unwrap_or_default();
        let quoted = format!("\"{}\"", name.split('[').next().unwrap_or_default());
        let mut matches = self.text.text.match_indices(&quoted);
        match (matches.next(), matches.next()) {
            (Some((at, _)), None) => self.text.error_at(at, problem),
            _ => FileError::of_file(self.text.path, problem),
        }
    }

    pub(crate) fn number(&self) -> Result<f64, FileError> {
        let number = self.value.as_f64().filter(|number| number.is_finite());
        number.ok_or_else(|| self.fault("it must be a finite number"))
    }

    pub(crate) fn positive(&self) -> Result<f64, FileError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.fault("it must be greater than 0")) }
    }

    /// Every number of it, however the lists are nested.
    pub(crate) fn numbers(&self) -> Result<Vec<f64>, FileError> {
        if !self.value.is_array() {
            return Ok(vec![self.number()?]);
        }
        let parts: Result<Vec<Vec<f64>>, FileError> =
            self.items().iter().map(Node::numbers).collect();
        Ok(parts?.concat())
    }

    pub(crate) fn numbers_of<const N: usize>(&self) -> Result<[f64; N], FileError> {
        let numbers = self.numbers()?;
        numbers.try_into().map_err(|_| self.fault(&format!("it must be {N} numbers")))
    }

    pub(crate) fn index(&self) -> Option<usize> {
        self.value.as_u64().and_then(|index| usize::try_from(index).ok())
    }
}
