//! The items of the overlay, each of which can be switched off.

use serde::{Deserialize, Serialize};

pinhole_core::texts! {
    /// An item that the overlay draws.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    #[repr(u8)]
    pub enum Item[2];
    {
        /// Returns the label of the item's checkbox.
        label,
        /// Returns the item's name in lesson files.
        name,
    }
    /// The camera's position.
    Eye: "eye", "eye";
    /// The point at, for a camera that is given by it.
    At: "at", "at";
    /// The view and up vectors as given.
    ViewAndUp: "view and up", "view-and-up";
    /// The u, v, w arrows.
    Basis: "u, v, w", "basis";
    /// The frustum's edges.
    Frustum: "frustum", "frustum";
    /// The viewport's outline.
    Viewport: "viewport outline", "viewport";
    /// The traced picture, on the viewport in space.
    Picture: "picture on the viewport", "picture";
    /// The edges between pixels, in both views.
    PixelGrid: "pixel grid", "pixel-grid";
    /// The marks that show how the image lies on the viewport: at its top edge and at pixel (0, 0), in both
    /// views.
    Marks: "top edge and pixel (0, 0)", "marks";
    /// The selected view ray, and its pixel in both views.
    Ray: "selected ray", "ray";
    /// The first hit and its normal.
    Hit: "hit and normal", "hit";
    /// The x, y, z axes at the origin.
    Axes: "x, y, z axes", "axes";
    /// The planes, each drawn as a pane with a grid of world units.
    Planes: "planes", "planes";
    /// The lines u = 0 and v = 0 in the camera view.
    UvAxes: "u = 0 and v = 0", "uv-axes";
    /// The labels of all these items.
    Labels: "labels", "labels";
    /// The loupe: the magnified pixels around the selected point, in the camera view.
    Loupe: "loupe", "loupe";
    /// The handles in the world view.
    Handles: "handles", "handles";
    /// The selected ray and the sphere that it hits first, as a textbook draws them: centre, radius, foot of
    /// the perpendicular, half chord and both roots.
    SphereFigure: "ray and sphere: roots and half chord", "sphere-figure";
    /// The floor in the world view: a grid below everything, and drop lines down to it.
    Floor: "floor and drop lines", "floor";
    /// The arcs from u to v, from v to w and from w to u.
    Ring: "order of u, v, w", "ring";
    /// The right angles between u, v and w, and the angles by which they have turned from the ghost's.
    RightAngles: "right angles of u, v, w", "right-angles";
    /// The parallelogram of up and w, with its area.
    UpCrossW: "area of up × w", "up-cross-w";
    /// The vector view from the eye to at, with -view beside it.
    ViewVector: "view = at − eye, and −view", "view-vector";
    /// Dimension lines of the viewport's width, height and distance.
    Measures: "width, height, distance", "measures";
    /// The selected point's u and v, from the middle of the viewport to the point, in both views.
    UvLegs: "u and v of the point", "uv-legs";
    /// The numbers of rows and columns along the pixel grid, and W and H, in both views.
    PixelNumbers: "rows and columns, W and H", "pixel-numbers";
    /// The u arrow without the others, for a basis that is not complete yet.
    U: "u alone", "u";
    /// The w arrow without the others.
    W: "w alone", "w";
    /// The square of w and u, with its area.
    WCrossU: "area of w × u", "w-cross-u";
    /// The vector d of the selected ray, from the eye to the viewport.
    Direction: "d of the selected ray", "direction";
    /// The points where the line of the selected ray meets objects, each with its t.
    Roots: "every t of the ray's line", "roots";
}

impl Item {
    /// Returns true for a figure of the whiteboard, which belongs to one topic.
    pub(crate) fn is_of_one_topic(self) -> bool {
        self as u8 >= Item::SphereFigure as u8 && self != Item::Floor
    }

    const fn bit(self) -> u64 {
        1 << self as u8
    }
}

/// The set of items that are drawn.
///
/// Stored as a bit set with one bit for each [`Item`], in the order of their declaration, so that an item
/// that a stored set does not know is off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct OverlayItems {
    on: u64,
}

impl Default for OverlayItems {
    /// Returns all items except the u and v axes of the camera view and the loupe, which would cover
    /// the picture, and the figures of the whiteboard, each of which belongs to one topic.
    fn default() -> Self {
        let figures = OverlayItems::ALL.on & !(2 * Item::Handles.bit() - 1) & !Item::Floor.bit();
        OverlayItems {
            on: OverlayItems::ALL.on & !(Item::UvAxes.bit() | Item::Loupe.bit() | figures),
        }
    }
}

impl OverlayItems {
    /// The empty set.
    pub const NONE: OverlayItems = OverlayItems { on: 0 };

    /// All items.
    pub const ALL: OverlayItems = OverlayItems { on: (1 << Item::ALL.len()) - 1 };

    /// Returns true if the item is drawn.
    pub fn shows(self, item: Item) -> bool {
        self.on & item.bit() != 0
    }

    /// Returns true if any of these items is shown.
    pub fn shows_any(self, items: &[Item]) -> bool {
        items.iter().any(|item| self.shows(*item))
    }

    /// Returns the items as which u, v and w are drawn: all three as the basis, or each alone.
    pub fn of_basis(self) -> [Item; 3] {
        let alone = [Item::U, Item::Basis, Item::W];
        if self.shows(Item::Basis) { [Item::Basis; 3] } else { alone }
    }

    /// Switches an item on or off.
    pub fn set(&mut self, item: Item, on: bool) {
        if on {
            self.on |= item.bit();
        } else {
            self.on &= !item.bit();
        }
    }

    /// Returns a copy of the set in which one item is switched on or off.
    #[must_use]
    pub fn with(mut self, item: Item, on: bool) -> OverlayItems {
        self.set(item, on);
        self
    }

    /// Returns a copy of the set in which all items of `hidden` are switched off.
    #[must_use]
    pub fn without(self, hidden: OverlayItems) -> OverlayItems {
        OverlayItems { on: self.on & !hidden.on }
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
            let others = OverlayItems::ALL.without(only);
            assert_eq!(others, OverlayItems::ALL.with(item, false));
        }
    }

    #[test]
    fn what_would_cover_the_picture_is_off_by_default() {
        let off: Vec<_> =
            Item::ALL.into_iter().filter(|item| !OverlayItems::default().shows(*item)).collect();
        let figures = Item::ALL.into_iter().skip(Item::SphereFigure as usize);
        let figures = figures.filter(|item| *item != Item::Floor);
        let expected: Vec<_> = [Item::UvAxes, Item::Loupe].into_iter().chain(figures).collect();
        assert_eq!(off, expected);
    }
}
