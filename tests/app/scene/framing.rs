//! From where the world view is seen: fitted to its size, unless a hand has moved the observer.

use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which, builtin};
use pinhole::model::session::ViewLayout;
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_core::{DVec2, DVec3, NO_OBJECT, Sphere};
use pinhole_figure::Scheme;
use pinhole_figure::observer::Observer;
use pinhole_figure::overlay::{Style, UP_LENGTH, arrow_length};
use pinhole_figure::overlay_items::Item;

use super::camera;
use crate::harness::{click_at, command, show, type_into, window_with};

/// Sizes of the window: wide, high, ordinary.
const SIZES: [egui::Vec2; 3] = [vec2(1920.0, 1080.0), vec2(900.0, 1000.0), vec2(1024.0, 768.0)];

fn observer(harness: &Harness<'_, App>) -> Observer {
    harness.state().session().shown.observer.unwrap()
}

/// Fails unless the tips of u, v, w and up are in the world view.
#[track_caller]
fn assert_tips_in_sight(harness: &Harness<'_, App>, what: &str) {
    let frame = harness.state().derived().world_frame.clone().unwrap();
    let seen = frame.camera();
    let camera = camera(harness);
    let resolved = camera.resolve().unwrap();
    let scale = harness.ctx.pixels_per_point();
    let length = arrow_length(seen, camera.eye, scale, false);
    let basis = resolved.basis();
    let up = UP_LENGTH * camera.up().normalize();
    for (name, axis) in [("u", basis.u), ("v", basis.v), ("w", basis.w), ("up", up)] {
        let uv = seen.project(camera.eye + length * axis).uv;
        let share = [uv.x / seen.viewport().width, uv.y / seen.viewport().height];
        assert!(share.iter().all(|s| s.abs() < 0.5), "{what}: the tip of {name} is cut off");
    }
}

#[test]
fn no_arrow_is_cut_off_when_the_window_or_the_layout_changes() {
    for scene in ["canonical", "look-at", "roll"] {
        let mut harness = window_with(scene, Remembered::default(), None);
        for size in SIZES {
            harness.set_size(size);
            harness.run();
            assert_tips_in_sight(&harness, &format!("{scene} at {size}"));
            harness.key_press(Key::F5);
            harness.run();
            assert_tips_in_sight(&harness, &format!("{scene} at {size}, presented"));
            harness.key_press(Key::F5);
            harness.run();
        }
        show(&mut harness, ViewLayout::World);
        assert_tips_in_sight(&harness, &format!("{scene}, the world view alone"));
    }
    let mut harness = window_with("canonical", Remembered::default(), None);
    for (lesson, step) in [(0, 0), (5, 1), (6, 2), (7, 0)] {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        for size in SIZES {
            harness.set_size(size);
            harness.run();
            assert_tips_in_sight(
                &harness,
                &format!("lesson {}.{} at {size}", lesson + 1, step + 1),
            );
        }
    }
}

#[test]
fn an_observer_that_a_hand_has_moved_stays() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    let framed = observer(&harness);
    harness.set_size(vec2(900.0, 1000.0));
    harness.run();
    assert_ne!(observer(&harness), framed, "it is fitted to another size");
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    click_at(&mut harness, view.left_bottom() + vec2(8.0, -8.0));
    harness.key_press_modifiers(Modifiers::ALT, Key::ArrowLeft);
    harness.run();
    let moved = observer(&harness);
    assert_ne!(moved, framed);
    for size in SIZES {
        harness.set_size(size);
        harness.run();
        assert_eq!(observer(&harness), moved);
    }
}

/// Whether a point of the scene is in the world view.
fn is_in_sight(harness: &Harness<'_, App>, point: DVec3) -> bool {
    let frame = harness.state().derived().world_frame.clone().unwrap();
    let seen = frame.camera();
    let uv = seen.project(point).uv;
    let share = [uv.x / seen.viewport().width, uv.y / seen.viewport().height];
    (point - seen.eye()).dot(seen.basis().w) < 0.0 && share.iter().all(|s| s.abs() < 0.5)
}

#[test]
fn eye_and_at_that_are_typed_out_of_sight_are_sought() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    for (field, text) in [("at x", "40"), ("eye y", "-60")] {
        type_into(&mut harness, field, text);
        let camera = camera(&harness);
        for point in [camera.eye, super::at_of(&camera)] {
            assert!(is_in_sight(&harness, point), "{field} = {text}: {point}");
        }
    }
    // What stays in sight moves nothing.
    let before = observer(&harness);
    type_into(&mut harness, "at x", "39");
    assert_eq!(observer(&harness), before);
    // Nor does anything move an observer that a hand has moved.
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    click_at(&mut harness, view.left_bottom() + vec2(8.0, -8.0));
    harness.key_press_modifiers(Modifiers::ALT, Key::ArrowLeft);
    harness.run();
    let moved = observer(&harness);
    assert_ne!(moved, before);
    type_into(&mut harness, "at x", "4000");
    assert_eq!(observer(&harness), moved);
}

