//! The parts of what a Blender program says: properties, and values as they are written or printed.

use pinhole_core::DVec3;

use crate::exchange::affine::Affine;
use crate::exchange::code::{Code, Piece, split};
use crate::formats::FileError;

/// No path of a camera is longer.
pub(super) const LONGEST_PATH: usize = 300;

/// A property, and the part of it that is meant.
pub(super) fn parted(path: &str) -> (&str, &str) {
    let path = path.trim_start_matches('.');
    path.split_at(path.find(['.', '[']).unwrap_or(path.len()))
}

/// The angles of `Euler((1, 2, 3), 'XYZ')`, and its order.
pub(super) fn euler(piece: Piece) -> (Piece, Option<Piece>) {
    let inside = ["Euler(", "mathutils.Euler("].iter().find_map(|word| {
        let inside = piece.text.strip_prefix(word)?.strip_suffix(')')?;
        Some(Piece { text: inside, at: piece.at + word.len() })
    });
    let Some(inside) = inside else { return (piece, None) };
    match split(inside)[..] {
        [angles, order] if order.text.starts_with(['\'', '"']) => (angles, Some(order)),
        _ => (inside, None),
    }
}

/// The numbers of `<Matrix 4x4 (1, 0, 0, 0) ...>`, between whose rows there is no comma.
pub(super) fn rows(code: &Code, name: &str, piece: Piece) -> Result<Vec<f64>, FileError> {
    let (mut numbers, mut rest) = (Vec::new(), piece);
    while let Some(open) = rest.text.find('(') {
        let row = code.bracketed(rest.from(open));
        let row = row.ok_or_else(|| code.fault(name, piece, "its brackets must be closed"))?;
        numbers.extend(code.numbers(name, row)?);
        rest = rest.from(row.at + row.text.len() - rest.at);
    }
    Ok(numbers)
}

/// What is in the angle brackets of `<Vector (1, 0, 0, 0) ...>`; else the piece.
pub(super) fn printed(piece: Piece) -> Piece {
    let inside = piece.text.strip_prefix('<').and_then(|text| text.strip_suffix('>'));
    let open = piece.text.find('(');
    match inside.zip(open) {
        Some((_, open)) => {
            Piece { text: &piece.text[open..piece.text.len() - 1], at: piece.at + open }
        }
        None => piece,
    }
}

/// The owner of a property in a path, be it the whole of it or a part of it that is changed.
pub(super) fn owner<'p>(path: &'p str, property: &str) -> Option<&'p str> {
    let (owner, rest) = path.split_once(property)?;
    (rest.is_empty() || rest.starts_with(['.', '['])).then_some(owner)
}

pub(super) fn is_active(head: &str) -> bool {
    ["context.object", "context.active_object", "C.object", "C.active_object", "objects.active"]
        .iter()
        .any(|end| {
            head.strip_suffix(end).is_some_and(|before| before.is_empty() || before.ends_with('.'))
        })
}

/// A name or several with points between them.
pub(super) fn is_path(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.'))
}

/// Without blanks, and with one kind of quotes.
pub(super) fn plain(text: &str) -> String {
    let quotes = |c: char| if c == '"' { '\'' } else { c };
    text.chars().filter(|c| !c.is_whitespace()).map(quotes).take(2 * LONGEST_PATH).collect()
}

/// The rotation by angles about the axes, that of the first letter first.
pub(super) fn turned(angles: DVec3, order: &str) -> Affine {
    order.chars().rev().fold(Affine::IDENTITY, |frame, axis| {
        let (angle, axis) = match axis {
            'X' => (angles.x, DVec3::X),
            'Y' => (angles.y, DVec3::Y),
            _ => (angles.z, DVec3::Z),
        };
        let turn = Affine::rotation(angle.to_degrees(), axis).unwrap_or(Affine::IDENTITY);
        frame.of(&turn)
    })
}

/// The axes that are not given.
pub(super) fn missing(given: [bool; 3]) -> impl Iterator<Item = &'static str> {
    ["x", "y", "z"].into_iter().zip(given).filter(|(_, given)| !given).map(|(axis, _)| axis)
}
