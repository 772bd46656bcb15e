//! Reads a student's answers, which are to be graded, from a file: a PNG picture, or a CSV file whose
//! header determines the kind of answers.
//!
//! ```text
//! basis   ux,uy,uz,vx,vy,vz,wx,wy,wz           one row
//! rays    row,column,ox,oy,oz,dx,dy,dz          a row a ray
//! hits    row,column and t, or x,y,z, or object, or several of them
//! ```
//!
//! In the row of a ray that hits nothing, the cells are empty or contain inf or nan, or the object is
//! -1. Case and spaces in the header are ignored.

use std::path::Path;

use pinhole_core::{BACKGROUND, DVec3, ImageSize, Pixel};
use pinhole_lecture::grading::{
    AnswerKind, Answers, GivenHit, HitAnswer, RayAnswer, Written, WrittenVector,
};

use crate::csv::{CsvTable, NO_DIRECTION, other_separator};
use crate::error::is_hidden;
use crate::images::png;
use crate::{FileError, Location, limits};

const BASIS: &[&str] = &["ux", "uy", "uz", "vx", "vy", "vz", "wx", "wy", "wz"];
const RAYS: &[&str] = &["row", "column", "ox", "oy", "oz", "dx", "dy", "dz"];
const HITS: &[&str] = &["row", "column", "t", "x", "y", "z", "object"];
const ROW: usize = 0;
const COLUMN: usize = 1;
const T: usize = 2;
const X: usize = 3;
const Z: usize = 5;
const OBJECT: usize = 6;

/// Returns those of the column names `asked` that the first line of a CSV file does not contain.
pub fn missing<'n>(bytes: &[u8], asked: &'n [String]) -> Vec<&'n str> {
    let names = header(bytes);
    asked
        .iter()
        .map(String::as_str)
        .filter(|name| !names.iter().any(|known| known == name))
        .collect()
}

/// Returns the kind of answers in a file, as detected from its first bytes; `None` if the file contains
/// no answers.
pub fn kind_of(bytes: &[u8]) -> Option<AnswerKind> {
    if png::is_png(bytes) {
        return Some(AnswerKind::Picture);
    }
    let names = header(bytes);
    let has = |known: &[&str]| names.iter().any(|name| known.contains(&name.as_str()));
    if has(BASIS) {
        Some(AnswerKind::Basis)
    } else if has(&RAYS[2..]) && has(&RAYS[..2]) {
        Some(AnswerKind::Rays)
    } else if has(&HITS[..2]) {
        Some(AnswerKind::Hits)
    } else {
        None
    }
}

/// Returns the maximum size in bytes of a file of answers about an image of this size. The longest row of answers
/// has some 200 bytes; beside the pixels of a picture stands what programs add to it.
pub fn largest(image: ImageSize) -> u64 {
    (512 * image.pixel_count() + (16 << 20)).min(limits::TABLE)
}

/// Bytes of memory that an answer in a table and a pixel of a picture take until they are graded: a fifth more than
/// was measured.
const ANSWER: u64 = 480;
const PIXEL: u64 = 80;

/// Bytes of the shortest row.
pub const SHORTEST_ROW: u64 = 4;

/// Returns how much memory in bytes it takes at most to grade a table with this many rows, or a picture, about an
/// image of this size; if the kind is not known yet, the larger of both.
pub fn memory(kind: Option<AnswerKind>, rows: u64, image: ImageSize) -> u64 {
    let pixels = image.pixel_count();
    let table = pixels / 8 + ANSWER * pixels.min(rows);
    match kind {
        None => table.max(PIXEL * pixels),
        Some(AnswerKind::Picture) => PIXEL * pixels,
        Some(_) => table,
    }
}

/// Returns true if a file that is dropped on the window should be treated as answers: it contains
/// answers, or is a table of something other than spheres.
pub fn are_meant(path: &Path, bytes: &[u8]) -> bool {
    let is_table = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    let is_of_spheres = || header(bytes).iter().any(|name| name == "r");
    kind_of(bytes).is_some() || is_table && !is_of_spheres()
}

/// Returns the column names in the first line that is not empty.
fn header(bytes: &[u8]) -> Vec<String> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let line = bytes.split(|byte| matches!(byte, b'\r' | b'\n')).find(|line| !line.is_empty());
    let line = line.unwrap_or_default();
    let line = String::from_utf8_lossy(&line[..line.len().min(limits::ROW)]);
    let name = |name: &str| name.trim().trim_matches('"').trim().to_ascii_lowercase();
    line.split(',').map(name).collect()
}

