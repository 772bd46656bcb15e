//! "Guess which": a wrong camera without its name, the class's answer, and what would have told.

use egui::{RichText, Ui};
use pinhole_core::{Camera, PosedCamera, Scene};
use pinhole_lecture::mistakes::{ComparedCamera, Mistake, WrongCamera, visible};

use super::super::number::error_color;
use super::super::sign::sign;
use super::checks;
use crate::mistakes::Gallery;

/// Starts a riddle, goes to the next one, or back to the gallery.
pub(super) fn buttons(
    ui: &mut Ui,
    gallery: &mut Gallery,
    camera: &Camera,
    seen: Option<(&PosedCamera, &Scene)>,
) {
    ui.horizontal(|ui| {
        let text = if gallery.guess.is_some() { "Next one" } else { "Guess which" };
        let hint = "Shows a wrong camera without its name";
        let button = ui.add_enabled(seen.is_some(), egui::Button::new(text));
        if button.on_hover_text(hint).clicked()
            && let Some((posed, scene)) = seen
        {
            gallery.ask(&visible(camera, posed, scene));
        }
        if gallery.guess.is_some() && ui.button("Gallery").clicked() {
            gallery.chosen = gallery.shown();
            gallery.guess = None;
        }
    });
    if gallery.nothing_shows {
        ui.label("No mistake shows in this picture: bring an object into it.");
    }
    ui.add_space(3.0);
}

/// The question, or what is to be said of the answer.
pub(super) fn verdict(ui: &mut Ui, gallery: &Gallery, wrong: &ComparedCamera, camera: &Camera) {
    let Some(guess) = gallery.guess else { return };
    let Some(answer) = guess.answer else {
        ui.label(RichText::new("Which mistake is it?").size(18.0).strong());
        ui.label(
            "The picture on the right was made by one of the mistakes in the list. Drag the camera, \
             and click the one that it is.",
        );
        return;
    };
    let name = guess.mistake.name();
    let (text, is_right) = if answer == guess.mistake {
        (format!("Right: {name}."), true)
    } else if looks_the_same(camera, answer, wrong) {
        let same = answer.name();
        (format!("Right: {same} and {name} give the same picture. Here it is {name}."), true)
    } else {
        (format!("Not {}: it is {name}.", answer.name()), false)
    };
    let text = RichText::new(text).size(18.0).strong();
    ui.horizontal_top(|ui| {
        sign(ui, is_right);
        let text = if is_right { text } else { text.color(error_color(ui)) };
        ui.add(egui::Label::new(text).wrap());
    });
    let told: Vec<&str> = checks::failing(wrong).map(|c| c.check.formula()).collect();
    if !told.is_empty() {
        ui.label(format!("What would have told: {}.", told.join("; ")));
    }
    ui.add_space(6.0);
}

fn looks_the_same(camera: &Camera, answer: Mistake, wrong: &ComparedCamera) -> bool {
    match (WrongCamera::new(camera, answer), &wrong.camera) {
        (Ok(answer), Ok(wrong)) => answer.sees_the_same(wrong),
        _ => false,
    }
}
