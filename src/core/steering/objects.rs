//! The handles of spheres and planes.

use glam::DVec3;

use crate::exact::scale::{length, unit};
use crate::scene::error::ObjectError;
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

impl Sphere {
    /// The sphere with its centre at a point; the radius stays.
    ///
    /// # Errors
    /// Where the sphere is none.
    pub fn with_center(&self, point: DVec3) -> Result<Sphere, ObjectError> {
        Sphere::new(point, self.radius)
    }

    /// The sphere with this centre whose surface passes through a point: `radius = |point - center|`.
    ///
    /// # Errors
    /// Where the point is the centre: the radius is 0.
    pub fn with_surface_through(&self, point: DVec3) -> Result<Sphere, ObjectError> {
        Sphere::new(self.center, length(point - self.center))
    }
}

impl Plane {
    /// The plane with this normal through a point.
    ///
    /// # Errors
    /// Where the plane is none.
    pub fn with_point(&self, point: DVec3) -> Result<Plane, ObjectError> {
        Plane::new(point, self.normal)
    }

    /// The plane moved along its normal until it passes through a point q, its own point with it,
    /// which so keeps its place in the plane: `point' = point + n (n . (q - point)) / (n . n)`.
    ///
    /// # Errors
    /// Where the plane is none, before or after.
    pub fn moved_through(&self, point: DVec3) -> Result<Plane, ObjectError> {
        self.check()?;
        let n = unit(self.normal);
        Plane::new(self.point + n.dot(point - self.point) * n, self.normal)
    }

    /// The plane whose normal, drawn from its point and `scale` times as long as it is, ends at `tip`:
    /// `normal = (tip - point) / scale`.
    ///
    /// # Errors
    /// Where the normal is zero or not finite (as with a scale of 0).
    pub fn with_normal_tip(&self, tip: DVec3, scale: f64) -> Result<Plane, ObjectError> {
        Plane::new(self.point, (tip - self.point) / scale)
    }
}
