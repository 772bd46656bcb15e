//! The camera's picture, drawn by the exact method (called the ladder), and the errors of another method.
//! Tracing reports its work to an [`OnWork`] callback, whose owner measures the time, so
//! this module needs no clock.

use std::fmt;
use std::sync::Arc;

use egui::Color32;
use pinhole_core::methods::{Method, trace_by};
use pinhole_core::{
    Counts, Depth, Frame, NO_OBJECT, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, Selection,
    Shade, Steps, retrace_painted, shade, trace, trace_painted,
};
use pinhole_figure::overlay::{Loupe, Picture, loupe_window};
use pinhole_figure::{Inspection, Item};
use pinhole_lecture::numbers::grouped;

use crate::features::accuracy::comparison::{self, Comparison};
use crate::view::adaptive_resolution::Subsampling;
use crate::view::derive::{GoodWorld, Inputs, Memo, SecondPicture, Spares, opaque};

/// Maximum number of ray-object tests that a method may do for one picture. They take about a second,
/// during which the window does not respond.
pub const MOST_QUESTIONS: u64 = 400_000_000;

/// The reason why there is no error map: every method but the exact one (the ladder) tests every object at
/// every pixel, which would take more than [`MOST_QUESTIONS`] tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooMany {
    /// Number of objects in the scene.
    pub objects: u64,
    /// Number of pixels on the screen.
    pub pixels: u64,
}

impl TooMany {
    fn check(objects: usize, pixels: usize) -> Option<TooMany> {
        let (objects, pixels) = (objects as u64, pixels as u64);
        let too_many = objects.saturating_mul(pixels) > MOST_QUESTIONS;
        too_many.then_some(TooMany { objects, pixels })
    }
}

impl fmt::Display for TooMany {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [objects, pixels] = [self.objects, self.pixels].map(grouped);
        write!(
            f,
            "{objects} objects at {pixels} pixels are too many for a method that asks every object \
             at every pixel"
        )
    }
}

/// A method's picture, compared with the answers of the exact method (the ladder).
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The method.
    pub method: Method,
    /// The error of every pixel.
    pub comparison: Comparison,
    /// The method's answers for all pixels.
    pub frame: Frame,
    /// The error map.
    pub picture: Arc<Picture>,
}

/// The camera's picture and the selected ray.
#[derive(Clone, Debug)]
pub(super) struct GoodPicture {
    pub(super) resolved: ResolvedCamera,
    pub(super) picture: Arc<Picture>,
    pub(super) inspection: Arc<Inspection>,
    /// Number of decisions that each step of the exact method (the ladder) made.
    pub(super) steps: Steps,
    /// The picture's subsampling.
    pub(super) subsampling: Subsampling,
    /// Numbers of spheres and rows that the renderer could skip.
    pub(super) counts: Counts,
    /// The answers of the error map's method, or the reason why it has none; `None` without an error map.
    pub(super) compared: Option<Result<Arc<Compared>, TooMany>>,
    /// The content of the loupe, if it is shown.
    pub(super) loupe: Option<Arc<Loupe>>,
}

/// The inputs of a trace. `generation` is that of the objects.
#[derive(Clone, Debug, PartialEq)]
struct TraceKey {
    resolved: ResolvedCamera,
    generation: u64,
    raster: Raster,
}

/// The inputs of a picture's colours. `palette` is the generation number of the objects' colours; with `clear`,
/// the picture is transparent where no object is hit. Only the first `scanned` pixels are shown, counted row by
/// row; `None` shows all of them.
#[derive(Clone, Debug, PartialEq)]
struct PictureKey {
    trace: TraceKey,
    shade: Shade,
    palette: u64,
    clear: bool,
    scanned: Option<u64>,
}

/// A picture, the number of decisions at each step of the exact method (the ladder), and how many spheres
/// and rows were skipped.
type MadePicture = (Arc<Picture>, Steps, Counts);

/// A cache of the camera's pictures.
#[derive(Debug, Default)]
pub(super) struct Pictures {
    truth: Memo<TraceKey, Arc<Frame>>,
    /// The last frame, which can be recoloured without tracing. It contains the objects and, if the flag in
    /// its key is true, `t`.
    rough: Memo<(TraceKey, bool), Arc<Frame<f32>>>,
    /// The answers of the error map's method.
    compared: Memo<(Method, TraceKey), Arc<Compared>>,
    picture: Memo<PictureKey, MadePicture>,
    shown: Spares<Picture, 2>,
    inspection: Memo<(ResolvedCamera, u64, Selection), Arc<Inspection>>,
    loupe: Memo<(PictureKey, u32, bool), Arc<Loupe>>,
    fineness: Memo<(ResolvedCamera, u64, [u32; 2]), Subsampling>,
    /// Number of pictures traced so far.
    pub(super) traced: u64,
}

