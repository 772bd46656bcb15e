//! The mistakes view: the gallery, its checks, and guessing which.

use egui::accesskit::{Role, Toggled};
use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::features::vote::OpenVote;
use pinhole::model::session::ViewLayout;
use pinhole::model::session::presenting::{self, SMALLEST_TEXT};
use pinhole::ui::app::App;
use pinhole_lecture::mistakes::Mistake;

use crate::harness::{
    assert_says, click_at, command, show, texts_with, type_into, window, window_with,
};

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
    window
        .get_by_role_and_label(Role::Image, "Wrong camera")
        .accesskit_node()
        .description()
        .unwrap()
}

/// Everything that is said of a check or number by its value for screen readers.
fn values(window: &Harness<'_, App>, part: &str) -> Vec<String> {
    let nodes = window.root().children_recursive();
    let values = nodes.filter_map(|node| node.accesskit_node().value());
    let is_spoken = |value: &String| [": ", " = ", " ≈ "].iter().any(|sign| value.contains(sign));
    values.filter(|value| is_spoken(value) && value.contains(part)).collect()
}

#[test]
fn a_closed_gallery_makes_no_wrong_picture() {
    let window = window("look-at");
    let derived = window.state().derived();
    assert!(derived.second_view.is_none());
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
        let wrong = derived.wrong_camera.as_deref().unwrap();
        assert_eq!(wrong.mistake, mistake);
        match &wrong.camera {
            Ok(_) => {
                let seen = wrong.compared.unwrap();
                let right = &derived.camera_view.as_ref().unwrap().image;
                let wrong_view = &derived.second_view.as_ref().unwrap().image;
                assert_eq!(wrong_view.size, right.size);
                let differs = wrong_view.pixels != right.pixels;
                assert!(seen.differing > 0 && differs, "{mistake}: {seen:?}");
                assert!(wrong_says(&window).starts_with(mistake.name()), "{}", wrong_says(&window));
                let finds = wrong.checks.iter().filter(|check| !check.passes).count();
                assert!(finds > 0);
                assert_eq!(values(&window, " catches it").len(), finds);
            }
            Err(why) => {
                assert!(why.starts_with("This changes nothing here. "), "{why}");
                assert!(derived.second_view.is_none(), "two equal pictures, silently");
                assert_says(&window, why);
                assert!(why.contains(mistake.hint()));
            }
        }
    }
}

/// Lets the scene rest until all thumbnails are traced.
fn rest(window: &mut Harness<'_, App>) {
    window.run_steps(80);
}

/// In which scene a thumbnail shows its mistake.
fn shown_in(window: &Harness<'_, App>, mistake: Mistake) -> String {
    let thumbnail = window.get_by_role_and_label(Role::Button, mistake.name());
    thumbnail.accesskit_node().description().unwrap()
}

#[test]
fn a_mistake_that_the_open_scene_does_not_show_is_shown_in_one_that_can_be_opened() {
    let mut window = open("canonical");
    rest(&mut window);
    assert_eq!(shown_in(&window, Mistake::LeftHanded), "In the open scene");
    assert_eq!(shown_in(&window, Mistake::WAsPrinted), "In the scene “roll”", "no empty sky");
    assert_eq!(shown_in(&window, Mistake::AspectDropped), "In the scene “non-square”");
    assert_says(&window, "Another scene shows this mistake better:");
    click(&mut window, Mistake::AspectDropped.name());
    type_into(&mut window, "W", "300");
    click(&mut window, "Open the scene “non-square”");
    assert_says(&window, "Save the changes to canonical?");
    click(&mut window, "Discard");
    rest(&mut window);
    assert_says(&window, &format!("Wrong camera: {}", Mistake::AspectDropped.name()));
    assert_eq!(shown_in(&window, Mistake::AspectDropped), "In the open scene");
    assert_eq!(texts_with(&window, "shows this mistake better"), Vec::<String>::new());
}

