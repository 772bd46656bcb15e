//! Flat layers of the world view, painted pixel by pixel over the traced picture: the background, the panes
//! that stand for planes, the floor's grid, and the viewport with the camera's picture on it. Nearer layers
//! cover farther ones. Whether a sphere covers a layer is decided by comparing t.

use std::ops::Range;

use egui::Color32;
use pinhole_core::{
    DVec2, EdgeBlend, Frame, ImageSize, NO_OBJECT, PixelRays, Rgb, Sphere, lambert,
};
use rayon::prelude::*;

use crate::overlay::{Flat, FlatRow, FlatSpot, Grid, StretchedPicture, opaque};

/// The layers between the observer's traced picture and the camera: the spheres around the camera, which
/// are cut away, the panes that stand for planes, and the floor. They seldom change while only the camera
/// moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Backdrop {
    pub(crate) background: Color32,
    pub(crate) patches: Vec<PlanePatch>,
    /// The floor's grid, of which only the lines are painted.
    pub(crate) floor: Option<PlanePatch>,
    pub(crate) bowls: Vec<Bowl>,
}

impl Backdrop {
    /// Paints the layers over the observer's traced and shaded picture, and smooths the borders of its
    /// objects.
    pub fn paint(&self, frame: &Frame<f32>, edges: &[EdgeBlend], dots: &mut [Color32]) {
        let layers = Layers::new(frame, self);
        let bands = dots.par_chunks_mut(BAND * layers.width.max(1)).enumerate();
        bands.for_each(|(band, dots)| {
            layers.paint_parts(band * BAND, dots, |_| 0..layers.width, |_, _, _| ());
        });
        if layers.is_traced() && dots.len() == frame.t.len() {
            smooth(edges.iter(), dots);
        }
    }
}

/// All flat layers of a world view, and the traced frame, whose t decides what hides them.
pub(crate) struct Layers<'a> {
    frame: &'a Frame<f32>,
    width: usize,
    height: usize,
    backdrop: &'a Backdrop,
    pub(crate) viewport: Option<ViewportLayer<'a>>,
}

/// A sphere around the camera, cut away so that the camera is visible: only the far side of its surface is
/// painted, where the observer's rays leave the sphere.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bowl {
    pub(crate) sphere: Sphere,
    pub(crate) color: Rgb,
    /// The observer's rays.
    pub(crate) rays: PixelRays,
}

/// Opacity of a bowl.
const BOWL: f32 = 0.45;

impl Bowl {
    /// Returns the colour of a screen pixel at (x, y) after the bowl is painted over the colour `below`.
    /// `traced_t` is the t of the traced object there.
    fn paint(&self, [x, y]: [f64; 2], traced_t: f32, below: Color32) -> Color32 {
        let PixelRays { eye, across, down, corner } = self.rays;
        let (q, radius) = (eye - self.sphere.center, self.sphere.radius);
        let direction = x * across + y * down + corner;
        // q, the vector from the centre to the eye, is in units of the radius, so that its square does not
        // overflow.
        let (q, length) = (q / radius, direction.length());
        let along = q.dot(direction) / length;
        let discriminant = along * along - (q.length_squared() - 1.0);
        let far = discriminant.sqrt() - along;
        let t = far * radius / length;
        if !(t > 0.0 && t < f64::from(traced_t)) {
            return below;
        }
        let cosine = (q + far / length * direction).dot(direction).abs() / length;
        mix(below, opaque(lambert(self.color, cosine.min(1.0))), BOWL)
    }
}

/// The viewport's rectangle: the picture, and the edges between its pixels.
pub(crate) struct ViewportLayer<'a> {
    /// The viewport's rectangle, with the coordinates a = u / width and b = v / height.
    pub(crate) flat: Flat,
    pub(crate) image: ImageSize,
    /// The camera's picture, with one colour for each pixel of the image.
    pub(crate) picture: Option<StretchedPicture<'a>>,
    /// The edges between the image's pixels as grid lines, and their opacity from 0 to 1.
    pub(crate) grid: Option<(Grid, f32)>,
    /// The colour behind transparent pixels.
    pub(crate) behind: Color32,
}

/// The pane that stands for an infinite plane: a rectangle with grid lines in world units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlanePatch {
    /// The plane; its coordinates (a, b) go from -0.5 to 0.5 across the rectangle.
    pub(crate) flat: Flat,
    pub(crate) color: Color32,
    pub(crate) grid_color: Color32,
    /// Opacity, 0 to 1.
    pub(crate) opacity: f32,
    pub(crate) grid: Grid,
}

