//! Scenes by their argument on the command line: a file, or one of those that come with the program.

pub mod builtin;

use std::path::{Path, PathBuf};

use self::builtin::Builtin;
use crate::document::Document;
use crate::{FileError, scene_file};

/// Origin of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SceneSource {
    /// A scene file.
    File(PathBuf),
    /// A scene that comes with the program.
    Builtin(&'static Builtin),
}

impl SceneSource {
    /// A path if there is such a file, or if it can only be one (it has a folder, or ends in
    /// `.toml`); else the name of a built-in scene.
    ///
    /// # Errors
    /// Returns an error, with the names that are near, if there is no such scene.
    pub fn from_argument(argument: &Path) -> Result<SceneSource, FileError> {
        let has_folder = argument.components().count() != 1 || argument.is_absolute();
        let is_toml = argument.extension().is_some_and(|extension| extension == "toml");
        if has_folder || is_toml || argument.is_file() {
            return Ok(SceneSource::File(argument.to_owned()));
        }
        let name = argument.to_string_lossy();
        if let Some(builtin) = builtin::find(&name) {
            return Ok(SceneSource::Builtin(builtin));
        }
        let near = builtin::nearest(&name);
        let hint = match &near[..] {
            [] => {
                let names: Vec<&str> = builtin::all().iter().map(|b| b.name).collect();
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
    /// Returns the first error in the file.
    pub fn load(&self) -> Result<Document, FileError> {
        match self {
            SceneSource::File(path) => scene_file::load(path),
            SceneSource::Builtin(builtin) => builtin.load(),
        }
    }

    /// The scene file that it is.
    pub fn scene_file(&self) -> Option<&Path> {
        match self {
            SceneSource::File(path) => Some(path),
            SceneSource::Builtin(_) => None,
        }
    }
}
