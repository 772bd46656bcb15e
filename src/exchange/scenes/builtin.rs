//! The scenes that come with the program.

use std::path::Path;

use crate::document::Document;
use crate::{FileError, scene_file, suggest};

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Builtin {
    /// Name that it is opened by.
    pub name: &'static str,
    /// Its file: a scene file.
    pub text: &'static str,
}

/// A list of the files `builtin/NAME.toml`.
macro_rules! scenes {
    [$($name:literal),* $(,)?] => {
        &[$(Builtin {
            name: $name,
            text: include_str!(concat!("builtin/", $name, ".toml")),
        }),*]
    };
}

/// Built-in scenes in the lecture's order: the canonical camera, what may change about it, then where numbers get
/// difficult.
const ALL: &[Builtin] = scenes![
    "canonical",
    "distance-two",
    "moved-eye",
    "forty-five",
    "look-at",
    "roll",
    "almost-parallel-up",
    "planet",
    "grazing",
    "tiny-far",
    "inside",
    "non-square",
];

/// All of them.
pub fn all() -> &'static [Builtin] {
    ALL
}

/// The one of this name.
pub fn find(name: &str) -> Option<&'static Builtin> {
    ALL.iter().find(|builtin| builtin.name == name)
}

/// The names that this could be a slip for, nearest first.
pub fn nearest(name: &str) -> Vec<&'static str> {
    suggest::nearest(name, ALL.iter().map(|builtin| builtin.name))
}

impl Builtin {
    /// The scene.
    ///
    /// # Errors
    /// Never fails; tests check all scenes.
    pub fn load(&self) -> Result<Document, FileError> {
        scene_file::parse(self.text, Path::new(self.name), Path::new(""))
    }

    /// The first sentence of its note: what it is, in a line.
    pub fn summary(&self) -> String {
        let note = self.text.lines().map_while(|line| line.strip_prefix("# "));
        let note = note.collect::<Vec<_>>().join(" ");
        note.split_inclusive(". ").next().unwrap_or_default().trim_end().to_owned()
    }
}
