//! Reads a document from a scene file's text.

use std::ops::{Range, RangeInclusive};
use std::path::Path;
use std::sync::Arc;

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Orientation, Plane, Rgb, Sphere, Viewport};
use toml_edit::Document as Toml;
use toml_parser::lexer::TokenKind;

use super::{VERSION, note_of_block, split_note};
use crate::csv::{self, SphereTable};
use crate::document::{CsvSpheres, Document, Item, StoredObserver};
use crate::error::one_line;
use crate::fields::{Section, TomlField, TomlSource};
use crate::format::{Imported, Input};
use crate::host::host;
use crate::{FileError, images, limits};

const TOP: &[&str] =
    &["pinhole", "spheres", "camera", "viewport", "image", "observer", "sphere", "plane"];
/// The tables of a scene that a lesson's step may have.
pub const TABLES: [&str; 5] = ["camera", "viewport", "image", "sphere", "plane"];
/// The fields in [`TOP`] that are values rather than tables, and must therefore precede the first
/// table.
const BEFORE_TABLES: &[&str] = &["pinhole", "spheres"];

/// Reads a document. If `base` is `None`, the CSV file is not read.
pub(super) fn document(
    text: &str,
    path: &Path,
    base: Option<&Path>,
    is_draft: bool,
) -> Result<Document, FileError> {
    let source = TomlSource { text, path, is_draft };
    let toml = toml(&source)?;
    let root = Section::root(&source, toml.as_table());
    root.version("pinhole", "scene", VERSION)?;
    root.only(TOP, &[])?;
    root.need("camera", "[camera] with eye, at and up")?;
    let mut document = Document {
        note: note_of_block(split_note(text.trim_start_matches('\u{feff}')).0),
        ..Document::default()
    };
    tables(&root, &mut document)?;
    document.observer = root.get("observer").map(|field| observer(&field)).transpose()?;
    document.csv_spheres =
        root.get("spheres").map(|field| csv_spheres(&field, base)).transpose()?;
    Ok(document)
}

/// Reads the camera of a scene without its CSV file, or of some of its tables alone. Such tables need no
/// version, and what they do not give is that of the camera `at_hand`.
pub(crate) fn camera(input: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let Input { text, path } = *input;
    let source = TomlSource { text, path, is_draft: false };
    let toml = toml(&source)?;
    let root = Section::root(&source, toml.as_table());
    let mut scene = Document { camera: *at_hand, ..Document::default() };
    if root.get("pinhole").is_some() {
        scene = document(text, path, None, false)?;
    } else {
        root.only(TOP, &[])?;
        tables(&root, &mut scene)?;
        root.get("observer").map(|field| observer(&field)).transpose()?;
    }
    let has_objects = scene.object_count() > 0 || scene.csv_spheres.is_some();
    let left_out =
        has_objects.then(|| "its objects are left out: a paste sets only the camera".to_owned());
    Ok(Imported { camera: scene.camera, notes: left_out.into_iter().collect() })
}

/// Reads the tables in [`TABLES`], each of which may be missing. A table that is present replaces the
/// corresponding values of the document.
pub fn tables(root: &Section, document: &mut Document) -> Result<(), FileError> {
    let camera = &mut document.camera;
    if let Some(section) = root.get("camera") {
        let Camera { viewport, image, .. } = *camera;
        *camera = Camera { viewport, image, ..read_camera(&section.section()?)? };
    }
    if let Some(section) = root.get("viewport") {
        camera.viewport = viewport(&section.section()?)?;
    }
    if let Some(section) = root.get("image") {
        camera.image = image(&section.section()?)?;
    }
    if let Some(field) = root.get("sphere") {
        document.spheres = objects(&field, sphere)?.into();
    }
    if let Some(field) = root.get("plane") {
        document.planes = objects(&field, plane)?.into();
    }
    Ok(())
}

