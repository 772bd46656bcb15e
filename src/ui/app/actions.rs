//! Carrying out what was asked for: opening, saving, quitting, and moving the selection.

use std::path::Path;
use std::sync::Arc;

use egui::{Context, ViewportCommand};

use super::App;
use crate::model::files::{OpenDocument, remember, title_of};
use crate::model::lessons::{self, Place, Which};
use crate::model::session::{Selection, Session, ViewLayout};
use crate::ui::action::{
    Action, FileAction, HistoryAction, Leave, LessonAction, MadeUp, ObjectAction, Observe,
};
use crate::ui::dialogs::dialog::{Dialog, PathField};
use crate::ui::panels::objects;
use crate::view::derive::Deriver;
use pinhole_exchange::scenes::SceneSource;

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
            Action::Leave(leave) => self.leave(ctx, leave),
            Action::File(action) => self.file(ctx, action),
            Action::Lesson(action) => self.lesson_action(ctx, action),
            Action::History(HistoryAction::Undo) => self.undo(ctx),
            Action::History(HistoryAction::Redo) => self.redo(ctx),
            Action::Figure(action) => self.figure(ctx, action),
            Action::Exchange(action) => self.exchange(ctx, action),
            Action::Answers(action) => self.answers(action),
            Action::Ghost(ghost) => self.move_ghost(ctx, ghost),
            Action::Play(play) => self.play(ctx, play),
            Action::Steer(steer) => {
                let time = ctx.input(|i| i.time);
                self.navigation.steer(steer, &mut self.open.document.camera, time);
                ctx.request_repaint();
            }
            Action::Observe(observe) => self.observe(ctx, observe),
            Action::Object(object) => self.change_objects(ctx, object),
            Action::Select { rows, columns } => {
                if let Ok(resolved) = self.open.document.camera.resolve() {
                    let selection = self.session.selection.inside(resolved.image());
                    self.session.selection = selection.stepped(&resolved, rows, columns);
                }
            }
            Action::Look(look) => self.change_look(ctx, look),
            Action::Overlay(overlay) => self.lay_over(ctx, overlay),
        }
    }

    /// Goes elsewhere, or asks first about unsaved changes.
    fn leave(&mut self, ctx: &Context, leave: Leave) {
        if leave == Leave::BackToStep && !self.differs_from_step() {
            return;
        }
        if self.open.has_changes() {
            self.ask_about_changes(leave);
        } else {
            self.proceed(ctx, leave);
        }
    }

    fn file(&mut self, ctx: &Context, action: FileAction) {
        match action {
            FileAction::AskOpen => {
                self.dialog = Some(Dialog::Open(PathField::to_open(self.open.file())));
            }
            FileAction::Save => self.save(ctx, None),
            FileAction::AskSaveAs => self.ask_save_as(None),
            FileAction::SaveAs { path, then } => self.save_then(ctx, &path, then),
            FileAction::SaveThen(leave) => self.save(ctx, Some(leave)),
            FileAction::Discard(leave) => {
                self.discarded = leave == Leave::Quit;
                self.proceed(ctx, leave);
            }
        }
    }

    fn lesson_action(&mut self, ctx: &Context, action: LessonAction) {
        let Some(open) = &self.lessons.open else { return };
        let to = match action {
            LessonAction::Next => open.next(),
            LessonAction::Previous => open.previous(),
            LessonAction::Close => return self.close_lesson(ctx),
        };
        if let Some(place) = to {
            self.apply(ctx, Leave::GoTo(place).into());
        }
    }

    fn observe(&mut self, ctx: &Context, observe: Observe) {
        let aspect = self.world_aspect();
        // The next frame, which knows the view's proportions, frames everything.
        if observe == Observe::FrameAll {
            self.session.observer = None;
        }
        ctx.request_repaint();
        let Some(observer) = &mut self.session.observer else { return };
        match observe {
            Observe::FrameAll => {}
            Observe::Orbit(right, up) => {
                observer.orbit(TURN * f64::from(right), TURN * f64::from(up));
            }
            Observe::Pan(right, up) => observer.pan(-PAN * f64::from(right), PAN * f64::from(up)),
            Observe::Zoom(steps) => observer.zoom(ZOOM.powi(steps)),
            Observe::FrameCamera => {
                *observer = observer.framing_camera(&self.open.document.camera, aspect);
            }
        }
    }

    /// Width by height of the world view as it was seen last.
    pub(super) fn world_aspect(&self) -> f64 {
        let seen = self.derived.world_view.as_ref().map(|shown| shown.image.size);
        seen.map_or(1.25, |[width, height]| width as f64 / height.max(1) as f64)
    }

    fn change_objects(&mut self, ctx: &Context, object: ObjectAction) {
        let document = &mut self.open.document;
        let count = document.object_count();
        let chosen = self.chosen_object.min(count.saturating_sub(1));
        match object {
            ObjectAction::AddSphere => self.chosen_object = objects::add_sphere(document),
            ObjectAction::AddPlane => self.chosen_object = objects::add_plane(document),
            ObjectAction::Choose(index) if index < count => self.chosen_object = index,
            ObjectAction::Next(by) if count > 0 => {
                let next = (chosen as i64 + i64::from(by)).rem_euclid(count as i64);
                self.chosen_object = next as usize;
            }
            ObjectAction::Remove if count > 0 => {
                if let Err(reason) = objects::remove(document, chosen) {
                    self.tell("This object was not removed", reason);
                }
            }
            _ => return,
        }
        ctx.request_discard("another object is chosen");
    }

    /// Opens the other scene or step, or closes the window: nothing stands in the way any more.
    fn proceed(&mut self, ctx: &Context, leave: Leave) {
        let before = self.whereabouts(ctx);
        match leave {
            Leave::Open(source) => self.load(ctx, source),
            Leave::Show(made_up) => self.show(ctx, *made_up),
            Leave::GoTo(place) => self.go_to(ctx, place),
            Leave::BackToStep => self.back_to_step(ctx),
            Leave::Quit => {
                self.may_close = true;
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
        }
        self.went_elsewhere(before);
    }

    /// Saves to the scene's own file, or asks for one.
    fn save(&mut self, ctx: &Context, then: Option<Leave>) {
        match self.open.scene_file().map(Path::to_owned) {
            Some(path) => self.save_then(ctx, &path, then),
            None => self.ask_save_as(then),
        }
    }

    fn save_then(&mut self, ctx: &Context, path: &Path, then: Option<Leave>) {
        self.save_to(path);
        if let Some(then) = then.filter(|_| !self.open.has_changes()) {
            self.apply(ctx, then.into());
        }
    }

    pub(super) fn ask_about_changes(&mut self, then: Leave) {
        self.dialog = Some(Dialog::Unsaved { title: title_of(self.open.origin()), then });
    }

    fn ask_save_as(&mut self, then: Option<Leave>) {
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