/// Relative margin by which an object must be nearer than a point to hide it. Without it, a surface would
/// hide its own points.
const TOLERANCE: f64 = 1e-3;

/// Relative margin by which a layer may lie behind the traced object and still be painted. Layers do not
/// touch the traced surfaces, so it only has to cover the rounding of `f32`.
const PAINT_TOLERANCE: f32 = 1e-6;

/// Value of |a| and |b| at the edges of the viewport and of a pane.
const HALF: f64 = 0.5;

/// Number of rows of screen pixels that are painted at a time.
pub(crate) const BAND: usize = 32;

/// Opacity of a pane up to which it does not hide lines behind it.
const SEEN_THROUGH: f32 = 0.25;

impl ViewportLayer<'_> {
    /// Returns the point where the ray through a screen position passes through the viewport's rectangle;
    /// `None` if it passes outside.
    pub(crate) fn spot(&self, dot: DVec2) -> Option<FlatSpot> {
        self.flat.at(dot, HALF)
    }

    /// Returns the colour of a screen pixel at (a, b) after the layer is painted over the colour `below`.
    /// `line` is the fraction of the pixel that grid lines cover.
    #[inline(always)]
    fn paint(&self, [a, b, line]: [f32; 3], below: Color32) -> Color32 {
        let (w, h) = (self.image.width(), self.image.height());
        let cell = |x: f32, count: u32| ((x * count as f32) as usize).min(count as usize - 1);
        let base = match &self.picture {
            Some(picture) => picture.color(cell(0.5 - b, h), cell(a + 0.5, w)),
            None => below,
        };
        match self.grid {
            Some((_, opacity)) => mix(base, opposing_grey(base, self.behind), line * opacity),
            None => base,
        }
    }
}

impl PlanePatch {
    /// Returns the colour of a screen pixel after the layer is painted over the colour `below`. `line` is
    /// the fraction of the pixel that grid lines cover.
    #[inline(always)]
    fn paint(&self, line: f32, is_visible: bool, below: Color32) -> Color32 {
        let opacity = if is_visible { self.opacity } else { 0.0 };
        let base = mix(below, self.color, opacity);
        if line > 0.0 { mix(base, self.grid_color, line * opacity) } else { base }
    }
}

impl<'a> Layers<'a> {
    /// Creates layers over the observer's frame, which must have a value for every screen pixel.
    pub(crate) fn new(frame: &'a Frame<f32>, backdrop: &'a Backdrop) -> Self {
        let image = frame.camera().image();
        let (width, height) = (image.width() as usize, image.height() as usize);
        Layers { frame, width, height, backdrop, viewport: None }
    }

    /// Returns true if the frame has a t and an object for every screen pixel.
    fn is_traced(&self) -> bool {
        self.frame.t.len() == self.width * self.height
            && self.frame.object.len() == self.frame.t.len()
    }

    /// Returns the t of the traced object at a screen position; infinity outside the picture.
    pub(crate) fn traced_t(&self, dot: DVec2) -> f64 {
        let inside =
            dot.cmpge(DVec2::ZERO).all() && dot.x < self.width as f64 && dot.y < self.height as f64;
        if !(inside && self.is_traced()) {
            return f64::INFINITY;
        }
        self.frame.t[dot.y as usize * self.width + dot.x as usize].into()
    }

    /// Returns true if something hides from the observer the point at `t` on the ray through a screen
    /// position. If `on_viewport` is true, the point lies on the viewport, which then does not hide it.
    pub(crate) fn hides(&self, dot: DVec2, t: f64, on_viewport: bool) -> bool {
        self.traced_t(dot) * (1.0 + TOLERANCE) < t || self.is_behind_layer(dot, t, on_viewport)
    }

    /// Returns true if the camera's picture, or a pane that is opaque enough, hides the point at `t` on the ray
    /// through a screen position. See [`Layers::hides`].
    pub(crate) fn is_behind_layer(&self, dot: DVec2, t: f64, on_viewport: bool) -> bool {
        let covers = |spot: FlatSpot| spot.t * (1.0 + TOLERANCE) < t;
        let picture = self.viewport.as_ref().filter(|v| !on_viewport && v.picture.is_some());
        let mut panes = self.backdrop.patches.iter().filter(|patch| patch.opacity > SEEN_THROUGH);
        picture.and_then(|layer| layer.spot(dot)).is_some_and(covers)
            || panes.any(|patch| patch.flat.at(dot, HALF).is_some_and(covers))
    }

