//! The statements of a text: calls, names that are given a value, and numbers that stand alone.

use super::tokens::{Kind, Token};

/// A statement.
#[derive(Debug)]
pub(crate) struct Statement<'t> {
    /// Byte at which it begins.
    pub(crate) at: usize,
    /// Its text.
    pub(crate) text: &'t str,
    /// Name that is given the value, as `view` in `glm::mat4 view = ...`; empty without one.
    pub(crate) target: &'t str,
    /// Function that is called; empty where nothing is.
    pub(crate) called: &'t str,
    /// True where `new` stands before the call.
    pub(crate) is_new: bool,
    /// Arguments of the call, or values.
    pub(crate) arguments: Vec<Argument<'t>>,
}

/// An argument, or a value.
#[derive(Clone, Debug, Default)]
pub(crate) struct Argument<'t> {
    /// Byte at which it begins.
    pub(crate) at: usize,
    /// Its text.
    pub(crate) text: &'t str,
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

/// Last part of a name: `vec3` of `glm::vec3`.
pub(crate) fn last_part(name: &str) -> &str {
    name.rsplit(['.', ':']).next().unwrap_or_default()
}

/// Splits tokens into statements; the error is the text at fault.
pub(super) fn statements<'t>(
    text: &'t str,
    tokens: &[Token<'t>],
) -> Result<Vec<Statement<'t>>, (usize, &'t str)> {
    let parts = tokens.split(|token| token.kind == Kind::End).filter(|part| !part.is_empty());
    let is_import = |kind| matches!(kind, Kind::Name("import" | "from"));
    parts
        .filter(|part| !is_import(part[0].kind))
        .map(|part| {
            let mut reader = Reader { text, tokens: part, next: 0 };
            reader.statement().ok_or((part[0].at, reader.text_between(0, part.len())))
        })
        .collect()
}

/// Tokens of one statement, and the next of them.
struct Reader<'s, 't> {
    text: &'t str,
    tokens: &'s [Token<'t>],
    next: usize,
}

