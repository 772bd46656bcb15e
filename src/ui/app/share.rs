//! Links: sharing what the window shows, and opening a link.

use egui::{Context, Ui};
use pinhole_exchange::link::{self, Link, Linked};
use pinhole_exchange::scenes::SceneSource;

use super::App;
use super::scene::{OpenScene, Opened};
use crate::features::share::link::{layout_of, read, to_window};
use crate::features::share::ui::{ShareForm, ShownCode};
use crate::model::lessons::{StepId, Which};
use crate::model::{OpenDocument, ViewLayout};
use crate::ui::action::{Leave, ShareAction};
use crate::ui::dialogs::{Dialog, Question};
use crate::ui::stage::Stage;

impl OpenScene {
    /// Opens what a link shows.
    pub(super) fn follow(&mut self, link: Link) -> Result<Opened, Question> {
        let layout = layout_of(&link);
        let opened = match link.shown {
            Linked::Step { lesson, step } => {
                let (lesson, step) = (lesson.wrapping_sub(1), step.wrapping_sub(1));
                let id = StepId { lesson: Which::Builtin(lesson), step };
                self.open_lesson(id, None)?
            }
            Linked::Builtin(scene) => self.load(SceneSource::Builtin(scene))?,
            Linked::Scene(document) => {
                let open = OpenDocument::made_up(*document, "Scene of a link".to_owned());
                self.replace(open, Default::default())
            }
        };
        self.session.shown.selection = link.ray.unwrap_or(self.session.shown.selection);
        // A scene is shown in both views, a step as it says.
        let is_scene = self.lessons.open.is_none();
        if let Some(layout) = layout.or(is_scene.then_some(ViewLayout::Both)) {
            self.session.shown.setup.layout = layout;
        }
        Ok(opened)
    }
}

impl App {
    /// Opens what a link shows, in the next frame.
    pub fn open_link(&mut self, link: Link) {
        self.waiting.push(Leave::Follow(Box::new(link)).into());
    }

    /// Opens the link with this text, in the next frame; asks about unsaved changes first, and says so if it is
    /// no link.
    pub fn follow_link(&mut self, text: String) {
        self.waiting.push(ShareAction::Follow(text).into());
    }

    /// Applies an action on links and codes.
    pub(super) fn share(&mut self, ctx: &Context, action: ShareAction) {
        match action {
            ShareAction::Show => self.show_link(),
            ShareAction::Follow(text) => match read(&text) {
                Ok(link) => self.leave(ctx, Leave::Follow(Box::new(link))),
                Err(error) => self.tell("This link cannot be opened", error),
            },
            ShareAction::Copy(url) => {
                ctx.copy_text(url);
                self.say("The link is on the clipboard".to_owned(), Vec::new());
            }
            ShareAction::CopyAnswer => {
                let exercises = &self.session().exercises;
                ctx.copy_text(exercises.to_code());
                let seen =
                    if exercises.saw_solution { " and that you saw the solution" } else { "" };
                let note = format!(
                    "For your lecturer. It contains your answers{seen}, but not your name."
                );
                self.say("The code of your answer is on the clipboard".to_owned(), vec![note]);
            }
        }
    }

    /// Shows the link, and its code. While presenting, the code alone fills the figure, if there is one, and
    /// disappears the second time.
    fn show_link(&mut self) {
        if self.over.code.take().is_some() {
            return;
        }
        let link = to_window(self.document(), self.session(), self.lesson());
        let fragment = match link.to_fragment() {
            Ok(fragment) => fragment,
            Err(error) => return self.tell("This scene has no link", error),
        };
        let address = &self.window.kept.address;
        if self.session().presenting.is_some() && !address.trim().is_empty() {
            let code = ShownCode::of(link::url(address, &fragment));
            if code.image.is_ok() {
                self.over.code = Some(code);
                return;
            }
        }
        self.over.open(Dialog::Share(ShareForm::new(fragment, address.clone())));
    }

    /// Shows the code over the main figure of the stage, or over the views, until presenting ends.
    pub(super) fn code_over(&mut self, ui: &Ui, stage: Option<&Stage>) {
        if self.scene.session.presenting.is_none() {
            self.over.code = None;
        }
        if let Some(code) = &mut self.over.code {
            code.fill(ui.ctx(), stage.map_or(ui.max_rect(), |stage| stage.main));
        }
    }
}
