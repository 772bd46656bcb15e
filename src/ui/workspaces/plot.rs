//! Both views, and every object's f(p + t d) against t below them.

use super::page::Page;
use crate::model::session::{Session, Split};
use crate::ui::changed::Changed;
use crate::ui::ray::plot;

pub(super) const PLOT: Page = Page {
    follows_pointer: true,
    areas: |divider| divider.both_above(Split::Plot),
    rest: |ui, desk| {
        let Session { ray_point_t, settings, .. } = &mut *desk.session;
        let mut shown = (*ray_point_t, settings.plot_compressed);
        let changed = Changed::edited(&mut shown, |(ray_point_t, compressed)| {
            plot::ui(ui, ray_point_t, compressed, desk.derived, desk.style.digits);
        });
        (*ray_point_t, settings.plot_compressed) = shown;
        changed
    },
    hovered: |ctx, _, derived| plot::hovered(ctx, derived),
    ..Page::VIEWS
};