/// Parses a TOML text of at most [`limits::TEXT`] bytes, whose brackets must not be nested more than
/// [`limits::NESTING`] deep. This is checked first, because the parser is recursive and continues after an
/// error, so that its own limit does not prevent a stack overflow.
///
/// # Errors
/// Returns an error if the text is too large, at the first bracket if they are nested too deep, or the first
/// syntax error.
pub fn toml<'t>(source: &TomlSource<'t>) -> Result<Toml<&'t str>, FileError> {
    if source.text.len() as u64 > limits::TEXT {
        return Err(limits::too_large(source.path, limits::TEXT));
    }
    if let Some(at) = too_deep(source.text) {
        let problem = format!(
            "from this bracket on they are nested more than {} deep: is it closed?",
            limits::NESTING
        );
        return Err(source.error(&(at..at), problem));
    }
    Toml::parse(source.text).map_err(|error| not_toml(source, &error))
}

/// Returns the position of the outermost bracket that is open where the nesting becomes too deep;
/// `None` if it never does.
fn too_deep(text: &str) -> Option<usize> {
    let mut open = Vec::new();
    for token in toml_parser::Source::new(text).lex() {
        match token.kind() {
            kind @ (TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket) => {
                open.push((kind, token.span().start()));
                if open.len() > limits::NESTING {
                    return Some(open[0].1);
                }
            }
            TokenKind::RightSquareBracket => {
                open.pop_if(|(kind, _)| *kind == TokenKind::LeftSquareBracket);
            }
            TokenKind::RightCurlyBracket => {
                open.pop_if(|(kind, _)| *kind == TokenKind::LeftCurlyBracket);
            }
            _ => (),
        }
    }
    None
}

/// Returns true if a comma between two digits begins here.
fn is_decimal_comma(source: &TomlSource, span: &Range<usize>) -> bool {
    let is_digit = |c: char| c.is_ascii_digit();
    let [before, rest] = [source.text.get(..span.start), source.text.get(span.start..)];
    before.is_some_and(|before| before.ends_with(is_digit))
        && rest
            .and_then(|rest| rest.strip_prefix(','))
            .is_some_and(|rest| rest.starts_with(is_digit))
}

/// Rephrases common syntax errors for users who do not know TOML's grammar.
fn not_toml(source: &TomlSource, error: &toml_edit::TomlError) -> FileError {
    let span = error.span().unwrap_or(0..0);
    let found = &*one_line(source.text.get(span.clone()).unwrap_or_default());
    let message = match error.message() {
        "duplicate key" => format!("{found} is given twice"),
        message if message.starts_with("string values must be quoted") => match found {
            "" => "the value after = is missing".to_owned(),
            word => format!("{word} is no value: write a number, or text in quotes"),
        },
        message if message.ends_with("overflowed") => format!("{found} is too large a number"),
        message if message.starts_with("key with no value") => {
            "after a name comes = and its value, such as width = 1.0: is it a scene's file?"
                .to_owned()
        }
        "unclosed array, expected `]`" => "the ] after the last number is missing".to_owned(),
        message
            if message.starts_with("unexpected key or value")
                && is_decimal_comma(source, &span) =>
        {
            "a decimal point, not a comma, must stand here".to_owned()
        }
        message if message.starts_with("unexpected key or value") => {
            "only one name and one value fit in a line: begin a new line here".to_owned()
        }
        message => {
            let message = message.trim_end_matches(", expected nothing");
            format!("not valid TOML: {message}")
        }
    };
    source.error(&span, message)
}