    /// Paints all layers over the `traced` picture in the pixels that the viewport covers, in a band of rows
    /// of which `top` is the first. All other pixels must already show the result of [`Backdrop::paint`].
    pub(crate) fn paint_viewport(&self, top: usize, traced: &[Color32], dots: &mut [Color32]) {
        let Some(viewport) = &self.viewport else { return };
        let part = |row: usize| viewport.flat.span(row as f64 + 0.5, self.width, HALF);
        self.paint_parts(top, dots, part, |row, part, dots| {
            let start = row * self.width;
            dots.copy_from_slice(&traced[start + part.start..start + part.end]);
        });
    }

    /// Smooths the borders between traced objects where [`Layers::paint_viewport`] painted, except where the
    /// camera's picture hides them.
    pub(crate) fn smooth_viewport(&self, edges: &[EdgeBlend], dots: &mut [Color32]) {
        let Some(viewport) = self.viewport.as_ref().filter(|_| self.is_traced()) else { return };
        let is_hidden = |at: DVec2, edge: &EdgeBlend| {
            let [own, other] = [edge.pixel, edge.from].map(|pixel| self.frame.t[pixel as usize]);
            let spot = viewport.spot(at).filter(|_| viewport.picture.is_some());
            spot.is_some_and(|spot| is_nearer(spot.t as f32, own.min(other)))
        };
        let row_of = |edge: &EdgeBlend| edge.pixel as usize / self.width;
        let rows = edges.chunk_by(|a, b| row_of(a) == row_of(b));
        let painted = rows.flat_map(|edges| {
            let row = row_of(&edges[0]);
            let y = row as f64 + 0.5;
            let part = viewport.flat.span(y, self.width, HALF);
            edges.iter().filter(move |edge| {
                let column = edge.pixel as usize - row * self.width;
                part.contains(&column) && !is_hidden(DVec2::new(column as f64 + 0.5, y), edge)
            })
        });
        smooth(painted, dots);
    }

    /// Paints all layers over a part of each row, starting at row `top`. Calls `before` on the pixels of
    /// each part before painting them.
    fn paint_parts(
        &self,
        top: usize,
        dots: &mut [Color32],
        part_of: impl Fn(usize) -> Range<usize>,
        before: impl Fn(usize, Range<usize>, &mut [Color32]),
    ) {
        if !self.is_traced() {
            return;
        }
        let count = 1 + self.backdrop.patches.len() + usize::from(self.backdrop.floor.is_some());
        let mut layers = vec![FlatRow::default(); count];
        for (row, dots) in (top..self.height).zip(dots.chunks_exact_mut(self.width)) {
            let part = part_of(row);
            if part.is_empty() {
                continue;
            }
            let y = row as f64 + 0.5;
            if let Some(ViewportLayer { flat, grid, .. }) = &self.viewport {
                let grid = grid.as_ref().map(|(grid, _)| grid);
                flat.fill_row(&mut layers[0], y, &part, HALF, grid);
            }
            let traced = &self.frame.t[row * self.width..][..self.width];
            if layers[0].span == part && self.shows_only_picture(&layers[0], y, traced) {
                self.paint_one(&layers[0], 0, part, traced, dots);
                continue;
            }
            before(row, part.clone(), &mut dots[part.clone()]);
            let patches = self.backdrop.patches.iter().chain(&self.backdrop.floor);
            for (layer, PlanePatch { flat, grid, .. }) in layers[1..].iter_mut().zip(patches) {
                flat.fill_row(layer, y, &part, HALF, Some(grid));
            }
            self.paint_row(&layers, row, &part, dots);
        }
    }

