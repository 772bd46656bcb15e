//! Applies the actions that were requested in an egui pass, each to the part of the window that it concerns.
//! Presenter mode and the window's colours and sizes are handled here.

use std::path::Path;

use egui::{Context, Event, Id, Popup, ThemePreference, ViewportCommand};
use pinhole_core::Selection;
use pinhole_exchange::legible;
use pinhole_exchange::scenes::SceneSource;
use pinhole_figure::typesetting::theme::{self, Look};

use crate::features::mistakes::MistakesView;
use crate::features::translator::state::{Notice, Taken, pasted};
use crate::features::vote;
use crate::model::files::{OpenDocument, title_of};
use crate::model::lessons::OpenLesson;
use crate::model::session::presenting::{self, PEN_COLORS, Presenting, SMALLEST_TEXT};
use crate::model::session::{Preferences, Session, Settings, ThemeName, ViewLayout, ZOOM};
use crate::ui::action::{
    Action, FileAction, FileUse, Leave, LessonAction, LookAction, Observe, PlayAction, ShareAction,
};
use crate::ui::app::App;
use crate::ui::app::scene::Opened;
use crate::ui::dialogs::palette::CommandPalette;
use crate::ui::dialogs::{Question, help};
use crate::ui::widgets::may_explain;
use crate::view::derive::Deriver;

/// The title of the message about a file that was changed and cannot be read.
pub(super) const NOT_READ: &str = "The changed scene cannot be read";

impl App {
    /// Applies the action.
    pub(super) fn apply(&mut self, ctx: &Context, action: Action) {
        // During an animation that moves the camera, undo only ends the animation.
        let is_undone = action == Action::Undo && self.playback.plays_camera();
        // Opening something else restores the camera from before the animation; saving keeps the camera
        // as it is shown.
        match &action {
            Action::Leave(_)
            | Action::Share(ShareAction::Follow(_))
            | Action::Undo
            | Action::Redo
            | Action::File(FileAction::Discard(_) | FileAction::TakeTheirs(_))
            // The other lesson actions stop the animation once they know that there is a step to open.
            | Action::Lesson(LessonAction::Close) => self.stop_animation(),
            Action::File(FileAction::CheckFile | FileAction::DiscardRecovered) => {}
            Action::File(_) => self.keep_animation(ctx),
            Action::Ask(of) | Action::Use(of, _) if of.saves_scene() => self.keep_animation(ctx),
            _ => {}
        }
        // The menu in which it was chosen may stay open for several clicks.
        if let Action::Ask(_)
        | Action::Look(LookAction::Present)
        | Action::Lesson(LessonAction::Vote)
        | Action::Vote(_) = action
        {
            Popup::close_all(ctx);
        }
        if !is_undone {
            self.carry_out(ctx, action);
        }
        ctx.request_repaint();
    }

