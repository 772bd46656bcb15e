//! The camera as numbers (eye, orientation, viewport and image), and the fields of the selected ray.

use std::cell::Cell;

use egui::{Context, Grid, Rect, RichText, Ui, UiBuilder};
use pinhole_core::{
    Basis, Camera, ImageSize, Orientation, OrientationKind, Pixel, ResolvedCamera, Selection,
    Viewport,
};
use pinhole_figure::symbols::{SymbolKind, meaning, typeset_message};
use pinhole_figure::typesetting::theme::error_color;
use pinhole_lecture::numbers::written;

use super::{section, teaching};
use crate::model::session::{Preferences, Session, Settings};
use crate::ui::widgets::{NumberField, ResponseExt as _, vector_color, vector_row};

/// Maximum number of significant digits in the heading of a folded section.
const HEADING_DIGITS: usize = 3;

/// Shows the fields that edit the camera. The setting `keep_pixel_shape` locks the aspect ratio of the
/// pixels: the viewport's width / height, divided by the image's W / H. The setting `keep_picture` locks the
/// ratios of the viewport's distance, width and height.
pub(crate) fn ui(ui: &mut Ui, camera: &mut Camera, session: &mut Session) {
    let style = session.shown.setup.number_style().at_most(HEADING_DIGITS);
    let eye = format!("eye {}", style.vector(camera.eye));
    let mut unfolded = session.preferences.unfolded.camera || camera.basis().is_err();
    let header = section(ui, "Camera", &eye, &mut unfolded, |ui| {
        given_by(ui, camera);
        Grid::new("camera vectors").num_columns(2).show(ui, |ui| orientation(ui, camera));
        teaching::ui(ui, camera, session);
    });
    if unfolded {
        canonical(ui, header.rect, camera);
    }
    session.preferences.unfolded.camera = unfolded;
    ui.separator();
    let Viewport { width, height, distance } = camera.viewport;
    let [width, height, distance] = [width, height, distance].map(|x| style.number(x));
    let [columns, rows] = [camera.image.width(), camera.image.height()];
    let values = format!("{width} × {height} at {distance}, {columns} × {rows}");
    let mut unfolded = session.preferences.unfolded.viewport || camera.viewport.check().is_err();
    section(ui, "Viewport and image", &values, &mut unfolded, |ui| {
        let settings = session.settings();
        Grid::new("viewport").num_columns(4).show(ui, |ui| viewport(ui, camera, &settings));
        let hint = "W and H change together, and so do width and height; 640 x 360 in the field of W or \
                    H sets both";
        let keeps = &mut session.preferences.keep_pixel_shape;
        ui.checkbox(keeps, "Keep the pixels' shape").on_hover_text(hint);
        pixel_shape(ui, camera);
    });
    session.preferences.unfolded.viewport = unfolded;
}

/// Shows the button for the canonical camera, at the right end of the section's heading.
fn canonical(ui: &mut Ui, heading: Rect, camera: &mut Camera) {
    let hint = "Eye at the origin, looking along −z, viewport 1 × 1 at distance 1";
    let row = heading.with_max_x(ui.max_rect().right());
    let layout = egui::Layout::right_to_left(egui::Align::Center);
    let mut row = ui.new_child(UiBuilder::new().max_rect(row).layout(layout));
    if row.button("Canonical camera").on_hover_text(hint).clicked() {
        *camera = Camera::CANONICAL;
    }
}

/// Shows the choice of how the camera is given (by *at*, *view* or a basis). Converts the camera to the
/// chosen form.
fn given_by(ui: &mut Ui, camera: &mut Camera) {
    ui.horizontal(|ui| {
        ui.label("Given by");
        let kinds = [
            (OrientationKind::At, "eye, at, up", "A point to look at"),
            (OrientationKind::View, "eye, view, up", "A direction to look along"),
            (OrientationKind::Basis, "u, v, w", "The basis set by hand"),
        ];
        let present = camera.orientation.kind();
        for (kind, text, hint) in kinds {
            let converted = camera.given_by(kind);
            let button = ui.add_enabled_ui(converted.is_ok(), |ui| {
                ui.selectable_label(kind == present, text).on_hover_text(hint)
            });
            if let Err(reason) = converted {
                button.inner.on_disabled_hover_text(typeset_message(reason));
            } else if button.inner.clicked()
                && let Ok(converted) = converted
            {
                *camera = converted;
            }
        }
    });
}

