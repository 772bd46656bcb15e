//! Checks a frame on a sample of its pixels.

use std::fmt;

use pinhole_core::{Frame, NO_OBJECT, Scene};
use rayon::prelude::*;

use super::random::Random;

/// A pixel of a frame whose object or `t` differs from the exactly computed first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fault {
    /// Row in the frame's raster.
    pub(crate) row: usize,
    /// Column in the frame's raster.
    pub(crate) column: usize,
    /// Object and t in the frame.
    pub(crate) found: (Option<u32>, f32),
    /// Object and t of the exact ray.
    pub(crate) truth: (Option<u32>, f64),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Fault { row, column, found, truth } = self;
        let object = |object: Option<u32>| object.map_or("nothing".to_owned(), |k| k.to_string());
        let (is, should) = (object(found.0), object(truth.0));
        write!(f, "row {row}, column {column}: {is} at t = {}", found.1)?;
        write!(f, ", but the exact ray says {should} at t = {}", truth.1)
    }
}

/// Compares `count` random pixels of a frame with the results of [`Scene::first_hit_of`] for the same
/// pixels' exact rays: the objects must be equal, and t within one ulp of `f32`. Every second pixel of
/// the sample is moved to the right, to the next pixel in its row whose object differs from its left
/// neighbour's, if there is one.
///
/// # Errors
/// Returns an error with the first pixel that differs.
pub(crate) fn sample(
    scene: &Scene,
    frame: &Frame<f32>,
    count: usize,
    seed: u64,
) -> Result<(), Fault> {
    let (rows, columns) = (frame.raster().rows().len(), frame.raster().columns().len());
    let mut random = Random::new(seed);
    let pixels: Vec<[usize; 2]> = (0..count)
        .map(|k| {
            let (row, column) = (random.below(rows as u32), random.below(columns as u32));
            let [row, column] = [row as usize, column as usize];
            let objects = &frame.object[row * columns..(row + 1) * columns];
            let outline = || (column + 1..columns).find(|j| objects[*j] != objects[*j - 1]);
            let moved = if k % 2 == 1 { outline() } else { None };
            [row, moved.unwrap_or(column)]
        })
        .collect();
    pixels.into_par_iter().try_for_each(|pixel| compare(scene, frame, pixel))
}

fn compare(scene: &Scene, frame: &Frame<f32>, [row, column]: [usize; 2]) -> Result<(), Fault> {
    let pixel = frame.at(row, column);
    let truth = scene.first_hit_of(&frame.camera().exact_ray(pixel.pixel));
    let object = truth.map(|root| root.object);
    let t = truth.map_or(f64::INFINITY, |root| root.t);
    if pixel.object == object && is_within_one_ulp(pixel.t, t) {
        return Ok(());
    }
    Err(Fault { row, column, found: (pixel.object, pixel.t), truth: (object, t) })
}

fn is_within_one_ulp(found: f32, truth: f64) -> bool {
    if truth.is_infinite() {
        return found == f32::INFINITY;
    }
    let rounded = truth as f32;
    [rounded.next_down(), rounded, rounded.next_up()].contains(&found)
}

/// Returns the share of pixels, from 0 to 1, in which two frames show the same object.
///
/// # Panics
/// Panics if the frames differ in size.
pub(crate) fn alike(a: &[u32], b: &[u32]) -> f64 {
    assert_eq!(a.len(), b.len());
    let same = a.iter().zip(b).filter(|(a, b)| a == b).count();
    same as f64 / a.len().max(1) as f64
}

/// Returns the share of pixels, from 0 to 1, that hit something.
pub(crate) fn coverage(objects: &[u32]) -> f64 {
    1.0 - alike(objects, &vec![NO_OBJECT; objects.len()])
}
