//! The page that is shown after a fault of the program itself, in place of a frame that would meet it
//! again: the scene is kept, and the user chooses how to go on.

use egui::{CentralPanel, RichText, Ui};

use super::App;
use crate::model::panics::caught;
use crate::ui::action::HistoryAction;
use crate::view::derive::Deriver;

impl App {
    /// One frame, or the page about the fault of the last one.
    pub fn ui(&mut self, ui: &mut Ui) {
        let shown = match self.failure.take() {
            Some(failure) => caught(|| self.failure_page(ui, failure)),
            None => caught(|| self.frame(ui)),
        };
        if let Err(failure) = shown {
            self.failure = Some(failure);
            // Whatever was half done is done anew.
            self.waiting.clear();
            self.over.dialog = None;
            self.views.deriver = Deriver::default();
            // The pass did not come as far as to note the edit that it met its fault by.
            self.recovery.write_changes(&self.scene.open);
            ui.ctx().request_repaint();
        }
    }

    fn failure_page(&mut self, ui: &mut Ui, failure: String) {
        let ctx = ui.ctx().clone();
        if self.window.is_to_close(&ctx) {
            // The changes are offered at the next start.
            self.window.let_close(&ctx, true);
        }
        // What was changed last may have no name yet.
        self.history.settle(&ctx, &self.scene.open.document);
        let mut stays = true;
        CentralPanel::default().show(ui, |ui| {
            ui.heading("Pinhole met a fault of its own");
            ui.label("The scene is kept, and unsaved changes are written aside.");
            ui.add_space(8.0);
            ui.label(RichText::new(&failure).monospace());
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                stays &= !ui.button("Go on").clicked();
                let can_undo = self.history.steps.undo_name().is_some();
                let undo = ui.add_enabled(can_undo, egui::Button::new("Undo and go on"));
                if undo.on_hover_text("Goes on without the last change").clicked() {
                    self.history.apply(&ctx, HistoryAction::Undo, &mut self.scene);
                    stays = false;
                }
                if ui.button("Copy a report").clicked() {
                    ctx.copy_text(self.report_of(&failure));
                }
            });
        });
        if stays {
            self.failure = Some(failure);
        } else {
            ctx.request_repaint();
        }
    }

    /// The text for those who mend the program.
    fn report_of(&self, failure: &str) -> String {
        let (version, system) = (env!("CARGO_PKG_VERSION"), std::env::consts::OS);
        let scene = pinhole_exchange::scene_file::to_text(self.document(), None);
        let renderer = &self.window.renderer;
        format!("Pinhole {version} on {system}, drawn by {renderer}\n{failure}\n\n{scene}")
    }
}
