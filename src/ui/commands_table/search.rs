//! Searches commands by typed words. A few hundred short names need no index.

use std::cmp::Reverse;

use super::{Group, UiCommand};

/// Words that users may type, and the words that commands use for them.
const SYNONYMS: [(&str, &str); 9] = [
    ("ball", "sphere"),
    ("color", "colour"),
    ("fullscreen", "present"),
    ("gimbal", "parallel"),
    ("quiz", "exercise"),
    ("screenshot", "export"),
    ("shade", "shading"),
    ("slides", "present"),
    ("wall", "plane"),
];

/// The quality of the match between a typed word and a command, from worst to best.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    /// The title contains the letters of the typed word in order.
    Scattered,
    /// A word of the title contains the typed word.
    Inside,
    /// A word of the description begins with the typed word.
    Described,
    /// A word of the title begins with the typed word.
    Begins,
    /// The typed word is a word of the title.
    Whole,
}

/// Returns the commands that match every typed word, best first: commands are compared by the word that fits
/// them worst. If nothing was typed, returns all commands in their order.
pub fn found<'a>(typed: &str, commands: impl Iterator<Item = &'a UiCommand>) -> Vec<&'a UiCommand> {
    let typed = typed.to_lowercase();
    let words: Vec<&str> = typed.split_whitespace().collect();
    if words.is_empty() {
        return commands.collect();
    }
    let ranked = commands.filter_map(|command| {
        let title = command.title().to_lowercase();
        let about = command.about.to_lowercase();
        let fits: Option<Vec<Fit>> = words.iter().map(|word| fit(word, &title, &about)).collect();
        let mut fits = fits?;
        fits.sort_unstable();
        let is_step = command.group == Group::Step;
        Some(((Reverse(fits), is_step, title.chars().count()), command))
    });
    let mut ranked: Vec<_> = ranked.collect();
    // The sort is stable: equal matches keep the table's order.
    ranked.sort_by(|(a, _), (b, _)| a.cmp(b));
    ranked.into_iter().map(|(_, command)| command).collect()
}

/// Returns how well a typed word matches a command's title or description; `None` if it matches neither. All
/// arguments must be in lower case.
fn fit(word: &str, title: &str, about: &str) -> Option<Fit> {
    let other = SYNONYMS.iter().find(|(typed, _)| *typed == word).map(|(_, word)| *word);
    let in_words = |word: &str| {
        let described = stands_in(word, about).filter(|fit| *fit >= Fit::Begins);
        stands_in(word, title).max(described.map(|_| Fit::Described))
    };
    in_words(word).max(other.and_then(in_words)).or_else(|| {
        let mut letters = title.chars();
        let is_there = word.chars().all(|letter| letters.any(|other| other == letter));
        is_there.then_some(Fit::Scattered)
    })
}

/// Returns how well a word fits the best place in a text; `None` if the text does not contain it.
fn stands_in(word: &str, text: &str) -> Option<Fit> {
    let matches = text.match_indices(word).map(|(at, _)| {
        let begins = !text[..at].ends_with(char::is_alphanumeric);
        let ends = !text[at + word.len()..].starts_with(char::is_alphanumeric);
        match (begins, ends) {
            (true, true) => Fit::Whole,
            (true, false) => Fit::Begins,
            (false, _) => Fit::Inside,
        }
    });
    matches.max()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::commands_table::all;

    fn titles(typed: &str) -> Vec<String> {
        found(typed, all().iter()).into_iter().map(UiCommand::title).collect()
    }

    #[test]
    fn letters_in_order_fit_and_others_do_not() {
        for typed in ["lay der", "derivation layout", "ldrv", "LAYOUT: DERIVATION"] {
            assert!(titles(typed).contains(&"Layout: Derivation".to_owned()), "{typed}");
        }
        assert!(!titles("derivatino").contains(&"Layout: Derivation".to_owned()));
        assert_eq!(titles(" ").len(), all().len());
    }

    #[test]
    fn what_fits_best_stands_first() {
        for (typed, first) in [
            ("undo", "Edit: Undo"),
            ("cam", "Layout: Camera view"),
            ("der", "Layout: Derivation"),
            ("add sphere", "Objects: + Sphere"),
            ("ball", "Objects: + Sphere"),
            ("add wall", "Objects: + Plane"),
            ("gimbal", "Scene: almost-parallel-up"),
        ] {
            assert_eq!(titles(typed).first().map(String::as_str), Some(first), "{typed}");
        }
    }

    #[test]
    fn each_synonym_finds_something() {
        for (typed, word) in SYNONYMS {
            assert!(!titles(typed).is_empty(), "{typed}");
            assert!(titles(word).iter().any(|title| titles(typed).contains(title)), "{typed}");
        }
    }
}