    /// Applies the action, which may open a dialog.
    fn carry_out(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::Leave(Leave::New) if !action.is_possible(self.available()) => {}
            Action::Object(_) if !action.is_possible(self.available()) => {
                if self.page().has_panel && self.question.is_none() {
                    let note = "Click a sphere in the world view, or an object in the list.";
                    self.say("No object is chosen".to_owned(), vec![note.to_owned()]);
                }
            }
            Action::Leave(leave) => self.leave(ctx, leave),
            Action::Ask(of) => self.ask(of),
            Action::Use(of, path) => self.use_file(ctx, of, path),
            Action::File(action) => self.file(ctx, action),
            Action::Lesson(action) => self.lesson_action(ctx, action),
            Action::Undo => self.undo_or_redo(ctx, false),
            Action::Redo => self.undo_or_redo(ctx, true),
            Action::Figure(action) => self.figure_action(ctx, action),
            // The text arrives later, as a paste event, like text pasted with the keyboard.
            Action::AskPaste => ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
            Action::Paste(text) => {
                let taken = pasted(&text, &self.scene.open.document.camera);
                self.take_camera(ctx, taken, "paste a camera");
            }
            Action::Share(action) => self.share(ctx, action),
            Action::Answers(action) => self.answers_action(action),
            Action::Play(action) => self.play(ctx, action),
            Action::FreezeGhost => self.scene.freeze_ghost(),
            Action::DropGhost => self.scene.drop_ghost(),
            Action::Give(given, value) => self.scene.give(ctx, given, value),
            Action::Steer(steer) => {
                let time = ctx.input(|i| i.time);
                self.dragging.steer(steer, &mut self.scene.open.document.camera, time);
            }
            Action::Observe(observe) => {
                use Observe::{Along, FrameAll, FrameCamera, FrameSphere};
                let size = self.views.world_size();
                // The observer jumps to another view, rather than moving by steps.
                if let Along(_) | FrameAll | FrameCamera | FrameSphere(_) = observe {
                    self.views.glide.begin(ctx);
                }
                self.question.as_mut().unwrap_or(&mut self.scene).observe(observe, size);
            }
            Action::Object(action) => {
                if let Err((title, reason)) = self.scene.change_objects(action) {
                    self.tell(title, reason);
                }
            }
            // An exercise has no pixel to select.
            Action::Select { .. } if self.question.is_some() => {}
            Action::Select { rows, columns } => self.scene.step_selection(rows, columns),
            Action::Look(action) => self.look_action(action),
            Action::Vote(action) => vote::ui::apply(ctx, &mut self.scene.session, action),
            Action::OpenContents => {
                let now = self.lesson().and_then(OpenLesson::number_of_all);
                let chosen = now.map_or(0, |[number, _]| number - 1);
                self.over.palette = Some(CommandPalette::contents(chosen));
            }
            Action::OpenPalette => self.over.palette = Some(CommandPalette::default()),
            Action::ShowKeys => self.over.shows_keys = true,
            Action::ShowConventions => self.over.open(help::conventions()),
            Action::ShowAbout => self.over.open(help::about()),
        }
    }

    /// Changes what is shown, or says why there is nothing to show.
    fn look_action(&mut self, action: LookAction) {
        if action == LookAction::Fill(ViewLayout::DerivationAlone)
            && let Some(why) = self.scene.why_no_derivation()
        {
            return self.say("Nothing to enlarge".to_owned(), vec![why.to_owned()]);
        }
        change_look(&mut self.scene.session, action);
        if action == LookAction::Present {
            self.scene.presenting_changed();
        }
    }

    /// Opens a vote on the question of the lesson's step.
    fn ask_class(&mut self) {
        if !self.scene.open_vote() {
            let how = "A lesson's file has them beside ask: choices = [\"right\", \"wrong\"].";
            let title = "This question has no answers to vote on";
            self.say(title.to_owned(), vec![how.to_owned()]);
        }
    }

    /// Leaves the open scene, or asks about unsaved changes first.
    pub(super) fn leave(&mut self, ctx: &Context, leave: Leave) {
        if leave == Leave::BackToStep && !self.scene.differs_from_step() {
            return;
        }
        if self.scene.open.has_changes() {
            self.ask_about_changes(leave);
        } else {
            self.proceed(ctx, leave);
        }
    }

    pub(super) fn ask_about_changes(&mut self, then: Leave) {
        let title = format!("Save the changes to {}?", title_of(self.scene.open.origin()));
        let answers = vec![
            ("Save", "", Some(FileAction::Save(Some(then.clone())).into())),
            ("Discard", "", Some(FileAction::Discard(then).into())),
            ("Cancel", "", None),
        ];
        self.over.ask(Question::new(title, "Unsaved changes will be lost.", answers));
    }

    /// Asks which version to keep after another program has changed the scene's file. `saves` is true if the user
    /// was about to save the scene to that file.
    fn ask_which_version(&mut self, title: &str, saves: bool, then: Option<Leave>) {
        let text = "Your changes are not in the file, and the other program's changes are not on the screen.";
        let mine =
            if saves { "Saves your version over theirs" } else { "Continues with your version" };
        let keep = FileAction::KeepMine { saves, then: then.clone() };
        let take = FileAction::TakeTheirs(then.clone());
        let save_as = FileUse::SaveAs(then);
        let answers = vec![
            ("Keep mine", mine, Some(keep.into())),
            ("Take theirs", "Reads the file again. Undo restores your version", Some(take.into())),
            ("Save as…", "Saves your version to another file", Some(save_as.into())),
            ("Cancel", "", None),
        ];
        let title = format!("Another program has changed {title}");
        self.over.ask(Question::new(title, text, answers));
    }

    /// Opens what `leave` names, or closes the window, without asking about unsaved changes.
    fn proceed(&mut self, ctx: &Context, leave: Leave) {
        self.settle(ctx, None);
        let before = self.scene.clone();
        let opened = match leave {
            Leave::New => {
                self.scene.session.shown.setup.layout = ViewLayout::Both;
                Ok(self.scene.replace(OpenDocument::blank(), Selection::default()))
            }
            Leave::Open(source) => self.open(source),
            Leave::Follow(link) => self.scene.follow(*link),
            Leave::GoTo(id) => self.scene.open_lesson(id, None),
            Leave::BackToStep => self.scene.back_to_step(),
            Leave::Restore { as_new } => self.restore(as_new),
            Leave::Quit => {
                self.window.close(ctx);
                Ok(Opened::default())
            }
        };
        match opened {
            Ok(opened) => self.show_opened(opened),
            Err(problem) => self.over.ask(problem),
        }
        self.history.went_elsewhere(before, &self.scene);
    }

    fn open(&mut self, source: SceneSource) -> Result<Opened, Question> {
        let opened = self.scene.load(source.clone())?;
        if let SceneSource::File(path) = source {
            self.window.remember(&path);
        }
        Ok(opened)
    }

    /// Prepares the views for a newly opened scene. If a lesson's step was opened, schedules its
    /// animation, if it has one.
    pub(super) fn show_opened(&mut self, Opened { is_another, play }: Opened) {
        if is_another {
            self.views.deriver = Deriver::default();
        }
        // The animation opens in the next pass, when the hit of the step's ray is known.
        self.waiting.extend(play.map(|kind| PlayAction::Open(kind).into()));
    }

    fn file(&mut self, ctx: &Context, action: FileAction) {
        match action {
            FileAction::Save(then) => self.save(ctx, then),
            FileAction::KeepView => self.keep_view(),
            FileAction::Discard(leave) => {
                self.window.discarded = leave == Leave::Quit;
                self.proceed(ctx, leave)
            }
            FileAction::DiscardRecovered => {
                if let Some(found) = self.recovery.take() {
                    found.discard();
                }
            }
            FileAction::CheckFile => self.check_file(ctx),
            FileAction::KeepMine { saves, then } => {
                self.scene.open.keep_mine();
                if saves {
                    self.save(ctx, then);
                }
            }
            FileAction::TakeTheirs(then) => {
                if let (true, Some(then)) = (self.take_theirs(ctx), then) {
                    self.leave(ctx, then);
                }
            }
        }
    }

    /// Opens the recovered changes that were offered.
    fn restore(&mut self, as_new: bool) -> Result<Opened, Question> {
        let Some(found) = self.recovery.take() else { return Ok(Opened::default()) };
        let problem = |reason| Question::message("The unsaved changes cannot be restored", reason);
        let (open, slot) = found.restore(as_new).map_err(problem)?;
        self.recovery.go_on_in(slot);
        Ok(self.scene.replace(open, Selection::default()))
    }

    /// Reads the scene's files again if another program has changed them. If there are unsaved changes,
    /// asks the user first.
    fn check_file(&mut self, ctx: &Context) {
        if self.scene.open.take_removal() {
            let title = title_of(self.scene.open.origin());
            let note = "The scene stays open here; Save writes the file again.".to_owned();
            return self.say(format!("{title} was removed by another program"), vec![note]);
        }
        let Some(file) = self.scene.open.changed_by_others() else { return };
        if self.scene.open.has_edits() {
            self.ask_which_version(&file, false, None);
        } else if self.take_theirs(ctx) {
            let title = format!("{file} was changed by another program and has been read again");
            self.say(title, Vec::new());
        }
    }

    /// Opens a dialog with a message.
    pub(super) fn tell(&mut self, title: &str, text: impl ToString) {
        self.over.ask(Question::message(title, text));
    }

    /// Shows a notice, which disappears by itself, with a title and notes below it.
    pub(crate) fn say(&mut self, title: String, notes: Vec<String>) {
        let (title, notes) = (legible(&title), notes.iter().map(|note| legible(note)).collect());
        let notice = Notice { title, notes, worked: true, camera: None, shown_at: None };
        self.scene.session.translator.notice = Some(notice);
    }

    /// Shows a notice that something was written to a file, with notes, or a message that it was not.
    pub(super) fn say_written(
        &mut self,
        written: Result<Vec<String>, String>,
        verb: &str,
        path: &Path,
        problem: &str,
    ) {
        let name = path.file_name().unwrap_or(path.as_os_str()).display();
        let folder = path.parent().filter(|folder| folder.is_absolute());
        let folder = folder.map(|folder| format!("in the folder {}", folder.display()));
        match written {
            Ok(notes) => {
                self.say(format!("{verb} {name}"), folder.into_iter().chain(notes).collect())
            }
            Err(reason) => self.tell(problem, reason),
        }
    }

    /// Reads the scene's file, which another program has changed, again as a step that the user can undo.
    /// Returns true if it can be read.
    fn take_theirs(&mut self, ctx: &Context) -> bool {
        self.settle(ctx, None);
        if let Err(error) = self.scene.reload() {
            self.tell(NOT_READ, error);
            return false;
        }
        if self.over.says(NOT_READ) {
            self.over.dialog = None;
        }
        self.settle(ctx, Some("reload the file"));
        true
    }

    /// Saves to the scene's file, or asks for a path.
    fn save(&mut self, ctx: &Context, then: Option<Leave>) {
        match self.scene.open.scene_file().map(Path::to_owned) {
            Some(path) => self.save_to(ctx, &path, then),
            None => self.ask(FileUse::SaveAs(then)),
        }
    }

    pub(super) fn save_to(&mut self, ctx: &Context, path: &Path, then: Option<Leave>) {
        if self.scene.open.is_own(path) && self.scene.open.was_changed_by_others() {
            let title = title_of(self.scene.open.origin());
            return self.ask_which_version(&title, true, then);
        }
        if let Err(reason) = self.scene.open.save_to(path) {
            return self.tell("The scene was not saved", reason);
        }
        self.history.take_as_settled(&self.scene.open.document);
        self.window.remember(path);
        if let Some(then) = then {
            self.leave(ctx, then);
        }
    }

    fn lesson_action(&mut self, ctx: &Context, action: LessonAction) {
        let derivation = self.views.derived.derivation.as_deref();
        let is_presenting = self.scene.session.presenting.is_some();
        let stays = match action {
            LessonAction::Next => {
                self.scene.reveal(derivation) || is_presenting && self.scene.solve()
            }
            LessonAction::Previous => is_presenting && self.scene.take_back(),
            _ => false,
        };
        if stays {
            return;
        }
        let Some(open) = &self.scene.lessons.open else { return };
        let to = match action {
            LessonAction::Next => open.next(),
            LessonAction::Previous => open.previous(),
            LessonAction::ShowAll => {
                self.scene.solve();
                return self.scene.show_all();
            }
            LessonAction::Vote => return self.ask_class(),
            LessonAction::Close => return self.scene.close_lesson(),
        };
        let Some(to) = to else { return };
        self.stop_animation();
        self.leave(ctx, Leave::GoTo(to));
        // Going back shows the answer and every line, since the class has already seen them.
        if action == LessonAction::Previous && self.over.dialog.is_none() {
            self.scene.show_all();
        }
    }

    /// Replaces the camera by one that was read, as a step that the user can undo, and says what was read.
    pub(super) fn take_camera(&mut self, ctx: &Context, (camera, said): Taken, step: &str) {
        if let Some(camera) = camera {
            self.keep_animation(ctx);
            self.settle(ctx, None);
            self.scene.replace_camera(camera);
            self.settle(ctx, Some(step));
        }
        self.scene.session.translator.notice = Some(said);
    }
}

