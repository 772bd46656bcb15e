//! The page about a student's answers: a map of the right and wrong answers, next to the camera's picture.
//! Below the pictures are the number of right answers, the worst answer, and the mistake that explains the
//! errors.

use egui::{Align, Layout, Rect, RichText, ScrollArea, Sense, Stroke, StrokeKind, Ui, vec2};
use pinhole_core::Selection;
use pinhole_figure::overlay::opaque;
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::typesetting::theme::error_color;
use pinhole_lecture::grading::{Cell, Graded};

use crate::model::Session;
use crate::ui::PageContext;
use crate::ui::action::{Action, AnswersAction, FileUse, LookAction};
use crate::ui::scene::view_rects::strip_above;
use crate::ui::widgets::{ResponseExt as _, sign};
use crate::view::derive::{Derived, SecondPicture};

/// Size of the text, in points.
const TEXT: f32 = 15.0;

/// Width of the map, in points, below which its title is only the file's name.
const NARROW: f32 = 440.0;
/// Width of the map, in points, below which the legend omits missing answers.
const NARROWEST: f32 = 330.0;

/// Text that is shown if there are no answers.
const NONE: &str = "Drop a student's answers on the window: CSV with the columns of a basis, of rays or of \
                    hits, or a picture as PNG.";

/// Shows the name of the answers as the title above the map.
pub(crate) fn strip(ui: &mut Ui, area: Rect, session: &Session, map: Option<&Graded>) {
    strip_above(ui, area, |ui| {
        let title = match &session.answers {
            Some(answers) if area.width() < NARROW => answers.name(),
            Some(answers) => format!("{}: {}", SecondPicture::Answers.name(), answers.name()),
            None => SecondPicture::Answers.name().to_owned(),
        };
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if let Some(graded) = map {
                legend(ui, area.width() >= NARROWEST, !graded.grade.not_judged.is_empty());
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(title).strong()).truncate());
            });
        });
    });
}

/// Shows the legend of the map's colours, from right to left. On a narrow map, it omits the colour of
/// missing answers.
fn legend(ui: &mut Ui, whole: bool, has_doubt: bool) {
    let cells = [
        (Cell::Unanswered, "not answered", whole),
        (Cell::NotJudged, "not judged", has_doubt),
        (Cell::Wrong, "wrong", true),
        (Cell::Right, "right", true),
    ];
    for (cell, text, _) in cells.into_iter().filter(|(.., is_shown)| *is_shown) {
        ui.label(text);
        let (rect, _) = ui.allocate_exact_size(vec2(12.0, 12.0), Sense::hover());
        let outline = Stroke::new(1.0, ui.visuals().weak_text_color());
        ui.painter().rect(rect, 2.0, opaque(cell.color()), outline, StrokeKind::Inside);
    }
}

/// Returns the description of the map for screen readers.
pub(crate) fn spoken(derived: &Derived, session: &Session) -> String {
    match derived.grading.as_ref().filter(|_| session.answers.is_some()) {
        Some(Err(error)) => error.to_string(),
        Some(Ok(graded)) => format!("{}. {}", graded.agreement(), graded.advice()),
        None => why_not(derived, session).to_owned(),
    }
}

/// Returns the reason why there is no map. Answers are not graded while the scene is invalid, nor, if grading
/// takes long, while the user is dragging something.
pub(crate) fn why_not(derived: &Derived, session: &Session) -> &'static str {
    match (derived.grading.as_ref(), derived.fault) {
        _ if session.answers.is_none() => NONE,
        (None, Some(_)) => "The scene is invalid, so the answers cannot be checked.",
        (None, None) => "The answers are checked when you release the mouse button.",
        (Some(Err(_)), _) => "These answers cannot be read.",
        (Some(Ok(_)), _) => "Answers about a basis have no map.",
    }
}

/// Shows the result of grading, and the buttons for the answers.
pub(crate) fn ui(ui: &mut Ui, PageContext { session, derived, .. }: &mut PageContext<'_>) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    buttons(ui, session);
    ui.add_space(4.0);
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        if session.answers.is_none() {
            return;
        }
        match derived.grading.as_ref() {
            None => drop(ui.strong(why_not(derived, session))),
            Some(Err(error)) => {
                ui.label(RichText::new(&**error).strong().color(error_color(ui)));
            }
            Some(Ok(graded)) => found(ui, graded, &mut session.shown.selection),
        }
    });
}

fn buttons(ui: &mut Ui, session: &mut Session) {
    ui.horizontal(|ui| {
        ui.button("Check answers…").asks(FileUse::CheckAnswers);
        let Some(answers) = &mut session.answers else { return };
        let again = ui.button("Read again").on_hover_text("Reads the file as it is now");
        again.asks(Action::Use(FileUse::CheckAnswers, answers.file.path.clone()));
        ui.button("Close the answers").asks(AnswersAction::PutAway);
        if !answers.are_numbered() {
            return;
        }
        let mut from_one = answers.count_from == 1;
        let hint = "Its first row and column have the number 1, as in the course";
        if ui.checkbox(&mut from_one, "The file counts from 1").on_hover_text(hint).changed() {
            answers.count_from = u32::from(from_one);
        }
    });
}

fn found(ui: &mut Ui, graded: &Graded, selection: &mut Selection) {
    let grade = &graded.grade;
    ui.horizontal_top(|ui| {
        if grade.is_judged() {
            sign(ui, grade.passes());
        }
        ui.add(egui::Label::new(RichText::new(graded.agreement()).size(18.0).strong()).wrap());
    });
    for note in graded.notes() {
        ui.label(note);
    }
    if grade.wrong() == 0 {
        return;
    }
    if let Some(worst) = graded.worst() {
        ui.horizontal_top(|ui| {
            if let Some(pixel) = graded.worst_pixel()
                && ui.button("Select the worst pixel").clicked()
            {
                *selection = Selection::Pixel(pixel);
            }
            ui.add(egui::Label::new(typeset_message(format!("Worst: {worst}"))).wrap());
        });
    }
    ui.add_space(6.0);
    if grade.diagnosis.mistakes.is_empty() {
        ui.label(RichText::new(graded.advice()).size(17.0).strong());
        return;
    }
    let text = RichText::new(format!("Mistake: {}", graded.mistakes())).size(17.0).strong();
    ui.label(text.color(error_color(ui)));
    for mistake in &grade.diagnosis.mistakes {
        ui.label(typeset_message(graded.advice_on(*mistake)));
        if mistake.is_in_gallery() {
            let show = ui.button(format!("Show me: {}", mistake.name()));
            show.asks(LookAction::Mistake(*mistake));
        }
    }
    for remark in graded.remarks() {
        ui.label(remark);
    }
}
