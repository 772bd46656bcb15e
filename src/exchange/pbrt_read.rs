//! Reading a pbrt scene: transforms, camera, film, spheres.

use std::collections::HashMap;

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Sphere, Viewport};

use super::affine::Affine;
use super::back::{MIRRORED, Mirrored, Stance, extent, image_of, in_ratio};
use super::code::error_at;
use super::sheet::{byte_of_light, n};
use super::{Taken, Text};
use crate::document::Item;
use crate::formats::FileError;

/// A word, a string without its quotes, a number, or a bracket.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Token<'t> {
    Word(&'t str),
    Quoted(&'t str),
    Number(f64),
    Open,
    Close,
}

/// The values of a directive's parameters, by name without the type.
type Parameters<'t> = HashMap<&'t str, Vec<Token<'t>>>;

struct Reader<'t> {
    text: &'t Text<'t>,
    tokens: Vec<(Token<'t>, usize)>,
    next: usize,
}

/// The current transformation: from the world, or an object, to what is around.
#[derive(Clone, Copy)]
struct State {
    transform: Affine,
    color: Option<[u8; 3]>,
}

/// What is known of the camera so far.
#[derive(Default)]
struct Found {
    /// `LookAt`'s three, where nothing but a mirror stands beside it.
    look_at: Option<[DVec3; 3]>,
    camera_from_world: Option<Affine>,
    camera: HashMap<String, f64>,
    screen: Option<Vec<f64>>,
    film: Option<(f64, f64)>,
    at: usize,
    spheres: Vec<Item<Sphere>>,
    notes: Vec<String>,
    /// Spheres that could not be read.
    unread: usize,
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let mut reader = Reader { text, tokens: tokens(text)?, next: 0 };
    let mut found = Found::default();
    let mut state = State { transform: Affine::IDENTITY, color: None };
    let mut saved = Vec::new();
    while let Some((token, at)) = reader.take() {
        let Token::Word(word) = token else {
            return Err(reader.error(at, "a value stands where a directive must be".to_owned()));
        };
        reader.directive(word, at, &mut state, &mut saved, &mut found)?;
    }
    found.camera(text, at_hand)
}

impl<'t> Reader<'t> {
    fn error(&self, at: usize, problem: String) -> FileError {
        error_at(self.text.path, self.text.text, at, problem)
    }

    fn take(&mut self) -> Option<(Token<'t>, usize)> {
        let token = self.tokens.get(self.next).copied();
        self.next += usize::from(token.is_some());
        token
    }

    fn numbers<const N: usize>(&mut self, word: &str, at: usize) -> Result<[f64; N], FileError> {
        let mut numbers = Vec::new();
        while let Some((Token::Number(_) | Token::Open | Token::Close, _)) =
            self.tokens.get(self.next)
        {
            if let Some((Token::Number(number), _)) = self.take() {
                numbers.push(number);
            }
        }
        let count = numbers.len();
        numbers
            .try_into()
            .map_err(|_| self.error(at, format!("{word} has {count} numbers: it must have {N}")))
    }

    fn vector(&mut self, word: &str, at: usize) -> Result<DVec3, FileError> {
        Ok(DVec3::from_array(self.numbers(word, at)?))
    }

    /// The strings and parameters after a directive.
    fn parameters(&mut self) -> (Option<&'t str>, Parameters<'t>) {
        let mut parameters = Parameters::new();
        let kind = match self.tokens.get(self.next) {
            Some((Token::Quoted(kind), _)) if !kind.contains(' ') => {
                self.next += 1;
                Some(*kind)
            }
            _ => None,
        };
        let mut name = "";
        let mut in_list = false;
        while let Some((token, _)) = self.tokens.get(self.next).copied() {
            match token {
                Token::Quoted(quoted) if !in_list && quoted.contains(' ') => {
                    name = quoted.split_whitespace().last().unwrap_or_default();
                    parameters.insert(name, Vec::new());
                }
                Token::Word("true" | "false") => (),
                Token::Word(_) => break,
                Token::Open => in_list = true,
                Token::Close => in_list = false,
                value => parameters.entry(name).or_default().push(value),
            }
            self.next += 1;
        }
        (kind, parameters)
    }

    fn directive(
        &mut self,
        word: &str,
        at: usize,
        state: &mut State,
        saved: &mut Vec<State>,
        found: &mut Found,
    ) -> Result<(), FileError> {
        if let Some(map) = self.map(word, at, state, found)? {
            if word != "LookAt" && found.camera_from_world.is_none() {
                found.look_at = None;
            }
            state.transform = state.transform.of(&map);
            return Ok(());
        }
        if !word.chars().all(char::is_alphanumeric) {
            return Err(self.error(at, format!("{word}: no directive of pbrt")));
        }
        let (kind, parameters) = self.parameters();
        match word {
            "Identity" => state.transform = Affine::IDENTITY,
            "AttributeBegin" | "TransformBegin" | "ObjectBegin" => saved.push(*state),
            "AttributeEnd" | "TransformEnd" | "ObjectEnd" => {
                let nothing = || self.error(at, format!("{word}: nothing was begun"));
                *state = saved.pop().ok_or_else(nothing)?;
            }
            "WorldBegin" => *state = State { transform: Affine::IDENTITY, color: None },
            "Camera" => {
                if kind != Some("perspective") {
                    let kind = kind.unwrap_or_default();
                    return Err(self.error(at, format!("Camera is {kind}: it must be perspective")));
                }
                found.at = at;
                found.camera_from_world = Some(state.transform);
                let first = |values: &[Token]| numbers_of(values).first().copied();
                let numbers = parameters.iter();
                let numbers = numbers.filter_map(|(k, v)| Some(((*k).to_owned(), first(v)?)));
                found.camera = numbers.collect();
                found.screen = parameters.get("screenwindow").map(|values| numbers_of(values));
            }
            "Film" => {
                let size = |name: &str, or: f64| {
                    let given = parameters.get(name).and_then(|v| numbers_of(v).first().copied());
                    given.unwrap_or(or)
                };
                found.film = Some((size("xresolution", 1280.0), size("yresolution", 720.0)));
            }
            "Material" => state.color = reflectance(&parameters),
            "Shape" => found.shape(self, at, kind, &parameters, state),
            _ => {}
        }
        Ok(())
    }

    /// What a directive does to the current transformation; `None` of one that does nothing.
    fn map(
        &mut self,
        word: &str,
        at: usize,
        state: &mut State,
        found: &mut Found,
    ) -> Result<Option<Affine>, FileError> {
        let (map, right) = match word {
            "LookAt" => {
                let [a, b, c, d, e, f, g, h, i] = self.numbers(word, at)?;
                let look = [DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i)];
                let mirror = Affine::scaling(DVec3::new(-1.0, 1.0, 1.0));
                let alone = [Affine::IDENTITY, mirror].contains(&state.transform);
                if found.camera_from_world.is_none() {
                    found.look_at = alone.then_some(look);
                }
                (look_at(look), "eye, at and up make no camera")
            }
            "Scale" => (Some(Affine::scaling(self.vector(word, at)?)), ""),
            "Translate" => (Some(Affine::translation(self.vector(word, at)?)), ""),
            "Rotate" => {
                let [angle, x, y, z] = self.numbers(word, at)?;
                (Affine::rotation(angle, DVec3::new(x, y, z)), "its axis is (0, 0, 0)")
            }
            "Transform" | "ConcatTransform" => {
                let m: [f64; 16] = self.numbers(word, at)?;
                if word == "Transform" {
                    state.transform = Affine::IDENTITY;
                }
                (Affine::of_columns(&m), "the matrix must be affine")
            }
            _ => return Ok(None),
        };
        map.map(Some).ok_or_else(|| self.error(at, format!("{word}: {right}")))
    }
}

