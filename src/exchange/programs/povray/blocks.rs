//! A POV-Ray scene's blocks: its camera, and the objects that stand by themselves.

use super::branches::{Branch, Branches};
use super::source::{Code, Piece, after_spaces, is_of_word, trimmed};
use super::values::{Values, word_of};
use crate::FileError;
use crate::format::left_out::LeftOut;

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

/// A camera's block, and under what it stands.
struct Shot<'t> {
    inside: Piece<'t>,
    /// The name that it is declared by.
    name: Option<&'t str>,
    /// Condition that is not worked out and decides whether it counts.
    under: Option<Piece<'t>>,
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
    pub(super) fn find(code: &'t Code, values: &Values) -> Blocks<'t> {
        let (mut blocks, mut branches) = (Blocks::default(), Branches::default());
        let mut rest = code.whole();
        while let Some(c) = rest.text.chars().next() {
            let after = rest.from(c.len_utf8());
            rest = match c {
                '"' => {
                    after.from(after.text.find(['"', '\n']).map_or(after.text.len(), |at| at + 1))
                }
                '#' => {
                    let word = word_of(after_spaces(after));
                    let end = code.whole().from(word.at + word.text.len());
                    branches.take(code, values, word, after_spaces(end));
                    if word.text == "include" && branches.now() != Branch::Skipped {
                        blocks.include(after_spaces(end));
                    }
                    end
                }
                '{' => match code.bracketed(rest) {
                    Some(inside) => after.from(inside.text.len() + 1),
                    None => break,
                },
                c if is_of_word(c) => {
                    let word = word_of(rest);
                    let open = after_spaces(rest.from(word.text.len()));
                    if !open.text.starts_with('{') {
                        open
                    } else {
                        let Some(inside) = code.bracketed(open) else { break };
                        blocks.take(code, word, inside, &branches);
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

    fn take(&mut self, code: &'t Code, word: Piece<'t>, inside: Piece<'t>, under: &Branches<'t>) {
        if under.now() == Branch::Skipped {
            return;
        }
        let under = under.undecided();
        let is_conditional = under.is_some();
        let before = code.whole().text[..word.at].trim_end();
        let declared = before.strip_suffix('=').map(|before| {
            let before = before.trim_end();
            &before[before.trim_end_matches(is_of_word).len()..]
        });
        match (word.text, declared) {
            ("camera", name) => self.cameras.push(Shot { inside, name, under }),
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
        let placed = |shot: &&Shot| shot.name.is_none();
        let certain = self.cameras.iter().rposition(|shot| placed(&shot) && shot.under.is_none());
        // Of those before it none counts.
        let candidates = &self.cameras[certain.unwrap_or(0)..];
        let open: Vec<Piece> =
            candidates.iter().filter(placed).filter_map(|shot| shot.under).collect();
        if let [first, _, ..] = open[..] {
            let right = format!(
                "it is not worked out, and {} of camera stand under such conditions: leave in one",
                open.len()
            );
            return Err(code.fault("the condition", first, &right));
        }
        let shot = match certain {
            Some(certain) => self.cameras.get(certain),
            None => self.cameras.iter().rfind(placed),
        };
        let Some(shot) = shot else {
            let shot = self.cameras.last();
            let shot =
                shot.ok_or_else(|| code.missing("camera", "as camera { location <0, 0, 0> }"))?;
            notes.push("no camera is placed: the last that is declared is taken".to_owned());
            return self.resolved(code, shot);
        };
        if !open.is_empty() {
            let line = code.error(shot.inside.at, "").place.map_or(0, |place| place.line);
            let which = match certain {
                Some(_) => "the last that stands under none",
                None => "it",
            };
            notes.push(format!(
                "1 of camera under a condition that is not worked out: {which} is taken, line {line}"
            ));
        }
        self.resolved(code, shot)
    }

    /// `camera { Name }` is the one that is declared by this name.
    fn resolved(&self, code: &Code, shot: &Shot<'t>) -> Result<Piece<'t>, FileError> {
        const MOST: usize = 8;
        let mut inside = shot.inside;
        for _ in 0..MOST {
            let content = trimmed(inside);
            let name = word_of(content);
            let declared =
                |shot: &&Shot| shot.name == Some(name.text) && shot.inside.at < inside.at;
            let Some(found) = self.cameras.iter().rfind(declared).filter(|_| !name.text.is_empty())
            else {
                return Ok(inside);
            };
            if name.text.len() < content.text.len() {
                let right = "what is added to it must stand in its declaration";
                return Err(code.fault("camera", name, right));
            }
            if let Some(under) = found.under {
                let right = format!("it is not worked out, and camera {} depends on it", name.text);
                return Err(code.fault("the condition", under, &right));
            }
            inside = found.inside;
        }
        Err(code.fault("camera", trimmed(shot.inside), "it is declared by too many other names"))
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
