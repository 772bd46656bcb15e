//! Reports on the work of deriving. The caller measures the time; there is no clock here.

use std::sync::Arc;

use pinhole_core::{
    Depth, Frame, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, Shade, retrace_painted,
    shade, trace, trace_painted,
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

/// A picture's frame and its opaque pixels.
pub(super) type Traced = (Frame<f32>, Vec<egui::Color32>);

/// Traces a frame with the `outputs`, and returns it with the opaque pixels of the picture; both in the
/// memory of a `spare` one, if that is as large.
pub(super) fn picture(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
    (shade, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    (spare, watch): (Option<Traced>, Watch<'_>),
) -> Traced {
    watch(Work::Rest);
    let paint = Paint { shade, color_of, to_pixel: opaque };
    let fits = |(frame, pixels): &Traced| {
        let has = |values: usize, asked: bool| values == if asked { raster.len() } else { 0 };
        frame.raster() == raster
            && pixels.len() == raster.len()
            && has(frame.t.len(), outputs.t)
            && has(frame.object.len(), outputs.object)
            && has(frame.normal.len(), outputs.normal)
    };
    let traced = if let Some((mut frame, mut pixels)) = spare.filter(fits) {
        retrace_painted(&mut frame, scene, camera, &paint, &mut pixels);
        (frame, pixels)
    } else {
        // Zeroed memory costs nothing until a thread fills its part.
        let mut pixels = bytemuck::allocation::zeroed_vec(raster.len());
        (trace_painted(scene, camera, raster, outputs, &paint, &mut pixels), pixels)
    };
    watch(Work::Trace);
    traced
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
