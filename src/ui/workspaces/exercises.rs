//! Questions with fields for the answers, and their scenes.

use super::page::Page;
use crate::ui::practice::exercises;

pub(super) const EXERCISES: Page = Page {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| {
        exercises::ui(ui, desk.session, &mut desk.tools.question, desk.actions);
    },
    ..Page::VIEWS
};
