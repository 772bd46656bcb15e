//! Carrying out what was asked for: opening, saving, quitting, and moving the selection.

use std::path::Path;
use std::sync::Arc;

use egui::{Context, ViewportCommand};

use super::App;
use crate::action::{Action, MadeUp, ObjectMove, Observe};
use crate::derive::Deriver;
use crate::figures::derivation_of;
use crate::files::{OpenDocument, remember, title_of};
use crate::formats::scene_argument::SceneSource;
use crate::lessons::{self, Place, Which};
use crate::panels::dialogs::{Dialog, PathField};
use crate::panels::objects;
use crate::session::{Selection, Session, ViewLayout};

/// A step of the observer by a key: an angle in radians, a share of the picture's height, and how many
/// times nearer.
const TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;
const PAN: f64 = 0.05;
const ZOOM: f64 = 1.15;

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
                self.dialog = Some(Dialog::Open(PathField::to_open(self.open.file())));
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
                let ledger = derivation_of(&self.open.document, &self.session);
                ctx.copy_text(ledger.written_in(markup));
            }
            Action::AskPaste => self.ask_paste(ctx),
            Action::Paste(text) => self.paste(ctx, &text),
            Action::AskTranslate => self.ask_translate(),
            Action::Translate(path) => self.translate(&path),
            Action::Undo => self.undo(ctx),
            Action::Redo => self.redo(ctx),
            Action::Ghost(ghost) => self.move_ghost(ctx, ghost),
            Action::Play(play) => self.play(ctx, play),
            Action::Steer(steer) => {
                let time = ctx.input(|i| i.time);
                self.navigation.steer(steer, &mut self.open.document.camera, time);
                ctx.request_repaint();
            }
            Action::Observe(observe) => self.observe(ctx, observe),
            Action::Object(object) => self.change_objects(ctx, object),
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

    fn observe(&mut self, ctx: &Context, observe: Observe) {
        let aspect = self.world_aspect();
        let Some(observer) = &mut self.session.observer else { return };
        match observe {
            Observe::Orbit(right, up) => {
                observer.orbit(TURN * f64::from(right), TURN * f64::from(up));
            }
            Observe::Pan(right, up) => observer.pan(-PAN * f64::from(right), PAN * f64::from(up)),
            Observe::Zoom(steps) => observer.zoom(ZOOM.powi(steps)),
            Observe::FrameCamera => {
                *observer = observer.framing_camera(&self.open.document.camera, aspect);
            }
        }
        ctx.request_repaint();
    }

    /// Width by height of the world view as it was seen last.
    pub(super) fn world_aspect(&self) -> f64 {
        let seen = self.derived.world_view.as_ref().map(|shown| shown.image.size);
        seen.map_or(1.25, |[width, height]| width as f64 / height.max(1) as f64)
    }

    fn change_objects(&mut self, ctx: &Context, object: ObjectMove) {
        let document = &mut self.open.document;
        let count = document.object_count();
        let chosen = self.chosen_object.min(count.saturating_sub(1));
        match object {
            ObjectMove::AddSphere => self.chosen_object = objects::add_sphere(document),
            ObjectMove::AddPlane => self.chosen_object = objects::add_plane(document),
            ObjectMove::Choose(index) if index < count => self.chosen_object = index,
            ObjectMove::Next(by) if count > 0 => {
                let next = (chosen as i64 + i64::from(by)).rem_euclid(count as i64);
                self.chosen_object = next as usize;
            }
            ObjectMove::Remove if count > 0 => {
                if let Err(reason) = objects::remove(document, chosen) {
                    self.tell("This object was not removed", reason);
                }
            }
            _ => return,
        }
        ctx.request_discard("another object is chosen");
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
        match self.open.scene_file().map(Path::to_owned) {
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
        let field = PathField::to_save(self.open.file(), &self.open.file_name());
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
