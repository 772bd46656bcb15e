//! The lab of lines in two dimensions.

use super::page::Page;
use crate::figures::Subject;
use crate::ui::changed::Changed;
use crate::ui::ray::lines;

pub(super) const LINES: Page = Page {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| {
        Changed::edited(&mut desk.session.lines, |lab| lines::ui(ui, lab, desk.style.digits))
    },
    asked: |ui, desk| lines::asked(ui, &desk.session.lines),
    figure: Subject::Lines,
    ..Page::VIEWS
};
