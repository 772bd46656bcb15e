//! The sections of the derivation, each of which can be hidden.

/// A section of the derivation, from top to bottom, with its label and its name in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum DerivationSection {
    /// The steps from view and up to u, v, w.
    Basis,
    /// The steps from a pixel to its view ray.
    PixelToRay,
    /// The intersection of every object with that ray.
    Objects,
}

impl DerivationSection {
    /// All sections, in order.
    pub const ALL: [DerivationSection; 3] = {
        use DerivationSection::*;
        [Basis, PixelToRay, Objects]
    };

    /// Returns the label of the section's checkbox.
    pub fn label(self) -> &'static str {
        match self {
            DerivationSection::Basis => "Basis",
            DerivationSection::PixelToRay => "Pixel to ray",
            DerivationSection::Objects => "Objects",
        }
    }

    /// Returns the section's name in files.
    pub fn name(self) -> &'static str {
        match self {
            DerivationSection::Basis => "basis",
            DerivationSection::PixelToRay => "pixel-to-ray",
            DerivationSection::Objects => "objects",
        }
    }

    fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// The sections of the derivation that are shown; all of them by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DerivationSections(u8);

impl Default for DerivationSections {
    fn default() -> Self {
        DerivationSection::ALL.into_iter().collect()
    }
}

impl FromIterator<DerivationSection> for DerivationSections {
    fn from_iter<I: IntoIterator<Item = DerivationSection>>(sections: I) -> Self {
        DerivationSections(sections.into_iter().fold(0, |bits, section| bits | section.bit()))
    }
}

impl DerivationSections {
    /// Returns true if the section is shown.
    pub fn shows(self, section: DerivationSection) -> bool {
        self.0 & section.bit() != 0
    }

    /// Shows or hides a section.
    pub fn set(&mut self, section: DerivationSection, shown: bool) {
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
    fn each_section_is_shown_alone() {
        for section in DerivationSection::ALL {
            let only: DerivationSections = [section].into_iter().collect();
            assert!(DerivationSection::ALL.iter().all(|s| only.shows(*s) == (*s == section)));
            let mut others = DerivationSections::default();
            others.set(section, false);
            assert!(DerivationSection::ALL.iter().all(|s| others.shows(*s) != (*s == section)));
        }
    }
}
