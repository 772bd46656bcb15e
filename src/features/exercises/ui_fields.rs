//! The answer fields of an exercise: each with the sign of its verdict and what is said of its answer.

use egui::{Align, Color32, Context, FontId, Id, Key, Label, Layout, RichText, Stroke, Ui, vec2};
use pinhole_figure::typesetting::theme::{self, WRITTEN, error_color, text_size};
use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{QuestionPart, Verdict};

use super::ui::row;
use crate::features::exercises::{Exercises, Feedback, TypedAnswer};
use crate::model::Session;
use crate::ui::PageContext;
use crate::ui::action::LookAction;
use crate::ui::widgets::{
    ResponseExt as _, line_field, marked_text, sign, text_width, vector_color,
};

/// Describes what the user may type.
const HINT: &str =
    "You may type 5*sqrt(2), -1/sqrt(2) or 3/7, or a decimal of at least four digits.";

/// Text of the button that shows a mistake as a ghost, and text as wide as the button with its padding. A space at its
/// end would take no room.
const SHOW_ME: [&str; 2] = ["Show me", "  Show\u{a0}me\u{a0}\u{a0}m"];

/// Height of a row of fields, as a multiple of the text's size, in the window and while presenting. It is at least
/// that of a button.
const ROW: [f32; 2] = [2.1, 1.6];
/// Number of lines of text below the fields, for verdicts or the hint, in the window and while presenting.
const VERDICT_LINES: [f32; 2] = [4.5, 2.0];
/// Space between the fields and the verdicts, in points.
const BEFORE_VERDICTS: f32 = 4.0;
/// Maximum width of one answer field, in points.
const FIELD: f32 = 150.0;
/// Width kept free for the sign behind the fields, in points.
const SIGN: f32 = 18.0;
/// Width kept free behind the sign for what refers to another answer, such as *as u*, as a multiple of the
/// text's size.
const REFERENCE: f32 = 2.8;
/// Space on each side of the text in a field, in points.
const MARGIN: f32 = 4.0;
/// Returns the height of the fields and of the verdicts below them.
pub(crate) fn height(ui: &Ui, exercises: &Exercises, [width, size]: [f32; 2]) -> f32 {
    let small = small(size);
    let hint = marked_text::height_within(ui, HINT, small, width);
    let lines = VERDICT_LINES[usize::from(theme::installed(ui.ctx()).presenting)];
    let verdicts = hint.max(lines * marked_text::row_height(ui, small));
    exercises.answers.len() as f32 * row_of_fields(ui, size) + BEFORE_VERDICTS + verdicts
}

/// Returns the height of a row of fields.
fn row_of_fields(ui: &Ui, size: f32) -> f32 {
    let row = ROW[usize::from(theme::installed(ui.ctx()).presenting)];
    (row * size).max(ui.spacing().interact_size.y)
}

/// Returns the size of verdicts below fields with text of this size.
pub(crate) fn small(size: f32) -> f32 {
    (size - 1.0).max(WRITTEN)
}

