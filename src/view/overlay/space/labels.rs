//! Label placement. Each label is put inside the picture, beside its anchor, over no other label
//! and no handle, and over as few lines as possible. One that has to stand off gets a leader line;
//! one that finds no room gives way to those before it.

use egui::Color32;
use pinhole_core::DVec2;

use crate::model::concept::Concept;
use crate::model::overlay_items::Item;
use crate::view::overlay::drawing::{Drawing, Label, Shape, dot, wide};
use crate::view::overlay::space::sketch::Pen;

/// A label to be placed.
#[derive(Clone, Debug)]
pub(crate) struct Request {
    /// The label; its position is still open.
    pub(crate) label: Label,
    pub(crate) concept: Option<Concept>,
    /// The point it names, in dots.
    pub(crate) anchor: DVec2,
    /// The preferred direction from the anchor; of any length, zero for no preference.
    pub(crate) toward: DVec2,
    /// Lower ranks are placed first.
    pub(crate) rank: u8,
}

impl Request {
    /// Creates the request for a pen's label with a colour, a size in points, and boldness.
    pub(crate) fn new(
        pen: Pen,
        text: String,
        (anchor, toward): (DVec2, DVec2),
        (color, size, bold): (Color32, f32, bool),
        halo: Color32,
    ) -> Request {
        let label = Label { item: pen.item, position: [0.0; 2], text, color, halo, size, bold };
        Request { label, concept: pen.concept, anchor, toward, rank: rank(pen.item) }
    }
}

/// Returns the rank of an item's label: the names of the camera's parts come before those of the
/// ray, the world's axes and the marks.
fn rank(item: Item) -> u8 {
    match item {
        Item::Handles => 1,
        Item::Eye | Item::Basis => 2,
        Item::ViewAndUp | Item::At => 3,
        Item::Ray | Item::Hit => 4,
        Item::Axes => 6,
        Item::Marks => 7,
        _ => 5,
    }
}

/// Distance from the anchor to the edge of the label, in points.
const GAP: f64 = 7.0;

/// Number of directions tried around the anchor, and of distances in each.
const DIRECTIONS: usize = 16;
const RINGS: usize = 9;

/// Distance from the anchor to the edge of a label, in points, beyond which it gets a leader line.
const LEADER_FROM: f64 = 20.0;

/// Distance, in points, between the sampled points of a line.
const OBSTACLE_SPACING: f64 = 5.0;

/// A rectangle: its centre, and half of its width and height.
type Area = (DVec2, DVec2);

/// Places the requests by rank, so that the first ones get the best positions, and adds the labels and
/// their leader lines to the drawing. A label that fits nowhere near its anchor is left out.
pub(crate) fn place(mut requests: Vec<Request>, drawing: &mut Drawing, size: DVec2) {
    requests.sort_by_key(|request| request.rank);
    let scale = drawing.scale;
    let obstacles = obstacles(drawing);
    let mut taken = handles(drawing);
    for mut request in requests {
        let half = half_extent(&request.label, scale);
        let free = |center: DVec2| {
            let margin = half + 1.0;
            let is_inside =
                center.cmpge(margin).all() && center.cmple((size - margin).max(margin)).all();
            is_inside
                && are_apart(&taken, center, half)
                && leader(&request, center, half, scale)
                    .is_none_or(|ends| taken.iter().all(|area| !crosses(ends, *area)))
        };
        let Some(center) = best_position(&request, half, f64::from(scale), &obstacles, &free)
        else {
            continue;
        };
        if let Some(ends) = leader(&request, center, half, scale) {
            let shape = Shape::Line { points: ends.map(dot).to_vec(), width: scale };
            let pen = Pen::new(request.label.item, request.label.color, 1.0);
            drawing.marks.push(pen.mark(shape, request.label.halo));
        }
        taken.push((center, half));
        request.label.position = dot(center);
        drawing.labels.push(request.label);
    }
}

