//! The lessons that come with the program.

use std::path::Path;
use std::sync::{Arc, LazyLock};

use super::lesson::Lesson;
use super::read;

/// Expands to a list of the files `assets/lessons/NAME.toml`: the name of each, for error messages, and
/// its text.
macro_rules! lessons {
    [$($name:literal),* $(,)?] => {
        &[$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/lessons/", $name, ".toml")),
        )),*]
    };
}

/// The names and texts of the lesson files, in the order of the lecture.
pub const FILES: &[(&str, &str)] = lessons![
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

/// Returns all built-in lessons, lesson 1 first. They are parsed once.
pub fn all() -> &'static [Arc<Lesson>] {
    static LESSONS: LazyLock<Vec<Arc<Lesson>>> = LazyLock::new(|| {
        let read = |(name, text): &(&str, &str)| read::parse(text, Path::new(name), None);
        FILES.iter().filter_map(|file| Some(Arc::new(read(file).ok()?))).collect()
    });
    &LESSONS
}
