//! Tracing a picture: bands of rows in parallel, each object asked of the pixels that it can cover.

use fearless_simd::Level;
use glam::DVec3;
use rayon::prelude::*;

use crate::band::Band;
use crate::counts::Counts;
use crate::depth::Depth;
use crate::frame::{Frame, NO_OBJECT, Outputs, Raster};
use crate::plan::Plan;
use crate::posed::PosedCamera;
use crate::scene::Scene;
use crate::seen::{ObjectSeen, plane_normal};
use crate::steps::Steps;

/// Traces the first hit of every pixel of the raster, bands of rows in parallel.
///
/// Each pixel's object is what [`Scene::first_hit_of`] says of its
/// [exact ray](PosedCamera::exact_ray), and its `t` is within the same bounds (the two may differ in
/// the last bit, where the exact `t` lies within 2^-40 of an ulp of the middle between two `f64`).
/// The same bits come from any number of threads and any processor. Per object, only the pixels
/// inside its bounds are asked, what the rays share is computed once, and a pixel in doubt goes up the
/// ladder by itself. A scene without planes runs no plane code.
pub fn trace(scene: &Scene, camera: &PosedCamera, raster: &Raster, outputs: Outputs) -> Frame {
    trace_reporting(scene, camera, raster, outputs, |_| ())
}

/// [`trace`] with `t` in `f32` or `f64`.
pub fn trace_as<T: Depth>(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
) -> Frame<T> {
    trace_reporting(scene, camera, raster, outputs, |_| ())
}

/// [`trace_as`] for those who want to tell how far it is: `done` is called, from any thread, with
/// the number of rows that were just finished.
pub fn trace_reporting<T: Depth>(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    done: impl Fn(usize) + Sync,
) -> Frame<T> {
    trace_at_level(Level::new(), scene, camera, raster, outputs, done)
}

/// [`trace_reporting`] with the instructions of a given SIMD level, all of which give the same bits.
pub fn trace_at_level<T: Depth>(
    level: Level,
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    done: impl Fn(usize) + Sync,
) -> Frame<T> {
    let mut frame = Frame {
        camera: *camera,
        raster: raster.clone(),
        // Zeroed memory costs nothing until a band, in its own thread, fills it.
        t: vec![T::ZERO; raster.len()],
        object: vec![0; raster.len()],
        normal: if outputs.normal { vec![DVec3::ZERO; raster.len()] } else { Vec::new() },
        steps: Steps::default(),
        counts: Counts::default(),
    };
    fill(&mut frame, level, scene, done);
    frame
}

/// Traces another camera or scene into a frame of the same raster: what [`trace_as`] gives, without
/// new memory.
pub fn retrace<T: Depth>(frame: &mut Frame<T>, level: Level, scene: &Scene, camera: &PosedCamera) {
    frame.camera = *camera;
    fill(frame, level, scene, |_| ());
}

/// Traces the frame's camera and raster into its buffers.
fn fill<T: Depth>(frame: &mut Frame<T>, level: Level, scene: &Scene, done: impl Fn(usize) + Sync) {
    let Frame { camera, raster, t, object, normal, steps, counts } = frame;
    if raster.is_empty() {
        return;
    }
    let width = raster.columns().len();
    let plan = Plan::new::<T>(level, scene, camera, raster);
    *counts = plan.counts;
    let band = plan.band_rows * width;
    let of_bands;
    (*steps, of_bands) = t
        .par_chunks_mut(band)
        .zip(object.par_chunks_mut(band))
        .enumerate()
        .map(|(index, (t, object))| {
            let first = index * plan.band_rows;
            let rows = t.len() / width;
            let traced = Band::new(&plan, first..first + rows, t, object).traced();
            done(rows);
            traced
        })
        .reduce(Default::default, |a, b| (a.0 + b.0, a.1 + b.1));
    *counts += of_bands;
    normal.par_chunks_mut(width).enumerate().for_each(|(row, normals)| {
        let pixels = row * width..(row + 1) * width;
        fill_normals(&plan, row, &object[pixels], normals);
    });
}

/// Normals of one row, each from its own exact ray.
fn fill_normals(plan: &Plan, row: usize, object: &[u32], normals: &mut [DVec3]) {
    let eye = plan.rays.camera().eye();
    let mut known: Option<(u32, ObjectSeen)> = None;
    for (column, normal) in normals.iter_mut().enumerate() {
        if object[column] == NO_OBJECT {
            continue;
        }
        let seen = match known.take() {
            Some((index, seen)) if index == object[column] => seen,
            _ => match plan.scene.object(object[column]) {
                Some(object) => ObjectSeen::new(&object, eye),
                None => continue,
            },
        };
        *normal = match &seen {
            ObjectSeen::Plane(seen) => plane_normal(seen.plane().normal),
            ObjectSeen::Sphere(sphere) => {
                let ray = plan.rays.camera().exact_ray(plan.rays.pixel(row, column));
                let end = seen.first_end(&ray, &mut Steps::default());
                end.map_or(DVec3::ZERO, |end| sphere.normal(&ray, end))
            }
        };
        known = Some((object[column], seen));
    }
}
