//! Asks for files, and reads and writes those other than scenes: the translator's text, a student's answers, and
//! figures of the views on the screen.

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{ColorImage, Context, Event};
use pinhole_exchange::host::host;
use pinhole_exchange::programs::is_gltf;
use pinhole_exchange::{
    Document, ExportScene, Exported, SceneSource, answers, legible_name, limits, link,
};
use pinhole_figure::export::Figure;
use pinhole_figure::overlay::Style;

use crate::features::answers::{AnswersFile, StudentAnswers};
use crate::features::class::code::codes_in;
use crate::features::exercises::{Exercises, Progress};
use crate::features::export::order::{Content, FigureSubject, MARGIN, Order, derivation_of};
use crate::features::export::ui::{ExportForm, OnScreen};
use crate::features::lines;
use crate::features::translator::state::{imported, with};
use crate::model::{Session, ViewLayout, page_part};
use crate::ui::action::{Action, AnswersAction, FigureAction, FileUse, Leave, ShareAction};
use crate::ui::app::App;
use crate::ui::app::scene::OpenScene;
use crate::ui::dialogs::{Dialog, Question};
use crate::ui::widgets::path_field::{FileQuestion, PathField};
use crate::ui::workspaces::page;

/// Returns the action for a text that was pasted while no text field had the focus: a link is opened, codes of
/// answers are counted, and of anything else, the camera is read.
pub(super) fn pasted(ctx: &Context) -> Option<Action> {
    if ctx.text_edit_focused() {
        return None;
    }
    let pasted = |event: &Event| match event {
        Event::Paste(text) => Some(text.clone()),
        _ => None,
    };
    let text = ctx.input(|input| input.events.iter().find_map(pasted))?;
    let has_code = codes_in(&text).next().is_some();
    Some(match text {
        link if link::is_meant(&link) => ShareAction::Follow(link).into(),
        codes if has_code => AnswersAction::AddCodes(codes).into(),
        other => Action::Paste(other),
    })
}

fn translated(scene: &OpenScene) -> Option<Exported> {
    let translator = &scene.session.translator;
    let with = with(&scene.open.document, translator.objects);
    let subject = ExportScene::new(&scene.open.document, with).ok()?;
    translator.chosen().write(&subject).ok()
}

/// Saves the translated camera.
///
/// # Errors
/// Returns the reason if there is no translation, or if the file cannot be written.
fn save_translation(scene: &OpenScene, path: &Path) -> Result<(), String> {
    let text = translated(scene).ok_or("The scene has no valid camera")?.text.text;
    scene.open.check_output(path)?;
    host().write(path, text.as_bytes()).map_err(|error| error.to_string())
}

/// Saves the scene, or the lesson's step if it is unchanged, as a page for a browser. Returns notes about files in it.
///
/// # Errors
/// Returns the reason if there is no page of the program, or if the file cannot be written.
fn save_page(scene: &OpenScene, path: &Path) -> Result<Vec<String>, String> {
    scene.open.check_output(path)?;
    let step = scene.lessons.open.as_ref().filter(|_| !scene.differs_from_step());
    let of_scene = || Ok(scene.open.files().map(Path::to_owned).collect());
    let read =
        step.map_or_else(of_scene, page_part::files_of).map_err(|error| error.to_string())?;
    if read.iter().any(|read| host().is_same_file(read, path)) {
        let path = path.display();
        return Err(format!("The lesson is read from {path}: choose another name."));
    }
    let part = match step {
        Some(step) => page_part::of_step(step),
        None => page_part::of_scene(&scene.open.document),
    };
    let page = part.map_err(|error| error.to_string())?.in_page(&host().page()?)?;
    host().write(path, page.as_bytes()).map_err(|error| error.to_string())?;
    Ok(page_part::notes(&read))
}

/// Maximum size of a file of answers that the window grades, in bytes. That is about two million answers,
/// which take several seconds.
const MOST_BYTES: u64 = 100_000_000;

