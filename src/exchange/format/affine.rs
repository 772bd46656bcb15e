//! Affine maps, as scene files put them together.

use pinhole_core::DVec3;

/// `p -> p.x * x + p.y * y + p.z * z + at`: the axes and origin of a frame, in the one around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    pub(crate) x: DVec3,
    pub(crate) y: DVec3,
    pub(crate) z: DVec3,
    pub(crate) at: DVec3,
}

impl Affine {
    pub(crate) const IDENTITY: Affine =
        Affine { x: DVec3::X, y: DVec3::Y, z: DVec3::Z, at: DVec3::ZERO };

    pub(crate) fn translation(by: DVec3) -> Affine {
        Affine { at: by, ..Affine::IDENTITY }
    }

    pub(crate) fn scaling(by: DVec3) -> Affine {
        Affine { x: DVec3::X * by.x, y: DVec3::Y * by.y, z: DVec3::Z * by.z, at: DVec3::ZERO }
    }

    /// About an axis, anticlockwise where it points at the viewer; the angle in degrees.
    pub(crate) fn rotation(degrees: f64, axis: DVec3) -> Option<Affine> {
        let axis = axis.try_normalize()?;
        let (sin, cos) = degrees.to_radians().sin_cos();
        // Rodrigues' formula.
        let turned = |v: DVec3| cos * v + sin * axis.cross(v) + (1.0 - cos) * axis.dot(v) * axis;
        Some(Affine {
            x: turned(DVec3::X),
            y: turned(DVec3::Y),
            z: turned(DVec3::Z),
            at: DVec3::ZERO,
        })
    }

    /// Makes a map of 16 numbers, column after column; `None` of any other count, or where the last row is not
    /// 0 0 0 1.
    pub(crate) fn from_columns(m: &[f64]) -> Option<Affine> {
        let column = |k: usize| DVec3::new(m[4 * k], m[4 * k + 1], m[4 * k + 2]);
        let is_affine = m.len() == 16 && [m[3], m[7], m[11]] == [0.0; 3] && m[15] == 1.0;
        is_affine.then(|| Affine { x: column(0), y: column(1), z: column(2), at: column(3) })
    }

    /// Makes a map of 12 or 16 numbers, row after row; `None` of any other count, or where the last row is not
    /// 0 0 0 1.
    pub(crate) fn from_rows(m: &[f64]) -> Option<Affine> {
        let is_affine = match m.len() {
            12 => true,
            16 => m[12..] == [0.0, 0.0, 0.0, 1.0],
            _ => false,
        };
        let column = |k: usize| DVec3::new(m[k], m[4 + k], m[8 + k]);
        is_affine.then(|| Affine { x: column(0), y: column(1), z: column(2), at: column(3) })
    }

    pub(crate) fn direction(&self, v: DVec3) -> DVec3 {
        v.x * self.x + v.y * self.y + v.z * self.z
    }

    pub(crate) fn point(&self, p: DVec3) -> DVec3 {
        self.direction(p) + self.at
    }

    /// First the other one, then this.
    pub(crate) fn after(&self, inner: &Affine) -> Affine {
        Affine {
            x: self.direction(inner.x),
            y: self.direction(inner.y),
            z: self.direction(inner.z),
            at: self.point(inner.at),
        }
    }

    pub(crate) fn inverse(&self) -> Option<Affine> {
        let (x, y, z) = (self.y.cross(self.z), self.z.cross(self.x), self.x.cross(self.y));
        let volume = self.x.dot(x);
        if !(volume.is_finite() && volume != 0.0) {
            return None;
        }
        // Rows of the inverse, read by columns.
        let (a, b, c) = (x / volume, y / volume, z / volume);
        let inverse = Affine {
            x: DVec3::new(a.x, b.x, c.x),
            y: DVec3::new(a.y, b.y, c.y),
            z: DVec3::new(a.z, b.z, c.z),
            at: DVec3::ZERO,
        };
        Some(Affine { at: -inverse.direction(self.at), ..inverse })
    }

    /// Returns the factor by which it scales, where it does so alike in all directions.
    pub(crate) fn scale(&self) -> Option<f64> {
        let [x, y, z] = [self.x, self.y, self.z].map(DVec3::length);
        let alike = (x - y).abs() <= 1e-9 * x && (x - z).abs() <= 1e-9 * x && x > 0.0;
        let right = |a: DVec3, b: DVec3| a.dot(b).abs() <= 1e-9 * x * x;
        (alike && right(self.x, self.y) && right(self.y, self.z) && right(self.z, self.x))
            .then_some(x)
    }
}
