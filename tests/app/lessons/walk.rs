//! The way through every step with *Next*: each says what it is about, and sets all that it says.

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::features::exercises::state::Exercises;
use pinhole::model::lessons::{AskedExercise, Step, builtin};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_core::{DVec2, DVec3};
use pinhole_figure::Concept;
use pinhole_figure::observer::Observer;
use pinhole_figure::overlay::Shape;
use pinhole_figure::overlay_items::{Item, OverlayItems};

use super::{Window, answer, at_step, key, press, shown_step};
use crate::harness::{assert_says, command, drag_from, show, texts_with, type_into};

/// Whether there are handles is the user's to say, whatever a step shows.
fn own_items(items: OverlayItems) -> OverlayItems {
    items.with(Item::Handles, true)
}

/// Returns the direction from which an observer looks.
fn direction(observer: &Observer) -> DVec3 {
    observer.camera(4, 3).view()
}

/// Fails unless the window is as the step says, in all that it says.
fn assert_is_as_said(app: &App, step: &Step, now: (usize, usize)) {
    assert_eq!(*app.document(), step.document, "{now:?}");
    let session = app.session();
    let (shown, said) = (&session.shown, &step.shown);
    let (setup, setup_said) = (shown.setup, said.setup);
    // How far off the observer stands, and around what it turns, is for the view's size to say.
    let looks_as = |observer: Observer, said: Observer| {
        direction(&observer).abs_diff_eq(direction(&said), 1e-12)
    };
    let has_observer = match said.observer {
        Some(said) if step.keep_observer => shown.observer == Some(said),
        Some(said) => shown.observer.is_some_and(|observer| looks_as(observer, said)),
        None => true,
    };
    let exercises = &session.exercises;
    let exercise = |own: AskedExercise| *exercises == Exercises::open(own.exercise, own.seed);
    let all_as_said = [
        ("selection", shown.selection == said.selection),
        ("observer", has_observer),
        ("formulas", shown.formulas == said.formulas),
        ("t", shown.ray_point_t == said.ray_point_t),
        ("ghost", shown.ghost == said.ghost),
        ("play", app.player().map(|player| player.kind) == step.play),
        ("exercise", step.exercise.is_none_or(exercise)),
    ];
    let as_said_if_said = [
        ("layout", setup.layout == setup_said.layout),
        ("show", own_items(setup.items) == own_items(setup_said.items)),
        ("shade", setup.shade == setup_said.shade),
        ("count_from_one", setup.count_from_one == setup_said.count_from_one),
        ("digits", setup.digits == setup_said.digits),
        ("keep_picture", setup.keep_picture == setup_said.keep_picture),
        ("teaching", setup.teaching == setup_said.teaching),
        ("derivation", shown.sections == said.sections),
        ("highlight", shown.highlighted == said.highlighted),
        ("mistake", shown.mistakes_view == said.mistakes_view),
        ("lines", shown.lines == said.lines),
    ];
    let left_alone = as_said_if_said.map(|(key, is_as_said)| (key, is_as_said || !step.says(key)));
    for (what, is_as_said) in all_as_said.into_iter().chain(left_alone) {
        assert!(is_as_said, "{now:?}: {what}");
    }
}

#[test]
fn next_goes_through_every_step_and_each_sets_all_that_it_says() {
    let mut window = at_step(1, 1);
    for (index, lesson) in builtin::all().iter().enumerate() {
        for (k, step) in lesson.steps.iter().enumerate() {
            let now = (index + 1, k + 1);
            assert_eq!(shown_step(&window), now);
            let steps = lesson.steps.len();
            assert_says(
                &window,
                &format!("Lesson {} · {} of {steps} · {}", now.0, now.1, step.title),
            );
            assert_says(&window, &step.text.replace('*', ""));
            if let Some(question) = &step.question {
                assert_says(&window, &question.ask.replace('*', ""));
                answer(&mut window);
                assert_says(&window, &question.answer.replace('*', ""));
            }
            assert_is_as_said(window.state(), step, now);
            for wrong in ["NaN", "nan"] {
                assert!(texts_with(&window, wrong).is_empty(), "{now:?}");
            }
            let next = window.get_by_role_and_label(Role::Button, "Next");
            let last = index + 1 == builtin::all().len() && k + 1 == lesson.steps.len();
            assert_eq!(next.accesskit_node().is_disabled(), last, "{now:?}");
            if !last {
                press(&mut window, "Next");
            }
        }
    }
    press(&mut window, "Previous");
    assert_eq!(shown_step(&window), (13, 3));
}

