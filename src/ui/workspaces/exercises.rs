//! Questions with fields for the answers.

use super::workspace::Workspace;
use crate::ui::practice::exercises;

pub(super) const EXERCISES: Workspace = Workspace {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| exercises::ui(ui, &mut desk.session.exercises, desk.style, desk.actions),
    ..Workspace::VIEWS
};
