//! A view ray with all its intersections, as the readouts, the overlay and `pinhole inspect` show
//! it.

use pinhole_core::{
    DVec2, ExactRay, Object, Pixel, PixelOfUv, PlaneTerms, Ray, ResolvedCamera, Root, Scene,
    SphereQuadratic,
};

use crate::model::concept::Concept;
use crate::model::session::Selection;

/// Number of objects whose parts are kept: more than anybody reads.
pub const LISTED_OBJECTS: usize = 12;

/// The numbers that decide hit or miss for one object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObjectTerms {
    /// a, b, c and D.
    Sphere(SphereQuadratic),
    /// `n . d` and `n . (point - p)`.
    Plane(PlaneTerms),
}

/// A view ray through the viewport, with everything that it meets.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The point (u, v) where the ray passes through the viewport.
    pub uv: DVec2,
    /// The position of that point in the image; `None` outside the image.
    pub image_position: Option<PixelOfUv>,
    /// The view ray with its direction rounded. The intersections are those of the ray before
    /// rounding.
    pub ray: Ray,
    /// All roots of all objects, by ascending `t`, including negative ones. Every `t` is finite.
    pub roots: Vec<Root>,
    /// The parts of the first [`LISTED_OBJECTS`] objects' intersections.
    pub terms: Vec<ObjectTerms>,
    /// Index of the first hit in `roots`.
    pub first: Option<usize>,
}

impl Inspection {
    /// Inspects the selected view ray. A pixel must lie inside the image.
    pub fn new(camera: &ResolvedCamera, scene: &Scene, selection: Selection) -> Inspection {
        let uv = selection.uv(camera);
        match selection.exact_ray(camera) {
            Ok(exact) => Inspection::of_exact(camera, scene, uv, &exact),
            Err(_) => Inspection {
                uv,
                image_position: None,
                ray: camera.ray(uv),
                roots: Vec::new(),
                terms: Vec::new(),
                first: None,
            },
        }
    }

    fn of_exact(camera: &ResolvedCamera, scene: &Scene, uv: DVec2, exact: &ExactRay) -> Inspection {
        let mut roots = scene.roots_of(exact);
        // A line that is almost parallel to a plane meets it beyond the range of `f64`: drop that
        // root.
        roots.retain(|root| root.t.is_finite());
        // The roots ascend in t, and equal ones follow the order of objects: the rule of the first
        // hit.
        let first = roots.iter().position(|root| root.t > 0.0);
        let terms = scene.objects().take(LISTED_OBJECTS).map(|object| match object {
            Object::Sphere(sphere) => ObjectTerms::Sphere(sphere.quadratic_of(exact)),
            Object::Plane(plane) => ObjectTerms::Plane(plane.terms_of(exact)),
        });
        let (image_position, terms) = (camera.pixel_of_uv(uv), terms.collect());
        Inspection { uv, image_position, ray: exact.rounded(), roots, terms, first }
    }

    /// Returns the only pixel that the ray goes through; `None` outside the image and on an edge
    /// between pixels.
    pub fn pixel(&self) -> Option<Pixel> {
        let PixelOfUv { pixel, column_edge, row_edge } = self.image_position?;
        (column_edge.is_none() && row_edge.is_none()).then_some(pixel)
    }

    /// Returns the concept of a root: its object, and its index among the object's roots by
    /// ascending t.
    pub fn concept_of(&self, root: &Root) -> Concept {
        let own = self.roots.iter().filter(|other| other.object == root.object);
        let number = own.take_while(|other| other.t < root.t).count() as u8;
        Concept::Root { object: root.object, number }
    }

    /// Returns the root of this object with this index.
    pub fn root_of(&self, object: u32, number: u8) -> Option<&Root> {
        self.roots.iter().filter(|root| root.object == object).nth(number.into())
    }

    /// Returns the reason why a root is, or is not, the first hit.
    pub fn verdict(&self, root: &Root) -> &'static str {
        match self.first_hit() {
            _ if root.t < 0.0 => "behind the eye: no hit",
            _ if root.t == 0.0 => "at the eye: no hit",
            Some(hit) if hit.object == root.object && hit.t == root.t => {
                "first hit (smallest t > 0)"
            }
            Some(hit) if hit.t == root.t => "the same t, but listed later",
            _ => "farther than the hit",
        }
    }

    /// Returns the first hit.
    pub fn first_hit(&self) -> Option<&Root> {
        self.first.map(|index| &self.roots[index])
    }
}