#[test]
fn a_lesson_that_is_closed_at_an_exercise_leaves_scene_and_view_as_they_should_be() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.set_size(vec2(1024.0, 768.0));
    for (lesson, step) in [(1, 4), (5, 5), (11, 8)] {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step: 0 }, None);
        harness.run();
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        harness.run();
        assert_eq!(harness.state().session().shown.setup.layout, ViewLayout::Exercises);
        harness.get_by_role_and_label(Role::Button, "Close the lesson").click();
        harness.run();
        assert_eq!(harness.state().session().shown.setup.layout, ViewLayout::Both);
        assert!(is_in_sight(&harness, camera(&harness).eye), "{lesson}.{step}");
        assert_tips_in_sight(&harness, &format!("after {}.{}", lesson + 1, step + 1));
    }
}

#[test]
fn a_step_seen_in_a_view_of_another_size_counts_as_unchanged() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(0), step: 0 }, None);
    for size in SIZES {
        harness.set_size(size);
        harness.run();
        let back = harness.get_by_role_and_label(Role::Button, "Back to the step");
        assert!(egui_kittest::kittest::NodeT::accesskit_node(&back).is_disabled(), "{size}");
    }
}

/// Where a point of the scene is in the world view, in points from its middle, and half the view's size.
fn in_view(harness: &Harness<'_, App>, point: DVec3) -> [DVec2; 2] {
    let frame = harness.state().derived().world_frame.clone().unwrap();
    let seen = frame.camera();
    let size = harness.get_by_role_and_label(Role::Image, "World view").rect().size();
    let half = 0.5 * DVec2::new(size.x.into(), size.y.into());
    let extent = 0.5 * DVec2::new(seen.viewport().width, seen.viewport().height);
    [half * seen.project(point).uv / extent, half]
}

/// Returns what is wrong with how the whole camera is framed.
pub(in crate::app) fn misframed(harness: &Harness<'_, App>) -> Option<String> {
    let camera = camera(harness);
    let frame = harness.state().derived().world_frame.clone()?;
    let length = arrow_length(frame.camera(), camera.eye, harness.ctx.pixels_per_point(), false);
    let items = harness.state().session().shown.setup.items;
    let mut points = vec![camera.eye];
    if items.shows(Item::ViewAndUp) && camera.orientation.has_up() {
        points.push(camera.eye + UP_LENGTH * length * camera.up().normalize());
    }
    if let Ok(resolved) = camera.resolve() {
        let basis = resolved.basis();
        if items.shows(Item::Basis) {
            points.extend([basis.u, basis.v, basis.w].map(|axis| camera.eye + length * axis));
        }
        let half = 0.5 * DVec2::new(resolved.viewport().width, resolved.viewport().height);
        let corners = [DVec2::ONE, -DVec2::ONE, DVec2::new(1.0, -1.0), DVec2::new(-1.0, 1.0)];
        points.extend(corners.map(|corner| resolved.ray(half * corner).at(1.0)));
    }
    let (mut least, mut most) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let mut half = DVec2::ONE;
    let spheres = harness.state().document().spheres.iter().flat_map(|sphere| {
        let Sphere { center, radius } = sphere.shape;
        DVec3::AXES
            .into_iter()
            .flat_map(move |axis| [center + radius * axis, center - radius * axis])
    });
    let ray = harness.state().derived().inspection.clone().filter(|_| items.shows(Item::Hit));
    let hit = ray.and_then(|ray| ray.first_hit().map(|hit| hit.point));
    let others = spheres.chain(hit).map(|p| (p, false));
    for (point, is_own) in points.iter().map(|p| (*p, true)).chain(others) {
        let at;
        [at, half] = in_view(harness, point);
        if is_own && (half - at.abs()).min_element() < 8.0_f64.min(0.08 * half.y) {
            return Some(format!("{point} is at {at} of {half}"));
        }
        (least, most) = (least.min(at.max(-half)), most.max(at.min(half)));
    }
    let share = ((most - least) / (2.0 * half)).max_element();
    (share < 0.19).then(|| format!("scene and camera fill {share:.2} of {half}"))
}

