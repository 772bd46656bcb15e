//! Walking along the selected ray by dragging its point in the world view.

use egui::{Pos2, Response, Ui};

use crate::view::derive::Derived;
use crate::view::overlay;

/// Maximum distance from the point at which the mouse grabs it, in points.
const GRASP: f32 = 14.0;

/// Returns the t to which the walking point is dragged; `None` if it is not dragged.
pub(crate) fn dragged(
    ui: &Ui,
    response: &Response,
    ray_point_t: Option<f64>,
    shown: &Derived,
) -> Option<f64> {
    let (t, frame) = (ray_point_t?, shown.world_frame.as_deref()?);
    let ray = shown.inspection.as_deref()?.ray;
    let key = response.id.with("walks");
    let per_point = ui.ctx().pixels_per_point();
    let in_dots = |at: Pos2| ((at - response.rect.min) * per_point).into();
    if response.drag_started() {
        let pressed = ui.input(|i| i.pointer.press_origin())?;
        let on_screen = overlay::world_position_of(frame, ray.at(t));
        let near = |[x, y]: [f32; 2]| {
            let at = response.rect.min + egui::vec2(x, y) / per_point;
            at.distance(pressed) <= GRASP
        };
        ui.data_mut(|data| data.insert_temp(key, on_screen.is_some_and(near)));
    }
    let walks = ui.data(|data| data.get_temp(key)).unwrap_or(false);
    if !walks || !response.dragged_by(egui::PointerButton::Primary) {
        return None;
    }
    let pointer = response.interact_pointer_pos()?;
    // The point stays if the ray runs towards the observer.
    Some(overlay::t_towards(frame, &ray, in_dots(pointer)).unwrap_or(t))
}
