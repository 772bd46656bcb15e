//! The app's first egui pass, and the log of the window's frame times.
//!
//! The first pass runs on another thread while the window opens: it reads the fonts, draws the glyphs and
//! traces the pictures, which is most of the cost of a first frame. If the window opens at the size at which
//! it was closed, its first frame only has to show the results.
//!
//! When the window is closed, `PINHOLE_FRAME_TIMES=times.csv pinhole` writes the time of each frame in
//! milliseconds, from input to presentation. The time of the first frame excludes the pass that ran
//! while the window opened. `tests/drag-latency.sh` computes the medians.

use std::panic::resume_unwind;
use std::path::PathBuf;
use std::thread::{JoinHandle, sleep, spawn};
use std::time::Duration;

use egui::{Context, FullOutput, RawInput, Rect, Vec2, ViewportId, ViewportInfo};

use crate::model::store::WindowGeometry;
use crate::platform::desktop::surface::MAX_TEXTURE_SIDE;
use crate::ui::app::App;
use crate::ui::frame_times::WorkTimes;

/// A first pass that may still be running.
pub(super) struct FirstPass(JoinHandle<(App, FullOutput)>);

impl FirstPass {
    /// Starts the first pass on another thread, for a window with the geometry from the end of the last run.
    pub(super) fn start(ctx: Context, mut app: App, geometry: WindowGeometry) -> FirstPass {
        App::set_up(&ctx, &app.session().settings());
        let input = input(geometry, ctx.zoom_factor());
        FirstPass(spawn(move || {
            let output = ctx.run_ui(input, |ui| app.ui(ui));
            (app, output)
        }))
    }

    /// Waits for the end of the pass. Returns the app, and the pass's output for the window. Meanwhile,
    /// the calling thread helps with the pass's parallel work; with one processor, it does all of that
    /// work.
    pub(super) fn end(self) -> (App, FullOutput) {
        while !self.0.is_finished() {
            if rayon::yield_now() != Some(rayon::Yield::Executed) {
                sleep(Duration::from_micros(100));
            }
        }
        self.0.join().unwrap_or_else(|panic| resume_unwind(panic))
    }

    /// Ends the pass and drops the app, because no window has opened.
    pub(super) fn discard(self) {
        let (_, output) = self.end();
        output.drop_without_applying_deltas();
    }
}

/// Returns egui's input for the first pass of a window with this geometry and zoom. It contains no events.
fn input(geometry: WindowGeometry, zoom: f32) -> RawInput {
    let info = ViewportInfo {
        native_pixels_per_point: Some(geometry.screen_scale()),
        maximized: Some(geometry.maximized),
        ..ViewportInfo::default()
    };
    let size = Vec2::from(geometry.inner_size).clamp(Vec2::splat(64.0), Vec2::splat(4096.0)) / zoom;
    RawInput {
        screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, size)),
        max_texture_side: Some(MAX_TEXTURE_SIDE),
        time: Some(0.0),
        viewports: [(ViewportId::ROOT, info)].into_iter().collect(),
        ..RawInput::default()
    }
}

/// The environment variable that holds the path of the log: a CSV file with one row per frame, in
/// milliseconds.
const FRAME_TIMES: &str = "PINHOLE_FRAME_TIMES";

/// The columns of the log:
/// - `since_input`, from the first input event that the frame handles until the frame was presented; empty
///   for a frame without input, such as one of an animation;
/// - `frame`, from the start of the app's pass until the frame was presented, with these three parts:
///   - `ui`, the app's pass, including egui's own work before and after it;
///   - `paint`, uploading new pictures and glyphs, tessellating and drawing; with wgpu, issuing the draw
///     commands;
///   - `wait`, waiting until the display accepts another frame;
/// - `trace`, `overlay` and `readouts`, which are parts of `ui`, and `own`, their sum; all four are empty
///   for a frame without a new picture.
const COLUMNS: &str = "since_input,frame,ui,paint,wait,trace,overlay,readouts,own\n";

/// The frames presented so far.
pub(super) struct FrameLog {
    pub(super) path: PathBuf,
    /// The times of each presented frame, in the order of [`COLUMNS`].
    frames: Vec<[Option<Duration>; 9]>,
}

impl FrameLog {
    /// Creates a log if the environment variable `PINHOLE_FRAME_TIMES` is set; otherwise returns
    /// `None`.
    pub(super) fn from_environment() -> Option<FrameLog> {
        let path = std::env::var_os(FRAME_TIMES)?.into();
        Some(FrameLog { path, frames: Vec::new() })
    }

    /// Adds a presented frame: the times of the first columns, and of its work, if it showed a new picture.
    pub(super) fn add(
        &mut self,
        since_input: Option<Duration>,
        presented: [Duration; 4],
        work: Option<WorkTimes>,
    ) {
        let [frame, ui, paint, wait] = presented.map(Some);
        let [trace, overlay, readouts] = [0, 1, 2].map(|kind| work.map(|times| times[kind]));
        let own = work.map(|times| times.iter().sum());
        self.frames.push([since_input, frame, ui, paint, wait, trace, overlay, readouts, own]);
    }

    /// Writes the CSV file.
    pub(super) fn save(&self) -> std::io::Result<()> {
        let ms = |time: Duration| format!("{:.3}", 1e3 * time.as_secs_f64());
        let cells = |row: &[Option<Duration>; 9]| row.map(|time| time.map(ms).unwrap_or_default());
        let rows = self.frames.iter().map(|row| cells(row).join(",") + "\n");
        std::fs::write(&self.path, COLUMNS.to_owned() + &rows.collect::<String>())
    }
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::model::files::OpenDocument;
    use crate::model::session::Settings;
    use crate::model::store::Remembered;

    /// Runs the app's first pass for a window with this geometry and zoom, as before the window's first
    /// frame. Returns the egui context and the app after that pass.
    fn opened(geometry: WindowGeometry, zoom: f32) -> (Context, App) {
        let open = OpenDocument::blank();
        let mut settings = Settings::default();
        settings.preferences.zoom = zoom;
        let app = App::new(open, Remembered { settings, ..Remembered::default() }, None);
        let ctx = crate::platform::desktop::start::context();
        let (app, output) = FirstPass::start(ctx.clone(), app, geometry).end();
        assert!(!output.textures_delta.set.is_empty(), "glyphs and pictures are to be uploaded");
        output.drop_without_applying_deltas();
        (ctx, app)
    }

    #[test]
    fn a_window_of_the_same_size_has_nothing_to_trace_or_draw_in_its_first_frame() {
        for zoom in [1.0, 1.3, 0.8] {
            let geometry = WindowGeometry { scale: 1.5, ..WindowGeometry::default() };
            let (ctx, mut app) = opened(geometry, zoom);
            assert_eq!(ctx.zoom_factor(), zoom);
            let traced = app.pictures_traced();
            assert!(traced > 0);
            let input = RawInput { time: Some(0.1), ..input(geometry, zoom) };
            let output = ctx.run_ui(input, |ui| app.ui(ui));
            assert_eq!(app.pictures_traced(), traced);
            assert!(output.textures_delta.set.is_empty(), "{:?}", output.textures_delta);
        }
    }

    #[test]
    fn a_remembered_geometry_that_no_screen_has_opens_a_window() {
        for inner_size in [[0.0; 2], [-5.0, 1e30], [f32::INFINITY; 2]] {
            for scale in [0.0, -1.0, 1e30] {
                let geometry = WindowGeometry { inner_size, scale, ..WindowGeometry::default() };
                opened(geometry, 1.0);
            }
        }
    }
}
