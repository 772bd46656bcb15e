//! The derivation of every number, beside both views or alone.

use egui::Ui;

use super::workspace::{Desk, Workspace};
use crate::figures::Subject;
use crate::model::session::{Session, Split};

pub(super) const DERIVATION: Workspace = Workspace {
    areas: |divider| divider.stack_beside(Split::Derivation, "derivation handle"),
    rest: derivation,
    hovered: |ctx, tools, _| tools.derivation.hovered(ctx),
    figure: Subject::Derivation,
    ..Workspace::VIEWS
};

pub(super) const ALONE: Workspace = Workspace { areas: |divider| divider.no_views(), ..DERIVATION };

fn derivation(ui: &mut Ui, desk: &mut Desk<'_>) {
    let Some(derivation) = &desk.derived.derivation else { return };
    let highlighted = desk.session.highlighted();
    let Session { sections, hovered, .. } = &mut *desk.session;
    desk.tools.derivation.ui(ui, derivation, sections, *hovered, highlighted);
}
