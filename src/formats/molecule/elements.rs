//! The elements: how an atom is drawn.

use pinhole_core::Rgb;

/// An element as a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// Its symbol, as `Cl`.
    pub symbol: &'static str,
    /// Its colour in the scheme that goes back to Corey, Pauling and Koltun's wooden models, with
    /// the values of Jmol's table (jmol.sourceforge.net/jscolors).
    pub color: Rgb,
    /// Its van der Waals radius in ångström. Of non-metals from Bondi, *van der Waals Volumes and
    /// Radii*, J. Phys. Chem. 68, 1964, table I, who gives all of organic chemistry; of the others
    /// from Alvarez, *A cartography of the van der Waals territories*, Dalton Trans. 42, 2013,
    /// table 1. Of which neither has one: [`UNKNOWN_RADIUS`].
    pub radius: f64,
}

/// Of an element that nobody has measured: about that of the others, in ångström.
pub const UNKNOWN_RADIUS: f64 = 2.0;

const fn element(symbol: &'static str, color: u32, radius: f64) -> Element {
    let [_, r, g, b] = color.to_be_bytes();
    Element { symbol, color: [r, g, b], radius }
}

/// Of an atom that is none of an element, such as a dummy atom: grey.
pub const UNKNOWN: Element = element("X", 0x808080, UNKNOWN_RADIUS);

