//! A classroom vote on which mistake made the wrong picture, with four large options. Once the answer is
//! revealed, the page shows the right option and its explanation.

use egui::{
    Align, Align2, Color32, Context, FontId, Key, Layout, Modifiers, Rect, RichText, ScrollArea,
    Sense, Stroke, StrokeKind, Ui, pos2, vec2,
};
use pinhole_core::{Camera, ResolvedCamera, Scene};
use pinhole_lecture::mistakes::{ComparedCamera, Mistake};

use super::mistakes::failing;
use crate::model::practice::{MistakesView, OpenVote, next_seed};
use crate::model::session::{Session, ViewLayout};
use crate::ui::practice::seed_field;
use crate::ui::widgets::{ResponseExt as _, clipped, cross, inside, text_width, tick};
use crate::view::typesetting::theme::error_color;

/// The letters of the options.
const LETTERS: [&str; 4] = ["A", "B", "C", "D"];

/// Size of the question's text, in points.
const QUESTION: f32 = 20.0;
/// Size of an option's letter, in points.
const LETTER: f32 = 30.0;
/// Size of a mistake's name, in points.
const NAME: f32 = 20.0;
/// Size of a formula, in points.
const FORMULA: f32 = 15.0;
/// Size of the reason's text, in points.
const REASON: f32 = 16.0;

/// Height of the question, in points.
const HEAD: f32 = 30.0;
/// Height of the reason, in points.
const WHY: f32 = 78.0;
/// Height of the reason if the page is wide, in points.
const WHY_IF_WIDE: f32 = 70.0;
/// Height of the buttons, in points.
const BAR: f32 = 32.0;

/// Minimum height of an option in a low window, in points.
const LEAST_OPTION: f32 = 36.0;
/// Minimum height of the text with the reason in a low window, in points.
const LEAST_REASON: f32 = 24.0;

/// Width of the page, in points, from which on the reason needs fewer lines.
const WIDE: f32 = 820.0;

/// Space between the options, in points.
const GAP: f32 = 8.0;

/// Width of a letter's column, in points.
const LETTER_WIDTH: f32 = 46.0;
/// Width of the column for the sign that marks right and wrong, in points.
const SIGN_WIDTH: f32 = 44.0;

/// Height of an option, in points, above which it also shows its formula.
const WITH_FORMULA: f32 = 54.0;

/// The camera and the scene from which a vote is created.
pub(super) type VoteInputs<'a> = (&'a Camera, &'a ResolvedCamera, &'a Scene);

/// Reveals the right option of an open vote if Enter or Page Down was pressed.
pub(crate) fn reveal_by_key(ctx: &Context, session: &mut Session) {
    let is_shown = session.settings.layout == ViewLayout::Mistakes;
    if !is_shown || session.mistakes_view.is_revealed() {
        return;
    }
    let has_focus = ctx.memory(|memory| memory.focused().is_some());
    let is_pressed = ctx.input_mut(|input| {
        input.consume_key(Modifiers::NONE, Key::PageDown)
            || !has_focus && input.consume_key(Modifiers::NONE, Key::Enter)
    });
    if is_pressed {
        session.mistakes_view.reveal();
    }
}

/// Shows the button that opens a vote.
pub(super) fn button(ui: &mut Ui, view: &mut MistakesView, inputs: Option<VoteInputs>) {
    let hint = "Shows a wrong picture without its name, and four mistakes to choose from";
    let button = ui.add_enabled(inputs.is_some(), egui::Button::new("Guess which"));
    if button.on_hover_text(hint).clicked()
        && let Some((camera, resolved, scene)) = inputs
    {
        view.ask(camera, resolved, scene);
    }
    if view.nothing_shows {
        ui.label("No two mistakes look different in this picture: bring an object into view.");
    }
    ui.add_space(3.0);
}

