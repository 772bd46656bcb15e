//! What a question consists of: the given numbers, the quantities to find, and the answers.

use pinhole_core::{DVec2, DVec3, ImageSize, Pixel, Ray, Sphere};

use super::judge::Condition;
use crate::mistakes::Mistake;

pinhole_core::texts! {
    /// A kind of question.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Exercise[2];
    {
        /// Returns the name in lesson files and codes.
        id,
        /// Returns the title.
        title,
    }
    /// Warm-up 1a: the view ray through a point (u, v).
    WarmUpRay: "warm-up-ray", "Warm-up 1a: a viewing ray";
    /// Warm-up 1b: the intersection of that ray with a wall.
    WarmUpPlane: "warm-up-plane", "Warm-up 1b: the wall it meets";
    /// A view ray and a wall, for a viewport whose distance is not 1.
    Distance: "distance", "A different distance";
    /// A basis that is turned about the y axis, and one of the camera's rays.
    Turned: "turned-basis", "A basis turned by 45°";
    /// A basis from view and up.
    ViewUp: "view-up", "A basis from view and up";
    /// A basis from eye, at and up.
    EyeAtUp: "eye-at-up", "A basis from eye, at and up";
    /// A ray and a sphere.
    Sphere: "sphere", "A ray and a sphere";
    /// A line and a ray in two dimensions.
    Lines: "lines", "A line and a ray in two dimensions";
    /// The point (u, v) of a pixel's centre.
    PixelUv: "pixel-uv", "A pixel's (u, v)";
    /// The point of a ray at a given t.
    PointAt: "point-at-t", "The point at t";
    /// The coefficients and the discriminant of the equation for t of a ray and a sphere.
    Coefficients: "coefficients", "a, b, c and D of a ray and a sphere";
}

/// The numbers given in a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// The canonical camera and a point of its viewport.
    Uv(DVec2),
    /// The canonical camera, a point of its viewport, and a wall, which is the plane with this z.
    UvAndWall {
        /// The point (u, v).
        uv: DVec2,
        /// The wall's z.
        z: f64,
    },
    /// The canonical camera with another distance, a point of its viewport, and a wall.
    Distance {
        /// The point (u, v).
        uv: DVec2,
        /// The viewport's distance from the eye.
        distance: f64,
        /// The wall's z.
        z: f64,
    },
    /// A camera at the origin that is turned about y, so that its right vector, u, is midway between
    /// two axes.
    Turned {
        /// The right vector, midway between +x or -x and +z or -z.
        right: DVec3,
        /// The point (u, v).
        uv: DVec2,
        /// The wall's z.
        z: f64,
    },
    /// A view direction and up.
    ViewUp {
        /// The direction in which the camera looks.
        view: DVec3,
        /// The up vector.
        up: DVec3,
    },
    /// Two points and up.
    EyeAtUp {
        /// The camera's position.
        eye: DVec3,
        /// The point that the camera looks at.
        at: DVec3,
        /// The up vector.
        up: DVec3,
    },
    /// A ray and a sphere.
    Sphere {
        /// The ray.
        ray: Ray,
        /// The sphere.
        sphere: Sphere,
    },
    /// Two lines in two dimensions: the implicit `a x + b y + c = 0` and the parametric `p + t d`.
    Lines {
        /// a, b and c.
        line: DVec3,
        /// p.
        origin: DVec2,
        /// d.
        direction: DVec2,
    },
    /// The canonical camera with this image, and a pixel.
    Pixel {
        /// W and H.
        image: ImageSize,
        /// The pixel.
        pixel: Pixel,
        /// True if the question counts rows and columns from 1, as in the lecture.
        from_one: bool,
    },
    /// A canonical camera that was moved, and its ray through a point of the viewport.
    PointAt {
        /// The camera's position.
        eye: DVec3,
        /// The point (u, v).
        uv: DVec2,
        /// The ray's t.
        t: f64,
    },
    /// A ray and a sphere, of which the equation for t is to be found.
    Coefficients {
        /// The ray.
        ray: Ray,
        /// The sphere.
        sphere: Sphere,
    },
}

pinhole_core::texts! {
    /// A quantity that the student must find.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Asked[2];
    {
        /// Returns the name of the answer's field.
        id,
        /// Returns the quantity's symbol, for the label in front of the text fields of its answer.
        symbol,
    }
    /// The ray's origin.
    Origin: "p", "𝐩";
    /// The ray's direction.
    Direction: "d", "𝐝";
    /// The ray's t.
    T: "t", "𝑡";
    /// The vector u, which points to the right in the image.
    U: "u", "𝐮";
    /// The vector v, which points upwards in the image.
    V: "v", "𝐯";
    /// The vector w, which points opposite to the view direction.
    W: "w", "𝐰";
    /// The hit point.
    Point: "point", "point";
    /// The outward unit normal at the hit point.
    Normal: "normal", "normal";
    /// Whether the ray itself hits (t > 0), and not only the line on which it lies.
    Hits: "hits", "the ray hits";
    /// The point (u, v) of the viewport.
    Uv: "uv", "(𝑢, 𝑣)";
    /// a in `a t^2 + 2 b t + c = 0`, the equation of a ray and a sphere.
    A: "a", "𝑎";
    /// b in it, half of the coefficient of t.
    B: "b", "𝑏";
    /// c in it.
    C: "c", "𝑐";
    /// Its discriminant, `D = b^2 - a c`.
    Discriminant: "D", "𝐷";
}

