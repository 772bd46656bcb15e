//! A file of a student's answers, whose grade the window shows.

use std::path::PathBuf;
use std::sync::Arc;

use pinhole_lecture::grading::AnswerKind;

/// A file of answers, as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnswersFile {
    /// The file's path.
    pub path: PathBuf,
    /// The file's content.
    pub bytes: Vec<u8>,
    /// The kind of answers, by the first bytes.
    pub kind: Option<AnswerKind>,
}

/// The answers that are graded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudentAnswers {
    /// The file.
    pub file: Arc<AnswersFile>,
    /// The number of the first row and column, 0 or 1.
    pub count_from: u32,
}

impl StudentAnswers {
    /// Returns the file's name.
    pub fn name(&self) -> String {
        let name = self.file.path.file_name().unwrap_or(self.file.path.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// Returns true if the answers name rows and columns by number; a basis and a picture do not.
    pub fn are_numbered(&self) -> bool {
        !matches!(self.file.kind, Some(AnswerKind::Basis | AnswerKind::Picture))
    }
}
