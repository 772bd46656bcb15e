//! Checks of a camera, and the verdict of each on a wrong one.

use pinhole_core::DVec2;

/// A property of every right camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Check {
    /// `|u| = 1`.
    LengthU,
    /// `|v| = 1`.
    LengthV,
    /// `|w| = 1`.
    LengthW,
    /// `u . v = 0`.
    UDotV,
    /// `v . w = 0`.
    VDotW,
    /// `w . u = 0`.
    WDotU,
    /// `(u x v) . w > 0`.
    RightHanded,
    /// `w . view / |view| < 0`: w is backwards.
    LooksForwards,
    /// `v . up / |up| > 0`.
    UpIsUp,
    /// `-direction . w = distance` of the middle ray: t = 1 is the viewport.
    ViewportAtDistance,
    /// (u, v) of pixel (0, 0): left of the middle and above it.
    TopLeft,
    /// One column to the right: (u, v) moves by `(width/W, 0)`.
    StepRight,
    /// One row down: (u, v) moves by `(0, -height/H)`.
    StepDown,
    /// The four corner pixels lie evenly around the middle: the mean of their (u, v) is (0, 0).
    CornersBalance,
}

/// A number that a check looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// One number.
    Number(f64),
    /// A place in the viewport, or a step there.
    Uv(DVec2),
}

/// The value that a right camera has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wanted {
    /// This, but for rounding.
    Equal(Value),
    /// Below 0.
    Negative,
    /// Above 0.
    Positive,
    /// u not above 0 and v not below it.
    LeftAndUp,
}

/// A check, carried out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Checked {
    /// Which one.
    pub check: Check,
    /// The camera's value; exactly 0 where it is 0 but for rounding.
    pub value: Value,
    /// The value that a right camera has.
    pub wanted: Wanted,
    /// True where both are the same.
    pub passes: bool,
}

impl Check {
    /// All of them.
    pub const ALL: &'static [Check] = &[
        Check::LengthU,
        Check::LengthV,
        Check::LengthW,
        Check::UDotV,
        Check::VDotW,
        Check::WDotU,
        Check::RightHanded,
        Check::LooksForwards,
        Check::UpIsUp,
        Check::ViewportAtDistance,
        Check::TopLeft,
        Check::StepRight,
        Check::StepDown,
        Check::CornersBalance,
    ];

    /// The number that it looks at, as a formula.
    pub fn formula(self) -> &'static str {
        match self {
            Check::LengthU => "|𝐮|",
            Check::LengthV => "|𝐯|",
            Check::LengthW => "|𝐰|",
            Check::UDotV => "𝐮 · 𝐯",
            Check::VDotW => "𝐯 · 𝐰",
            Check::WDotU => "𝐰 · 𝐮",
            Check::RightHanded => "(𝐮 × 𝐯) · 𝐰",
            Check::LooksForwards => "𝐰 · view / |view|",
            Check::UpIsUp => "𝐯 · up / |up|",
            Check::ViewportAtDistance => "−𝐝 · 𝐰, middle ray",
            Check::TopLeft => "(𝑢, 𝑣) of pixel (0, 0)",
            Check::StepRight => "a column on, (𝑢, 𝑣) moves",
            Check::StepDown => "a row on, (𝑢, 𝑣) moves",
            Check::CornersBalance => "four corners, mean (𝑢, 𝑣)",
        }
    }

    /// Its meaning when it passes.
    pub fn meaning(self) -> &'static str {
        match self {
            Check::LengthU => "𝐮 is a unit vector",
            Check::LengthV => "𝐯 is a unit vector",
            Check::LengthW => "𝐰 is a unit vector",
            Check::UDotV => "𝐮 and 𝐯 are orthogonal",
            Check::VDotW => "𝐯 and 𝐰 are orthogonal",
            Check::WDotU => "𝐰 and 𝐮 are orthogonal",
            Check::RightHanded => "𝐮 × 𝐯 points along 𝐰: right-handed",
            Check::LooksForwards => "𝐰 points backwards, so the camera looks along view",
            Check::UpIsUp => "𝐯 is on up's side, so up is up in the image",
            Check::ViewportAtDistance => "t = 1 is the viewport, at its distance",
            Check::TopLeft => "row 0, column 0 is at the top left",
            Check::StepRight => "columns go right, by width/𝑊",
            Check::StepDown => "rows go down, by height/𝐻",
            Check::CornersBalance => "pixels lie evenly around the middle: their centres are taken",
        }
    }
}