/// The step of the window's zoom.
const ZOOM_STEP: f32 = 0.1;

/// Changes how the scene is shown.
pub(super) fn change_look(session: &mut Session, action: LookAction) {
    let (layout, settings) = (&mut session.shown.setup.layout, &mut session.preferences);
    match action {
        LookAction::Layout(chosen) => *layout = chosen,
        LookAction::Shade(shade) => session.shown.setup.shade = shade,
        LookAction::Theme(theme) => match &mut session.presenting {
            Some(presenting) => presenting.theme = theme,
            None => settings.theme = theme,
        },
        LookAction::SwitchTheme => session.presenting.iter_mut().for_each(|now| {
            let is_light = now.theme == ThemeName::Light;
            now.theme = if is_light { ThemeName::Dark } else { ThemeName::Light };
        }),
        LookAction::Blank => session.presenting.iter_mut().for_each(|now| now.is_blank = true),
        LookAction::NextPenColor => {
            let pen = session.live.pen.iter_mut();
            pen.for_each(|pen| pen.color = (pen.color + 1) % PEN_COLORS);
        }
        LookAction::Scheme(scheme) => settings.scheme = scheme,
        LookAction::Digits(digits) => session.shown.setup.digits = digits,
        LookAction::Toggle(switch) => switch.toggle(session),
        LookAction::Recap => session.shown.toggle_recap(),
        LookAction::ZoomBy(by) => zoom_by(session, by),
        LookAction::Exercise(exercise) => {
            session.exercises.show(exercise, None);
            *layout = ViewLayout::Exercises;
        }
        LookAction::Mistake(chosen) => {
            session.shown.mistakes_view = MistakesView { chosen, ..MistakesView::default() };
            *layout = ViewLayout::Mistakes;
        }
        LookAction::ShowMe(mistake) => session.exercises.toggle_shown(mistake),
        LookAction::Vote => {
            session.live.vote = None;
            session.shown.mistakes_view.wants_vote = true;
            *layout = ViewLayout::Mistakes;
        }
        LookAction::Present => present_or_end(session),
        LookAction::Fill(full) => {
            let presenting = session.presenting.get_or_insert(Presenting::begin());
            presenting.fill(full, layout);
        }
    }
}

