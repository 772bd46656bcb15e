//! What code gives a name, statement after statement: a value, an element of it, or a change that is
//! not understood, which makes the name unreadable.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use super::Index;
use super::Matrix;
use super::code::evaluate;
use super::statements::{Given, What, near};
use crate::exchange::code::{Code, Comments, Piece, split, statement, trimmed};

/// So many names are looked up: each one takes a pass over the text.
const MOST_NAMES: usize = 200;

/// So many changes of one name are followed, and so many values worked out.
const MOST_STEPS: usize = 100;
const MOST_VALUES: usize = 5000;

/// The names of a text.
pub(in crate::exchange) struct Names<'t> {
    pub(in crate::exchange) code: &'t Code<'t>,
    comments: Comments,
    /// Which bracket is the innermost one that is open, from each place on.
    open: Vec<(usize, Option<(usize, u8)>)>,
    given: RefCell<HashMap<String, Rc<Vec<Given<'t>>>>>,
    /// By where a value is given.
    values: RefCell<HashMap<(usize, usize), Option<Matrix>>>,
}

/// What a name is given, and what is not understood of it.
#[derive(Clone, Debug)]
pub(in crate::exchange) struct Found<'t> {
    /// Where it is given last as a whole.
    pub(in crate::exchange) piece: Piece<'t>,
    /// The value, or what of it cannot be read.
    pub(in crate::exchange) value: Result<Matrix, String>,
}

