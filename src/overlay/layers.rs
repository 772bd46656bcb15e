//! What the observer sees besides the traced spheres, dot by dot: the background, the planes'
//! patches, and the viewport with the picture on it. Near ones cover far ones, and spheres cover
//! and are covered as their t says.

use egui::Color32;
use pinhole_core::{DVec2, Frame, ImageSize, NO_OBJECT};
use rayon::prelude::*;

use crate::overlay::flat::{Extent, Flat, FlatSpot, Grid};
use crate::overlay::picture::{Nearest, Picture};

/// Everything flat in one world view, and the t-buffer that it is compared with.
pub(crate) struct Layers<'a> {
    frame: &'a Frame,
    width: usize,
    height: usize,
    pub(crate) background: Color32,
    pub(crate) viewport: Option<ViewportLayer<'a>>,
    pub(crate) patches: Vec<Patch>,
}

/// The viewport's rectangle: the picture, and the edges between its pixels.
pub(crate) struct ViewportLayer<'a> {
    /// (a, b) is (u / width, v / height).
    pub(crate) flat: Flat,
    pub(crate) image: ImageSize,
    pub(crate) picture: Option<PictureLookup<'a>>,
    /// The edges between pixels that are drawn, and how opaque they are, 0 to 1.
    pub(crate) grid: Option<(Grid, f32)>,
}

/// A picture with the nearest traced pixel of each pixel looked up beforehand.
pub(crate) struct PictureLookup<'a> {
    picture: &'a Picture,
    rows: Nearest,
    columns: Nearest,
}

/// The part of an infinite plane near what the observer looks at, fading outwards, with grid lines
/// in world units.
pub(crate) struct Patch {
    /// (a, b) are world units from the patch's centre.
    pub(crate) flat: Flat,
    pub(crate) radius: f64,
    pub(crate) color: Color32,
    pub(crate) grid_color: Color32,
    /// In its middle, 0 to 1.
    pub(crate) opacity: f32,
    pub(crate) grid: Grid,
}

/// How much nearer something must be to hide a point: the points of a surface must not hide
/// themselves.
const TOLERANCE: f64 = 1e-3;

/// Through a patch that is more transparent than this, lines are seen as if it were not there.
const SEEN_THROUGH: f32 = 0.25;

impl<'a> PictureLookup<'a> {
    /// `None` for a picture that is not whole, or of another image.
    pub(crate) fn new(picture: &'a Picture, image: ImageSize) -> Option<Self> {
        if !picture.is_whole() || picture.image != image {
            return None;
        }
        let (rows, columns) = picture.nearest();
        Some(PictureLookup { picture, rows, columns })
    }

    fn color(&self, row: usize, column: usize) -> Color32 {
        let width = self.picture.raster.columns().len();
        self.picture.pixels[self.rows.of(row) * width + self.columns.of(column)]
    }
}

impl ViewportLayer<'_> {
    /// Where on the rectangle the dot's ray passes; `None` beside it.
    pub(crate) fn spot(&self, dot: DVec2) -> Option<FlatSpot> {
        self.flat.at(dot, Extent::Square(0.5))
    }

    fn paint(&self, spot: &FlatSpot, below: Color32) -> Color32 {
        let (w, h) = (self.image.width(), self.image.height());
        let cell = |x: f64, count: u32| ((x * f64::from(count)) as usize).min(count as usize - 1);
        let base = match &self.picture {
            Some(picture) => {
                picture.color(cell(0.5 - spot.place.y, h), cell(spot.place.x + 0.5, w))
            }
            None => below,
        };
        let Some((grid, opacity)) = &self.grid else { return base };
        let covered = self.flat.grid_coverage(spot, grid) as f32;
        mix(base, contrast(base), covered * opacity)
    }
}

impl Patch {
    fn spot(&self, dot: DVec2) -> Option<FlatSpot> {
        self.flat.at(dot, Extent::Disc(self.radius))
    }

    /// How opaque the patch is at a spot: it fades to nothing at its rim.
    fn opacity_at(&self, spot: &FlatSpot) -> f32 {
        let inward = 1.0 - spot.place.length_squared() / (self.radius * self.radius);
        let s = (1.3 * inward).clamp(0.0, 1.0) as f32;
        self.opacity * s * s * (3.0 - 2.0 * s)
    }

    fn paint(&self, spot: &FlatSpot, below: Color32) -> Color32 {
        let opacity = self.opacity_at(spot);
        let line = self.flat.grid_coverage(spot, &self.grid) as f32;
        let base = mix(below, self.color, opacity);
        mix(base, self.grid_color, line * opacity)
    }
}

