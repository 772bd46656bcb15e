//! Searches commands by typed words. A few hundred short names need no index.

use std::cmp::Reverse;

use super::{Group, UiCommand};
use crate::model::lessons::LessonArgument;
use crate::ui::action::{Action, Leave};

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

/// Returns the commands that match every typed word, best first; before all others, the step whose number was
/// typed, such as 6.2, alone or last. If nothing was typed, returns all commands in their order.
pub fn found<'a>(typed: &str, commands: impl Iterator<Item = &'a UiCommand>) -> Vec<&'a UiCommand> {
    let asked = match LessonArgument::parse(typed.split_whitespace().last().unwrap_or_default()) {
        Ok(LessonArgument::Builtin(id)) => Some(Action::from(Leave::GoTo(id))),
        _ => None,
    };
    let typed = in_words(typed);
    let mut ranked: Vec<_> = commands
        .filter_map(|command| {
            let (title, about) = (in_words(&command.title()), in_words(&command.about));
            let fits = typed.split_whitespace().map(|word| fit(word, &title, &about));
            let worst = fits.min().unwrap_or(BEST);
            let is_step = command.group == Group::Step;
            let length = if is_step { 0 } else { title.len() };
            Some((Reverse(worst), is_step, length, command)).filter(|_| worst > 0)
        })
        .collect();
    if !typed.trim().is_empty() {
        // The sort is stable: equal matches keep the table's order.
        ranked.sort_by_key(|(worst, is_step, length, command)| {
            (asked.as_ref() != Some(&command.action), *worst, *is_step, *length)
        });
    }
    ranked.into_iter().map(|(.., command)| command).collect()
}

/// Returns the text in lower case, with a space before and after each word in place of signs.
fn in_words(text: &str) -> String {
    format!(
        " {} ",
        text.to_lowercase().replace("c++", "cpp").replace(|c: char| !c.is_alphanumeric(), " ")
    )
}

/// The quality of a typed word that is a word of the title.
const BEST: u8 = 4;

/// Returns how well a typed word, or its synonym, matches a command's title or description: [`BEST`], or 3 if
/// a word of the title begins with it, 2 if one of the description does, 1 if the title contains it, 0 if
/// none of this holds.
fn fit(word: &str, title: &str, about: &str) -> u8 {
    let is_in =
        |text: &str, before: &str, after: &str| text.contains(&format!("{before}{word}{after}"));
    let ways = [(title, " ", " "), (title, " ", ""), (about, " ", ""), (title, "", "")];
    let worse = ways.iter().take_while(|(text, before, after)| !is_in(text, before, after));
    let own = BEST - worse.count() as u8;
    let synonym = SYNONYMS.iter().find(|(typed, _)| *typed == word);
    own.max(synonym.map_or(0, |(_, other)| fit(other, title, about)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::commands_table::all;

    fn titles(typed: &str) -> Vec<String> {
        found(typed, all().iter()).into_iter().map(UiCommand::title).collect()
    }

    #[test]
    fn parts_of_words_fit_and_others_do_not() {
        for typed in ["lay der", "derivation layout", "rivat", "LAYOUT: DERIVATION"] {
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
            ("6.2", "Contents: Lesson 6: 45 degrees, by hand, 2. What a camera's basis must be"),
            ("contents 5.2", "Contents: Lesson 5: Orientation, 2. Turned by 45°"),
            ("contents", "Contents: Lesson 1: The canonical camera, 1. The camera in its world"),
            ("svg", "File: Export a figure…"),
            ("three.js", "File: Save the camera for another program…"),
            ("c++", "File: Save the camera for another program…"),
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