/// Shows the vote.
pub(super) fn ui(
    ui: &mut Ui,
    view: &mut MistakesView,
    wrong: Option<&ComparedCamera>,
    inputs: Option<VoteInputs>,
) {
    let whole = ui.available_rect_before_wrap().shrink2(vec2(6.0, 2.0));
    let Some(open) = &mut view.open_vote else { return };
    let (head, rest) = whole.split_top_bottom_at_y(whole.top() + HEAD);
    let (above, bar) = rest.split_top_bottom_at_y(rest.bottom() - BAR);
    let why = if whole.width() < WIDE { WHY } else { WHY_IF_WIDE };
    // In a low window the reason scrolls, so that the options stay legible.
    let why = why.min(above.height() - 2.0 * (LEAST_OPTION + GAP)).max(LEAST_REASON);
    let (tiles, why) = above.split_top_bottom_at_y(above.bottom() - why);
    inside(ui, head, |ui| {
        let text = RichText::new("Which mistake made the wrong picture?").size(QUESTION);
        ui.add(egui::Label::new(text.strong()).truncate());
    });
    options(ui, tiles.with_max_y(tiles.bottom() - GAP), open);
    clipped(ui, why, |ui| {
        let area = ScrollArea::vertical().id_salt("why").auto_shrink(false);
        area.show(ui, |ui| reason(ui, open, wrong));
    });
    inside(ui, bar, |ui| ui.horizontal_centered(|ui| buttons(ui, view, inputs)));
}

/// Minimum height of an option, in points.
const LEAST_HEIGHT: f32 = 8.0;

/// Shows the options in two rows.
fn options(ui: &mut Ui, area: Rect, open: &mut OpenVote) {
    let count = open.vote.options.len();
    let size = 0.5 * (area.size() - vec2(GAP, GAP));
    for index in 0..count {
        let (column, row) = ((index % 2) as f32, (index / 2) as f32);
        let min = area.min + vec2(column * (size.x + GAP), row * (size.y + GAP));
        let rect = Rect::from_min_size(min, size);
        // In the pass in which the vote opens, its area may still be too small.
        let has_room = size.x > LETTER_WIDTH + SIGN_WIDTH && size.y > LEAST_HEIGHT;
        if has_room && option(ui, rect, index, open) && !open.is_revealed {
            open.answer = Some(index);
        }
    }
}

/// Shows an option. Returns true if the user votes for it.
fn option(ui: &Ui, rect: Rect, index: usize, open: &OpenVote) -> bool {
    let mistake = open.vote.options[index];
    let id = ui.scope_id().with(("option", index));
    let response = ui.interact(rect, id, Sense::click());
    let name = format!("{}: {}", LETTERS[index], mistake.name());
    let response = response.with_role(egui::accesskit::Role::Button).named(name);
    let is_right = index == open.vote.right;
    let is_chosen = open.answer == Some(index);
    let visuals = ui.visuals();
    let strong = visuals.strong_text_color();
    let selected = visuals.selection.stroke.color;
    let (edge, ink) = match (open.is_revealed, is_right, is_chosen) {
        (true, true, _) => (Stroke::new(4.0, strong), strong),
        (true, false, true) => (Stroke::new(3.0, error_color(ui)), visuals.weak_text_color()),
        (true, false, false) => (visuals.widgets.inactive.bg_stroke, visuals.weak_text_color()),
        (false, _, true) => (Stroke::new(4.0, selected), strong),
        (false, ..) => (Stroke::new(1.0, visuals.weak_text_color()), strong),
    };
    let fill = match response.hovered() && !open.is_revealed {
        true => visuals.widgets.hovered.weak_bg_fill,
        false => visuals.widgets.inactive.weak_bg_fill,
    };
    let painter = ui.painter_at(rect.expand(2.0));
    painter.rect(rect, 6.0, fill, edge, StrokeKind::Inside);
    let letter = pos2(rect.left() + 0.5 * LETTER_WIDTH, rect.center().y);
    let font = FontId::proportional(LETTER.min(0.75 * rect.height()));
    painter.text(letter, Align2::CENTER_CENTER, LETTERS[index], font, ink);
    let right = rect.right() - SIGN_WIDTH;
    let text = Rect::from_x_y_ranges(rect.left() + LETTER_WIDTH..=right, rect.y_range());
    names(ui, text, mistake, ink);
    if open.is_revealed && (is_right || is_chosen) {
        let center = rect.right_center() - vec2(0.5 * SIGN_WIDTH, 0.0);
        let sign = Rect::from_center_size(center, vec2(26.0, 26.0));
        if is_right { tick(&painter, sign, strong) } else { cross(&painter, sign, error_color(ui)) }
    }
    response.clicked()
}

