//! Lays out a formula as positioned text and strokes, and breaks formulas into lines. As in TeX, a formula
//! consists of boxes on a common baseline, but TeX's refinements are left out.
//!
//! [`lines`] aligns formulas at their first relation (such as `=`). The part before the relation ends at
//! the column's indent, and every later line begins there with a relation. A line holds at most one side of
//! an equation that is a vector. The next such side begins a new line even if there is room, so that
//! nothing jumps while numbers change.
//!
//! A formula that is too wide is broken before `=` and other relations, and a side that is still too wide
//! before `+`, `×` and other operators. If a term is still too wide, it is first set slightly smaller; then
//! its vectors are written as columns; finally its text shrinks until it fits. No line is wider than the
//! column.

use crate::formula::{Arrangement, Formula, Operator, SymbolInk, gap};
use crate::{Given, symbols};

/// The font of a piece of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// Upright, for digits, operators and words.
    Upright,
    /// Italic, for scalars. Their text is already written in Unicode's mathematical italic letters.
    Italic,
    /// Bold, for vectors.
    Bold,
}

/// Measures the width of text.
pub trait TextMeasure {
    /// Returns the width of `text` in a font whose em is `size`, in the unit of `size`.
    fn width(&mut self, text: &str, face: Face, size: f32) -> f32;
}

/// A [`TextMeasure`] that is borrowed while a formula is laid out.
pub type Measure<'a> = &'a mut dyn TextMeasure;

/// A piece of text. Positions are relative to the start of the layout's first baseline, with x to the right
/// and y down.
#[derive(Clone, Debug, PartialEq)]
pub struct TextRun {
    /// The text.
    pub text: String,
    /// The font.
    pub face: Face,
    /// Size of the em.
    pub size: f32,
    /// The colour.
    pub ink: SymbolInk,
    /// The start of the text's baseline.
    pub at: [f32; 2],
}

/// A stroke, such as a fraction bar or a bracket.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// The corners.
    pub points: Vec<[f32; 2]>,
    /// The width.
    pub width: f32,
    /// The colour.
    pub ink: SymbolInk,
}

/// The box of a number that the user gives and can edit. Its extents are measured from the baseline, as for
/// text.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenBox {
    /// The number.
    pub given: Given,
    /// The start of the number's baseline.
    pub at: [f32; 2],
    /// Width of the box.
    pub width: f32,
    /// Extent above the baseline.
    pub ascent: f32,
    /// Extent below the baseline.
    pub descent: f32,
}

/// A formula after layout: its parts have positions, and its box extends `ascent` above the baseline and
/// `descent` below it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Width of the box.
    pub width: f32,
    /// Extent above the baseline.
    pub ascent: f32,
    /// Extent below the baseline; in a layout of several lines, below the first baseline.
    pub descent: f32,
    /// The text.
    pub runs: Vec<TextRun>,
    /// The strokes.
    pub rules: Vec<Rule>,
    /// The boxes of the given numbers.
    pub givens: Vec<GivenBox>,
}

/// Extent of text above its baseline, in ems.
const ASCENT: f32 = 0.76;
/// Extent of text below its baseline, in ems.
const DESCENT: f32 = 0.24;
/// Height of the math axis above the baseline, in ems: of fraction bars, minus signs and the middle of
/// brackets.
const AXIS: f32 = 0.34;
/// Width of strokes, in ems.
const STROKE: f32 = 0.066;
/// Size of superscripts and subscripts, relative to the surrounding text.
const SMALL: f32 = 0.72;
/// Minimum size of smaller parts, in points, unless the text around them is smaller.
const LEAST: f32 = 12.0;
/// Size of numerators and denominators, relative to the surrounding text.
pub(super) const FRACTION: f32 = 0.88;
/// Height in ems from which parentheses are drawn as strokes.
const TALL: f32 = 1.3;

