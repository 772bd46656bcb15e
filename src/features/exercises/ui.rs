//! An exercise on the stage: in the column, its answer fields, its buttons, hints and its solution; as the main figure, the lines of a question in two dimensions.

use std::ops::Range;
use std::sync::Arc;

use egui::{FontId, Sense, Ui, vec2};
use pinhole_figure::derivation::Derivation;
use pinhole_figure::typesetting::theme;
use pinhole_lecture::exercises::{self, Asked, Exercise, Given};
use pinhole_lecture::lines::{ImplicitLine, ParametricLine};
use pinhole_lecture::{LARGEST_SEED, next_seed};

use super::ui_fields;
use crate::features::exercises::Exercises;
use crate::features::lines;
use crate::features::lines::state::{LinesLab, Window};
use crate::features::lines::view::{card, draw_exercise};
use crate::model::Session;
use crate::ui::action::{AnswersAction, ShareAction};
use crate::ui::scene::views;
use crate::ui::widgets::{
    self, ResponseExt as _, button_width, combo, inside, largest_size, marked_text, seed_field,
};
use crate::ui::{PageContext, derivation};
use crate::view::derive::Derived;

/// The button for a hint.
const GIVE_HINT: &str = "Hint";
/// The button that copies the answer's code.
const COPY: &str = "Copy my answer";

/// Height of a step of a substitution, as a multiple of a line's height.
const BETWEEN_STEPS: f32 = 1.7;
/// Least height of a hint below the buttons, as a multiple of a line's height.
const HINT_LINES: f32 = 2.6;
/// Number of further lines for verdicts where there is room for the solution, too.
const MORE_LINES: f32 = 3.0;
/// Padding of the solution at the left and right, and the radius of its corners, in points.
const PADDING: f32 = 6.0;
const ROUNDING: f32 = 6.0;
/// Side of the tick at an exercise that is done, in points.
const TICK: f32 = 14.0;
/// Minimum width of the word *seed* and its field, in points.
const SEED: f32 = 84.0;
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
pub(crate) fn row(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y.max(24.0) + 4.0
}

/// Returns the height of the choice of exercise and numbers above the question. While presenting, there is
/// none; in a lesson, its step chooses the exercise.
pub(crate) fn choice_height(ui: &Ui, context: &PageContext<'_>) -> f32 {
    let has_none = !context.session.shows_exercise() || theme::installed(ui.ctx()).presenting;
    match (has_none, context.step.is_some()) {
        (true, _) => 0.0,
        (false, true) => row(ui),
        (false, false) => 2.0 * row(ui),
    }
}

