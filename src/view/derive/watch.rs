//! Reports on the work of deriving. The caller measures the time; there is no clock here.

use std::sync::Arc;

use pinhole_core::{
    Depth, Frame, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, Shade, shade, trace,
    trace_painted,
};

use super::opaque;

/// The kind of work done since the last report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Planning, tracing and colouring pixels.
    Trace,
    /// Drawing over the pictures.
    Overlay,
    /// All other work.
    Rest,
}

/// A callback for work that was just done.
pub type Watch<'a> = &'a (dyn Fn(Work) + Sync);

/// Traces a frame with the `outputs`, and returns it with the opaque pixels of the picture.
pub(super) fn picture(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
    (shade, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    watch: Watch<'_>,
) -> (Frame<f32>, Vec<egui::Color32>) {
    watch(Work::Rest);
    // Zeroed memory costs nothing until a thread fills its part.
    let mut pixels = bytemuck::allocation::zeroed_vec(raster.len());
    let paint = Paint { shade, color_of, to_pixel: opaque };
    let frame = trace_painted(scene, camera, raster, outputs, &paint, &mut pixels);
    watch(Work::Trace);
    (frame, pixels)
}

/// Returns opaque pixels of a frame, which must have all outputs that the shading reads.
pub(super) fn repainted<T: Depth>(
    frame: &Frame<T>,
    scene: &Scene,
    (mode, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    watch: Watch<'_>,
) -> Vec<egui::Color32> {
    watched(watch, Work::Trace, || shade(frame, scene, mode, color_of, opaque))
}

/// Traces `t` with all its digits, and the objects.
pub(super) fn truth(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    watch: Watch<'_>,
) -> Arc<Frame> {
    watch(Work::Rest);
    let frame = trace(scene, camera, raster, Outputs::default());
    watch(Work::Trace);
    Arc::new(frame)
}

/// Does some work and reports it.
pub(super) fn watched<R>(watch: Watch<'_>, work: Work, run: impl FnOnce() -> R) -> R {
    watch(Work::Rest);
    let done = run();
    watch(work);
    done
}
