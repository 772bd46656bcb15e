//! A camera from the clipboard, and the translator's text to a file.

use egui::{Context, Event};
use pinhole_exchange::format::{ExportScene, Exported};

use super::scene::OpenScene;
use crate::model::files::{files_of, save_written};
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
    let written = translated(scene)?;
    let target = scene.session.translator.chosen();
    let (name, ending) = match written.files.len() {
        1 => (written.files[0].0, target.ending()),
        // A folder has no ending.
        _ => (target.name(), ""),
    };
    let question = FileQuestion {
        title: "Save the camera for another program",
        verb: "Save",
        endings: &[],
        hint: "path of the file",
        writes: Some(ending),
    };
    Some(Dialog::Translate(PathField::new(question, scene.open.file(), name)))
}

/// Writes the translator's text, or its files into a folder; what there is to tell if that fails.
pub(super) fn save(scene: &OpenScene, path: &std::path::Path) -> Option<Dialog> {
    let written = translated(scene)?;
    let files = files_of(&written, path);
    let saved = files
        .iter()
        .try_for_each(|(path, _)| scene.open.check_output(path))
        .and_then(|()| save_written(&written, path).map_err(|error| error.to_string()));
    saved.err().map(|error| Dialog::message("The camera was not saved", error))
}
