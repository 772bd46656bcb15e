//! The sections of the derivation, which is the step-by-step calculation of the camera's and the ray's
//! numbers, and the choice of single lines of it. Each section can be hidden.

use std::sync::Arc;

use crate::Concept;

pinhole_core::texts! {
    /// A section of the derivation. The variants are in their order on the screen, from top to bottom.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum DerivationSection[2];
    {
        /// Returns the label of the section's checkbox.
        label,
        /// Returns the section's name in files.
        name,
    }
    /// The steps from view and up to u, v, w.
    Basis: "Basis", "basis";
    /// The steps from a pixel to its view ray.
    PixelToRay: "Pixel to ray", "pixel-to-ray";
    /// The intersection of the view ray with every object.
    Objects: "Objects", "objects";
}

/// Lines of the derivation that are shown in place of whole sections.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Formulas {
    /// The lines about these concepts.
    About(Arc<[Concept]>),
    /// The first lines about these concepts, as many as each is named times: what leads to the answers of an
    /// exercise.
    Solution(Arc<[Concept]>),
    /// How view, w, u, v, d and the ray come about, in one line each.
    Recap,
}

impl Formulas {
    /// Returns the concepts that are named; none for the recap.
    pub fn concepts(&self) -> &[Concept] {
        match self {
            Formulas::About(concepts) | Formulas::Solution(concepts) => concepts,
            Formulas::Recap => &[],
        }
    }
}

/// Which sections of the derivation are shown: true for a shown section, in the order of
/// [`DerivationSection::ALL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DerivationSections(pub [bool; 3]);

impl Default for DerivationSections {
    /// Shows all sections.
    fn default() -> Self {
        DerivationSections([true; 3])
    }
}

impl DerivationSections {
    /// Returns true if the section is shown.
    pub fn shows(self, section: DerivationSection) -> bool {
        self.0[section as usize]
    }

    /// Shows or hides a section.
    pub fn set(&mut self, section: DerivationSection, shown: bool) {
        self.0[section as usize] = shown;
    }
}
