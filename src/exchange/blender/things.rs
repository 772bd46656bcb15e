//! Which thing each statement of a Blender program is about, and which of them is the camera.

use std::collections::{HashMap, HashSet};

use super::parts::{LONGEST_PATH, is_active, is_path, owner, plain};
use super::passed::{Passed, passed};
use crate::exchange::code::{Code, Piece, is_of_word, split};
use crate::exchange::python::{Block, Statement, Verb, statements};
use crate::formats::FileError;

/// What is done to a part of a thing.
#[derive(Clone, Debug)]
pub(super) struct Deed<'t> {
    /// The whole path, with the thing's one name in the place of the program's names.
    pub(super) path: String,
    pub(super) verb: Verb,
    pub(super) value: Piece<'t>,
    pub(super) block: Block,
}

/// What is known of a thing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Camera,
    Other,
    /// It may be one: it is called so.
    Named,
    Unknown,
}

/// What the statements do, thing by thing.
#[derive(Default)]
pub(super) struct Things<'t> {
    names: HashMap<String, String>,
    /// What each function returns, and how often it was asked to.
    returned: HashMap<String, (String, usize)>,
    function: String,
    /// The data of each object that is made.
    data: HashMap<String, String>,
    /// The object that was added last, or made the active one.
    active: String,
    /// What `scene.camera` was given.
    given: Vec<String>,
    made: usize,
    /// To which functions what was given already.
    handed: HashSet<String>,
    pub(super) deeds: Vec<Deed<'t>>,
}

/// The camera, and its data.
pub(super) struct Chosen {
    /// What it is called by.
    pub(super) camera: Vec<String>,
    pub(super) data: Vec<String>,
    /// The text makes it: what is not said of it is as Blender makes cameras.
    pub(super) is_made: bool,
}

pub(super) const SCENE_CAMERA: &str = "scene.camera";
/// What gives an object its place or its turn.
const STANCE: [&str; 8] = [
    ".location",
    ".rotation_euler",
    ".rotation_quaternion",
    ".rotation_axis_angle",
    ".matrix_world",
    ".matrix_local",
    ".matrix_basis",
    ".added",
];
/// What only a camera's data have.
const LENS: [&str; 6] =
    [".lens", ".sensor_width", ".sensor_height", ".sensor_fit", ".angle_x", ".angle_y"];

