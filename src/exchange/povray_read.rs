//! Reading a POV-Ray scene: its camera, spheres and planes, where they are given by plain numbers.

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Viewport};

use super::back::{MIRRORED, Mirrored, Stance, image_of, settled};
use super::code::{Code, Comments, Piece, number, trimmed, words};
use super::povray_objects::Blocks;
use super::{Taken, Text};
use crate::formats::FileError;

/// What a camera of ours has.
const OWN: [&str; 8] =
    ["perspective", "location", "right", "up", "direction", "sky", "look_at", "angle"];

/// The projections that are none of a pinhole camera.
const OTHER_PROJECTIONS: [&str; 7] = [
    "orthographic",
    "fisheye",
    "ultra_wide_angle",
    "omnimax",
    "panoramic",
    "cylinder",
    "spherical",
];

/// What moves a camera as a whole.
const MOVES: [&str; 5] = ["rotate", "translate", "scale", "matrix", "transform"];

/// What blurs, as a lens does.
const BLUR: [&str; 6] =
    ["aperture", "focal_point", "blur_samples", "confidence", "variance", "bokeh"];

/// What bends the rays.
const BENT: &str = "normal";

/// What may stand in a camera, after whose value the next one begins.
fn camera_words() -> impl Iterator<Item = &'static str> {
    let lists: [&[&str]; 5] = [&OWN, &OTHER_PROJECTIONS, &MOVES, &BLUR, &[BENT]];
    lists.into_iter().flatten().copied()
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::SlashesAndAngles);
    let mut notes = Vec::new();
    let blocks = Blocks::of(&code);
    // camera { Name } says nothing itself: it is one that was declared.
    let says = |camera: &&Piece| camera_words().any(|word| !words(**camera, word).is_empty());
    let camera = blocks.cameras.iter().rfind(says).or(blocks.cameras.last()).copied();
    let camera =
        camera.ok_or_else(|| code.missing("camera", "as camera { location <0, 0, 0> }"))?;
    let image = image(text, at_hand, &mut notes);
    let view = View::read(&code, camera, image)?;
    let Frame { right, up, direction } = view.frame();
    let viewport = Viewport {
        width: tidy(right.length()),
        height: tidy(up.length()),
        distance: tidy(direction.length()),
    };
    if BLUR.iter().any(|word| value(camera, word).is_some()) {
        notes.push("lens blur is left out: a pinhole is sharp everywhere".to_owned());
    }
    if value(camera, BENT).is_some() {
        notes.push("the camera's normal is left out: a pinhole's rays are straight".to_owned());
    }
    let stance = Stance { eye: view.location, right, up, backwards: DVec3::ZERO - direction };
    let mirrored = Basis::is_left_handed(right, up, -direction);
    let stance = if mirrored { stance.mirrored() } else { stance };
    let orientation =
        stance.orientation(&mut notes).map_err(|right| code.rotation("camera", &right))?;
    if mirrored {
        notes.push(MIRRORED.to_owned());
    }
    blocks.left_out(&mut notes);
    let mut spheres = blocks.spheres(&code, &mut notes);
    let mut planes = blocks.planes(&code, &mut notes);
    blocks.colors(&code, &mut notes);
    if mirrored {
        (spheres, planes) = (spheres.mirrored(), planes.mirrored());
    }
    let camera = Camera { eye: stance.eye, orientation, viewport, image };
    Ok(Taken { camera, spheres, planes, notes })
}

/// A length without the digits that a square root adds to a short number.
fn tidy(length: f64) -> f64 {
    settled(length, 4.0 * f64::EPSILON * length)
}

/// `+W400 +H300` wherever it stands, the comment at the head included.
fn image(text: &Text, at_hand: &Camera, notes: &mut Vec<String>) -> ImageSize {
    let option = |name: &str| {
        let mut words = text.text.split_whitespace();
        words.find_map(|word| word.strip_prefix(name)?.parse::<f64>().ok())
    };
    let given = option("+W").zip(option("+H")).and_then(|(w, h)| image_of(w, h).ok());
    given.unwrap_or_else(|| {
        let image = at_hand.image;
        let (w, h) = (image.width(), image.height());
        notes.push(format!("the scene does not say +W and +H: {w} × {h} pixels taken"));
        image
    })
}

