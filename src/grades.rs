//! The answers that the window shows the grade of, as a file.

use std::path::PathBuf;
use std::sync::Arc;

use pinhole_lecture::grading::Kind;

/// A file of answers, as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnswersFile {
    /// Where it is.
    pub path: PathBuf,
    /// What it holds.
    pub bytes: Vec<u8>,
    /// What kind of answers that is, by its first bytes.
    pub kind: Option<Kind>,
}

/// The answers that the window shows the grade of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnswersAtHand {
    /// Shared, so that it is compared by where it is.
    pub file: Arc<AnswersFile>,
    /// Where its rows and columns begin, 0 or 1.
    pub count_from: u32,
}

impl AnswersAtHand {
    /// The file's name.
    pub fn name(&self) -> String {
        let name = self.file.path.file_name().unwrap_or(self.file.path.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// Whether its rows and columns are numbers that begin somewhere: not those of a basis or a
    /// picture.
    pub fn are_numbered(&self) -> bool {
        !matches!(self.file.kind, Some(Kind::Basis | Kind::Picture))
    }
}
