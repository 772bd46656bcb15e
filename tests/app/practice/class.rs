//! A class's answers: copied as codes, collected, and counted.

use egui::Event;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use super::exercises::{answers, open};
use crate::app::presenter::press;
use crate::harness::{assert_says, copied_text, show, texts_with, window};

fn click(window: &mut Harness<'_, App>, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click_accesskit();
    window.run();
}

/// The code of answers that a student has typed.
fn copied(window: &mut Harness<'_, App>, t: &str) -> String {
    answers(window, "t", &[t]);
    answers(window, "point", &["0", "0", &format!("-{t}")]);
    answers(window, "normal", &["0", "0", "1"]);
    window.get_by_role_and_label(Role::Button, "Copy my answer").click_accesskit();
    let code = copied_text(window);
    assert_says(window, "The code of your answer is on the clipboard");
    code
}

#[test]
fn copied_codes_are_pasted_and_counted() {
    let mut student = open(Exercise::Sphere);
    let copy = student.get_by_role_and_label(Role::Button, "Copy my answer");
    assert!(copy.accesskit_node().is_disabled(), "nothing is typed");
    let right = copied(&mut student, "4");
    let told = "For your lecturer. It contains your answers, but not your name.";
    assert_says(&student, told);
    answers(&mut student, "t", &["4 sqrt"]);
    let copy = student.get_by_role_and_label(Role::Button, "Copy my answer");
    assert!(copy.accesskit_node().is_disabled(), "t cannot be read");
    click(&mut student, "Show the solution");
    click(&mut student, "Hide the solution");
    let far = copied(&mut student, "6");
    let told = told.replace(", but", " and that you saw the solution, but");
    assert_says(&student, &told);
    let mut lecturer = window("canonical");
    lecturer.event(Event::Paste(format!("Anna: {right}\nBert: {far}")));
    lecturer.run();
    assert_eq!(lecturer.state().session().shown.setup.layout, ViewLayout::Class);
    assert_says(&lecturer, "A ray and a sphere: 2 answers, 1 after a look at the solution");
    assert_says(&lecturer, "right: 1");
    assert_says(&lecturer, "far-root: 1");
    // More come one by one, one of them cut off.
    lecturer.event(Event::Paste(format!("{far}\n{}", &right[..right.len() - 4])));
    lecturer.run();
    assert_says(&lecturer, "far-root: 2");
    assert_says(&lecturer, "Not readable: 1");
    assert_says(&lecturer, "The code in line 4 is cut off: copy it again as a whole.");
    // The names beside the codes are not shown to the class.
    assert!(!texts_with(&lecturer, "Anna").is_empty());
    press(&mut lecturer, egui::Key::F5);
    assert_says(&lecturer, "far-root: 2");
    assert_eq!(texts_with(&lecturer, "Anna"), Vec::<String>::new());
    assert_eq!(texts_with(&lecturer, "The code in line"), Vec::<String>::new());
    press(&mut lecturer, egui::Key::F5);
    click(&mut lecturer, "Remove all codes");
    assert!(texts_with(&lecturer, "far-root").is_empty());
    click(&mut lecturer, "Bring the codes back");
    assert_says(&lecturer, "far-root: 2");
    click(&mut lecturer, "Remove all codes");
    assert!(
        texts_with(&lecturer, "far-root").is_empty() && texts_with(&lecturer, "Anna").is_empty()
    );
}

#[test]
fn an_empty_page_tells_the_class_what_to_do() {
    let mut window = window("canonical");
    show(&mut window, ViewLayout::Class);
    press(&mut window, egui::Key::F5);
    assert!(!texts_with(&window, "Copy my answer puts a code").is_empty());
}

#[test]
fn codes_are_typed_into_the_page() {
    let mut window = window("canonical");
    show(&mut window, ViewLayout::Class);
    window.get_by_role_and_label(Role::MultilineTextInput, "codes").focus();
    window.run();
    window.event(Event::Text("Hello answer1/sphere/7".to_owned()));
    window.run();
    assert_says(&window, "The code in line 1 is cut off: copy it again as a whole.");
}
