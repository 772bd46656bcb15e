//! `pinhole scenes`: the built-in scenes, a line each.

use pinhole_exchange::scenes::builtin;

use super::console::to_stdout;
use super::error::CommandError;

pub(super) fn run() -> Result<(), CommandError> {
    let scenes = builtin::all();
    let width = scenes.iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    to_stdout(|out| {
        for scene in scenes {
            writeln!(out, "{:width$}  {}", scene.name, scene.summary())?;
        }
        Ok(())
    })
}
