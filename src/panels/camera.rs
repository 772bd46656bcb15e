//! The camera as numbers: where the eye is, where it looks, the viewport and the image.

use egui::{Grid, RichText, Ui};
use pinhole_core::{
    BasisError, BasisVector, Camera, CameraError, ImageSize, Orientation, OrientationKind, Viewport,
};

use super::number::{NumberField, error_color, vector_color, vector_row};

/// Edits the camera. `square_pixels` is the lock that keeps width : height as W : H.
pub(crate) fn ui(ui: &mut Ui, camera: &mut Camera, square_pixels: &mut bool) {
    ui.horizontal(|ui| {
        ui.heading("Camera");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let hint = "Eye at the origin, looking along -z, viewport 1 × 1 at distance 1";
            if ui.button("Canonical camera").on_hover_text(hint).clicked() {
                *camera = Camera::CANONICAL;
            }
        });
    });
    given_by(ui, camera);
    Grid::new("camera vectors").num_columns(2).show(ui, |ui| orientation(ui, camera));
    ui.add_space(6.0);
    ui.heading("Viewport and image");
    Grid::new("viewport").num_columns(4).show(ui, |ui| viewport(ui, camera, *square_pixels));
    let lock = ui.checkbox(square_pixels, "Square pixels");
    lock.clone().on_hover_text("Keep width : height as W : H when either changes");
    if lock.changed() && *square_pixels {
        camera.viewport.height = camera.viewport.width / camera.image.aspect();
    }
    if !*square_pixels {
        pixel_shape(ui, camera);
    }
}

/// How the camera is given; switching converts.
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
                button.inner.on_disabled_hover_text(reason.to_string());
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
    let row = |ui: &mut Ui, field: &'static str, name: &str, value| {
        let color = vector_color(ui, name);
        ui.label(RichText::new(name).strong().color(color.unwrap_or(ui.visuals().text_color())));
        ui.vertical(|ui| {
            ui.horizontal(|ui| vector_row(ui, name, value));
            if let Some(fault) = fault.filter(|fault| is_at_fault(fault, field)) {
                ui.label(RichText::new(fault.to_string()).color(error_color(ui)));
            }
        });
        ui.end_row();
    };
    row(ui, "eye", "eye", &mut camera.eye);
    match &mut camera.orientation {
        Orientation::At { at, up } => {
            row(ui, "at", "at", at);
            row(ui, "up", "up", up);
        }
        Orientation::View { view, up } => {
            row(ui, "view", "view", view);
            row(ui, "up", "up", up);
        }
        Orientation::Basis(basis) => {
            row(ui, "basis.u", "u", &mut basis.u);
            row(ui, "basis.v", "v", &mut basis.v);
            row(ui, "basis.w", "w", &mut basis.w);
        }
    }
}

/// Whether this is the field to write the reason under.
fn is_at_fault(fault: &BasisError, field: &str) -> bool {
    let of_vector = |vector: BasisVector| match vector {
        BasisVector::U => "basis.u",
        BasisVector::V => "basis.v",
        BasisVector::W => "basis.w",
    };
    let at_fault = match fault {
        BasisError::NotFinite { field, .. } => field,
        BasisError::EyeIsAt { .. } => "at",
        BasisError::ViewIsZero => "view",
        BasisError::UpIsZero | BasisError::UpParallelToView { .. } => "up",
        BasisError::NotUnit { vector, .. } => of_vector(*vector),
        BasisError::NotOrthogonal { second, .. } => of_vector(*second),
        _ => "basis.w",
    };
    at_fault == field
}

fn viewport(ui: &mut Ui, camera: &mut Camera, square_pixels: bool) {
    let fault = match camera.posed() {
        Err(CameraError::Viewport(fault)) => Some(fault),
        _ => None,
    };
    let before = *camera;
    size_rows(ui, camera);
    ui.label("distance");
    NumberField::new("distance", &mut camera.viewport.distance).show(ui);
    ui.label("");
    ui.label("");
    ui.end_row();
    field_of_view(ui, camera);
    if square_pixels {
        keep_pixels_square(&before, camera);
    }
    if let Some(fault) = fault {
        ui.label("");
        ui.label(RichText::new(fault.to_string()).color(error_color(ui)));
        ui.end_row();
    }
}

fn size_rows(ui: &mut Ui, camera: &mut Camera) {
    let (mut columns, mut rows) = (camera.image.width(), camera.image.height());
    let pixels = |ui: &mut Ui, name: &str, value: &mut u32| {
        let field = egui::DragValue::new(value).range(1..=ImageSize::MAX).speed(1.0).suffix(" px");
        let response = ui.add(field.min_size(egui::vec2(78.0, ui.spacing().interact_size.y)));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
    };
    ui.label("width");
    NumberField::new("width", &mut camera.viewport.width).show(ui);
    ui.label("W");
    pixels(ui, "W", &mut columns);
    ui.end_row();
    ui.label("height");
    NumberField::new("height", &mut camera.viewport.height).show(ui);
    ui.label("H");
    pixels(ui, "H", &mut rows);
    ui.end_row();
    if let Ok(image) = ImageSize::new(columns, rows) {
        camera.image = image;
    }
}

/// Both fields of view in degrees; editing one changes width and height and keeps the distance.
fn field_of_view(ui: &mut Ui, camera: &mut Camera) {
    if camera.viewport.check().is_err() {
        return;
    }
    let viewport = camera.viewport;
    let edited = |ui: &mut Ui, name: &str, radians: f64| {
        let mut degrees = radians.to_degrees();
        let response = NumberField::new(name, &mut degrees).suffix("°").show(ui);
        response.changed().then(|| degrees.clamp(1e-6, 179.0).to_radians())
    };
    ui.label("fov across").on_hover_text("Horizontal field of view: 2 atan(width / (2 distance))");
    if let Some(fov) = edited(ui, "horizontal field of view", viewport.horizontal_fov()) {
        camera.viewport = viewport.with_horizontal_fov(fov);
    }
    ui.label("up").on_hover_text("Vertical field of view: 2 atan(height / (2 distance))");
    if let Some(fov) = edited(ui, "vertical field of view", viewport.vertical_fov()) {
        camera.viewport = viewport.with_vertical_fov(fov);
    }
    ui.end_row();
}

/// After an edit, the other measure follows: the height, or the width where the height was edited.
fn keep_pixels_square(before: &Camera, camera: &mut Camera) {
    let Viewport { width, height, .. } = camera.viewport;
    let aspect = camera.image.aspect();
    if height != before.viewport.height && width == before.viewport.width {
        camera.viewport.width = height * aspect;
    } else if width != before.viewport.width || camera.image != before.image {
        camera.viewport.height = width / aspect;
    }
}

/// What shape the pixels have, where they need not be square.
fn pixel_shape(ui: &mut Ui, camera: &Camera) {
    let Viewport { width, height, .. } = camera.viewport;
    let ratio = width / height / camera.image.aspect();
    if ratio.is_finite() && (ratio - 1.0).abs() > 1e-9 {
        ui.label(format!(
            "Pixels are {} times as wide as high: spheres look stretched",
            super::number::significant(ratio, 4)
        ));
    }
}
