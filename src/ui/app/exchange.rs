//! A camera from the clipboard, and the translator's text to a file.

use egui::{Context, Event};
use pinhole_exchange::format::{ExportScene, Exported};

use super::scene::OpenScene;
use crate::model::files::save_written;
use crate::model::translator::with;
use crate::ui::changed::Changed;
use crate::ui::dialogs::dialog::{Dialog, PathField};
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

/// Tells what became of the last paste, until the camera is another one.
pub(super) fn paste_notice(ctx: &Context, scene: &mut OpenScene) -> Changed {
    let pasted = &mut scene.session.translator.pasted;
    let was_there = pasted.is_some();
    if pasted.as_ref().is_some_and(|said| said.camera != scene.open.document.camera) {
        *pasted = None;
    }
    translator::notice(ctx, pasted);
    Changed::SESSION.when(pasted.is_some() != was_there)
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
    let field = PathField::new(scene.open.file(), name, &[], "path of the file");
    Some(Dialog::Translate { field, ending })
}

/// Writes the translator's text, or its files into a folder; what there is to tell if that fails.
pub(super) fn save(scene: &OpenScene, path: &std::path::Path) -> Option<Dialog> {
    let saved = save_written(&translated(scene)?, path);
    saved.err().map(|error| Dialog::message("The camera was not saved", error))
}
