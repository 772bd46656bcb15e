//! The headless commands, most of them in a file of their own. None of them uses a display or a graphics
//! driver.
//!
//! `pinhole scenes` and `pinhole completions` are here, `export` and `import` in `other_programs`.
//! The commands share `load` (the scene and its ray), `console` (standard streams and errors) and
//! `progress`.

pub mod arguments;
mod check;
mod check_class;
mod console;
mod figure;
mod inspect;
mod load;
mod other_programs;
mod page;
mod progress;
pub mod render;
#[cfg(feature = "report")]
mod report;
mod share;
mod trace;

use pinhole_exchange::scenes::BuiltinScene;
use serde_json::json;

pub use self::arguments::mistyped;
pub use self::console::{CommandError, exit_code, print};
use self::console::{columns, to_json, to_stdout};
use crate::cli::arguments::{Command, Shell};

/// Runs a command.
///
/// # Errors
/// Returns the reason if the command fails.
pub fn run(command: &Command) -> Result<(), CommandError> {
    match command {
        Command::Scenes { json } => list_scenes(*json),
        Command::Inspect(arguments) => inspect::run(arguments),
        Command::Render(arguments) => render::run(arguments),
        Command::Trace(arguments) => trace::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        #[cfg(feature = "report")]
        Command::Report(arguments) => report::run(arguments),
        #[cfg(not(feature = "report"))]
        Command::Report(_) => Err(console::not_built("report", "report")),
        Command::Figure(arguments) => figure::run(arguments),
        Command::Export(arguments) => other_programs::export(arguments),
        Command::Share(arguments) => share::run(arguments),
        Command::Import(arguments) => other_programs::import(arguments),
        Command::Page(arguments) => page::run(arguments),
        Command::Completions { shell } => complete(*shell),
    }
}

/// `pinhole completions`: prints the script with which a shell completes commands, options and scenes.
fn complete(shell: Shell) -> Result<(), CommandError> {
    let script = match shell {
        Shell::Bash => include_str!("../../assets/completions/pinhole.bash"),
        Shell::Zsh => include_str!("../../assets/completions/_pinhole"),
        Shell::Fish => include_str!("../../assets/completions/pinhole.fish"),
    };
    to_stdout(|out| out.write_all(script.as_bytes()))
}

/// `pinhole scenes`: lists the built-in scenes, one per line.
fn list_scenes(json: bool) -> Result<(), CommandError> {
    let scenes = BuiltinScene::all();
    if json {
        let listed = |scene: &BuiltinScene| json!({"name": scene.name, "summary": scene.summary()});
        let text = to_json(&json!({"scenes": scenes.iter().map(listed).collect::<Vec<_>>()}))?;
        return to_stdout(|out| out.write_all(text.as_bytes()));
    }
    let row = |scene: &BuiltinScene| [scene.name.to_owned(), scene.summary()];
    let lines = columns(&scenes.iter().map(row).collect::<Vec<_>>());
    to_stdout(|out| writeln!(out, "{}", lines.join("\n")))
}
