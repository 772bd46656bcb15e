//! What names stand for in code, without running it: one that is given a value once and is changed
//! nowhere is that value.

use std::cell::RefCell;
use std::collections::HashMap;

use super::code::{Code, Piece, after_spaces, number, split, statement, trimmed, words};

/// A statement that gives a name a value, or changes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Assignment<'t> {
    /// What the name belongs to: `cam.data` in `cam.data.lens = 50`, nothing for a plain name.
    pub(crate) owner: &'t str,
    /// Where the statement's name stands.
    pub(crate) at: usize,
    /// The value; `None` where only a part is changed, as by `x += 1`, `K[0, 2] = 320` or `p.x = 1`.
    pub(crate) value: Option<Piece<'t>>,
}

/// How a plain name is given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Given<'t> {
    /// By no statement.
    Never,
    /// By one, and nothing changes it.
    Once(Piece<'t>),
    /// By several, or something changes a part of it.
    Changed,
}

/// What was worked out of names.
#[derive(Debug, Default)]
pub(crate) struct Known(RefCell<HashMap<String, Option<Vec<f64>>>>);

/// So many names are looked up: each one takes a pass over the text.
const MOST_NAMES: usize = 500;

/// So many statements are looked for that give one name a value: each may go to the end of the text.
pub(crate) const MOST_ASSIGNMENTS: usize = 100;

/// No statement has more characters before the name, or between it and the sign.
const LONGEST_HEAD: usize = 500;

impl Code<'_> {
    /// Every statement that gives this name a value or changes it, in the order of the text: `x = 1`,
    /// `const float x = 1.0f;`, `a.x = 1`, `x, y = 1, 2`, `vec3 x(1, 2, 3);`, `#define x 1`. An argument
    /// by name in a call is none. No more than [`MOST_ASSIGNMENTS`] are looked for.
    pub(crate) fn assignments(&self, name: &str) -> Vec<Assignment<'_>> {
        let whole = self.whole();
        let found = words(whole, name).into_iter();
        found.filter_map(|at| assignment(self, whole, name, at)).take(MOST_ASSIGNMENTS).collect()
    }

    /// How a plain name, or a path such as `this.fov`, is given.
    pub(crate) fn given(&self, name: &str) -> Given<'_> {
        let mut given = Given::Never;
        for assignment in self.assignments(name).iter().filter(|found| found.owner.is_empty()) {
            given = match (given, assignment.value) {
                (Given::Never, Some(value)) => Given::Once(value),
                _ => return Given::Changed,
            };
        }
        match (given, name.strip_prefix("this.")) {
            (Given::Never, Some(field)) => self.field_of_class(field),
            _ => given,
        }
    }

    /// What `private width = 1280;` in a class gives `this.width`.
    fn field_of_class(&self, name: &str) -> Given<'_> {
        let whole = self.whole();
        let found = self.assignments(name);
        let mut own = found.iter().filter(|found| found.owner.is_empty());
        let (Some(Assignment { at, value: Some(value), .. }), None) = (own.next(), own.next())
        else {
            return Given::Never;
        };
        let around = self.brackets.iter().take_while(|(open, _)| open < at);
        let Some((open, _)) = around.filter(|(_, close)| close > at).last() else {
            return Given::Never;
        };
        let before = &whole.text[..*open];
        let head = before.rsplit([';', '{', '}', '\n']).next().unwrap_or_default();
        let is_class = !words(Piece { text: head, at: 0 }, "class").is_empty();
        if is_class { Given::Once(*value) } else { Given::Never }
    }

    /// The numbers of a piece with names in it: those of the one name that it is, or what it comes to
    /// with a number for every name.
    pub(crate) fn numbers_by_names(&self, piece: Piece, deeper: usize) -> Option<Vec<f64>> {
        let text = piece.text.trim();
        if names_in(text).next() == Some(0..text.len()) {
            return self.numbers_of_name(text, deeper);
        }
        let (mut plain, mut from) = (String::new(), 0);
        for name in names_in(text) {
            let followed = text[name.end..].trim_start();
            let number = match followed.starts_with('(') {
                true => None,
                false => self.numbers_of_name(&text[name.clone()], deeper),
            };
            if let Some([number]) = number.as_deref() {
                plain.push_str(&text[from..name.start]);
                plain.push_str(&format!("({number:?})"));
                from = name.end;
            }
        }
        plain.push_str(&text[from..]);
        (from > 0).then(|| number(&plain).map(|number| vec![number]))?
    }

    fn numbers_of_name(&self, name: &str, deeper: usize) -> Option<Vec<f64>> {
        let known = &self.known.0;
        if let Some(known) = known.borrow().get(name) {
            return known.clone();
        }
        if known.borrow().len() == MOST_NAMES {
            return None;
        }
        // Whatever is made of itself comes to nothing.
        known.borrow_mut().insert(name.to_owned(), None);
        let Given::Once(value) = self.given(name) else { return None };
        let mut numbers = Vec::new();
        self.collect(name, value, deeper, &mut numbers).ok()?;
        known.borrow_mut().insert(name.to_owned(), Some(numbers.clone()));
        Some(numbers)
    }
}