/// Shows the fields, each with what is said of it, and below them what may be typed, or is still missing.
pub(super) fn fields(ui: &mut Ui, context: &mut PageContext<'_>, size: f32, hides_said: bool) {
    let PageContext { session, step, .. } = context;
    let exercises = &mut session.exercises;
    ui.style_mut().override_font_id = Some(FontId::proportional(size));
    ui.spacing_mut().item_spacing.y = 0.0;
    let parts = exercises.question().parts.clone();
    let names = parts.iter().map(|part| format!("{} =", part.asked.symbol()));
    let indent = names.map(|name| text_width(ui, &name, FontId::proportional(size + 1.0)));
    let indent = indent.fold(0.0, f32::max);
    let (small, said) = (small(size), at_fields(exercises));
    let slot = Id::unique(("said below", exercises.question().exercise, exercises.seed()));
    let kept: Option<Vec<f32>> = ui.data(|data| data.get_temp(slot));
    // After a new start, nothing is said and nothing typed.
    let is_begun = exercises.answers.iter().any(|typed| {
        typed.feedback.is_some() || typed.fields.iter().any(|field| !field.is_empty())
    });
    let kept = kept.filter(|_| is_begun);
    let mut heights = kept.unwrap_or_else(|| vec![0.0; parts.len()]);
    let rows = parts.len() as f32 * row_of_fields(ui, size) + BEFORE_VERDICTS + row(ui);
    let (mut room, mut wants_check) = (ui.available_height() - rows, false);
    let is_wrong = |typed: &TypedAnswer| typed.feedback.as_ref().is_some_and(Feedback::is_wrong);
    let is_any_wrong = exercises.answers.iter().any(is_wrong);
    for (k, text) in said.into_iter().enumerate() {
        let feedback = exercises.answers[k].feedback.as_ref();
        let shown = feedback.and_then(|said| exercises.may_show(said));
        let mut said = text.filter(|_| !hides_said).map(|text| Said { text, shown, size: small });
        wants_check |= field_row(ui, exercises, k, &mut said, [indent, size]);
        // What is said of a right answer takes no room from what is said of the wrong ones.
        said = said.filter(|_| !is_any_wrong || is_wrong(&exercises.answers[k]));
        // An answer that was edited since the check has lost its sentence, but not the room, so that the
        // fields below it stay in place.
        if exercises.answers[k].feedback.is_some() {
            let whole = ui.available_width();
            let needed = said.as_ref().map_or(0.0, |said| said.height(ui, whole));
            let is_first = heights[..k].iter().all(|height| *height == 0.0);
            heights[k] = if needed <= room + 1.0 || is_first { needed } else { 0.0 };
        }
        room -= heights[k];
        let end = ui.cursor().top() + heights[k];
        if let Some(said) = said.filter(|_| heights[k] > 0.0) {
            said.ui(ui, exercises);
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
        note(ui, session, small, [has_room, step.is_some(), wants_check]);
    }
}

/// Shows the fields of part `k` of the question and, behind them, the sign of the verdict and what is said, if it
/// fits there. Returns whether Enter was pressed in a field.
fn field_row(
    ui: &mut Ui,
    exercises: &mut Exercises,
    k: usize,
    said: &mut Option<Said>,
    [indent, size]: [f32; 2],
) -> bool {
    let part = exercises.question().parts[k].clone();
    let row = vec2(ui.available_width(), row_of_fields(ui, size));
    let content = |ui: &mut Ui| {
        ui.set_min_size(row);
        let typed = &mut exercises.answers[k];
        let entered = answer(ui, &part, typed, indent);
        verdict(ui, &part, typed);
        let is_wrong = typed.feedback.as_ref().is_some_and(Feedback::is_wrong);
        let color = if is_wrong { error_color(ui) } else { ui.visuals().text_color() };
        *said =
            said.take().map(|said| Said { text: said.text.size(said.size).color(color), ..said });
        let width = ui.available_width();
        let fits = |said: &mut Said| width > SIGN && said.height(ui, width) <= row.y;
        if let Some(said) = said.take_if(fits) {
            said.ui(ui, exercises);
        }
        entered
    };
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), content).inner
}

/// What is said of an answer.
struct Said {
    text: RichText,
    /// The mistake of a camera that it names, which may be shown as a ghost.
    shown: Option<Mistake>,
    /// The size of the text, in points.
    size: f32,
}

impl Said {
    fn height(&self, ui: &Ui, width: f32) -> f32 {
        let button = self.shown.map_or("", |_| SHOW_ME[1]);
        marked_text::height_within(ui, &format!("{}{button}", self.text.text()), self.size, width)
    }

    /// Shows the sentence and, if it names a mistake of a camera, the button that shows the camera as a ghost in
    /// the figure.
    fn ui(self, ui: &mut Ui, exercises: &Exercises) {
        let label = Label::new(self.text).wrap();
        let Some(mistake) = self.shown else { return drop(ui.add(label)) };
        ui.horizontal_wrapped(|ui| {
            ui.add(label);
            let is_shown = exercises.shown_mistake == self.shown;
            let text = RichText::new(SHOW_ME[0]).size(self.size).underline();
            let hint =
                "Draws the camera with this mistake, from the question's numbers, in the figure";
            let button = egui::Button::selectable(is_shown, text).small();
            let response = ui.add(button).named(format!("Show me: {}", mistake.name()));
            response.on_hover_text(hint).asks(LookAction::ShowMe(mistake));
        });
    }
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
    let feedback = exercises.answers.iter().filter_map(|typed| typed.feedback.as_ref());
    let has_several = feedback.filter(|said| said.is_no_number()).count() > 1;
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
fn answer(ui: &mut Ui, part: &QuestionPart, typed: &mut TypedAnswer, indent: f32) -> bool {
    let size = text_size(ui);
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
            let exercise = exercises.question().exercise;
            let (text, hint) = match exercises.saw_solution && !progress.is_done(exercise) {
                true => ("All correct, after the solution.", "New numbers give it a tick"),
                false => ("All correct.", ""),
            };
            let label = ui.label(RichText::new(text).strong());
            if !hint.is_empty() {
                label.on_hover_text(hint);
            }
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
