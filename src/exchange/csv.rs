//! Reads CSV tables row by row, of which one is in memory at a time: many spheres (header `x,y,z,r`,
//! optionally `color` and `name`), and rays (header `ox,oy,oz,dx,dy,dz`). Columns may be in any order.

use std::io::{self, Read};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use pinhole_core::{DVec3, Ray, Rgb, Sphere};

use crate::error::{nearest, one_line};
use crate::fields::no_number;
use crate::{FileError, Location, images, limits};

const SPHERE: &[&str] = &["x", "y", "z", "r", "color", "name"];
const R: usize = 3;
const COLOR: usize = 4;
const NAME: usize = 5;
const RAY: &[&str] = &["ox", "oy", "oz", "dx", "dy", "dz"];

/// The spheres of a table, with their names and colours. A column that the table does not have takes no
/// memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SphereTable {
    /// Spheres in the file's order, which a scene shares.
    pub spheres: Arc<Vec<Sphere>>,
    colors: Vec<Option<Rgb>>,
    /// All names, one after another, in UTF-8.
    names: Vec<u8>,
    /// The end of each sphere's name in `names`.
    name_ends: Vec<u32>,
}

impl SphereTable {
    /// Returns the name and the colour of a sphere, if it has them.
    pub fn look(&self, index: usize) -> (Option<&str>, Option<Rgb>) {
        let end = |index: usize| self.name_ends.get(index).map_or(0, |end| *end as usize);
        let name = &self.names[index.checked_sub(1).map_or(0, end)..end(index)];
        let name = std::str::from_utf8(name).ok().filter(|name| !name.is_empty());
        (name, self.colors.get(index).copied().flatten())
    }
}

/// Reads the spheres of a table; `path` is used in messages.
///
/// # Errors
/// Returns an error if the source cannot be read, if there is too little memory, or for the first invalid
/// row, with its line, column and value.
pub fn spheres(path: &Path, source: impl Read) -> Result<SphereTable, FileError> {
    let (mut spheres, mut found) = (Vec::new(), SphereTable::default());
    CsvTable::new(path, source, SPHERE, R + 1)?.for_each(|row| {
        let (center, radius) = (row.vector(0)?, row.number(R)?);
        if radius <= 0.0 {
            return Err(row.error(R, "it must be greater than 0"));
        }
        row.append(&mut spheres, &[Sphere { center, radius }])?;
        if row.has(COLOR) {
            let color = images::parse_color(row.text(COLOR));
            if color.is_none() && !row.cell(COLOR).is_empty() {
                return Err(row.error(COLOR, "it must be a colour such as #e69f00"));
            }
            row.append(&mut found.colors, &[color])?;
        }
        if row.has(NAME) {
            let name = row.text(NAME);
            if name.is_empty() && !row.cell(NAME).is_empty() {
                return Err(row.error(NAME, "it must be UTF-8 text"));
            }
            // Two quotes stand for one.
            row.append(&mut found.names, name.replace("\"\"", "\"").as_bytes())?;
            row.append(&mut found.name_ends, &[found.names.len() as u32])?;
        }
        Ok(())
    })?;
    spheres.shrink_to_fit();
    // A scene's index takes this much for each of many spheres; whoever makes it has no way to say so.
    limits::memory("the index of the table's spheres", 48 * spheres.len() as u64)
        .map_err(|problem| FileError::of_file(path, problem))?;
    Ok(SphereTable { spheres: Arc::new(spheres), ..found })
}

/// Reads the rays of a table; `path` is used in messages.
///
/// # Errors
/// Returns the errors of [`spheres`]. A row is invalid if a cell is not a finite number, or if the
/// direction is zero.
pub fn rays(path: &Path, source: impl Read) -> Result<Vec<Ray>, FileError> {
    let mut rays = Vec::new();
    CsvTable::new(path, source, RAY, RAY.len())?.for_each(|row| {
        let (origin, direction) = (row.vector(0)?, row.vector(3)?);
        if direction == DVec3::ZERO {
            return Err(row.error(3, NO_DIRECTION));
        }
        row.append(&mut rays, &[Ray { origin, direction }])
    })?;
    Ok(rays)
}

/// The error message for a direction of zero.
pub(crate) const NO_DIRECTION: &str = "the direction (dx, dy, dz) is zero: it must point somewhere";

const UNCLOSED: &str = "this quote is not closed: a second one must end its cell";
const TOO_MANY: &str = "there are too many rows: at most 10000000 are read";
const TOO_LONG: &str = "the row is too long: at most 64 kB are read";

/// Number of bytes that are read at once.
const BLOCK: u64 = 256 << 10;

