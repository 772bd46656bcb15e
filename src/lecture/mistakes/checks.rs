//! Checks of a camera, and the verdict of each on a wrong one.

use pinhole_core::DVec2;

/// The table of checks: each with the number that it looks at, as a formula, and its meaning when it
/// passes.
macro_rules! checks {
    ($($(#[$doc:meta])* $name:ident: $formula:literal, $meaning:literal;)*) => {
        /// A property of every right camera.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Check {
            $($(#[$doc])* $name,)*
        }

        impl Check {
            /// All of them.
            pub const ALL: &'static [Check] = &[$(Check::$name,)*];

            /// The number that it looks at, as a formula.
            pub fn formula(self) -> &'static str {
                match self {
                    $(Check::$name => $formula,)*
                }
            }

            /// Its meaning when it passes.
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Check::$name => $meaning,)*
                }
            }
        }
    };
}

checks! {
    /// `|u| = 1`.
    LengthU: "|𝐮|",
        "𝐮 is a unit vector";
    /// `|v| = 1`.
    LengthV: "|𝐯|",
        "𝐯 is a unit vector";
    /// `|w| = 1`.
    LengthW: "|𝐰|",
        "𝐰 is a unit vector";
    /// `u . v = 0`.
    UDotV: "𝐮 · 𝐯",
        "𝐮 and 𝐯 are perpendicular";
    /// `v . w = 0`.
    VDotW: "𝐯 · 𝐰",
        "𝐯 and 𝐰 are perpendicular";
    /// `w . u = 0`.
    WDotU: "𝐰 · 𝐮",
        "𝐰 and 𝐮 are perpendicular";
    /// `(u x v) . w > 0`.
    RightHanded: "(𝐮 × 𝐯) · 𝐰",
        "𝐮 × 𝐯 points along 𝐰: right-handed";
    /// `w . view / |view| < 0`: w is backwards.
    LooksForwards: "𝐰 · view / |view|",
        "𝐰 points backwards, so the camera looks along view";
    /// `v . up / |up| > 0`.
    UpIsUp: "𝐯 · up / |up|",
        "𝐯 is on up's side, so up is up in the image";
    /// `-direction . w = distance` of the middle ray: t = 1 is the viewport.
    ViewportAtDistance: "−𝐝 · 𝐰, middle ray",
        "t = 1 is the viewport, at its distance";
    /// (u, v) of pixel (0, 0): left of the middle and above it.
    TopLeft: "(𝑢, 𝑣) of pixel (0, 0)",
        "row 0, column 0 is at the top left";
    /// One column to the right: (u, v) moves by `(width/W, 0)`.
    StepRight: "next column, step of (𝑢, 𝑣)",
        "columns go right, by width/𝑊";
    /// One row down: (u, v) moves by `(0, -height/H)`.
    StepDown: "next row, step of (𝑢, 𝑣)",
        "rows go down, by height/𝐻";
    /// The four corner pixels lie evenly around the middle: the mean of their (u, v) is (0, 0).
    CornersBalance: "four corners, mean (𝑢, 𝑣)",
        "pixels lie evenly around the middle: their centres are taken";
}

/// A number that a check looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// One number.
    Number(f64),
    /// A position in the viewport, or a step there.
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
    /// The check.
    pub check: Check,
    /// The camera's value; exactly 0 where it is 0 but for rounding.
    pub value: Value,
    /// The value that a right camera has.
    pub wanted: Wanted,
    /// True where both are the same.
    pub passes: bool,
}
