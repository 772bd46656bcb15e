//! The built-in scenes, and the lookup of the scene that a command-line argument names, a file or a
//! built-in scene.

use std::path::{Path, PathBuf};

use crate::document::Document;
use crate::error::nearest;
use crate::{FileError, scene_file};

/// The origin of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SceneSource {
    /// A scene file.
    File(PathBuf),
    /// A scene that comes with the program.
    Builtin(&'static BuiltinScene),
}

impl SceneSource {
    /// Returns the scene that an argument names. It is a file if there is one at this path, or if the
    /// argument can only be a path, because it contains a folder or ends in `.toml`. Otherwise it is
    /// the built-in scene with this name.
    ///
    /// # Errors
    /// Returns an error that suggests similar names if there is no such scene.
    pub fn from_argument(argument: &Path) -> Result<SceneSource, FileError> {
        let has_folder = argument.components().count() != 1 || argument.is_absolute();
        let is_toml = argument.extension().is_some_and(|extension| extension == "toml");
        let is_there = argument.symlink_metadata().is_ok_and(|data| !data.is_dir());
        if has_folder || is_toml || is_there {
            return Ok(SceneSource::File(argument.to_owned()));
        }
        let name = argument.to_string_lossy();
        if let Some(builtin) = BuiltinScene::find(&name) {
            return Ok(SceneSource::Builtin(builtin));
        }
        let near = BuiltinScene::nearest(&name);
        let hint = match &near[..] {
            [] => {
                let names: Vec<&str> = BuiltinScene::all().iter().map(|b| b.name).collect();
                format!("the built-in ones are {}", names.join(", "))
            }
            near => format!("did you mean {}?", near.join(" or ")),
        };
        let problem = format!("neither a file nor a built-in scene: {hint}");
        Err(FileError::of_file(argument, problem))
    }

    /// Reads the scene.
    ///
    /// # Errors
    /// Returns the first error in the file or in its CSV file.
    pub fn load(&self) -> Result<Document, FileError> {
        match self {
            SceneSource::File(path) => scene_file::load(path),
            SceneSource::Builtin(builtin) => builtin.load(),
        }
    }

    /// Returns the path of the scene file; `None` for a built-in scene.
    pub fn scene_file(&self) -> Option<&Path> {
        match self {
            SceneSource::File(path) => Some(path),
            SceneSource::Builtin(_) => None,
        }
    }
}

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltinScene {
    /// The name by which the scene is opened.
    pub name: &'static str,
    /// The text of the scene file.
    pub text: &'static str,
}

/// Expands to a list of the files `scenes/builtin/NAME.toml`.
macro_rules! scenes {
    [$($name:literal),* $(,)?] => {
        &[$(BuiltinScene {
            name: $name,
            text: include_str!(concat!("scenes/builtin/", $name, ".toml")),
        }),*]
    };
}

/// The built-in scenes in the order of the lecture: the canonical camera, then its parameters, and then
/// numerically difficult scenes.
const BUILTIN: &[BuiltinScene] = scenes![
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

impl BuiltinScene {
    /// Returns all built-in scenes, in the lecture's order.
    pub fn all() -> &'static [BuiltinScene] {
        BUILTIN
    }

    /// Returns the built-in scene with this name; `None` if there is none.
    pub fn find(name: &str) -> Option<&'static BuiltinScene> {
        BUILTIN.iter().find(|scene| scene.name == name)
    }

    /// Returns the names of built-in scenes similar to `name`, the nearest first.
    pub fn nearest(name: &str) -> Vec<&'static str> {
        nearest(name, BUILTIN.iter().map(|scene| scene.name))
    }

    /// Reads the scene.
    ///
    /// # Errors
    /// Never returns an error; tests check all built-in scenes.
    pub fn load(&self) -> Result<Document, FileError> {
        scene_file::parse(self.text, Path::new(self.name), Path::new(""))
    }

    /// Returns the first sentence of the scene's note, which summarises the scene.
    pub fn summary(&self) -> String {
        let note = self.text.lines().map_while(|line| line.strip_prefix("# "));
        let note = note.collect::<Vec<_>>().join(" ");
        note.split_inclusive(". ").next().unwrap_or_default().trim_end().to_owned()
    }
}
