//! COLMAP's `cameras.txt` and `images.txt`: K by one line, the pose by a quaternion and a translation
//! from world to camera.

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Intrinsics};

use super::opencv::{off_centre, pose_of, translation, viewport_of};
use crate::FileError;
use crate::error::one_line;
use crate::format::image_size::image_of;
use crate::format::text::{Text, flipped, n};
use crate::format::{
    Axis, Conventions, ExportScene, Exported, Format, Imported, Importer, Input, PixelConvention,
    Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "colmap",
    label: "COLMAP",
    short: "COLMAP",
    ending: "txt",
    conventions: Conventions {
        axes: [Axis::U, Axis::MINUS_V, Axis::MINUS_W],
        given_by: "quaternion w x y z from world to camera, t = −R eye",
        pixels: PixelConvention::Corner,
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
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "colmap",
    label: "COLMAP",
    read,
    detect: |text| {
        let lines = Lines::split(text);
        !(lines.cameras.is_empty() && lines.images.is_empty())
    },
};

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
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
    let Basis { u, v, w } = *subject.resolve().basis();
    // Columns of R are its rows' coordinates: R = (u, -v, -w) as rows turns world to camera.
    let columns = [0, 1, 2].map(|k| DVec3::new(u[k], -v[k], -w[k]));
    let q = Basis { u: columns[0], v: columns[1], w: columns[2] }.quaternion();
    let t = translation(subject);
    let images = format!(
        "# Image list with two lines of data per image:\n\
         #   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n\
         #   POINTS2D[] as (X, Y, POINT3D_ID)\n\
         1 {} {} {} {} 1 image.png\n\n",
        q.map(n).join(" "),
        n(t.x),
        flipped(n(t.y)),
        flipped(n(t.z))
    );
    let points = "# 3D point list with one line of data per point:\n\
                  #   POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
    let notes = subject.objects_left_out("COLMAP has points only").into_iter().collect();
    let files = vec![
        ("cameras.txt", Text::from_marked(&cameras)),
        ("images.txt", Text::from_marked(&images)),
        ("points3D.txt", Text::from_marked(points)),
    ];
    Ok(Exported { files, notes })
}

/// Models and their parameters: whether fx and fy differ, and how many numbers follow cx, cy.
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

/// An image's line.
struct ImageLine<'t> {
    at: usize,
    /// QW, QX, QY, QZ, TX, TY, TZ.
    numbers: [f64; 7],
    camera: u64,
    name: &'t str,
}

/// The lines of both files, told apart.
#[derive(Default)]
struct Lines<'t> {
    cameras: Vec<Line<'t>>,
    images: Vec<ImageLine<'t>>,
    /// Lines that are none of them.
    others: Vec<&'t str>,
}