/// Where names stand in an expression, paths such as `this.fov` whole.
fn names_in(text: &str) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = &text[at..];
            let c = rest.chars().next()?;
            let end = rest.find(|c: char| !is_of_path(c)).unwrap_or(rest.len()).max(c.len_utf8());
            let from = at;
            at += end;
            if c.is_alphabetic() || c == '_' {
                return Some(from..at);
            }
        }
    })
}

fn is_of_path(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.' | '$')
}

fn assignment<'t>(
    code: &'t Code,
    whole: Piece<'t>,
    name: &str,
    at: usize,
) -> Option<Assignment<'t>> {
    let before = &whole.text[..at];
    let path = before.trim_end_matches(is_of_path);
    let owner = before[path.len()..].strip_suffix('.');
    if owner.is_none() && path.len() < before.len() {
        return None;
    }
    let mut back = path.char_indices().rev().take(LONGEST_HEAD);
    let start = back.find(|(_, c)| matches!(c, '\n' | ';' | '{' | '}'));
    if start.is_none() && back.next().is_none() && path.len() > LONGEST_HEAD {
        return None;
    }
    let head = &path[start.map_or(0, |(end, _)| end + 1)..];
    let rest = whole.from(at + name.len());
    if head.trim() == "#define" {
        let end = rest.text.find('\n').unwrap_or(rest.text.len());
        let value = trimmed(Piece { text: &rest.text[..end], ..rest });
        return Some(Assignment { owner: "", at, value: Some(value) });
    }
    if is_after_others(path) {
        let sign = after_spaces(rest);
        let is_given = sign.text.starts_with('=') && !sign.text[1..].starts_with(['=', '>']);
        let value = is_given.then(|| own_value(statement(after_spaces(sign.from(1)))))?;
        return owner.is_none().then_some(Assignment { owner: "", at, value: Some(value) });
    }
    let owner = owner.unwrap_or_default();
    let is_head = |c: char| is_of_path(c) || " \t:<>*&,#".contains(c);
    if !head.chars().all(is_head) || head.trim() == "return" {
        return None;
    }
    let place = head.chars().filter(|c| *c == ',').count();
    let value = value_given(code, after_spaces(rest), place, !head.trim().is_empty())?;
    Some(Assignment { owner, at, value })
}

/// Whether a name follows others that are given a value in the same statement: `double x = 1, y = 2;`,
/// also over lines, or `x = y = 3`.
fn is_after_others(path: &str) -> bool {
    let is_head = |c: char| is_of_path(c) || " \t:<>*&#=".contains(c);
    let end = path.trim_end();
    let first = end.char_indices().rev().take(LONGEST_HEAD).last().map_or(0, |(at, _)| at);
    let (end, is_cut) = (&end[first..], first > 0);
    if end.ends_with('=') {
        let start = end.rfind(['\n', ';', '{', '}']);
        if start.is_none() && is_cut {
            return false;
        }
        let head = &end[start.map_or(0, |at| at + 1)..];
        let is_chain = |part: &str| part.trim().chars().next_back().is_some_and(is_of_path);
        let mut parts = head.strip_suffix('=').unwrap_or(head).split('=');
        return head.chars().all(is_head) && parts.all(is_chain);
    }
    if !end.ends_with(',') {
        return false;
    }
    // The statement begins where a line does not follow a comma.
    let mut depth = 0_i32;
    let mut start = None;
    for (at, c) in end.char_indices().rev() {
        match c {
            ')' | ']' => depth += 1,
            '(' | '[' => depth -= 1,
            ';' | '{' | '}' => start = Some(at + 1),
            '\n' if depth == 0 && !end[..at].trim_end().ends_with([',', '=']) => {
                start = Some(at + 1);
            }
            _ => (),
        }
        if depth < 0 {
            return false;
        }
        if start.is_some() {
            break;
        }
    }
    if start.is_none() && is_cut {
        return false;
    }
    let head = end[start.unwrap_or(0)..].split('=').next().unwrap_or_default();
    // A declaration has a kind before the name.
    let has_kind = head.split_whitespace().count() > 1;
    has_kind && end[start.unwrap_or(0)..].contains('=') && head.chars().all(is_head)
}

