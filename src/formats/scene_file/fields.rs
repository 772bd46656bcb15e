//! The fields of a scene file's tables, each with the name and place that messages give it.

use std::ops::Range;
use std::path::Path;

use pinhole_core::DVec3;
use toml_edit::{ArrayOfTables, Item, TableLike, Value};

use super::super::{FileError, Place, suggest};

/// The text that is read, and what messages call it.
pub(super) struct Source<'a> {
    pub(super) text: &'a str,
    pub(super) path: &'a Path,
}

/// A table: `camera`, `sphere[3]`, or the file itself, whose name is empty.
pub(super) struct Section<'a> {
    source: &'a Source<'a>,
    name: String,
    table: &'a dyn TableLike,
    span: Range<usize>,
}

/// A field with a value.
pub(super) struct Field<'a> {
    source: &'a Source<'a>,
    name: String,
    item: Entry<'a>,
    span: Range<usize>,
}

#[derive(Clone, Copy)]
enum Entry<'a> {
    Value(&'a Value),
    Table(&'a dyn TableLike),
    Tables(&'a ArrayOfTables),
}

impl Source<'_> {
    pub(super) fn error(&self, span: &Range<usize>, problem: impl Into<String>) -> FileError {
        FileError {
            file: self.path.display().to_string(),
            place: Some(Place::of_byte(self.text.as_bytes(), span.start)),
            problem: problem.into(),
        }
    }
}

impl<'a> Section<'a> {
    /// The file itself.
    pub(super) fn root(source: &'a Source<'a>, table: &'a dyn TableLike) -> Section<'a> {
        Section { source, name: String::new(), table, span: 0..0 }
    }

    fn path_of(&self, key: &str) -> String {
        if self.name.is_empty() { key.to_owned() } else { format!("{}.{key}", self.name) }
    }

    /// Refuses the first field that is none of the `known`; `top` are those of the file itself.
    pub(super) fn only(&self, known: &[&'static str], top: &[&str]) -> Result<(), FileError> {
        let Some((key, _)) = self.table.iter().find(|(key, _)| !known.contains(key)) else {
            return Ok(());
        };
        let span = self.table.key(key).and_then(|key| key.span()).unwrap_or(self.span.clone());
        let near = suggest::nearest(key, known.iter().copied());
        let hint = if !self.name.is_empty() && top.contains(&key) {
            "it belongs at the top of the file, before the first [table]".to_owned()
        } else if let Some(near) = near.first() {
            format!("did you mean {near}?")
        } else {
            format!("the fields here are {}", known.join(", "))
        };
        Err(self.source.error(&span, format!("{} is unknown: {hint}", self.path_of(key))))
    }

    /// A field, if it is there.
    pub(super) fn get(&self, key: &str) -> Option<Field<'a>> {
        let item = self.table.get(key)?;
        let entry = match item {
            Item::Value(Value::InlineTable(table)) => Entry::Table(table),
            Item::Value(value) => Entry::Value(value),
            Item::Table(table) => Entry::Table(table),
            Item::ArrayOfTables(tables) => Entry::Tables(tables),
            Item::None => return None,
        };
        let key_span = || self.table.key(key).and_then(|key| key.span());
        let span = item.span().or_else(key_span).unwrap_or(self.span.clone());
        Some(Field { source: self.source, name: self.path_of(key), item: entry, span })
    }

    /// A field that must be there; `such_as` is a line that would do.
    pub(super) fn need(&self, key: &str, such_as: &str) -> Result<Field<'a>, FileError> {
        self.get(key).ok_or_else(|| self.missing(&self.path_of(key), such_as))
    }

    /// The error that something is missing in this table.
    pub(super) fn missing(&self, what: &str, such_as: &str) -> FileError {
        self.source.error(&self.span, format!("{what} is missing: write {such_as}"))
    }
}

impl<'a> Field<'a> {
    /// `camera.eye[2] is nan: ` and what would be right.
    pub(super) fn error(&self, right: &str) -> FileError {
        let value = match self.item {
            Entry::Value(_) => shown(&self.source.text[self.span.clone()]),
            Entry::Table(_) => "a table".to_owned(),
            Entry::Tables(_) => "a list of tables".to_owned(),
        };
        self.source.error(&self.span, format!("{} is {value}: {right}", self.name))
    }

    /// The error that this field is at fault, in words that say its value themselves.
    pub(super) fn fault(&self, problem: impl std::fmt::Display) -> FileError {
        self.source.error(&self.span, format!("{}: {problem}", self.name))
    }

    /// The error that this field is there at all.
    pub(super) fn refuse(&self, why: &str) -> FileError {
        self.source.error(&self.span, format!("{} is there {why}", self.name))
    }

    /// A finite number; an integer will do.
    pub(super) fn number(&self) -> Result<f64, FileError> {
        match self.item {
            Entry::Value(Value::Integer(integer)) => Ok(*integer.value() as f64),
            Entry::Value(Value::Float(float)) if float.value().is_finite() => Ok(*float.value()),
            Entry::Value(Value::Float(_)) => Err(self.error("it must be a finite number")),
            _ => Err(self.error("it must be a number")),
        }
    }

    /// A finite number greater than 0.
    pub(super) fn positive(&self) -> Result<f64, FileError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.error("it must be greater than 0")) }
    }

    /// An integer as it stands.
    pub(super) fn integer(&self) -> Option<i64> {
        match self.item {
            Entry::Value(value) => value.as_integer(),
            _ => None,
        }
    }

    /// Three finite numbers.
    pub(super) fn vector(&self) -> Result<DVec3, FileError> {
        const RIGHT: &str = "it must be three numbers, such as [0.0, 1.0, 0.0]";
        let Entry::Value(Value::Array(array)) = self.item else {
            return Err(self.error(RIGHT));
        };
        if array.len() != 3 {
            return Err(self.error(RIGHT));
        }
        let mut numbers = [0.0; 3];
        for (k, (number, value)) in numbers.iter_mut().zip(array.iter()).enumerate() {
            *number = self.element(k, value).number()?;
        }
        Ok(DVec3::from_array(numbers))
    }

    fn element(&self, k: usize, value: &'a Value) -> Field<'a> {
        let item = match value {
            Value::InlineTable(table) => Entry::Table(table),
            value => Entry::Value(value),
        };
        let span = value.span().unwrap_or(self.span.clone());
        Field { source: self.source, name: format!("{}[{k}]", self.name), item, span }
    }

    /// A string.
    pub(super) fn text(&self) -> Result<&'a str, FileError> {
        match self.item {
            Entry::Value(Value::String(text)) => Ok(text.value()),
            _ => Err(self.error("it must be text in quotes")),
        }
    }

    /// One table.
    pub(super) fn section(&self) -> Result<Section<'a>, FileError> {
        match self.item {
            Entry::Table(table) => Ok(self.section_of(self.name.clone(), table, self.span.clone())),
            _ => Err(self.error(&format!("it must be one table, [{}]", self.name))),
        }
    }

    /// A list of tables.
    pub(super) fn sections(&self) -> Result<Vec<Section<'a>>, FileError> {
        let name = |k: usize| format!("{}[{k}]", self.name);
        let right = format!("each one must be a table that begins with [[{}]]", self.name);
        match self.item {
            Entry::Tables(tables) => {
                let section = |(k, table): (usize, &'a toml_edit::Table)| {
                    self.section_of(name(k), table, table.span().unwrap_or(self.span.clone()))
                };
                Ok(tables.iter().enumerate().map(section).collect())
            }
            Entry::Value(Value::Array(array)) => array
                .iter()
                .enumerate()
                .map(|(k, value)| {
                    let element = self.element(k, value);
                    element.section().map_err(|_| element.error(&right))
                })
                .collect(),
            _ => Err(self.error(&right)),
        }
    }

    fn section_of(
        &self,
        name: String,
        table: &'a dyn TableLike,
        span: Range<usize>,
    ) -> Section<'a> {
        Section { source: self.source, name, table, span }
    }
}

/// A value as it is written, cut to a length that a message can carry.
fn shown(text: &str) -> String {
    const LONGEST: usize = 60;
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() <= LONGEST {
        return line;
    }
    line.chars().take(LONGEST).chain("...".chars()).collect()
}
