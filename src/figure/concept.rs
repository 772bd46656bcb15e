//! Concepts: the named parts of the scene and of the camera's derivation, such as the eye or up x w. Every
//! line of the derivation is about a concept, and the views can highlight it.

use crate::symbols;

/// A concept with a name: a part of the scene, or a quantity in a camera's derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Concept {
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
    /// The cross product `up x w`, with its two factors and the parallelogram that they span.
    UpCrossW,
    /// The cross product `w x u`, with its two factors and the parallelogram that they span.
    WCrossU,
    /// The viewport's rectangle.
    Viewport,
    /// The distance from the eye to the viewport.
    Distance,
    /// The selected pixel, or the selected point (u, v) of the viewport.
    Pixel,
    /// The component of the ray's direction to the right: u times the basis vector u.
    AlongU,
    /// The component of the ray's direction upwards: v times the basis vector v.
    AlongV,
    /// The component of the ray's direction forwards: -distance times the basis vector w.
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
        /// Index of the point among all points where the line meets this object, by ascending t.
        number: u8,
    },
    /// A step on the way to the t at which the selected ray's line meets an object.
    Equation {
        /// Index of the object.
        object: u32,
        /// The step.
        step: EquationStep,
    },
    /// The normal at the first hit.
    Normal,
}

pinhole_core::texts! {
    /// A step in solving the equation for the t at which a ray's line meets an object.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum EquationStep[1];
    {
        /// Returns what precedes the object's number in the name of such a concept.
        prefix,
    }
    /// The ray is substituted into the object's implicit equation.
    Substitution: "substitution ";
    /// The coordinate along a plane's normal is solved for t.
    Coordinate: "coordinate ";
    /// The vector between the eye and the object: `p - centre` of a sphere, `point - p` of a plane.
    Offset: "offset ";
    /// The square of its length.
    OffsetSquared: "offset squared ";
    /// The coefficients of the equation for t are computed.
    Coefficients: "coefficients ";
    /// The quadratic equation is solved for t.
    Solution: "solution ";
    /// The discriminant of the quadratic equation is computed.
    Discriminant: "discriminant ";
}

/// The concept under the pointer, and which part of the window the pointer is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hovered {
    /// The concept under the pointer.
    pub concept: Concept,
    /// The part of the window where the pointer is.
    pub by: HoverSource,
}

/// A part of the window where the user can point at a concept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoverSource {
    /// The numbers below the views.
    Numbers,
    /// A view. The derivation then scrolls to the concept's line.
    View,
    /// A line of the derivation, or the text next to the plot of f(p + t d).
    Derivation,
}

/// A set of concepts, in which all objects count as one, and so do all points on the ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Concepts(u32);

// Two bits are for concepts with an index.
const _: () = assert!(NAMES.len() + 2 <= u32::BITS as usize);

impl Concepts {
    /// Returns the set with this concept.
    #[must_use]
    pub fn with(self, concept: Concept) -> Concepts {
        Concepts(self.0 | concept.bit())
    }

    /// Returns true if the concept is in the set.
    pub fn contains(self, concept: Concept) -> bool {
        self.0 & concept.bit() != 0
    }

    /// Returns true if the other set has all concepts of this one.
    pub fn is_within(self, other: Concepts) -> bool {
        self.0 & !other.0 == 0
    }
}

/// What the newest line of a derivation is about, and what was spoken of until then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Directed {
    /// The concept of the newest line.
    pub concept: Concept,
    /// Index of the object that a line spoke of last.
    pub object: Option<u32>,
    /// The concepts of all lines so far.
    pub spoken: Concepts,
    /// True if a lesson's step names them, and no line is revealed yet: then none of them is more than the others.
    pub is_of_step: bool,
}

impl Directed {
    /// Returns what a step directs to that names these concepts; `None` if it names none.
    pub fn to(subject: &[Concept]) -> Option<Directed> {
        let concept = *subject.last()?;
        let object = subject.iter().find_map(|concept| concept.object());
        let spoken = subject.iter().copied().fold(Concepts::default(), Concepts::with);
        Some(Directed { concept, object, spoken, is_of_step: true })
    }
}

/// The concepts that need no object's index, each with its name in files and its description.
const NAMES: &[(Concept, &str, &str)] = &[
    (Concept::Eye, "eye", symbols::EYE),
    (Concept::At, "at", symbols::AT),
    (Concept::View, "view", symbols::VIEW),
    (Concept::Up, "up", symbols::UP),
    (Concept::Backwards, "backwards", "−view: backwards, not yet of length 1"),
    (Concept::U, "u", symbols::U),
    (Concept::V, "v", symbols::V),
    (Concept::W, "w", symbols::W),
    (Concept::UpCrossW, "up-cross-w", "up × 𝐰: perpendicular to both"),
    (Concept::WCrossU, "w-cross-u", "𝐰 × 𝐮: perpendicular to both"),
    (Concept::Viewport, "viewport", "viewport: what the image is stretched over"),
    (Concept::Distance, "distance", symbols::DISTANCE),
    (Concept::Pixel, "pixel", "the selected position in the viewport"),
    (Concept::AlongU, "along-u", "𝑢 𝐮: how far to the right"),
    (Concept::AlongV, "along-v", "𝑣 𝐯: how far up"),
    (Concept::AlongW, "along-w", "−distance 𝐰: how far forwards"),
    (Concept::Direction, "direction", symbols::D),
    (Concept::Ray, "ray", "𝐩 + 𝑡 𝐝: the view ray"),
    (Concept::Normal, "normal", symbols::NORMAL),
];

