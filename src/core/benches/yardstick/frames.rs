//! The buffers into which all contestants but `pinhole-core` write a frame, and the pixels' rays,
//! computed in `f32` as in textbooks.

use glam::Vec3;
use pinhole_core::{ImageSize, NO_OBJECT, ResolvedCamera};

/// t and object of every pixel, row by row from the top.
#[derive(Clone, Debug)]
pub(crate) struct Buffers {
    /// Columns.
    pub(crate) width: usize,
    /// t of the first hit; infinite if there is none.
    pub(crate) t: Vec<f32>,
    /// The object hit, or [`NO_OBJECT`].
    pub(crate) object: Vec<u32>,
}

impl Buffers {
    /// Creates the buffers of an image. It writes to all their memory, so that no page faults occur
    /// while times are measured.
    pub(crate) fn new(image: ImageSize) -> Buffers {
        let width = image.width() as usize;
        let pixels = width * image.height() as usize;
        Buffers { width, t: vec![f32::INFINITY; pixels], object: vec![NO_OBJECT; pixels] }
    }
}

/// The view rays of a frame in `f32`.
pub(crate) struct Rays {
    pub(crate) eye: Vec3,
    u: Vec3,
    v: Vec3,
    /// `-distance*W`
    ahead: Vec3,
    width: f32,
    height: f32,
    columns: f32,
    rows: f32,
}

impl Rays {
    pub(crate) fn new(camera: &ResolvedCamera) -> Rays {
        let (basis, viewport, image) = (camera.basis(), camera.viewport(), camera.image());
        Rays {
            eye: camera.eye().as_vec3(),
            u: basis.u.as_vec3(),
            v: basis.v.as_vec3(),
            ahead: (-viewport.distance * basis.w).as_vec3(),
            width: viewport.width as f32,
            height: viewport.height as f32,
            columns: image.width() as f32,
            rows: image.height() as f32,
        }
    }

    /// Returns four vectors, which determine all rays, as twelve numbers: the eye, the direction of
    /// pixel (0, 0), and the change of the direction per column and per row.
    pub(crate) fn numbers(&self) -> [f32; 12] {
        let (column, row) = (self.width / self.columns * self.u, -self.height / self.rows * self.v);
        let vectors = [self.eye, self.direction(0, 0), column, row].map(|vector| vector.to_array());
        std::array::from_fn(|k| vectors[k / 3][k % 3])
    }

    /// Returns `u*U + v*V - distance*W` for a pixel's centre.
    #[inline]
    pub(crate) fn direction(&self, row: usize, column: usize) -> Vec3 {
        let u = self.width * ((column as f32 + 0.5) / self.columns - 0.5);
        let v = self.height * (0.5 - (row as f32 + 0.5) / self.rows);
        u * self.u + v * self.v + self.ahead
    }
}
