//! Line breaking: sets a formula in lines of a given width. It is broken before `=` and other
//! relations; a piece that is still too wide is broken before `+`, `×` and other operators; then
//! vectors are written as columns; then the text gets smaller. No line is wider than the column.

use super::layout::{Layout, Measure, layout, room, row};
use super::{Direction, Formula};

/// The column in which lines are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Size of the em.
    pub size: f32,
    /// Width of the column.
    pub width: f32,
    /// Indent of every line but the first.
    pub indent: f32,
}

/// Distance between two lines, in ems.
const LEADING: f32 = 0.42;

/// Sets a formula in as many lines as it needs.
pub fn lines(formula: &Formula, column: Column, measure: &mut dyn Measure) -> Layout {
    let Column { size, width, indent } = column;
    let whole = layout(formula, size, measure);
    if whole.width <= width {
        return whole;
    }
    let mut set = Lines { column, done: Vec::new(), open: None };
    for piece in pieces(
        formula.parts(),
        |part| matches!(part, Formula::Operator(operator) if operator.is_relation()),
    ) {
        let single = row(piece, size, measure);
        if single.width <= width - indent {
            set.add(piece, single);
            continue;
        }
        for term in pieces(
            piece,
            |part| matches!(part, Formula::Operator(operator) if operator.is_binary()),
        ) {
            let single = row(term, size, measure);
            let single = if single.width <= width - indent {
                single
            } else {
                narrowed(term, size, width - indent, measure)
            };
            set.add(term, single);
        }
    }
    set.stacked()
}

/// Cuts the parts before each one that `begins` a new piece.
fn pieces(parts: &[Formula], begins: impl Fn(&Formula) -> bool) -> Vec<&[Formula]> {
    let mut cuts = vec![0];
    cuts.extend((1..parts.len()).filter(|k| begins(&parts[*k])));
    cuts.push(parts.len());
    cuts.windows(2).map(|pair| &parts[pair[0]..pair[1]]).filter(|piece| !piece.is_empty()).collect()
}

/// Sets a piece that is too wide for a line: first with vectors as columns, then also smaller.
fn narrowed(parts: &[Formula], size: f32, width: f32, measure: &mut dyn Measure) -> Layout {
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
    done: Vec<Layout>,
    /// The line that is being filled, and its last part.
    open: Option<(Layout, &'a Formula)>,
}

impl<'a> Lines<'a> {
    /// Adds a piece to the open line if it fits, otherwise to a new line.
    fn add(&mut self, parts: &'a [Formula], piece: Layout) {
        let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return };
        let indent = if self.done.is_empty() { 0.0 } else { self.column.indent };
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
        self.done.extend(self.open.take().map(|(line, _)| line));
        let mut whole = Layout::default();
        for (k, line) in self.done.into_iter().enumerate() {
            if k == 0 {
                whole = line;
                continue;
            }
            let y = whole.descent + LEADING * self.column.size + line.ascent;
            whole.put(line, self.column.indent, y);
        }
        whole
    }
}