/// The vectors that lead tip to tail along d.
const LEGS: &[Concept] = &[Concept::AlongU, Concept::AlongV, Concept::AlongW];

impl Concept {
    /// Returns the concept with this name in files: `up-cross-w`, `object 0`, `root 0 1` (root 1 of
    /// object 0), or a step on the way to its t, such as `substitution 0`.
    pub fn from_name(name: &str) -> Option<Concept> {
        for step in EquationStep::ALL {
            if let Some(Ok(object)) = name.strip_prefix(step.prefix()).map(str::parse) {
                return Some(Concept::Equation { object, step });
            }
        }
        if let Some(object) = name.strip_prefix("object ") {
            return Some(Concept::Object(object.parse().ok()?));
        }
        if let Some(rest) = name.strip_prefix("root ") {
            let (object, number) = rest.split_once(' ')?;
            return Some(Concept::Root {
                object: object.parse().ok()?,
                number: number.parse().ok()?,
            });
        }
        NAMES.iter().find(|(_, known, _)| *known == name).map(|(concept, ..)| *concept)
    }

    /// Returns the concept's name in files.
    pub fn name(self) -> String {
        match self {
            Concept::Object(object) => format!("object {object}"),
            Concept::Root { object, number } => format!("root {object} {number}"),
            Concept::Equation { object, step } => format!("{}{object}", step.prefix()),
            other => {
                let known = NAMES.iter().find(|(concept, ..)| *concept == other);
                known.map_or("", |(_, name, _)| *name).to_owned()
            }
        }
    }

    /// Returns the names of all concepts without an index.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().map(|(_, name, _)| *name)
    }

    /// Returns the concepts from which this one is made, and which are drawn with it while it is highlighted.
    pub fn made_from(self) -> &'static [Concept] {
        match self {
            Concept::UpCrossW => &[Concept::W],
            Concept::WCrossU => &[Concept::W, Concept::U],
            Concept::Backwards => &[Concept::View],
            leg if leg.is_leg() => LEGS,
            Concept::Equation { step: EquationStep::Offset, .. } => &[Concept::Direction],
            _ => &[],
        }
    }

    /// Returns true for one of the vectors that lead tip to tail along d.
    pub fn is_leg(self) -> bool {
        LEGS.contains(&self)
    }

    /// Returns the concepts out of which this one grows when its line follows theirs, and which stay beside it.
    pub fn grows_from(self) -> &'static [Concept] {
        match self {
            Concept::W => &[Concept::Backwards],
            Concept::U => &[Concept::UpCrossW, Concept::W],
            Concept::V => &[Concept::WCrossU],
            Concept::Direction => LEGS,
            other => other.made_from(),
        }
    }

    /// Returns the concept's bit in a set.
    fn bit(self) -> u32 {
        let named = NAMES.iter().position(|(concept, ..)| *concept == self.in_views());
        1 << match (named, self) {
            (Some(index), _) => index,
            (None, Concept::Root { .. }) => NAMES.len(),
            (None, _) => NAMES.len() + 1,
        }
    }

    /// Returns the concept that the views highlight for this one.
    pub fn in_views(self) -> Concept {
        match self {
            Concept::Equation {
                step: EquationStep::Offset | EquationStep::OffsetSquared, ..
            } => self,
            Concept::Equation { object, .. } => Concept::Object(object),
            other => other,
        }
    }

    /// Returns the index of the object that the concept belongs to.
    pub fn object(self) -> Option<u32> {
        match self {
            Concept::Object(object)
            | Concept::Root { object, .. }
            | Concept::Equation { object, .. } => Some(object),
            _ => None,
        }
    }

    /// Returns the concept's description. `title` maps an object's index to its title, which the
    /// descriptions of objects and roots contain.
    pub fn description(self, title: impl Fn(u32) -> String) -> String {
        match self {
            Concept::Object(object) | Concept::Equation { object, .. } => title(object),
            Concept::Root { object, .. } => format!("where the ray's line meets {}", title(object)),
            other => {
                let found = NAMES.iter().find(|(concept, ..)| *concept == other);
                found.map_or(String::new(), |(.., description)| (*description).to_owned())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_of_a_concept_with_a_description() {
        let numbered = [
            (Concept::Object(7), "object 7"),
            (Concept::Root { object: 2, number: 1 }, "root 2 1"),
            (Concept::Equation { object: 1, step: EquationStep::Discriminant }, "discriminant 1"),
            (
                Concept::Equation { object: 3, step: EquationStep::OffsetSquared },
                "offset squared 3",
            ),
        ];
        for (concept, name) in NAMES.iter().map(|(c, name, _)| (*c, *name)).chain(numbered) {
            assert_eq!((Concept::from_name(name), &concept.name()[..]), (Some(concept), name));
            assert!(!concept.description(|k| format!("sphere {k}")).is_empty());
        }
        for wrong in ["", "nothing", "object", "object x", "root 1", "root 1 x", "discriminant"] {
            assert_eq!(Concept::from_name(wrong), None, "{wrong}");
        }
    }
}
