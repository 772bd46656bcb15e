//! The numbers of rows and columns along the pixel grid, in both views: as many as there is room for.

use egui::Color32;
use pinhole_core::DVec2;

use crate::overlay::{LabelFont, LineStyle, MARK, Request, drawing};

/// Distance between two numbers, in points.
const GAP: f64 = 3.0;

/// Font of the numbers.
const NUMBER: LabelFont = MARK;

/// Returns half of the extent of a number on the screen.
pub(super) fn half_extent(text: &str, scale: f64) -> DVec2 {
    DVec2::from(drawing::half_extent(text, f64::from(NUMBER.0) * scale))
}

/// Returns labels with the numbers of rows or columns that fit beside one another: every one, or every second,
/// fifth, tenth... of them. `first` is the number of the first row or column, 0 or 1, and `place` returns the
/// position for an index and a text; `None` if it is out of sight. Returns nothing if not even two of several
/// fit.
pub(super) fn numbers(
    (pen, halo): (LineStyle, Color32),
    count: u32,
    first: u32,
    scale: f64,
    place: impl Fn(u32, &str) -> Option<DVec2>,
) -> Vec<Request> {
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
            let request = |(at, text)| {
                let request = Request::new(pen, text, [at, DVec2::ZERO], NUMBER, halo);
                Request { is_fixed: true, rank: 0, ..request }
            };
            return placed.into_iter().map(request).collect();
        }
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Item;

    fn texts(count: u32, first: u32, spacing: f64) -> Vec<String> {
        let place = |k: u32, _: &str| Some(DVec2::new(spacing * f64::from(k), 0.0));
        let pen = LineStyle::new(Item::PixelNumbers, Color32::BLACK, 1.0);
        let requests = numbers((pen, Color32::WHITE), count, first, 1.0, place);
        requests.into_iter().map(|request| request.label.text).collect()
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
