//! The classic wrong cameras: each mistake as a change to one stage of the way from eye, view and up
//! to a pixel's ray, the camera that it makes, and the checks that find it.
//!
//! ```text
//! w = -view/|view|    u = up x w / |up x w|    v = w x u
//! pixel (row, column) -> (u, v) -> direction = u*U + v*V - distance*W
//! ```

mod camera;
mod checks;
mod picture;

use std::fmt;

pub use camera::{NoWrongCamera, WrongCamera};
pub use checks::{Check, Checked, Value, Wanted};
pub use picture::WrongPicture;

/// A classic mistake on the way to a pixel's ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Mistake {
    /// `w = normalize(view)`, as the lecture prints it.
    WAsPrinted,
    /// `w = normalize(at - eye)`: the same, from points.
    WIsAtMinusEye,
    /// `v = u x w`.
    VIsUCrossW,
    /// `u = up x w`, and with it v, not normalized.
    NotNormalized,
    /// `w = -view`, not normalized, and with it v.
    WNotNormalized,
    /// `direction = u*U + v*V - W`.
    DistanceDropped,
    /// The pixel's corner instead of its centre.
    PixelCorner,
    /// Rows counted from the bottom.
    RowsFromBottom,
    /// u from the row and v from the column.
    RowsColumnsSwapped,
    /// `v = up`.
    UpAsV,
    /// `u = normalize(w x up)`.
    UIsWCrossUp,
    /// Both cross products the other way round.
    LeftHanded,
    /// The course's `j - 0.5`, with pixels counted from 0.
    CountedFromOne,
    /// The viewport's width taken for its height.
    AspectDropped,
}

/// What is said of a mistake.
struct Texts {
    id: &'static str,
    name: &'static str,
    formula: &'static str,
    shows: &'static str,
    hint: &'static str,
}

