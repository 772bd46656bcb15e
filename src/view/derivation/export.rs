//! The derivation as text for slides and notes: LaTeX, and Markdown with `$formulas$`.

use std::fmt::Write as _;

use pinhole_exchange::is_hidden;

use super::{Derivation, Line, left_out};
use crate::view::formula::latex;

/// The markup language of an exported derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Markup {
    /// LaTeX with amsmath.
    Latex,
    /// Markdown with `$formulas$`.
    Markdown,
}

impl Derivation {
    /// Writes the derivation for slides or notes.
    pub fn written_in(&self, markup: Markup) -> String {
        match markup {
            Markup::Latex => self.to_latex(),
            Markup::Markdown => self.to_markdown(),
        }
    }

    /// Writes LaTeX with amsmath: a heading and an `align*` for each section.
    fn to_latex(&self) -> String {
        let mut out = String::from("% needs \\usepackage{amsmath}\n");
        // Writing to a string cannot fail.
        for section in &self.sections {
            let _ = writeln!(out, "\\subsection*{{{}}}", latex::text(&section.title));
            let lines: Vec<String> = section.lines.iter().map(latex_line).collect();
            if !lines.is_empty() {
                let lines = lines.join(" \\\\\n");
                let _ = writeln!(out, "\\begin{{align*}}\n{lines}\n\\end{{align*}}");
            }
        }
        if self.left_out > 0 {
            let _ = writeln!(out, "{}", latex::text(&left_out(self.left_out)));
        }
        out
    }

    /// Writes Markdown: a heading and a list for each section.
    fn to_markdown(&self) -> String {
        let mut out = String::new();
        for (k, section) in self.sections.iter().enumerate() {
            let before = if k == 0 { "" } else { "\n" };
            let _ = writeln!(out, "{before}### {}\n", markdown(&section.title));
            for line in &section.lines {
                let _ = write!(out, "- ${}$", latex::math(&line.formula));
                if !line.note.is_empty() {
                    let _ = write!(out, "; {}", markdown(&line.note));
                }
                out.push('\n');
            }
        }
        if self.left_out > 0 {
            let _ = writeln!(out, "\n{}", left_out(self.left_out));
        }
        out
    }
}

fn latex_line(line: &Line) -> String {
    let formula = latex::aligned(&line.formula);
    match line.note.as_str() {
        "" => format!("  {formula}"),
        note => format!("  {formula} && \\text{{{}}}", latex::text(note)),
    }
}

/// Escapes the characters that Markdown treats as markup.
fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if r"\`*_[]<>#$|~".contains(c) {
            out.push('\\');
        }
        if !is_hidden(c) {
            out.push(c);
        }
    }
    out
}
