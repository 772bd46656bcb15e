//! The texts that a frame paints.

use std::sync::Arc;

use egui::epaint::{Shape, TextShape};
use egui::{Color32, Pos2, Rect};
use egui_kittest::Harness;
use pinhole::ui::app::App;

/// A run of letters of one colour.
pub(crate) struct Run {
    pub(crate) text: String,
    /// The size in points before zoom.
    pub(crate) size: f32,
    pub(crate) color: Color32,
    /// The colour of its halo or of the fills below it; `None` on a picture.
    pub(crate) ground: Option<Color32>,
    /// The rows of the text that it is a part of.
    pub(crate) rows: Vec<Rect>,
}

/// Returns a colour painted over another.
pub(crate) fn over(below: Color32, above: Color32) -> Color32 {
    let keep = 1.0 - f32::from(above.a()) / 255.0;
    let [r, g, b] = [0, 1, 2].map(|k| {
        (f32::from(above.to_array()[k]) + keep * f32::from(below.to_array()[k])).round() as u8
    });
    Color32::from_rgb(r, g, b)
}

/// The texts of a frame, and what was filled below them so far; `None` is a picture.
struct Texts {
    fills: Vec<(Rect, Option<Color32>)>,
    runs: Vec<Run>,
}

/// Every text that is painted.
pub(crate) fn texts(window: &Harness<'_, App>) -> Vec<Run> {
    let ground = window.ctx.global_style().visuals.panel_fill;
    let mut texts = Texts { fills: vec![(Rect::EVERYTHING, Some(ground))], runs: Vec::new() };
    for clipped in &window.output().shapes {
        texts.add(&clipped.shape, clipped.clip_rect);
    }
    assert!(!texts.runs.is_empty(), "no text is painted");
    texts.runs
}

impl Texts {
    fn add(&mut self, shape: &Shape, clip: Rect) {
        match shape {
            Shape::Vec(shapes) => match shapes.as_slice() {
                [Shape::Text(halo), .., Shape::Text(text)]
                    if Arc::ptr_eq(&halo.galley, &text.galley) =>
                {
                    self.add_text(text, clip, halo.override_text_color);
                }
                shapes => shapes.iter().for_each(|shape| self.add(shape, clip)),
            },
            Shape::Rect(rect) if rect.fill.a() > 0 => {
                let fill = rect.brush.is_none().then_some(rect.fill);
                self.fills.push((rect.rect.intersect(clip), fill));
            }
            Shape::Mesh(mesh) => self.fills.push((mesh.calc_bounds().intersect(clip), None)),
            Shape::Text(text) => {
                let ground = self.ground(text.visual_bounding_rect().center());
                self.add_text(text, clip, ground);
            }
            _ => {}
        }
    }

    fn ground(&self, at: Pos2) -> Option<Color32> {
        let below = self.fills.iter().filter(|(rect, _)| rect.contains(at));
        below.fold(None, |ground, (_, fill)| match (*fill, ground) {
            (Some(fill), _) if fill.is_opaque() => Some(fill),
            (Some(fill), Some(ground)) => Some(over(ground, fill)),
            _ => None,
        })
    }

    fn add_text(&mut self, shape: &TextShape, clip: Rect, ground: Option<Color32>) {
        if !clip.intersects(shape.visual_bounding_rect()) {
            return;
        }
        let job = &shape.galley.job;
        let rows = shape.galley.rows.iter().map(|row| row.rect().translate(shape.pos.to_vec2()));
        let rows: Vec<Rect> = rows.collect();
        for section in &job.sections {
            let range = &section.byte_range;
            let text = job.text[range.start.0..range.end.0].to_owned();
            let own = section.format.color;
            let own = if own == Color32::PLACEHOLDER { shape.fallback_color } else { own };
            let color = shape.override_text_color.unwrap_or(own);
            let color = color.gamma_multiply(shape.opacity_factor);
            if !text.trim().is_empty() && color.a() > 0 {
                let (size, rows) = (section.format.font_id.size, rows.clone());
                self.runs.push(Run { text, size, color, ground, rows });
            }
        }
    }
}
