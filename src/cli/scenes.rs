//! `pinhole scenes`: the built-in scenes, a line each.

use pinhole_exchange::scenes::BuiltinScene;
use serde::Serialize;

use super::console::{CommandError, to_json, to_stdout};
use crate::cli::arguments::ScenesArguments;

/// The list as JSON.
#[derive(Serialize)]
struct List {
    scenes: Vec<Listed>,
}

#[derive(Serialize)]
struct Listed {
    name: &'static str,
    summary: String,
}

pub(super) fn run(arguments: &ScenesArguments) -> Result<(), CommandError> {
    let scenes = BuiltinScene::all();
    if arguments.json {
        let listed =
            scenes.iter().map(|scene| Listed { name: scene.name, summary: scene.summary() });
        let text = to_json(&List { scenes: listed.collect() })?;
        return to_stdout(|out| out.write_all(text.as_bytes()));
    }
    let width = scenes.iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    to_stdout(|out| {
        for scene in scenes {
            writeln!(out, "{:width$}  {}", scene.name, scene.summary())?;
        }
        Ok(())
    })
}
