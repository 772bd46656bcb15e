//! Checks that every camera without mistakes passes, and their results for a wrong camera.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{DVec2, DVec3, ORTHONORMAL_TOLERANCE};

use super::wrong_camera::{WrongCamera, corners};

pinhole_core::texts! {
    /// A property that every right camera has.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Check[2];
    {
        /// Returns a formula for the quantity that the check examines.
        formula,
        /// Returns the property that a camera has if it passes the check.
        meaning,
    }
    /// `|u| = 1`.
    LengthU: "|𝐮|", "𝐮 is a unit vector";
    /// `|v| = 1`.
    LengthV: "|𝐯|", "𝐯 is a unit vector";
    /// `|w| = 1`.
    LengthW: "|𝐰|", "𝐰 is a unit vector";
    /// `u . v = 0`.
    UDotV: "𝐮 · 𝐯", "𝐮 and 𝐯 are perpendicular";
    /// `v . w = 0`.
    VDotW: "𝐯 · 𝐰", "𝐯 and 𝐰 are perpendicular";
    /// `w . u = 0`.
    WDotU: "𝐰 · 𝐮", "𝐰 and 𝐮 are perpendicular";
    /// `(u x v) . w > 0`.
    RightHanded: "(𝐮 × 𝐯) · 𝐰", "𝐮 × 𝐯 points along 𝐰: right-handed";
    /// `w . view / |view| < 0`: w points backwards.
    LooksForwards: "𝐰 · view / |view|", "𝐰 points backwards, so the camera looks along view";
    /// `v . up / |up| > 0`.
    UpIsUp: "𝐯 · up / |up|", "𝐯 is on up's side, so up is up in the image";
    /// `-direction . w = distance` for the ray through the middle of the image, so that the viewport is
    /// at t = 1.
    ViewportAtDistance: "−𝐝 · 𝐰, middle ray", "t = 1 is the viewport, at its distance";
    /// The (u, v) of pixel (0, 0) is to the left of the viewport's middle and above it.
    TopLeft: "(𝑢, 𝑣) of pixel (0, 0)", "row 0, column 0 is at the top left";
    /// From one column to the next, (u, v) changes by `(width/W, 0)`.
    StepRight: "next column, step of (𝑢, 𝑣)", "columns go right, by width/𝑊";
    /// From one row to the next, (u, v) changes by `(0, -height/H)`.
    StepDown: "next row, step of (𝑢, 𝑣)", "rows go down, by height/𝐻";
    /// The mean (u, v) of the four corner pixels is (0, 0): they lie symmetrically around the middle.
    CornersBalance: "four corners, mean (𝑢, 𝑣)", "pixels lie evenly around the middle: their centres are taken";
}

impl Check {
    /// Returns true if the check examines lengths, right angles or handedness of u, v, w, and nothing else.
    pub fn is_of_basis(self) -> bool {
        use Check::{LengthU, LengthV, LengthW, RightHanded, UDotV, VDotW, WDotU};
        matches!(self, LengthU | LengthV | LengthW | UDotV | VDotW | WDotU | RightHanded)
    }
}

/// The value of a quantity that a check examines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// One number.
    Number(f64),
    /// A point of the viewport, or a step between two points.
    Uv(DVec2),
}

/// The values with which a check passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wanted {
    /// This value, up to rounding errors.
    Equal(Value),
    /// Below 0.
    Negative,
    /// Above 0.
    Positive,
    /// u at most 0 and v at least 0.
    LeftAndUp,
}

/// The result of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Checked {
    /// The check.
    pub check: Check,
    /// The value of the checked quantity for this camera; exactly 0 if it differs from 0 only by
    /// rounding errors.
    pub value: Value,
    /// The values with which the check passes.
    pub wanted: Wanted,
    /// True if the check passes.
    pub passes: bool,
}

impl WrongCamera {
    /// Returns the results of all checks for this camera.
    pub fn checks(&self) -> Vec<Checked> {
        Check::ALL.into_iter().map(|check| self.check(check)).collect()
    }

