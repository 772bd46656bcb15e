//! What a three.js program hands the camera or a part of it to, and other names of its parts: who
//! holds one may move the camera.

use super::stand::moves;
use super::steps::{Later, body, name_before, path_of, steps};
use crate::exchange::code::{Code, Piece, after_spaces, split, words};
use crate::formats::FileError;

/// The camera itself, and what of it is handed on as a thing that can be changed.
const PARTS: [&str; 6] = ["", ".position", ".rotation", ".quaternion", ".up", ".scale"];

/// Calls that leave what they are handed as it is, or do what is read elsewhere, or move it later.
const HARMLESS: [&str; 54] = [
    "add",
    "addBinding",
    "addInput",
    "addVectors",
    "angleTo",
    "applyEuler",
    "applyMatrix4",
    "applyQuaternion",
    "attach",
    "catch",
    "clear",
    "compile",
    "compileAsync",
    "copy",
    "crossVectors",
    "debug",
    "dir",
    "distanceTo",
    "distanceToSquared",
    "dot",
    "equals",
    "error",
    "for",
    "function",
    "GUI",
    "if",
    "info",
    "intersectObjects",
    "lerp",
    "lerpVectors",
    "log",
    "lookAt",
    "multiply",
    "premultiply",
    "project",
    "push",
    "Raycaster",
    "remove",
    "render",
    "renderAsync",
    "return",
    "set",
    "setFromCamera",
    "setFromEuler",
    "setFromMatrixPosition",
    "setSize",
    "Stats",
    "sub",
    "subVectors",
    "switch",
    "table",
    "unproject",
    "warn",
    "while",
];

/// How the names of others that are harmless end.
const HARMLESS_ENDS: [&str; 4] = ["Controls", "Helper", "Pass", "Composer"];

/// A list in a list in a call: no call has more of them.
const DEEPEST: usize = 8;

/// Where the camera or a part of it stands as a whole.
struct Use<'t> {
    at: usize,
    part: String,
    rest: Piece<'t>,
}

pub(super) fn handed(code: &Code, names: &[&str], later: &Later) -> Result<(), FileError> {
    let whole = code.whole();
    let mut uses = Vec::new();
    for name in names {
        for at in words(whole, name) {
            if !whole.text[..at].ends_with('.') && !later.contains(at) {
                let mut part = String::new();
                let rest = path_of(whole.from(at + name.len()), &mut part);
                if PARTS.contains(&part.as_str()) {
                    uses.push(Use { at, part, rest });
                }
            }
        }
    }
    uses.sort_by_key(|one| one.at);
    let (mut brackets, mut around) = (code.brackets.iter().copied().peekable(), Vec::new());
    for one in uses {
        while let Some(pair) = brackets.next_if(|(open, _)| *open < one.at) {
            while around.pop_if(|(_, close)| *close < pair.0).is_some() {}
            around.push(pair);
        }
        while around.pop_if(|(_, close)| *close < one.at).is_some() {}
        let before = whole.text[..one.at].trim_end();
        if before.ends_with('=') {
            other_name(code, &one, before, later)?;
        } else if before.ends_with(['(', ',', '{', '[', ':'])
            && one.rest.text.starts_with([',', ')', '}', ']'])
            && let Some(open) = call_around(whole.text, &around)
        {
            handed_to(code, names, &one, open)?;
        }
    }
    Ok(())
}

/// The bracket of the call that has a place among its arguments, also in a list of its own.
fn call_around(text: &str, around: &[(usize, usize)]) -> Option<usize> {
    for (open, _) in around.iter().rev().take(DEEPEST) {
        if text[*open..].starts_with('(') {
            return Some(*open);
        }
        if !text[..*open].trim_end().ends_with(['(', ',', ':', '[']) {
            return None;
        }
    }
    None
}

/// `const p = camera.position;`, and then `p.y = 9`.
fn other_name(code: &Code, one: &Use, before: &str, later: &Later) -> Result<(), FileError> {
    let right = "it is a part of the camera, which must be moved by its own name";
    let taken_apart = before.strip_suffix('=').unwrap_or(before).trim_end().strip_suffix('}');
    if let Some(inside) = taken_apart.and_then(|before| before.rsplit('{').next()) {
        let is_part = |part: &&&str| {
            !words(Piece { text: inside, at: 0 }, part.trim_start_matches('.')).is_empty()
        };
        if let Some(part) = PARTS[1..].iter().find(is_part) {
            let piece = Piece { text: part.trim_start_matches('.'), at: one.at };
            return Err(code.error(one.at, format!("{}: {right}", piece.text)));
        }
        return Ok(());
    }
    if one.part.is_empty() {
        return Ok(());
    }
    let Some(alias) = name_before(before, "") else { return Ok(()) };
    for step in steps(code, alias) {
        let path = format!("{}{}", one.part, step.path);
        if step.at > one.at && !step.path.is_empty() && moves(&path) && !later.contains(step.at) {
            return Err(code.fault(&format!("{alias}{}", step.path), step.values, right));
        }
    }
    Ok(())
}

