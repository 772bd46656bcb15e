//! What is left out of a text, counted by kind.

use std::collections::HashMap;

/// Kinds of things that are left out, with how often, in the order of the text.
#[derive(Debug, Default)]
pub(super) struct LeftOut {
    counts: Vec<(String, usize)>,
    places: HashMap<String, usize>,
    /// Number of things of kinds beyond the most that are told.
    others: usize,
}

/// Maximum number of kinds that are told by name.
const MOST_KINDS: usize = 20;

impl LeftOut {
    /// Counts one more of this kind, which is `said`, as "left out: Pinhole has spheres and planes".
    pub(super) fn add(&mut self, kind: &str, said: &str) {
        let kind: String = kind.chars().filter(|c| !c.is_control()).take(40).collect();
        let note = format!("{kind} {said}");
        if let Some(place) = self.places.get(&note) {
            self.counts[*place].1 += 1;
        } else if self.counts.len() == MOST_KINDS {
            self.others += 1;
        } else {
            self.places.insert(note.clone(), self.counts.len());
            self.counts.push((note, 1));
        }
    }

    /// A note for each kind, as "3 of obj left out: Pinhole has spheres and planes".
    pub(super) fn tell(&self, notes: &mut Vec<String>) {
        notes.extend(self.counts.iter().map(|(note, count)| format!("{count} of {note}")));
        if self.others > 0 {
            notes.push(format!("{} of other kinds left out", self.others));
        }
    }
}
