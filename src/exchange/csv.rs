//! Reads CSV tables without allocating memory per row: many spheres (header `x,y,z,r`, optionally
//! `color` and `name`), and rays (header `ox,oy,oz,dx,dy,dz`). Columns may be in any order.

use std::path::Path;

use pinhole_core::{DVec3, Ray, Sphere};

use crate::document::Item;
use crate::error::{nearest, one_line};
use crate::fields::no_number;
use crate::images;
use crate::{FileError, Location, limits};

const SPHERE: &[&str] = &["x", "y", "z", "r", "color", "name"];
const R: usize = 3;
const COLOR: usize = 4;
const NAME: usize = 5;
const RAY: &[&str] = &["ox", "oy", "oz", "dx", "dy", "dz"];

/// Reads the spheres of a CSV file.
///
/// # Errors
/// Returns an error if the file cannot be read or a row is invalid. The error for a row has its line,
/// column and value.
pub fn load_spheres(path: &Path) -> Result<Vec<Item<Sphere>>, FileError> {
    spheres(path, &limits::read(path, limits::TABLE)?)
}

/// Reads spheres from a file's content; `path` is used in messages.
///
/// # Errors
/// Returns an error for the first invalid row, with its line, column and value.
pub fn spheres(path: &Path, bytes: &[u8]) -> Result<Vec<Item<Sphere>>, FileError> {
    let mut spheres = Vec::new();
    CsvTable::new(path, bytes, SPHERE, R + 1)?.for_each(|row| {
        let (center, radius) = (row.vector(0)?, row.number(R)?);
        if radius <= 0.0 {
            return Err(row.error(R, "it must be greater than 0"));
        }
        let right = "it must be a colour such as #e69f00";
        let color = |text| images::parse_color(text).ok_or_else(|| row.error(COLOR, right));
        let color = row.text(COLOR)?.map(color).transpose()?;
        let name = row.text(NAME)?.map(str::to_owned);
        spheres.push(Item { name, color, shape: Sphere { center, radius } });
        Ok(())
    })?;
    spheres.shrink_to_fit();
    Ok(spheres)
}

/// Reads rays from a file's content; `path` is used in messages.
///
/// # Errors
/// Returns an error for the first invalid row, with its line, column and value. A row is invalid if a
/// cell is not a finite number, or if the direction is zero.
pub fn rays(path: &Path, bytes: &[u8]) -> Result<Vec<Ray>, FileError> {
    let mut rays = Vec::new();
    CsvTable::new(path, bytes, RAY, RAY.len())?.for_each(|row| {
        let (origin, direction) = (row.vector(0)?, row.vector(3)?);
        if direction == DVec3::ZERO {
            return Err(row.error(3, NO_DIRECTION));
        }
        rays.push(Ray { origin, direction });
        Ok(())
    })?;
    Ok(rays)
}

/// The error message for a direction of zero.
pub(crate) const NO_DIRECTION: &str = "the direction (dx, dy, dz) is zero: it must point somewhere";

/// A CSV file in memory, with its header parsed.
pub(crate) struct CsvTable<'a> {
    file: &'a Path,
    bytes: &'a [u8],
    reader: csv::Reader<&'a [u8]>,
    /// For each known column name, the index of the column in the file; `None` if the file has no such
    /// column.
    fields: Vec<Option<usize>>,
    names: &'static [&'static str],
    width: usize,
}

/// One row of a [`CsvTable`].
pub(crate) struct CsvRow<'t, 'a> {
    table: &'t CsvTable<'a>,
    record: &'t csv::ByteRecord,
}

