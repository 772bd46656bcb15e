//! The statements of a Python program, one after the other, without running it.

use super::code::{Code, Piece, after_spaces, split, statement, trimmed};

/// What may keep a statement from being done once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Block {
    Always,
    /// In an `if`, an `else` or a `match`.
    Perhaps,
    /// In a `for` or a `while`.
    Often,
}

/// What a statement does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verb {
    /// `left = right`.
    Give,
    /// `left += right` and its like, with the sign before the `=`.
    Change(char),
    /// An expression alone, which is both; in a console, what was printed after it is given to it.
    Say,
    /// `return right`.
    Return,
    /// `def left():`.
    Define,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Statement<'t> {
    pub(super) left: Piece<'t>,
    pub(super) verb: Verb,
    pub(super) right: Piece<'t>,
    pub(super) block: Block,
}

/// What begins a block, and how often it is done.
const HEADS: [(&str, Block); 14] = [
    ("for", Block::Often),
    ("while", Block::Often),
    ("async", Block::Often),
    ("if", Block::Perhaps),
    ("elif", Block::Perhaps),
    ("else", Block::Perhaps),
    ("match", Block::Perhaps),
    ("case", Block::Perhaps),
    ("except", Block::Perhaps),
    ("try", Block::Always),
    ("finally", Block::Always),
    ("with", Block::Always),
    ("class", Block::Always),
    ("def", Block::Always),
];

/// What Blender prints in its console.
const PRINTED: [&str; 8] =
    ["Vector(", "Euler(", "Matrix(", "Quaternion(", "<Vector", "<Euler", "<Matrix", "<Quaternion"];

pub(super) fn statements<'t>(code: &'t Code) -> Vec<Statement<'t>> {
    let whole = code.whole();
    let mut reader = Reader { blocks: Vec::new(), found: Vec::new() };
    let (mut at, mut indent, mut is_first) = (0, 0, true);
    while at < whole.text.len() {
        let line = &whole.text[at..];
        // In a console a line begins with >>> or with three points.
        let said = line.trim_start_matches([' ', '\t', '>', '.']);
        let skipped = line.len() - said.len();
        if is_first {
            indent = skipped;
        }
        let rest = whole.from(at + skipped);
        let said = printed(rest).unwrap_or_else(|| statement(rest));
        at += skipped + said.text.len();
        let after = &whole.text[at..];
        at += after.len() - after.trim_start_matches([' ', '\t']).len();
        // What ends a statement, or a bracket that nothing opened.
        let end = whole.text[at..].chars().next();
        at += end.map_or(0, char::len_utf8);
        if !said.text.is_empty() {
            reader.read(said, indent, is_first);
        }
        is_first = end == Some('\n');
    }
    reader.found
}

/// A value that the console prints in angle brackets, over several lines.
fn printed(rest: Piece) -> Option<Piece> {
    const LONGEST: usize = 1000;
    if !PRINTED.iter().any(|word| word.starts_with('<') && rest.text.starts_with(word)) {
        return None;
    }
    let (end, _) = rest.text.char_indices().take(LONGEST).find(|(_, c)| *c == '>')?;
    Some(Piece { text: &rest.text[..=end], ..rest })
}

struct Reader<'t> {
    /// How far each open block's head is indented.
    blocks: Vec<(usize, Block)>,
    found: Vec<Statement<'t>>,
}

impl<'t> Reader<'t> {
    fn read(&mut self, said: Piece<'t>, indent: usize, is_first: bool) {
        if is_first {
            while self.blocks.pop_if(|(deep, _)| *deep >= indent).is_some() {}
        }
        let block = self.blocks.last().map_or(Block::Always, |(_, block)| *block);
        let Some((said, block)) = self.after_head(said, indent, block) else { return };
        let of = |left, verb, right| Statement { left, verb, right, block };
        if let Some(value) = said.text.strip_prefix("return") {
            let right = trimmed(said.from(said.text.len() - value.len()));
            self.found.push(of(right, Verb::Return, right));
        } else if PRINTED.iter().any(|word| said.text.starts_with(word)) {
            // What was printed belongs to what was said before it.
            match self.found.last_mut().filter(|last| last.verb == Verb::Say) {
                Some(last) => *last = of(asked(last.right), Verb::Give, said),
                None => self.found.push(of(said, Verb::Say, said)),
            }
        } else if let Some((left, verb, right)) = equals(said) {
            let (lefts, rights) = (split(left), split(right));
            if lefts.len() > 1 && lefts.len() == rights.len() {
                let pairs = lefts.into_iter().zip(rights);
                self.found.extend(pairs.map(|(left, right)| of(left, verb, right)));
            } else {
                self.found.push(of(left, verb, right));
            }
        } else {
            self.found.push(of(said, Verb::Say, said));
        }
    }

    /// What stands behind the colon of a block's head, if that is what was said, and how often it is
    /// done.
    fn after_head(
        &mut self,
        said: Piece<'t>,
        indent: usize,
        around: Block,
    ) -> Option<(Piece<'t>, Block)> {
        let end = said.text.find(|c: char| !c.is_alphanumeric() && c != '_');
        let word = &said.text[..end.unwrap_or(said.text.len())];
        let head = HEADS.iter().find(|(head, _)| *head == word);
        let Some(((_, own), colon)) = head.zip(outside(said.text, ':')) else {
            return Some((said, around));
        };
        // What is done when the file is run as a program.
        let is_main = said.text[..colon].contains("__name__");
        let block = match own {
            Block::Perhaps if !is_main && around == Block::Always => Block::Perhaps,
            Block::Often => Block::Often,
            _ => around,
        };
        self.blocks.push((indent, block));
        if word == "def" {
            let left = trimmed(Piece { text: &said.text[3..colon], at: said.at + 3 });
            self.found.push(Statement { left, verb: Verb::Define, right: left, block });
        }
        let rest = after_spaces(said.from(colon + 1));
        (!rest.text.is_empty()).then_some((rest, block))
    }
}

/// What stands in the brackets of `print(...)`.
fn asked(said: Piece) -> Piece {
    let inside = said.text.strip_prefix("print(").and_then(|text| text.strip_suffix(')'));
    inside.map_or(said, |text| Piece { text, at: said.at + 6 })
}

/// Where a sign stands outside of all brackets.
fn outside(text: &str, sign: char) -> Option<usize> {
    let mut depth = 0_i32;
    text.char_indices().find_map(|(at, c)| {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => (),
        }
        (c == sign && depth == 0).then_some(at)
    })
}

/// Both sides of `=` or `+=`.
fn equals(said: Piece) -> Option<(Piece, Verb, Piece)> {
    let at = outside(said.text, '=')?;
    let (before, after) = (&said.text[..at], &said.text[at + 1..]);
    let sign = before.chars().next_back()?;
    if after.starts_with('=') || "<>!=:".contains(sign) {
        return None;
    }
    let right = trimmed(said.from(at + 1));
    let (left, verb) = match sign {
        '+' | '-' | '*' | '/' | '@' | '%' | '|' | '&' | '^' => {
            (&before[..at - 1], Verb::Change(sign))
        }
        _ => (before, Verb::Give),
    };
    // name: kind = value.
    let left = left.split_once(": ").map_or(left, |(name, _)| name);
    Some((trimmed(Piece { text: left, at: said.at }), verb, right))
}
