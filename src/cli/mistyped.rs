//! Commands whose names are mistyped.

use std::ffi::OsStr;
use std::path::Path;

use clap::CommandFactory as _;
use clap::error::ContextKind;
use pinhole_exchange::scenes::SceneSource;

use super::arguments::Arguments;

/// Returns the error of a first argument that is neither a command nor a scene, but nearly a command's
/// name. As a scene may stand there, too, clap does not tell it by itself.
pub fn mistyped(first: &OsStr) -> Option<clap::Error> {
    if SceneSource::from_argument(Path::new(first)).is_ok() {
        return None;
    }
    let definition = Arguments::command();
    let commands = definition.get_subcommands().cloned();
    let alone = clap::Command::new("pinhole").subcommands(commands);
    let error = alone.try_get_matches_from([OsStr::new("pinhole"), first]).err()?;
    error.get(ContextKind::SuggestedSubcommand).is_some().then_some(error)
}
