//! Places the labels of a drawing.
//!
//! Each label lies inside the picture and near its anchor, the point that it names. It covers no other
//! label, no handle, no tip of an arrow, and as few lines as possible. A label far from its anchor gets a
//! leader line; one for which there is no room is left out. The more important labels are placed first.

use egui::Color32;
use pinhole_core::DVec2;

use crate::overlay::{Drawing, Label, LabelFont, LineStyle, Mark, Shape, dot, wide};
use crate::{Concept, Item};

/// A label to be placed.
#[derive(Clone, Debug)]
pub(crate) struct Request {
    /// The label, whose position is not yet set.
    pub(crate) label: Label,
    pub(crate) concept: Option<Concept>,
    /// The point that the label names, in screen pixels.
    pub(crate) anchor: DVec2,
    /// The preferred direction from the anchor to the label, of any length; zero if there is no preference.
    pub(crate) toward: DVec2,
    /// Labels of lower rank are placed first.
    pub(crate) rank: u8,
    /// True if the label's middle must be at the anchor.
    pub(crate) is_fixed: bool,
}

impl Request {
    /// Creates the request for a label. Its overlay item, its concept and its colour are those of the line
    /// style.
    pub(crate) fn new(
        pen: LineStyle,
        text: String,
        [anchor, toward]: [DVec2; 2],
        (size, bold): LabelFont,
        halo: Color32,
    ) -> Request {
        let LineStyle { item, color, .. } = pen;
        let label = Label { item, position: [0.0; 2], text, color, halo, size, bold };
        let rank = rank(pen.item);
        Request { label, concept: pen.concept, anchor, toward, rank, is_fixed: false }
    }
}

/// Returns the rank of an item's label; labels of lower rank are placed first. The names of the camera's
/// parts precede those of the ray, of a point's u and v, of the world's axes and of the marks.
fn rank(item: Item) -> u8 {
    match item {
        Item::Handles => 1,
        Item::Eye | Item::Basis | Item::U | Item::W => 2,
        Item::ViewAndUp | Item::At => 3,
        Item::Ray | Item::Hit | Item::SphereFigure => 4,
        Item::Axes | Item::UvLegs => 6,
        Item::Marks => 7,
        _ => 5,
    }
}

/// Minimum distance from the anchor (the point that a label names) to the edge of the label, in points.
const GAP: f64 = 7.0;

/// Number of directions tried around the anchor.
const DIRECTIONS: usize = 16;
/// Number of distances tried in each direction, and the step from one to the next, in points.
const RINGS: usize = 16;
const RING_STEP: f64 = 9.0;

/// Distance from the anchor (the point that a label names) to the edge of the label, in points, above which
/// the label gets a leader line.
const LEADER_FROM: f64 = 20.0;

/// Distance between the sample points along a line, in points.
const OBSTACLE_SPACING: f64 = 5.0;

/// A rectangle: its centre, and half of its width and height.
type CenteredBox = (DVec2, DVec2);

/// Places the requested labels in order of rank, so that the first ones get the best positions. Adds
/// the labels and their leader lines to the drawing, and omits labels that fit nowhere near their
/// anchors. No label is placed on a handle, on the tip of an arrow, or in a `covered` rectangle (left, top,
/// right and bottom).
pub(crate) fn place_labels(
    mut requests: Vec<Request>,
    drawing: &mut Drawing,
    size: DVec2,
    covered: &[[f32; 4]],
) {
    requests.sort_by_key(|request| request.rank);
    let scale = drawing.scale;
    let obstacles = obstacles(drawing);
    let line_ends = line_ends(drawing);
    let mut taken = handle_areas(drawing);
    taken.extend(tips(drawing));
    taken.extend(covered.iter().map(|[left, top, right, bottom]| {
        let (least, most) = (wide([*left, *top]), wide([*right, *bottom]));
        (0.5 * (least + most), 0.5 * (most - least))
    }));
    for mut request in requests {
        let half = wide(request.label.half_extent(scale));
        let free = |center: DVec2| {
            let margin = half + 1.0;
            let is_inside =
                center.cmpge(margin).all() && center.cmple((size - margin).max(margin)).all();
            is_inside
                && taken.iter().all(|(at, h)| (center - *at).abs().cmpgt(half + *h).any())
                && leader(&request, center, half, scale).is_none_or(|ends| {
                    !prolongs(ends, request.anchor, &line_ends)
                        && taken.iter().all(|area| !crosses(ends, *area))
                })
        };
        let center = if request.is_fixed {
            Some(request.anchor).filter(|at| free(*at))
        } else {
            best_position(&request, half, f64::from(scale), &obstacles, &free)
        };
        let Some(center) = center else { continue };
        if let Some(ends) = leader(&request, center, half, scale) {
            let shape = Shape::Line { points: ends.map(dot).to_vec(), width: scale };
            let pen = LineStyle::new(request.label.item, request.label.color, 1.0);
            drawing.marks.push(pen.mark(shape, request.label.halo));
        }
        taken.push((center, half));
        request.label.position = dot(center);
        drawing.labels.push(request.label);
    }
}

