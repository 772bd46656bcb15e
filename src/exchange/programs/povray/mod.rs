//! POV-Ray 3.7: `camera` by location, right, up and direction, which say all that a camera here has.
//!
//! The ray through the middle of a pixel is `direction + x right + y up` with x and y from -1/2 to 1/2
//! (POV-Ray's reference, *Camera*), so right is width U, up is height V and direction -distance W. Its
//! world is left-handed by habit alone: right says which way the picture runs.

mod blocks;
mod comments;
mod objects;
mod read;
mod source;
mod values;

use pinhole_core::arithmetic::unit;
use pinhole_core::{BACKGROUND, Sphere};

use self::read::read;
use crate::format::text::{commas, flipped_all, light, n, one_line};
use crate::format::{
    Axis, Conventions, ExportScene, Exported, Format, Importer, PixelConvention, Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "povray",
    label: "POV-Ray",
    short: "POV-Ray",
    ending: "pov",
    conventions: Conventions {
        axes: [Axis::U, Axis::V, Axis::MINUS_W],
        given_by: "location, right = width u, up = height v, direction = −distance w",
        pixels: PixelConvention::Corner,
        view: "length of right and up against that of direction",
        field: |subject| {
            let viewport = subject.viewport();
            format!("{}, {} : {}", n(viewport.width), n(viewport.height), n(viewport.distance))
        },
        distance: "length of direction",
        shape: "any: right and up need not go with +W and +H",
        lengths: "f64",
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "povray",
    label: "POV-Ray",
    read,
    detect: |text| {
        let mut matches = text.match_indices("camera");
        matches.any(|(at, word)| text[at + word.len()..].trim_start().starts_with('{'))
    },
};

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
    let [width, height] = subject.size();
    let viewport = *subject.viewport();
    let basis = *subject.resolve().basis();
    let mut text = format!(
        "// povray +W{width} +H{height} -A scene.pov\n\
         #version 3.7;\n\
         global_settings {{ assumed_gamma 1 }}\n\n\
         camera {{\n  perspective\n  location <{}>\n  right <{}>\n  up <{}>\n  direction <{}>\n}}\n",
        commas(subject.resolve().eye()),
        commas(viewport.width * basis.u),
        commas(viewport.height * basis.v),
        flipped_all(-viewport.distance * basis.w, ", "),
    );
    let (spheres, planes) = (subject.spheres(), subject.planes());
    if !(spheres.is_empty() && planes.is_empty()) {
        text.push_str(&format!(
            "\nbackground {{ color rgb <{}> }}\n\
             light_source {{ <{}>, color rgb 1 shadowless }}\n\
             #default {{ finish {{ ambient 0 diffuse 1 }} }}\n",
            light(BACKGROUND).join(", "),
            commas(subject.resolve().eye()),
        ));
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        let color = light(sphere.color).join(", ");
        text.push_str(&format!(
            "sphere {{ <{}>, {} pigment {{ color rgb <{color}> }} }} // {}\n",
            commas(center),
            n(radius),
            one_line(&sphere.title)
        ));
    }
    for plane in planes {
        let normal = unit(plane.shape.normal);
        let color = light(plane.color).join(", ");
        text.push_str(&format!(
            "plane {{ <{}>, {} pigment {{ color rgb <{color}> }} }} // {}\n",
            commas(normal),
            n(normal.dot(plane.shape.point)),
            one_line(&plane.title)
        ));
    }
    Ok(Exported::one_file("scene.pov", &text, Vec::new()))
}
