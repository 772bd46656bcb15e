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

/// Returns the frame's smallest `t`, which [`Shade::T`] shows as white; infinite if nothing is hit.
pub fn nearest_t<T: Depth>(frame: &Frame<T>) -> f64 {
    let least = |t: &[T]| t.iter().map(|t| t.widened()).fold(f64::INFINITY, f64::min);
    frame.t.par_chunks(1 << 16).map(least).reduce(|| f64::INFINITY, f64::min)
}

/// Shades like [`shade`], with the instructions of a given SIMD level. All levels give the same bits.
pub fn shade_at_level<T: Depth, P: Clone + Send + Sync>(
    level: Level,
    frame: &Frame<T>,
    scene: &Scene,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
) -> Vec<P> {
    let mut pixels = vec![(paint.to_pixel)(BACKGROUND); frame.raster().len()];
    let nearest = if paint.shade == Shade::T { nearest_t(frame) } else { f64::INFINITY };
    shade_part(level, frame, scene, paint, nearest, &mut pixels);
    pixels
}

/// Shades like [`shade_at_level`] a part of a picture, whose smallest `t` is `nearest`; only [`Shade::T`]
/// uses it.
///
/// # Panics
/// Panics unless `pixels` has one element for each pixel of the frame.
pub fn shade_part<T: Depth, P: Send>(
    level: Level,
    frame: &Frame<T>,
    scene: &Scene,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    nearest: f64,
    pixels: &mut [P],
) {
    let (camera, raster) = (frame.camera(), frame.raster());
    if raster.is_empty() {
        return;
    }
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