/// Lays out a formula in one line. `size` is the size of the em.
pub fn layout(formula: &Formula, size: f32, measure: Measure<'_>) -> Layout {
    match formula {
        Formula::Scalar(name) => {
            // In mathematical italics, a name with several letters would look like a product.
            let text = match name.len() {
                1 => name.chars().map(symbols::italic).collect(),
                _ => (*name).to_owned(),
            };
            text_box(text, Face::Italic, SymbolInk::Text, size, measure)
        }
        Formula::Vector(name, ink) => text_box((*name).to_owned(), Face::Bold, *ink, size, measure),
        Formula::Word(text) | Formula::Number(text) | Formula::Rounded(text) => {
            text_box(text.clone(), Face::Upright, SymbolInk::Text, size, measure)
        }
        Formula::Operator(operator) => {
            text_box(operator.sign().to_owned(), Face::Upright, SymbolInk::Text, size, measure)
        }
        Formula::Given(given, inner) => {
            let mut inner = layout(inner, size, measure);
            let Layout { width, ascent, descent, .. } = inner;
            inner.givens.push(GivenBox { given: *given, at: [0.0; 2], width, ascent, descent });
            inner
        }
        Formula::Row(parts) => row(parts, size, measure),
        Formula::Root(inner) => root(layout(inner, size, measure), size),
        Formula::Fraction(above, below) => {
            let small = smaller(FRACTION, size);
            fraction(layout(above, small, measure), layout(below, small, measure), size)
        }
        Formula::Power(base, small) => script(base, small, -0.38, size, measure),
        Formula::Index(base, small) => script(base, small, 0.2, size, measure),
        Formula::Norm(inner) => fenced(layout(inner, size, measure), Fence::Bar, size),
        Formula::Parentheses(inner) => in_parentheses(layout(inner, size, measure), size, measure),
        Formula::Tuple(coordinates, Arrangement::Row) => {
            let mut parts = Vec::new();
            for coordinate in coordinates {
                if !parts.is_empty() {
                    parts.push(Operator::Comma.into());
                }
                parts.push(coordinate.clone());
            }
            in_parentheses(row(&parts, size, measure), size, measure)
        }
        Formula::Tuple(coordinates, Arrangement::Column) => {
            let boxes = coordinates.iter().map(|c| layout(c, size, measure)).collect();
            fenced(column(boxes, size), Fence::Bracket, size)
        }
    }
}

fn text_box(text: String, face: Face, ink: SymbolInk, size: f32, measure: Measure<'_>) -> Layout {
    let width = measure.width(&text, face, size);
    Layout {
        width,
        ascent: ASCENT * size,
        descent: DESCENT * size,
        runs: vec![TextRun { text, face, size, ink, at: [0.0, 0.0] }],
        ..Layout::default()
    }
}

impl Layout {
    pub(super) fn height(&self) -> f32 {
        self.ascent + self.descent
    }

    /// Adds another layout, whose baseline starts at (x, y).
    pub(super) fn put(&mut self, mut other: Layout, x: f32, y: f32) {
        let moved = |[a, b]: [f32; 2]| [a + x, b + y];
        other.runs.iter_mut().for_each(|run| run.at = moved(run.at));
        for rule in &mut other.rules {
            rule.points.iter_mut().for_each(|point| *point = moved(*point));
        }
        other.givens.iter_mut().for_each(|given| given.at = moved(given.at));
        self.runs.append(&mut other.runs);
        self.givens.append(&mut other.givens);
        self.rules.append(&mut other.rules);
        self.width = self.width.max(x + other.width);
        self.ascent = self.ascent.max(other.ascent - y);
        self.descent = self.descent.max(other.descent + y);
    }

    fn rule(&mut self, points: Vec<[f32; 2]>, size: f32) {
        self.rules.push(Rule { points, width: STROKE * size, ink: SymbolInk::Text });
    }
}

/// Returns the gap between two adjacent parts.
pub(super) fn room(before: &Formula, after: &Formula, size: f32) -> f32 {
    size * gap(before, after)
}

pub(super) fn row(parts: &[Formula], size: f32, measure: Measure<'_>) -> Layout {
    let mut whole = Layout::default();
    for (k, part) in parts.iter().enumerate() {
        let before = if k == 0 { 0.0 } else { room(&parts[k - 1], part, size) };
        let part = layout(part, size, measure);
        let x = whole.width + before;
        whole.put(part, x, 0.0);
    }
    whole
}

fn fraction(above: Layout, below: Layout, size: f32) -> Layout {
    let pad = 0.12 * size;
    let (width, axis) = (above.width.max(below.width) + 2.0 * pad, -AXIS * size);
    let mut whole = Layout { width, ..Layout::default() };
    let (x_above, x_below) = (0.5 * (width - above.width), 0.5 * (width - below.width));
    let (up, down) = (axis - 0.1 * size - above.descent, axis + 0.1 * size + below.ascent);
    whole.put(above, x_above, up);
    whole.put(below, x_below, down);
    whole.rule(vec![[0.04 * size, axis], [width - 0.04 * size, axis]], size);
    whole
}

