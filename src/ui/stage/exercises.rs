//! An exercise on the stage: in the column, its answer fields with their verdicts, its buttons and its
//! solution; as the main figure, the lines of a question in two dimensions.

use std::sync::Arc;

use egui::{
    Align, Color32, Context, FontId, Id, Key, Label, Layout, RichText, Sense, Stroke, Ui, vec2,
};
use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{self, Asked, Exercise, Given, QuestionPart, Verdict};
use pinhole_lecture::lines::{ImplicitLine, ParametricLine};

use super::column::SIZES;
use crate::model::lines::{LinesLab, Window};
use crate::model::practice::{LARGEST_SEED, next_seed};
use crate::model::session::presenting::WRITTEN;
use crate::model::{Exercises, Feedback, Session, TypedAnswer};
use crate::ui::action::{AnswersAction, LookAction, ShareAction};
use crate::ui::derivation::DerivationPanel;
use crate::ui::practice::seed_field;
use crate::ui::scene::views;
use crate::ui::widgets::{
    self, ResponseExt as _, button_width, combo, inside, line_field, marked_text, sign, text_width,
    vector_color,
};
use crate::ui::workspaces::PageContext;
use crate::view::derivation::Derivation;
use crate::view::derive::Derived;
use crate::view::lines::{self, draw_exercise, substitution};
use crate::view::typesetting::theme::{self, error_color};

/// Describes what the user may type.
const HINT: &str =
    "You may type 5*sqrt(2), -1/sqrt(2) or 3/7, or a decimal of at least four digits.";

/// The button for a hint.
const GIVE_HINT: &str = "Hint";
/// The button that copies the answer's code.
const COPY: &str = "Copy my answer";

/// Text of the button that shows a mistake as a ghost. The spaces are as wide as its padding.
const SHOW_ME: &str = "  Show me  ";

/// Height of a row of fields, as a multiple of the text's size. It is at least that of a button.
const ROW: f32 = 2.1;
/// Number of lines of text below the fields: for verdicts or the hint.
const VERDICT_LINES: f32 = 3.5;
/// Height of a step of a substitution, as a multiple of a line's height.
const BETWEEN_STEPS: f32 = 1.7;
/// Least height of a hint below the buttons, as a multiple of a line's height.
const HINT_LINES: f32 = 2.6;
/// Number of further lines for verdicts where there is room for the solution, too.
const MORE_LINES: f32 = 3.0;
/// Padding of the solution at the left and right, and the radius of its corners, in points.
const PADDING: f32 = 6.0;
const ROUNDING: f32 = 6.0;
/// Space between the fields and the verdicts, in points.
const BEFORE_VERDICTS: f32 = 4.0;
/// Maximum width of one answer field, in points.
const FIELD: f32 = 150.0;
/// Width kept free for the sign behind the fields, in points.
const SIGN: f32 = 18.0;
/// Side of the tick at an exercise that is done, in points.
const TICK: f32 = 14.0;
/// Minimum width of the word *seed* and its field, in points.
const SEED: f32 = 84.0;
/// Width kept free behind the sign for what refers to another answer, such as *as u*, as a multiple of the
/// text's size.
const REFERENCE: f32 = 2.8;
/// Space on each side of the text in a field, in points.
const MARGIN: f32 = 4.0;
/// Height of the substitution of one line into another, as a multiple of a line's height. Most of its steps,
/// and the verdict, take two rows.
pub(crate) const SUBSTITUTION: f32 = 14.5;

/// Name of the picture of a question in two dimensions.
const PLANE: &str = "Lines in the plane";

/// Returns the paragraphs of the exercise's question; none if there is no exercise on the stage.
pub(crate) fn texts(session: &Session) -> Vec<String> {
    match session.shows_exercise() {
        true => exercises::question(&session.exercises.question().given),
        false => Vec::new(),
    }
}

/// Returns the height of a row of buttons, with the space below it.
fn row(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y.max(24.0) + 4.0
}

