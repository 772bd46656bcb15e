//! One ray, looked at closely: what the readouts, the overlay and `pinhole inspect` show.

use pinhole_core::{
    DVec2, ExactRay, Object, Pixel, PixelOfUv, PlaneTerms, Ray, ResolvedCamera, Root, Scene,
    SphereQuadratic,
};

use crate::thing::Thing;

/// How many objects' parts are kept: more than anybody reads.
pub const LISTED_OBJECTS: usize = 12;

/// The numbers that decide hit or miss for one object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parts {
    /// a, b, c and D.
    Sphere(SphereQuadratic),
    /// `n . d` and `n . (point - p)`.
    Plane(PlaneTerms),
}

/// A view ray through the viewport, with everything that it meets.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// Where the ray passes through the viewport.
    pub uv: DVec2,
    /// Where that is in the image; `None` outside it.
    pub place: Option<PixelOfUv>,
    /// The view ray, its direction rounded. What it meets is that of the ray before rounding.
    pub ray: Ray,
    /// Every root of every object, by ascending `t`, negative ones too. All `t` are finite.
    pub roots: Vec<Root>,
    /// The parts of the first [`LISTED_OBJECTS`] objects' intersections.
    pub parts: Vec<Parts>,
    /// Index into `roots` of the first hit.
    pub first: Option<usize>,
}

impl Inspection {
    /// The view ray through a (u, v).
    pub fn of_uv(camera: &ResolvedCamera, scene: &Scene, uv: DVec2) -> Inspection {
        match camera.exact_ray_at(uv) {
            Ok(exact) => Inspection::of_exact(camera, scene, uv, &exact),
            Err(_) => Inspection {
                uv,
                place: None,
                ray: camera.ray(uv),
                roots: Vec::new(),
                parts: Vec::new(),
                first: None,
            },
        }
    }

    /// The view ray through a pixel's centre.
    pub fn of_pixel(camera: &ResolvedCamera, scene: &Scene, pixel: Pixel) -> Inspection {
        Inspection::of_exact(camera, scene, camera.uv_of_pixel(pixel), &camera.exact_ray(pixel))
    }

    fn of_exact(camera: &ResolvedCamera, scene: &Scene, uv: DVec2, exact: &ExactRay) -> Inspection {
        let mut roots = scene.roots_of(exact);
        // A line that is all but parallel to a plane meets it beyond the range of numbers: nowhere.
        roots.retain(|root| root.t.is_finite());
        // By ascending t, equal ones in the order of objects: the first hit's own rule.
        let first = roots.iter().position(|root| root.t > 0.0);
        let parts = scene.objects().take(LISTED_OBJECTS).map(|object| match object {
            Object::Sphere(sphere) => Parts::Sphere(sphere.quadratic_of(exact)),
            Object::Plane(plane) => Parts::Plane(plane.terms_of(exact)),
        });
        let (place, parts) = (camera.pixel_of_uv(uv), parts.collect());
        Inspection { uv, place, ray: exact.rounded(), roots, parts, first }
    }

    /// The one pixel that the ray goes through; `None` outside the image and on an edge between
    /// pixels.
    pub fn pixel(&self) -> Option<Pixel> {
        let PixelOfUv { pixel, column_edge, row_edge } = self.place?;
        (column_edge.is_none() && row_edge.is_none()).then_some(pixel)
    }

    /// A root's name: its place among those of its object, by ascending t.
    pub fn thing_of(&self, root: &Root) -> Thing {
        let own = self.roots.iter().filter(|other| other.object == root.object);
        let number = own.take_while(|other| other.t < root.t).count() as u8;
        Thing::Root { object: root.object, number }
    }

    /// The root that has this name.
    pub fn root_of(&self, object: u32, number: u8) -> Option<&Root> {
        self.roots.iter().filter(|root| root.object == object).nth(number.into())
    }

    /// Why one of the roots is, or is not, what the ray hits.
    pub fn verdict(&self, root: &Root) -> &'static str {
        match self.first_hit() {
            _ if root.t < 0.0 => "behind the eye: no hit",
            _ if root.t == 0.0 => "at the eye: no hit",
            Some(hit) if hit.object == root.object && hit.t == root.t => {
                "the hit: the smallest t > 0 of all"
            }
            Some(hit) if hit.t == root.t => "the same t, but listed later",
            _ => "farther than the hit",
        }
    }

    /// The first hit.
    pub fn first_hit(&self) -> Option<&Root> {
        self.first.map(|index| &self.roots[index])
    }
}
