//! Opens the window on a scene.

use std::fmt;
use std::io::Cursor;
use std::path::Path;

use etcetera::{BaseStrategy as _, choose_base_strategy};
use pinhole_exchange::FileError;
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::{SceneSource, builtin};

use crate::cli::arguments::WindowArguments;
use crate::model::files::OpenDocument;
use crate::model::store::{Remembered, Store};
use crate::platform;
use crate::platform::frame_log::{FRAME_TIMES, FrameLog};
use crate::platform::{PresentError, WindowOptions};
use crate::ui::app::{App, complain};
use crate::ui::motion;
use crate::ui::program::{FrameTimes, Program};

/// A reason why the window did not open, or closed early.
#[derive(Debug)]
pub enum WindowError {
    /// The named scene or lesson cannot be read.
    Scene(FileError),
    /// There is no display or no renderer.
    Present(PresentError),
}

impl fmt::Display for WindowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WindowError::Scene(error) => error.fmt(f),
            WindowError::Present(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for WindowError {}

/// Opens the window on the named scene or lesson, otherwise on that of the last run, otherwise on
/// the lecture's own scene. Returns when the window is closed.
///
/// # Errors
/// Returns an error if the named scene or lesson cannot be read, or if there is no display.
pub fn run(arguments: &WindowArguments) -> Result<(), WindowError> {
    let WindowArguments { scene, lesson, renderer } = arguments;
    let store = Store::of_user();
    let mut remembered = store.as_ref().map(Store::load).unwrap_or_default();
    if store.as_ref().is_none_or(Store::is_new) {
        remembered.settings.reduced_motion = wants_less_motion();
    }
    let lesson = match (lesson, scene) {
        (Some(lesson), _) => Some(lesson.load().map_err(WindowError::Scene)?),
        (None, Some(_)) => None,
        (None, None) => remembered.lesson_place().map(|place| (place, None)),
    };
    let Start { open, remembered, trouble } =
        start(scene.as_deref(), remembered).map_err(WindowError::Scene)?;
    let options = WindowOptions {
        title: "Pinhole".to_owned(),
        app_id: "pinhole".to_owned(),
        geometry: remembered.window,
        icon: icon(),
    };
    let mut app = App::new(open, remembered, store);
    if let Some((place, file)) = lesson {
        app.open_lesson(place, file);
    }
    if let Some(trouble) = trouble {
        app.tell("The last scene cannot be opened again", trouble);
    }
    let frame_log = std::env::var_os(FRAME_TIMES).map(FrameLog::to);
    if frame_log.is_some() {
        app.time_frames();
    }
    let make = |ctx: &egui::Context, info: &platform::RendererInfo| {
        App::set_up(ctx, &app.session().settings);
        app.drawn_by(info.to_string());
        Box::new(InWindow { app, frame_log }) as Box<dyn Program>
    };
    platform::run(*renderer, options, make).map_err(WindowError::Present)
}

/// Returns true if the desktop's settings ask for less motion.
fn wants_less_motion() -> bool {
    choose_base_strategy().is_ok_and(|places| motion::is_reduced(&places.config_dir()))
}

/// Returns the icon of the window; `None` still lets the window open.
fn icon() -> Option<egui::IconData> {
    let mut decoder = png::Decoder::new(Cursor::new(include_bytes!("../../assets/icon.png")));
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    Some(egui::IconData { rgba, width: info.width, height: info.height })
}

/// The app as the window's program.
struct InWindow {
    app: App,
    frame_log: Option<FrameLog>,
}

impl Program for InWindow {
    fn ui(&mut self, ui: &mut egui::Ui) {
        self.app.ui(ui);
    }

    fn wants_upload_time(&self) -> bool {
        self.frame_log.is_some()
    }

    fn presented(&mut self, times: &FrameTimes) {
        if let Some(log) = &mut self.frame_log {
            log.push(*times, self.app.work_presented());
        }
    }

    fn on_exit(&mut self) {
        self.app.on_exit();
        if let Some(log) = &self.frame_log
            && let Err(error) = log.save()
        {
            complain(&format!("{}: {error}", log.path.display()));
        }
    }
}

/// The document and state that the window opens with.
struct Start {
    open: OpenDocument,
    remembered: Remembered,
    /// The reason why it is not the scene of the last run.
    trouble: Option<String>,
}

/// Reads the scene to open: the named one, otherwise the last run's, otherwise the lecture's own.
fn start(scene: Option<&Path>, remembered: Remembered) -> Result<Start, FileError> {
    let load = |argument: &Path| {
        let source = SceneSource::from_argument(argument)?;
        Ok::<_, FileError>(OpenDocument::new(source.load()?, source))
    };
    if let Some(argument) = scene {
        // A ray selected in another scene has no meaning in this one.
        let remembered = Remembered { selection: None, ..remembered };
        return Ok(Start { open: load(argument)?, remembered, trouble: None });
    }
    let last = remembered.last.as_deref().map(load);
    match last {
        Some(Ok(open)) => Ok(Start { open, remembered, trouble: None }),
        Some(Err(error)) => Ok(Start {
            open: canonical()?,
            remembered: Remembered { selection: None, ..remembered },
            trouble: Some(error.to_string()),
        }),
        None => Ok(Start { open: canonical()?, remembered, trouble: None }),
    }
}

fn canonical() -> Result<OpenDocument, FileError> {
    match builtin::find("canonical") {
        Some(scene) => Ok(OpenDocument::new(scene.load()?, SceneSource::Builtin(scene))),
        None => Ok(OpenDocument::new(Document::default(), SceneSource::File("scene.toml".into()))),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_icon_is_a_picture() {
        let icon = super::icon().expect("assets/icon.png is a PNG");
        assert_eq!(icon.rgba.len(), (icon.width * icon.height * 4) as usize);
        assert!(icon.rgba.chunks(4).any(|pixel| pixel != &icon.rgba[..4]));
    }
}
