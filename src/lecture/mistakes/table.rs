//! The table of mistakes: each mistake's name, the texts about it, and its variants (the different ways
//! in which students make it).

use std::fmt;

use super::pipeline::{
    Distance, Extent, Measure, Offset, Pipeline, Rows, Sign, SquareRoot, Swap, UpAsV, Way,
    WhichRoot,
};

/// Defines the structure of an entry in the table, and a method of [`Mistake`] for each of its texts. A
/// text that is not needed is empty.
macro_rules! entry {
    ($($(#[$doc:meta])* $field:ident,)*) => {
        struct Entry {
            id: &'static str,
            $($field: &'static str,)*
            /// The mistake's variants in a program, as changes to the right [`Pipeline`], the most
            /// common one first.
            ways: &'static [Way],
        }

        impl Entry {
            const EMPTY: Entry = Entry { id: "", $($field: "",)* ways: &[] };
        }

        impl Mistake {
            $($(#[$doc])*
            pub fn $field(self) -> &'static str {
                self.entry().$field
            })*
        }
    };
}

entry! {
    /// A few words for the gallery's list.
    name,
    /// The wrong formula and the right one, for the gallery (the window's list of mistakes whose
    /// pictures can be shown).
    formula,
    /// The effect of the mistake on the picture, for the gallery.
    shows,
    /// A change to the scene that makes the mistake visible, which the gallery suggests if the mistake
    /// does not show.
    hint,
    /// One sentence of advice for the author of a program that makes the mistake: where to look.
    advice,
    /// One sentence of feedback on an exercise's answer to which the mistake leads: what is wrong with
    /// it, and where to look.
    exercise_feedback,
}

macro_rules! mistakes {
    (
        {$($(#[$graded_doc:meta])* $graded:ident $graded_id:literal {
            $($graded_field:ident: $graded_value:expr,)*
        })*}
        {$($(#[$doc:meta])* $name:ident $id:literal { $($field:ident: $value:expr,)* })*}
        {$($answer_name:ident $answer_id:literal: $feedback:literal,)*}
    ) => {
        /// A classic mistake in ray tracing, at any stage from the camera's basis to the hit.
        ///
        /// The variants are in the order in which a student's answers are checked for the mistakes.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Mistake {
            $($(#[$graded_doc])* $graded,)*
            $($(#[$doc])* $name,)*
            $(#[doc = $feedback] $answer_name,)*
        }

        impl Mistake {
            /// All mistakes.
            pub const ALL: &'static [Mistake] =
                &[$(Mistake::$graded,)* $(Mistake::$name,)* $(Mistake::$answer_name,)*];

            /// The mistakes for which a student's answers are checked both alone and in pairs, in the
            /// order in which they are checked and named.
            pub const GRADED: &'static [Mistake] = &[$(Mistake::$graded,)*];

            #[expect(clippy::needless_update, reason = "one mistake has all of an entry")]
            fn entry(self) -> &'static Entry {
                match self {
                    $(Mistake::$graded => const {
                        &Entry { id: $graded_id, $($graded_field: $graded_value,)* ..Entry::EMPTY }
                    })*
                    $(Mistake::$name => const {
                        &Entry { id: $id, $($field: $value,)* ..Entry::EMPTY }
                    })*
                    $(Mistake::$answer_name => const {
                        &Entry { id: $answer_id, exercise_feedback: $feedback, ..Entry::EMPTY }
                    })*
                }
            }
        }
    };
}

mistakes! {
// A graded program is checked for these mistakes.
{
    /// w points forwards: `w = normalize(view)`, as the lecture's slide has it, or `normalize(at -
    /// eye)`.
    WAsPrinted "w-as-printed" {
        name: "𝐰 without the minus",
        formula: "𝐰 ← normalize(view). Right: 𝐰 ← −normalize(view).",
        shows: "The camera looks the other way: it sees what is behind it, and nothing else in the \
                numbers looks wrong.",
        hint: "Any camera given by view, or by at, shows it.",
        advice: "Look at w: it points backwards, w = -view/|view| = normalize(eye - at), so that w \
                 . view is below 0.",
        exercise_feedback: "𝐰 is made from view without the minus: 𝐰 points backwards, so 𝐰 · view \
            must be below 0.",
        ways: &[|p| p.basis.w_forwards = true],
    }

    /// `v = u x w`.
    VIsUCrossW "v-is-u-cross-w" {
        name: "𝐯 = 𝐮 × 𝐰",
        formula: "𝐯 ← 𝐮 × 𝐰. Right: 𝐯 ← 𝐰 × 𝐮.",
        shows: "The picture is upside down, but left is still left.",
        hint: "Any camera given by view, or by at, shows it.",
        advice: "Look at the order of v's cross product: v = w x u, which points up in the image.",
        exercise_feedback: "𝐯 = 𝐮 × 𝐰 points down: the factors are exchanged.",
        ways: &[|p| p.basis.v_swapped ^= true],
    }

    /// w, u or both are not normalized, or `a = d . d` is assumed to be 1.
    NotNormalized "not-normalized" {
        name: "𝐮 and 𝐯 not normalized",
        formula: "𝐮 ← up × 𝐰, and 𝐯 ← 𝐰 × 𝐮 from it. Right: 𝐮 ← normalize(up × 𝐰).",
        shows: "The viewport is |up × 𝐰| times as large: everything is seen larger where that is \
                below 1, smaller where it is above. The closer up is to the view, the smaller the \
                viewport.",
        hint: "Here up × 𝐰 has length 1: give up another length, or tip it towards the view.",
        advice: "Look for a normalize that is missing: w = -view/|view| and u = up x w / |up x w| \
                 have length 1; and where |d| is not 1, a = d . d is not.",
        exercise_feedback: "𝐮 = up × 𝐰 is not normalized, and 𝐯 = 𝐰 × 𝐮 with it.",
        ways: &[
            |p| p.basis.set_raw(false, true, false),
            |p| p.basis.set_raw(true, false, false),
            |p| p.basis.set_raw(true, true, false),
            |p| p.basis.set_raw(false, true, true),
            |p| p.basis.set_raw(true, false, true),
            |p| p.basis.set_raw(true, true, true),
            |p| p.quadratic.a_left_out = true,
        ],
    }

    /// `v = up`.
    UpAsV "up-as-v" {
        name: "up used as 𝐯",
        formula: "𝐯 ← up. Right: 𝐯 ← 𝐰 × 𝐮.",
        shows: "Heights are distorted, and the middle row is right: up leans towards the view or \
                away from it, and 𝐯 does not.",
        hint: "Here up is a unit vector perpendicular to the view: tip the camera up or down.",
        advice: "Look at v: up is only a hint, and v = w x u is perpendicular to w.",
        exercise_feedback: "up is only a hint: 𝐯 = 𝐰 × 𝐮 is perpendicular to 𝐰.",
        ways: &[|p| p.basis.up_as_v = UpAsV::AsGiven, |p| p.basis.up_as_v = UpAsV::Unit],
    }

    /// The viewport's distance is assumed to be 1, or the direction's component along w is left out.
    DistanceDropped "distance-dropped" {
        name: "distance dropped",
        formula: "𝐝 ← 𝑢 𝐮 + 𝑣 𝐯 − 𝐰. Right: 𝐝 ← 𝑢 𝐮 + 𝑣 𝐯 − distance 𝐰.",
        shows: "The field of view is that of distance 1: everything is seen larger or smaller.",
        hint: "Here the distance is 1: give the viewport another distance.",
        advice: "Look at the direction's part along w: it is -distance w, with the viewport's own \
                 distance.",
        exercise_feedback: "The distance is left out: the part along 𝐰 is −distance.",
        ways: &[|p| p.distance = Distance::One, |p| p.distance = Distance::LeftOut],
    }

    /// The ray passes through the pixel's corner instead of its centre, or columns and rows are divided
    /// by `W - 1` and `H - 1`, so that the outermost rays pass through the viewport's edges.
    PixelCorner "pixel-corner" {
        name: "corner instead of centre",
        formula: "𝑢 ← width (𝑗/𝑊 − ½), 𝑣 ← height (½ − 𝑖/𝐻). Right: 𝑗 + ½ and 𝑖 + ½.",
        shows: "The picture moves by half a pixel, right and down: seen only where pixels are \
                large.",
        hint: "Any image shows it; one of few pixels shows it best.",
        advice: "Look at where in a pixel (u, v) is taken: at its centre, (j + 0.5)/W and (i + \
                 0.5)/H, with j and i from 0.",
        exercise_feedback: "This is a corner of the pixel, half a pixel from its centre: mind the ½.",
        ways: &[
            |p| p.move_in_pixel(-0.5, -0.5),
            |p| p.edge_to_edge = true,
            |p| p.move_in_pixel(-0.5, 0.0),
            |p| p.move_in_pixel(0.0, -0.5),
        ],
    }

    /// Rows are counted from the bottom.
    RowsFromBottom "rows-from-bottom" {
        name: "rows from the bottom",
        formula: "𝑣 ← height ((𝑖 + ½)/𝐻 − ½). Right: 𝑣 ← height (½ − (𝑖 + ½)/𝐻).",
        shows: "The picture is upside down, with a perfect basis.",
        hint: "Give the image more than one row.",
        advice: "Look at the sign of v: row 0 is on top, v = height (0.5 - (i + 0.5)/H).",
        ways: &[|p| p.rows = Rows::SignOfV, |p| p.rows = Rows::FromLast],
    }

    /// u is calculated from the row, and v from the column.
    RowsColumnsSwapped "rows-columns-swapped" {
        name: "rows and columns swapped",
        formula: "𝑢 ← width ((𝑖 + ½)/𝑊 − ½), 𝑣 ← height (½ − (𝑗 + ½)/𝐻). Right: 𝑢 from the column \
                  𝑗, 𝑣 from the row 𝑖.",
        shows: "The picture is mirrored in the diagonal from top left to bottom right.",
        hint: "Give the image more than one pixel.",
        advice: "Look at which index makes what: u comes from the column j and W, v from the row i \
                 and H.",
        exercise_feedback: "Row and column are exchanged: 𝑢 comes from the column 𝑗, 𝑣 from the row 𝑖.",
        ways: &[
            |p| p.swap = Swap::Indices,
            |p| p.swap = Swap::Shares,
            |p| p.swap = Swap::Counts,
        ],
    }

    /// Rows and columns, or objects, are counted from 1 instead of from 0.
    CountedFromOne "counted-from-one" {
        name: "counted from 1",
        formula: "𝑢 ← width ((𝑗 − ½)/𝑊 − ½) with 𝑗 from 0, and 𝑣 likewise. Right: 𝑗 + ½, or count \
                  from 1.",
        shows: "The picture moves by one pixel, right and down.",
        hint: "Any image shows it; one of few pixels shows it best.",
        advice: "Look at where counting begins: rows, columns and objects count from 0 here, with \
                 (j + 0.5)/W; from 1 it would be (j - 0.5)/W.",
        ways: &[
            Pipeline::count_pixels_from_one,
            |p| p.from_one = true,
            |p| p.move_in_pixel(1.0, 1.0),
            Pipeline::count_objects_from_one,
            Pipeline::count_all_from_one,
        ],
    }

    /// The viewport's width is used as its height, too, or its height as its width.
    AspectDropped "aspect-dropped" {
        name: "width used as height",
        formula: "𝑣 ← width (½ − (𝑖 + ½)/𝐻). Right: 𝑣 ← height (½ − (𝑖 + ½)/𝐻).",
        shows: "Spheres are stretched or flattened.",
        hint: "Here the viewport is as high as it is wide: give it another width or height.",
        advice: "Look at the viewport's measures: u takes its width and v its height, and here \
                 they differ.",
        ways: &[
            |p| p.extent = Extent::WidthForHeight,
            |p| p.extent = Extent::HeightForWidth,
            |p| p.extent = Extent::Ones,
            |p| p.extent = Extent::WidthByImage,
            |p| p.extent = Extent::HeightByImage,
        ],
    }

    /// `u = w x up`: the factors of one cross product, or of both, are exchanged.
    LeftHanded "left-handed" {
        name: "left-handed basis",
        formula: "𝐮 ← normalize(𝐰 × up), 𝐯 ← 𝐮 × 𝐰. Right: up × 𝐰 and 𝐰 × 𝐮.",
        shows: "The picture is mirrored: left and right are exchanged, up is still up.",
        hint: "Any camera given by view, or by at, shows it.",
        advice: "Look at the order of u's cross product: u = up x w, which points right in the \
                 image.",
        exercise_feedback: "Both cross products are the other way round: up × 𝐰 and 𝐰 × 𝐮.",
        ways: &[|p| p.basis.swap_both(), |p| p.basis.u_swapped ^= true],
    }

    /// The numbers are computed in `f32`, which is not precise enough for the scene.
    SinglePrecision "single-precision" {
        advice: "Look at the type of your numbers: this scene needs double precision (f64), and \
                 these are off by as much as single (f32) may be.",
        ways: &[|p| p.single = true],
    }

    /// `b = 2 d . (p - center)` is used in a quadratic formula that expects half of it, or half of it
    /// in one that expects b.
    BForHalfB "b-for-half-b" {
        advice: "Look at b in the quadratic formula: with b = d . (p - center) it is (-b - \
                 sqrt(b^2 - ac))/a, with twice that (-b - sqrt(b^2 - 4ac))/(2a).",
        exercise_feedback: "𝑏 has a factor 2 too much: with 𝑏 = 𝐝 · (𝐩 − centre), 𝐷 is 𝑏² − 𝑎𝑐 and \
            the root is divided by 𝑎.",
        ways: &[
            |p| p.quadratic.set(2.0, 4.0, 1.0, 1.0),
            |p| p.quadratic.set(1.0, 1.0, 4.0, 2.0),
            |p| p.quadratic.set(2.0, 4.0, 4.0, 1.0),
            |p| p.quadratic.set(1.0, 1.0, 1.0, 2.0),
            |p| p.quadratic.set(2.0, 1.0, 1.0, 1.0),
            |p| p.quadratic.set(1.0, 4.0, 4.0, 2.0),
            |p| p.quadratic.set(2.0, 4.0, 1.0, 2.0),
        ],
    }

    /// The larger root is used instead of the smaller one.
    FarRoot "far-root" {
        advice: "Look at which root is taken: the smallest t above 0 is the hit, of one object and \
                 among all.",
        exercise_feedback: "That is the second root, where the ray leaves. Which one is first?",
        ways: &[|p| p.root = WhichRoot::Far, |p| p.root = WhichRoot::Farthest],
    }

    /// A hit behind the eye is accepted.
    NegativeT "negative-t" {
        advice: "Look for a test that is missing: only t > 0 is in front of the eye.",
        ways: &[|p| p.sign = Sign::Any, |p| p.sign = Sign::Nearest],
    }

    /// The distance in the world is reported as t (a multiple of the direction's length), or t is used
    /// as a distance.
    TForDistance "t-for-distance" {
        advice: "Look at what t counts: t is in lengths of d, which is not normalized, and the \
                 distance along the ray is t |d|.",
        exercise_feedback: "That is the distance along the ray. 𝑡 is in units of |𝐝|, and |𝐝| is \
            not 1.",
        ways: &[
            |p| p.measure = Measure::Distance,
            |p| p.measure = Measure::PointOfUnit,
            |p| p.measure = Measure::PointOfDistance,
        ],
    }

    /// The last object is used instead of the first: the last one in the scene, or the farthest along
    /// the ray.
    LastObject "last-object" {
        advice: "Look at how the hits of several objects are compared: the smallest t is the first \
                 hit, and a later object replaces it only where its t is smaller.",
        ways: &[|p| p.root = WhichRoot::Last, |p| p.root = WhichRoot::FarthestObject],
    }
}

// These mistakes occur in the gallery or in an answer. A graded program is checked for some of them,
// each alone.
{
    /// `w = normalize(at - eye)`: the same as [`Mistake::WAsPrinted`], for a camera that is given by
    /// eye and at.
    WIsAtMinusEye "w-is-at-minus-eye" {
        name: "𝐰 from at − eye",
        formula: "𝐰 ← normalize(at − eye). Right: 𝐰 ← normalize(eye − at).",
        shows: "The camera looks away from at, which is exactly behind it.",
        hint: "Give the camera by eye, at and up.",
        exercise_feedback: "at − eye is the view: 𝐰 points the other way, from at to eye.",
        ways: &[|p| p.basis.w_forwards = true],
    }

    /// `w = -view` is not normalized, so that v does not have length 1 either.
    WNotNormalized "w-not-normalized" {
        name: "𝐰 not normalized",
        formula: "𝐰 ← −view, and 𝐯 ← 𝐰 × 𝐮 from it. Right: 𝐰 ← −normalize(view).",
        shows: "The viewport is |view| times as far and as high, but not as wide: everything is \
                stretched sideways where |view| > 1, squeezed where |view| < 1.",
        hint: "Here the view has length 1: move at farther away, or give view another length.",
        exercise_feedback: "𝐰 = −view is not normalized, but each vector of the basis has length 1.",
        ways: &[|p| p.basis.set_raw(true, false, false)],
    }

    /// `u = normalize(w x up)`.
    UIsWCrossUp "u-is-w-cross-up" {
        name: "𝐮 = 𝐰 × up",
        formula: "𝐮 ← normalize(𝐰 × up). Right: 𝐮 ← normalize(up × 𝐰).",
        shows: "The picture is turned by 180°: 𝐯, made from 𝐮, is wrong, too.",
        hint: "Any camera given by view, or by at, shows it.",
        exercise_feedback: "𝐮 = 𝐰 × up points left: the factors are exchanged.",
        ways: &[|p| p.basis.u_swapped ^= true],
    }

    /// `direction = eye - point`: every ray leads from the viewport back to the eye.
    RayReversed "ray-reversed" {
        advice: "Look at the direction's sign: every ray leads back to the eye, and it is d = \
                 point - eye.",
        ways: &[|p| p.reversed = true],
    }

    /// `direction = u*U + v*V + distance*W`.
    DistanceAdded "distance-added" {
        advice: "Look at the direction's part along w: it is added, and it is -distance w.",
        exercise_feedback: "The part along 𝐰 has the wrong sign: 𝐰 points backwards.",
        ways: &[|p| p.distance = Distance::Plus],
    }

    /// The component of the direction along w is left out, so that the direction stays in the
    /// viewport's plane.
    FlatDirection "flat-direction" {
        exercise_feedback: "This stays in the viewport's plane. How far in front of the eye is the \
            viewport?",
        ways: &[|p| p.distance = Distance::LeftOut],
    }

    /// `w = view`, neither reversed nor normalized.
    WIsView "w-is-view" {
        exercise_feedback: "𝐰 is view itself: 𝐰 points the other way, and is of length 1: 𝐰 = \
            −view/|view|.",
        ways: &[
            |p| (p.basis.w_forwards, p.basis.w_raw) = (true, true),
            |p| (p.basis.w_forwards, p.basis.w_raw, p.basis.u_raw) = (true, true, true),
        ],
    }

    /// Neither w nor u is normalized.
    NothingNormalized "nothing-normalized" {
        exercise_feedback: "𝐰 and 𝐮 are not normalized, nor is what is made from them.",
        ways: &[|p| p.basis.set_raw(true, true, false)],
    }

    /// `b` is used instead of `-b`.
    SignOfB "sign-of-b" {
        advice: "Look at the sign of b: b = d . (p - center), and t begins with -b; with center - p \
                 for p - center, b has the other sign.",
        exercise_feedback: "The sign of 𝑏 is lost: 𝑡 begins with −𝑏, and 𝑏 is negative here.",
        ways: &[|p| p.quadratic.set(-1.0, 1.0, 1.0, 1.0)],
    }

    /// Half of `b` is used in the discriminant of the full quadratic formula.
    HalfBForB "half-b-for-b" {
        exercise_feedback: "𝑏 lacks a factor 2: where 𝐷 is 𝑏² − 4𝑎𝑐, 𝑏 = 2 𝐝 · (𝐩 − centre).",
        ways: &[|p| p.quadratic.set(1.0, 1.0, 4.0, 2.0)],
    }

    /// `a` is used instead of `2a` in the denominator of the full quadratic formula.
    DividedByA "divided-by-a" {
        exercise_feedback: "This is twice what it should be: where 𝑏 = 2 𝐝 · (𝐩 − centre), divide \
            by 2𝑎, not by 𝑎.",
        ways: &[|p| p.quadratic.set(2.0, 4.0, 4.0, 1.0)],
    }

    /// `2a` is used instead of `a` in the denominator of the halved quadratic formula.
    DividedBy2A "divided-by-2a" {
        exercise_feedback: "This is half of what it should be: where 𝑏 = 𝐝 · (𝐩 − centre), without \
            a 2, divide by 𝑎, not by 2𝑎.",
        ways: &[|p| p.quadratic.set(1.0, 1.0, 1.0, 2.0)],
    }

    /// `a = d . d` is left out.
    ALeftOut "a-left-out" {
        exercise_feedback: "𝑎 = 𝐝 · 𝐝 is left out: it is 1 only where |𝐝| is.",
        ways: &[|p| p.quadratic.a_left_out = true],
    }

    /// p is used instead of `p - center`.
    CenterLeftOut "center-left-out" {
        advice: "Look at p - center in the quadratic's b and c: the sphere's center is left out.",
        exercise_feedback: "The centre is left out: it is 𝐩 − centre, not 𝐩.",
        ways: &[|p| p.quadratic.offset = Offset::CenterLeftOut],
    }

    /// `-center` is used instead of `p - center`, or `t d` instead of `p + t d`.
    OriginLeftOut "origin-left-out" {
        advice: "Look at p - center in the quadratic's b and c: p, which is the eye, is left out.",
        exercise_feedback: "𝐩 is left out: the ray is 𝐩 + 𝑡𝐝, not 𝑡𝐝 alone.",
        ways: &[|p| p.quadratic.offset = Offset::OriginLeftOut],
    }

    /// `r` is used instead of `r^2`.
    RadiusNotSquared "radius-not-squared" {
        advice: "Look at c in the quadratic formula: the radius must be squared, c = |p - center|^2 \
                 - r^2.",
        exercise_feedback: "The radius must be squared: 𝑐 = |𝐩 − centre|² − 𝑟².",
        ways: &[|p| p.quadratic.radius_unsquared = true],
    }

    /// `-b/a` is used as t, or the discriminant is used in place of its square root.
    RootLeftOut "root-left-out" {
        advice: "Look for a square root that is missing: t = (-b - sqrt(D))/a, with D = b^2 - ac.",
        exercise_feedback: "The root of 𝐷 is left out: this is where the ray is closest to the \
            centre.",
        ways: &[
            |p| p.quadratic.square_root = SquareRoot::LeftOut,
            |p| p.quadratic.square_root = SquareRoot::NotTaken,
        ],
    }

    /// The viewport's height is used as its width, and its width as its height.
    ViewportSwapped "viewport-swapped" {
        advice: "Look at the viewport's measures: its width and height are exchanged, and u takes \
                 the width, v the height.",
        ways: &[|p| p.extent = Extent::Swapped],
    }

    /// Half or twice the viewport's width and height are used.
    ViewportScaled "viewport-scaled" {
        advice: "Look at a factor 2 in u and v: across the viewport, u goes from -width/2 to width/2, \
                 and v from height/2 to -height/2. Or the distance is twice or half of what it is.",
        ways: &[|p| p.extent = Extent::Half, |p| p.extent = Extent::Twice],
    }

    /// The direction is the position of the viewport's point, from which the eye was not subtracted.
    EyeInDirection "eye-in-direction" {
        advice: "Look at the direction: it leads from the eye to the point on the viewport, d = \
                 point - eye, and here the eye is in it.",
        ways: &[|p| p.eye_added = true],
    }
}

// These mistakes occur only in answers that are calculated by hand, not in graded programs.
{
    ViewportForEye "viewport-for-eye":
        "Every view ray starts at the eye. (𝑢, 𝑣) is where it passes the viewport.",
    SignOfZ "sign-of-z": "𝑧 has the wrong sign: the camera looks along −𝑧.",
    UvSwapped "uv-swapped": "𝑢 and 𝑣 are exchanged: 𝑢 goes to the right, 𝑣 goes up.",
    VDown "v-down": "𝑣 has the wrong sign: 𝑣 grows upwards.",
    ULeft "u-left": "𝑢 has the wrong sign: 𝑢 grows to the right.",
    UvLeftOut "uv-left-out": "𝑢 and 𝑣 are left out: this is the ray through the middle.",
    UvUnscaled "uv-unscaled":
        "𝑥 and 𝑦 are still those of the viewport: multiply all of 𝐝 by 𝑡, not 𝑧 alone.",
    DistanceOnAll "distance-on-all":
        "Every part is multiplied by the distance. Only the part along 𝐰 must be: 𝑢 and 𝑣 are \
         already measured at the viewport.",
    DistanceOnUv "distance-on-uv":
        "𝑢 and 𝑣 are multiplied by the distance. They are already measured at the viewport: it is \
         the part along 𝐰 that is −distance.",
    ViewportAtOne "viewport-at-one":
        "This is the right line, but 𝑡 = 1 is at distance 1, not on the viewport: do not divide 𝐝 \
         by the distance.",
    FromViewport "from-viewport":
        "This counts from the viewport. 𝑡 counts from the eye: 𝑡 = 1 is the viewport.",
    BasisForgotten "basis-forgotten":
        "These are the camera's coordinates (𝑢, 𝑣, −distance), as if it were not turned. What are \
         they in the world, along 𝐮, 𝐯 and 𝐰?",
    ZIsMinusDistance "z-is-minus-distance":
        "𝐝's 𝑧 is −distance only for the canonical camera: here the step to the \
         viewport is −distance 𝐰.",
    WForwards "w-forwards": "𝐰 points forwards here: it must point backwards, and −𝐰 forwards.",
    ULeftwards "u-leftwards": "𝐮 points left here: it must point right in the image.",
    TurnedOtherWay "turned-other-way":
        "This camera is turned the other way about 𝑦: between which axes does 𝐮 point?",
    UAndWSwapped "u-and-w-swapped": "𝐮 and 𝐰 are exchanged: 𝐮 is right, 𝐰 is backwards.",
    UAndVSwapped "u-and-v-swapped": "𝐮 and 𝐯 are exchanged: 𝐮 is right, 𝐯 is up in the image.",
    BasisUnnormalized "basis-unnormalized":
        "𝐮 and 𝐰 must be of length 1: normalize them before anything is made from them.",
    Unnormalized "unnormalized": "The direction is right, but its length is not 1: normalize it.",
    EyeForgotten "eye-forgotten": "𝐰 is made from at alone: the view goes from eye to at.",
    AtForgotten "at-forgotten": "𝐰 is made from eye alone: the view goes from eye to at.",
    EyePlusAt "eye-plus-at": "𝐰 is made from eye + at. It is eye − at: mind every sign.",
    SignOfT "sign-of-t":
        "The sign is wrong: in front of the ray's origin, 𝑡 is positive; behind it, negative.",
    CoordinateForT "coordinate-for-t":
        "That is how far away the plane is in 𝑧. How many 𝐝 does it take to get there?",
    TInverted "t-inverted": "The quotient is upside down: 𝑡 is the gap divided by 𝐝's step.",
    NormalInwards "normal-inwards": "This points into the sphere: the normal goes outwards.",
    NormalFromOrigin "normal-from-origin":
        "This is the hit seen from the origin: the normal goes from the centre to it.",
    NormalAgainstRay "normal-against-ray":
        "This goes back along the ray: the normal goes from the centre to the hit.",
    CLeftOut "c-left-out": "𝑐 is left out: put 𝐩 + 𝑡𝐝 for 𝑥 and 𝑦, and keep 𝑐.",
    SignOfC "sign-of-c": "𝑐 has the wrong sign: look at which side of the equation it is on.",
    NotDivided "not-divided": "A number multiplies 𝑡 in this equation: divide by it.",
    TermLeftOut "term-left-out":
        "𝑡 is in the part of 𝑥 and in the part of 𝑦: add up both before you divide.",
    PAndDSwapped "p-and-d-swapped": "𝐩 and 𝐝 are exchanged: 𝑡 multiplies 𝐝.",
    LineForRay "line-for-ray":
        "Look at the sign of 𝑡: the ray hits where 𝑡 > 0; where 𝑡 < 0, the line is behind it.",
    CountedFromOther "counted-from-other":
        "This is the centre of another pixel: mind whether the first row and column are number 0 or 1.",
    UvFromCorner "uv-from-corner":
        "This is measured from the image's corner: (𝑢, 𝑣) is (0, 0) in its middle.",
    TAlongUnit "t-along-unit":
        "This goes the distance 𝑡: 𝑡 is in units of |𝐝|, so do not normalize 𝐝.",
    TOnAll "t-on-all": "𝑡 multiplies 𝐝 alone, not 𝐩.",
    CenterMinusP "center-minus-p": "The sign is wrong: it is 𝐩 − centre, from the centre to 𝐩.",
    RadiusLeftOut "radius-left-out": "𝑟² is left out: 𝑐 = |𝐩 − centre|² − 𝑟².",
    FullDiscriminant "full-discriminant":
        "This is 4𝐷, from the whole coefficient of 𝑡 and 4𝑎𝑐: with 𝑏, half of it, 𝐷 = 𝑏² − 𝑎𝑐.",
}
}

impl Mistake {
    /// The mistakes in the window's gallery, those whose wrong camera can be shown, in the order of its
    /// list.
    pub const GALLERY: &'static [Mistake] = &[
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

    /// The mistakes for which a student's answers are checked after those of [`Mistake::GRADED`], but
    /// only alone, not in pairs.
    pub const ALONE: &'static [Mistake] = &[
        Mistake::SignOfB,
        Mistake::CenterLeftOut,
        Mistake::OriginLeftOut,
        Mistake::RadiusNotSquared,
        Mistake::RootLeftOut,
        Mistake::ViewportSwapped,
        Mistake::ViewportScaled,
        Mistake::EyeInDirection,
    ];

    /// Returns the mistake's name in files and commands, such as `w-as-printed`.
    pub fn id(self) -> &'static str {
        self.entry().id
    }

    /// Returns true if the mistake's wrong camera can be shown, which is the case for those of
    /// [`Mistake::GALLERY`].
    pub fn is_in_gallery(self) -> bool {
        Mistake::GALLERY.contains(&self)
    }

    /// Returns the pipeline whose only mistake is this one, in its most common variant.
    pub(crate) fn usual(self) -> Pipeline {
        self.pipelines().next().unwrap_or(Pipeline::RIGHT)
    }

    /// Returns pipelines whose only mistake is this one, one for each of its variants, the most common
    /// first.
    pub(crate) fn pipelines(self) -> impl Iterator<Item = Pipeline> {
        self.pipelines_from(Pipeline::RIGHT)
    }

    /// Returns copies of a pipeline, each with one variant of this mistake added, the most common
    /// first.
    pub(crate) fn pipelines_from(self, pipeline: Pipeline) -> impl Iterator<Item = Pipeline> {
        self.entry().ways.iter().map(move |way| pipeline.with(*way))
    }

    /// Returns true if `other` includes this mistake or is an effect of it, so that `other` need not be
    /// named next to it.
    pub fn is_part_of(self, other: Mistake) -> bool {
        matches!(
            (self, other),
            (Mistake::WNotNormalized, Mistake::NothingNormalized)
                | (Mistake::UIsWCrossUp, Mistake::LeftHanded | Mistake::ULeftwards)
                // Minus the right t may be z itself, or result from a minus in d: its amount is right.
                | (Mistake::SignOfT, Mistake::CoordinateForT | Mistake::SignOfZ)
                | (Mistake::FullDiscriminant, Mistake::BForHalfB)
        )
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}
