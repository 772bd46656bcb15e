//! Blender by its Python: a camera object with `matrix_world`, whose camera looks along its own -z with
//! y up. World coordinates are kept: Blender's z up is a habit of its views, not of the camera.

use pinhole_core::{Basis, Sphere};

use crate::format::text::{commas, light, n, quotable, real, rows};
use crate::format::{Conventions, ExportScene, Format, PixelConvention, Unsupported, square_note};

pub(super) const FORMAT: Format = Format {
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
    write,
};

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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
    text.push_str(&objects(subject, notes));
    Ok(text)
}

/// Meshes in the objects' places.
fn objects(subject: &ExportScene, notes: &mut Vec<String>) -> String {
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
