//! The scene's spheres and planes: a list to choose from, and the chosen one's fields.

use egui::{Button, RichText, ScrollArea, Ui};
use pinhole_core::{Camera, DVec2, DVec3, ObjectError, Plane, Rgb, Sphere};

use super::look;
use super::number::{NumberField, error_color, vector_row};
use crate::document::{Document, Item};
use crate::formats::molecule;
use crate::letters::told;

/// Rows of the list that are visible at once.
const LIST_ROWS: f32 = 6.0;

/// Edits the objects; `chosen` is the index of the one whose fields are shown.
pub(crate) fn ui(ui: &mut Ui, document: &mut Document, chosen: &mut usize) {
    ui.horizontal(|ui| {
        ui.heading("Objects");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button("+ Plane").on_hover_text("Add a plane").clicked() {
                let plane = Plane { point: DVec3::new(0.0, -1.0, 0.0), normal: DVec3::Y };
                document.planes.push(Item::plain(plane));
                *chosen = document.sphere_count() + document.planes.len() - 1;
            }
            if ui.button("+ Sphere").on_hover_text("Add a sphere").clicked() {
                document.spheres.push(Item::plain(new_sphere(&document.camera)));
                *chosen = document.spheres.len() - 1;
            }
        });
    });
    if document.object_count() == 0 {
        ui.weak("Nothing to see yet: add a sphere or a plane.");
        return;
    }
    *chosen = (*chosen).min(document.object_count() - 1);
    list(ui, document, chosen);
    ui.add_space(4.0);
    editor(ui, document, *chosen);
}

/// A sphere that the camera sees, in the upper right quarter of the picture.
fn new_sphere(camera: &Camera) -> Sphere {
    let Ok(posed) = camera.posed() else {
        return Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    };
    let viewport = posed.viewport();
    let ray = posed.ray(DVec2::new(0.25 * viewport.width, 0.25 * viewport.height));
    // Four viewport distances away, a tenth of the picture high.
    Sphere { center: ray.at(4.0), radius: 4.0 * 0.1 * viewport.height }
}

fn list(ui: &mut Ui, document: &Document, chosen: &mut usize) {
    let row_height = ui.spacing().interact_size.y;
    ScrollArea::vertical()
        .id_salt("objects")
        .max_height(LIST_ROWS * (row_height + ui.spacing().item_spacing.y))
        .auto_shrink([false, true])
        .show_rows(ui, row_height, document.object_count(), |ui, rows| {
            for index in rows {
                ui.horizontal(|ui| {
                    swatch(ui, look::object_color(ui, document, index as u32));
                    // A long name is cut off: it may not widen the panel.
                    let title = document.title_of(index);
                    let label = ui.add(Button::selectable(*chosen == index, title).truncate());
                    if label.clicked() {
                        *chosen = index;
                    }
                });
            }
        });
}

fn swatch(ui: &mut Ui, [r, g, b]: Rgb) {
    let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 3.0, egui::Color32::from_rgb(r, g, b));
}

fn editor(ui: &mut Ui, document: &mut Document, index: usize) {
    let spheres = document.spheres.len();
    let first_plane = document.sphere_count();
    let color = document.color_of(index as u32);
    if index < spheres {
        if heading(ui, &mut document.spheres[index], color) {
            document.spheres.remove(index);
            return;
        }
        sphere(ui, &mut document.spheres[index].shape);
    } else if index < first_plane {
        let file = document.csv_spheres.as_ref().map_or("", |csv| csv.path.as_str());
        let row = if molecule::is_molecule(file.as_ref()) { "atom" } else { "row" };
        ui.label(format!(
            "Sphere {index} is {row} {} of {file}: edit it there.",
            index - spheres + 1
        ));
    } else {
        let item = &mut document.planes[index - first_plane];
        if heading(ui, item, color) {
            document.planes.remove(index - first_plane);
            return;
        }
        plane(ui, &mut item.shape);
    }
}

/// Name, colour (`shown` in the views) and the remove button; whether that was clicked.
fn heading<S>(ui: &mut Ui, item: &mut Item<S>, shown: Rgb) -> bool {
    ui.horizontal(|ui| {
        let mut color = shown;
        let response = ui.color_edit_button_srgb(&mut color);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("color"));
        if response.changed() {
            item.color = Some(color);
        }
        let mut name = item.name.clone().unwrap_or_default();
        let field = egui::TextEdit::singleline(&mut name).hint_text("name").desired_width(150.0);
        let response = ui.add(field);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("name"));
        if response.changed() {
            item.name = (!name.is_empty()).then_some(name);
        }
        ui.button("Remove").clicked()
    })
    .inner
}

fn sphere(ui: &mut Ui, sphere: &mut Sphere) {
    let fault = sphere.check().err();
    ui.horizontal(|ui| {
        ui.label("centre");
        vector_row(ui, "centre", &mut sphere.center);
    });
    ui.horizontal(|ui| {
        ui.label("radius");
        NumberField::new("radius", &mut sphere.radius).show(ui);
    });
    reason(ui, fault);
}

fn plane(ui: &mut Ui, plane: &mut Plane) {
    let fault = plane.check().err();
    ui.horizontal(|ui| {
        ui.label("point");
        vector_row(ui, "point", &mut plane.point);
    });
    ui.horizontal(|ui| {
        ui.label("normal");
        vector_row(ui, "normal", &mut plane.normal);
    });
    reason(ui, fault);
}

fn reason(ui: &mut Ui, fault: Option<ObjectError>) {
    if let Some(fault) = fault {
        ui.label(RichText::new(told(fault)).color(error_color(ui)));
    }
}
