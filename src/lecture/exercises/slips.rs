//! The mistakes that answers tell.

use super::Asked;

/// A classic mistake in an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Slip {
    /// `w = normalize(view)`, as the lecture prints it.
    WAsPrinted,
    /// `w = normalize(at - eye)`.
    WIsAtMinusEye,
    /// `w = -view`, not normalized, and with it v.
    WNotNormalized,
    /// `u = up x w`, and with it v, not normalized.
    UNotNormalized,
    /// `u = normalize(w x up)`.
    UIsWCrossUp,
    /// `v = u x w`.
    VIsUCrossW,
    /// Both cross products the other way round.
    LeftHanded,
    /// `v = up`.
    UpAsV,
    /// `direction = u*U + v*V - W`.
    DistanceDropped,
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
    /// u counted leftwards.
    ULeft,
    /// The middle ray.
    UvLeftOut,
    /// The point without t times u and v.
    UvUnscaled,
    /// Every part of the direction times the distance.
    DistanceOnAll,
    /// u and v times the distance, and not the step to the viewport.
    DistanceOnUv,
    /// The right line, with t = 1 at distance 1.
    ViewportAtOne,
    /// t counted from the viewport.
    FromViewport,
    /// The direction in the camera's coordinates, not turned into the world's.
    BasisForgotten,
    /// The direction's z is -distance, in a turned camera.
    ZIsMinusDistance,
    /// `+ distance w`.
    PlusW,
    /// w of a basis set by hand points forwards.
    WForwards,
    /// u points left.
    ULeftwards,
    /// Turned about y by the other quarter.
    TurnedOtherWay,
    /// u and w exchanged.
    UAndWSwapped,
    /// u and v exchanged, as vectors.
    UAndVSwapped,
    /// u and w set by hand, not of length 1.
    BasisUnnormalized,
    /// A normal that is not normalized.
    Unnormalized,
    /// w is the view itself, neither turned round nor normalized.
    WIsView,
    /// Neither w nor u is normalized.
    NothingNormalized,
    /// The eye left out: w from at alone.
    EyeForgotten,
    /// At left out: w from the eye alone.
    AtForgotten,
    /// `eye + at`: a minus lost in `eye - at`.
    EyePlusAt,
    /// t with the other sign.
    SignOfT,
    /// The plane's z, with or without its sign, taken for t.
    CoordinateForT,
    /// `t |d|` for t.
    TForDistance,
    /// t upside down.
    TInverted,
    /// The second root.
    FarRoot,
    /// `b` for `-b`.
    SignOfB,
    /// `-b/a`: no root of D.
    RootLeftOut,
    /// `b` of the full quadratic in the D of half of it.
    BForHalfB,
    /// Half of `b` in the D of the full quadratic.
    HalfBForB,
    /// `a` for `2a` below the full quadratic's root.
    DividedByA,
    /// `2a` for `a` below the halved quadratic's root.
    DividedBy2A,
    /// `r` for `r^2`.
    RadiusNotSquared,
    /// `a = d . d` left out.
    ALeftOut,
    /// The normal towards the centre.
    NormalInwards,
    /// The hit point from the origin, in place of from the centre.
    NormalFromOrigin,
    /// `-d` for the normal.
    NormalAgainstRay,
    /// The line's c left out.
    CLeftOut,
    /// The line's c with the other sign.
    SignOfC,
    /// The ray's origin left out.
    OriginLeftOut,
    /// Not divided by what t is multiplied with.
    NotDivided,
    /// One of the two products that t is multiplied with left out.
    TermLeftOut,
    /// p and d exchanged.
    PAndDSwapped,
    /// The line is met, but behind the ray's origin.
    LineForRay,
}

impl Slip {
    /// Whether this mistake is made in the other, too, with one more, or is how the other comes about
    /// and says it, too.
    pub fn is_part_of(self, other: Slip) -> bool {
        matches!(
            (self, other),
            (Slip::WNotNormalized, Slip::NothingNormalized)
                | (Slip::UIsWCrossUp, Slip::LeftHanded | Slip::ULeftwards)
        )
    }

