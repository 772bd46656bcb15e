//! The state that one run of the program stores for the next one: settings, window, recent files and
//! the last scene.

use std::path::{Path, PathBuf};

use etcetera::{AppStrategy, AppStrategyArgs, choose_app_strategy};
use pinhole_core::Selection;
use pinhole_exchange::host::host;
use pinhole_exchange::{FileError, limits};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::model::lessons::{StepId, Which};
use crate::model::practice::progress::Progress;
use crate::model::session::Settings;

/// The remembered state as stored on disk.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Remembered {
    /// Preferences.
    pub settings: Settings,
    /// The exercises that are done.
    pub progress: Progress,
    /// The position and size of the window.
    pub window: WindowGeometry,
    /// The selected ray of the scene that was open.
    #[serde(rename = "ray")]
    pub selection: Option<Selection>,
    /// The recently opened or saved files, newest first.
    pub recent: Vec<PathBuf>,
    /// The name of the window's renderer, for bug reports.
    pub renderer: String,
    /// The address of the page in a browser, which stands before links.
    pub address: String,
    /// The command-line argument that opens the scene that was open or, if a lesson was open, the scene
    /// before the lesson.
    pub last: Option<PathBuf>,
    /// The number of the built-in lesson that was open, and the number of its step, both counted from 1.
    pub lesson: Option<(usize, usize)>,
}

impl Remembered {
    /// Returns the step of the built-in lessons at which the last run ended; `None` if no lesson was
    /// open.
    pub fn lesson_step(&self) -> Option<StepId> {
        let (number, step) = self.lesson?;
        Some(StepId { lesson: Which::Builtin(number.checked_sub(1)?), step: step.checked_sub(1)? })
    }
}

/// Reads a file of which parts may be invalid: every value that can be read is used, and the others have
/// their defaults.
fn readable(text: &str) -> Remembered {
    let read: Value = serde_json::from_str(text).unwrap_or_default();
    let Ok(mut kept) = serde_json::to_value(Remembered::default()) else {
        return Remembered::default();
    };
    keep(&mut kept, "", &read);
    serde_json::from_value(kept).unwrap_or_default()
}

/// Copies `read` into the JSON value `kept`, at the place that the JSON pointer names. Each part that would
/// make the whole invalid is left out.
fn keep(kept: &mut Value, pointer: &str, read: &Value) {
    if let (Value::Object(entries), Some(Value::Object(known))) = (read, kept.pointer(pointer)) {
        let known: Vec<String> = known.keys().cloned().collect();
        for key in known {
            if let Some(value) = entries.get(&key) {
                keep(kept, &format!("{pointer}/{key}"), value);
            }
        }
        return;
    }
    let mut next = kept.clone();
    if let Some(value) = next.pointer_mut(pointer) {
        value.clone_from(read);
        if Remembered::deserialize(&next).is_ok() {
            *kept = next;
        }
    }
}

/// A file that stores [`Remembered`].
#[derive(Clone, Debug)]
pub struct Store {
    path: PathBuf,
}

impl Store {
    /// Returns the user's own store in the system's usual folder; `None` if there is no such folder
    /// because the user has no home directory.
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

    /// Creates a store that uses this file.
    pub fn at(path: &Path) -> Store {
        Store { path: path.to_owned() }
    }

    /// Returns the folder in which unsaved changes are recorded.
    pub fn unsaved(&self) -> PathBuf {
        self.path.with_file_name("unsaved")
    }

    /// Returns true if this is the program's first run, which has no stored state yet.
    pub fn is_new(&self) -> bool {
        host().stamp(&self.path).is_none()
    }

    /// Loads the stored state, with the default for every value that is missing or cannot be read.
    pub fn load(&self) -> Remembered {
        let text = limits::read_text(&self.path).unwrap_or_default();
        serde_json::from_str(&text).unwrap_or_else(|_| readable(&text))
    }

    /// Saves `state`, completely or not at all.
    ///
    /// # Errors
    /// Returns an error if the file could not be written.
    pub fn save(&self, state: &Remembered) -> Result<(), FileError> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        host().make_folder(folder)?;
        let text = serde_json::to_string_pretty(state)
            .map_err(|error| FileError::unwritable(&self.path, &error.into()))?;
        host().write(&self.path, text.as_bytes())
    }
}

/// The position and size of the window.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct WindowGeometry {
    /// Size of the window's content, in points without zoom.
    pub inner_size: [f32; 2],
    /// Top left corner of the window's frame; `None` if the desktop is to choose it.
    pub position: Option<[f32; 2]>,
    /// True if the window is maximised.
    pub maximized: bool,
    /// Number of pixels per point of the screen that showed the window.
    pub scale: f32,
}

impl Default for WindowGeometry {
    fn default() -> Self {
        Self { inner_size: [1280.0, 800.0], position: None, maximized: false, scale: 1.0 }
    }
}

impl WindowGeometry {
    /// Returns the number of pixels per point of the screen, clamped to the range of real screens.
    pub fn screen_scale(&self) -> f32 {
        self.scale.clamp(0.5, 8.0)
    }

    /// Stores the window's current position and size. The window calls this function each frame and
    /// saves the geometry on exit. While the window is maximised, minimised or in full screen, its
    /// normal position and size are kept.
    pub fn update(&mut self, ctx: &egui::Context) {
        let zoom = ctx.zoom_factor();
        ctx.input(|input| {
            let viewport = input.viewport();
            if viewport.minimized == Some(true) || viewport.fullscreen == Some(true) {
                return;
            }
            self.maximized = viewport.maximized == Some(true);
            self.scale = viewport.native_pixels_per_point.unwrap_or(self.scale);
            if self.maximized {
                return;
            }
            // Wayland reports no position, so neither rectangle of the window is available there.
            let size = viewport.inner_rect.map_or(input.viewport_rect().size(), |r| r.size());
            if size.x >= 1.0 && size.y >= 1.0 {
                self.inner_size = [size.x * zoom, size.y * zoom];
            }
            self.position = viewport.outer_rect.map(|r| [r.min.x * zoom, r.min.y * zoom]);
        });
    }
}

#[cfg(test)]
mod tests {
    use pinhole_core::methods::Method;

    use super::*;

    #[test]
    fn a_file_of_another_version_loses_only_what_is_unknown() {
        let settings = Settings { digits: 7, compared: Method::LadderF32, ..Settings::default() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut state = serde_json::to_value(&remembered).expect("JSON");
        let stored = &mut state["settings"];
        assert_eq!(
            (&stored["compared"], &stored["shade"]),
            (&"ladder-f32".into(), &"lambert".into())
        );
        stored["compared"] = "a-method-of-tomorrow".into();
        stored["layout"] = "Frame".into();
        stored["shade"] = "Normal".into();
        stored["eye_keeps"] = "View".into();
        stored["maps_certainty"] = true.into();
        stored["splits"]["frame"] = 350.into();
        let settings = Settings { compared: Settings::default().compared, ..settings };
        assert_eq!(readable(&state.to_string()), Remembered { settings, ..remembered });
    }
}