fn root(inner: Layout, size: f32) -> Layout {
    let (sign, over) = (0.62 * size, 0.1 * size);
    let top = -(inner.ascent + over);
    let (bottom, end) = (inner.descent - 0.1 * size, sign + inner.width + 0.06 * size);
    let middle = 0.45 * (top + bottom);
    let mut whole = Layout::default();
    whole.put(inner, sign, 0.0);
    whole.rule(
        vec![
            [0.06 * size, middle + 0.1 * size],
            [0.17 * size, middle],
            [0.32 * size, bottom],
            [sign - 0.06 * size, top],
            [end, top],
        ],
        size,
    );
    whole.width = end + 0.04 * size;
    whole.ascent = whole.ascent.max(-top + 0.06 * size);
    whole
}

/// Returns the size of an index, a power or a part of a fraction: this share of the surrounding text's, but
/// legible.
fn smaller(share: f32, size: f32) -> f32 {
    (share * size).max(size.min(LEAST))
}

/// Lays out a base with a superscript or subscript, whose baseline is `shift` ems lower (higher if
/// negative).
fn script(base: &Formula, small: &Formula, shift: f32, size: f32, measure: Measure<'_>) -> Layout {
    let mut whole = layout(base, size, measure);
    let small = layout(small, smaller(SMALL, size), measure);
    let raised = if shift < 0.0 { (ASCENT * size - whole.ascent).min(0.0) } else { 0.0 };
    let x = whole.width + 0.03 * size;
    whole.put(small, x, shift * size + raised);
    whole
}

fn column(boxes: Vec<Layout>, size: f32) -> Layout {
    let between = 0.18 * size;
    let height: f32 = boxes.iter().map(Layout::height).sum::<f32>()
        + between * boxes.len().saturating_sub(1) as f32;
    let width = boxes.iter().map(|b| b.width).fold(0.0, f32::max);
    let mut whole = Layout::default();
    let mut top = -AXIS * size - 0.5 * height;
    for entry in boxes {
        let (x, y) = (width - entry.width, top + entry.ascent);
        top += entry.height() + between;
        whole.put(entry, x, y);
    }
    whole
}

/// The pair of delimiters that enclose a part.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fence {
    Bar,
    Bracket,
    Parenthesis,
}

fn in_parentheses(inner: Layout, size: f32, measure: Measure<'_>) -> Layout {
    if inner.height() > TALL * size {
        return fenced(inner, Fence::Parenthesis, size);
    }
    let mut whole = text_box("(".to_owned(), Face::Upright, SymbolInk::Text, size, measure);
    for part in [inner, text_box(")".to_owned(), Face::Upright, SymbolInk::Text, size, measure)] {
        let x = whole.width;
        whole.put(part, x, 0.0);
    }
    whole
}

/// Encloses a part of a formula in two delimiters, such as brackets, that are as tall as the part.
fn fenced(inner: Layout, fence: Fence, size: f32) -> Layout {
    let (top, bottom) = (-inner.ascent - 0.04 * size, inner.descent + 0.04 * size);
    let pad = match fence {
        Fence::Bar => 0.24 * size,
        Fence::Bracket | Fence::Parenthesis => 0.32 * size,
    };
    let (left, hook) = (0.1 * size, 0.14 * size);
    let width = inner.width + 2.0 * pad;
    let mut whole = Layout::default();
    whole.put(inner, pad, 0.0);
    let side = |outer: f32, inward: f32| match fence {
        Fence::Bar => vec![[outer, top], [outer, bottom]],
        Fence::Bracket => {
            let inner = outer + inward * hook;
            vec![[inner, top], [outer, top], [outer, bottom], [inner, bottom]]
        }
        // A parabola through the two ends that reaches `outer` in the middle.
        Fence::Parenthesis => (0..=12)
            .map(|k| {
                let s = k as f32 / 6.0 - 1.0;
                [outer + inward * hook * s * s, 0.5 * (top + bottom) + 0.5 * s * (bottom - top)]
            })
            .collect(),
    };
    whole.rule(side(left, 1.0), size);
    whole.rule(side(width - left, -1.0), size);
    whole.width = width;
    whole.ascent = whole.ascent.max(-top);
    whole.descent = whole.descent.max(bottom);
    whole
}

