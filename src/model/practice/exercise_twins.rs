//! The open exercise as the world view draws it: what is given, what was typed, and, once it is no
//! secret any more, what is right.

use pinhole_core::{DVec2, DVec3, Ray};
use pinhole_lecture::exercises::{Answer, Asked, Given, QuestionPart};

use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::practice::exercises::{Exercises, Feedback, TypedAnswer};
use crate::model::practice::twin::{Twin, TwinShape};

/// The vectors that a question may ask for, in the order in which twins number them.
const BASIS: [Asked; 3] = [Asked::U, Asked::V, Asked::W];

/// A part of the question with its answers.
struct Answered<'a> {
    typed: &'a TypedAnswer,
    /// The right numbers, once they may be seen.
    right: Option<&'a [f64]>,
    /// The typed numbers, unless they are known to be right.
    yours: Option<Vec<f64>>,
}

impl Answered<'_> {
    /// Returns `u?` as long as the answer was not checked, and then `your u`.
    fn label(&self, name: &str) -> String {
        match self.typed.is_judged {
            false => format!("{name}?"),
            true => format!("your {name}"),
        }
    }

    fn right_vector(&self) -> Option<DVec3> {
        self.right.and_then(vector)
    }

    fn your_vector(&self) -> Option<DVec3> {
        self.yours.as_deref().and_then(vector)
    }
}

fn vector(numbers: &[f64]) -> Option<DVec3> {
    let vector = DVec3::from_array(numbers.try_into().ok()?);
    vector.is_finite().then_some(vector)
}

impl Exercises {
    /// Returns true if the right answer to this part may be seen.
    fn may_be_seen(&self, typed: &TypedAnswer) -> bool {
        self.is_solved || typed.feedback.as_ref().is_some_and(Feedback::is_good)
    }

