//! Both views, and every object's f(p + t d) against t below them.

use super::workspace::Workspace;
use crate::model::session::Split;
use crate::ui::changed::Changed;
use crate::ui::ray::plot;

pub(super) const PLOT: Workspace = Workspace {
    areas: |divider| divider.both_above(Split::Plot),
    rest: |ui, desk| {
        let session = &mut *desk.session;
        let before = (session.ray_point_t, session.settings.plot_compressed);
        plot::ui(ui, session, desk.derived, desk.style.digits);
        Changed::SESSION.when(before != (session.ray_point_t, session.settings.plot_compressed))
    },
    hovered: |ctx, _, derived| plot::hovered(ctx, derived),
    ..Workspace::VIEWS
};