impl<'t> Names<'t> {
    pub(in crate::exchange) fn new(code: &'t Code<'t>, comments: Comments) -> Names<'t> {
        Names {
            code,
            comments,
            open: innermost(code.whole().text),
            given: RefCell::default(),
            values: RefCell::default(),
        }
    }

    /// What the text gives this name in the end; `None` where it gives it nothing.
    pub(in crate::exchange) fn find(&self, name: &str) -> Option<Found<'t>> {
        let given = self.given(name);
        self.found(&given, given.len(), super::code::DEEPEST)
    }

    /// What a name stands for at a place: what it is given last before it, or all that it is given.
    pub(in crate::exchange) fn value_at(
        &self,
        name: &str,
        before: usize,
        depth: usize,
    ) -> Option<Matrix> {
        let given = self.given(name);
        let own = given.first().is_some_and(|given| given.owner.is_empty());
        let mut count = given.partition_point(|given| given.at < before);
        if count == 0 && given.len() == 1 {
            count = 1;
        }
        self.found(&given[..count], count, depth).filter(|_| own)?.value.ok()
    }

    fn given(&self, name: &str) -> Rc<Vec<Given<'t>>> {
        if let Some(known) = self.given.borrow().get(name) {
            return Rc::clone(known);
        }
        let full = self.given.borrow().len() == MOST_NAMES;
        let found = Rc::new(if full { Vec::new() } else { self.all_given(name) });
        self.given.borrow_mut().insert(name.to_owned(), Rc::clone(&found));
        found
    }

    fn found(&self, given: &[Given<'t>], count: usize, depth: usize) -> Option<Found<'t>> {
        let last = given[..count].iter().rposition(Given::is_whole)?;
        let whole = given[last];
        let piece = self.piece(whole.what);
        let key = (whole.at, count);
        let known = self.values.borrow().get(&key).cloned();
        if let Some(Some(value)) = known {
            return Some(Found { piece, value: Ok(value) });
        }
        if self.values.borrow().len() > MOST_VALUES {
            return Some(Found { piece, value: Err("it is made of too many names".to_owned()) });
        }
        // Whatever is made of itself comes to nothing.
        self.values.borrow_mut().insert(key, None);
        let value = match known {
            Some(_) => Err("it is not understood here".to_owned()),
            None => self.changed(&given[..count], last, depth),
        };
        self.values.borrow_mut().insert(key, value.as_ref().ok().cloned());
        Some(Found { piece, value })
    }

    /// The value that is given last as a whole, with what is done to it after that.
    fn changed(&self, given: &[Given<'t>], last: usize, depth: usize) -> Result<Matrix, String> {
        let shown = |piece: Piece| {
            let text: Vec<&str> = piece.text.split_whitespace().collect();
            let text: String = text.join(" ").chars().take(60).collect();
            format!("{text} is not understood here")
        };
        let line = |at: usize| self.code.whole().text[..at].matches('\n').count() + 1;
        let follows = |pair: &[Given]| self.follows(pair[0].at, pair[1].at);
        let steps = &given[last + 1..];
        if steps.len() > MOST_STEPS {
            return Err("it is changed too often to be followed".to_owned());
        }
        if last > 0 && !follows(&given[last - 1..=last]) {
            let (a, b) = (line(given[last - 1].at), line(given[last].at));
            return Err(format!("it is given in lines {a} and {b}, and only one of them may hold"));
        }
        let whole = given[last];
        let depth = depth.checked_sub(1).ok_or("it is made of too many names")?;
        let piece = self.piece(whole.what);
        let read = |piece: Piece<'t>, at: usize| evaluate(self, piece, at, depth).map_err(shown);
        let mut value = match whole.what {
            What::OneOf(_, 0, 2) if is_rodrigues(piece) && split(piece).len() == 1 => {
                read(piece, whole.from)?
            }
            What::OneOf(_, place, count) => {
                let parts = split(piece);
                match parts.len() == count {
                    true => read(parts[place], whole.from)?,
                    false => {
                        let all = read(piece, whole.from)?;
                        let part = all.at(&[Index::At(place as i64)]);
                        let part = part.filter(|_| all.length() == Some(count));
                        part.ok_or_else(|| shown(piece))?
                    }
                }
            }
            What::Rodrigues(_) => {
                read(piece, whole.from)?.rodrigues().ok_or_else(|| shown(piece))?
            }
            _ => read(piece, whole.from)?,
        };
        for step in steps {
            let not = || format!("line {} changes it in a way not understood here", line(step.at));
            if !self.follows(whole.at, step.at) {
                return Err(not());
            }
            value = match step.what {
                What::Element(index, sign, by) => {
                    let by = read(statement(by), step.from)?;
                    let index = super::code::index(self, index, step.from, depth);
                    let index = index.ok_or_else(not)?;
                    let by = match sign {
                        '=' => Some(by),
                        _ => value.at(&index).and_then(|old| old.combined(sign, &by)),
                    };
                    by.and_then(|by| value.with(&index, &by)).ok_or_else(not)?
                }
                What::Step(sign, by) => {
                    let by = read(statement(by), step.from)?;
                    value.combined(sign, &by).ok_or_else(not)?
                }
                _ => return Err(not()),
            };
        }
        Ok(value)
    }

    fn piece(&self, what: What<'t>) -> Piece<'t> {
        match what {
            What::Value(from) => {
                let piece = statement(from);
                // double fx = 500, fy = 510;
                match split(piece).first() {
                    Some(first) if self.comments == Comments::Slashes => *first,
                    _ => piece,
                }
            }
            What::OneOf(from, ..) | What::Stream(from) => statement(from),
            What::Entry(from) => self.entry(from),
            What::Exact(piece)
            | What::Rodrigues(piece)
            | What::Element(.., piece)
            | What::Step(_, piece) => piece,
            What::Other => self.code.whole().from(self.code.whole().text.len()),
        }
    }

    /// Up to the comma or bracket at which an entry of a call or a dictionary ends, or the line's end.
    fn entry(&self, from: Piece<'t>) -> Piece<'t> {
        // cv::FileStorage's YAML, and that of ROS: a matrix has its numbers behind its sizes.
        let tag = from.text.strip_prefix("!!opencv-matrix").unwrap_or(from.text);
        let head = near(tag).split('[').next().unwrap_or_default();
        let is_sizes = |c: char| c.is_alphanumeric() || " \r\n\t:,{\"-_".contains(c);
        let is_data = ["data:", "data\":"].iter().any(|data| head.trim_end().ends_with(data));
        let is_matrix = is_data && head.chars().all(is_sizes);
        let skipped = from.text.len() - tag.len() + head.len();
        let from = if is_matrix { from.from(skipped) } else { from };
        if let Some(inside) = self.code.bracketed(from).filter(|_| from.text.starts_with('['))
            && let whole = &from.text[..inside.text.len() + 2]
            && is_ended(&from.text[whole.len()..])
        {
            return Piece { text: whole, ..from };
        }
        let piece = statement(from);
        let first = split(piece).first().copied().unwrap_or(piece);
        trimmed(first)
    }

    /// Whether what stands at `later` is always reached after `earlier`, as far as brackets and, in
    /// Python and YAML, indentation tell.
    fn follows(&self, earlier: usize, later: usize) -> bool {
        let text = self.code.whole().text;
        match self.innermost(later) {
            Some((open, _)) => open < earlier,
            None if self.comments == Comments::Hash => {
                let start = |at: usize| text[..at].rfind('\n').map_or(0, |end| end + 1);
                let indented = |line: &str| line.len() - line.trim_start().len();
                let own = indented(&text[start(later)..]);
                let between = text[start(earlier)..start(later)].lines();
                let mut between = between.filter(|line| !line.trim().is_empty());
                between.all(|line| indented(line) >= own)
            }
            None => true,
        }
    }

    pub(in crate::exchange) fn innermost(&self, at: usize) -> Option<(usize, u8)> {
        let next = self.open.partition_point(|(from, _)| *from <= at);
        self.open.get(next.checked_sub(1)?)?.1
    }
}

/// The innermost open bracket from each place on. Brackets in strings of one line are none.
fn innermost(text: &str) -> Vec<(usize, Option<(usize, u8)>)> {
    let bytes = text.as_bytes();
    let (mut all, mut open) = (Vec::new(), Vec::new());
    let mut at = 0;
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'(' | b'[' | b'{' => {
                open.push((at, *byte));
                all.push((at + 1, open.last().copied()));
            }
            b')' | b']' | b'}' => {
                open.pop();
                all.push((at + 1, open.last().copied()));
            }
            b'"' | b'\'' => {
                let end = bytes[at + 1..].iter().position(|b| b == byte || *b == b'\n');
                let end = end.map(|end| at + 1 + end).filter(|end| bytes[*end] == *byte);
                at = end.unwrap_or(at);
            }
            _ => (),
        }
        at += 1;
    }
    all
}

fn is_rodrigues(piece: Piece) -> bool {
    let function = piece.text.split('(').next().unwrap_or_default();
    ["cv2.Rodrigues", "cv.Rodrigues"].contains(&function.trim())
}

fn is_ended(text: &str) -> bool {
    let text = text.trim_start_matches([' ', '\t', '\r']);
    text.is_empty() || text.starts_with(['\n', ',', ';', '}', ']', ')'])
}
