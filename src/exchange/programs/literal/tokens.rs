//! Numbers, names and signs of a pasted text, without its comments.

/// A token, and the byte at which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Token<'t> {
    pub(super) at: usize,
    pub(super) kind: Kind<'t>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind<'t> {
    /// A finite number, and whether it is written as a whole one, which C divides without a fraction.
    Number {
        value: f64,
        is_whole: bool,
    },
    /// A name with its points, as `camera.position.set` and `glm::vec3`.
    Name(&'t str),
    Open,
    Close,
    Comma,
    /// `=`, or `:` after a name.
    Is,
    Divided,
    /// A semicolon, or the end of a line on which a statement may end.
    End,
    Other,
}

/// Longest text that is split: no camera needs more.
const LONGEST: usize = 1 << 20;

/// Deepest brackets: a matrix in a call has four.
const DEEPEST: usize = 8;

/// Splits a text into its tokens; the error is the byte at fault and what would be right.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, (usize, &'static str)> {
    if text.len() > LONGEST {
        return Err((0, "it must not be longer than a million characters"));
    }
    let mut tokens: Vec<Token> = Vec::new();
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let before = tokens.last().map(|token| token.kind);
        let is_sign = matches!(c, '-' | '+') && !matches!(before, Some(Kind::Name(_)));
        let (kind, length) = match c {
            '\n' => {
                // A statement goes on in brackets, and after what asks for more.
                let goes_on = matches!(before, None | Some(Kind::Is | Kind::Comma | Kind::End));
                (if open.is_empty() && !goes_on { Some(Kind::End) } else { None }, 1)
            }
            _ if c.is_whitespace() || c == '\u{feff}' => (None, c.len_utf8()),
            _ if comment(rest) > 0 => {
                // In Python, // divides.
                if rest.starts_with("//") && matches!(before, Some(Kind::Number { .. })) {
                    return Err((at, "a number must not stand before //, which may divide it"));
                }
                (None, comment(rest))
            }
            '(' | '[' | '{' => {
                open.push((at, closing(c)));
                if open.len() > DEEPEST {
                    return Err((at, "brackets must not be deeper than a matrix's"));
                }
                (Some(Kind::Open), 1)
            }
            ')' | ']' | '}' => {
                if open.pop_if(|(_, close)| *close == c).is_none() {
                    return Err((at, "no bracket is open that it closes"));
                }
                (Some(Kind::Close), 1)
            }
            ',' => (Some(Kind::Comma), 1),
            ';' => (Some(if open.is_empty() { Kind::End } else { Kind::Other }), 1),
            '=' | ':' => (Some(Kind::Is), 1),
            '/' => (Some(Kind::Divided), 1),
            _ if c.is_ascii_digit() || c == '.' || is_sign => match number(rest) {
                Some((number, length)) => (Some(number), length),
                None => (Some(Kind::Other), c.len_utf8()),
            },
            _ => match name(rest) {
                "" => (Some(Kind::Other), c.len_utf8()),
                name => (Some(Kind::Name(name)), name.len()),
            },
        };
        tokens.extend(kind.map(|kind| Token { at, kind }));
        at += length;
    }
    match open.first() {
        Some((at, _)) => Err((*at, "this bracket is not closed")),
        None => Ok(tokens),
    }
}

fn closing(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

/// Length of the comment with which a text begins; 0 without one.
fn comment(text: &str) -> usize {
    /// Directives by which lines are left out, which cannot be told without running them.
    const DIRECTIVES: [&str; 4] = ["#if", "#el", "#end", "#define"];
    let is_directive = DIRECTIVES.iter().any(|directive| text.starts_with(directive));
    if text.starts_with("//") || (text.starts_with('#') && !is_directive) {
        text.find('\n').unwrap_or(text.len())
    } else if let Some(inside) = text.strip_prefix("/*") {
        inside.find("*/").map_or(text.len(), |end| end + 4)
    } else {
        0
    }
}

/// The number with which a text begins, and its length: `-1`, `.5`, `2.`, `1e-3`, `4.0f`.
fn number<'t>(text: &str) -> Option<(Kind<'t>, usize)> {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let sign = usize::from(text.starts_with(['-', '+']));
    let mut end = sign + digits(sign);
    let mut count = end - sign;
    let mut is_whole = true;
    if text[end..].starts_with('.') {
        let fraction = digits(end + 1);
        (end, count, is_whole) = (end + 1 + fraction, count + fraction, false);
    }
    if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
        let sign = usize::from(exponent.starts_with(['-', '+']));
        (end, is_whole) = (end + 1 + sign + digits(end + 1 + sign), false);
    }
    let value: f64 = text[..end].parse().ok().filter(|value: &f64| value.is_finite())?;
    if !is_whole && text[end..].starts_with(['f', 'F']) {
        end += 1;
    }
    let ends = !text[end..].starts_with(|c: char| is_of_name(c) || c == '.');
    (count > 0 && ends).then_some((Kind::Number { value, is_whole }, end))
}

fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '$'
}

/// The name with which a text begins; empty where it begins with none.
fn name(text: &str) -> &str {
    if !text.starts_with(|c: char| is_of_name(c) && !c.is_numeric()) {
        return "";
    }
    let mut end = 0;
    loop {
        end += text[end..].find(|c| !is_of_name(c)).unwrap_or(text.len() - end);
        let joint = ["::", "."].into_iter().find(|joint| text[end..].starts_with(joint));
        match joint.map(|joint| end + joint.len()) {
            Some(next) if text[next..].starts_with(is_of_name) => end = next,
            _ => return &text[..end],
        }
    }
}
