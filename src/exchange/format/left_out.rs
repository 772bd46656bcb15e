//! Elements of a text that an import leaves out, counted by kind.

use crate::FileError;
use crate::error::is_hidden;

/// Kinds of elements that are left out, with how often, in the order of the text.
#[derive(Debug, Default)]
pub(crate) struct LeftOut {
    counts: Vec<(String, usize)>,
    /// Number of elements of kinds beyond the most that are told.
    others: usize,
}

/// Maximum number of kinds that are told by name.
const MOST_KINDS: usize = 20;

impl LeftOut {
    /// Counts one more of this kind, which is `said`, as "left out: Pinhole has spheres and planes".
    pub(crate) fn add(&mut self, kind: &str, said: &str) {
        let kind: String = kind.chars().filter(|c| !is_hidden(*c)).take(40).collect();
        let note = format!("{kind} {said}");
        if let Some((_, count)) = self.counts.iter_mut().find(|(told, _)| *told == note) {
            *count += 1;
        } else if self.counts.len() == MOST_KINDS {
            self.others += 1;
        } else {
            self.counts.push((note, 1));
        }
    }

    /// A note for each kind, as "3 of obj left out: Pinhole has spheres and planes".
    pub(crate) fn tell(&self, notes: &mut Vec<String>) {
        notes.extend(self.counts.iter().map(|(note, count)| format!("{count} of {note}")));
        if self.others > 0 {
            notes.push(format!("{} of other kinds left out", self.others));
        }
    }
}

/// Keeps the objects that could be read; of the others a note says how many there are, and
/// what is wrong with the first: no object spoils the camera. After so many faults that the text is of
/// another kind, it is read no further: each one's line takes a pass over the text.
pub(crate) fn readable<T>(
    objects: impl IntoIterator<Item = Result<T, FileError>>,
    what: &str,
    notes: &mut Vec<String>,
) -> Vec<T> {
    const ENOUGH: usize = 100;
    let (mut read, mut faults) = (Vec::new(), Vec::new());
    for object in objects {
        match object {
            Ok(object) => read.push(object),
            Err(fault) => faults.push(fault),
        }
        if faults.len() == ENOUGH {
            notes.push(format!("what follows the first {ENOUGH} of {what} left out is not read"));
            break;
        }
    }
    if let Some(first) = faults.first() {
        let line = first.location.map(|location| format!("line {}: ", location.line));
        let line = line.unwrap_or_default();
        notes.push(format!("{} of {what} left out: {line}{}", faults.len(), first.problem));
    }
    read
}
