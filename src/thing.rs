//! What can be pointed at: a line of the ledger is about it, and a view shows it.

/// Something in the scene or in a camera's derivation that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Thing {
    /// The camera's position.
    Eye,
    /// The point the camera looks at.
    At,
    /// The view direction.
    View,
    /// The up vector as given.
    Up,
    /// `-view`: backwards, before it is normalized to w.
    Backwards,
    /// The basis vector u: right in the image.
    U,
    /// The basis vector v: up in the image.
    V,
    /// The basis vector w: backwards.
    W,
    /// `up x w`, with its two factors and the parallelogram between them.
    UpCrossW,
    /// `w x u`, likewise.
    WCrossU,
    /// The viewport's rectangle.
    Viewport,
    /// From the eye to the viewport.
    Distance,
    /// The selected pixel, or the place (u, v) on the viewport.
    Pixel,
    /// `u U`: the part of the direction to the right.
    AlongU,
    /// `v V`: the part of the direction upwards.
    AlongV,
    /// `-distance W`: the part of the direction forwards.
    AlongW,
    /// The direction of the selected ray: from the eye to the viewport.
    Direction,
    /// The selected ray.
    Ray,
    /// An object of the scene.
    Object(u32),
    /// A place where the selected ray's line meets an object.
    Root {
        /// Which object.
        object: u32,
        /// Which of its roots, by ascending t.
        number: u8,
    },
    /// The normal at the first hit.
    Normal,
}