#[test]
fn thumbnails_follow_the_scene_once_it_rests() {
    let mut window = open("canonical");
    rest(&mut window);
    let field = window.get_by_role_and_label(Role::SpinButton, "distance").rect().center();
    window.hover_at(field);
    window.drag_at(field);
    window.hover_at(field + vec2(80.0, 0.0));
    rest(&mut window);
    assert_ne!(window.state().document().camera.viewport.distance, 1.0);
    assert_eq!(shown_in(&window, Mistake::DistanceDropped), "In the scene “distance-two”");
    window.drop_at(field + vec2(80.0, 0.0));
    rest(&mut window);
    assert_eq!(shown_in(&window, Mistake::DistanceDropped), "In the open scene");
    let idle = window.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
    assert!(idle.as_secs() > 1, "{idle:?}");
}

#[test]
fn thumbnails_are_chosen_by_keys_in_every_window() {
    for (size, chosen) in [
        ([1280.0, 800.0], Mistake::NotNormalized),
        ([1920.0, 1080.0], Mistake::PixelCorner),
        // In a menu, only the keys up and down move.
        ([737.0, 900.0], Mistake::WIsAtMinusEye),
        ([390.0, 844.0], Mistake::WIsAtMinusEye),
    ] {
        let mut window = open("canonical");
        window.set_size(size.into());
        window.run();
        if let Some(menu) = window.query_by_label("mistake") {
            menu.click();
            window.run();
        }
        let first = window.get_by_role_and_label(Role::Button, Mistake::WAsPrinted.name());
        assert_eq!(first.accesskit_node().toggled(), Some(Toggled::True));
        first.focus();
        window.run();
        for key in [egui::Key::ArrowRight, egui::Key::ArrowDown] {
            window.key_press(key);
            window.run();
        }
        let thumbnail = window.get_by_role_and_label(Role::Button, chosen.name());
        assert!(thumbnail.accesskit_node().is_focused(), "{chosen} at {size:?}");
        assert_eq!(thumbnail.accesskit_node().toggled(), Some(Toggled::False));
        assert!(window.ctx.content_rect().contains_rect(thumbnail.rect()), "{size:?}");
        window.key_press(egui::Key::Enter);
        window.run();
        assert_eq!(window.state().session().shown.mistakes_view.chosen, chosen);
    }
}

#[test]
fn as_printed_is_found_by_one_check_alone() {
    let mut window = open("look-at");
    click(&mut window, Mistake::WAsPrinted.name());
    assert_eq!(values(&window, " catches it"), ["𝐰 · view / |view|: 1 catches it"]);
    assert_says(&window, "1 of 14 checks catches it");
    assert_eq!(values(&window, "passes").len(), 13);
    assert_eq!(values(&window, "wrong w "), ["wrong w ≈ (−0.80413, −0.15317, −0.57438)"]);
    assert_eq!(values(&window, "wrong v "), Vec::<String>::new(), "it is right");
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
    assert!(window.state().derived().second_view.is_some());
}

#[test]
fn no_image_is_too_large_for_a_wrong_picture() {
    let mut window = open("look-at");
    // Rows for columns: 9000 of them to the right, where there are 400.
    click(&mut window, Mistake::RowsColumnsSwapped.name());
    type_into(&mut window, "H", "9000");
    assert!(window.state().derived().second_view.is_some());
    assert!(wrong_says(&window).starts_with(Mistake::RowsColumnsSwapped.name()));
    // A corner more than the widest image has.
    click(&mut window, Mistake::PixelCorner.name());
    type_into(&mut window, "H", "300");
    type_into(&mut window, "W", "16384");
    assert!(window.state().derived().second_view.is_some());
    assert_eq!(texts_with(&window, "must be 1 to 16384"), Vec::<String>::new());
}

#[test]
fn compared_pictures_take_the_room_that_is_there() {
    let mut window = open("canonical");
    window.set_size(vec2(1024.0, 768.0));
    window.run();
    for name in ["Camera view", "Wrong camera"] {
        let height = window.get_by_role_and_label(Role::Image, name).rect().height();
        assert!(height > 200.0, "{name}: {height}");
    }
}

#[test]
fn a_click_in_the_wrong_picture_selects_the_same_pixel_in_both() {
    let mut window = open("look-at");
    let before = window.state().derived().second_view.as_ref().unwrap().clone();
    let rect = window.get_by_role_and_label(Role::Image, "Wrong camera").rect();
    let at = rect.min + egui::vec2(0.25, 0.75) * rect.size() + egui::vec2(0.3, 0.3);
    click_at(&mut window, at);
    let pinhole_core::Selection::Pixel(pixel) = window.state().session().shown.selection else {
        panic!("no pixel is selected")
    };
    assert!(pixel.row.abs_diff(300) <= 1 && pixel.column.abs_diff(100) <= 1, "{pixel:?}");
    let after = window.state().derived().second_view.as_ref().unwrap().clone();
    assert_ne!(before.image.pixels, after.image.pixels, "it is marked");
}

