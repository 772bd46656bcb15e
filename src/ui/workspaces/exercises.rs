//! Questions with fields for the answers.

use super::workspace::Workspace;
use crate::ui::changed::Changed;
use crate::ui::practice::exercises;

pub(super) const EXERCISES: Workspace = Workspace {
    has_panel: false,
    areas: |divider| divider.no_views(),
    rest: |ui, desk| {
        Changed::in_session(&mut desk.session.exercises, |exercises| {
            exercises::ui(ui, exercises, desk.style, desk.actions);
        })
    },
    ..Workspace::VIEWS
};
