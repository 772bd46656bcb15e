//! The dial of the conditioning: degrees of roll for each degree that up is tipped sideways.

use std::f32::consts::PI;

use egui::epaint::PathStroke;
use egui::{Align2, Color32, FontId, Pos2, RichText, Sense, Shape, Stroke, Ui, pos2, vec2};
use pinhole_core::{BasisError, Camera, UpAngle};
use pinhole_lecture::numbers::written;

use super::reason;
use crate::model::letters::typeset_message;
use crate::ui::widgets::Spoken as _;
use crate::view::typesetting::theme::error_color;

/// Number of decades of the scale, which ends at 10^6.
const DECADES: f32 = 6.0;
const RADIUS: f32 = 64.0;
/// Text sizes that are legible from the back row.
const NUMBER: f32 = 20.0;
const WORDS: f32 = 15.0;
const TICK: f32 = 12.0;

/// Conditioning from which on the camera is called sensitive, and very sensitive.
const SENSITIVE: f64 = 2.0;
const VERY_SENSITIVE: f64 = 20.0;

/// Shows the dial of this camera.
pub(super) fn ui(ui: &mut Ui, camera: &Camera) {
    let angle = camera.up_angle();
    let shown = match &angle {
        Ok(UpAngle { conditioning, .. }) => Some(*conditioning),
        // The end of the scale: there is no camera beyond it.
        Err(BasisError::UpParallelToView { .. }) => Some(f64::INFINITY),
        Err(_) => None,
    };
    if let Some(conditioning) = shown {
        face(ui, conditioning);
    }
    match angle {
        Ok(UpAngle { conditioning, .. }) => words(ui, conditioning),
        Err(fault) => reason(ui, format!("No camera: {}", typeset_message(fault))),
    }
}

/// Shows the number and its meaning.
fn words(ui: &mut Ui, conditioning: f64) {
    let number = format!("{}° of roll per 1° of up", written(conditioning, 3));
    let response = ui.label(RichText::new(&number).size(NUMBER).strong());
    let hint = "Tipped sideways, out of the plane of up and view, by a small angle";
    response.on_hover_text(hint).named("sensitivity").spoken(number);
    let meaning = if conditioning < SENSITIVE {
        "Calm: up and view are well apart."
    } else if conditioning < VERY_SENSITIVE {
        "Sensitive: up is close to the line of view."
    } else {
        "Very sensitive: up and view are almost parallel."
    };
    ui.label(RichText::new(meaning).size(WORDS));
}

/// Draws the half circle with its scale, 1 on the left and a million on the right, and the needle.
fn face(ui: &mut Ui, conditioning: f64) {
    let size = vec2(ui.available_width(), RADIUS + 30.0);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let hub = pos2(rect.center().x, rect.bottom() - 6.0);
    let text = ui.visuals().strong_text_color();
    arcs(ui, hub);
    for decade in 0..=DECADES as usize {
        let angle = angle_of(decade as f32);
        let (inner, outer) = (at(hub, angle, RADIUS - 5.0), at(hub, angle, RADIUS + 4.0));
        ui.painter().line_segment([inner, outer], Stroke::new(1.5, text));
        let label = ["1", "10", "100", "10³", "10⁴", "10⁵", "10⁶"][decade];
        let center = at(hub, angle, RADIUS + 15.0);
        ui.painter().text(center, Align2::CENTER_CENTER, label, FontId::proportional(TICK), text);
    }
    let decade = (conditioning.log10() as f32).clamp(0.0, DECADES);
    let tip = at(hub, angle_of(decade), RADIUS - 12.0);
    ui.painter().line_segment([hub, tip], Stroke::new(3.0, text));
    ui.painter().circle_filled(hub, 5.0, text);
}

/// Draws the zones calm, sensitive and very sensitive, which differ in width as well as in colour.
fn arcs(ui: &Ui, hub: Pos2) {
    let quiet = ui.visuals().weak_text_color();
    let amber = Color32::from_rgb(0xe0, 0x8a, 0x00);
    let zones = [
        (0.0, SENSITIVE.log10() as f32, quiet, 3.0),
        (SENSITIVE.log10() as f32, VERY_SENSITIVE.log10() as f32, amber, 5.0),
        (VERY_SENSITIVE.log10() as f32, DECADES, error_color(ui), 8.0),
    ];
    for (from, to, color, width) in zones {
        let steps = 1 + ((to - from) * 12.0) as usize;
        let point = |k: usize| {
            let share = k as f32 / steps as f32;
            at(hub, angle_of(from + share * (to - from)), RADIUS)
        };
        let points = (0..=steps).map(point).collect();
        ui.painter().add(Shape::line(points, PathStroke::new(width, color)));
    }
}

/// Returns the angle of a number with this logarithm: from the left over the top to the right.
fn angle_of(decades: f32) -> f32 {
    PI * (1.0 - decades / DECADES)
}

fn at(hub: Pos2, angle: f32, radius: f32) -> Pos2 {
    hub + radius * vec2(angle.cos(), -angle.sin())
}
