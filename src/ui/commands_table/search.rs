//! Finding commands by a few of their letters.
//!
//! A few hundred short names need no index and no crate: each word that is typed has to be found in
//! a command's title, its letters in order, and the better it fits the farther up the command
//! stands. Pure.

use super::UiCommand;

/// The commands that fit what was typed, best first; all of them, in their order, where nothing was.
pub fn found<'a>(typed: &str, commands: impl Iterator<Item = &'a UiCommand>) -> Vec<&'a UiCommand> {
    if typed.trim().is_empty() {
        return commands.collect();
    }
    let scored = commands.filter_map(|command| Some((score(typed, &command.title())?, command)));
    let mut scored: Vec<(u32, &UiCommand)> = scored.collect();
    // Stable: equally good ones stay in the table's order.
    scored.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
    scored.into_iter().map(|(_, command)| command).collect()
}

/// Score of a title for what was typed: more is better, `None` where a word does not fit at all.
/// Case does not count.
pub fn score(typed: &str, title: &str) -> Option<u32> {
    let title: Vec<char> = title.to_lowercase().chars().collect();
    let typed = typed.to_lowercase();
    // Of two that fit alike, the shorter one is fitted better.
    let brevity = 60_u32.saturating_sub(title.len() as u32);
    typed
        .split_whitespace()
        .map(|word| of_word(word, &title))
        .try_fold(brevity, |sum, word| Some(sum + 64 * word?))
}

/// One word's letters in a title, in order; the best of all ways to begin.
fn of_word(word: &str, title: &[char]) -> Option<u32> {
    let letters: Vec<char> = word.chars().collect();
    (0..title.len()).filter_map(|start| from(&letters, title, start)).max()
}

/// The letters' score with the first one at `start` and each other one as early as it can be: three
/// for a letter beside the one before, two for one that begins a word, one for any other.
fn from(letters: &[char], title: &[char], start: usize) -> Option<u32> {
    let begins_word = |at: usize| at == 0 || !title[at - 1].is_alphanumeric();
    let mut sum = 0;
    let mut last: Option<usize> = None;
    for letter in letters {
        let at = match last {
            None => (title[start] == *letter).then_some(start)?,
            Some(last) => {
                let rest = || (last + 1..title.len()).filter(|at| title[*at] == *letter);
                let beside = rest().next().filter(|at| *at == last + 1);
                beside.or_else(|| rest().find(|at| begins_word(*at))).or_else(|| rest().next())?
            }
        };
        let is_beside = last.is_some_and(|last| at == last + 1);
        sum += if is_beside { 3 } else { 1 } + u32::from(begins_word(at));
        last = Some(at);
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_in_order_fit_and_others_do_not() {
        assert!(score("lay der", "Layout: Derivation").is_some());
        assert!(score("derivation layout", "Layout: Derivation").is_some());
        assert!(score("ldrv", "Layout: Derivation").is_some());
        assert_eq!(score("derivatino", "Layout: Derivation"), None);
        assert!(score("", "Layout: Derivation").is_some());
    }

    #[test]
    fn what_fits_better_stands_first() {
        let better = |typed, first, second| {
            assert!(score(typed, first) > score(typed, second), "{typed}: {first}, {second}");
        };
        better("undo", "Edit: Undo", "Colours: light under no dome");
        better("cam", "Layout: Camera", "Colours: as the system");
        better("der", "Layout: Derivation", "Overlay: labels under eye, dashed");
        better("fa", "Views: Frame all", "Overlay: frustum");
    }
}
