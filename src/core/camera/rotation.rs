//! A basis as a rotation: its unit quaternion, and what is wrong with three vectors that are almost
//! one.

use glam::{DMat3, DQuat, DVec3};

use crate::camera::basis::Basis;
use crate::exact::scale::unit;

impl Basis {
    /// The rotation `[w, x, y, z]` that takes x to u, y to v and z to w: from camera to world. Of the
    /// two unit quaternions, the one whose w is not negative.
    ///
    /// (S. W. Shepperd, *Quaternion from rotation matrix*, J. Guidance and Control 1, 1978.)
    pub fn quaternion(&self) -> [f64; 4] {
        let q = DQuat::from_mat3(&DMat3::from_cols(self.u, self.v, self.w)).normalize();
        let q = if q.w < 0.0 { -q } else { q };
        [q.w, q.x, q.y, q.z]
    }

    /// The basis that a quaternion `[w, x, y, z]` of any length turns x, y, z to; `None` for one of
    /// zero, or not finite.
    pub fn of_quaternion([w, x, y, z]: [f64; 4]) -> Option<Basis> {
        let q = DQuat::from_xyzw(x, y, z, w);
        let length = q.length();
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        let turn = DMat3::from_quat(DQuat::from_vec4(glam::DVec4::from(q) / length).normalize());
        Some(Basis { u: turn.x_axis, v: turn.y_axis, w: turn.z_axis })
    }

    /// Returns the distance of three vectors from orthonormal: the largest of `| |a| - 1 |` and
    /// `|a . b|`.
    pub fn error_of(u: DVec3, v: DVec3, w: DVec3) -> f64 {
        let lengths = [u, v, w].map(|a| (a.length() - 1.0).abs());
        let angles = [u.dot(v), v.dot(w), w.dot(u)].map(f64::abs);
        lengths.into_iter().chain(angles).fold(0.0, f64::max)
    }

    /// Returns whether three vectors, unit or not, are left-handed: the picture of a camera that
    /// has them for right, up and backwards is a mirror image.
    pub fn is_left_handed(u: DVec3, v: DVec3, w: DVec3) -> bool {
        let vectors = [u, v, w];
        if vectors.iter().any(|a| !a.is_finite() || *a == DVec3::ZERO) {
            return false;
        }
        let [u, v, w] = vectors.map(unit);
        u.cross(v).dot(w) < 0.0
    }
}
