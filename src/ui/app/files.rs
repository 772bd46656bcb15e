//! Reads and writes files other than scenes: the translator's text, a student's answers, and figures of the
//! views on the screen.

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{ColorImage, Context, Event, Ui};
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
use crate::features::translator::state::with;
use crate::features::{lines, translator};
use crate::model::page_part;
use crate::model::{Session, ViewLayout};
use crate::ui::action::{Action, AnswersAction, ExchangeAction, FigureAction, Leave, ShareAction};
use crate::ui::app::App;
use crate::ui::app::question::in_views;
use crate::ui::app::scene::OpenScene;
use crate::ui::dialogs::{Dialog, Question};
use crate::ui::widgets::path_field::FileQuestion;
use crate::ui::workspaces::page;

/// Returns the action for a text that was pasted while no text field had the focus: a link is opened, codes of
/// answers are counted, and of anything else, the camera is read.
pub(super) fn pasted(ctx: &Context) -> Option<Action> {
    if ctx.text_edit_focused() {
        return None;
    }
    let pasted = |event: &Event| match event {
        Event::Paste(text) if link::is_meant(text) => {
            Some(ShareAction::Follow(text.clone()).into())
        }
        Event::Paste(text) if codes_in(text).next().is_some() => {
            Some(AnswersAction::AddCodes(text.clone()).into())
        }
        Event::Paste(text) => Some(ExchangeAction::Paste(text.clone()).into()),
        _ => None,
    };
    ctx.input(|input| input.events.iter().find_map(pasted))
}

/// Shows the last notice. A notice about a camera disappears when the camera changes.
pub(super) fn notice(ui: &Ui, scene: &mut OpenScene) {
    let notice = &mut scene.session.translator.notice;
    let camera = notice.as_ref().and_then(|said| said.camera);
    if camera.is_some_and(|camera| camera != scene.open.document.camera) {
        *notice = None;
    }
    translator::ui::notice(ui, notice);
}

fn translated(scene: &OpenScene) -> Option<Exported> {
    let translator = &scene.session.translator;
    let with = with(&scene.open.document, translator.objects);
    let subject = ExportScene::new(&scene.open.document, with).ok()?;
    translator.chosen().write(&subject).ok()
}

/// Returns the dialog that asks where to save the translated camera.
pub(super) fn ask_where_to_save_translation(scene: &OpenScene) -> Option<Dialog> {
    translated(scene)?;
    let format = scene.session.translator.chosen();
    let question = FileQuestion {
        title: "Save the camera for another program",
        endings: &[],
        hint: "path of the file",
        writes: Some(format.ending()),
    };
    Some(Dialog::file(question, scene.open.file(), format.file, ExchangeAction::Save))
}

/// Saves the translated camera.
///
/// # Errors
/// Returns the reason if there is no translation, or if the file cannot be written.
pub(super) fn save_translation(scene: &OpenScene, path: &Path) -> Result<(), String> {
    let text = translated(scene).ok_or("The scene has no valid camera")?.text.text;
    let write = |()| {
        let written = host().write(path, text.as_bytes());
        written.map_err(|error| error.to_string())
    };
    scene.open.check_output(path).and_then(write)
}

