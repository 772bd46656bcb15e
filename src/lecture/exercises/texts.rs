//! Writes questions and verdicts in words. In these texts, `**p**` denotes a vector, and `*t*` a
//! scalar. Numbers are written in exact form, such as `1/√2`, where one is recognised.

use pinhole_core::{DVec2, DVec3, ImageSize, Pixel, Ray, Sphere};

use super::judge::{ENOUGH_DIGITS, Verdict};
use super::question::{Asked, Given, QuestionPart};
use crate::numbers::{exact_if_short as short, sum, written_whole as number};

/// Returns the text of a question, one string for each paragraph.
pub fn question(given: &Given) -> Vec<String> {
    const CANONICAL: &str =
        "A canonical camera: eye at the origin, looking along −*z*, viewport 1 × 1 at distance 1.";
    let asked_of_basis =
        "What are **w** (backwards), **u** (to the right) and **v** (up in the image), each of length 1?"
            .to_owned();
    match *given {
        Given::Uv(uv) => {
            let asked =
                format!("What is the viewing ray **p** + *t* **d** through {}?", uv_text(uv));
            let meaning = "**p** is where the ray begins, **d** the direction in which it goes.";
            vec![CANONICAL.to_owned(), asked, meaning.to_owned()]
        }
        Given::UvAndWall { uv, z } => vec![CANONICAL.to_owned(), where_on_wall(uv, z)],
        Given::Distance { uv, distance, z } => at_distance(uv, distance, z),
        Given::Turned { right, uv, z } => turned(right, uv, z),
        Given::ViewUp { view, up } => vec![
            format!("A camera looks along view = {}, with up = {}.", triple(view), triple(up)),
            asked_of_basis,
        ],
        Given::EyeAtUp { eye, at, up } => {
            let (eye, at, up) = (triple(eye), triple(at), triple(up));
            let looks =
                format!("A camera has eye = {eye}, at = {at} and up = {up}.");
            vec![looks, asked_of_basis]
        }
        Given::Sphere { ray, sphere } => vec![
            given_sphere_and_ray(&ray, &sphere),
            "At which *t* is the first hit, where, and with which outward unit normal?".to_owned(),
        ],
        Given::Lines { line, origin, direction } => lines(line, origin, direction),
        Given::Pixel { image, pixel, from_one } => {
            vec![CANONICAL.to_owned(), centre_of_pixel(image, pixel, from_one)]
        }
        Given::PointAt { eye, uv, t } => {
            let ray = format!("{} + *t* {}", triple(eye), triple(uv.extend(-1.0)));
            let camera = format!("A canonical camera was moved to eye = {}.", triple(eye));
            vec![camera, format!("Where is the point at *t* = {} of its ray {ray}?", number(t))]
        }
        Given::Coefficients { ray, sphere } => vec![
            given_sphere_and_ray(&ray, &sphere),
            "The points in both are at the *t* with *a t*² + 2*b t* + *c* = 0. What are *a*, *b*, *c* \
             and *D* = *b*² − *a c*?"
                .to_owned(),
        ],
    }
}

fn centre_of_pixel(image: ImageSize, pixel: Pixel, from_one: bool) -> String {
    let from = u32::from(from_one);
    format!(
        "Its image is {} × {} pixels. Rows and columns are counted from {from}, from the top left. What \
         is (*u*, *v*) at the centre of the pixel in row *i* = {}, column *j* = {}?",
        image.width(),
        image.height(),
        pixel.row + from,
        pixel.column + from
    )
}

fn where_on_wall(uv: DVec2, z: f64) -> String {
    format!(
        "The ray through {}, with **d** as the lecture builds it, meets the plane *z* = {}. At which \
         *t*, and where?",
        uv_text(uv),
        number(z)
    )
}

fn at_distance(uv: DVec2, distance: f64, z: f64) -> Vec<String> {
    let camera = format!(
        "A canonical camera, but the viewport is at distance {} from the eye.",
        number(distance)
    );
    let asked = format!(
        "What is **d** through {}, so that *t* = 1 is on the viewport? At which *t* is the plane \
         *z* = {}?",
        uv_text(uv),
        number(z)
    );
    vec![camera, asked]
}

fn turned(right: DVec3, uv: DVec2, z: f64) -> Vec<String> {
    let axis = |x: f64, name: &str| format!("{}*{name}*", if x < 0.0 { '−' } else { '+' });
    let camera = format!(
        "A camera at the origin, distance 1: right is midway between {} and {}, up is +*y*.",
        axis(right.x, "x"),
        axis(right.z, "z")
    );
    let asked = format!(
        "What are **u**, **v**, **w** and **d** = *u* **u** + *v* **v** − **w** for {}? At which *t* \
         does it meet *z* = {}?",
        uv_text(uv),
        number(z)
    );
    vec![camera, asked]
}

fn given_sphere_and_ray(ray: &Ray, sphere: &Sphere) -> String {
    format!(
        "The ray {} + *t* {} and the sphere around {} of radius {}.",
        triple(ray.origin),
        triple(ray.direction),
        triple(sphere.center),
        number(sphere.radius)
    )
}

fn lines(line: DVec3, origin: DVec2, direction: DVec2) -> Vec<String> {
    let given = format!(
        "The line {} = 0 and the ray {} + *t* {}.",
        sum([(line.x, "*x*"), (line.y, "*y*"), (line.z, "")], number),
        pair(origin),
        pair(direction)
    );
    let asked = "At which *t*, and where, does the ray's line meet the given line? Does the ray itself \
                 (*t* > 0) hit it?";
    vec![given, asked.to_owned()]
}

/// Formats a point of the viewport, for example `(u, v) = (0.2, −0.1)`.
fn uv_text(uv: DVec2) -> String {
    format!("(*u*, *v*) = {}", pair(uv))
}

/// A no-break space, which keeps a vector on one line.
const SPACE: char = '\u{a0}';

fn pair(v: DVec2) -> String {
    format!("({},{SPACE}{})", number(v.x), number(v.y))
}

fn triple(v: DVec3) -> String {
    format!("({},{SPACE}{},{SPACE}{})", number(v.x), number(v.y), number(v.z))
}

impl Verdict {
    /// Returns the verdict on an answer to `part`, in words.
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
            // A number that differs from −1 only in its last digits is displayed as −1.
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
            Verdict::Mistakes(mistakes) => {
                let texts: Vec<&str> =
                    mistakes.iter().map(|mistake| mistake.exercise_feedback()).collect();
                format!("Wrong: {}", texts.join(" Or: "))
            }
            Verdict::Wrong(findings) => format!("Wrong: {}.", findings.join("; ")),
        }
    }
}

/// Returns the verdict, in words, on an answer that is wrong only by the mistake that the verdict on
/// another part, which asks for `source`, already names.
pub fn follows(source: Asked) -> String {
    format!("Wrong, for the same reason as {}.", source.symbol())
}
