//! The exercises view: the list, the question, the answer fields, and the verdicts.

use egui::{
    Align, Color32, Key, Layout, Rect, RichText, ScrollArea, TextEdit, Ui, UiBuilder, pos2,
};
use pinhole_lecture::exercises::{self, Exercise, QuestionPart};

use crate::model::practice::exercises::{Exercises, Feedback, LARGEST_SEED, TypedAnswer};
use crate::ui::action::{Action, Leave, MadeUp};
use crate::ui::scene::readouts::NumberStyle;
use crate::ui::widgets::marked_text;
use crate::ui::widgets::number::vector_color;
use crate::ui::widgets::sign::sign;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::typesetting::theme::error_color;

/// Size of the text, in points.
const TEXT: f32 = 17.0;

/// Width of the list, in points.
const LIST: f32 = 290.0;

/// Indent of the fields and of the text below them, in points.
const INDENT: f32 = 96.0;

/// Height of the bar with the buttons, in points.
const BAR: f32 = 52.0;

/// Width of one answer field, in points.
const FIELD: f32 = 150.0;

/// Space beside the text in a field, in points.
const MARGIN: f32 = 4.0;

/// The coordinates of a vector: for screen readers, and as symbols.
const AXES: [(&str, &str); 3] = [("x", "𝑥"), ("y", "𝑦"), ("z", "𝑧")];

/// Shows the current exercise; opening its camera adds to `actions`.
pub(crate) fn ui(
    ui: &mut Ui,
    exercises: &mut Exercises,
    style: NumberStyle,
    actions: &mut Vec<Action>,
) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let whole = ui.available_rect_before_wrap().shrink(8.0);
    let list = LIST.min(0.35 * whole.width());
    let left = Rect::from_min_max(whole.min, pos2(whole.left() + list, whole.bottom()));
    let right = Rect::from_min_max(pos2(left.right() + 20.0, whole.top()), whole.max);
    ui.scope_builder(UiBuilder::new().max_rect(left), |ui| {
        ui.heading("Exercises");
        ui.add_space(4.0);
        ScrollArea::vertical().id_salt("exercises").show(ui, |ui| choose(ui, exercises));
    });
    // The buttons stay where they are, whatever is said above them.
    let (above, bar) = right.split_top_bottom_at_y(right.bottom() - BAR);
    let mut wants_check = false;
    ui.scope_builder(UiBuilder::new().max_rect(above), |ui| {
        ScrollArea::vertical().id_salt("exercise").auto_shrink(false).show(ui, |ui| {
            wants_check = exercise(ui, exercises, style);
        });
    });
    ui.scope_builder(UiBuilder::new().max_rect(bar), |ui| {
        ui.separator();
        wants_check |= buttons(ui, exercises, actions);
    });
    if wants_check {
        exercises.check();
        ui.ctx().request_discard("answers were checked after they were drawn");
    }
}

fn choose(ui: &mut Ui, exercises: &mut Exercises) {
    let chosen = exercises.question().exercise;
    for &exercise in Exercise::ALL {
        let text = RichText::new(exercises::title(exercise)).size(15.0);
        let response = ui.add(egui::Button::selectable(exercise == chosen, text).wrap());
        if response.clicked() && exercise != chosen {
            *exercises = Exercises::open(exercise, None);
        }
    }
}

/// Shows the question with its fields. Returns true if Enter was pressed in one.
fn exercise(ui: &mut Ui, exercises: &mut Exercises, style: NumberStyle) -> bool {
    let question = exercises.question().clone();
    ui.heading(RichText::new(exercises::title(question.exercise)).size(22.0).strong());
    source(ui, exercises);
    ui.add_space(8.0);
    for paragraph in exercises::question(&question.given) {
        marked_text::label(ui, &paragraph, TEXT);
    }
    ui.add_space(10.0);
    let mut wants_check = false;
    for (part, typed) in question.parts.iter().zip(&mut exercises.answers) {
        wants_check |= answer(ui, part, typed);
        verdict(ui, part, typed);
        if exercises.is_solved {
            solution(ui, part, style);
        }
        ui.add_space(8.0);
    }
    ui.label(
        RichText::new(
            "Numbers may be typed exactly: 5*sqrt(2), -1/sqrt(2), 3/7. Nothing is kept or sent.",
        )
        .size(15.0)
        .weak(),
    );
    wants_check
}

/// Shows the buttons, and whether all is right. Returns true if the answers are to be checked.
fn buttons(ui: &mut Ui, exercises: &mut Exercises, actions: &mut Vec<Action>) -> bool {
    let mut wants_check = false;
    ui.horizontal_wrapped(|ui| {
        wants_check = ui.button("Check").on_hover_text("Or Enter in a field").clicked();
        let text = if exercises.is_solved { "Hide the solution" } else { "Show the solution" };
        if ui.button(text).clicked() {
            exercises.is_solved = !exercises.is_solved;
        }
        if let Some(document) = exercises.document() {
            let hint = "Makes this question's camera, and what its ray meets, the open scene";
            if ui.button("Show this scene").on_hover_text(hint).clicked() {
                let question = exercises.question();
                let title = exercises::title(question.exercise).to_owned();
                let made_up = MadeUp { document, title, uv: question.uv() };
                actions.push(Leave::Show(Box::new(made_up)).into());
                ui.ctx().request_repaint();
            }
        }
        if exercises.is_right() {
            sign(ui, true);
            ui.label(RichText::new("All correct.").strong());
        }
    });
    wants_check
}

