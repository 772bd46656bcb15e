//! The sections of the derivation, each of which can be hidden.

use serde::{Deserialize, Serialize};

/// A section of the derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[repr(u8)]
pub enum LedgerSection {
    /// The steps from view and up to u, v, w.
    Basis,
    /// The steps from a pixel to its view ray.
    PixelToRay,
    /// The intersection of every object with that ray.
    Objects,
}

impl LedgerSection {
    /// All sections, from top to bottom.
    pub const ALL: [LedgerSection; 3] =
        [LedgerSection::Basis, LedgerSection::PixelToRay, LedgerSection::Objects];

    /// Returns the section's name in files.
    pub fn name(self) -> &'static str {
        match self {
            LedgerSection::Basis => "basis",
            LedgerSection::PixelToRay => "pixel-to-ray",
            LedgerSection::Objects => "objects",
        }
    }

    /// Returns the section with this name.
    pub fn from_name(name: &str) -> Option<LedgerSection> {
        LedgerSection::ALL.into_iter().find(|section| section.name() == name)
    }

    /// Returns the label of the section's checkbox.
    pub fn label(self) -> &'static str {
        match self {
            LedgerSection::Basis => "Basis",
            LedgerSection::PixelToRay => "Pixel to ray",
            LedgerSection::Objects => "Objects",
        }
    }

    fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// The sections of the derivation that are shown; all of them by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Vec<LedgerSection>", into = "Vec<LedgerSection>")]
pub struct LedgerSections(u8);

impl Default for LedgerSections {
    fn default() -> Self {
        LedgerSection::ALL.into_iter().collect()
    }
}

impl FromIterator<LedgerSection> for LedgerSections {
    fn from_iter<I: IntoIterator<Item = LedgerSection>>(sections: I) -> Self {
        LedgerSections(sections.into_iter().fold(0, |bits, section| bits | section.bit()))
    }
}

impl From<Vec<LedgerSection>> for LedgerSections {
    fn from(sections: Vec<LedgerSection>) -> Self {
        sections.into_iter().collect()
    }
}

impl From<LedgerSections> for Vec<LedgerSection> {
    fn from(sections: LedgerSections) -> Self {
        LedgerSection::ALL.into_iter().filter(|section| sections.shows(*section)).collect()
    }
}

impl LedgerSections {
    /// Returns true if the section is shown.
    pub fn shows(self, section: LedgerSection) -> bool {
        self.0 & section.bit() != 0
    }

    /// Shows or hides a section.
    pub fn set(&mut self, section: LedgerSection, shown: bool) {
        if shown {
            self.0 |= section.bit();
        } else {
            self.0 &= !section.bit();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_are_shown_alone_and_have_names() {
        for section in LedgerSection::ALL {
            assert_eq!(LedgerSection::from_name(section.name()), Some(section));
            let only: LedgerSections = [section].into_iter().collect();
            assert!(LedgerSection::ALL.iter().all(|s| only.shows(*s) == (*s == section)));
            let mut others = LedgerSections::default();
            others.set(section, false);
            assert_eq!(Vec::from(others).len(), 2);
            assert!(!others.shows(section));
        }
    }
}
