//! Questions with fields for the answers.

use super::page::Page;
use crate::ui::changed::Changed;
use crate::ui::practice::exercises;

pub(super) const EXERCISES: Page = Page {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| {
        Changed::edited(&mut desk.session.exercises, |open| {
            exercises::ui(ui, open, desk.style, desk.actions);
        })
    },
    ..Page::VIEWS
};
