//! Tracing a picture: bands of rows in parallel, each object asked of the pixels that it can cover.

use std::ops::Range;

use fearless_simd::Level;
use glam::DVec3;
use rayon::prelude::*;

use crate::band::Band;
use crate::bounds::{Bounds, PixelBounds};
use crate::frame::{Depth, Frame, NO_OBJECT, Outputs, Raster};
use crate::frame_rays::FrameRays;
use crate::posed::PosedCamera;
use crate::scene::{Object, Scene};
use crate::seen::{ObjectSeen, plane_normal};
use crate::sphere::Sphere;
use crate::steps::Steps;

/// Rows that one thread traces at a time.
const BAND_ROWS: usize = 32;

/// Traces the first hit of every pixel of the raster, bands of rows in parallel.
///
/// Each pixel is what [`Scene::first_hit_of`] says of its [exact ray](PosedCamera::exact_ray), bit
/// for bit in object and `t`, whatever the number of threads and the processor: per object, only the
/// pixels inside its bounds are asked, what the rays share is computed once, and a pixel in doubt
/// goes up the ladder by itself. A scene without planes runs no plane code.
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
    let Frame { camera, raster, t, object, normal, steps } = frame;
    if raster.is_empty() {
        return;
    }
    let width = raster.columns().len();
    let plan = Plan::new(level, scene, camera, raster);
    let band = BAND_ROWS * width;
    *steps = t
        .par_chunks_mut(band)
        .zip(object.par_chunks_mut(band))
        .enumerate()
        .map(|(index, (t, object))| {
            let first = index * BAND_ROWS;
            let rows = t.len() / width;
            let steps = plan.trace_band(first..first + rows, t, object);
            done(rows);
            steps
        })
        .reduce(Steps::default, |a, b| a + b);
    normal.par_chunks_mut(width).enumerate().for_each(|(row, normals)| {
        let pixels = row * width..(row + 1) * width;
        plan.fill_normals(row, &object[pixels], normals);
    });
}

/// A sphere and the pixels of the raster (not of the image) that it can cover.
struct Visible {
    index: u32,
    rows: Range<u16>,
    columns: Range<u16>,
}

/// What all bands of a frame share.
struct Plan<'a> {
    level: Level,
    scene: &'a Scene,
    rays: FrameRays<'a>,
    /// For each run of spheres, for each band, those that it can see; in the order of objects.
    visible: Vec<Vec<Vec<Visible>>>,
    planes: Vec<ObjectSeen>,
}

/// Spheres whose bounds one thread finds at a time.
const SPHERES_PER_RUN: usize = 8192;

/// For each band, the spheres of a run that it can see; `first` is the run's first index.
fn visible_by_band(
    spheres: &[Sphere],
    first: usize,
    bounds: &Bounds,
    raster: &Raster,
) -> Vec<Vec<Visible>> {
    let part_of = |cells: &Range<u32>, of: &[u32]| {
        let place = |cell: u32| of.partition_point(|x| *x < cell) as u16;
        place(cells.start)..place(cells.end)
    };
    let mut bands = Vec::new();
    bands.resize_with(raster.rows().len().div_ceil(BAND_ROWS), Vec::new);
    for (index, sphere) in (first..).zip(spheres) {
        let Some(PixelBounds { rows, columns }) = bounds.of(sphere) else { continue };
        let (rows, columns) = (part_of(&rows, raster.rows()), part_of(&columns, raster.columns()));
        if rows.is_empty() || columns.is_empty() {
            continue;
        }
        let (rows, band) = (usize::from(rows.start)..usize::from(rows.end), BAND_ROWS);
        for seen_in in &mut bands[rows.start / band..rows.end.div_ceil(band)] {
            let rows = rows.start as u16..rows.end as u16;
            seen_in.push(Visible { index: index as u32, rows, columns: columns.clone() });
        }
    }
    bands
}

impl<'a> Plan<'a> {
    fn new(level: Level, scene: &'a Scene, camera: &'a PosedCamera, raster: &'a Raster) -> Self {
        let bounds = Bounds::new(camera);
        let visible = scene
            .spheres()
            .par_chunks(SPHERES_PER_RUN)
            .enumerate()
            .map(|(run, spheres)| visible_by_band(spheres, run * SPHERES_PER_RUN, &bounds, raster))
            .collect();
        let seen = |plane| ObjectSeen::new(&Object::Plane(plane), camera.eye());
        Plan {
            level,
            scene,
            rays: FrameRays::new(camera, raster),
            visible,
            planes: scene.planes().iter().copied().map(seen).collect(),
        }
    }

    fn trace_band<T: Depth>(&self, rows: Range<usize>, t: &mut [T], object: &mut [u32]) -> Steps {
        t.fill(T::NONE);
        object.fill(NO_OBJECT);
        let mut band =
            Band::new(self.level, self.scene, &self.rays, &self.planes, rows.clone(), t, object);
        for run in &self.visible {
            for Visible { index, rows: own, columns } in &run[rows.start / BAND_ROWS] {
                let own =
                    usize::from(own.start).max(rows.start)..usize::from(own.end).min(rows.end);
                band.add_sphere(*index, own, usize::from(columns.start)..usize::from(columns.end));
            }
        }
        for plane in 0..self.planes.len() {
            band.add_plane(plane);
        }
        band.steps
    }

    /// Normals of one row, each from its own exact ray.
    fn fill_normals(&self, row: usize, object: &[u32], normals: &mut [DVec3]) {
        let eye = self.rays.camera().eye();
        let mut known: Option<(u32, ObjectSeen)> = None;
        for (column, normal) in normals.iter_mut().enumerate() {
            if object[column] == NO_OBJECT {
                continue;
            }
            let seen = match known.take() {
                Some((index, seen)) if index == object[column] => seen,
                _ => match self.scene.object(object[column]) {
                    Some(object) => ObjectSeen::new(&object, eye),
                    None => continue,
                },
            };
            *normal = match &seen {
                ObjectSeen::Plane(seen) => plane_normal(seen.plane().normal),
                ObjectSeen::Sphere(sphere) => {
                    let ray = self.rays.camera().exact_ray(self.rays.pixel(row, column));
                    let end = seen.first_end(&ray, &mut Steps::default());
                    end.map_or(DVec3::ZERO, |end| sphere.normal(&ray, end))
                }
            };
            known = Some((object[column], seen));
        }
    }
}
