//! Calls that are handed a thing: a function may move what it is given, unseen.

use crate::exchange::code::{Code, Piece, after_spaces, is_of_word, split, trimmed, words};

/// A thing among the arguments of a call.
pub(super) struct Passed<'t> {
    /// The call, with its name.
    pub(super) call: Piece<'t>,
    /// The argument as it is written.
    pub(super) argument: &'t str,
    /// Which of the arguments it is, from 0, or its name.
    pub(super) place: String,
}

/// A call in a call in a call: no camera is handed on deeper.
const DEEPEST: usize = 16;

/// No function that is looked through is longer.
const LONGEST_BODY: usize = 10_000;

/// The last names of calls that leave what they are given where it is.
const HARMLESS: [&str; 38] = [
    "Euler",
    "Matrix",
    "Quaternion",
    "Vector",
    "abs",
    "bool",
    "copy",
    "debug",
    "deepcopy",
    "dict",
    "dist",
    "error",
    "format",
    "getattr",
    "hasattr",
    "id",
    "info",
    "isinstance",
    "len",
    "link",
    "list",
    "log",
    "max",
    "min",
    "new",
    "print",
    "remove",
    "render",
    "repr",
    "round",
    "select_set",
    "str",
    "tuple",
    "type",
    "unlink",
    "warning",
    "world_to_camera_view",
    "write",
];

/// Every argument of the calls in a piece, but of those that are known to be harmless.
pub(super) fn passed<'t>(code: &'t Code, said: Piece<'t>) -> Vec<Passed<'t>> {
    let mut found = Vec::new();
    let mut quote = None;
    let mut depth = 0_usize;
    for (at, c) in said.text.char_indices() {
        match (quote, c) {
            (None, '\'' | '"') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => depth = depth.saturating_sub(1),
            _ => (),
        }
        if quote.is_some() || c != '(' || depth > DEEPEST {
            continue;
        }
        let head = said.text[..at].trim_end();
        let start = head.trim_end_matches(is_of_path).len();
        let last = head[start..].rsplit('.').next().unwrap_or_default();
        let Some(inside) = code.bracketed(said.from(at)) else { continue };
        if last.is_empty() || HARMLESS.contains(&last) {
            continue;
        }
        let text = said.text.get(start..=inside.at - said.at + inside.text.len());
        let call = Piece { text: text.unwrap_or(last), at: said.at + start };
        for (k, argument) in split(inside).into_iter().enumerate() {
            let named = argument.text.split_once('=').filter(|(name, _)| is_name(name.trim()));
            let (place, value) = match named {
                Some((name, _)) => (name.trim().to_owned(), argument.from(name.len() + 1)),
                None => (k.to_string(), argument),
            };
            let value = trimmed(value);
            // What is in a list is handed on with it.
            let parts = match value.text.starts_with(['[', '(']).then(|| code.bracketed(value)) {
                Some(Some(list)) => split(list),
                _ => vec![value],
            };
            found.extend(parts.into_iter().map(|part| {
                let argument = part.text.trim_start_matches('*');
                Passed { call, argument, place: place.clone() }
            }));
        }
    }
    found
}

/// Whether the text has the function that is called, and it only reads what it is given there.
pub(super) fn is_only_read(code: &Code, call: Piece, place: &str) -> bool {
    let name = call.text.split('(').next().unwrap_or_default().trim();
    let whole = code.whole();
    let defined = |at: &usize| whole.text[..*at].trim_end().ends_with("def");
    let mut found = words(whole, name).into_iter().filter(defined);
    let (Some(at), None) = (found.next(), found.next()) else { return false };
    let open = after_spaces(whole.from(at + name.len()));
    let Some(inside) = code.bracketed(open) else { return false };
    let parameters = split(inside);
    let names = parameters.iter().map(|part| {
        let end = part.text.find([':', '=']).unwrap_or(part.text.len());
        part.text[..end].trim()
    });
    let parameter = match place.parse::<usize>() {
        Ok(k) => names.clone().nth(k),
        Err(_) => names.clone().find(|name| *name == place),
    };
    let Some(parameter) = parameter.filter(|name| is_name(name)) else { return false };
    let line = whole.text[..at].rfind('\n').map_or(0, |end| end + 1);
    let indent = indent_of(&whole.text[line..]);
    let body = whole.from(inside.at + inside.text.len() + 1);
    let mut end = body.text.find('\n').unwrap_or(body.text.len());
    while end < body.text.len() {
        let next = &body.text[end + 1..];
        let line = next.lines().next().unwrap_or_default();
        if !line.trim().is_empty() && indent_of(line) <= indent {
            break;
        }
        if end > LONGEST_BODY {
            return false;
        }
        end += 1 + next.find('\n').unwrap_or(next.len());
    }
    let body = Piece { text: &body.text[..end.min(body.text.len())], ..body };
    words(body, parameter).into_iter().all(|at| is_read_at(body.text, at))
}

/// Whether a number of the thing is read there, and nothing is done to the thing.
fn is_read_at(text: &str, at: usize) -> bool {
    /// What cannot be changed through another name.
    const PLAIN: [&str; 9] =
        [".x", ".y", ".z", ".w", ".name", ".lens", ".angle", ".type", ".sensor_width"];
    let rest = &text[at..];
    let end = rest.find(|c: char| !is_of_path(c)).unwrap_or(rest.len());
    let after = rest[end..].trim_start_matches([' ', '\t']);
    let before = text[..at].trim_end_matches([' ', '\t']);
    let begins = before.is_empty() || before.ends_with(['\n', ';', ':']);
    let harmless_call = before.strip_suffix('(').is_some_and(|head| {
        let last = head.rsplit(|c: char| !is_of_word(c)).next();
        last.is_some_and(|last| HARMLESS.contains(&last)) && after.starts_with(')')
    });
    let is_plain = PLAIN.iter().any(|plain| rest[..end].ends_with(plain));
    // One of several that are given something at once, outside of all brackets.
    let line = before.rsplit('\n').next().unwrap_or_default();
    let count = |sign: char| line.matches(sign).count();
    let is_target = after.starts_with('=')
        || (after.starts_with(',') && count('(') + count('[') == count(')') + count(']'));
    let is_call = after.starts_with(['(', '[']);
    !begins && (harmless_call || (is_plain && !is_call && !is_target))
}

fn indent_of(line: &str) -> usize {
    line.len() - line.trim_start_matches([' ', '\t']).len()
}

fn is_of_path(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.')
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_') && text.chars().all(is_of_word)
}
