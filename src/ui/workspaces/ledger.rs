//! The derivation of every number, beside both views or alone.

use egui::Ui;

use super::workspace::{Desk, Workspace};
use crate::figures::Subject;
use crate::model::session::{Session, Split};
use crate::ui::changed::Changed;

pub(super) const LEDGER: Workspace = Workspace {
    areas: |divider| divider.stack_beside(Split::Ledger, "ledger handle"),
    rest: derivation,
    pointed: |ctx, tools, _| tools.ledger.pointed(ctx),
    figure: Subject::Ledger,
    ..Workspace::VIEWS
};

pub(super) const ALONE: Workspace = Workspace { areas: |divider| divider.no_views(), ..LEDGER };

fn derivation(ui: &mut Ui, desk: &mut Desk<'_>) -> Changed {
    let Some(ledger) = &desk.derived.ledger else { return Changed::NOTHING };
    let lit = desk.session.lit();
    let Session { sections, pointed, .. } = &mut *desk.session;
    Changed::in_session(sections, |sections| {
        desk.tools.ledger.ui(ui, ledger, sections, *pointed, lit);
    })
}
