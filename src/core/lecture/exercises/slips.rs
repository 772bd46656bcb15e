//! The mistakes that answers tell.

use crate::lecture::mistakes::Mistake;

/// A classic mistake in an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slip {
    /// One of the wrong cameras'.
    Camera(Mistake),
    /// A point of the viewport taken for the eye.
    ViewportForEye,
    /// The direction's z without its minus.
    SignOfZ,
    /// No step from the eye to the viewport at all.
    FlatDirection,
    /// u and v exchanged.
    UvSwapped,
    /// v counted downwards.
    VDown,
    /// Every part of the direction times the distance.
    DistanceOnAll,
    /// The direction in the camera's coordinates, not turned into the world's.
    BasisForgotten,
    /// `+ distance w`.
    PlusW,
    /// u and w exchanged.
    UAndWSwapped,
    /// u and v exchanged, as vectors.
    UAndVSwapped,
    /// A vector where it is not normalized.
    Unnormalized,
    /// The eye left out: w from at alone.
    EyeForgotten,
    /// t with the other sign.
    SignOfT,
    /// The coordinate that is met, taken for t.
    CoordinateForT,
    /// `t |d|` for t.
    TForDistance,
    /// t upside down.
    TInverted,
    /// The second root.
    FarRoot,
    /// `b` of the full quadratic in the formula for half of it.
    BForHalfB,
    /// `r` for `r^2`.
    RadiusNotSquared,
    /// `a = d . d` left out.
    ALeftOut,
    /// The normal towards the centre.
    NormalInwards,
    /// The hit point from the origin, in place of from the centre.
    NormalFromOrigin,
    /// The line's c left out.
    CLeftOut,
    /// The line's c with the other sign.
    SignOfC,
    /// The ray's origin left out.
    OriginLeftOut,
    /// The line is met, but behind the ray's origin.
    LineForRay,
}

