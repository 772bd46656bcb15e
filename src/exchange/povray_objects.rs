//! A POV-Ray scene's blocks, and of them the spheres and planes that stand by themselves.

use pinhole_core::{Camera, DVec3, Plane, Sphere};

use super::affine::Affine;
use super::back::{readable, settled};
use super::code::{Code, Piece, after_spaces, number, trimmed, words};
use super::povray_read::vector;
use super::sheet::byte_of_light;
use crate::document::Item;
use crate::formats::FileError;

/// Other objects.
const OTHERS: [&str; 27] = [
    "box",
    "cylinder",
    "cone",
    "torus",
    "mesh",
    "mesh2",
    "blob",
    "disc",
    "triangle",
    "smooth_triangle",
    "polygon",
    "prism",
    "lathe",
    "sor",
    "text",
    "height_field",
    "superellipsoid",
    "sphere_sweep",
    "isosurface",
    "parametric",
    "julia_fractal",
    "bicubic_patch",
    "quadric",
    "quartic",
    "cubic",
    "poly",
    "object",
];

/// Objects made of others, which are parts of them and not there by themselves.
const MADE_OF_OTHERS: [&str; 4] = ["union", "difference", "intersection", "merge"];

/// The names of `colors.inc` that are read, as light.
const COLORS: [(&str, [f64; 3]); 9] = [
    ("Red", [1.0, 0.0, 0.0]),
    ("Green", [0.0, 1.0, 0.0]),
    ("Blue", [0.0, 0.0, 1.0]),
    ("White", [1.0, 1.0, 1.0]),
    ("Black", [0.0, 0.0, 0.0]),
    ("Yellow", [1.0, 1.0, 0.0]),
    ("Cyan", [0.0, 1.0, 1.0]),
    ("Magenta", [1.0, 0.0, 1.0]),
    ("Gray", [0.752941, 0.752941, 0.752941]),
];

/// What stands in a scene under no other block, each block as what is in its braces.
#[derive(Default)]
pub(super) struct Blocks<'t> {
    /// Cameras; those that are declared or under a condition come first.
    pub(super) cameras: Vec<Piece<'t>>,
    spheres: Vec<Piece<'t>>,
    planes: Vec<Piece<'t>>,
    others: Vec<&'t str>,
    declared: bool,
    conditional: bool,
}

