//! The lecture's symbols: the only table of their meanings, one sentence each, and their letters in plain
//! text, taken from Unicode's block *Mathematical Alphanumeric Symbols*.

/// The kind of a symbol. It distinguishes symbols with the same letter, such as the vector u and the scalar
/// u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// A vector or a point, bold.
    Vector,
    /// A number in a formula, italic.
    Scalar,
    /// A number among the readouts.
    Readout,
}

use SymbolKind::{Readout, Scalar, Vector};

/// What eye means.
pub const EYE: &str = "eye: where every view ray begins";
/// What at means.
pub const AT: &str = "at: the point that the camera looks at";
/// What view means.
pub const VIEW: &str = "view: the direction that the camera looks along";
/// What up means.
pub const UP: &str = "up: a hint that keeps the camera level; not 𝐯";
/// What u means.
pub const U: &str = "𝐮: to the right in the image, of length 1";
/// What v means.
pub const V: &str = "𝐯: up in the image, of length 1";
/// What w means.
pub const W: &str = "𝐰: backwards, the opposite of the view direction, of length 1";
/// What d means.
pub const D: &str = "𝐝: the view ray's direction, from the eye to the viewport";
/// What distance means.
pub const DISTANCE: &str = "distance: from the eye to the viewport, the lecture's scalar d";
/// What a normal means.
pub const NORMAL: &str = "normal: perpendicular to the surface where the ray hits it, of length 1";
const P: &str = "𝐩: where the view ray begins, the eye";
const T: &str = "𝑡: how far along the ray, in units of |𝐝|; 𝑡 = 1 is the viewport";
const UV: &str = "(𝑢, 𝑣): the position in the viewport, from its middle, in world units";

/// All symbols that have an explanation, with their kinds and meanings.
const MEANINGS: [(SymbolKind, &str, &str); 39] = [
    (Vector, "eye", EYE),
    (Vector, "at", AT),
    (Vector, "view", VIEW),
    (Vector, "up", UP),
    (Vector, "u", U),
    (Vector, "v", V),
    (Vector, "w", W),
    (Vector, "p", P),
    (Vector, "d", D),
    (Vector, "n", "𝐧: the plane's normal, perpendicular to it, of any length"),
    (Vector, "x", "𝐱: any point of the object"),
    (Vector, "centre", "centre: the middle of the sphere"),
    (Vector, "point", "point: some point of the plane"),
    (Vector, "hit", "hit: the point where the ray meets the object first"),
    (Vector, "normal", NORMAL),
    (Scalar, "t", T),
    (Scalar, "u", "𝑢: how far right of the viewport's middle, in world units"),
    (Scalar, "v", "𝑣: how far above the viewport's middle, in world units"),
    (Scalar, "distance", DISTANCE),
    (Scalar, "i", "𝑖: the pixel's row, counted from the top"),
    (Scalar, "j", "𝑗: the pixel's column, counted from the left"),
    (Scalar, "W", "𝑊: how many columns the image has"),
    (Scalar, "H", "𝐻: how many rows the image has"),
    (Scalar, "width", "width: the viewport's, in world units"),
    (Scalar, "height", "height: the viewport's, in world units"),
    (Scalar, "r", "𝑟: the sphere's radius"),
    (Scalar, "a", "𝑎: the coefficient of 𝑡², the direction's squared length"),
    (Scalar, "b", "𝑏: half the coefficient of 𝑡; negative where the centre is ahead"),
    (Scalar, "c", "𝑐: what remains at 𝑡 = 0; negative where the eye is inside the sphere"),
    (
        Scalar,
        "D",
        "𝐷: a quarter of the textbook's discriminant, as 𝑏 is half; below 0 missed, 0 touched",
    ),
    (Readout, "t", T),
    (Readout, "(u, v)", UV),
    (Readout, "|d|", "|𝐝|: the direction's length, the distance per unit of 𝑡"),
    (Readout, "distance", "distance: from the eye along the ray, 𝑡 |𝐝|, in world units"),
    (Readout, "point", "point: where the ray's line meets the object, 𝐩 + 𝑡 𝐝"),
    (Readout, "normal", NORMAL),
    (Readout, "pixel", "pixel: what the ray goes through in the image, by row and column"),
    (Readout, "angle(up, view)", "the angle between up and view; at 0° there is no camera"),
    (
        Readout,
        "sensitivity",
        "degrees that the camera rolls for each degree that up is tipped sideways",
    ),
];

/// Returns the meaning of a symbol in a sentence; `None` if the table does not list it.
pub fn meaning(kind: SymbolKind, name: &str) -> Option<&'static str> {
    let known = |(listed, known, _): &&(SymbolKind, &str, &str)| *listed == kind && *known == name;
    MEANINGS.iter().find(known).map(|(.., meaning)| *meaning)
}

/// Returns the mathematical italic form of a letter, for scalars. Characters other than A to Z and a to z
/// are returned unchanged.
pub fn italic(letter: char) -> char {
    match letter {
        // U+1D455 is not assigned; the older U+210E is used instead.
        'h' => '\u{210e}',
        'a'..='z' => shifted(letter, 'a', 0x1d44e),
        'A'..='Z' => shifted(letter, 'A', 0x1d434),
        other => other,
    }
}

/// Returns the mathematical bold form of a letter, for vectors. Characters other than A to Z and a to z are
/// returned unchanged.
pub fn bold(letter: char) -> char {
    match letter {
        'a'..='z' => shifted(letter, 'a', 0x1d41a),
        'A'..='Z' => shifted(letter, 'A', 0x1d400),
        other => other,
    }
}

/// Returns the text with mathematical italic letters replaced by ordinary ones, for programs that read or
/// store it.
pub fn plain_scalars(text: &str) -> String {
    let plain = |c: char| match u32::from(c) {
        0x210e => 'h',
        code @ 0x1d44e..0x1d468 => char::from_u32(code - 0x1d44e + u32::from('a')).unwrap_or(c),
        code @ 0x1d434..0x1d44e => char::from_u32(code - 0x1d434 + u32::from('A')).unwrap_or(c),
        _ => c,
    };
    text.chars().map(plain).collect()
}

/// Returns a message of the core crate in the notation of the window: the signs `−`, `×` and `·`, bold
/// vectors u, v and w, and "centre" for "center".
pub fn typeset_message(message: impl std::fmt::Display) -> String {
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
    fn every_symbol_is_there_once_and_named_first() {
        for (k, (kind, name, text)) in MEANINGS.iter().enumerate() {
            assert!(
                MEANINGS[..k].iter().all(|(other, known, _)| (other, known) != (kind, name)),
                "{name}"
            );
            assert_eq!(meaning(*kind, name), Some(*text));
            assert!(!text.ends_with('.') && text.len() < 100, "{text}");
        }
        assert_ne!(meaning(SymbolKind::Vector, "u"), meaning(SymbolKind::Scalar, "u"));
        assert_eq!(meaning(SymbolKind::Scalar, "q"), None);
    }
}

#[cfg(test)]
mod letters_tests {
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