impl<'t> Lines<'t> {
    /// Each image's line is followed by one of its points, which may be empty.
    fn split(text: &'t str) -> Lines<'t> {
        let mut lines = Lines::default();
        let (mut at, mut is_points) = (0, false);
        for line in text.split_inclusive('\n') {
            let from = at;
            at += line.len();
            if line.trim_start().starts_with('#') {
                continue;
            }
            let cells: Vec<&str> = line.split_whitespace().collect();
            let is_numbers = cells.iter().all(|cell| cell.parse::<f64>().is_ok());
            if std::mem::take(&mut is_points) && is_numbers || cells.is_empty() {
                continue;
            }
            if let Some(image) = image_line(line, from, &cells) {
                lines.images.push(image);
                is_points = true;
            } else if is_camera(&cells) {
                lines.cameras.push(Line { at: from, cells });
            } else if !is_numbers {
                lines.others.push(line.trim());
            }
        }
        lines
    }
}

fn is_camera(cells: &[&str]) -> bool {
    let is_model =
        |model: &&str| model.len() > 2 && model.chars().all(|c| c.is_ascii_uppercase() || c == '_');
    cells.len() > 4 && cells[0].parse::<u64>().is_ok() && cells.get(1).is_some_and(is_model)
}

/// `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`, whose name may have blanks in it, or be a number.
fn image_line<'t>(line: &'t str, at: usize, cells: &[&'t str]) -> Option<ImageLine<'t>> {
    let [id, numbers @ .., camera] = cells.get(..9)? else { return None };
    let numbers: Vec<f64> = numbers.iter().map_while(|cell| cell.parse().ok()).collect();
    let numbers: [f64; 7] = numbers.try_into().ok()?;
    let (_, camera) = (id.parse::<u64>().ok()?, camera.parse::<u64>().ok()?);
    let (first, rest) = (cells.get(9)?, cells.get(10..).unwrap_or_default());
    let is_number = |cell: &&str| cell.parse::<f64>().is_ok();
    let is_unit = (numbers[..4].iter().map(|q| q * q).sum::<f64>() - 1.0).abs() < 0.01;
    let is_named = !is_number(first) || !rest.iter().all(is_number);
    // The name is what is left of the line.
    let skipped = |rest: &'t str, cell: &&str| rest.trim_start().strip_prefix(*cell);
    let name = cells.iter().take(9).try_fold(line, skipped)?.trim();
    let is_image =
        numbers.iter().all(|x| x.is_finite()) && (is_named || rest.is_empty() && is_unit);
    is_image.then_some(ImageLine { at, numbers, camera, name })
}

/// The line of a camera.
fn intrinsics(
    text: &Input,
    camera: &Line,
    notes: &mut Vec<String>,
) -> Result<(Intrinsics, ImageSize), FileError> {
    let error = |at: usize, problem: String| text.error_at(at, problem);
    let model = camera.cells[1];
    let Some((_, two, distortions)) = MODELS.iter().find(|known| known.0 == model) else {
        let known: Vec<&str> = MODELS.iter().map(|known| known.0).collect();
        let (model, right) = (one_line(model), known.join(", "));
        return Err(error(camera.at, format!("MODEL is {model}: it must be one of {right}")));
    };
    let numbers: Result<Vec<f64>, FileError> = camera.cells[2..]
        .iter()
        .map(|cell| {
            let number = cell.parse::<f64>().ok().filter(|x| x.is_finite());
            number.ok_or_else(|| {
                error(
                    camera.at,
                    format!("PARAMS has {}: it must be a finite number", one_line(cell)),
                )
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

/// The camera that an image has.
fn camera_of<'l, 't>(
    text: &Input,
    cameras: &'l [Line<'t>],
    image: &ImageLine,
) -> Result<&'l Line<'t>, FileError> {
    let id = image.camera;
    let mut own = cameras.iter().filter(|camera| camera.cells[0].parse() == Ok(id));
    let error = |at: usize, problem: String| Err(text.error_at(at, problem));
    match (own.next(), own.next()) {
        (Some(camera), None) => Ok(camera),
        (Some(_), Some(second)) => {
            error(second.at, format!("CAMERA_ID is {id}: it must be given once"))
        }
        (None, _) => {
            let ids: Vec<&str> = cameras.iter().take(5).map(|camera| camera.cells[0]).collect();
            let more = if cameras.len() > 5 { ", ..." } else { "" };
            let problem = format!(
                "CAMERA_ID of {} is {id}: it must be that of a camera in cameras.txt, {}{more}",
                one_line(image.name),
                one_line(&ids.join(", "))
            );
            error(image.at, problem)
        }
    }
}

fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let error = |at: usize, problem: String| text.error_at(at, problem);
    let missing = |what: &str| FileError::of_file(text.path, what.to_owned());
    let lines = Lines::split(text.text);
    if lines.cameras.is_empty() {
        let line = "the line of cameras.txt is missing: 1 PINHOLE width height fx fy cx cy";
        return Err(missing(line));
    }
    let image = lines.images.first().ok_or_else(|| {
        missing("the line of images.txt is missing: 1 QW QX QY QZ TX TY TZ CAMERA_ID NAME")
    })?;
    let camera = camera_of(text, &lines.cameras, image)?;
    let mut notes = Vec::new();
    let more = lines.images.len() - 1;
    if more > 0 {
        let name = one_line(image.name);
        notes.push(format!("{name} is taken; {more} more images are left out"));
    }
    if let Some(first) = lines.others.first() {
        let first = one_line(first);
        let count = lines.others.len();
        notes.push(format!(
            "{count} lines are left out, the first is \"{first}\": they are none of a camera, an image \
             or its points"
        ));
    }
    let (k, size) = intrinsics(text, camera, &mut notes)?;
    let [qw, qx, qy, qz, x, y, z] = image.numbers;
    let turn = Basis::of_quaternion([qw, qx, qy, qz]).ok_or_else(|| {
        error(image.at, "QW QX QY QZ are 0 0 0 0: they must be a rotation".to_owned())
    })?;
    // Its columns are the world's axes in the camera; R's rows are wanted.
    let rows = [0, 1, 2].map(|k| DVec3::new(turn.u[k], turn.v[k], turn.w[k]));
    let (orientation, eye, _) = pose_of(rows, DVec3::new(x, y, z))
        .right_handed(&mut notes)
        .map_err(|right| error(image.at, format!("the pose is no rotation: {right}")))?;
    let viewport = viewport_of(&k, size, at_hand.viewport.distance);
    Ok(Imported::camera(Camera { eye, orientation, viewport, image: size }, notes))
}