/// Returns the height of the choice of exercise and numbers above the question. While presenting, there is
/// none; in a lesson, its step chooses the exercise.
pub(crate) fn choice_height(ui: &Ui, session: &Session, is_lesson: bool) -> f32 {
    let has_none = !session.shows_exercise() || theme::installed(ui.ctx()).presenting;
    match (has_none, is_lesson) {
        (true, _) => 0.0,
        (false, true) => row(ui),
        (false, false) => 2.0 * row(ui),
    }
}

/// Shows the choice of exercise and numbers.
pub(crate) fn choice(ui: &mut Ui, session: &mut Session, is_lesson: bool) {
    if !is_lesson {
        ui.horizontal(|ui| {
            let done = format!("{} of {} done", session.progress.count(), Exercise::ALL.len());
            let title = session.exercises.question().exercise.title();
            let width = ui.available_width() - button_width(ui, &done);
            combo(ui, "exercise", width.min(280.0), title, |ui| choose(ui, session));
            ui.weak(done);
        });
    }
    source(ui, &mut session.exercises);
}

/// Shows all exercises, each that is done with a tick, and the way to start them over.
fn choose(ui: &mut Ui, session: &mut Session) {
    let Session { exercises, progress, .. } = session;
    let chosen = exercises.question().exercise;
    for &exercise in Exercise::ALL {
        ui.horizontal(|ui| {
            let is_done = progress.is_done(exercise);
            let (tick, _) = ui.allocate_exact_size(vec2(TICK, TICK), Sense::hover());
            let mut response = ui.selectable_label(exercise == chosen, exercise.title());
            if is_done {
                widgets::tick(ui.painter(), tick, ui.visuals().text_color());
                response = response.described("done");
            }
            if response.clicked() && exercise != chosen {
                exercises.show(exercise, None);
            }
        });
    }
    ui.separator();
    let can = progress.count() > 0;
    ui.add_enabled(can, egui::Button::new("Start over…")).asks(AnswersAction::AskStartOver);
}

/// Shows the choice between the lecture's question and a question generated from a seed.
fn source(ui: &mut Ui, exercises: &mut Exercises) {
    let exercise = exercises.question().exercise;
    let seed = exercises.seed();
    ui.horizontal(|ui| {
        if ui.selectable_label(seed.is_none(), "Lecture version").clicked() && seed.is_some() {
            exercises.show(exercise, None);
        }
        let hint = "The same question with other numbers";
        if ui.button("New numbers").on_hover_text(hint).clicked() {
            exercises.renew(seed.map_or(1, next_seed));
        }
        if let Some(seed) = seed {
            let hint = format!(
                "The number that the question's numbers are drawn from: the same seed, the same \
                 question; a whole number, 0 to {LARGEST_SEED}"
            );
            if ui.available_width() > SEED {
                ui.label("seed").on_hover_text(&hint);
            }
            let mut typed = seed;
            seed_field(ui, &mut typed, "exercise seed", &hint);
            if typed != seed {
                exercises.show(exercise, Some(typed));
            }
        }
    });
}

/// Returns the height of the fields and of the verdicts below them.
fn answers_height(ui: &Ui, exercises: &Exercises, [width, size]: [f32; 2]) -> f32 {
    let small = small(size);
    let hint = marked_text::height_within(ui, HINT, small, width);
    let verdicts = hint.max(VERDICT_LINES * marked_text::row_height(ui, small));
    exercises.answers.len() as f32 * row_of_fields(ui, size) + BEFORE_VERDICTS + verdicts
}

/// Returns the height of the solution.
fn solution_height(ui: &mut Ui, session: &Session, derived: &Derived, at: [f32; 2]) -> f32 {
    let [width, size] = at;
    match &derived.derivation {
        Some(lines) if lab(&session.exercises).is_none() => {
            DerivationPanel::card_height(ui, lines, width, size)
        }
        _ => SUBSTITUTION * marked_text::row_height(ui, size),
    }
}

/// Returns the height of a row of fields.
fn row_of_fields(ui: &Ui, size: f32) -> f32 {
    (ROW * size).max(ui.spacing().interact_size.y)
}

