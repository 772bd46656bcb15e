//! `.pdb`: a record a line, its fields in fixed columns. Of the Protein Data Bank's format, version
//! 3.3 (2012), this reads the atoms: `ATOM` and `HETATM`, up to the end of the first `MODEL`, and
//! the title for the note.
//!
//! ```text
//! columns  1-6   record         13-16  atom's name    17  alternate location
//!         18-20  residue        22     chain          23-27  its number, with a letter inserted
//!         31-38  x              39-46  y              47-54  z, all in ångström
//!         77-78  element
//! ```

use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use std::path::Path;

use pinhole_core::DVec3;

use super::atoms::{Atom, Molecule, coordinate};
use super::elements::{self, Element};
use crate::formats::{FileError, Place};

/// A record, and where it stands.
struct Record<'a> {
    path: &'a Path,
    line: usize,
    text: &'a str,
}

/// Reads the first model.
pub(super) fn read(text: &str, path: &Path) -> Result<Molecule, FileError> {
    let (mut title, mut compound) = (String::new(), String::new());
    let (mut atoms, mut known) = (Vec::new(), BTreeSet::new());
    let (mut models, mut alternates, mut ended) = (0, 0, false);
    for (line, text) in text.lines().enumerate() {
        let record = Record { path, line, text };
        match record.field(1..=6).trim_end() {
            "TITLE" => title += &format!(" {}", record.field(11..=80)),
            "COMPND" if !text.contains("MOL_ID:") => {
                compound += &format!(" {}", record.field(11..=80))
            }
            "MODEL" => models += 1,
            "ENDMDL" => ended = true,
            "ATOM" | "HETATM" if !ended => match record.is_alternate(&mut known) {
                true => alternates += 1,
                false => atoms.push(record.atom()?),
            },
            _ => {}
        }
    }
    let title = if title.trim().is_empty() { compound } else { title };
    Ok(Molecule { title, atoms, left_out: left_out(models, alternates) })
}

fn left_out(models: usize, alternates: usize) -> Option<String> {
    let models = (models > 1).then(|| format!("The file has {models} models: this is the first."));
    let alternates = (alternates > 0).then(|| {
        let plural = if alternates == 1 { "" } else { "s" };
        format!("Of atoms with alternate locations, the first is shown; {alternates} other{plural} left out.")
    });
    let said: Vec<String> = [models, alternates].into_iter().flatten().collect();
    (!said.is_empty()).then(|| said.join(" "))
}

impl<'a> Record<'a> {
    /// The text in these columns, counted from 1; as much of it as there is.
    fn field(&self, columns: RangeInclusive<usize>) -> &'a str {
        let byte = |column: usize| {
            self.text.char_indices().nth(column).map_or(self.text.len(), |(byte, _)| byte)
        };
        let (from, to) = (byte(columns.start() - 1), byte(*columns.end()));
        &self.text[from..to]
    }

    /// Whether the atom is another location of one that is known already.
    fn is_alternate(&self, known: &mut BTreeSet<(&'a str, &'a str)>) -> bool {
        let has_others = !self.field(17..=17).trim().is_empty();
        has_others && !known.insert((self.field(13..=16), self.field(18..=27)))
    }

    fn atom(&self) -> Result<Atom, FileError> {
        let element = self.element()?;
        let axis = |axis: &str, columns: RangeInclusive<usize>| {
            let (first, last) = (*columns.start(), *columns.end());
            let text = self.field(columns).trim();
            coordinate(text).map_err(|right| {
                self.error(first, &format!("{axis} in columns {first}-{last} is {text:?}: {right}"))
            })
        };
        let center = DVec3::new(axis("x", 31..=38)?, axis("y", 39..=46)?, axis("z", 47..=54)?);
        Ok(Atom { name: self.name(), element, center })
    }

    /// `CA ALA A12`: atom, residue, chain and the residue's number, as far as they are there.
    fn name(&self) -> String {
        let residue = self.field(18..=20).trim();
        let number = format!("{}{}", self.field(22..=22).trim(), self.field(23..=27).trim());
        let parts = [self.field(13..=16).trim(), residue, &number];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
    }

    fn element(&self) -> Result<&'static Element, FileError> {
        let right = "it must be a symbol such as C or CL";
        match self.field(77..=78).trim() {
            "" => of_name(self.field(13..=16)).ok_or_else(|| {
                let name = self.field(13..=16);
                self.error(13, &format!("the atom's name in columns 13-16 is {name:?}, which begins with no element, and columns 77-78 name none: {right}"))
            }),
            symbol => elements::of_label(symbol).ok_or_else(|| {
                self.error(77, &format!("the element in columns 77-78 is {symbol:?}: {right}"))
            }),
        }
    }

    fn error(&self, column: usize, problem: &str) -> FileError {
        let place = Place { line: self.line + 1, column };
        FileError { place: Some(place), ..FileError::of_file(self.path, problem) }
    }
}

/// The element that an atom's name begins with. The symbol ends in the name's second column: ` CA `
/// is a carbon, `CA  ` is calcium. A hydrogen's name of four letters begins in the first one.
fn of_name(name: &str) -> Option<&'static Element> {
    let mut chars = name.chars();
    let (first, second) = (chars.next()?, chars.next().unwrap_or(' '));
    if first == ' ' || first.is_ascii_digit() {
        return elements::of_symbol(&second.to_string());
    }
    if first == 'H' && !name.ends_with(' ') {
        return elements::of_symbol("H");
    }
    elements::of_symbol(&format!("{first}{second}"))
        .or_else(|| elements::of_symbol(&first.to_string()))
}
