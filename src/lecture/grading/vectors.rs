//! Bases and rays against those of pipelines.

use pinhole_core::DVec3;
use pinhole_core::arithmetic::{length, unit};

use super::answers::{RayAnswer, WrittenVector};
use super::diagnosis::Fits;
use super::grade::{Judged, Right};
use crate::mistakes::{GivenCamera, Pipeline, PipelineCamera};

pub(super) struct Vectors<'a> {
    pub(super) answers: &'a [WrittenVector; 3],
    pub(super) given: &'a GivenCamera,
    pub(super) tolerance: f64,
    /// The share of what the written digits leave open that is allowed.
    pub(super) digits: f64,
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
        let off = (self.tolerance + camera.off) * length(wanted) + self.digits * rounding;
        (value - wanted).abs().max_element() <= off
    }

    fn judged(&self, index: usize) -> Judged {
        let right = self.given.camera_of(Pipeline::RIGHT);
        let error = length(self.answers[index].value - [right.u, right.v, right.w][index]);
        Judged { is_right: self.fits(&right, index), error }
    }

    fn right(&self, index: usize) -> Right {
        let basis = self.given.resolved.basis();
        Right::Vector([basis.u, basis.v, basis.w][index])
    }
}

pub(super) struct Rays<'a> {
    pub(super) answers: &'a [RayAnswer],
    pub(super) given: &'a GivenCamera,
    pub(super) tolerance: f64,
    /// The share of what the written digits leave open that is allowed.
    pub(super) digits: f64,
}

impl Fits for Rays<'_> {
    fn len(&self) -> usize {
        self.answers.len()
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let RayAnswer { pixel, origin, direction } = self.answers[index];
        let wanted = camera.direction(f64::from(pixel.row), f64::from(pixel.column));
        let rounding = self.digits * direction.rounding / length(direction.value);
        let origin_off = self.tolerance * self.size(camera)
            + camera.epsilon * length(camera.eye)
            + self.digits * origin.rounding;
        camera.answers_for(pixel)
            && turned(direction.value, wanted) <= self.tolerance + camera.off + rounding
            && (origin.value - camera.eye).abs().max_element() <= origin_off
    }

    fn judged(&self, index: usize) -> Judged {
        let RayAnswer { origin, direction, .. } = self.answers[index];
        let Right::Ray(ray) = self.right(index) else {
            return Judged { is_right: false, error: f64::INFINITY };
        };
        let right = self.given.camera_of(Pipeline::RIGHT);
        let turned = turned(direction.value, ray.direction);
        let moved = length(origin.value - right.eye) / self.size(&right);
        let is_ray = direction.value.is_finite() && direction.value != DVec3::ZERO;
        let error = if is_ray && moved.is_finite() { turned.max(moved) } else { f64::INFINITY };
        Judged { is_right: self.fits(&right, index), error }
    }

    fn right(&self, index: usize) -> Right {
        let (pixel, resolved) = (self.answers[index].pixel, &self.given.resolved);
        let is_pixel = resolved.image().contains(pixel);
        if is_pixel { Right::Ray(resolved.ray_of_pixel(pixel)) } else { Right::NoPixel }
    }
}

impl Rays<'_> {
    /// The length that an origin is taken to have: that of the eye, or, where that is larger, the
    /// viewport's distance.
    fn size(&self, camera: &PipelineCamera) -> f64 {
        length(camera.eye).max(self.given.resolved.viewport().distance)
    }
}

/// The turn of one direction against another, whatever their lengths: the chord between both
/// unit vectors; its largest coordinate tells, as digits are written by coordinate.
fn turned(a: DVec3, b: DVec3) -> f64 {
    (unit(a) - unit(b)).abs().max_element()
}
