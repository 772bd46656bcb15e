//! Converts rows of hits to rows of pixels.

use std::ops::Range;

use fearless_simd::Level;

use crate::camera::resolved::ResolvedCamera;
use crate::render::frame::{Depth, NO_OBJECT, Raster};
use crate::render::shade::paint::{BACKGROUND, Paint, Rgb, Shade};
use crate::render::shade::shade_rows::{HitShader, PADDING, RowRays, Run, ToneRow};
use crate::scene::Scene;

/// The values that all pixels of a picture share.
pub(crate) struct Painter<'a, C, F> {
    level: Level,
    paint: &'a Paint<C, F>,
    shader: HitShader<'a>,
    camera: &'a ResolvedCamera,
    raster: &'a Raster,
    /// The column's term of the view ray's direction, for each column (a structure of arrays), padded to
    /// whole SIMD vectors.
    columns: [Vec<f64>; 3],
    is_plain: bool,
}

impl<'a, C, F> Painter<'a, C, F>
where
    C: Fn(u32) -> Rgb + Sync,
{
    /// Makes a painter; `nearest` is the `t` that [`Shade::T`] shows as white.
    pub(crate) fn new(
        level: Level,
        paint: &'a Paint<C, F>,
        scene: &'a Scene,
        camera: &'a ResolvedCamera,
        raster: &'a Raster,
        nearest: f64,
    ) -> Self {
        let mut columns: [Vec<f64>; 3] = Default::default();
        for column in raster.columns() {
            let part = camera.column_term(camera.u_of_column(*column));
            for (column, x) in columns.iter_mut().zip(part.to_array()) {
                column.push(x);
            }
        }
        for column in &mut columns {
            column.resize(column.len() + PADDING, 0.0);
        }
        let shader = HitShader::new(scene, paint.shade, nearest);
        let is_plain = has_plain_rays(camera);
        Painter { level, paint, shader, camera, raster, columns, is_plain }
    }

    /// Paints some rows of the raster, given their hits. `t` is used only by shadings that [need
    /// it](Shade::needs_t).
    pub(crate) fn rows<T: Depth, P>(
        &self,
        rows: Range<usize>,
        t: &[T],
        object: &[u32],
        pixels: &mut [P],
    ) where
        F: Fn(Rgb) -> P + Sync,
    {
        let width = self.raster.columns().len();
        let padded = if self.paint.shade == Shade::Object { 0 } else { width + PADDING };
        let mut tones: ToneRow = std::array::from_fn(|_| vec![0; padded]);
        let (mut runs, mut wide) = (Vec::new(), Vec::new());
        let of_rows = object.chunks_exact(width).zip(pixels.chunks_exact_mut(width));
        for (index, (row, (object, pixels))) in rows.zip(of_rows).enumerate() {
            self.find_runs(object, &mut runs);
            if self.paint.shade.needs_t() {
                wide.clear();
                wide.extend(t[index * width..][..width].iter().map(|t| t.widened()));
                wide.resize(padded, 1.0);
            }
            let rays = RowRays {
                eye: self.camera.eye(),
                columns: self.columns.each_ref().map(|part| &part[..]),
                row: self.camera.row_term(self.camera.v_of_row(self.raster.rows()[row])),
                is_plain: self.is_plain,
            };
            self.shader.row(self.level, &rays, &runs, &wide, &mut tones);
            self.write(&runs, &tones, pixels);
        }
    }

    /// Finds the runs of a row (neighbouring pixels that show the same object), from left to right.
    fn find_runs(&self, object: &[u32], runs: &mut Vec<Run>) {
        runs.clear();
        let mut start = 0;
        while let Some(&found) = object.get(start) {
            let end = start + run_length(&object[start..], found);
            if found != NO_OBJECT {
                let color = (self.paint.color_of)(found);
                runs.push(Run { start, end, object: found, color });
            }
            start = end;
        }
    }

    fn write<P>(&self, runs: &[Run], tones: &ToneRow, pixels: &mut [P])
    where
        F: Fn(Rgb) -> P + Sync,
    {
        let to_pixel = &self.paint.to_pixel;
        let fill = |pixels: &mut [P], color| pixels.iter_mut().for_each(|p| *p = to_pixel(color));
        let mut done = 0;
        for run in runs {
            fill(&mut pixels[done..run.start], BACKGROUND);
            done = run.end;
            let pixels = &mut pixels[run.start..run.end];
            if self.paint.shade == Shade::Object {
                fill(pixels, run.color);
                continue;
            }
            let [r, g, b] = tones.each_ref().map(|channel| channel[run.start..run.end].iter());
            for (pixel, ((r, g), b)) in pixels.iter_mut().zip(r.zip(g).zip(b)) {
                *pixel = to_pixel(self.shader.color_of([*r, *g, *b]));
            }
        }
        fill(&mut pixels[done..], BACKGROUND);
    }
}

/// Returns the number of pixels at the start of a row that show the object `same`.
fn run_length(object: &[u32], same: u32) -> usize {
    // Without a branch, comparing a chunk takes a few vector instructions.
    let is_same = |chunk: &&[u32]| chunk.iter().fold(true, |all, o| all & (*o == same));
    let whole = 32 * object.chunks_exact(32).take_while(is_same).count();
    whole + object[whole..].iter().take_while(|o| **o == same).count()
}

/// Returns whether the squared lengths of all directions are far from 0 and infinity: no direction is
/// shorter than the viewport's distance, and none is longer than the sum of its width, height and
/// distance.
fn has_plain_rays(camera: &ResolvedCamera) -> bool {
    let viewport = camera.viewport();
    let longest = viewport.width + viewport.height + viewport.distance;
    viewport.distance > 1e-59 && longest < 1e59
}
