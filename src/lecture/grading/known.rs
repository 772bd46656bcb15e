//! The classic mistakes that answers are graded against.

use std::fmt;

/// A classic mistake of a student's ray tracer, from the basis to the hit.
///
/// Their order is the one in which they are tried and named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum KnownMistake {
    /// `w = normalize(view)`, as the lecture prints it; also `normalize(at - eye)`.
    WAsPrinted,
    /// `v = u x w`.
    VIsUCrossW,
    /// w, u or both not normalized; or `a = d . d` taken as 1.
    NotNormalized,
    /// `v = up`.
    UpAsV,
    /// The viewport's distance taken as 1, or the part along w left out.
    DistanceDropped,
    /// The pixel's corner instead of its centre; also centres spread from edge to edge.
    PixelCorner,
    /// Rows counted from the bottom.
    RowsFromBottom,
    /// u from the row and v from the column.
    RowsColumnsSwapped,
    /// Rows and columns, or objects, counted from 1 where they count from 0.
    CountedFromOne,
    /// The viewport's width taken for its height, or its height for its width.
    AspectDropped,
    /// `u = w x up`: one cross product, or both, the other way round.
    LeftHanded,
    /// Computed in `f32` where that does not suffice.
    SinglePrecision,
    /// `b = 2 d . (p - center)` and its half mixed up in the quadratic formula.
    BForHalfB,
    /// The larger root taken for the smaller, or the last object for the first.
    FarRoot,
    /// A hit behind the eye taken for one.
    NegativeT,
    /// The distance along the ray given as t, or t taken for a distance.
    TForDistance,
}

impl KnownMistake {
    /// All of them.
    pub const ALL: &'static [KnownMistake] = &[
        KnownMistake::WAsPrinted,
        KnownMistake::VIsUCrossW,
        KnownMistake::NotNormalized,
        KnownMistake::UpAsV,
        KnownMistake::DistanceDropped,
        KnownMistake::PixelCorner,
        KnownMistake::RowsFromBottom,
        KnownMistake::RowsColumnsSwapped,
        KnownMistake::CountedFromOne,
        KnownMistake::AspectDropped,
        KnownMistake::LeftHanded,
        KnownMistake::SinglePrecision,
        KnownMistake::BForHalfB,
        KnownMistake::FarRoot,
        KnownMistake::NegativeT,
        KnownMistake::TForDistance,
    ];

    /// `w-as-printed`, ...: what files and commands call it.
    pub fn id(self) -> &'static str {
        match self {
            KnownMistake::WAsPrinted => "w-as-printed",
            KnownMistake::VIsUCrossW => "v-is-u-cross-w",
            KnownMistake::NotNormalized => "not-normalized",
            KnownMistake::UpAsV => "up-as-v",
            KnownMistake::DistanceDropped => "distance-dropped",
            KnownMistake::PixelCorner => "pixel-corner",
            KnownMistake::RowsFromBottom => "rows-from-bottom",
            KnownMistake::RowsColumnsSwapped => "rows-columns-swapped",
            KnownMistake::CountedFromOne => "counted-from-one",
            KnownMistake::AspectDropped => "aspect-dropped",
            KnownMistake::LeftHanded => "left-handed",
            KnownMistake::SinglePrecision => "single-precision",
            KnownMistake::BForHalfB => "b-for-half-b",
            KnownMistake::FarRoot => "far-root",
            KnownMistake::NegativeT => "negative-t",
            KnownMistake::TForDistance => "t-for-distance",
        }
    }

    /// The mistake of this [`KnownMistake::id`].
    pub fn from_id(id: &str) -> Option<KnownMistake> {
        KnownMistake::ALL.iter().copied().find(|mistake| mistake.id() == id)
    }

    /// One sentence on what to look at.
    pub fn advice(self) -> &'static str {
        match self {
            KnownMistake::WAsPrinted => {
                "Look at w: it points backwards, w = -view/|view| = normalize(eye - at), so that \
                 w . view is below 0."
            }
            KnownMistake::VIsUCrossW => {
                "Look at the order of v's cross product: v = w x u, which points up in the image."
            }
            KnownMistake::NotNormalized => {
                "Look for a normalize that is missing: w = -view/|view| and u = up x w / |up x w| \
                 have length 1; and where |d| is not 1, a = d . d is not."
            }
            KnownMistake::UpAsV => {
                "Look at v: up is only a hint, and v = w x u is at right angles to w."
            }
            KnownMistake::DistanceDropped => {
                "Look at the direction's part along w: it is -distance w, with the viewport's own \
                 distance."
            }
            KnownMistake::PixelCorner => {
                "Look at where in a pixel (u, v) is taken: at its centre, (j + 0.5)/W and \
                 (i + 0.5)/H, with j and i from 0."
            }
            KnownMistake::RowsFromBottom => {
                "Look at the sign of v: row 0 is on top, v = height (0.5 - (i + 0.5)/H)."
            }
            KnownMistake::RowsColumnsSwapped => {
                "Look at which index makes what: u comes from the column j and W, v from the row i \
                 and H."
            }
            KnownMistake::CountedFromOne => {
                "Look at where counting begins: rows, columns and objects count from 0 here, with \
                 (j + 0.5)/W; from 1 it would be (j - 0.5)/W."
            }
            KnownMistake::AspectDropped => {
                "Look at the viewport's measures: u takes its width and v its height, and here \
                 they differ."
            }
            KnownMistake::LeftHanded => {
                "Look at the order of u's cross product: u = up x w, which points right in the \
                 image."
            }
            KnownMistake::SinglePrecision => {
                "Look at the type of your numbers: this scene needs double precision (f64), and \
                 these are off by as much as single (f32) may be."
            }
            KnownMistake::BForHalfB => {
                "Look at b in the quadratic formula: with b = d . (p - center) it is \
                 (-b - sqrt(b^2 - ac))/a, with twice that (-b - sqrt(b^2 - 4ac))/(2a)."
            }
            KnownMistake::FarRoot => {
                "Look at which root is taken: the smallest t above 0 is the hit, of one object and \
                 among all."
            }
            KnownMistake::NegativeT => {
                "Look for a test that is missing: only t > 0 is in front of the eye."
            }
            KnownMistake::TForDistance => {
                "Look at what t counts: t is in lengths of d, which is not normalized, and the \
                 distance along the ray is t |d|."
            }
        }
    }
}

impl fmt::Display for KnownMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}
