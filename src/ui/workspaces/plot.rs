//! Both views, and every object's f(p + t d) against t below them.

use super::page::Page;
use crate::model::session::{Session, Split};
use crate::ui::ray::plot;

pub(super) const PLOT: Page = Page {
    follows_pointer: true,
    areas: |divider| divider.both_above(Split::Plot),
    rest: |ui, desk| {
        let Session { ray_point_t, settings, .. } = &mut *desk.session;
        let compressed = &mut settings.plot_compressed;
        plot::ui(ui, ray_point_t, compressed, desk.derived, desk.style.digits);
    },
    hovered: |ctx, _, derived| plot::hovered(ctx, derived),
    ..Page::VIEWS
};
