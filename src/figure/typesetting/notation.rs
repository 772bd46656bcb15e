//! Formulas within text: scalars are set in mathematical italics, vectors in mathematical bold, and
//! coordinates as subscripts.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Response, Ui};

use crate::symbols;
use crate::typesetting::theme::WRITTEN;

/// The letters that denote vectors when they are not part of a word.
const VECTORS: &str = "pdn";

/// Lays out text that contains formulas. Each single letter becomes a mathematical letter, and `_x` after
/// it becomes its subscript. Words stay unchanged.
pub fn formula(text: &str, size: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let full = TextFormat { font_id: FontId::proportional(size), color, ..TextFormat::default() };
    let small = FontId::proportional((0.72 * size).max(WRITTEN.min(size)));
    let small = TextFormat { font_id: small, valign: Align::BOTTOM, ..full.clone() };
    let mut run = String::new();
    let chars: Vec<char> = text.chars().collect();
    let mut k = 0;
    while k < chars.len() {
        let is_letter = |k: usize| chars.get(k).is_some_and(char::is_ascii_alphabetic);
        if chars[k] == '_' && is_letter(k + 1) {
            job.append(&std::mem::take(&mut run), 0.0, full.clone());
            job.append(&chars[k + 1].to_string(), 0.0, small.clone());
            k += 2;
            continue;
        }
        let alone = is_letter(k) && !is_letter(k + 1) && !(k > 0 && is_letter(k - 1));
        let with_subscript = chars.get(k + 1) == Some(&'_');
        run.push(if alone { letter(chars[k], with_subscript) } else { chars[k] });
        k += 1;
    }
    job.append(&run, 0.0, full);
    job
}

/// Adds a label with typeset formulas. Screen readers and tests receive it as plain text.
pub fn label(ui: &mut Ui, text: &str, size: f32, color: Color32) -> Response {
    let response = ui.label(formula(&unbroken(text), size, color));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(without_marks(text)));
    response
}

/// Maximum length, in characters, of a formula that is never broken across lines.
const UNBROKEN: usize = 30;

/// Replaces the spaces inside formulas with no-break spaces: around operators, between coordinates, and
/// between factors. A long formula may still be broken before an operator.
pub fn unbroken(text: &str) -> String {
    const OPERATORS: [&str; 11] = ["=", "+", "−", "·", "×", "<", ">", "≤", "≥", "≈", "←"];
    let is_operator = |word: &str| OPERATORS.contains(&without_marks(word).as_str());
    let is_letter = |word: &str| {
        // A letter may have a subscript.
        let plain = without_marks(word.split_once('_').map_or(word, |(letter, _)| letter));
        plain.chars().count() == 1 && plain.starts_with(|c: char| c.is_alphabetic())
    };
    let is_factor = |word: &str| {
        let digits = word.trim_start_matches(['(', '−']);
        let is_number = !digits.ends_with('.') && digits.parse::<f64>().is_ok();
        is_number || word.starts_with('*') && without_marks(word).chars().count() == 1
    };
    let mut joined = String::new();
    let (mut length, mut before, mut is_in_tuple) = (0, "", false);
    let breaks = |c: char| c.is_whitespace() && c != '\u{a0}';
    for word in text.split(breaks).filter(|word| !word.is_empty()) {
        let word_length = without_marks(word).chars().count();
        let operates = is_operator(word) || is_operator(before);
        let ends_in_letter = is_letter(word.trim_end_matches(')'));
        let is_multiplied = word.starts_with('(') || word.starts_with("**") || ends_in_letter;
        let are_letters = (is_letter(before) || before.ends_with(')')) && ends_in_letter;
        let joins = operates || is_factor(before) && is_multiplied || are_letters;
        let has_room = length + 1 + word_length <= UNBROKEN || !is_operator(word);
        if is_in_tuple || joins && has_room && length > 0 {
            joined.push('\u{a0}');
            length += 1 + word_length;
        } else {
            if !joined.is_empty() {
                joined.push(' ');
            }
            length = word_length;
        }
        joined.push_str(word);
        is_in_tuple = (is_in_tuple || begins_tuple(word)) && !word.contains(')');
        before = word;
    }
    joined
}

/// Removes the marks of symbols and subscripts, for screen readers.
pub fn without_marks(text: &str) -> String {
    text.replace(['*', '_'], "")
}

/// Returns true if a word begins the coordinates of a vector, or the arguments of a function: if it consists of
/// at most one letter, an opening parenthesis, a number or a letter, and a comma.
fn begins_tuple(word: &str) -> bool {
    let (name, rest) = word.split_once('(').unwrap_or((word, ""));
    let first = rest.strip_suffix(',').filter(|_| without_marks(name).chars().count() < 2);
    first.is_some_and(|first| {
        let first = without_marks(first);
        first.chars().count() == 1 || first.starts_with(|c: char| c == '−' || c.is_ascii_digit())
    })
}

/// Returns the mathematical form of a letter: bold for the name of a vector, italic for a scalar or for a
/// vector's coordinate.
fn letter(c: char, is_coordinate: bool) -> char {
    if VECTORS.contains(c) && !is_coordinate { symbols::bold(c) } else { symbols::italic(c) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_alone_are_mathematical_and_words_are_not() {
        let text = |text| formula(text, 16.0, Color32::WHITE).text;
        assert_eq!(text("f(p + t d) at"), "𝑓(𝐩 + 𝑡 𝐝) at");
        assert_eq!(text("p_x = 2"), "𝑝x = 2");
        assert_eq!(text("h, D"), "ℎ, 𝐷");
        assert_eq!(without_marks("p_x + t d_x"), "px + t dx");
    }

    #[test]
    fn no_line_breaks_inside_a_short_formula() {
        let lines =
            |text: &str| unbroken(text).split(' ').map(without_marks).collect::<Vec<_>>().join("|");
        let formulas = |text: &str| lines(text).replace('\u{a0}', " ");
        assert_eq!(
            formulas("ahead, (0, 0, 0) + *t* (0, 0, −1)."),
            "ahead,|(0, 0, 0) + t (0, 0, −1)."
        );
        assert_eq!(
            formulas("to (1, 2,\n3) and (as said, here)"),
            "to|(1, 2, 3)|and|(as|said,|here)"
        );
        assert_eq!(formulas("the eye, **p** = (0, 0, 0), and"), "the|eye,|p = (0, 0, 0),|and");
        assert_eq!(
            formulas("*u* = 199.5/400 − 1/2 = −0.00125 = 2 − 3 and *v*"),
            "u = 199.5/400 − 1/2 = −0.00125|= 2 − 3|and|v"
        );
        assert_eq!(
            formulas("c = 24, D = b² − a c = −0.2 < 0: missed"),
            "c = 24,|D = b² − a c = −0.2 < 0:|missed"
        );
        assert_eq!(formulas("= 1 at *t*"), "= 1|at|t");
        assert_eq!(formulas("y = p_y + t d_y, (2·1 − 1·3) t"), "y = py + t dy,|(2·1 − 1·3) t");
        assert_eq!(formulas("notes print *w* ← normalize(*v*)"), "notes|print|w ← normalize(v)");
        assert_eq!(formulas("f(x, y) = 2 x + 3 (2 − t)"), "f(x, y) = 2 x + 3 (2 − t)");
        assert_eq!(formulas("so: f(p + t d) = (1 − 3 t)"), "so:|f(p + t d) = (1 − 3 t)");
        assert_eq!(formulas("a\u{a0}tie of\n2"), "a tie|of|2");
    }
}
