//! The pen of presenter mode: it draws over everything below the lesson's text.

use egui::epaint::PathStroke;
use egui::{Area, Color32, CursorIcon, Order, Pos2, Rect, Sense, Ui, Vec2, vec2};

use crate::model::session::pen::Pen;
use crate::ui::widgets::Spoken as _;

/// Name of the area that is drawn on, for screen readers.
pub(crate) const NAME: &str = "Pen";
/// Width of a line and of its casing, and radius of the pointer, in points.
const LINE: f32 = 3.0;
const CASING: f32 = 5.0;
const POINTER: f32 = 5.0;
/// Colour of what is drawn: nothing that the views draw has it.
const INK: Color32 = Color32::from_rgb(0xff, 0xe6, 0x00);

/// Takes what the mouse draws on `area`, and shows it with a pointer that the back row sees.
pub(crate) fn ui(ui: &Ui, area: Rect, pen: &mut Pen) {
    let id = ui.scope_id().with(NAME);
    Area::new(id).order(Order::Foreground).fixed_pos(area.min).constrain(false).show(
        ui.ctx(),
        |ui| {
            let (_, response) = ui.allocate_exact_size(area.size(), Sense::drag());
            let response = response.named(NAME).on_hover_cursor(CursorIcon::Crosshair);
            let share = |at: Pos2| ((at - area.min) / area.size().max(Vec2::splat(1.0))).into();
            let at = response.interact_pointer_pos();
            if let (true, Some(from)) =
                (response.drag_started(), ui.input(|i| i.pointer.press_origin()))
            {
                pen.press(share(from));
            }
            if let (true, Some(at)) = (response.dragged(), at) {
                pen.draw_to(share(at));
            }
            for (width, color) in [(CASING, Color32::BLACK), (LINE, INK)] {
                for line in &pen.lines {
                    let at = |&[x, y]: &[f32; 2]| area.min + vec2(x, y) * area.size();
                    let points = line.iter().map(at).collect();
                    ui.painter().line(points, PathStroke::new(width, color));
                }
            }
            if let Some(at) = at.or(response.hover_pos()) {
                ui.painter().circle(at, POINTER, INK, (CASING - LINE, Color32::BLACK));
            }
        },
    );
}
