//! A grade as one JSON object.

use pinhole_lecture::grading::{Answers, GivenHit, Graded, Right, Worst};
use serde::Serialize;
use serde_json::{Value, json};

/// The fields of the contract, and behind them those that say more.
#[derive(Serialize)]
pub(super) struct Check {
    kind: &'static str,
    answers: usize,
    agree: usize,
    tolerance: f64,
    worst: Value,
    mistakes: Vec<&'static str>,
    advice: String,
    /// Other sets of mistakes that give the same answers.
    alternatives: Vec<Vec<&'static str>>,
    /// Shading that a picture is taken to have.
    shade: Option<&'static str>,
    /// Pixels without an answer, where each counts as a wrong one.
    unanswered: usize,
}

impl Check {
    pub(super) fn new(graded: &Graded) -> Check {
        let grade = &graded.grade;
        let diagnosis = &grade.diagnosis;
        Check {
            kind: grade.kind.name(),
            answers: grade.answers(),
            agree: grade.agree(),
            tolerance: grade.tolerance,
            worst: grade.worst.as_ref().map_or(Value::Null, |worst| worst_of(graded, worst)),
            mistakes: diagnosis.mistakes.iter().map(|mistake| mistake.id()).collect(),
            advice: graded.advice(),
            alternatives: diagnosis
                .alternatives
                .iter()
                .map(|set| set.iter().map(|mistake| mistake.id()).collect())
                .collect(),
            shade: grade.shade.map(|shade| shade.name()),
            unanswered: grade.unanswered,
        }
    }
}

/// The position, the answer given, the right one, and the distance between them: `null` where a hit is
/// taken for a miss or for one of another object, which no number measures. A miss is `"miss"`; nothing
/// is right where there is no such pixel.
fn worst_of(graded: &Graded, worst: &Worst) -> Value {
    let index = worst.index;
    let given = match &graded.answers {
        Answers::Basis(vectors) => json!(vectors[index].value.to_array()),
        Answers::Rays(rays) => {
            let (origin, direction) = (rays[index].origin.value, rays[index].direction.value);
            json!({"origin": origin.to_array(), "direction": direction.to_array()})
        }
        Answers::Hits(hits) => {
            hits[index].hit.map_or(json!("miss"), |GivenHit { t, point, object }| {
                json!({
                    "t": t.map(|t| t.value),
                    "point": point.map(|point| point.value.to_array()),
                    "object": object,
                })
            })
        }
        Answers::Picture(pixels) => json!(pixels[index]),
    };
    let right = match worst.right {
        Right::Vector(vector) => json!(vector.to_array()),
        Right::Ray(ray) => {
            json!({"origin": ray.origin.to_array(), "direction": ray.direction.to_array()})
        }
        Right::Hit(Some(hit)) => {
            json!({"t": hit.t, "point": hit.point.to_array(), "object": hit.object})
        }
        Right::Hit(None) => json!("miss"),
        Right::NoPixel => Value::Null,
        Right::Color(color) => json!(color),
    };
    let name = ["u", "v", "w"].get(index);
    let error = worst.error.is_finite().then_some(worst.error);
    let mut value = json!({"given": given, "right": right, "error": error});
    match graded.pixel(index) {
        Some(pixel) => {
            value["row"] = json!(pixel.row + graded.count_from);
            value["column"] = json!(pixel.column + graded.count_from);
        }
        None => value["vector"] = json!(name),
    }
    value
}
