//! What the statements of code do to a name, one after the other.

use super::names::Names;
use crate::exchange::code::{Piece, after_spaces, is_of_word, split, words};

/// What is done to a name at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'t> {
    pub(super) at: usize,
    /// Where the statement begins: what it takes is what was given before.
    pub(super) from: usize,
    /// Who the name belongs to: `cam` in `cam.K`.
    pub(super) owner: &'t str,
    pub(super) what: What<'t>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum What<'t> {
    /// The value begins here.
    Value(Piece<'t>),
    /// The value is one of several: which of how many.
    OneOf(Piece<'t>, usize, usize),
    /// The value in a call or a dictionary begins here.
    Entry(Piece<'t>),
    /// The numbers begin here, whatever commas are between them.
    Stream(Piece<'t>),
    /// Just this.
    Exact(Piece<'t>),
    /// What `cv::Rodrigues` makes of it.
    Rodrigues(Piece<'t>),
    /// An index, and what is put there: by `=`, or by a sign before it.
    Element(Piece<'t>, char, Piece<'t>),
    /// `*=` and its like.
    Step(char, Piece<'t>),
    Other,
}

impl Given<'_> {
    /// Whether it is given as a whole.
    pub(super) fn is_whole(&self) -> bool {
        !matches!(self.what, What::Element(..) | What::Step(..) | What::Other)
    }
}

impl<'t> Names<'t> {
    /// Everything that is done to a name, in order, by itself or by another name of the same numbers.
    pub(super) fn all_given(&self, name: &str) -> Vec<Given<'t>> {
        let mut all = self.stated(name);
        let mut others = self.others(name);
        all.append(&mut others);
        all.sort_by_key(|given| given.at);
        all
    }

    /// The changes by `S = R`, `S[0] = 1`, as NumPy and OpenCV do not copy what is named again.
    fn others(&self, name: &str) -> Vec<Given<'t>> {
        let whole = self.code.whole();
        let other = |at: usize| {
            let before = near_end(&whole.text[..at]);
            let target = before.trim_end().strip_suffix('=')?.trim_end();
            let start = target.trim_end_matches(is_of_word);
            let other = &target[start.len()..];
            let rest = near(&whole.text[at + name.len()..]);
            let rest = rest.split(['\n', ';']).next().unwrap_or_default().trim_end();
            let is_number = rest.starts_with('[') && rest.contains(',') && !rest.contains(':');
            let is_copy = ["copy", "clone", "astype", "dot", "inv", "tolist", "flatten"]
                .iter()
                .any(|copy| rest.contains(copy));
            let is_same = rest.is_empty() || rest.starts_with(['.', '[']);
            let is_other = !other.is_empty() && other != name && is_same && !is_number && !is_copy;
            is_other.then_some((other, at))
        };
        let mut changes = Vec::new();
        for (k, (other, at)) in words(whole, name).into_iter().filter_map(other).enumerate() {
            if k == MOST_OTHERS {
                changes.push(Given { at, from: at, owner: "", what: What::Other });
                break;
            }
            let given = self.stated(other);
            let after = given.into_iter().filter(|given| given.at > at);
            let changed = after.take_while(|given| !given.is_whole());
            changes.extend(changed.map(|given| Given { what: What::Other, owner: "", ..given }));
        }
        changes
    }

    /// Everything that is done to a name, in order: to the plain one, else to the one of one owner.
    fn stated(&self, name: &str) -> Vec<Given<'t>> {
        let whole = self.code.whole();
        let mut all: Vec<Given> =
            words(whole, name).into_iter().filter_map(|at| self.one_given(name, at)).collect();
        all.extend(self.written_by_calls(name));
        all.sort_by_key(|given| given.at);
        let is_entry =
            |given: &Given| matches!(given.what, What::Entry(_)) && self.in_call(given.at);
        let is_plain = |given: &Given| given.owner.is_empty() && !is_entry(given);
        if all.iter().any(|given| is_plain(given) && given.is_whole()) {
            all.retain(is_plain);
        } else if let Some(first) =
            all.iter().find(|given| given.is_whole()).map(|given| given.owner)
        {
            // Of several owners, none is the one.
            let alone =
                all.iter().filter(|given| given.is_whole()).all(|given| given.owner == first);
            all.retain(|given| alone && given.owner == first);
        }
        all
    }

    fn in_call(&self, at: usize) -> bool {
        self.innermost(at).is_some_and(|(_, kind)| kind == b'(')
    }

    /// What functions write into an argument: of `cv::Rodrigues` it is known what.
    fn written_by_calls(&self, name: &str) -> Vec<Given<'t>> {
        let mut given = Vec::new();
        for (function, from) in WRITERS {
            for call in self.code.calls(function) {
                let parts = split(call);
                let Some(place) = parts.iter().skip(from).position(|part| part.text == name) else {
                    continue;
                };
                let what = match (function, place) {
                    ("Rodrigues", 0) => What::Rodrigues(parts[0]),
                    _ => What::Other,
                };
                let at = call.at.saturating_sub(1);
                given.push(Given { at, from: at, owner: "", what });
            }
        }
        given
    }

    fn one_given(&self, name: &str, at: usize) -> Option<Given<'t>> {
        let whole = self.code.whole();
        let (before, rest) = (&whole.text[..at], whole.from(at + name.len()));
        if let Some(quote) = before.chars().next_back().filter(|c| matches!(c, '"' | '\''))
            && rest.text.starts_with(quote)
        {
            return quoted(before, rest.from(1)).map(|what| Given {
                at,
                from: at,
                owner: "",
                what,
            });
        }
        // No statement begins further before.
        let near = near_end(before);
        let path = near.trim_end_matches(|c: char| c.is_alphanumeric() || "_.->:".contains(c));
        let path = near[path.len()..].trim_start_matches(['-', '>', ':']);
        let owner = path.strip_suffix('.').or_else(|| path.strip_suffix("->"));
        if owner.is_none() && !path.is_empty() {
            return None;
        }
        let head = &near[..near.len() - path.len()];
        let start = head.rfind(['\n', ';', '{', '}']).map(|end| end + 1);
        if start.is_none() && near.len() < before.len() {
            return None;
        }
        let owner = owner.filter(|owner| !["self", "this"].contains(owner)).unwrap_or_default();
        let head = &head[start.unwrap_or(0)..];
        let what = self.done(head, after_spaces_in_line(rest), at)?;
        Some(Given { at, from: at - path.len() - head.len(), owner, what })
    }

    /// What is done by a statement, by what stands before the name and after it.
    fn done(&self, head: &str, rest: Piece<'t>, at: usize) -> Option<What<'t>> {
        let first = rest.text.chars().next()?;
        let value = |skipped: usize| after_spaces(rest.from(skipped));
        let is_given = is_assigned(rest.text);
        let opens_entry = |head: &str| {
            let head = head.trim();
            head.is_empty() || head.ends_with(',') || head.ends_with('(')
        };
        if self.in_call(at) {
            // np.negative(R, out=R)
            let argument = head.trim_end().strip_suffix('=').unwrap_or_default().trim_end();
            let is_written = ["out", "dst"].iter().any(|name| argument.ends_with(name));
            let entry = || (is_given && opens_entry(head)).then(|| What::Entry(value(1)));
            return if is_written { Some(What::Other) } else { entry() };
        }
        let is_head = |c: char| c.is_alphanumeric() || "_ \t:<>*&,.".contains(c);
        let word = head.split_whitespace().next().unwrap_or_default().trim_end_matches(':');
        if CONDITIONS.contains(&word) || !head.chars().all(is_head) {
            let is_entry = first == ':' && opens_entry(head);
            // double fx = 500, fy = 510; is a list, too.
            let is_listed = is_given && head.trim_end().ends_with(',');
            let is_run_over = word == "for" && rest.text.starts_with("in ");
            return match is_entry || is_listed {
                true => Some(What::Entry(value(1))),
                false => (is_given || is_run_over).then_some(What::Other),
            };
        }
        let is_bare = head.trim().is_empty();
        if is_given {
            let place = head.matches(',').count();
            return Some(match place {
                0 => What::Value(value(1)),
                _ => What::OneOf(value(1), place, place + 1),
            });
        }
        match first {
            ':' if opens_entry(head) && !rest.text.starts_with("::") => {
                Some(annotated(rest).map_or_else(|| What::Entry(value(1)), What::Value))
            }
            ',' => targets(head, rest),
            '[' | '(' if is_bare => self.element(rest),
            '[' => {
                // double K[3][3] = {
                let end = near(rest.text).find(['=', ';', '\n'])?;
                is_assigned(&rest.text[end..]).then(|| What::Value(value(end + 1)))
            }
            '(' if NO_TYPES.contains(&word) => None,
            '(' => self.code.bracketed(rest).map(What::Exact),
            '.' if is_bare => self.method(rest),
            '<' if is_bare && rest.text.starts_with("<<") => Some(What::Stream(value(2))),
            '+' | '-' | '*' | '/' if is_bare && is_assigned(&rest.text[1..]) => {
                Some(What::Step(first, value(2)))
            }
            '@' if is_assigned(&rest.text[1..]) => Some(What::Other),
            _ => None,
        }
    }

    /// `[0, 2] = 320`, `[0][2] = 320`, `(0, 2) = 320`.
    fn element(&self, rest: Piece<'t>) -> Option<What<'t>> {
        let first = self.code.bracketed(rest)?;
        let mut after = rest.from(first.text.len() + 2);
        if let Some(second) = self.code.bracketed(after) {
            after = after.from(second.text.len() + 2);
        }
        let index = Piece { text: &rest.text[1..after.at - rest.at - 1], at: rest.at + 1 };
        let after = after_spaces(after);
        if is_assigned(after.text) {
            return Some(What::Element(index, '=', after_spaces(after.from(1))));
        }
        if let Some(sign @ ('+' | '-' | '*' | '/')) = after.text.chars().next()
            && is_assigned(&after.text[1..])
        {
            return Some(What::Element(index, sign, after_spaces(after.from(2))));
        }
        let end = near(after.text).find(['=', '\n', ';'])?;
        is_assigned(&after.text[end..]).then_some(What::Other)
    }

    /// `.at<double>(0, 2) = 320`, or whatever else is given a value or changes it.
    fn method(&self, rest: Piece<'t>) -> Option<What<'t>> {
        let near = near(rest.text);
        let name = near[1..].split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if name == "at"
            && let Some(open) = near.find('(')
            && let Some(element) = self.element(rest.from(open))
        {
            return Some(element);
        }
        let end = near.find(['=', '\n', ';', '(']).unwrap_or(near.len());
        let changes = CHANGING.contains(&name) || is_assigned(&rest.text[end..]);
        changes.then_some(What::Other)
    }
}

/// So many other names of the same numbers are followed; with more, a name is not understood.
const MOST_OTHERS: usize = 8;

/// Words at which a statement begins that holds sometimes only.
const CONDITIONS: [&str; 14] = [
    "if", "else", "elif", "for", "while", "case", "switch", "try", "except", "catch", "return",
    "assert", "lambda", "def",
];

/// Words before a name and a bracket that are no type.
const NO_TYPES: [&str; 12] = [
    "return", "def", "class", "if", "elif", "while", "assert", "print", "await", "yield", "throw",
    "not",
];

/// Methods that change what they belong to.
const CHANGING: [&str; 8] =
    ["fill", "setTo", "itemset", "put", "sort", "resize", "setIdentity", "convertTo"];

/// Functions that write into their arguments, and from which one on.
const WRITERS: [(&str, usize); 7] = [
    ("Rodrigues", 1),
    ("solvePnP", 4),
    ("solvePnPRansac", 4),
    ("solvePnPRefineLM", 4),
    ("calibrateCamera", 3),
    ("fill_diagonal", 0),
    ("copyto", 0),
];

/// What stands behind a name in quotes: `"K": ...`, `d["K"] = ...`.
fn quoted<'t>(before: &str, rest: Piece<'t>) -> Option<What<'t>> {
    let rest = after_spaces(rest);
    if rest.text.starts_with(':') {
        return Some(What::Entry(after_spaces(rest.from(1))));
    }
    let is_index = before[..before.len() - 1].ends_with('[') && rest.text.starts_with(']');
    let after = after_spaces(rest.from(usize::from(is_index)));
    (is_index && is_assigned(after.text)).then(|| What::Value(after_spaces(after.from(1))))
}

/// `: np.ndarray = value`.
fn annotated(rest: Piece<'_>) -> Option<Piece<'_>> {
    let line = near(rest.text).split('\n').next().unwrap_or_default();
    let end = line.find('=')?;
    let kind = line[1..end].trim();
    let is_kind = |c: char| c.is_alphanumeric() || "_.[], |\"'".contains(c);
    let begins = kind.starts_with(|c: char| c.is_alphabetic() || matches!(c, '"' | '\''));
    let is_given = begins && kind.chars().all(is_kind) && is_assigned(&rest.text[end..]);
    is_given.then(|| after_spaces(rest.from(end + 1)))
}

/// The others of `a, b = ...`.
fn targets<'t>(head: &str, rest: Piece<'t>) -> Option<What<'t>> {
    let is_target = |c: char| c.is_alphanumeric() || "_., *\t".contains(c);
    let end = near(rest.text).find(|c: char| !is_target(c))?;
    if !is_assigned(&rest.text[end..]) {
        return None;
    }
    let place = head.matches(',').count();
    let count = place + 1 + rest.text[..end].matches(',').count();
    Some(What::OneOf(after_spaces(rest.from(end + 1)), place, count))
}

pub(super) fn is_assigned(text: &str) -> bool {
    text.starts_with('=') && !text[1..].starts_with(['=', '>'])
}

fn after_spaces_in_line(piece: Piece) -> Piece {
    piece.from(piece.text.len() - piece.text.trim_start_matches([' ', '\t']).len())
}

/// The last characters.
fn near_end(text: &str) -> &str {
    let mut from = text.len().saturating_sub(200);
    while !text.is_char_boundary(from) {
        from += 1;
    }
    &text[from..]
}

/// The next characters; what is looked for is among them.
pub(super) fn near(text: &str) -> &str {
    let mut end = text.len().min(200);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    &text[..end]
}
