//! A lesson's steps while presenting: how many presses they take, what key 3 does, and what the class does
//! not see.

use egui::epaint::Shape;
use egui::{Key, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;

use super::presenter::assert_texts_are_large;
use crate::harness::{click_at, drag_from, texts_with, window};

fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

/// The window's size in points while presenting at 1920 x 1080 pixels.
const SIZE: Vec2 = vec2(819.0, 461.0);

/// The most presses of Page Down that lead from the first step to the last one's answer, with a press for the
/// solution of each of eight exercises.
const MOST_PRESSES: usize = 161;

#[test]
fn the_whole_lecture_takes_few_presses_of_page_down() {
    let mut harness = window("canonical");
    let first = StepId { lesson: Which::Builtin(0), step: 0 };
    harness.state_mut().open_lesson(first, None);
    harness.run();
    press(&mut harness, Key::F5);
    harness.set_size(SIZE);
    harness.run();
    let mut presses: Vec<(StepId, usize)> = vec![(first, 0)];
    let state = |harness: &Harness<'_, App>| {
        let session = harness.state().session();
        let id = harness.state().lesson().unwrap().id();
        let shown = (session.shown.is_asking, session.shown.revealed_lines);
        (id, shown, session.exercises.clone())
    };
    loop {
        let before = state(&harness);
        press(&mut harness, Key::PageDown);
        assert_texts_are_large(&harness);
        let now = state(&harness);
        if now == before {
            break;
        }
        match presses.last_mut() {
            Some((id, count)) if *id == before.0 => *count += 1,
            _ => presses.push((before.0, 1)),
        }
    }
    let all: usize = presses.iter().map(|(_, count)| count).sum();
    assert!(all <= MOST_PRESSES, "{all} presses: {presses:?}");
    let at =
        |lesson: usize, step: usize| StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    let of = |step| presses.iter().find(|(id, _)| *id == step).map_or(0, |(_, count)| *count);
    assert_eq!(of(at(6, 2)), 4, "checks of the same kind come together, and so do given vectors");
    let layout = |harness: &Harness<'_, App>| harness.state().session().shown.setup.layout;
    let shown = layout(&harness);
    press(&mut harness, Key::F5);
    assert_eq!(layout(&harness), shown, "what a step has set stays");
}

fn step(lesson: usize, step: usize) -> Harness<'static, App> {
    let mut harness = window("canonical");
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    harness.state_mut().open_lesson(id, None);
    harness.run();
    press(&mut harness, Key::F5);
    harness.set_size(SIZE);
    harness.run();
    harness
}

#[test]
fn key_3_swaps_main_figure_and_inset_and_swaps_them_back() {
    let mut harness = step(7, 1);
    let rects = |harness: &Harness<'_, App>| {
        ["World view", "Camera view"].map(|name| harness.get_by_label(name).rect())
    };
    let [world, camera] = rects(&harness);
    assert!(world.contains_rect(camera));
    press(&mut harness, Key::Num3);
    let [inset, main] = rects(&harness);
    assert!(main.area() > 4.0 * inset.area(), "{main} {inset}");
    assert!(main.height() > 0.9 * world.height() && world.contains_rect(inset));
    // The inset is what the pointer reaches.
    harness.hover_at(inset.center());
    harness.run();
    let observer = harness.state().session().shown.observer;
    drag_from(&mut harness, inset.center(), vec2(20.0, 5.0));
    assert_ne!(harness.state().session().shown.observer, observer);
    press(&mut harness, Key::Num3);
    assert_eq!(rects(&harness), [world, camera]);
    press(&mut harness, Key::Num2);
    assert!(harness.query_by_label("Camera view").is_none());
    press(&mut harness, Key::F5);
    assert_eq!(harness.state().session().shown.setup.layout, ViewLayout::Both);
}

#[test]
fn that_the_answer_is_hidden_is_a_dot_for_the_lecturer() {
    let mut harness = step(3, 1);
    let dots = |harness: &Harness<'_, App>| {
        let dots = harness
            .query_all_by(|node| node.value().is_some_and(|value| value == "The answer is hidden"));
        dots.map(|node| node.rect().width()).collect::<Vec<f32>>()
    };
    for key in [None, Some(Key::Num1), Some(Key::Num2), Some(Key::Num3), Some(Key::Num4)] {
        if let Some(key) = key {
            press(&mut harness, key);
        }
        assert_eq!(texts_with(&harness, "Hidden until"), Vec::<String>::new(), "{key:?}");
        assert!(matches!(dots(&harness)[..], [width] if width < 20.0), "{key:?}");
    }
    press(&mut harness, Key::PageDown);
    assert_eq!(dots(&harness), Vec::<f32>::new());
}

#[test]
fn tooltips_wait_for_a_click_and_keep_off_what_they_speak_of() {
    let mut harness = step(1, 4);
    let camera = harness.get_by_label("Camera view").rect();
    let told_of_ray = |harness: &Harness<'_, App>| -> Vec<Rect> {
        let texts = harness.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
            Shape::Text(text) if text.galley.job.text.starts_with("row ") => {
                Some(text.visual_bounding_rect())
            }
            _ => None,
        });
        texts.collect()
    };
    let at = camera.center() + vec2(10.0, -10.0);
    harness.hover_at(at);
    for _ in 0..20 {
        harness.step();
    }
    assert_eq!(told_of_ray(&harness), [], "the class is looking");
    click_at(&mut harness, at);
    let pointer = at + vec2(2.0, 0.0);
    harness.hover_at(pointer);
    for _ in 0..4 {
        harness.step();
    }
    let told = told_of_ray(&harness);
    assert!(matches!(told[..], [rect] if !rect.expand(8.0).contains(pointer)), "{told:?}");
}