/// Returns the size of verdicts below fields with text of this size.
fn small(size: f32) -> f32 {
    (size - 1.0).max(WRITTEN)
}

/// Returns the height of the buttons below the answers. While presenting, they are beside the step's number.
fn bar(ui: &Ui) -> f32 {
    if theme::installed(ui.ctx()).presenting { 0.0 } else { row(ui) }
}

/// Returns the least height of the exercise in the column below the question. If need be, the solution takes
/// the place of the fields.
pub(crate) fn height(ui: &mut Ui, session: &Session, derived: &Derived, at: [f32; 2]) -> f32 {
    let answers = answers_height(ui, &session.exercises, at);
    let solution = solution_height(ui, session, derived, [at[0], WRITTEN]);
    answers.max(solution) + bar(ui)
}

/// Shows the answer fields with their verdicts, the buttons, and the solution if the user has asked for it.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>, size: f32, is_lesson: bool) {
    let whole = ui.available_rect_before_wrap();
    let PageContext { session, derived, .. } = context;
    let answers = answers_height(ui, &session.exercises, [whole.width(), size]);
    let (most, is_solved) = (whole.height() - bar(ui), session.exercises.is_solved);
    let mut solved = |size| solution_height(ui, session, derived, [whole.width(), size]);
    // Below the fields or, if there is too little room, in their place.
    let has_both = answers + solved(size) <= most;
    let room = if has_both { most - answers } else { most };
    let of_solution = SIZES.into_iter().find(|own| *own <= size && solved(*own) <= room);
    let of_solution = of_solution.unwrap_or(WRITTEN);
    let solved = solved(of_solution);
    let height = match has_both {
        // What the solution leaves over is for more to be said of the answers.
        true => {
            answers
                + (most - answers - solved)
                    .min(MORE_LINES * marked_text::row_height(ui, small(size)))
        }
        false => most.min(answers.max(solved)),
    };
    let (above, below) = whole.split_top_bottom_at_y(whole.top() + height);
    // Where there is no room below the buttons, a new hint has that of what is said of the answers.
    let hint_room = HINT_LINES * marked_text::row_height(ui, of_solution);
    let hint_below = below.height() - bar(ui) >= hint_room;
    let hides_said = !hint_below && context.session.exercises.has_new_hint();
    inside(ui, above, |ui| match is_solved && !has_both {
        true => solution(ui, context, [solved, of_solution]),
        false => fields(ui, context.session, size, [is_lesson, hides_said]),
    });
    let (buttons_area, rest) = below.split_top_bottom_at_y(below.top() + bar(ui));
    if buttons_area.height() > 0.0 {
        inside(ui, buttons_area, |ui| {
            ui.horizontal_centered(|ui| buttons(ui, context));
        });
    }
    let has_hint = context.session.exercises.hints() > 0 && (hint_below || hides_said);
    if !is_solved && has_hint {
        let area = if hint_below { rest } else { above.with_min_y(above.bottom() - hint_room) };
        inside(ui, area, |ui| hint(ui, context, of_solution));
    }
    if is_solved && has_both {
        inside(ui, rest, |ui| solution(ui, context, [solved, of_solution]));
    }
}