impl<'a> CsvTable<'a> {
    /// Reads the header, which contains the required columns and may contain the optional ones, in any
    /// order and case. `names` lists all of them: first the `required` ones, then the optional ones.
    pub(crate) fn new(
        file: &'a Path,
        bytes: &'a [u8],
        names: &'static [&'static str],
        required: usize,
    ) -> Result<CsvTable<'a>, FileError> {
        if let Some((at, problem)) = no_row(bytes) {
            return Err(FileError::at(file, Location::of_byte(bytes, at), problem));
        }
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(bytes);
        let header = match reader.byte_headers() {
            Ok(header) => header.clone(),
            Err(error) => return Err(FileError::of_file(file, error.to_string())),
        };
        let mut table =
            CsvTable { file, bytes, reader, fields: vec![None; names.len()], names, width: 0 };
        table.width = header.len();
        if let Some(problem) = no_header(&header, names) {
            return Err(table.error(Some(Location::START), problem));
        }
        for (field, cell) in header.iter().enumerate() {
            let location = table.location_of(&header, field);
            let name = String::from_utf8_lossy(plain(cell));
            let Some(column) = names.iter().position(|known| known.eq_ignore_ascii_case(&name))
            else {
                return Err(table.error(Some(location), unknown_column(&name, names)));
            };
            if table.fields[column].replace(field).is_some() {
                return Err(table.error(Some(location), format!("column {name} is there twice")));
            }
        }
        if let Some(missing) = table.fields[..required].iter().position(Option::is_none) {
            let (needed, missing) = (names[..required].join(","), names[missing]);
            let problem = format!(
                "column {missing} is missing: the first line must name the columns {needed}"
            );
            return Err(table.error(Some(Location::START), problem));
        }
        Ok(table)
    }

    /// Calls `each` for every row.
    pub(crate) fn for_each(
        mut self,
        mut each: impl FnMut(&CsvRow) -> Result<(), FileError>,
    ) -> Result<(), FileError> {
        let mut record = csv::ByteRecord::new();
        for count in 0_usize.. {
            match self.reader.read_byte_record(&mut record) {
                Ok(true) => {}
                Ok(false) => return Ok(()),
                Err(error) => return Err(self.error(None, error.to_string())),
            }
            if count == limits::ROWS {
                let problem = format!("there are too many rows: at most {} are read", limits::ROWS);
                return Err(self.error(Some(self.location_of(&record, 0)), problem));
            }
            if record.len() != self.width {
                let problem = format!(
                    "the row has {} cells: it must have {}, as the first line has",
                    record.len(),
                    self.width
                );
                return Err(self.error(Some(self.location_of(&record, 0)), problem));
            }
            each(&CsvRow { table: &self, record: &record })?;
        }
        Ok(())
    }

    fn error(&self, location: Option<Location>, problem: String) -> FileError {
        FileError { location, ..FileError::of_file(self.file, problem) }
    }

    /// Returns the line and column of a field, by searching its row again. This is only needed for
    /// errors.
    fn location_of(&self, record: &csv::ByteRecord, field: usize) -> Location {
        let start = record.position().map_or(0, |p| p.byte() as usize).min(self.bytes.len());
        // The reader's position includes the empty lines before the row.
        let is_row = |b: &u8| !matches!(b, b'\r' | b'\n');
        let start = start + self.bytes[start..].iter().position(is_row).unwrap_or(0);
        let (mut left, mut quoted, mut byte) = (field, false, start);
        while left > 0 && byte < self.bytes.len() {
            match self.bytes[byte] {
                b'"' => quoted = !quoted,
                b',' if !quoted => left -= 1,
                _ => {}
            }
            byte += 1;
        }
        Location::of_byte(self.bytes, byte)
    }
}

/// Returns the byte at which a table can no longer be split into rows, and the reason (an unclosed
/// quote, or a row that is too long), or `None` if the whole table can be split. Without this check,
/// the CSV reader would load all remaining bytes into memory.
fn no_row(bytes: &[u8]) -> Option<(usize, String)> {
    let (mut row, mut quote, mut passed) = (0, None, 0);
    let marks = memchr::memchr3_iter(b'"', b'\n', b'\r', bytes);
    for at in marks.chain([bytes.len()]) {
        if at - row > limits::ROW {
            let problem = format!("the row is too long: at most {} kB are read", limits::ROW >> 10);
            return Some(quote.map(unclosed).unwrap_or((row, problem)));
        }
        match (bytes.get(at), quote) {
            // The second of two quotes, which together stand for one.
            _ if at < passed => (),
            (Some(b'"'), None) if at == row || bytes[at - 1] == b',' => quote = Some(at),
            (Some(b'"'), Some(_)) if bytes.get(at + 1) == Some(&b'"') => passed = at + 2,
            (Some(b'"'), Some(_)) => quote = None,
            (Some(b'\r' | b'\n'), None) => row = at + 1,
            _ => (),
        }
    }
    quote.map(unclosed)
}

