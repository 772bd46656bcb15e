//! The checks of the wrong camera: those that catch the mistake, and those that miss it.

use egui::{Label, RichText, Ui};
use pinhole_lecture::mistakes::{Checked, ComparedCamera, Value, Wanted};

use super::{TEXT, cell, text_width};
use crate::model::readings::NumberStyle;
use crate::ui::widgets::Spoken as _;
use crate::ui::widgets::sign;
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
            row(ui, here, right, style);
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

/// Shows the verdict, then the formula, then its value, and the right one if it differs: below them
/// where they have no room beside them.
fn row(ui: &mut Ui, here: &Checked, right: &Checked, style: NumberStyle) {
    let value = text_of(here.value, style);
    let right = format!("right: {}", wanted(here, right, style));
    let mut fits = true;
    ui.horizontal_top(|ui| {
        verdict_and_formula(ui, here, &value);
        fits = text_width(ui, &value).max(text_width(ui, &right)) <= ui.available_width();
        if here.passes {
            let value = RichText::new(&value).size(TEXT);
            cell(ui, ui.available_width(), |ui| ui.label(value));
        } else if fits {
            both(ui, &value, &right);
        }
    });
    if !here.passes && !fits {
        ui.horizontal_top(|ui| {
            cell(ui, VERDICT, |_| ());
            both(ui, &value, &right);
        });
    }
}

fn verdict_and_formula(ui: &mut Ui, here: &Checked, value: &str) {
    let said = if here.passes { "passes" } else { "catches it" };
    let verdict = RichText::new(said).size(TEXT);
    let verdict =
        if here.passes { verdict.weak() } else { verdict.strong().color(error_color(ui)) };
    sign(ui, here.passes);
    let spoken = format!("{}: {value} {said}", here.check.formula());
    cell(ui, VERDICT, |ui| ui.label(verdict)).spoken(spoken);
    cell(ui, FORMULA, |ui| ui.label(here.check.formula())).on_hover_text(here.check.meaning());
}

/// Shows the wrong value and the right one, in two lines where there is no room for one.
fn both(ui: &mut Ui, value: &str, right: &str) {
    cell(ui, ui.available_width(), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.horizontal_wrapped(|ui| {
            let value = RichText::new(value).size(TEXT).strong().color(error_color(ui));
            ui.label(value);
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
