//! The edges of spheres in vector formats: curves, as their outlines are known exactly. A sphere's picture, with
//! its exact shading, is clipped by its outline.

use egui::{Color32, ColorImage};
use pinhole_core::Ellipse;

/// Distance from an outline, in pixels, up to which its smoothed edge may mix the colours of both sides.
const EDGE: f64 = 0.75;
/// Distance from which the colours of pixels at the edge are taken instead.
const PURE: f64 = 1.5;
/// Distance up to which the colours of either side continue on the other one, where viewers mix them.
const REACH: f64 = 4.0;

/// Spheres in the world view of a figure.
#[derive(Debug, Default)]
pub(super) struct SphereEdges {
    /// Their outlines, in dots of the figure.
    pub(super) outlines: Vec<Ellipse>,
    /// The picture that is clipped by the outlines, transparent far from them; `None` if the figure's picture
    /// shows the spheres.
    pub(super) picture: Option<ColorImage>,
}

impl SphereEdges {
    /// Moves the spheres out of the picture of a figure with this size in dots. So far, the outlines are in
    /// pixels of the picture.
    pub(super) fn cut_out_of(&mut self, picture: &mut ColorImage, dots: [u32; 2]) {
        let size = picture.size;
        let whole = picture.pixels.clone();
        let mut spheres = ColorImage::filled(size, Color32::TRANSPARENT);
        for outline in &mut self.outlines {
            for (pixel, at) in outline.pixels(size, REACH) {
                let (distance, outwards) = outline.distance(at);
                // The colour at another distance from the outline.
                let color = |wanted: f64| {
                    let [x, y] = (at + (wanted - distance) * outwards).to_array();
                    let index = |x: f64, count: usize| (x.max(0.0) as usize).min(count - 1);
                    whole[index(y, size[1]) * size[0] + index(x, size[0])]
                };
                if distance.abs() < EDGE || (-REACH..0.0).contains(&distance) {
                    picture.pixels[pixel] = color(PURE);
                }
                if (-EDGE..REACH).contains(&distance) {
                    spheres.pixels[pixel] = color(-PURE);
                }
            }
            let scale = f64::from(dots[0]) / size[0] as f64;
            outline.center *= scale;
            outline.axes = outline.axes.map(|axis| axis * scale);
        }
        // Last, so that the colour beyond one sphere's edge covers nothing of its neighbour.
        for outline in &self.outlines {
            for (pixel, at) in outline.pixels(size, 0.0) {
                if outline.distance(at).0 < -EDGE {
                    spheres.pixels[pixel] = whole[pixel];
                }
            }
        }
        self.picture = Some(spheres).filter(|_| !self.outlines.is_empty());
    }
}