    /// Whether what is said of it is about this answer itself, and not about another one from which
    /// this follows.
    pub fn is_told_by(self, asked: Asked) -> bool {
        match self {
            Slip::WAsPrinted
            | Slip::WIsAtMinusEye
            | Slip::WNotNormalized
            | Slip::WForwards
            | Slip::WIsView
            | Slip::EyeForgotten
            | Slip::AtForgotten
            | Slip::EyePlusAt => asked == Asked::W,
            Slip::UIsWCrossUp | Slip::UNotNormalized | Slip::ULeftwards => asked == Asked::U,
            Slip::VIsUCrossW => asked == Asked::V,
            Slip::LeftHanded
            | Slip::TurnedOtherWay
            | Slip::UAndVSwapped
            | Slip::UAndWSwapped
            | Slip::BasisUnnormalized
            | Slip::NothingNormalized => false,
            Slip::DistanceDropped
            | Slip::SignOfZ
            | Slip::FlatDirection
            | Slip::UvSwapped
            | Slip::VDown
            | Slip::ULeft
            | Slip::UvLeftOut
            | Slip::DistanceOnAll
            | Slip::DistanceOnUv
            | Slip::ViewportAtOne
            | Slip::BasisForgotten
            | Slip::ZIsMinusDistance
            | Slip::PlusW => asked != Asked::T,
            _ => true,
        }
    }