/// Returns the action for a file that is dropped on the window or opened. Its first bytes and its name
/// tell whether it is a link, answers to grade, a glTF to take the camera from, or a scene to open.
fn dropped(path: PathBuf) -> Action {
    const FIRST: u64 = 1 << 16;
    let mut bytes = Vec::new();
    match host().open(&path).map(|file| file.take(FIRST).read_to_end(&mut bytes)) {
        Ok(Ok(_)) if let Some(link) = link_in(&bytes) => ShareAction::Follow(link).into(),
        Ok(Ok(_)) if answers::are_meant(&path, &bytes) => Action::Use(FileUse::CheckAnswers, path),
        _ if is_gltf(&path) => Action::Use(FileUse::Import, path),
        _ => Leave::Open(SceneSource::File(path)).into(),
    }
}

/// Returns the link in a dropped file: a text with nothing else, or a desktop's shortcut to a page.
fn link_in(bytes: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(bytes).ok()?;
    let of_shortcut = text.lines().find_map(|line| line.strip_prefix("URL="));
    let text = of_shortcut.unwrap_or(text);
    link::is_meant(text).then(|| text.to_owned())
}

/// Reads and grades a file of answers. The grade is updated when the scene changes, but not when the
/// file does.
fn check(session: &mut Session, path: &Path) -> Result<(), Question> {
    let size = host().stamp(path).map_or(0, |file| file.length);
    if size > MOST_BYTES {
        let problem = format!(
            "{} has {} MB, and the window would stop responding: grade it with pinhole check",
            legible_name(path),
            size / 1_000_000
        );
        return Err(Question::message("Too many answers", problem));
    }
    let bytes = limits::read(path, limits::TABLE)
        .map_err(|error| Question::message("These answers cannot be read", error))?;
    let known = session.answers.as_ref().filter(|known| known.file.path == path);
    let count_from = known.map_or(0, |known| known.count_from);
    let kind = answers::kind_of(&bytes);
    let file = Arc::new(AnswersFile { path: path.to_owned(), bytes, kind });
    session.answers = Some(StudentAnswers { file, count_from });
    session.shown.setup.layout = ViewLayout::Answers;
    Ok(())
}

/// The larger side, in points, of a figure of a view that is not on the screen.
const VIEW: f32 = 960.0;
/// Size, in points, of a figure of the derivation if it is not on the screen.
const DERIVATION: [f32; 2] = [800.0, 600.0];
/// Size, in points, of a figure of two lines in the plane if the lab has not been shown
/// yet.
const LINES: [f32; 2] = [800.0, 640.0];

impl App {
    /// Asks for a file, at first in a folder and with a name that suit its use, unless there is nothing to save.
    pub(super) fn ask(&mut self, of: FileUse) {
        const STEP: &str = "Save this view at the end of a lesson, or begin one";
        const NUMBERS: &str = "path of a glTF or of a text with numbers";
        const ANSWERS: &str = "path of a .csv or .png file of answers";
        let (title, endings, hint): (_, &[_], _) = match of {
            FileUse::Open => ("Open a scene", &["toml"], "path of a .toml scene"),
            FileUse::SaveAs(_) => ("Save the scene as", &["toml"], "path of a .toml scene"),
            FileUse::SavePage => {
                ("Save as a page for a browser", &["html"], "path of a .html file")
            }
            FileUse::SaveStep => (STEP, &["toml"], "path of a lesson; a new file begins one"),
            FileUse::Import => ("Import a camera", &["gltf", "glb", "txt"], NUMBERS),
            FileUse::SaveCamera => ("Save the camera for another program", &[], "path of the file"),
            FileUse::CheckAnswers => ("Check a student's answers", &["csv", "png"], ANSWERS),
        };
        let OpenScene { open, session, lessons, .. } = &self.scene;
        let last = match of {
            FileUse::SaveStep => lessons.file.as_ref().and_then(|lesson| lesson.file.as_deref()),
            FileUse::CheckAnswers => session.answers.as_ref().map(|answers| &*answers.file.path),
            _ => None,
        };
        let format = session.translator.chosen();
        let (name, writes) = match of {
            FileUse::Open | FileUse::Import | FileUse::CheckAnswers => (PathBuf::new(), None),
            FileUse::SaveAs(_) => (open.file_name().into(), Some("toml")),
            FileUse::SavePage => {
                (Path::new(&open.file_name()).with_extension("html"), Some("html"))
            }
            FileUse::SaveStep => {
                let name = last.and_then(Path::file_name).unwrap_or("lesson.toml".as_ref());
                (name.into(), Some("toml"))
            }
            FileUse::SaveCamera if translated(&self.scene).is_none() => return,
            FileUse::SaveCamera => (format.file.into(), Some(format.ending())),
        };
        let question = FileQuestion { title, endings, hint, writes };
        let mut field =
            PathField::new(question, last.or(open.scene_file()), &name.to_string_lossy());
        field.adds = of == FileUse::SaveStep;
        self.over.open(Dialog::File(field, of));
    }

