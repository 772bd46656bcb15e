//! The rays that a program sends out.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{Basis, Camera, CameraError, DVec3, Orientation, Pixel, PosedCamera};

use super::program::{Bottom, Distance, Extent, Place, Program, Swap};

/// The camera that answers are about, with what wrong programs make of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given {
    pub(super) posed: PosedCamera,
    view: DVec3,
    up: DVec3,
    /// `|up x w|` of the right w.
    up_cross_w: f64,
    /// u, v and w are given, so that no mistake can be made in finding them.
    pub(super) by_hand: bool,
    /// By how many roundings a direction may be off, as a share of its length.
    roundings: f64,
}

/// Far more roundings than there are between a camera's numbers and a ray's, each of which makes at
/// most one unit in the last place.
const ROUNDINGS: f64 = 16.0;

impl Given {
    pub(super) fn new(camera: &Camera) -> Result<Given, CameraError> {
        let posed = camera.posed()?;
        let (view, up) = (camera.view(), camera.up());
        let conditioning = camera.up_angle().map_or(1.0, |angle| angle.conditioning);
        // at - eye cancels where both are far out.
        let lost = match camera.orientation {
            Orientation::At { at, .. } => (length(at) + length(camera.eye)) / length(view),
            _ => 0.0,
        };
        Ok(Given {
            posed,
            view,
            up,
            up_cross_w: length(up) * unit(up).cross(posed.basis().w).length(),
            by_hand: matches!(camera.orientation, Orientation::Basis(_)),
            roundings: ROUNDINGS * (1.0 + lost) * conditioning,
        })
    }

    /// The camera of a program.
    pub(super) fn camera_of(&self, program: Program) -> ProgramCamera {
        let Basis { u, v, w } = *self.posed.basis();
        let [width, height] = self.extent(program.extent);
        let [u_factor, v_factor, w_factor] = self.factors(&program);
        let distance = match program.distance {
            Distance::Right => self.posed.viewport().distance,
            Distance::One => 1.0,
            Distance::LeftOut => 0.0,
            Distance::Plus => -self.posed.viewport().distance,
        };
        let up = match program.up_as_v {
            Some(true) => Some(unit(self.up)),
            Some(false) => Some(self.up),
            None => None,
        };
        let epsilon = if program.single { f64::from(f32::EPSILON) } else { f64::EPSILON };
        ProgramCamera {
            program,
            eye: self.posed.eye(),
            u: u_factor * u,
            v: up.unwrap_or(v_factor * v),
            w: w_factor * w,
            distance,
            extent: [width, height],
            count: [self.posed.image().width(), self.posed.image().height()].map(f64::from),
            epsilon,
            off: self.roundings * epsilon,
            nearest: f64::NAN,
        }
    }

    /// u, v and w as multiples of the right ones.
    fn factors(&self, program: &Program) -> [f64; 3] {
        if self.by_hand {
            return [1.0; 3];
        }
        let sign = |is_negative: bool| if is_negative { -1.0 } else { 1.0 };
        let w_length = if program.w_raw { length(self.view) } else { 1.0 };
        let w = sign(program.w_forwards) * w_length;
        let u_length = if program.u_raw { self.up_cross_w * w_length } else { 1.0 };
        let u = sign(program.w_forwards != program.u_swapped) * u_length;
        let v = sign(program.v_swapped) * w * u;
        [u, if program.v_unit { v.signum() } else { v }, w]
    }

    fn extent(&self, extent: Extent) -> [f64; 2] {
        let viewport = self.posed.viewport();
        let (width, height) = (viewport.width, viewport.height);
        match extent {
            Extent::Ones if width != height => [1.0, 1.0],
            Extent::Right | Extent::Ones => [width, height],
            Extent::WidthForHeight => [width, width],
            Extent::HeightForWidth => [height, height],
            Extent::WidthByImage => [height * self.posed.image().aspect(), height],
            Extent::HeightByImage => [width, width / self.posed.image().aspect()],
        }
    }
}

/// A program's camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProgramCamera {
    pub(super) program: Program,
    pub(super) eye: DVec3,
    pub(super) u: DVec3,
    pub(super) v: DVec3,
    pub(super) w: DVec3,
    distance: f64,
    /// Width and height.
    extent: [f64; 2],
    /// W and H.
    count: [f64; 2],
    /// The spacing of the program's numbers at 1.
    pub(super) epsilon: f64,
    /// How far a direction may be off by rounding, as a share of its length.
    pub(super) off: f64,
    /// The t that a picture by t shows white.
    pub(super) nearest: f64,
}

impl ProgramCamera {
    /// Whether the program answers for a pixel of this name.
    pub(super) fn answers_for(&self, pixel: Pixel) -> bool {
        let [w, h] = self.count;
        let is_inside = f64::from(pixel.column) < w && f64::from(pixel.row) < h;
        is_inside || self.program.from_one
    }

    /// The direction that the program has for what it calls this row and column.
    pub(super) fn direction(&self, row: f64, column: f64) -> DVec3 {
        let Program { bottom, swap, shift, .. } = self.program;
        let [w, h] = self.count;
        let row = if bottom == Bottom::LastRow { h - 1.0 - row } else { row };
        let ((across, columns), (down, rows)) = match swap {
            Swap::No => ((column, w), (row, h)),
            Swap::Indices => ((row, w), (column, h)),
            Swap::Shares => ((row, h), (column, w)),
            Swap::Counts => ((column, h), (row, w)),
        };
        // In the form of the right camera, whose numerator is exact.
        let share = |index: f64, count: f64, corner: Place| match self.program.place {
            Place::EdgeToEdge => {
                let steps = count - 1.0;
                (2.0 * (index + shift) - steps) / (2.0 * steps)
            }
            place if place == Place::Corner || place == corner => {
                (2.0 * (index + shift) - count) / (2.0 * count)
            }
            _ => (2.0 * (index + shift) + 1.0 - count) / (2.0 * count),
        };
        let upwards = if bottom == Bottom::SignOfV { 1.0 } else { -1.0 };
        let u = self.extent[0] * share(across, columns, Place::CornerAcross);
        let v = upwards * self.extent[1] * share(down, rows, Place::CornerDown);
        let direction = u * self.u + v * self.v - self.distance * self.w;
        if self.program.reversed { -direction } else { direction }
    }
}
