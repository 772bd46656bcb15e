//! The mistakes view: the gallery, its checks, and guessing which.

use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_lecture::mistakes::{Mistake, NoWrongCamera};

use crate::harness::{assert_says, click_at, show, texts_with, type_into, window};

/// As a screen reader does, so that no entry of a list need be scrolled to.
fn click(window: &mut Harness<'_, App>, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click_accesskit();
    window.run();
}

fn open(scene: &str) -> Harness<'static, App> {
    let mut window = window(scene);
    show(&mut window, ViewLayout::Mistakes);
    window
}

fn wrong_says(window: &Harness<'_, App>) -> String {
    window.get_by_role_and_label(Role::Image, "Wrong camera").value().unwrap()
}

/// Everything that is said of a check or number by its value for screen readers.
fn values(window: &Harness<'_, App>, part: &str) -> Vec<String> {
    let nodes = window.root().children_recursive();
    let values = nodes.filter_map(|node| node.accesskit_node().value());
    let is_spoken = |value: &String| value.contains(": ") || value.contains(" = ");
    values.filter(|value| is_spoken(value) && value.contains(part)).collect()
}

#[test]
fn a_closed_gallery_makes_no_wrong_picture() {
    let window = window("look-at");
    let derived = window.state().derived();
    assert!(derived.wrong.is_none() && derived.wrong_view.is_none());
}

#[test]
fn every_mistake_is_one_click_and_shows_or_says_why_not() {
    let mut window = open("look-at");
    for &mistake in Mistake::GALLERY {
        click(&mut window, mistake.name());
        assert_says(&window, &format!("Wrong camera: {}", mistake.name()));
        assert_says(&window, mistake.formula());
        assert_says(&window, mistake.shows());
        let derived = window.state().derived().clone();
        let wrong = derived.wrong.unwrap();
        assert_eq!(wrong.mistake, mistake);
        match wrong.camera {
            Ok(_) => {
                let seen = wrong.seen.unwrap();
                let right = derived.camera_view.unwrap().image;
                let wrong_view = derived.wrong_view.unwrap().image;
                assert_eq!(wrong_view.size, right.size);
                let differs = wrong_view.pixels != right.pixels;
                assert!(seen.differing > 0 && differs, "{mistake}: {seen:?}");
                assert!(wrong_says(&window).starts_with(mistake.name()), "{}", wrong_says(&window));
                let finds = wrong.checks.iter().filter(|check| !check.passes).count();
                assert!(finds > 0);
                assert_eq!(values(&window, " finds it").len(), finds);
            }
            Err(why) => {
                assert_eq!(why, NoWrongCamera::ChangesNothing(mistake));
                assert!(derived.wrong_view.is_none(), "two equal pictures, silently");
                assert_says(&window, &why.to_string());
                assert!(why.to_string().contains(mistake.hint()));
            }
        }
    }
}

#[test]
fn as_printed_is_found_by_one_check_alone() {
    let mut window = open("look-at");
    click(&mut window, Mistake::WAsPrinted.name());
    assert_eq!(values(&window, " finds it"), ["𝐰 · view / |view|: 1 finds it"]);
    assert_says(&window, "1 of 14 checks finds it");
    assert_eq!(values(&window, "passes").len(), 13);
    assert_eq!(values(&window, "wrong w = "), ["wrong w = (−0.80413, −0.15317, −0.57438)"]);
    assert_eq!(values(&window, "wrong v = "), Vec::<String>::new(), "it is right");
}

#[test]
fn a_distance_of_one_says_what_to_change_and_then_it_shows() {
    let mut window = open("look-at");
    click(&mut window, Mistake::DistanceDropped.name());
    let hint = "This changes nothing here. Here the distance is 1: give the viewport another \
                distance.";
    assert_says(&window, hint);
    assert_eq!(wrong_says(&window), hint);
    type_into(&mut window, "distance", "2");
    assert_eq!(texts_with(&window, "This changes nothing here"), Vec::<String>::new());
    assert_says(&window, "distance 2, taken as 1");
    assert!(window.state().derived().wrong_view.is_some());
}

