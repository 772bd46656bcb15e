//! What the class reads while presenting, in every state of every step: its letters are large, and a number is
//! rounded in one way.

use egui::{Key, Rect};

use super::directed::{SIZES, open, presented};
use super::{Window, shown_step};
use crate::app::painted_texts::texts;

/// Calls a function in every state of every step: the question, each line, the answer and an exercise's solution.
fn in_all_states(mut is_seen: impl FnMut(&Window, &str)) {
    let mut window = presented(SIZES[0]);
    open(&mut window, 1, 1);
    let mut count = 0;
    loop {
        let ((lesson, step), session) = (shown_step(&window), window.state().session().clone());
        count += 1;
        is_seen(&window, &format!("{lesson}.{step} state {count}"));
        window.key_press(Key::PageDown);
        window.run();
        if shown_step(&window) == (lesson, step) && *window.state().session() == session {
            break;
        }
    }
    assert!(count > 110, "{count} states");
}

/// The least distance between two rows that the class reads at 1920 x 1080, in pixels.
const PITCH: f32 = 55.0;

/// The rows of the column but for its title and its notes, which are weak.
fn rows(window: &Window) -> Vec<Rect> {
    let weak = window.ctx.global_style().visuals.weak_text_color();
    let figure = 0.58 * SIZES[0].x;
    let runs = texts(window).into_iter().filter(|run| run.color != weak);
    let rows = runs.flat_map(|run| run.rows).filter(|row| row.left() > figure);
    let mut rows: Vec<Rect> = rows.collect();
    rows.sort_by(|a, b| a.center().y.total_cmp(&b.center().y));
    // The parts of a formula are beside, above and below each other.
    let core = |row: Rect| {
        row.with_min_y(row.center().y - 0.3 * row.height())
            .with_max_y(row.center().y + 0.3 * row.height())
    };
    let mut merged: Vec<Rect> = Vec::new();
    for row in rows.into_iter().map(core) {
        match merged.last_mut().filter(|last| last.bottom() > row.top()) {
            Some(last) if row.height() > last.height() => *last = row,
            Some(_) => {}
            None => merged.push(row),
        }
    }
    merged
}

#[test]
fn what_the_class_reads_has_a_line_pitch_of_55_pixels() {
    let mut small = Vec::new();
    in_all_states(|window, name| {
        let rows = rows(window);
        let pitch = rows.windows(2).map(|pair| pair[1].center().y - pair[0].center().y);
        let least = pitch.fold(f32::INFINITY, f32::min) * 1080.0 / SIZES[0].y;
        // The solution of five vectors and numbers fills the column.
        let wanted = if name.starts_with("6.6 ") { 52.0 } else { PITCH };
        if least < wanted {
            small.push(format!("{name}: {least:.1}"));
        }
    });
    assert!(small.is_empty(), "{}", small.join("\n"));
}

/// The numbers with decimals in a text.
fn decimals(text: &str) -> Vec<String> {
    let is_other = |letter: char| !letter.is_ascii_digit() && letter != '.';
    let numbers = text.split(is_other).map(|number| number.trim_matches('.').to_owned());
    numbers.filter(|number| number.contains('.') && number.parse::<f64>().is_ok()).collect()
}

/// Returns true if one number has fewer decimals than another one, of which it is a rounding.
fn is_rounding(short: &str, long: &str) -> bool {
    let places = |number: &str| number.split_once('.').map_or(0, |(_, places)| places.len());
    let significant = short.replace('.', "").trim_start_matches('0').len();
    let long_value: f64 = long.parse().unwrap();
    let rounded = format!("{:.*}", places(short), long_value + 1e-9);
    significant > 1 && places(short) < places(long) && rounded == short
}

#[test]
fn a_number_is_rounded_in_one_way_on_one_screen() {
    let mut found = Vec::new();
    in_all_states(|window, name| {
        let mut numbers: Vec<String> =
            texts(window).iter().flat_map(|run| decimals(&run.text)).collect();
        numbers.sort();
        numbers.dedup();
        for short in &numbers {
            let other = numbers.iter().filter(|long| is_rounding(short, long));
            found.extend(other.map(|long| format!("{name}: {short} and {long}")));
        }
    });
    assert!(found.is_empty(), "{}", found.join("\n"));
}
