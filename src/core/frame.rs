//! A picture: the first hit of every pixel's view ray.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use crate::bounds::{PixelBounds, sphere_bounds};
use crate::image::{ImageSize, Pixel};
use crate::plane::PlaneSeen;
use crate::posed::PosedCamera;
use crate::scene::Scene;
use crate::sphere::{Roots, SphereSeen};

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

/// Traces the first hit of every pixel of the raster, rows in parallel.
///
/// Each pixel is what [`Scene::first_hit`] says of its view ray, bit for bit: per sphere, only the
/// pixels inside its [bounds](sphere_bounds) are asked, and what the rays share is computed once.
/// A scene without planes runs no plane code.
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
    let mut t = vec![f64::INFINITY; raster.len()];
    let mut object = vec![NO_OBJECT; raster.len()];
    let mut normal = if outputs.normal { vec![DVec3::ZERO; raster.len()] } else { Vec::new() };
    if !raster.is_empty() {
        let shared = Shared::new(scene, camera, raster);
        let band = BAND_ROWS * width;
        t.par_chunks_mut(band).zip(object.par_chunks_mut(band)).enumerate().for_each(
            |(index, (t, object))| {
                let first = index * BAND_ROWS;
                let rows = t.len() / width;
                shared.trace_band(&mut Band { rows: first..first + rows, t, object });
                done(rows);
            },
        );
        normal.par_chunks_mut(width).enumerate().for_each(|(row, normals)| {
            let start = row * width;
            shared.fill_normals(row, &t[start..], &object[start..], normals);
        });
    }
    Frame { camera: *camera, raster: raster.clone(), t, object, normal }
}

/// What all bands of a frame share.
struct Shared<'a> {
    scene: &'a Scene,
    camera: &'a PosedCamera,
    raster: &'a Raster,
    /// Where in the raster (not in the image) each visible sphere can be seen.
    bounds: Vec<(u32, Range<usize>, Range<usize>)>,
    /// `u*U` of each column of the raster.
    column_parts: Vec<DVec3>,
    planes: Vec<PlaneSeen>,
}

/// Consecutive rows of the raster, with their part of the buffers.
struct Band<'a> {
    rows: Range<usize>,
    t: &'a mut [f64],
    object: &'a mut [u32],
}

impl<'a> Shared<'a> {
    fn new(scene: &'a Scene, camera: &'a PosedCamera, raster: &'a Raster) -> Self {
        let part_of = |pixels: &Range<u32>, of: &[u32]| {
            of.partition_point(|x| *x < pixels.start)..of.partition_point(|x| *x < pixels.end)
        };
        let bounds = scene
            .spheres()
            .par_iter()
            .with_min_len(1024)
            .enumerate()
            .filter_map(|(index, sphere)| {
                let PixelBounds { rows, columns } = sphere_bounds(camera, sphere)?;
                let (rows, columns) =
                    (part_of(&rows, &raster.rows), part_of(&columns, &raster.columns));
                (!rows.is_empty() && !columns.is_empty()).then_some((index as u32, rows, columns))
            })
            .collect();
        Shared {
            scene,
            camera,
            raster,
            bounds,
            column_parts: raster
                .columns
                .iter()
                .map(|column| camera.column_part(camera.u_of_column(*column)))
                .collect(),
            planes: scene.planes().iter().map(|p| PlaneSeen::new(p, camera.eye())).collect(),
        }
    }

    fn row_part(&self, row: usize) -> DVec3 {
        self.camera.row_part(self.camera.v_of_row(self.raster.rows[row]))
    }

    fn trace_band(&self, band: &mut Band) {
        for (index, rows, columns) in &self.bounds {
            let rows = rows.start.max(band.rows.start)..rows.end.min(band.rows.end);
            if !rows.is_empty() {
                let sphere = &self.scene.spheres()[*index as usize];
                let seen = SphereSeen::new(sphere, self.camera.eye());
                self.trace_object(band, *index, rows, columns.clone(), |d| seen.roots(d));
            }
        }
        let columns = 0..self.column_parts.len();
        for (index, plane) in (self.scene.spheres().len() as u32..).zip(&self.planes) {
            self.trace_object(band, index, band.rows.clone(), columns.clone(), |d| plane.roots(d));
        }
    }

    /// Objects come in ascending order, so "nearer than what is there" keeps the first of equals.
    fn trace_object(
        &self,
        band: &mut Band,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        roots: impl Fn(DVec3) -> Roots,
    ) {
        let width = self.column_parts.len();
        for row in rows {
            let row_part = self.row_part(row);
            let start = (row - band.rows.start) * width;
            let t = &mut band.t[start..start + width][columns.clone()];
            let object = &mut band.object[start..start + width][columns.clone()];
            let parts = &self.column_parts[columns.clone()];
            for ((t, object), column_part) in t.iter_mut().zip(object).zip(parts) {
                if let Some(hit) = roots(*column_part + row_part).first_positive()
                    && hit < *t
                {
                    *t = hit;
                    *object = index;
                }
            }
        }
    }

    fn fill_normals(&self, row: usize, t: &[f64], object: &[u32], normals: &mut [DVec3]) {
        let row_part = self.row_part(row);
        for (column, normal) in normals.iter_mut().enumerate() {
            if let Some(hit) = self.scene.object(object[column]) {
                let direction = self.column_parts[column] + row_part;
                let ray = crate::Ray { origin: self.camera.eye(), direction };
                *normal = hit.root(object[column], &ray, t[column]).normal;
            }
        }
    }
}