/// Opens a step before an audience, with the answer to its question.
fn present(harness: &mut Harness<'_, App>, lesson: usize, step: usize) {
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    harness.state_mut().open_lesson(id, None);
    harness.run_steps(3);
    if harness.state().session().shown.is_asking {
        harness.key_press(Key::PageDown);
        harness.run_steps(3);
    }
}

#[test]
fn a_step_without_arrows_leaves_the_view_to_what_it_shows() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.key_press(Key::F5);
    for size in [vec2(1024.0, 768.0), vec2(1920.0, 1080.0)] {
        harness.set_size(size);
        // The graph covers nearly half of the view.
        for (lesson, step, least) in [(12, 8, 0.4), (12, 6, 0.15), (13, 1, 0.15)] {
            present(&mut harness, lesson, step);
            let ball = harness.state().document().spheres[0].shape;
            let up = ball.radius
                * harness.state().derived().world_frame.clone().unwrap().camera().basis().v;
            let [top, half] = in_view(&harness, ball.center + up);
            let [bottom, _] = in_view(&harness, ball.center - up);
            let share = (top.y - bottom.y) / (2.0 * half.y);
            assert!((least..1.0).contains(&share), "{lesson}.{step} at {size}: {share}");
        }
    }
}

#[test]
fn a_low_view_has_room_for_the_arrows_and_the_ball() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.key_press(Key::F5);
    harness.set_size(vec2(1024.0, 768.0));
    for step in 1..=3 {
        present(&mut harness, 10, step);
        assert_tips_in_sight(&harness, &format!("10.{step}"));
        let camera = camera(&harness);
        let ball = harness.state().document().spheres[0].shape.center;
        let [[eye, half], [ball, _]] = [camera.eye, ball].map(|at| in_view(&harness, at));
        let share = (ball.x - eye.x).abs() / (2.0 * half.x);
        assert!(share > 0.15, "10.{step}: the ball is {share} of the view from the eye");
    }
}

#[test]
fn items_that_a_hand_switches_move_nothing() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(0), step: 3 }, None);
    harness.run_steps(3);
    let before = observer(&harness);
    for item in [Item::Basis, Item::ViewAndUp, Item::Axes] {
        command(&mut harness, &format!("Overlay: {}", item.label()));
        assert!(harness.state().session().shown.setup.items.shows(item));
        assert_eq!(observer(&harness), before, "{item:?}");
    }
    harness.set_size(vec2(900.0, 700.0));
    harness.run_steps(3);
    assert_tips_in_sight(&harness, "switched on by hand, in another view");
}

#[test]
fn a_step_is_seen_alike_from_whichever_it_is_opened() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    // Small views are quickly traced.
    harness.set_size(vec2(640.0, 400.0));
    let mut found = Vec::new();
    for (lesson, steps) in builtin::all().iter().enumerate() {
        let mut seen = |steps: &[(usize, usize)]| {
            for (lesson, step) in steps {
                let id = StepId { lesson: Which::Builtin(*lesson), step: *step };
                harness.state_mut().open_lesson(id, None);
                harness.run_steps(3);
            }
            harness.state().session().shown.observer
        };
        for step in 1..steps.steps.len() {
            let next = seen(&[(lesson, step - 1), (lesson, step)]);
            if seen(&[((lesson + 1) % 13, 0), (lesson, step)]) != next {
                found.push(format!("{}.{}", lesson + 1, step + 1));
            }
        }
    }
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn the_first_scene_is_seen_from_the_side_and_above_with_at_on_the_ball() {
    let harness = window_with("canonical", Remembered::default(), None);
    let ball = harness.state().document().spheres[0].shape.center;
    assert_eq!(super::at_of(&camera(&harness)), ball);
    let frame = harness.state().derived().world_frame.clone().unwrap();
    let back = frame.camera().basis().w;
    let along = back.dot(camera(&harness).resolve().unwrap().basis().w);
    assert!((0.45..0.85).contains(&along), "beside the camera, not behind it: {along}");
    assert!((0.2..0.5).contains(&back.y), "a little above: {}", back.y);
}

#[test]
fn readouts_are_as_high_as_before_once_a_small_window_is_large_again() {
    let mut settings = pinhole::model::session::Settings::default();
    settings.preferences.unfolded.numbers = true;
    let mut harness =
        window_with("canonical", Remembered { settings, ..Remembered::default() }, None);
    let before = harness.state().session().preferences.splits;
    let view = |harness: &Harness<'_, App>| {
        harness.get_by_role_and_label(Role::Image, "World view").rect()
    };
    let large = view(&harness);
    harness.set_size(vec2(640.0, 300.0));
    harness.run();
    harness.set_size(crate::harness::SIZE);
    harness.run();
    assert_eq!(harness.state().session().preferences.splits, before);
    assert_eq!(view(&harness), large);
}

