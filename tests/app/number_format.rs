//! One number format in the whole window: the real minus, and counts with their digits in groups.

use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::{Preferences, Settings, Setup, Unfolded, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;

use super::harness::{assert_says, type_into, unfolded, window_with};

/// Returns every name and value in the window but those of text that is being typed.
fn texts(window: &Harness<'_, App>) -> Vec<String> {
    let read = |node: egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        let is_typed =
            node.role() == Role::TextInput || node.role() == Role::SpinButton && node.is_focused();
        let value = node.value().filter(|_| !is_typed);
        [node.label(), value, node.description()]
    };
    window.root().children_recursive().flat_map(read).flatten().collect()
}

/// Returns the parts of a text that are not in the window's number format.
fn faults(text: &str) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let at = |k: usize| letters.get(k).copied().unwrap_or(' ');
    let is_digit = |k: usize| at(k).is_ascii_digit();
    let around = |k: usize| letters[k.saturating_sub(8)..letters.len().min(k + 8)].iter().collect();
    let mut faults = Vec::new();
    for k in 0..letters.len() {
        let is_joined = k > 0 && (at(k - 1).is_alphabetic() && at(k - 1) != 'e');
        let is_minus = at(k) == '-' && (is_digit(k + 1) || at(k + 1) == '.') && !is_joined;
        let separates = [' ', '\u{2009}', '\u{202f}', '\''].contains(&at(k));
        let is_group = separates
            && k > 0
            && is_digit(k - 1)
            && (k + 1..k + 4).all(is_digit)
            && !is_digit(k + 4);
        if is_minus || is_group {
            faults.push(around(k));
        }
    }
    let counted = ["decisions", "pixels", "spheres", "ulps"];
    let words: Vec<&str> = text.split_whitespace().collect();
    let counts =
        words.windows(2).filter(|pair| counted.iter().any(|unit| pair[1].starts_with(unit)));
    let is_long = |count: &str| count.len() > 4 && count.chars().all(|c| c.is_ascii_digit());
    faults.extend(counts.map(|pair| pair[0]).filter(|count| is_long(count)).map(str::to_owned));
    faults
}

#[test]
fn the_faults_are_found() {
    for text in
        ["x = -1", "(0, -0.5)", "1e-9", "189489 decisions", "160 000 pixels", "160\u{202f}000"]
    {
        assert!(!faults(text).is_empty(), "{text}");
    }
    for text in ["−1", "sphere 2-a", "row 1, column 200", "ray-sphere", "82,369 of 90,000 pixels"]
    {
        assert_eq!(faults(text), Vec::<String>::new());
    }
}

#[test]
fn every_number_in_the_window_is_written_in_one_way() {
    let layouts = [
        ViewLayout::Both,
        ViewLayout::Derivation,
        ViewLayout::Plot,
        ViewLayout::Lines,
        ViewLayout::Compare,
        ViewLayout::Mistakes,
        ViewLayout::Exercises,
    ];
    let everywhere =
        ["canonical", "look-at"].into_iter().flat_map(|scene| layouts.map(|l| (scene, l)));
    let further = ["inside", "almost-parallel-up", "tiny-far", "planet", "non-square"];
    let further = further.map(|scene| (scene, ViewLayout::Derivation));
    for (scene, layout) in everywhere.chain(further) {
        let settings =
            Settings { setup: Setup { layout, teaching: true, ..Setup::default() }, ..unfolded() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut window = window_with(scene, remembered, None);
        for (field, text) in [("eye x", "-1.25"), ("eye y", "-12345.678")] {
            if window.query_by_role_and_label(Role::SpinButton, field).is_some() {
                type_into(&mut window, field, text);
            }
        }
        // What may be typed is shown as it is typed.
        for text in texts(&window).into_iter().filter(|text| !text.contains("You may type")) {
            let faults = faults(&text);
            assert!(faults.is_empty(), "{scene}, {layout:?}: {faults:?} in “{text}”");
        }
    }
}

#[test]
fn the_strip_has_the_digits_of_the_settings_and_calls_no_rounded_number_equal() {
    let unfolded = Unfolded { ray: true, ..Unfolded::default() };
    for (digits, uv, u) in [
        (5, "(u, v) = (−0.21375, 0.11875)", "u ≈ (0.58124, 0, −0.81373)"),
        (4, "(u, v) ≈ (−0.2138, 0.1188)", "u ≈ (0.5812, 0, −0.8137)"),
    ] {
        let settings = Settings {
            setup: Setup { digits, ..Setup::default() },
            preferences: Preferences { unfolded, ..Preferences::default() },
        };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut window = window_with("look-at", remembered, None);
        type_into(&mut window, "uv u", "-0.21375");
        type_into(&mut window, "uv v", "0.11875");
        assert_says(&window, uv);
        assert_says(&window, u);
    }
}

#[test]
fn fields_have_the_digits_of_the_settings() {
    let value = |digits| {
        let settings = Settings { setup: Setup { digits, ..Setup::default() }, ..unfolded() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let window = window_with("canonical", remembered, None);
        window.get_by_role_and_label(Role::SpinButton, "horizontal field of view").value()
    };
    assert_eq!(value(5).as_deref(), Some("53.13°"));
    assert_eq!(value(3).as_deref(), Some("53.1°"));
}