#[test]
fn no_image_is_too_large_for_a_wrong_picture() {
    let mut window = open("look-at");
    // Rows for columns: 9000 of them to the right, where there are 400.
    click(&mut window, Mistake::RowsColumnsSwapped.name());
    type_into(&mut window, "H", "9000");
    assert!(window.state().derived().wrong_view.is_some());
    assert!(wrong_says(&window).starts_with(Mistake::RowsColumnsSwapped.name()));
    // A corner more than the widest image has.
    click(&mut window, Mistake::PixelCorner.name());
    type_into(&mut window, "H", "300");
    type_into(&mut window, "W", "16384");
    assert!(window.state().derived().wrong_view.is_some());
    assert_eq!(texts_with(&window, "must be 1 to 16384"), Vec::<String>::new());
}

#[test]
fn a_click_in_the_wrong_picture_selects_the_same_pixel_in_both() {
    let mut window = open("look-at");
    let before = window.state().derived().wrong_view.clone().unwrap();
    let rect = window.get_by_role_and_label(Role::Image, "Wrong camera").rect();
    let at = rect.min + egui::vec2(0.25, 0.75) * rect.size() + egui::vec2(0.3, 0.3);
    click_at(&mut window, at);
    let pinhole::model::session::Selection::Pixel(pixel) = window.state().session().selection
    else {
        panic!("no pixel is selected")
    };
    assert!(pixel.row.abs_diff(300) <= 1 && pixel.column.abs_diff(100) <= 1, "{pixel:?}");
    let after = window.state().derived().wrong_view.clone().unwrap();
    assert_ne!(before.image.pixels, after.image.pixels, "it is marked");
}

#[test]
fn a_fault_keeps_the_last_pictures() {
    let mut window = open("look-at");
    type_into(&mut window, "up y", "0");
    let derived = window.state().derived();
    assert!(derived.fault.is_some() && derived.wrong_view.is_some());
    type_into(&mut window, "up y", "1");
    assert!(window.state().derived().fault.is_none());
}

#[test]
fn an_idle_gallery_traces_nothing() {
    let mut window = open("look-at");
    let traced = window.state().pictures_traced();
    window.run_steps(3);
    assert_eq!(window.state().pictures_traced(), traced);
}

#[test]
fn guess_which_hides_the_name_checks_the_answer_and_goes_on() {
    let mut window = open("look-at");
    click(&mut window, "Guess which");
    assert_says(&window, "Wrong camera: which mistake is it?");
    assert_says(&window, "Which mistake is it?");
    assert!(values(&window, " finds it").is_empty(), "that would tell");
    let guess = window.state().session().mistakes_view.guess.unwrap();
    assert!(!wrong_says(&window).contains(guess.mistake.name()), "{}", wrong_says(&window));
    assert!(!texts_with(&window, guess.mistake.formula()).iter().any(|_| true));
    // Wrong first: one that gives another picture.
    let other = Mistake::GALLERY.iter().copied().find(|m| {
        let camera = window.state().document().camera;
        let wrong = |mistake| pinhole_lecture::mistakes::WrongCamera::new(&camera, mistake);
        wrong(*m).is_ok_and(|m| !m.sees_the_same(&wrong(guess.mistake).unwrap()))
    });
    let other = other.unwrap();
    click(&mut window, other.name());
    assert_says(&window, &format!("Not {}: it is {}.", other.name(), guess.mistake.name()));
    assert!(!texts_with(&window, "What would have told: ").is_empty());
    assert!(!values(&window, " finds it").is_empty());
    click(&mut window, "Next one");
    let next = window.state().session().mistakes_view.guess.unwrap();
    assert_ne!(next.mistake, guess.mistake);
    assert_eq!(next.answer, None);
    click(&mut window, next.mistake.name());
    assert_says(&window, &format!("Right: {}.", next.mistake.name()));
    click(&mut window, "Gallery");
    assert_eq!(window.state().session().mistakes_view.guess, None);
    assert_says(&window, &format!("Wrong camera: {}", next.mistake.name()));
}