fn orientation(ui: &mut Ui, camera: &mut Camera) {
    let fault = camera.basis().err();
    let given = match &mut camera.orientation {
        Orientation::At { at, up } => vec![("at", at), ("up", up)],
        Orientation::View { view, up } => vec![("view", view), ("up", up)],
        Orientation::Basis(Basis { u, v, w }) => vec![("u", u), ("v", v), ("w", w)],
    };
    for (name, value) in [("eye", &mut camera.eye)].into_iter().chain(given) {
        // The picture says what is wrong; here only the name of the field is marked.
        let is_wrong = fault.is_some_and(|fault| fault.vector() == name);
        let color = if is_wrong { Some(error_color(ui)) } else { vector_color(ui, name) };
        let color = color.unwrap_or(ui.visuals().text_color());
        let label = ui.label(RichText::new(name).strong().color(color));
        if let Some(words) = meaning(SymbolKind::Vector, name) {
            label.on_hover_text(words);
        }
        ui.horizontal(|ui| vector_row(ui, name, value));
        ui.end_row();
    }
}

fn viewport(ui: &mut Ui, camera: &mut Camera, settings: &Settings) {
    let before = *camera;
    let mut columns_and_rows = [camera.image.width(), camera.image.height()];
    let pair = Cell::new(None);
    let wrong = camera.viewport.check().err().map(|fault| fault.field);
    let named = |ui: &mut Ui, name: &'static str| {
        let color = if wrong == Some(name) { error_color(ui) } else { ui.visuals().text_color() };
        ui.label(RichText::new(name).color(color));
    };
    named(ui, "width");
    NumberField::new("width", &mut camera.viewport.width).show(ui);
    pixels(ui, "W", &mut columns_and_rows[0], &pair);
    named(ui, "height");
    NumberField::new("height", &mut camera.viewport.height).show(ui);
    pixels(ui, "H", &mut columns_and_rows[1], &pair);
    let start = at_start_of_drag(ui, &before);
    let is_of_image = resize(camera, &start, columns_and_rows, pair.get(), &settings.preferences);
    let before = if is_of_image { start } else { before };
    named(ui, "distance");
    NumberField::new("distance", &mut camera.viewport.distance).show(ui);
    ui.end_row();
    keep(ui.ctx(), &before, camera, settings);
    // While the picture is locked, the field of view cannot be edited, because that would change the
    // picture.
    field_of_view(ui, camera, !settings.setup.keep_picture);
}

/// After an edit of the viewport or the image, restores the picture or the aspect ratio of the pixels,
/// whichever the settings lock.
pub(crate) fn keep(ctx: &Context, before: &Camera, camera: &mut Camera, settings: &Settings) {
    if settings.setup.keep_picture && camera.viewport != before.viewport {
        teaching::keep_picture(ctx, before, camera);
    } else if settings.preferences.keep_pixel_shape {
        keep_pixels_shape(before, camera);
    }
}

/// Returns the camera as it was when the present drag began. An image that is made tiny by a drag and large
/// again then has its shape again.
fn at_start_of_drag(ui: &Ui, camera: &Camera) -> Camera {
    let key = egui::Id::unique("camera before the drag");
    let is_dragged = ui.ctx().dragged_id().is_some();
    let start = ui.data(|data| data.get_temp(key)).filter(|_| is_dragged).unwrap_or(*camera);
    ui.data_mut(|data| data.insert_temp(key, start));
    start
}

/// Sets the image's size to a typed pair or, if one of its width and height was edited, to that. If the pixels'
/// shape is kept, the other one then follows, so that no image is a sliver, and the viewport is that of
/// `start` again. Returns true if the image's size changed.
fn resize(
    camera: &mut Camera,
    start: &Camera,
    [columns, rows]: [u32; 2],
    pair: Option<[f64; 2]>,
    preferences: &Preferences,
) -> bool {
    let before = camera.image;
    let following = |edited: u32, was: u32, other: u32| {
        let follows = f64::from(other) * f64::from(edited) / f64::from(was);
        follows.round().clamp(1.0, f64::from(ImageSize::MAX)) as u32
    };
    let (width, height) = (start.image.width(), start.image.height());
    let [columns, rows] = match pair {
        Some(pair) => pair.map(|count| count as u32),
        None if !preferences.keep_pixel_shape => [columns, rows],
        None if columns != before.width() => [columns, following(columns, width, height)],
        None if rows != before.height() => [following(rows, height, width), rows],
        None => [columns, rows],
    };
    let Ok(image) = ImageSize::new(columns, rows) else { return false };
    if image != before {
        (camera.image, camera.viewport) = (image, start.viewport);
    }
    image != before
}

/// Shows a field for the image's width or height, in which both may be typed.
fn pixels(ui: &mut Ui, name: &str, value: &mut u32, pair: &Cell<Option<[f64; 2]>>) {
    ui.label(name);
    let mut count = f64::from(*value);
    let range = 1.0..=f64::from(ImageSize::MAX);
    let field = NumberField::new(name, &mut count);
    if (NumberField { suffix: " px", range, is_whole: true, pair: Some(pair), ..field })
        .show(ui)
        .changed()
    {
        *value = count as u32;
    }
    ui.end_row();
}

