//! Reads the fields of the tables in a TOML file, with their names and positions for error messages.

use std::ops::{Range, RangeInclusive};
use std::path::Path;

use pinhole_core::DVec3;
use toml_edit::{ArrayOfTables, Item, TableLike, Value};

use crate::error::{nearest, one_line};
use crate::{FileError, Location};

/// The text of a TOML file, and its path for messages.
pub struct TomlSource<'a> {
    /// Text of the file.
    pub text: &'a str,
    /// Path of the file, for messages.
    pub path: &'a Path,
    /// True for unsaved changes, in which a number that must be positive may be any number.
    pub is_draft: bool,
}

/// A table of the file, such as `camera` or `sphere[3]`, or the whole file, whose name is empty.
pub struct Section<'a> {
    source: &'a TomlSource<'a>,
    name: String,
    table: &'a dyn TableLike,
    span: Range<usize>,
}

/// A field, with its value.
pub struct TomlField<'a> {
    source: &'a TomlSource<'a>,
    name: String,
    item: FieldItem<'a>,
    span: Range<usize>,
}

#[derive(Clone, Copy)]
enum FieldItem<'a> {
    Value(&'a Value),
    Table(&'a dyn TableLike),
    Tables(&'a ArrayOfTables),
}

impl TomlSource<'_> {
    /// Creates an error at a position in the file.
    pub fn error(&self, span: &Range<usize>, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), span.start), problem)
    }
}

impl<'a> Section<'a> {
    /// Returns the section for the whole file, whose name is empty.
    pub fn root(source: &'a TomlSource<'a>, table: &'a dyn TableLike) -> Section<'a> {
        Section { source, name: String::new(), table, span: 0..0 }
    }

    /// Checks the version of a file's format, which is the value of `key`. `what` is a word for the
    /// file's content, for messages; `known` is the version that this program reads.
    ///
    /// # Errors
    /// Returns an error if the version is missing or is not `known`.
    pub fn version(&self, key: &str, what: &str, known: i64) -> Result<(), FileError> {
        let field = self.need(key, &format!("{key} = {known} (the format version) at the top"))?;
        match field.integer() {
            Some(version) if version == known => Ok(()),
            Some(newer) if newer > known => Err(field.error(&format!(
                "this {what} format is newer than this program, which reads {known}: get a newer Pinhole"
            ))),
            _ => Err(field.error(&format!("the format version must be {known}"))),
        }
    }

    /// Returns the name of a field for messages, prefixed with the table's name.
    pub fn path_of(&self, key: &str) -> String {
        let key = one_line(key);
        if self.name.is_empty() { key } else { format!("{}.{key}", self.name) }
    }

    /// Checks that there are no fields but those in `known`. Returns an error for the first other one.
    /// `top` lists the fields that belong at the top of the file, for a better message.
    pub fn only(&self, known: &[&'static str], top: &[&str]) -> Result<(), FileError> {
        let Some((key, _)) = self.table.iter().find(|(key, _)| !known.contains(key)) else {
            return Ok(());
        };
        let span = self.table.key(key).and_then(|key| key.span()).unwrap_or(self.span.clone());
        let near = nearest(key, known.iter().copied());
        let hint = if !self.name.is_empty() && top.contains(&key) {
            "it belongs at the top of the file, before the first [table]".to_owned()
        } else if let Some(near) = near.first() {
            format!("did you mean {near}?")
        } else {
            format!("the fields here are {}", known.join(", "))
        };
        Err(self.source.error(&span, format!("{} is unknown: {hint}", self.path_of(key))))
    }

    /// Returns a field; `None` if the table does not contain it.
    pub fn get(&self, key: &str) -> Option<TomlField<'a>> {
        let item = self.table.get(key)?;
        let entry = match item {
            Item::Value(Value::InlineTable(table)) => FieldItem::Table(table),
            Item::Value(value) => FieldItem::Value(value),
            Item::Table(table) => FieldItem::Table(table),
            Item::ArrayOfTables(tables) => FieldItem::Tables(tables),
            Item::None => return None,
        };
        let key_span = || self.table.key(key).and_then(|key| key.span());
        let span = item.span().or_else(key_span).unwrap_or(self.span.clone());
        Some(TomlField { source: self.source, name: self.path_of(key), item: entry, span })
    }

    /// Returns a required field. `such_as` is an example of a line that sets it, for the error message.
    pub fn need(&self, key: &str, such_as: &str) -> Result<TomlField<'a>, FileError> {
        self.get(key).ok_or_else(|| self.missing(&self.path_of(key), such_as))
    }

