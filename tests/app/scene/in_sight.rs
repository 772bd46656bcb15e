//! In every step of the lessons, what the world view draws is in sight, and its labels are legible.

use std::fmt::Write as _;

use egui::accesskit::Role;
use egui::{Key, Pos2, Rect, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which, builtin};
use pinhole::model::overlay_items::Item;
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole::view::derive::Shown;
use pinhole::view::overlay::{Label, Mark, Shape};

use crate::harness::window;

/// Sizes of the window, in points: 1920 x 1080 pixels while presenting, and a phone.
const SIZES: [Vec2; 2] = [vec2(820.0, 461.0), vec2(390.0, 844.0)];

/// Calls `check` for each step with a world view, in each size, before and after the answer.
fn for_each_step(mut check: impl FnMut(&Harness<'_, App>, &Shown, Rect, &str)) {
    let mut window = window("canonical");
    for size in SIZES {
        let is_phone = size.x < size.y;
        if window.state().session().presenting.is_some() == is_phone {
            window.key_press(Key::F5);
        }
        window.set_size(size);
        window.run();
        for (lesson, steps) in builtin::all().iter().enumerate() {
            for (step, shown) in steps.steps.iter().enumerate() {
                if shown.view.layout == Some(ViewLayout::Exercises) {
                    continue;
                }
                let id = StepId { lesson: Which::Builtin(lesson), step };
                window.state_mut().open_lesson(id, None);
                window.run();
                let mut name = format!("{}.{} at {size}", lesson + 1, step + 1);
                loop {
                    let world = window.query_by_role_and_label(Role::Image, "World view");
                    let world = world.map(|view| view.rect());
                    if let (Some(rect), Some(shown)) =
                        (world, window.state().derived().world_view.clone())
                    {
                        check(&window, &shown, rect, &name);
                    }
                    if !window.state().session().is_asking {
                        break;
                    }
                    window.key_press(Key::End);
                    window.run();
                    name.push_str(", answered");
                }
            }
        }
    }
}

/// What covers the world view, in its pixels.
fn covered(window: &Harness<'_, App>, world: Rect) -> Vec<Rect> {
    let names = ["Camera view", "Plot of f(p + t d)"];
    let insets = names.iter().filter_map(|name| {
        window.query_by_role_and_label(Role::Image, name).map(|view| view.rect().intersect(world))
    });
    let scale = window.ctx.pixels_per_point();
    let inside = insets.filter(|rect| rect.is_positive());
    inside.map(|rect| rect.translate(-world.min.to_vec2()) * scale).collect()
}

fn points(mark: &Mark) -> Vec<Pos2> {
    let to_pos = |[x, y]: [f32; 2]| pos2(x, y);
    match &mark.shape {
        Shape::Line { points, .. } | Shape::Polygon { points } => {
            points.iter().copied().map(to_pos).collect()
        }
        Shape::Disc { center, .. } => vec![to_pos(*center)],
    }
}

/// Whether a mark may leave the picture: planes, floor and frustum have no end, nor has a ray that hits nothing
/// that is drawn. The ray of a wrong camera is an answer, which belongs to the eye.
fn is_endless(window: &Harness<'_, App>, mark: &Mark) -> bool {
    let app = window.state();
    let items = app.session().settings.items;
    let shows_planes = items.shows(Item::Planes) || items.shows(Item::Hit);
    let hit = app.derived().inspection.as_ref().and_then(|ray| ray.first_hit().copied());
    let has_end =
        hit.is_some_and(|hit| shows_planes || (hit.object as usize) < app.document().spheres.len());
    match mark.item {
        Item::Planes | Item::Floor | Item::Frustum => true,
        Item::Ray => !has_end && matches!(mark.shape, Shape::Line { .. }),
        Item::Eye => app.session().settings.layout == ViewLayout::Mistakes,
        _ => false,
    }
}

#[test]
fn nothing_that_a_step_draws_is_out_of_sight() {
    let mut found = String::new();
    for_each_step(|window, shown, world, name| {
        let scale = window.ctx.pixels_per_point();
        let picture = Rect::from_min_size(Pos2::ZERO, world.size() * scale).expand(0.5);
        let insets = covered(window, world);
        for mark in shown.marks.iter().filter(|mark| !is_endless(window, mark)) {
            let outside: Vec<Pos2> = points(mark)
                .into_iter()
                .filter(|at| !picture.contains(*at) || insets.iter().any(|rect| rect.contains(*at)))
                .collect();
            if !outside.is_empty() {
                let (item, concept) = (mark.item, mark.concept);
                writeln!(found, "{name}: {item:?} {concept:?} {outside:?} of {picture} {insets:?}")
                    .unwrap();
            }
        }
    });
    assert!(found.is_empty(), "{found}");
}

fn box_of(label: &Label, scale: f32) -> Rect {
    let [x, y] = label.half_extent(scale);
    Rect::from_center_size(label.position.into(), 2.0 * vec2(x, y))
}

#[test]
fn no_label_covers_another_or_a_handle_or_the_tip_of_an_arrow() {
    let mut found = String::new();
    for_each_step(|window, shown, _, name| {
        let scale = window.ctx.pixels_per_point();
        let boxes: Vec<Rect> = shown.labels.iter().map(|label| box_of(label, scale)).collect();
        for (k, (label, rect)) in shown.labels.iter().zip(&boxes).enumerate() {
            for (other, at) in shown.labels.iter().zip(&boxes).take(k) {
                if rect.shrink(0.1).intersects(*at) {
                    writeln!(found, "{name}: {} on {}", label.text, other.text).unwrap();
                }
            }
            for mark in shown.marks.iter() {
                let at = points(mark)[0];
                let is_tip = matches!(&mark.shape, Shape::Polygon { points } if points.len() == 3);
                let is_handle =
                    mark.item == Item::Handles && !matches!(mark.shape, Shape::Line { .. });
                if (is_tip || is_handle) && rect.contains(at) {
                    writeln!(found, "{name}: {} on {:?} {:?}", label.text, mark.item, mark.concept)
                        .unwrap();
                }
            }
        }
    });
    assert!(found.is_empty(), "{found}");
}
