//! Letters of formulas in plain text, from Unicode's block *Mathematical Alphanumeric Symbols*.

/// A scalar's letter, italic; what is no letter from A to z stays as it is.
pub(crate) fn italic(letter: char) -> char {
    match letter {
        // U+1D455 is not assigned: this one was there before.
        'h' => '\u{210e}',
        'a'..='z' => shifted(letter, 'a', 0x1d44e),
        'A'..='Z' => shifted(letter, 'A', 0x1d434),
        other => other,
    }
}

/// A vector's letter, bold and upright; what is no letter from A to z stays as it is.
pub(crate) fn bold(letter: char) -> char {
    match letter {
        'a'..='z' => shifted(letter, 'a', 0x1d41a),
        'A'..='Z' => shifted(letter, 'A', 0x1d400),
        other => other,
    }
}

fn shifted(letter: char, first: char, to: u32) -> char {
    char::from_u32(to + u32::from(letter) - u32::from(first)).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_alphabets_are_mathematical_from_end_to_end() {
        let all = |of: fn(char) -> char, letters: &str| letters.chars().map(of).collect::<String>();
        assert_eq!(all(italic, "aghizAZ1−"), "𝑎𝑔ℎ𝑖𝑧𝐴𝑍1−");
        assert_eq!(all(bold, "aghizAZ1−"), "𝐚𝐠𝐡𝐢𝐳𝐀𝐙1−");
    }
}
