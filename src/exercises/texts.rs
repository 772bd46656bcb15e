//! The exercises in words.

use pinhole_core::lecture::exercises::{
    Answer, Asked, Exercise, Finding, Given, Part, Slip, Verdict,
};
use pinhole_core::lecture::{NumberForm, VectorForm};
use pinhole_core::{DVec2, DVec3, shortest};

use super::Said;
use crate::number::written;

/// What the list calls an exercise.
pub fn title(exercise: Exercise) -> &'static str {
    match exercise {
        Exercise::WarmUpRay => "Warm-up 1a: a viewing ray",
        Exercise::WarmUpPlane => "Warm-up 1b: the wall it meets",
        Exercise::Distance => "What if the distance is another",
        Exercise::Turned => "A basis turned by 45°",
        Exercise::ViewUp => "A basis from view and up",
        Exercise::EyeAtUp => "A basis from eye, at and up",
        Exercise::Sphere => "A ray and a sphere",
        Exercise::Lines => "A line and a ray in two dimensions",
    }
}

/// The question, a paragraph each.
pub fn question(given: &Given) -> Vec<String> {
    const CANONICAL: &str =
        "A canonical camera: eye at the origin, looking along −z, viewport 1 × 1 at distance 1.";
    match *given {
        Given::Uv(uv) => vec![
            CANONICAL.to_owned(),
            format!("What is the viewing ray 𝐩 + t 𝐝 through (𝑢, 𝑣) = {}?", pair(uv)),
        ],
        Given::UvAndWall { uv, z } => vec![
            CANONICAL.to_owned(),
            format!(
                "The ray through (𝑢, 𝑣) = {}, with 𝐝 as the lecture builds it, meets the plane \
                 z = {}. At which t, and where?",
                pair(uv),
                number(z)
            ),
        ],
        Given::Distance { uv, distance, z } => vec![
            format!(
                "A canonical camera, but the viewport is at distance {} from the eye.",
                number(distance)
            ),
            format!(
                "What is 𝐝 through (𝑢, 𝑣) = {}, so that t = 1 is on the viewport? At which t is the \
                 plane z = {}?",
                pair(uv),
                number(z)
            ),
        ],
        Given::Turned { right, uv, z } => {
            let axis = |x: f64, name: &str| format!("{}{name}", if x < 0.0 { '−' } else { '+' });
            vec![
                format!(
                    "A camera at the origin, with distance 1, is turned about the y axis: right is \
                     midway between {} and {}, up in the image is +y.",
                    axis(right.x, "x"),
                    axis(right.z, "z")
                ),
                format!(
                    "What are 𝐮, 𝐯 and 𝐰, and 𝐝 = 𝑢 𝐮 + 𝑣 𝐯 − 𝐰 for (𝑢, 𝑣) = {}? At which t does it \
                     meet the plane z = {}?",
                    pair(uv),
                    number(z)
                ),
            ]
        }
        Given::ViewUp { view, up } => vec![
            format!("A camera looks along view = {}, with up = {}.", triple(view), triple(up)),
            "What are 𝐰, 𝐮 and 𝐯?".to_owned(),
        ],
        Given::EyeAtUp { eye, at, up } => vec![
            format!(
                "A camera at eye = {} looks at the point at = {}, with up = {}.",
                triple(eye),
                triple(at),
                triple(up)
            ),
            "What are 𝐰, 𝐮 and 𝐯?".to_owned(),
        ],
        Given::Sphere { ray, sphere } => vec![
            format!(
                "The ray {} + t {} and the sphere around {} of radius {}.",
                triple(ray.origin),
                triple(ray.direction),
                triple(sphere.center),
                number(sphere.radius)
            ),
            "At which t is the first hit, where, and with which outward unit normal?".to_owned(),
        ],
        Given::Lines { line, origin, direction } => vec![
            format!(
                "The line {} = 0 and the ray {} + t {}.",
                implicit(line),
                pair(origin),
                pair(direction)
            ),
            "At which t, and where, does the ray's line meet the other? Does the ray itself (t > 0) \
             hit it?"
                .to_owned(),
        ],
    }
}

/// `2x − y + 1`
fn implicit(line: DVec3) -> String {
    let mut text = String::new();
    for (factor, name) in [(line.x, "x"), (line.y, "y"), (line.z, "")] {
        if factor == 0.0 {
            continue;
        }
        let sign = match (factor < 0.0, text.is_empty()) {
            (false, true) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (true, false) => " − ",
        };
        text.push_str(sign);
        if factor.abs() != 1.0 || name.is_empty() {
            text.push_str(&number(factor.abs()));
        }
        text.push_str(name);
    }
    text
}

/// What a part is called in front of its fields.
pub fn asked(part: &Part) -> &'static str {
    match part.asked {
        Asked::Origin => "𝐩",
        Asked::Direction => "𝐝",
        Asked::T => "t",
        Asked::U => "𝐮",
        Asked::V => "𝐯",
        Asked::W => "𝐰",
        Asked::Point => "point",
        Asked::Normal => "normal",
        Asked::Hits => "the ray hits",
    }
}