fn handed_to(code: &Code, names: &[&str], one: &Use, open: usize) -> Result<(), FileError> {
    let whole = code.whole();
    let Some(arguments) = code.bracketed(whole.from(open)) else { return Ok(()) };
    let callee = callee_before(&whole.text[..open]);
    let behind = after_spaces(whole.from(arguments.at + arguments.text.len() + 1));
    if callee.is_empty() || is_harmless(callee) || is_definition(behind.text) {
        return Ok(());
    }
    let short = callee.rsplit('.').next().unwrap_or(callee);
    let place = split(arguments)
        .iter()
        .position(|part| (part.at..part.at + part.text.len()).contains(&one.at));
    if place.is_some_and(|place| leaves_alone(code, names, short, place)) {
        return Ok(());
    }
    let length = one.rest.at - one.at;
    let piece = Piece { text: whole.text[one.at..one.at + length].trim_end(), at: one.at };
    let right = "what it does to the camera is not read: the camera must be moved by its own name";
    Err(code.fault(&format!("what {callee} is handed"), piece, right))
}

/// The path before a bracket.
fn callee_before(before: &str) -> &str {
    let before = before.trim_end();
    let start = before.trim_end_matches(|c: char| c.is_alphanumeric() || "_$.".contains(c)).len();
    &before[start..]
}

fn is_harmless(callee: &str) -> bool {
    let short = callee.rsplit('.').next().unwrap_or(callee);
    HARMLESS.contains(&short) || HARMLESS_ENDS.iter().any(|end| short.ends_with(end))
}

/// Whether what follows a bracket shows that parameters stand in it.
fn is_definition(behind: &str) -> bool {
    let kind = behind.strip_prefix(':').map(|kind| {
        let is_kind = |c: char| c.is_alphanumeric() || " _.[]|".contains(c);
        kind.trim_start_matches(is_kind)
    });
    let behind = kind.unwrap_or(behind);
    behind.starts_with('{') || behind.starts_with("=>")
}

/// Whether a function of the text does nothing to what it is handed in this place.
fn leaves_alone(code: &Code, names: &[&str], callee: &str, place: usize) -> bool {
    let whole = code.whole();
    let is_class = |at: &usize| whole.text[..*at].trim_end().ends_with("class");
    let found = words(whole, callee);
    let (from, name) = match found.iter().find(|at| is_class(at)) {
        Some(class) => (*class, "constructor"),
        None => (0, callee),
    };
    let mut places = words(whole.from(from), name).into_iter().map(|at| at + from);
    let found = places.find_map(|at| Some((at + name.len(), body(code, at, name.len())?)));
    let Some((end, inside)) = found else { return false };
    let Some(head) = whole.text.get(end..inside.start) else { return false };
    let Some(open) = head.find('(') else { return false };
    let Some(parameters) = code.bracketed(whole.from(end + open)) else { return false };
    let parameters = split(parameters);
    // What has no name of its own cannot be told apart.
    let Some(parameter) = parameters.get(place) else { return false };
    let is_letter = |c: char| c.is_alphanumeric() || "_$".contains(c);
    let parameter = parameter.text.split(|c| !is_letter(c)).next().unwrap_or_default();
    // By the camera's own name it is moved as everywhere.
    if parameter.is_empty() || names.contains(&parameter) {
        return !parameter.is_empty();
    }
    let inside = Piece { text: &whole.text[inside.clone()], at: inside.start };
    words(inside, parameter).into_iter().all(|at| {
        let before = &inside.text[..at];
        let mut path = String::new();
        let rest = path_of(inside.from(at + parameter.len()), &mut path);
        if before.ends_with('.') {
            return true;
        }
        if !path.is_empty() {
            return !moves(&path);
        }
        let open = before.rfind('(').unwrap_or(0);
        let callee = callee_before(&before[..open]);
        rest.text.starts_with([',', ')']) && is_harmless(callee)
    })
}
