//! Compares a student's basis, rays and hits with those of pipelines (programs that may make mistakes).

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{DVec3, Outputs, Pixel, Raster, ResolvedCamera, Scene, trace};

use crate::grading::answers::{GivenHit, HitAnswer, RayAnswer, WrittenVector};
use crate::grading::certainty::Certainty;
use crate::grading::diagnosis::{Fits, GradingContext};
use crate::grading::first_hits::{Finding, FirstHits, PossibleHit, hits_of_each, work};
use crate::grading::grade::{AnswerValue, Hit, Truth};
use crate::mistakes::{Measure, Pipeline, PipelineCamera};

pub(super) struct Hits<'a> {
    pub(super) answers: &'a [HitAnswer],
    /// The true first hits, in the order of the answers.
    pub(super) first: Vec<Option<Hit>>,
    pub(super) scene: &'a Scene,
    pub(super) context: GradingContext<'a>,
}

impl Fits for Hits<'_> {
    fn work(&self, pipeline: &Pipeline) -> usize {
        work(self.scene, pipeline)
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let HitAnswer { pixel, hit } = self.answers[index];
        if !camera.answers_for(pixel) {
            return false;
        }
        let (direction, first) = self.found(camera, index);
        first.outcomes().any(|outcome| self.is(camera, direction, outcome, hit))
    }

    fn is_evidence(&self, camera: &PipelineCamera, index: usize) -> bool {
        // Without the square root, rounding errors may outgrow t.
        let (_, first) = self.found(camera, index);
        first.hits.iter().all(|hit| hit.most - hit.least <= hit.t.abs())
    }

    fn certainty(&self, index: usize) -> Certainty {
        let HitAnswer { pixel, hit } = self.answers[index];
        let GradingContext { right, tolerance, .. } = &self.context;
        let about = (pixel, self.first[index].map(|hit| hit.object));
        let says_t = hit.is_some_and(|hit| hit.t.is_some() || hit.point.is_some());
        let is = |direction, outcome: Finding| self.is(right, direction, outcome, hit);
        self.context.certainty(self.scene, about, *tolerance, says_t, is)
    }

    fn may_be_unseen(&self, index: usize) -> bool {
        let HitAnswer { pixel, hit } = self.answers[index];
        let (Some(truth), true) = (self.first[index], hit.is_some()) else {
            return self.first[index].is_some();
        };
        let camera = &self.context.right;
        let direction = camera.direction(f64::from(pixel.row), f64::from(pixel.column));
        hits_of_each(self.scene, camera, direction, self.context.tolerance).iter().any(|unseen| {
            unseen.object != truth.object && self.is(camera, direction, Some(unseen), hit)
        })
    }

    fn error(&self, index: usize) -> f64 {
        match self.context.has(self.answers[index].pixel) {
            true => error_of(self.answers[index].hit, self.first[index], self.context.right.eye),
            false => f64::INFINITY,
        }
    }

    fn right(&self, index: usize) -> AnswerValue {
        match self.context.has(self.answers[index].pixel) {
            true => self.first[index].into(),
            false => AnswerValue::NoPixel,
        }
    }
}

impl GradingContext<'_> {
    /// Returns true if the image contains this pixel.
    fn has(&self, pixel: Pixel) -> bool {
        self.given.resolved.image().contains(pixel)
    }
}

