//! The plot of f(p + t d), and walking along the ray.

use egui::accesskit::Role;
use egui::epaint::Shape;
use egui::{Key, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_figure::concept::Concept;
use pinhole_figure::overlay::world_position_of;
use pinhole_figure::overlay_items::Item;

use crate::harness::{assert_reads, assert_says, says, show, type_into, window};

fn open(scene: &str) -> Harness<'static, App> {
    let mut window = window(scene);
    show(&mut window, ViewLayout::Plot);
    window
}

/// The t that the world view's label says.
fn t_in_the_world_view(window: &Harness<'_, App>) -> Option<String> {
    let labels = window.state().derived().world_view.clone()?.labels;
    let walked = |text: &String| text.starts_with("t = ");
    labels.iter().filter(|l| l.item == Item::Ray).map(|l| l.text.clone()).find(walked)
}

fn select(window: &mut Harness<'_, App>, u: &str, v: &str) {
    type_into(window, "uv u", u);
    type_into(window, "uv v", v);
}

#[test]
fn every_object_s_curve_says_what_it_does() {
    let mut window = open("canonical");
    assert_reads(&window, "D < 0: f is never 0: missed");
    assert_reads(&window, "straight line, 0 at t = 6");
    select(&mut window, "0", "0");
    assert_reads(&window, "D > 0: in at t = 4, out at t = 6");
    assert_says(&window, "the first hit");
    type_into(&mut window, "at z", "-9");
    type_into(&mut window, "eye z", "-5");
    assert_reads(
        &window,
        "f < 0 at t = 0: the eye is inside; t = −1 is behind, t = 1 is its first root ahead",
    );
    type_into(&mut window, "eye z", "-5.5");
    type_into(&mut window, "at z", "-5");
    assert_reads(
        &window,
        "f < 0 at t = 0: the eye is inside; t = −0.5 is behind, t = 1.5 is its first root ahead",
    );
}

#[test]
fn walking_keeps_the_shape_of_the_curves() {
    let mut window = open("canonical");
    let samples = |window: &Harness<'_, App>| {
        let plot = window.state().derived().plot.as_ref().unwrap();
        plot.curves.iter().map(|curve| curve.samples.clone()).collect::<Vec<_>>()
    };
    let before = samples(&window);
    window.get_by_role_and_label(Role::CheckBox, "Walk along the ray").click();
    window.run();
    type_into(&mut window, "walked t", "4.5");
    assert_eq!(before, samples(&window));
    select(&mut window, "0", "0");
    assert_ne!(before, samples(&window));
}

#[test]
fn what_is_said_of_a_curve_lights_its_object() {
    let mut window = open("canonical");
    let line = window.get_by_label("straight line, 0 at t = 6").rect();
    window.hover_at(line.center());
    window.run();
    let concept = window.state().session().live.hovered.map(|pointed| pointed.concept);
    assert_eq!(concept, Some(Concept::Object(2)));
    window.remove_cursor();
    window.run();
    assert_eq!(window.state().session().live.hovered, None);
}

#[test]
fn tangent_and_behind_explain_themselves() {
    let mut window = open("canonical");
    select(&mut window, "0", "0");
    type_into(&mut window, "eye x", "1");
    type_into(&mut window, "at x", "1");
    assert_reads(&window, "D = 0: f touches 0 once, at t = 5: tangent, so it hits");
    type_into(&mut window, "eye x", "0");
    type_into(&mut window, "at x", "0");
    type_into(&mut window, "at z", "-9");
    type_into(&mut window, "eye z", "-8");
    assert_reads(&window, "0 only at t = −4 and t = −2, not ahead of the eye: no hit");
    assert_reads(&window, "0 only at t = −2, behind the eye: no hit");
}

#[test]
fn walking_is_seen_in_the_world_view_and_read_off_as_numbers() {
    let mut window = open("canonical");
    select(&mut window, "0", "0");
    assert_eq!(t_in_the_world_view(&window), None);
    window.get_by_role_and_label(Role::CheckBox, "Walk along the ray").click();
    window.run();
    assert_eq!(window.state().session().shown.ray_point_t, Some(2.0));
    assert_says(&window, "outside all objects");
    type_into(&mut window, "walked t", "4.5");
    assert_eq!(t_in_the_world_view(&window).as_deref(), Some("t = 4.5"));
    assert_reads(&window, "p + t d = (0, 0, −4.5)");
    assert_reads(&window, "at t = 4.5: f = −0.75 < 0: inside");
    assert_reads(&window, "at t = 4.5: f = 1.5 > 0: on the side that n points to");
    assert_says(&window, "inside sphere 0 “ball”");
    type_into(&mut window, "walked t", "4");
    assert_says(&window, "on sphere 0 “ball”");
    assert!(!says(&window, "outside all objects"), "at t = 4: f = 0: on it");
    type_into(&mut window, "walked t", "4.5");
    window.get_by_role_and_label(Role::CheckBox, "Walk along the ray").click();
    window.run();
    assert_eq!(t_in_the_world_view(&window), None);
}