/// Returns the error message for a first line that has none of the column names; `None` if it has one.
/// The message does not quote the line, because a scene may refer to any file as its table.
fn no_header(header: &csv::ByteRecord, names: &[&'static str]) -> Option<String> {
    let is_known = |cell: &[u8]| {
        let cell = String::from_utf8_lossy(plain(cell));
        names.iter().any(|known| known.eq_ignore_ascii_case(&cell))
    };
    let has_known =
        |separator: u8| header.iter().any(|cell| cell.split(|b| *b == separator).any(is_known));
    if header.is_empty() || has_known(b',') {
        return None;
    }
    let other =
        [(b';', "semicolons"), (b'\t', "tabs")].into_iter().find(|(sign, _)| has_known(*sign));
    Some(match other {
        Some((_, separators)) => separated_by(separators),
        None => format!("the first line must be a header with columns out of {}", names.join(",")),
    })
}

fn unclosed(quote: usize) -> (usize, String) {
    (quote, "this quote is not closed: a second one must end its cell".to_owned())
}

/// Returns the error message for a table whose cells are separated by `separators` instead of commas.
pub(crate) fn separated_by(separators: &str) -> String {
    format!(
        "the first line has {separators}: commas must stand between cells, and a point in a number"
    )
}

/// Returns a cell without surrounding spaces and quotes. The CSV reader does not remove quotes that
/// follow a space.
fn plain(cell: &[u8]) -> &[u8] {
    let cell = cell.trim_ascii();
    let inside = cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\""));
    inside.map_or(cell, <[u8]>::trim_ascii)
}

impl CsvRow<'_, '_> {
    /// Returns the cell of a known column without surrounding spaces; it is empty if the file has no
    /// such column.
    pub(crate) fn cell(&self, column: usize) -> &[u8] {
        let field = self.table.fields[column];
        plain(field.and_then(|field| self.record.get(field)).unwrap_or_default())
    }

    /// Returns the number in a column, which must be finite.
    pub(crate) fn number(&self, column: usize) -> Result<f64, FileError> {
        let text = std::str::from_utf8(self.cell(column)).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(self.error(column, "it must be a finite number")),
            Err(_) => Err(self.error(column, &no_number(text))),
        }
    }

    /// Returns the vector in three consecutive columns, starting with `first`.
    fn vector(&self, first: usize) -> Result<DVec3, FileError> {
        Ok(DVec3::new(self.number(first)?, self.number(first + 1)?, self.number(first + 2)?))
    }

    /// Returns the text in a column; `None` if the cell is empty.
    pub(crate) fn text(&self, column: usize) -> Result<Option<&str>, FileError> {
        match std::str::from_utf8(self.cell(column)) {
            Ok("") => Ok(None),
            Ok(text) => Ok(Some(text)),
            Err(_) => Err(self.error(column, "it must be UTF-8 text")),
        }
    }

    /// Creates an error such as `column r is "-1": it must be greater than 0`, located at the cell,
    /// where `right` is the part after the colon.
    pub(crate) fn error(&self, column: usize, right: &str) -> FileError {
        let location = self.table.fields[column].map(|f| self.table.location_of(self.record, f));
        let value = one_line(&String::from_utf8_lossy(self.cell(column)));
        let problem = format!("column {} is {value:?}: {right}", self.table.names[column]);
        self.table.error(location, problem)
    }
}

fn unknown_column(name: &str, names: &[&'static str]) -> String {
    let name = &*one_line(name);
    let hint = match nearest(name, names.iter().copied()).first() {
        Some(near) => format!("did you mean {near}?"),
        None => format!("the first line must name columns out of {}", names.join(",")),
    };
    format!("column {name:?} is unknown: {hint}")
}