#[test]
fn titles_and_buttons_above_the_views_do_not_overlap_in_a_small_window() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.set_size(vec2(640.0, 480.0));
    harness.run();
    let rects = |role: Role, names: &[&str]| -> Vec<egui::Rect> {
        let named = names.iter().flat_map(|name| harness.query_all_by_role_and_label(role, name));
        named.map(|node| node.rect()).collect()
    };
    let mut all = rects(Role::Label, &["World view", "Camera view"]);
    assert_eq!(all.len(), 2);
    all.extend(rects(Role::Button, &["Maximise", "Eye orbits at"]));
    assert!(all.len() >= 4);
    for (k, one) in all.iter().enumerate() {
        for other in &all[..k] {
            assert!(!one.shrink(0.5).intersects(*other), "{one} and {other}");
        }
    }
}

#[test]
fn the_lesson_on_the_viewport_compares_like_with_like() {
    let lessons = pinhole::model::lessons::builtin::all();
    let warm_up = &lessons[1].steps[0].document;
    for step in &lessons[2].steps[..3] {
        let document = &step.document;
        assert_eq!(document.spheres, lessons[2].steps[0].document.spheres, "{}", step.title);
        assert_eq!(document.planes, warm_up.planes, "{}", step.title);
        assert_eq!(document.camera.orientation, warm_up.camera.orientation, "{}", step.title);
        assert_eq!(step.shown.observer, lessons[2].steps[0].shown.observer, "{}", step.title);
    }
    assert_eq!(lessons[2].steps[1].document.camera.viewport.distance, 2.0);
    assert_eq!(lessons[2].steps[1].shown.selection, lessons[1].steps[0].shown.selection);
}

#[test]
fn the_basis_of_lesson_5_points_neither_at_the_observer_nor_away_from_it() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    for step in 0..3 {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(4), step }, None);
        harness.run();
        let eye = harness.state().derived().world_frame.as_ref().unwrap().camera().eye();
        let camera = camera(&harness);
        let toward = (eye - camera.eye).normalize();
        let basis = *camera.resolve().unwrap().basis();
        for (name, axis) in [("u", basis.u), ("v", basis.v), ("w", basis.w)] {
            let seen = axis.cross(toward).length();
            assert!(seen > 0.5, "5.{}: {seen} of {name} is seen", step + 1);
        }
    }
}

#[test]
fn the_planet_s_horizon_is_in_sight_and_v_stands_out_from_the_ground() {
    for size in SIZES {
        let mut harness = window_with("planet", Remembered::default(), None);
        harness.set_size(size);
        harness.run();
        let app = harness.state();
        let frame = app.derived().world_frame.clone().unwrap();
        let (rows, columns) = (frame.raster().rows().len(), frame.raster().columns().len());
        let is_sky = |row: &usize| frame.object[row * columns + columns / 2] == NO_OBJECT;
        let sky = (0..rows).filter(is_sky).count() as f64 / rows as f64;
        assert!(sky > 0.08, "{sky} of the view's height at {size}");
        let [r, g, b] = app.document().color_of(0);
        for is_dark in [false, true] {
            let v = Style::new(Scheme::default(), is_dark).colors().basis[1];
            let apart = [r.abs_diff(v.r()), g.abs_diff(v.g()), b.abs_diff(v.b())];
            assert!(apart.into_iter().max() > Some(64), "{apart:?}");
        }
    }
}

#[test]
fn the_lecture_s_button_is_whole_in_every_window() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    for size in [vec2(1280.0, 1000.0), vec2(640.0, 480.0), vec2(520.0, 400.0)] {
        harness.set_size(size);
        harness.run();
        let area = egui::Rect::from_min_size(egui::Pos2::ZERO, size);
        let buttons = ["Start the lecture", "Practise", "Present", "All numbers"];
        let there = buttons.map(|button| {
            let mut found = harness.query_all_by_role_and_label(Role::Button, button);
            // A workspace and a command have the same names.
            found.find(|found| found.rect().top() > 60.0).map(|found| found.rect())
        });
        assert!(there[0].is_some(), "{size}");
        for (name, rect) in buttons.into_iter().zip(there) {
            let Some(rect) = rect else { continue };
            assert!(area.contains_rect(rect), "{name} at {size}: {rect}");
        }
    }
}