impl Hits<'_> {
    /// Returns the direction of an answer's ray and the hits that a program with this camera may find first.
    fn found(&self, camera: &PipelineCamera, index: usize) -> (DVec3, FirstHits) {
        let Pixel { row, column } = self.answers[index].pixel;
        let direction = camera.direction(row.into(), column.into());
        (direction, FirstHits::find(self.scene, camera, direction, self.context.tolerance))
    }

    /// Returns true if the student's answer is within the range of the acceptable `outcome`, on the
    /// same object, or if both are misses.
    fn is(
        &self,
        camera: &PipelineCamera,
        direction: DVec3,
        outcome: Finding,
        answer: Option<GivenHit>,
    ) -> bool {
        let (Some(hit), Some(given)) = (outcome, answer) else {
            return outcome.is_none() && answer.is_none();
        };
        let Pipeline { measure, objects_from_one, .. } = camera.pipeline;
        let length = length(direction);
        let (t_unit, step) = match measure {
            Measure::Right => (1.0, direction),
            Measure::Distance => (length, direction),
            Measure::PointOfUnit => (1.0, direction / length),
            Measure::PointOfDistance => (length, length * direction),
        };
        let PossibleHit { object, t, least, most, .. } = *hit;
        let is_object =
            given.object.is_none_or(|given| given == object + u32::from(objects_from_one));
        let is_t = given.t.is_none_or(|given| {
            let off =
                8.0 * f64::EPSILON * (t_unit * t).abs() + self.context.digits * given.rounding;
            given.value >= t_unit * least - off && given.value <= t_unit * most + off
        });
        let is_point = |given: WrittenVector| {
            let from_eye = given.value - camera.eye;
            let reach = least.abs().max(most.abs()) * step.length();
            let off = (self.context.tolerance + camera.off) * reach
                + self.context.digits * given.rounding
                + 16.0 * camera.epsilon * (camera.eye.length() + reach);
            // The ray must have a point, within the allowed range of t, that differs by at most `off`
            // in each coordinate.
            let mut along = [least, most];
            for axis in 0..3 {
                let ends = [from_eye[axis] - off, from_eye[axis] + off].map(|x| x / step[axis]);
                if step[axis] == 0.0 && from_eye[axis].abs() > off {
                    return false;
                } else if step[axis] != 0.0 {
                    along[0] = along[0].max(ends[0].min(ends[1]));
                    along[1] = along[1].min(ends[0].max(ends[1]));
                }
            }
            along[0] <= along[1]
        };
        is_object && is_t && given.point.is_none_or(is_point)
    }
}

/// Returns the distance between the given hit and the true one, relative to the distance of the true
/// one from the eye. It is 0 for two misses, and infinite if one is a hit and the other is a miss, or
/// if they are on different objects.
fn error_of(given: Option<GivenHit>, truth: Option<Hit>, eye: DVec3) -> f64 {
    let (given, truth) = match (given, truth) {
        (None, None) => return 0.0,
        (Some(given), Some(truth)) => (given, truth),
        _ => return f64::INFINITY,
    };
    if given.object.is_some_and(|object| object != truth.object) {
        return f64::INFINITY;
    }
    let of_t = given.t.map_or(0.0, |t| (t.value - truth.t).abs() / truth.t);
    let distance = (truth.point - eye).length();
    let of_point = given.point.map_or(0.0, |p| (p.value - truth.point).length() / distance);
    // An error that is NaN counts as infinite.
    if of_t.is_nan() || of_point.is_nan() { f64::INFINITY } else { of_t.max(of_point) }
}

/// Returns the true first hits of the rays through these pixels; `None` for a miss, and for a pixel
/// outside the image.
pub(super) fn truth_of(
    truth: &Truth,
    resolved: &ResolvedCamera,
    pixels: &[Pixel],
) -> Vec<Option<Hit>> {
    /// Maximum number of rows that are traced at a time, to limit the memory for large images.
    const ROWS: u32 = 256;
    let image = resolved.image();
    let mut hits = vec![None; pixels.len()];
    let mut by_row: Vec<usize> = (0..pixels.len()).filter(|i| image.contains(pixels[*i])).collect();
    by_row.sort_by_key(|index| pixels[*index].row);
    for here in by_row.chunk_by(|a, b| pixels[*a].row / ROWS == pixels[*b].row / ROWS) {
        let [first, last] = [here[0], here[here.len() - 1]].map(|index| pixels[index].row);
        let raster = Raster::part(first..last + 1, 0..image.width());
        if here.len() * 16 < raster.len() {
            // The pixels are few and far apart.
            for index in here {
                let hit = truth.scene.first_hit_of(&resolved.exact_ray(pixels[*index]));
                hits[*index] = hit.map(|r| Hit { t: r.t, point: r.point, object: r.object });
            }
            continue;
        }
        let frame = trace(truth.scene, resolved, &raster, Outputs::default());
        for index in here {
            let pixel = pixels[*index];
            let traced = frame.at((pixel.row - first) as usize, pixel.column as usize);
            let (t, point) = (traced.t, resolved.ray_of_pixel(pixel).at(traced.t));
            hits[*index] = traced.object.map(|object| Hit { t, point, object });
        }
    }
    hits
}

