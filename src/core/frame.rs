//! A picture: the first hit of every pixel's view ray.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use crate::bounds::{Bounds, PixelBounds};
use crate::image::{ImageSize, Pixel};
use crate::plane::PlaneSeen;
use crate::posed::PosedCamera;
use crate::ray::Ray;
use crate::scene::{Normals, Scene};
use crate::sphere::{Kernel, Sphere, SphereSeen};

/// [`Frame::object`] where the ray hits nothing.
pub const NO_OBJECT: u32 = u32::MAX;

/// Which rows and columns of the image to trace, ascending. A screen smaller than the image shows
/// only some of its pixels; the others need not be traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    rows: Vec<u32>,
    columns: Vec<u32>,
}

/// What to compute besides `t` and object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// The outward unit normal of every hit.
    pub normal: bool,
}

/// The traced pixels, row by row, with the camera and raster that they belong to.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    camera: PosedCamera,
    raster: Raster,
    /// `t` of the first hit; infinite where there is none.
    pub t: Vec<f64>,
    /// Index of the object hit, or [`NO_OBJECT`].
    pub object: Vec<u32>,
    /// Outward unit normals, zero where nothing is hit; empty unless asked for.
    pub normal: Vec<DVec3>,
}

/// One traced pixel of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramePixel {
    /// Which pixel of the image it is.
    pub pixel: Pixel,
    /// `t` of the first hit; infinite where there is none.
    pub t: f64,
    /// The object hit.
    pub object: Option<u32>,
}

impl Raster {
    /// Every pixel of the image.
    pub fn full(image: ImageSize) -> Raster {
        Raster { rows: (0..image.height()).collect(), columns: (0..image.width()).collect() }
    }

    /// The pixels that a nearest-neighbour display of `rows` x `columns` dots shows of the image;
    /// at most every pixel once.
    pub fn shown_on(image: ImageSize, columns: u32, rows: u32) -> Raster {
        Raster {
            rows: shown(image.height(), rows.max(1)),
            columns: shown(image.width(), columns.max(1)),
        }
    }

    /// The rows traced, ascending.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// The columns traced, ascending.
    pub fn columns(&self) -> &[u32] {
        &self.columns
    }

