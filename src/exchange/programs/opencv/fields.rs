//! Names and their numbers in JSON, in a YAML file of `cv::FileStorage`, or in statements such as
//! `K = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]`.

use std::collections::HashMap;

use serde_json::Value;

use crate::FileError;
use crate::error::one_line;
use crate::format::{Input, json};
use crate::programs::literal::Source;

/// A name and what it is given.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub(super) name: String,
    /// Byte at which the value stands.
    pub(super) at: usize,
    /// The value's text, on one line.
    pub(super) shown: String,
    /// Its numbers, brackets regardless; `None` where it is none of numbers.
    pub(super) numbers: Option<Vec<f64>>,
}

const RIGHT: &str = "only K, R (or rvec) and t, the image's width and height and the distortion may be given, \
                     each by numbers";

/// Returns every field of a text that has one of these names.
///
/// # Errors
/// Returns an error if the text is no JSON, or a statement gives none of these names.
pub(super) fn fields(
    text: &Input,
    is_known: impl Fn(&str) -> bool,
) -> Result<Vec<Field>, FileError> {
    let mut found = Vec::new();
    if text.text.trim_start().starts_with(['{', '[']) {
        let value = json::parse(text)?;
        let mut offsets = NameOffsets { text: text.text, known: HashMap::new() };
        collect(&mut offsets, &value, &is_known, &mut found);
    } else if is_yaml(text.text) {
        found = yaml(text.text);
        found.retain(|field| is_known(&field.name));
    } else {
        let source = Source::new(text, RIGHT)?;
        for statement in &source.statements {
            let [value] = &statement.arguments[..] else {
                return Err(source.refused(statement, RIGHT));
            };
            if !(is_known(&statement.target) && statement.called.is_empty()) {
                return Err(source.refused(statement, RIGHT));
            }
            found.push(Field {
                name: statement.target.clone(),
                at: value.at,
                shown: one_line(&value.text),
                numbers: value.numbers.clone().filter(|_| !value.text.contains('/')),
            });
        }
    }
    Ok(found)
}

/// The bytes at which names stand first in a text, each looked for once.
struct NameOffsets<'t> {
    text: &'t str,
    known: HashMap<String, usize>,
}

impl NameOffsets<'_> {
    fn first(&mut self, name: &str) -> usize {
        let find = || self.text.find(&format!("\"{name}\"")).unwrap_or_default();
        *self.known.entry(name.to_owned()).or_insert_with(find)
    }
}

/// Every object's fields, however deep. JSON that is read is nested at most 127 deep.
fn collect(
    offsets: &mut NameOffsets,
    value: &Value,
    is_known: &impl Fn(&str) -> bool,
    into: &mut Vec<Field>,
) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                if !is_known(name) {
                    collect(offsets, value, is_known, into);
                    continue;
                }
                // As cv::FileStorage writes a matrix.
                let value = value.get("data").unwrap_or(value);
                let mut numbers = Vec::new();
                let is_of_numbers = flatten(value, &mut numbers);
                let at = offsets.first(name);
                into.push(Field {
                    name: name.clone(),
                    at,
                    shown: one_line(&value.to_string().chars().take(500).collect::<String>()),
                    numbers: is_of_numbers.then_some(numbers),
                });
            }
        }
        Value::Array(items) => items.iter().for_each(|item| collect(offsets, item, is_known, into)),
        _ => (),
    }
}

fn flatten(value: &Value, into: &mut Vec<f64>) -> bool {
    match value {
        Value::Array(items) => items.iter().all(|item| flatten(item, into)),
        value => value.as_f64().map(|number| into.push(number)).is_some(),
    }
}

pub(super) fn is_yaml(text: &str) -> bool {
    text.trim_start().starts_with("%YAML")
        || text.lines().any(|line| line.trim_start().starts_with("data:"))
}

/// The fields of a YAML file whose matrices are lists, or have their numbers in a list called `data`.
fn yaml(text: &str) -> Vec<Field> {
    let mut fields = Vec::new();
    // The names that have deeper ones below them, with their indentation.
    let mut above: Vec<(usize, &str)> = Vec::new();
    let (mut at, mut behind) = (0, 0);
    for line in text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        let indentation = line.len() - line.trim_start().len();
        let Some((name, value)) = line.split_once(':') else { continue };
        if start < behind || line.trim_start().starts_with(['%', '#', '-']) {
            continue;
        }
        let (name, given) = (name.trim(), value.trim());
        above.retain(|(own, _)| *own < indentation);
        if given.is_empty() || given.starts_with('!') {
            above.push((indentation, name));
            continue;
        }
        let from = start + line.len() - value.trim_start().len();
        // A list goes on to its bracket, over lines.
        let end = match given.starts_with('[') {
            true => list_end(&text[from..]).map_or(text.len(), |end| from + end),
            false => from + given.len(),
        };
        behind = end;
        let cells = text[from..end].split(|c: char| c.is_whitespace() || "[],".contains(c));
        let cells = cells.filter(|cell| !cell.is_empty());
        let number = |cell: &str| cell.parse().ok().filter(|number: &f64| number.is_finite());
        let name = match (name, above.last()) {
            ("data", Some((_, owner))) => owner,
            (name, _) => name,
        };
        fields.push(Field {
            name: name.to_owned(),
            at: from,
            shown: one_line(&text[from..end]),
            numbers: cells.map(number).collect(),
        });
    }
    fields
}

/// Length of the list with which a text begins, its brackets included.
fn list_end(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    text.bytes()
        .position(|byte| {
            match byte {
                b'[' => depth += 1,
                b']' => depth = depth.saturating_sub(1),
                _ => (),
            }
            depth == 0
        })
        .map(|end| end + 1)
}