    /// Returns the result of one check for this camera.
    pub fn check(&self, check: Check) -> Checked {
        let (value, wanted) = self.value_and_wanted(check);
        let size = self.right_camera().viewport().width.max(self.right_camera().viewport().height);
        let passes = match (value, wanted) {
            (Value::Number(x), Wanted::Equal(Value::Number(y))) => {
                (x - y).abs() <= ORTHONORMAL_TOLERANCE * y.abs().max(1.0)
            }
            (Value::Uv(x), Wanted::Equal(Value::Uv(y))) => {
                // The tolerance is relative to the size of a pixel, which in a large image is small
                // compared with the viewport.
                let pixels = self.image().width().max(self.image().height());
                (x - y).abs().max_element() <= ORTHONORMAL_TOLERANCE * size / f64::from(pixels)
            }
            (Value::Number(x), Wanted::Negative) => x < 0.0,
            (Value::Number(x), Wanted::Positive) => x > 0.0,
            (Value::Uv(uv), Wanted::LeftAndUp) => uv.x <= 0.0 && uv.y >= 0.0,
            _ => false,
        };
        Checked { check, value, wanted, passes }
    }

    fn value_and_wanted(&self, check: Check) -> (Value, Wanted) {
        let (u, v, w) = (self.u(), self.v(), self.w());
        let number = |x: f64, wanted: f64| (Value::Number(x), equal(wanted));
        let uv = |x: DVec2, wanted: DVec2| (Value::Uv(x), Wanted::Equal(Value::Uv(wanted)));
        let viewport = self.right_camera().viewport();
        let (columns, rows) = (f64::from(self.image().width()), f64::from(self.image().height()));
        let first = self.made.uv(0.0, 0.0);
        match check {
            Check::LengthU => number(length(u), 1.0),
            Check::LengthV => number(length(v), 1.0),
            Check::LengthW => number(length(w), 1.0),
            Check::UDotV => number(dot(u, v), 0.0),
            Check::VDotW => number(dot(v, w), 0.0),
            Check::WDotU => number(dot(w, u), 0.0),
            Check::RightHanded => (Value::Number(u.cross(v).dot(w)), Wanted::Positive),
            Check::LooksForwards => (Value::Number(w.dot(unit(self.given.view))), Wanted::Negative),
            Check::UpIsUp => (Value::Number(v.dot(unit(self.given.up))), Wanted::Positive),
            Check::ViewportAtDistance => {
                number(-self.direction_at(DVec2::ZERO).dot(w), viewport.distance)
            }
            Check::TopLeft => (Value::Uv(first), Wanted::LeftAndUp),
            Check::StepRight => {
                uv(self.made.uv(0.0, 1.0) - first, DVec2::new(viewport.width / columns, 0.0))
            }
            Check::StepDown => {
                uv(self.made.uv(1.0, 0.0) - first, DVec2::new(0.0, -viewport.height / rows))
            }
            Check::CornersBalance => {
                let all = corners(self.image()).map(|pixel| self.uv_of_pixel(pixel));
                uv(0.25 * all.into_iter().sum::<DVec2>(), DVec2::ZERO)
            }
        }
    }
}

fn equal(x: f64) -> Wanted {
    Wanted::Equal(Value::Number(x))
}

/// Returns `a . b`, or exactly 0 if the vectors are perpendicular up to rounding errors, whatever their
/// lengths.
fn dot(a: DVec3, b: DVec3) -> f64 {
    let cosine = unit(a).dot(unit(b));
    if cosine.abs() <= ROUNDING { 0.0 } else { length(a) * length(b) * cosine }
}

/// Upper bound, with a margin, of the rounding error of the cosine of the angle between two vectors of
/// a basis, which is a few times 1e-16. A mistake that tilts a vector by less than this changes no
/// pixel.
const ROUNDING: f64 = 1e-12;
