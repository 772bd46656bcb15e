//! The lecture's exercises, and others of the same kind: what is given, the right answers, the
//! answers that classic mistakes give, and what is to be said of an answer.

mod bases;
mod judge;
mod objects;
mod pick;
mod question_texts;
mod rays;
mod solution;
mod solve;
mod verdict_texts;
mod wanted;

use pinhole_core::{Basis, Camera, DVec2, DVec3, Orientation, Plane, Ray, Sphere, Viewport};

pub use judge::Verdict;
pub use question_texts::{asked, question, title};
pub use solution::solution;
pub use verdict_texts::follows;
pub use wanted::Finding;

use crate::mistakes::Mistake;

/// A kind of question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exercise {
    /// Warm-up 1a: the view ray of a (u, v).
    WarmUpRay,
    /// Warm-up 1b: where it meets a wall.
    WarmUpPlane,
    /// What if the distance is not 1.
    Distance,
    /// A basis by a turn in the xz plane, and a ray of it.
    Turned,
    /// A basis from view and up.
    ViewUp,
    /// A basis from eye, at and up.
    EyeAtUp,
    /// A ray and a sphere.
    Sphere,
    /// A line and a ray in two dimensions.
    Lines,
}

/// What is given in a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// A canonical camera and a place in its viewport.
    Uv(DVec2),
    /// The same, and the plane at this z.
    UvAndWall {
        /// The place.
        uv: DVec2,
        /// The wall's z.
        z: f64,
    },
    /// The canonical camera with another distance, and the same.
    Distance {
        /// The place.
        uv: DVec2,
        /// From eye to viewport.
        distance: f64,
        /// The wall's z.
        z: f64,
    },
    /// A camera at the origin, turned about y, whose right is midway between two axes.
    Turned {
        /// Right: midway between +x or -x and +z or -z.
        right: DVec3,
        /// The place.
        uv: DVec2,
        /// The wall's z.
        z: f64,
    },
    /// A view direction and up.
    ViewUp {
        /// Where the camera looks.
        view: DVec3,
        /// Which way is up.
        up: DVec3,
    },
    /// Two points and up.
    EyeAtUp {
        /// Where the camera is.
        eye: DVec3,
        /// What it looks at.
        at: DVec3,
        /// Which way is up.
        up: DVec3,
    },
    /// A ray and a sphere.
    Sphere {
        /// The ray.
        ray: Ray,
        /// The sphere.
        sphere: Sphere,
    },
    /// `a x + b y + c = 0` and `p + t d`.
    Lines {
        /// a, b and c.
        line: DVec3,
        /// p.
        origin: DVec2,
        /// d.
        direction: DVec2,
    },
}

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Asked {
    /// The ray's origin.
    Origin,
    /// The ray's direction.
    Direction,
    /// Where on the ray.
    T,
    /// Right in the image.
    U,
    /// Up in the image.
    V,
    /// Backwards.
    W,
    /// The point that is hit.
    Point,
    /// The outward unit normal there.
    Normal,
    /// Whether the ray, and not only its line, hits.
    Hits,
}

/// An answer, right or wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// One number, or the coordinates of a point or vector.
    Numbers(Vec<f64>),
    /// Yes or no.
    Yes(bool),
}

/// One thing that a question asks for.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Part {
    /// What.
    pub asked: Asked,
    /// The right answer.
    pub truth: Answer,
    /// Whether every positive multiple is right, too.
    pub may_be_scaled: bool,
    /// Answers that mistakes give.
    pub mistakes: Vec<(Mistake, Answer)>,
    /// What the vector has to be at right angles to, by name.
    orthogonal_to: Vec<(&'static str, DVec3)>,
    /// What else it has to fulfil.
    wanted: Vec<wanted::Wanted>,
}

/// A question with everything that is known of it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Question {
    /// Of which kind.
    pub exercise: Exercise,
    /// The numbers in it.
    pub given: Given,
    /// What it asks for.
    pub parts: Vec<Part>,
}

impl Exercise {
    /// All of them, in the lecture's order.
    pub const ALL: &'static [Exercise] = &[
        Exercise::WarmUpRay,
        Exercise::WarmUpPlane,
        Exercise::Distance,
        Exercise::Turned,
        Exercise::ViewUp,
        Exercise::EyeAtUp,
        Exercise::Sphere,
        Exercise::Lines,
    ];

    /// What files call it.
    pub fn id(self) -> &'static str {
        match self {
            Exercise::WarmUpRay => "warm-up-ray",
            Exercise::WarmUpPlane => "warm-up-plane",
            Exercise::Distance => "distance",
            Exercise::Turned => "turned-basis",
            Exercise::ViewUp => "view-up",
            Exercise::EyeAtUp => "eye-at-up",
            Exercise::Sphere => "sphere",
            Exercise::Lines => "lines",
        }
    }

    /// The exercise of this [`Exercise::id`].
    pub fn from_id(id: &str) -> Option<Exercise> {
        Exercise::ALL.iter().copied().find(|exercise| exercise.id() == id)
    }
}

