//! The statements of a three.js program that are about one thing, and which of its cameras is meant.

use std::ops::Range;

use crate::exchange::code::{Code, Piece, after_spaces, is_of_word, split, statement, words};
use crate::formats::FileError;

/// Something is done to a thing: `camera.position.set(1, 2, 3)`, `camera.position.y += 5`.
#[derive(Clone, Debug)]
pub(super) struct Step<'t> {
    pub(super) at: usize,
    /// What follows the thing's name, up to the bracket or the sign.
    pub(super) path: String,
    pub(super) verb: Verb,
    pub(super) values: Piece<'t>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verb {
    Call,
    /// `=`.
    Give,
    /// `+=` and its like.
    Change(char),
}

/// Everything that is done to what has this name, in the order of the text.
pub(super) fn steps<'t>(code: &'t Code, name: &str) -> Vec<Step<'t>> {
    let whole = code.whole();
    let mut steps = Vec::new();
    let is_own = |at: &usize| !whole.text[..*at].ends_with('.');
    let mut from = 0;
    for at in words(whole, name).into_iter().filter(is_own) {
        // What is in a value is a part of it.
        if at < from {
            continue;
        }
        let mut path = String::new();
        let mut rest = whole.from(at + name.len());
        loop {
            rest = path_of(rest, &mut path);
            let Some((verb, values)) = deed(code, rest) else { break };
            steps.push(Step { at, path: path.clone(), verb, values });
            // What a call gives back may be told more.
            let method = path.rfind('.').unwrap_or(0);
            if verb != Verb::Call {
                from = values.at + values.text.len();
                break;
            }
            if is_question(&path) {
                break;
            }
            path.truncate(method);
            rest = whole.from(values.at + values.text.len() + 1);
            if !after_spaces(rest).text.starts_with('.') {
                break;
            }
        }
    }
    steps
}

/// Adds `.position.set` to the path, and gives what follows it; lines may end before a point.
pub(super) fn path_of<'t>(mut rest: Piece<'t>, path: &mut String) -> Piece<'t> {
    loop {
        let next = after_spaces(rest);
        let next = next.from(next.text.len() - next.text.trim_start_matches(['?', '!']).len());
        let Some(word) = next.text.strip_prefix('.') else { return after_spaces(rest) };
        let end = word.find(|c: char| !is_of_word(c)).unwrap_or(word.len());
        path.push('.');
        path.push_str(&word[..end]);
        rest = next.from(1 + end);
        if end == 0 {
            return rest;
        }
    }
}

fn deed<'t>(code: &Code, rest: Piece<'t>) -> Option<(Verb, Piece<'t>)> {
    let mut signs = rest.text.chars();
    let (first, second) = (signs.next()?, signs.next());
    match (first, second) {
        ('(', _) => code.bracketed(rest).map(|inside| (Verb::Call, inside)),
        ('=', Some('=' | '>')) => None,
        ('=', _) => Some((Verb::Give, statement(after_spaces(rest.from(1))))),
        ('+', Some('+')) | ('-', Some('-')) => {
            Some((Verb::Change('?'), Piece { text: &rest.text[..2], ..rest }))
        }
        ('+' | '-' | '*' | '/', Some('=')) => {
            Some((Verb::Change(first), statement(after_spaces(rest.from(2)))))
        }
        _ => None,
    }
}

/// What only asks, and changes nothing.
pub(super) fn is_question(path: &str) -> bool {
    const QUESTIONS: [&str; 12] = [
        "clone",
        "distanceTo",
        "distanceToSquared",
        "length",
        "lengthSq",
        "toArray",
        "toJSON",
        "equals",
        "dot",
        "angleTo",
        "toFixed",
        "manhattanLength",
    ];
    let last = path.rsplit('.').next().unwrap_or_default();
    last.starts_with("get") || QUESTIONS.contains(&last)
}

