//! What moves all that is seen beside the calls that are read.

use super::read::Call;
use crate::exchange::code::{Code, Piece, words};
use crate::formats::FileError;

const MOVING: [&str; 5] = ["glTranslate", "glRotate", "glScale", "glMultMatrix", "glLoadMatrix"];

/// What stands before `gluLookAt` or `gluPerspective` in its matrix moves all that is seen, and so does
/// what is done to the lens's or to GLM's matrix after it.
pub(super) fn unmoved(code: &Code, call: &Call) -> Result<(), FileError> {
    let whole = code.whole();
    if !call.name.starts_with("glu") {
        return unchanged(code, call);
    }
    let before = &whole.text[..call.arguments.at];
    let fresh = ["glLoadIdentity", "glMatrixMode", "\n}", "\ndef ", "glPopMatrix"];
    let start = fresh.iter().filter_map(|word| before.rfind(word)).max().unwrap_or(0);
    if let Some(word) = MOVING.iter().find(|word| before[start..].contains(**word)) {
        let right = format!("{word} stands before it and moves all that is seen");
        return Err(code.fault(call.name, call.arguments, &right));
    }
    // The lens's matrix goes on until another one is chosen.
    let after = &whole.text[call.arguments.at..];
    let ends = ["glMatrixMode", "gluLookAt", "glLoadIdentity", "\n}", "\ndef "];
    let end = ends.iter().filter_map(|word| after.find(word)).min().unwrap_or(0);
    let is_lens = call.name == "gluPerspective" && after[end..].starts_with("glMatrixMode");
    if let Some(word) = MOVING.iter().find(|word| is_lens && after[..end].contains(**word)) {
        let right =
            format!("{word} stands behind it in the same matrix and moves all that is seen");
        return Err(code.fault(call.name, call.arguments, &right));
    }
    Ok(())
}

fn unchanged(code: &Code, call: &Call) -> Result<(), FileError> {
    const CHANGING: [&str; 4] = ["translate(", "rotate(", "scale(", "inverse("];
    if call.matrix.is_empty() {
        return Ok(());
    }
    let whole = code.whole();
    let after = |at: &usize| *at > call.arguments.at;
    for at in words(whole, call.matrix).into_iter().filter(after) {
        let rest = whole.text[at + call.matrix.len()..].trim_start();
        let Some(value) = rest.strip_prefix('=').map(|value| value.split([';', '\n']).next())
        else {
            continue;
        };
        let value = value.unwrap_or_default();
        if CHANGING.iter().any(|word| value.contains(word)) {
            let right = format!(
                "the camera's matrix is changed after {}: it must be made by it alone",
                call.name
            );
            let piece = Piece { text: call.matrix, at };
            return Err(code.fault("the matrix", piece, &right));
        }
    }
    Ok(())
}

/// GLM's matrix as it is made, not a part of a product or of another call, which may turn it: but for
/// the lens before it, the objects' own matrix behind it, and what only hands it on.
pub(super) fn alone(code: &Code, look: &Call) -> Result<(), FileError> {
    if look.name.starts_with("glu") {
        return Ok(());
    }
    let whole = code.whole();
    let fault = |right: &str| Err(code.fault(look.name, look.arguments, right));
    let after = whole.text[look.arguments.at + look.arguments.text.len()..].trim_start();
    let after = after.strip_prefix(')').unwrap_or(after).trim_start();
    if let Some(factor) = after.strip_prefix(['*', '@']) {
        let end = factor.find([';', ',', ')', '\n']).unwrap_or(factor.len());
        let factor = factor[..end].trim().to_ascii_lowercase();
        let is_objects = factor == "m" || ["model", "world"].iter().any(|own| factor.contains(own));
        if !(is_objects && factor.chars().all(is_of_path)) {
            return fault("it is multiplied: the camera's matrix must be made by it alone");
        }
    }
    let method = after.strip_prefix('.').map(|rest| rest.split('(').next().unwrap_or_default());
    if method.is_some_and(|name| !["data", "ptr", "to_cols_array"].contains(&name.trim())) {
        return fault("it is changed at once: the camera's matrix must be made by it alone");
    }
    let path = &whole.text[..look.arguments.at];
    let path = path.rfind(look.name).map_or(path, |at| &path[..at]);
    let start = path.trim_end_matches(is_of_path).len();
    let statement = path[..start].rfind([';', '{', '}']).map_or(0, |at| at + 1);
    let before = &path[statement..start];
    if let Some(factor) = before.trim_end().strip_suffix(['*', '@']) {
        let factor = own_part(factor).trim().to_ascii_lowercase();
        let is_lens = ["proj", "persp", "ortho", "frustum", "clip", "lens"];
        if !(factor == "p" || is_lens.iter().any(|own| factor.contains(own))) {
            return fault("it is multiplied: the camera's matrix must be made by it alone");
        }
    }
    let Some(open) = enclosing(before) else { return Ok(()) };
    let head = before[..open].trim_end();
    let from = head.trim_end_matches(is_of_path).len();
    let (kind, name) = (head[..from].trim_end_matches([' ', '\t']), &head[from..]);
    // glm::mat4 view(glm::lookAt(...)) gives a name.
    let is_declared = kind.ends_with(|c: char| c.is_alphanumeric() || "_>".contains(c))
        && !kind.ends_with("return");
    let last = name.rsplit(['.', ':']).next().unwrap_or_default();
    let small = last.to_ascii_lowercase();
    const HANDING: [&str; 6] = ["uniform", "set", "value_ptr", "mat4", "loadmatrix", "push"];
    if is_declared || name.is_empty() || HANDING.iter().any(|word| small.contains(word)) {
        return Ok(());
    }
    fault(&format!("it is an argument of {name}: the camera's matrix must be made by it alone"))
}

/// The bracket that is open at the end of a text.
fn enclosing(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    text.char_indices().rev().find_map(|(at, c)| {
        match c {
            ')' => depth += 1,
            '(' if depth == 0 => return Some(at),
            '(' => depth -= 1,
            _ => (),
        }
        None
    })
}

/// A factor's text from where its argument or its statement begins.
fn own_part(text: &str) -> &str {
    let mut depth = 0_usize;
    let start = text.char_indices().rev().find(|(_, c)| {
        match c {
            ')' => depth += 1,
            '(' if depth > 0 => depth -= 1,
            '(' | ',' | '=' | '*' | '@' if depth == 0 => return true,
            _ => (),
        }
        false
    });
    start.map_or(text, |(at, _)| &text[at + 1..])
}

fn is_of_path(c: char) -> bool {
    c.is_alphanumeric() || "_.:$".contains(c)
}
