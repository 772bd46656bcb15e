//! Texts are large, and texts and marks stand out from the ground that they stand on.

use std::collections::BTreeMap;

use egui::{Color32, ColorImage, Pos2, Theme};
use pinhole_figure::overlay::{self, Style, contrast_ratio};
use pinhole_figure::typesetting::theme::WRITTEN;
use pinhole_figure::{Item, Scheme};

use super::Seen;
use crate::app::painted_texts::{Run, over, texts};

/// The least contrast of a text, and of a mark (WCAG 2.2, *Contrast (Minimum)* and *Non-text Contrast*).
const LEAST: [f64; 2] = [4.5, 3.0];

/// The texts that are smaller than 28 pixels at 1920 x 1080: than the size that the zoom makes so large.
pub(super) fn small_texts(seen: &Seen<'_>) -> Vec<String> {
    let is_1080p = seen.window.ctx.content_rect().width() > 800.0;
    let small = texts(seen.window).into_iter().filter(|run| is_1080p && run.size < WRITTEN);
    small.map(|run| format!("“{}” has {}", run.text, run.size)).collect()
}

/// The least contrast of the text of the lit line, which is large: of that, WCAG demands 3.
const LEAST_LIT: f64 = 4.0;

/// The texts that have too little contrast, or have no halo on a picture.
pub(super) fn faint_texts(seen: &Seen<'_>) -> Vec<String> {
    texts_fainter_than(LEAST[0], seen)
}

/// The same while a line of the card is lit.
pub(super) fn faint_lit_texts(seen: &Seen<'_>) -> Vec<String> {
    texts_fainter_than(LEAST_LIT, seen)
}

fn texts_fainter_than(least: f64, seen: &Seen<'_>) -> Vec<String> {
    let faint = |Run { text, color, ground, .. }: Run| {
        let Some(ground) = ground else { return Some(format!("“{text}” on a picture")) };
        let ratio = contrast_ratio(over(ground, color), ground);
        (ratio < least).then(|| format!("“{text}”: {ratio:.2}, {color:?} on {ground:?}"))
    };
    texts(seen.window).into_iter().filter_map(faint).collect()
}

/// The colours of the picture on both sides of a line, along it.
fn beside(image: &ColorImage, points: &[[f32; 2]], width: f32) -> Vec<[Option<Color32>; 2]> {
    let color = |at: Pos2| {
        let [column, row] = [at.x, at.y].map(|x| x as usize);
        let is_inside =
            at.x >= 0.0 && at.y >= 0.0 && column < image.width() && row < image.height();
        is_inside.then(|| image[(column, row)])
    };
    let mut found = Vec::new();
    for ends in points.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(Pos2::from);
        let side = (0.5 * width + 2.5) * (to - from).normalized().rot90();
        let count = ((to - from).length() / 6.0).ceil();
        let all = (0..count as u32).map(|k| from.lerp(to, (k as f32 + 0.5) / count));
        found.extend(all.map(|at| [color(at + side), color(at - side)]));
    }
    found
}

/// The marks that have too little contrast with their casing or, without one, with both sides for more than
/// a third of their length. What is translucent, and the edges of panes, are the ground on which marks
/// stand; what has the background's colour is a casing or a hole.
pub(super) fn faint_marks(seen: &Seen<'_>) -> Vec<String> {
    let is_dark = seen.window.ctx.theme() == Theme::Dark;
    let background = Style::new(Scheme::Standard, is_dark).colors().background;
    let derived = seen.app().derived();
    let views = [("World view", &derived.world_view), ("Camera view", &derived.camera_view)];
    let mut lengths: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    for (view, shown) in views {
        let Some(shown) = shown.as_ref().filter(|_| seen.rect(view).is_some()) else { continue };
        let is_ground = |mark: &overlay::Mark| {
            !mark.color.is_opaque() || mark.color == background || mark.item == Item::Planes
        };
        for mark in shown.marks.iter().filter(|mark| !is_ground(mark)) {
            let is_faint = |ground: &Color32| contrast_ratio(mark.color, *ground) < LEAST[1];
            let [faint, all] = match (&mark.shape, mark.halo) {
                (_, Some(halo)) => [usize::from(is_faint(&halo)), 1],
                (overlay::Shape::Line { points, width }, None) => {
                    let sides = beside(&shown.image, points, *width);
                    let faint = sides.iter().filter(|both| both.iter().flatten().all(is_faint));
                    [faint.count(), sides.len()]
                }
                _ => continue,
            };
            let name = format!("{view}: {:?} {:?} {:?}", mark.item, mark.concept, mark.color);
            let sum = lengths.entry(name).or_default();
            *sum = [sum[0] + faint, sum[1] + all];
        }
    }
    let faint = lengths.into_iter().filter(|(_, [faint, all])| 3 * faint > *all);
    faint.map(|(name, [faint, all])| format!("{name}: {faint} of {all}")).collect()
}