    /// Uses a file as it was asked for.
    pub(super) fn use_file(&mut self, ctx: &Context, of: FileUse, path: PathBuf) {
        match of {
            FileUse::Open => self.apply(ctx, dropped(path)),
            FileUse::SaveAs(then) => self.save_to(ctx, &path, then),
            FileUse::SavePage => {
                let saved = save_page(&self.scene, &path);
                self.say_written(saved, "Saved to", &path, "The page was not saved")
            }
            FileUse::SaveStep => self.save_step(&path),
            FileUse::Import => {
                let taken = imported(&path, &self.scene.open.document.camera);
                self.take_camera(ctx, taken, "import a camera");
            }
            FileUse::SaveCamera => {
                let saved = save_translation(&self.scene, &path).map(|()| Vec::new());
                self.say_written(saved, "Saved to", &path, "The camera was not saved")
            }
            FileUse::CheckAnswers => {
                if let Err(problem) = check(&mut self.scene.session, &path) {
                    self.over.ask(problem);
                }
            }
        }
    }

    /// Applies an action on a student's answers, on the exercises or on a class's answers.
    pub(super) fn answers_action(&mut self, action: AnswersAction) {
        let Session { answers, exercises, progress, class, shown, .. } = &mut self.scene.session;
        let layout = &mut shown.setup.layout;
        match action {
            AnswersAction::PutAway => {
                *answers = None;
                if *layout == ViewLayout::Answers {
                    *layout = ViewLayout::Both;
                }
            }
            AnswersAction::AskStartOver => {
                let text = "No exercise is done then, and what was typed in them is gone.";
                let yes = Some(AnswersAction::StartOver.into());
                let answers = vec![("Start over", "", yes), ("Cancel", "", None)];
                let title = "Start the exercises over?".to_owned();
                self.over.ask(Question::new(title, text, answers));
            }
            AnswersAction::StartOver => {
                let opened = Exercises::open(exercises.question().exercise, exercises.seed());
                (*exercises, *progress) = (opened, Progress::default());
            }
            AnswersAction::AddCodes(text) => {
                class.add(&text);
                *layout = ViewLayout::Class;
            }
        }
    }

    /// Applies an action on figures or animations to export.
    pub(super) fn figure_action(&mut self, ctx: &Context, action: FigureAction) {
        match action {
            FigureAction::Ask => {
                let first = self.layout_subject();
                let mut subjects = FigureSubject::ALL.to_vec();
                subjects.sort_by_key(|subject| *subject != first);
                self.over.open(Dialog::Export(self.export_form(ctx, &subjects)));
            }
            FigureAction::Export(order, path) => {
                let exported = self.export(&order, &path).map(|()| Vec::new());
                self.say_written(exported, "Exported to", &path, "The figure was not exported")
            }
            FigureAction::AskAnimation => {
                let Some(player) = &mut self.playback.player else { return };
                player.running = false;
                let kind = player.kind;
                let subjects = [FigureSubject::World, FigureSubject::Camera];
                let form = self.export_form(ctx, &subjects).animated(kind);
                self.over.open(Dialog::Export(form));
            }
            FigureAction::ExportAnimation(order, frames, path) => {
                self.export_animation(order, frames, path)
            }
            FigureAction::Copy => self.copy_figure(ctx),
            FigureAction::CopyDerivation(markup) => {
                let (document, session) = self.figure_source();
                ctx.copy_text(derivation_of(document, &session).written_in(markup));
                self.say(format!("Copied as {}", markup.label()), Vec::new());
            }
        }
    }

