//! The mistakes page: the picture of a camera that is computed with a typical mistake, next to the right
//! picture. Below the pictures are the gallery of mistakes, the explanation of the chosen one, and checks
//! (properties of every right camera), each of which catches or misses the mistake.

use egui::{
    Align, Color32, FontId, FontSelection, Label, Layout, Rect, RichText, ScrollArea, Ui,
    UiBuilder, pos2,
};
use pinhole_figure::readings::ReadingValue;
use pinhole_figure::typesetting::theme::{STACKED, error_color, text_size};
use pinhole_figure::{Concept, Formulas, NumberStyle};
use pinhole_lecture::mistakes::{Checked, ComparedCamera, Value, Wanted, WrongCamera};
use pinhole_lecture::numbers::percent;

use crate::features::mistakes::MistakesView;
use crate::features::mistakes::ui_gallery::CELL;
use crate::features::vote;
use crate::model::Session;
use crate::ui::PageContext;
use crate::ui::scene::view_rects::strip_above;
use crate::ui::widgets::{self, ResponseExt as _, Words, cell, combo, sign, vector_color};
use crate::view::derive::SecondPicture;

/// Size of the text, in points.
const TEXT: f32 = 15.0;

/// Minimum and maximum number of columns of the gallery beside the explanation, and maximum number in a menu.
const COLUMNS: [f32; 3] = [2.0, 5.0, 3.0];

/// Minimum width of the explanation beside the gallery, in points.
const EXPLANATION: f32 = 300.0;

/// Width of the button that opens the menu of mistakes, and minimum width of the window beside the menu's
/// thumbnails, in points.
const MENU: [f32; 2] = [200.0, 40.0];

/// Width of the table of checks, in points.
const CHECKS: f32 = 440.0;

/// Width of the page, in points, below which the checks go below the explanation.
const NARROW: f32 = 760.0;

/// Width of a vector's letter, in points.
const LETTER: f32 = 16.0;

/// Width of the letter, the signs and the gaps in a row with two vectors, in points.
const BESIDE_VECTORS: f32 = 110.0;

/// Shows the title above the wrong picture, and the choice between that picture and the map of the pixels
/// that differ.
pub(crate) fn strip(ui: &mut Ui, area: Rect, mistakes_view: &mut MistakesView) {
    strip_above(ui, area, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if mistakes_view.is_revealed() {
                let hint = "Dark where the pixel sees a different object";
                let wanted = &mut mistakes_view.wants_differences;
                ui.toggle_value(wanted, "Differences").on_hover_text(hint);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let full = title(mistakes_view);
                // If the full title does not fit, a short one is enough: the gallery shows the mistake's
                // name, too.
                let fits = text_width(ui, &full) <= ui.available_width();
                let short = full.split(':').next().unwrap_or_default();
                let title = RichText::new(if fits { &full } else { short }).strong();
                let title = ui.add(Label::new(title.color(error_color(ui))).truncate());
                title.on_hover_text(&full).spoken(&full);
            });
        });
    });
}

fn title(mistakes_view: &MistakesView) -> String {
    match mistakes_view.open_vote {
        None => {
            format!("{}: {}", SecondPicture::WrongCamera.name(), mistakes_view.chosen.name())
        }
        Some(_) => "Wrong picture".to_owned(),
    }
}

/// The titles of both pictures on a lesson's stage while the step's question is open.
pub(crate) const HEADINGS: [&str; 2] = ["Camera 1", "Camera 2"];

/// Shows the titles above the pictures of the right and the wrong camera on a lesson's stage. While the step's
/// question is open, they do not say which is right.
pub(crate) fn headings(ui: &mut Ui, areas: [Rect; 2], is_asking: bool) {
    let verdicts = [(": right", true), (": wrong", false)];
    for ((area, name), (verdict, is_right)) in areas.into_iter().zip(HEADINGS).zip(verdicts) {
        strip_above(ui, area, |ui| {
            if is_asking {
                ui.strong(name);
            } else {
                sign(ui, is_right);
                let title = RichText::new(format!("{name}{verdict}")).strong();
                ui.label(if is_right { title } else { title.color(error_color(ui)) });
            }
        });
    }
}

/// Returns the width of a text in a label.
fn text_width(ui: &Ui, text: &str) -> f32 {
    widgets::text_width(ui, text, FontSelection::Default.resolve(ui.style()))
}

