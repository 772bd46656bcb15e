//! The program laid out in memory as it is in a window.

use egui::{Ui, UiBuilder};
use pinhole::ui::app::App;

/// Shows the program on all of the window. A test harness leaves a margin around what it shows; a
/// real window has none.
pub(crate) fn show(ui: &mut Ui, app: &mut App) {
    let window = ui.ctx().content_rect();
    ui.scope_builder(UiBuilder::new().max_rect(window), |ui| {
        ui.set_clip_rect(window);
        app.ui(ui);
    });
}
