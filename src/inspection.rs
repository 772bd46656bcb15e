//! One ray, looked at closely: what the readouts, the overlay and `pinhole inspect` show.

use pinhole_core::{DVec2, Pixel, PixelOfUv, PosedCamera, Ray, Root, Scene};

/// A view ray through the viewport, with everything that it meets.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// Where the ray passes through the viewport.
    pub uv: DVec2,
    /// Where that is in the image; `None` outside it.
    pub place: Option<PixelOfUv>,
    /// The view ray.
    pub ray: Ray,
    /// Every root of every object, by ascending `t`, negative ones too. All `t` are finite.
    pub roots: Vec<Root>,
    /// Index into `roots` of the first hit.
    pub first: Option<usize>,
}

impl Inspection {
    /// The view ray through a (u, v).
    pub fn of_uv(camera: &PosedCamera, scene: &Scene, uv: DVec2) -> Inspection {
        let ray = camera.ray(uv);
        let mut roots = scene.roots(&ray);
        // A line that is all but parallel to a plane meets it beyond the range of numbers: nowhere.
        roots.retain(|root| root.t.is_finite());
        // By ascending t, equal ones in the order of objects: the first hit's own rule.
        let first = roots.iter().position(|root| root.t > 0.0);
        Inspection { uv, place: camera.pixel_of_uv(uv), ray, roots, first }
    }

    /// The view ray through a pixel's centre.
    pub fn of_pixel(camera: &PosedCamera, scene: &Scene, pixel: Pixel) -> Inspection {
        Inspection::of_uv(camera, scene, camera.uv_of_pixel(pixel))
    }

    /// The one pixel that the ray goes through; `None` outside the image and on an edge between
    /// pixels.
    pub fn pixel(&self) -> Option<Pixel> {
        let PixelOfUv { pixel, column_edge, row_edge } = self.place?;
        (column_edge.is_none() && row_edge.is_none()).then_some(pixel)
    }

    /// The first hit.
    pub fn first_hit(&self) -> Option<&Root> {
        self.first.map(|index| &self.roots[index])
    }
}