impl<'t> Things<'t> {
    pub(super) fn of(code: &'t Code) -> Things<'t> {
        let mut things = Things::default();
        for said in statements(code) {
            if said.verb != Verb::Define {
                things.hand_on(code, &said);
            }
            things.take(&said);
        }
        things
    }

    fn take(&mut self, said: &Statement<'t>) {
        let left = plain(said.left.text);
        match said.verb {
            Verb::Define => {
                left.split('(').next().unwrap_or_default().clone_into(&mut self.function)
            }
            Verb::Return => {
                let value = self.resolved(said.right, said.block);
                self.returned.insert(self.function.clone(), (value, 0));
            }
            // What the console printed, without what it was asked.
            Verb::Say if left.starts_with("Matrix(") || left.starts_with("<Matrix") => {
                let said = Statement { verb: Verb::Give, ..*said };
                self.add("camera.matrix_world".to_owned(), &said);
            }
            Verb::Say => {
                let path = self.resolved(said.right, said.block);
                self.add(path, said);
            }
            Verb::Give => {
                let value = self.resolved(said.right, said.block);
                let path = self.path_of(&left);
                if path == SCENE_CAMERA {
                    self.given.push(value);
                } else if path.ends_with("objects.active") {
                    self.active = value;
                } else {
                    self.add(path, said);
                    let things = ["#", ".objects[", ".cameras[", SCENE_CAMERA];
                    let is_thing = things.iter().any(|word| value.contains(word));
                    let is_name = is_path(&left) && (is_thing || !left.contains('.'));
                    if is_name && value.len() < LONGEST_PATH {
                        self.names.insert(left, value);
                    }
                }
            }
            Verb::Change(_) => {
                let path = self.path_of(&left);
                self.add(path, said);
            }
        }
    }

    fn add(&mut self, path: String, said: &Statement<'t>) {
        let (verb, value, block) = (said.verb, said.right, said.block);
        self.deeds.push(Deed { path, verb, value, block });
    }

    /// What the calls of a statement are given: a deed of each thing whose place they may change.
    fn hand_on(&mut self, code: &'t Code, said: &Statement<'t>) {
        for Passed { call, argument, place } in passed(code, said.right) {
            let path = self.path_of(&plain(argument));
            let owner = STANCE.iter().find_map(|word| path.strip_suffix(word)).unwrap_or(&path);
            // So many are looked through; of more it is not known what they do.
            let place = if self.handed.len() < 1000 { place } else { "?".to_owned() };
            let path = format!("{owner}.passed[{place}]");
            let name = call.text.split('(').next().unwrap_or_default();
            if self.handed.insert(format!("{name} {path}")) {
                let (verb, block) = (Verb::Say, said.block);
                self.deeds.push(Deed { path, verb, value: call, block });
            }
        }
    }

    fn is_scene(owner: &str) -> bool {
        let last = owner.rsplit('.').next().unwrap_or_default();
        last == "scene" || last.starts_with("scenes[") || last == "scn"
    }

    /// With one name for the scene's camera, whatever the scene is called.
    fn of_scene(path: String) -> String {
        let camera = path.match_indices(".camera").map(|(at, word)| (at, at + word.len()));
        let mut camera = camera.filter(|(at, end)| {
            !path[*end..].starts_with(is_of_word) && Self::is_scene(&path[..*at])
        });
        match camera.next() {
            Some((_, end)) => format!("{SCENE_CAMERA}{}", &path[end..]),
            None => path,
        }
    }

    /// The one name of what an expression is.
    fn resolved(&mut self, piece: Piece<'t>, block: Block) -> String {
        let text = plain(piece.text);
        if text.is_empty() {
            return text;
        }
        let call = text.split_once('(').map(|(name, _)| name.to_owned());
        let Some(name) = call else { return self.path_of(&text) };
        if name.ends_with(".objects.new") {
            return self.object(piece);
        }
        if let Some(kind) = name.strip_suffix(".new").filter(|kind| kind.contains(".data.")) {
            self.made += 1;
            return format!("{}#{}", kind.rsplit('.').next().unwrap_or_default(), self.made);
        }
        if name.contains(".ops.") && name.ends_with("_add") {
            self.made += 1;
            let kind = name.rsplit('.').next().unwrap_or_default();
            if kind != "constraint_add" {
                self.active = format!("{kind}#{}", self.made);
                let (verb, path) = (Verb::Say, format!("{}.added", self.active));
                self.deeds.push(Deed { path, verb, value: piece, block });
                return self.active.clone();
            }
        }
        if name.starts_with("bpy.ops.transform.") || name.ends_with("constraint_add") {
            let path = format!("{}.{}", self.active, name.trim_start_matches("bpy."));
            self.deeds.push(Deed { path, verb: Verb::Say, value: piece, block });
        }
        if name.contains("camera_to_view") {
            let path = format!("{SCENE_CAMERA}.ops.{name}");
            self.deeds.push(Deed { path, verb: Verb::Say, value: piece, block });
        }
        if let Some((value, count)) = self.returned.get_mut(&name) {
            *count += 1;
            return match count {
                1 => value.clone(),
                // Another one, as it is made anew.
                _ => format!("{value} again {count}"),
            };
        }
        let path = self.path_of(&text);
        let owner_acts = [".constraints.new(", ".rotate(", ".rotate_axis("];
        if owner_acts.iter().any(|act| path.contains(act)) {
            self.deeds.push(Deed { path: path.clone(), verb: Verb::Say, value: piece, block });
        }
        path
    }

    /// `bpy.data.objects.new("name", data)`.
    fn object(&mut self, piece: Piece<'t>) -> String {
        self.made += 1;
        let name = format!("object#{}", self.made);
        let open = piece.text.find('(').map_or(piece.text.len(), |at| at + 1);
        let inside = piece.from(open);
        let inside = Piece { text: inside.text.strip_suffix(')').unwrap_or(inside.text), ..inside };
        let parts = split(inside);
        let by_name = parts.iter().find_map(|part| {
            let (before, _) = part.text.split_once('=')?;
            (before.trim() == "object_data").then(|| part.from(before.len() + 1))
        });
        let data = by_name.or(parts.get(1).copied());
        let data = data.map_or("None".to_owned(), |data| self.resolved(data, Block::Always));
        self.data.insert(name.clone(), data);
        name
    }

    /// A path with the things' own names in the place of the program's.
    pub(super) fn path_of(&self, text: &str) -> String {
        if text.len() > LONGEST_PATH {
            return text.to_owned();
        }
        let text = text.replace(".get(", "[").replace("'),", "'],");
        let text = match text.strip_suffix("')") {
            Some(start) if start.contains("['") => format!("{start}']"),
            _ => text,
        };
        let ends: Vec<usize> =
            text.match_indices('.').map(|(at, _)| at).chain([text.len()]).collect();
        for end in ends.into_iter().rev() {
            let (head, rest) = text.split_at(end);
            if is_active(head) && !self.active.is_empty() {
                return format!("{}{rest}", self.active);
            }
            if let Some(known) = self.names.get(head) {
                return Self::of_scene(format!("{known}{rest}"));
            }
        }
        Self::of_scene(text)
    }

    fn kind(&self, thing: &str) -> Kind {
        if thing == SCENE_CAMERA || thing.starts_with("camera_add#") {
            return Kind::Camera;
        }
        if let Some((kind, _)) = thing.split_once("_add#") {
            return if kind == "add" { Kind::Unknown } else { Kind::Other };
        }
        let own = thing.split(" again").next().unwrap_or(thing);
        if let Some(data) = self.data.get(own) {
            let others =
                ["lights#", "meshes#", "curves#", "None", "bpy.data.lights", "bpy.data.meshes"];
            return match data {
                data if data.starts_with("cameras#") || data.starts_with("bpy.data.cameras") => {
                    Kind::Camera
                }
                data if others.iter().any(|other| data.starts_with(other)) => Kind::Other,
                _ => Kind::Unknown,
            };
        }
        let small = thing.to_ascii_lowercase();
        if small.contains("cam") { Kind::Named } else { Kind::Unknown }
    }

    /// Those that are given a place or a turn, in the order of the text.
    fn standing(&self) -> Vec<String> {
        const MOST: usize = 1000;
        let mut standing: Vec<String> = Vec::new();
        let mut seen = HashSet::new();
        for deed in &self.deeds {
            let owners = STANCE.iter().filter_map(|word| owner(&deed.path, word));
            for owner in owners.take(1).filter(|owner| !owner.is_empty()) {
                if standing.len() < MOST && seen.insert(owner.to_owned()) {
                    standing.push(owner.to_owned());
                }
            }
        }
        standing
    }

    /// The camera: what `scene.camera` is given, else what is made as one, else what is called so, else
    /// the only thing that has a place.
    pub(super) fn camera(&self, code: &Code) -> Result<Chosen, FileError> {
        let standing = self.standing();
        let of = |kinds: &[Kind]| -> Vec<&String> {
            standing.iter().filter(|thing| kinds.contains(&self.kind(thing))).collect()
        };
        let first = self.given.first();
        let camera = match first {
            Some(_) if self.given.iter().any(|given| Some(given) != first) => {
                return Err(code.missing("the one camera", "scene.camera is given more than one"));
            }
            Some(given) => given,
            None => {
                let sure = of(&[Kind::Camera, Kind::Named]);
                let found = if sure.is_empty() { of(&[Kind::Unknown]) } else { sure };
                match found[..] {
                    [one] => one,
                    [] => {
                        let right = "the camera must be given by it, or by location and \
                                     rotation_euler";
                        return Err(code.missing("matrix_world", right));
                    }
                    [a, b, ..] => {
                        let right = format!(
                            "{} or {}: scene.camera = ... must say which it is",
                            shown(a),
                            shown(b)
                        );
                        return Err(code.missing("the one camera", &right));
                    }
                }
            }
        };
        let mut names = vec![camera.clone()];
        if first.is_some() {
            names.push(SCENE_CAMERA.to_owned());
        }
        let data = self.data_of(&names, &standing, code)?;
        let is_made = camera.contains('#');
        Ok(Chosen { camera: names, data, is_made })
    }

    /// Under which names the camera's data are found.
    fn data_of(
        &self,
        camera: &[String],
        standing: &[String],
        code: &Code,
    ) -> Result<Vec<String>, FileError> {
        let mut data: Vec<String> = camera.iter().map(|name| format!("{name}.data")).collect();
        data.extend(camera.iter().filter_map(|name| self.data.get(name).cloned()));
        let others_data: Vec<&String> = self.data.values().take(100).collect();
        let mut is_given = false;
        let mut others: Vec<&str> = Vec::new();
        for deed in &self.deeds {
            let Some(owner) = LENS.iter().find_map(|word| owner(&deed.path, word)) else {
                continue;
            };
            if data.iter().any(|own| own == owner) {
                is_given = true;
                continue;
            }
            // Another object's, which has its own place.
            let object = owner.strip_suffix(".data");
            let is_other = object
                .is_some_and(|object| standing.iter().any(|other| other == object))
                || others_data.iter().any(|of| *of == owner);
            if !is_other && !others.contains(&owner) && others.len() < 2 {
                others.push(owner);
            }
        }
        match others[..] {
            [one] if !is_given => data.push(one.to_owned()),
            [] => (),
            _ => {
                let right = "the text gives one to several cameras: one must be left";
                return Err(code.missing("the camera's lens", right));
            }
        }
        Ok(data)
    }
}

/// How a thing is called in a message.
fn shown(thing: &str) -> &str {
    thing.split('#').next().unwrap_or(thing)
}
