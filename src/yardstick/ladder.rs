//! The contestant that all this is about: the one place that knows how `pinhole-core` is asked for a
//! frame.

use pinhole_core::{Frame, Level, Outputs, Raster, ResolvedCamera, Scene, retrace, trace_at_level};

/// A frame to trace into, traced once.
pub(crate) fn first_frame(level: Level, scene: &Scene, camera: &ResolvedCamera) -> Frame<f32> {
    let raster = Raster::full(camera.image());
    trace_at_level(level, scene, camera, &raster, Outputs::default(), |_| ())
}

/// Traces another camera into a kept frame.
pub(crate) fn trace(frame: &mut Frame<f32>, level: Level, scene: &Scene, camera: &ResolvedCamera) {
    retrace(frame, level, scene, camera);
}
