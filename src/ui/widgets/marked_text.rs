//! Sentences with the lecture's symbols: `**u**` is a vector, shown in bold and in its own colour; `*u*` is a
//! scalar, shown in italics.

use egui::text::LayoutJob;
use egui::{FontFamily, FontId, Label, TextFormat, Ui};

use super::ResponseExt as _;
use super::number::vector_color;
use crate::model::symbols;
use crate::view::typesetting::notation::unbroken;
use crate::view::typesetting::theme;

/// Shows the text, typeset and wrapped. Screen readers and tests receive it without the asterisks that mark
/// symbols.
pub(crate) fn label(ui: &mut Ui, text: &str, size: f32) {
    let job = laid_out(ui, text, size);
    ui.add(Label::new(job).wrap()).spoken(plain(text));
}

/// Returns the height of the text when it is wrapped to this width.
pub(crate) fn height_within(ui: &Ui, text: &str, size: f32, width: f32) -> f32 {
    let mut job = laid_out(ui, text, size);
    job.wrap.max_width = width;
    ui.painter().layout_job(job).size().y
}

fn laid_out(ui: &Ui, text: &str, size: f32) -> LayoutJob {
    let color = ui.visuals().strong_text_color();
    let mut job = LayoutJob::default();
    for (run, is_vector) in runs(&unbroken(text)) {
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

/// Returns the text without its marks.
pub(crate) fn plain(text: &str) -> String {
    text.replace('*', "")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_and_scalars_are_told_apart() {
        let text = "*u***u** + *v***v**";
        let run = |text: &str, is_vector| (text.to_owned(), is_vector);
        assert_eq!(
            runs(text),
            [run("𝑢", false), run("u", true), run(" + 𝑣", false), run("v", true)]
        );
        assert_eq!(plain(text), "uu + vv");
        assert_eq!(runs("*h*, *W* 1"), [run("ℎ, 𝑊 1", false)]);
    }
}
