//! Presenter mode, by keyboard alone: what fills the window, how large text is, and what comes back.

use egui::accesskit::Role;
use egui::epaint::Shape;
use egui::{Key, Modifiers, Rect, Theme, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::presenting::zoom;
use pinhole::model::session::{Preferences, Settings, ThemeName, ViewLayout};
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_figure::typesetting::theme::WRITTEN;
use pinhole_lecture::exercises::Exercise;

use super::painted_texts::{Run, texts};
use super::practice::exercises::choose;
use crate::harness::{
    assert_says, click_at, drag_from, says, show, texts_with, unfolded, window, window_with,
};

pub(crate) fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

fn layout(harness: &Harness<'_, App>) -> ViewLayout {
    harness.state().session().shown.setup.layout
}

/// The window is that large on the screen, in pixels.
pub(crate) fn resize(harness: &mut Harness<'_, App>, pixels: [f32; 2]) {
    // A window tells its size in points, of which a pixel has more where less is zoomed.
    for _ in 0..6 {
        let size = vec2(pixels[0], pixels[1]) / harness.ctx.zoom_factor();
        harness.set_size(size);
        let viewport = harness.input_mut().viewports.get_mut(&egui::ViewportId::ROOT).unwrap();
        viewport.inner_rect = Some(Rect::from_min_size(pos2(0.0, 0.0), size));
        harness.step();
    }
}

#[test]
fn lesson_1s_ray_is_the_same_number_in_the_text_and_the_derivation_in_few_steps() {
    let mut harness = window("canonical");
    let id = StepId { lesson: Which::Builtin(0), step: 2 };
    harness.state_mut().open_lesson(id, None);
    harness.run();
    press(&mut harness, Key::F5);
    press(&mut harness, Key::PageDown);
    let step = |harness: &Harness<'_, App>| harness.state().lesson().unwrap().id().step;
    assert_eq!(step(&harness), 2);
    for number in ["= 0.24875", "= 0.25125"] {
        assert!(!texts_with(&harness, number).is_empty(), "{number}");
    }
    assert!(texts_with(&harness, "𝐝 =").is_empty(), "only u and v are asked for");
    press(&mut harness, Key::PageDown);
    assert_eq!(step(&harness), 3);
}

#[track_caller]
pub(super) fn assert_texts_are_large(harness: &Harness<'_, App>) {
    for Run { text, size, .. } in texts(harness) {
        assert!(size >= WRITTEN, "“{text}” is written in {size}");
    }
}

#[test]
fn panels_go_and_everything_comes_back() {
    let mut harness = window("canonical");
    let before = harness.state().session().clone();
    let zoom_before = harness.ctx.zoom_factor();
    press(&mut harness, Key::F5);
    assert!(harness.state().session().presenting.is_some());
    for gone in ["File", "Viewport and image", "Objects", "Maximise"] {
        assert!(!says(&harness, gone), "{gone}");
    }
    assert!(harness.query_by_label("World view").is_some());
    assert!(harness.ctx.zoom_factor() > zoom_before);
    press(&mut harness, Key::Num3);
    press(&mut harness, Key::F5);
    assert_eq!(harness.state().session().settings(), before.settings());
    assert_eq!(harness.state().session().presenting, None);
    assert_eq!(harness.ctx.zoom_factor(), zoom_before);
    assert_says(&harness, "File");
    press(&mut harness, Key::F5);
    press(&mut harness, Key::Escape);
    assert_eq!(harness.state().session().presenting, None);
}

#[test]
fn a_key_each_fills_the_window() {
    let mut harness = window("canonical");
    press(&mut harness, Key::Num1);
    assert_eq!(layout(&harness), ViewLayout::Both, "it is a key of presenting");
    press(&mut harness, Key::F5);
    let window = harness.ctx.content_rect();
    for (key, world, camera) in [
        (Key::Num1, false, false),
        (Key::Num2, true, false),
        (Key::Num3, false, true),
        (Key::Num4, true, true),
    ] {
        press(&mut harness, key);
        let rect = |name: &str| harness.query_by_label(name).map(|node| node.rect());
        let (seen_world, seen_camera) = (rect("World view"), rect("Camera view"));
        assert_eq!((seen_world.is_some(), seen_camera.is_some()), (world, camera), "{key:?}");
        let widest = seen_world.into_iter().chain(seen_camera).map(|rect| rect.height());
        if let Some(height) = widest.reduce(f32::max) {
            assert!(height > 0.9 * window.height().min(0.5 * window.width()), "{key:?}: {height}");
        }
        let derivation = harness.state().derived().derivation.is_some();
        assert_eq!(derivation, key == Key::Num1);
    }
    press(&mut harness, Key::F5);
    assert_eq!(layout(&harness), ViewLayout::Both);
}

#[test]
fn no_text_is_smaller_than_the_setting() {
    let mut harness = window("canonical");
    press(&mut harness, Key::F5);
    for pixels in [[1024.0, 768.0], [1280.0, 720.0], [1920.0, 1080.0], [3840.0, 2160.0]] {
        let smallest = harness.state().session().preferences.smallest_text;
        let scale = zoom(pixels, smallest);
        resize(&mut harness, pixels);
        let zoomed = harness.ctx.zoom_factor();
        assert!((zoomed - scale).abs() < 0.01 * scale, "{pixels:?}: {zoomed} for {scale}");
        // The setting is for a projector; a smaller window has smaller texts in proportion.
        let part = (pixels[0] / 1229.0).min(pixels[1] / 768.0).min(1.0);
        assert!(WRITTEN * zoomed >= 0.99 * part * smallest);
        for key in [Key::Num1, Key::Num2, Key::Num3, Key::Num4] {
            press(&mut harness, key);
            assert_texts_are_large(&harness);
        }
    }
    // Sheets and palette, too.
    press(&mut harness, Key::F1);
    assert_texts_are_large(&harness);
    press(&mut harness, Key::Escape);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    harness.run();
    assert_texts_are_large(&harness);
}

#[test]
fn the_smallest_text_is_set_by_keys_while_presenting() {
    let mut harness = window("canonical");
    let usual = Preferences::default().smallest_text;
    let zoom_before = harness.ctx.zoom_factor();
    press(&mut harness, Key::F5);
    let small = harness.ctx.zoom_factor();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Plus);
    harness.run();
    assert!(harness.state().session().preferences.smallest_text > usual);
    assert!(harness.ctx.zoom_factor() > small);
    press(&mut harness, Key::F5);
    assert_eq!(harness.ctx.zoom_factor(), zoom_before);
}