/// By atomic number, from hydrogen.
const ELEMENTS: [Element; 109] = [
    element("H", 0xffffff, 1.20),
    element("He", 0xd9ffff, 1.40),
    element("Li", 0xcc80ff, 2.12),
    element("Be", 0xc2ff00, 1.98),
    element("B", 0xffb5b5, 1.91),
    element("C", 0x909090, 1.70),
    element("N", 0x3050f8, 1.55),
    element("O", 0xff0d0d, 1.52),
    element("F", 0x90e050, 1.47),
    element("Ne", 0xb3e3f5, 1.54),
    element("Na", 0xab5cf2, 2.50),
    element("Mg", 0x8aff00, 2.51),
    element("Al", 0xbfa6a6, 2.25),
    element("Si", 0xf0c8a0, 2.10),
    element("P", 0xff8000, 1.80),
    element("S", 0xffff30, 1.80),
    element("Cl", 0x1ff01f, 1.75),
    element("Ar", 0x80d1e3, 1.88),
    element("K", 0x8f40d4, 2.73),
    element("Ca", 0x3dff00, 2.62),
    element("Sc", 0xe6e6e6, 2.58),
    element("Ti", 0xbfc2c7, 2.46),
    element("V", 0xa6a6ab, 2.42),
    element("Cr", 0x8a99c7, 2.45),
    element("Mn", 0x9c7ac7, 2.45),
    element("Fe", 0xe06633, 2.44),
    element("Co", 0xf090a0, 2.40),
    element("Ni", 0x50d050, 2.40),
    element("Cu", 0xc88033, 2.38),
    element("Zn", 0x7d80b0, 2.39),
    element("Ga", 0xc28f8f, 2.32),
    element("Ge", 0x668f8f, 2.29),
    element("As", 0xbd80e3, 1.85),
    element("Se", 0xffa100, 1.90),
    element("Br", 0xa62929, 1.85),
    element("Kr", 0x5cb8d1, 2.02),
    element("Rb", 0x702eb0, 3.21),
    element("Sr", 0x00ff00, 2.84),
    element("Y", 0x94ffff, 2.75),
    element("Zr", 0x94e0e0, 2.52),
    element("Nb", 0x73c2c9, 2.56),
    element("Mo", 0x54b5b5, 2.45),
    element("Tc", 0x3b9e9e, 2.44),
    element("Ru", 0x248f8f, 2.46),
    element("Rh", 0x0a7d8c, 2.44),
    element("Pd", 0x006985, 2.15),
    element("Ag", 0xc0c0c0, 2.53),
    element("Cd", 0xffd98f, 2.49),
    element("In", 0xa67573, 2.43),
    element("Sn", 0x668080, 2.42),
    element("Sb", 0x9e63b5, 2.47),
    element("Te", 0xd47a00, 2.06),
    element("I", 0x940094, 1.98),
    element("Xe", 0x429eb0, 2.16),
    element("Cs", 0x57178f, 3.48),
    element("Ba", 0x00c900, 3.03),
    element("La", 0x70d4ff, 2.98),
    element("Ce", 0xffffc7, 2.88),
    element("Pr", 0xd9ffc7, 2.92),
    element("Nd", 0xc7ffc7, 2.95),
    element("Pm", 0xa3ffc7, UNKNOWN_RADIUS),
    element("Sm", 0x8fffc7, 2.90),
    element("Eu", 0x61ffc7, 2.87),
    element("Gd", 0x45ffc7, 2.83),
    element("Tb", 0x30ffc7, 2.79),
    element("Dy", 0x1fffc7, 2.87),
    element("Ho", 0x00ff9c, 2.81),
    element("Er", 0x00e675, 2.83),
    element("Tm", 0x00d452, 2.79),
    element("Yb", 0x00bf38, 2.80),
    element("Lu", 0x00ab24, 2.74),
    element("Hf", 0x4dc2ff, 2.63),
    element("Ta", 0x4da6ff, 2.53),
    element("W", 0x2194d6, 2.57),
    element("Re", 0x267dab, 2.49),
    element("Os", 0x266696, 2.48),
    element("Ir", 0x175487, 2.41),
    element("Pt", 0xd0d0e0, 2.29),
    element("Au", 0xffd123, 2.32),
    element("Hg", 0xb8b8d0, 2.45),
    element("Tl", 0xa6544d, 2.47),
    element("Pb", 0x575961, 2.60),
    element("Bi", 0x9e4fb5, 2.54),
    element("Po", 0xab5c00, UNKNOWN_RADIUS),
    element("At", 0x754f45, UNKNOWN_RADIUS),
    element("Rn", 0x428296, UNKNOWN_RADIUS),
    element("Fr", 0x420066, UNKNOWN_RADIUS),
    element("Ra", 0x007d00, UNKNOWN_RADIUS),
    element("Ac", 0x70abfa, 2.80),
    element("Th", 0x00baff, 2.93),
    element("Pa", 0x00a1ff, 2.88),
    element("U", 0x008fff, 2.71),
    element("Np", 0x0080ff, 2.82),
    element("Pu", 0x006bff, 2.81),
    element("Am", 0x545cf2, 2.83),
    element("Cm", 0x785ce3, 3.05),
    element("Bk", 0x8a4fe3, 3.40),
    element("Cf", 0xa136d4, 3.05),
    element("Es", 0xb31fd4, 2.70),
    element("Fm", 0xb31fba, UNKNOWN_RADIUS),
    element("Md", 0xb30da6, UNKNOWN_RADIUS),
    element("No", 0xbd0d87, UNKNOWN_RADIUS),
    element("Lr", 0xc70066, UNKNOWN_RADIUS),
    element("Rf", 0xcc0059, UNKNOWN_RADIUS),
    element("Db", 0xd1004f, UNKNOWN_RADIUS),
    element("Sg", 0xd90045, UNKNOWN_RADIUS),
    element("Bh", 0xe00038, UNKNOWN_RADIUS),
    element("Hs", 0xe6002e, UNKNOWN_RADIUS),
    element("Mt", 0xeb0026, UNKNOWN_RADIUS),
];

/// The element of a symbol, in small letters or large ones; of deuterium and tritium, hydrogen.
pub fn of_symbol(symbol: &str) -> Option<&'static Element> {
    let symbol = if matches!(symbol, "D" | "T") { "H" } else { symbol };
    ELEMENTS.iter().find(|element| element.symbol.eq_ignore_ascii_case(symbol))
}

/// The element of an atomic number, as `6`.
pub fn of_number(number: usize) -> Option<&'static Element> {
    ELEMENTS.get(number.checked_sub(1)?)
}

/// The element of an atom's label: of the letters with which it begins, as in `C12`, and force fields'
/// `C_3` and `C.ar`; [`UNKNOWN`] of other letters, as in `Xx` and `DU`, and `None` of no letter.
pub fn of_label(label: &str) -> Option<&'static Element> {
    let end = label.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(label.len());
    match &label[..end] {
        "" => None,
        letters => Some(of_symbol(letters).unwrap_or(&UNKNOWN)),
    }
}
