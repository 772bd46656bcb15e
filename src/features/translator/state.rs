//! The translator: writes the camera in another program's notation, compares conventions, and reads pasted
//! cameras.

use std::path::Path;

use pinhole_core::{Camera, DVec3, Orientation, Pixel};
use pinhole_exchange::format::{
    Axis, Conventions, ExportScene, Exported, Format, Imported, Include, Input, PixelConvention,
};
use pinhole_exchange::programs::{FORMATS, Importer, UNKNOWN, file_text};
use pinhole_exchange::{Document, FileError, limits};
use pinhole_figure::symbols::{bold, italic};
use pinhole_lecture::numbers::{equated_tuple, written_whole};

use crate::model::with_defaults;

/// Maximum number of objects that are written and displayed.
pub const MOST_OBJECTS: usize = 500;

with_defaults! {
    /// The choices in the translator.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Translator {
        /// The name of the [`Format`].
        pub target: &'static str = "opencv",
        /// True if the objects are written as well.
        pub objects: bool = false,
        /// The notice about the last action, while it is shown.
        pub notice: Option<Notice> = None,
    }
}

impl Translator {
    /// Returns the chosen format.
    pub fn chosen(&self) -> &'static Format {
        Format::named(self.target).unwrap_or(&FORMATS[0])
    }
}

/// A brief notice about a finished action, such as pasting a camera or reloading a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// The result in a few words.
    pub title: String,
    /// Further details: what was left out, or the error in the text.
    pub notes: Vec<String>,
    /// True if the action succeeded.
    pub worked: bool,
    /// The camera after the action; `None` if the action did not involve the camera. Once the camera has
    /// changed, the notice is outdated.
    pub camera: Option<Camera>,
    /// Time in seconds at which the notice was first shown; `None` if it has not been shown yet.
    pub shown_at: Option<f64>,
}

/// A camera that was read, if there was a valid one, and the notice that says what was read or why not.
pub type Taken = (Option<Camera>, Notice);

/// Returns a notice that no camera was read.
fn not_taken(title: String, note: String, at_hand: &Camera) -> Taken {
    let (camera, notes) = (Some(*at_hand), vec![note]);
    (None, Notice { title, notes, worked: false, camera, shown_at: None })
}

/// Reads the camera in a text. Values that the text does not specify are taken from the camera `at_hand`;
/// objects in the text are ignored.
pub fn pasted(text: &str, at_hand: &Camera) -> Taken {
    if text.len() > limits::PASTE {
        let most = limits::PASTE >> 10;
        let has = text.len().div_ceil(1 << 10);
        let problem = format!(
            "it has {has} KiB, and at most {most} KiB are read: copy the camera's lines alone"
        );
        let title = "This text was not pasted: nothing was changed";
        return not_taken(title.to_owned(), problem, at_hand);
    }
    let Some(importer) = Importer::of(text) else {
        let title = "This text is not a camera: nothing was changed";
        return not_taken(title.to_owned(), UNKNOWN.to_owned(), at_hand);
    };
    let text = Input { path: Path::new("pasted"), text };
    taken(importer.read(&text, at_hand).map(|read| (importer, read)), "pasted", at_hand)
}

/// Reads the camera in a file, as [`pasted`] does in a text.
pub fn imported(path: &Path, at_hand: &Camera) -> Taken {
    let read = || {
        let text = file_text(path, limits::read(path, limits::FOREIGN)?)?;
        let text = Input { path, text: &text };
        let importer = Importer::of_file(&text)?;
        Ok((importer, importer.read(&text, at_hand)?))
    };
    taken(read(), "imported", at_hand)
}

/// Returns the camera that was read, and says how and from what, or why it was not.
fn taken(read: Result<(Importer, Imported), FileError>, how: &str, at_hand: &Camera) -> Taken {
    match read {
        Ok((importer, read)) => {
            let (camera, notes) = (Some(read.camera), read.notes);
            let title = format!("Camera {how}: {}", importer.label());
            (camera, Notice { title, notes, worked: true, camera, shown_at: None })
        }
        Err(error) => {
            let title = format!("Not {how}: this camera cannot be read");
            not_taken(title, error.to_string(), at_hand)
        }
    }
}

