//! Reading a pbrt scene: transforms, camera, film, spheres.

use std::collections::HashMap;

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Orientation, Viewport};

use super::shapes::{Paint, Shapes};
use super::tokens::{Parameters, Reader, Token};
use crate::FileError;
use crate::error::one_line;
use crate::format::affine::Affine;
use crate::format::image_size::{image_of, size_note};
use crate::format::pose::{MIRRORED, Pose, mirrored};
use crate::format::text::n;
use crate::format::viewport::{extent, in_ratio};
use crate::format::{Imported, Input};

/// Directives with strings and parameters behind them, or nothing, in all versions of pbrt.
const WITH_PARAMETERS: [&str; 27] = [
    "Accelerator",
    "AreaLightSource",
    "Attribute",
    "Camera",
    "ColorSpace",
    "Exterior",
    "Film",
    "Integrator",
    "Interior",
    "LightSource",
    "MakeNamedMaterial",
    "MakeNamedMedium",
    "Material",
    "MediumInterface",
    "NamedMaterial",
    "Option",
    "PixelFilter",
    "Renderer",
    "ReverseOrientation",
    "Sampler",
    "SearchPath",
    "Shape",
    "SurfaceIntegrator",
    "Texture",
    "Volume",
    "VolumeIntegrator",
    "WorldEnd",
];

/// Attributes in force.
#[derive(Clone, Copy)]
struct State {
    /// Map from the world to the camera, or from an object to the world.
    transform: Affine,
    /// `LookAt`'s three, where nothing but a mirror stands beside it.
    look_at: Option<[DVec3; 3]>,
    paint: Paint,
}

impl State {
    const INITIAL: State =
        State { transform: Affine::IDENTITY, look_at: None, paint: Paint::Unsaid };

    fn take(&mut self, step: &Step) {
        let mirror = Affine::scaling(DVec3::new(-1.0, 1.0, 1.0));
        let alone = [Affine::IDENTITY, mirror].contains(&self.transform);
        self.look_at = step.look_at.filter(|_| alone);
        self.transform = match step.is_whole {
            true => step.map,
            false => self.transform.after(&step.map),
        };
    }
}

/// The scene as far as it is read.
#[derive(Default)]
struct Found<'t> {
    look_at: Option<[DVec3; 3]>,
    camera_from_world: Option<Affine>,
    camera: Option<Parameters<'t>>,
    film: Option<Parameters<'t>>,
    at: usize,
    /// The named coordinate systems.
    systems: HashMap<&'t str, Affine>,
    shapes: Shapes<'t>,
    /// `AttributeBegin` and the like that are not ended,
    /// and whether each is an `ObjectBegin`.
    saved: Vec<(State, bool)>,
    /// Number of open `ObjectBegin`s: what is in those stands nowhere by itself.
    objects: usize,
    notes: Vec<String>,
}

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let mut reader = Reader::new(text)?;
    let mut found = Found::default();
    let mut state = State::INITIAL;
    while let Some((token, at)) = reader.take() {
        let Token::Word(word) = token else {
            return Err(reader.error(at, "a value stands where a directive must be"));
        };
        found.directive(&mut reader, word, at, &mut state)?;
    }
    found.finish(text, at_hand)
}

/// A change of the current transformation by a directive.
struct Step {
    map: Affine,
    look_at: Option<[DVec3; 3]>,
    /// True where the map takes the current one's place.
    is_whole: bool,
}

/// Returns the map from the world to the camera.
fn look_at([eye, at, up]: [DVec3; 3]) -> Option<Affine> {
    let z = (at - eye).try_normalize()?;
    let x = up.cross(z).try_normalize()?;
    Affine { x, y: z.cross(x), z, at: eye }.inverse()
}