/// Returns what is said about the wrong picture. While a question or a vote is open, it does not name the mistake.
pub(crate) fn words(
    wrong: &ComparedCamera,
    mistakes_view: &MistakesView,
    is_asking: bool,
) -> Words {
    let is_revealed = mistakes_view.is_revealed();
    let why_not = wrong.why_not.as_deref().map(|why| match is_revealed {
        true => why,
        false => "This mistake changes nothing with this camera: press Another one.",
    });
    let spoken = match (why_not, share_that_differs(wrong)) {
        (Some(why), _) => why.to_owned(),
        (None, Some(share)) if is_revealed && !is_asking => {
            format!("{}: {share}", wrong.mistake.name())
        }
        (None, share) => share.unwrap_or_default(),
    };
    (spoken, why_not.map(str::to_owned))
}

/// Returns a text such as `33 % of the picture differs`; `None` if there is no wrong picture.
fn share_that_differs(wrong: &ComparedCamera) -> Option<String> {
    let shares = wrong.compared?;
    Some(format!("{} of the picture differs", percent(shares.differing, shares.pixels)))
}

/// Shows the open vote or, if there is none, the gallery of mistakes.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let view = &mut context.session.shown.mistakes_view;
    let inputs = context.derived.resolved.as_ref().zip(context.derived.scene.as_deref());
    if view.wants_vote
        && let Some((resolved, scene)) = inputs
    {
        view.ask(&context.open.document.camera, resolved, scene);
        ui.ctx().request_discard("a vote was opened after its picture was drawn");
    }
    if view.open_vote.is_some() { vote::ui::ui(ui, context) } else { choice(ui, context) }
}

/// Shows the gallery, the explanation and the checks side by side. In a narrow area, the gallery is in a menu.
fn choice(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { open, session, derived, tools, style, .. } = context;
    let (gallery, style, can_ask) = (&mut tools.gallery, *style, vote::ui::can_ask(derived));
    let mistakes_view = &mut session.shown.mistakes_view;
    if derived.fault.is_none() {
        gallery.step(ui, &open.document, session.shown.setup.shade);
    }
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let whole = ui.available_rect_before_wrap();
    let part = |from: f32, to: f32| {
        Rect::from_min_max(pos2(from, whole.top()), pos2(to.max(from + 1.0), whole.bottom()))
    };
    let is_narrow = whole.width() < NARROW;
    let is_stacked = whole.width() < STACKED;
    let checks_width = if is_narrow { 0.0 } else { CHECKS.min(0.46 * whole.width()) };
    let columns = (whole.width() - checks_width - EXPLANATION) / CELL.x;
    let columns = columns.floor().clamp(COLUMNS[0], COLUMNS[1]);
    let thumbnails = if is_stacked { 0.0 } else { columns * CELL.x + 20.0 };
    let (left, right) = (whole.left() + thumbnails, whole.right() - checks_width);
    if !is_stacked {
        column(ui, part(whole.left(), left - 8.0), "gallery", |ui| {
            vote::ui::button(ui, mistakes_view, can_ask);
            gallery.grid(ui, &mut mistakes_view.chosen);
        });
    }
    let Some(wrong) = derived.wrong_camera.as_deref() else { return };
    column(ui, part(left, right - 8.0), "mistake", |ui| {
        if is_stacked {
            ui.horizontal_wrapped(|ui| {
                let name = mistakes_view.chosen.name();
                let chosen = &mut mistakes_view.chosen;
                combo(ui, "mistake", MENU[0], name, |ui| {
                    let most = ui.ctx().content_rect().width() - MENU[1];
                    ui.set_min_width(most.min(COLUMNS[2] * CELL.x));
                    gallery.grid(ui, chosen);
                });
                vote::ui::button(ui, mistakes_view, can_ask);
            });
        }
        if is_narrow {
            ui.spacing_mut().item_spacing.y = 1.0;
        }
        gallery.elsewhere(ui, wrong.mistake);
        explanation(ui, wrong, style);
        if is_narrow {
            ui.add_space(4.0);
            checks(ui, wrong, style);
        }
    });
    if !is_narrow {
        column(ui, part(right, whole.right()), "checks", |ui| checks(ui, wrong, style));
    }
}