fn reflectance(parameters: &Parameters) -> Option<[u8; 3]> {
    let [r, g, b] = numbers_of(parameters.get("reflectance")?).try_into().ok()?;
    Some([r, g, b].map(byte_of_light))
}

fn numbers_of(values: &[Token]) -> Vec<f64> {
    let number = |token: &Token| match token {
        Token::Number(number) => Some(*number),
        _ => None,
    };
    values.iter().filter_map(number).collect()
}

/// From the world to the camera.
fn look_at([eye, at, up]: [DVec3; 3]) -> Option<Affine> {
    let z = (at - eye).try_normalize()?;
    let x = up.cross(z).try_normalize()?;
    Affine { x, y: z.cross(x), z, at: eye }.inverse()
}

impl Found {
    /// Takes a sphere, and tells of any other shape.
    fn shape(
        &mut self,
        reader: &Reader,
        at: usize,
        kind: Option<&str>,
        parameters: &Parameters,
        state: &State,
    ) {
        let scale = state.transform.scale().filter(|_| kind == Some("sphere"));
        let Some(scale) = scale else {
            let kind = kind.unwrap_or("a shape");
            self.notes.push(match kind {
                "sphere" => "a sphere that is scaled to an ellipsoid is left out".to_owned(),
                _ => format!("{kind} is left out: Pinhole has spheres and planes"),
            });
            return;
        };
        let radius = parameters.get("radius").and_then(|r| numbers_of(r).first().copied());
        let radius = radius.unwrap_or(1.0) * scale;
        if radius <= 0.0 {
            self.unread += 1;
            if self.unread > 1 {
                return;
            }
            let place = reader.error(at, String::new()).place;
            let line = place.map(|place| format!("line {}: ", place.line)).unwrap_or_default();
            let why = format!("radius is {}: it must be greater than 0", n(radius));
            self.notes.push(format!("a sphere is left out: {line}{why}"));
            return;
        }
        let shape = Sphere { center: state.transform.at, radius };
        self.spheres.push(Item { name: None, color: state.color, shape });
    }

