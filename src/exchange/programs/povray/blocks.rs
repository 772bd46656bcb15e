//! A POV-Ray scene's blocks: its camera, and the objects that stand by themselves.

use super::source::Code;
use super::values::depth_behind;
use crate::FileError;
use crate::format::left_out::LeftOut;
use crate::programs::pieces::{Piece, is_of_word};

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

/// POV-Ray's own files, which hold no camera and no object that stands in a scene.
const STANDARD: [&str; 25] = [
    "arrays",
    "chars",
    "colors",
    "consts",
    "debug",
    "finish",
    "functions",
    "glass",
    "glass_old",
    "golds",
    "ior",
    "logo",
    "math",
    "metals",
    "rand",
    "shapes",
    "shapes2",
    "skies",
    "stars",
    "stones",
    "strings",
    "textures",
    "transforms",
    "woodmaps",
    "woods",
];

/// A camera's block.
struct Shot<'t> {
    inside: Piece<'t>,
    /// The name that it is declared by.
    name: Option<&'t str>,
    /// True where it stands between `#if` and `#end`, or their like.
    is_conditional: bool,
}

/// Blocks of a scene that stand in no other one, each as the text in its braces.
#[derive(Default)]
pub(super) struct Blocks<'t> {
    cameras: Vec<Shot<'t>>,
    pub(super) spheres: Vec<Piece<'t>>,
    pub(super) planes: Vec<Piece<'t>>,
    others: LeftOut,
    is_declared: bool,
    is_conditional: bool,
}

impl<'t> Blocks<'t> {
    /// One pass over the text; it ends at the first block that is not closed.
    pub(super) fn find(code: &'t Code) -> Blocks<'t> {
        let (mut blocks, mut depth) = (Blocks::default(), 0_usize);
        let mut rest = code.whole();
        while let Some(c) = rest.text.chars().next() {
            let after = rest.from(c.len_utf8());
            rest = match c {
                '"' => {
                    after.from(after.text.find(['"', '\n']).map_or(after.text.len(), |at| at + 1))
                }
                '#' => {
                    let word = after.after_spaces().word();
                    let behind = code.whole().from(word.at + word.text.len());
                    depth = depth_behind(word.text, depth);
                    if word.text == "include" {
                        blocks.include(behind.after_spaces());
                    }
                    behind
                }
                '{' => match code.bracketed(rest) {
                    Some(inside) => after.from(inside.text.len() + 1),
                    None => break,
                },
                c if is_of_word(c) => {
                    let word = rest.word();
                    let open = rest.from(word.text.len()).after_spaces();
                    if !open.text.starts_with('{') {
                        open
                    } else {
                        let Some(inside) = code.bracketed(open) else { break };
                        blocks.take(code, word, inside, depth > 0);
                        open.from(inside.text.len() + 2)
                    }
                }
                _ => after,
            };
        }
        blocks
    }

    fn include(&mut self, behind: Piece) {
        let file = behind.text.strip_prefix('"').and_then(|rest| rest.split(['"', '\n']).next());
        let name = file.and_then(|file| file.strip_suffix(".inc"));
        if !name.is_some_and(|name| STANDARD.contains(&name)) {
            self.others.add("#include", "left out: what is in other files is not read");
        }
    }

    fn take(&mut self, code: &'t Code, word: Piece<'t>, inside: Piece<'t>, is_conditional: bool) {
        let before = code.whole().text[..word.at].trim_end();
        let declared = before.strip_suffix('=').map(|before| {
            let before = before.trim_end();
            &before[before.trim_end_matches(is_of_word).len()..]
        });
        match (word.text, declared) {
            ("camera", name) => {
                self.cameras.push(Shot { inside, name, is_conditional });
            }
            (other, Some(_)) => self.is_declared |= is_object(other),
            (other, _) if is_conditional => self.is_conditional |= is_object(other),
            ("sphere", _) => self.spheres.push(inside),
            ("plane", _) => self.planes.push(inside),
            (other, _) if MADE_OF_OTHERS.contains(&other) || other == "blob" => {
                let said = "left out with its parts: Pinhole has whole spheres and planes";
                self.others.add(other, said);
            }
            (other, _) if is_object(other) => {
                self.others.add(other, "left out: Pinhole has spheres and planes");
            }
            _ => (),
        }
    }

    /// The camera that POV-Ray looks through: the last one.
    pub(super) fn camera(
        &self,
        code: &Code,
        notes: &mut Vec<String>,
    ) -> Result<Piece<'t>, FileError> {
        let placed = self.cameras.iter().rposition(|shot| shot.name.is_none());
        if placed.is_none() && !self.cameras.is_empty() {
            notes.push("no camera is placed: the last that is declared is taken".to_owned());
        }
        let mut index = placed
            .or(self.cameras.len().checked_sub(1))
            .ok_or_else(|| code.missing("camera", "as camera { location <0, 0, 0> }"))?;
        loop {
            let shot = &self.cameras[index];
            if shot.is_conditional {
                let right = "camera: it must stand by itself, not between #if, #while, #for, #switch or \
                             #macro and #end";
                return Err(code.error(shot.inside.at, right));
            }
            // `camera { Name }` is the one that is declared by this name before it.
            let content = shot.inside.trimmed();
            let name = content.word();
            let mut before = self.cameras[..index].iter();
            let Some(declared) = before.rposition(|other| other.name == Some(name.text)) else {
                return Ok(shot.inside);
            };
            if name.text.len() < content.text.len() {
                let right = "what is added to it must stand in its declaration";
                return Err(code.fault("camera", name, right));
            }
            index = declared;
        }
    }

    /// Notes the blocks that are left out because of where or what they are.
    pub(super) fn left_out(&self, notes: &mut Vec<String>) {
        self.others.tell(notes);
        if self.is_declared {
            notes
                .push("what #declare names is left out: an object must stand by itself".to_owned());
        }
        if self.is_conditional {
            let note =
                "what stands between #if, #while, #for, #switch or #macro and #end is left out";
            notes.push(note.to_owned());
        }
    }
}

fn is_object(word: &str) -> bool {
    ["sphere", "plane"].contains(&word) || OTHERS.contains(&word) || MADE_OF_OTHERS.contains(&word)
}
