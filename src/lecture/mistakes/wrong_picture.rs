//! The pictures of wrong cameras, and votes (quiz questions for an audience) on which mistake was made
//! in a picture.
//!
//! The rays of a wrong camera are also those of a valid camera whose viewport is mirrored, scaled,
//! shifted by a fraction of a pixel, or facing backwards. The tracer draws this stand-in camera as fast
//! as any other, and its pixels are then moved to where the wrong camera shows them. If up is used as
//! v, each row has a stand-in camera of its own.

use pinhole_core::{
    BACKGROUND, Basis, Camera, CameraError, DVec3, Frame, HitShader, ImageSize, NO_OBJECT,
    Orientation, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, Shade, Viewport, trace_as,
};
use rayon::prelude::*;

use crate::mistakes::checks::Checked;
use crate::mistakes::pipeline::{Rows, Swap};
use crate::mistakes::table::Mistake;
use crate::mistakes::wrong_camera::WrongCamera;

/// The first hits of the rays of a wrong camera.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct WrongPicture {
    camera: WrongCamera,
    /// The rows and columns that were traced.
    pub raster: Raster,
    /// The `t` of the first hit of every pixel of the raster, row by row; infinite for a miss.
    pub t: Vec<f32>,
    /// The index of the object hit in every pixel, or [`NO_OBJECT`].
    pub object: Vec<u32>,
}

/// The positions of a wrong camera's columns (or rows) in the image of its stand-in, the valid camera
/// that has the same rays.
struct StandInAxis {
    /// Number of the stand-in's pixels along this axis, large enough to contain all positions. If rows
    /// are used as columns, it can be almost three times that of the image.
    count: u32,
    /// Size of the stand-in's viewport along this axis; its pixels are as large as the wrong camera's.
    extent: f64,
    /// The positions, ascending and without repetition.
    sorted: Vec<u32>,
    is_reversed: bool,
}

impl StandInAxis {
    /// Creates the axis. `indices` are the columns (or rows) of the wrong camera, in ascending order,
    /// and `pixels` is the number of pixels into which it divides `extent`. `half` is the offset that
    /// it adds to an index: 0.5 for the pixel's centre, 0 for its edge.
    fn new(indices: &[u32], pixels: u32, extent: f64, half: f64, is_reversed: bool) -> StandInAxis {
        // The shift is one pixel for an offset of zero. `beyond` leaves space for indices beyond the
        // last pixel.
        let shift = (2.0 * (0.5 - half)) as u32;
        let last = indices.last().copied().unwrap_or_default();
        let beyond = (last + 1).saturating_sub(pixels);
        let count = pixels + shift + 2 * beyond;
        let in_stand_in = |index: u32| {
            if is_reversed { pixels + beyond + shift - 1 - index } else { index + beyond }
        };
        let mut sorted: Vec<u32> = indices.iter().map(|index| in_stand_in(*index)).collect();
        sorted.sort_unstable();
        let extent = extent.abs() * (f64::from(count) / f64::from(pixels));
        StandInAxis { count, extent, sorted, is_reversed }
    }

    /// Returns the index in `sorted` of the position of the wrong camera's `k`th column (or row).
    fn at(&self, k: usize) -> usize {
        if self.is_reversed { self.sorted.len() - 1 - k } else { k }
    }
}

