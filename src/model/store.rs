//! What one run remembers for the next: settings, window, recent files and the last scene.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use etcetera::{AppStrategy, AppStrategyArgs, choose_app_strategy};
use pinhole_core::{DVec2, Pixel};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::model::lessons::{Place, Which};
use crate::model::session::{Selection, Settings};
use crate::model::window_geometry::WindowGeometry;
use pinhole_exchange::{FileError, atomic};

/// The remembered state, as it is on disk.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Remembered {
    /// Preferences.
    pub settings: Settings,
    /// The window's place.
    pub window: WindowGeometry,
    /// The selected ray of the scene that was open.
    pub selection: Option<RememberedRay>,
    /// Files opened or saved lately, newest first.
    pub recent: Vec<PathBuf>,
    /// What drew the window, for reports of what went wrong.
    pub renderer: String,
    /// The scene that was open, as the command line names it; before the lesson, if one was.
    pub last: Option<PathBuf>,
    /// The lesson that was open and its step, both counted from 1.
    pub lesson: Option<(usize, usize)>,
}

impl Remembered {
    /// Where in the program's lessons the last run ended.
    pub fn lesson_place(&self) -> Option<Place> {
        let (number, step) = self.lesson?;
        Some(Place { lesson: Which::Builtin(number.checked_sub(1)?), step: step.checked_sub(1)? })
    }
}

/// A [`Selection`], in a form that is written to disk.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RememberedRay {
    /// Row and column, from 0.
    Pixel(u32, u32),
    /// u and v.
    Uv(f64, f64),
}

impl From<Selection> for RememberedRay {
    fn from(selection: Selection) -> Self {
        match selection {
            Selection::Pixel(pixel) => RememberedRay::Pixel(pixel.row, pixel.column),
            Selection::Uv(uv) => RememberedRay::Uv(uv.x, uv.y),
        }
    }
}

impl From<RememberedRay> for Selection {
    fn from(ray: RememberedRay) -> Self {
        match ray {
            RememberedRay::Pixel(row, column) => Selection::Pixel(Pixel { row, column }),
            RememberedRay::Uv(u, v) => Selection::Uv(DVec2::new(u, v)),
        }
    }
}

/// As much of a file that is wrong somewhere as can be read: the values that fit, one by one.
fn readable(text: &str) -> Remembered {
    let read: Value = serde_json::from_str(text).unwrap_or_default();
    let Ok(mut kept) = serde_json::to_value(Remembered::default()) else {
        return Remembered::default();
    };
    keep(&mut kept, "", &read);
    serde_json::from_value(kept).unwrap_or_default()
}

/// Puts what was `read` at a place (a JSON pointer) into what is `kept`, as far as that can be read
/// then.
fn keep(kept: &mut Value, place: &str, read: &Value) {
    if let (Value::Object(entries), Some(Value::Object(known))) = (read, kept.pointer(place)) {
        let known: Vec<String> = known.keys().cloned().collect();
        for key in known {
            if let Some(value) = entries.get(&key) {
                keep(kept, &format!("{place}/{key}"), value);
            }
        }
        return;
    }
    let mut next = kept.clone();
    if let Some(value) = next.pointer_mut(place) {
        value.clone_from(read);
        if Remembered::deserialize(&next).is_ok() {
            *kept = next;
        }
    }
}

/// A file that keeps [`Remembered`].
#[derive(Clone, Debug)]
pub struct Store {
    path: PathBuf,
}

impl Store {
    /// The user's own, in the place that the system has for it; `None` where there is no such
    /// place (no home directory).
    pub fn of_user() -> Option<Store> {
        let strategy = choose_app_strategy(AppStrategyArgs {
            top_level_domain: "org".to_owned(),
            author: "Pinhole".to_owned(),
            app_name: "pinhole".to_owned(),
        })
        .ok()?;
        let folder = strategy.state_dir().unwrap_or_else(|| strategy.data_dir());
        Some(Store { path: folder.join("state.json") })
    }

    /// A store in this file.
    pub fn at(path: &Path) -> Store {
        Store { path: path.to_owned() }
    }

    /// Where a scene goes whose window went away before it could be saved.
    pub fn unsaved(&self) -> PathBuf {
        self.path.with_file_name("unsaved.toml")
    }

    /// Whether there was no run before this one.
    pub fn is_new(&self) -> bool {
        !self.path.exists()
    }

    /// What was remembered; the default where nothing was, and for each value that cannot be read.
    pub fn load(&self) -> Remembered {
        let text = std::fs::read_to_string(&self.path).unwrap_or_default();
        serde_json::from_str(&text).unwrap_or_else(|_| readable(&text))
    }

    /// Remembers `state`, whole or not at all.
    ///
    /// # Errors
    /// Why it could not be written.
    pub fn save(&self, state: &Remembered) -> Result<(), FileError> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder).map_err(|error| FileError::unwritable(folder, &error))?;
        atomic::write(&self.path, |file| {
            file.write_all(serde_json::to_string_pretty(state)?.as_bytes())
        })
    }
}
