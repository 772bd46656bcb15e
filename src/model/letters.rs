//! Letters of formulas in plain text, from Unicode's block *Mathematical Alphanumeric Symbols*.

/// Returns the italic letter of a scalar; characters other than A to Z and a to z stay as they are.
pub(crate) fn italic(letter: char) -> char {
    match letter {
        // U+1D455 is not assigned; the older U+210E takes its place.
        'h' => '\u{210e}',
        'a'..='z' => shifted(letter, 'a', 0x1d44e),
        'A'..='Z' => shifted(letter, 'A', 0x1d434),
        other => other,
    }
}

/// Returns the bold upright letter of a vector; characters other than A to Z and a to z stay as
/// they are.
pub(crate) fn bold(letter: char) -> char {
    match letter {
        'a'..='z' => shifted(letter, 'a', 0x1d41a),
        'A'..='Z' => shifted(letter, 'A', 0x1d400),
        other => other,
    }
}

/// Returns the text with plain letters instead of italic ones, for programs that read or store it.
pub(crate) fn plain_scalars(text: &str) -> String {
    let plain = |c: char| match u32::from(c) {
        0x210e => 'h',
        code @ 0x1d44e..0x1d468 => char::from_u32(code - 0x1d44e + u32::from('a')).unwrap_or(c),
        code @ 0x1d434..0x1d44e => char::from_u32(code - 0x1d434 + u32::from('A')).unwrap_or(c),
        _ => c,
    };
    text.chars().map(plain).collect()
}

/// Returns a message of the core in the window's notation: the signs `−`, `×` and `·`, bold vectors
/// u, v and w, and "centre" for "center".
pub(crate) fn typeset_message(message: impl std::fmt::Display) -> String {
    let message = message.to_string().replace(" x ", " × ").replace(" . ", " · ");
    let letters: Vec<char> = message.replace("center", "centre").chars().collect();
    let at = |k: Option<usize>| k.and_then(|k| letters.get(k)).copied().unwrap_or(' ');
    let sign = |(k, letter): (usize, &char)| {
        let (before, after) = (at(k.checked_sub(1)), at(Some(k + 1)));
        let is_exponent = before == 'e' && at(k.checked_sub(2)).is_ascii_digit();
        let alone = !before.is_alphanumeric() && before != '.' && !after.is_alphanumeric();
        match letter {
            '-' if is_exponent || (!before.is_alphanumeric() && after.is_alphanumeric()) => '−',
            'u' | 'v' | 'w' if alone && after != '.' => bold(*letter),
            other => *other,
        }
    };
    letters.iter().enumerate().map(sign).collect()
}

fn shifted(letter: char, first: char, to: u32) -> char {
    char::from_u32(to + u32::from(letter) - u32::from(first)).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_alphabets_are_mathematical_from_end_to_end() {
        let all = |styled: fn(char) -> char, letters: &str| {
            letters.chars().map(styled).collect::<String>()
        };
        assert_eq!(all(italic, "aghizAZ1−"), "𝑎𝑔ℎ𝑖𝑧𝐴𝑍1−");
        assert_eq!(all(bold, "aghizAZ1−"), "𝐚𝐠𝐡𝐢𝐳𝐀𝐙1−");
        assert_eq!(plain_scalars("𝑎𝑔ℎ𝑖𝑧𝐴𝑍1− 𝐩"), "aghizAZ1− 𝐩");
    }

    #[test]
    fn messages_get_the_signs_of_formulas() {
        for (message, on_screen) in [
            ("u . v is -1e-9: it must be 0", "𝐮 · 𝐯 is −1e−9: it must be 0"),
            ("left-handed: u x v is -w and", "left-handed: 𝐮 × 𝐯 is −𝐰 and"),
            ("center is (0, -inf, 1)", "centre is (0, −inf, 1)"),
            ("basis.u is 0 - and up x w", "basis.u is 0 - and up × 𝐰"),
        ] {
            assert_eq!(typeset_message(message), on_screen);
        }
    }
}
