//! The checks of the wrong camera: those that catch the mistake, and those that miss it.

use egui::{Label, RichText, Ui};
use pinhole_lecture::mistakes::{Checked, ComparedCamera, Value, Wanted};

use super::{TEXT, cell};
use crate::ui::scene::readouts::NumberStyle;
use crate::ui::widgets::sign::sign;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::typesetting::theme::error_color;

/// Widths of the verdict and of the formula, in points.
const VERDICT: f32 = 76.0;
const FORMULA: f32 = 192.0;

/// Shows the checks as a table, those that catch the mistake first.
pub(super) fn ui(ui: &mut Ui, wrong: &ComparedCamera, style: NumberStyle) {
    if wrong.checks.is_empty() {
        ui.label("Without a wrong camera there is nothing to check.");
        return;
    }
    ui.strong(summary(wrong));
    ui.add_space(3.0);
    let rows = || wrong.checks.iter().zip(&wrong.right_checks);
    for passes in [false, true] {
        for (here, right) in rows().filter(|(here, _)| here.passes == passes) {
            ui.horizontal_top(|ui| row(ui, here, right, style));
        }
    }
}

/// Returns `2 of 14 checks catch it`.
pub(super) fn summary(wrong: &ComparedCamera) -> String {
    let (all, failing) = (wrong.checks.len(), failing(wrong).count());
    match failing {
        0 => format!("None of {all} checks catches it"),
        1 => format!("1 of {all} checks catches it"),
        _ => format!("{failing} of {all} checks catch it"),
    }
}

pub(super) fn failing(wrong: &ComparedCamera) -> impl Iterator<Item = &Checked> {
    wrong.checks.iter().filter(|checked| !checked.passes)
}

/// Shows the verdict, then the formula, then its value, which wraps if it is long.
fn row(ui: &mut Ui, here: &Checked, right: &Checked, style: NumberStyle) {
    let said = if here.passes { "passes" } else { "catches it" };
    let verdict = RichText::new(said).size(TEXT);
    let verdict =
        if here.passes { verdict.weak() } else { verdict.strong().color(error_color(ui)) };
    sign(ui, here.passes);
    let spoken = format!("{}: {} {said}", here.check.formula(), text_of(here.value, style));
    cell(ui, VERDICT, |ui| ui.label(verdict)).spoken(spoken);
    cell(ui, FORMULA, |ui| ui.label(here.check.formula())).on_hover_text(here.check.meaning());
    let value = RichText::new(text_of(here.value, style)).size(TEXT);
    cell(ui, ui.available_width(), |ui| {
        if here.passes {
            ui.label(value);
            return;
        }
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.horizontal_wrapped(|ui| {
            ui.label(value.strong().color(error_color(ui)));
            let right = format!("right: {}", wanted(here, right, style));
            ui.add(Label::new(right).extend());
        });
    });
}

fn wanted(here: &Checked, right: &Checked, style: NumberStyle) -> String {
    let value = text_of(right.value, style);
    match here.wanted {
        Wanted::Equal(_) => value,
        Wanted::Negative => format!("{value} < 0"),
        Wanted::Positive => format!("{value} > 0"),
        Wanted::LeftAndUp => value,
    }
}

fn text_of(value: Value, style: NumberStyle) -> String {
    match value {
        Value::Number(x) => style.number(x),
        Value::Uv(uv) => format!("({}, {})", style.number(uv.x), style.number(uv.y)),
    }
}