pub(super) struct Vectors<'a> {
    pub(super) answers: &'a [WrittenVector; 3],
    pub(super) context: GradingContext<'a>,
}

impl Fits for Vectors<'_> {
    fn shows_basis(&self) -> bool {
        true
    }

    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let WrittenVector { value, rounding } = self.answers[index];
        let wanted = [camera.u, camera.v, camera.w][index];
        let off =
            (self.context.tolerance + camera.off) * length(wanted) + self.context.digits * rounding;
        (value - wanted).abs().max_element() <= off
    }

    fn certainty(&self, index: usize) -> Certainty {
        let mut turned = self.context.right;
        (turned.u, turned.v, turned.w) = (turned.v, turned.w, turned.u);
        if self.fits(&turned, index) { Certainty::Doubtful } else { Certainty::Sure }
    }

    fn error(&self, index: usize) -> f64 {
        let PipelineCamera { u, v, w, .. } = self.context.right;
        length(self.answers[index].value - [u, v, w][index])
    }

    fn right(&self, index: usize) -> AnswerValue {
        let basis = self.context.given.resolved.basis();
        AnswerValue::Vector([basis.u, basis.v, basis.w][index])
    }
}

pub(super) struct Rays<'a> {
    pub(super) answers: &'a [RayAnswer],
    pub(super) context: GradingContext<'a>,
}

impl Fits for Rays<'_> {
    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool {
        let RayAnswer { pixel, origin, direction } = self.answers[index];
        let GradingContext { tolerance, digits, .. } = self.context;
        let wanted = camera.direction(f64::from(pixel.row), f64::from(pixel.column));
        let rounding = digits * direction.rounding / length(direction.value);
        let origin_off = tolerance * self.size(camera)
            + camera.epsilon * length(camera.eye)
            + digits * origin.rounding;
        camera.answers_for(pixel)
            && turned(direction.value, wanted) <= tolerance + camera.off + rounding
            && (origin.value - camera.eye).abs().max_element() <= origin_off
    }

    fn certainty(&self, index: usize) -> Certainty {
        let fits_all = self.context.around.iter().all(|camera| self.fits(camera, index));
        if fits_all { Certainty::Doubtful } else { Certainty::Sure }
    }

    fn error(&self, index: usize) -> f64 {
        let RayAnswer { origin, direction, .. } = self.answers[index];
        let AnswerValue::Ray(ray) = self.right(index) else { return f64::INFINITY };
        let turned = turned(direction.value, ray.direction);
        let moved = length(origin.value - self.context.right.eye) / self.size(&self.context.right);
        let is_ray = direction.value.is_finite() && direction.value != DVec3::ZERO;
        if is_ray && moved.is_finite() { turned.max(moved) } else { f64::INFINITY }
    }

    fn right(&self, index: usize) -> AnswerValue {
        let pixel = self.answers[index].pixel;
        match self.context.has(pixel) {
            true => AnswerValue::Ray(self.context.given.resolved.ray_of_pixel(pixel)),
            false => AnswerValue::NoPixel,
        }
    }
}

impl Rays<'_> {
    /// Returns the length relative to which the error of a ray's origin is measured: the eye's distance
    /// from the world's origin or, if that is larger, the viewport's distance.
    fn size(&self, camera: &PipelineCamera) -> f64 {
        length(camera.eye).max(self.context.given.resolved.viewport().distance)
    }
}

/// Returns the difference of two directions, regardless of their lengths: the largest coordinate of the
/// difference of their unit vectors. Coordinates are compared because each is rounded separately when
/// it is written.
fn turned(a: DVec3, b: DVec3) -> f64 {
    (unit(a) - unit(b)).abs().max_element()
}
