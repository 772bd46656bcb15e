//! Line breaking: sets a formula in lines of a given width, aligned at its relations.
//!
//! What stands before the first relation ends where the column says, so that the relations of all
//! formulas in a column stand below each other; later lines begin there, each with its relation. A
//! line has one form of a vector at most: the next one begins a new line, at whatever width, so that
//! nothing jumps while numbers change. A formula that is too wide is broken before `=` and other
//! relations; a piece that is still too wide is broken before `+`, `×` and other operators; what is
//! only a little too wide then gets a little smaller; then vectors are written as columns; then the
//! text gets as small as it must. No line is wider than the column.

use super::layout::{Layout, Measure, room, row};
use super::{Direction, Formula, Operator};

/// The column in which lines are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Size of the em.
    pub size: f32,
    /// Width of the column.
    pub width: f32,
    /// Position of the first relation, and of the start of every later line. What is too wide for
    /// the room before it moves its own first relation to the right.
    pub indent: f32,
}

/// Distance between two lines, in ems.
const LEADING: f32 = 0.42;

/// Returns the width of what stands before a formula's first relation, with the gap behind it; 0 for
/// a formula without one.
pub fn left_width(formula: &Formula, size: f32, measure: &mut dyn Measure) -> f32 {
    let parts = formula.parts();
    match parts.iter().position(Formula::is_relation) {
        Some(at) if at > 0 => {
            row(&parts[..at], size, measure).width + room(&parts[at - 1], &parts[at], size)
        }
        _ => 0.0,
    }
}

/// Sets a formula in as many lines as it needs.
pub fn lines(formula: &Formula, column: Column, measure: &mut dyn Measure) -> Layout {
    let Column { size, width, indent } = column;
    let left = left_width(formula, size, measure);
    let start = if left > 0.0 { (indent - left).max(0.0) } else { 0.0 };
    let mut set = Lines { column, start, done: Vec::new(), open: None };
    let mut before: Vec<&[Formula]> = Vec::new();
    for piece in pieces(formula.parts(), Formula::is_relation) {
        if piece.first().is_some_and(Formula::is_relation) {
            if before.iter().any(|before| are_apart(before, piece)) {
                set.end_line();
                before.clear();
            }
            before.push(piece);
        }
        let lines_before = set.done.len();
        let single = row(piece, size, measure);
        if single.width <= width - indent {
            set.add(piece, single);
        } else {
            set.add_in_terms(piece, measure);
        }
        if set.done.len() > lines_before {
            before = vec![piece];
        }
    }
    set.stacked()
}

/// Returns true if two pieces that begin with relations must not stand in one line: two forms of a
/// vector; and `≈ a = b`, where what equals the left side would seem to equal a.
fn are_apart(before: &[Formula], after: &[Formula]) -> bool {
    let has_tuple = |piece: &[Formula]| piece.iter().any(Formula::has_tuple);
    let begins_with = |piece: &[Formula], sign| piece.first() == Some(&Formula::Operator(sign));
    (has_tuple(before) && has_tuple(after))
        || (begins_with(before, Operator::Approximately) && begins_with(after, Operator::Equals))
}

/// Cuts the parts before each one that `begins` a new piece.
fn pieces(parts: &[Formula], begins: impl Fn(&Formula) -> bool) -> Vec<&[Formula]> {
    let mut cuts = vec![0];
    cuts.extend((1..parts.len()).filter(|k| begins(&parts[*k])));
    cuts.push(parts.len());
    cuts.windows(2).map(|pair| &parts[pair[0]..pair[1]]).filter(|piece| !piece.is_empty()).collect()
}

/// Size of a piece that is a little too wide, relative to the others.
const TIGHT: f32 = 0.88;

/// Sets a piece that is too wide for a line: a little smaller where that is enough, then with vectors
/// as columns, then also smaller.
fn narrowed(parts: &[Formula], size: f32, width: f32, measure: &mut dyn Measure) -> Layout {
    let tight = row(parts, TIGHT * size, measure);
    if tight.width <= width {
        return tight;
    }
    let columns: Vec<Formula> = parts.iter().map(upright).collect();
    let single = row(&columns, size, measure);
    if single.width <= width {
        return single;
    }
    // Widths are proportional to the size, apart from the fonts' rounding.
    let mut smaller = size;
    let mut single = single;
    for _ in 0..8 {
        smaller *= (0.99 * width / single.width).clamp(0.05, 0.99);
        single = row(&columns, smaller, measure);
        if single.width <= width {
            break;
        }
    }
    single
}

/// Returns the formula with its vectors as columns.
fn upright(formula: &Formula) -> Formula {
    match formula {
        Formula::Tuple(coordinates, _) => Formula::Tuple(coordinates.clone(), Direction::Column),
        Formula::Norm(inner) => Formula::Norm(Box::new(upright(inner))),
        Formula::Parentheses(inner) => Formula::Parentheses(Box::new(upright(inner))),
        Formula::Row(parts) => Formula::Row(parts.iter().map(upright).collect()),
        Formula::Fraction(above, below) => {
            Formula::Fraction(Box::new(upright(above)), Box::new(upright(below)))
        }
        Formula::Root(inner) => Formula::Root(Box::new(upright(inner))),
        other => other.clone(),
    }
}

/// The lines while they are set.
struct Lines<'a> {
    column: Column,
    /// Start of the first line.
    start: f32,
    done: Vec<Layout>,
    /// The line that is being filled, and its last part.
    open: Option<(Layout, &'a Formula)>,
}

impl<'a> Lines<'a> {
    /// Ends the open line: the next piece begins a new one.
    fn end_line(&mut self) {
        self.done.extend(self.open.take().map(|(line, _)| line));
    }

    /// Adds a piece that is too wide for a line term by term.
    fn add_in_terms(&mut self, piece: &'a [Formula], measure: &mut dyn Measure) {
        let Column { size, width, indent } = self.column;
        let is_binary =
            |part: &Formula| matches!(part, Formula::Operator(operator) if operator.is_binary());
        for term in pieces(piece, is_binary) {
            let single = row(term, size, measure);
            let single = match single.width <= width - indent {
                true => single,
                false => narrowed(term, size, width - indent, measure),
            };
            self.add(term, single);
        }
    }

    /// Adds a piece to the open line if it fits, otherwise to a new line.
    fn add(&mut self, parts: &'a [Formula], piece: Layout) {
        let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return };
        let indent = if self.done.is_empty() { self.start } else { self.column.indent };
        match self.open.take() {
            Some((mut line, before)) => {
                let x = line.width + room(before, first, self.column.size);
                if x + piece.width <= self.column.width - indent {
                    line.put(piece, x, 0.0);
                    self.open = Some((line, last));
                } else {
                    self.done.push(line);
                    self.open = Some((piece, last));
                }
            }
            None => self.open = Some((piece, last)),
        }
    }

    /// Stacks the lines.
    fn stacked(mut self) -> Layout {
        self.end_line();
        let mut whole = Layout::default();
        for (k, line) in self.done.into_iter().enumerate() {
            if k == 0 {
                whole.put(line, self.start, 0.0);
                continue;
            }
            let y = whole.descent + LEADING * self.column.size + line.ascent;
            whole.put(line, self.column.indent, y);
        }
        whole
    }
}
