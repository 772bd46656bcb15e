//! What the Help menu tells: the conventions, and what the program is.

use super::dialog::Dialog;

/// The conventions of the lecture as the program keeps them.
const CONVENTIONS: &str = "\
The camera's basis is right-handed. 𝐮 points right in the image, 𝐯 up in the image, 𝐰 backwards, away \
from the viewport: 𝐰 = −view/|view|, 𝐮 = normalize(up × 𝐰), 𝐯 = 𝐰 × 𝐮.

up is a hint that keeps the camera level. It is not 𝐯.

A view ray is 𝐩 + 𝑡 𝐝 with 𝐩 = eye and 𝐝 = 𝑢 𝐮 + 𝑣 𝐯 − distance 𝐰. 𝐝 is not normalized: 𝑡 = 1 is on the \
viewport, and the distance along the ray is 𝑡 |𝐝|.

Row 0 is on top, column 0 on the left. A pixel's ray goes through its centre: \
𝑢 = width ((column + ½)/W − ½), 𝑣 = height (½ − (row + ½)/H). The course counts from 1: \
The menu View has a switch for that, under Numbers.

A hit is the smallest 𝑡 > 0. Touching a sphere is a hit; a plane parallel to the ray is none. Of objects \
at the same 𝑡, the one listed first is hit.";

/// Returns the dialog with the conventions.
pub(crate) fn conventions() -> Dialog {
    Dialog::message("The lecture's conventions", CONVENTIONS)
}

/// Returns the dialog about the program.
pub(crate) fn about() -> Dialog {
    let text = format!(
        "Version {}\n\nPinhole shows what a pinhole camera sees, and why: how eye, at and up make u, v, w, \
         and how a pixel's ray finds what it hits. Every hit or miss in its pictures is the one \
         that exact arithmetic gives.\n\nLicences: {}. The fonts have their own, which come with the program.",
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_LICENSE"),
    );
    Dialog::message("Pinhole", text)
}