    fn answered(&self, asked: Asked) -> Option<Answered<'_>> {
        let mut parts = self.question().parts.iter().zip(&self.answers);
        let (part, typed) = parts.find(|(part, _)| part.asked == asked)?;
        Some(self.answers_of(part, typed))
    }

    fn answers_of<'a>(&self, part: &'a QuestionPart, typed: &'a TypedAnswer) -> Answered<'a> {
        let right = match &part.truth {
            Answer::Numbers(numbers) if self.may_be_seen(typed) => Some(numbers.as_slice()),
            _ => None,
        };
        let is_right = typed.feedback.as_ref().is_some_and(Feedback::is_good);
        Answered { typed, right, yours: typed.numbers().filter(|_| !is_right) }
    }

    /// Returns the overlay items that give away no answer.
    pub(crate) fn items(&self, usual: OverlayItems) -> OverlayItems {
        let hidden = [
            Item::Handles,
            Item::Loupe,
            Item::Ray,
            Item::Hit,
            Item::Picture,
            Item::PixelGrid,
            Item::Marks,
        ];
        let items = hidden.into_iter().fold(usual, |items, item| items.with(item, false));
        let asked = BASIS.map(|asked| self.answered(asked));
        if asked.iter().all(Option::is_none) {
            return items;
        }
        // Frustum and viewport show all three vectors.
        let is_secret = asked.iter().flatten().any(|answer| answer.right.is_none());
        let items = items.with(Item::Basis, false);
        let shows = |item| items.shows(item) && !is_secret;
        items.with(Item::Frustum, shows(Item::Frustum)).with(Item::Viewport, shows(Item::Viewport))
    }

    /// Returns the answers to draw in the scene of [`Exercises::document`].
    pub(crate) fn twins(&self) -> Vec<Twin> {
        let mut twins = Vec::new();
        for (index, (asked, name)) in BASIS.into_iter().zip(["u", "v", "w"]).enumerate() {
            let Some(answer) = self.answered(asked) else { continue };
            let shape = |vector| TwinShape::BasisVector(index, vector);
            twins.extend(answer.right_vector().map(|u| Twin::right(shape(u), name)));
            twins.extend(answer.your_vector().map(|u| Twin::yours(shape(u), answer.label(name))));
        }
        self.ray_twins(&mut twins);
        self.hit_twins(&mut twins);
        twins
    }

    /// Returns the ray that the question gives, or that an earlier question was about.
    fn given_ray(&self) -> Option<Ray> {
        match self.question().given {
            Given::Sphere { ray, .. } => Some(ray),
            _ => Some(self.question().camera()?.resolve().ok()?.ray(self.question().uv()?)),
        }
    }

    /// Adds the rays, and the points at the t on them.
    fn ray_twins(&self, twins: &mut Vec<Twin>) {
        let Some(given) = self.given_ray() else { return };
        let t = self.answered(Asked::T);
        let right_t = t.as_ref().and_then(|t| t.right).map(|t| t[0]);
        let your_t = t.as_ref().and_then(|t| t.yours.as_ref()).map(|t| t[0]);
        let typed_t = t.as_ref().and_then(|t| t.typed.numbers()).map(|t| t[0]);
        let Some(direction) = self.answered(Asked::Direction) else {
            twins.push(Twin::right(TwinShape::Direction(given), "d"));
            if let (Some(t), Some(at)) = (&t, your_t) {
                twins.push(Twin::yours(TwinShape::OnRay(given, at), t.label("t")));
            }
            return;
        };
        if let Some(d) = direction.right_vector() {
            let ray = Ray { direction: d, ..given };
            twins.push(Twin::right(TwinShape::Ray(ray, right_t), "ray"));
            if let (Some(t), Some(at), None) = (&t, your_t, direction.your_vector()) {
                twins.push(Twin::yours(TwinShape::OnRay(ray, at), t.label("t")));
            }
        }
        let typed_p = self.answered(Asked::Origin).and_then(|p| vector(&p.typed.numbers()?));
        let origin = typed_p.unwrap_or(given.origin);
        if let Some(ray) = direction.your_vector().and_then(|d| Ray::new(origin, d).ok()) {
            twins.push(Twin::yours(TwinShape::Ray(ray, typed_t), direction.label("ray")));
        } else if let Some(p) = self.answered(Asked::Origin)
            && let Some(at) = p.your_vector()
        {
            twins.push(Twin::yours(TwinShape::Point(at), p.label("p")));
        }
    }

    /// Adds the points that are hit, and the normals there.
    fn hit_twins(&self, twins: &mut Vec<Twin>) {
        let point = self.answered(Asked::Point);
        let right = point.as_ref().and_then(Answered::right_vector);
        let yours = point.as_ref().and_then(Answered::your_vector);
        twins.extend(right.map(|at| Twin::right(TwinShape::Point(at), "hit")));
        if let (Some(point), Some(at)) = (&point, yours) {
            twins.push(Twin::yours(TwinShape::Point(at), point.label("hit")));
        }
        let Some(normal) = self.answered(Asked::Normal) else { return };
        // The typed point, if there is one, gives nothing away.
        let typed = point.as_ref().and_then(|point| vector(&point.typed.numbers()?));
        if let (Some(at), Some(n)) = (right, normal.right_vector()) {
            twins.push(Twin::right(TwinShape::Normal(at, n), "n"));
        }
        if let (Some(at), Some(n)) = (typed.or(right), normal.your_vector()) {
            twins.push(Twin::yours(TwinShape::Normal(at, n), normal.label("n")));
        }
    }

    /// Returns the typed points of a question in two dimensions, with their labels.
    pub(crate) fn points_in_plane(&self) -> Vec<(String, DVec2)> {
        let Given::Lines { origin, direction, .. } = self.question().given else {
            return Vec::new();
        };
        let mut points = Vec::new();
        if let Some(t) = self.answered(Asked::T)
            && let Some([at]) = t.yours.as_deref()
        {
            points.push((t.label("t"), origin + *at * direction));
        }
        if let Some(point) = self.answered(Asked::Point)
            && let Some([x, y]) = point.yours.as_deref()
        {
            points.push((point.label("point"), DVec2::new(*x, *y)));
        }
        points.retain(|(_, at)| at.is_finite());
        points
    }

    /// Returns the right t, if it is asked for.
    pub(crate) fn right_t(&self) -> Option<f64> {
        let part = self.question().parts.iter().find(|part| part.asked == Asked::T)?;
        match &part.truth {
            Answer::Numbers(numbers) => numbers.first().copied(),
            Answer::Yes(_) => None,
        }
    }

    /// Returns true if all right answers may be seen.
    pub(crate) fn shows_all(&self) -> bool {
        self.answers.iter().all(|typed| self.may_be_seen(typed))
    }
}