/// What follows a word of a camera, up to the next one.
fn value<'t>(camera: Piece<'t>, word: &str) -> Option<Piece<'t>> {
    let at = *words(camera, word).last()?;
    let rest = camera.from(at + word.len());
    let next = camera_words().flat_map(|word| words(rest, word)).min();
    Some(trimmed(Piece { text: &rest.text[..next.unwrap_or(rest.text.len())], ..rest }))
}

/// What a camera says.
struct View {
    location: DVec3,
    right: DVec3,
    up: DVec3,
    direction: DVec3,
    sky: DVec3,
    look_at: Option<DVec3>,
}

struct Frame {
    right: DVec3,
    up: DVec3,
    direction: DVec3,
}

impl View {
    fn read(code: &Code, camera: Piece, image: ImageSize) -> Result<View, FileError> {
        if let Some(other) = OTHER_PROJECTIONS.iter().find(|other| !words(camera, other).is_empty())
        {
            let piece = Piece { text: other, at: camera.at + words(camera, other)[0] };
            return Err(code.fault("the projection", piece, "it must be perspective"));
        }
        for moved in MOVES {
            if let Some(piece) = value(camera, moved) {
                return Err(code.fault(moved, piece, "the camera must be given without it"));
            }
        }
        let or = |word: &str, or: DVec3| match value(camera, word) {
            Some(piece) => vector(code, word, piece, image),
            None => Ok(or),
        };
        let look_at = value(camera, "look_at");
        let mut view = View {
            location: or("location", DVec3::ZERO)?,
            right: or("right", DVec3::new(1.33, 0.0, 0.0))?,
            up: or("up", DVec3::Y)?,
            direction: or("direction", DVec3::Z)?,
            sky: or("sky", DVec3::Y)?,
            look_at: look_at.map(|piece| vector(code, "look_at", piece, image)).transpose()?,
        };
        if let Some(piece) = value(camera, "angle") {
            let angle = number(piece.text).filter(|angle| *angle > 0.0 && *angle < 180.0);
            let angle = angle.ok_or_else(|| {
                code.fault("angle", piece, "it must be between 0 and 180 degrees")
            })?;
            // The horizontal field of view, which sets direction's length.
            let length = 0.5 * view.right.length() / (0.5 * angle.to_radians()).tan();
            view.direction = view.direction.normalize_or_zero() * length;
        }
        Ok(view)
    }

    /// As POV-Ray turns the camera towards `look_at`: right, up and direction keep their lengths, and
    /// the camera its handedness.
    fn frame(&self) -> Frame {
        let View { right, up, direction, .. } = *self;
        let Some(at) = self.look_at else { return Frame { right, up, direction } };
        let left_handed = up.cross(direction).dot(right) > 0.0;
        let ahead = (at - self.location).normalize_or_zero();
        let side = self.sky.cross(ahead).normalize_or_zero();
        let above = ahead.cross(side);
        let side = if left_handed { side } else { -side };
        Frame {
            right: side * right.length(),
            up: above * up.length(),
            direction: ahead * direction.length(),
        }
    }
}

/// `<1, 2, 3>`, or a multiple of x, y and z as in `x * image_width / image_height`.
pub(super) fn vector(
    code: &Code,
    field: &str,
    piece: Piece,
    image: ImageSize,
) -> Result<DVec3, FileError> {
    if piece.text.starts_with('[') {
        return code.vector(field, piece);
    }
    let with = |axis: usize| {
        let mut text = piece.text.to_owned();
        let size = [("image_width", image.width()), ("image_height", image.height())];
        for (word, value) in size {
            text = text.replace(word, &value.to_string());
        }
        let letters = text.chars().map(|c| match c {
            'x' | 'y' | 'z' => format!("({})", u8::from(c as usize - 'x' as usize == axis)),
            other => other.to_string(),
        });
        number(&letters.collect::<String>())
    };
    match [with(0), with(1), with(2)] {
        [Some(x), Some(y), Some(z)] => Ok(DVec3::new(x, y, z) + DVec3::ZERO),
        _ => Err(code.fault(field, piece, "it must be a vector of numbers, as <1, 2, 3>")),
    }
}
