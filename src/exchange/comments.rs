//! What a program does not read: comments, and what the preprocessor leaves out.

/// Which comments a language has.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Comments {
    /// From `#` to the end of the line.
    Hash,
    /// From `//` to the end of the line, and `/* */`.
    Slashes,
    /// The same, and `<1, 2, 3>` is a list, as in POV-Ray.
    SlashesAndAngles,
}

/// The text with blanks for what is not read, so that places stay.
pub(super) fn without_comments(text: &str, comments: Comments) -> String {
    let mut plain = text.as_bytes().to_vec();
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let rest = &bytes[at..];
        let length = if comments == Comments::Hash && rest[0] == b'#'
            || comments != Comments::Hash && rest.starts_with(b"//")
        {
            rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len())
        } else if comments != Comments::Hash && rest.starts_with(b"/*") {
            let end = rest.windows(2).skip(2).position(|pair| pair == b"*/");
            end.map_or(rest.len(), |end| end + 4)
        } else if comments == Comments::Hash
            && [&b"\"\"\""[..], b"'''"].iter().any(|quotes| rest.starts_with(quotes))
        {
            // A text over several lines, which is what a function says of itself.
            let end = rest.windows(3).skip(3).position(|three| three == &rest[..3]);
            end.map_or(3, |end| end + 6)
        } else if matches!(rest[0], b'"' | b'\'') {
            // No comment begins within a string of one line.
            let end = rest[1..].iter().position(|b| *b == rest[0] || *b == b'\n');
            let end = end.filter(|end| rest[end + 1] == rest[0]);
            at += end.map_or(1, |end| end + 2);
            continue;
        } else {
            at += 1;
            continue;
        };
        for byte in &mut plain[at..at + length] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
        at += length;
    }
    if comments == Comments::Slashes {
        blank_left_out(&mut plain);
    }
    // Whole comments were blanked: what is left is text.
    String::from_utf8_lossy(&plain).into_owned()
}

/// Blanks what stands between `#if 0` and its `#else` or `#endif`; after `#if 1`, what stands in its
/// `#else`. Other conditions are not known: all their branches stay.
fn blank_left_out(plain: &mut [u8]) {
    // Of each `#if` that is open: whether the branch at hand is left out, and the one after `#else`.
    let mut open: Vec<(bool, bool)> = Vec::new();
    let mut left_out = 0_usize;
    for line in plain.split_inclusive_mut(|byte| *byte == b'\n') {
        let (word, rest) = directive(line);
        let was = open.last().is_some_and(|(is_left_out, _)| *is_left_out);
        match word.as_str() {
            "if" => {
                open.push((rest == "0", rest == "1"));
                left_out += usize::from(rest == "0");
            }
            "ifdef" | "ifndef" => open.push((false, false)),
            "else" | "elif" => {
                if let Some(last) = open.last_mut() {
                    last.0 = last.1;
                    left_out = left_out + usize::from(last.0) - usize::from(was);
                }
            }
            "endif" => {
                open.pop();
                left_out -= usize::from(was);
            }
            _ if left_out > 0 => {
                line.iter_mut().filter(|byte| **byte != b'\n').for_each(|byte| *byte = b' ');
            }
            _ => (),
        }
    }
}

/// The word after a line's `#`, and what follows it.
fn directive(line: &[u8]) -> (String, String) {
    let line = line.trim_ascii();
    let Some(rest) = line.strip_prefix(b"#") else { return Default::default() };
    let rest = String::from_utf8_lossy(rest.trim_ascii_start());
    let end = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
    (rest[..end].to_owned(), rest[end..].trim().to_owned())
}