/// Saves the scene, or the lesson's step if it is unchanged, as a page for a browser. Returns notes about files in it.
///
/// # Errors
/// Returns the reason if there is no page of the program, or if the file cannot be written.
pub(super) fn save_page(scene: &OpenScene, path: &Path) -> Result<Vec<String>, String> {
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

const ANSWERS: FileQuestion = FileQuestion {
    title: "Check a student's answers",
    endings: &["csv", "png"],
    hint: "path of a .csv or .png file of answers",
    writes: None,
};

/// Returns the action for a file that is dropped on the window or opened. Its first bytes and its name
/// tell whether it is a link, answers to grade, a glTF to take the camera from, or a scene to open.
pub(super) fn dropped(path: PathBuf) -> Action {
    const FIRST: u64 = 1 << 16;
    let mut bytes = Vec::new();
    match host().open(&path).map(|file| file.take(FIRST).read_to_end(&mut bytes)) {
        Ok(Ok(_)) if let Some(link) = link_in(&bytes) => ShareAction::Follow(link).into(),
        Ok(Ok(_)) if answers::are_meant(&path, &bytes) => AnswersAction::Check(path).into(),
        _ if is_gltf(&path) => ExchangeAction::Import(path).into(),
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

/// Applies an action on a student's answers. Returns a dialog if the user must answer a question or read a
/// message.
pub(super) fn apply_answers_action(scene: &mut OpenScene, action: AnswersAction) -> Option<Dialog> {
    let session = &mut scene.session;
    match action {
        AnswersAction::Ask => {
            // Start in the folder of the last answers, or of the scene.
            let last = session.answers.as_ref().map(|answers| &*answers.file.path);
            let near = last.or(scene.open.file());
            return Some(Dialog::file(ANSWERS, near, "", AnswersAction::Check));
        }
        AnswersAction::Check(path) => return check(session, &path).err().map(Dialog::Question),
        AnswersAction::PutAway => {
            session.answers = None;
            if session.shown.setup.layout == ViewLayout::Answers {
                session.shown.setup.layout = ViewLayout::Both;
            }
        }
        AnswersAction::AskStartOver => {
            let text = "No exercise is done then, and what was typed in them is gone.";
            let yes = Some(AnswersAction::StartOver.into());
            let answers = vec![("Start over", "", yes), ("Cancel", "", None)];
            let title = "Start the exercises over?".to_owned();
            return Some(Dialog::Question(Question::new(title, text, answers)));
        }
        AnswersAction::StartOver => {
            let exercises = &session.exercises;
            let opened = Exercises::open(exercises.question().exercise, exercises.seed());
            (session.exercises, session.progress) = (opened, Progress::default());
        }
        AnswersAction::AddCodes(text) => {
            session.class.add(&text);
            session.shown.setup.layout = ViewLayout::Class;
        }
    }
    None
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
    /// Applies an action on figures or animations to export. Returns a dialog if the user must answer a
    /// question or read a message.
    pub(super) fn figure_action(&mut self, ctx: &Context, action: FigureAction) -> Option<Dialog> {
        match action {
            FigureAction::Ask => {
                let first = self.layout_subject();
                let mut subjects = FigureSubject::ALL.to_vec();
                subjects.sort_by_key(|subject| *subject != first);
                Some(Dialog::Export(self.export_form(ctx, &subjects)))
            }
            FigureAction::Export(order, path) => {
                let exported = self.export(&order, &path);
                self.say_written(exported, "Exported to", &path, "The figure was not exported")
            }
            FigureAction::AskAnimation => {
                let player = self.playback.player.as_mut()?;
                player.running = false;
                let kind = player.kind;
                let subjects = [FigureSubject::World, FigureSubject::Camera];
                Some(Dialog::Export(self.export_form(ctx, &subjects).animated(kind)))
            }
            FigureAction::ExportAnimation(order, frames, path) => {
                self.export_animation(order, frames, path)
            }
            FigureAction::Copy => self.copy_figure(ctx),
            FigureAction::CopyDerivation(markup) => {
                let (document, session) = self.figure_source();
                ctx.copy_text(derivation_of(document, &session).written_in(markup));
                self.say(format!("Copied as {}", markup.label()), Vec::new());
                None
            }
        }
    }

    fn export_form(&self, ctx: &Context, subjects: &[FigureSubject]) -> ExportForm {
        let subjects = subjects.iter().map(|subject| self.on_screen(ctx, *subject)).collect();
        ExportForm::new(self.scene.open.file(), subjects, self.figure_style(ctx))
    }

    /// Returns what a figure of the open page shows: a view, the derivation or two lines in the plane.
    fn layout_subject(&self) -> FigureSubject {
        page(self.scene.session.shown.setup.layout).figure
    }

    fn figure_style(&self, ctx: &Context) -> Style {
        Style::new(self.scene.session.preferences.scheme, ctx.theme() == egui::Theme::Dark)
    }

    /// Copies a figure of the open page to the clipboard, at the page's size on the screen.
    fn copy_figure(&mut self, ctx: &Context) -> Option<Dialog> {
        let shown = self.on_screen(ctx, self.layout_subject());
        let order = shown.order(shown.dots(), self.figure_style(ctx), false);
        match self.figure(&order) {
            Ok(figure) => {
                ctx.copy_image(ColorImage::new(figure.size, figure.to_pixels()));
                self.say("The figure is on the clipboard".to_owned(), Vec::new());
                None
            }
            Err(problem) => Some(Dialog::message("The figure was not copied", problem)),
        }
    }

    fn figure(&self, order: &Order) -> Result<Figure, String> {
        let (document, session) = self.figure_source();
        order.figure(document, &session)
    }

    /// Returns the document in the views, and its session without what is under the pointer, because figures
    /// do not highlight it.
    fn figure_source(&self) -> (&Document, Session) {
        let scene = in_views(&self.scene, self.question.as_ref());
        let mut session = scene.session.clone();
        session.live.hovered = None;
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
        let scene = in_views(&self.scene, self.question.as_ref());
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
                let mut figure = self.figure(order)?;
                order.refine(&mut figure, format, document, &session)?;
                figure.to_file(format)?
            }
        };
        host().write(path, &bytes).map_err(|error| error.to_string())
    }
}