    fn viewport(&self, image: ImageSize, at_hand: &Camera) -> Result<Viewport, String> {
        let given = |name: &str| self.camera.get(name).copied();
        // pbrt's own is 1e6 where none is given.
        let distance = given("focaldistance").filter(|d| *d > 0.0 && *d < 1e6);
        let distance = distance.unwrap_or(at_hand.viewport.distance);
        let fov = given("fov").unwrap_or(90.0);
        if !(fov > 0.0 && fov < 180.0) {
            return Err(format!("fov is {}: it must be between 0 and 180 degrees", n(fov)));
        }
        let frame = given("frameaspectratio").unwrap_or(image.aspect());
        let short = extent(fov, distance);
        let (mut wide, mut high) = if frame > 1.0 { (frame, 1.0) } else { (1.0, 1.0 / frame) };
        if let Some([left, right, bottom, top]) = self.screen.as_deref() {
            (wide, high) = (0.5 * (right - left), 0.5 * (top - bottom));
            if left + right != 0.0 || bottom + top != 0.0 || wide <= 0.0 || high <= 0.0 {
                return Err("screenwindow: it must have 0 in its middle".to_owned());
            }
        }
        Ok(Viewport { width: in_ratio(short, wide), height: in_ratio(short, high), distance })
    }

    fn camera(mut self, text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
        let at = self.at;
        let error = |problem: String| error_at(text.path, text.text, at, problem);
        let Some(transform) = self.camera_from_world else {
            let missing = "Camera is missing: Camera \"perspective\" must be there";
            return Err(FileError::of_file(text.path, missing));
        };
        let (width, height) = self.film.unwrap_or((1280.0, 720.0));
        let image = image_of(width, height)
            .map_err(|right| error(format!("xresolution, yresolution: {right}")))?;
        let viewport = self.viewport(image, at_hand).map_err(&error)?;
        if self.camera.get("lensradius").is_some_and(|radius| *radius > 0.0) {
            self.notes.push("lensradius is left out: a pinhole is sharp everywhere".to_owned());
        }
        let world_from_camera = transform
            .inverse()
            .ok_or_else(|| error("the camera's transformation has no inverse".to_owned()))?;
        let stance = Stance {
            eye: world_from_camera.at,
            right: world_from_camera.x,
            up: world_from_camera.y,
            backwards: -world_from_camera.z,
        };
        let Stance { right, up, backwards, .. } = stance;
        let mirrored = pinhole_core::Basis::is_left_handed(right, up, backwards);
        let turn = |v: DVec3| if mirrored { v.mirrored() } else { v };
        let (eye, orientation) = match self.look_at {
            Some([eye, at, up]) => (turn(eye), Orientation::At { at: turn(at), up: turn(up) }),
            None => {
                let stance = if mirrored { stance.mirrored() } else { stance };
                let orientation = stance
                    .orientation(&mut self.notes)
                    .map_err(|right| error_at(text.path, text.text, self.at, right))?;
                (stance.eye, orientation)
            }
        };
        if mirrored {
            self.notes.push(MIRRORED.to_owned());
            self.spheres = self.spheres.mirrored();
        }
        if self.unread > 1 {
            self.notes.push(format!("{} of sphere left out in all", self.unread));
        }
        self.notes.dedup();
        let camera = Camera { eye, orientation, viewport, image };
        Ok(Taken { spheres: self.spheres, ..Taken::camera(camera, self.notes) })
    }
}

fn tokens<'t>(text: &Text<'t>) -> Result<Vec<(Token<'t>, usize)>, FileError> {
    let mut tokens = Vec::new();
    let source = text.text;
    let mut at = 0;
    while let Some(c) = source[at..].chars().next() {
        let rest = &source[at..];
        let length = match c {
            '#' => rest.find('\n').unwrap_or(rest.len()),
            '[' | ']' => {
                tokens.push((if c == '[' { Token::Open } else { Token::Close }, at));
                1
            }
            '"' => {
                let end = rest[1..].find('"').ok_or_else(|| {
                    error_at(text.path, source, at, "a string is not closed: its \" is missing")
                })?;
                tokens.push((Token::Quoted(rest[1..=end].trim()), at));
                end + 2
            }
            c if c.is_whitespace() => c.len_utf8(),
            _ => {
                let end = rest.find(|c: char| c.is_whitespace() || "[]\"#".contains(c));
                let word = &rest[..end.unwrap_or(rest.len())];
                let number = word.parse::<f64>().ok().filter(|x| x.is_finite());
                tokens.push((number.map_or(Token::Word(word), Token::Number), at));
                word.len()
            }
        };
        at += length;
    }
    Ok(tokens)
}
