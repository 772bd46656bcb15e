//! The statements of a text: calls, names that are given a value, and numbers that stand alone.

use crate::programs::pieces::Piece;

/// A statement.
#[derive(Debug, Default)]
pub(crate) struct Statement {
    /// Byte at which it begins.
    pub(crate) at: usize,
    /// Its text.
    pub(crate) text: String,
    /// Name that is given the value, as `view` in `glm::mat4 view = ...`; empty without one.
    pub(crate) target: String,
    /// Function that is called; empty where nothing is.
    pub(crate) called: String,
    /// True where `new` stands before the call.
    pub(crate) is_new: bool,
    /// Arguments of the call, or values.
    pub(crate) arguments: Vec<Argument>,
}

/// An argument, or a value.
#[derive(Debug)]
pub(crate) struct Argument {
    /// Byte at which it begins.
    pub(crate) at: usize,
    /// Its text.
    pub(crate) text: String,
    /// Its numbers, brackets regardless; `None` where it is not literal.
    pub(crate) numbers: Option<Vec<f64>>,
    /// The angle in degrees of `radians(...)`, which has no numbers.
    pub(crate) degrees: Option<f64>,
}

/// Functions that make a list or a vector of their numbers and do nothing else.
const MAKERS: [&str; 10] = [
    "vec3", "dvec3", "Vec3", "Vector3", "point3", "array", "asarray", "Matrix", "Vector", "SVector",
];

/// Functions that take an angle in degrees to radians.
const RADIANS: [&str; 4] = ["radians", "deg2rad", "degToRad", "DegToRad"];

/// Words that may stand before the name of a variable.
const DECLARATIONS: [&str; 8] =
    ["const", "let", "var", "auto", "static", "export", "mat4", "glm::mat4"];

/// Directives by which lines are left out, which cannot be told without running them.
const DIRECTIVES: [&str; 4] = ["#if", "#el", "#end", "#define"];

/// Last part of a name: `vec3` of `glm::vec3`.
pub(crate) fn last_segment(name: &str) -> &str {
    name.rsplit(['.', ':']).next().unwrap_or_default()
}

/// Returns the text with blanks in the places of its comments, byte by byte.
///
/// # Errors
/// Returns the byte of a comment that may be a division, and what would be right.
pub(super) fn without_comments(text: &str) -> Result<String, (usize, &'static str)> {
    let mut plain = String::with_capacity(text.len());
    while let Some(c) = text[plain.len()..].chars().next() {
        let rest = &text[plain.len()..];
        let is_directive = DIRECTIVES.iter().any(|directive| rest.starts_with(directive));
        let blank = if rest.starts_with("//") || c == '#' && !is_directive {
            rest.find('\n').unwrap_or(rest.len())
        } else if let Some(inside) = rest.strip_prefix("/*") {
            inside.find("*/").map_or(rest.len(), |end| end + 4)
        } else if c == '\u{feff}' {
            c.len_utf8()
        } else {
            plain.push(c);
            continue;
        };
        let divides = || {
            let before = plain.trim_end_matches([' ', '\t']);
            before.ends_with(|c: char| c.is_ascii_digit() || c == '.')
        };
        if rest.starts_with("//") && divides() {
            let right = "a number must not stand before //, which may divide it, as in Python";
            return Err((plain.len(), right));
        }
        plain.extend(std::iter::repeat_n(' ', blank));
    }
    Ok(plain)
}

/// Splits a text without comments into its statements; the error is the byte at fault and what would be
/// right.
pub(super) fn statements<'r>(
    plain: &str,
    right: &'r str,
) -> Result<Vec<Statement>, (usize, &'r str)> {
    let (mut open, mut pieces): (Vec<(usize, char)>, Vec<Piece>) = Default::default();
    let (mut from, mut last, whole) = (0, ' ', Piece { text: plain, at: 0 });
    for (at, c) in plain.char_indices() {
        match c {
            '(' => open.push((at, ')')),
            '[' => open.push((at, ']')),
            '{' => open.push((at, '}')),
            ')' | ']' | '}' if open.pop_if(|(_, close)| *close == c).is_none() => {
                return Err((at, "no bracket is open that it closes"));
            }
            // A statement goes on in brackets, and on the line behind what asks for more.
            ';' | '\n' if open.is_empty() && (c == ';' || !"=,:".contains(last)) => {
                pieces.push(whole.until(at).from(from));
                from = at + 1;
            }
            _ => (),
        }
        if !c.is_whitespace() {
            last = c;
        }
    }
    if let Some((at, _)) = open.first() {
        return Err((*at, "this bracket is not closed"));
    }
    pieces.push(whole.from(from));
    let pieces = pieces.into_iter().map(Piece::trimmed).filter(|piece| !piece.text.is_empty());
    let is_import = |word: &str| ["import", "from"].contains(&word);
    pieces
        .filter(|piece| !piece.text.split_whitespace().next().is_some_and(is_import))
        .map(|piece| statement(piece).ok_or((piece.at, right)))
        .collect()
}

