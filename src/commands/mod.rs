//! The headless commands, one a file. None of them touches a display or a graphics driver.

mod animation;
mod bench;
mod check;
mod export;
mod figure;
mod import;
mod inspect;
mod outputs;
mod progress;
mod render;
pub mod render_view;
mod report;
mod scenes;
mod trace;

use std::fmt;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;

use pinhole_core::{CameraError, DVec2, ImageSize, Pixel, PosedCamera};

use crate::arguments::Command;
use crate::session::Selection;
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::SceneSource;
use pinhole_exchange::{FileError, scene_file};

/// Why a command did not do what it was asked to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CommandError {
    /// The input is at fault: exit status 1.
    Input(String),
    /// The arguments do not go together: exit status 2.
    Arguments(String),
    /// The answers were graded, and not all of them agree: exit status 1, and no message.
    Disagrees,
    /// There is nothing to grade, or nothing to grade it by: exit status 2.
    Unreadable(String),
    /// Nobody reads standard output any more. Nothing is wrong.
    ReaderGone,
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CommandError::Input(message)
            | CommandError::Arguments(message)
            | CommandError::Unreadable(message) => f.write_str(message),
            CommandError::Disagrees => f.write_str("not all answers agree"),
            CommandError::ReaderGone => f.write_str("nobody reads standard output"),
        }
    }
}

impl std::error::Error for CommandError {}

impl From<FileError> for CommandError {
    fn from(error: FileError) -> Self {
        CommandError::Input(error.to_string())
    }
}

/// Runs a command.
///
/// # Errors
/// Why it could not be done.
pub fn run(command: &Command) -> Result<(), CommandError> {
    match command {
        Command::Scenes => scenes::run(),
        Command::Inspect(arguments) => inspect::run(arguments),
        Command::Render(arguments) => render::run(arguments),
        Command::Trace(arguments) => trace::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::Report(arguments) => report::run(arguments),
        Command::Bench(arguments) => bench::run(arguments),
        Command::Figure(arguments) => figure::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Import(arguments) => import::run(arguments),
    }
}

/// The exit status of a command; its error goes to standard error.
pub fn exit_code(result: Result<(), CommandError>) -> ExitCode {
    let status = match &result {
        Ok(()) | Err(CommandError::ReaderGone) => return ExitCode::SUCCESS,
        Err(CommandError::Disagrees) => return ExitCode::from(1),
        Err(CommandError::Input(_)) => 1,
        Err(CommandError::Arguments(_) | CommandError::Unreadable(_)) => 2,
    };
    if let Err(error) = result {
        // Where standard error is closed too, the status has to do.
        let _ = writeln!(io::stderr(), "pinhole: {error}");
    }
    ExitCode::from(status)
}

/// Says on standard error what was done otherwise than one may think.
fn warn(note: &str) {
    // Where standard error is closed, there is nobody to tell.
    let _ = writeln!(io::stderr(), "pinhole: note: {note}");
}

/// Reads the scene that an argument means.
fn load(scene: &Path) -> Result<Document, CommandError> {
    Ok(SceneSource::from_argument(scene)?.load()?)
}

/// The camera of a scene, ready for its rays.
///
/// What is wrong with it is told at its place in the scene file, as what cannot be read is.
fn pose(scene: &Path, document: &Document) -> Result<PosedCamera, CommandError> {
    let place_of = |error: &CameraError| match SceneSource::from_argument(scene) {
        Ok(source) => scene_file::camera_fault(source.scene_file()?, error),
        Err(_) => None,
    };
    document.camera.posed().map_err(|error| match place_of(&error) {
        Some(fault) => fault.into(),
        None => of_scene(scene, error),
    })
}

/// The ray that is asked for; that through the viewport's centre where none is.
fn selection_of(
    camera: &PosedCamera,
    pixel: Option<Pixel>,
    uv: Option<DVec2>,
) -> Result<Selection, String> {
    let selection = match (pixel, uv) {
        (Some(pixel), _) => {
            inside(camera.image(), pixel)?;
            Selection::Pixel(pixel)
        }
        (None, uv) => Selection::Uv(uv.unwrap_or_default()),
    };
    if !camera.ray(selection.uv(camera)).direction.is_finite() {
        return Err("the ray's direction is beyond the range of numbers: make the viewport, its \
                    distance or (u, v) smaller"
            .to_owned());
    }
    Ok(selection)
}

fn inside(image: ImageSize, pixel: Pixel) -> Result<(), String> {
    if image.contains(pixel) {
        return Ok(());
    }
    let Pixel { row, column } = pixel;
    let (width, height) = (image.width(), image.height());
    Err(format!(
        "pixel {row},{column} is outside the image of {height} rows and {width} columns: rows are \
         0 to {}, columns 0 to {}",
        height - 1,
        width - 1
    ))
}

/// Turns what is wrong with a scene's camera or objects into what is wrong with the scene.
fn of_scene(scene: &Path, error: impl fmt::Display) -> CommandError {
    CommandError::Input(format!("{}: {error}", scene.display()))
}

/// Refuses the name of another format: what it promises is not what would be in the file.
fn named(output: &Path, ending: &str, what: &str) -> Result<(), CommandError> {
    match output.extension() {
        Some(other) if !other.eq_ignore_ascii_case(ending) => {
            let stem = output.with_extension(ending);
            let problem = format!("{what}: not {} but {}", output.display(), stem.display());
            Err(CommandError::Arguments(problem))
        }
        _ => Ok(()),
    }
}

/// Writes to standard output, with care for a reader who has seen enough.
fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CommandError> {
    let mut out = BufWriter::new(io::stdout().lock());
    write(&mut out).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => CommandError::ReaderGone,
        _ => CommandError::Input(format!("standard output cannot be written: {error}")),
    })
}