/// Shows both fields of view in degrees. Editing one of them changes the viewport's width and height,
/// but not its distance.
fn field_of_view(ui: &mut Ui, camera: &mut Camera, enabled: bool) {
    if camera.viewport.check().is_err() {
        return;
    }
    let viewport = camera.viewport;
    let edited = |ui: &mut Ui, name: &str, radians: f64| {
        let mut degrees = radians.to_degrees();
        let field = NumberField::new(name, &mut degrees);
        let field = NumberField { suffix: "°", range: FOV_DEGREES, ..field };
        let response = ui.add_enabled_ui(enabled, |ui| field.show(ui)).inner;
        response.changed().then(|| degrees.to_radians())
    };
    ui.label("fov ↔").on_hover_text("Horizontal field of view: 2 atan(width / (2 distance))");
    // At a distance of 1e308, a wide viewport exceeds the range of numbers.
    let take = |new: Viewport| if new.check().is_ok() { new } else { viewport };
    if let Some(fov) = edited(ui, "horizontal field of view", viewport.horizontal_fov()) {
        camera.viewport = take(viewport.with_horizontal_fov(fov));
    }
    ui.label("fov ↕").on_hover_text("Vertical field of view: 2 atan(height / (2 distance))");
    if let Some(fov) = edited(ui, "vertical field of view", viewport.vertical_fov()) {
        camera.viewport = take(viewport.with_vertical_fov(fov));
    }
    ui.end_row();
}

/// Range of valid fields of view, in degrees. It ends below 180 degrees, for which a flat viewport would be
/// infinite.
const FOV_DEGREES: std::ops::RangeInclusive<f64> = 1e-6..=179.999;

/// Returns the ratio of width to height of a camera's pixels.
fn shape_of(camera: &Camera) -> f64 {
    camera.viewport.width / camera.viewport.height / camera.image.aspect()
}

/// Restores the aspect ratio of the pixels: adapts the height of the viewport after an edit of its width, and
/// vice versa. After an edit of the image, the larger of the viewport's width and height stays as it was, so
/// that no field of view grows. Nothing is adapted if a value would exceed the range of numbers.
fn keep_pixels_shape(before: &Camera, camera: &mut Camera) {
    let ratio = shape_of(before) * camera.image.aspect();
    let Viewport { width, height, .. } = camera.viewport;
    let edited = |now: f64, then: f64| now != then && is_extent(now);
    let [width, height] = if edited(height, before.viewport.height) {
        [height * ratio, height]
    } else if edited(width, before.viewport.width) {
        [width, width / ratio]
    } else if camera.image != before.image {
        let larger = width.max(height);
        [larger * ratio.min(1.0), larger / ratio.max(1.0)]
    } else {
        return;
    };
    if is_extent(width) && is_extent(height) {
        (camera.viewport.width, camera.viewport.height) = (width, height);
    }
}

fn is_extent(x: f64) -> bool {
    x.is_finite() && x > 0.0
}

/// If the image's pixels are not square, shows their aspect ratio and a button that makes them square.
fn pixel_shape(ui: &mut Ui, camera: &mut Camera) {
    let shape = shape_of(camera);
    let is_known = camera.viewport.check().is_ok() && is_extent(shape);
    if is_known && (shape - 1.0).abs() > 1e-9 {
        let times = written(shape, 4);
        ui.label(format!("Pixels are {times} times as wide as high: spheres look stretched"));
        if ui.button("Make pixels square").clicked() {
            let aspect = camera.image.aspect();
            let height = camera.viewport.width / aspect;
            if is_extent(height) {
                camera.viewport.height = height;
            } else {
                camera.viewport.width = camera.viewport.height * aspect;
            }
        }
    }
}

/// Shows the fields of the selected ray: row and column, or (u, v). If the camera is invalid, says that there
/// is no ray.
pub(crate) fn selected_ray(
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
    // A point on an edge or a corner does not belong to a single pixel.
    let known = match *selection {
        Selection::Pixel(_) => true,
        Selection::Uv(uv) => resolved.pixel_of_uv(uv).is_some_and(|at| at.only_pixel().is_some()),
    };
    Grid::new("selected ray").num_columns(4).show(ui, |ui| {
        let from = u32::from(count_from_one);
        let height = ui.spacing().interact_size.y;
        // The field shows a dash if the ray passes outside the image or between pixels.
        let written = |index: f64| if known { index.to_string() } else { "–".to_owned() };
        let field = |ui: &mut Ui, name: &str, index: &mut u32, count: u32| {
            ui.label(name);
            let mut shown = *index + from;
            let field = egui::DragValue::new(&mut shown).range(from..=count - 1 + from).speed(0.2);
            let field = field.update_while_editing(false).min_size(egui::vec2(78.0, height));
            let response = ui.add(field.custom_formatter(|index, _| written(index))).named(name);
            *index = shown - from;
            response.changed()
        };
        let mut pixel = selection.pixel(resolved).unwrap_or(Pixel { row: 0, column: 0 });
        let image = resolved.image();
        let row = field(ui, "row", &mut pixel.row, image.height());
        let column = field(ui, "column", &mut pixel.column, image.width());
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
