//! The right answers, and those that mistakes give.

use super::conditions::is_near;
use super::question::{Answer, Given, QuestionPart};
use super::wrong_answers::Wrong;
use super::{bases, objects, rays};

/// The parts of a question; `None` where a basis cannot be found or a sphere is not met. A mistake
/// that changes nothing in its numbers is no wrong answer.
pub(super) fn parts(given: &Given) -> Option<Vec<QuestionPart>> {
    let (mut parts, wrongs) = match *given {
        Given::Uv(uv) => rays::of_uv(uv),
        Given::UvAndWall { uv, z } => rays::and_wall(uv, z),
        Given::Distance { uv, distance, z } => rays::at_distance(uv, distance, z),
        Given::Turned { right, uv, z } => bases::turned_by_hand(right, uv, z),
        Given::ViewUp { .. } | Given::EyeAtUp { .. } => bases::constructed(given)?,
        Given::Sphere { ray, sphere } => objects::sphere(&ray, &sphere)?,
        Given::Lines { line, origin, direction } => objects::lines(line, origin, direction),
    };
    for Wrong { mistake, answers } in wrongs {
        for (asked, answer) in answers {
            let part = parts.iter_mut().find(|part| part.asked == asked);
            if let Some(part) = part.filter(|part| is_another(&part.truth, &answer)) {
                part.mistakes.push((mistake, answer));
            }
        }
    }
    Some(parts)
}

fn is_another(truth: &Answer, answer: &Answer) -> bool {
    match (truth, answer) {
        (Answer::Numbers(truth), Answer::Numbers(answer)) => {
            answer.iter().all(|x| x.is_finite()) && !is_near(answer, truth)
        }
        (truth, answer) => truth != answer,
    }
}