/// A CSV file, of which one row at a time is known: at first its header.
pub(crate) struct CsvTable<'a> {
    file: &'a Path,
    source: io::Take<Box<dyn Read + 'a>>,
    /// True if the source is at its end.
    is_ended: bool,
    /// The part of the file around the row.
    bytes: Vec<u8>,
    /// The byte in `bytes` at which the row begins, and its line, counted from 0.
    row: (usize, usize),
    /// The same for the next row.
    next: (usize, usize),
    /// The row's cells, as they are written.
    cells: Vec<Range<usize>>,
    /// For each known column name, the index of the column in the file; `None` if the file has no such
    /// column.
    fields: Vec<Option<usize>>,
    names: &'static [&'static str],
}

impl<'a> CsvTable<'a> {
    /// Reads the header, which contains the required columns and may contain the optional ones, in any
    /// order and case. `names` lists all of them: first the `required` ones, then the optional ones.
    pub(crate) fn new(
        file: &'a Path,
        source: impl Read + 'a,
        names: &'static [&'static str],
        required: usize,
    ) -> Result<CsvTable<'a>, FileError> {
        let mut table = CsvTable {
            file,
            source: (Box::new(source) as Box<dyn Read>).take(limits::TABLE + 1),
            is_ended: false,
            bytes: Vec::new(),
            row: (0, 0),
            next: (0, 0),
            cells: Vec::new(),
            fields: vec![None; names.len()],
            names,
        };
        table.fill()?;
        limits::not_utf_16(file, &table.bytes)?;
        if table.bytes.starts_with("\u{feff}".as_bytes()) {
            table.next.0 = 3;
        }
        while table.read_row()? && table.cells.is_empty() {}
        if let Some(problem) = table.no_header() {
            return Err(FileError::at(file, Location::START, problem));
        }
        for (field, cell) in table.cells.iter().enumerate() {
            let name = String::from_utf8_lossy(plain(&table.bytes[cell.clone()]));
            let Some(column) = table.column_of(name.as_bytes()) else {
                return Err(table.error_at(cell.start, unknown_column(&name, names)));
            };
            if table.fields[column].replace(field).is_some() {
                return Err(table.error_at(cell.start, format!("column {name} is there twice")));
            }
        }
        if let Some(missing) = table.fields[..required].iter().position(Option::is_none) {
            let (needed, missing) = (names[..required].join(","), names[missing]);
            let problem = format!(
                "column {missing} is missing: the first line must name the columns {needed}"
            );
            return Err(FileError::at(file, Location::START, problem));
        }
        Ok(table)
    }

    /// Calls `each` for every row.
    pub(crate) fn for_each(
        mut self,
        mut each: impl FnMut(&Self) -> Result<(), FileError>,
    ) -> Result<(), FileError> {
        let (width, mut count) = (self.cells.len(), 0);
        while self.read_row()? {
            match self.cells.len() {
                0 => continue,
                _ if count == limits::ROWS => return Err(self.error_at(self.row.0, TOO_MANY)),
                cells if cells != width => {
                    let right = format!("it must have {width}, as the first line has");
                    let noun = if cells == 1 { "cell" } else { "cells" };
                    let problem = format!("the row has {cells} {noun}: {right}");
                    return Err(self.error_at(self.row.0, problem));
                }
                _ => each(&self)?,
            }
            count += 1;
        }
        Ok(())
    }

    /// Reads the next row, which has no cells if the line is empty. Returns false at the end of the file.
    fn read_row(&mut self) -> Result<bool, FileError> {
        self.fill()?;
        self.row = self.next;
        self.cells.clear();
        let start = self.row.0;
        let bytes = &self.bytes[..self.bytes.len().min(start + limits::ROW + 1)];
        let (mut cell, mut is_quoted, mut closed) = (start, false, usize::MAX);
        let end = (start..bytes.len()).find(|&at| {
            match bytes[at] {
                b'"' if is_quoted => (is_quoted, closed) = (false, at + 1),
                // Of two quotes inside a quoted cell, which stand for one, the second opens it again.
                b'"' if at == cell || at == closed => is_quoted = true,
                b',' if !is_quoted => {
                    self.cells.push(cell..at);
                    cell = at + 1;
                }
                b'\r' | b'\n' if !is_quoted => return true,
                b'\n' => self.next.1 += 1,
                _ => {}
            }
            false
        });
        let end = match end {
            Some(end) => end,
            None if is_quoted => return Err(self.error_at(cell, UNCLOSED)),
            None if bytes.len() - start > limits::ROW => return Err(self.error_at(start, TOO_LONG)),
            None => bytes.len(),
        };
        self.cells.extend((end > start).then_some(cell..end));
        let rest = &self.bytes[end..];
        let line_end = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.next = (end + line_end, self.next.1 + 1);
        Ok(self.next.0 > start)
    }

    /// Reads on until the longest possible row and its line end are there.
    fn fill(&mut self) -> Result<(), FileError> {
        if self.is_ended || self.bytes.len() - self.next.0 > limits::ROW + 1 {
            return Ok(());
        }
        self.bytes.drain(..self.next.0);
        self.next.0 = 0;
        let read = self.source.by_ref().take(BLOCK).read_to_end(&mut self.bytes);
        let read = read.map_err(|error| FileError::unreadable(self.file, &error))?;
        self.is_ended = (read as u64) < BLOCK;
        match self.source.limit() {
            0 => Err(limits::too_large(self.file, limits::TABLE)),
            _ => Ok(()),
        }
    }

    /// Returns the known column that a cell of the header names.
    fn column_of(&self, cell: &[u8]) -> Option<usize> {
        self.names.iter().position(|name| name.as_bytes().eq_ignore_ascii_case(plain(cell)))
    }

    /// Returns the error message for a first line that has none of the column names; `None` if it has one.
    /// The message does not quote the line, because a scene may refer to any file as its table.
    fn no_header(&self) -> Option<String> {
        let line = &self.bytes[self.row.0..self.cells.last()?.end];
        let is_known = |part: &[u8]| self.column_of(part).is_some();
        let has_known = |separator| line.split(|b| [separator, b','].contains(b)).any(is_known);
        if has_known(b',') {
            return None;
        }
        let unknown = || {
            format!("the first line must be a header with columns out of {}", self.names.join(","))
        };
        Some(other_separator(has_known).unwrap_or_else(unknown))
    }

    /// Creates an error located at a byte of `bytes` in the row.
    fn error_at(&self, byte: usize, problem: impl Into<String>) -> FileError {
        let mut location = Location::of_byte(&self.bytes[self.row.0..], byte - self.row.0);
        location.line += self.row.1;
        FileError::at(self.file, location, problem)
    }

    /// Appends items to a list that grows with the table.
    fn append<T: Copy>(&self, list: &mut Vec<T>, items: &[T]) -> Result<(), FileError> {
        list.try_reserve(items.len()).map_err(|_| {
            let bytes = size_of_val(list.as_slice()) as u64;
            let problem = limits::too_little_memory("the table up to this row", bytes);
            self.error_at(self.row.0, problem)
        })?;
        list.extend_from_slice(items);
        Ok(())
    }

    /// Returns true if the file has this known column.
    pub(crate) fn has(&self, column: usize) -> bool {
        self.fields[column].is_some()
    }

    /// Returns the row's cell of a known column without surrounding spaces; it is empty if the file has no
    /// such column.
    pub(crate) fn cell(&self, column: usize) -> &[u8] {
        let cell = self.fields[column].map(|field| self.cells[field].clone());
        plain(cell.map_or(&[], |cell| &self.bytes[cell]))
    }

    /// Returns the text in a cell; it is empty if it is not UTF-8.
    pub(crate) fn text(&self, column: usize) -> &str {
        std::str::from_utf8(self.cell(column)).unwrap_or_default()
    }

    /// Returns the number in a column, which must be finite.
    pub(crate) fn number(&self, column: usize) -> Result<f64, FileError> {
        let text = self.text(column);
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

    /// Creates an error such as `column r is "-1": it must be greater than 0`, located at the cell,
    /// where `right` is the part after the colon.
    pub(crate) fn error(&self, column: usize, right: &str) -> FileError {
        let start = self.fields[column].map_or(self.row.0, |field| self.cells[field].start);
        let value = one_line(&String::from_utf8_lossy(self.cell(column)));
        self.error_at(start, format!("column {} is {value:?}: {right}", self.names[column]))
    }
}

/// Returns the error message for a first line that has other separators than commas, if `has` is true of one.
pub(crate) fn other_separator(has: impl Fn(u8) -> bool) -> Option<String> {
    let names = [(b';', "semicolons"), (b'\t', "tabs")];
    let (_, name) = names.into_iter().find(|(separator, _)| has(*separator))?;
    let right = "commas must stand between cells, and a point in a number";
    Some(format!("the first line has {name}: {right}"))
}

/// Returns a cell without surrounding spaces and quotes.
fn plain(cell: &[u8]) -> &[u8] {
    let cell = cell.trim_ascii();
    let inside = cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\""));
    inside.map_or(cell, <[u8]>::trim_ascii)
}

fn unknown_column(name: &str, names: &[&'static str]) -> String {
    let name = &*one_line(name);
    let hint = match nearest(name, names.iter().copied()).first() {
        Some(near) => format!("did you mean {near}?"),
        None => format!("the first line must name columns out of {}", names.join(",")),
    };
    format!("column {name:?} is unknown: {hint}")
}