    /// How many pixels are traced.
    pub fn len(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Whether no pixel is traced.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The cells of `count` at the centres of `dots` dots across them.
fn shown(count: u32, dots: u32) -> Vec<u32> {
    if dots >= count {
        return (0..count).collect();
    }
    let (count, dots) = (u64::from(count), u64::from(dots));
    (0..dots).map(|k| ((2 * k + 1) * count / (2 * dots)) as u32).collect()
}

impl Frame {
    /// The camera that the frame was traced for.
    pub fn camera(&self) -> &PosedCamera {
        &self.camera
    }

    /// The rows and columns that were traced.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// The traced pixel in the raster's `row`th row and `column`th column.
    ///
    /// # Panics
    /// Outside the raster.
    pub fn at(&self, row: usize, column: usize) -> FramePixel {
        let index = row * self.raster.columns.len() + column;
        let object = self.object[index];
        FramePixel {
            pixel: Pixel { row: self.raster.rows[row], column: self.raster.columns[column] },
            t: self.t[index],
            object: (object != NO_OBJECT).then_some(object),
        }
    }
}

/// Rows that one thread traces at a time.
const BAND_ROWS: usize = 32;

/// Traces the first hit of every pixel of the raster, bands of rows in parallel.
///
/// Each pixel is what [`Scene::first_hit`] says of its view ray, bit for bit and whatever the number
/// of threads: per sphere, only the pixels inside its bounds are asked, and what the rays share is
/// computed once. A scene without planes runs no plane code.
pub fn trace(scene: &Scene, camera: &PosedCamera, raster: &Raster, outputs: Outputs) -> Frame {
    trace_reporting(scene, camera, raster, outputs, |_| ())
}

/// [`trace`] for those who want to tell how far it is: `done` is called, from any thread, with the
/// number of rows that were just finished.
pub fn trace_reporting(
    scene: &Scene,
    camera: &PosedCamera,
    raster: &Raster,
    outputs: Outputs,
    done: impl Fn(usize) + Sync,
) -> Frame {
    let width = raster.columns.len();
    let mut frame = Frame {
        camera: *camera,
        raster: raster.clone(),
        // Zeroed memory costs nothing until a band, in its own thread, fills it.
        t: vec![0.0; raster.len()],
        object: vec![0; raster.len()],
        normal: if outputs.normal { vec![DVec3::ZERO; raster.len()] } else { Vec::new() },
    };
    if raster.is_empty() {
        return frame;
    }
    let plan = Plan::new(scene, camera, raster);
    let band = BAND_ROWS * width;
    frame.t.par_chunks_mut(band).zip(frame.object.par_chunks_mut(band)).enumerate().for_each(
        |(index, (t, object))| {
            let first = index * BAND_ROWS;
            let rows = t.len() / width;
            plan.trace_band(&mut Band { rows: first..first + rows, t, object });
            done(rows);
        },
    );
    frame.normal.par_chunks_mut(width).enumerate().for_each(|(row, normals)| {
        let pixels = row * width..(row + 1) * width;
        plan.fill_normals(row, &frame.t[pixels.clone()], &frame.object[pixels], normals);
    });
    frame
}

/// A sphere and the pixels of the raster (not of the image) that it can cover.
struct Visible {
    index: u32,
    rows: Range<u16>,
    columns: Range<u16>,
}

/// What all bands of a frame share.
struct Plan<'a> {
    scene: &'a Scene,
    camera: &'a PosedCamera,
    raster: &'a Raster,
    /// For each run of spheres, for each band, those that it can see; in the order of objects.
    visible: Vec<Vec<Vec<Visible>>>,
    /// `u*U` of each column of the raster.
    column_parts: Vec<DVec3>,
    planes: Vec<PlaneSeen>,
    normals: Normals<'a>,
    /// Whether no view ray's direction needs scaling.
    plain: bool,
}

/// Consecutive rows of the raster, with their part of the buffers.
struct Band<'a> {
    rows: Range<usize>,
    t: &'a mut [f64],
    object: &'a mut [u32],
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
    bands.resize_with(raster.rows.len().div_ceil(BAND_ROWS), Vec::new);
    for (index, sphere) in (first..).zip(spheres) {
        let Some(PixelBounds { rows, columns }) = bounds.of(sphere) else { continue };
        let (rows, columns) = (part_of(&rows, &raster.rows), part_of(&columns, &raster.columns));
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
    fn new(scene: &'a Scene, camera: &'a PosedCamera, raster: &'a Raster) -> Self {
        let bounds = Bounds::new(camera);
        let visible = scene
            .spheres()
            .par_chunks(SPHERES_PER_RUN)
            .enumerate()
            .map(|(run, spheres)| visible_by_band(spheres, run * SPHERES_PER_RUN, &bounds, raster))
            .collect();
        Plan {
            scene,
            camera,
            raster,
            visible,
            column_parts: raster
                .columns
                .iter()
                .map(|column| camera.column_part(camera.u_of_column(*column)))
                .collect(),
            planes: scene.planes().iter().map(|p| PlaneSeen::new(p, camera.eye())).collect(),
            normals: Normals::new(scene),
            plain: camera.has_plain_directions(raster),
        }
    }

    fn row_part(&self, row: usize) -> DVec3 {
        self.camera.row_part(self.camera.v_of_row(self.raster.rows[row]))
    }

    fn trace_band(&self, band: &mut Band) {
        band.t.fill(f64::INFINITY);
        band.object.fill(NO_OBJECT);
        for run in &self.visible {
            for Visible { index, rows, columns } in &run[band.rows.start / BAND_ROWS] {
                let rows = usize::from(rows.start).max(band.rows.start)
                    ..usize::from(rows.end).min(band.rows.end);
                let columns = usize::from(columns.start)..usize::from(columns.end);
                let seen =
                    SphereSeen::new(&self.scene.spheres()[*index as usize], self.camera.eye());
                match seen.kernel(self.plain) {
                    Kernel::Any => {
                        self.trace_object(band, *index, rows, columns, |d| seen.first_hit(d));
                    }
                    Kernel::Near => {
                        self.trace_object(band, *index, rows, columns, |d| seen.first_hit_near(d));
                    }
                    Kernel::Far => {
                        self.trace_object(band, *index, rows, columns, |d| seen.first_hit_far(d));
                    }
                }
            }
        }
        let (rows, columns) = (band.rows.clone(), 0..self.column_parts.len());
        for (index, plane) in (self.scene.spheres().len() as u32..).zip(&self.planes) {
            let (rows, columns) = (rows.clone(), columns.clone());
            if plane.is_plain(self.plain) {
                self.trace_object(band, index, rows, columns, |d| plane.first_hit_plain(d));
            } else {
                self.trace_object(band, index, rows, columns, |d| plane.first_hit(d));
            }
        }
    }

    /// Objects come in ascending order, so "nearer than what is there" keeps the first of equals.
    /// `first_hit` gives the `t` of the first hit, or anything but a positive, finite number.
    fn trace_object(
        &self,
        band: &mut Band,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        first_hit: impl Fn(DVec3) -> f64,
    ) {
        let width = self.column_parts.len();
        for row in rows {
            let row_part = self.row_part(row);
            let start = (row - band.rows.start) * width;
            let t = &mut band.t[start..start + width][columns.clone()];
            let object = &mut band.object[start..start + width][columns.clone()];
            let parts = &self.column_parts[columns.clone()];
            for ((t, object), column_part) in t.iter_mut().zip(object).zip(parts) {
                let hit = first_hit(*column_part + row_part);
                if hit > 0.0 && hit < *t {
                    *t = hit;
                    *object = index;
                }
            }
        }
    }

    fn fill_normals(&self, row: usize, t: &[f64], object: &[u32], normals: &mut [DVec3]) {
        let row_part = self.row_part(row);
        for (column, normal) in normals.iter_mut().enumerate() {
            if object[column] != NO_OBJECT {
                let direction = self.column_parts[column] + row_part;
                let ray = Ray { origin: self.camera.eye(), direction };
                *normal = self.normals.at(object[column], &ray, t[column]);
            }
        }
    }
}