/// Returns what an export contains besides the camera: the objects, if the user wants them and there are
/// not too many of them.
pub fn with(document: &Document, objects: bool) -> Include {
    let few = document.object_count() <= MOST_OBJECTS;
    if objects && few { Include::Meshes } else { Include::CameraAlone }
}

/// A camera in the notation of a format.
#[derive(Clone, Debug, PartialEq)]
pub struct Translation {
    /// The text, or the reason why the camera cannot be written.
    pub written: Result<Exported, String>,
    /// The table of conventions. It is empty if there is no valid camera, and for exports as source code,
    /// which follow the lecture's own conventions.
    pub rows: Vec<ConventionRow>,
}

impl Translation {
    /// Translates a document's camera into a format. `pixel` is the example pixel in the table of
    /// conventions.
    pub fn new(
        document: &Document,
        format: &Format,
        objects: bool,
        pixel: Pixel,
        digits: usize,
    ) -> Translation {
        match ExportScene::new(document, with(document, objects)) {
            Ok(subject) => Translation {
                written: format.write(&subject),
                rows: (format.conventions.as_ref())
                    .map_or_else(Vec::new, |own| rows(own, &subject, pixel, digits)),
            },
            Err(error) => Translation { written: Err(error), rows: Vec::new() },
        }
    }
}

/// A row of the table of conventions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConventionRow {
    /// Name of the convention.
    pub about: &'static str,
    /// Pinhole's form of the convention.
    pub ours: String,
    /// The other format's form of it.
    pub theirs: String,
    /// True if the two forms are opposite, such as axes with opposite directions.
    pub flipped: bool,
    /// True if the other format's convention differs from Pinhole's.
    pub differs: bool,
}

/// Returns two texts: the rule by which a program assigns coordinates to the centres of pixels, and the
/// coordinates of this pixel's centre by that rule, in an image of this size.
fn counted(
    pixels: PixelConvention,
    Pixel { row, column }: Pixel,
    [width, height]: [u32; 2],
) -> [String; 2] {
    let (i, j) = (italic('i'), italic('j'));
    let (y, x) = (f64::from(row), f64::from(column));
    let (w, h) = (f64::from(width), f64::from(height));
    let short = |x: f64| (x * 1e4).round() / 1e4;
    let (rule, [a, b]) = match pixels {
        PixelConvention::Corner => {
            (format!("x = {j} + ½, y = {i} + ½: from the upper left corner"), [x + 0.5, y + 0.5])
        }
        PixelConvention::AtCentre => {
            (format!("x = {j}, y = {i}: from the centre of the first pixel"), [x, y])
        }
        PixelConvention::FromBottom => (
            format!("x = {j} + ½, y = H − {i} − ½: from the lower left corner, up"),
            [x + 0.5, h - y - 0.5],
        ),
        PixelConvention::FromOne => {
            (format!("{i} + 1, {j} + 1: counted from 1"), [y + 1.0, x + 1.0])
        }
        PixelConvention::ColumnFirst => (format!("get_ray({j}, {i}): the column first"), [x, y]),
        PixelConvention::Device => (
            format!("x = (2{j} + 1) / W − 1, y = 1 − (2{i} + 1) / H: −1 to 1, up"),
            [short((2.0 * x + 1.0 - w) / w), short((h - 2.0 * y - 1.0) / h)],
        ),
    };
    [rule, format!("({}, {})", written_whole(a), written_whole(b))]
}

