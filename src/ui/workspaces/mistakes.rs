//! The scene with a classic wrong camera in it as a ghost, the right picture, and the wrong one.

use egui::Ui;

use super::page::{Beside, Desk, Frame, Page};
use crate::figures::Subject;
use crate::model::session::Split;
use crate::ui::practice::mistakes;
use crate::ui::scene::views;

pub(super) const MISTAKES: Page = Page {
    areas: |divider| divider.three_above(Split::Mistakes),
    beside: Some(&Beside {
        name: views::WRONG,
        derive: |sizes, size| sizes.wrong = Some(size),
        show: wrong_camera,
    }),
    rest: |ui, desk| {
        let view = &mut desk.session.mistakes_view;
        mistakes::ui(ui, desk.derived, &desk.open.document, view, desk.style);
    },
    figure: Subject::Camera,
    ..Page::VIEWS
};

fn wrong_camera(ui: &mut Ui, desk: &mut Desk<'_>, Frame { area, rect }: Frame) {
    let derived = desk.derived;
    mistakes::strip(ui, area, &mut desk.session.mistakes_view);
    let Some(wrong) = &derived.wrong else { return };
    let mistakes_view = &desk.session.mistakes_view;
    views::speak(ui, views::WRONG, &mistakes::spoken(wrong, mistakes_view));
    match &derived.wrong_view {
        Some(shown) => desk.picture(ui, rect, shown, derived.fault.is_some()),
        None => mistakes::no_picture(ui, rect, wrong, mistakes_view),
    }
}
