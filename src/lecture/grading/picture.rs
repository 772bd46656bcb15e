//! Compares whole pictures with those of pipelines.

use std::array;

use pinhole_core::arithmetic::length;
use pinhole_core::{
    BACKGROUND, DVec3, NO_OBJECT, Outputs, Pixel, Raster, Rgb, Scene, Shade, lambert, shade,
    trace_as,
};

use super::certainty::Certainty;
use super::diagnosis::{Fits, GradingContext};
use super::first_hits::{Finding, FirstHits, normal_at, work};
use super::grade::{AnswerValue, LEVELS_TOLERANCE, RELATIVE_TOLERANCE, Truth};
use crate::mistakes::{GivenCamera, Pipeline, PipelineCamera};

/// A student's picture that is compared under the assumption that it has a certain shading.
pub(super) struct Picture<'a> {
    pub(super) pixels: &'a [Rgb],
    pub(super) scene: &'a Scene,
    pub(super) color_of: &'a (dyn Fn(u32) -> Rgb + Sync),
    pub(super) shade: Shade,
    /// Index of the brightest grey pixel, which is the pixel of the nearest hit if the picture is
    /// shaded by t; `None` if no pixel is grey.
    pub(super) brightest: Option<usize>,
    /// The right picture.
    pub(super) right: &'a [Rgb],
    /// The objects that are hit first.
    pub(super) objects: &'a [u32],
    /// The right picture's [`contrast`].
    pub(super) contrast: f64,
    pub(super) context: GradingContext<'a>,
}

/// Returns the right picture in every shading, in the order of [`Shade::ALL`], the objects in it, and the
/// camera of a program without mistakes.
pub(super) fn right_pictures(
    truth: &Truth,
    given: &GivenCamera,
) -> ([Vec<Rgb>; 4], Vec<u32>, PipelineCamera) {
    let raster = Raster::full(given.resolved.image());
    let frame = trace_as::<f32>(truth.scene, &given.resolved, &raster, Outputs::default());
    let nearest = frame.t.iter().copied().fold(f32::INFINITY, f32::min);
    let pictures = Shade::ALL.map(|mode| shade(&frame, truth.scene, mode, truth.color_of, |c| c));
    let mut camera = given.camera_of(Pipeline::RIGHT);
    camera.nearest = Some(f64::from(nearest));
    (pictures, frame.object, camera)
}

/// Returns the index of the brightest grey pixel (the first of several); `None` if no pixel is grey.
pub(super) fn brightest(pixels: &[Rgb]) -> Option<usize> {
    let greys = pixels.iter().enumerate().filter(|(_, [r, g, b])| r == g && g == b);
    greys.rev().max_by_key(|(_, color)| color[0]).map(|(index, _)| index)
}

/// Returns the largest difference of a hit's colour from the background, in levels; 255 if nothing is hit.
pub(super) fn contrast(right: &[Rgb], objects: &[u32]) -> f64 {
    let hits = right.iter().zip(objects).filter(|(_, object)| **object != NO_OBJECT);
    hits.map(|(color, _)| off(*color, BACKGROUND)).reduce(f64::max).unwrap_or(255.0)
}

impl Fits for Picture<'_> {
    fn prepare(&self, camera: &mut PipelineCamera) {
        if self.shade == Shade::T
            && let Some(brightest) = self.brightest
        {
            let first = self.meetings(camera, brightest).0;
            camera.nearest = first.hits.first().map(|hit| hit.t);
        }
    }

    fn work(&self, pipeline: &Pipeline) -> usize {
        work(self.scene, pipeline)
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let (first, direction) = self.meetings(camera, index);
        first.outcomes().any(|outcome| self.is(self.pixels[index], camera, direction, outcome))
    }

    fn certainty(&self, index: usize) -> Certainty {
        let width = self.context.given.resolved.image().width();
        let pixel = Pixel { row: index as u32 / width, column: index as u32 % width };
        // The background would pass for the hit, or every hit for the background. At the usual tolerance,
        // such colours are alike in the right picture itself.
        let contrast = match self.objects[index] {
            NO_OBJECT => self.contrast,
            _ => off(self.right[index], BACKGROUND),
        };
        if self.context.tolerance > LEVELS_TOLERANCE && contrast <= self.context.tolerance {
            return Certainty::Doubtful;
        }
        let about = (pixel, Some(self.objects[index]).filter(|object| *object != NO_OBJECT));
        let (camera, says_t) = (&self.context.right, self.shade != Shade::Object);
        let is =
            |direction, outcome: Finding| self.is(self.pixels[index], camera, direction, outcome);
        self.context.certainty(self.scene, about, RELATIVE_TOLERANCE, says_t, is)
    }

    fn error(&self, index: usize) -> f64 {
        off(self.pixels[index], self.right[index])
    }

    fn right(&self, index: usize) -> AnswerValue {
        AnswerValue::Color(self.right[index])
    }
}

impl Picture<'_> {
    fn meetings(&self, camera: &PipelineCamera, index: usize) -> (FirstHits, DVec3) {
        let width = self.context.given.resolved.image().width() as usize;
        let direction = camera.direction((index / width) as f64, (index % width) as f64);
        let first = FirstHits::find(self.scene, camera, direction, RELATIVE_TOLERANCE);
        (first, direction)
    }

    /// Returns true if a pixel has a colour that the acceptable `outcome` has.
    fn is(&self, pixel: Rgb, camera: &PipelineCamera, direction: DVec3, outcome: Finding) -> bool {
        let Some(hit) = outcome else { return self.is_near(pixel, [BACKGROUND; 2]) };
        let color = |t: f64| self.color(camera, direction, hit.object, t);
        // A t of the opposite sign, on the other side of the eye, would have a different colour.
        let same_side = |t: f64| if t * hit.t > 0.0 { t } else { hit.t };
        let around = [same_side(hit.least), hit.t, same_side(hit.most)];
        let [a, b, c] = around.map(color);
        let least = array::from_fn(|k| a[k].min(b[k]).min(c[k]));
        let most = array::from_fn(|k| a[k].max(b[k]).max(c[k]));
        self.is_near(pixel, [least, most])
    }

    /// Returns the colour of a hit, calculated in the same way as by [`shade`].
    fn color(&self, camera: &PipelineCamera, direction: DVec3, object: u32, t: f64) -> Rgb {
        let byte = |x: f64| (x + 0.5) as u8;
        let color = (self.color_of)(object);
        let point = camera.eye + t * direction;
        let Some(normal) = normal_at(self.scene, object, point) else { return BACKGROUND };
        match self.shade {
            Shade::Object => color,
            Shade::T => [byte(255.0 * camera.nearest.unwrap_or(f64::NAN) / t); 3],
            Shade::Normal => normal.to_array().map(|x| byte(127.5 * (x + 1.0))),
            Shade::Lambert => {
                let cosine = normal.dot(direction).abs() / length(direction);
                lambert(color, cosine)
            }
        }
    }

    fn is_near(&self, pixel: Rgb, [least, most]: [Rgb; 2]) -> bool {
        (0..3).all(|k| {
            let value = f64::from(pixel[k]);
            value >= f64::from(least[k]) - self.context.tolerance
                && value <= f64::from(most[k]) + self.context.tolerance
        })
    }
}

/// Returns the largest difference of two colours in any channel, in levels.
pub(super) fn off(a: Rgb, b: Rgb) -> f64 {
    let worst = (0..3).map(|k| a[k].abs_diff(b[k])).max().unwrap_or_default();
    f64::from(worst)
}
