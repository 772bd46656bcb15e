//! Reading a POV-Ray scene: its camera, spheres and planes, where they are given by plain numbers.

use pinhole_core::{Basis, BasisError, Camera, DVec3, ImageSize, Viewport};

use super::blocks::Blocks;
use super::objects::objects;
use super::source::{Code, words};
use super::values::{Values, has};
use crate::FileError;
use crate::format::image_size::{image_of, image_of_ratio, size_note};
use crate::format::pose::Pose;
use crate::format::viewport::settled;
use crate::format::{Imported, Input};
use crate::programs::pieces::{Piece, is_of_word};

/// Words of a pinhole camera.
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

/// Words that move a camera as a whole.
const MOVES: [&str; 5] = ["rotate", "translate", "scale", "matrix", "transform"];

/// Words that blur, as a lens does.
const BLUR: [&str; 6] =
    ["aperture", "focal_point", "blur_samples", "confidence", "variance", "bokeh"];

/// Word that bends the rays.
const BENT: &str = "normal";

/// Returns the words that may stand in a camera, each with its value behind it.
fn camera_words() -> impl Iterator<Item = &'static str> {
    let lists: [&[&str]; 5] = [&OWN, &OTHER_PROJECTIONS, &MOVES, &BLUR, &[BENT]];
    lists.into_iter().flatten().copied()
}

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let code = Code::new(text);
    let mut notes = Vec::new();
    let given = size(text);
    let values = Values::new(&code, given.unwrap_or(at_hand.image));
    let blocks = Blocks::find(&code);
    let camera = blocks.camera(&code, &mut notes)?;
    let (view, image, values) = match given {
        Some(image) => (View::read(&code, &values, camera)?, image, values),
        None => by_ratio(&code, values, camera, at_hand.image, &mut notes)?,
    };
    let view = view.turned(&mut notes).map_err(|error| no_aim(&code, camera, &error))?;
    let View { location: eye, right, up, direction, .. } = view;
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
    let pose = Pose { eye, right, up, backwards: DVec3::ZERO - direction };
    let (orientation, eye, mirrored) = pose.right_handed(&mut notes).map_err(|right| {
        FileError::of_file(text.path, format!("camera is no rotation: {right}"))
    })?;
    blocks.left_out(&mut notes);
    let (spheres, planes) = objects(&code, &values, &blocks, &mut notes);
    let camera = Camera { eye, orientation, viewport, image };
    Ok(Imported { camera, spheres, planes, notes }.mirrored_if(mirrored))
}

/// A length without the digits that a square root adds to a short number.
fn tidy(length: f64) -> f64 {
    settled(length, 4.0 * f64::EPSILON * length)
}

/// `+W400 +H300` wherever it stands, the comment at the head included.
fn size(text: &Input) -> Option<ImageSize> {
    let option = |name: &str| {
        let mut words = text.text.split_whitespace();
        words.find_map(|word| word.strip_prefix(name)?.parse::<f64>().ok())
    };
    option("+W").zip(option("+H")).and_then(|(w, h)| image_of(w, h).ok())
}

/// The camera and an image whose sides have the ratio of right and up, so that pixels are square, as
/// POV-Ray's are meant to be: that at hand where right follows the image.
fn by_ratio<'t>(
    code: &'t Code,
    values: Values<'t>,
    camera: Piece,
    at_hand: ImageSize,
    notes: &mut Vec<String>,
) -> Result<(View, ImageSize, Values<'t>), FileError> {
    let view = View::read(code, &values, camera)?;
    let (aspect, mut said) = (view.aspect(), Vec::new());
    if aspect.is_finite() && aspect > 0.0 {
        let image = image_of_ratio(at_hand, aspect, "the scene", &mut said);
        let values = Values::new(code, image);
        let other = View::read(code, &values, camera)?;
        if image == at_hand || other.aspect() == aspect {
            notes.append(&mut said);
            return Ok((other, image, values));
        }
    }
    let unsaid = "the scene does not say how many pixels there are";
    notes.push(size_note(unsaid, at_hand, " taken"));
    Ok((view, at_hand, Values::new(code, at_hand)))
}

/// Returns the value of a word of a camera: the text up to the next one.
fn value<'t>(camera: Piece<'t>, word: &str) -> Option<Piece<'t>> {
    let at = *words(camera, word).last()?;
    let rest = camera.from(at + word.len());
    let next = next_word(rest).map_or(rest.text.len(), |next| next.at - rest.at);
    Some(rest.until(next).trimmed())
}

/// The first word of a camera in a piece.
fn next_word(mut rest: Piece) -> Option<Piece> {
    while !rest.text.is_empty() {
        let word = rest.word();
        if camera_words().any(|known| known == word.text) {
            return Some(word);
        }
        let behind = rest.from(word.text.len());
        rest = behind.from(behind.text.find(is_of_word).unwrap_or(behind.text.len()));
    }
    None
}