/// Returns what the step's card is about.
fn about(session: &Session) -> &[Concept] {
    session.shown.formulas.as_ref().map_or(&[], Formulas::concepts)
}

/// Shows the card of a lesson's step in this text size: the right and the wrong basis, of which only the vectors
/// that the card is about, and the checks. If it is about all three vectors, these are the checks of the basis that
/// pass; if about none, the checks that catch the mistake.
pub(crate) fn card(ui: &mut Ui, context: &PageContext<'_>, wrong: &ComparedCamera, size: f32) {
    let (style, about) = (context.style, about(context.session));
    ui.style_mut().override_font_id = Some(FontId::proportional(size));
    ui.spacing_mut().item_spacing.y = 0.2 * size;
    if let Ok(camera) = &wrong.camera {
        basis(ui, camera, style, about);
    }
    if about.is_empty() {
        let checks = wrong.right_checks.iter().zip(&wrong.checks);
        for (right, here) in checks.filter(|(_, here)| !here.passes) {
            let formula = right.check.formula();
            let is_right = format!("{formula} = {}", wanted(here, right, style));
            let is_wrong = format!("{formula} = {}", text_of(here.value, style));
            for (text, passes) in [(is_right, true), (is_wrong, false)] {
                ui.horizontal(|ui| (sign(ui, passes), ui.label(text)));
            }
        }
    } else if about.len() == 3 {
        ui.strong("Camera 2 passes");
        let checks = wrong.checks.iter().filter(|it| it.passes && it.check.is_of_basis());
        // Three lengths, three right angles, and handedness.
        for row in checks.collect::<Vec<_>>().chunks(3) {
            let is_same =
                |a: &&Checked, b: &&Checked| text_of(a.value, style) == text_of(b.value, style);
            ui.horizontal(|ui| {
                for equal in row.chunk_by(is_same) {
                    let formulas: Vec<&str> = equal.iter().map(|it| it.check.formula()).collect();
                    let (formulas, value) = (formulas.join(" = "), text_of(equal[0].value, style));
                    sign(ui, true);
                    let label = ui.label(format!("{formulas} = {value}"));
                    label.spoken(format!("{formulas}: {value} passes"));
                }
            });
        }
    }
}

/// Returns an upper bound for the number of rows of text on the card.
pub(crate) fn card_rows(wrong: &ComparedCamera, session: &Session) -> usize {
    match about(session).len() {
        0 => 5 + 2 * wrong.failing().count(),
        3 => 8,
        // A wrong vector may be below the right one.
        count => 2 * count,
    }
}

fn column(ui: &mut Ui, rect: Rect, name: &str, content: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ScrollArea::vertical().id_salt(name).auto_shrink(false).show(ui, content);
    });
}

/// Shows the mistake, its effect, and the right and the wrong basis.
fn explanation(ui: &mut Ui, wrong: &ComparedCamera, style: NumberStyle) {
    let mistake = wrong.mistake;
    if let Some(why) = &wrong.why_not {
        ui.label(RichText::new(why).strong());
        ui.add_space(4.0);
    }
    ui.label(RichText::new(mistake.formula()).size(16.0).strong());
    ui.add_space(4.0);
    ui.label(mistake.shows());
    if let Some(share) = share_that_differs(wrong) {
        ui.add_space(4.0);
        ui.label(format!("{share}."));
    }
    if let Ok(camera) = &wrong.camera {
        ui.add_space(6.0);
        basis(ui, camera, style, &[]);
    }
}