impl Slip {
    /// What files and tests call it.
    pub fn id(self) -> &'static str {
        match self {
            Slip::Camera(mistake) => mistake.id(),
            Slip::ViewportForEye => "viewport-for-eye",
            Slip::SignOfZ => "sign-of-z",
            Slip::FlatDirection => "flat-direction",
            Slip::UvSwapped => "uv-swapped",
            Slip::VDown => "v-down",
            Slip::DistanceOnAll => "distance-on-all",
            Slip::BasisForgotten => "basis-forgotten",
            Slip::PlusW => "plus-w",
            Slip::UAndWSwapped => "u-and-w-swapped",
            Slip::UAndVSwapped => "u-and-v-swapped",
            Slip::Unnormalized => "unnormalized",
            Slip::EyeForgotten => "eye-forgotten",
            Slip::SignOfT => "negative-t",
            Slip::CoordinateForT => "coordinate-for-t",
            Slip::TForDistance => "t-for-distance",
            Slip::TInverted => "t-inverted",
            Slip::FarRoot => "far-root",
            Slip::BForHalfB => "b-for-half-b",
            Slip::RadiusNotSquared => "radius-not-squared",
            Slip::ALeftOut => "a-left-out",
            Slip::NormalInwards => "normal-inwards",
            Slip::NormalFromOrigin => "normal-from-origin",
            Slip::CLeftOut => "c-left-out",
            Slip::SignOfC => "sign-of-c",
            Slip::OriginLeftOut => "origin-left-out",
            Slip::LineForRay => "line-for-ray",
        }
    }

    /// What was done, and what to look at.
    pub fn look_at(self) -> &'static str {
        match self {
            Slip::Camera(mistake) => camera(mistake),
            Slip::ViewportForEye => {
                "That is where the ray passes the viewport. Where does every view ray start?"
            }
            Slip::SignOfZ => "z has the wrong sign: the camera looks along −z.",
            Slip::FlatDirection => {
                "This stays in the viewport's plane. How far in front of the eye is the viewport?"
            }
            Slip::UvSwapped => "𝑢 and 𝑣 are exchanged: 𝑢 goes to the right, 𝑣 goes up.",
            Slip::VDown => "𝑣 has the wrong sign: 𝑣 grows upwards.",
            Slip::DistanceOnAll => {
                "Every part is multiplied by the distance. Only the step to the viewport is: 𝑢 and \
                 𝑣 are already measured there."
            }
            Slip::BasisForgotten => {
                "These are the camera's coordinates (𝑢, 𝑣, −distance). What are they in the world, \
                 along 𝐮, 𝐯 and 𝐰?"
            }
            Slip::PlusW => "The part along 𝐰 has the wrong sign: 𝐰 points backwards.",
            Slip::UAndWSwapped => "𝐮 and 𝐰 are exchanged: 𝐮 is right, 𝐰 is backwards.",
            Slip::UAndVSwapped => "𝐮 and 𝐯 are exchanged: 𝐮 is right, 𝐯 is up in the image.",
            Slip::Unnormalized => "The direction is right, but its length is not 1: normalize it.",
            Slip::EyeForgotten => "𝐰 is made of at alone: the view goes from eye to at.",
            Slip::SignOfT => {
                "The sign is wrong: in front of the ray's origin, t is positive; behind it, negative."
            }
            Slip::CoordinateForT => {
                "That is a coordinate of the point. How many 𝐝 does it take to get there?"
            }
            Slip::TForDistance => {
                "That is the distance along the ray. t counts in lengths of 𝐝, and |𝐝| is not 1."
            }
            Slip::TInverted => "The quotient is upside down: t is the gap divided by 𝐝's step.",
            Slip::FarRoot => "That is the second root, where the ray leaves. Which one is first?",
            Slip::BForHalfB => {
                "b has a factor 2 too much: with b = 𝐝 · (𝐩 − centre), D is b² − ac and the root \
                 is divided by a."
            }
            Slip::RadiusNotSquared => "The radius must be squared: c = |𝐩 − centre|² − r².",
            Slip::ALeftOut => "a = 𝐝 · 𝐝 is left out: it is 1 only where |𝐝| is.",
            Slip::NormalInwards => "This points into the sphere: the normal goes outwards.",
            Slip::NormalFromOrigin => {
                "This is the hit seen from the origin: the normal goes from the centre to it."
            }
            Slip::CLeftOut => "c is left out: put p + t d for x and y, and keep c.",
            Slip::SignOfC => "c has the wrong sign: look at which side of the equation it is on.",
            Slip::OriginLeftOut => "𝐩 is left out: x = pₓ + t dₓ, not t dₓ alone.",
            Slip::LineForRay => {
                "Look at the sign of t: the line is met behind the ray's origin where t < 0."
            }
        }
    }
}

fn camera(mistake: Mistake) -> &'static str {
    match mistake {
        Mistake::WAsPrinted => {
            "𝐰 is made of view without the minus: 𝐰 points backwards, so 𝐰 · view must be below 0."
        }
        Mistake::WIsAtMinusEye => "at − eye is the view: 𝐰 points the other way, from at to eye.",
        Mistake::VIsUCrossW => "𝐯 = 𝐮 × 𝐰 points down: the factors are exchanged.",
        Mistake::NotNormalized => "𝐮 = up × 𝐰 is not normalized, and 𝐯 = 𝐰 × 𝐮 with it.",
        Mistake::WNotNormalized => "𝐰 = −view is not normalized, and what is made of it.",
        Mistake::DistanceDropped => "The distance is left out: the part along 𝐰 is −distance.",
        Mistake::UpAsV => "up is only a hint: 𝐯 = 𝐰 × 𝐮 is at right angles to 𝐰.",
        Mistake::UIsWCrossUp => "𝐮 = 𝐰 × up points left: the factors are exchanged.",
        Mistake::LeftHanded => "Both cross products are the other way round: up × 𝐰 and 𝐰 × 𝐮.",
        Mistake::PixelCorner
        | Mistake::RowsFromBottom
        | Mistake::RowsColumnsSwapped
        | Mistake::CountedFromOne
        | Mistake::AspectDropped => mistake.shows(),
    }
}
