//! The rays that a student's pipeline sends out.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{Basis, Camera, CameraError, DVec2, DVec3, Orientation, Pixel, ResolvedCamera};

use super::pipeline::{Extent, Pipeline, Rows, Swap, UpAsV};

/// A right camera, with what wrong pipelines make of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GivenCamera {
    pub(crate) resolved: ResolvedCamera,
    pub(crate) view: DVec3,
    pub(crate) up: DVec3,
    /// `|up/|up| x w|` of the right w, in which no up is too long or too short.
    sine: f64,
    /// u, v and w are given, so that no mistake can be made in finding them.
    pub(crate) by_hand: bool,
    /// Count of roundings by which a direction may be off, as a share of its length.
    roundings: f64,
}

/// Far more roundings than there are between a camera's numbers and a ray's, each of which makes at
/// most one unit in the last place.
const ROUNDINGS: f64 = 16.0;

impl GivenCamera {
    pub(crate) fn new(camera: &Camera) -> Result<GivenCamera, CameraError> {
        let resolved = camera.resolve()?;
        let (view, up) = (camera.view(), camera.up());
        let conditioning = camera.up_angle().map_or(1.0, |angle| angle.conditioning);
        // at - eye cancels where both are far out.
        let lost = match camera.orientation {
            Orientation::At { at, .. } => (length(at) + length(camera.eye)) / length(view),
            _ => 0.0,
        };
        Ok(GivenCamera {
            resolved,
            view,
            up,
            sine: unit(up).cross(resolved.basis().w).length(),
            by_hand: matches!(camera.orientation, Orientation::Basis(_)),
            roundings: ROUNDINGS * (1.0 + lost) * conditioning,
        })
    }

    /// The camera that a pipeline makes.
    pub(crate) fn camera_of(&self, pipeline: Pipeline) -> PipelineCamera {
        let Basis { u, v, w } = *self.resolved.basis();
        let factors = self.factors(&pipeline);
        let up_as_v = match pipeline.basis.up_as_v {
            UpAsV::No => None,
            UpAsV::AsGiven => Some(self.up),
            UpAsV::Unit => Some(unit(self.up)),
        };
        let epsilon = if pipeline.single { f64::from(f32::EPSILON) } else { f64::EPSILON };
        PipelineCamera {
            pipeline,
            eye: self.resolved.eye(),
            u: factors.x * u,
            v: up_as_v.unwrap_or(factors.y * v),
            w: factors.z * w,
            factors,
            up_as_v,
            distance: self.resolved.viewport().distance,
            extent: self.extent(pipeline.extent),
            count: [self.resolved.image().width(), self.resolved.image().height()].map(f64::from),
            epsilon,
            off: self.roundings * epsilon,
            nearest: None,
        }
    }

    /// u, v and w as multiples of the right ones, so that none loses digits where up is close to
    /// the view.
    fn factors(&self, pipeline: &Pipeline) -> DVec3 {
        if self.by_hand {
            return DVec3::ONE;
        }
        let basis = pipeline.basis;
        let sign = |is_negative: bool| if is_negative { -1.0 } else { 1.0 };
        let w_length = if basis.w_raw { length(self.view) } else { 1.0 };
        let w = sign(basis.w_forwards) * w_length;
        let u_length = if basis.u_raw { w_length * length(self.up) * self.sine } else { 1.0 };
        let u = sign(basis.w_forwards != basis.u_swapped) * u_length;
        let v = sign(basis.v_swapped) * w * u;
        DVec3::new(u, if basis.v_unit { v.signum() } else { v }, w)
    }

    fn extent(&self, extent: Extent) -> [f64; 2] {
        let viewport = self.resolved.viewport();
        let (width, height) = (viewport.width, viewport.height);
        match extent {
            Extent::Ones if width != height => [1.0, 1.0],
            Extent::Right | Extent::Ones => [width, height],
            Extent::WidthForHeight => [width, width],
            Extent::HeightForWidth => [height, height],
            Extent::WidthByImage => [height * self.resolved.image().aspect(), height],
            Extent::HeightByImage => [width, width / self.resolved.image().aspect()],
            Extent::Swapped => [height, width],
            Extent::Half => [0.5 * width, 0.5 * height],
            Extent::Twice => [2.0 * width, 2.0 * height],
        }
    }
}

/// A pipeline's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PipelineCamera {
    pub(crate) pipeline: Pipeline,
    pub(crate) eye: DVec3,
    pub(crate) u: DVec3,
    pub(crate) v: DVec3,
    pub(crate) w: DVec3,
    /// u, v and w as multiples of the right ones.
    pub(crate) factors: DVec3,
    /// v, where it is no such multiple.
    pub(crate) up_as_v: Option<DVec3>,
    /// The viewport's.
    distance: f64,
    /// Width and height.
    pub(crate) extent: [f64; 2],
    /// W and H.
    count: [f64; 2],
    /// The spacing of the pipeline's numbers at 1.
    pub(crate) epsilon: f64,
    /// Error bound of a direction by rounding, as a share of its length.
    pub(crate) off: f64,
    /// The t that a picture by t shows white.
    pub(crate) nearest: Option<f64>,
}

impl PipelineCamera {
    /// Returns whether the pipeline answers for a pixel of this name.
    pub(crate) fn answers_for(&self, pixel: Pixel) -> bool {
        let [w, h] = self.count;
        let is_inside = f64::from(pixel.column) < w && f64::from(pixel.row) < h;
        is_inside || self.pipeline.from_one
    }

    /// (u, v) that the pipeline has for what it calls this row and column.
    pub(crate) fn uv(&self, row: f64, column: f64) -> DVec2 {
        let Pipeline { rows, swap, in_pixel, edge_to_edge, .. } = self.pipeline;
        let [w, h] = self.count;
        let row = if rows == Rows::FromLast { h - 1.0 - row } else { row };
        let ((across, columns), (down, height)) = match swap {
            Swap::No => ((column, w), (row, h)),
            Swap::Indices => ((row, w), (column, h)),
            Swap::Shares => ((row, h), (column, w)),
            Swap::Counts => ((column, h), (row, w)),
        };
        // In the form of the right camera, whose numerator is exact.
        let share = |index: f64, count: f64, in_pixel: f64| {
            let steps = if edge_to_edge { count - 1.0 } else { count };
            (2.0 * (index + in_pixel) - count) / (2.0 * steps)
        };
        let side = if rows == Rows::SignOfV { -1.0 } else { 1.0 };
        DVec2::new(
            self.extent[0] * share(across, columns, in_pixel[0]),
            side * self.extent[1] * (0.0 - share(down, height, in_pixel[1])),
        )
    }

    /// The distance that the rays are made with.
    pub(crate) fn distance_taken(&self) -> f64 {
        self.pipeline.distance.taken_for(self.distance)
    }

    /// The direction that the pipeline has for a (u, v).
    pub(crate) fn direction_at(&self, uv: DVec2) -> DVec3 {
        let direction = self.pipeline.direction([self.u, self.v, self.w], self.distance, uv);
        if self.pipeline.eye_added { self.eye + direction } else { direction }
    }

    /// The direction that the pipeline has for what it calls this row and column.
    pub(crate) fn direction(&self, row: f64, column: f64) -> DVec3 {
        self.direction_at(self.uv(row, column))
    }
}
