//! *Ray Tracing in One Weekend* (P. Shirley, T. D. Black, S. Hollasch, version 4): the lines that set
//! up its `camera`.

use pinhole_core::{Camera, ImageSize, Orientation, Sphere, Viewport};

use super::back::{extent, image_of, in_ratio, readable};
use super::code::{Code, Comments, Piece, number, split, trimmed};
use super::sheet::{Sheet, commas, light, n, real};
use super::terms::{Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, Written};
use crate::document::Item;
use crate::formats::FileError;

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
    read,
    claims: |text| text.contains("lookfrom") || text.contains("focus_dist"),
};

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

fn read(text: &Text, _: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Slashes);
    let mut notes = Vec::new();
    let vector = |name: &str, or: [f64; 3]| -> Result<_, FileError> {
        Ok(code.vector_of(name)?.unwrap_or(or.into()))
    };
    // What the book's camera has where nothing is set.
    let eye = vector("lookfrom", [0.0; 3])?;
    let at = vector("lookat", [0.0, 0.0, -1.0])?;
    let up = vector("vup", [0.0, 1.0, 0.0])?;
    if code.value("lookfrom").is_none() {
        return Err(code.missing("lookfrom", "it must be given, as lookfrom = point3(0, 0, 0);"));
    }
    let vfov = code.number_of("vfov")?.unwrap_or(90.0);
    if !(vfov > 0.0 && vfov < 180.0) {
        let piece = code.value("vfov").unwrap_or(code.whole());
        return Err(code.fault("vfov", piece, "it must be between 0 and 180 degrees"));
    }
    let image = image(&code)?;
    let distance = code.number_of("focus_dist")?.unwrap_or(10.0);
    let height = extent(vfov, distance);
    let width = in_ratio(height, image.aspect());
    if code.number_of("defocus_angle")?.is_some_and(|angle| angle > 0.0) {
        notes.push("defocus_angle is left out: a pinhole is sharp everywhere".to_owned());
    }
    let camera = Camera {
        eye,
        orientation: Orientation::At { at, up },
        viewport: Viewport { width, height, distance },
        image,
    };
    let spheres = code.calls("make_shared<sphere>").into_iter().map(|call| sphere(&code, call));
    let spheres = readable(spheres, "sphere", &mut notes);
    Ok(Taken { spheres, ..Taken::camera(camera, notes) })
}

/// As the book's `initialize` reckons it.
fn image(code: &Code) -> Result<ImageSize, FileError> {
    let width = code.number_of("image_width")?.unwrap_or(100.0);
    let ratio = code.number_of("aspect_ratio")?.unwrap_or(1.0);
    let height = (width / ratio).trunc().max(1.0);
    image_of(width, height).map_err(|right| {
        let piece = code.value("image_width").unwrap_or(code.whole());
        code.fault("image_width", piece, &right)
    })
}

fn sphere(code: &Code, call: Piece) -> Result<Item<Sphere>, FileError> {
    let parts = split(call);
    let [center, radius, ..] = parts[..] else {
        return Err(code.fault("sphere", call, "it must have a centre and a radius"));
    };
    let center = code.vector("sphere centre", trimmed(center))?;
    let radius_value = number(radius.text).filter(|radius| *radius > 0.0);
    let radius = radius_value
        .ok_or_else(|| code.fault("sphere radius", radius, "it must be greater than 0"))?;
    let color = code.calls_in(call, "color").first().and_then(|color| {
        let [r, g, b] = code.numbers("color", *color).ok()?.try_into().ok()?;
        Some([r, g, b].map(super::sheet::byte_of_light))
    });
    Ok(Item { name: None, color, shape: Sphere { center, radius } })
}