    /// Creates the error for a key that is missing in the table.
    pub fn missing(&self, what: &str, such_as: &str) -> FileError {
        self.source.error(&self.span, format!("{what} is missing: write {such_as}"))
    }
}

impl<'a> TomlField<'a> {
    /// Creates an error about the field's value, such as `camera.eye[2] is nan: `, followed by `right`,
    /// the rule for valid values.
    pub fn error(&self, right: &str) -> FileError {
        let value = match self.item {
            FieldItem::Value(_) => one_line(&self.source.text[self.span.clone()]),
            FieldItem::Table(_) => "a table".to_owned(),
            FieldItem::Tables(_) => "a list of tables".to_owned(),
        };
        self.source.error(&self.span, format!("{} is {value}: {right}", self.name))
    }

    /// Creates an error about the field from a message that already contains the value.
    pub fn fault(&self, problem: impl std::fmt::Display) -> FileError {
        self.source.error(&self.span, format!("{}: {problem}", self.name))
    }

    /// Creates the error for a field that must not be present.
    pub fn refuse(&self, why: &str) -> FileError {
        self.source.error(&self.span, format!("{} is there {why}", self.name))
    }

    /// Returns the value as a number, which must be finite. Integers are accepted.
    pub fn number(&self) -> Result<f64, FileError> {
        match self.item {
            FieldItem::Value(Value::Integer(integer)) => Ok(*integer.value() as f64),
            FieldItem::Value(Value::Float(float)) if float.value().is_finite() => {
                Ok(*float.value())
            }
            FieldItem::Value(Value::Float(_)) => Err(self.error("it must be a finite number")),
            FieldItem::Value(Value::String(text)) => Err(self.error(&no_number(text.value()))),
            _ => Err(self.error("it must be a number")),
        }
    }

    /// Returns the value as a number, which must be finite and, except in a draft, greater than 0.
    pub fn positive(&self) -> Result<f64, FileError> {
        let number = self.number()?;
        let is_valid = number > 0.0 || self.is_draft();
        if is_valid { Ok(number) } else { Err(self.error("it must be greater than 0")) }
    }

    /// Returns true if the field belongs to unsaved changes, which may contain invalid numbers.
    pub(crate) fn is_draft(&self) -> bool {
        self.source.is_draft
    }

    /// Returns the value if it is an integer; otherwise `None`.
    pub fn integer(&self) -> Option<i64> {
        match self.item {
            FieldItem::Value(value) => value.as_integer(),
            _ => None,
        }
    }

    /// Returns the value as an integer, which must be in `range`. `what` describes the number in the
    /// error message.
    pub fn whole(&self, range: RangeInclusive<i64>, what: &str) -> Result<i64, FileError> {
        self.integer().filter(|number| range.contains(number)).ok_or_else(|| {
            self.error(&format!("it must be {what}, {} to {}", range.start(), range.end()))
        })
    }

    /// Returns the value as a boolean.
    pub fn boolean(&self) -> Result<bool, FileError> {
        match self.item {
            FieldItem::Value(Value::Boolean(value)) => Ok(*value.value()),
            _ => Err(self.error("it must be true or false")),
        }
    }

    /// Returns the value as a vector, which must have three finite components.
    pub fn vector(&self) -> Result<DVec3, FileError> {
        self.numbers("three numbers, such as [0.0, 1.0, 0.0]").map(DVec3::from_array)
    }

