//! The world view and the camera view, both or one of them, and the selected ray in numbers.

use egui::{Align, Layout, Ui};

use super::page::{Desk, Page};
use crate::figures::Subject;
use crate::model::lessons::{StepId, Which};
use crate::model::overlay_items::Item;
use crate::model::session::ViewLayout;
use crate::ui::action::{Leave, LookAction};
use crate::ui::scene::readouts;
use crate::ui::scene::view_rects::Areas;
use crate::ui::widgets::asking::Asking as _;

pub(super) const BOTH: Page = Page {
    follows_pointer: true,
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        divider.both(views, rest)
    },
    rest: numbers,
    hovered: |ctx, _, _| readouts::hovered(ctx),
    ..Page::VIEWS
};

pub(super) const WORLD: Page = Page {
    follows_pointer: true,
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        Areas { world: Some(views), camera: None, second: None, rest }
    },
    rest: numbers,
    hovered: |ctx, _, _| readouts::hovered(ctx),
    ..Page::VIEWS
};

pub(super) const CAMERA: Page = Page {
    follows_pointer: true,
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        Areas { world: None, camera: Some(views), second: None, rest }
    },
    rest: numbers,
    hovered: |ctx, _, _| readouts::hovered(ctx),
    figure: Subject::Camera,
    ..Page::VIEWS
};

fn numbers(ui: &mut Ui, desk: &mut Desk<'_>) {
    let (derived, document, style) = (desk.derived, &desk.open.document, desk.style);
    if desk.session.presenting.is_some() {
        if desk.session.settings.presents_numbers {
            readouts::strip(ui, derived, document, style, true);
        }
        return;
    }
    let all = desk.session.settings.unfolded.numbers;
    let mut switched = false;
    ui.add_space(2.0);
    if all {
        switched = ui.small_button("Fewer numbers").clicked();
        readouts::ui(ui, derived, document, style);
    } else {
        readouts::strip(ui, derived, document, style, false);
        ui.horizontal(|ui| {
            let shows_all = desk.session.settings.items.shows(Item::ViewAndUp);
            let dragged = if shows_all { "eye, at or up" } else { "eye" };
            ui.weak(format!("Drag {dragged}. Click a pixel."));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                switched = ui.button("All numbers").clicked();
                if desk.has_lesson {
                    return;
                }
                ui.button("Present").asks(LookAction::Present, desk.actions);
                let exercises = LookAction::Layout(ViewLayout::Exercises);
                ui.button("Practise").asks(exercises, desk.actions);
                let lecture = StepId { lesson: Which::Builtin(0), step: 0 };
                ui.button("Start the lecture").asks(Leave::GoTo(lecture), desk.actions);
            });
        });
    }
    if switched {
        desk.session.settings.unfolded.numbers = !all;
    }
}
