//! The camera in other programs' terms, beside both views.

use super::page::Page;
use crate::model::session::{Session, Split};
use crate::ui::changed::Changed;

pub(super) const TRANSLATOR: Page = Page {
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: |ui, desk| {
        let document = &desk.open.document;
        let Session { translator, selection, settings, .. } = &mut *desk.session;
        Changed::edited(translator, |choice| {
            let panel = &mut desk.tools.translator;
            panel.ui(ui, document, choice, *selection, settings.digits, desk.actions);
        })
    },
    ..Page::VIEWS
};
