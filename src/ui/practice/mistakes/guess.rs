//! "Guess which": a wrong camera without its name, the class's answer, and the checks that would
//! have told.

use egui::{RichText, Ui};
use pinhole_core::{Camera, ResolvedCamera, Scene};
use pinhole_lecture::mistakes::{ComparedCamera, Mistake, WrongCamera, visible};

use super::checks;
use crate::model::practice::mistakes_view::MistakesView;
use crate::ui::widgets::sign::sign;
use crate::view::typesetting::theme::error_color;

/// Shows the buttons that start a question, go to the next one, or return to the gallery.
pub(super) fn buttons(
    ui: &mut Ui,
    mistakes_view: &mut MistakesView,
    camera: &Camera,
    seen: Option<(&ResolvedCamera, &Scene)>,
) {
    ui.horizontal(|ui| {
        let text = if mistakes_view.guess.is_some() { "Next one" } else { "Guess which" };
        let hint = "Shows a wrong camera without its name";
        let button = ui.add_enabled(seen.is_some(), egui::Button::new(text));
        if button.on_hover_text(hint).clicked()
            && let Some((resolved, scene)) = seen
        {
            mistakes_view.ask(&visible(camera, resolved, scene));
        }
        if mistakes_view.guess.is_some() && ui.button("Gallery").clicked() {
            mistakes_view.chosen = mistakes_view.shown();
            mistakes_view.guess = None;
        }
    });
    if mistakes_view.nothing_shows {
        ui.label("No mistake shows in this picture: bring an object into it.");
    }
    ui.add_space(3.0);
}

/// Shows the question, or the verdict on the answer.
pub(super) fn verdict(
    ui: &mut Ui,
    mistakes_view: &MistakesView,
    wrong: &ComparedCamera,
    camera: &Camera,
) {
    let Some(guess) = mistakes_view.guess else { return };
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
    let failing: Vec<&str> = checks::failing(wrong).map(|c| c.check.formula()).collect();
    if !failing.is_empty() {
        ui.label(format!("What would have told: {}.", failing.join("; ")));
    }
    ui.add_space(6.0);
}

fn looks_the_same(camera: &Camera, answer: Mistake, wrong: &ComparedCamera) -> bool {
    match (WrongCamera::new(camera, answer), &wrong.camera) {
        (Ok(answer), Ok(wrong)) => answer.sees_the_same(wrong),
        _ => false,
    }
}