/// Shows u, v, w of both cameras, or those of them that are in `about`: side by side if they fit, otherwise one
/// above the other.
fn basis(ui: &mut Ui, camera: &WrongCamera, style: NumberStyle, about: &[Concept]) {
    let right = camera.right_camera().basis();
    let rows = [
        (Concept::U, "u", "𝐮", right.u, camera.u()),
        (Concept::V, "v", "𝐯", right.v, camera.v()),
        (Concept::W, "w", "𝐰", right.w, camera.w()),
    ];
    let scale = text_size(ui) / TEXT;
    for ((concept, name, letter, right, wrong), is_wrong) in
        rows.into_iter().zip(camera.wrong_vectors())
    {
        if !about.is_empty() && !about.contains(&concept) {
            continue;
        }
        let color = vector_color(ui, name).unwrap_or(Color32::PLACEHOLDER);
        let letter = RichText::new(letter).color(color);
        let is_wrong_value = style.equated_value(&ReadingValue::Vector(wrong));
        let (right, wrong) = (style.vector(right), style.vector(wrong));
        let both = text_width(ui, &right) + text_width(ui, &wrong) + scale * BESIDE_VECTORS;
        let fits = both <= ui.available_width();
        let wrong = |ui: &mut Ui| {
            sign(ui, false);
            let text = RichText::new(&wrong).strong().color(error_color(ui));
            ui.add(Label::new(text).wrap()).spoken(format!("wrong {name} {is_wrong_value}"));
        };
        ui.horizontal_top(|ui| {
            cell(ui, scale * LETTER, |ui| ui.label(letter));
            sign(ui, true);
            ui.add(Label::new(right).wrap());
            if is_wrong && fits {
                wrong(ui);
            }
        });
        if is_wrong && !fits {
            ui.horizontal_top(|ui| {
                cell(ui, scale * LETTER, |_| ());
                wrong(ui);
            });
        }
    }
    let (right, wrong) = (camera.right_camera().viewport().distance, camera.distance());
    if right != wrong {
        ui.label(format!("distance {}, taken as {}", style.number(right), style.number(wrong)));
    }
}

/// Width of the verdict, in points.
const VERDICT: f32 = 76.0;
/// Width of the formula, in points.
const FORMULA: f32 = 192.0;

/// Shows the checks as a table, in which the checks that catch the mistake come first.
fn checks(ui: &mut Ui, wrong: &ComparedCamera, style: NumberStyle) {
    if wrong.checks.is_empty() {
        ui.label("Without a wrong camera there is nothing to check.");
        return;
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    ui.strong(summary(wrong));
    ui.add_space(3.0);
    for passes in [false, true] {
        let all = wrong.checks.iter().zip(&wrong.right_checks);
        for (here, right) in all.filter(|(here, _)| here.passes == passes) {
            row(ui, here, right, style);
        }
    }
}

/// Returns a text such as `2 of 14 checks catch it`.
fn summary(wrong: &ComparedCamera) -> String {
    let (all, failing) = (wrong.checks.len(), wrong.failing().count());
    match failing {
        0 => format!("None of {all} checks catches it"),
        1 => format!("1 of {all} checks catches it"),
        _ => format!("{failing} of {all} checks catch it"),
    }
}

/// Shows a check's verdict, formula and value, and the right value if it differs. Values that do not fit in
/// the row are shown below it.
fn row(ui: &mut Ui, here: &Checked, right: &Checked, style: NumberStyle) {
    let value = text_of(here.value, style);
    ui.horizontal_wrapped(|ui| {
        verdict_and_formula(ui, here, &value);
        let text = RichText::new(value);
        if here.passes {
            ui.add(Label::new(text).extend());
        } else {
            ui.add(Label::new(text.strong().color(error_color(ui))).extend());
            ui.add(Label::new(format!("right: {}", wanted(here, right, style))).extend());
        }
    });
}

fn verdict_and_formula(ui: &mut Ui, here: &Checked, value: &str) {
    let said = if here.passes { "passes" } else { "catches it" };
    let verdict = match here.passes {
        true => RichText::new(said).weak(),
        false => RichText::new(said).strong().color(error_color(ui)),
    };
    let scale = text_size(ui) / TEXT;
    sign(ui, here.passes);
    let spoken = format!("{}: {value} {said}", here.check.formula());
    cell(ui, scale * VERDICT, |ui| ui.label(verdict)).spoken(spoken);
    cell(ui, scale * FORMULA, |ui| ui.label(here.check.formula()))
        .on_hover_text(here.check.meaning());
}

fn wanted(here: &Checked, right: &Checked, style: NumberStyle) -> String {
    let value = text_of(right.value, style);
    match here.wanted {
        Wanted::Negative => format!("{value} < 0"),
        Wanted::Positive => format!("{value} > 0"),
        Wanted::Equal(_) | Wanted::LeftAndUp => value,
    }
}

fn text_of(value: Value, style: NumberStyle) -> String {
    match value {
        Value::Number(x) => style.number(x),
        Value::Uv(uv) => format!("({}, {})", style.number(uv.x), style.number(uv.y)),
    }
}
