//! Reasons why there is nothing to see.

use std::fmt::Display;

use egui::{Align, Layout, Rect, RichText, Ui, UiBuilder};

use crate::model::letters::typeset_message;
use crate::view::typesetting::theme::error_color;

/// Returns a message in the colour of errors.
pub(crate) fn fault_text(ui: &Ui, message: impl Display) -> RichText {
    RichText::new(typeset_message(message)).color(error_color(ui))
}

/// Shows, in place of a picture, the reason why there is none.
pub(crate) fn no_picture(ui: &mut Ui, rect: Rect, reason: &str) {
    ui.painter().rect_filled(rect, 4.0, ui.visuals().faint_bg_color);
    let inside = rect.shrink(16.0);
    let layout = Layout::top_down(Align::Center).with_main_align(Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(inside).layout(layout), |ui| {
        ui.set_clip_rect(rect);
        ui.add_space((0.5 * inside.height() - 40.0).max(0.0));
        ui.label(RichText::new(reason).size(17.0).strong());
    });
}
