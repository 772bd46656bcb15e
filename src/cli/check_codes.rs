//! `pinhole check --codes`: counts the mistakes in a class's answers to exercises.

use std::fmt::Write as _;
use std::path::Path;

use pinhole_exchange::{FileError, limits};

use super::console::{CommandError, read, to_json};
use crate::model::practice::class::ClassAnswers;

/// Returns what is printed, and whether all answers are right.
pub(super) fn graded(path: &Path, as_json: bool) -> Result<(String, bool), CommandError> {
    let (path, bytes) = read(path, limits::TEXT)?;
    let class = ClassAnswers::read(&String::from_utf8_lossy(&bytes));
    if class.exercises.is_empty() {
        let first = class.not_readable.first();
        let problem = match first {
            None => "no code in it: the code of an answer begins with answer1/".to_owned(),
            Some((line, problem)) => {
                format!("no code can be read: that in line {line} is {problem}")
            }
        };
        return Err(FileError::of_file(path, problem).into());
    }
    let text = if as_json { to_json(&class)? } else { text(&class) };
    Ok((text, class.all_right()))
}

/// Maximum length of a bar, in characters.
const LONGEST: usize = 40;

fn text(class: &ClassAnswers) -> String {
    let mut text = String::new();
    for own in &class.exercises {
        let _ = writeln!(text, "{}", own.title);
        let width = own.counts.iter().map(|(outcome, _)| outcome.len()).max().unwrap_or_default();
        for (outcome, count) in &own.counts {
            let bar = "#".repeat((count * LONGEST / own.answers.max(LONGEST)).max(1));
            let _ = writeln!(text, "  {outcome:width$}  {count:4}  {bar}");
        }
        for line in &own.explanations {
            let _ = writeln!(text, "  {line}");
        }
    }
    for problem in class.problems() {
        let _ = writeln!(text, "{problem}");
    }
    text
}