#[test]
fn a_fault_keeps_the_last_pictures() {
    let mut window = open("look-at");
    type_into(&mut window, "up y", "0");
    let derived = window.state().derived();
    assert!(derived.fault.is_some() && derived.second_view.is_some());
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
fn a_mistakes_camera_stands_in_the_world_view_as_a_ghost() {
    let mut window = open("look-at");
    let labels = |window: &Harness<'_, App>| -> Vec<String> {
        let shown = window.state().derived().world_view.clone().unwrap();
        shown.labels.iter().map(|label| label.text.clone()).collect()
    };
    click(&mut window, Mistake::VIsUCrossW.name());
    let shown = labels(&window);
    assert!(shown.contains(&"v′".to_owned()), "{shown:?}");
    assert!(!shown.contains(&"u′".to_owned()), "it is right: {shown:?}");
    assert!(window.state().derived().answer_marks.iter().any(|twin| twin.label == "ray′"));
    // The wrong camera is no ghost of the user's.
    assert_eq!(window.state().session().shown.ghost, None);
    click(&mut window, "Guess which");
    let shown = labels(&window);
    assert!(shown.iter().all(|label| !label.contains('′')), "that would tell: {shown:?}");
    assert!(window.state().derived().answer_marks.is_empty());
    window.key_press(egui::Key::Enter);
    window.run();
    assert!(!window.state().derived().answer_marks.is_empty());
}

#[test]
fn the_pixels_that_differ_are_a_map_beside_the_right_picture() {
    let mut window = open("look-at");
    click(&mut window, Mistake::VIsUCrossW.name());
    let picture = window.state().derived().second_view.as_ref().unwrap().image.clone();
    click(&mut window, "Differences");
    let map = window.state().derived().second_view.as_ref().unwrap().image.clone();
    assert_eq!(map.size, picture.size);
    let differs =
        [[0xc8, 0x10, 0x58], [0x00, 0x4a, 0x86]].map(|[r, g, b]| egui::Color32::from_rgb(r, g, b));
    let share = |image: &egui::ColorImage| {
        let dark = image.pixels.iter().filter(|color| differs.contains(color)).count();
        dark as f32 / image.pixels.len() as f32
    };
    assert!(share(&map) > 0.1 && share(&picture) == 0.0, "{} {}", share(&map), share(&picture));
    click(&mut window, "Differences");
    assert_eq!(window.state().derived().second_view.as_ref().unwrap().image.clone(), picture);
}

fn open_vote(window: &Harness<'_, App>) -> OpenVote {
    window.state().session().shown.mistakes_view.open_vote.clone().unwrap()
}

fn mistake_of(open: &OpenVote) -> Mistake {
    open.options[open.right].mistake.expect("a vote on a picture")
}

fn option(open: &OpenVote, index: usize) -> String {
    format!("{}: {}", ["A", "B", "C", "D"][index], open.options[index].text)
}

#[test]
fn a_vote_tells_nothing_before_it_is_revealed_and_goes_on() {
    let mut window = open("look-at");
    click(&mut window, "Guess which");
    let open = open_vote(&window);
    assert_eq!(open.options.len(), 4);
    let mistake = mistake_of(&open);
    let is_secret = |window: &Harness<'_, App>| {
        let checks = values(window, " catches it").is_empty();
        let told = texts_with(window, mistake.shows()).is_empty()
            && texts_with(window, mistake.formula()).is_empty();
        checks && told && !wrong_says(window).contains(mistake.name())
    };
    assert!(is_secret(&window));
    for mistake in Mistake::GALLERY {
        assert!(window.query_by_role_and_label(Role::Button, mistake.name()).is_none());
    }
    let buttons = |window: &Harness<'_, App>| -> Vec<egui::Rect> {
        let rect = |name: &str| window.get_by_role_and_label(Role::Button, name).rect();
        let options = (0..4).map(|index| rect(&option(&open, index)));
        options.chain([rect("Reveal"), rect("Another one")]).collect()
    };
    let before = buttons(&window);
    // Wrong first.
    let wrong = (open.right + 1) % 4;
    click(&mut window, &option(&open, wrong));
    assert_eq!(open_vote(&window).answer, Some(wrong));
    assert!(is_secret(&window), "a vote is no answer yet");
    click(&mut window, "Reveal");
    let letter = ["A", "B", "C", "D"][open.right];
    assert_says(&window, &format!("{letter}: {}. {}", mistake.name(), mistake.shows()));
    assert_says(&window, mistake.formula());
    assert!(wrong_says(&window).starts_with(mistake.name()));
    assert_eq!(buttons(&window), before, "nothing moves");
    click(&mut window, "Another one");
    let next = open_vote(&window);
    assert_ne!(mistake_of(&next), mistake);
    assert!(next.answer.is_none() && !next.is_revealed);
    click(&mut window, "Reveal");
    click(&mut window, "All mistakes");
    assert_eq!(window.state().session().shown.mistakes_view.open_vote, None);
    assert_says(&window, &format!("Wrong camera: {}", mistake_of(&next).name()));
}

