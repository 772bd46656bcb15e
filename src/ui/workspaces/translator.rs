//! The camera in other programs' terms, beside both views.

use super::workspace::Workspace;
use crate::model::session::Split;

pub(super) const TRANSLATOR: Workspace = Workspace {
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: |ui, desk| {
        desk.tools.translator.ui(ui, &desk.open.document, desk.session, desk.actions);
    },
    ..Workspace::VIEWS
};