fn read_camera(section: &Section) -> Result<Camera, FileError> {
    section.only(&["eye", "at", "view", "up", "basis"], BEFORE_TABLES)?;
    let eye = section.need("eye", "eye = [0.0, 0.0, 0.0]")?.vector()?;
    let ways: Vec<(&str, TomlField)> = ["at", "view", "basis"]
        .into_iter()
        .filter_map(|way| Some((way, section.get(way)?)))
        .collect();
    if let [(first, _), (_, second), ..] = &ways[..] {
        let first = section.path_of(first);
        let why = format!("together with {first}: keep exactly one of at, view and basis");
        return Err(second.refuse(&why));
    }
    let up = || section.need("up", "up = [0.0, 1.0, 0.0]")?.vector();
    let orientation = match ways.into_iter().next() {
        Some(("at", at)) => Orientation::At { at: at.vector()?, up: up()? },
        Some(("view", view)) => Orientation::View { view: view.vector()?, up: up()? },
        Some((_, basis)) => {
            if let Some(up) = section.get("up") {
                let basis = section.path_of("basis");
                let why = format!("together with {basis}: a basis needs no up, leave it out");
                return Err(up.refuse(&why));
            }
            Orientation::Basis(read_basis(&basis.section()?)?)
        }
        None => {
            let what = format!("{} (or view, or basis)", section.path_of("at"));
            return Err(section.missing(&what, "at = [0.0, 0.0, -1.0]"));
        }
    };
    Ok(Camera { eye, orientation, ..Camera::CANONICAL })
}

fn read_basis(section: &Section) -> Result<Basis, FileError> {
    section.only(&["u", "v", "w"], BEFORE_TABLES)?;
    Ok(Basis {
        u: section.need("u", "u = [1.0, 0.0, 0.0]")?.vector()?,
        v: section.need("v", "v = [0.0, 1.0, 0.0]")?.vector()?,
        w: section.need("w", "w = [0.0, 0.0, 1.0]")?.vector()?,
    })
}

fn viewport(section: &Section) -> Result<Viewport, FileError> {
    section.only(&["width", "height", "distance"], BEFORE_TABLES)?;
    let measure = |key: &str, default: f64| section.get(key).map_or(Ok(default), |f| f.positive());
    let Viewport { width, height, distance } = Viewport::CANONICAL;
    Ok(Viewport {
        width: measure("width", width)?,
        height: measure("height", height)?,
        distance: measure("distance", distance)?,
    })
}

fn image(section: &Section) -> Result<ImageSize, FileError> {
    section.only(&["width", "height"], BEFORE_TABLES)?;
    let default = Camera::CANONICAL.image;
    let right = format!("it must be a whole number of pixels, 1 to {}", ImageSize::MAX);
    let measure = |key: &str, default: u32| match section.get(key) {
        None => Ok(default),
        Some(field) => field
            .integer()
            .and_then(|pixels| u32::try_from(pixels).ok())
            .filter(|pixels| (1..=ImageSize::MAX).contains(pixels))
            .ok_or_else(|| field.error(&right)),
    };
    let (width, height) =
        (measure("width", default.width())?, measure("height", default.height())?);
    ImageSize::new(width, height).map_err(|_| section.missing("a size", &right))
}

/// Limits of an observer's distance from its target.
const DISTANCES: RangeInclusive<f64> = 1e-9..=1e12;

/// Reads the observer of the world view.
///
/// # Errors
/// Returns an error if a field is missing, unknown or out of range.
pub fn observer(field: &TomlField) -> Result<StoredObserver, FileError> {
    let section = field.section()?;
    section.only(&["target", "azimuth", "elevation", "distance"], BEFORE_TABLES)?;
    let number = |key: &str, such_as: &str| section.need(key, such_as)?.number();
    let observer = StoredObserver {
        target: section.need("target", "target = [0.0, 0.0, -3.0]")?.vector()?,
        azimuth: number("azimuth", "azimuth = 40.0 (degrees, from +z towards +x)")?,
        elevation: number("elevation", "elevation = 20.0 (degrees above the target)")?,
        distance: number("distance", "distance = 12.0")?,
    };
    let refuse = |key: &str, right: &str| section.get(key).map_or(Ok(()), |f| Err(f.error(right)));
    if observer.target.abs().max_element() > *DISTANCES.end() {
        refuse("target", "it must be at most 1e12 away")?;
    }
    if observer.elevation.abs() > 90.0 {
        refuse("elevation", "it must be -90 to 90 degrees")?;
    }
    if !DISTANCES.contains(&observer.distance) {
        refuse("distance", "it must be 1e-9 to 1e12")?;
    }
    Ok(observer)
}