impl<'t> Reader<'_, 't> {
    fn peek(&self) -> Option<Kind<'t>> {
        self.tokens.get(self.next).map(|token| token.kind)
    }

    fn takes(&mut self, kind: Kind) -> bool {
        let is_next = self.peek() == Some(kind);
        self.next += usize::from(is_next);
        is_next
    }

    fn name(&mut self) -> Option<&'t str> {
        let Some(Kind::Name(name)) = self.peek() else { return None };
        self.next += 1;
        Some(name)
    }

    fn at(&self, index: usize) -> usize {
        self.tokens.get(index).map_or(self.text.len(), |token| token.at)
    }

    /// Input from one token to before another, without blanks and comments behind it.
    fn text_between(&self, from: usize, to: usize) -> &'t str {
        let start = self.at(from);
        let Some(last) = self.tokens.get(from..to).and_then(<[Token]>::last) else { return "" };
        let rest = &self.text[last.at..];
        let length = match last.kind {
            Kind::Name(name) => name.len(),
            Kind::Number { .. } => rest
                .find(|c: char| c.is_whitespace() || ",;)]}/#".contains(c))
                .unwrap_or(rest.len()),
            _ => rest.chars().next().map_or(0, char::len_utf8),
        };
        &self.text[start..last.at + length]
    }

    fn statement(&mut self) -> Option<Statement<'t>> {
        let mut names = Vec::new();
        while let Some(name) = self.name() {
            names.push(name);
        }
        let mut made = Statement {
            at: self.at(0),
            text: self.text_between(0, self.tokens.len()),
            target: "",
            called: "",
            is_new: false,
            arguments: Vec::new(),
        };
        if names.is_empty() {
            while self.peek().is_some() {
                made.arguments.push(self.argument());
                self.takes(Kind::Comma);
            }
            return Some(made);
        }
        let last = names.pop()?;
        if self.takes(Kind::Is) {
            made.target = last;
            if !names.iter().all(|name| DECLARATIONS.contains(name)) {
                return None;
            }
            let start = self.next;
            made.is_new = self.takes(Kind::Name("new"));
            match self.name() {
                Some(name) if self.peek() == Some(Kind::Open) && !is_maker(name) => {
                    made.called = name;
                }
                _ => {
                    self.next = start;
                    made.arguments.push(self.argument());
                    return self.peek().is_none().then_some(made);
                }
            }
        } else {
            made.called = last;
            made.is_new = names == ["new"];
            if !(names.is_empty() || made.is_new) {
                return None;
            }
        }
        made.arguments = self.call()?;
        self.peek().is_none().then_some(made)
    }

    /// Reads the arguments in the brackets of a call.
    fn call(&mut self) -> Option<Vec<Argument<'t>>> {
        let mut arguments = Vec::new();
        if !self.takes(Kind::Open) {
            return None;
        }
        while !self.takes(Kind::Close) {
            arguments.push(self.argument());
            if !self.takes(Kind::Comma) && self.peek() != Some(Kind::Close) {
                return None;
            }
        }
        Some(arguments)
    }

    /// Reads an argument, up to a comma, a bracket that closes, or the end.
    fn argument(&mut self) -> Argument<'t> {
        let start = self.next;
        let mut argument = Argument { at: self.at(start), ..Argument::default() };
        let mut numbers = Vec::new();
        let is_literal = self.value(&mut numbers, &mut argument).is_some();
        // Numbers that stand alone may be kept apart by blanks.
        let ends = match self.peek() {
            None | Some(Kind::Comma | Kind::Close | Kind::Open) => true,
            Some(Kind::Number { .. }) => numbers.len() == 1,
            _ => false,
        };
        if is_literal && ends {
            argument.numbers = Some(numbers);
        } else {
            self.next = start;
            self.skip();
        }
        argument.text = self.text_between(start, self.next);
        argument
    }

    /// Goes on to the comma or bracket that ends an argument.
    fn skip(&mut self) {
        let mut depth = 0_usize;
        while let Some(kind) = self.peek() {
            match kind {
                Kind::Comma | Kind::Close if depth == 0 => return,
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                _ => (),
            }
            self.next += 1;
        }
    }

    /// A number, a quotient of two, a list, or what [`MAKERS`] and [`RADIANS`] make of them.
    fn value(&mut self, into: &mut Vec<f64>, argument: &mut Argument<'t>) -> Option<()> {
        match self.peek()? {
            Kind::Number { value, is_whole } => {
                self.next += 1;
                if !self.takes(Kind::Divided) {
                    into.push(value);
                    return Some(());
                }
                let Kind::Number { value: by, is_whole: by_whole } = self.peek()? else {
                    return None;
                };
                self.next += 1;
                argument.divides_whole |= is_whole && by_whole;
                into.push(Some(value / by).filter(|quotient| quotient.is_finite())?);
                Some(())
            }
            Kind::Open => self.list(into, argument),
            Kind::Name("new") => {
                self.next += 1;
                let name = self.name()?;
                is_maker(name).then(|| self.list(into, argument))?
            }
            Kind::Name(name) if is_maker(name) => {
                self.next += 1;
                let before = into.len();
                self.list(into, argument)?;
                // GLM fills a vector with one number.
                if matches!(last_part(name), "vec3" | "dvec3") && into.len() == before + 1 {
                    into.extend([into[before]; 2]);
                }
                Some(())
            }
            Kind::Name(name) if RADIANS.contains(&last_part(name)) => {
                self.next += 1;
                let before = into.len();
                self.list(into, argument)?;
                let degrees = into.pop()?;
                argument.degrees = Some(degrees);
                into.push(degrees.to_radians());
                (into.len() == before + 1).then_some(())
            }
            _ => None,
        }
    }

    /// Values in brackets: all between commas, or all between blanks.
    fn list(&mut self, into: &mut Vec<f64>, argument: &mut Argument<'t>) -> Option<()> {
        if !self.takes(Kind::Open) {
            return None;
        }
        let (mut commas, mut values) = (0, 0);
        while !self.takes(Kind::Close) {
            self.value(into, argument)?;
            values += 1;
            commas += usize::from(self.takes(Kind::Comma));
        }
        // A comma may stand behind the last one.
        (commas == 0 || commas == values || commas + 1 == values).then_some(())
    }
}

fn is_maker(name: &str) -> bool {
    MAKERS.contains(&last_part(name))
}