impl WrongPicture {
    /// Traces the wrong camera's picture, only in the pixels of `raster`, which must be a raster of the
    /// camera's image.
    ///
    /// # Errors
    /// Returns an error if the wrong camera's numbers do not form a camera.
    pub fn trace(
        scene: &Scene,
        camera: &WrongCamera,
        raster: &Raster,
    ) -> Result<WrongPicture, CameraError> {
        let mut picture = WrongPicture {
            camera: camera.clone(),
            raster: raster.clone(),
            t: vec![f32::INFINITY; raster.len()],
            object: vec![NO_OBJECT; raster.len()],
        };
        if raster.is_empty() {
            return Ok(picture);
        }
        let made = &camera.made;
        let swapped = made.pipeline.swap != Swap::No;
        let (along_u, along_v) = if swapped {
            (raster.rows(), raster.columns())
        } else {
            (raster.columns(), raster.rows())
        };
        let (image, facing) = (camera.image(), made.factors.z.signum());
        let ([half_u, half_v], [width, height]) = (made.pipeline.in_pixel, made.extent);
        let width = width * made.factors.x;
        let columns = StandInAxis::new(along_u, image.width(), width, half_u, width * facing < 0.0);
        if let Some(up) = made.up_as_v {
            for (k, index) in along_v.iter().enumerate() {
                let uv = if swapped {
                    made.uv(0.0, f64::from(*index))
                } else {
                    made.uv(f64::from(*index), 0.0)
                };
                let stand_in = camera.row_camera(uv.y * up, &columns)?;
                let frame = traced(scene, &stand_in, vec![0], columns.sorted.clone());
                picture.take(&frame, &columns, k..k + 1, |_| 0);
            }
            return Ok(picture);
        }
        let side = if made.pipeline.rows == Rows::FromTop { 1.0 } else { -1.0 };
        let height = height * made.factors.y;
        let rows = StandInAxis::new(along_v, image.height(), height, half_v, side * height < 0.0);
        let stand_in = camera.stand_in(&columns, &rows)?;
        let frame = traced(scene, &stand_in, rows.sorted.clone(), columns.sorted.clone());
        picture.take(&frame, &columns, 0..along_v.len(), |k| rows.at(k));
        Ok(picture)
    }

    /// Copies the pixels of the stand-in's frame to their positions in the wrong camera's picture, for
    /// the lines of pixels `ks`. Line k is row `row_of(k)` of the frame; it is a row of the picture or,
    /// if rows and columns are exchanged, a column.
    fn take(
        &mut self,
        frame: &Frame<f32>,
        columns: &StandInAxis,
        ks: std::ops::Range<usize>,
        row_of: impl Fn(usize) -> usize,
    ) {
        let width = self.raster.columns().len();
        let swapped = self.camera.made.pipeline.swap != Swap::No;
        for k in ks {
            let row = row_of(k) * columns.sorted.len();
            for c in 0..columns.sorted.len() {
                let from = row + columns.at(c);
                let to = if swapped { c * width + k } else { k * width + c };
                (self.t[to], self.object[to]) = (frame.t[from], frame.object[from]);
            }
        }
    }

    /// Returns the picture's colours, row by row, calculated in the same way as for a camera without
    /// mistakes.
    pub fn shaded<P: Clone + Send + Sync>(
        &self,
        scene: &Scene,
        shade: Shade,
        color_of: impl Fn(u32) -> Rgb + Sync,
        to_pixel: impl Fn(Rgb) -> P + Sync,
    ) -> Vec<P> {
        let nearest = self.t.iter().copied().fold(f32::INFINITY, f32::min);
        let shader = HitShader::new(scene, shade, f64::from(nearest));
        let color = |index: usize| {
            let object = self.object[index];
            match self.camera.ray(self.raster.pixel(index)) {
                Ok(ray) if object != NO_OBJECT => {
                    shader.color(&ray, object, f64::from(self.t[index]), color_of(object))
                }
                _ => BACKGROUND,
            }
        };
        (0..self.object.len()).into_par_iter().map(|index| to_pixel(color(index))).collect()
    }
}

impl WrongCamera {
    /// Returns the stand-in: the valid camera that has the same rays as this wrong one, but in other
    /// pixels.
    fn stand_in(
        &self,
        columns: &StandInAxis,
        rows: &StandInAxis,
    ) -> Result<ResolvedCamera, CameraError> {
        let Basis { u, v, w } = *self.right_camera().basis();
        let facing = self.made.factors.z.signum();
        let basis = Basis { u: facing * u, v, w: facing * w };
        let viewport = Viewport {
            width: columns.extent,
            height: rows.extent,
            distance: self.distance() * self.made.factors.z.abs(),
        };
        self.resolve(basis, viewport, [columns.count, rows.count])
    }

    /// Returns the stand-in for one row: the valid camera whose only row has the same rays as that row
    /// of this wrong camera. `upward` is the row's term `v*V` in the direction.
    fn row_camera(
        &self,
        upward: DVec3,
        columns: &StandInAxis,
    ) -> Result<ResolvedCamera, CameraError> {
        let facing = self.made.factors.z.signum();
        let forward = upward - self.distance() * self.w();
        // u is perpendicular to up and w, except for rounding errors.
        let u = facing * self.right_camera().basis().u;
        let w = -(forward - forward.dot(u) * u).normalize();
        let viewport = Viewport { width: columns.extent, height: 1.0, distance: forward.length() };
        let basis = Basis { u, v: w.cross(u), w };
        self.resolve(basis, viewport, [columns.count, 1])
    }