/// The value itself where others follow: `1` of `1, y = 2`, and `3` of `y = 3`.
fn own_value(mut value: Piece) -> Piece {
    let name_of = |text: &str| {
        let sign = text.find('=')?;
        let is_sign = !text[sign + 1..].starts_with(['=', '>']);
        let name = text[..sign].trim_end();
        let begins = name.starts_with(|c: char| c.is_alphabetic() || "_$".contains(c));
        (is_sign && begins && name.chars().all(is_of_path)).then_some(sign)
    };
    while let Some(sign) = name_of(value.text) {
        value = after_spaces(value.from(sign + 1));
    }
    match split(value)[..] {
        [first] if value.text.ends_with(',') => first,
        [first, second, ..] if name_of(second.text).is_some() => first,
        _ => value,
    }
}

/// How many numbers a list stands for that has so many in its brackets: GLM's `vec3(1)` has three,
/// and so has `new THREE.Vector3()`.
pub(super) fn filled(list: Piece, inside: Piece, count: usize) -> usize {
    let head = list.text[..inside.at.saturating_sub(list.at + 1)].trim();
    let kind = head.rsplit(['.', ':', ' ']).next().unwrap_or_default();
    match (kind, count) {
        ("vec2" | "dvec2", 1) => 2,
        ("vec3" | "dvec3", 1) => 3,
        ("vec4" | "dvec4", 1) => 4,
        ("Vector3", 0) if head.starts_with("new ") => 3,
        _ => count,
    }
}

/// What follows a name at which a statement begins: the value that it is given, `Some(None)` where a
/// part of it is changed, and `None` where nothing is done to it.
fn value_given<'t>(
    code: &'t Code,
    rest: Piece<'t>,
    place: usize,
    has_type: bool,
) -> Option<Option<Piece<'t>>> {
    let first = rest.text.chars().next()?;
    if first == '(' {
        // vec3 eye(1, 2, 3);
        return (has_type && place == 0).then(|| code.bracketed(rest)).flatten().map(Some);
    }
    // The others of a, b = 1, 2; what kind of thing it is; a part of it.
    let mut left = rest;
    let (mut is_part, mut is_word_next) = (false, false);
    loop {
        let next = left.text.chars().next()?;
        if left.at - rest.at > LONGEST_HEAD {
            return None;
        }
        left = match next {
            '=' if left.text[1..].starts_with(['=', '>']) => return None,
            '=' => break,
            '[' => {
                is_part = true;
                let inside = code.bracketed(left)?;
                left.from(inside.text.len() + 2)
            }
            '.' => {
                (is_part, is_word_next) = (true, true);
                left.from(1)
            }
            '+' | '-' | '*' | '/' if left.text[1..].starts_with('=') => {
                is_part = true;
                left.from(1)
            }
            ',' | ':' => {
                is_word_next = true;
                left.from(1)
            }
            ' ' | '\t' => left.from(1),
            // Two words in a row are a kind and the name of what is of it: float in float x = 1.
            c if is_word_next && (c == '_' || c.is_alphanumeric()) => left.from(c.len_utf8()),
            _ => return None,
        };
    }
    if is_part {
        return Some(None);
    }
    let others = rest.text[..left.at - rest.at].chars().filter(|c| *c == ',').count();
    let value = statement(after_spaces(left.from(1)));
    if place + others == 0 {
        return Some(Some(own_value(value)));
    }
    // As many values as names, or one that is taken apart: what each gets is not known.
    let values = split(value);
    Some((values.len() == place + others + 1).then(|| values[place]))
}