/// Returns the line from an anchor to the label that names it, if that stands off.
fn leader(request: &Request, center: DVec2, half: DVec2, scale: f32) -> Option<[DVec2; 2]> {
    let end = request.anchor.clamp(center - half, center + half);
    let from = request.anchor.move_towards(end, 0.5 * GAP * f64::from(scale));
    (end.distance(request.anchor) > LEADER_FROM * f64::from(scale)).then_some([from, end])
}

/// Returns true if a line runs through an area that it does not begin in.
fn crosses([from, to]: [DVec2; 2], (center, half): Area) -> bool {
    const SAMPLES: usize = 16;
    let is_in = |at: DVec2| (at - center).abs().cmplt(half).all();
    !is_in(from) && (1..=SAMPLES).any(|k| is_in(from.lerp(to, k as f64 / SAMPLES as f64)))
}

/// Returns true if a rectangle overlaps none of the areas.
fn are_apart(areas: &[Area], center: DVec2, half: DVec2) -> bool {
    areas.iter().all(|(other, h)| (center - *other).abs().cmpgt(half + *h).any())
}

/// Returns the areas that handles cover.
fn handles(drawing: &Drawing) -> Vec<Area> {
    let marks = drawing.marks.iter().filter(|mark| mark.item == Item::Handles);
    let areas = marks.filter_map(|mark| match &mark.shape {
        Shape::Disc { center, radius } => Some((wide(*center), DVec2::splat((*radius).into()))),
        Shape::Polygon { points } => {
            let points = || points.iter().copied().map(wide);
            let (least, most) = (points().reduce(DVec2::min)?, points().reduce(DVec2::max)?);
            Some((0.5 * (least + most), 0.5 * (most - least)))
        }
        // A guide or the ring of a held handle, not a handle's area.
        Shape::Line { .. } => None,
    });
    areas.collect()
}

fn half_extent(label: &Label, scale: f32) -> DVec2 {
    wide(label.half_extent(scale))
}

fn best_position(
    request: &Request,
    half: DVec2,
    scale: f64,
    obstacles: &[DVec2],
    free: &dyn Fn(DVec2) -> bool,
) -> Option<DVec2> {
    let wish = request.toward.try_normalize();
    let step = 9.0 * scale;
    let reach = half.length() + GAP * scale + step * RINGS as f64;
    let near: Vec<DVec2> = obstacles
        .iter()
        .copied()
        .filter(|o| (*o - request.anchor).abs().max_element() < reach + half.max_element())
        .collect();
    let mut best: Option<(f64, DVec2)> = None;
    for ring in 0..RINGS {
        for k in 0..DIRECTIONS {
            let direction = DVec2::from_angle(k as f64 * std::f64::consts::TAU / DIRECTIONS as f64);
            let edge = direction.abs().dot(half);
            let center = request.anchor + direction * (edge + GAP * scale + step * ring as f64);
            let astray = wish.map_or(0.0, |wish| 1.0 - wish.dot(direction));
            let at_least = 2.0 * ring as f64 + 2.5 * astray;
            if best.is_some_and(|(least, _)| at_least >= least) || !free(center) {
                continue;
            }
            let crossed =
                near.iter().filter(|o| (**o - center).abs().cmplt(half).all()).count() as f64;
            let cost = crossed.min(12.0) + at_least;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, center));
            }
        }
    }
    best.map(|(_, center)| center)
}

/// Returns sample points along all lines.
fn obstacles(drawing: &Drawing) -> Vec<DVec2> {
    let spacing = OBSTACLE_SPACING * f64::from(drawing.scale);
    let mut points = Vec::new();
    for mark in &drawing.marks {
        match &mark.shape {
            Shape::Line { points: chain, .. } | Shape::Polygon { points: chain } => {
                for pair in chain.windows(2) {
                    let (a, b) = (wide(pair[0]), wide(pair[1]));
                    let count = ((b - a).length() / spacing).ceil().clamp(1.0, 4096.0);
                    points.extend((0..=count as usize).map(|k| a.lerp(b, k as f64 / count)));
                }
            }
            Shape::Disc { center, .. } => points.push(wide(*center)),
        }
    }
    points
}