/// Shows the exercise's buttons.
pub(crate) fn buttons(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { session, derived, .. } = context;
    let hint = "Or Enter in a field. Nothing is sent anywhere.";
    if ui.button("Check").on_hover_text(hint).clicked() {
        session.check_exercise();
    }
    let exercises = &mut session.exercises;
    let solution = if exercises.is_solved { "Hide the solution" } else { "Show the solution" };
    let room = ui.available_width();
    let fits = |ui: &Ui, of: &str| {
        [GIVE_HINT, of, COPY].map(|text| button_width(ui, text)).iter().sum::<f32>() <= room
    };
    let [is_whole, is_copy_whole] = [solution, "Solution"].map(|of| fits(ui, of));
    let can = !exercises.is_solved && !exercises.is_right();
    let about =
        "The next line that leads to what is not right yet; after the last one, the solution";
    let hint = ui.add_enabled(can, egui::Button::new(GIVE_HINT)).on_hover_text(about);
    if hint.clicked() {
        exercises.give_hint(hint_lines(exercises, derived));
    }
    if ui.button(if is_whole { solution } else { "Solution" }).named(solution).clicked() {
        exercises.toggle_solution();
    }
    if !theme::installed(ui.ctx()).presenting {
        let copy = egui::Button::new(if is_copy_whole { COPY } else { "Copy" });
        let copy = ui.add_enabled(exercises.is_readable(), copy).named(COPY);
        let hint = "As a code that you can send, if all that you have typed can be read";
        copy.on_hover_text(hint).on_disabled_hover_text(hint).asks(ShareAction::CopyAnswer);
    }
}

/// Shows the fields, each with what is said of it, and below them what may be typed, or is still missing.
fn fields(ui: &mut Ui, session: &mut Session, size: f32, [is_lesson, hides_said]: [bool; 2]) {
    let exercises = &mut session.exercises;
    ui.style_mut().override_font_id = Some(FontId::proportional(size));
    ui.spacing_mut().item_spacing.y = 0.0;
    let parts = exercises.question().parts.clone();
    let names = parts.iter().map(|part| format!("{} =", part.asked.symbol()));
    let indent = names.map(|name| text_width(ui, &name, FontId::proportional(size + 1.0)));
    let indent = indent.fold(0.0, f32::max);
    let (small, height, said) = (small(size), row_of_fields(ui, size), at_fields(exercises));
    let slot = Id::unique(("said below", exercises.question().exercise, exercises.seed()));
    let kept: Option<Vec<f32>> = ui.data(|data| data.get_temp(slot));
    let mut heights = kept.unwrap_or_else(|| vec![0.0; parts.len()]);
    let rows = parts.len() as f32 * height + BEFORE_VERDICTS + row(ui);
    let (mut room, mut wants_check) = (ui.available_height() - rows, false);
    for ((k, part), mut text) in parts.iter().enumerate().zip(said) {
        text = text.filter(|_| !hides_said);
        let whole = ui.available_width();
        let feedback = exercises.answers[k].feedback.as_ref();
        let shown = feedback.and_then(|said| exercises.may_show(said));
        let needs = |ui: &Ui, text: &RichText, width| {
            let whole = format!("{}{}", text.text(), shown.map_or("", |_| SHOW_ME));
            marked_text::height_within(ui, &whole, small, width)
        };
        ui.allocate_ui_with_layout(
            vec2(whole, height),
            Layout::left_to_right(Align::Center),
            |ui| {
                ui.set_min_size(vec2(whole, height));
                let typed = &mut exercises.answers[k];
                wants_check |= answer(ui, part, typed, [indent, size]);
                verdict(ui, part, typed);
                let is_wrong = typed.feedback.as_ref().is_some_and(Feedback::is_wrong);
                let color = if is_wrong { error_color(ui) } else { ui.visuals().text_color() };
                text = text.take().map(|text| text.size(small).color(color));
                let width = ui.available_width();
                let fits = |text: &mut RichText| width > SIGN && needs(ui, text, width) <= height;
                if let Some(text) = text.take_if(fits) {
                    sentence(ui, exercises, text, small, shown);
                }
            },
        );
        // An answer that was edited since the check has lost its sentence, but not the room, so that the
        // fields below it stay in place.
        if exercises.answers[k].feedback.is_some() {
            let needed = text.as_ref().map_or(0.0, |text| needs(ui, text, whole));
            let is_first = heights[..k].iter().all(|height| *height == 0.0);
            heights[k] = if needed <= room + 1.0 || is_first { needed } else { 0.0 };
        }
        room -= heights[k];
        let end = ui.cursor().top() + heights[k];
        if let Some(text) = text.filter(|_| heights[k] > 0.0) {
            sentence(ui, exercises, text, small, shown);
        }
        ui.add_space(end - ui.cursor().top());
    }
    let has_room = heights.iter().all(|height| *height == 0.0);
    ui.data_mut(|data| data.insert_temp(slot, heights));
    if wants_check {
        session.check_exercise();
        let wrong = |typed: &TypedAnswer| !typed.feedback.as_ref().is_some_and(Feedback::is_good);
        if let Some(k) = session.exercises.answers.iter().position(wrong) {
            focus(ui.ctx(), &parts[k]);
        }
    }
    ui.add_space(BEFORE_VERDICTS);
    if !hides_said {
        note(ui, session, small, [has_room, is_lesson, wants_check]);
    }
}

