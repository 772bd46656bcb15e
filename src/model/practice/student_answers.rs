//! The answers that the window shows the grade of, as a file.

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

/// The answers that the window shows the grade of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudentAnswers {
    /// Shared, so that it is compared by where it is.
    pub file: Arc<AnswersFile>,
    /// The first row and column of its count, 0 or 1.
    pub count_from: u32,
}

impl StudentAnswers {
    /// The file's name.
    pub fn name(&self) -> String {
        let name = self.file.path.file_name().unwrap_or(self.file.path.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// Returns whether its rows and columns are numbers that begin somewhere: not those of a basis
    /// or a picture.
    pub fn are_numbered(&self) -> bool {
        !matches!(self.file.kind, Some(AnswerKind::Basis | AnswerKind::Picture))
    }
}
