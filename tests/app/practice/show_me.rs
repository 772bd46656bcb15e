//! *Show me*: a mistake that a verdict names, as a ghost in the exercise's figure.

use egui::accesskit::{Role, Toggled};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use super::exercises::{answer, answers, choose, click, drawn, open};
use crate::harness::texts_with;

const BUTTON: &str = "Show me";
const W: [&str; 3] = ["0", "-1", "0"];

/// The labels of the ghost in the figure.
fn ghost(window: &Harness<'_, App>) -> Vec<String> {
    let labels = &window.state().derived().world_view.as_ref().unwrap().labels;
    let texts = labels.iter().map(|label| label.text.clone());
    texts.filter(|text| text == "wrong camera" || text.contains('′')).collect()
}

fn has_button(window: &Harness<'_, App>) -> bool {
    !texts_with(window, BUTTON).is_empty()
}

/// Presses the only such button.
#[track_caller]
fn press(window: &mut Harness<'_, App>) {
    let names = texts_with(window, BUTTON);
    assert_eq!(names.len(), 1, "{names:?}");
    click(window, &names[0]);
}

#[test]
fn a_mistake_is_shown_with_the_students_numbers() {
    let mut window = open(Exercise::ViewUp);
    answers(&mut window, "w", &W);
    click(&mut window, "Check");
    assert!(!has_button(&window), "u and v are not answered yet");
    answers(&mut window, "u", &["0", "0", "-1"]);
    answers(&mut window, "v", &["1", "0", "0"]);
    click(&mut window, "Check");
    assert_eq!(ghost(&window), [""; 0]);
    press(&mut window);
    let button = window.get_by_role_and_label(Role::Button, "Show me: 𝐰 without the minus");
    assert_eq!(button.accesskit_node().toggled(), Some(Toggled::True));
    assert!(ghost(&window).contains(&"wrong camera".to_owned()));
    let right = ["right", "drawn: u,", ", w,"];
    assert!(right.iter().all(|part| !drawn(&window).contains(part)), "{}", drawn(&window));
    assert!(drawn(&window).ends_with("wrong camera (dashed)"));
    press(&mut window);
    assert_eq!(ghost(&window), [""; 0], "again, it goes");
    press(&mut window);
    answer(&mut window, "w y", "1");
    assert_eq!(ghost(&window), [""; 0], "the answer has changed");
    answer(&mut window, "w y", "-1");
    click(&mut window, "Check");
    assert_eq!(ghost(&window), [""; 0], "it does not come back by itself");
    press(&mut window);
    choose(&mut window, Exercise::EyeAtUp);
    choose(&mut window, Exercise::ViewUp);
    assert_eq!(ghost(&window), [""; 0], "another question has been asked");
}

#[test]
fn a_dropped_distance_is_shown_and_a_sign_is_not_one_of_a_camera() {
    let mut window = open(Exercise::Distance);
    answers(&mut window, "d", &["0.2", "-0.1", "-1"]);
    click(&mut window, "Check");
    press(&mut window);
    assert_eq!(ghost(&window), ["wrong camera", "(0, 0)′"]);
    answers(&mut window, "d", &["0.2", "-0.1", "2"]);
    click(&mut window, "Check");
    assert!(!has_button(&window));
}