    /// What was done, and what to look at.
    pub fn look_at(self) -> &'static str {
        match self {
            Slip::WAsPrinted => {
                "𝐰 is made of view without the minus: 𝐰 points backwards, so 𝐰 · view must be below 0."
            }
            Slip::WIsAtMinusEye => "at − eye is the view: 𝐰 points the other way, from at to eye.",
            Slip::VIsUCrossW => "𝐯 = 𝐮 × 𝐰 points down: the factors are exchanged.",
            Slip::UNotNormalized => "𝐮 = up × 𝐰 is not normalized, and 𝐯 = 𝐰 × 𝐮 with it.",
            Slip::WNotNormalized => "𝐰 = −view is not normalized, and what is made of it.",
            Slip::DistanceDropped => "The distance is left out: the part along 𝐰 is −distance.",
            Slip::UpAsV => "up is only a hint: 𝐯 = 𝐰 × 𝐮 is at right angles to 𝐰.",
            Slip::UIsWCrossUp => "𝐮 = 𝐰 × up points left: the factors are exchanged.",
            Slip::LeftHanded => "Both cross products are the other way round: up × 𝐰 and 𝐰 × 𝐮.",
            Slip::ViewportForEye => {
                "Every view ray starts at the eye. (𝑢, 𝑣) is where it passes the viewport."
            }
            Slip::SignOfZ => "𝑧 has the wrong sign: the camera looks along −𝑧.",
            Slip::FlatDirection => {
                "This stays in the viewport's plane. How far in front of the eye is the viewport?"
            }
            Slip::UvSwapped => "𝑢 and 𝑣 are exchanged: 𝑢 goes to the right, 𝑣 goes up.",
            Slip::VDown => "𝑣 has the wrong sign: 𝑣 grows upwards.",
            Slip::ULeft => "𝑢 has the wrong sign: 𝑢 grows to the right.",
            Slip::UvLeftOut => "𝑢 and 𝑣 are left out: this is the ray through the middle.",
            Slip::UvUnscaled => {
                "𝑥 and 𝑦 are still those of the viewport: multiply all of 𝐝 by 𝑡, not 𝑧 alone."
            }
            Slip::DistanceOnAll => {
                "Every part is multiplied by the distance. Only the step to the viewport is: 𝑢 and \
                 𝑣 are already measured there."
            }
            Slip::DistanceOnUv => {
                "𝑢 and 𝑣 are multiplied by the distance. They are already measured at the viewport: \
                 it is the part along 𝐰 that is −distance."
            }
            Slip::ViewportAtOne => {
                "This is the right line, but 𝑡 = 1 is at distance 1, not on the viewport: do not \
                 divide 𝐝 by the distance."
            }
            Slip::FromViewport => {
                "This counts from the viewport. 𝑡 counts from the eye: 𝑡 = 1 is the viewport."
            }
            Slip::BasisForgotten => {
                "These are the camera's coordinates (𝑢, 𝑣, −distance), as if it were not turned. \
                 What are they in the world, along 𝐮, 𝐯 and 𝐰?"
            }
            Slip::ZIsMinusDistance => {
                "That 𝐝's 𝑧 is −distance holds for the canonical camera alone: here the step to the \
                 viewport is −distance 𝐰."
            }
            Slip::PlusW => "The part along 𝐰 has the wrong sign: 𝐰 points backwards.",
            Slip::WForwards => "𝐰 points forwards here: it must point backwards, and −𝐰 forwards.",
            Slip::ULeftwards => "𝐮 points left here: it must point right in the image.",
            Slip::TurnedOtherWay => {
                "This camera is turned the other way about 𝑦: between which axes is right?"
            }
            Slip::UAndWSwapped => "𝐮 and 𝐰 are exchanged: 𝐮 is right, 𝐰 is backwards.",
            Slip::UAndVSwapped => "𝐮 and 𝐯 are exchanged: 𝐮 is right, 𝐯 is up in the image.",
            Slip::BasisUnnormalized => {
                "𝐮 and 𝐰 must be of length 1: normalize them before anything is made of them."
            }
            Slip::Unnormalized => "The direction is right, but its length is not 1: normalize it.",
            Slip::WIsView => {
                "𝐰 is view itself: 𝐰 points the other way, and is of length 1: 𝐰 = −view/|view|."
            }
            Slip::NothingNormalized => "𝐰 is not normalized, nor 𝐮, nor what is made of them.",
            Slip::EyeForgotten => "𝐰 is made of at alone: the view goes from eye to at.",
            Slip::AtForgotten => "𝐰 is made of eye alone: the view goes from eye to at.",
            Slip::EyePlusAt => "𝐰 is made of eye + at. It is eye − at: mind every sign.",
            Slip::SignOfT => {
                "The sign is wrong: in front of the ray's origin, 𝑡 is positive; behind it, negative."
            }
            Slip::CoordinateForT => {
                "That is how far away the plane is in 𝑧. How many 𝐝 does it take to get there?"
            }
            Slip::TForDistance => {
                "That is the distance along the ray. 𝑡 counts in lengths of 𝐝, and |𝐝| is not 1."
            }
            Slip::TInverted => "The quotient is upside down: 𝑡 is the gap divided by 𝐝's step.",
            Slip::FarRoot => "That is the second root, where the ray leaves. Which one is first?",
            Slip::SignOfB => "The sign of 𝑏 is lost: 𝑡 begins with −𝑏, and 𝑏 is negative here.",
            Slip::RootLeftOut => {
                "The root of 𝐷 is left out: this is where the ray is closest to the centre."
            }
            Slip::BForHalfB => {
                "𝑏 has a factor 2 too much: with 𝑏 = 𝐝 · (𝐩 − centre), 𝐷 is 𝑏² − 𝑎𝑐 and the root is \
                 divided by 𝑎."
            }
            Slip::HalfBForB => "𝑏 lacks a factor 2: where 𝐷 is 𝑏² − 4𝑎𝑐, 𝑏 = 2 𝐝 · (𝐩 − centre).",
            Slip::DividedByA => {
                "This is twice what it should be: where 𝑏 = 2 𝐝 · (𝐩 − centre), divide by 2𝑎, not by 𝑎."
            }
            Slip::DividedBy2A => {
                "This is half of what it should be: where 𝑏 = 𝐝 · (𝐩 − centre), without a 2, divide by \
                 𝑎, not by 2𝑎."
            }
            Slip::RadiusNotSquared => "The radius must be squared: 𝑐 = |𝐩 − centre|² − 𝑟².",
            Slip::ALeftOut => "𝑎 = 𝐝 · 𝐝 is left out: it is 1 only where |𝐝| is.",
            Slip::NormalInwards => "This points into the sphere: the normal goes outwards.",
            Slip::NormalFromOrigin => {
                "This is the hit seen from the origin: the normal goes from the centre to it."
            }
            Slip::NormalAgainstRay => {
                "This goes back along the ray: the normal goes from the centre to the hit."
            }
            Slip::CLeftOut => "𝑐 is left out: put 𝐩 + 𝑡𝐝 for 𝑥 and 𝑦, and keep 𝑐.",
            Slip::SignOfC => "𝑐 has the wrong sign: look at which side of the equation it is on.",
            Slip::OriginLeftOut => "𝐩 is left out: 𝐩 + 𝑡𝐝 goes in, not 𝑡𝐝 alone.",
            Slip::NotDivided => {
                "Divide by all that 𝑡 is multiplied with: 𝐝's step across the line."
            }
            Slip::TermLeftOut => {
                "𝑡 is in the part of 𝑥 and in the part of 𝑦: add up both before you divide."
            }
            Slip::PAndDSwapped => "𝐩 and 𝐝 are exchanged: 𝑡 multiplies 𝐝.",
            Slip::LineForRay => {
                "Look at the sign of 𝑡: the line is met behind the ray's origin where 𝑡 < 0."
            }
        }
    }
}
