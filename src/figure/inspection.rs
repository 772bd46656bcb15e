//! A view ray with all its intersections, for the readouts, the overlay and `pinhole inspect`.

use pinhole_core::{
    DVec2, ExactRay, Pixel, PixelOfUv, Ray, ResolvedCamera, Root, Scene, Selection,
};

use crate::concept::Concept;

/// A view ray through the viewport, with all its intersections.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The point (u, v) where the ray passes through the viewport.
    pub uv: DVec2,
    /// The position in the image of the point (u, v); `None` if it lies outside.
    pub image_position: Option<PixelOfUv>,
    /// The view ray, with its direction rounded to `f64`. The intersections are calculated for the
    /// unrounded ray.
    pub ray: Ray,
    /// The roots of all objects, that is, all t at which the ray's line meets them, in ascending order and
    /// including negative ones. A `t` outside the range of `f64` is stored as infinite.
    pub roots: Vec<Root>,
    /// The rank of each root; see [`RankedRoot`](pinhole_core::RankedRoot).
    pub ranks: Vec<u32>,
    /// The distance from the eye to each root's point, which is negative behind the eye.
    pub distances: Vec<f64>,
    /// Index of the first hit in `roots`.
    pub first: Option<usize>,
}

impl Inspection {
    /// Returns the pixels that the ray touches, row by row. The list is empty if the ray passes outside
    /// the image.
    pub fn touched(&self, camera: &ResolvedCamera) -> Vec<Pixel> {
        self.image_position.map_or(Vec::new(), |position| position.touching(camera.image()))
    }

    /// Finds all intersections of the selected view ray. A selected pixel must lie inside the image.
    pub fn new(camera: &ResolvedCamera, scene: &Scene, selection: Selection) -> Inspection {
        let uv = selection.uv(camera);
        let exact = selection.exact_ray(camera).ok();
        let found = exact.as_ref().map_or_else(Vec::new, |ray| scene.ranked_roots_of(ray));
        let roots: Vec<Root> = found.iter().map(|ranked| ranked.root).collect();
        Inspection {
            uv,
            image_position: exact.as_ref().and_then(|_| camera.pixel_of_uv(uv)),
            ray: exact.as_ref().map_or_else(|| camera.ray(uv), ExactRay::rounded),
            ranks: found.iter().map(|ranked| ranked.rank).collect(),
            distances: found.iter().map(|ranked| ranked.distance).collect(),
            // The roots ascend in t, and roots with equal t are in the order of the objects; the first
            // positive one is therefore the first hit.
            first: roots.iter().position(|root| root.t > 0.0),
            roots,
        }
    }

    /// Returns the only pixel that the ray passes through; `None` if it passes outside the image or
    /// through an edge between pixels.
    pub fn pixel(&self) -> Option<Pixel> {
        self.image_position?.only_pixel()
    }

    /// Returns the concept of a root: its object, and its index among that object's roots by ascending t.
    pub fn concept_of(&self, root: &Root) -> Concept {
        let own = self.roots.iter().filter(|other| other.object == root.object);
        let number = own.take_while(|other| other.t < root.t).count() as u8;
        Concept::Root { object: root.object, number }
    }

    /// Returns the root of `object` whose index among that object's roots, by ascending t, is `number`;
    /// `None` if there is none.
    pub fn root_of(&self, object: u32, number: u8) -> Option<&Root> {
        self.index_of(object, number).map(|index| &self.roots[index])
    }

    /// Returns the position in `roots` of the root of `object` whose index among that object's roots is
    /// `number`.
    pub fn index_of(&self, object: u32, number: u8) -> Option<usize> {
        let mut own = (0..self.roots.len()).filter(|k| self.roots[*k].object == object);
        own.nth(number.into())
    }

    /// Explains in a few words why the root at this index of `roots` is, or is not, the first hit.
    pub fn verdict(&self, index: usize) -> &'static str {
        let t = self.roots[index].t;
        match self.first {
            _ if t < 0.0 => "behind the eye: no hit",
            _ if t == 0.0 => "at the eye: no hit",
            Some(first) if first == index => "first hit (smallest t > 0)",
            Some(first) if self.ranks[first] == self.ranks[index] => "the same t, but listed later",
            Some(first) if self.roots[first].t == t && t.is_normal() => {
                "farther than the hit, by less than the digits of t show"
            }
            _ => "beyond the hit",
        }
    }

    /// Explains why the first hit comes first although another object's root is at the same printed t.
    /// Returns `None` if no other object's root is, so that the printed values show it.
    pub fn why_first(&self) -> Option<&'static str> {
        let first = self.first?;
        let tied = |k: usize| self.ranks[k] == self.ranks[first];
        let alike = |k: usize| {
            self.roots[k].t == self.roots[first].t
                && self.roots[k].object != self.roots[first].object
        };
        let mut others = (0..self.roots.len()).filter(|k| alike(*k)).peekable();
        others.peek()?;
        Some(match others.any(tied) {
            true => "of equal ones, the object listed first",
            false if self.roots[first].t.is_normal() => {
                "another is farther by less than the digits of t show"
            }
            false => "another is farther; t is beyond f64's range",
        })
    }

    /// Returns the first hit.
    pub fn first_hit(&self) -> Option<&Root> {
        self.first.map(|index| &self.roots[index])
    }
}
