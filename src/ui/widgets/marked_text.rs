//! Sentences with the lecture's symbols: `**u**` is a vector, shown in bold and in its own colour; `*u*` is a
//! scalar, shown in italics. The words view, up and at need no marks where they are vectors: in a formula, and
//! where the words around them say so.

use std::sync::Arc;

use egui::text::LayoutJob;
use egui::{FontFamily, FontId, Galley, Label, TextFormat, Ui};
use pinhole_figure::symbols;
use pinhole_figure::typesetting::notation::{unbroken, without_marks};
use pinhole_figure::typesetting::theme;

use super::ResponseExt as _;
use super::number::vector_color;
use crate::ui::commands_table::instruction;

/// Shows the text, typeset and wrapped. Screen readers and tests receive it without the asterisks that mark
/// symbols.
pub(crate) fn label(ui: &mut Ui, text: &str, size: f32) {
    let job = laid_out(ui, text, size);
    ui.add(Label::new(job).wrap()).spoken(without_marks(&instruction(ui.ctx(), text)));
}

/// Lays the text out, wrapped to this width.
pub(crate) fn galley(ui: &Ui, text: &str, size: f32, width: f32) -> Arc<Galley> {
    let mut job = laid_out(ui, text, size);
    job.wrap.max_width = width;
    ui.painter().layout_job(job)
}

/// Returns the height of the text when it is wrapped to this width.
pub(crate) fn height_within(ui: &Ui, text: &str, size: f32, width: f32) -> f32 {
    galley(ui, text, size, width).size().y
}

fn laid_out(ui: &Ui, text: &str, size: f32) -> LayoutJob {
    let color = ui.visuals().strong_text_color();
    let mut job = LayoutJob::default();
    let runs = runs(&unbroken(&instruction(ui.ctx(), text))).into_iter();
    for (run, is_vector) in runs.flat_map(|(run, is_vector)| with_named(&run, is_vector)) {
        let family = if is_vector { theme::bold() } else { FontFamily::Proportional };
        let own = vector_color(ui, &run).filter(|_| is_vector);
        let format = TextFormat {
            font_id: FontId::new(size, family),
            color: own.unwrap_or(color),
            // The two fonts have different line heights.
            line_height: Some(row_height(ui, size)),
            ..TextFormat::default()
        };
        job.append(&run, 0.0, format);
    }
    job
}

/// Returns the height of one line of such text.
pub(crate) fn row_height(ui: &Ui, size: f32) -> f32 {
    ui.ctx().fonts_mut(|fonts| fonts.row_height(&FontId::proportional(size))).ceil()
}

/// Splits the text into runs of letters with the same style; true marks a vector. Scalars become italic
/// letters.
fn runs(text: &str) -> Vec<(String, bool)> {
    let mut runs: Vec<(String, bool)> = Vec::new();
    let (mut is_vector, mut is_scalar) = (false, false);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter == '*' {
            // Inside a scalar, the first star of `***` ends it: u times the vector u is `*u***u**`.
            if !is_scalar && letters.next_if_eq(&'*').is_some() {
                is_vector = !is_vector;
            } else {
                is_scalar = !is_scalar;
            }
            continue;
        }
        let letter = if is_scalar { symbols::italic(letter) } else { letter };
        match runs.last_mut().filter(|run| run.1 == is_vector) {
            Some((run, _)) => run.push(letter),
            None => runs.push((letter.to_string(), is_vector)),
        }
    }
    runs
}

/// The vectors that the user gives, whose names are also ordinary words.
const GIVEN: [&str; 3] = ["view", "up", "at"];
/// The points of formulas, whose names are words elsewhere.
const POINTS: [&str; 4] = ["eye", "centre", "point", "hit"];

