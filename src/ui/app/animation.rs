//! Exporting the animation that is open: a frame a pass of the window, which so stays alive.

use std::path::PathBuf;

use egui::Context;

use super::App;
use crate::figures::{Animation, Frames, Order, Recorder, Subject};
use crate::model::session::Session;
use crate::ui::dialogs::dialog::Dialog;
use crate::ui::dialogs::export::ExportForm;
use crate::view::overlay::Style;

impl App {
    /// Opens the dialog, with the world view chosen.
    pub(super) fn ask_export_animation(&mut self, ctx: &Context) {
        let Some(player) = &mut self.player else { return };
        player.running = false;
        let kind = player.kind;
        let subjects =
            [Subject::World, Subject::Camera].map(|subject| self.on_screen(ctx, subject));
        let dark = ctx.theme() == egui::Theme::Dark;
        let style = if dark { Style::Dark } else { Style::Light };
        let form = ExportForm::new(self.open.file(), subjects.to_vec(), style);
        self.dialog = Some(Dialog::Export(form.animated(kind)));
    }

    /// Begins to write the animation that is open.
    pub(super) fn export_animation(&mut self, order: Order, frames: Frames, path: PathBuf) {
        let Some(player) = &self.player else { return };
        let session = Session { hovered: None, ..self.session.clone() };
        let animation = Animation {
            kind: player.kind,
            start: player.start,
            loops: player.loops,
            scene: (self.open.document.clone(), session),
            order,
            frames,
        };
        match Recorder::new(animation, path) {
            Ok(recorder) => {
                self.dialog = Some(Dialog::Progress { done: 0, of: frames.count });
                self.recorder = Some(recorder);
            }
            Err(problem) => self.tell("The animation was not exported", problem),
        }
    }

    /// Makes the next frame, if something is being exported; nothing is left of it where its dialog
    /// was closed.
    pub(super) fn record(&mut self, ctx: &Context) {
        let Some(recorder) = &mut self.recorder else { return };
        let Some(Dialog::Progress { done, of }) = &mut self.dialog else {
            self.recorder = None;
            return;
        };
        let stepped = recorder.step();
        (*done, *of) = recorder.progress();
        let ended = match stepped {
            Ok(()) if *done < *of => {
                ctx.request_repaint();
                return;
            }
            Ok(()) => self.recorder.take().map_or(Ok(()), Recorder::finish),
            Err(problem) => Err(problem),
        };
        (self.recorder, self.dialog) = (None, None);
        if let Err(problem) = ended {
            self.tell("The animation was not exported", problem);
        }
        ctx.request_repaint();
    }
}
