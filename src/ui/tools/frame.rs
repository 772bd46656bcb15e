//! The frame view: what the pictures left out, and what was left to do, in plain words.

use egui::{FontId, Grid, RichText, ScrollArea, Ui};
use pinhole_core::{Counts, Steps};

use crate::ui::scene::views::{CAMERA, WORLD};
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;

/// Size of the text, in points: for the back row.
const TEXT: f32 = 15.0;

/// A line: what is counted, what that means, and how to say it of a picture.
type Line = (&'static str, &'static str, fn(&Counts, &Steps) -> String);

const LINES: [Line; 13] = [
    (
        "spheres",
        "All spheres of the scene; the world view draws those around the observer or the camera as \
         circles and does not trace them",
        |c, _| c.spheres.to_string(),
    ),
    ("behind the eye", "Skipped: they lie wholly behind the eye", |c, _| c.behind.to_string()),
    (
        "outside the picture, or between two rows",
        "Skipped: they lie outside the picture, or are so small that they fall between the centres \
         of two rows of its pixels",
        |c, _| c.outside.to_string(),
    ),
    ("in view", "Their outlines reach rows of the picture, hidden or not", |c, _| {
        c.in_view.to_string()
    }),
    (
        "hidden by nearer spheres",
        "Nearer spheres hide all of it in a band of rows. Counted once for each such band, so it can \
         be more than there are spheres; scenes of fewer than 256 spheres are not tested for it",
        |c, _| c.hidden.to_string(),
    ),
    (
        "index blocks skipped",
        "Many spheres are kept in blocks of neighbours; a block is skipped as a whole; a scene of few \
         spheres needs no index",
        |c, _| match c.blocks {
            0 => "no index".to_owned(),
            blocks => share(c.blocks_left_out, blocks),
        },
    ),
    ("planes tested", "A plane that is the same as an earlier one is skipped", |c, _| {
        share(c.planes_asked, c.planes)
    }),
    (
        "bands without a hit",
        "Threads trace bands of rows; one that nothing reaches is only background",
        |c, _| share(c.bands_untouched, c.bands),
    ),
    ("rows that nothing reaches", "No object's outline reaches them: only background", |c, _| {
        share(c.rows_untouched, c.rows)
    }),
    (
        "decided in f64",
        "Hit or miss, and which is first, settled within f64's error bound",
        |_, s| s.f64.to_string(),
    ),
    ("in double-double", "Too close for f64: settled with twice the digits", |_, s| {
        s.double_double.to_string()
    }),
    ("exactly", "Too close for that too: settled in whole numbers, without rounding", |_, s| {
        s.exact.to_string()
    }),
    ("all decisions", "Each is what one ray decides about one object", |_, s| {
        s.total().to_string()
    }),
];

fn share(part: u64, all: u64) -> String {
    format!("{part} of {all}")
}

/// Shows a line a count, a column a picture.
pub(crate) fn ui(ui: &mut Ui, derived: &Derived) {
    ui.style_mut().override_font_id = Some(FontId::proportional(TEXT));
    let camera = derived.counts.zip(derived.steps);
    let world = derived.world_frame.as_ref().map(|frame| (frame.counts, frame.steps));
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        ui.spacing_mut().interact_size.y = 19.0;
        Grid::new("counts").striped(true).num_columns(3).spacing([12.0, 3.0]).show(ui, |ui| {
            ui.strong("Skipped, and done");
            for name in [CAMERA, WORLD] {
                ui.strong(name);
            }
            ui.end_row();
            for (name, hint, say) in LINES {
                ui.label(name).on_hover_text(hint);
                for (view, counted) in [(CAMERA, camera), (WORLD, world)] {
                    let text = counted.map_or("-".to_owned(), |(c, s)| say(&c, &s));
                    let spoken = format!("{view}, {name}: {text}");
                    let label = ui.label(RichText::new(text).strong()).spoken(spoken);
                    label.on_hover_text(hint);
                }
                ui.end_row();
            }
        });
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(counts: &Counts, steps: &Steps) -> Vec<String> {
        LINES.iter().map(|(name, _, say)| format!("{name}: {}", say(counts, steps))).collect()
    }

    #[test]
    fn a_large_scene_in_words() {
        let mut counts = Counts::default();
        counts.spheres = 1_000_000;
        counts.behind = 250_000;
        counts.outside = 738_000;
        counts.in_view = 12_000;
        counts.hidden = 4_321;
        counts.planes = 2;
        counts.planes_asked = 1;
        counts.blocks = 62_500;
        counts.blocks_left_out = 40_000;
        counts.bands = 34;
        counts.bands_untouched = 5;
        counts.rows = 1080;
        counts.rows_untouched = 163;
        let mut steps = Steps::default();
        (steps.f64, steps.double_double, steps.exact) = (2_100_000, 12, 3);
        let expected = [
            "spheres: 1000000",
            "behind the eye: 250000",
            "outside the picture, or between two rows: 738000",
            "in view: 12000",
            "hidden by nearer spheres: 4321",
            "index blocks skipped: 40000 of 62500",
            "planes tested: 1 of 2",
            "bands without a hit: 5 of 34",
            "rows that nothing reaches: 163 of 1080",
            "decided in f64: 2100000",
            "in double-double: 12",
            "exactly: 3",
            "all decisions: 2100015",
        ];
        assert_eq!(said(&counts, &steps), expected);
    }

    #[test]
    fn a_small_scene_has_no_index() {
        let lines = said(&Counts::default(), &Steps::default());
        assert!(lines.contains(&"index blocks skipped: no index".to_owned()), "{lines:?}");
    }
}