#[test]
fn a_key_reveals_before_a_lesson_goes_on() {
    let mut window = window("look-at");
    command(&mut window, "From eye, at and up, 1. One line more");
    // The step asks first: its answer, or the step after it.
    window.key_press(egui::Key::PageDown);
    window.run();
    show(&mut window, ViewLayout::Mistakes);
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Mistakes);
    let step = |window: &Harness<'_, App>| window.state().lesson().unwrap().id();
    command(&mut window, "Guess which");
    let before = step(&window);
    window.key_press(egui::Key::PageDown);
    window.run();
    assert!(open_vote(&window).is_revealed);
    assert_eq!(step(&window), before);
}

/// From the back row: in points of the projector, an option's text is no smaller than this.
#[test]
fn a_vote_fits_a_projector() {
    let mut window = open("look-at");
    click(&mut window, "Guess which");
    window.key_press(egui::Key::F5);
    for size in [[1024.0, 768.0], [683.0, 512.0], [910.0, 512.0]] {
        window.set_size(size.into());
        window.run();
        let whole = window.ctx.content_rect();
        let open = open_vote(&window);
        let rects: Vec<egui::Rect> = (0..4)
            .map(|index| window.get_by_role_and_label(Role::Button, &option(&open, index)).rect())
            .collect();
        for rect in &rects {
            assert!(whole.contains_rect(*rect) && rect.height() >= 34.0, "{rect} in {whole}");
        }
        let reveal = window.get_by_role_and_label(Role::Button, "Reveal").rect();
        assert!(whole.contains_rect(reveal), "{reveal} in {whole}");
        assert!(rects.iter().all(|rect| !rect.intersects(reveal)));
    }
}

/// The window's size in points before an audience, on a projector of this many pixels.
fn projected(pixels: [f32; 2]) -> egui::Vec2 {
    egui::Vec2::from(pixels) / presenting::zoom(pixels, SMALLEST_TEXT.usual)
}

/// The texts on the screen that begin like this, each with its rectangle and what it is clipped to.
fn painted(window: &Harness<'_, App>, begin: &str) -> Vec<(egui::Rect, egui::Rect)> {
    let texts = window.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) if text.galley.job.text.starts_with(begin) => {
            Some((text.visual_bounding_rect(), clipped.clip_rect))
        }
        _ => None,
    });
    texts.collect()
}

#[test]
fn a_vote_has_room_beside_a_lesson() {
    let steps = [
        "From view and up, 5. A hint, not a vector of the basis",
        "The canonical camera, 2. A point of the viewport",
    ];
    for (pixels, step) in [[1920.0, 1080.0], [1024.0, 768.0]]
        .into_iter()
        .flat_map(|pixels| steps.map(|step| (pixels, step)))
    {
        let mut window = window("look-at");
        command(&mut window, step);
        let title = format!("{} · ", window.state().lesson().unwrap().short_title());
        show(&mut window, ViewLayout::Mistakes);
        window.key_press(egui::Key::F5);
        window.run();
        window.set_size(projected(pixels));
        window.run();
        assert!(!painted(&window, &title).is_empty(), "{title}");
        command(&mut window, "Guess which");
        let whole = window.ctx.content_rect();
        let open = open_vote(&window);
        for index in 0..4 {
            let name = option(&open, index);
            let rect = window.get_by_role_and_label(Role::Button, &name).rect();
            assert!(whole.contains_rect(rect), "{name}: {rect} in {whole}, {step}");
            assert!(rect.height() >= 36.0, "{name}: {rect}, {step}");
            let texts = painted(&window, &open.options[index].text);
            let is_whole = |(text, clip): &(egui::Rect, egui::Rect)| {
                rect.contains_rect(*text) && clip.expand(1.0).contains_rect(*text)
            };
            assert!(texts.iter().any(is_whole), "{name}: {texts:?} in {rect}, {step}");
        }
        assert!(painted(&window, &title).is_empty(), "the step's text is of another question");
        click(&mut window, "All mistakes");
        assert!(!painted(&window, &title).is_empty());
    }
}

