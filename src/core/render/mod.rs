//! Tracing a picture: bands of rows in parallel, each object asked of the pixels that it can cover.

pub(crate) mod bvh;
pub(crate) mod frame;
pub(crate) mod outline;
pub(crate) mod plan;
pub(crate) mod polynomial;
pub(crate) mod row_band;
pub(crate) mod rows;
pub(crate) mod shade;

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use fearless_simd::Level;
use glam::DVec3;
use rayon::prelude::*;

use crate::camera::resolved::PosedCamera;
use crate::exact::steps::Steps;
use crate::render::frame::counts::Counts;
use crate::render::frame::depth::Depth;
use crate::render::frame::{Frame, NO_OBJECT, Outputs, Raster};
use crate::render::plan::{Plan, SLICE_ROWS};
use crate::render::row_band::Band;
use crate::render::shade::painter::Painter;
use crate::render::shade::{Paint, Rgb, Shade, paint_frame};
use crate::scene::Scene;
use crate::scene::object_from_origin::{ObjectSeen, plane_normal};

/// What of a frame was just done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The plan: what the rows can see, and what their pixels share.
    Planned,
    /// So many rows: traced, and coloured where the shading allows.
    Rows(usize),
}

/// Traces the first hit of every pixel of the raster, bands of rows in parallel.
///
/// Each pixel's object is what [`Scene::first_hit_of`] says of its
/// [exact ray](PosedCamera::exact_ray), and its `t` is within the same bounds (the two may differ in
/// the last bit, where the exact `t` lies within 2^-40 of an ulp of the middle between two `f64`).
/// The same bits come from any number of threads and any processor. What the rays share is computed
/// once, only what can be seen is looked at, and a pixel in doubt goes up the ladder by itself. A scene
/// without planes runs no plane code.
pub fn trace(scene: &Scene, camera: &PosedCamera, raster: &Raster, outputs: Outputs) -> Frame {
    trace_reporting(scene, camera, raster, outputs, |_| ())
}

/// [`trace`] with `t` in `f64`, or within an ulp in `f32`, which takes a fraction of the time.
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
    let mut frame = empty_frame(camera, raster, outputs);
    let observe = |stage| {
        if let Stage::Rows(rows) = stage {
            done(rows);
        }
    };
    T::fill(&mut frame, level, scene, None, &observe);
    frame
}

/// Traces and colours: writes the picture's pixels, those that [`shade`](crate::shade) makes of the
/// frame, and keeps of the frame only the `outputs`. Each band of rows is coloured as soon as it is
/// traced, while it is still in the cache; [`Shade::T`] alone waits for the nearest `t` of all.
///
/// `observe` is told, from any thread, when a stage is done.
///
/// # Panics
/// Where there is not one pixel for each of the raster's.
pub fn trace_painted<T: Depth, P: Send>(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    pixels: &mut [P],
    observe: impl Fn(Stage) + Sync,
) -> Frame<T> {
    trace_painted_at_level(Level::new(), scene, camera, raster, outputs, paint, pixels, observe)
}

/// [`trace_painted`] with the instructions of a given SIMD level, all of which give the same bits.
#[expect(clippy::too_many_arguments, reason = "those of trace_painted, and the level")]
pub fn trace_painted_at_level<T: Depth, P: Send>(
    level: Level,
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    pixels: &mut [P],
    observe: impl Fn(Stage) + Sync,
) -> Frame<T> {
    assert_eq!(pixels.len(), raster.len(), "a pixel for each of the raster's");
    if paint.shade != Shade::T {
        let mut frame = empty_frame(camera, raster, outputs);
        let painter = Painter::new(level, paint, scene, camera, raster, f64::INFINITY);
        let slice = SLICE_ROWS * raster.columns().len().max(1);
        let slices: Vec<Mutex<&mut [P]>> = pixels.chunks_mut(slice).map(Mutex::new).collect();
        let finish = |rows: Range<usize>, t: &[T], object: &[u32]| {
            // Bands are whole slices: no two want the same one, and no lock is waited for.
            let slices = slices[rows.start / SLICE_ROWS..].iter();
            let hits = t.chunks(slice).zip(object.chunks(slice));
            for ((start, (t, object)), pixels) in rows.step_by(SLICE_ROWS).zip(hits).zip(slices) {
                let mut pixels = pixels.lock().unwrap_or_else(PoisonError::into_inner);
                painter.rows(start..start + SLICE_ROWS, t, object, &mut pixels);
            }
        };
        T::fill(&mut frame, level, scene, Some(&finish), &observe);
        return frame;
    }
    let mut frame = empty_frame(camera, raster, Outputs { t: true, object: true, ..outputs });
    T::fill(&mut frame, level, scene, None, &observe);
    paint_frame(level, &frame, scene, paint, pixels);
    if !outputs.t {
        frame.t = Vec::new();
    }
    if !outputs.object {
        frame.object = Vec::new();
    }
    frame
}

