//! The scene's spheres and planes: a list to choose from, and the fields of the chosen object.

use egui::{Button, Response, ScrollArea, Ui};
use pinhole_core::{DVec2, DVec3, ObjectError, Plane, Rgb, Sphere};
use pinhole_exchange::document::{Document, Item, SharedList};
use pinhole_figure::typesetting::theme;

use crate::ui::action::ObjectAction;
use crate::ui::commands_table::hint;
use crate::ui::widgets::{NumberField, ResponseExt as _, fault_text, line_field, vector_row};

/// Number of rows of the list that are visible at once.
const LIST_ROWS: f32 = 6.0;

/// Edits the objects; `chosen` is the index of the object whose fields are shown, if any.
pub(crate) fn ui(ui: &mut Ui, document: &mut Document, chosen: &mut Option<usize>) {
    ui.horizontal(|ui| {
        for (text, add) in
            [("+ Sphere", ObjectAction::AddSphere), ("+ Plane", ObjectAction::AddPlane)]
        {
            ui.button(text).on_hover_text(hint(add)).asks(add);
        }
    });
    if document.object_count() == 0 {
        ui.weak("Nothing to see yet: add a sphere or a plane.");
        return;
    }
    *chosen = chosen.filter(|chosen| *chosen < document.object_count());
    list(ui, document, chosen);
    if let Some(index) = *chosen {
        ui.add_space(4.0);
        editor(ui, document, index);
    }
}

/// Adds a sphere that the camera sees. Returns its index.
pub(crate) fn add_sphere(document: &mut Document) -> usize {
    let sphere = new_sphere(document);
    document.spheres.push(Item::plain(sphere));
    document.spheres.len() - 1
}

/// Adds a plane below the origin. Returns its index.
pub(crate) fn add_plane(document: &mut Document) -> usize {
    let plane = Plane { point: DVec3::new(0.0, -1.0, 0.0), normal: DVec3::Y };
    document.planes.push(Item::plain(plane));
    document.sphere_count() + document.planes.len() - 1
}

/// Adds a copy of an object: of a sphere, beside it; of a plane, one unit in front of it. Returns its index.
///
/// # Errors
/// Returns an error if the object comes from a file of spheres.
pub(crate) fn duplicate(document: &mut Document, index: usize) -> Result<usize, String> {
    match place(document, index)? {
        Place::Sphere(index) => {
            let right = document.camera.resolve().map_or(DVec3::X, |camera| camera.basis().u);
            let mut copy = document.spheres[index].clone();
            let Sphere { center, radius } = copy.shape;
            // At the end of the range of numbers, the copy is in the same place.
            copy.shape = Sphere::new(center + 2.0 * radius * right, radius).unwrap_or(copy.shape);
            document.spheres.push(copy);
            Ok(document.spheres.len() - 1)
        }
        Place::Plane(index) => {
            let mut copy = document.planes[index].clone();
            copy.shape.point += copy.shape.normal.normalize_or_zero();
            document.planes.push(copy);
            Ok(document.object_count() - 1)
        }
    }
}

/// Deletes an object from the scene.
///
/// # Errors
/// Returns an error if the object comes from a file of spheres.
pub(crate) fn delete(document: &mut Document, index: usize) -> Result<(), String> {
    match place(document, index)? {
        Place::Sphere(index) => drop(document.spheres.remove(index)),
        Place::Plane(index) => drop(document.planes.remove(index)),
    }
    Ok(())
}

/// The place of an object in the document's list of its kind.
enum Place {
    Sphere(usize),
    Plane(usize),
}

/// Returns the place of an object, or a message that a sphere from a CSV file must be edited in that file.
fn place(document: &Document, index: usize) -> Result<Place, String> {
    if let Some(plane) = index.checked_sub(document.sphere_count()) {
        return Ok(Place::Plane(plane));
    }
    let Some(row) = index.checked_sub(document.spheres.len()) else {
        return Ok(Place::Sphere(index));
    };
    let file = document.csv_spheres.as_ref().map_or("", |csv| csv.path.as_str());
    Err(format!("Sphere {index} is row {} of {file}: edit it there.", row + 1))
}

/// The centres of the picture's quarters, as fractions of the viewport.
const QUARTERS: [[f64; 2]; 4] = [[0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25], [0.25, -0.25]];
/// The difference in t between new spheres that are placed one behind another; t is 1 on the viewport.
const BEHIND: f64 = 1.5;

/// Returns a new sphere that the camera sees. It is in the upper right quarter of the picture, or at the
/// next position where it touches no other sphere.
fn new_sphere(document: &Document) -> Sphere {
    let camera = document.camera.resolve().ok();
    let at = |k: usize| {
        let far = 4.0 + BEHIND * (k / QUARTERS.len()) as f64;
        let [x, y] = QUARTERS[k % QUARTERS.len()];
        let placed = camera.as_ref().and_then(|camera| {
            let viewport = camera.viewport();
            let ray = camera.ray(DVec2::new(x * viewport.width, y * viewport.height));
            // The diameter is a fifth of the picture's height.
            Sphere::new(ray.at(far), far * 0.1 * viewport.height).ok()
        });
        // With a viewport of 1e308, the sphere exceeds the range of numbers.
        placed.unwrap_or(Sphere { center: DVec3::new(0.0, 0.0, -1.0 - far), radius: 1.0 })
    };
    let is_free = |new: &Sphere| {
        let touches = |old: &Sphere| new.center.distance(old.center) <= new.radius + old.radius;
        !document.spheres.iter().any(|old| touches(&old.shape))
    };
    let most = QUARTERS.len() * (document.spheres.len() + 1);
    (0..most).map(at).find(is_free).unwrap_or_else(|| at(most))
}