impl Pictures {
    /// Returns the camera's picture and what belongs to it. Only the pixels that the screen can show are
    /// traced.
    pub(super) fn get(
        &mut self,
        inputs: Inputs<'_>,
        resolved: ResolvedCamera,
        world: &GoodWorld,
    ) -> GoodPicture {
        let Inputs { session, sizes, watch, .. } = inputs;
        let selection = session.shown_selection().inside(resolved.image());
        let inspection = self.inspection.get((resolved, world.generation, selection), |_| {
            Arc::new(Inspection::new(&resolved, &world.scene, selection))
        });
        // Without a camera view, the picture is still shown on the viewport in the world view.
        let size = sizes.camera.or(sizes.world).unwrap_or([1, 1]);
        let subsampling =
            self.fineness.at_most((resolved, world.generation, size), sizes.subsampling);
        let raster = subsampling.raster(resolved.image(), size);
        let trace = TraceKey { resolved, generation: world.generation, raster };
        let (setup, pixels) = (&session.shown.setup, session.preferences.loupe_pixels);
        // The limit applies to the full picture: a method that is too slow for it is not used during a drag
        // either.
        let all = Subsampling::NONE.raster(resolved.image(), size).len();
        let compared = self.compared(inputs, &trace, world, all);
        // A picture for the viewport in the world view is opaque, since it hides the objects behind it.
        let clear = sizes.purpose.is_clear() && sizes.camera.is_some();
        let (shade, scanned) = (setup.shade, session.live.scanned_pixels);
        let key = PictureKey { trace, shade, palette: world.palette, clear, scanned };
        let (picture, steps, counts) = self.picture(&key, world, watch);
        let position = inspection.image_position.filter(|_| setup.items.shows(Item::Loupe));
        let loupe = position.map(|position| {
            let [rows, columns] = loupe_window(&position, resolved.image(), pixels);
            let trace = TraceKey { raster: Raster::part(rows, columns), ..key.trace };
            let key = (PictureKey { trace, clear: false, ..key }, pixels, setup.count_from_one);
            self.loupe.get(key, |key| Arc::new(loupe(key, world, watch)))
        });
        GoodPicture { loupe, resolved, picture, inspection, subsampling, steps, counts, compared }
    }

    /// Compares the error map's method with the exact one (the ladder), if there is an error map. `pixels` is
    /// the number of pixels of the full picture.
    fn compared(
        &mut self,
        Inputs { session, sizes, watch, .. }: Inputs<'_>,
        trace: &TraceKey,
        world: &GoodWorld,
        pixels: usize,
    ) -> Option<Result<Arc<Compared>, TooMany>> {
        sizes.second.filter(|(kind, _)| *kind == SecondPicture::ErrorMap)?;
        if let Some(too_many) = TooMany::check(world.scene.len(), pixels) {
            return Some(Err(too_many));
        }
        let truth = self.truth.get(trace.clone(), |trace| {
            self.traced += 1;
            trace_truth(&world.scene, trace, watch)
        });
        let key = (session.preferences.compared, trace.clone());
        Some(Ok(self.compared.get(key, |(method, trace)| {
            watched(watch, WorkKind::Trace, || {
                let traced = trace_by(*method, &world.scene, &trace.resolved, &trace.raster);
                let comparison = Comparison::new(&truth, &traced);
                let mut frame = Frame::clone(&truth);
                (frame.t, frame.object) = (traced.t, traced.object);
                let picture = picture_of(&frame, comparison::colors(&comparison));
                Arc::new(Compared { method: *method, comparison, frame, picture })
            })
        })))
    }

    /// Returns the camera's picture.
    fn picture(&mut self, key: &PictureKey, world: &GoodWorld, watch: OnWork<'_>) -> MadePicture {
        let (scene, mode) = (&world.scene, key.shade);
        let colors = (mode, |i: u32| world.colors[i as usize]);
        let (picture, steps, counts) = self.picture.get(key.clone(), |key| {
            let outputs = Outputs { t: mode.needs_t(), object: true, normal: false };
            let mut fresh = None;
            let trace = (key.trace.clone(), outputs.t);
            let spare = self.rough.take_other(&trace).and_then(Arc::into_inner);
            let pixels = self.shown.take(|_| true).map(|picture| picture.pixels);
            let spare = spare.zip(pixels);
            let frame = self.rough.get(trace, |(TraceKey { resolved, raster, .. }, _)| {
                self.traced += 1;
                let memory = (spare, watch);
                let traced = trace_picture(scene, resolved, raster, outputs, colors, memory);
                fresh = Some(traced.1);
                Arc::new(traced.0)
            });
            let mut pixels = fresh.unwrap_or_else(|| repainted(&frame, scene, colors, watch));
            if key.clear {
                let hits = pixels.iter_mut().zip(&frame.object);
                let missed = hits.filter(|(_, hit)| **hit == NO_OBJECT);
                missed.for_each(|(pixel, _)| *pixel = Color32::TRANSPARENT);
            }
            hide_unscanned(&key.trace, key.scanned, &mut pixels);
            (picture_of(&frame, pixels), frame.steps, frame.counts)
        });
        self.shown.keep(&picture);
        (picture, steps, counts)
    }
}

