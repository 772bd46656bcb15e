//! The camera in other programs' terms, beside both views.

use super::page::Page;
use crate::model::session::{Session, Split};

pub(super) const TRANSLATOR: Page = Page {
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: |ui, desk| {
        let document = &desk.open.document;
        let Session { translator, selection, settings, .. } = &mut *desk.session;
        let panel = &mut desk.tools.translator;
        panel.ui(ui, document, translator, *selection, settings.digits, desk.actions);
    },
    ..Page::VIEWS
};
