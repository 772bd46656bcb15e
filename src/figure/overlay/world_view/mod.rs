//! The world view: the scene with the camera in it, as the observer sees it.

pub(super) mod ground;
pub(super) mod handles;
pub(super) mod lens;
pub(super) mod sketch;
mod uncovered;
pub(super) mod under_pointer;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{DVec2, DVec3, EdgeBlend, Frame, Ray, ResolvedCamera, Scene, Sphere};
use rayon::prelude::*;

use crate::Item;
use crate::overlay::{
    BAND, Backdrop, Bowl, ColoredScene, Drawing, Figure, Fills, Flat, Grid, HandleMark, Layers,
    Picture, Same, Screen, Sketch, ViewportLayer, camera_uv_at, mix, opaque, place_labels, wide,
};

/// The inputs of the world view. Equal inputs give the same picture, so they serve as the cache's key.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldView {
    /// What is drawn besides the scene.
    pub figure: Figure,
    /// The picture of the edited camera, if there is a current one, to be drawn on the viewport.
    pub picture: Option<Same<Picture>>,
    /// The generation numbers of the objects and of their colours, which identify the scene.
    pub generations: [u64; 2],
    /// Indices of the spheres [around the camera](crate::observer::enclosing), which are drawn cut
    /// away so that the camera is visible.
    pub enclosing: Arc<Vec<u32>>,
    /// The observer's picture of [`observer::traced_scene`](crate::observer::traced_scene),
    /// traced at every pixel.
    pub frame: Same<Frame<f32>>,
    /// The handles that can be dragged.
    pub handles: Vec<HandleMark>,
    /// The number of the first row and column, 0 or 1.
    pub first_number: u32,
    /// Screen pixels per point.
    pub scale: f32,
    /// True if the picture is transparent where the observer's rays hit nothing.
    pub is_clear: bool,
    /// The rectangles, in physical pixels, that an inset and a line of numbers cover: left, top, right and
    /// bottom of each.
    pub covered: Vec<[f32; 4]>,
    /// True if the marks are not painted into the picture, as for figures, which draw them separately.
    pub without_marks: bool,
}

/// The pictures over which a world view is painted.
#[derive(Clone, Copy)]
pub struct Below<'a> {
    /// The observer's picture.
    pub traced: &'a [Color32],
    /// The observer's picture with the backdrop painted over it.
    pub painted: &'a [Color32],
    /// The borders between the objects of the observer's picture.
    pub edges: &'a [EdgeBlend],
}

/// Paints the world view. Returns the drawing, whose labels the caller must draw.
pub fn world(
    view: &WorldView,
    scene: ColoredScene<'_>,
    backdrop: &Backdrop,
    below: Below<'_>,
    dots: &mut [Color32],
) -> Drawing {
    let layers = view.layers(backdrop);
    let mut drawing = view.sketch(scene, &layers);
    let marks =
        if view.without_marks { Fills::default() } else { Fills::new(&drawing, view.size()) };
    if view.without_marks {
        drawing.spheres = view.uncovered(scene.scene, &layers);
    }
    view.paint(&layers, &marks, below, dots);
    drawing
}

/// Returns the (u, v) of the camera's viewport at a position in the world view, in screen pixels; `None` if
/// the position lies outside the viewport or an object hides it.
pub fn pick(resolved: &ResolvedCamera, frame: &Frame<f32>, position: [f32; 2]) -> Option<DVec2> {
    let observer = frame.camera();
    let at = wide(position);
    let backdrop = Backdrop::default();
    let layers = Layers::new(frame, &backdrop);
    let layer = viewport_layer(resolved, observer, Color32::TRANSPARENT)?;
    let spot = layer.spot(at)?;
    let uv = spot.position * DVec2::new(resolved.viewport().width, resolved.viewport().height);
    (spot.t <= layers.traced_t(at)).then_some(uv)
}