/// Reads the answers from a file's content. `path` is used in messages. `image` is the image size of
/// the scene to which the answers belong. `count_from`, 0 or 1, is the number of the first row and
/// column.
///
/// # Errors
/// Returns an error for the first invalid row, with line, column and value, or if the file contains no
/// answers, or more than there is memory to grade.
pub fn parse(
    path: &Path,
    bytes: &[u8],
    image: ImageSize,
    count_from: u32,
) -> Result<Answers, FileError> {
    let kind = kind_of(bytes).ok_or_else(|| no_answers(path, bytes))?;
    let rows = bytes.iter().filter(|byte| matches!(byte, b'\r' | b'\n')).count();
    let memory = memory(Some(kind), rows.min(limits::ROWS) as u64, image);
    limits::memory("grading it", memory).map_err(|problem| FileError::of_file(path, problem))?;
    let pixels = || AnsweredPixels::new(image, count_from);
    let answers = match kind {
        AnswerKind::Picture => {
            return png::decode(path, bytes, image, BACKGROUND).map(Answers::Picture);
        }
        AnswerKind::Basis => return basis(path, bytes),
        AnswerKind::Rays => rays(path, bytes, pixels())?,
        AnswerKind::Hits => hits(path, bytes, pixels())?,
    };
    if answers.is_empty() {
        return Err(FileError::of_file(path, "there is no answer: a row an answer must follow"));
    }
    Ok(answers)
}

fn no_answers(path: &Path, bytes: &[u8]) -> FileError {
    let names = header(bytes);
    let has = |separator| names.iter().any(|name| name.contains(char::from(separator)));
    if let Some(problem) = other_separator(has) {
        return FileError::at(path, Location::START, problem);
    }
    if bytes.trim_ascii().is_empty() {
        return FileError::of_file(
            path,
            "the file is empty: did the program that writes it end well?",
        );
    }
    let first: String = names.join(",").chars().filter(|c| !is_hidden(*c)).take(40).collect();
    let problem = format!(
        "the first line is {first:?}: it must name the columns {}, or {}, or row,column with t or x,y,z or object; or \
         the file must be a picture in PNG",
        BASIS.join(","),
        RAYS.join(",")
    );
    FileError::at(path, Location::START, problem)
}

fn basis(path: &Path, bytes: &[u8]) -> Result<Answers, FileError> {
    let mut vectors = None;
    CsvTable::new(path, bytes, BASIS, BASIS.len())?.for_each(|row| {
        if vectors.is_some() {
            return Err(row.error(0, "a camera has one basis: there must be one row"));
        }
        vectors = Some([vector(row, 0)?, vector(row, 3)?, vector(row, 6)?]);
        Ok(())
    })?;
    let none = || FileError::of_file(path, "there is no basis: a row of nine numbers must follow");
    vectors.map(Answers::Basis).ok_or_else(none)
}

fn rays(path: &Path, bytes: &[u8], mut pixels: AnsweredPixels) -> Result<Answers, FileError> {
    let mut rays = Vec::new();
    CsvTable::new(path, bytes, RAYS, RAYS.len())?.for_each(|row| {
        let pixel = pixels.read(row)?;
        let (origin, direction) = (vector(row, 2)?, relative(vector(row, 5)?));
        if direction.value == DVec3::ZERO {
            return Err(row.error(5, NO_DIRECTION));
        }
        rays.push(RayAnswer { pixel, origin, direction });
        Ok(())
    })?;
    pixels.finish()?;
    Ok(Answers::Rays(rays))
}