/// Writes the mistake's name, and the wrong formula below it if it fits.
fn names(ui: &Ui, rect: Rect, mistake: Mistake, ink: Color32) {
    let line = |text: &str, size: f32| {
        let width = text_width(ui, text, FontId::proportional(size));
        let scale = (rect.width() / width.max(1.0)).min(1.0);
        let font = FontId::proportional(size * scale.max(0.6));
        ui.painter().layout_no_wrap(text.to_owned(), font, ink)
    };
    let formula = mistake.formula().split(" Right:").next().unwrap_or_default();
    let lines = [line(mistake.name(), NAME), line(formula, FORMULA)];
    let shown = if rect.height() >= WITH_FORMULA { &lines[..] } else { &lines[..1] };
    let height = shown.iter().map(|galley| galley.size().y).sum::<f32>();
    let mut at = pos2(rect.left(), rect.center().y - 0.5 * height);
    let painter = ui.painter_at(rect);
    for galley in shown {
        painter.galley(at, galley.clone(), ink);
        at.y += galley.size().y;
    }
}

/// Shows the voting instructions or, once the answer is revealed, the reason why the right option is
/// right.
fn reason(ui: &mut Ui, open: &OpenVote, wrong: Option<&ComparedCamera>) {
    let text = |text: String| RichText::new(text).size(REASON);
    if !open.is_revealed {
        let hint = "Compare it with the correct picture on its left. Vote for A, B, C or D; then press \
                    Enter or Page Down.";
        ui.label(text(hint.to_owned()));
        return;
    }
    let mistake = open.vote.mistake();
    let verdict = format!("{}: {}. {}", LETTERS[open.vote.right], mistake.name(), mistake.shows());
    ui.label(text(verdict).strong());
    ui.label(text(mistake.formula().to_owned()));
    let failing = wrong.into_iter().flat_map(failing);
    let catching: Vec<&str> = failing.map(|checked| checked.check.formula()).collect();
    match &catching[..] {
        [] => (),
        [one] => drop(ui.label(text(format!("The check that catches it: {one}.")))),
        many => drop(ui.label(text(format!("The checks that catch it: {}.", many.join("; "))))),
    }
}

fn buttons(ui: &mut Ui, view: &mut MistakesView, inputs: Option<VoteInputs>) {
    let is_revealed = view.is_revealed();
    let reveal = egui::Button::new(RichText::new("Reveal").strong());
    if ui.add_enabled(!is_revealed, reveal).on_hover_text("Enter or Page Down").clicked() {
        view.reveal();
    }
    let another = ui.add_enabled(inputs.is_some(), egui::Button::new("Another one")).clicked();
    if ui.button("All mistakes").on_hover_text("Ends the vote").clicked() {
        view.close_vote();
        return;
    }
    let mut seed = if another { next_seed(view.seed) } else { view.seed };
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let hint = "The number that the question is drawn from: in the same scene, the same seed asks \
                    the same question";
        seed_field(ui, &mut seed, "vote seed", hint);
        ui.label("seed").on_hover_text(hint);
    });
    if seed != view.seed
        && let Some((camera, resolved, scene)) = inputs
    {
        view.seed = seed;
        view.ask(camera, resolved, scene);
    }
}