#[test]
fn another_step_ends_a_vote() {
    let mut window = window("look-at");
    command(&mut window, "From view and up, 5. A hint, not a vector of the basis");
    command(&mut window, "Guess which");
    assert!(!open_vote(&window).is_revealed);
    command(&mut window, "From view and up, 4. Up in the picture: v");
    assert_eq!(window.state().session().shown.mistakes_view.open_vote, None);
}

#[test]
fn the_right_values_are_whole_before_an_audience() {
    for pixels in [[1920.0, 1080.0], [1024.0, 768.0]] {
        let mut window = open("look-at");
        window.key_press(egui::Key::F5);
        window.run();
        window.set_size(projected(pixels));
        window.run();
        for &mistake in Mistake::GALLERY {
            click(&mut window, mistake.name());
            for (text, clip) in painted(&window, "right: ") {
                let is_whole =
                    clip.x_range().contains(text.left()) && clip.x_range().contains(text.right());
                assert!(is_whole, "{mistake}: {text} in {clip}");
            }
        }
    }
}

#[test]
fn the_palette_opens_a_vote_from_any_window() {
    for size in [[1280.0, 800.0], [1920.0, 1080.0], [640.0, 480.0]] {
        let mut window = window_with("look-at", pinhole::model::store::Remembered::default(), None);
        window.set_size(size.into());
        window.run();
        command(&mut window, "Guess which");
        assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Mistakes);
        assert_eq!(open_vote(&window).options.len(), 4);
        assert_says(&window, "Which mistake made the wrong picture?");
    }
}

#[test]
fn a_vote_that_is_revealed_stays_as_it_was_given() {
    let mut window = open("look-at");
    click(&mut window, "Guess which");
    let names: Vec<String> = {
        let open = open_vote(&window);
        let named = open.options.iter().zip(["A", "B", "C", "D"]);
        named.map(|(mistake, letter)| format!("{letter}: {}", mistake.text)).collect()
    };
    click(&mut window, &names[0]);
    assert_eq!(open_vote(&window).answer, Some(0));
    click(&mut window, "Reveal");
    click(&mut window, &names[1]);
    assert_eq!(open_vote(&window).answer, Some(0));
}

#[test]
fn a_mistake_and_what_catches_it_are_in_sight_in_a_small_window() {
    let mut window = open("canonical");
    window.set_size(vec2(1024.0, 768.0));
    window.run();
    let bottom = window.ctx.content_rect().bottom();
    let checks: Vec<egui::Rect> = window
        .query_all_by(|node| node.value().is_some_and(|value| value.ends_with(" catches it")))
        .map(|node| node.rect())
        .collect();
    assert!(!checks.is_empty());
    for check in checks {
        assert!(check.bottom() <= bottom, "{check} of {bottom}");
    }
    let titles: Vec<&egui::epaint::TextShape> = window
        .output()
        .shapes
        .iter()
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) if text.galley.job.text.starts_with("Wrong camera") => {
                Some(text)
            }
            _ => None,
        })
        .collect();
    assert!(!titles.is_empty() && titles.iter().all(|title| !title.galley.elided), "{titles:?}");
}

#[test]
fn the_vote_is_in_a_menu() {
    let mut window = open("canonical");
    show(&mut window, ViewLayout::Both);
    window.get_by_label("View").click();
    window.run();
    window.get_by_label_contains("Vote: guess which mistake").click();
    window.run();
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Mistakes);
    assert!(!open_vote(&window).is_revealed);
}
