//! Text in columns, for terminals.

use std::fmt::Write as _;

/// The width of each column: that of its widest cell.
pub(crate) fn widths<const N: usize>(rows: &[[String; N]]) -> [usize; N] {
    std::array::from_fn(|column| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)
    })
}

/// Writes rows, the first column to the left, the others to the right, two blanks between.
pub(crate) fn aligned<const N: usize>(out: &mut String, rows: &[[String; N]], widths: [usize; N]) {
    for row in rows {
        let mut line = format!("{:<width$}", row[0], width = widths[0]);
        for (cell, width) in row.iter().zip(widths).skip(1) {
            let _ = write!(line, "  {cell:>width$}");
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
}

/// Writes text behind a head, in lines of at most `width` characters, the further ones indented as
/// far.
pub(crate) fn wrapped(out: &mut String, width: usize, head: &str, text: &str) {
    let indent = head.chars().count();
    for (k, line) in lines(text, width - indent).into_iter().enumerate() {
        let head = if k == 0 { head } else { "" };
        let _ = writeln!(out, "{head:indent$}{line}");
    }
}

/// Splits a text into lines of at most `width` characters.
pub(crate) fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
