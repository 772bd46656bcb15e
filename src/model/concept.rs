//! What can be pointed at: a line of the ledger is about it, and a view shows it.

use crate::model::symbols;

/// Something in the scene or in a camera's derivation that has a name.
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
    /// `-view`: backwards, before it is normalized to w.
    Backwards,
    /// The basis vector u: right in the image.
    U,
    /// The basis vector v: up in the image.
    V,
    /// The basis vector w: backwards.
    W,
    /// `up x w`, with its two factors and the parallelogram between them.
    UpCrossW,
    /// `w x u`, likewise.
    WCrossU,
    /// The viewport's rectangle.
    Viewport,
    /// From the eye to the viewport.
    Distance,
    /// The selected pixel, or the place (u, v) on the viewport.
    Pixel,
    /// `u U`: the part of the direction to the right.
    AlongU,
    /// `v V`: the part of the direction upwards.
    AlongV,
    /// `-distance W`: the part of the direction forwards.
    AlongW,
    /// The direction of the selected ray: from the eye to the viewport.
    Direction,
    /// The selected ray.
    Ray,
    /// An object of the scene.
    Object(u32),
    /// A place where the selected ray's line meets an object.
    Root {
        /// Which object.
        object: u32,
        /// Which of its roots, by ascending t.
        number: u8,
    },
    /// The normal at the first hit.
    Normal,
}

/// What is pointed at, and where that is done: the other place follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pointed {
    /// At what.
    pub thing: Thing,
    /// Where.
    pub by: Pointing,
}

/// Where something is pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pointing {
    /// In a view: the ledger scrolls to its line.
    View,
    /// At a line of the ledger, or in the words beside the plot.
    Ledger,
}

/// Names of things that have no number, in files, and what is said of them.
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
    /// The thing that has this name in files: `up-cross-w`, `object 0`, `root 0 1` (of object 0 the
    /// root with number 1).
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

    /// The names of all things that have no number.
    pub fn names() -> [&'static str; 19] {
        NAMES.map(|(_, name, _)| name)
    }

    /// Its name in files.
    pub fn name(self) -> String {
        match self {
            Thing::Object(object) => format!("object {object}"),
            Thing::Root { object, number } => format!("root {object} {number}"),
            other => other.entry().0.to_owned(),
        }
    }

    /// What is said of it; of an object or a root by the object's `title`.
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