    /// Returns true if the camera's picture hides everything else in its part of a row.
    fn shows_only_picture(&self, row: &FlatRow, y: f64, traced: &[f32]) -> bool {
        let Some(viewport) = self.viewport.as_ref().filter(|layer| layer.picture.is_some()) else {
            return false;
        };
        // The sign of the difference between the 1/t of two planes changes at most once in a row, since 1/t
        // is linear, so the planes are compared at the ends.
        let patches = self.backdrop.patches.iter().chain(&self.backdrop.floor);
        let is_nearest = |x: usize| {
            let at = |flat: &Flat| flat.at(DVec2::new(x as f64, y), f64::INFINITY);
            let Some(spot) = at(&viewport.flat) else { return false };
            patches.clone().all(|patch| at(&patch.flat).is_none_or(|other| spot.t < other.t))
        };
        let mut in_front = row.t.iter().zip(&traced[row.span.clone()]);
        [row.span.start, row.span.end].into_iter().all(is_nearest)
            && in_front.all(|(t, traced)| is_nearer(*t, *traced))
    }

    fn paint_row(&self, layers: &[FlatRow], row: usize, part: &Range<usize>, dots: &mut [Color32]) {
        let (layers, floor) = layers.split_at(1 + self.backdrop.patches.len());
        let start = row * self.width;
        let t = &self.frame.t[start..start + self.width];
        let objects = &self.frame.object[start..start + self.width];
        for (dot, object) in dots[part.clone()].iter_mut().zip(&objects[part.clone()]) {
            if *object == NO_OBJECT {
                *dot = self.backdrop.background;
            }
        }
        for bowl in &self.backdrop.bowls {
            let y = row as f64 + 0.5;
            for (column, dot) in part.clone().zip(&mut dots[part.clone()]) {
                *dot = bowl.paint([column as f64 + 0.5, y], t[column], *dot);
            }
        }
        // Between two successive ends of spans, the layers that cover a pixel stay the same.
        let mut ends: Vec<usize> = layers.iter().flat_map(|l| [l.span.start, l.span.end]).collect();
        ends.sort_unstable();
        for pair in ends.windows(2) {
            let part = pair[0]..pair[1];
            let there = |l: &FlatRow| l.span.start <= part.start && part.end <= l.span.end;
            let there: Vec<usize> = (0..layers.len()).filter(|l| there(&layers[*l])).collect();
            match there[..] {
                [] => {}
                [only] => self.paint_one(&layers[only], only, part, t, dots),
                _ => self.paint_many(layers, &there, part, t, dots),
            }
        }
        // The lines of the floor, where neither the camera's picture nor a pane hides them.
        let (Some(patch), [floor]) = (&self.backdrop.floor, floor) else { return };
        for (column, (spot_t, [.., line])) in
            floor.span.clone().zip(floor.spots(floor.span.clone()))
        {
            if line == 0.0 || !is_nearer(spot_t, t[column]) {
                continue;
            }
            let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
            // Where a pane meets the floor, the pane has precedence.
            if !self.is_behind_layer(at, f64::from(spot_t) * (1.0 + TOLERANCE), false) {
                dots[column] = mix(dots[column], patch.grid_color, line * patch.opacity);
            }
        }
    }

    fn paint_one(
        &self,
        row: &FlatRow,
        index: usize,
        part: Range<usize>,
        traced: &[f32],
        dots: &mut [Color32],
    ) {
        let (dots, traced) = (&mut dots[part.clone()], &traced[part.clone()]);
        let spots = row.spots(part);
        // Each kind of layer has its own loop, because most of the time is spent here: planes can
        // cover the whole screen.
        match (index.checked_sub(1), &self.viewport) {
            (Some(patch), _) => {
                let patch = &self.backdrop.patches[patch];
                for ((dot, (t, spot)), traced) in dots.iter_mut().zip(spots).zip(traced) {
                    *dot = patch.paint(spot[2], is_nearer(t, *traced), *dot);
                }
            }
            (None, Some(viewport)) => {
                let nearer = dots.iter_mut().zip(spots).zip(traced);
                let nearer = nearer.filter(|((_, (t, _)), traced)| is_nearer(*t, **traced));
                nearer.for_each(|((dot, (_, spot)), _)| *dot = viewport.paint(spot, *dot));
            }
            (None, None) => {}
        }
    }

