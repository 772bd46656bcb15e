//! The lab of lines in two dimensions.

use super::page::Page;
use crate::figures::Subject;
use crate::ui::ray::lines;

pub(super) const LINES: Page = Page {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| lines::ui(ui, &mut desk.session.lines, desk.style.digits),
    asked: |ui, desk| lines::asked(ui, &desk.session.lines),
    figure: Subject::Lines,
    ..Page::VIEWS
};