#[test]
fn dragging_in_the_plot_walks_there() {
    let mut window = open("canonical");
    let before = window.state().derived().world_view.clone().unwrap().image;
    let plot = window.get_by_label("Plot of f(p + t d)").rect();
    let at = |share: f32| egui::pos2(plot.left() + share * plot.width(), plot.center().y);
    window.hover_at(at(0.5));
    window.run();
    window.drag_at(at(0.5));
    window.run();
    let middle = window.state().session().shown.ray_point_t;
    window.hover_at(at(0.8));
    window.run();
    window.drop_at(at(0.8));
    window.run();
    let walked = window.state().session().shown.ray_point_t.unwrap();
    assert!(middle.is_none_or(|middle| middle < walked), "{middle:?} {walked}");
    let said = window.get_by_label("Plot of f(p + t d)").accesskit_node().description();
    assert_eq!(said.as_deref(), Some(format!("point marked at t = {walked}").as_str()));
    let after = window.state().derived().world_view.clone().unwrap().image;
    assert_ne!(before.pixels, after.pixels);
}

#[test]
fn of_many_objects_the_first_met_are_shown_and_the_rest_counted() {
    let folder = tempfile::tempdir().unwrap();
    let row = |k: i32| format!("0,0,{},0.3\n", -2 - k);
    let rows: String = (0..20).map(row).collect();
    std::fs::write(folder.path().join("row.csv"), format!("x,y,z,r\n{rows}")).unwrap();
    let path = folder.path().join("row.toml");
    let text = "pinhole = 1\nspheres = \"row.csv\"\n\
                [camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";
    std::fs::write(&path, text).unwrap();
    let mut window = open(path.to_str().unwrap());
    select(&mut window, "0", "0");
    assert_says(&window, "12 more objects are left out");
    assert_reads(&window, "D > 0: in at t = 1.7, out at t = 2.3");
}

#[test]
fn the_point_that_walks_is_dragged_in_the_world_view() {
    let mut window = open("canonical");
    window.get_by_role_and_label(Role::CheckBox, "Walk along the ray").click();
    window.run();
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let to_screen = |window: &Harness<'_, App>, t: f64| {
        let derived = window.state().derived();
        let ray = derived.inspection.clone().unwrap().ray;
        let frame = derived.world_frame.clone().unwrap();
        let at = world_position_of(frame.camera(), ray.at(t)).unwrap();
        rect.min + vec2(at.x as f32, at.y as f32)
    };
    let observer = window.state().session().shown.observer;
    let (from, to) = (to_screen(&window, 3.0), to_screen(&window, 4.5));
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.run();
    window.hover_at(to);
    window.run();
    window.drop_at(to);
    window.run();
    let walked = window.state().session().shown.ray_point_t.unwrap();
    assert!((walked - 4.5).abs() < 0.05, "{walked}");
    assert_eq!(window.state().session().shown.observer, observer, "the observer stays");
}

/// A window of this size on a step of lesson 12, counted from 1, with its question answered.
fn lesson(step: usize, size: egui::Vec2) -> Harness<'static, App> {
    answered((12, step), size)
}

/// A window of this size on a step of a lesson, both counted from 1, with its question answered.
pub(super) fn answered((lesson, step): (usize, usize), size: egui::Vec2) -> Harness<'static, App> {
    let mut window = window("canonical");
    window.set_size(size);
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    window.state_mut().open_lesson(id, None);
    window.run();
    if window.state().session().shown.is_asking {
        window.key_press(Key::PageDown);
        window.run();
    }
    window
}

/// The labels in the plot, without the numbers of its axes.
fn labels(window: &Harness<'_, App>) -> Vec<(String, Rect)> {
    labels_in(window, "Plot of f(p + t d)")
}

/// The labels in a drawing with halos, and where they are.
pub(super) fn labels_in(window: &Harness<'_, App>, drawing: &str) -> Vec<(String, Rect)> {
    let plot = window.get_by_label(drawing).rect();
    let label = |shape: &Shape| {
        let Shape::Vec(shapes) = shape else { return None };
        let Some(Shape::Text(text)) = shapes.last() else { return None };
        let rect = text.visual_bounding_rect();
        plot.contains_rect(rect).then(|| (text.galley.job.text.clone(), rect))
    };
    window.output().shapes.iter().filter_map(|clipped| label(&clipped.shape)).collect()
}

#[test]
fn two_objects_that_are_met_at_one_t_share_its_number() {
    for step in [5, 7] {
        let window = lesson(step, vec2(1280.0, 1000.0));
        let numbers: Vec<String> = labels(&window).into_iter().map(|(text, _)| text).collect();
        let shared = if step == 5 { "6" } else { "5" };
        let count = numbers.iter().filter(|text| text.ends_with(shared)).count();
        assert_eq!(count, 1, "12.{step}: {numbers:?}");
    }
}