/// Shows the sentence on an answer and, if it names a mistake of a camera, the button that shows the camera as a
/// ghost in the figure.
fn sentence(ui: &mut Ui, exercises: &Exercises, text: RichText, size: f32, shown: Option<Mistake>) {
    let label = Label::new(text).wrap();
    let Some(mistake) = shown else { return drop(ui.add(label)) };
    ui.horizontal_wrapped(|ui| {
        ui.add(label);
        let is_shown = exercises.shown_mistake == shown;
        let text = RichText::new(SHOW_ME.trim()).size(size).underline();
        let hint = "Draws the camera with this mistake, from the question's numbers, in the figure";
        let button = ui.add(egui::Button::selectable(is_shown, text).small()).on_hover_text(hint);
        button.asks(LookAction::ShowMe(mistake));
    });
}

/// Returns the id of an answer's field.
fn field_id(part: &QuestionPart, axis: &str) -> Id {
    Id::unique(("answer", part.asked.id(), axis))
}

/// Sets the keyboard focus to the first field of an answer, unless a finger types: its keyboard hides half of
/// the window.
fn focus(ctx: &Context, part: &QuestionPart) {
    if part.count() > 0 && !theme::installed(ctx).by_touch {
        let [(axis, _), ..] = part.asked.coordinates();
        ctx.memory_mut(|memory| memory.request_focus(field_id(part, axis)));
    }
}

/// Returns what is said at the fields of each part: a sentence that stands at an earlier one is referred to.
fn at_fields(exercises: &Exercises) -> Vec<Option<RichText>> {
    let parts = &exercises.question().parts;
    let mut said: Vec<(&str, String)> = Vec::new();
    let is_no_number =
        |typed: &&TypedAnswer| typed.feedback.as_ref().is_some_and(Feedback::is_no_number);
    let has_several = exercises.answers.iter().filter(is_no_number).count() > 1;
    let mut text_of = |part: &QuestionPart, feedback: &Feedback| {
        let sentence = match feedback {
            Feedback::Judged(Verdict::Right) | Feedback::NotAnswered => return None,
            // They are all named in one sentence.
            Feedback::NoNumber(_) if has_several => return None,
            Feedback::Follows(source) => return Some(format!("as {}", source.symbol())),
            _ => feedback.sentence(part),
        };
        if let Some((symbol, _)) = said.iter().find(|(_, earlier)| *earlier == sentence) {
            return Some(format!("as {symbol}"));
        }
        said.push((part.asked.symbol(), sentence.clone()));
        Some(sentence)
    };
    let all = parts.iter().zip(&exercises.answers);
    all.map(|(part, typed)| text_of(part, typed.feedback.as_ref()?).map(RichText::new)).collect()
}

