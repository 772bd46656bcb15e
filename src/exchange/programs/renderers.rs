//! Renderers: POV-Ray, pbrt, Mitsuba and Blender.

use pinhole_core::arithmetic::unit;
use pinhole_core::{BACKGROUND, Basis, Sphere};

use crate::format::{Axis, Conventions, Format, PixelConvention};
use crate::format::{ExportScene, Unsupported, square_note};
use crate::format::{
    commas, commas_of, flipped, light, n, quotable, real, rows, sanitized, spaces,
};

/// POV-Ray 3.7: `camera` with location, right, up and direction, which can express every property
/// of Pinhole's camera.
///
/// The ray through the middle of a pixel is `direction + x right + y up` with x and y from -1/2 to
/// 1/2 (POV-Ray's reference, *Camera*), so right is width U, up is height V and direction -distance
/// W. POV-Ray's world is left-handed by convention only: right determines in which direction the
/// picture's columns run.
pub(super) const POVRAY: Format = Format {
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
    write: povray,
};

fn povray(subject: &ExportScene, _: &mut Vec<String>) -> Result<String, Unsupported> {
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
            sanitized(&sphere.title)
        ));
    }
    for plane in planes {
        let normal = unit(plane.shape.normal);
        let color = light(plane.color, ", ");
        text.push_str(&format!(
            "plane {{ <{}>, {} pigment {{ color rgb <{color}> }} }} // {}\n",
            commas(normal),
            n(normal.dot(plane.shape.point)),
            sanitized(&plane.title)
        ));
    }
    Ok(text)
}

/// pbrt-v4: `LookAt` and `Camera "perspective"` in a left-handed camera space.
///
/// pbrt's `LookAt` puts `up x view` to the right, which in a right-handed world is left; `Scale -1
/// 1 1` before it flips the picture back (Pharr, Jakob, Humphreys, *Physically Based Rendering*,
/// 4th ed., sections 3.9.5 and 5.1). `fov` is the angle of the image's shorter side;
/// `frameaspectratio` is width / height, even if pixels are not square.
pub(super) const PBRT: Format = Format {
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
    write: pbrt,
};

fn shorter_degrees(subject: &ExportScene) -> f64 {
    let viewport = subject.viewport();
    viewport.horizontal_fov().min(viewport.vertical_fov()).to_degrees()
}

fn pbrt(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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
            sanitized(&sphere.title),
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
            sanitized(&plane.title),
            light(plane.color, " "),
            corners.join("  ")
        ));
        notes.push(square_note(&plane.title, "pbrt", half));
    }
    Ok(text)
}

/// Mitsuba 3's XML: a sensor `perspective`, whose camera has x to the *left*, y up and z forwards.
pub(super) const MITSUBA: Format = Format {
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
    write: mitsuba,
};

fn mitsuba(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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
    text.push_str(&mitsuba_objects(subject, notes));
    text.push_str("</scene>\n");
    Ok(text)
}

/// Returns a light, the spheres, and squares that replace the planes.
fn mitsuba_objects(subject: &ExportScene, notes: &mut Vec<String>) -> String {
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

/// Blender's Python: a camera object with `matrix_world`, whose camera looks along its own -z with y up. World
/// coordinates are kept: z up is a convention of Blender's views, not of its camera.
pub(super) const BLENDER: Format = Format {
    name: "blender",
    label: "Blender Python",
    short: "Blender",
    file: "scene.py",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "matrix_world: u, v, w, eye as columns",
        pixels: PixelConvention::Corner,
        view: "angle_x: horizontal, in radians, with sensor_fit HORIZONTAL",
        field: |subject| n(subject.viewport().horizontal_fov()),
        distance: "none: clip_start and clip_end cut, and change no ray",
        shape: "any: pixel_aspect_x and pixel_aspect_y",
        lengths: "f32",
    }),
    write: blender,
};

fn blender(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [width, height] = subject.size();
    let (near, far) = subject.clip();
    let viewport = subject.viewport();
    let Basis { u, v, w } = *subject.resolve().basis();
    let eye = subject.resolve().eye();
    let [x, y, z] = rows([u, v, w, eye], ", ");
    // Blender takes neither below 1.
    let shape = subject.pixel_shape();
    let (aspect_x, aspect_y) = if shape >= 1.0 { (shape, 1.0) } else { (1.0, 1.0 / shape) };
    if aspect_x.max(aspect_y) > 200.0 {
        return Err(Unsupported(format!(
            "pixels are {} times as wide as high: Blender's pixel aspect goes to 200",
            n(shape)
        )));
    }
    let mut text = format!(
        "import bpy\nfrom mathutils import Matrix\n\nscene = bpy.context.scene\n\
         data = bpy.data.cameras.new(\"pinhole\")\ncamera = bpy.data.objects.new(\"pinhole\", data)\n\
         scene.collection.objects.link(camera)\nscene.camera = camera\n\n\
         camera.matrix_world = Matrix((\n    ({x}),\n    ({y}),\n    ({z}),\n    (0, 0, 0, 1)))\n\n\
         data.sensor_fit = 'HORIZONTAL'\ndata.angle_x = {}\ndata.clip_start = {}\n\
         data.clip_end = {}\n\nscene.render.resolution_x = {width}\n\
         scene.render.resolution_y = {height}\nscene.render.resolution_percentage = 100\n\
         scene.render.pixel_aspect_x = {}\nscene.render.pixel_aspect_y = {}\n",
        real(viewport.horizontal_fov()),
        real(near),
        real(far),
        real(aspect_x),
        real(aspect_y),
    );
    text.push_str(&blender_objects(subject, notes));
    Ok(text)
}

/// Returns meshes that replace the objects.
fn blender_objects(subject: &ExportScene, notes: &mut Vec<String>) -> String {
    let mut text = String::new();
    let (spheres, planes) = (&subject.spheres, &subject.planes);
    if !(spheres.is_empty() && planes.is_empty()) {
        text.push_str(
            "\n\ndef looks(name, color):\n    thing = bpy.context.object\n    thing.name = name\n    \
             material = bpy.data.materials.new(name)\n    material.diffuse_color = (*color, 1)\n    \
             thing.data.materials.append(material)\n\n\n",
        );
    }
    for sphere in spheres {
        let Sphere { center, radius } = sphere.shape;
        text.push_str(&format!(
            "bpy.ops.mesh.primitive_uv_sphere_add(radius={}, location=({}), segments=64, ring_count=32)\n\
             looks(\"{}\", ({}))\n",
            n(radius),
            commas(center),
            quotable(&sphere.title),
            light(sphere.color, ", ")
        ));
    }
    for plane in planes {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let [x, y, z] = rows([half * a, half * b, a.cross(b), middle], ", ");
        text.push_str(&format!(
            "bpy.ops.mesh.primitive_plane_add(size=2)\nbpy.context.object.matrix_world = Matrix((\n    \
             ({x}),\n    ({y}),\n    ({z}),\n    (0, 0, 0, 1)))\nlooks(\"{}\", ({}))\n",
            quotable(&plane.title),
            light(plane.color, ", ")
        ));
        notes.push(square_note(&plane.title, "Blender", half));
    }
    text
}