impl Mistake {
    /// All of them, in the order of a gallery.
    pub const ALL: &'static [Mistake] = &[
        Mistake::WAsPrinted,
        Mistake::WIsAtMinusEye,
        Mistake::VIsUCrossW,
        Mistake::NotNormalized,
        Mistake::WNotNormalized,
        Mistake::DistanceDropped,
        Mistake::PixelCorner,
        Mistake::RowsFromBottom,
        Mistake::RowsColumnsSwapped,
        Mistake::UpAsV,
        Mistake::UIsWCrossUp,
        Mistake::LeftHanded,
        Mistake::CountedFromOne,
        Mistake::AspectDropped,
    ];

    /// `w-as-printed`, ...: what files and commands call it.
    pub fn id(self) -> &'static str {
        self.texts().id
    }

    /// The mistake of this [`Mistake::id`].
    pub fn from_id(id: &str) -> Option<Mistake> {
        Mistake::ALL.iter().copied().find(|mistake| mistake.id() == id)
    }

    /// A few words for a list.
    pub fn name(self) -> &'static str {
        self.texts().name
    }

    /// What is done wrong, as a formula, and what would be right.
    pub fn formula(self) -> &'static str {
        self.texts().formula
    }

    /// How it shows in the picture.
    pub fn shows(self) -> &'static str {
        self.texts().shows
    }

    /// What to change where it changes nothing.
    pub fn hint(self) -> &'static str {
        self.texts().hint
    }

    /// The checks that find it, where all of its effects show.
    pub fn found_by(self) -> &'static [Check] {
        use Check::*;
        match self {
            Mistake::WAsPrinted | Mistake::WIsAtMinusEye => &[LooksForwards],
            Mistake::VIsUCrossW => &[RightHanded, UpIsUp],
            Mistake::NotNormalized => &[LengthU, LengthV],
            Mistake::WNotNormalized => &[LengthV, LengthW, ViewportAtDistance],
            Mistake::DistanceDropped => &[ViewportAtDistance],
            Mistake::PixelCorner | Mistake::CountedFromOne => &[CornersBalance],
            Mistake::RowsFromBottom => &[TopLeft, StepDown],
            // The corners only where the image is not square.
            Mistake::RowsColumnsSwapped => &[StepRight, StepDown, CornersBalance],
            Mistake::UpAsV => &[LengthV, VDotW],
            Mistake::UIsWCrossUp => &[UpIsUp],
            Mistake::LeftHanded => &[RightHanded],
            Mistake::AspectDropped => &[StepDown],
        }
    }

    fn texts(self) -> Texts {
        match self {
            Mistake::WAsPrinted => Texts {
                id: "w-as-printed",
                name: "𝐰 as printed",
                formula: "𝐰 ← normalize(view). Right: 𝐰 ← −normalize(view).",
                shows: "The camera looks the other way: it sees what is behind it, and nothing else \
                        in the numbers looks wrong.",
                hint: "Any camera given by view, or by at, shows it.",
            },
            Mistake::WIsAtMinusEye => Texts {
                id: "w-is-at-minus-eye",
                name: "𝐰 from at − eye",
                formula: "𝐰 ← normalize(at − eye). Right: 𝐰 ← normalize(eye − at).",
                shows: "The camera looks away from at, which is exactly behind it.",
                hint: "Give the camera by eye, at and up.",
            },
            Mistake::VIsUCrossW => Texts {
                id: "v-is-u-cross-w",
                name: "𝐯 = 𝐮 × 𝐰",
                formula: "𝐯 ← 𝐮 × 𝐰. Right: 𝐯 ← 𝐰 × 𝐮.",
                shows: "The picture is upside down, but left is still left.",
                hint: "Any camera given by view, or by at, shows it.",
            },
            Mistake::NotNormalized => Texts {
                id: "not-normalized",
                name: "𝐮 and 𝐯 not normalized",
                formula: "𝐮 ← up × 𝐰, and 𝐯 ← 𝐰 × 𝐮 from it. Right: 𝐮 ← normalize(up × 𝐰).",
                shows: "The viewport is |up × 𝐰| times as large: everything is seen larger where that \
                        is below 1, smaller where it is above. The closer up is to the view, the \
                        smaller the viewport.",
                hint: "Here up × 𝐰 has length 1: give up another length, or tip it towards the view.",
            },
            Mistake::WNotNormalized => Texts {
                id: "w-not-normalized",
                name: "𝐰 not normalized",
                formula: "𝐰 ← −view, and 𝐯 ← 𝐰 × 𝐮 from it. Right: 𝐰 ← −normalize(view).",
                shows: "The viewport is |view| times as far and as high, but not as wide: everything \
                        is stretched sideways where |view| > 1, squeezed where |view| < 1.",
                hint: "Here the view has length 1: move at farther away, or give view another length.",
            },
            Mistake::DistanceDropped => Texts {
                id: "distance-dropped",
                name: "distance dropped",
                formula: "𝐝 ← 𝑢 𝐮 + 𝑣 𝐯 − 𝐰. Right: 𝐝 ← 𝑢 𝐮 + 𝑣 𝐯 − distance 𝐰.",
                shows: "The field of view is that of distance 1: everything is seen larger or \
                        smaller.",
                hint: "Here the distance is 1: give the viewport another distance.",
            },
            Mistake::PixelCorner => Texts {
                id: "pixel-corner",
                name: "corner instead of centre",
                formula: "𝑢 ← width (𝑗/𝑊 − ½), 𝑣 ← height (½ − 𝑖/𝐻). Right: 𝑗 + ½ and 𝑖 + ½.",
                shows: "The picture moves by half a pixel, right and down: seen only where pixels \
                        are large.",
                hint: "Any image shows it; one of few pixels shows it best.",
            },
            Mistake::RowsFromBottom => Texts {
                id: "rows-from-bottom",
                name: "rows from the bottom",
                formula: "𝑣 ← height ((𝑖 + ½)/𝐻 − ½). Right: 𝑣 ← height (½ − (𝑖 + ½)/𝐻).",
                shows: "The picture is upside down, with a perfect basis.",
                hint: "Give the image more than one row.",
            },
            Mistake::RowsColumnsSwapped => Texts {
                id: "rows-columns-swapped",
                name: "rows and columns swapped",
                formula: "𝑢 ← width ((𝑖 + ½)/𝑊 − ½), 𝑣 ← height (½ − (𝑗 + ½)/𝐻). Right: 𝑢 from \
                          the column 𝑗, 𝑣 from the row 𝑖.",
                shows: "The picture is mirrored in the diagonal from top left to bottom right.",
                hint: "Give the image more than one pixel.",
            },
            Mistake::UpAsV => Texts {
                id: "up-as-v",
                name: "up used as 𝐯",
                formula: "𝐯 ← up. Right: 𝐯 ← 𝐰 × 𝐮.",
                shows: "Heights are distorted, and the middle row is right: up leans towards the \
                        view or away from it, and 𝐯 does not.",
                hint: "Here up is a unit vector at right angles to the view: tip the camera up or \
                       down.",
            },
            Mistake::UIsWCrossUp => Texts {
                id: "u-is-w-cross-up",
                name: "𝐮 = 𝐰 × up",
                formula: "𝐮 ← normalize(𝐰 × up). Right: 𝐮 ← normalize(up × 𝐰).",
                shows: "The picture is turned by half a turn: 𝐯, made of 𝐮, is wrong with it.",
                hint: "Any camera given by view, or by at, shows it.",
            },
            Mistake::LeftHanded => Texts {
                id: "left-handed",
                name: "left-handed basis",
                formula: "𝐮 ← normalize(𝐰 × up), 𝐯 ← 𝐮 × 𝐰. Right: up × 𝐰 and 𝐰 × 𝐮.",
                shows: "The picture is mirrored: left and right are exchanged, up is still up.",
                hint: "Any camera given by view, or by at, shows it.",
            },
            Mistake::CountedFromOne => Texts {
                id: "counted-from-one",
                name: "counted from 1",
                formula: "𝑢 ← width ((𝑗 − ½)/𝑊 − ½) with 𝑗 from 0, and 𝑣 likewise. Right: 𝑗 + ½, or \
                          count from 1.",
                shows: "The picture moves by one pixel, right and down.",
                hint: "Any image shows it; one of few pixels shows it best.",
            },
            Mistake::AspectDropped => Texts {
                id: "aspect-dropped",
                name: "height taken as width",
                formula: "𝑣 ← width (½ − (𝑖 + ½)/𝐻). Right: 𝑣 ← height (½ − (𝑖 + ½)/𝐻).",
                shows: "Spheres are stretched or flattened.",
                hint: "Here the viewport is as high as it is wide: give it another width or height.",
            },
        }
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}
