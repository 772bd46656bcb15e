//! A camera from the clipboard, and the translator's text to a file.

use std::path::Path;

use egui::{Context, Event, ViewportCommand};

use super::App;
use crate::model::files::save_written;
use crate::model::session::ViewLayout;
use crate::model::translator::{pasted, with};
use crate::ui::action::{Action, ExchangeAction};
use crate::ui::dialogs::dialog::{Dialog, PathField};
use crate::ui::tools::translator;
use pinhole_exchange::format::{ExportScene, Exported};

impl App {
    /// A text that was pasted while nothing is typed into.
    pub(super) fn pasted_text(&self, ctx: &Context, actions: &mut Vec<Action>) {
        if self.is_covered() || ctx.text_edit_focused() {
            return;
        }
        let text = ctx.input(|input| {
            input.events.iter().find_map(|event| match event {
                Event::Paste(text) => Some(text.clone()),
                _ => None,
            })
        });
        actions.extend(text.map(|text| ExchangeAction::Paste(text).into()));
    }

    pub(super) fn exchange(&mut self, ctx: &Context, action: ExchangeAction) {
        match action {
            ExchangeAction::AskPaste => {
                // It comes as if it was pasted by its keys.
                ctx.send_viewport_cmd(ViewportCommand::RequestPaste);
                ctx.request_repaint();
            }
            ExchangeAction::Paste(text) => self.paste(ctx, &text),
            ExchangeAction::TranslateInto(name) => {
                self.session.translator.target = name;
                self.session.settings.layout = ViewLayout::Translator;
                ctx.request_discard("the translator is shown");
            }
            ExchangeAction::AskSave => self.ask_translate(),
            ExchangeAction::Save(path) => self.translate(&path),
        }
    }

    /// Sets the camera from a text, as one step of the history; or says what is wrong with it.
    fn paste(&mut self, ctx: &Context, text: &str) {
        let (camera, said) = pasted(text, &self.open.document.camera);
        if let Some(camera) = camera {
            self.keep_play(ctx);
            self.settle(ctx);
            let image = self.open.document.camera.image;
            self.session.selection = self.session.selection.in_another_image(image, camera.image);
            self.open.document.camera = camera;
            self.settle_as(ctx, Some("paste a camera"));
        }
        self.session.translator.pasted = Some(said);
        ctx.request_discard("a camera was pasted");
    }

    /// What became of the last paste, until the camera is another one.
    pub(super) fn paste_notice(&mut self, ctx: &Context) {
        let pasted = &mut self.session.translator.pasted;
        if pasted.as_ref().is_some_and(|said| said.camera != self.open.document.camera) {
            *pasted = None;
        }
        translator::notice(ctx, pasted);
    }

    fn translated(&self) -> Option<Exported> {
        let translator = &self.session.translator;
        let with = with(&self.open.document, translator.objects);
        let subject = ExportScene::new(&self.open.document, with).ok()?;
        translator.chosen().write(&subject).ok()
    }

    /// Asks where to write the translator's text.
    fn ask_translate(&mut self) {
        let Some(written) = self.translated() else { return };
        let target = self.session.translator.chosen();
        let (name, ending) = match written.files.len() {
            1 => (written.files[0].0, target.ending()),
            // A folder has no ending.
            _ => (target.name(), ""),
        };
        let field = PathField::of_exchange(self.open.file(), name);
        self.dialog = Some(Dialog::Translate { field, ending });
    }

    /// Writes the translator's text, or its files into a folder.
    fn translate(&mut self, path: &Path) {
        let Some(written) = self.translated() else { return };
        if let Err(error) = save_written(&written, path) {
            self.tell("The camera was not saved", error.to_string());
        }
    }
}
