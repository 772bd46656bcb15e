//! A vote by keys and by raised hands, in two rounds.

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::features::vote::state::OpenVote;
use pinhole::ui::app::App;

use crate::harness::{assert_says, command, says, texts_with, window};

/// A window before an audience with an open vote, over a step of a lesson.
fn voting() -> Harness<'static, App> {
    let mut window = window("look-at");
    command(&mut window, "From view and up, 5. A hint, not a vector of the basis");
    press(&mut window, Key::F5);
    command(&mut window, "Guess which");
    window
}

fn press(window: &mut Harness<'_, App>, key: Key) {
    window.key_press(key);
    window.run();
}

fn open(window: &Harness<'_, App>) -> OpenVote {
    window.state().session().shown.mistakes_view.open_vote.clone().unwrap()
}

/// Raises hands with the keyboard alone.
fn count(window: &mut Harness<'_, App>, hands: &str) {
    press(window, Key::H);
    let name = format!("hands in round {}", open(window).round + 1);
    let field = window.get_by_role_and_label(Role::TextInput, &name);
    assert!(field.is_focused(), "H asks for the hands");
    field.type_text(hands);
    window.run();
    press(window, Key::Enter);
}

/// The bar's rectangles of a round: those that are filled, or hollow ones.
fn bars(window: &Harness<'_, App>) -> Vec<(String, egui::Rect)> {
    let labels = window.query_all_by(|node| node.value().is_some_and(|v| v.contains(" hands in ")));
    labels.map(|node| (node.value().unwrap(), node.rect())).collect()
}

#[test]
fn the_keys_a_to_d_choose_and_mean_nothing_else_meanwhile() {
    let mut window = voting();
    for (option, key) in [Key::A, Key::B, Key::C, Key::D].into_iter().enumerate() {
        press(&mut window, key);
        assert_eq!(open(&window).answer, Some(option));
    }
    let presenting = window.state().session().presenting.unwrap();
    assert!(!presenting.is_blank, "B is an option, not the blank screen");
    press(&mut window, Key::Enter);
    assert!(open(&window).is_revealed);
    press(&mut window, Key::A);
    assert_eq!(open(&window).answer, Some(3), "what was chosen stays");
    press(&mut window, Key::B);
    assert!(window.state().session().presenting.unwrap().is_blank, "the vote is over");
}

#[test]
fn hands_are_drawn_as_bars_in_their_proportion_and_the_second_round_beside_the_first() {
    let mut window = voting();
    assert_eq!(bars(&window), []);
    count(&mut window, "12 40 9 3");
    assert_eq!(open(&window).hands[0], Some([12, 40, 9, 3]));
    let first = bars(&window);
    let said: Vec<&str> = first.iter().map(|(said, _)| said.as_str()).collect();
    assert_eq!(
        said,
        [
            "A: 12 hands in round 1",
            "B: 40 hands in round 1",
            "C: 9 hands in round 1",
            "D: 3 hands in round 1"
        ]
    );
    press(&mut window, Key::V);
    count(&mut window, "2 57 4 1");
    assert_eq!(open(&window).hands, [Some([12, 40, 9, 3]), Some([2, 57, 4, 1])]);
    let both = bars(&window);
    assert_eq!(both.len(), 8);
    for (said, rect) in &both {
        assert!(window.ctx.content_rect().contains_rect(*rect), "{said}: {rect}");
    }
    press(&mut window, Key::PageDown);
    assert!(open(&window).is_revealed);
    assert_eq!(bars(&window), both, "nothing moves");
}

/// The filled rectangles that are as wide as a bar of the option with most hands, and others of its height.
fn filled_widths(window: &Harness<'_, App>) -> Vec<f32> {
    let rows: Vec<egui::Rect> = bars(window).into_iter().map(|(_, rect)| rect).collect();
    let shapes = window.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
        egui::Shape::Rect(shape) => Some(shape.rect),
        _ => None,
    });
    let shapes: Vec<egui::Rect> = shapes.collect();
    let bar_in = |row: &egui::Rect| {
        shapes.iter().find(|rect| {
            rect.min.distance(row.min) < 0.5 && rect.height() > 4.0 && rect.height() <= row.height()
        })
    };
    rows.iter().map(|row| bar_in(row).map_or(0.0, |rect| rect.width())).collect()
}

#[test]
fn a_bar_is_as_long_as_its_hands_and_large_enough_for_the_last_row() {
    let mut window = voting();
    for [width, height] in [[819.0, 461.0], [614.0, 461.0]] {
        window.set_size(egui::vec2(width, height));
        window.run();
        count(&mut window, "10 40 0 20");
        let lengths = filled_widths(&window);
        for (length, share) in lengths.iter().zip([0.25, 1.0, 0.0, 0.5]) {
            assert!((length - share * lengths[1]).abs() < 0.5, "{lengths:?}");
        }
        assert!(lengths[1] > 60.0, "{lengths:?}");
        for (said, rect) in bars(&window) {
            assert!(rect.height() >= 12.0, "{said}: {rect}");
        }
    }
}

#[test]
fn bad_numbers_are_explained_and_draw_nothing() {
    let mut window = voting();
    count(&mut window, "12 40 9");
    assert_says(&window, "Give 4 numbers, such as 12 40 9 3: here are 3.");
    assert_eq!((bars(&window), open(&window).hands[0]), (vec![], None));
    let field = window.get_by_role_and_label(Role::TextInput, "hands in round 1");
    field.focus();
    window.run();
    window.get_by_role_and_label(Role::TextInput, "hands in round 1").type_text(" many");
    window.run();
    press(&mut window, Key::Enter);
    assert!(!texts_with(&window, "“many” is no number of hands").is_empty());
    assert!(!says(&window, "NaN"));
}

#[test]
fn page_down_takes_what_is_typed_and_reveals() {
    let mut window = voting();
    press(&mut window, Key::H);
    window.get_by_role_and_label(Role::TextInput, "hands in round 1").type_text("1 2 3 4");
    window.run();
    press(&mut window, Key::PageDown);
    let open = open(&window);
    assert!(open.is_revealed);
    assert_eq!(open.hands[0], Some([1, 2, 3, 4]));
}