impl<'t> Found<'t> {
    /// Returns a directive's change of the current transformation; `None` of one that changes nothing.
    fn step(
        &self,
        reader: &mut Reader<'t>,
        word: &str,
        at: usize,
    ) -> Result<Option<Step>, FileError> {
        let mut look = None;
        let (map, right) = match word {
            "Identity" => (Some(Affine::IDENTITY), ""),
            "LookAt" => {
                let [a, b, c, d, e, f, g, h, i] = reader.numbers(word, at)?;
                let three = [DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i)];
                look = Some(three);
                (look_at(three), "eye, at and up make no camera")
            }
            "Scale" => (Some(Affine::scaling(reader.vector(word, at)?)), ""),
            "Translate" => (Some(Affine::translation(reader.vector(word, at)?)), ""),
            "Rotate" => {
                let [angle, x, y, z] = reader.numbers(word, at)?;
                (Affine::rotation(angle, DVec3::new(x, y, z)), "its axis is (0, 0, 0)")
            }
            "Transform" | "ConcatTransform" => {
                let m: [f64; 16] = reader.numbers(word, at)?;
                (Affine::from_columns(&m), "the matrix must be affine")
            }
            "CoordSysTransform" => {
                let name = reader.name(word, at)?;
                let right = "it must be camera, world, or named by CoordinateSystem before it";
                (self.systems.get(name).copied(), right)
            }
            _ => return Ok(None),
        };
        let map = map.ok_or_else(|| reader.error(at, format!("{word}: {right}")))?;
        let is_whole = ["Identity", "Transform", "CoordSysTransform"].contains(&word);
        Ok(Some(Step { map, look_at: look, is_whole }))
    }

    fn directive(
        &mut self,
        reader: &mut Reader<'t>,
        word: &str,
        at: usize,
        state: &mut State,
    ) -> Result<(), FileError> {
        if let Some(step) = self.step(reader, word, at)? {
            state.take(&step);
            return Ok(());
        }
        match word {
            "AttributeBegin" | "TransformBegin" => self.saved.push((*state, false)),
            "ObjectBegin" => {
                reader.name(word, at)?;
                let said = "left out with its parts: an object must stand by itself";
                self.shapes.left.add(word, said);
                self.saved.push((*state, true));
                self.objects += 1;
            }
            "AttributeEnd" | "TransformEnd" | "ObjectEnd" => {
                let nothing = || reader.error(at, format!("{word}: nothing was begun"));
                let (before, is_object) = self.saved.pop().ok_or_else(nothing)?;
                *state = before;
                self.objects -= usize::from(is_object);
            }
            "WorldBegin" => {
                *state = State::INITIAL;
                self.systems.insert("world", Affine::IDENTITY);
            }
            "ActiveTransform" => {
                let given = one_line(reader.name(word, at)?);
                if given != "All" {
                    let right = "it must be All: nothing must move while the shutter is open";
                    return Err(reader.error(at, format!("{word} is {given}: {right}")));
                }
            }
            // Nothing moves between these times.
            "TransformTimes" => {
                let _: [f64; 2] = reader.numbers(word, at)?;
            }
            "CoordinateSystem" => {
                self.systems.insert(reader.name(word, at)?, state.transform);
            }
            "ObjectInstance" | "Include" | "Import" => {
                reader.name(word, at)?;
                let said = match word {
                    "ObjectInstance" => "left out: an object must stand by itself",
                    _ => "left out: what is in other files is not read",
                };
                self.shapes.left.add(word, said);
            }
            _ if WITH_PARAMETERS.contains(&word) => {
                self.with_parameters(reader, word, at, state)?;
            }
            _ => return Err(reader.error(at, format!("{}: no directive of pbrt", one_line(word)))),
        }
        Ok(())
    }

    fn with_parameters(
        &mut self,
        reader: &mut Reader<'t>,
        word: &str,
        at: usize,
        state: &mut State,
    ) -> Result<(), FileError> {
        let parameters = reader.parameters(word != "Option")?;
        match word {
            "Camera" => {
                if parameters.kind != Some("perspective") {
                    let kind = one_line(parameters.kind.unwrap_or_default());
                    return Err(
                        reader.error(at, format!("Camera is {kind}: it must be perspective"))
                    );
                }
                self.at = at;
                self.look_at = state.look_at;
                self.camera_from_world = Some(state.transform);
                self.systems.extend(state.transform.inverse().map(|system| ("camera", system)));
                self.camera = Some(parameters);
            }
            "Film" => self.film = Some(parameters),
            "Material" => state.paint = Paint::from_parameters(&parameters),
            "MakeNamedMaterial" => self.shapes.name_material(&parameters),
            "NamedMaterial" => state.paint = self.shapes.material(parameters.kind),
            "Attribute" => {
                let sizes = ["radius", "zmin", "zmax", "phimax"];
                if sizes.iter().any(|name| parameters.has(name)) {
                    let right = "Attribute: a sphere's parameters must stand in its Shape";
                    return Err(reader.error(at, right));
                }
                if parameters.has("reflectance") {
                    self.shapes.left.add(word, "left out: a colour must stand in Material");
                }
            }
            "Shape" if self.objects == 0 => {
                self.shapes.take(at, &parameters, &state.transform, state.paint);
            }
            _ => (),
        }
        Ok(())
    }

    fn viewport(
        &self,
        camera: &Parameters,
        image: ImageSize,
        at_hand: &Camera,
    ) -> Result<Viewport, String> {
        // pbrt's own is 1e6 where none is given.
        let distance = camera.number("focaldistance").filter(|d| *d > 0.0 && *d < 1e6);
        let distance = distance.unwrap_or(at_hand.viewport.distance);
        let half = camera.number("halffov").filter(|half| *half > 0.0);
        let fov = half.map(|half| 2.0 * half).or(camera.number("fov")).unwrap_or(90.0);
        if !(fov > 0.0 && fov < 180.0) {
            return Err(format!("fov is {}: it must be between 0 and 180 degrees", n(fov)));
        }
        let frame = camera.number("frameaspectratio").unwrap_or(image.aspect());
        let short = extent(fov, distance);
        let (mut wide, mut high) = if frame > 1.0 { (frame, 1.0) } else { (1.0, 1.0 / frame) };
        if let [left, right, bottom, top] = camera.numbers("screenwindow")[..] {
            (wide, high) = (0.5 * (right - left), 0.5 * (top - bottom));
            if left + right != 0.0 || bottom + top != 0.0 || wide <= 0.0 || high <= 0.0 {
                return Err("screenwindow: it must have 0 in its middle".to_owned());
            }
        }
        Ok(Viewport { width: in_ratio(short, wide), height: in_ratio(short, high), distance })
    }

    /// The film's size; a part of it that is rendered alone is told in a note.
    fn image(&mut self) -> Result<ImageSize, String> {
        let film =
            |name: &str| self.film.as_ref().map(|film| film.numbers(name)).unwrap_or_default();
        let size = |name: &str, or: f64| film(name).first().copied().unwrap_or(or);
        let (width, height) = (size("xresolution", 1280.0), size("yresolution", 720.0));
        let image = image_of(width, height)
            .map_err(|right| format!("xresolution, yresolution: {right}"))?;
        let unsaid: Vec<&str> = ["xresolution", "yresolution"]
            .into_iter()
            .filter(|name| film(name).is_empty())
            .collect();
        if !unsaid.is_empty() {
            let unsaid = format!("Film does not give {}", unsaid.join(" and "));
            self.notes.push(size_note(&unsaid, image, ", as in pbrt, taken"));
        }
        for (name, whole) in
            [("cropwindow", [0.0, 1.0, 0.0, 1.0]), ("pixelbounds", [0.0, width, 0.0, height])]
        {
            let part = film(name);
            if !part.is_empty() && part != whole {
                let (w, h) = (image.width(), image.height());
                self.notes
                    .push(format!("{name} is left out: the whole image, {w} × {h}, is taken"));
            }
        }
        Ok(image)
    }

    fn finish(mut self, text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
        let at = self.at;
        let error = |problem: String| text.error_at(at, problem);
        let (Some(transform), Some(camera)) = (self.camera_from_world, self.camera.take()) else {
            let missing = "Camera is missing: Camera \"perspective\" must be there";
            return Err(FileError::of_file(text.path, missing));
        };
        let image = self.image().map_err(&error)?;
        let viewport = self.viewport(&camera, image, at_hand).map_err(&error)?;
        if camera.number("lensradius").is_some_and(|radius| radius > 0.0) {
            self.notes.push("lensradius is left out: a pinhole is sharp everywhere".to_owned());
        }
        let world_from_camera = transform
            .inverse()
            .ok_or_else(|| error("the camera's transformation has no inverse".to_owned()))?;
        let pose = Pose {
            eye: world_from_camera.at,
            right: world_from_camera.x,
            up: world_from_camera.y,
            backwards: -world_from_camera.z,
        };
        let Pose { right, up, backwards, .. } = pose;
        let is_mirrored = Basis::is_left_handed(right, up, backwards);
        let turn = |v: DVec3| if is_mirrored { mirrored(v) } else { v };
        let (eye, orientation) = match self.look_at {
            Some([eye, at, up]) => (turn(eye), Orientation::At { at: turn(at), up: turn(up) }),
            None => {
                let pose = if is_mirrored { pose.mirrored() } else { pose };
                let orientation = pose.orientation(&mut self.notes).map_err(&error)?;
                (pose.eye, orientation)
            }
        };
        self.shapes.tell(text, &mut self.notes);
        if is_mirrored {
            self.notes.push(MIRRORED.to_owned());
        }
        let camera = Camera { eye, orientation, viewport, image };
        let imported = Imported::camera(camera, self.notes);
        Ok(Imported { spheres: self.shapes.spheres, ..imported }.mirrored_if(is_mirrored))
    }
}
