//! COLMAP's `cameras.txt` and `images.txt`: K by one line, the pose by a quaternion and a translation
//! from world to camera.

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Intrinsics};

use super::back::image_of;
use super::code::error_at;
use super::opencv::{off_centre, stance, translation, turned, viewport_of};
use super::sheet::{Sheet, flipped, n};
use super::terms::{Axis, Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, Written};
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "colmap",
    label: "COLMAP",
    short: "COLMAP",
    ending: "txt",
    terms: Terms {
        axes: [Axis::U, Axis::MinusV, Axis::MinusW],
        given_by: "quaternion w x y z from world to camera, t = −R eye",
        pixels: Pixels::Corner,
        view: "fx, fy: distance / pixel's width and height, in pixels",
        field: |subject| {
            let Intrinsics { fx, fy, .. } = subject.intrinsics();
            format!("{}, {}", n(fx), n(fy))
        },
        distance: "none: K knows pixels only",
        shape: "any: fx and fy differ (model PINHOLE)",
        lengths: "f64",
    },
    write,
    read,
    claims: |text| camera_line(text).is_some() || (image_line(text).is_some()),
};

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    let [width, height] = subject.size();
    let Intrinsics { fx, fy, cx, cy } = subject.intrinsics();
    let cameras = format!(
        "# Camera list with one line of data per camera:\n\
         #   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[] = fx, fy, cx, cy\n\
         1 PINHOLE {width} {height} {} {} {} {}\n",
        n(fx),
        n(fy),
        n(cx),
        n(cy)
    );
    let Basis { u, v, w } = *subject.posed().basis();
    // Columns of R are its rows' coordinates: R = (u, -v, -w) as rows turns world to camera.
    let columns = [0, 1, 2].map(|k| DVec3::new(u[k], -v[k], -w[k]));
    let q = Basis { u: columns[0], v: columns[1], w: columns[2] }.quaternion();
    let t = translation(subject);
    let images = format!(
        "# Image list with two lines of data per image:\n\
         #   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n\
         #   POINTS2D[] as (X, Y, POINT3D_ID)\n\
         1 {} {} {} {} 1 image.png\n\n",
        q.map(|x| flipped(n(x))).join(" "),
        n(t.x),
        flipped(n(t.y)),
        flipped(n(t.z))
    );
    let points = "# 3D point list with one line of data per point:\n\
                  #   POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
    let objects = subject.spheres().len() + subject.planes().len();
    let left = "objects are left out: COLMAP has points only";
    let notes = (objects > 0).then(|| left.to_owned()).into_iter().collect();
    let files = vec![
        ("cameras.txt", Sheet::of(&cameras)),
        ("images.txt", Sheet::of(&images)),
        ("points3D.txt", Sheet::of(points)),
    ];
    Ok(Written { files, notes })
}

/// Which parameters each model begins with: fx, fy or one f, and how many follow cx, cy.
const MODELS: [(&str, bool, usize); 6] = [
    ("SIMPLE_PINHOLE", false, 0),
    ("PINHOLE", true, 0),
    ("SIMPLE_RADIAL", false, 1),
    ("RADIAL", false, 2),
    ("OPENCV", true, 4),
    ("FULL_OPENCV", true, 8),
];

struct Line<'t> {
    at: usize,
    cells: Vec<&'t str>,
}

fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut at = 0;
    text.split_inclusive('\n').filter_map(move |line| {
        let from = at;
        at += line.len();
        let is_data = !line.trim_start().starts_with('#') && !line.trim().is_empty();
        is_data.then(|| Line { at: from, cells: line.split_whitespace().collect() })
    })
}

fn camera_line(text: &str) -> Option<Line<'_>> {
    lines(text).find(|line| {
        let is_number = line.cells[0].parse::<u64>().is_ok();
        is_number
            && line.cells.get(1).is_some_and(|model| {
                model.len() > 2 && model.chars().all(|c| c.is_ascii_uppercase() || c == '_')
            })
            && line.cells.len() > 4
    })
}

