//! The scenes that come with the program.

use std::path::Path;

use super::FileError;
use super::molecule;
use super::scene_file;
use super::suggest;
use crate::document::Document;

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Builtin {
    /// What it is opened by.
    pub name: &'static str,
    /// The name of its file, whose ending says what it is.
    pub file: &'static str,
    /// Its file: a scene file, or a molecule's.
    pub text: &'static str,
}

/// A list of the files `assets/scenes/NAME.ENDING`.
macro_rules! scenes {
    [$($name:literal . $ending:ident),* $(,)?] => {
        &[$(Builtin {
            name: $name,
            file: concat!($name, ".", stringify!($ending)),
            text: include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"), "/assets/scenes/", $name, ".", stringify!($ending)
            )),
        }),*]
    };
}

/// In the lecture's order: the canonical camera, what may change about it, then where numbers get
/// difficult; last, something to look at.
const ALL: &[Builtin] = scenes![
    "canonical".toml,
    "distance-two".toml,
    "moved-eye".toml,
    "forty-five".toml,
    "look-at".toml,
    "roll".toml,
    "almost-parallel-up".toml,
    "planet".toml,
    "grazing".toml,
    "tiny-far".toml,
    "inside".toml,
    "non-square".toml,
    "caffeine".xyz,
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
    /// None, as the tests see to.
    pub fn load(&self) -> Result<Document, FileError> {
        let file = Path::new(self.file);
        if molecule::is_molecule(file) {
            return molecule::parse(self.text, file);
        }
        scene_file::parse(self.text, Path::new(self.name), Path::new(""))
    }

    /// Its text, if it is a scene file.
    pub fn scene_text(&self) -> Option<&'static str> {
        (!molecule::is_molecule(Path::new(self.file))).then_some(self.text)
    }

    /// The first sentence of its note: what it is, in a line.
    pub fn summary(&self) -> String {
        let note = match self.scene_text() {
            Some(text) => {
                let note = text.lines().map_while(|line| line.strip_prefix("# "));
                note.collect::<Vec<_>>().join(" ")
            }
            // Its line of comment.
            None => self.text.lines().nth(1).unwrap_or_default().to_owned(),
        };
        note.split_inclusive(". ").next().unwrap_or_default().trim_end().to_owned()
    }
}