impl Asked {
    /// What a field is called.
    pub fn id(self) -> &'static str {
        match self {
            Asked::Origin => "p",
            Asked::Direction => "d",
            Asked::T => "t",
            Asked::U => "u",
            Asked::V => "v",
            Asked::W => "w",
            Asked::Point => "point",
            Asked::Normal => "normal",
            Asked::Hits => "hits",
        }
    }

    /// Whether it is of length 1.
    pub fn is_unit(self) -> bool {
        matches!(self, Asked::U | Asked::V | Asked::W | Asked::Normal)
    }

    /// Returns whether what is said of a mistake is about this answer itself, and not about another one
    /// from which this follows.
    pub fn tells(self, mistake: Mistake) -> bool {
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

    /// Whether it is a direction, of which length and sense can be wrong apart from the rest; a point
    /// is none.
    pub fn is_vector(self) -> bool {
        self.is_unit() || self == Asked::Direction
    }
}

impl Question {
    /// The lecture's own question, or, with a seed, another one like it: the same one for the same
    /// seed, everywhere.
    pub fn new(exercise: Exercise, seed: Option<u64>) -> Question {
        let given = match seed {
            None => pick::lecture(exercise),
            Some(seed) => pick::seeded(exercise, seed),
        };
        // What is picked can be solved: every basis exists, and every sphere is met.
        Question { exercise, given, parts: solve::parts(&given).unwrap_or_default() }
    }

    /// What is to be said of the answers, one a part; nothing of a part that was not answered.
    pub fn judge(&self, answers: &[Option<Answer>]) -> Vec<Option<Verdict>> {
        judge::judge(&self.parts, answers)
    }

    /// The part that is told every mistake that part k is told, where all of them are about that one's
    /// answer and none is about this one's.
    pub fn source_of(&self, k: usize, verdicts: &[Option<Verdict>]) -> Option<Asked> {
        let Some(Verdict::Mistakes(mistakes)) = &verdicts[k] else { return None };
        let tells = |asked: Asked, verdict: &Option<Verdict>| match verdict {
            Some(Verdict::Mistakes(told)) => {
                mistakes.iter().all(|mistake| asked.tells(*mistake) && told.contains(mistake))
            }
            _ => false,
        };
        if mistakes.iter().any(|mistake| self.parts[k].asked.tells(*mistake)) {
            return None;
        }
        let mut told = self.parts.iter().zip(verdicts);
        told.find(|(part, told)| tells(part.asked, told)).map(|(part, _)| part.asked)
    }

    /// The camera of the question, where there is one.
    pub fn camera(&self) -> Option<Camera> {
        solve::camera(&self.given)
    }

    /// The place in the viewport that the question's ray passes.
    pub fn uv(&self) -> Option<DVec2> {
        match self.given {
            Given::Uv(uv)
            | Given::UvAndWall { uv, .. }
            | Given::Distance { uv, .. }
            | Given::Turned { uv, .. } => Some(uv),
            Given::Sphere { .. } => Some(DVec2::ZERO),
            _ => None,
        }
    }

    /// The sphere in it.
    pub fn sphere(&self) -> Option<Sphere> {
        match self.given {
            Given::Sphere { sphere, .. } => Some(sphere),
            _ => None,
        }
    }

    /// The wall in it.
    pub fn plane(&self) -> Option<Plane> {
        match self.given {
            Given::UvAndWall { z, .. } | Given::Distance { z, .. } | Given::Turned { z, .. } => {
                Some(solve::wall(z))
            }
            _ => None,
        }
    }
}

impl Part {
    /// How many numbers the answer has; none of a yes or no.
    pub fn count(&self) -> usize {
        match &self.truth {
            Answer::Numbers(numbers) => numbers.len(),
            Answer::Yes(_) => 0,
        }
    }
}

/// The canonical camera with another orientation, eye and distance.
fn camera(eye: DVec3, orientation: Orientation, distance: f64) -> Camera {
    let viewport = Viewport { distance, ..Viewport::CANONICAL };
    Camera { eye, orientation, viewport, ..Camera::CANONICAL }
}

/// A basis turned about y: v is y, and w follows from right.
fn turned(right: DVec3) -> Basis {
    Basis { u: right, v: DVec3::Y, w: right.cross(DVec3::Y) }
}
