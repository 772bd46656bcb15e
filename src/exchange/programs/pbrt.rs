//! pbrt-v4: `LookAt` and `Camera "perspective"` in a left-handed camera space.
//!
//! pbrt's `LookAt` puts `up x view` to the right, which in a right-handed world is left; `Scale -1 1 1`
//! before it turns the picture back (Pharr, Jakob, Humphreys, *Physically Based Rendering*, 4th ed.,
//! sections 3.9.5 and 5.1). fov is that of the image's shorter side; `frameaspectratio` is width /
//! height, of pixels that are not square too.

use pinhole_core::Sphere;

use crate::format::text::{flipped, light, n, one_line, spaces};
use crate::format::{
    Axis, Conventions, ExportScene, Format, PixelConvention, Unsupported, square_note,
};

pub(super) const FORMAT: Format = Format {
    name: "pbrt",
    label: "pbrt-v4",
    short: "pbrt",
    file: "scene.pbrt",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::V, Axis::MINUS_W],
        given_by: "LookAt eye at up, after Scale −1 1 1",
        pixels: PixelConvention::Corner,
        view: "fov: of the shorter side, in degrees",
        field: |subject| n(shorter_degrees(subject)),
        distance: "focaldistance, which a pinhole's rays do not depend on",
        shape: "any: frameaspectratio is width / height",
        lengths: "f32 as it is usually built",
    }),
    write,
};

fn shorter_degrees(subject: &ExportScene) -> f64 {
    let viewport = subject.viewport();
    viewport.horizontal_fov().min(viewport.vertical_fov()).to_degrees()
}

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [eye, at, up] = subject.look_at()?;
    let [width, height] = subject.size();
    let viewport = subject.viewport();
    let frame = match subject.pixel_shape() == 1.0 {
        true => String::new(),
        false => {
            format!("\n    \"float frameaspectratio\" [ {} ]", n(viewport.width / viewport.height))
        }
    };
    let mut text = format!(
        "Scale {} 1 1\nLookAt {}\n       {}\n       {}\nCamera \"perspective\"\n    \
         \"float fov\" [ {} ]{frame}\n    \"float focaldistance\" [ {} ]\n\
         Film \"rgb\" \"string filename\" [ \"scene.exr\" ]\n    \
         \"integer xresolution\" [ {width} ]\n    \"integer yresolution\" [ {height} ]\n",
        flipped(-1.0),
        spaces(eye),
        spaces(at),
        spaces(up),
        n(shorter_degrees(subject)),
        n(viewport.distance),
    );
    let (spheres, planes) = (&subject.spheres, &subject.planes);
    if !(spheres.is_empty() && planes.is_empty()) {
        text.push_str("\nWorldBegin\nLightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\n");
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        text.push_str(&format!(
            "AttributeBegin # {}\n  Translate {}\n  Material \"diffuse\" \"rgb reflectance\" [ {} ]\n  \
             Shape \"sphere\" \"float radius\" [ {} ]\nAttributeEnd\n",
            one_line(&sphere.title),
            spaces(center),
            light(sphere.color, " "),
            n(radius)
        ));
    }
    for plane in planes {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let corner = |x: f64, y: f64| spaces(middle + half * (x * a + y * b));
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0)];
        text.push_str(&format!(
            "AttributeBegin # {}\n  Material \"diffuse\" \"rgb reflectance\" [ {} ]\n  \
             Shape \"bilinearmesh\" \"point3 P\" [ {} ]\nAttributeEnd\n",
            one_line(&plane.title),
            light(plane.color, " "),
            corners.join("  ")
        ));
        notes.push(square_note(&plane.title, "pbrt", half));
    }
    Ok(text)
}