/// Splits a run at the names of vectors, as in `view = at − eye` and `perpendicular to up`.
fn with_named(run: &str, is_vector: bool) -> Vec<(String, bool)> {
    if is_vector {
        return vec![(run.to_owned(), true)];
    }
    let mut split: Vec<(String, bool)> = Vec::new();
    let mut start = 0;
    for word in run.split_inclusive(|letter: char| !letter.is_alphabetic()) {
        let name = word.trim_end_matches(|letter: char| !letter.is_alphabetic());
        let (before, after) = (&run[..start], &run[start + name.len()..]);
        let is_given = GIVEN.contains(&name);
        let is_name = (is_given || POINTS.contains(&name)) && is_in_formula(before, after)
            || is_given && is_noun(name, before, after);
        for (part, is_vector) in [(name, is_name), (&word[name.len()..], false)] {
            match split.last_mut().filter(|last| last.1 == is_vector) {
                Some((last, _)) => last.push_str(part),
                None if part.is_empty() => {}
                None => split.push((part.to_owned(), is_vector)),
            }
        }
        start += word.len();
    }
    split
}

/// Returns true if a word between these texts is next to an operator, or the argument of a function.
fn is_in_formula(before: &str, after: &str) -> bool {
    let is_operator = |letter: char| "=−×·|/←".contains(letter);
    let is_argument = before.strip_suffix('(').is_some_and(|f| f.ends_with(char::is_alphabetic));
    is_argument
        || before.trim_end().ends_with(is_operator)
        || after.trim_start().starts_with(is_operator)
}

/// The words after which the name of a given vector is not an ordinary word.
const BEFORE_NOUN: [&str; 14] = [
    "of", "to", "from", "along", "above", "and", "or", "not", "when", "which", "any", "closer",
    "eye,", "at,",
];

/// Returns true if a given vector's name between these texts is that vector. The words at and view are also a
/// preposition and a verb, which do not end a phrase.
fn is_noun(name: &str, before: &str, after: &str) -> bool {
    let last = before.split_whitespace().next_back().unwrap_or_default().to_lowercase();
    let is_after = before.ends_with(char::is_whitespace)
        && BEFORE_NOUN.contains(&last.as_str())
        && !["line of ", "field of ", "angle of "].into_iter().any(|other| before.ends_with(other));
    let ends_phrase = after.is_empty()
        || after.starts_with([',', '.', ';', ':', '?'])
        || [" and ", " or "].into_iter().any(|next| after.starts_with(next));
    is_after && (name == "up" || ends_phrase)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_given_vectors_are_vectors_in_formulas_and_as_nouns() {
        let vectors = |text: &str| -> Vec<String> {
            with_named(text, false).into_iter().filter(|run| run.1).map(|run| run.0).collect()
        };
        assert_eq!(vectors("view = at − eye = (−21, −4, −15)."), ["view", "at", "eye"]);
        assert_eq!(vectors("(hit − centre)/𝑟 at the eye"), ["hit", "centre"]);
        assert_eq!(vectors(" = −view / |view| = (0, 1, 0)"), ["view", "view"]);
        assert_eq!(vectors("normalize(up × "), ["up"]);
        assert_eq!(vectors(" ← normalize(view). The"), ["view"]);
        assert_eq!(vectors("perpendicular to up and to "), ["up"]);
        assert_eq!(
            vectors("the opposite of view, with length 1. Drag the tip of up."),
            ["view", "up"]
        );
        assert_eq!(
            vectors("the eye is straight above at, and up is parallel to view."),
            ["at", "up", "view"]
        );
        assert_eq!(vectors("Drag eye, at, up or the pixel"), ["at", "up"]);
        for text in [
            "Up is a hint at most; look at the view, points up in the picture",
            "and at which t? It looks at the point. The warm-up, off the line of view.",
            "points upwards",
        ] {
            assert_eq!(vectors(text), [""; 0], "{text}");
            assert_eq!(with_named(text, false), [(text.to_owned(), false)]);
        }
    }

    #[test]
    fn vectors_and_scalars_are_told_apart() {
        let text = "*u***u** + *v***v**";
        let run = |text: &str, is_vector| (text.to_owned(), is_vector);
        assert_eq!(
            runs(text),
            [run("𝑢", false), run("u", true), run(" + 𝑣", false), run("v", true)]
        );
        assert_eq!(without_marks(text), "uu + vv");
        assert_eq!(runs("*h*, *W* 1"), [run("ℎ, 𝑊 1", false)]);
    }
}
