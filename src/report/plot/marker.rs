//! How a method is told from the others: a shape and a colour each, hollow in single precision,
//! filled in double.

use crate::chart::figure::{Figure, Ink, Place, Shape};
pub(crate) use crate::chart::marker::Marker;
use crate::chart::marker::{Outline, RADIUS, marker};

/// Wrong decisions, wherever they are shown.
pub(crate) const WRONG: Ink = [0xb0, 0x00, 0x20];

/// Colours after Okabe and Ito, "Color Universal Design" (2008), which readers who do not see red
/// or green can tell apart; yellow, too light for white paper, is wine instead (Tol 2021).
const MARKERS: [(&str, Marker); 9] = [
    ("ladder", Marker { color: [0x00, 0x00, 0x00], outline: Outline::Star }),
    ("double-double", marker([0x77, 0x77, 0x77], 6, 0.0)),
    ("textbook", marker([0xd5, 0x5e, 0x00], 24, 0.0)),
    ("half-b", marker([0xe6, 0x9f, 0x00], 4, 45.0)),
    ("kahan", marker([0x00, 0x9e, 0x73], 3, 0.0)),
    ("perpendicular", marker([0x00, 0x72, 0xb2], 4, 0.0)),
    ("closest-point", marker([0x56, 0xb4, 0xe9], 3, 180.0)),
    ("recentred", marker([0xcc, 0x79, 0xa7], 5, 0.0)),
    ("lagrange", marker([0x88, 0x22, 0x55], 3, 90.0)),
];

/// A method that came later, in grey.
const STRANGER: Marker = marker([0x44, 0x44, 0x44], 3, 270.0);

/// The mark of a method, by its name without the precision.
pub(crate) fn of(family: &str) -> Marker {
    MARKERS.iter().find(|(name, _)| *name == family).map_or(STRANGER, |(_, marker)| *marker)
}

/// The mark of a method that decided wrong: a ring around its own.
pub(crate) fn ring(figure: &mut Figure, center: Place) {
    figure.shapes.push(Shape::Ring { center, radius: 1.65 * RADIUS, color: WRONG, width: 2.5 });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_methods_look_alike() {
        for (index, (name, marker)) in MARKERS.iter().enumerate() {
            for (other, later) in &MARKERS[index + 1..] {
                assert_ne!(marker.color, later.color, "{name} and {other}");
                assert_ne!(marker.outline, later.outline, "{name} and {other}");
            }
            assert_ne!(*marker, STRANGER, "{name}");
        }
    }
}
