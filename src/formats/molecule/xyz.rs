//! `.xyz`: the number of atoms, a line of comment, then a line an atom: its element, x, y, z in
//! ångström, and whatever a program adds. Several such frames may follow each other.
//!
//! Source: the format's description at Open Babel and its use in XMol, from where it comes; the
//! comment's `Properties=` is of the extended form of ASE and OVITO.

use std::path::Path;

use pinhole_core::DVec3;

use super::atoms::{Atom, Molecule, coordinate};
use super::elements::{self, Element};
use crate::formats::{FileError, Place};

/// The columns that this reads, as the extended form names them.
const COLUMNS: &str = "species:S:1:pos:R:3";

/// A text's lines, and what is wrong with one.
struct Lines<'a> {
    path: &'a Path,
    lines: Vec<&'a str>,
}

/// Reads the first frame.
pub(super) fn read(text: &str, path: &Path) -> Result<Molecule, FileError> {
    let text = Lines { path, lines: text.lines().collect() };
    let count = text.count(0)?;
    let title = text.lines.get(1).copied().unwrap_or_default();
    text.check_columns(title)?;
    let atoms = (0..count).map(|index| text.atom(index, count)).collect::<Result<_, _>>()?;
    let frames = text.frames(count)?;
    let left_out =
        (frames > 1).then(|| format!("The file has {frames} frames: this is the first."));
    Ok(Molecule { title: title.to_owned(), atoms, left_out })
}

impl<'a> Lines<'a> {
    /// How many atoms follow.
    fn count(&self, line: usize) -> Result<usize, FileError> {
        let text = self.lines.get(line).copied().unwrap_or_default();
        let right = "it must be the number of atoms, a whole number";
        text.trim().parse::<usize>().map_err(|_| {
            self.error(line, text, &format!("the number of atoms is {:?}: {right}", text.trim()))
        })
    }

    fn check_columns(&self, comment: &str) -> Result<(), FileError> {
        match comment.split_once("Properties=") {
            Some((_, columns)) if !columns.trim_start_matches('"').starts_with(COLUMNS) => {
                let columns = columns.split_whitespace().next().unwrap_or_default();
                let right = format!("the columns must begin with {COLUMNS}");
                Err(self.error(1, columns, &format!("Properties is {columns}: {right}")))
            }
            _ => Ok(()),
        }
    }

    fn atom(&self, index: usize, count: usize) -> Result<Atom, FileError> {
        let line = index + 2;
        let number = index + 1;
        let Some(text) = self.lines.get(line).filter(|text| !text.trim().is_empty()) else {
            let right = "there must be a line an atom: element, x, y, z";
            let problem = format!("atom {number} of {count} is missing: {right}");
            return Err(self.error(line.min(self.lines.len()), "", &problem));
        };
        let mut words = text.split_whitespace();
        let symbol = words.next().unwrap_or_default();
        let Some(element) = element(symbol) else {
            let right = "it must be a symbol such as C or Cl, or an atomic number";
            return Err(self.error(
                line,
                symbol,
                &format!("atom {number}'s element is {symbol:?}: {right}"),
            ));
        };
        let mut next = |axis: &str| match words.next() {
            None => Err(self.error(
                line,
                "",
                &format!("atom {number} has no {axis}: a line must be element, x, y, z"),
            )),
            Some(word) => coordinate(word).map_err(|right| {
                self.error(line, word, &format!("atom {number}'s {axis} is {word:?}: {right}"))
            }),
        };
        let center = DVec3::new(next("x")?, next("y")?, next("z")?);
        Ok(Atom { name: format!("{}{number}", element.symbol), element, center })
    }

    /// How many frames there are; after the last there may be blank lines.
    fn frames(&self, first: usize) -> Result<usize, FileError> {
        let (mut frames, mut line) = (1, first.saturating_add(2));
        while self.lines.get(line..).is_some_and(|rest| rest.iter().any(|l| !l.trim().is_empty())) {
            let text = self.lines[line];
            let count = self.count(line).map_err(|_| {
                let right = format!(
                    "after atom {first}, the last one by the first line, the file must end, or \
                     another frame begin with its number of atoms"
                );
                self.error(line, text, &format!("{:?} follows the last atom: {right}", text.trim()))
            })?;
            (frames, line) = (frames + 1, line.saturating_add(2).saturating_add(count));
        }
        Ok(frames)
    }

    /// `word` is a part of the line; empty for its end.
    fn error(&self, line: usize, word: &str, problem: &str) -> FileError {
        let text = self.lines.get(line).copied().unwrap_or_default();
        // Where the word itself is: another one may be the same.
        let byte = match word {
            "" => text.len(),
            word => (word.as_ptr() as usize).wrapping_sub(text.as_ptr() as usize),
        };
        let byte = if text.is_char_boundary(byte) { byte } else { 0 };
        let place = Place { line: line + 1, column: text[..byte].chars().count() + 1 };
        FileError { place: Some(place), ..FileError::of_file(self.path, problem) }
    }
}

/// By symbol, by atomic number, or by a label such as `C12` or `C_3`.
fn element(text: &str) -> Option<&'static Element> {
    match text.parse() {
        Ok(number) => elements::of_number(number),
        Err(_) => elements::of_label(text),
    }
}