/// Values of a camera.
struct View {
    location: DVec3,
    right: DVec3,
    up: DVec3,
    direction: DVec3,
    sky: DVec3,
    look_at: Option<DVec3>,
}

impl View {
    fn read(code: &Code, values: &Values, camera: Piece) -> Result<View, FileError> {
        let first = camera.trimmed().word().text;
        if !camera.trimmed().text.is_empty() && !camera_words().any(|word| word == first) {
            let right = "it must begin with a word such as location, or be a name that is declared before it in this \
                         file as = camera { ... }";
            return Err(code.fault("camera", camera.trimmed(), right));
        }
        if let Some(at) = camera.text.find('#') {
            let piece = camera.from(at + 1).word();
            return Err(code.fault("camera", piece, "no directive must stand in it"));
        }
        if let Some(other) = OTHER_PROJECTIONS.iter().find(|other| has(camera, other)) {
            let piece = Piece { text: other, at: camera.at + words(camera, other)[0] };
            return Err(code.fault("the projection", piece, "it must be perspective"));
        }
        for moved in MOVES {
            if let Some(piece) = value(camera, moved) {
                return Err(code.fault(moved, piece, "the camera must be given without it"));
            }
        }
        let given = |word: &str| {
            let Some(piece) = value(camera, word) else { return Ok(None) };
            if let Some(vector) = values.vector(piece) {
                return Ok(Some(vector));
            }
            // Which of its numbers is none.
            let inside = code.bracketed(piece).unwrap_or(piece);
            let is_none = |part: &Piece| values.number(*part).is_none();
            if let (3, Some(part)) =
                (inside.split().len(), inside.split().into_iter().find(is_none))
            {
                return Err(code.fault(word, part, "it must be a finite number"));
            }
            let right = match values.is_open(piece.text) {
                true => {
                    "it is declared more than once, under a condition, or not by plain numbers: here it \
                     must be numbers"
                }
                false => "it must be a vector of numbers, as <1, 2, 3>",
            };
            Err(code.fault(word, piece, right))
        };
        let or = |word: &str, or: DVec3| Ok::<_, FileError>(given(word)?.unwrap_or(or));
        let mut view = View {
            location: or("location", DVec3::ZERO)?,
            right: or("right", DVec3::new(1.33, 0.0, 0.0))?,
            up: or("up", DVec3::Y)?,
            direction: or("direction", DVec3::Z)?,
            sky: or("sky", DVec3::Y)?,
            look_at: given("look_at")?,
        };
        if let Some(piece) = value(camera, "angle") {
            let angle = values.number(piece).filter(|angle| *angle > 0.0 && *angle < 180.0);
            let angle = angle.ok_or_else(|| {
                code.fault("angle", piece, "it must be between 0 and 180 degrees")
            })?;
            // The horizontal field of view, which sets direction's length.
            let length = 0.5 * view.right.length() / (0.5 * angle.to_radians()).tan();
            view.direction = view.direction.normalize_or_zero() * length;
        }
        Ok(view)
    }

    /// Width by height.
    fn aspect(&self) -> f64 {
        self.right.length() / self.up.length()
    }

    /// Turns the camera towards `look_at` as POV-Ray does: right, up and direction keep their lengths, and
    /// the camera its handedness. Where `look_at` lies along sky, right stays as it is given; POV-Ray 3.7
    /// warns of it, too.
    ///
    /// # Errors
    /// Returns an error if location and `look_at` give no direction, or sky none.
    fn turned(self, notes: &mut Vec<String>) -> Result<View, BasisError> {
        let View { right, up, direction, .. } = self;
        let Some(at) = self.look_at else { return Ok(self) };
        let left_handed = up.cross(direction).dot(right) > 0.0;
        let (side, above, ahead) = match Basis::from_eye_at_up(self.location, at, self.sky) {
            Ok(Basis { u, v, w }) => (-u, v, -w),
            Err(BasisError::UpParallelToView { view, .. }) => {
                let said = "look_at lies straight along sky: right is taken as it is given, as POV-Ray does";
                notes.push(said.to_owned());
                let (side, ahead) = (right.normalize_or_zero(), view.normalize_or_zero());
                (side, ahead.cross(side), ahead)
            }
            Err(other) => return Err(other),
        };
        let side = if left_handed { side } else { -side };
        Ok(View {
            right: side * right.length(),
            up: above * up.length(),
            direction: ahead * direction.length(),
            ..self
        })
    }
}

/// The error of a camera that cannot be turned towards `look_at`.
fn no_aim(code: &Code, camera: Piece, error: &BasisError) -> FileError {
    let right = match error {
        BasisError::EyeIsAt { .. } => "it must be another point than location",
        BasisError::UpIsZero => "sky must not be <0, 0, 0>",
        other => &other.to_string(),
    };
    code.fault("look_at", value(camera, "look_at").unwrap_or(camera), right)
}
