//! The world view and the camera view, both or one of them, and the selected ray in numbers.

use egui::Ui;

use super::workspace::{Desk, Workspace};
use crate::figures::Subject;
use crate::ui::changed::Changed;
use crate::ui::scene::readouts;
use crate::ui::scene::view_rects::Areas;

pub(super) const BOTH: Workspace = Workspace {
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        divider.both(views, rest)
    },
    rest: numbers,
    ..Workspace::VIEWS
};

pub(super) const WORLD: Workspace = Workspace {
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        Areas { world: Some(views), camera: None, beside: None, rest }
    },
    rest: numbers,
    ..Workspace::VIEWS
};

pub(super) const CAMERA: Workspace = Workspace {
    areas: |divider| {
        let (views, rest) = divider.above_readouts();
        Areas { world: None, camera: Some(views), beside: None, rest }
    },
    rest: numbers,
    figure: Subject::Camera,
    ..Workspace::VIEWS
};

fn numbers(ui: &mut Ui, desk: &mut Desk<'_>) -> Changed {
    if desk.session.presenting.is_none() {
        readouts::ui(ui, desk.derived, &desk.open.document, desk.style);
    }
    Changed::NOTHING
}
