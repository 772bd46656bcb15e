//! The drawing of the lab of lines: the plane with both lines in it, and the substitution of one
//! into the other.

pub(crate) mod drawing;
pub(crate) mod steps;

use egui::{Rect, RichText, Ui, UiBuilder, Vec2, pos2};
use pinhole_lecture::lines::{LineError, Substitution};
use pinhole_lecture::numbers::written as number;

use self::steps::{steps, verdict};
use crate::model::letters::typeset_message;
use crate::model::lines::LinesLab;
use crate::view::typesetting::notation;
use crate::view::typesetting::theme::error_color;

/// Text size in points, legible from the back row.
pub(crate) const TEXT: f32 = 16.5;

/// Greatest width of the numbers beside the drawing, in points, and as a share of the whole.
const NUMBERS: (f32, f32) = (400.0, 0.46);

/// Writes a line of text, with its formulas typeset.
pub(crate) fn text(ui: &mut Ui, text: &str) {
    notation::label(ui, text, TEXT + 1.0, ui.visuals().text_color());
}

/// Draws the lab without handles to drag and without a background: the plane with both lines in it,
/// and the substitution.
pub(crate) fn draw(ui: &mut Ui, area: Rect, lab: &LinesLab, digits: usize) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let (left, right) = parts(area);
    drawing::draw(ui, left, lab, digits);
    let right = right.shrink2(Vec2::new(2.0, 14.0));
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| substitution(ui, lab, digits));
}

/// Returns the areas of the plane and of the numbers beside it.
pub(crate) fn parts(area: Rect) -> (Rect, Rect) {
    let middle = area.right() - NUMBERS.0.min(NUMBERS.1 * area.width());
    let left = Rect::from_min_max(area.min, pos2(middle - 10.0, area.bottom()));
    (left, Rect::from_min_max(pos2(middle, area.top()), area.max))
}

pub(crate) fn substitution(ui: &mut Ui, lab: &LinesLab, digits: usize) {
    let substitution = match Substitution::new(lab.line(), lab.ray) {
        Ok(substitution) => substitution,
        Err(error) => return no_line(ui, &error),
    };
    for step in steps(&substitution, digits) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.weak(format!("{}:  ", step.what));
            text(ui, &step.text);
        });
    }
    ui.add_space(6.0);
    let verdict = verdict(&substitution, digits);
    notation::label(ui, &verdict, TEXT + 3.0, ui.visuals().strong_text_color());
    ui.add_space(4.0);
    let (f, sign) = substitution.f(lab.t);
    let compared = match sign {
        std::cmp::Ordering::Less => "< 0",
        std::cmp::Ordering::Equal => ": on the line",
        std::cmp::Ordering::Greater => "> 0",
    };
    let (t, f) = (number(lab.t, digits), number(f, digits));
    text(ui, &format!("at t = {t}:  f = {f} {compared}"));
}

fn no_line(ui: &mut Ui, error: &LineError) {
    let text = RichText::new(typeset_message(error)).size(TEXT + 2.0).strong();
    ui.label(text.color(error_color(ui)));
}
