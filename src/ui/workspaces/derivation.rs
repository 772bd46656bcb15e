//! The derivation of every number, beside both views or alone.

use egui::Ui;

use super::page::{Desk, Page};
use crate::figures::Subject;
use crate::model::session::Split;

pub(super) const DERIVATION: Page = Page {
    follows_pointer: true,
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: derivation,
    hovered: |ctx, tools, _| tools.derivation.hovered(ctx),
    figure: Subject::Derivation,
    ..Page::VIEWS
};

pub(super) const ALONE: Page = Page { areas: |divider| divider.no_views(), ..DERIVATION };

fn derivation(ui: &mut Ui, desk: &mut Desk<'_>) {
    let Some(derivation) = &desk.derived.derivation else { return };
    let (session, actions) = (&mut *desk.session, &mut *desk.actions);
    desk.tools.derivation.ui(ui, derivation, &desk.open.document, session, actions);
}