fn zoom_by(session: &mut Session, by: i32) {
    let settings = &mut session.preferences;
    if session.presenting.is_some() {
        let next = settings.smallest_text + by as f32 * SMALLEST_TEXT.step;
        let next = if by == 0 { SMALLEST_TEXT.usual } else { next };
        settings.smallest_text = next.clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
    } else {
        let next = ((settings.zoom / ZOOM_STEP).round() + by as f32) * ZOOM_STEP;
        settings.zoom = if by == 0 { 1.0 } else { next.clamp(ZOOM.0, ZOOM.1) };
    }
}

fn present_or_end(session: &mut Session) {
    match session.presenting.take() {
        None => session.presenting = Some(Presenting::begin()),
        Some(presenting) => {
            session.shown.setup.layout = presenting.before(session.shown.setup.layout);
            session.live.pen = None;
            session.shown.revealed_lines = None;
        }
    }
}

/// Delay of tooltips that do not appear, in seconds; egui takes no infinite one.
const NEVER: f32 = 86_400.0;

/// Returns the look that the settings ask for.
pub(crate) fn look_of(settings: &Settings, presenting: bool) -> Look {
    let Settings { setup, preferences: Preferences { scheme, reduced_motion, .. } } = *settings;
    Look { scheme, presenting, by_touch: false, reduced_motion, digits: setup.digits }
}

