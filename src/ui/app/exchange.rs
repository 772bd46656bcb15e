//! A camera from the clipboard, and the translator's text to a file.

use std::io::Write as _;
use std::path::Path;

use egui::{Context, Event};
use pinhole_exchange::atomic;
use pinhole_exchange::format::{ExportScene, Exported};

use super::scene::OpenScene;
use crate::model::translator::with;
use crate::ui::dialogs::dialog::Dialog;
use crate::ui::dialogs::path_field::{FileQuestion, PathField};
use crate::ui::tools::translator;

/// A text that was pasted while nothing is typed into.
pub(super) fn pasted_text(ctx: &Context) -> Option<String> {
    if ctx.text_edit_focused() {
        return None;
    }
    ctx.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::Paste(text) => Some(text.clone()),
            _ => None,
        })
    })
}

/// Tells what was done last that nobody sees else; of a camera, until it is another one.
pub(super) fn notice(ctx: &Context, scene: &mut OpenScene) {
    let notice = &mut scene.session.translator.notice;
    let camera = notice.as_ref().and_then(|said| said.camera);
    if camera.is_some_and(|camera| camera != scene.open.document.camera) {
        *notice = None;
    }
    translator::notice(ctx, notice);
}

fn translated(scene: &OpenScene) -> Option<Exported> {
    let translator = &scene.session.translator;
    let with = with(&scene.open.document, translator.objects);
    let subject = ExportScene::new(&scene.open.document, with).ok()?;
    translator.chosen().write(&subject).ok()
}

/// Asks where to write the translator's text.
pub(super) fn ask_where_to_save(scene: &OpenScene) -> Option<Dialog> {
    translated(scene)?;
    let format = scene.session.translator.chosen();
    let question = FileQuestion {
        title: "Save the camera for another program",
        verb: "Save",
        endings: &[],
        hint: "path of the file",
        writes: Some(format.ending()),
    };
    Some(Dialog::Translate(PathField::new(question, scene.open.file(), format.file)))
}

/// Writes the translator's text; what there is to tell if that fails.
pub(super) fn save(scene: &OpenScene, path: &Path) -> Option<Dialog> {
    let text = translated(scene)?.text.text;
    let write = |()| {
        let written = atomic::write(path, |file| file.write_all(text.as_bytes()));
        written.map_err(|error| error.to_string())
    };
    let saved = scene.open.check_output(path).and_then(write);
    saved.err().map(|error| Dialog::message("The camera was not saved", error))
}