/// Returns the t of the point of a ray's line that is nearest to the observer's line of sight through a
/// position, which is in screen pixels. The t is rounded to the precision of the pointer. Returns `None` if
/// the two lines are parallel.
pub fn t_towards(frame: &Frame<f32>, ray: &Ray, position: [f32; 2]) -> Option<f64> {
    let observer = frame.camera();
    let size = [observer.image().width() as usize, observer.image().height() as usize];
    let sight = observer.ray(camera_uv_at(observer, size, position)).direction;
    let (d, between) = (ray.direction, ray.origin - observer.eye());
    // The shortest segment between the ray's line and the line of sight is orthogonal to both.
    let across = d.cross(sight);
    let t = sight.cross(between).dot(across) / across.length_squared();
    let digits = 10_f64.powf(3.0 - t.abs().max(1.0).log10().ceil());
    t.is_finite().then(|| (t * digits).round() / digits + 0.0)
}

fn viewport_layer<'a>(
    resolved: &ResolvedCamera,
    observer: &ResolvedCamera,
    behind: Color32,
) -> Option<ViewportLayer<'a>> {
    let (basis, viewport) = (resolved.basis(), resolved.viewport());
    let rays = observer.pixel_rays();
    let (u, v) = (viewport.width * basis.u, viewport.height * basis.v);
    let flat = Flat::new(&rays, resolved.viewport_point(DVec2::ZERO), u, v)?;
    Some(ViewportLayer { flat, image: resolved.image(), picture: None, grid: None, behind })
}

/// How much of the scenery's colour is left while the figure is directed to something else.
const SCENERY: f32 = 0.45;

/// Minimum distance between the image pixels' edges that are drawn on the viewport, in points. If the edges
/// are closer together, only every second, fifth, tenth... edge is drawn.
const GRID_SPACING: f64 = 7.0;

impl WorldView {
    /// Returns the marks and labels without painting them.
    pub fn drawing(&self, scene: ColoredScene<'_>) -> Drawing {
        self.sketch(scene, &self.layers(&self.backdrop(scene)))
    }

    fn size(&self) -> [usize; 2] {
        let image = self.frame.camera().image();
        [image.width() as usize, image.height() as usize]
    }

    fn paint(&self, layers: &Layers, marks: &Fills, below: Below<'_>, dots: &mut [Color32]) {
        let Below { traced, painted, edges } = below;
        let [width, height] = self.size();
        let background = self.background();
        let fades = self.figure.highlighted.is_some_and(|lit| lit.fades_scenery());
        if [dots.len(), traced.len(), painted.len()] != [width * height; 3] || dots.is_empty() {
            return dots.fill(Color32::BLACK);
        }
        dots.par_chunks_mut(BAND * width).enumerate().for_each(|(band, dots)| {
            dots.copy_from_slice(&painted[band * BAND * width..][..dots.len()]);
            if fades {
                dots.iter_mut().for_each(|dot| *dot = mix(background, *dot, SCENERY));
            }
            layers.paint_viewport(band * BAND, traced, dots);
        });
        layers.smooth_viewport(edges, dots);
        marks.paint_after(width, dots, |_, _| ());
    }

    fn screen(&self) -> Screen {
        let mut screen =
            Screen::new(self.frame.camera(), self.figure.observer.distance(), self.scale);
        screen.is_directed = self.figure.is_directed;
        screen
    }

    fn background(&self) -> Color32 {
        match self.is_clear {
            true => Color32::TRANSPARENT,
            false => self.figure.style.colors().background,
        }
    }

    /// Returns the layers below the camera and its marks.
    pub fn backdrop(&self, scene: ColoredScene<'_>) -> Backdrop {
        let background = self.background();
        let rays = self.frame.camera().pixel_rays();
        let bowl = |(index, sphere)| Bowl { sphere, color: scene.color_of(index), rays };
        let bowls = self.drawn_around(scene.scene).map(bowl).collect();
        let (patches, floor) = self.ground_layers(&self.ground(scene), &rays);
        Backdrop { background, patches, floor, bowls }
    }

    /// Returns the spheres around the camera that are drawn: the largest ones, since those behind many others
    /// cannot be seen.
    fn drawn_around(&self, scene: &Scene) -> impl Iterator<Item = (u32, Sphere)> {
        /// Maximum number of them.
        const MOST: usize = 6;
        let sphere = |index: &u32| Some((*index, *scene.spheres().get(*index as usize)?));
        let mut around: Vec<_> = self.enclosing.iter().filter_map(sphere).collect();
        if around.len() > MOST {
            around.select_nth_unstable_by(MOST, |(_, a), (_, b)| b.radius.total_cmp(&a.radius));
            around.truncate(MOST);
            around.sort_unstable_by_key(|(index, _)| *index);
        }
        around.into_iter()
    }

