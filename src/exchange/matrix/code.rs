//! What an expression of NumPy or of OpenCV comes to, worked out without running the code: to its very
//! end, or not at all.

use super::Index;
use super::MOST;
use super::Matrix;
use super::functions::{MODULES, STACKS, is_type, made, number_at};
use super::names::Names;
use crate::exchange::code::{Piece, after_spaces, is_of_word, split, trimmed};

/// So many brackets and names in each other are followed.
pub(super) const DEEPEST: usize = 40;

/// An expression, as far as it is not read yet, and where it stands: names have the values that they
/// are given before it.
struct Reader<'n, 't> {
    names: &'n Names<'t>,
    rest: Piece<'t>,
    before: usize,
    depth: usize,
}

/// What cannot be read.
pub(super) type Unread<'t> = Piece<'t>;

/// The value of an expression that stands at `before`.
///
/// # Errors
/// The part of it that is not understood.
pub(super) fn evaluate<'t>(
    names: &Names<'t>,
    piece: Piece<'t>,
    before: usize,
    depth: usize,
) -> Result<Matrix, Unread<'t>> {
    let piece = trimmed(piece);
    let depth = depth.checked_sub(1).ok_or(piece)?;
    let parts = split(piece);
    if parts.len() > 1 || piece.text.ends_with(',') {
        return list(names, piece, before, depth);
    }
    let mut reader = Reader { names, rest: piece, before, depth };
    let value = reader.sum()?;
    let left = trimmed(reader.rest);
    let left = if left.text.starts_with('=') { piece } else { left };
    match left.text.is_empty() && value.numbers.iter().all(|x| x.is_finite()) {
        true => Ok(value),
        false => Err(if left.text.is_empty() { piece } else { left }),
    }
}

/// The parts of an index, as they stand between its brackets: `0, 2`, `:3, 3`, or `0][2`.
pub(super) fn index<'t>(
    names: &Names<'t>,
    inside: Piece<'t>,
    before: usize,
    depth: usize,
) -> Option<Vec<Index>> {
    let reader = Reader { names, rest: inside, before, depth };
    match inside.text.split_once("][") {
        Some((first, _)) => {
            let second = inside.from(first.len() + 2);
            let first = reader.index(Piece { text: first, ..inside })?;
            Some([first, reader.index(second)?].concat())
        }
        None => reader.index(inside),
    }
}

/// A row as NumPy prints it, `500.   0. 320.`.
fn printed_row(text: &str) -> Option<Vec<f64>> {
    if text.len() > 4000 || text.contains([',', '[', '(']) {
        return None;
    }
    let cells: Option<Vec<f64>> =
        text.split_whitespace().map(|cell| cell.parse::<f64>().ok()).collect();
    cells.filter(|cells| !cells.is_empty() && cells.iter().all(|x| x.is_finite()))
}

/// What stands between the brackets of a list.
fn list<'t>(
    names: &Names<'t>,
    inside: Piece<'t>,
    before: usize,
    depth: usize,
) -> Result<Matrix, Unread<'t>> {
    let inside = trimmed(inside);
    if let Some(row) = printed_row(inside.text) {
        return Matrix::shaped(vec![row.len()], row).ok_or(inside);
    }
    let mut parts = split(inside);
    if let [_] = parts[..] {
        // Rows as they are printed, or as MATLAB has them: without commas between them.
        let matlab: Option<Vec<_>> = inside.text.split(';').map(printed_row).collect();
        if let Some(rows) = matlab {
            let rows = rows.into_iter().map(Matrix::vector).collect();
            return Matrix::of_list(rows).ok_or(inside);
        }
        let mut rows = Vec::new();
        let mut rest = inside;
        while rest.text.starts_with('[')
            && let Some(row) = names.code.bracketed(rest)
        {
            let end = row.at + row.text.len() + 1 - rest.at;
            rows.push(Piece { text: &rest.text[..end], ..rest });
            rest = after_spaces(rest.from(end));
        }
        if rest.text.is_empty() {
            parts = rows;
        }
    }
    if parts.len() > MOST {
        return Err(inside);
    }
    let items: Result<Vec<Matrix>, Unread> =
        parts.into_iter().map(|part| evaluate(names, part, before, depth)).collect();
    Matrix::of_list(items?).ok_or(inside)
}

