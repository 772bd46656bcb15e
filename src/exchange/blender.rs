//! Blender by its Python: a camera object with `matrix_world`, whose camera looks along its own -z with
//! y up. World coordinates are kept: Blender's z up is a habit of its views, not of the camera.

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Sphere, Viewport};

use super::affine::Affine;
use super::back::{extent, image_of, in_ratio, readable, shortest_where};
use super::code::{Code, Comments, Piece};
use super::gltf::placed;
use super::sheet::{Sheet, commas, light, n, quotable, real};
use super::subject::square_note;
use super::terms::{Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, Written};
use crate::document::Item;
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "blender",
    label: "Blender Python",
    short: "Blender",
    ending: "py",
    terms: Terms {
        axes: Terms::OURS,
        given_by: "matrix_world: u, v, w, eye as columns",
        pixels: Pixels::Corner,
        view: "angle_x: horizontal, in radians, with sensor_fit HORIZONTAL",
        field: |subject| n(subject.viewport().horizontal_fov()),
        distance: "none: clip_start and clip_end cut, and change no ray",
        shape: "any: pixel_aspect_x and pixel_aspect_y",
        lengths: "f32",
    },
    write,
    read,
    claims: |text| text.contains("bpy") || text.contains("matrix_world"),
};

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    let [width, height] = subject.size();
    let (near, far) = subject.clip();
    let viewport = subject.viewport();
    let Basis { u, v, w } = *subject.posed().basis();
    let eye = subject.posed().eye();
    let row = |k: usize| format!("({}, {}, {}, {})", n(u[k]), n(v[k]), n(w[k]), n(eye[k]));
    // Blender takes neither below 1.
    let shape = subject.pixel_shape();
    let (aspect_x, aspect_y) = if shape >= 1.0 { (shape, 1.0) } else { (1.0, 1.0 / shape) };
    let mut notes = Vec::new();
    if aspect_x.max(aspect_y) > 200.0 {
        return Err(Unsayable(format!(
            "pixels are {} times as wide as high: Blender's pixel aspect goes to 200",
            n(shape)
        )));
    }
    let mut text = format!(
        "import bpy\nfrom mathutils import Matrix\n\nscene = bpy.context.scene\n\
         data = bpy.data.cameras.new(\"pinhole\")\ncamera = bpy.data.objects.new(\"pinhole\", data)\n\
         scene.collection.objects.link(camera)\nscene.camera = camera\n\n\
         camera.matrix_world = Matrix((\n    {},\n    {},\n    {},\n    (0, 0, 0, 1)))\n\n\
         data.sensor_fit = 'HORIZONTAL'\ndata.angle_x = {}\ndata.clip_start = {}\n\
         data.clip_end = {}\n\nscene.render.resolution_x = {width}\n\
         scene.render.resolution_y = {height}\nscene.render.resolution_percentage = 100\n\
         scene.render.pixel_aspect_x = {}\nscene.render.pixel_aspect_y = {}\n",
        row(0),
        row(1),
        row(2),
        real(viewport.horizontal_fov()),
        real(near),
        real(far),
        real(aspect_x),
        real(aspect_y),
    );
    text.push_str(&objects(subject, &mut notes));
    Ok(Written::of("scene.py", Sheet::of(&text), notes))
}

/// Meshes in the objects' places.
fn objects(subject: &Subject, notes: &mut Vec<String>) -> String {
    let mut text = String::new();
    let (spheres, planes) = (subject.spheres(), subject.planes());
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
            light(sphere.color).join(", ")
        ));
    }
    for plane in planes {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let c = a.cross(b);
        let row = |k: usize| {
            let [x, y, z] = [half * a[k], half * b[k], c[k]].map(n);
            format!("({x}, {y}, {z}, {})", n(middle[k]))
        };
        text.push_str(&format!(
            "bpy.ops.mesh.primitive_plane_add(size=2)\nbpy.context.object.matrix_world = Matrix((\n    \
             {},\n    {},\n    {},\n    (0, 0, 0, 1)))\nlooks(\"{}\", ({}))\n",
            row(0),
            row(1),
            row(2),
            quotable(&plane.title),
            light(plane.color).join(", ")
        ));
        notes.push(square_note(&plane.title, "Blender", half));
    }
    text
}

fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Hash);
    let mut notes = Vec::new();
    let number =
        |name: &str, or: f64| -> Result<f64, FileError> { Ok(code.number_of(name)?.unwrap_or(or)) };
    let given = code.number_of("resolution_x")?.zip(code.number_of("resolution_y")?);
    let image = match given {
        Some((width, height)) => {
            let percent = number("resolution_percentage", 100.0)? / 100.0;
            let piece = code.value("resolution_x").unwrap_or(code.whole());
            image_of((width * percent).trunc(), (height * percent).trunc())
                .map_err(|right| code.fault("resolution_x", piece, &right))?
        }
        None => {
            let image = at_hand.image;
            let (w, h) = (image.width(), image.height());
            notes.push(format!("the text does not say the resolution: {w} × {h} pixels taken"));
            image
        }
    };
    let shape = number("pixel_aspect_x", 1.0)? / number("pixel_aspect_y", 1.0)?;
    let viewport = viewport(&code, image, shape, at_hand.viewport.distance)?;
    for name in ["shift_x", "shift_y"] {
        if number(name, 0.0)? != 0.0 {
            notes.push(format!("{name} is left out: the middle is the middle here"));
        }
    }
    let (orientation, eye) = placed(&frame(&code)?, &mut notes)
        .map_err(|right| code.rotation("matrix_world", &right))?;
    let mut taken = Taken::camera(Camera { eye, orientation, viewport, image }, notes);
    spheres(&code, &mut taken);
    Ok(taken)
}

