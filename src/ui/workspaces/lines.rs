//! The lab of lines in two dimensions.

use super::workspace::Workspace;
use crate::figures::Subject;
use crate::ui::ray::lines;

pub(super) const LINES: Workspace = Workspace {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| lines::ui(ui, &mut desk.session.lines, desk.style.digits),
    figure: Subject::Lines,
    ..Workspace::VIEWS
};