fn list(ui: &mut Ui, document: &Document, chosen: &mut Option<usize>) {
    let row_height = ui.spacing().interact_size.y;
    let with_gap = row_height + ui.spacing().item_spacing.y;
    let shown = ui.scope_id().with("object that is in sight");
    let mut area = ScrollArea::vertical().id_salt("objects");
    let before = ui.data(|data| data.get_temp::<Option<usize>>(shown));
    if let (true, Some(chosen)) = (before.is_some_and(|before| before != *chosen), *chosen) {
        // The object was selected elsewhere: scroll it to the middle.
        let middle = chosen as f32 - 0.5 * (LIST_ROWS - 1.0);
        area = area.vertical_scroll_offset((with_gap * middle).max(0.0));
    }
    area.max_height(LIST_ROWS * with_gap).auto_shrink([false, true]).show_rows(
        ui,
        row_height,
        document.object_count(),
        |ui, rows| {
            for index in rows {
                ui.horizontal(|ui| {
                    swatch(ui, theme::object_color(ui, document, index as u32));
                    // Truncate a long name: it must not widen the panel.
                    let title = document.title_of(index);
                    let label =
                        ui.add(Button::selectable(*chosen == Some(index), title).truncate());
                    if label.clicked() {
                        *chosen = Some(index).filter(|_| *chosen != Some(index));
                    }
                });
            }
        },
    );
    ui.data_mut(|data| data.insert_temp(shown, *chosen));
}

fn swatch(ui: &mut Ui, [r, g, b]: Rgb) -> Response {
    let (rect, response) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 3.0, egui::Color32::from_rgb(r, g, b));
    response
}

/// Shows an object's fields.
fn editor(ui: &mut Ui, document: &mut Document, index: usize) {
    let own = document.color_of(index as u32);
    let shown = theme::object_color(ui, document, index as u32);
    match place(document, index) {
        Ok(Place::Sphere(index)) => edit(ui, &mut document.spheres, index, [own, shown], sphere),
        Ok(Place::Plane(index)) => edit(ui, &mut document.planes, index, [own, shown], plane),
        Err(elsewhere) => drop(ui.label(elsewhere)),
    }
}

/// Shows the fields of an object. Stores the object only if it has changed, because storing it copies the
/// list, which is shared with the undo history.
fn edit<S: Clone + PartialEq>(
    ui: &mut Ui,
    items: &mut SharedList<Item<S>>,
    index: usize,
    colors: [Rgb; 2],
    fields: fn(&mut Ui, &mut S) -> Result<(), ObjectError>,
) {
    let mut item = items[index].clone();
    heading(ui, &mut item, colors);
    if let Err(fault) = fields(ui, &mut item.shape) {
        ui.label(fault_text(ui, fault));
    }
    if items[index] != item {
        items[index] = item;
    }
}

/// Shows the name, the colour and the delete button. The object's colour can be edited unless the colour
/// scheme replaces it.
fn heading<S>(ui: &mut Ui, item: &mut Item<S>, [own, shown]: [Rgb; 2]) {
    ui.horizontal(|ui| {
        let mut color = own;
        if own != shown {
            let hint = "This colour scheme replaces the object's colour: edit it in another scheme";
            swatch(ui, shown).on_hover_text(hint);
        } else if ui.color_edit_button_srgb(&mut color).named("color").changed() {
            item.color = Some(color);
        }
        let mut name = item.name.clone().unwrap_or_default();
        let field = line_field(&mut name).hint_text("name").desired_width(150.0);
        if ui.add(field).named("name").changed() {
            item.name = (!name.is_empty()).then_some(name);
        }
        ui.button("Delete").asks(ObjectAction::Delete);
    });
}

/// Shows a sphere's fields. Returns the error that the sphere had before the edit, if any.
fn sphere(ui: &mut Ui, sphere: &mut Sphere) -> Result<(), ObjectError> {
    let valid = sphere.check();
    vector(ui, "centre", &mut sphere.center);
    ui.horizontal(|ui| {
        ui.label("radius");
        NumberField::new("radius", &mut sphere.radius).show(ui);
    });
    valid
}

/// Shows a plane's fields. Returns the error that the plane had before the edit, if any.
fn plane(ui: &mut Ui, plane: &mut Plane) -> Result<(), ObjectError> {
    let valid = plane.check();
    vector(ui, "point", &mut plane.point);
    vector(ui, "normal", &mut plane.normal);
    valid
}

fn vector(ui: &mut Ui, name: &str, value: &mut DVec3) {
    ui.horizontal(|ui| {
        ui.label(name);
        vector_row(ui, name, value);
    });
}
