//! The lessons that come with the program.

use std::path::Path;
use std::sync::{Arc, LazyLock};

use pinhole_exchange::FileError;

use super::lesson::Lesson;
use super::read;

/// A list of the files `assets/lessons/NAME.toml`.
macro_rules! lessons {
    [$($name:literal),* $(,)?] => {
        &[$(Builtin {
            name: $name,
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/lessons/", $name, ".toml")),
        }),*]
    };
}

/// A lesson that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Builtin {
    /// The name of its file, for error messages.
    pub name: &'static str,
    /// The text of its lesson file.
    pub text: &'static str,
}

/// The lesson files in the order of the lecture.
pub const FILES: &[Builtin] = lessons![
    "01-canonical-camera",
    "02-warm-up",
    "03-viewport-and-distance",
    "04-eye-moved",
    "05-orientation",
    "06-forty-five-degrees",
    "07-view-and-up",
    "08-eye-at-up",
    "09-when-it-breaks",
    "10-as-printed",
    "11-parametric-and-implicit",
    "12-ray-and-objects",
    "13-many-rays",
];

impl Builtin {
    /// Reads the lesson.
    ///
    /// # Errors
    /// Never fails; tests check all lessons.
    pub fn load(&self) -> Result<Lesson, FileError> {
        read::parse(self.text, Path::new(self.name), None)
    }
}

/// Returns all built-in lessons, which are read once; lesson 1 comes first.
pub fn all() -> &'static [Arc<Lesson>] {
    static LESSONS: LazyLock<Vec<Arc<Lesson>>> = LazyLock::new(|| {
        FILES.iter().filter_map(|file| Some(Arc::new(file.load().ok()?))).collect()
    });
    &LESSONS
}