fn image_lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    lines(text).filter(|line| {
        let numbers = line.cells.iter().take(9).filter(|cell| cell.parse::<f64>().is_ok());
        line.cells.len() == 10
            && numbers.count() == 9
            && line.cells[0].parse::<u64>().is_ok()
            && line.cells[9].parse::<f64>().is_err()
    })
}

fn image_line(text: &str) -> Option<Line<'_>> {
    image_lines(text).next()
}

/// The line of a camera.
fn intrinsics(
    text: &Text,
    camera: &Line,
    notes: &mut Vec<String>,
) -> Result<(Intrinsics, ImageSize), FileError> {
    let error = |at: usize, problem: String| error_at(text.path, text.text, at, problem);
    let model = camera.cells[1];
    let Some((_, two, distortions)) = MODELS.iter().find(|known| known.0 == model) else {
        let known: Vec<&str> = MODELS.iter().map(|known| known.0).collect();
        let right = known.join(", ");
        return Err(error(camera.at, format!("MODEL is {model}: it must be one of {right}")));
    };
    let numbers: Result<Vec<f64>, FileError> = camera.cells[2..]
        .iter()
        .map(|cell| {
            let number = cell.parse::<f64>().ok().filter(|x| x.is_finite());
            number.ok_or_else(|| {
                error(camera.at, format!("PARAMS has {cell}: it must be a finite number"))
            })
        })
        .collect();
    let numbers = numbers?;
    let wanted = 5 + usize::from(*two) + distortions;
    if numbers.len() != wanted {
        let count = numbers.len();
        let problem = format!("{model} has {count} numbers: it must have {wanted}");
        return Err(error(camera.at, problem));
    }
    let size = image_of(numbers[0], numbers[1])
        .map_err(|right| error(camera.at, format!("WIDTH HEIGHT: {right}")))?;
    let rest = &numbers[if *two { 4 } else { 3 }..];
    let (fx, fy) = (numbers[2], if *two { numbers[3] } else { numbers[2] });
    if fx <= 0.0 || fy <= 0.0 {
        let problem = format!("the focal length is {}: it must be greater than 0", n(fx.min(fy)));
        return Err(error(camera.at, problem));
    }
    let k = Intrinsics { fx, fy, cx: rest[0], cy: rest[1] };
    off_centre(&k, size, notes);
    if rest[2..].iter().any(|k| *k != 0.0) {
        notes
            .push("the distortion is left out: a pinhole draws straight lines straight".to_owned());
    }
    Ok((k, size))
}

fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let error = |at: usize, problem: String| error_at(text.path, text.text, at, problem);
    let missing = |what: &str| FileError::of_file(text.path, what.to_owned());
    let camera = camera_line(text.text).ok_or_else(|| {
        missing("the line of cameras.txt is missing: 1 PINHOLE width height fx fy cx cy")
    })?;
    let image = image_line(text.text).ok_or_else(|| {
        missing("the line of images.txt is missing: 1 QW QX QY QZ TX TY TZ CAMERA_ID NAME")
    })?;
    let mut notes = Vec::new();
    let more = image_lines(text.text).count() - 1;
    if more > 0 {
        let name = image.cells[9];
        notes.push(format!("{name} is taken; {more} more images are left out"));
    }
    let (k, size) = intrinsics(text, &camera, &mut notes)?;
    let number = |k: usize| image.cells[k].parse::<f64>().unwrap_or_default();
    let turn =
        Basis::of_quaternion([number(1), number(2), number(3), number(4)]).ok_or_else(|| {
            error(image.at, "QW QX QY QZ are 0 0 0 0: they must be a rotation".to_owned())
        })?;
    // Its columns are the world's axes in the camera; R's rows are wanted.
    let rows = [0, 1, 2].map(|k| DVec3::new(turn.u[k], turn.v[k], turn.w[k]));
    let t = DVec3::new(number(5), number(6), number(7));
    let (orientation, eye) = turned(stance(rows, t), &mut notes)
        .map_err(|right| error(image.at, format!("the pose is no rotation: {right}")))?;
    let viewport = viewport_of(&k, size, at_hand.viewport.distance);
    Ok(Taken::camera(Camera { eye, orientation, viewport, image: size }, notes))
}