impl<'t> Blocks<'t> {
    /// One pass over the text; it ends at the first block that is not closed.
    pub(super) fn of(code: &'t Code) -> Blocks<'t> {
        let (mut blocks, mut aside) = (Blocks::default(), Vec::new());
        let (mut rest, mut conditions) = (code.whole(), 0_usize);
        while let Some(c) = rest.text.chars().next() {
            let after = rest.from(c.len_utf8());
            rest = match c {
                '"' => {
                    after.from(after.text.find(['"', '\n']).map_or(after.text.len(), |at| at + 1))
                }
                '#' => {
                    let word = word_of(after_spaces(after));
                    match word.text {
                        "if" | "ifdef" | "ifndef" | "while" | "for" | "switch" | "macro" => {
                            conditions += 1;
                        }
                        "end" => conditions = conditions.saturating_sub(1),
                        _ => (),
                    }
                    code.whole().from(word.at + word.text.len())
                }
                '{' => match code.bracketed(rest) {
                    Some(inside) => after.from(inside.text.len() + 1),
                    None => break,
                },
                c if is_letter(c) => {
                    let word = word_of(rest);
                    let open = after_spaces(rest.from(word.text.len()));
                    if !open.text.starts_with('{') {
                        open
                    } else {
                        let Some(inside) = code.bracketed(open) else { break };
                        let before = code.whole().text[..word.at].trim_end();
                        let is_declared = before.ends_with('=');
                        match (word.text, is_declared, conditions > 0) {
                            ("camera", false, false) => blocks.cameras.push(inside),
                            ("camera", ..) => aside.push(inside),
                            (_, true, _) => blocks.declared |= is_object(word.text),
                            (_, _, true) => blocks.conditional |= is_object(word.text),
                            ("sphere", ..) => blocks.spheres.push(inside),
                            ("plane", ..) => blocks.planes.push(inside),
                            (other, ..) if is_object(other) => blocks.others.push(other),
                            _ => (),
                        }
                        open.from(inside.text.len() + 2)
                    }
                }
                _ => after,
            };
        }
        blocks.cameras.splice(0..0, aside);
        blocks
    }

    /// What is left out because of where or what it is.
    pub(super) fn left_out(&self, notes: &mut Vec<String>) {
        for kind in OTHERS.iter().chain(&MADE_OF_OTHERS) {
            let count = self.others.iter().filter(|other| other == &kind).count();
            let why = match MADE_OF_OTHERS.contains(kind) || *kind == "blob" {
                true => "with its parts: Pinhole has whole spheres and planes",
                false => "Pinhole has spheres and planes",
            };
            let between = if why.starts_with("with") { " " } else { ": " };
            if count > 0 {
                notes.push(format!("{count} of {kind} left out{between}{why}"));
            }
        }
        if self.declared {
            notes
                .push("what #declare names is left out: an object must stand by itself".to_owned());
        }
        if self.conditional {
            let note =
                "what stands between #if, #while, #for, #switch or #macro and #end is left out";
            notes.push(note.to_owned());
        }
    }

    pub(super) fn spheres(&self, code: &Code, notes: &mut Vec<String>) -> Vec<Item<Sphere>> {
        let spheres = self.spheres.iter().map(|block| sphere(code, *block));
        let spheres = readable(spheres, "sphere", notes);
        if spheres.iter().any(Option::is_none) {
            notes.push("a sphere that is scaled to an ellipsoid is left out".to_owned());
        }
        spheres.into_iter().flatten().collect()
    }

    pub(super) fn planes(&self, code: &Code, notes: &mut Vec<String>) -> Vec<Item<Plane>> {
        readable(self.planes.iter().map(|block| plane(code, *block)), "plane", notes)
    }

    /// What is said of colours that are there and could not be read.
    pub(super) fn colors(&self, code: &Code, notes: &mut Vec<String>) {
        let is_unread = |block: &&Piece| {
            let has = |word: &str| !words(**block, word).is_empty();
            (has("pigment") || has("texture")) && color(code, **block).is_none()
        };
        let count = self.spheres.iter().chain(&self.planes).filter(is_unread).count();
        if count > 0 {
            notes.push(format!(
                "{count} of pigment or texture left out: a colour must be rgb <1, 0.5, 0> or a name such as Red"
            ));
        }
    }
}

fn is_object(word: &str) -> bool {
    ["sphere", "plane"].contains(&word) || OTHERS.contains(&word) || MADE_OF_OTHERS.contains(&word)
}

fn is_letter(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The word with which a piece begins.
fn word_of(piece: Piece) -> Piece {
    let end = piece.text.find(|c| !is_letter(c)).unwrap_or(piece.text.len());
    Piece { text: &piece.text[..end], ..piece }
}

/// `None` of an ellipsoid.
fn sphere(code: &Code, block: Piece) -> Result<Option<Item<Sphere>>, FileError> {
    let (center, rest) = beginning(code, "sphere", block)?;
    let center = plain_vector(code, "sphere centre", center)?;
    let (value, modifiers) = value_of(rest);
    let radius = number(value.text).filter(|radius| *radius > 0.0);
    let right = "it must have a radius greater than 0, as sphere { <0, 0, 0>, 1 }";
    let radius = radius.ok_or_else(|| code.fault("sphere", block, right))?;
    let placed = placed(code, modifiers)?;
    let Some(scale) = placed.scale() else { return Ok(None) };
    let (center, radius) = match placed == Affine::IDENTITY {
        true => (center, radius),
        false => (plain(placed.point(center)), settled(radius * scale, 4.0 * f64::EPSILON * scale)),
    };
    Ok(Some(Item { name: None, color: color(code, block), shape: Sphere { center, radius } }))
}

fn plane(code: &Code, block: Piece) -> Result<Item<Plane>, FileError> {
    let (normal, rest) = beginning(code, "plane", block)?;
    let normal = plain_vector(code, "plane's normal", normal)?;
    let (value, modifiers) = value_of(rest);
    let right = "it must have a normal and a distance, as plane { <0, 1, 0>, -1 }";
    let distance = number(value.text).filter(|_| normal != DVec3::ZERO);
    let distance = distance.ok_or_else(|| code.fault("plane", block, right))?;
    let mut shape = Plane { point: normal.normalize() * distance + DVec3::ZERO, normal };
    let placed = placed(code, modifiers)?;
    if placed != Affine::IDENTITY {
        // A normal goes by the inverse transposed: here times the determinant.
        let Affine { x, y, z, .. } = placed;
        let turned = normal.x * y.cross(z) + normal.y * z.cross(x) + normal.z * x.cross(y);
        let turned = turned * x.dot(y.cross(z)).signum();
        let right = "it must not be scaled to nothing";
        let turned = turned.try_normalize().ok_or_else(|| code.fault("plane", block, right))?;
        shape = Plane { point: plain(placed.point(shape.point)), normal: plain(turned) };
    }
    Ok(Item { name: None, color: color(code, block), shape })
}

/// The vector with which an object begins, and what follows it and its comma.
fn beginning<'t>(
    code: &Code,
    name: &str,
    block: Piece<'t>,
) -> Result<(Piece<'t>, Piece<'t>), FileError> {
    if let Some(piece) = words(block, "clipped_by").first() {
        let piece = Piece { text: "clipped_by", at: block.at + piece };
        return Err(code.fault(name, piece, "Pinhole has whole spheres and planes"));
    }
    let block = trimmed(block);
    let end = match code.bracketed(block) {
        Some(inside) => Some(inside.text.len() + 2),
        None => block.text.find(','),
    };
    let end =
        end.ok_or_else(|| code.fault(name, block, "it must begin with a vector and a number"))?;
    let rest = after_spaces(block.from(end));
    let rest = if rest.text.starts_with(',') { rest.from(1) } else { rest };
    Ok((Piece { text: &block.text[..end], ..block }, rest))
}

/// The value with which a piece begins, up to the first word that is none of an expression, and what
/// follows.
fn value_of(piece: Piece) -> (Piece, Piece) {
    const OF_VALUES: [&str; 8] = ["x", "y", "z", "pi", "sqrt", "sin", "cos", "tan"];
    let mut at = 0;
    while let Some(c) = piece.text[at..].chars().next() {
        if c.is_ascii_digit() {
            // With the exponent, as in 1e3.
            at += word_of(piece.from(at)).text.len();
        } else if is_letter(c) {
            let word = word_of(piece.from(at)).text;
            if !OF_VALUES.contains(&word) {
                break;
            }
            at += word.len();
        } else if matches!(c, '{' | '}') {
            break;
        } else {
            at += c.len_utf8();
        }
    }
    (trimmed(Piece { text: &piece.text[..at], ..piece }), piece.from(at))
}

fn plain_vector(code: &Code, field: &str, piece: Piece) -> Result<DVec3, FileError> {
    vector(code, field, piece, Camera::CANONICAL.image)
}

/// Where what follows an object's numbers puts it, one step after the other.
fn placed(code: &Code, modifiers: Piece) -> Result<Affine, FileError> {
    steps(code, modifiers, 0)
}

/// What stands in so many `transform { ... }`.
fn steps(code: &Code, modifiers: Piece, depth: usize) -> Result<Affine, FileError> {
    const DEEPEST: usize = 8;
    const RIGHT: &str = "it must be twelve numbers for matrix, and translate, scale, rotate or matrix \
                         in transform";
    let mut placed = Affine::IDENTITY;
    let mut rest = modifiers;
    while let Some(c) = rest.text.chars().next() {
        if !is_letter(c) {
            // What is in the braces of a texture moves the texture.
            let inside = code.bracketed(rest).filter(|_| c == '{');
            rest = rest.from(inside.map_or(c.len_utf8(), |inside| inside.text.len() + 2));
            continue;
        }
        let word = word_of(rest);
        let open = after_spaces(rest.from(word.text.len()));
        let (value, after) = match code.bracketed(open).filter(|_| open.text.starts_with('{')) {
            Some(inside) if word.text == "transform" => (inside, open.from(inside.text.len() + 2)),
            _ => value_of(open),
        };
        let step = match word.text {
            "translate" => Some(Affine::translation(plain_vector(code, "translate", value)?)),
            "scale" => Some(Affine::scaling(plain_vector(code, "scale", value)?)),
            "rotate" => Some(rotation(plain_vector(code, "rotate", value)?)),
            "matrix" => matrix(&code.numbers("matrix", value)?),
            "transform" if !value.text.is_empty() && depth < DEEPEST => {
                Some(steps(code, value, depth + 1)?)
            }
            // The name of one that is declared.
            "transform" if value.text.is_empty() => {
                return Err(code.fault("transform", word_of(open), RIGHT));
            }
            "transform" => None,
            _ if depth > 0 => return Err(code.fault("transform", word, RIGHT)),
            _ => {
                rest = open;
                continue;
            }
        };
        placed = step.ok_or_else(|| code.fault(word.text, value, RIGHT))?.of(&placed);
        rest = after;
    }
    Ok(placed)
}

/// About x, then y, then z.
fn rotation(degrees: DVec3) -> Affine {
    [(degrees.x, DVec3::X), (degrees.y, DVec3::Y), (degrees.z, DVec3::Z)]
        .into_iter()
        .filter_map(|(degrees, axis)| Affine::rotation(degrees, axis))
        .fold(Affine::IDENTITY, |before, turn| turn.of(&before))
}

/// Where x, y, z and the origin come to lie.
fn matrix(m: &[f64]) -> Option<Affine> {
    let row = |k: usize| DVec3::new(m[k], m[k + 1], m[k + 2]);
    (m.len() == 12).then(|| Affine { x: row(0), y: row(3), z: row(6), at: row(9) })
}

/// Without the digits that the sines and cosines of right angles leave.
fn plain(v: DVec3) -> DVec3 {
    let roundings = 4.0 * f64::EPSILON * v.length();
    DVec3::from_array(v.to_array().map(|x| settled(x, roundings)))
}

fn color(code: &Code, block: Piece) -> Option<[u8; 3]> {
    if let Some(at) = ["rgb", "rgbf", "rgbt", "rgbft"]
        .iter()
        .find_map(|word| words(block, word).first().map(|at| at + word.len()))
    {
        let (value, _) = value_of(after_spaces(block.from(at)));
        let value = Piece { text: value.text.trim_end_matches([',', ' ', '\n']), ..value };
        let numbers = code.numbers("color", value).ok()?;
        let light = match numbers[..] {
            [grey] => [grey; 3],
            [r, g, b, ..] => [r, g, b],
            _ => return None,
        };
        return Some(light.map(byte_of_light));
    }
    let named =
        COLORS.iter().filter_map(|(name, light)| Some((*words(block, name).first()?, light)));
    let (_, light) = named.min_by_key(|(at, _)| *at)?;
    Some(light.map(byte_of_light))
}
