//! The numbers of rows and columns along the pixel grid, in both views: as many as there is room for.

use pinhole_core::DVec2;

use crate::overlay::{LabelFont, MARK, drawing};

/// Distance between two numbers, in points.
const GAP: f64 = 3.0;

/// Font of the numbers.
pub(super) const NUMBER: LabelFont = MARK;

/// Returns half of the extent of a number on the screen.
pub(super) fn half_extent(text: &str, scale: f64) -> DVec2 {
    DVec2::from(drawing::half_extent(text, f64::from(NUMBER.0) * scale))
}

/// Returns the numbers of rows or columns that fit beside one another, with their positions: every one, or
/// every second, fifth, tenth... of them. `first` is the number of the first row or column, 0 or 1, and
/// `place` returns the position for an index and a text; `None` if it is out of sight. Returns nothing if not
/// even two of several fit.
pub(super) fn numbers(
    count: u32,
    first: u32,
    scale: f64,
    place: impl Fn(u32, &str) -> Option<DVec2>,
) -> Vec<(String, DVec2)> {
    let steps = (0..10).flat_map(|power| [1, 2, 5].map(|m| m * 10u32.saturating_pow(power)));
    for step in steps.take_while(|step| *step <= count) {
        let numbered = (0..count).filter(|k| *k == 0 || (k + first).is_multiple_of(step));
        let texts = numbered.map(|k| (k, (k + first).to_string()));
        let placed = texts.map(|(k, text)| Some((place(k, &text)?, text)));
        // Numbers closer together than two points of the screen need not be placed.
        let Some(placed) = placed.collect::<Option<Vec<_>>>() else { return Vec::new() };
        let are_apart = |pair: &[(DVec2, String)]| {
            let room = half_extent(&pair[0].1, scale) + half_extent(&pair[1].1, scale);
            let apart = (pair[1].0 - pair[0].0).abs() - room;
            apart.max_element() >= GAP * scale
        };
        let mut placed = placed;
        // The first number counted from 1 is close to the second one.
        if placed.len() > 2 && !are_apart(&placed[..2]) {
            placed.remove(1);
        }
        if placed.windows(2).all(are_apart) && (placed.len() > 1 || count == 1) {
            return placed.into_iter().map(|(at, text)| (text, at)).collect();
        }
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(count: u32, first: u32, spacing: f64) -> Vec<String> {
        let place = |k: u32, _: &str| Some(DVec2::new(spacing * f64::from(k), 0.0));
        numbers(count, first, 1.0, place).into_iter().map(|(text, _)| text).collect()
    }

    #[test]
    fn numbers_are_thinned_out_when_the_grid_is_fine() {
        assert_eq!(texts(4, 0, 30.0), ["0", "1", "2", "3"]);
        assert_eq!(texts(4, 1, 30.0), ["1", "2", "3", "4"]);
        assert_eq!(texts(8, 0, 8.0), ["0", "2", "4", "6"]);
        assert_eq!(texts(8, 1, 8.0), ["1", "4", "6", "8"]);
        assert_eq!(texts(400, 0, 0.5), ["0", "100", "200", "300"]);
        assert_eq!(texts(400, 1, 0.5), ["1", "100", "200", "300", "400"]);
        assert_eq!(texts(400, 0, 0.01), [""; 0]);
        assert_eq!(texts(1, 1, 30.0), ["1"]);
    }
}