/// `new THREE.Something(`: what is in the brackets, and the name that it is given, if any.
pub(super) fn made<'t>(code: &'t Code, kind: &str) -> Vec<(Option<&'t str>, Piece<'t>)> {
    let whole = code.whole();
    let is_path = |c: char| c.is_alphanumeric() || "_$.".contains(c);
    let mut found = Vec::new();
    for call in code.calls(kind) {
        let before = whole.text[..call.at].trim_end_matches('(').trim_end();
        let before = before.trim_end_matches(is_path);
        let Some(before) = before.trim_end().strip_suffix("new") else { continue };
        found.push((name_before(before.trim_end(), kind), call));
    }
    found
}

/// The name in `const camera: THREE.PerspectiveCamera =`.
pub(super) fn name_before<'t>(before: &'t str, kind: &str) -> Option<&'t str> {
    let before = before.strip_suffix('=')?.trim_end();
    // In TypeScript its kind may follow the name.
    let before = before.trim_end_matches(kind).trim_end_matches("THREE.").trim_end();
    let before = before.trim_end_matches(':').trim_end();
    let start = before.rfind(|c: char| !(c.is_alphanumeric() || "_$.".contains(c)));
    let name = before.get(start.map_or(0, |at| at + 1)..).unwrap_or_default();
    (!name.is_empty()).then_some(name)
}

/// The camera that is made: of several the one that is rendered, or that is called camera.
pub(super) fn camera<'t>(
    code: &'t Code,
    kind: &str,
    notes: &mut Vec<String>,
) -> Result<(Option<&'t str>, Piece<'t>), FileError> {
    let cameras = made(code, kind);
    let Some(last) = cameras.last() else {
        let right = "it must be made, as new THREE.PerspectiveCamera(50, 4 / 3, 0.1, 100)";
        return Err(code.missing(kind, right));
    };
    let others = cameras.iter().filter(|(name, _)| *name != last.0).count();
    let chosen = if others == 0 {
        *last
    } else {
        let mut seen: Vec<&str> = Vec::new();
        for call in ["render", "RenderPass"].into_iter().flat_map(|name| code.calls(name)) {
            if let [_, camera, ..] = split(call)[..] {
                seen.push(camera.text);
            }
        }
        seen.sort_unstable();
        let is_rendered = |name: &str| seen.binary_search(&name).is_ok();
        let is_called_so = |name: &str| ["camera", "this.camera"].contains(&name);
        let one_of = |is_it: &dyn Fn(&str) -> bool| {
            let own = cameras.iter().filter(|(name, _)| name.is_some_and(is_it));
            let own: Vec<_> = own.copied().collect();
            own.last().copied().filter(|last| own.iter().all(|(name, _)| *name == last.0))
        };
        let Some(one) = one_of(&is_rendered).or_else(|| one_of(&is_called_so)) else {
            let right = format!("one of {} cameras: leave in one", cameras.len());
            return Err(code.fault(kind, last.1, &right));
        };
        let name = one.0.unwrap_or_default();
        notes.push(format!("{} cameras are made: {name} is taken", cameras.len()));
        one
    };
    let again = cameras.iter().filter(|(name, _)| *name == chosen.0).count();
    if again > 1 && others == 0 {
        notes.push(format!("the camera is made {again} times: as it is made last is taken"));
    }
    Ok(chosen)
}

/// Every name of a thing: `this.camera = camera;` gives it another.
pub(super) fn names<'t>(code: &'t Code, name: &'t str) -> Vec<&'t str> {
    const MOST: usize = 10;
    let whole = code.whole();
    let mut names = vec![name];
    for at in words(whole, name) {
        let after = whole.text[at + name.len()..].trim_start_matches([' ', '\t', '\r']);
        let before = whole.text[..at].trim_end();
        let ends = after.is_empty() || after.starts_with([';', '\n']);
        if !ends || whole.text[..at].ends_with('.') || names.len() == MOST {
            continue;
        }
        if let Some(other) = name_before(before, "PerspectiveCamera").filter(|n| !names.contains(n))
        {
            names.push(other);
        }
    }
    names
}

