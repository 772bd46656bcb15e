//! Questions with fields for the answers, and their scenes.

use super::page::Page;
use crate::ui::changed::Changed;
use crate::ui::practice::exercises;

pub(super) const EXERCISES: Page = Page {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| {
        let before = desk.session.exercises.clone();
        exercises::ui(ui, desk.session, &mut desk.tools.question, desk.actions);
        Changed::SESSION.when(desk.session.exercises != before)
    },
    ..Page::VIEWS
};
