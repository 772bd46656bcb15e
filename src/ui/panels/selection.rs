//! Fields for the selected ray: row and column, or (u, v).

use egui::{Grid, Ui};
use pinhole_core::{Pixel, ResolvedCamera, Selection};

use crate::ui::widgets::Spoken as _;
use crate::ui::widgets::number::NumberField;

/// Edits the selection of a valid camera.
pub(crate) fn ui(
    ui: &mut Ui,
    selection: &mut Selection,
    resolved: Option<&ResolvedCamera>,
    count_from_one: bool,
) {
    let Some(resolved) = resolved else {
        ui.weak("The camera sees nothing, so there is no ray.");
        return;
    };
    *selection = selection.inside(resolved.image());
    let uv = selection.uv(resolved);
    let position = resolved.pixel_of_uv(uv);
    // A point on an edge or corner belongs to no single pixel.
    let (inside, known) = match *selection {
        Selection::Pixel(pixel) => (Some(pixel), true),
        Selection::Uv(_) => (
            position.map(|position| position.pixel),
            position.is_some_and(|position| position.only_pixel().is_some()),
        ),
    };
    Grid::new("selected ray").num_columns(4).show(ui, |ui| {
        let from = u32::from(count_from_one);
        let mut pixel = inside.unwrap_or(Pixel { row: 0, column: 0 });
        let image = resolved.image();
        let row = index_field(ui, "row", &mut pixel.row, image.height(), from, known);
        let column = index_field(ui, "column", &mut pixel.column, image.width(), from, known);
        ui.end_row();
        if row || column {
            *selection = Selection::Pixel(pixel);
        }
        let mut typed = uv;
        ui.label("u");
        let u = NumberField::new("uv u", &mut typed.x).show(ui).changed();
        ui.label("v");
        let v = NumberField::new("uv v", &mut typed.y).show(ui).changed();
        ui.end_row();
        if u || v {
            *selection = Selection::Uv(typed);
        }
    });
}

/// Shows a field for a row or column, with a dash if the ray passes outside the image or between
/// pixels. Returns true if it changed.
fn index_field(
    ui: &mut Ui,
    name: &str,
    index: &mut u32,
    count: u32,
    from: u32,
    known: bool,
) -> bool {
    ui.label(name);
    let mut shown = *index + from;
    let field = egui::DragValue::new(&mut shown)
        .range(from..=count - 1 + from)
        .speed(0.2)
        .update_while_editing(false)
        .custom_formatter(|index, _| if known { index.to_string() } else { "–".to_owned() });
    let response =
        ui.add(field.min_size(egui::vec2(78.0, ui.spacing().interact_size.y))).named(name);
    *index = shown - from;
    response.changed()
}