/// An answer, right or wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// One number, or the coordinates of a point or vector.
    Numbers(Vec<f64>),
    /// Yes or no.
    Yes(bool),
}

/// One of the quantities that a question asks for, with its right answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct QuestionPart {
    /// The quantity to find.
    pub asked: Asked,
    /// The right answer.
    pub truth: Answer,
    /// True if every positive multiple of the right answer also counts as right.
    pub may_be_scaled: bool,
    /// The wrong answers to which known mistakes lead.
    pub mistakes: Vec<(Mistake, Answer)>,
    /// The vectors to which the answer must be perpendicular, each with its name for the verdict.
    pub(super) orthogonal_to: Vec<(&'static str, DVec3)>,
    /// Further conditions that the answer must meet.
    pub(super) conditions: Vec<Condition>,
}

/// A question with its given numbers, the right answers, and the wrong answers to which mistakes lead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Question {
    /// The kind of question.
    pub exercise: Exercise,
    /// The given numbers.
    pub given: Given,
    /// The quantities to find.
    pub parts: Vec<QuestionPart>,
}

impl Exercise {
    /// All exercises, in the lecture's order.
    pub const LISTED: &'static [Exercise] = &[
        Exercise::PixelUv,
        Exercise::WarmUpRay,
        Exercise::PointAt,
        Exercise::WarmUpPlane,
        Exercise::Distance,
        Exercise::Turned,
        Exercise::ViewUp,
        Exercise::EyeAtUp,
        Exercise::Coefficients,
        Exercise::Sphere,
        Exercise::Lines,
    ];
}

impl Asked {
    /// Returns the names of the quantity's coordinates, as far as it has them, each with its symbol.
    pub fn coordinates(self) -> [(&'static str, &'static str); 3] {
        match self {
            Asked::Uv => [("u", "𝑢"), ("v", "𝑣"), ("", "")],
            _ => [("x", "𝑥"), ("y", "𝑦"), ("z", "𝑧")],
        }
    }

    /// Returns true if the quantity is a vector of length 1.
    pub fn is_unit(self) -> bool {
        matches!(self, Asked::U | Asked::V | Asked::W | Asked::Normal)
    }

    /// Returns true if a mistake is made in calculating this quantity itself, rather than one from
    /// which it is calculated.
    pub fn is_about_mistake(self, mistake: Mistake) -> bool {
        match mistake {
            Mistake::WAsPrinted
            | Mistake::WIsAtMinusEye
            | Mistake::WNotNormalized
            | Mistake::WForwards
            | Mistake::WIsView
            | Mistake::EyeForgotten
            | Mistake::AtForgotten
            | Mistake::EyePlusAt => self == Asked::W,
            Mistake::UIsWCrossUp | Mistake::NotNormalized | Mistake::ULeftwards => self == Asked::U,
            Mistake::VIsUCrossW => self == Asked::V,
            Mistake::LeftHanded
            | Mistake::TurnedOtherWay
            | Mistake::UAndVSwapped
            | Mistake::UAndWSwapped
            | Mistake::BasisUnnormalized
            | Mistake::NothingNormalized => false,
            Mistake::DistanceDropped
            | Mistake::SignOfZ
            | Mistake::FlatDirection
            | Mistake::UvSwapped
            | Mistake::VDown
            | Mistake::ULeft
            | Mistake::UvLeftOut
            | Mistake::DistanceOnAll
            | Mistake::DistanceOnUv
            | Mistake::ViewportAtOne
            | Mistake::BasisForgotten
            | Mistake::ZIsMinusDistance
            | Mistake::DistanceAdded => self != Asked::T,
            _ => true,
        }
    }

    /// Returns true if the quantity is a direction, so that its length or its sign alone can be wrong;
    /// false for points and numbers.
    pub fn is_vector(self) -> bool {
        self.is_unit() || self == Asked::Direction
    }
}

impl QuestionPart {
    /// Returns how many numbers the answer consists of; 0 for a yes-or-no answer.
    pub fn count(&self) -> usize {
        match &self.truth {
            Answer::Numbers(numbers) => numbers.len(),
            Answer::Yes(_) => 0,
        }
    }
}