    fn resolve(
        &self,
        basis: Basis,
        viewport: Viewport,
        [columns, rows]: [u32; 2],
    ) -> Result<ResolvedCamera, CameraError> {
        let image = ImageSize::partly_traced(columns, rows).map_err(CameraError::Image)?;
        let (eye, orientation) = (self.right_camera().eye(), Orientation::Basis(basis));
        Camera { eye, orientation, viewport, image }.resolve()
    }
}

fn traced(scene: &Scene, camera: &ResolvedCamera, rows: Vec<u32>, columns: Vec<u32>) -> Frame<f32> {
    trace_as(scene, camera, &Raster::from_cells(rows, columns), Outputs::default())
}

/// Returns the object that the right camera sees in each pixel.
pub(super) fn right_objects(resolved: &ResolvedCamera, scene: &Scene, raster: &Raster) -> Vec<u32> {
    let outputs = Outputs { object: true, ..Outputs::NONE };
    trace_as::<f32>(scene, resolved, raster, outputs).object
}

/// A wrong camera, and the results of comparing it with the right one.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedCamera {
    /// The mistake that was made.
    pub mistake: Mistake,
    /// The camera that results from the mistake, or the reason why there is none, as a sentence.
    pub camera: Result<WrongCamera, String>,
    /// The results of all checks for the right camera.
    pub right_checks: Vec<Checked>,
    /// The results of all checks for the wrong camera; empty if there is none.
    pub checks: Vec<Checked>,
    /// The numbers of compared and of differing pixels; `None` if no pictures were compared.
    pub compared: Option<ComparedPixels>,
    /// The reason why there is no wrong picture; `None` if there is one.
    pub why_not: Option<String>,
}

/// The result of comparing the pixels of two pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedPixels {
    /// The number of pixels that are compared.
    pub pixels: usize,
    /// The number of pixels in which the two pictures show different objects, including those in which
    /// only one picture shows an object.
    pub differing: usize,
}

/// A wrong camera's picture, and the objects that the wrong and the right camera see in each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedPicture<P> {
    /// The colours of the wrong picture, row by row.
    pub pixels: Vec<P>,
    /// The object that the wrong camera sees in each pixel.
    pub wrong: Vec<u32>,
    /// The object that the right camera sees in each pixel.
    pub right: Vec<u32>,
}

impl ComparedCamera {
    /// Returns the checks that fail for the wrong camera.
    pub fn failing(&self) -> impl Iterator<Item = &Checked> {
        self.checks.iter().filter(|checked| !checked.passes)
    }

    /// Makes a mistake in a camera, and compares the resulting camera with the right one: its numbers
    /// and, if it has a picture, the picture.
    pub fn new<P: Clone + Send + Sync>(
        camera: &Camera,
        resolved: &ResolvedCamera,
        scene: &Scene,
        mistake: Mistake,
        raster: &Raster,
        paint: Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    ) -> (ComparedCamera, Option<ComparedPicture<P>>) {
        let made = WrongCamera::new(camera, mistake);
        let mut wrong = ComparedCamera {
            mistake,
            why_not: made.as_ref().err().cloned(),
            camera: made,
            right_checks: WrongCamera::right(camera).map(|c| c.checks()).unwrap_or_default(),
            checks: Vec::new(),
            compared: None,
        };
        let Ok(camera) = &wrong.camera else { return (wrong, None) };
        wrong.checks = camera.checks();
        match WrongPicture::trace(scene, camera, raster) {
            Ok(picture) => {
                let right = right_objects(resolved, scene, raster);
                let differing = count_differing(&picture.object, &right);
                wrong.compared = Some(ComparedPixels { pixels: right.len(), differing });
                let Paint { shade, color_of, to_pixel } = paint;
                let pixels = picture.shaded(scene, shade, color_of, to_pixel);
                (wrong, Some(ComparedPicture { pixels, wrong: picture.object, right }))
            }
            Err(error) => {
                wrong.why_not = Some(format!("The wrong camera sees nothing: {error}"));
                (wrong, None)
            }
        }
    }
}

/// Counts the pixels with different objects, including those where only one of the two is
/// [`NO_OBJECT`].
pub(super) fn count_differing(a: &[u32], b: &[u32]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}
