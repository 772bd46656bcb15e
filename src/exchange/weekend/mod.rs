//! *Ray Tracing in One Weekend* (P. Shirley, T. D. Black, S. Hollasch, version 4): the lines that set
//! up its `camera`.

mod read;

use pinhole_core::Sphere;

use crate::exchange::code::{Piece, is_of_word, split};
use crate::exchange::sheet::{Sheet, commas, light, n, real};
use crate::exchange::terms::{Pixels, Terms};
use crate::exchange::{Format, Subject, Unsayable, Written};

pub(super) const FORMAT: Format = Format {
    name: "weekend",
    label: "Ray Tracing in One Weekend",
    short: "One Weekend",
    ending: "cc",
    terms: Terms {
        axes: Terms::OURS,
        given_by: "lookfrom, lookat, vup",
        pixels: Pixels::ColumnFirst,
        view: "vfov: vertical, in degrees",
        field: |subject| n(subject.vertical_degrees()),
        distance: "focus_dist: the viewport is there, t = 1 too",
        shape: "square only; image_height = int(image_width / aspect_ratio)",
        lengths: "f64",
    },
    write,
    read: self::read::read,
    claims,
};

fn claims(text: &str) -> bool {
    // The first chapters' programs leave the camera where it is made.
    let is_rendered =
        || [".image_width", ".aspect_ratio", ".render("].iter().all(|w| text.contains(w));
    text.contains("lookfrom")
        || text.contains("focus_dist")
        || is_rendered()
        || is_constructed(text)
}

/// `camera cam(vec3(...), vec3(...), vec3(...), 90, ...)` and `Camera::new(Point3::new(...), ...)`: no
/// other camera is made of three vectors and two numbers.
fn is_constructed(text: &str) -> bool {
    /// No call of it is longer.
    const LONGEST: usize = 2000;
    const VECTORS: [&str; 4] = ["vec3(", "point3(", "Vec3::new(", "Point3::new("];
    let found = text.match_indices("amera").map(|(at, _)| at);
    found.filter(|at| text[..*at].ends_with(['c', 'C'])).any(|at| {
        let before = text[..at - 1].chars().next_back();
        let rest = text[at + "amera".len()..].trim_start_matches(' ');
        let rest = rest.strip_prefix("::new").unwrap_or(rest);
        let rest = rest.trim_start_matches(is_of_word);
        let mut depth = 0_usize;
        let end = rest.char_indices().take(LONGEST).find(|(_, c)| {
            match c {
                '(' => depth += 1,
                ')' => depth = depth.saturating_sub(1),
                _ => (),
            }
            depth == 0
        });
        let inside = end.and_then(|(end, _)| rest.get(1..end));
        let parts = split(Piece { text: inside.unwrap_or_default(), at: 0 });
        !before.is_some_and(is_of_word)
            && parts.len() >= 5
            && parts.iter().take(3).all(|part| VECTORS.iter().any(|v| part.text.starts_with(v)))
    })
}

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    subject.square_pixels("Ray Tracing in One Weekend")?;
    let [eye, at, up] = subject.look_at()?;
    let [width, height] = subject.size();
    let mut text = format!(
        "camera cam;\n\n\
         cam.aspect_ratio  = {};\n\
         cam.image_width   = {width};\n\n\
         cam.vfov          = {};\n\
         cam.lookfrom      = point3({});\n\
         cam.lookat        = point3({});\n\
         cam.vup           = vec3({});\n\n\
         cam.defocus_angle = 0;\n\
         cam.focus_dist    = {};\n",
        aspect_ratio(width, height),
        real(subject.vertical_degrees()),
        commas(eye),
        commas(at),
        commas(up),
        n(subject.viewport().distance),
    );
    let mut notes = Vec::new();
    let spheres = subject.spheres();
    if !spheres.is_empty() {
        text.push_str("\nhittable_list world;\n");
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        let color = light(sphere.color).join(", ");
        text.push_str(&format!(
            "world.add(make_shared<sphere>(point3({}), {}, make_shared<lambertian>(color({color}))));\n",
            commas(center),
            n(radius),
        ));
    }
    notes.extend(subject.planes().iter().map(|plane| {
        format!("{} is left out: the book's first volume has spheres only", plane.title)
    }));
    Ok(Written::of("main.cc", Sheet::of(&text), notes))
}

/// The ratio from which `int(image_width / aspect_ratio)` is the height.
fn aspect_ratio(width: u32, height: u32) -> String {
    let (w, h) = (f64::from(width), f64::from(height));
    let rows = |ratio: f64| (w / ratio) as u32;
    if rows(w / h) == height {
        return format!("{} / {}", real(w), real(h));
    }
    // The quotient is rounded up, and a row is lost: a little less keeps it.
    real((w / h).next_down())
}
