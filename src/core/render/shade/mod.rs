//! Colours of hits.

pub(crate) mod normals;
pub(crate) mod paint;
pub(crate) mod painter;
pub(crate) mod shade_rows;

use fearless_simd::Level;
use rayon::prelude::*;

use crate::render::frame::{Depth, Frame};
use crate::render::shade::paint::{BACKGROUND, Paint, Rgb, Shade, Srgb};
use crate::render::shade::painter::Painter;
use crate::render::shade::shade_rows::{AMBIENT, FROM_EYE};
use crate::scene::Scene;

/// Number of rows that one thread shades at a time.
const ROWS: usize = 16;

/// Returns the colours of a frame, row by row, each converted to a pixel by `to_pixel`. Rows are shaded
/// in parallel. [`trace_painted`](crate::trace_painted) computes the same colours while it traces.
///
/// `color_of` returns each object's own colour. The frame must have been traced from the scene and must
/// have `t` and objects.
pub fn shade<T: Depth, P: Clone + Send + Sync>(
    frame: &Frame<T>,
    scene: &Scene,
    shade: Shade,
    color_of: impl Fn(u32) -> Rgb + Sync,
    to_pixel: impl Fn(Rgb) -> P + Sync,
) -> Vec<P> {
    shade_at_level(Level::new(), frame, scene, &Paint { shade, color_of, to_pixel })
}

/// Shades like [`shade`], with the instructions of a given SIMD level. All levels give the same bits.
pub fn shade_at_level<T: Depth, P: Clone + Send + Sync>(
    level: Level,
    frame: &Frame<T>,
    scene: &Scene,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
) -> Vec<P> {
    let mut pixels = vec![(paint.to_pixel)(BACKGROUND); frame.raster().len()];
    paint_frame(level, frame, scene, paint, &mut pixels);
    pixels
}

/// Computes the pixels of a traced frame, which must have objects and, if the shading needs it, `t`.
pub(crate) fn paint_frame<T: Depth, P: Send>(
    level: Level,
    frame: &Frame<T>,
    scene: &Scene,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    pixels: &mut [P],
) {
    let (camera, raster) = (frame.camera(), frame.raster());
    if raster.is_empty() {
        return;
    }
    let nearest = match paint.shade {
        Shade::T => {
            let least = |t: &[T]| t.iter().map(|t| t.widened()).fold(f64::INFINITY, f64::min);
            frame.t.par_chunks(1 << 16).map(least).reduce(|| f64::INFINITY, f64::min)
        }
        _ => f64::INFINITY,
    };
    let painter = Painter::new(level, paint, scene, camera, raster, nearest);
    let width = raster.columns().len();
    pixels.par_chunks_mut(ROWS * width).enumerate().for_each(|(index, pixels)| {
        let part = index * ROWS * width..index * ROWS * width + pixels.len();
        let t = frame.t.get(part.clone()).unwrap_or_default();
        let rows = index * ROWS..index * ROWS + pixels.len() / width;
        painter.rows(rows, t, &frame.object[part], pixels);
    });
}

/// Returns a colour lit from the eye, as in [`Shade::Lambert`]; `cosine` is `|n.d| / |d|`, with the unit
/// normal n and the ray's direction d.
pub fn lambert(color: Rgb, cosine: f64) -> Rgb {
    let (light, srgb) = ((AMBIENT + FROM_EYE * cosine) as f32, Srgb::get());
    color.map(|byte| srgb.byte_of((light * srgb.linear_of(byte) + 0.5) as u32))
}