fn hits(path: &Path, bytes: &[u8], mut pixels: AnsweredPixels) -> Result<Answers, FileError> {
    let mut hits = Vec::new();
    let problem = |problem: &str| FileError::at(path, Location::START, problem);
    let table = CsvTable::new(path, bytes, HITS, 2)?;
    let columns = [ROW, COLUMN, T, X, X + 1, Z, OBJECT].map(|column| table.has(column));
    let has = |column: usize| columns[column];
    let coordinates = (X..=Z).filter(|column| has(*column)).count();
    if coordinates != 0 && coordinates != 3 {
        return Err(problem("a point needs all of the columns x,y,z"));
    }
    if coordinates == 0 && !has(T) && !has(OBJECT) {
        return Err(problem("nothing is answered: there must be a column t, or x,y,z, or object"));
    }
    table.for_each(|row| {
        let pixel = pixels.read(row)?;
        let answered: Vec<usize> = (T..=OBJECT).filter(|column| has(*column)).collect();
        let is_empty = |column: &usize| row.cell(*column).is_empty();
        let is_infinite = |column: &usize| stands_for_a_miss(row.text(*column));
        let is_none = has(OBJECT) && number_in(row, OBJECT) == Some(-1.0);
        if is_none || answered.iter().all(|column| is_empty(column) || is_infinite(column)) {
            hits.push(HitAnswer { pixel, hit: None });
            return Ok(());
        }
        if let Some(empty) = answered.iter().copied().find(|column| is_empty(column)) {
            return Err(row.error(
                empty,
                "a miss leaves all cells behind row and column empty, and a hit none",
            ));
        }
        if let Some(infinite) = answered.iter().copied().find(is_infinite) {
            let right = "it must be a finite number, as the row's other cells tell of a hit";
            return Err(row.error(infinite, right));
        }
        let mut hit = GivenHit::default();
        if has(T) {
            hit.t = Some(number(row, T).map_err(|_| row.error(T, NO_NUMBER))?);
        }
        if coordinates == 3 {
            hit.point = Some(vector(row, X)?);
        }
        if has(OBJECT) {
            hit.object = Some(whole(row, OBJECT)?);
        }
        hits.push(HitAnswer { pixel, hit: Some(hit) });
        Ok(())
    })?;
    pixels.finish()?;
    Ok(Answers::Hits(hits))
}

/// The rule for a cell in the row of a hit, for messages.
const NO_NUMBER: &str =
    "it must be a finite number; a miss leaves its cells empty, or has inf in them";

/// Returns true for the texts that programming languages print when nothing is hit: `inf`, `nan`, C's
/// `-nan(ind)`. A number that is too large for an `f64` is not accepted.
fn stands_for_a_miss(text: &str) -> bool {
    let text = text.to_ascii_lowercase();
    let word = text.trim_start_matches(['+', '-']);
    !text.starts_with("-inf") && ["inf", "infinity", "nan", "nan(ind)"].contains(&word)
}

/// Returns the number in a cell, which may be `inf`, `nan` or C's `-nan(ind)`; `None` if the cell
/// contains no number.
fn number_in(row: &CsvTable, column: usize) -> Option<f64> {
    row.text(column).trim_end_matches("(ind)").parse().ok()
}

/// Returns the integer in a cell, which may be in NumPy's notation: `12`, `1.2e+01`.
fn whole(row: &CsvTable, column: usize) -> Result<u32, FileError> {
    match number_in(row, column) {
        Some(number) if number >= 0.0 && number.fract() == 0.0 && number <= f64::from(u32::MAX) => {
            Ok(number as u32)
        }
        _ => Err(row.error(column, "it must be a whole number, 0 or more")),
    }
}

fn number(row: &CsvTable, column: usize) -> Result<Written<f64>, FileError> {
    let value = row.number(column)?;
    Ok(Written { value, rounding: rounding_of(row.text(column), value) })
}

fn vector(row: &CsvTable, first: usize) -> Result<WrittenVector, FileError> {
    let [x, y, z] = [number(row, first)?, number(row, first + 1)?, number(row, first + 2)?];
    let rounding = x.rounding.max(y.rounding).max(z.rounding);
    Ok(Written { value: DVec3::new(x.value, y.value, z.value), rounding })
}

/// Largest relative rounding error of a number with six digits: half a unit in the sixth digit of a
/// number that begins with 1.
const ROUNDING_SHARE: f64 = 0.5e-5;

/// Limits the rounding error of a vector to a fraction of its largest coordinate. Otherwise, a tiny
/// vector written with six decimals could have nearly any direction.
fn relative(vector: WrittenVector) -> WrittenVector {
    let most = ROUNDING_SHARE * vector.value.abs().max_element();
    Written { rounding: vector.rounding.min(most), ..vector }
}

/// Returns the maximum rounding error of a written number: half a unit in its last digit. A number with
/// fewer than six digits counts as one with six, because `%g` and C++ streams omit trailing zeros,
/// unless it was written with six decimals. The result is at most [`ROUNDING_SHARE`] of the number;
/// near 0, six decimals are enough.
fn rounding_of(text: &str, value: f64) -> f64 {
    const DIGITS: usize = 6;
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().unwrap_or(0)),
        None => (text, 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).skip_while(|d| *d == b'0').count();
    if digits >= DIGITS || decimals >= DIGITS {
        let half_unit = 0.5 * 10f64.powi(exponent.saturating_sub(decimals.min(400) as i32));
        let least = if exponent <= 0 { ROUNDING_SHARE } else { 0.0 };
        return half_unit.min(least.max(ROUNDING_SHARE * value.abs()));
    }
    match value.abs() {
        0.0 => 0.0,
        size => 0.5 * 10f64.powi(size.log10().floor() as i32 + 1 - DIGITS as i32),
    }
}