/// Returns the picture with these colours of a frame's pixels.
fn picture_of<T: Depth>(frame: &Frame<T>, pixels: Vec<Color32>) -> Arc<Picture> {
    Arc::new(Picture { raster: frame.raster().clone(), image: frame.camera().image(), pixels })
}

/// Returns the pixels that the loupe (the magnifier) shows.
fn loupe(key: &(PictureKey, u32, bool), world: &GoodWorld, watch: OnWork<'_>) -> Loupe {
    let (PictureKey { trace, shade, scanned, .. }, shown_pixels, count_from_one) = key;
    let frame = trace_truth(&world.scene, trace, watch);
    let colors = (*shade, |i: u32| world.colors[i as usize]);
    let mut pixels = repainted(&frame, &world.scene, colors, watch);
    hide_unscanned(trace, *scanned, &mut pixels);
    let picture = Picture { raster: trace.raster.clone(), image: trace.resolved.image(), pixels };
    Loupe { picture, shown_pixels: *shown_pixels, count_from_one: *count_from_one }
}

/// A kind of work. Each report of finished work attributes the time since the last report to a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkKind {
    /// Planning, tracing and colouring pixels.
    Trace,
    /// Drawing marks over the pictures.
    Overlay,
    /// All other work.
    Rest,
}

/// A callback that receives the kind of work that was just finished.
pub type OnWork<'a> = &'a (dyn Fn(WorkKind) + Sync);

/// A traced frame, and the opaque pixels of its picture.
pub(super) type PaintedFrame = (Frame<f32>, Vec<egui::Color32>);

/// Traces a frame with the given `outputs`. Returns the frame and its picture as opaque pixels. The memory
/// of `spare` is reused for them if it has the same raster and outputs.
pub(super) fn trace_picture(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
    (shade, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    (spare, watch): (Option<PaintedFrame>, OnWork<'_>),
) -> PaintedFrame {
    let paint = Paint { shade, color_of, to_pixel: opaque };
    let fits = |(frame, pixels): &PaintedFrame| {
        let has = |values: usize, asked: bool| values == if asked { raster.len() } else { 0 };
        frame.raster() == raster
            && pixels.len() == raster.len()
            && has(frame.t.len(), outputs.t)
            && has(frame.object.len(), outputs.object)
            && has(frame.normal.len(), outputs.normal)
    };
    watched(watch, WorkKind::Trace, || {
        if let Some((mut frame, mut pixels)) = spare.filter(fits) {
            retrace_painted(&mut frame, scene, camera, &paint, &mut pixels);
            return (frame, pixels);
        }
        // Zeroed pages are allocated only when a thread first writes to them.
        let mut pixels = bytemuck::allocation::zeroed_vec(raster.len());
        (trace_painted(scene, camera, raster, outputs, &paint, &mut pixels), pixels)
    })
}

/// Shades a frame and returns its opaque pixels. The frame must have all the outputs that the shading
/// reads.
pub(super) fn repainted<T: Depth>(
    frame: &Frame<T>,
    scene: &Scene,
    (mode, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    watch: OnWork<'_>,
) -> Vec<egui::Color32> {
    watched(watch, WorkKind::Trace, || shade(frame, scene, mode, color_of, opaque))
}

/// Traces the objects, and `t` with all its digits.
fn trace_truth(scene: &Scene, key: &TraceKey, watch: OnWork<'_>) -> Arc<Frame> {
    let TraceKey { resolved, raster, .. } = key;
    let trace = || Arc::new(trace(scene, resolved, raster, Outputs::default()));
    watched(watch, WorkKind::Trace, trace)
}

/// Calls `run` and reports its time as work of the kind `work`. Time between the last report and the call
/// is reported as [`WorkKind::Rest`].
pub(super) fn watched<R>(watch: OnWork<'_>, work: WorkKind, run: impl FnOnce() -> R) -> R {
    watch(WorkKind::Rest);
    let done = run();
    watch(work);
    done
}

/// Colours of pixels that are not scanned yet: a checkerboard of two greys, which looks unlike any picture
/// of spheres.
const NOT_YET: [Color32; 2] = [Color32::from_gray(92), Color32::from_gray(116)];

/// Number of checkerboard squares along the picture's shorter side.
const SQUARES: usize = 16;

/// Replaces all but the first `scanned` pixels of the image, counted row by row, by a checkerboard.
fn hide_unscanned(
    TraceKey { resolved, raster, .. }: &TraceKey,
    scanned: Option<u64>,
    pixels: &mut [Color32],
) {
    let Some(scanned) = scanned else { return };
    let width = u64::from(resolved.image().width());
    let (rows, columns) = (raster.rows(), raster.columns());
    let side = (rows.len().min(columns.len()) / SQUARES).max(1);
    for (i, (row, pixels)) in rows.iter().zip(pixels.chunks_mut(columns.len())).enumerate() {
        // Number of scanned pixels in this row.
        let done = scanned.saturating_sub(u64::from(*row) * width);
        let from = columns.partition_point(|column| u64::from(*column) < done);
        for (j, pixel) in pixels.iter_mut().enumerate().skip(from) {
            *pixel = NOT_YET[(i / side + j / side) % 2];
        }
    }
}