#[test]
fn keys_of_presenting_are_typed_into_fields_and_the_next_run_does_not_present() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let mut harness = window_with("canonical", Remembered::default(), Some(store.clone()));
    press(&mut harness, Key::F5);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    harness.run();
    harness.get_by_label("Command").type_text("exercise sphere");
    harness.run();
    press(&mut harness, Key::Enter);
    press(&mut harness, Key::Num2);
    assert_eq!(layout(&harness), ViewLayout::World);
    harness.state_mut().on_exit();
    assert_eq!(store.load().settings.setup.layout, ViewLayout::Exercises);
}

#[test]
fn the_numbers_stand_in_the_column_and_the_views_stay_without_them() {
    for pixels in [[1024.0, 768.0], [1920.0, 1080.0]] {
        let mut harness = window("look-at");
        press(&mut harness, Key::F5);
        resize(&mut harness, pixels);
        let view = |harness: &Harness<'_, App>| harness.get_by_label("World view").rect();
        let with_numbers = view(&harness);
        let content = harness.ctx.content_rect();
        assert!(with_numbers.area() > 0.5 * content.area(), "{with_numbers} in {content}");
        for name in ["u ≈ ", "v ≈ ", "w ≈ ", "(u, v) = ", "d ≈ ", "t ≈ ", "hit = "] {
            let number = harness.get_by(|node| {
                node.role() == Role::Label
                    && node.value().is_some_and(|text| text.starts_with(name))
            });
            let rect = number.rect();
            assert!(content.contains_rect(rect), "{name}: {rect} in {content}");
            let painted = harness.output().shapes.iter().find_map(|clipped| match &clipped.shape {
                Shape::Text(text) if rect.contains(text.visual_bounding_rect().center()) => {
                    Some((text.visual_bounding_rect(), clipped.clip_rect))
                }
                _ => None,
            });
            let (text, clip) = painted.unwrap();
            assert!(clip.contains_rect(text), "{name}: {text} is cut off at {clip}");
        }
        assert_texts_are_large(&harness);
        press(&mut harness, Key::N);
        assert_eq!(view(&harness), with_numbers);
        assert_eq!(texts_with(&harness, "d = ").len(), 0);
        press(&mut harness, Key::N);
        assert_eq!(view(&harness), with_numbers);
    }
}

