//! What the overlay draws, each item of which can be switched off.

use serde::{Deserialize, Serialize};

/// One thing that the overlay draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Item {
    /// The camera's position.
    Eye,
    /// The point the camera looks at, where it is given by one.
    At,
    /// The view and up vectors as given.
    ViewAndUp,
    /// The u, v, w arrows.
    Basis,
    /// The frustum's edges.
    Frustum,
    /// The viewport's outline.
    Viewport,
    /// The traced picture, on the viewport in space.
    Picture,
    /// The edges between pixels, in both views.
    PixelGrid,
    /// The marks on the image's top edge and at pixel (0, 0), in both views.
    Marks,
    /// The selected view ray, and its pixel in both views.
    Ray,
    /// The first hit and its normal.
    Hit,
    /// The x, y, z axes at the origin.
    Axes,
    /// The planes, as patches with a grid of world units.
    Planes,
    /// The lines u = 0 and v = 0 in the camera view.
    UvAxes,
    /// The text at all of these.
    Labels,
    /// The pixels around the selected place, magnified, in the camera view.
    Loupe,
    /// What can be taken in the hand in the world view.
    Handles,
}

impl Item {
    /// All of them, in the order in which a panel lists them.
    pub const ALL: [Item; 17] = [
        Item::Eye,
        Item::At,
        Item::ViewAndUp,
        Item::Basis,
        Item::Frustum,
        Item::Viewport,
        Item::Picture,
        Item::PixelGrid,
        Item::Marks,
        Item::Ray,
        Item::Hit,
        Item::Axes,
        Item::Planes,
        Item::UvAxes,
        Item::Labels,
        Item::Loupe,
        Item::Handles,
    ];

    /// What a checkbox for it says.
    pub fn label(self) -> &'static str {
        match self {
            Item::Eye => "eye",
            Item::At => "at",
            Item::ViewAndUp => "view and up",
            Item::Basis => "u, v, w",
            Item::Frustum => "frustum",
            Item::Viewport => "viewport outline",
            Item::Picture => "picture on the viewport",
            Item::PixelGrid => "pixel grid",
            Item::Marks => "top edge and pixel (0, 0)",
            Item::Ray => "selected ray",
            Item::Hit => "hit and normal",
            Item::Axes => "x, y, z axes",
            Item::Planes => "planes",
            Item::UvAxes => "u = 0 and v = 0",
            Item::Labels => "labels",
            Item::Loupe => "loupe",
            Item::Handles => "handles",
        }
    }

    /// What lesson files call it.
    pub fn name(self) -> &'static str {
        match self {
            Item::Eye => "eye",
            Item::At => "at",
            Item::ViewAndUp => "view-and-up",
            Item::Basis => "basis",
            Item::Frustum => "frustum",
            Item::Viewport => "viewport",
            Item::Picture => "picture",
            Item::PixelGrid => "pixel-grid",
            Item::Marks => "marks",
            Item::Ray => "ray",
            Item::Hit => "hit",
            Item::Axes => "axes",
            Item::Planes => "planes",
            Item::UvAxes => "uv-axes",
            Item::Labels => "labels",
            Item::Loupe => "loupe",
            Item::Handles => "handles",
        }
    }

    fn bit(self) -> u32 {
        1 << self as u8
    }
}

/// Which items are drawn.
///
/// Kept as a set of bits, one for each [`Item`] in the order of their declaration; a bit that is
/// not known is ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct OverlayItems {
    off: u32,
}

impl Default for OverlayItems {
    /// All but what would lie over the camera's picture: its axes and the loupe.
    fn default() -> Self {
        OverlayItems { off: Item::UvAxes.bit() | Item::Loupe.bit() }
    }
}

impl OverlayItems {
    /// Nothing at all.
    pub const NONE: OverlayItems = OverlayItems { off: u32::MAX };

    /// Everything.
    pub const ALL: OverlayItems = OverlayItems { off: 0 };

    /// Whether the item is drawn.
    pub fn shows(self, item: Item) -> bool {
        self.off & item.bit() == 0
    }

    /// Switches an item on or off.
    pub fn set(&mut self, item: Item, on: bool) {
        if on {
            self.off &= !item.bit();
        } else {
            self.off |= item.bit();
        }
    }

    /// The same items with one switched on or off.
    #[must_use]
    pub fn with(mut self, item: Item, on: bool) -> OverlayItems {
        self.set(item, on);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_item_is_switched_alone() {
        for item in Item::ALL {
            let only = OverlayItems::NONE.with(item, true);
            assert!(Item::ALL.iter().all(|other| only.shows(*other) == (*other == item)));
            assert_eq!(only.with(item, false), OverlayItems::NONE);
        }
    }

    #[test]
    fn all_but_two_are_on_by_default() {
        let off: Vec<_> =
            Item::ALL.iter().filter(|item| !OverlayItems::default().shows(**item)).collect();
        assert_eq!(off, [&Item::UvAxes, &Item::Loupe]);
    }
}
