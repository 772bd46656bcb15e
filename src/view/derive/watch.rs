//! What deriving spends its time on, told to those who hold a clock; this side of it has none.

use std::sync::Arc;

use pinhole_core::{
    Depth, Frame, Outputs, Paint, PosedCamera, Raster, Rgb, Scene, Shade, shade, trace,
    trace_painted,
};

use super::opaque;

/// What the time since the last thing told was spent on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Planning, tracing and colouring pixels.
    Trace,
    /// Drawing over the pictures.
    Overlay,
    /// Anything else.
    Rest,
}

/// Who hears of work that was just done.
pub type Watch<'a> = &'a (dyn Fn(Work) + Sync);

/// Opaque pixels of what the camera sees, and of the frame behind them the `outputs`.
pub(super) fn picture(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    (shade, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    watch: Watch<'_>,
) -> (Frame<f32>, Vec<egui::Color32>) {
    watch(Work::Rest);
    // Zeroed memory costs nothing until a thread fills its part.
    let mut pixels = bytemuck::allocation::zeroed_vec(raster.len());
    let paint = Paint { shade, color_of, to_pixel: opaque };
    let frame = trace_painted(scene, camera, raster, outputs, &paint, &mut pixels, |_| ());
    watch(Work::Trace);
    (frame, pixels)
}

/// Opaque pixels of a frame of the scene, which has all that the shading reads.
pub(super) fn repainted<T: Depth>(
    frame: &Frame<T>,
    scene: &Scene,
    (mode, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    watch: Watch<'_>,
) -> Vec<egui::Color32> {
    watched(watch, Work::Trace, || shade(frame, scene, mode, color_of, opaque))
}

/// `t` with all its digits, and objects.
pub(super) fn truth(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    watch: Watch<'_>,
) -> Arc<Frame> {
    watch(Work::Rest);
    let frame = trace(scene, camera, raster, Outputs::default());
    watch(Work::Trace);
    Arc::new(frame)
}

/// Does some of the work and tells of it.
pub(super) fn watched<R>(watch: Watch<'_>, work: Work, run: impl FnOnce() -> R) -> R {
    watch(Work::Rest);
    let done = run();
    watch(work);
    done
}