#[test]
fn no_text_at_1080_lines_is_smaller_than_28_pixels() {
    let settings = Settings::default();
    assert!(WRITTEN * zoom([1920.0, 1080.0], settings.preferences.smallest_text) >= 28.0);
}

#[test]
fn an_exercise_is_as_large_as_its_fields_leave_room_for() {
    for (exercise, largest) in [(Exercise::WarmUpRay, true), (Exercise::Turned, false)] {
        let mut harness = window("canonical");
        show(&mut harness, ViewLayout::Exercises);
        choose(&mut harness, exercise);
        press(&mut harness, Key::F5);
        resize(&mut harness, [1920.0, 1080.0]);
        assert_texts_are_large(&harness);
        let size = |start: &str| {
            let texts = texts(&harness);
            texts.iter().find(|run| run.text.starts_with(start)).unwrap().size
        };
        let least = if largest { 14.0 } else { WRITTEN };
        for text in ["What ", "You may type"] {
            assert!(size(text) >= least, "{exercise:?}, {text}: {}", size(text));
        }
        let buttons = harness.get_by_role_and_label(Role::Button, "Check").rect();
        let fields: Vec<Rect> =
            harness.get_all_by_role(Role::TextInput).map(|field| field.rect()).collect();
        assert!(!fields.is_empty());
        for field in fields {
            assert!(field.bottom() <= buttons.top(), "{exercise:?}: {field} above {buttons}");
        }
    }
}

#[test]
fn the_pen_draws_over_the_views_and_escape_wipes_it_off() {
    let mut harness = window("canonical");
    press(&mut harness, Key::F5);
    press(&mut harness, Key::P);
    let (document, observer) =
        (harness.state().document().clone(), harness.state().session().shown.observer);
    let view = harness.get_by_label("World view").rect();
    drag_from(&mut harness, view.center(), vec2(60.0, 40.0));
    let pen = harness.state().session().live.pen.clone().unwrap();
    assert_eq!(pen.strokes.len(), 1);
    let drawn = |harness: &Harness<'_, App>| {
        let is_line = |shape: &Shape| matches!(shape, Shape::Path(path) if path.points.len() >= 2);
        harness.output().shapes.iter().filter(|clipped| is_line(&clipped.shape)).count()
    };
    assert!(drawn(&harness) >= 2, "a line and its casing");
    assert_eq!(*harness.state().document(), document, "nothing below it was dragged");
    assert_eq!(harness.state().session().shown.observer, observer);
    press(&mut harness, Key::Escape);
    assert!(harness.state().session().live.pen.is_none() && drawn(&harness) == 0);
    assert!(harness.state().session().presenting.is_some(), "Escape put the pen away, no more");
    press(&mut harness, Key::Escape);
    assert!(harness.state().session().presenting.is_none());
}

