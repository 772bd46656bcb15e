//! Mitsuba 3's XML: a sensor `perspective`, whose camera has x to the *left*, y up and z forwards.

use crate::format::text::{commas, light, n, quotable, rows};
use crate::format::{
    Axis, Conventions, ExportScene, Format, PixelConvention, Unsupported, square_note,
};

pub(super) const FORMAT: Format = Format {
    name: "mitsuba",
    label: "Mitsuba 3",
    short: "Mitsuba",
    file: "scene.xml",
    conventions: Some(Conventions {
        axes: [Axis::MINUS_U, Axis::V, Axis::MINUS_W],
        given_by: "lookat: origin, target, up",
        pixels: PixelConvention::Corner,
        view: "fov: in degrees, along fov_axis (x: horizontal)",
        field: |subject| n(subject.viewport().horizontal_fov().to_degrees()),
        distance: "none: near_clip and far_clip cut, and change no ray",
        shape: "square only",
        lengths: "f32 in most variants",
    }),
    write,
};

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    subject.square_pixels("Mitsuba")?;
    let [eye, at, up] = subject.look_at()?;
    let [width, height] = subject.size();
    let (near, far) = subject.clip();
    let mut text = format!(
        "<scene version=\"3.0.0\">\n  <integrator type=\"direct\"/>\n  <sensor type=\"perspective\">\n    \
         <string name=\"fov_axis\" value=\"x\"/>\n    <float name=\"fov\" value=\"{}\"/>\n    \
         <float name=\"near_clip\" value=\"{}\"/>\n    <float name=\"far_clip\" value=\"{}\"/>\n    \
         <transform name=\"to_world\">\n      <lookat origin=\"{}\" target=\"{}\" up=\"{}\"/>\n    \
         </transform>\n    <film type=\"hdrfilm\">\n      \
         <integer name=\"width\" value=\"{width}\"/>\n      \
         <integer name=\"height\" value=\"{height}\"/>\n      <rfilter type=\"box\"/>\n    </film>\n  \
         </sensor>\n",
        n(subject.viewport().horizontal_fov().to_degrees()),
        n(near),
        n(far),
        commas(eye),
        commas(at),
        commas(up),
    );
    text.push_str(&objects(subject, notes));
    text.push_str("</scene>\n");
    Ok(text)
}

/// A light, the spheres, and squares in the planes' places.
fn objects(subject: &ExportScene, notes: &mut Vec<String>) -> String {
    let mut text = String::new();
    let (spheres, planes) = (&subject.spheres, &subject.planes);
    if !(spheres.is_empty() && planes.is_empty()) {
        text.push_str("  <emitter type=\"constant\"/>\n");
    }
    for sphere in spheres {
        let [x, y, z] = sphere.shape.center.to_array().map(n);
        text.push_str(&format!(
            "  <shape type=\"sphere\" id=\"{}\">\n    \
             <point name=\"center\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>\n    \
             <float name=\"radius\" value=\"{}\"/>\n{}  </shape>\n",
            quotable(&sphere.title),
            n(sphere.shape.radius),
            bsdf(sphere.color)
        ));
    }
    for plane in planes {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let rows = rows([half * a, half * b, a.cross(b), middle], " ");
        let looks = bsdf(plane.color)
            .replace("<bsdf type", "<bsdf type=\"twosided\"><bsdf type")
            .replace("</bsdf>\n", "</bsdf></bsdf>\n");
        text.push_str(&format!(
            "  <shape type=\"rectangle\" id=\"{}\">\n    <transform name=\"to_world\">\n      \
             <matrix value=\"{} 0 0 0 1\"/>\n    </transform>\n{looks}  </shape>\n",
            quotable(&plane.title),
            rows.join(" "),
        ));
        notes.push(square_note(&plane.title, "Mitsuba", half));
    }
    text
}

fn bsdf(rgb: pinhole_core::Rgb) -> String {
    let color = light(rgb, " ");
    format!("    <bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"{color}\"/></bsdf>\n")
}
