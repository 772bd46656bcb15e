//! Both views, and every object's f(p + t d) against t below them.

use super::workspace::Workspace;
use crate::model::session::Split;
use crate::ui::ray::plot;

pub(super) const PLOT: Workspace = Workspace {
    areas: |divider| divider.both_above(Split::Plot),
    rest: |ui, desk| plot::ui(ui, desk.session, desk.derived, desk.style.digits),
    hovered: |ctx, _, derived| plot::hovered(ctx, derived),
    ..Workspace::VIEWS
};