    fn paint_many(
        &self,
        layers: &[FlatRow],
        there: &[usize],
        part: Range<usize>,
        traced: &[f32],
        dots: &mut [Color32],
    ) {
        let mut found: Vec<(f32, usize)> = Vec::with_capacity(there.len());
        // The camera's picture is opaque, so layers behind it need not be sorted.
        let picture = self.viewport.as_ref().filter(|v| there[0] == 0 && v.picture.is_some());
        for column in part {
            let t = |index: &usize| layers[*index].t[column - layers[*index].span.start];
            if let Some(viewport) = picture {
                let viewport_t = t(&0);
                if is_nearer(viewport_t, traced[column])
                    && there[1..].iter().all(|layer| t(layer) > viewport_t)
                {
                    let spot = layers[0].spot(column - layers[0].span.start);
                    dots[column] = viewport.paint(spot, dots[column]);
                    continue;
                }
            }
            found.clear();
            found.extend(there.iter().map(|index| (t(index), *index)));
            found.retain(|(t, _)| is_nearer(*t, traced[column]));
            found.sort_by(|a, b| b.0.total_cmp(&a.0));
            for (_, index) in &found {
                let (row, below) = (&layers[*index], dots[column]);
                let spot = row.spot(column - row.span.start);
                dots[column] = match (index.checked_sub(1), &self.viewport) {
                    (Some(patch), _) => self.backdrop.patches[patch].paint(spot[2], true, below),
                    (None, Some(viewport)) => viewport.paint(spot, below),
                    (None, None) => below,
                };
            }
        }
    }
}

/// Mixes the pixels at the borders between objects with those of their neighbours.
fn smooth<'a>(edges: impl Iterator<Item = &'a EdgeBlend>, dots: &mut [Color32]) {
    // No pixel may change before its neighbours have read it.
    let mut mixed: Vec<(usize, Color32)> = Vec::new();
    for EdgeBlend { pixel, from, share } in edges {
        let (pixel, other) = (*pixel as usize, dots[*from as usize]);
        match mixed.last_mut() {
            Some((last, color)) if *last == pixel => *color = mix(other, *color, *share),
            _ => mixed.push((pixel, mix(other, dots[pixel], *share))),
        }
    }
    mixed.into_iter().for_each(|(pixel, color)| dots[pixel] = color);
}

/// Returns true if a layer at `t` is nearer than the traced object in the same screen pixel, or at the same
/// t.
fn is_nearer(t: f32, traced: f32) -> bool {
    (t > 0.0) & (t <= traced * (1.0 + PAINT_TOLERANCE))
}

/// Returns a blend of two colours: `top` with weight `share`, and `bottom` with the rest.
#[inline(always)]
pub(crate) fn mix(bottom: Color32, top: Color32, share: f32) -> Color32 {
    // The lowest bits of the sum 2^23 + x hold x as an integer. This avoids the special cases of a cast.
    let weight = ((share.clamp(0.0, 1.0) * 256.0 + 8_388_608.0).to_bits() & 0x1ff).min(256);
    // Two channels are processed at a time: 8 bits of colour times 9 bits of weight fit into 16 bits.
    let (b, t) = (u32::from_le_bytes(bottom.to_array()), u32::from_le_bytes(top.to_array()));
    let two = |b: u32, t: u32| {
        (((b & 0x00ff_00ff) * (256 - weight) + (t & 0x00ff_00ff) * weight) >> 8) & 0x00ff_00ff
    };
    let [r, g, b, a] = (two(b, t) | two(b >> 8, t >> 8) << 8).to_le_bytes();
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// Returns a grey that contrasts with a colour: black for a light colour, white for a very dark one (by the
/// luma of ITU-R BT.601), and a grey in between for others, so that a line across a shaded surface has no
/// seam. For a transparent colour, the colour `behind` it counts.
pub(crate) fn opposing_grey(color: Color32, behind: Color32) -> Color32 {
    const FROM: u32 = 40_000;
    const TO: u32 = 95_000;
    let color = if color.a() < 128 { behind } else { color };
    let luma = 299 * u32::from(color.r()) + 587 * u32::from(color.g()) + 114 * u32::from(color.b());
    Color32::from_gray(((TO - luma.clamp(FROM, TO)) * 255 / (TO - FROM)) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_over_a_shaded_surface_have_no_seam() {
        let line = |grey: u8| {
            let base = Color32::from_gray(grey);
            i32::from(mix(base, opposing_grey(base, Color32::BLACK), 0.45).r())
        };
        for grey in 1..=255 {
            assert!((line(grey) - line(grey - 1)).abs() <= 4, "{grey}");
        }
        for grey in (0..=55).chain(90..=255) {
            assert!((line(grey) - i32::from(grey)).abs() >= 12, "{grey} is told apart");
        }
    }
}
