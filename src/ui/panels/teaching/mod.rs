//! The camera panel's part for teaching: cameras that differ in one thing alone, and how steady the
//! camera is.

mod dial;

use egui::{CollapsingHeader, Id, Label, RichText, Slider, Ui};
use pinhole_core::{Camera, Orientation};

use crate::model::session::Settings;
use crate::ui::widgets::number::NumberField;
use crate::view::typesetting::theme::error_color;

/// Shows it, folded unless the settings say otherwise.
pub(crate) fn ui(ui: &mut Ui, camera: &mut Camera, settings: &mut Settings) {
    let header = CollapsingHeader::new("Teaching").open(Some(settings.teaching));
    let response = header.show(ui, |ui| {
        let text = "Keep the picture: scale distance, width and height together";
        let hint = "The same picture: d is scaled, and t is divided by as much";
        ui.checkbox(&mut settings.keep_picture, text).on_hover_text(hint);
        // A basis by hand has no up.
        if !matches!(camera.orientation, Orientation::Basis(_)) {
            swing(ui, camera);
            tilt(ui, camera);
            dial::ui(ui, camera);
        }
    });
    if response.header_response.clicked() {
        settings.teaching = !settings.teaching;
    }
}

/// After an edit of one measure of the viewport, the other two follow.
pub(crate) fn keep_picture(ui: &Ui, before: &Camera, camera: &mut Camera) {
    let kept = Kept::of(ui, "kept picture", |made| made.viewport == before.viewport, before);
    let (from, old, edited) = (kept.from.viewport, before.viewport, camera.viewport);
    let Ok(scaled) = kept.from.picture_scaled_as(&old, &edited) else {
        // A measure that is none is told below the fields, as without the lock; the next one that is
        // one finds the picture again.
        if from.check().is_ok() {
            Kept { made: *camera, ..kept }.keep(ui, "kept picture");
        }
        return;
    };
    let as_typed = |typed, old, scaled| if typed == old { scaled } else { typed };
    camera.viewport.width = as_typed(edited.width, old.width, scaled.viewport.width);
    camera.viewport.height = as_typed(edited.height, old.height, scaled.viewport.height);
    camera.viewport.distance = scaled.viewport.distance;
    Kept { made: *camera, ..kept }.keep(ui, "kept picture");
}

/// What a camera was made from by a control that turns or scales it. Every move of that control
/// starts there again: rounding does not add up under the hand.
#[derive(Clone, Copy)]
struct Kept {
    from: Camera,
    made: Camera,
    degrees: f64,
}

impl Kept {
    /// What `now` was made from; itself, if what the control made last is not what `is_now`.
    fn of(ui: &Ui, name: &'static str, is_now: impl Fn(&Camera) -> bool, now: &Camera) -> Kept {
        let kept = ui.data(|data| data.get_temp::<Kept>(Id::unique(name)));
        let itself = Kept { from: *now, made: *now, degrees: 0.0 };
        kept.filter(|kept| is_now(&kept.made)).unwrap_or(itself)
    }

    fn keep(self, ui: &Ui, name: &'static str) {
        ui.data_mut(|data| data.insert_temp(Id::unique(name), self));
    }
}

/// Turns up about the view, in degrees from where it was before the control was touched.
fn swing(ui: &mut Ui, camera: &mut Camera) {
    let kept = Kept::of(ui, "swung camera", |made| made == camera, camera);
    let mut degrees = kept.degrees;
    let hint = "Turns up about the view: the camera rolls, and looks along the same line";
    row(ui, "swing up", hint, camera.basis().is_ok(), |ui| {
        let slider = ui.add(Slider::new(&mut degrees, -180.0..=180.0).show_value(false));
        ui.ctx().accesskit_node_builder(slider.id, |node| node.set_label("swing up slider"));
        let field = NumberField::new("swing up", &mut degrees).suffix("°").width(FIELD).show(ui);
        if !(slider.changed() || field.changed()) {
            return;
        }
        if let Ok(swung) = kept.from.swung(degrees) {
            *camera = swung;
            Kept { made: swung, degrees, ..kept }.keep(ui, "swung camera");
        }
    });
}

/// Turns up towards the view, or away from it, in one plane with it.
fn tilt(ui: &mut Ui, camera: &mut Camera) {
    let kept = Kept::of(ui, "tilted camera", |made| made == camera, camera);
    let angle = camera.up_angle();
    let mut degrees = angle.map_or(90.0, |angle| angle.angle.to_degrees());
    let hint = "The angle between up and view: u, v and w stay, but get nervous near 0° and 180°";
    row(ui, "up from view", hint, angle.is_ok(), |ui| {
        // Fine near both ends, where it matters.
        let mut place = (0.5 * degrees.to_radians()).tan().log10();
        let slider = ui.add(Slider::new(&mut place, -ENDS..=ENDS).show_value(false));
        ui.ctx().accesskit_node_builder(slider.id, |node| node.set_label("up from view slider"));
        if slider.changed() {
            degrees = (2.0 * 10f64.powf(place).atan()).to_degrees();
        }
        let field = NumberField::new("up from view", &mut degrees).suffix("°").width(FIELD);
        let field = field.within(SMALLEST..=180.0 - SMALLEST).show(ui);
        if !(slider.changed() || field.changed()) {
            return;
        }
        if let Ok(tilted) = kept.from.up_tilted(degrees) {
            *camera = tilted;
            Kept { made: tilted, ..kept }.keep(ui, "tilted camera");
        }
    });
}

/// The slider's ends: log10 of the tangent of half the angle.
const ENDS: f64 = 5.0;
/// The smallest angle between up and view that can be typed, in degrees.
const SMALLEST: f64 = 1e-9;
const SLIDER: f32 = 110.0;
const FIELD: f32 = 70.0;

/// A name and its controls; out of reach where there is nothing to turn.
fn row(ui: &mut Ui, name: &str, hint: &str, possible: bool, controls: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = SLIDER;
        ui.add_sized([88.0, ui.spacing().interact_size.y], Label::new(name)).on_hover_text(hint);
        ui.add_enabled_ui(possible, |ui| ui.horizontal(controls));
    });
}

/// Why there is no number, where there is none.
fn reason(ui: &mut Ui, text: String) {
    ui.label(RichText::new(text).size(15.0).color(error_color(ui)));
}
