//! The scene with a student's answer beside the right one, the camera's picture, and where the answers
//! are wrong in it.

use egui::Ui;

use super::page::{Beside, Desk, Frame, Page};
use crate::figures::Subject;
use crate::model::session::Split;
use crate::ui::practice::answers;
use crate::ui::scene::views;

pub(super) const ANSWERS: Page = Page {
    areas: |divider| divider.three_above(Split::Answers),
    beside: Some(&Beside {
        name: views::ANSWERS,
        derive: |sizes, size| sizes.answers = Some(size),
        show: map,
    }),
    rest: |ui, desk| answers::ui(ui, desk.derived, desk.session, desk.actions),
    figure: Subject::Camera,
    ..Page::VIEWS
};

fn map(ui: &mut Ui, desk: &mut Desk<'_>, Frame { area, rect }: Frame) {
    let derived = desk.derived;
    let has_map = derived.answers_view.is_some();
    answers::strip(ui, area, desk.session.answers.as_ref(), has_map);
    views::speak(ui, views::ANSWERS, &answers::spoken(derived, desk.session));
    match &derived.answers_view {
        Some(shown) => desk.picture(ui, rect, shown, false),
        None => answers::no_map(ui, rect, derived, desk.session),
    }
}
