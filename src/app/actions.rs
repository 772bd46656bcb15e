//! Carrying out what was asked for: opening, saving, quitting, and moving the selection.

use std::path::Path;
use std::sync::Arc;

use egui::{Context, ViewportCommand};

use super::App;
use crate::action::{Action, MadeUp};
use crate::derive::Deriver;
use crate::figures::ledger_of;
use crate::files::{OpenDocument, remember, title_of};
use crate::formats::scene_argument::SceneSource;
use crate::lessons::{self, Place, Which};
use crate::panels::dialogs::{Dialog, PathField};
use crate::session::{Selection, Session, ViewLayout};

impl App {
    /// Does it, or asks what stands in its way.
    pub(super) fn apply(&mut self, ctx: &Context, action: Action) {
        if self.end_play_for(ctx, &action) {
            return;
        }
        match action {
            Action::BackToStep if !self.differs_from_step() => {}
            Action::Open(_)
            | Action::Show(_)
            | Action::Quit
            | Action::GoTo(_)
            | Action::BackToStep
                if self.open.has_changes() =>
            {
                self.ask_about_changes(action);
            }
            Action::Open(_)
            | Action::Show(_)
            | Action::Quit
            | Action::GoTo(_)
            | Action::BackToStep => {
                self.proceed(ctx, action);
            }
            Action::Discard(then) => {
                self.discarded = matches!(*then, Action::Quit);
                self.proceed(ctx, *then);
            }
            Action::Next | Action::Previous => {
                let open = self.lessons.open.as_ref();
                let is_next = action == Action::Next;
                let to = open.and_then(|open| if is_next { open.next() } else { open.previous() });
                if let Some(place) = to {
                    self.apply(ctx, Action::GoTo(place));
                }
            }
            Action::CloseLesson if self.lessons.open.is_none() => {}
            Action::CloseLesson => self.close_lesson(ctx),
            Action::SaveThen(then) => self.save(ctx, Some(then)),
            Action::AskOpen => {
                self.dialog = Some(Dialog::Open(PathField::near(self.open.file(), "")));
            }
            Action::AskAnswers => self.ask_answers(),
            Action::CheckAnswers(path) => self.check_answers(&path),
            Action::PutAnswersAway => self.put_answers_away(),
            Action::Save => self.save(ctx, None),
            Action::AskSaveAs => self.ask_save_as(None),
            Action::SaveAs { path, then } => self.save_then(ctx, &path, then),
            Action::AskExport => self.ask_export(ctx),
            Action::AskExportAnimation => self.ask_export_animation(ctx),
            Action::ExportAnimation { order, frames, path } => {
                self.export_animation(order, frames, path);
            }
            Action::Export { order, path } => self.export(&order, &path),
            Action::CopyLedger(markup) => {
                let ledger = ledger_of(&self.open.document, &self.session);
                ctx.copy_text(ledger.written_in(markup));
            }
            Action::Undo => self.undo(ctx),
            Action::Redo => self.redo(ctx),
            Action::Ghost(ghost) => self.move_ghost(ctx, ghost),
            Action::Play(play) => self.play(ctx, play),
            Action::FrameAll => {
                // The next frame, which knows the view's proportions, frames everything.
                self.session.observer = None;
                ctx.request_repaint();
            }
            Action::Step { rows, columns } => {
                if let Ok(posed) = self.open.document.camera.posed() {
                    let selection = self.session.selection.inside(posed.image());
                    self.session.selection = selection.stepped(&posed, rows, columns);
                }
            }
            look => self.change_look(ctx, look),
        }
    }

    /// Opens the other scene or step, or closes the window: nothing stands in the way any more.
    fn proceed(&mut self, ctx: &Context, action: Action) {
        let before = self.whereabouts(ctx);
        match action {
            Action::Open(source) => self.load(ctx, source),
            Action::Show(made_up) => self.show(ctx, *made_up),
            Action::GoTo(place) => self.go_to(ctx, place),
            Action::BackToStep => self.back_to_step(ctx),
            _ => {
                self.may_close = true;
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
        }
        self.went_elsewhere(before);
    }

    /// Saves to the scene's own file, or asks for one.
    fn save(&mut self, ctx: &Context, then: Option<Box<Action>>) {
        match self.open.file().map(Path::to_owned) {
            Some(path) => self.save_then(ctx, &path, then),
            None => self.ask_save_as(then),
        }
    }

    fn save_then(&mut self, ctx: &Context, path: &Path, then: Option<Box<Action>>) {
        self.save_to(path);
        if let Some(then) = then.filter(|_| !self.open.has_changes()) {
            self.apply(ctx, *then);
        }
    }

    pub(super) fn ask_about_changes(&mut self, then: Action) {
        self.dialog = Some(Dialog::Unsaved { title: title_of(self.open.origin()), then });
    }

    fn ask_save_as(&mut self, then: Option<Box<Action>>) {
        let field = PathField::near(self.open.file(), &self.open.file_name());
        self.dialog = Some(Dialog::SaveAs { field, then });
    }

    /// Opens a document from no file, with both views beside it.
    fn show(&mut self, ctx: &Context, made_up: MadeUp) {
        let MadeUp { document, title, uv } = made_up;
        self.close_lesson(ctx);
        self.open = OpenDocument::of_step(document, title);
        // It can be got again, but what is changed in it counts.
        self.open.leave_lesson();
        self.deriver = Deriver::default();
        self.session.observer = None;
        self.session.ghost = None;
        self.session.selection = uv.map_or(Session::default().selection, Selection::Uv);
        self.session.settings.layout = ViewLayout::Both;
        self.chosen_object = 0;
    }

    fn load(&mut self, ctx: &Context, source: SceneSource) {
        if let SceneSource::File(path) = &source
            && lessons::is_lesson(path)
        {
            return self.load_lesson(path);
        }
        match source.load() {
            Ok(document) => {
                if let SceneSource::File(path) = &source {
                    remember(&mut self.recent, path);
                }
                self.close_lesson(ctx);
                self.open = OpenDocument::new(document, source);
                // What was good in another scene is nothing to show in this one.
                self.deriver = Deriver::default();
                self.session.observer = None;
                self.session.ghost = None;
                self.session.selection = Session::default().selection;
                self.chosen_object = 0;
            }
            Err(error) => self.tell("This scene cannot be opened", error.to_string()),
        }
    }

    fn load_lesson(&mut self, path: &Path) {
        match lessons::load(path) {
            Ok(lesson) => {
                remember(&mut self.recent, path);
                let place = Place { lesson: Which::File, step: 0 };
                self.open_lesson(place, Some(Arc::new(lesson)));
            }
            Err(error) => self.tell("This lesson cannot be opened", error.to_string()),
        }
    }

    pub(super) fn save_to(&mut self, path: &Path) {
        match self.open.save_to(path) {
            Ok(()) => {
                self.settled();
                remember(&mut self.recent, path);
            }
            Err(reason) => self.tell("The scene was not saved", reason),
        }
    }
}