#[test]
fn presenting_fills_the_screen_and_the_window_comes_back() {
    let mut harness = window("canonical");
    let sent = |harness: &Harness<'_, App>| -> Vec<bool> {
        let commands = &harness.output().viewport_output[&egui::ViewportId::ROOT].commands;
        let fills = commands.iter().filter_map(|command| match command {
            egui::ViewportCommand::Fullscreen(fills) => Some(*fills),
            _ => None,
        });
        fills.collect()
    };
    for fills in [true, false] {
        // A key that is let go is a pass of its own.
        harness.key_down(Key::F5);
        harness.step();
        assert_eq!(sent(&harness), [fills]);
        harness.key_up(Key::F5);
        harness.run();
        assert!(sent(&harness).is_empty(), "once");
    }
}

#[test]
fn a_hall_sees_light_ground_and_the_window_s_own_comes_back() {
    let settings = Settings {
        preferences: Preferences { theme: ThemeName::Dark, ..unfolded().preferences },
        ..unfolded()
    };
    let remembered = Remembered { settings, ..Remembered::default() };
    let mut harness = window_with("canonical", remembered, None);
    let is_dark = |harness: &Harness<'_, App>| harness.ctx.theme() == Theme::Dark;
    assert!(is_dark(&harness));
    press(&mut harness, Key::F5);
    assert!(!is_dark(&harness));
    press(&mut harness, Key::T);
    assert!(is_dark(&harness));
    press(&mut harness, Key::T);
    assert!(!is_dark(&harness));
    press(&mut harness, Key::F5);
    assert!(is_dark(&harness));
    assert_eq!(harness.state().session().preferences.theme, ThemeName::Dark);
}

#[test]
fn b_and_a_point_blank_the_screen_and_any_key_brings_it_back() {
    let mut harness = window("canonical");
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(0), step: 0 }, None);
    harness.run();
    let is_blank = |harness: &Harness<'_, App>| harness.query_by_label("Blank screen").is_some();
    press(&mut harness, Key::B);
    assert!(!is_blank(&harness), "it is a key of presenting");
    press(&mut harness, Key::F5);
    for blanks in [Key::B, Key::Period] {
        press(&mut harness, blanks);
        assert!(is_blank(&harness), "{blanks:?}");
        // The class has not seen what the next step would show.
        press(&mut harness, Key::PageDown);
        assert!(!is_blank(&harness));
        assert_eq!(harness.state().lesson().unwrap().id().step, 0);
    }
    press(&mut harness, Key::B);
    press(&mut harness, Key::B);
    assert!(!is_blank(&harness));
    press(&mut harness, Key::B);
    let camera = harness.state().document().camera;
    harness.event(egui::Event::Paste("eye = (1, 2, 3), at = (0, 0, 0), up = (0, 1, 0)".into()));
    harness.run();
    assert!(is_blank(&harness) && harness.state().document().camera == camera);
    click_at(&mut harness, pos2(300.0, 300.0));
    assert!(!is_blank(&harness));
    press(&mut harness, Key::B);
    press(&mut harness, Key::Escape);
    assert!(!is_blank(&harness) && harness.state().session().presenting.is_some());
}

#[test]
fn the_pen_has_three_colours() {
    let mut harness = window("canonical");
    press(&mut harness, Key::F5);
    press(&mut harness, Key::P);
    let pen = |harness: &Harness<'_, App>| harness.state().session().live.pen.clone().unwrap();
    for stroke in 0..4 {
        drag_from(&mut harness, pos2(300.0, 200.0 + 20.0 * stroke as f32), vec2(80.0, 0.0));
        press(&mut harness, Key::C);
    }
    let colors: Vec<_> = pen(&harness).strokes.iter().map(|stroke| stroke.color).collect();
    let [first, second, third, fourth] = colors[..] else { panic!("{colors:?}") };
    assert!(first != second && second != third && third != first && fourth == first);
}