    fn layers<'a>(&'a self, backdrop: &'a Backdrop) -> Layers<'a> {
        let mut layers = Layers::new(&self.frame, backdrop);
        layers.viewport = self.figure.resolved.as_ref().and_then(|resolved| {
            let (items, image) = (self.figure.items, resolved.image());
            let behind = self.figure.style.colors().background;
            let layer = viewport_layer(resolved, self.frame.camera(), behind)?;
            let picture = self.picture.as_ref().filter(|_| items.shows(Item::Picture));
            let picture = picture.filter(|p| p.is_whole() && p.image == image);
            let picture = picture.map(|p| p.on([image.width() as usize, image.height() as usize]));
            let has_grid = items.shows(Item::PixelGrid);
            let grid = has_grid.then(|| pixel_grid(&self.screen(), resolved)).flatten();
            Some(ViewportLayer { picture, grid, ..layer })
        });
        layers
    }

    fn sketch(&self, scene: ColoredScene<'_>, layers: &Layers<'_>) -> Drawing {
        let colors = self.figure.style.colors();
        let screen = self.screen();
        let mut sketch = Sketch {
            view: self,
            screen,
            layers,
            has_labels: self.figure.items.shows(Item::Labels),
            colors,
            drawing: Drawing { scale: self.scale, ..Drawing::default() },
            requests: Vec::new(),
            fades: self.figure.highlighted.is_some_and(|lit| lit.dims),
        };
        sketch.ground(scene);
        let cut_away =
            |(index, sphere)| (index, sphere, mix(opaque(scene.color_of(index)), colors.ink, 0.3));
        let cut_away: Vec<_> = self.drawn_around(scene.scene).map(cut_away).collect();
        sketch.parts(self.figure.parts(scene.scene, &cut_away));
        sketch.handles();
        let Sketch { mut drawing, requests, .. } = sketch;
        place_labels(requests, &mut drawing, screen.size, &self.covered);
        drawing
    }
}

/// Returns the grid of image pixel edges that is as dense as can be distinguished on the screen, and its
/// opacity; `None` if there is none.
fn pixel_grid(screen: &Screen, resolved: &ResolvedCamera) -> Option<(Grid, f32)> {
    let center = resolved.viewport_point(DVec2::ZERO);
    let (basis, viewport, image) = (resolved.basis(), resolved.viewport(), resolved.image());
    let middle = screen.spot(center)?;
    let dots_per = |axis: DVec3, extent: f64, count: u32| {
        let half = 0.25 * extent * axis;
        let ends = (screen.spot(center - half), screen.spot(center + half));
        let half_extent = match ends {
            (Some(a), Some(b)) => (b.at - a.at).length(),
            (Some(end), None) | (None, Some(end)) => 2.0 * (end.at - middle.at).length(),
            // The observer is so close that the viewport is larger than the screen.
            (None, None) => screen.size.max_element(),
        };
        2.0 * half_extent / f64::from(count)
    };
    let across = dots_per(basis.u, viewport.width, image.width());
    let dots = across.min(dots_per(basis.v, viewport.height, image.height()));
    let wanted = GRID_SPACING * screen.scale / dots.max(1e-9);
    let step = (0..5)
        .flat_map(|power| [1, 2, 5].map(|m| m * 10u32.pow(power)))
        .find(|step| f64::from(*step) >= wanted)?;
    let opacity = if step == 1 { 0.4 } else { 0.18 };
    let (w, h) = (f64::from(image.width()), f64::from(image.height()));
    // The coordinates are (u / width, v / height); one crossing is at the corner of pixel (0, 0).
    let step = f64::from(step) / DVec2::new(w, h);
    Some((Grid::new(step, DVec2::new(-0.5, 0.5), screen.scale.max(1.0) as f32), opacity))
}