/// The parts of the text that are run later, or again and again: functions that answer events, and
/// those that draw each picture.
pub(super) fn later(code: &Code) -> Later {
    const CALLERS: [&str; 6] = [
        "requestAnimationFrame",
        "setAnimationLoop",
        "addEventListener",
        "useFrame",
        "setInterval",
        "setTimeout",
    ];
    const LOOPS: [&str; 12] = [
        "animate",
        "animation",
        "render",
        "tick",
        "update",
        "loop",
        "draw",
        "frame",
        "renderLoop",
        "animationLoop",
        "updateCamera",
        "gameLoop",
    ];
    const MOST: usize = 100;
    let mut names: Vec<&str> = LOOPS.to_vec();
    let mut parts = Vec::new();
    for call in CALLERS.into_iter().flat_map(|caller| code.calls(caller)) {
        parts.push(call.at..call.at + call.text.len());
        let is_name = |text: &str| {
            !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || "_$".contains(c))
        };
        let last = split(call).into_iter().take(2).map(|part| part.text);
        for name in last.map(|name| name.strip_prefix("this.").unwrap_or(name)) {
            if is_name(name) && !names.contains(&name) && names.len() < MOST {
                names.push(name);
            }
        }
    }
    let whole = code.whole();
    for name in names {
        let mut from = 0;
        for at in words(whole, name) {
            if at >= from
                && let Some(part) = body(code, at, name.len())
            {
                from = part.end;
                parts.push(part);
            }
        }
    }
    Later::of(parts)
}

/// Parts of a text, which may overlap.
pub(super) struct Later {
    /// Where each begins, and where all up to it end, in order.
    parts: Vec<(usize, usize)>,
}

impl Later {
    fn of(mut parts: Vec<Range<usize>>) -> Later {
        parts.sort_by_key(|part| part.start);
        let mut end = 0;
        let parts = parts.into_iter().map(|part| {
            end = end.max(part.end);
            (part.start, end)
        });
        Later { parts: parts.collect() }
    }

    pub(super) fn contains(&self, at: usize) -> bool {
        let before = self.parts.partition_point(|(start, _)| *start <= at);
        self.parts[..before].last().is_some_and(|(_, end)| at < *end)
    }
}

/// The body of a function, where its name stands.
pub(super) fn body(code: &Code, at: usize, length: usize) -> Option<Range<usize>> {
    // No arguments are longer.
    const LONGEST: usize = 300;
    let whole = code.whole();
    let rest = after_spaces(whole.from(at + length));
    let open = match rest.text.chars().next()? {
        '(' => {
            let inside = code.bracketed(rest)?;
            let after = after_spaces(rest.from(inside.text.len() + 2));
            // In TypeScript the kind of its result may stand before the body.
            let kind = after.text.strip_prefix(':').map_or(0, |kind| {
                1 + kind.find(|c: char| !(c.is_alphanumeric() || c == ' ')).unwrap_or(0)
            });
            after.from(kind)
        }
        '=' | ':' => {
            let said = rest.from(1);
            let end = said.text.char_indices().take(LONGEST).find(|(_, c)| *c == ';');
            let end = end.or_else(|| said.text.char_indices().take(LONGEST).last());
            let said = Piece { text: &said.text[..end.map_or(0, |(at, _)| at)], ..said };
            let arrow = said.text.find("=>").map(|at| at + 2);
            let open = arrow.or_else(|| {
                let is_function = said.text.trim_start().starts_with("function");
                is_function.then(|| said.text.find('{')).flatten()
            })?;
            let found = after_spaces(rest.from(1 + open));
            if !found.text.starts_with('{') {
                let found = statement(found);
                return Some(found.at..found.at + found.text.len());
            }
            found
        }
        _ => return None,
    };
    let inside = open.text.starts_with('{').then(|| code.bracketed(open)).flatten()?;
    Some(inside.at..inside.at + inside.text.len())
}