/// Traces another camera or scene into a frame of the same raster: what [`trace_as`] gives, without
/// new memory.
pub fn retrace<T: Depth>(frame: &mut Frame<T>, level: Level, scene: &Scene, camera: &PosedCamera) {
    frame.camera = *camera;
    T::fill(frame, level, scene, None, &|_| ());
}

/// A frame with room for what is asked for.
fn empty_frame<T: Depth>(camera: &PosedCamera, raster: &Raster, outputs: Outputs) -> Frame<T> {
    // Zeroed memory costs nothing until a band, in its own thread, fills it.
    let pixels = |asked: bool| if asked { raster.len() } else { 0 };
    Frame {
        camera: *camera,
        raster: raster.clone(),
        t: vec![T::ZERO; pixels(outputs.t)],
        object: vec![0; pixels(outputs.object)],
        normal: vec![DVec3::ZERO; pixels(outputs.normal)],
        steps: Steps::default(),
        counts: Counts::default(),
    }
}

/// What is done with the rows of a band when they are traced: rows, `t`, objects.
pub(crate) type Finish<'a, T> = &'a (dyn Fn(Range<usize>, &[T], &[u32]) + Sync);

/// A band's part of each buffer; empty where that was not asked for.
struct Part<'a, T> {
    t: &'a mut [T],
    object: &'a mut [u32],
    normal: &'a mut [DVec3],
}

/// The parts of a buffer, and empty ones where there is none.
fn parts<T>(buffer: &mut [T], size: usize) -> impl Iterator<Item = &mut [T]> {
    buffer.chunks_mut(size).chain(std::iter::repeat_with(|| -> &mut [T] { &mut [] }))
}

/// A buffer's part; where that was not asked for, as much of the thread's own.
fn or_own<'a, T: Copy>(part: &'a mut [T], own: &'a mut Vec<T>, len: usize, zero: T) -> &'a mut [T] {
    if part.len() == len {
        return part;
    }
    own.resize(len.max(own.len()), zero);
    &mut own[..len]
}

/// Traces the frame's camera and raster into those of its buffers that have room, band by band, each
/// of which is finished while it is in the cache.
pub(crate) fn fill<T: Depth>(
    frame: &mut Frame<T>,
    level: Level,
    scene: &Scene,
    finish: Option<Finish<'_, T>>,
    observe: &(dyn Fn(Stage) + Sync),
) {
    let Frame { camera, raster, t, object, normal, steps, counts } = frame;
    if raster.is_empty() {
        return;
    }
    let (width, rows) = (raster.columns().len(), raster.rows().len());
    let plan = Plan::new::<T>(level, scene, camera, raster);
    observe(Stage::Planned);
    *counts = plan.counts;
    let is_quick = plan.is_quick && finish.is_none() && normal.is_empty();
    let band = plan.band_rows * width;
    let parts: Vec<Part<T>> = (parts(t, band).zip(parts(object, band)).zip(parts(normal, band)))
        .map(|((t, object), normal)| Part { t, object, normal })
        .take(rows.div_ceil(plan.band_rows))
        .collect();
    let trace_band = |own: &mut (Vec<T>, Vec<u32>), (index, part): (usize, Part<T>)| {
        let first = index * plan.band_rows;
        let rows = first..rows.min(first + plan.band_rows);
        let t = or_own(part.t, &mut own.0, rows.len() * width, T::ZERO);
        let object = or_own(part.object, &mut own.1, rows.len() * width, 0);
        let traced = Band::new(&plan, rows.clone(), t, object).traced();
        let of_rows = part.normal.chunks_mut(width).zip(object.chunks(width));
        for (row, (normals, object)) in rows.clone().zip(of_rows) {
            fill_normals(&plan, row, object, normals);
        }
        if let Some(finish) = finish {
            finish(rows.clone(), t, object);
        }
        observe(Stage::Rows(rows.len()));
        traced
    };
    let own = || (Vec::new(), Vec::new());
    let of_bands;
    (*steps, of_bands) = if is_quick {
        let mut own = own();
        let bands = parts.into_iter().enumerate().map(|band| trace_band(&mut own, band));
        bands.fold(Default::default(), sums)
    } else {
        let bands = parts.into_par_iter().enumerate().map_init(own, trace_band);
        bands.reduce(Default::default, sums)
    };
    *counts += of_bands;
}

fn sums(a: (Steps, Counts), b: (Steps, Counts)) -> (Steps, Counts) {
    (a.0 + b.0, a.1 + b.1)
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
