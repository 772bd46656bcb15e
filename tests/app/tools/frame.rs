//! The frame view: what the pictures leave out.

use egui_kittest::Harness;
use pinhole::model::session::{Settings, Split, Splits, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_core::{Counts, Steps};

use crate::harness::{assert_says, show, texts_with, type_into, unfolded, window, window_with};

fn open(window: &mut Harness<'_, App>) {
    show(window, ViewLayout::Frame);
}

/// What is said of a picture, of numbers below a thousand.
#[track_caller]
fn assert_counts(window: &Harness<'_, App>, view: &str, counts: &Counts, steps: &Steps) {
    let share = |part: u64, all: u64| format!("{part} of {all}");
    for (name, text) in [
        ("spheres", counts.spheres.to_string()),
        ("behind the eye", counts.behind.to_string()),
        ("outside the picture, or between two rows", counts.outside.to_string()),
        ("in view", counts.in_view.to_string()),
        ("planes tested", share(counts.planes_asked, counts.planes)),
        ("bands without a hit", share(counts.bands_untouched, counts.bands)),
        ("rows that nothing reaches", share(counts.rows_untouched, counts.rows)),
        ("index blocks skipped", "no index".to_owned()),
        ("in double-double", steps.double_double.to_string()),
        ("exactly", steps.exact.to_string()),
    ] {
        assert_says(window, &format!("{view}, {name}: {text}"));
    }
}

#[test]
fn both_pictures_counts_are_those_of_what_was_traced() {
    let mut window = window("canonical");
    type_into(&mut window, "W", "30");
    type_into(&mut window, "H", "20");
    open(&mut window);
    let derived = window.state().derived().clone();
    let (counts, steps) = (derived.counts.unwrap(), derived.steps.unwrap());
    assert!(steps.total() > 0, "the lecture's ball is in view");
    assert_counts(&window, "Camera view", &counts, &steps);
    let world = derived.world_frame.unwrap();
    assert_counts(&window, "World view", &world.counts, &world.steps);
    assert_says(&window, &format!("Camera view, all decisions: {}", steps.total()));
    // Turned away from both balls, the camera has less to decide.
    type_into(&mut window, "at z", "1");
    let turned = window.state().derived().clone();
    assert!(turned.steps.unwrap().total() < steps.total());
    assert_counts(&window, "Camera view", &turned.counts.unwrap(), &turned.steps.unwrap());
}

#[test]
fn the_lectures_balls_are_counted_where_they_are() {
    let mut window = window("canonical");
    let told = |c: &Counts| (c.spheres, c.behind, c.outside, c.in_view, c.hidden, c.blocks);
    let counted = |window: &Harness<'_, App>| {
        let derived = window.state().derived();
        (told(&derived.counts.unwrap()), told(&derived.world_frame.as_ref().unwrap().counts))
    };
    let both_in_view = (2, 0, 0, 2, 0, 0);
    assert_eq!(counted(&window), (both_in_view, both_in_view));
    type_into(&mut window, "at z", "1");
    assert_eq!(counted(&window), ((2, 2, 0, 0, 0, 0), both_in_view), "the observer stays");
    type_into(&mut window, "at z", "-1");
    type_into(&mut window, "eye y", "50");
    type_into(&mut window, "at y", "50");
    assert_eq!(counted(&window).0, (2, 0, 2, 0, 0, 0));
}

#[test]
fn a_fault_leaves_the_last_counts() {
    let mut window = window("canonical");
    open(&mut window);
    let before = texts_with(&window, "Camera view, all decisions: ");
    type_into(&mut window, "up y", "0");
    assert!(window.state().derived().fault.is_some());
    assert_eq!(texts_with(&window, "Camera view, all decisions: "), before);
}

#[test]
fn the_view_is_remembered() {
    let mut splits = Splits::default();
    splits.set(Split::Frame, 321.0);
    let settings = Settings { layout: ViewLayout::Frame, splits, ..unfolded() };
    let text = serde_json::to_string(&settings).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), settings);
    splits.set(Split::Frame, f32::NAN);
    assert_eq!(splits, Splits::default());
    let remembered = Remembered { settings, ..Remembered::default() };
    let window = window_with("canonical", remembered, None);
    assert_eq!(texts_with(&window, "Camera view, all decisions: ").len(), 1);
}