/// Returns the leader line from an anchor to its label; `None` if they are close together.
fn leader(request: &Request, center: DVec2, half: DVec2, scale: f32) -> Option<[DVec2; 2]> {
    let end = request.anchor.clamp(center - half, center + half);
    let from = request.anchor.move_towards(end, 0.5 * GAP * f64::from(scale));
    (end.distance(request.anchor) > LEADER_FROM * f64::from(scale)).then_some([from, end])
}

/// Returns true if a line segment passes through an area without starting in it.
fn crosses([from, to]: [DVec2; 2], (center, half): CenteredBox) -> bool {
    const SAMPLES: usize = 16;
    let is_in = |at: DVec2| (at - center).abs().cmplt(half).all();
    !is_in(from) && (1..=SAMPLES).any(|k| is_in(from.lerp(to, k as f64 / SAMPLES as f64)))
}

/// Returns the ends of all lines, each with the line's direction there.
fn line_ends(drawing: &Drawing) -> Vec<(DVec2, DVec2)> {
    let chains = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Line { points, .. } if points.len() > 1 => Some(points),
        _ => None,
    });
    let ends = |points: &Vec<[f32; 2]>| {
        let last = points.len() - 1;
        [[0, 1], [last, last - 1]].map(|[end, next]| {
            let end = wide(points[end]);
            (end, (end - wide(points[next])).normalize_or_zero())
        })
    };
    chains.flat_map(ends).collect()
}

/// Returns true if a leader line would seem to prolong a line that ends at its anchor.
fn prolongs([from, to]: [DVec2; 2], anchor: DVec2, line_ends: &[(DVec2, DVec2)]) -> bool {
    const NEAR: f64 = 2.0;
    const STRAIGHT: f64 = 0.95;
    let direction = (to - from).normalize_or_zero();
    let is_straight = |along: DVec2| along.dot(direction) > STRAIGHT;
    line_ends.iter().any(|(end, along)| end.distance(anchor) < NEAR && is_straight(*along))
}

/// Returns the areas covered by handles.
fn handle_areas(drawing: &Drawing) -> Vec<CenteredBox> {
    let marks = drawing.marks.iter().filter(|mark| mark.item == Item::Handles);
    let areas = marks.filter_map(|mark| match &mark.shape {
        Shape::Disc { center, radius } => Some((wide(*center), DVec2::splat((*radius).into()))),
        Shape::Polygon { points } => {
            let points = || points.iter().copied().map(wide);
            let (least, most) = (points().reduce(DVec2::min)?, points().reduce(DVec2::max)?);
            Some((0.5 * (least + most), 0.5 * (most - least)))
        }
        // A line here is the ring around a held handle, which labels may cover.
        Shape::Line { .. } => None,
    });
    areas.collect()
}

/// Half of the side of the square around an arrow's tip that labels keep free, in points.
const TIP: f64 = 2.0;

/// Returns the areas around the tips of arrowheads.
fn tips(drawing: &Drawing) -> impl Iterator<Item = CenteredBox> {
    let half = DVec2::splat(TIP * f64::from(drawing.scale));
    let tip = |mark: &Mark| match &mark.shape {
        Shape::Polygon { points } if points.len() == 3 => Some(wide(points[0])),
        // An open head has its tip in the middle.
        Shape::Line { points, .. } if points.len() == 3 => Some(wide(points[1])),
        // The head of a hidden arrow is an outline.
        Shape::Line { points, .. } if points.len() == 4 => Some(wide(points[0])),
        _ => None,
    };
    drawing.marks.iter().filter_map(tip).map(move |tip| (tip, half))
}

fn best_position(
    request: &Request,
    half: DVec2,
    scale: f64,
    obstacles: &[DVec2],
    free: &dyn Fn(DVec2) -> bool,
) -> Option<DVec2> {
    let wish = request.toward.try_normalize();
    let step = RING_STEP * scale;
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

/// Returns the points that labels should not cover: samples along all lines, and the centres of all discs.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leader_does_not_prolong_the_line_whose_end_it_names() {
        let pen = LineStyle::new(Item::SphereFigure, Color32::BLACK, 2.0);
        let line = vec![[200.0, 300.0], [200.0, 200.0]];
        let mark = pen.mark(Shape::Line { points: line, width: 2.0 }, Color32::WHITE);
        let mut drawing = Drawing { scale: 1.0, marks: vec![mark], ..Drawing::default() };
        let end = DVec2::splat(200.0);
        let to = [end, -DVec2::Y];
        let request = Request::new(pen, "foot".to_owned(), to, (14.0, false), Color32::WHITE);
        // There is no room near the end of the line.
        let covered = [[150.0, 150.0, 250.0, 250.0]];
        place_labels(vec![request], &mut drawing, DVec2::splat(400.0), &covered);
        let [_, Mark { shape: Shape::Line { points, .. }, .. }] = &drawing.marks[..] else {
            panic!("no leader: {drawing:?}")
        };
        let along = (wide(points[1]) - wide(points[0])).normalize();
        assert!(along.y > -0.95, "{along}");
    }
}
