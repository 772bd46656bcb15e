//! POV-Ray's comments, which may stand in one another.

/// The text with blanks in the places of its comments, byte by byte.
pub(super) fn without_comments(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(['/', '"']) {
        let (before, from) = rest.split_at(at);
        plain.push_str(before);
        let (length, is_comment) = match from {
            _ if from.starts_with("//") => (from.find('\n').unwrap_or(from.len()), true),
            _ if from.starts_with("/*") => (block(from), true),
            _ if from.starts_with('"') => {
                (from[1..].find(['"', '\n']).map_or(from.len(), |end| end + 2), false)
            }
            _ => (1, false),
        };
        let (piece, behind) = from.split_at(length);
        match is_comment {
            true => plain.extend(piece.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' })),
            false => plain.push_str(piece),
        }
        rest = behind;
    }
    plain + rest
}

/// Returns the length of the block comment with which a text begins.
fn block(text: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while let Some(next) = text[at..].find(['/', '*']) {
        at += next;
        let sign = &text.as_bytes()[at..];
        match sign {
            [b'/', b'*', ..] => depth += 1,
            [b'*', b'/', ..] => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return at;
        }
    }
    text.len()
}
