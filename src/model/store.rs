//! The state that one run of the program stores for the next one: settings, window, recent files and
//! the last scene. Windows that are open at the same time lose nothing to each other.

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use etcetera::{AppStrategy, AppStrategyArgs, choose_app_strategy};
use pinhole_core::Selection;
use pinhole_exchange::host::{Lock, host};
use pinhole_exchange::{FileError, limits};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::features::exercises::progress::Progress;
use crate::model::files::remember;
use crate::model::lessons::{StepId, Which};
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

    /// Returns what to store for this window, whose state was `base` when it last read or wrote the stored one,
    /// which is now `theirs`. Other windows' settings, exercises and recent files stay where this window has not
    /// changed its own. What was open, and where, is this window's.
    fn merged(&self, base: &Remembered, theirs: &Remembered) -> Remembered {
        let mut recent = theirs.recent.clone();
        newest(&base.recent, &self.recent)
            .iter()
            .rev()
            .for_each(|path| remember(&mut recent, path));
        let progress = self.progress.merged(&base.progress, &theirs.progress);
        let of = |one: &Remembered| {
            let (settings, address) = (one.settings, one.address.clone());
            serde_json::to_value(Remembered { settings, address, ..self.clone() })
                .unwrap_or_default()
        };
        let mut all = of(theirs);
        take(&of(base), &of(self), &mut all);
        let all = serde_json::from_value(all).unwrap_or_else(|_| self.clone());
        Remembered { progress, recent, ..all }
    }
}

/// Takes what differs from `base` in `mine` over into `theirs`, value by value.
fn take(base: &Value, mine: &Value, theirs: &mut Value) {
    if let (Value::Object(all), Value::Object(_)) = (mine, &*theirs) {
        all.iter().for_each(|(key, mine)| take(&base[key], mine, &mut theirs[key]));
    } else if base != mine {
        theirs.clone_from(mine);
    }
}

/// Returns the files that were put first in the list of recent files, which was `base`.
fn newest<'a>(base: &[PathBuf], now: &'a [PathBuf]) -> &'a [PathBuf] {
    let is_older = |count: &usize| {
        let older = base.iter().filter(|path| !now[..*count].contains(path));
        older.take(now.len() - count).eq(&now[*count..])
    };
    &now[..(0..now.len()).find(is_older).unwrap_or(now.len())]
}

/// Reads a file of which parts may be invalid: every value that can be read is used, and the others are those of
/// `otherwise`.
fn readable(text: &str, otherwise: &Remembered) -> Remembered {
    if let Ok(all) = serde_json::from_str(text) {
        return all;
    }
    let read: Value = serde_json::from_str(text).unwrap_or_default();
    let mut kept = serde_json::to_value(otherwise).unwrap_or_default();
    keep(&mut kept, "", &read);
    serde_json::from_value(kept).unwrap_or_else(|_| otherwise.clone())
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
        readable(&text, &Remembered::default())
    }

    /// Saves the changes of a window from `base`, its state when it last loaded or saved it, to `state`. The file is
    /// written completely or not at all, and keeps what other windows have changed meanwhile.
    ///
    /// # Errors
    /// Returns an error if the file could not be written.
    pub fn save(&self, base: &Remembered, state: &Remembered) -> Result<(), FileError> {
        host().make_folder(self.path.parent().unwrap_or(Path::new(".")))?;
        let _turn = self.turn();
        let mut stored = Vec::new();
        if !self.is_new() {
            let read = host().open(&self.path)?.take(limits::TEXT).read_to_end(&mut stored);
            read.map_err(|error| FileError::unreadable(&self.path, &error))?;
        }
        let theirs = readable(&String::from_utf8_lossy(&stored), state);
        let merged = state.merged(base, &theirs);
        let text = serde_json::to_string_pretty(&merged)
            .map_err(|error| FileError::unwritable(&self.path, &error.into()))?;
        host().write(&self.path, text.as_bytes())
    }

    /// Waits until no other window saves its state, for at most 5 s: it may hang. Returns `None` then, and if
    /// the host cannot lock. In a browser, nothing comes between reading and writing.
    fn turn(&self) -> Option<Lock> {
        const PAUSE: Duration = Duration::from_millis(10);
        let path = self.path.with_extension("lock");
        let tries = if host().has_folders() { 500 } else { 0 };
        for _ in 0..tries {
            match host().lock(&path) {
                Ok(None) => thread::sleep(PAUSE),
                tried => return tried.ok().flatten(),
            }
        }
        None
    }
}

