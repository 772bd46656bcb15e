//! The note: the comment block that a scene file begins with.

/// Splits a scene file's text into its note and the rest. The block ends before the first line
/// that is no comment.
pub(super) fn split(text: &str) -> (&str, &str) {
    let mut end = 0;
    for line in text.split_inclusive('\n').take_while(|line| line.starts_with('#')) {
        end += line.len();
    }
    text.split_at(end)
}

/// The note in a comment block: its lines without `# `.
pub(super) fn of_block(block: &str) -> String {
    let line = |line: &str| -> String {
        let line = line.strip_prefix('#').unwrap_or(line);
        line.strip_prefix(' ').unwrap_or(line).trim_end_matches('\r').to_owned()
    };
    let block = block.strip_suffix('\n').unwrap_or(block);
    block.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// The comment block of a note, with a newline at its end; empty for an empty note.
///
/// Control characters, which TOML has no place for in comments, become blanks.
pub(super) fn to_block(note: &str) -> String {
    if note.is_empty() {
        return String::new();
    }
    let clean = |c: char| if c.is_control() && c != '\t' { ' ' } else { c };
    note.split('\n')
        .map(|line| {
            let line: String = line.chars().map(clean).collect();
            if line.is_empty() { "#\n".to_owned() } else { format!("# {line}\n") }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_ends_at_the_first_line_without_a_hash() {
        let text = "# one\n#\n#  three\n\n# not this\npinhole = 1\n";
        let (block, rest) = split(text);
        assert_eq!(of_block(block), "one\n\n three");
        assert_eq!(rest, "\n# not this\npinhole = 1\n");
        assert_eq!(split("\n# late\n"), ("", "\n# late\n"));
    }

    #[test]
    fn notes_survive() {
        for note in ["one line", "two\nlines", "an end\n", "\n", " indented", "#hash", "tab\there"]
        {
            assert_eq!(of_block(split(&to_block(note)).0), note);
        }
        assert_eq!(to_block(""), "");
        assert_eq!(to_block("a\r\nb"), "# a \n# b\n");
    }
}
