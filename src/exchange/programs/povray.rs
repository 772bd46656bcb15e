//! POV-Ray 3.7: `camera` by location, right, up and direction, which say all that a camera here has.
//!
//! The ray through the middle of a pixel is `direction + x right + y up` with x and y from -1/2 to 1/2
//! (POV-Ray's reference, *Camera*), so right is width U, up is height V and direction -distance W. Its
//! world is left-handed by habit alone: right says which way the picture runs.

use pinhole_core::arithmetic::unit;
use pinhole_core::{BACKGROUND, Sphere};

use crate::format::text::{commas, commas_of, flipped, light, n, one_line};
use crate::format::{Axis, Conventions, ExportScene, Format, PixelConvention, Unsupported};

pub(super) const FORMAT: Format = Format {
    name: "povray",
    label: "POV-Ray",
    short: "POV-Ray",
    file: "scene.pov",
    conventions: Some(Conventions {
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
    }),
    write,
};

fn write(subject: &ExportScene, _: &mut Vec<String>) -> Result<String, Unsupported> {
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
        commas_of(-viewport.distance * basis.w, flipped),
    );
    let (spheres, planes) = (&subject.spheres, &subject.planes);
    if !(spheres.is_empty() && planes.is_empty()) {
        text.push_str(&format!(
            "\nbackground {{ color rgb <{}> }}\n\
             light_source {{ <{}>, color rgb 1 shadowless }}\n\
             #default {{ finish {{ ambient 0 diffuse 1 }} }}\n",
            light(BACKGROUND, ", "),
            commas(subject.resolve().eye()),
        ));
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        let color = light(sphere.color, ", ");
        text.push_str(&format!(
            "sphere {{ <{}>, {} pigment {{ color rgb <{color}> }} }} // {}\n",
            commas(center),
            n(radius),
            one_line(&sphere.title)
        ));
    }
    for plane in planes {
        let normal = unit(plane.shape.normal);
        let color = light(plane.color, ", ");
        text.push_str(&format!(
            "plane {{ <{}>, {} pigment {{ color rgb <{color}> }} }} // {}\n",
            commas(normal),
            n(normal.dot(plane.shape.point)),
            one_line(&plane.title)
        ));
    }
    Ok(text)
}