/// Applies the settings' theme, text size and zoom to the window.
pub(super) fn follow_look(ctx: &Context, session: &Session) {
    let settings = &session.preferences;
    ctx.set_theme(match session.presenting.map_or(settings.theme, |now| now.theme) {
        ThemeName::System => ThemePreference::System,
        ThemeName::Dark => ThemePreference::Dark,
        ThemeName::Light => ThemePreference::Light,
    });
    let presenting = session.presenting.is_some();
    let look = look_of(&session.settings(), presenting);
    theme::install(ctx, Look { by_touch: is_by_touch(ctx), ..look });
    let usual = egui::style::Interaction::default().tooltip_delay;
    let delay = if may_explain(ctx) { usual } else { NEVER };
    if ctx.global_style().interaction.tooltip_delay != delay {
        ctx.all_styles_mut(|style| style.interaction.tooltip_delay = delay);
    }
    let zoom = if presenting {
        presenting::zoom(window_size(ctx), settings.smallest_text)
    } else {
        settings.zoom
    };
    // Small differences are ignored: the zoom is computed from a rounded size in points, and would never
    // settle.
    if (ctx.zoom_factor() / zoom - 1.0).abs() > 0.004 {
        ctx.set_zoom_factor(zoom);
        ctx.request_repaint();
    }
}

/// Returns true if the last pointer was a finger. This does not change while a pointer is down, so that nothing
/// moves under it.
fn is_by_touch(ctx: &Context) -> bool {
    let shown = theme::installed(ctx).by_touch;
    let (touches, moves, is_down) = ctx.input(|input| {
        let moves = input.events.iter().any(|event| matches!(event, Event::PointerMoved(_)));
        let touches = input.events.iter().any(|event| matches!(event, Event::Touch { .. }));
        (touches || input.any_touches(), moves, input.pointer.any_down())
    });
    let last = Id::unique("the last pointer was a finger");
    let is_finger = touches || !moves && ctx.data(|data| data.get_temp(last)).unwrap_or(shown);
    ctx.data_mut(|data| data.insert_temp(last, is_finger));
    if is_down { shown } else { is_finger }
}

/// Returns the window's size in points at a zoom of 1, or zero if the window is not on a screen.
fn window_size(ctx: &Context) -> [f32; 2] {
    let size = ctx.content_rect().size() * ctx.zoom_factor();
    // A window that exists only in memory has no size in pixels, so its size in points does not depend
    // on the zoom.
    let is_real = ctx.input(|input| input.viewport().inner_rect.is_some());
    if is_real { size.into() } else { [0.0; 2] }
}