/// Shows the fields for the answer to one part of the question. Returns whether Enter was pressed in one.
fn answer(
    ui: &mut Ui,
    part: &QuestionPart,
    typed: &mut TypedAnswer,
    [indent, size]: [f32; 2],
) -> bool {
    let name = part.asked.id();
    // Without a frame, a field hardly stands out from a white or a black page.
    let frame = Stroke::new(1.0, ui.visuals().weak_text_color());
    ui.visuals_mut().widgets.inactive.bg_stroke = frame;
    if part.count() == 0 {
        ui.label(part.asked.symbol());
        for (yes, text) in [(true, "yes"), (false, "no")] {
            if ui.radio(typed.yes == Some(yes), text).clicked() {
                (typed.yes, typed.feedback) = (Some(yes), None);
            }
        }
        return false;
    }
    let color = vector_color(ui, name).unwrap_or(Color32::PLACEHOLDER);
    let text = RichText::new(format!("{} =", part.asked.symbol())).size(size + 1.0);
    let wide = vec2(indent, ui.available_height());
    ui.allocate_ui_with_layout(wide, Layout::right_to_left(Align::Center), |ui| {
        ui.label(text.color(color));
    });
    // The fields share the row with the gaps between them.
    let between = ui.spacing().item_spacing.x;
    let width = (ui.available_width() - SIGN - REFERENCE * size) / part.count() as f32 - between;
    let width = width.clamp(44.0, FIELD);
    let (mut left, mut entered) = (false, false);
    for ((axis, hint), text) in part.asked.coordinates().into_iter().zip(&mut typed.fields) {
        let (label, hint) = match part.count() {
            1 => (format!("answer {name}"), ""),
            _ => (format!("answer {name} {axis}"), hint),
        };
        let field = line_field(text).hint_text(hint).desired_width(width);
        let field = field.id(field_id(part, axis)).margin(egui::Margin::symmetric(MARGIN as i8, 2));
        let response = ui.add(field.font(FontId::proportional(size))).named(label);
        if response.changed() {
            typed.feedback = None;
        }
        left |= response.lost_focus();
        entered |= response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
    }
    // A vector may be typed into one field, with its brackets, so its coordinates are distributed
    // only when the field loses focus.
    if left {
        typed.spread();
    }
    entered
}

/// Shows the sign of the verdict on an answer behind its fields, once it has been checked.
fn verdict(ui: &mut Ui, part: &QuestionPart, typed: &TypedAnswer) {
    let Some(said) = &typed.feedback else { return };
    let response = match said {
        Feedback::Judged(_) | Feedback::Follows(_) => sign(ui, said.is_good()),
        _ => ui.weak("?"),
    };
    let sentence = said.sentence(part);
    response.on_hover_text(&sentence).spoken(format!("{}: {sentence}", part.asked.id()));
}

/// Shows, below the fields, whether all is right or which answers are missing; before a check, what may be
/// typed, if what was said before leaves room. Outside a lesson, *Next* leads on; it has the focus after a
/// check by Enter.
fn note(ui: &mut Ui, session: &mut Session, size: f32, [has_room, is_lesson, by_enter]: [bool; 3]) {
    let Session { exercises, progress, .. } = session;
    let those = |are: fn(&Feedback) -> bool| -> Vec<&str> {
        let parts = exercises.question().parts.iter().zip(&exercises.answers);
        let those = parts.filter(|(_, typed)| typed.feedback.as_ref().is_some_and(are));
        those.map(|(part, _)| part.asked.symbol()).collect()
    };
    let missing = those(|said| *said == Feedback::NotAnswered);
    let no_numbers = those(Feedback::is_no_number);
    if exercises.is_right() {
        ui.horizontal(|ui| {
            sign(ui, true);
            ui.label(RichText::new("All correct.").strong());
            let next = progress.next_after(exercises.question().exercise);
            let Some(next) = next.filter(|_| !is_lesson) else { return };
            let response = ui.button("Next →").named("Next exercise").on_hover_text(next.title());
            if by_enter {
                response.request_focus();
            }
            if response.clicked() {
                exercises.show(next, None);
                focus(ui.ctx(), &exercises.question().parts[0]);
            }
        });
    } else if no_numbers.len() > 1 {
        let text = format!("{} are not numbers: try 0.5, 1/3 or sqrt(2)/2.", no_numbers.join(", "));
        ui.add(Label::new(RichText::new(text).size(size).color(error_color(ui))).wrap());
    } else if !missing.is_empty() {
        let text = format!("Not answered yet: {}", missing.join(", "));
        ui.add(Label::new(RichText::new(text).size(size).weak()).wrap());
    } else if has_room && exercises.answers.iter().all(|typed| typed.feedback.is_none()) {
        ui.add(Label::new(RichText::new(HINT).size(size).weak()).wrap());
    }
}