#[test]
fn an_open_question_has_the_graph_s_axes_but_no_curve() {
    let mut window = window("canonical");
    window.set_size(vec2(1280.0, 1000.0));
    window.state_mut().open_lesson(StepId { lesson: Which::Builtin(11), step: 4 }, None);
    window.run();
    let painted = |window: &Harness<'_, App>, part: &str| {
        let mut shapes = window.output().shapes.iter();
        shapes.any(|clipped| match &clipped.shape {
            Shape::Text(text) => text.galley.job.text.starts_with(part),
            Shape::Vec(shapes) => matches!(shapes.last(), Some(Shape::Text(text))
                if text.galley.job.text.starts_with(part)),
            _ => false,
        })
    };
    for answered in [false, true] {
        assert!(painted(&window, "|𝐩 + 𝑡 𝐝 − centre|") && painted(&window, "behind"));
        for part in ["ball", "first hit"] {
            assert_eq!(painted(&window, part), answered, "{part}");
        }
        window.key_press(Key::PageDown);
        window.run();
    }
}

#[test]
fn no_word_stands_beside_a_root_s_number() {
    let mut window = window("canonical");
    window.set_size(vec2(820.0, 461.0));
    window.state_mut().open_lesson(StepId { lesson: Which::Builtin(12), step: 1 }, None);
    window.key_press(Key::PageDown);
    window.run();
    let labels = labels(&window);
    let (_, six) = labels.iter().find(|(text, _)| text == "6").unwrap();
    let beside = |rect: &Rect| rect.y_range().contains(six.center().y) && rect.right() < six.left();
    let near = labels.iter().filter(|(_, rect)| beside(rect) && six.left() - rect.right() < 12.0);
    assert_eq!(near.count(), 0, "{labels:?}");
}

#[test]
fn every_root_has_its_number_before_an_audience_too() {
    let mut window = lesson(8, vec2(1024.0, 768.0));
    window.key_press(Key::F5);
    window.run();
    window.set_size(vec2(820.0, 461.0));
    window.run();
    let shown: Vec<String> = labels(&window).into_iter().map(|(text, _)| text).collect();
    for root in ["−3", "−2", "−1"] {
        assert!(shown.iter().any(|text| text == root), "no {root}: {shown:?}");
    }
}

#[test]
fn no_curve_runs_through_a_word_of_the_lesson_on_many_rays() {
    for step in [1, 2] {
        let mut window = answered((13, step), vec2(1024.0, 768.0));
        window.key_press(Key::F5);
        window.run();
        let rect = window.get_by_label("Plot of f(p + t d)").rect();
        let plot = window.state().derived().plot.clone().unwrap();
        let (t, length) = (plot.range.start(), plot.range.end() - plot.range.start());
        let at = |(x, y): &(f64, f64)| {
            rect.lerp_inside(vec2(((x - t) / length) as f32, ((4.4 - y) / 6.8) as f32))
        };
        let samples: Vec<egui::Pos2> =
            plot.curves.iter().flat_map(|curve| &curve.samples).map(at).collect();
        for (text, rect) in
            labels(&window).iter().filter(|(text, _)| text.contains(char::is_alphabetic))
        {
            assert!(!samples.iter().any(|at| rect.contains(*at)), "13.{step}: {text}");
        }
    }
}

#[test]
fn of_two_equal_curves_both_are_seen() {
    let mut window = lesson(7, vec2(1280.0, 1000.0));
    window.remove_cursor();
    window.run();
    let plot = window.get_by_label("Plot of f(p + t d)").rect();
    // Where the parabolas rise, at the right of what they touch.
    let part =
        Rect::from_min_max(plot.lerp_inside(vec2(0.6, 0.1)), plot.lerp_inside(vec2(0.95, 0.4)));
    let colors: Vec<[u8; 4]> = window.state().derived().plot.as_ref().unwrap().curves[..2]
        .iter()
        .map(|curve| curve.named.color.to_array())
        .collect();
    let image = window.render().unwrap();
    for color in colors {
        let near = |x: u32, y: u32| {
            let pixel = image.get_pixel(x, y).0;
            (0..3).all(|k| pixel[k].abs_diff(color[k]) < 12)
        };
        let pixels = (part.top() as u32..part.bottom() as u32)
            .flat_map(|y| (part.left() as u32..part.right() as u32).map(move |x| (x, y)));
        let count = pixels.filter(|(x, y)| near(*x, *y)).count();
        assert!(count > 20, "{color:?}: {count} pixels");
    }
}

#[test]
fn no_name_or_text_is_cut_off_in_a_small_window() {
    let mut window = window("inside");
    show(&mut window, ViewLayout::Plot);
    window.set_size(vec2(1024.0, 768.0));
    window.run();
    let right = window.ctx.content_rect().right();
    assert!(window.get_by_label("the first hit").rect().right() <= right);
}
