//! Cameras used in teaching: the camera of *Ray Tracing in One Weekend* and that of the course.

use pinhole_core::Sphere;

use crate::format::{Conventions, Format, PixelConvention};
use crate::format::{ExportScene, Unsupported};
use crate::format::{commas, light, n, real};

/// *Ray Tracing in One Weekend* (P. Shirley, T. D. Black, S. Hollasch, version 4): the lines that set up its
/// `camera`.
pub(super) const WEEKEND: Format = Format {
    name: "weekend",
    label: "Ray Tracing in One Weekend",
    short: "One Weekend",
    file: "main.cc",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "lookfrom, lookat, vup",
        pixels: PixelConvention::ColumnFirst,
        view: "vfov: vertical, in degrees",
        field: |subject| n(subject.vertical_degrees()),
        distance: "focus_dist: the viewport is there, t = 1 too",
        shape: "square only; image_height = int(image_width / aspect_ratio)",
        lengths: "f64",
    }),
    write: weekend,
};

fn weekend(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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
    let spheres = &subject.spheres;
    if !spheres.is_empty() {
        text.push_str("\nhittable_list world;\n");
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        let color = light(sphere.color, ", ");
        text.push_str(&format!(
            "world.add(make_shared<sphere>(point3({}), {}, make_shared<lambertian>(color({color}))));\n",
            commas(center),
            n(radius),
        ));
    }
    notes.extend(subject.planes.iter().map(|plane| {
        format!("{} is left out: the book's first volume has spheres only", plane.title)
    }));
    Ok(text)
}

/// Returns the ratio for which `int(image_width / aspect_ratio)` is the height.
fn aspect_ratio(width: u32, height: u32) -> String {
    let (w, h) = (f64::from(width), f64::from(height));
    let rows = |ratio: f64| (w / ratio) as u32;
    if rows(w / h) == height {
        return format!("{} / {}", real(w), real(h));
    }
    // The quotient was rounded up, which would lose a row: the next smaller number keeps it.
    real((w / h).next_down())
}

/// The course's own camera, a call in Julia: `PerspectiveCamera(eye, view, up, focal, H, W)`, whose viewport is 1
/// wide and H / W high.
pub(super) const COURSE: Format = Format {
    name: "course",
    label: "PerspectiveCamera of the course",
    short: "Course",
    file: "camera.jl",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, view, up",
        pixels: PixelConvention::FromOne,
        view: "focal: distance / width",
        field: |subject| n(focal(subject)),
        distance: "focal; the viewport is 1 wide",
        shape: "square only: the viewport is H / W high",
        lengths: "f64",
    }),
    write: course,
};

fn focal(subject: &ExportScene) -> f64 {
    subject.viewport().distance / subject.viewport().width
}

fn course(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    subject.square_pixels("the course's camera")?;
    let camera = subject.camera();
    let [width, height] = subject.size();
    let text = format!(
        "PerspectiveCamera(\n    Vec3({}), # eye\n    Vec3({}), # view\n    Vec3({}), # up\n    {}, # focal\n    \
         {height}, {width}) # H, W\n",
        commas(camera.eye),
        commas(camera.view()),
        commas(camera.up()),
        real(focal(subject)),
    );
    let scale = subject.viewport().width;
    if scale != 1.0 {
        notes.push(format!(
            "the course's viewport is 1 wide, this one {}: the same rays, and every t is {} times \
             as large there",
            n(scale),
            n(scale)
        ));
    }
    notes.extend(subject.objects_left_out("the call makes a camera only"));
    Ok(text)
}