/// Returns the lines that lead to what is not right yet; `None` for a question in two dimensions.
fn lines_left(exercises: &Exercises, derived: &Derived) -> Option<Derivation> {
    let lines = derived.derivation.as_ref().filter(|_| lab(exercises).is_none())?;
    Some(Derivation::clone(lines).left(exercises.concepts()))
}

/// Returns the number of hints before the solution.
fn hint_lines(exercises: &Exercises, derived: &Derived) -> usize {
    // From the substitution to t, or with t known.
    let of_plane = if exercises.is_left(Asked::T) { 4 } else { 1 };
    lines_left(exercises, derived).map_or(of_plane, |lines| lines.line_count())
}

/// Shows the hints that were given or, where there is little room, the newest ones.
fn hint(ui: &mut Ui, context: &mut PageContext<'_>, size: f32) {
    let PageContext { open, session, derived, tools, style } = context;
    let count = session.exercises.hints();
    if let Some(lab) = lab(&session.exercises) {
        let last = 6 - hint_lines(&session.exercises, derived) + count;
        ui.style_mut().override_font_id = Some(FontId::proportional(size));
        // The last ones for which there is room.
        let fit =
            (ui.available_height() / (BETWEEN_STEPS * marked_text::row_height(ui, size))) as usize;
        lines::hint(ui, &lab, style.digits, last - fit.clamp(1, last)..last);
    } else if let Some(lines) = lines_left(&session.exercises, derived) {
        tools.derivation.card(ui, &Arc::new(lines.hint(count)), &open.document, session, size);
    }
}

/// Shows the solution: the lines of the derivation that lead to the answers.
fn solution(ui: &mut Ui, context: &mut PageContext<'_>, [height, size]: [f32; 2]) {
    let area = ui.available_rect_before_wrap();
    let area = area.with_max_y(area.top() + height).expand2(vec2(PADDING, 0.0));
    ui.painter().rect_filled(area, ROUNDING, ui.visuals().faint_bg_color);
    let PageContext { open, session, derived, tools, style } = context;
    match (&derived.derivation, lab(&session.exercises)) {
        (_, Some(lab)) => {
            ui.style_mut().override_font_id = Some(FontId::proportional(size));
            substitution(ui, &lab, style.digits);
        }
        (Some(lines), None) => tools.derivation.card(ui, lines, &open.document, session, size),
        _ => {}
    }
}

/// Returns the lab of lines, which draws two lines in the plane, for a question in two dimensions, with t at
/// the intersection of its lines. Returns `None` for other questions.
pub(crate) fn lab(exercises: &Exercises) -> Option<LinesLab> {
    let Given::Lines { line, origin, direction } = exercises.question().given else { return None };
    let line = ImplicitLine { a: line.x, b: line.y, c: line.z };
    let ray = ParametricLine { p: origin, d: direction };
    let t = exercises.right_t()?;
    let meeting = ray.at(t);
    let mut lab = LinesLab::new(line, ray, t);
    let reach = [origin, meeting].map(|point| point.abs().max_element());
    let half_extent = 1.5 * reach.into_iter().fold(2.0, f64::max);
    lab.window = Window { half_extent, ..lab.window };
    Some(lab)
}

/// Shows the lines of a question in two dimensions.
pub(crate) fn plane(ui: &mut Ui, session: &Session) {
    let Some(lab) = lab(&session.exercises) else { return };
    let rect = ui.available_rect_before_wrap();
    let typed = session.exercises.points_in_plane();
    let seen = (session.exercises.shows_all(), session.settings.digits);
    let _ = views::view(ui, rect, PLANE);
    draw_exercise(ui, rect, &lab, &typed, seen);
    let names: Vec<&str> = typed.iter().map(|(name, _)| name.as_str()).collect();
    views::speak(ui, PLANE, &format!("drawn: {}", names.join(", ")));
}
