//! The concepts of the scene and of the camera's derivation: a line of the derivation is about one,
//! and a view shows it.

use crate::model::symbols;

/// A named concept of the scene or of a camera's derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Thing {
    /// The camera's position.
    Eye,
    /// The point the camera looks at.
    At,
    /// The view direction.
    View,
    /// The up vector as given.
    Up,
    /// `-view`: the backward direction, before it is normalized to w.
    Backwards,
    /// The basis vector u: right in the image.
    U,
    /// The basis vector v: up in the image.
    V,
    /// The basis vector w: backwards.
    W,
    /// `up x w`, with its two factors and the parallelogram that they span.
    UpCrossW,
    /// `w x u`, with its two factors and the parallelogram that they span.
    WCrossU,
    /// The viewport's rectangle.
    Viewport,
    /// The distance from the eye to the viewport.
    Distance,
    /// The selected pixel, or the selected point (u, v) of the viewport.
    Pixel,
    /// `u U`: the component of the direction to the right.
    AlongU,
    /// `v V`: the component of the direction upwards.
    AlongV,
    /// `-distance W`: the component of the direction forwards.
    AlongW,
    /// The direction of the selected ray: from the eye to the viewport.
    Direction,
    /// The selected ray.
    Ray,
    /// An object of the scene.
    Object(u32),
    /// A point where the selected ray's line meets an object.
    Root {
        /// Index of the object.
        object: u32,
        /// Index of the root among the object's roots, by ascending t.
        number: u8,
    },
    /// The normal at the first hit.
    Normal,
}

/// The concept that is hovered, and the place where it is hovered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pointed {
    /// The hovered concept.
    pub thing: Thing,
    /// The place where it is hovered.
    pub by: Pointing,
}

/// A place where a concept is hovered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pointing {
    /// A view: the derivation scrolls to the concept's line.
    View,
    /// A line of the derivation, or the text beside the plot.
    Ledger,
}

/// The concepts without a number, with their names in files and their descriptions.
const NAMES: [(Thing, &str, &str); 19] = [
    (Thing::Eye, "eye", symbols::EYE),
    (Thing::At, "at", symbols::AT),
    (Thing::View, "view", symbols::VIEW),
    (Thing::Up, "up", symbols::UP),
    (Thing::Backwards, "backwards", "−view: backwards, not yet of length 1"),
    (Thing::U, "u", symbols::U),
    (Thing::V, "v", symbols::V),
    (Thing::W, "w", symbols::W),
    (Thing::UpCrossW, "up-cross-w", "up × 𝐰: at right angles to both"),
    (Thing::WCrossU, "w-cross-u", "𝐰 × 𝐮: at right angles to both"),
    (Thing::Viewport, "viewport", "viewport: what the image is stretched over"),
    (Thing::Distance, "distance", symbols::DISTANCE),
    (Thing::Pixel, "pixel", "the selected place in the viewport"),
    (Thing::AlongU, "along-u", "𝑢 𝐮: how far to the right"),
    (Thing::AlongV, "along-v", "𝑣 𝐯: how far up"),
    (Thing::AlongW, "along-w", "−distance 𝐰: how far forwards"),
    (Thing::Direction, "direction", symbols::D),
    (Thing::Ray, "ray", "𝐩 + 𝑡 𝐝: the view ray"),
    (Thing::Normal, "normal", symbols::NORMAL),
];

impl Thing {
    /// Returns the concept with this name in files: `up-cross-w`, `object 0`, or `root 0 1` (root 1
    /// of object 0).
    pub fn from_name(name: &str) -> Option<Thing> {
        if let Some(object) = name.strip_prefix("object ") {
            return Some(Thing::Object(object.parse().ok()?));
        }
        if let Some(rest) = name.strip_prefix("root ") {
            let (object, number) = rest.split_once(' ')?;
            return Some(Thing::Root {
                object: object.parse().ok()?,
                number: number.parse().ok()?,
            });
        }
        NAMES.iter().find(|(_, known, _)| *known == name).map(|(thing, ..)| *thing)
    }

    /// Returns the names of all concepts without a number.
    pub fn names() -> [&'static str; 19] {
        NAMES.map(|(_, name, _)| name)
    }

    /// Returns the concept's name in files.
    pub fn name(self) -> String {
        match self {
            Thing::Object(object) => format!("object {object}"),
            Thing::Root { object, number } => format!("root {object} {number}"),
            other => other.entry().0.to_owned(),
        }
    }

    /// Returns the concept's description; that of an object or a root contains the object's
    /// `title`.
    pub fn words(self, title: impl Fn(u32) -> String) -> String {
        match self {
            Thing::Object(object) => title(object),
            Thing::Root { object, .. } => format!("where the ray's line meets {}", title(object)),
            other => other.entry().1.to_owned(),
        }
    }

    fn entry(self) -> (&'static str, &'static str) {
        let found = NAMES.iter().find(|(thing, ..)| *thing == self);
        found.map_or(("", ""), |(_, name, words)| (name, words))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back_to_their_things() {
        let numbered = [Thing::Object(7), Thing::Root { object: 2, number: 1 }];
        for thing in NAMES.iter().map(|(thing, ..)| *thing).chain(numbered) {
            assert_eq!(Thing::from_name(&thing.name()), Some(thing));
            assert!(!thing.words(|k| format!("sphere {k}")).is_empty());
        }
        for wrong in ["", "nothing", "object", "object x", "root 1", "root 1 x"] {
            assert_eq!(Thing::from_name(wrong), None, "{wrong}");
        }
    }
}