with_defaults! {
    /// The position and size of the window.
    #[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
    #[serde(default)]
    pub struct WindowGeometry {
        /// Size of the window's content, in points without zoom.
        pub inner_size: [f32; 2] = [1280.0, 800.0],
        /// Top left corner of the window's frame; `None` if the desktop is to choose it.
        pub position: Option<[f32; 2]> = None,
        /// True if the window is maximised.
        pub maximized: bool = false,
        /// Number of pixels per point of the screen that showed the window.
        pub scale: f32 = 1.0,
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

    use std::sync::Barrier;

    use super::*;
    use crate::model::session::Split;

    fn done(names: &[&str]) -> Progress {
        Progress::from(serde_json::json!(names))
    }

    fn store() -> (tempfile::TempDir, Store) {
        let folder = tempfile::tempdir().expect("a folder");
        let store = Store::at(&folder.path().join("state.json"));
        (folder, store)
    }

    fn paths(names: &[&str]) -> Vec<PathBuf> {
        names.iter().map(|name| std::path::absolute(name).expect("a path")).collect()
    }

    #[test]
    fn windows_that_are_open_at_the_same_time_lose_nothing_to_each_other() {
        let (_folder, store) = store();
        let (progress, recent) = (done(&["sphere", "distance"]), paths(&["a", "b", "c"]));
        let base = Remembered { progress, recent, ..Remembered::default() };
        assert_eq!(store.save(&Remembered::default(), &base), Ok(()));
        let [mut one, mut two] = [base.clone(), base.clone()];
        one.settings.setup.digits = 7;
        one.settings.preferences.unfolded.ray = true;
        one.settings.preferences.splits.set(Split::Views, 0.3);
        one.progress = done(&["sphere", "distance", "lines"]);
        one.recent = paths(&["b", "one", "a", "c"]);
        two.settings.preferences.zoom = 1.5;
        two.settings.preferences.unfolded.objects = true;
        two.settings.preferences.splits.set(Split::Stack, 0.3);
        two.progress = done(&["distance", "turned-basis"]);
        two.recent = paths(&["two", "a", "b", "c"]);
        two.address = "https://example.org".to_owned();
        two.last = Some("planet".into());
        assert_eq!((store.save(&base, &one), store.save(&base, &two)), (Ok(()), Ok(())));
        let mut wanted = Remembered { settings: one.settings, ..two.clone() };
        wanted.settings.preferences.zoom = 1.5;
        wanted.settings.preferences.unfolded.objects = true;
        wanted.settings.preferences.splits.set(Split::Stack, 0.3);
        wanted.progress = done(&["distance", "lines", "turned-basis"]);
        wanted.recent = paths(&["two", "b", "one", "a", "c"]);
        assert_eq!(store.load(), wanted);
        // What a window has not changed since stays another's; what was open is its own.
        one.progress = done(&[]);
        let before = Remembered { progress: done(&["lines"]), ..one.clone() };
        assert_eq!(store.save(&before, &one), Ok(()));
        wanted.progress = done(&["distance", "turned-basis"]);
        wanted.last = None;
        assert_eq!(store.load(), wanted);
    }

    #[test]
    fn windows_that_save_at_once_lose_nothing_to_each_other() {
        const WINDOWS: usize = 6;
        let names: Vec<String> = (0..WINDOWS).map(|window| format!("file-{window}")).collect();
        for _ in 0..20 {
            let (_folder, store) = store();
            let start = Barrier::new(WINDOWS);
            std::thread::scope(|scope| {
                for name in &names {
                    let own = Remembered { recent: paths(&[name]), ..Remembered::default() };
                    let (store, start) = (&store, &start);
                    scope.spawn(move || {
                        start.wait();
                        assert_eq!(store.save(&Remembered::default(), &own), Ok(()));
                    });
                }
            });
            let mut recent = store.load().recent;
            recent.sort();
            assert_eq!(recent, paths(&names.iter().map(String::as_str).collect::<Vec<_>>()));
        }
    }

    /// Its settings are what this window knows, not the defaults.
    #[test]
    fn a_file_that_is_gone_or_broken_is_written_again() {
        let (folder, store) = store();
        let mut own = Remembered::default();
        own.settings.setup.digits = 7;
        for text in [&b""[..], b"{ not json", b"\xff\xfe{}", b"[7]", b"gone"] {
            let path = folder.path().join("state.json");
            std::fs::write(&path, text).expect("a file");
            if text == b"gone" {
                std::fs::remove_file(&path).expect("a file");
            }
            assert_eq!(store.save(&own, &own), Ok(()));
            assert_eq!(store.load(), own, "{text:?}");
        }
    }

    #[test]
    fn a_file_of_another_version_loses_only_what_is_unknown() {
        let mut settings = Settings::default();
        (settings.setup.digits, settings.preferences.compared) = (7, Method::LadderF32);
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
        settings.preferences.compared = Settings::default().preferences.compared;
        let read = readable(&state.to_string(), &Remembered::default());
        assert_eq!(read, Remembered { settings, ..remembered });
    }
}
