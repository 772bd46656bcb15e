//! A student's answers that are graded.

use std::path::PathBuf;
use std::sync::Arc;

use pinhole_exchange::legible_name;
use pinhole_lecture::AnswerKind;

/// A file of answers, as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnswersFile {
    /// The file's path.
    pub path: PathBuf,
    /// The file's content.
    pub bytes: Vec<u8>,
    /// The kind of answers, as detected from the file's first bytes; `None` if they are of no known
    /// kind.
    pub kind: Option<AnswerKind>,
}

/// The answers to be graded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudentAnswers {
    /// The file.
    pub file: Arc<AnswersFile>,
    /// The number with which the file begins to count rows and columns: 0 or 1.
    pub count_from: u32,
}

impl StudentAnswers {
    /// Returns the file's name.
    pub fn name(&self) -> String {
        legible_name(self.file.path.file_name().unwrap_or(self.file.path.as_os_str()))
    }

    /// Returns true if the answers contain row and column numbers; those for a basis or a picture do not.
    pub fn are_numbered(&self) -> bool {
        !matches!(self.file.kind, Some(AnswerKind::Basis | AnswerKind::Picture))
    }
}
