//! Verdicts in words.

use super::conditions::Finding;
use super::judge::{ENOUGH_DIGITS, Verdict};
use super::question::{Asked, QuestionPart};
use super::question_texts::name;
use super::short_numbers::short;
use crate::mistakes::Mistake;

impl Verdict {
    /// The verdict on an answer to this part, in words.
    pub fn sentence(&self, part: &QuestionPart) -> String {
        match self {
            Verdict::Right => "Right.".to_owned(),
            Verdict::Multiple { times } => {
                format!("Right: yours is {} times ours, the same ray.", short(*times))
            }
            Verdict::Rounded { digits } if self.is_right() => format!("Right, to {digits} digits."),
            Verdict::Rounded { digits } => format!(
                "Right to {digits} digits: type at least {ENOUGH_DIGITS}, or give it exactly, as in \
                 1/sqrt(2)."
            ),
            // What is −1 but for the last digits is written as −1.
            Verdict::Backwards { times } if short(*times) == "−1" => {
                "Wrong: it points the opposite way: it is minus ours.".to_owned()
            }
            Verdict::Backwards { times } => {
                format!("Wrong: it points the opposite way: it is {} times ours.", short(*times))
            }
            Verdict::OtherLength { times } if part.asked.is_unit() => {
                format!(
                    "Wrong: the direction is right, but the length is {}: it must be 1.",
                    short(*times)
                )
            }
            Verdict::OtherLength { times } => format!(
                "Wrong: the direction is right, but it is {} times ours: here its length matters, because 𝑡 \
                 is in units of it.",
                short(*times)
            ),
            Verdict::Mistakes(mistakes) => format!("Wrong: {}", named(mistakes)),
            Verdict::Wrong(findings) => {
                let texts: Vec<String> =
                    findings.iter().map(|finding| found(finding, part)).collect();
                format!("Wrong: {}.", texts.join("; "))
            }
        }
    }
}

fn named(mistakes: &[Mistake]) -> String {
    let texts: Vec<&str> = mistakes.iter().map(|mistake| mistake.told()).collect();
    texts.join(" Or: ")
}

fn found(finding: &Finding, part: &QuestionPart) -> String {
    let is_t = part.asked == Asked::T;
    match *finding {
        Finding::Zero => "a direction cannot be (0, 0, 0)".to_owned(),
        Finding::Coordinate(k) => {
            format!("{} should be another number", ["𝑥", "𝑦", "𝑧"][k.min(2)])
        }
        Finding::Length(length) => format!("its length is {}, not 1", short(length)),
        Finding::NotOrthogonal { to, dot } => {
            format!("it is not perpendicular to {}: the dot product is {}", bold(to), short(dot))
        }
        Finding::Angle { degrees } => {
            let from = match part.asked {
                Asked::U => "right in the image",
                Asked::V => "up in the image",
                Asked::W => "straight backwards",
                _ => "the direction from the centre to the hit",
            };
            format!("it is {}° off {from}", short(degrees))
        }
        Finding::OffWall { z, wall } if is_t => {
            format!("at this 𝑡, 𝑧 is {}, not the wall's {}", short(z), short(wall))
        }
        Finding::OffWall { z, wall } => {
            format!("its 𝑧 is {}, not the wall's {}", short(z), short(wall))
        }
        Finding::OffSphere { distance, radius } => format!(
            "{} is not on the sphere: it is {} from the centre, and the radius is {}",
            if is_t { "the point at this 𝑡" } else { "it" },
            short(distance),
            short(radius)
        ),
        Finding::OffLine { value } => format!(
            "{} is not on the line: put into its equation, it gives {}, not 0",
            if is_t { "the point at this 𝑡" } else { "it" },
            short(value)
        ),
        Finding::OffRay { distance } => {
            format!("it is not on the ray, but {} away from it", short(distance))
        }
        Finding::OffEye { distance } => {
            format!("it is {} from the eye, where every view ray starts", short(distance))
        }
        Finding::OffUv { uv, wanted } => {
            let [passed, wanted] =
                [uv, wanted].map(|uv| format!("({}, {})", short(uv.x), short(uv.y)));
            format!("it passes the viewport at (𝑢, 𝑣) = {passed}, not {wanted}")
        }
        Finding::NotForwards { along_w } => {
            format!("it does not point forwards: 𝐝 · 𝐰 is {}, and must be below 0", short(along_w))
        }
        Finding::Another if part.count() == 1 => "it should be another number".to_owned(),
        Finding::Another => "every coordinate should be another number".to_owned(),
    }
}

fn bold(name: &str) -> &str {
    match name {
        "u" => "𝐮",
        "v" => "𝐯",
        "w" => "𝐰",
        other => other,
    }
}

/// The verdict on a part whose answer follows from that to another one.
pub fn follows(source: Asked) -> String {
    format!("Wrong: it follows from {}.", name(source))
}
