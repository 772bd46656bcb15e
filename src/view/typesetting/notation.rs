//! Formulas within a line of text: scalars in mathematical italics, vectors in mathematical bold,
//! coordinates as subscripts.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Response, Ui};

use crate::model::letters;

/// The letters that denote vectors when they stand alone.
const VECTORS: &str = "pdn";

/// Lays out `text`: each letter that stands alone becomes a mathematical one, and `_x` after it
/// becomes its subscript. Words stay as they are.
pub(crate) fn formula(text: &str, size: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let full = TextFormat { font_id: FontId::proportional(size), color, ..TextFormat::default() };
    let small = FontId::proportional(0.72 * size);
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

/// Adds text with typeset formulas as a label; screen readers and tests get it as plain text.
pub(crate) fn label(ui: &mut Ui, text: &str, size: f32, color: Color32) -> Response {
    let response = ui.label(formula(text, size, color));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(plain(text)));
    response
}

/// Returns the text for screen readers: without subscript marks.
pub(crate) fn plain(text: &str) -> String {
    text.replace('_', "")
}

/// Returns a letter of the mathematical alphabets; a vector's coordinate is a scalar.
fn letter(c: char, is_coordinate: bool) -> char {
    if VECTORS.contains(c) && !is_coordinate { letters::bold(c) } else { letters::italic(c) }
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
        assert_eq!(plain("p_x + t d_x"), "px + t dx");
    }
}