impl<'a> Layers<'a> {
    /// `frame` is the observer's, with every pixel traced.
    pub(crate) fn new(frame: &'a Frame, background: Color32) -> Self {
        let image = frame.camera().image();
        Layers {
            frame,
            width: image.width() as usize,
            height: image.height() as usize,
            background,
            viewport: None,
            patches: Vec::new(),
        }
    }

    /// Whether the frame has a t for every dot.
    fn is_traced(&self) -> bool {
        self.frame.t.len() == self.width * self.height
            && self.frame.object.len() == self.frame.t.len()
    }

    /// t of the traced object at a dot; infinite beside the picture.
    pub(crate) fn traced_t(&self, dot: DVec2) -> f64 {
        let inside =
            dot.cmpge(DVec2::ZERO).all() && dot.x < self.width as f64 && dot.y < self.height as f64;
        if !(inside && self.is_traced()) {
            return f64::INFINITY;
        }
        self.frame.t[dot.y as usize * self.width + dot.x as usize]
    }

    /// Whether something hides a point at `t` from the observer. Lines drawn on the viewport are
    /// not hidden by it.
    pub(crate) fn hides(&self, dot: DVec2, t: f64, on_viewport: bool) -> bool {
        let covers = |nearer: f64| nearer * (1.0 + TOLERANCE) < t;
        if covers(self.traced_t(dot)) {
            return true;
        }
        let picture = self.viewport.as_ref().filter(|v| !on_viewport && v.picture.is_some());
        if picture.and_then(|layer| layer.spot(dot)).is_some_and(|spot| covers(spot.t)) {
            return true;
        }
        self.patches.iter().any(|patch| {
            patch
                .spot(dot)
                .is_some_and(|spot| covers(spot.t) && patch.opacity_at(&spot) > SEEN_THROUGH)
        })
    }

    /// Paints all layers over the traced picture.
    pub(crate) fn paint(&self, dots: &mut [Color32]) {
        if !self.is_traced() || dots.len() != self.frame.t.len() {
            return;
        }
        dots.par_chunks_exact_mut(self.width).with_min_len(8).enumerate().for_each(
            |(row, dots)| {
                let start = row * self.width;
                let (t, object) = (&self.frame.t[start..], &self.frame.object[start..]);
                let mut found = Vec::with_capacity(self.patches.len() + 1);
                for (column, dot) in dots.iter_mut().enumerate() {
                    if object[column] == NO_OBJECT {
                        *dot = self.background;
                    }
                    let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                    *dot = self.over(at, t[column] * (1.0 + 1e-6), *dot, &mut found);
                }
            },
        );
    }

    /// The colour of one dot under all layers nearer than `t`. `found` is scratch space.
    fn over(
        &self,
        at: DVec2,
        t: f64,
        mut color: Color32,
        found: &mut Vec<(FlatSpot, Option<usize>)>,
    ) -> Color32 {
        found.clear();
        let viewport = self.viewport.as_ref();
        found.extend(viewport.and_then(|v| v.spot(at)).map(|spot| (spot, None)));
        for (index, patch) in self.patches.iter().enumerate() {
            found.extend(patch.spot(at).map(|spot| (spot, Some(index))));
        }
        found.retain(|(spot, _)| spot.t <= t);
        if found.len() > 1 {
            found.sort_by(|a, b| b.0.t.total_cmp(&a.0.t));
        }
        for (spot, of) in found.iter() {
            color = match (of, viewport) {
                (Some(index), _) => self.patches[*index].paint(spot, color),
                (None, Some(viewport)) => viewport.paint(spot, color),
                (None, None) => color,
            };
        }
        color
    }
}

/// `share` of `top` over `bottom`, both opaque.
pub(crate) fn mix(bottom: Color32, top: Color32, share: f32) -> Color32 {
    if share <= 0.0 {
        return bottom;
    }
    let weight = (share.min(1.0) * 256.0) as u32;
    let channel =
        |b: u8, t: u8| ((u32::from(b) * (256 - weight) + u32::from(t) * weight) >> 8) as u8;
    Color32::from_rgb(
        channel(bottom.r(), top.r()),
        channel(bottom.g(), top.g()),
        channel(bottom.b(), top.b()),
    )
}

/// Black on a light colour, white on a dark one (luma of ITU-R BT.601).
pub(crate) fn contrast(color: Color32) -> Color32 {
    let luma = 299 * u32::from(color.r()) + 587 * u32::from(color.g()) + 114 * u32::from(color.b());
    if luma > 110_000 { Color32::BLACK } else { Color32::WHITE }
}