/// The pixels that have been answered so far. Each pixel must lie in the image and occur only once.
struct AnsweredPixels {
    image: ImageSize,
    count_from: u32,
    /// One bit for each pixel, including an extra row and column for pixels that are counted from 1.
    answered_bits: Vec<u64>,
    /// True once a row or column number 0 has been read.
    has_zero: bool,
    /// The error for the first answer with row H or column W, which is outside an image of H rows and W
    /// columns unless all rows and columns are counted from 1.
    beyond: Option<FileError>,
}

impl AnsweredPixels {
    fn new(image: ImageSize, count_from: u32) -> AnsweredPixels {
        let cells = (u64::from(image.width()) + 1) * (u64::from(image.height()) + 1);
        let answered_bits = vec![0; (cells / 64 + 1) as usize];
        AnsweredPixels { image, count_from, answered_bits, has_zero: false, beyond: None }
    }

    fn read(&mut self, row: &CsvTable) -> Result<Pixel, FileError> {
        let coordinate = |column: usize| {
            let value = whole(row, column)?;
            let below = || self.outside(row, column, None);
            value.checked_sub(self.count_from).ok_or_else(below)
        };
        let pixel = Pixel { row: coordinate(ROW)?, column: coordinate(COLUMN)? };
        let (width, height) = (self.image.width(), self.image.height());
        for (column, value, count) in [(ROW, pixel.row, height), (COLUMN, pixel.column, width)] {
            if value < count {
                continue;
            }
            let error = self.outside(row, column, Some(pixel));
            if value > count || self.count_from != 0 {
                return Err(error);
            }
            self.beyond.get_or_insert(error);
        }
        self.has_zero |= pixel.row == 0 || pixel.column == 0;
        let bit = u64::from(pixel.row) * (u64::from(width) + 1) + u64::from(pixel.column);
        let (word, bit) = ((bit / 64) as usize, 1 << (bit % 64));
        if self.answered_bits[word] & bit != 0 {
            let twice = "this row and column is answered above: once is enough";
            return Err(row.error(ROW, twice));
        }
        self.answered_bits[word] |= bit;
        Ok(pixel)
    }

    fn outside(&self, row: &CsvTable, column: usize, pixel: Option<Pixel>) -> FileError {
        let (what, count) = match column {
            ROW => ("rows", self.image.height()),
            _ => ("columns", self.image.width()),
        };
        let (first, last) = (self.count_from, count - 1 + self.count_from);
        let (w, h) = (self.image.width(), self.image.height());
        let mut right = format!("{what} are {first} to {last}, as the scene's image is {w} x {h}");
        let turned = pixel.map(|pixel| Pixel { row: pixel.column, column: pixel.row });
        if turned.is_some_and(|turned| self.image.contains(turned)) {
            right += "; are rows and columns exchanged?";
        } else if self.count_from == 1 {
            right += ", and they are said to count from 1";
        }
        row.error(column, &right)
    }

    /// Checks that rows and columns are not counted both from 0 and up to H or W.
    fn finish(self) -> Result<(), FileError> {
        match self.beyond {
            Some(error) if self.has_zero => Err(error),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::rounding_of;

    #[test]
    fn the_last_digit_is_half_a_unit_off_at_most() {
        let cases = [
            ("0.70710678118654757", 0.5e-17),
            ("0.707107", 0.5e-6),
            ("-1234.5678", 0.5e-4),
            ("7.07106781e-01", 0.5e-9),
            ("0.000000", 0.5e-6),
            ("0.25", 0.5e-6),
            ("4", 0.5e-5),
            ("1e+06", 5.0),
            ("0", 0.0),
            ("160000", 0.5),
            ("0.000000e300", 0.0),
            ("0.0000001e8", 0.5e-4),
            ("0.000000e-2", 0.5e-8),
        ];
        for (text, expected) in cases {
            let rounding = rounding_of(text, text.parse().expect("a number"));
            assert!((rounding - expected).abs() <= 1e-9 * expected, "{text}: {rounding}");
        }
    }
}
