//! CSV tables of numbers, read without an allocation per row.

use std::path::Path;

use crate::{FileError, Location, suggest};

/// A CSV file in memory, with its header understood.
pub(crate) struct CsvTable<'a> {
    file: &'a Path,
    bytes: &'a [u8],
    reader: csv::Reader<&'a [u8]>,
    /// For every known column, which field of a row it is.
    fields: Vec<Option<usize>>,
    names: &'static [&'static str],
    width: usize,
}

/// One row of a [`CsvTable`].
pub(crate) struct Row<'t, 'a> {
    table: &'t CsvTable<'a>,
    record: &'t csv::ByteRecord,
}

impl<'a> CsvTable<'a> {
    /// Reads the header: `required` columns, then optional ones, in any order, in capitals or small
    /// letters. `names` is both.
    pub(crate) fn new(
        file: &'a Path,
        bytes: &'a [u8],
        names: &'static [&'static str],
        required: usize,
    ) -> Result<CsvTable<'a>, FileError> {
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(bytes);
        let header = match reader.byte_headers() {
            Ok(header) => header.clone(),
            Err(error) => return Err(FileError::of_file(file, error.to_string())),
        };
        let mut table =
            CsvTable { file, bytes, reader, fields: vec![None; names.len()], names, width: 0 };
        table.width = header.len();
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
            let location = Location { line: 1, column: 1 };
            let problem = format!(
                "column {missing} is missing: the first line must name the columns {needed}"
            );
            return Err(table.error(Some(location), problem));
        }
        Ok(table)
    }

    /// Calls `each` with every row.
    pub(crate) fn for_each(
        mut self,
        mut each: impl FnMut(&Row) -> Result<(), FileError>,
    ) -> Result<(), FileError> {
        let mut record = csv::ByteRecord::new();
        loop {
            match self.reader.read_byte_record(&mut record) {
                Ok(true) => {}
                Ok(false) => return Ok(()),
                Err(error) => return Err(self.error(None, error.to_string())),
            }
            if record.len() != self.width {
                let problem = format!(
                    "the row has {} cells: it must have {}, as the first line has",
                    record.len(),
                    self.width
                );
                return Err(self.error(Some(self.location_of(&record, 0)), problem));
            }
            each(&Row { table: &self, record: &record })?;
        }
    }

    fn error(&self, location: Option<Location>, problem: String) -> FileError {
        FileError { file: self.file.display().to_string(), location, problem }
    }

    /// The position of a field: its row is searched again, which costs nothing where nothing is wrong.
    fn location_of(&self, record: &csv::ByteRecord, field: usize) -> Location {
        let start = record.position().map_or(0, |p| p.byte() as usize).min(self.bytes.len());
        // The reader's position is that of the empty lines before the row, if there are any.
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

/// A cell without the blanks around it, and without quotes that a blank before them has kept.
fn plain(cell: &[u8]) -> &[u8] {
    let cell = cell.trim_ascii();
    let inside = cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\""));
    inside.map_or(cell, <[u8]>::trim_ascii)
}

impl Row<'_, '_> {
    /// The cell of a known column, without the blanks around it; empty if the file has no such
    /// column.
    pub(crate) fn cell(&self, column: usize) -> &[u8] {
        let field = self.table.fields[column];
        plain(field.and_then(|field| self.record.get(field)).unwrap_or_default())
    }

    /// The finite number in a column.
    pub(crate) fn number(&self, column: usize) -> Result<f64, FileError> {
        let text = std::str::from_utf8(self.cell(column)).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(self.error(column, "it must be a finite number")),
            Err(_) => Err(self.error(column, "it must be a number")),
        }
    }

    /// The text in a column, `None` if it is empty.
    pub(crate) fn text(&self, column: usize) -> Result<Option<&str>, FileError> {
        match std::str::from_utf8(self.cell(column)) {
            Ok("") => Ok(None),
            Ok(text) => Ok(Some(text)),
            Err(_) => Err(self.error(column, "it must be UTF-8 text")),
        }
    }

    /// `column r is "-1": ` and what would be right.
    pub(crate) fn error(&self, column: usize, right: &str) -> FileError {
        let location = self.table.fields[column].map(|f| self.table.location_of(self.record, f));
        let value = String::from_utf8_lossy(self.cell(column));
        let problem = format!("column {} is {value:?}: {right}", self.table.names[column]);
        self.table.error(location, problem)
    }
}

fn unknown_column(name: &str, names: &[&'static str]) -> String {
    let hint = match suggest::nearest(name, names.iter().copied()).first() {
        Some(near) => format!("did you mean {near}?"),
        None => format!("the first line must name columns out of {}", names.join(",")),
    };
    format!("column {name:?} is unknown: {hint}")
}
