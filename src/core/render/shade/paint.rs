//! Colours, and how hits become them.

/// sRGB bytes.
pub type Rgb = [u8; 3];

/// The colour of a pixel whose ray hits nothing.
pub const BACKGROUND: Rgb = [0xc9, 0xd3, 0xdf];

/// A way to make a colour of a hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shade {
    /// Lit from the eye: the object's colour times `0.15 + 0.85 |n.d| / |d|`, in linear light.
    #[default]
    Lambert,
    /// The outward normal's x, y, z, from -1..1 to red, green, blue 0..255.
    Normal,
    /// Grey, `t_min / t` of the frame: the nearest hit is white.
    T,
    /// The object's colour, flat.
    Object,
}

impl Shade {
    /// All of them.
    pub const ALL: [Shade; 4] = [Shade::Lambert, Shade::Normal, Shade::T, Shade::Object];

    /// `lambert`, `normal`, `t`, `object`.
    pub fn name(self) -> &'static str {
        match self {
            Shade::Lambert => "lambert",
            Shade::Normal => "normal",
            Shade::T => "t",
            Shade::Object => "object",
        }
    }

    /// Returns whether the colours depend on `t`.
    pub fn needs_t(self) -> bool {
        matches!(self, Shade::Normal | Shade::T)
    }
}

/// A way to make pixels of hits.
#[derive(Clone, Copy, Debug)]
pub struct Paint<C, F> {
    /// A way to make a colour of a hit.
    pub shade: Shade,
    /// `Fn(u32) -> Rgb`: each object's own colour.
    pub color_of: C,
    /// `Fn(Rgb) -> P`: the form that pixels have.
    pub to_pixel: F,
}
