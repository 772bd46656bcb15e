//! The checks carried out on a camera.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{DVec2, DVec3, ORTHONORMAL_TOLERANCE};

use super::checks::{Check, Checked, Value, Wanted};
use super::wrong_camera::WrongCamera;

impl WrongCamera {
    /// Every check, with this camera's numbers.
    pub fn checks(&self) -> Vec<Checked> {
        Check::ALL.iter().copied().map(|check| self.check(check)).collect()
    }

    /// One check, with this camera's numbers.
    pub fn check(&self, check: Check) -> Checked {
        let (value, wanted) = self.value_and_wanted(check);
        let size = self.right_camera().viewport().width.max(self.right_camera().viewport().height);
        let passes = match (value, wanted) {
            (Value::Number(x), Wanted::Equal(Value::Number(y))) => {
                (x - y).abs() <= ORTHONORMAL_TOLERANCE * y.abs().max(1.0)
            }
            (Value::Uv(x), Wanted::Equal(Value::Uv(y))) => {
                // A pixel of a large image is small beside the viewport: its own size counts.
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
                let (row, column) = (rows - 1.0, columns - 1.0);
                let corners = [(0.0, 0.0), (0.0, column), (row, 0.0), (row, column)];
                let sum: DVec2 =
                    corners.iter().map(|(row, column)| self.made.uv(*row, *column)).sum();
                uv(0.25 * sum, DVec2::ZERO)
            }
        }
    }
}

fn equal(x: f64) -> Wanted {
    Wanted::Equal(Value::Number(x))
}

/// `a . b`; 0 where it is nothing but rounding, however long the vectors are.
fn dot(a: DVec3, b: DVec3) -> f64 {
    let cosine = unit(a).dot(unit(b));
    if cosine.abs() <= ROUNDING { 0.0 } else { length(a) * length(b) * cosine }
}

/// More than rounding makes of the cosine between two vectors of a basis, which is a few times
/// 1e-16; mistakes that tilt a vector by less than this change no pixel.
const ROUNDING: f64 = 1e-12;