/// Another layout, which has the camera's fields; another eye, and another observer.
fn disturb(window: &mut Window) {
    show(window, ViewLayout::World);
    type_into(window, "eye x", "0.125");
    let view = window.get_by_role_and_label(Role::Image, "World view").rect();
    drag_from(window, view.min + egui::vec2(60.0, 60.0), egui::vec2(50.0, 20.0));
}

#[test]
fn after_dragging_in_any_step_r_brings_back_all_of_it() {
    let mut window = at_step(1, 1);
    // Small views are quickly traced.
    window.set_size(egui::vec2(960.0, 400.0));
    window.run();
    for (index, lesson) in builtin::all().iter().enumerate() {
        for (k, step) in lesson.steps.iter().enumerate() {
            let now = (index + 1, k + 1);
            assert_eq!(shown_step(&window), now);
            answer(&mut window);
            let before = window.state().session().clone();
            disturb(&mut window);
            assert_ne!(*window.state().document(), step.document, "{now:?}");
            assert_ne!(window.state().session().shown.observer, before.shown.observer, "{now:?}");
            key(&mut window, Key::R);
            assert_is_as_said(window.state(), step, now);
            assert_eq!(*window.state().session(), before, "{now:?}");
            key(&mut window, Key::PageDown);
        }
    }
}

#[test]
fn a_step_is_the_same_however_it_is_reached() {
    for (lesson, step) in [(3, 3), (7, 4), (12, 8)] {
        let direct = at_step(lesson, step);
        let mut walked = at_step(lesson, 1);
        for _ in 1..step {
            press(&mut walked, "Next");
            answer(&mut walked);
        }
        assert_eq!(direct.state().document(), walked.state().document());
        assert_eq!(
            direct.state().session().shown.selection,
            walked.state().session().shown.selection
        );
        assert_eq!(direct.state().session().settings(), walked.state().session().settings());
    }
}

/// Returns the pixels of the camera view that have about this colour.
fn colored(window: &Window, [r, g, b]: [u8; 3]) -> usize {
    let view = window.state().derived().camera_view.clone().unwrap();
    let is_close = |pixel: &&egui::Color32| {
        let apart = [(pixel.r(), r), (pixel.g(), g), (pixel.b(), b)];
        apart.iter().all(|(a, b)| a.abs_diff(*b) < 24)
    };
    view.image.pixels.iter().filter(is_close).count()
}

#[test]
fn the_loupe_of_2_2_hides_no_sphere() {
    let mut window = at_step(2, 2);
    for size in [egui::vec2(1280.0, 1000.0), egui::vec2(1920.0, 1080.0)] {
        window.set_size(size);
        window.run();
        let spheres = [[0xe6, 0x9f, 0x00], [0x56, 0xb4, 0xe9]];
        let seen = |window: &Window| spheres.map(|color| colored(window, color));
        let with_loupe = seen(&window);
        command(&mut window, "Overlay: loupe");
        let without = seen(&window);
        command(&mut window, "Overlay: loupe");
        for (seen, all) in with_loupe.into_iter().zip(without) {
            assert!(seen as f64 > 0.7 * all as f64, "{seen} of {all} pixels at {size}");
        }
    }
}

#[test]
fn the_ray_of_2_1_does_not_end_at_a_wall_that_is_not_drawn() {
    let mut window = at_step(2, 1);
    answer(&mut window);
    let app = window.state();
    assert!(!app.session().shown.setup.items.shows(Item::Planes));
    let (shown, frame) = (app.derived().world_view.clone().unwrap(), &app.derived().world_frame);
    let hit = app.derived().inspection.as_ref().unwrap().first_hit().unwrap().point;
    let seen = frame.as_ref().unwrap().camera();
    let share = seen.project(hit).uv / DVec2::new(seen.viewport().width, seen.viewport().height);
    let [width, height] = shown.image.size.map(|n| n as f64);
    let hit = DVec2::new((0.5 + share.x) * width, (0.5 - share.y) * height);
    let ends = shown.marks.iter().filter(|mark| mark.concept == Some(Concept::Ray));
    let ends = ends.filter_map(|mark| match &mark.shape {
        Shape::Line { points, .. } => Some([points[0], points[points.len() - 1]]),
        _ => None,
    });
    let apart = |[x, y]: [f32; 2]| hit.distance(DVec2::new(x.into(), y.into()));
    let nearest = ends.flatten().map(apart).fold(f64::INFINITY, f64::min);
    assert!(nearest > 20.0, "the ray ends {nearest} pixels from the wall");
}