fn objects<S>(
    field: &TomlField,
    read: impl Fn(&Section) -> Result<S, FileError>,
) -> Result<Vec<Item<S>>, FileError> {
    let item = |section: &Section| {
        let shape = read(section)?;
        let name = section.get("name").map(|name| name.text()).transpose()?;
        let color = section.get("color").map(|color| read_color(&color)).transpose()?;
        Ok(Item { name: name.map(str::to_owned), color, shape })
    };
    field.sections()?.iter().map(item).collect()
}

fn sphere(section: &Section) -> Result<Sphere, FileError> {
    section.only(&["name", "center", "radius", "color"], BEFORE_TABLES)?;
    Ok(Sphere {
        center: section.need("center", "center = [0.0, 0.0, -5.0]")?.vector()?,
        radius: section.need("radius", "radius = 1.0")?.positive()?,
    })
}

fn plane(section: &Section) -> Result<Plane, FileError> {
    section.only(&["name", "point", "normal", "color"], BEFORE_TABLES)?;
    let point = section.need("point", "point = [0.0, 0.0, -6.0]")?.vector()?;
    let field = section.need("normal", "normal = [0.0, 0.0, 1.0]")?;
    let normal = field.vector()?;
    if normal == DVec3::ZERO && !field.is_draft() {
        return Err(field.error("it must point somewhere"));
    }
    Ok(Plane { point, normal })
}

fn read_color(field: &TomlField) -> Result<Rgb, FileError> {
    const RIGHT: &str = "it must be a colour such as \"#e69f00\"";
    let text = field.text().map_err(|_| field.error(RIGHT))?;
    images::parse_color(text).ok_or_else(|| field.error(RIGHT))
}

fn csv_spheres(field: &TomlField, base: Option<&Path>) -> Result<CsvSpheres, FileError> {
    let path = field.text().map_err(|_| field.error("it must be the path of a CSV file"))?;
    let file = base.unwrap_or(Path::new("")).join(path);
    let stamp = host().stamp(&file);
    let items = match base {
        None => SphereTable::default(),
        Some(_) => table(&file).map_err(|error| match error.location {
            Some(_) => error,
            // The path is wrong, so the error points to the scene file's field with the path.
            None => {
                field.error(&format!("the table of the scene's spheres must be there, but {error}"))
            }
        })?,
    };
    let (path, count) = (path.to_owned(), items.spheres.len());
    Ok(CsvSpheres { path, file, stamp, count, items: Arc::new(items) })
}

fn table(file: &Path) -> Result<SphereTable, FileError> {
    csv::spheres(file, limits::open(file, limits::TABLE)?)
}

/// Returns a document with the spheres of its CSV file, which were away. If the document `at_hand` has them, they
/// are shared with it; otherwise the file is read again.
///
/// # Errors
/// Returns an error if the file cannot be read, or if it has another number of spheres than before, for which the
/// rest of the document may not be meant.
pub fn with_table(document: &Document, at_hand: &Document) -> Result<Document, FileError> {
    let mut document = document.clone();
    let Some(csv) = &mut document.csv_spheres else { return Ok(document) };
    csv.items = match &at_hand.csv_spheres {
        Some(at_hand) if at_hand == csv => Arc::clone(&at_hand.items),
        _ => Arc::new(table(&csv.file)?),
    };
    if csv.items.spheres.len() != csv.count {
        let problem =
            "has another number of spheres than when the lesson was opened: open it again";
        return Err(FileError::of_file(&csv.file, problem));
    }
    Ok(document)
}