impl<'t> Reader<'_, 't> {
    fn skip(&mut self, sign: &str) -> bool {
        self.rest = after_spaces(self.rest);
        let is_next = self.rest.text.starts_with(sign);
        if is_next {
            self.rest = self.rest.from(sign.len());
        }
        is_next
    }

    fn evaluate(&self, piece: Piece<'t>) -> Result<Matrix, Unread<'t>> {
        evaluate(self.names, piece, self.before, self.depth)
    }

    fn sum(&mut self) -> Result<Matrix, Unread<'t>> {
        let from = self.rest;
        let mut value = self.product()?;
        loop {
            let sign = match self.skip("+") {
                true => '+',
                false if self.skip("-") => '-',
                false => return Ok(value),
            };
            let other = self.product()?;
            value = value.combined(sign, &other).ok_or(from)?;
        }
    }

    fn product(&mut self) -> Result<Matrix, Unread<'t>> {
        let from = self.rest;
        let mut value = self.signed()?;
        loop {
            self.rest = after_spaces(self.rest);
            if self.rest.text.starts_with("**") || self.rest.text.starts_with("//") {
                return Err(self.rest);
            }
            let sign = match self.rest.text.chars().next() {
                Some(sign @ ('*' | '/' | '@')) => sign,
                _ => return Ok(value),
            };
            self.rest = self.rest.from(1);
            let other = self.signed()?;
            let made = match sign {
                '@' => value.product(&other),
                _ => value.combined(sign, &other),
            };
            value = made.ok_or(from)?;
        }
    }

    fn signed(&mut self) -> Result<Matrix, Unread<'t>> {
        let mut negative = false;
        loop {
            if self.skip("-") {
                negative = !negative;
            } else if !["+", "(float)", "(double)"].into_iter().any(|sign| self.skip(sign)) {
                break;
            }
        }
        let value = self.part()?;
        Ok(if negative { value.each(|x| 0.0 - x) } else { value })
    }

    /// A number, a list, a name or a call, and what is done to it: `.T`, `[0]`, `.reshape(3, 1)`.
    fn part(&mut self) -> Result<Matrix, Unread<'t>> {
        let from = after_spaces(self.rest);
        self.rest = from;
        let first = from.text.chars().next().ok_or(from)?;
        let mut value = match first {
            '[' | '{' => return self.inside().and_then(|piece| self.list(piece)),
            '(' => {
                let inside = self.inside()?;
                match trimmed(inside).text {
                    text if text.contains("<<") => stream(self, inside)?,
                    _ => self.evaluate(inside)?,
                }
            }
            '0'..='9' | '.' => return self.number().ok_or(from),
            _ => self.named()?,
        };
        loop {
            let next = after_spaces(self.rest);
            if next.text.starts_with('.') {
                self.rest = next;
            }
            if self.rest.text.starts_with('[') {
                let inside = self.inside()?;
                let index = self.index(inside).ok_or(inside)?;
                value = value.at(&index).ok_or(inside)?;
            } else if self.rest.text.starts_with('.') {
                let from = self.rest;
                self.rest = self.rest.from(1);
                let name = self.path();
                value = self.method(name, value).ok_or(from)?;
            } else {
                return Ok(value);
            }
        }
    }

    fn list(&self, inside: Piece<'t>) -> Result<Matrix, Unread<'t>> {
        list(self.names, inside, self.before, self.depth.checked_sub(1).ok_or(inside)?)
    }

    /// What is in the brackets that open here; read up to behind them.
    fn inside(&mut self) -> Result<Piece<'t>, Unread<'t>> {
        let inside = self.names.code.bracketed(self.rest).ok_or(self.rest)?;
        let end = inside.at + inside.text.len() + 1 - self.rest.at;
        if end > self.rest.text.len() {
            return Err(self.rest);
        }
        self.rest = self.rest.from(end);
        Ok(inside)
    }

    fn number(&mut self) -> Option<Matrix> {
        let (number, length) = number_at(self.rest.text)?;
        self.rest = self.rest.from(length);
        Some(Matrix::scalar(number))
    }

    /// Letters and digits from here.
    fn path(&mut self) -> &'t str {
        let text = self.rest.text;
        let end = text.find(|c: char| !is_of_word(c)).unwrap_or(text.len());
        self.rest = self.rest.from(end);
        &text[..end]
    }

    fn named(&mut self) -> Result<Matrix, Unread<'t>> {
        let from = self.rest;
        let mut name = self.path();
        let mut is_module = false;
        loop {
            let is_owner = MODULES.contains(&name) || ["self", "this"].contains(&name);
            is_module |= MODULES.contains(&name);
            let sign = ["::", ".", "->"].into_iter().find(|sign| self.rest.text.starts_with(sign));
            let (true, Some(sign)) = (is_owner, sign) else { break };
            self.rest = self.rest.from(sign.len());
            name = self.path();
        }
        if name == "new" {
            self.rest = after_spaces(self.rest);
            name = self.path();
        }
        if is_module && name.eq_ignore_ascii_case("pi") || ["CV_PI", "M_PI"].contains(&name) {
            return Ok(Matrix::scalar(std::f64::consts::PI));
        }
        if name.is_empty() {
            return Err(from);
        }
        let opens = after_spaces(self.rest);
        if opens.text.starts_with('(') {
            self.rest = opens;
            let inside = self.inside()?;
            let end = self.rest.at - from.at;
            let call = Piece { text: &from.text[..end], ..from };
            return self.call(name, inside, call);
        }
        let known = self.names.value_at(name, self.before, self.depth);
        known.ok_or(Piece { text: &from.text[..self.rest.at - from.at], ..from })
    }

    fn call(
        &mut self,
        name: &str,
        inside: Piece<'t>,
        call: Piece<'t>,
    ) -> Result<Matrix, Unread<'t>> {
        if name == "Rodrigues" && self.rest.text.starts_with('[') {
            // It returns the rotation and the derivatives.
            let index = self.inside()?;
            (index.text.trim() == "0").then_some(()).ok_or(call)?;
        }
        let parts = split(inside);
        if STACKS.contains(&name) {
            return self.stacked(name, &parts).ok_or(call);
        }
        let (mut values, mut is_whole) = (Vec::new(), false);
        for (k, part) in parts.iter().enumerate() {
            if k > 0 && is_type(part.text) {
                continue;
            }
            match part.text.starts_with("dtype") {
                true => is_whole = true,
                // Texts are for functions that are not known.
                false if part.text.starts_with(['"', '\'']) => return Err(call),
                false => values.push(self.evaluate(*part)?),
            }
        }
        let value = made(name, &values).ok_or(call)?;
        let is_kept = !is_whole || value.numbers.iter().all(|x| x.fract() == 0.0);
        is_kept.then_some(value).ok_or(call)
    }

    /// `np.hstack([R, t])`: of parts that need not have one shape.
    fn stacked(&self, name: &str, parts: &[Piece<'t>]) -> Option<Matrix> {
        let (first, more) = parts.split_first()?;
        let is_list = first.text.starts_with(['[', '(']);
        let inside = self.names.code.bracketed(*first).filter(|_| is_list)?;
        let items = split(inside).into_iter().map(|part| self.evaluate(part).ok());
        let items: Vec<Matrix> = items.collect::<Option<_>>()?;
        let axis: Option<String> =
            more.first().map(|more| more.text.split_whitespace().collect::<String>());
        match (name, axis.as_deref(), more.len()) {
            ("hstack", None, 0) => Matrix::beside(&items),
            ("concatenate", Some("axis=1" | "1"), 1) => {
                let flat = items.iter().any(Matrix::is_vector);
                Matrix::beside(&items).filter(|_| !flat)
            }
            ("column_stack", None, 0) => {
                let columns: Option<Vec<Matrix>> = items.iter().map(Matrix::column).collect();
                Matrix::beside(&columns?)
            }
            ("vstack" | "row_stack", None, 0) => Matrix::below(&items),
            _ => None,
        }
    }

    fn index(&self, inside: Piece<'t>) -> Option<Vec<Index>> {
        let whole = |piece: Piece<'t>| match piece.text.is_empty() {
            true => Some(None),
            false => {
                let number = self.evaluate(piece).ok()?.number()?;
                (number.fract() == 0.0 && number.abs() < 1e6).then_some(Some(number as i64))
            }
        };
        let one = |piece: Piece<'t>| match piece.text.split_once(':') {
            Some((from, to)) if !to.contains(':') => {
                let to = trimmed(piece.from(from.len() + 1));
                let from = trimmed(Piece { text: from, ..piece });
                Some(Index::Range(whole(from)?, whole(to)?))
            }
            Some(_) => None,
            None if ["None", "np.newaxis"].contains(&piece.text) => Some(Index::New),
            None => Some(Index::At(whole(piece)??)),
        };
        split(inside).into_iter().map(one).collect()
    }

    fn method(&mut self, name: &str, value: Matrix) -> Option<Matrix> {
        if name == "T" {
            return value.transposed();
        }
        let inside = self.inside().ok()?;
        if name == "astype" {
            return is_type(inside.text).then_some(value);
        }
        let arguments: Option<Vec<Matrix>> =
            split(inside).into_iter().map(|part| self.evaluate(part).ok()).collect();
        match (name, &arguments?[..]) {
            ("transpose" | "t", []) => value.transposed(),
            ("inv", []) => value.inverse(),
            ("copy" | "clone", []) => Some(value),
            ("flatten" | "ravel" | "squeeze", []) => Some(value.flat()),
            ("dot", [other]) => value.product(other),
            ("reshape", sizes) => {
                let sizes: Vec<f64> = sizes.iter().flat_map(|size| size.numbers.clone()).collect();
                value.reshaped(&sizes)
            }
            _ => None,
        }
    }
}

/// `cv::Mat_<double>(3, 3) << 500, 0, 320, ...`: in brackets of its own.
fn stream<'t>(reader: &Reader<'_, 't>, inside: Piece<'t>) -> Result<Matrix, Unread<'t>> {
    let at = inside.text.find("<<").ok_or(inside)?;
    let made = inside.text[..at].trim();
    let numbers = reader.evaluate(inside.from(at + 2))?;
    let kind = made.strip_prefix("cv::").unwrap_or(made);
    let sizes = kind.split_once('(').and_then(|(kind, sizes)| {
        let kinds = ["Mat_<double>", "Mat_<float>", "Mat1d", "Mat1f"];
        kinds.contains(&kind.trim()).then_some(())?;
        let sizes = sizes.strip_suffix(')')?.split(',');
        sizes.map(|size| size.trim().parse::<f64>().ok()).collect::<Option<Vec<f64>>>()
    });
    sizes.and_then(|sizes| numbers.reshaped(&sizes)).ok_or(inside)
}