/// The column in which formulas are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Size of the em.
    pub size: f32,
    /// Width of the column.
    pub width: f32,
    /// Position at which the first relation is aligned, and start of every later line. If the part before
    /// the first relation is wider than the indent, that relation moves to the right.
    pub indent: f32,
}

/// Gap between two lines, in ems.
const LEADING: f32 = 0.42;

/// Returns the width of the part before a formula's first relation, including the gap between them; 0 if
/// there is no relation or nothing before it.
pub fn left_width(formula: &Formula, size: f32, measure: Measure<'_>) -> f32 {
    let parts = formula.parts();
    match parts.iter().position(Formula::is_relation) {
        Some(at) if at > 0 => {
            row(&parts[..at], size, measure).width + room(&parts[at - 1], &parts[at], size)
        }
        _ => 0.0,
    }
}

/// Lays out a formula in as many lines as it needs.
pub fn lines(formula: &Formula, column: Column, measure: Measure<'_>) -> Layout {
    let Column { size, width, indent } = column;
    let left = left_width(formula, size, measure);
    let start = if left > 0.0 { (indent - left).max(0.0) } else { 0.0 };
    let mut set = LineBuilder { column, start, done: Vec::new(), open: None };
    let mut before: Vec<&[Formula]> = Vec::new();
    let has_tuple = |piece: &[Formula]| piece.iter().any(Formula::has_tuple);
    for piece in pieces(formula.parts(), Formula::is_relation) {
        if piece.first().is_some_and(Formula::is_relation) {
            if has_tuple(piece) && before.iter().any(|before| has_tuple(before)) {
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

/// Splits a row into pieces. A new piece starts at each part for which `begins` returns true.
pub(super) fn pieces(parts: &[Formula], begins: impl Fn(&Formula) -> bool) -> Vec<&[Formula]> {
    let mut cuts = vec![0];
    cuts.extend((1..parts.len()).filter(|k| begins(&parts[*k])));
    cuts.push(parts.len());
    cuts.windows(2).map(|pair| &parts[pair[0]..pair[1]]).filter(|piece| !piece.is_empty()).collect()
}

/// Relative size of a term that is slightly too wide.
const TIGHT: f32 = 0.88;

/// Lays out a piece of a formula that is too wide for a line: slightly smaller if that is enough; otherwise
/// with its vectors as columns, and with smaller text if necessary.
fn narrowed(parts: &[Formula], size: f32, width: f32, measure: Measure<'_>) -> Layout {
    let tight = row(parts, TIGHT * size, measure);
    if tight.width <= width {
        return tight;
    }
    let columns: Vec<Formula> = parts.iter().map(upright).collect();
    let single = row(&columns, size, measure);
    if single.width <= width {
        return single;
    }
    // The width is proportional to the text size only up to the fonts' rounding, so the size is iterated.
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

/// Returns the formula with its vectors written as columns.
pub(super) fn upright(formula: &Formula) -> Formula {
    match formula {
        Formula::Tuple(coordinates, _) => Formula::Tuple(coordinates.clone(), Arrangement::Column),
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

/// Builds the lines of a formula.
struct LineBuilder<'a> {
    column: Column,
    /// Start of the first line.
    start: f32,
    done: Vec<Layout>,
    /// The unfinished line, to which the next piece may be added, and the last part of the formula in it.
    open: Option<(Layout, &'a Formula)>,
}

impl<'a> LineBuilder<'a> {
    /// Ends the open line. The next piece begins a new one.
    fn end_line(&mut self) {
        self.done.extend(self.open.take().map(|(line, _)| line));
    }

    /// Adds a side of an equation that is too wide for a line, term by term.
    fn add_in_terms(&mut self, piece: &'a [Formula], measure: Measure<'_>) {
        let Column { size, width, indent } = self.column;
        for term in pieces(piece, Formula::is_binary) {
            let single = row(term, size, measure);
            let single = match single.width <= width - indent {
                true => single,
                false => narrowed(term, size, width - indent, measure),
            };
            self.add(term, single);
        }
    }

    /// Adds a piece of the formula to the open line if it fits, otherwise to a new line.
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

    /// Stacks all lines in one layout.
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
