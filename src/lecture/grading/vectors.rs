//! Bases and rays against those of pipelines.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{DVec3, ImageSize};
use rayon::prelude::*;

use super::answers::{RayAnswer, WrittenVector};
use super::diagnosis::Fits;
use super::grade::{Digits, Judged};
use crate::mistakes::{GivenCamera, Pipeline, PipelineCamera};

pub(super) struct Vectors<'a> {
    pub(super) answers: &'a [WrittenVector; 3],
    pub(super) tolerance: f64,
    pub(super) digits: Digits,
}

impl Fits for Vectors<'_> {
    fn len(&self) -> usize {
        3
    }

    fn shows_basis(&self) -> bool {
        true
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let WrittenVector { value, rounding } = self.answers[index];
        let wanted = [camera.u, camera.v, camera.w][index];
        let off = (self.tolerance + camera.off) * length(wanted) + self.digits.allow(rounding);
        (value - wanted).abs().max_element() <= off
    }
}

impl Vectors<'_> {
    pub(super) fn judged(&self, given: &GivenCamera) -> Vec<Judged> {
        let right = given.camera_of(Pipeline::RIGHT);
        let judge = |index: usize| Judged {
            is_right: self.fits(&right, index),
            error: length(self.answers[index].value - [right.u, right.v, right.w][index]),
        };
        (0..3).map(judge).collect()
    }
}

pub(super) struct Rays<'a> {
    pub(super) answers: &'a [RayAnswer],
    pub(super) tolerance: f64,
    pub(super) digits: Digits,
    /// The viewport's distance: how long an origin of 0 is taken to be.
    pub(super) size: f64,
    pub(super) image: ImageSize,
}

impl Fits for Rays<'_> {
    fn len(&self) -> usize {
        self.answers.len()
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let RayAnswer { pixel, origin, direction } = self.answers[index];
        let wanted = camera.direction(f64::from(pixel.row), f64::from(pixel.column));
        let rounding = self.digits.allow(direction.rounding) / length(direction.value);
        camera.answers_for(pixel)
            && turned(direction.value, wanted) <= self.tolerance + camera.off + rounding
            && self.is_eye(camera, origin)
    }
}

impl Rays<'_> {
    fn is_eye(&self, camera: &PipelineCamera, origin: WrittenVector) -> bool {
        let size = length(camera.eye).max(self.size);
        let off = self.tolerance * size
            + camera.epsilon * length(camera.eye)
            + self.digits.allow(origin.rounding);
        (origin.value - camera.eye).abs().max_element() <= off
    }

    pub(super) fn judged(&self, given: &GivenCamera) -> Vec<Judged> {
        let right = given.camera_of(Pipeline::RIGHT);
        let judge = |index: usize| {
            let RayAnswer { pixel, origin, direction } = self.answers[index];
            if !self.image.contains(pixel) {
                return Judged { is_right: false, error: f64::INFINITY };
            }
            let size = length(right.eye).max(self.size);
            let turned = turned(direction.value, given.posed.ray_of_pixel(pixel).direction);
            let moved = length(origin.value - right.eye) / size;
            let is_ray = direction.value.is_finite() && direction.value != DVec3::ZERO;
            let error = if is_ray && moved.is_finite() { turned.max(moved) } else { f64::INFINITY };
            Judged { is_right: self.fits(&right, index), error }
        };
        (0..self.answers.len()).into_par_iter().map(judge).collect()
    }
}

/// The turn of one direction against another, whatever their lengths: the chord between both
/// unit vectors; its largest coordinate tells, as digits are written by coordinate.
fn turned(a: DVec3, b: DVec3) -> f64 {
    (unit(a) - unit(b)).abs().max_element()
}