/// Shows the choice between the lecture's own question and one from a seed.
fn source(ui: &mut Ui, exercises: &mut Exercises) {
    let exercise = exercises.question().exercise;
    let seed = exercises.seed();
    ui.horizontal_wrapped(|ui| {
        if ui.selectable_label(seed.is_none(), "Lecture version").clicked() && seed.is_some() {
            *exercises = Exercises::open(exercise, None);
        }
        let hint = "Other numbers, from the next seed";
        if ui.button("New numbers").on_hover_text(hint).clicked() {
            let next = seed.map_or(1, |seed| if seed < LARGEST_SEED { seed + 1 } else { 0 });
            *exercises = Exercises::open(exercise, Some(next));
        }
        if let Some(seed) = seed {
            ui.label("seed");
            let mut typed = seed;
            let field = egui::DragValue::new(&mut typed)
                .speed(0.1)
                .range(0..=LARGEST_SEED)
                .update_while_editing(false);
            let hint = format!("A whole number, 0 to {LARGEST_SEED}");
            ui.add(field).on_hover_text(hint).named("exercise seed");
            if typed != seed {
                *exercises = Exercises::open(exercise, Some(typed));
            }
            ui.label(RichText::new("Who types the same seed gets the same question.").weak());
        }
    });
}

/// Shows the fields of one part. Returns true if Enter was pressed in one.
fn answer(ui: &mut Ui, part: &QuestionPart, typed: &mut TypedAnswer) -> bool {
    let mut entered = false;
    let name = part.asked.id();
    ui.horizontal_wrapped(|ui| {
        let color = vector_color(ui, name).unwrap_or(Color32::PLACEHOLDER);
        let wide = egui::vec2(90.0, 30.0);
        let text = RichText::new(format!("{} =", exercises::asked(part))).size(TEXT + 1.0);
        let text = if part.count() == 0 {
            RichText::new(exercises::asked(part)).size(TEXT)
        } else {
            text.color(color)
        };
        ui.allocate_ui_with_layout(wide, Layout::right_to_left(Align::Center), |ui| {
            ui.label(text);
        });
        if part.count() == 0 {
            for (yes, text) in [(true, "yes"), (false, "no")] {
                if ui.radio(typed.yes == Some(yes), text).clicked() {
                    (typed.yes, typed.feedback) = (Some(yes), None);
                }
            }
            return;
        }
        // Side by side with what is between them and round the text.
        let between = ui.spacing().item_spacing.x + 2.0 * MARGIN + 1.0;
        let width = (ui.available_width() / part.count() as f32 - between).clamp(60.0, FIELD);
        let (mut changed, mut left) = (false, false);
        for ((axis, hint), text) in AXES.into_iter().zip(&mut typed.fields) {
            let label = if part.count() == 1 {
                format!("answer {name}")
            } else {
                format!("answer {name} {axis}")
            };
            let hint = if part.count() == 1 { "" } else { hint };
            let field = TextEdit::singleline(text).hint_text(hint).desired_width(width);
            let field = field.margin(egui::Margin::symmetric(MARGIN as i8, 2));
            let response = ui.add(field.font(egui::FontId::proportional(TEXT))).named(label);
            changed |= response.changed();
            left |= response.lost_focus();
            entered |= response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
        }
        if changed {
            typed.feedback = None;
        }
        // Only when the field loses focus: a vector may also be typed with its brackets.
        if left {
            typed.spread();
        }
    });
    entered
}

/// Shows the right answer below the fields.
fn solution(ui: &mut Ui, part: &QuestionPart, style: NumberStyle) {
    let text = format!("{} {}", exercises::asked(part), exercises::solution(part, style.digits));
    ui.horizontal_top(|ui| {
        ui.add_space(INDENT);
        ui.add(egui::Label::new(RichText::new(text).strong()).wrap());
    });
}

/// Shows the verdict on a part once it was checked.
fn verdict(ui: &mut Ui, part: &QuestionPart, typed: &TypedAnswer) {
    let Some(said) = &typed.feedback else { return };
    let text = RichText::new(said.sentence(part)).size(TEXT - 1.0).strong();
    let is_wrong = !said.is_good() && !matches!(said, Feedback::NotAnswered | Feedback::Missing);
    let text = if is_wrong { text.color(error_color(ui)) } else { text };
    ui.horizontal_top(|ui| {
        ui.add_space(INDENT);
        if let Feedback::Judged(_) | Feedback::Follows(_) = said {
            sign(ui, said.is_good());
        }
        let spoken = format!("{}: {}", part.asked.id(), said.sentence(part));
        ui.add(egui::Label::new(text).wrap()).spoken(spoken);
    });
}
