//! A student's answers in the window: read, told from scenes, and put away.

use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::App;
use crate::model::session::ViewLayout;
use crate::model::student_answers::{AnswersAtHand, AnswersFile};
use crate::ui::action::{Action, AnswersAction, Leave};
use crate::ui::dialogs::dialog::{Dialog, PathField};
use pinhole_exchange::scenes::SceneSource;
use pinhole_exchange::{FileError, answers};

/// No larger file is graded in the window: two million answers, which take some seconds.
const MOST_BYTES: u64 = 100_000_000;

/// What a file that is dropped on the window is opened as: its first bytes tell.
pub(super) fn dropped(path: PathBuf) -> Action {
    const FIRST: u64 = 1 << 16;
    let mut bytes = Vec::new();
    let read = File::open(&path).and_then(|file| file.take(FIRST).read_to_end(&mut bytes));
    match read {
        Ok(_) if answers::are_meant(&path, &bytes) => AnswersAction::Check(path).into(),
        _ => Leave::Open(SceneSource::File(path)).into(),
    }
}

impl App {
    pub(super) fn answers(&mut self, action: AnswersAction) {
        match action {
            AnswersAction::Ask => self.ask_answers(),
            AnswersAction::Check(path) => self.check_answers(&path),
            AnswersAction::PutAway => self.put_answers_away(),
        }
    }

    /// Asks for the file of answers, near the last one or the scene.
    fn ask_answers(&mut self) {
        let last = self.session.answers.as_ref().map(|answers| answers.file.path.clone());
        let near = last.as_deref().or(self.open.file());
        self.dialog = Some(Dialog::Answers(PathField::answers_near(near)));
    }

    /// Shows the grade of a file of answers. They are read once: the grade follows the scene, and not
    /// the file.
    fn check_answers(&mut self, path: &Path) {
        let size = fs::metadata(path).map_or(0, |file| file.len());
        if size > MOST_BYTES {
            let problem = format!(
                "{} has {} MB, and the window would stand still for long: pinhole check grades it",
                path.display(),
                size / 1_000_000
            );
            self.tell("These answers are too many", problem);
            return;
        }
        match fs::read(path) {
            Ok(bytes) => {
                let known = self.session.answers.as_ref().filter(|known| known.file.path == path);
                let count_from = known.map_or(0, |known| known.count_from);
                let kind = answers::kind_of(&bytes);
                let file = Arc::new(AnswersFile { path: path.to_owned(), bytes, kind });
                self.session.answers = Some(AnswersAtHand { file, count_from });
                self.session.settings.layout = ViewLayout::Answers;
            }
            Err(error) => {
                let error = FileError::unreadable(path, &error).to_string();
                self.tell("These answers cannot be read", error);
            }
        }
    }

    /// Forgets the answers, and goes back to both views.
    fn put_answers_away(&mut self) {
        self.session.answers = None;
        if self.session.settings.layout == ViewLayout::Answers {
            self.session.settings.layout = ViewLayout::Both;
        }
    }
}
