//! The camera in other programs' terms, beside both views.

use super::workspace::Workspace;
use crate::model::session::Split;
use crate::ui::changed::Changed;

pub(super) const TRANSLATOR: Workspace = Workspace {
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: |ui, desk| {
        let before = desk.session.translator.clone();
        desk.tools.translator.ui(ui, &desk.open.document, desk.session, desk.actions);
        Changed::SESSION.when(desk.session.translator != before)
    },
    ..Workspace::VIEWS
};