/// Returns the table that compares a format's conventions with Pinhole's, one in each row. It also shows the
/// values that they give for the subject's camera, such as its axes and its field of view, rounded to
/// `digits` significant digits, and for `pixel`, an example in the rows about pixels.
fn rows(
    conventions: &Conventions,
    subject: &ExportScene,
    pixel: Pixel,
    digits: usize,
) -> Vec<ConventionRow> {
    let (image, viewport) = (subject.resolve().image(), subject.resolve().viewport());
    let size = [image.width(), image.height()];
    let mut table = axes(conventions, subject, digits);
    let mut line = |about, ours: &str, theirs: &str, flipped, differs| {
        let (ours, theirs) = (ours.to_owned(), theirs.to_owned());
        table.push(ConventionRow { about, ours, theirs, flipped, differs });
    };
    let hand = |is_left| if is_left { "left-handed" } else { "right-handed" };
    let is_left = !conventions.is_right_handed();
    line("its axes are", hand(false), hand(is_left), is_left, is_left);
    let looks = |forward| if forward { "along +z" } else { "along −z" };
    let forward = conventions.axes[2] == Axis::MINUS_W;
    line("it looks", looks(false), looks(forward), forward, forward);
    let at_or = match subject.document.camera.orientation {
        Orientation::At { .. } => "eye, at, up",
        Orientation::View { .. } => "eye, view, up",
        Orientation::Basis(_) => "eye and u, v, w",
    };
    line("given by", at_or, conventions.given_by, false, true);
    let pixels = conventions.pixels;
    let [our_rule, our_centre] = counted(PixelConvention::Corner, pixel, size);
    let [their_rule, their_centre] = counted(pixels, pixel, size);
    let flipped = matches!(pixels, PixelConvention::FromBottom | PixelConvention::Device);
    let differs = pixels != PixelConvention::Corner;
    line("centre of a pixel", &our_rule, &their_rule, flipped, differs);
    let ours = format!("row, column ({}, {}), centre {our_centre}", pixel.row, pixel.column);
    line("in numbers", &ours, &their_centre, flipped, differs);
    let [w, h, d] = [viewport.width, viewport.height, viewport.distance].map(written_whole);
    let theirs = format!("{}: {}", conventions.view, conventions.field_of_view(subject));
    line("field of view", &format!("width {w} × height {h} at distance {d}"), &theirs, false, true);
    line("distance", "t = 1 is the viewport", conventions.distance, false, true);
    let is_fixed = !conventions.shape.starts_with("any");
    line("pixels' shape", "any", conventions.shape, false, is_fixed);
    table
}

/// Returns the rows about the camera's axes x, y and z. They give each axis as a vector of the world, in
/// Pinhole's convention and in the format's.
fn axes(conventions: &Conventions, subject: &ExportScene, digits: usize) -> Vec<ConventionRow> {
    let basis = subject.resolve().basis();
    let text = |axis: Axis| {
        let v = basis.to_world_from_camera(axis.direction);
        // Adding 0 makes a negative zero positive.
        let is = equated_tuple(&(v + DVec3::ZERO).to_array(), digits);
        // A bold letter with its sign.
        let letter: String = axis.name.chars().map(bold).collect();
        format!("{} {letter} {is}", axis.meaning)
    };
    let names = ["x of the camera", "y of the camera", "z of the camera"];
    let pairs = names.into_iter().zip(Conventions::OURS.into_iter().zip(conventions.axes));
    pairs
        .map(|(about, (ours, theirs))| ConventionRow {
            about,
            ours: text(ours),
            theirs: text(theirs),
            flipped: theirs.is_flipped(),
            differs: ours != theirs,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Web pages and editors put such characters on the clipboard.
    #[test]
    fn a_paste_with_characters_of_more_bytes_is_read_or_told() {
        let text = "glm::mat4\u{a0}view =\u{a0}glm::lookAt(glm::vec3(4, 3, 3),\u{a0}glm::vec3(0), \
                    glm::vec3(0, 1, 0)); // it\u{2019}s\n";
        assert_eq!(pasted(text, &Camera::CANONICAL).1.notes.len(), 1);
        for (at, _) in text.char_indices() {
            for strange in ["\u{a0}", "\u{2019}", "\u{201c}", "\r", "\r\u{1d54f}"] {
                let (head, tail) = text.split_at(at);
                let (camera, said) = pasted(&format!("{head}{strange}{tail}"), &Camera::CANONICAL);
                assert_eq!((camera.is_some(), !said.notes.is_empty()), (said.worked, true));
            }
        }
    }

    #[test]
    fn a_large_paste_is_refused_and_one_of_many_calculations_is_told_in_short() {
        let sum = |terms: usize| format!("gluLookAt({}1)", "1 + ".repeat(terms));
        let told = |text: &str| {
            let (camera, said) = pasted(text, &Camera::CANONICAL);
            assert_eq!(camera, None);
            said.notes.join(" ")
        };
        assert!(told(&sum(30_000)).len() < 300);
        assert_eq!(
            told(&sum(40_000)),
            "it has 157 KiB, and at most 128 KiB are read: copy the camera's lines alone"
        );
    }
}
