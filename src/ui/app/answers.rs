//! A student's answers in the window: read, told from scenes, and put away.

use std::fs::{self, File};
use std::io::{ErrorKind, Read as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pinhole_exchange::scenes::SceneSource;
use pinhole_exchange::{answers, limits};

use super::scene::OpenScene;
use crate::model::practice::student_answers::{AnswersFile, StudentAnswers};
use crate::model::session::{Session, ViewLayout};
use crate::ui::action::{Action, AnswersAction, Leave};
use crate::ui::dialogs::dialog::{Dialog, Message};
use crate::ui::dialogs::path_field::{FileQuestion, PathField};

/// Maximum size of a file that is graded in the window: two million answers, which take some seconds.
const MOST_BYTES: u64 = 100_000_000;

const ANSWERS: FileQuestion = FileQuestion {
    title: "Check a student's answers",
    verb: "Check",
    endings: &["csv", "png"],
    hint: "path of a .csv or .png file of answers",
    writes: None,
};

/// Returns the action for a file that is dropped on the window: its first bytes tell.
pub(super) fn dropped(path: PathBuf) -> Action {
    const FIRST: u64 = 1 << 16;
    let mut bytes = Vec::new();
    // A pipe may never be written to.
    let file =
        || if path.is_file() { File::open(&path) } else { Err(ErrorKind::InvalidInput.into()) };
    let read = file().and_then(|file| file.take(FIRST).read_to_end(&mut bytes));
    match read {
        Ok(_) if answers::are_meant(&path, &bytes) => AnswersAction::Check(path).into(),
        _ => Leave::Open(SceneSource::File(path)).into(),
    }
}

/// Does it, or returns what there is to ask or to tell.
pub(super) fn apply(scene: &mut OpenScene, action: AnswersAction) -> Option<Dialog> {
    let session = &mut scene.session;
    match action {
        AnswersAction::Ask => {
            // Near the last one, or the scene.
            let last = session.answers.as_ref().map(|answers| &*answers.file.path);
            return Some(Dialog::Answers(PathField::new(ANSWERS, last.or(scene.open.file()), "")));
        }
        AnswersAction::Check(path) => return check(session, &path).err().map(Dialog::Message),
        AnswersAction::PutAway => {
            session.answers = None;
            if session.settings.layout == ViewLayout::Answers {
                session.settings.layout = ViewLayout::Both;
            }
        }
    }
    None
}

/// Shows the grade of a file of answers. They are read once: the grade follows the scene, and not
/// the file.
fn check(session: &mut Session, path: &Path) -> Result<(), Message> {
    let size = fs::metadata(path).map_or(0, |file| file.len());
    if size > MOST_BYTES {
        let problem = format!(
            "{} has {} MB, and the window would stop responding: grade it with pinhole check",
            path.display(),
            size / 1_000_000
        );
        return Err(Message::new("Too many answers", problem));
    }
    let bytes = limits::read(path, limits::TABLE)
        .map_err(|error| Message::new("These answers cannot be read", error))?;
    let known = session.answers.as_ref().filter(|known| known.file.path == path);
    let count_from = known.map_or(0, |known| known.count_from);
    let kind = answers::kind_of(&bytes);
    let file = Arc::new(AnswersFile { path: path.to_owned(), bytes, kind });
    session.answers = Some(StudentAnswers { file, count_from });
    session.settings.layout = ViewLayout::Answers;
    Ok(())
}
