//! Nothing that is drawn over the views covers anything else: labels, handles and hints, in every
//! built-in scene.

use egui::accesskit::Role;
use egui::{Key, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole::view::derive::FinishedView;
use pinhole_exchange::scenes::BuiltinScene;
use pinhole_figure::overlay::Shape;
use pinhole_figure::overlay_items::Item;

use crate::harness::window_with;

/// The window's sizes, in points.
const SIZES: [Vec2; 3] = [vec2(1024.0, 768.0), vec2(1280.0, 800.0), vec2(1920.0, 1080.0)];

/// What may be cut off at a view's border, in points: the rounding of a rectangle to pixels.
const ROUNDING: f32 = 1.0;

/// What is drawn over a view, in points of the window.
struct Drawn {
    name: String,
    area: Rect,
    /// What is placed freely and so must be in sight as a whole.
    is_label: bool,
}

/// The areas of the labels and handles of a view whose rectangle is `rect`.
fn drawn(rect: Rect, shown: &FinishedView, scale: f32) -> Vec<Drawn> {
    let in_window = |[x, y]: [f32; 2]| rect.min + vec2(x, y) / scale;
    let labels = shown.labels.iter().map(|label| {
        let size = 2.0 * Vec2::from(label.half_extent(scale)) / scale;
        let area = Rect::from_center_size(in_window(label.position), size);
        Drawn { name: format!("“{}”", label.text), area, is_label: true }
    });
    // A handle is a filled shape, and a smaller one in its middle.
    let mut handles: Vec<Rect> = Vec::new();
    for mark in shown.marks.iter().filter(|mark| mark.item == Item::Handles) {
        let area = match &mark.shape {
            Shape::Disc { center, radius } => {
                Rect::from_center_size(in_window(*center), Vec2::splat(2.0 * radius / scale))
            }
            Shape::Polygon { points } => {
                let points: Vec<Pos2> = points.iter().map(|point| in_window(*point)).collect();
                Rect::from_points(&points)
            }
            Shape::Line { .. } => continue,
        };
        if !handles.iter().any(|other| other.contains_rect(area)) {
            handles.push(area);
        }
    }
    let handles = handles.into_iter().map(|area| Drawn {
        name: format!("a handle at {:?}", area.center() - rect.min),
        area,
        is_label: false,
    });
    labels.chain(handles).collect()
}

/// The words and buttons that lie over a view.
fn hints(harness: &Harness<'_, App>, rect: Rect) -> Vec<Drawn> {
    let nodes = harness.root().children_recursive();
    let over = nodes.filter_map(|node| {
        let role = node.accesskit_node().role();
        let is_text = matches!(role, Role::Label | Role::Button);
        node.accesskit_node().bounding_box()?;
        let area = node.rect().intersect(rect);
        let name = node.accesskit_node().label().or_else(|| node.accesskit_node().value())?;
        (is_text && area.is_positive()).then_some(Drawn { name, area, is_label: false })
    });
    over.collect()
}

/// Everything that covers something else, or is cut off at its view's border.
pub(in crate::app) fn offences(harness: &Harness<'_, App>) -> Vec<String> {
    let scale = harness.ctx.pixels_per_point();
    let derived = harness.state().derived();
    let views = [("World view", &derived.world_view), ("Camera view", &derived.camera_view)];
    let mut found = Vec::new();
    for (view, shown) in views {
        let node = harness.query_by_role_and_label(Role::Image, view);
        let (Some(node), Some(shown)) = (node, shown) else { continue };
        let rect = node.rect();
        let is_stale = derived.fault.is_some() && view == "Camera view";
        let mut all = if is_stale { Vec::new() } else { drawn(rect, shown, scale) };
        all.extend(hints(harness, rect));
        for (k, one) in all.iter().enumerate() {
            if one.is_label && !rect.expand(ROUNDING).contains_rect(one.area) {
                found.push(format!("{view}: {} is cut off", one.name));
            }
            for other in &all[..k] {
                if one.area.shrink(ROUNDING).intersects(other.area.shrink(ROUNDING)) {
                    found.push(format!("{view}: {} and {}", one.name, other.name));
                }
            }
        }
    }
    found
}

#[test]
fn nothing_covers_anything_else_in_any_scene() {
    let mut found = Vec::new();
    for size in SIZES {
        for scene in BuiltinScene::all() {
            let mut harness = window_with(scene.name, Remembered::default(), None);
            harness.set_size(size);
            for mode in ["", ", presented"] {
                // The animations of a whole second are not waited for.
                harness.run_steps(3);
                let offences = offences(&harness).into_iter();
                found.extend(offences.map(|it| format!("{} at {size}{mode}: {it}", scene.name)));
                harness.key_press(Key::F5);
            }
        }
    }
    assert!(found.is_empty(), "{} offences:\n{}", found.len(), found.join("\n"));
}
