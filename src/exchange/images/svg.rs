//! What every SVG that the program writes has in common.

use std::fmt::Write as _;

/// The fonts of plain text: the program's own, then what looks much the same.
pub const SANS: &str = "Noto Sans, DejaVu Sans, Helvetica, Arial, sans-serif";

/// An opaque colour.
pub fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Places, with so many decimals.
pub fn chain<T: Into<f64> + Copy>(points: &[[T; 2]], decimals: usize) -> String {
    let mut out = String::new();
    for [x, y] in points {
        let before = if out.is_empty() { "" } else { " " };
        let (x, y): (f64, f64) = ((*x).into(), (*y).into());
        // Writing to a string cannot fail.
        let _ = write!(out, "{before}{x:.decimals$},{y:.decimals$}");
    }
    out
}

/// Text that XML may hold: what marks it up is spelled out, and control characters, which it may
/// not hold at all, are left out.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => {}
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped() {
        assert_eq!(escaped("a < b & c > \"d\"\u{0}\n"), "a &lt; b &amp; c &gt; &quot;d&quot;");
    }
}