/// Shows the choice of exercise and numbers.
pub(crate) fn choice(ui: &mut Ui, PageContext { session, step, .. }: &mut PageContext<'_>) {
    if step.is_none() {
        ui.horizontal(|ui| {
            let done = format!("{} of {} done", session.progress.count(), Exercise::LISTED.len());
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
    for &exercise in Exercise::LISTED {
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

/// Returns the height of the solution.
fn solution_height(ui: &mut Ui, session: &Session, derived: &Derived, at: [f32; 2]) -> f32 {
    let [width, size] = at;
    match (&derived.derivation, lab(&session.exercises)) {
        (_, Some(lab)) => {
            lines::view::card_height(ui, (&lab, session.shown.setup.digits, true), at)
        }
        (Some(lines), None) => derivation::card_height(ui, lines, width, size),
        _ => 0.0,
    }
}

/// Returns the height of the buttons below the answers. While presenting, they are beside the step's number.
fn bar(ui: &Ui) -> f32 {
    if theme::installed(ui.ctx()).presenting { 0.0 } else { row(ui) }
}

/// Returns the least height of the exercise in the column below the question and the advice of this height. If
/// need be, the solution takes the place of the fields; it always takes that of the advice.
pub(crate) fn height(
    ui: &mut Ui,
    session: &Session,
    derived: &Derived,
    (at, advice): ([f32; 2], f32),
) -> f32 {
    let answers = ui_fields::height(ui, &session.exercises, at);
    let solution = solution_height(ui, session, derived, at);
    answers.max(solution - advice) + bar(ui)
}

/// Shows the answer fields with their verdicts, the buttons, and the solution if the user has asked for it.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>, size: f32) {
    let whole = ui.available_rect_before_wrap();
    let PageContext { session, derived, .. } = &*context;
    let answers = ui_fields::height(ui, &session.exercises, [whole.width(), size]);
    let (most, is_solved) = (whole.height() - bar(ui), session.exercises.is_solved);
    let mut solved = |size| solution_height(ui, session, derived, [whole.width(), size]);
    // Below the fields or, if there is too little room, in their place.
    let has_both = answers + solved(size) <= most;
    let room = if has_both { most - answers } else { most };
    let of_solution = largest_size(size, |own| solved(*own) <= room);
    let solved = solved(of_solution);
    let height = match has_both {
        // What the solution leaves over is for more to be said of the answers.
        true => {
            answers
                + (most - answers - solved)
                    .min(MORE_LINES * marked_text::row_height(ui, ui_fields::small(size)))
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
        false => ui_fields::fields(ui, context, size, hides_said),
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
        let lines = lines_left(exercises, derived);
        let all = lines.map_or(plane_hints(exercises).len(), |lines| lines.line_count());
        exercises.give_hint(all);
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

/// Returns the lines that lead to what is not right yet; `None` for a question in two dimensions.
fn lines_left(exercises: &Exercises, derived: &Derived) -> Option<Derivation> {
    let lines = derived.derivation.as_ref().filter(|_| lab(exercises).is_none())?;
    Some(Derivation::clone(lines).left(exercises.concepts()))
}

/// Returns the steps of a substitution that lead to t or, if t is right, to the point.
fn plane_hints(exercises: &Exercises) -> Range<usize> {
    if exercises.is_left(Asked::T) { lines::view::TO_T } else { lines::view::TO_POINT }
}

/// Shows the hints that were given or, where there is little room, the newest ones.
fn hint(ui: &mut Ui, context: &mut PageContext<'_>, size: f32) {
    let PageContext { ref session, derived, style, .. } = *context;
    let count = session.exercises.hints();
    if let Some(lab) = lab(&session.exercises) {
        let last = plane_hints(&session.exercises).start + count;
        ui.style_mut().override_font_id = Some(FontId::proportional(size));
        // The last ones for which there is room.
        let fit =
            (ui.available_height() / (BETWEEN_STEPS * marked_text::row_height(ui, size))) as usize;
        lines::view::hint(ui, &lab, style.digits, last - fit.clamp(1, count)..last);
    } else if let Some(lines) = lines_left(&session.exercises, derived) {
        derivation::card(ui, context, &Arc::new(lines.hint(count)), size);
    }
}

/// Shows the solution: the lines of the derivation that lead to the answers.
fn solution(ui: &mut Ui, context: &mut PageContext<'_>, [height, size]: [f32; 2]) {
    let area = ui.available_rect_before_wrap();
    let area = area.with_max_y(area.top() + height).expand2(vec2(PADDING, 0.0));
    ui.painter().rect_filled(area, ROUNDING, ui.visuals().faint_bg_color);
    let PageContext { ref session, derived, style, .. } = *context;
    match (&derived.derivation, lab(&session.exercises)) {
        (_, Some(lab)) => {
            ui.style_mut().override_font_id = Some(FontId::proportional(size));
            card(ui, &lab, (style.digits, true), None);
        }
        (Some(lines), None) => derivation::card(ui, context, lines, size),
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
    let seen = (session.exercises.shows_all(), session.shown.setup.digits);
    let _ = views::view(ui, rect, PLANE);
    draw_exercise(ui, rect, &lab, &typed, seen);
    let names: Vec<&str> = typed.iter().map(|(name, _)| name.as_str()).collect();
    views::speak(ui, PLANE, &format!("drawn: {}", names.join(", ")));
}
