//! Label placement. Each label is put inside the picture, beside its anchor, over no other label
//! and no handle, and over as few lines as possible.

use std::borrow::Cow;

use egui::Color32;
use pinhole_core::DVec2;

use crate::model::concept::Concept;
use crate::model::overlay_items::Item;
use crate::view::overlay::drawing::{Drawing, Label, Shape, dot};

/// A label to be placed.
#[derive(Clone, Debug)]
pub(crate) struct Request {
    pub(crate) item: Item,
    pub(crate) text: Cow<'static, str>,
    pub(crate) concept: Option<Concept>,
    /// The point it names, in dots.
    pub(crate) anchor: DVec2,
    /// The preferred direction from the anchor; of any length, zero for no preference.
    pub(crate) toward: DVec2,
    pub(crate) color: Color32,
    /// Font size in points.
    pub(crate) size: f32,
    pub(crate) bold: bool,
}

/// Distance from the anchor to the edge of the label, in points.
const GAP: f64 = 7.0;

/// Number of directions tried around the anchor, and of distances in each.
const DIRECTIONS: usize = 16;
const RINGS: usize = 6;

/// Distance, in points, between the sampled points of a line.
const OBSTACLE_SPACING: f64 = 5.0;

/// A rectangle: its centre, and half of its width and height.
type Area = (DVec2, DVec2);

/// Places the requests in order, so that the first ones get the best places. A label that fits
/// nowhere near its anchor is left out; one that fits only over a handle is put there.
pub(crate) fn place(
    requests: &[Request],
    drawing: &Drawing,
    size: DVec2,
    halo: Color32,
) -> Vec<Label> {
    let scale = drawing.scale;
    let obstacles = obstacles(drawing);
    let handles = handles(drawing);
    let mut labels: Vec<Label> = Vec::with_capacity(requests.len());
    for request in requests {
        let mut label = Label {
            item: request.item,
            position: [0.0, 0.0],
            text: request.text.clone().into_owned(),
            color: request.color,
            halo,
            size: request.size,
            bold: request.bold,
        };
        let half = half_extent(&label, scale);
        let taken: Vec<Area> = labels
            .iter()
            .map(|l| {
                (DVec2::new(l.position[0].into(), l.position[1].into()), half_extent(l, scale))
            })
            .collect();
        let free = |center: DVec2| {
            let margin = half + 1.0;
            center.cmpge(margin).all()
                && center.cmple(size - margin).all()
                && are_apart(&taken, center, half)
        };
        let find = |free: &dyn Fn(DVec2) -> bool| {
            best_place(request, half, f64::from(scale), &obstacles, free)
        };
        let beside_handles = |center| free(center) && are_apart(&handles, center, half);
        if let Some(center) = find(&beside_handles).or_else(|| find(&free)) {
            label.position = dot(center);
            labels.push(label);
        }
    }
    labels
}

/// Returns true if a rectangle overlaps none of the areas.
fn are_apart(areas: &[Area], center: DVec2, half: DVec2) -> bool {
    areas.iter().all(|(other, h)| (center - *other).abs().cmpgt(half + *h).any())
}

/// Returns the areas that handles cover.
fn handles(drawing: &Drawing) -> Vec<Area> {
    let wide = |[x, y]: [f32; 2]| DVec2::new(x.into(), y.into());
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
    let [x, y] = label.half_extent(scale);
    DVec2::new(x.into(), y.into())
}

fn best_place(
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
                    let [a, b] = [pair[0], pair[1]].map(|[x, y]| DVec2::new(x.into(), y.into()));
                    let count = ((b - a).length() / spacing).ceil().clamp(1.0, 4096.0);
                    points.extend((0..=count as usize).map(|k| a.lerp(b, k as f64 / count)));
                }
            }
            Shape::Disc { center: [x, y], .. } => {
                points.push(DVec2::new((*x).into(), (*y).into()));
            }
        }
    }
    points
}
