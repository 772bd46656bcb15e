//! The gizmo of the world view: the world's axes as the observer sees them. A click on an axis looks along it.

use egui::accesskit::Role;
use egui::{Align2, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, pos2, vec2};
use pinhole_core::{Basis, DVec3};
use pinhole_figure::observer::WorldAxis;
use pinhole_figure::typesetting::theme;

use super::view_rects::STRIP;
use crate::ui::action::Observe;
use crate::ui::widgets::ResponseExt as _;

/// The axes, each with its letter and the view along it.
const AXES: [(WorldAxis, &str, &str); 3] = [
    (WorldAxis::X, "x", "Look along x, from the side"),
    (WorldAxis::Y, "y", "Look along y, from above"),
    (WorldAxis::Z, "z", "Look along z, from the front"),
];

/// Length of an axis, in points.
const LENGTH: f32 = 26.0;
/// Radius of the disc at the end of an axis, in points.
const RADIUS: f32 = 9.0;
/// Distance of the gizmo from the edges of the world view and from its title, in points.
const MARGIN: f32 = 6.0;
/// Minimum size of a world view that has a gizmo, in points.
const LEAST: f32 = 240.0;

/// Returns the rectangle of the gizmo in the upper right corner of a world view; `None` if the view is too small,
/// or if the pointer is a finger, which would miss its discs.
pub(crate) fn area(ui: &Ui, world: Rect) -> Option<Rect> {
    let size = Vec2::splat(2.0 * (LENGTH + RADIUS));
    let corner = pos2(world.right() - MARGIN, world.top() + STRIP + MARGIN);
    let area = Rect::from_min_size(corner - vec2(size.x, 0.0), size);
    let by_touch = theme::installed(ui.ctx()).by_touch;
    (world.size().min_elem() >= LEAST && !by_touch).then_some(area)
}

/// Shows the gizmo for an observer with this basis.
pub(crate) fn show(ui: &Ui, area: Rect, basis: &Basis) {
    let directions = DVec3::AXES.map(|axis| basis.to_camera_from_world(axis));
    let end = |axis: DVec3| area.center() + LENGTH * vec2(axis.x as f32, -axis.y as f32);
    let mut axes: Vec<_> = AXES.into_iter().zip(directions).enumerate().collect();
    // The nearest axis is drawn last.
    axes.sort_by(|(_, (_, a)), (_, (_, b))| a.z.total_cmp(&b.z));
    let ends: Vec<Pos2> = axes.iter().map(|(_, (_, direction))| end(*direction)).collect();
    let colors = theme::style(ui).colors();
    let painter = ui.painter();
    for (place, (k, ((axis, letter, about), _))) in axes.into_iter().enumerate() {
        let (end, stroke) = (ends[place], Stroke::new(2.0, colors.axes[k]));
        painter.line_segment([area.center(), end], stroke);
        // What a nearer axis covers cannot be clicked.
        if ends[place + 1..].iter().any(|nearer| nearer.distance(end) < 2.0 * RADIUS) {
            continue;
        }
        let disc = Rect::from_center_size(end, Vec2::splat(2.0 * RADIUS));
        let response = ui.interact(disc, ui.scope_id().with(("gizmo", letter)), Sense::click());
        let is_marked = response.hovered() || response.has_focus();
        let [fill, ink] = match is_marked {
            true => [colors.axes[k], colors.background],
            false => [colors.background, colors.axes[k]],
        };
        painter.circle(end, RADIUS, fill, stroke);
        painter.text(end, Align2::CENTER_CENTER, letter, FontId::proportional(13.0), ink);
        response
            .with_role(Role::Button)
            .named(about)
            .described("A second click looks from the other side.")
            .on_hover_text(format!("{about}; again, from the other side"))
            .asks(Observe::Along(axis));
    }
}
