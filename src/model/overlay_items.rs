//! The items of the overlay, each of which can be switched off.

use serde::{Deserialize, Serialize};

/// An item that the overlay draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Item {
    /// The camera's position.
    Eye,
    /// The point that the camera looks at, if it is given by one.
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
    /// The labels of all these items.
    Labels,
    /// The magnified pixels around the selected place, in the camera view.
    Loupe,
    /// The handles in the world view.
    Handles,
}

impl Item {
    /// All items, in the order of a panel.
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

    /// Returns the label of the item's checkbox.
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

    /// Returns the item's name in lesson files.
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

/// The set of items that are drawn.
///
/// Stored as a set of bits, one for each [`Item`] in the order of their declaration; unknown bits
/// are ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct OverlayItems {
    off: u32,
}

impl Default for OverlayItems {
    /// Returns all items except those that would cover the camera's picture: its axes and the
    /// loupe.
    fn default() -> Self {
        OverlayItems { off: Item::UvAxes.bit() | Item::Loupe.bit() }
    }
}

impl OverlayItems {
    /// The empty set.
    pub const NONE: OverlayItems = OverlayItems { off: u32::MAX };

    /// All items.
    pub const ALL: OverlayItems = OverlayItems { off: 0 };

    /// Returns true if the item is drawn.
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

    /// Returns the same items with one switched on or off.
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