    fn export_form(&self, ctx: &Context, subjects: &[FigureSubject]) -> ExportForm {
        let subjects = subjects.iter().map(|subject| self.on_screen(ctx, *subject)).collect();
        ExportForm::new(self.scene.open.scene_file(), subjects, self.figure_style(ctx))
    }

    /// Returns what a figure of the open page shows: a view, the derivation or two lines in the plane.
    fn layout_subject(&self) -> FigureSubject {
        page(self.scene.session.shown.setup.layout).figure
    }

    fn figure_style(&self, ctx: &Context) -> Style {
        Style::new(self.scene.session.preferences.scheme, ctx.theme() == egui::Theme::Dark)
    }

    /// Copies a figure of the open page to the clipboard, at the page's size on the screen.
    fn copy_figure(&mut self, ctx: &Context) {
        let shown = self.on_screen(ctx, self.layout_subject());
        let order = shown.order(shown.dots(), self.figure_style(ctx), false);
        match self.figure(&order) {
            Ok(figure) => {
                ctx.copy_image(ColorImage::new(figure.size, figure.to_pixels()));
                self.say("The figure is on the clipboard".to_owned(), Vec::new());
            }
            Err(problem) => self.tell("The figure was not copied", problem),
        }
    }

    fn figure(&self, order: &Order) -> Result<Figure, String> {
        let (document, session) = self.figure_source();
        order.figure(document, &session)
    }

    /// Returns the document in the views, and its session without what is under the pointer, because figures
    /// do not highlight it.
    fn figure_source(&self) -> (&Document, Session) {
        let scene = self.question.as_ref().unwrap_or(&self.scene);
        let mut session = scene.session.clone();
        (session.live.hovered, session.live.directed) = (None, None);
        (&scene.open.document, session)
    }

    /// Returns a figure's subject with its size on the screen, or with a default size if it is not on
    /// the screen.
    fn on_screen(&self, ctx: &Context, subject: FigureSubject) -> OnScreen {
        let (scale, derived) = (ctx.pixels_per_point(), &self.views.derived);
        let view = match subject {
            FigureSubject::World => &derived.world_view,
            _ => &derived.camera_view,
        };
        let shown = view.as_ref().map(|view| view.image.size.map(|dots| dots as f32 / scale));
        let scene = self.question.as_ref().unwrap_or(&self.scene);
        let aspect = scene.open.document.camera.image.aspect() as f32;
        let points = match subject {
            FigureSubject::World => shown.unwrap_or([VIEW, VIEW * 9.0 / 16.0]),
            FigureSubject::Camera => {
                shown.unwrap_or([VIEW * aspect.min(1.0), VIEW / aspect.max(1.0)])
            }
            FigureSubject::Derivation => {
                let width = self.tools.derivation.width().map(|width| width + 2.0 * MARGIN);
                [width.unwrap_or(DERIVATION[0]), DERIVATION[1]]
            }
            FigureSubject::Lines => lines::ui::size(ctx).unwrap_or(LINES),
        };
        OnScreen { subject, points, scale }
    }

    /// Writes a figure to a file.
    fn export(&self, order: &Order, path: &Path) -> Result<(), String> {
        self.scene.open.check_output(path)?;
        let (document, session) = self.figure_source();
        let bytes = match Content::for_path(order.subject, path)? {
            Content::Text(markup) => {
                derivation_of(document, &session).written_in(markup).into_bytes()
            }
            Content::Figure(format) => {
                order.figure_as(format, document, &session)?.to_file(format)?
            }
        };
        host().write(path, &bytes).map_err(|error| error.to_string())
    }
}