fn viewport(
    code: &Code,
    image: ImageSize,
    pixel_shape: f64,
    distance: f64,
) -> Result<Viewport, FileError> {
    let frame = image.aspect() * pixel_shape;
    let fit = code.value("sensor_fit").map(|piece| piece.text.trim_matches(['\'', '"']));
    let by_width = match fit {
        Some("HORIZONTAL") => true,
        Some("VERTICAL") => false,
        _ => frame >= 1.0,
    };
    let angle = |name: &str| -> Result<Option<f64>, FileError> {
        let Some(angle) = code.number_of(name)? else { return Ok(None) };
        if !(angle > 0.0 && angle < std::f64::consts::PI) {
            let piece = code.value(name).unwrap_or(code.whole());
            return Err(code.fault(name, piece, "it must be between 0 and pi, in radians"));
        }
        let near = pinhole_core::extent_of_fov(angle, distance);
        let fits = |x| pinhole_core::fov_of_extent(x, distance) == angle;
        Ok(Some(shortest_where(near, fits)))
    };
    let wide = |width: f64| Viewport { width, height: in_ratio(width, 1.0 / frame), distance };
    let high = |height: f64| Viewport { width: in_ratio(height, frame), height, distance };
    if let Some(width) = angle("angle_x")? {
        return Ok(wide(width));
    }
    if let Some(height) = angle("angle_y")? {
        return Ok(high(height));
    }
    if let Some(across) = angle("angle")? {
        return Ok(if by_width { wide(across) } else { high(across) });
    }
    // Blender's camera has 50 mm and 36 mm where nothing is set.
    let lens = code.number_of("lens")?.unwrap_or(50.0);
    let sensor = match fit {
        Some("VERTICAL") => code.number_of("sensor_height")?.unwrap_or(24.0),
        _ => code.number_of("sensor_width")?.unwrap_or(36.0),
    };
    if lens <= 0.0 || sensor <= 0.0 {
        let piece = code.value("lens").unwrap_or(code.whole());
        return Err(code.fault("lens", piece, "it must be greater than 0"));
    }
    let degrees = 2.0 * (0.5 * sensor / lens).atan().to_degrees();
    let across = extent(degrees, distance);
    Ok(if by_width { wide(across) } else { high(across) })
}

/// By `matrix_world`, or by location and rotation.
fn frame(code: &Code) -> Result<Affine, FileError> {
    // The camera's comes first, and those of objects after it.
    if let Some(piece) = code.first_value("matrix_world") {
        let numbers = code.numbers("matrix_world", piece)?;
        let affine = Affine::of_rows(&numbers);
        let right = "it must be four rows of four numbers, the last one 0, 0, 0, 1";
        return affine.ok_or_else(|| code.fault("matrix_world", piece, right));
    }
    let Some(location) = code.vector_of("location")? else {
        let right = "the camera must be given by it, or by location and rotation_euler";
        return Err(code.missing("matrix_world", right));
    };
    let at = Affine::translation(location);
    if let Some(piece) = code.value("rotation_quaternion") {
        let numbers = code.numbers("rotation_quaternion", piece)?;
        let q: Option<[f64; 4]> = numbers.try_into().ok();
        let turn = q.and_then(Basis::of_quaternion);
        let right = "it must be four numbers w, x, y, z";
        let turn = turn.ok_or_else(|| code.fault("rotation_quaternion", piece, right))?;
        return Ok(at.of(&Affine { x: turn.u, y: turn.v, z: turn.w, at: DVec3::ZERO }));
    }
    // XYZ: about x first, then y, then z.
    let angles = code.vector_of("rotation_euler")?.unwrap_or(DVec3::ZERO);
    let turns = [(angles.z, DVec3::Z), (angles.y, DVec3::Y), (angles.x, DVec3::X)];
    let turned = turns.into_iter().fold(at, |frame, (angle, axis)| {
        let turn = Affine::rotation(angle.to_degrees(), axis).unwrap_or(Affine::IDENTITY);
        frame.of(&turn)
    });
    Ok(turned)
}

fn spheres(code: &Code, taken: &mut Taken) {
    let sphere = |call: Piece<'_>| {
        let parts = super::code::split(call);
        let argument = |name: &str| {
            parts.iter().find_map(|part| {
                let (before, _) = part.text.split_once('=')?;
                (before.trim() == name).then(|| part.from(before.len() + 1))
            })
        };
        let radius = argument("radius").map_or(Ok(1.0), |piece| code.number("radius", piece))?;
        let center =
            argument("location").map(|piece| code.vector("location", piece)).transpose()?;
        if radius <= 0.0 {
            return Err(code.fault("radius", call, "it must be greater than 0"));
        }
        let shape = Sphere { center: center.unwrap_or_default(), radius };
        Ok(Item { name: None, color: None, shape })
    };
    let spheres = code.calls("primitive_uv_sphere_add").into_iter().map(sphere);
    taken.spheres = readable(spheres, "primitive_uv_sphere_add", &mut taken.notes);
    let planes = code.calls("primitive_plane_add").len();
    if planes > 0 {
        taken.notes.push(format!("{planes} squares left out: Pinhole's planes have no end"));
    }
}
