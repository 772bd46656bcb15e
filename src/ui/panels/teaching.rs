//! The camera panel's experiments: edits that change a single property of the camera, and its conditioning,
//! that is, by how many degrees it rolls for each degree that up is tipped sideways.

use egui::{CollapsingHeader, Context, Id, RichText, Slider, Ui};
use pinhole_core::{Camera, UpAngle};
use pinhole_lecture::numbers::written;

use crate::model::Session;
use crate::ui::widgets::{NumberField, ResponseExt as _};

/// Shows the experiments, folded unless the settings say otherwise.
pub(crate) fn ui(ui: &mut Ui, camera: &mut Camera, session: &mut Session) {
    let header = CollapsingHeader::new("Experiments").open(Some(session.shown.setup.teaching));
    let response = header.show(ui, |ui| {
        let text = "Keep the picture: scale distance, width and height together";
        let hint = "The picture stays: d is scaled, and t is divided by the same factor";
        ui.checkbox(&mut session.shown.setup.keep_picture, text).on_hover_text(hint);
        // A basis set by hand has no up.
        if camera.orientation.has_up() {
            let hint = "On: up stays fixed while eye or at is dragged, so the view can become parallel to it. \
                        Off: up turns with the camera when the view comes close to it";
            ui.checkbox(&mut session.preferences.keep_up, "Keep up").on_hover_text(hint);
            tilt(ui, camera);
            if let Ok(UpAngle { conditioning, .. }) = camera.up_angle() {
                sensitivity(ui, conditioning);
            }
        }
    });
    if response.header_response.clicked() {
        session.shown.setup.teaching ^= true;
    }
}

/// After the user edits the viewport's width, height or distance, scales the other two, so that the picture
/// stays the same.
pub(crate) fn keep_picture(ctx: &Context, before: &Camera, camera: &mut Camera) {
    let kept = Kept::resume(ctx, "kept picture", |made| made.viewport == before.viewport, before);
    let (from, old, edited) = (kept.from.viewport, before.viewport, camera.viewport);
    let Ok(scaled) = kept.from.picture_scaled_as(&old, &edited) else {
        // An invalid extent is reported below the fields, as without the lock. The next valid extent restores
        // the picture.
        if from.check().is_ok() {
            Kept { made: *camera, ..kept }.keep(ctx, "kept picture");
        }
        return;
    };
    let as_typed = |typed, old, scaled| if typed == old { scaled } else { typed };
    camera.viewport.width = as_typed(edited.width, old.width, scaled.viewport.width);
    camera.viewport.height = as_typed(edited.height, old.height, scaled.viewport.height);
    camera.viewport.distance = scaled.viewport.distance;
    Kept { made: *camera, ..kept }.keep(ctx, "kept picture");
}

/// The state of a control that turns or scales the camera: the camera before the control was used, and the
/// last camera that the control made of it. Every move of the control starts from the first one again, so
/// that rounding errors do not accumulate.
#[derive(Clone, Copy)]
struct Kept {
    /// The camera before the control was used.
    from: Camera,
    /// The camera that the control made last.
    made: Camera,
}

impl Kept {
    /// Returns the stored state of the control if `is_now` returns true for the last camera that the control
    /// made. Otherwise the camera has been changed elsewhere, and the returned state starts at `now`.
    fn resume(ctx: &Context, name: &str, is_now: impl Fn(&Camera) -> bool, now: &Camera) -> Kept {
        let kept = ctx.data(|data| data.get_temp::<Kept>(Id::unique(name)));
        let itself = Kept { from: *now, made: *now };
        kept.filter(|kept| is_now(&kept.made)).unwrap_or(itself)
    }

    fn keep(self, ctx: &Context, name: &str) {
        ctx.data_mut(|data| data.insert_temp(Id::unique(name), self));
    }
}

/// Shows the control that turns *up* towards the view direction or away from it, in the plane that contains
/// both.
fn tilt(ui: &mut Ui, camera: &mut Camera) {
    let kept = Kept::resume(ui.ctx(), "tilted camera", |made| made == camera, camera);
    let angle = camera.up_angle();
    let mut degrees = angle.map_or(90.0, |angle| angle.angle.to_degrees());
    let hint =
        "The angle between up and view: u, v and w stay, but get very sensitive near 0° and 180°";
    ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = SLIDER;
        ui.label("up from view").on_hover_text(hint);
        ui.add_enabled_ui(angle.is_ok(), |ui| {
            // The scale is logarithmic, and so fine near both ends, where it matters.
            let mut exponent = (0.5 * degrees.to_radians()).tan().log10();
            let slider = Slider::new(&mut exponent, -ENDS..=ENDS).show_value(false);
            let slider = ui.add(slider).named("up from view slider");
            if slider.changed() {
                degrees = (2.0 * 10f64.powf(exponent).atan()).to_degrees();
            }
            let field = NumberField::new("up from view", &mut degrees);
            let range = SMALLEST..=180.0 - SMALLEST;
            let field = NumberField { suffix: "°", width: FIELD, range, ..field }.show(ui);
            if (slider.changed() || field.changed())
                && let Ok(tilted) = kept.from.up_tilted(degrees)
            {
                *camera = tilted;
                Kept { made: tilted, ..kept }.keep(ui.ctx(), "tilted camera");
            }
        });
    });
}

/// End of the slider's range, which is from -`ENDS` to `ENDS`: log10(tan(a / 2)), where a is the angle
/// between up and view.
const ENDS: f64 = 5.0;
/// Minimum angle between up and view that can be typed, in degrees.
const SMALLEST: f64 = 1e-9;
const SLIDER: f32 = 110.0;
const FIELD: f32 = 70.0;

/// Size of the sensitivity, in points; it is legible from the back row of a classroom.
const NUMBER: f32 = 20.0;

/// Shows the camera's conditioning: by how many degrees the camera rolls for each degree
/// that up is tipped sideways.
fn sensitivity(ui: &mut Ui, conditioning: f64) {
    let number = format!("{}° of roll per 1° of up", written(conditioning, 3));
    let response = ui.label(RichText::new(&number).size(NUMBER).strong());
    let hint = "Tipped sideways, out of the plane of up and view, by a small angle";
    response.on_hover_text(hint).named("sensitivity").spoken(number);
}