/// `name(...)`, `new Name(...)`, `name = ...`, or numbers; `None` of anything else.
fn statement(piece: Piece) -> Option<Statement> {
    let mut made = Statement { at: piece.at, text: piece.text.to_owned(), ..Statement::default() };
    let mut value = piece;
    if let Some((target, given)) = assignment(piece) {
        let mut words: Vec<&str> = target.split_whitespace().collect();
        let name = words.pop().filter(|name| is_name(name))?;
        if !words.iter().all(|word| DECLARATIONS.contains(word)) {
            return None;
        }
        made.target = name.to_owned();
        value = given;
    }
    let is_new = value.text.starts_with("new") && value.text[3..].starts_with(char::is_whitespace);
    let call = if is_new { value.from(3).trimmed() } else { value };
    match call_of(call) {
        Some((name, inside)) if !MAKERS.contains(&last_segment(name)) => {
            made.called = name.to_owned();
            made.is_new = is_new;
            made.arguments = inside.split().into_iter().map(argument).collect();
        }
        _ if !made.target.is_empty() => made.arguments = vec![argument(value)],
        _ if value.text.starts_with(is_of_name) && literal(value.text).is_none() => return None,
        _ => made.arguments = value.split().into_iter().map(argument).collect(),
    }
    Some(made)
}

/// The parts before and behind the first `=` or `:` that stands in no bracket and is none of `::`.
fn assignment(piece: Piece<'_>) -> Option<(&str, Piece<'_>)> {
    let head = piece.text.split(['(', '[', '{']).next()?.replace("::", "..");
    let at = head.find(['=', ':'])?;
    Some((&piece.text[..at], piece.from(at + 1).trimmed()))
}

/// A name, and what is in the brackets behind it, where these are the whole piece.
fn call_of(piece: Piece<'_>) -> Option<(&str, Piece<'_>)> {
    let open = piece.text.find('(')?;
    let name = piece.text[..open].trim_end();
    let mut depth = 0_usize;
    let close = piece.text.char_indices().find(|(_, c)| {
        depth += usize::from("([{".contains(*c));
        depth -= usize::from(")]}".contains(*c)).min(depth);
        ")]}".contains(*c) && depth == 0
    });
    let is_call = is_name(name) && close.is_some_and(|(at, _)| at + 1 == piece.text.len());
    is_call.then(|| (name, piece.until(piece.text.len() - 1).from(open + 1)))
}

fn argument(piece: Piece) -> Argument {
    let call = call_of(piece).map(|(name, inside)| (last_segment(name), inside));
    let angle = call.filter(|(name, _)| RADIANS.contains(name)).map(|(_, inside)| inside.text);
    let mut numbers = literal(piece.text);
    // GLM fills a vector with one number.
    if let (Some([one]), Some(("vec3" | "dvec3", _))) = (numbers.as_deref(), call) {
        numbers = Some(vec![*one; 3]);
    }
    let degrees = angle.and_then(literal).filter(|angle| angle.len() == 1).map(|angle| angle[0]);
    Argument { at: piece.at, text: piece.text.to_owned(), numbers, degrees }
}

/// The numbers of a text which has nothing else but brackets, [`MAKERS`] before them, quotients of two
/// numbers, and commas or blanks.
fn literal(text: &str) -> Option<Vec<f64>> {
    let mut spaced = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '(' | '[' | '{' => spaced.push_str(" ( "),
            ')' | ']' | '}' => spaced.push_str(" ) "),
            ',' | '/' => spaced.extend([' ', c, ' ']),
            c => spaced.push(c),
        }
    }
    let (mut numbers, mut commas, mut is_behind_value) = (Vec::new(), 0, false);
    let mut cells = spaced.split_whitespace().peekable();
    while let Some(cell) = cells.next() {
        match cell {
            "(" | "new" => (),
            ")" => is_behind_value = true,
            // Two commas leave a number out.
            "," if !is_behind_value => return None,
            "," => (commas, is_behind_value) = (commas + 1, false),
            name if cells.peek() == Some(&"(") && MAKERS.contains(&last_segment(name)) => (),
            cell => {
                let mut value = number(cell)?;
                if cells.next_if_eq(&"/").is_some() {
                    value /= number(cells.next()?)?;
                }
                numbers.push(Some(value).filter(|value| value.is_finite())?);
                is_behind_value = true;
            }
        }
    }
    // All between commas, of which one may stand behind the last, or all between blanks.
    let count = numbers.len();
    (count > 0 && (commas == 0 || commas == count || commas + 1 == count)).then_some(numbers)
}

/// A number as these languages write it: `-1`, `.5`, `2.`, `1e-3`, `4.0f`.
fn number(cell: &str) -> Option<f64> {
    let is_float = cell.ends_with(['f', 'F']) && cell.contains(['.', 'e', 'E']);
    let digits = if is_float { &cell[..cell.len() - 1] } else { cell };
    digits.parse().ok().filter(|number: &f64| number.is_finite())
}

fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c == '_' || c == '$'
}

fn is_name(name: &str) -> bool {
    let is_inside = |c: char| is_of_name(c) || c.is_numeric() || c == '.' || c == ':';
    name.starts_with(is_of_name) && name.chars().all(is_inside)
}