    /// Returns the value as a list of `N` finite numbers. `such_as` says in the error message what is
    /// valid, with an example.
    pub fn numbers<const N: usize>(&self, such_as: &str) -> Result<[f64; N], FileError> {
        let elements = self.elements().filter(|elements| elements.len() == N);
        let elements = elements.ok_or_else(|| self.error(&format!("it must be {such_as}")))?;
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(&elements) {
            *number = element.number()?;
        }
        Ok(numbers)
    }

    /// Returns the elements of a list of values; `None` if the value is not a list.
    pub fn elements(&self) -> Option<Vec<TomlField<'a>>> {
        let FieldItem::Value(Value::Array(array)) = self.item else { return None };
        Some(array.iter().enumerate().map(|(k, value)| self.element(k, value)).collect())
    }

    fn element(&self, k: usize, value: &'a Value) -> TomlField<'a> {
        let item = match value {
            Value::InlineTable(table) => FieldItem::Table(table),
            value => FieldItem::Value(value),
        };
        let span = value.span().unwrap_or(self.span.clone());
        TomlField { source: self.source, name: format!("{}[{k}]", self.name), item, span }
    }

    /// Returns the value as a string.
    pub fn text(&self) -> Result<&'a str, FileError> {
        match self.item {
            FieldItem::Value(Value::String(text)) => Ok(text.value()),
            _ => Err(self.error("it must be text in quotes")),
        }
    }

    /// Returns the value, which must be one of the `known` names. The error suggests the nearest one.
    pub fn one_of(&self, known: &[&'static str]) -> Result<&'static str, FileError> {
        let choices = || format!("it must be one of {}", known.join(", "));
        let text = self.text().map_err(|_| self.error(&choices()))?;
        if let Some(name) = known.iter().find(|name| **name == text) {
            return Ok(name);
        }
        Err(match nearest(text, known.iter().copied()).first() {
            Some(near) => self.error(&format!("did you mean \"{near}\"?")),
            None => self.error(&choices()),
        })
    }

    /// Returns the value as a table.
    pub fn section(&self) -> Result<Section<'a>, FileError> {
        match self.item {
            FieldItem::Table(table) => {
                let (source, name, span) = (self.source, self.name.clone(), self.span.clone());
                Ok(Section { source, name, table, span })
            }
            _ => Err(self.error(&format!("it must be one table, [{}]", self.name))),
        }
    }

    /// Returns the value as a list of tables.
    pub fn sections(&self) -> Result<Vec<Section<'a>>, FileError> {
        self.sections_named(|k| format!("{}[{k}]", self.name))
    }

    /// Returns the value as a list of tables. In error messages, the tables are counted from 1.
    ///
    /// # Errors
    /// Returns an error if the value is not an array of tables.
    pub fn sections_from_one(&self) -> Result<Vec<Section<'a>>, FileError> {
        self.sections_named(|k| format!("{} {}", self.name, k + 1))
    }

    fn sections_named(
        &self,
        name: impl Fn(usize) -> String,
    ) -> Result<Vec<Section<'a>>, FileError> {
        let right = format!("each one must be a table that begins with [[{}]]", self.name);
        match self.item {
            FieldItem::Tables(tables) => {
                let section = |(k, table): (usize, &'a toml_edit::Table)| {
                    let span = table.span().unwrap_or(self.span.clone());
                    Section { source: self.source, name: name(k), table, span }
                };
                Ok(tables.iter().enumerate().map(section).collect())
            }
            FieldItem::Value(Value::Array(array)) => array
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
}

/// Returns the message about a text in place of a number, which may have a decimal comma.
pub(crate) fn no_number(text: &str) -> String {
    let number = text.contains(',').then(|| text.replacen(',', ".", 1).parse::<f64>().ok());
    match number.flatten().filter(|number| number.is_finite()) {
        Some(number) => format!("it must be a number with a decimal point: write {number:?}"),
        None => "it must be a number".to_owned(),
    }
}
