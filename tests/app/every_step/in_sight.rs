//! What the world view draws is in sight, and its labels are legible.

use egui::{Pos2, Rect, Vec2, pos2};
use pinhole::ui::app::App;
use pinhole_figure::overlay::{Mark, Shape};
use pinhole_figure::overlay_items::Item;

use super::Seen;

/// What covers the world view, in its pixels.
fn insets(seen: &Seen<'_>, world: Rect) -> Vec<Rect> {
    let names = ["Camera view", "Plot of f(p + t d)"];
    let insets = names.into_iter().filter_map(|name| Some(seen.rect(name)?.intersect(world)));
    let scale = seen.window.ctx.pixels_per_point();
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
/// that is drawn. That of a wrong camera is an answer, and ends on what the wrong camera sees.
fn is_endless(app: &App, mark: &Mark) -> bool {
    let items = app.session().shown.setup.items;
    let shows_planes = items.shows(Item::Planes) || items.shows(Item::Hit);
    let hit = app.derived().inspection.as_ref().and_then(|ray| ray.first_hit().copied());
    let has_end =
        hit.is_some_and(|hit| shows_planes || (hit.object as usize) < app.document().spheres.len());
    match mark.item {
        Item::Planes | Item::Floor | Item::Frustum => true,
        // The ray of an answer.
        Item::Eye => hit.is_none() && matches!(mark.shape, Shape::Line { .. }),
        Item::Ray => !has_end && matches!(mark.shape, Shape::Line { .. }),
        _ => false,
    }
}

/// The marks of the world view that reach beyond it, or below an inset.
pub(super) fn out_of_sight(seen: &Seen<'_>) -> Vec<String> {
    let Some(world) = seen.rect("World view") else { return Vec::new() };
    let Some(shown) = seen.app().derived().world_view.clone() else { return Vec::new() };
    let picture = world.size() * seen.window.ctx.pixels_per_point();
    let picture = Rect::from_min_size(Pos2::ZERO, picture).expand(0.5);
    let insets = insets(seen, world);
    let is_hidden =
        |at: &Pos2| !picture.contains(*at) || insets.iter().any(|rect| rect.contains(*at));
    // What a step is about fills the view; what else is drawn may leave it.
    let directed = seen.app().session().live.directed;
    let is_subject = |mark: &&Mark| {
        directed.is_none_or(|now| mark.concept.is_some_and(|one| now.spoken.contains(one)))
    };
    let marks = shown.marks.iter().filter(|mark| !is_endless(seen.app(), mark));
    let marks = marks.filter(is_subject);
    let hidden = marks.map(|mark| (mark, points(mark).into_iter().filter(is_hidden)));
    let hidden = hidden.map(|(mark, at)| (mark, at.collect::<Vec<Pos2>>()));
    let hidden = hidden.filter(|(_, at)| !at.is_empty());
    hidden.map(|(m, at)| format!("{:?} {:?} {at:?} {insets:?}", m.item, m.concept)).collect()
}

/// The labels of the world view that lie on another one, on a handle or on the tip of an arrow.
pub(super) fn covered(seen: &Seen<'_>) -> Vec<String> {
    let shown = seen.app().derived().world_view.clone();
    let Some(shown) = shown.filter(|_| seen.rect("World view").is_some()) else {
        return Vec::new();
    };
    let scale = seen.window.ctx.pixels_per_point();
    let extent = |k: usize| Vec2::from(shown.labels[k].half_extent(scale));
    let area = |k: usize| Rect::from_center_size(shown.labels[k].position.into(), 2.0 * extent(k));
    let mut found = Vec::new();
    for (k, label) in shown.labels.iter().enumerate() {
        let others = (0..k).filter(|other| area(k).shrink(0.1).intersects(area(*other)));
        found.extend(others.map(|k| format!("{} on {}", label.text, shown.labels[k].text)));
        for mark in shown.marks.iter() {
            let is_tip = matches!(&mark.shape, Shape::Polygon { points } if points.len() == 3);
            let is_handle = mark.item == Item::Handles && !matches!(mark.shape, Shape::Line { .. });
            if (is_tip || is_handle) && area(k).contains(points(mark)[0]) {
                found.push(format!("{} on {:?} {:?}", label.text, mark.item, mark.concept));
            }
        }
    }
    found
}