/// Whether what is said is that the answer is right.
pub(crate) fn is_good(said: &Said) -> bool {
    matches!(said, Said::Judged(verdict) if verdict.is_right())
}

/// What is said of an answer.
pub(crate) fn said(said: &Said, part: &Part) -> String {
    match said {
        Said::NotAnswered => "Not answered yet.".to_owned(),
        Said::Missing => "One of the numbers is missing.".to_owned(),
        Said::NoNumber(why) => format!("{why}."),
        Said::Judged(verdict) => judged(verdict, part),
    }
}

fn judged(verdict: &Verdict, part: &Part) -> String {
    match verdict {
        Verdict::Right => "Right.".to_owned(),
        Verdict::Multiple { times } => {
            format!("Right: yours is {} times ours, the same ray.", short(*times))
        }
        Verdict::Rounded { digits } => format!(
            "Right to {digits} digits: give it exactly, as in 1/sqrt(2), or with more digits."
        ),
        Verdict::Backwards { times } => {
            format!("Wrong: it points the opposite way, and is {} times ours.", short(*times))
        }
        Verdict::OtherLength { times } if part.asked.is_unit() => {
            format!(
                "Wrong: the direction is right, but the length is {}: it must be 1.",
                short(*times)
            )
        }
        Verdict::OtherLength { times } => format!(
            "Wrong: the direction is right, but it is {} times ours: here its length matters, because t \
             counts in it.",
            short(*times)
        ),
        Verdict::Slips(slips) => format!("Wrong: {}", named(slips)),
        Verdict::Wrong(findings) => {
            let texts: Vec<String> = findings.iter().map(|finding| found(finding, part)).collect();
            format!("Wrong: {}.", texts.join("; "))
        }
    }
}

fn named(slips: &[Slip]) -> String {
    let texts: Vec<&str> = slips.iter().map(|slip| slip.look_at()).collect();
    texts.join(" Or: ")
}

fn found(finding: &Finding, part: &Part) -> String {
    match finding {
        Finding::Zero => "a direction cannot be (0, 0, 0)".to_owned(),
        Finding::Coordinate(k) => format!("{} is another number", ["x", "y", "z"][(*k).min(2)]),
        Finding::Length(length) => format!("its length is {}, not 1", short(*length)),
        Finding::NotOrthogonal { to, dot } => {
            format!("it is not orthogonal to {}: the dot product is {}", bold(to), short(*dot))
        }
        Finding::Another if part.count() == 1 => "it is another number".to_owned(),
        Finding::Another => "every coordinate is another one".to_owned(),
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

/// The right answer, exactly if it can be recognised, and in decimals where that is another text.
pub fn solution(part: &Part, digits: usize) -> String {
    let numbers = match &part.truth {
        Answer::Yes(yes) => return if *yes { "= yes" } else { "= no" }.to_owned(),
        Answer::Numbers(numbers) => numbers,
    };
    let decimals = |x: &f64| written(*x, digits);
    let decimals = listed(&numbers.iter().map(decimals).collect::<Vec<_>>());
    match exact(numbers) {
        Some(exact) if exact == decimals => format!("= {exact}"),
        Some(exact) => format!("= {exact} ≈ {decimals}"),
        None => format!("≈ {decimals}"),
    }
}

/// `5√2`, `(5, 0, −7)/√74`, `(0.2, −0.1, −1)`.
fn exact(numbers: &[f64]) -> Option<String> {
    if let [x, y, z] = *numbers
        && let VectorForm::Common { whole, factor } = VectorForm::of(DVec3::new(x, y, z))?
        && factor.root() > 1
        && factor.is_root_below()
    {
        let whole = whole.map(|n| number(n as f64));
        return Some(format!("{}/√{}", listed(&whole), factor.root()));
    }
    let each: Option<Vec<String>> =
        numbers.iter().map(|x| Some(form(NumberForm::of(*x)?))).collect();
    Some(listed(&each?))
}

fn listed(texts: &[String]) -> String {
    match texts {
        [one] => one.clone(),
        many => format!("({})", many.join(", ")),
    }
}

/// `5√2`, `−1/√2`, `3/7`. Decimals stay decimals.
fn form(form: NumberForm) -> String {
    if form.decimals().is_some() {
        return number(form.value());
    }
    let (n, k, m) = (form.numerator(), form.root(), form.denominator());
    let sign = if n < 0 { "−" } else { "" };
    let above = match (n.unsigned_abs(), k) {
        (n, k) if k == 1 || form.is_root_below() => n.to_string(),
        (1, k) => format!("√{k}"),
        (n, k) => format!("{n}√{k}"),
    };
    match (form.is_root_below(), m) {
        (true, _) => format!("{sign}{above}/√{k}"),
        (false, 1) => format!("{sign}{above}"),
        (false, m) => format!("{sign}{above}/{m}"),
    }
}

fn number(x: f64) -> String {
    shortest(x).replace('-', "−")
}

/// For sentences: exact where it is short.
fn short(x: f64) -> String {
    NumberForm::of(x).map(form).unwrap_or_else(|| written(x, 5))
}

fn pair(v: DVec2) -> String {
    format!("({}, {})", number(v.x), number(v.y))
}

fn triple(v: DVec3) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}
