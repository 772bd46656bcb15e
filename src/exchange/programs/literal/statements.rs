//! The statements of a text: calls, names that are given a value, and numbers that stand alone.

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
    /// The angle in degrees, where `radians(...)` stands around it.
    pub(crate) degrees: Option<f64>,
    /// True for a quotient such as 4 / 3, which is 1 in C.
    pub(crate) divides_whole: bool,
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

/// A piece of a text, and the byte at which it begins.
#[derive(Clone, Copy)]
struct Piece<'t> {
    at: usize,
    text: &'t str,
}

/// Last part of a name: `vec3` of `glm::vec3`.
pub(crate) fn last_part(name: &str) -> &str {
    name.rsplit(['.', ':']).next().unwrap_or_default()
}

/// Returns the text with blanks in the places of its comments, byte by byte.
///
/// # Errors
/// The byte of a comment that may be a division, and what would be right.
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
        let before = plain.trim_end_matches([' ', '\t']);
        if rest.starts_with("//") && before.ends_with(|c: char| c.is_ascii_digit() || c == '.') {
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
    let (mut from, mut last) = (0, ' ');
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
                pieces.push(Piece { at: from, text: &plain[from..at] });
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
    pieces.push(Piece { at: from, text: &plain[from..] });
    let pieces = pieces.into_iter().map(trimmed).filter(|piece| !piece.text.is_empty());
    let is_import = |word: &str| ["import", "from"].contains(&word);
    pieces
        .filter(|piece| !piece.text.split_whitespace().next().is_some_and(is_import))
        .map(|piece| statement(piece).ok_or((piece.at, right)))
        .collect()
}

fn trimmed(piece: Piece) -> Piece {
    let text = piece.text.trim_start();
    Piece { at: piece.at + piece.text.len() - text.len(), text: text.trim_end() }
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
    let bare = value.text.strip_prefix("new").filter(|rest| rest.starts_with(char::is_whitespace));
    let call = trimmed(Piece {
        at: value.at + value.text.len() - bare.unwrap_or(value.text).len(),
        text: bare.unwrap_or(value.text),
    });
    match call_of(call) {
        Some((name, inside)) if !MAKERS.contains(&last_part(name)) => {
            made.called = name.to_owned();
            made.is_new = bare.is_some();
            made.arguments = split(inside).into_iter().map(argument).collect();
        }
        _ if !made.target.is_empty() => made.arguments = vec![argument(value)],
        _ if value.text.starts_with(is_of_name) && literal(value.text).is_none() => return None,
        _ => made.arguments = split(value).into_iter().map(argument).collect(),
    }
    Some(made)
}

/// The parts before and behind the first `=` or `:` that stands in no bracket and is none of `::`.
fn assignment(piece: Piece<'_>) -> Option<(&str, Piece<'_>)> {
    let head = &piece.text[..piece.text.find(['(', '[', '{']).unwrap_or(piece.text.len())];
    let joint = head.replace("::", "..");
    let at = joint.find(['=', ':'])?;
    Some((&head[..at], trimmed(Piece { at: piece.at + at + 1, text: &piece.text[at + 1..] })))
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
    let inside = piece.text.get(open + 1..piece.text.len() - 1)?;
    is_call.then_some((name, Piece { at: piece.at + open + 1, text: inside }))
}

/// The pieces between commas that stand in no bracket of their own.
fn split(piece: Piece) -> Vec<Piece> {
    let (mut depth, mut from, mut pieces) = (0_i32, 0, Vec::new());
    for (at, c) in piece.text.char_indices().chain([(piece.text.len(), ',')]) {
        depth += i32::from("([{".contains(c)) - i32::from(")]}".contains(c));
        if c == ',' && depth == 0 {
            pieces.push(trimmed(Piece { at: piece.at + from, text: &piece.text[from..at] }));
            from = at + 1;
        }
    }
    // A comma may stand behind the last one.
    pieces.pop_if(|last| last.text.is_empty());
    pieces
}

fn argument(piece: Piece) -> Argument {
    let call = call_of(piece);
    let (name, inside) = call.map_or(("", ""), |(name, inside)| (last_part(name), inside.text));
    let is_angle = RADIANS.contains(&name);
    let (numbers, divides_whole) = literal(if is_angle { inside } else { piece.text }).unzip();
    let (numbers, degrees) = match numbers.as_deref() {
        Some([degrees]) if is_angle => (Some(vec![degrees.to_radians()]), Some(*degrees)),
        _ if is_angle => (None, None),
        // GLM fills a vector with one number.
        Some([one]) if ["vec3", "dvec3"].contains(&name) => (Some(vec![*one; 3]), None),
        _ => (numbers, None),
    };
    let divides_whole = divides_whole == Some(true);
    Argument { at: piece.at, text: piece.text.to_owned(), numbers, degrees, divides_whole }
}

/// The numbers of a text which has nothing else but brackets, [`MAKERS`] before them, quotients of two
/// numbers, and commas or blanks; and true where a whole number is divided by one.
fn literal(text: &str) -> Option<(Vec<f64>, bool)> {
    let mut spaced = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '(' | '[' | '{' => spaced.push_str(" ( "),
            ')' | ']' | '}' => spaced.push_str(" ) "),
            ',' | '/' => spaced.extend([' ', c, ' ']),
            c => spaced.push(c),
        }
    }
    let (mut numbers, mut commas, mut divides_whole) = (Vec::new(), 0, false);
    let mut cells = spaced.split_whitespace().peekable();
    while let Some(cell) = cells.next() {
        match cell {
            "(" | ")" | "new" => (),
            "," => commas += 1,
            name if cells.peek() == Some(&"(") && MAKERS.contains(&last_part(name)) => (),
            cell => {
                let mut value = number(cell)?;
                if cells.next_if_eq(&"/").is_some() {
                    let by = cells.next()?;
                    divides_whole |= is_whole(cell) && is_whole(by);
                    value /= number(by)?;
                }
                numbers.push(Some(value).filter(|value| value.is_finite())?);
            }
        }
    }
    // All between commas, of which one may stand behind the last, or all between blanks.
    let count = numbers.len();
    (commas == 0 || commas == count || commas + 1 == count).then_some((numbers, divides_whole))
}

/// A number as these languages write it: `-1`, `.5`, `2.`, `1e-3`, `4.0f`.
fn number(cell: &str) -> Option<f64> {
    let is_float = cell.ends_with(['f', 'F']) && cell.contains(['.', 'e', 'E']);
    let digits = if is_float { &cell[..cell.len() - 1] } else { cell };
    digits.parse().ok().filter(|number: &f64| number.is_finite())
}

fn is_whole(cell: &str) -> bool {
    cell.bytes().all(|byte| byte.is_ascii_digit() || b"+-".contains(&byte))
}

fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c == '_' || c == '$'
}

fn is_name(name: &str) -> bool {
    let is_inside = |c: char| is_of_name(c) || c.is_numeric() || c == '.' || c == ':';
    name.starts_with(is_of_name) && name.chars().all(is_inside)
}
