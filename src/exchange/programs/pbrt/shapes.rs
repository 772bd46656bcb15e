//! A pbrt scene's spheres and the colours of their materials, and what is left out.

use std::collections::HashMap;

use pinhole_core::Sphere;

use super::tokens::Parameters;
use crate::document::Item;
use crate::format::Input;
use crate::format::affine::Affine;
use crate::format::left_out::{LeftOut, readable};
use crate::format::text::byte_of_light;

/// A material's colour, as far as it gives one.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Paint {
    /// Colour of a shape without a material.
    Unsaid,
    Plain([u8; 3]),
    /// A texture, a spectrum, a metal.
    Unread,
}

impl Paint {
    pub(super) fn from_parameters(parameters: &Parameters) -> Paint {
        // Kd is what pbrt-v3 calls it.
        let light = parameters.color("reflectance").or_else(|| parameters.color("Kd"));
        light.map_or(Paint::Unread, |light| Paint::Plain(light.map(byte_of_light)))
    }
}

#[derive(Default)]
pub(super) struct Shapes<'t> {
    pub(super) spheres: Vec<Item<Sphere>>,
    pub(super) left: LeftOut,
    materials: HashMap<&'t str, Paint>,
    /// Faults of spheres whose numbers are wrong, each with its byte.
    faults: Vec<(usize, String)>,
    unpainted: usize,
}

impl<'t> Shapes<'t> {
    pub(super) fn name_material(&mut self, parameters: &Parameters<'t>) {
        if let Some(name) = parameters.kind {
            self.materials.insert(name, Paint::from_parameters(parameters));
        }
    }

    pub(super) fn material(&self, name: Option<&str>) -> Paint {
        name.and_then(|name| self.materials.get(name)).copied().unwrap_or(Paint::Unread)
    }

    /// Takes a sphere, and counts any other shape.
    pub(super) fn take(
        &mut self,
        at: usize,
        parameters: &Parameters,
        transform: &Affine,
        paint: Paint,
    ) {
        let kind = parameters.kind.unwrap_or("shape");
        if kind != "sphere" {
            return self.left.add(kind, "left out: Pinhole has spheres and planes");
        }
        let radius = parameters.number("radius").unwrap_or(1.0);
        let given = |name: &str, or: f64| parameters.number(name).unwrap_or(or);
        let is_whole = given("zmin", -radius) <= -radius
            && given("zmax", radius) >= radius
            && given("phimax", 360.0) >= 360.0;
        if !is_whole {
            let said = "left out with zmin, zmax or phimax: Pinhole has whole spheres";
            return self.left.add(kind, said);
        }
        let Some(scale) = transform.scale() else {
            return self.left.add(kind, "left out: scaled to an ellipsoid");
        };
        let radius = radius * scale;
        if !(radius > 0.0 && radius.is_finite() && transform.at.is_finite()) {
            let problem = match radius > 0.0 {
                true => "its numbers must be finite".to_owned(),
                false => format!("radius is {radius}: it must be greater than 0"),
            };
            return self.faults.push((at, problem));
        }
        let color = match paint {
            Paint::Plain(color) => Some(color),
            Paint::Unsaid => None,
            Paint::Unread => {
                self.unpainted += 1;
                None
            }
        };
        let shape = Sphere { center: transform.at, radius };
        self.spheres.push(Item { name: None, color, shape });
    }

    /// Notes what was left out.
    pub(super) fn tell(&mut self, text: &Input, notes: &mut Vec<String>) {
        let faults = self.faults.drain(..);
        let faults = faults.map(|(at, problem)| Err::<(), _>(text.error_at(at, problem)));
        readable(faults, "sphere", notes);
        self.left.tell(notes);
        if self.unpainted > 0 {
            notes.push(format!(
                "{} of Material left out: a colour must be \"rgb reflectance\"",
                self.unpainted
            ));
        }
    }
}
