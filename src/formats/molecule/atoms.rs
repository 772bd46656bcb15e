//! What both formats make of a file: atoms, and what is said of them.

use std::collections::BTreeMap;

use pinhole_core::{DVec3, Sphere};

use super::elements::{Element, UNKNOWN};
use crate::document::Item;

/// No atom is farther than this from the origin along an axis, in ångström: a tenth of a
/// millimetre. Larger numbers are slips, such as a blank that is missing between two.
const FARTHEST: f64 = 1e6;

/// A molecule's file.
pub(super) struct Molecule {
    /// What the file says of itself.
    pub title: String,
    /// In the file's order.
    pub atoms: Vec<Atom>,
    /// What there is in the file beside them.
    pub left_out: Option<String>,
}

/// An atom.
pub(super) struct Atom {
    pub name: String,
    pub element: &'static Element,
    pub center: DVec3,
}

impl Atom {
    /// The sphere that it is in a scene.
    pub(super) fn item(&self) -> Item<Sphere> {
        let Element { color, radius, .. } = *self.element;
        Item {
            name: Some(self.name.clone()),
            color: Some(color),
            shape: Sphere { center: self.center, radius },
        }
    }
}

impl Molecule {
    /// The scene's note: the title, the formula, and what was left out.
    pub(super) fn note(&self) -> String {
        let title = self.title.split_whitespace().collect::<Vec<_>>().join(" ");
        let atoms = match self.atoms.len() {
            1 => "1 atom".to_owned(),
            count => format!("{count} atoms"),
        };
        let what =
            format!("{atoms}, {}: spheres of van der Waals radius, in ångström.", self.formula());
        let stop = if title.is_empty() || title.ends_with(['.', '!', '?']) { "" } else { "." };
        let unknown = self.atoms.iter().filter(|atom| *atom.element == UNKNOWN).count();
        let unknown = match unknown {
            0 => String::new(),
            1 => "1 atom is of no known element: grey.".to_owned(),
            count => format!("{count} atoms are of no known element: grey."),
        };
        let left_out = self.left_out.clone().unwrap_or_default();
        let parts = [format!("{title}{stop}"), what, unknown, left_out];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("\n")
    }

    /// In Hill's order: carbon, hydrogen, the others by letter; all by letter without carbon (Hill,
    /// J. Am. Chem. Soc. 22, 1900).
    fn formula(&self) -> String {
        let mut counts: BTreeMap<(u8, &str), usize> = BTreeMap::new();
        let has_carbon = self.atoms.iter().any(|atom| atom.element.symbol == "C");
        for Atom { element, .. } in &self.atoms {
            let place = match element.symbol {
                "C" => 0,
                "H" if has_carbon => 1,
                _ => 2,
            };
            *counts.entry((place, element.symbol)).or_default() += 1;
        }
        let part = |((_, symbol), count): (&(u8, &str), &usize)| match count {
            1 => (*symbol).to_owned(),
            count => format!("{symbol}{count}"),
        };
        counts.iter().map(part).collect()
    }
}

/// A coordinate, or what would be right.
pub(super) fn coordinate(text: &str) -> Result<f64, &'static str> {
    match text.parse::<f64>() {
        Ok(x) if x.abs() <= FARTHEST => Ok(x),
        Ok(x) if x.is_finite() => Err("it must be at most a million ångström"),
        Ok(_) => Err("it must be a finite number of ångström"),
        Err(_) => Err("it must be a number of ångström"),
    }
}
