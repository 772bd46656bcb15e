//! The world view, which is the observer's picture with the camera and everything else drawn in it, and
//! the camera view.
//!
//! The camera's own picture is lit from its eye, so a ball is brightest in its middle and looks flat. The
//! observer's picture is lit from above the observer's left shoulder, as in a printed figure. Light goes
//! around a ball and through others: no ray to the light is traced, so there are no shadows.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{
    Camera, DVec3, Frame, NO_OBJECT, Outputs, Pixel, ResolvedCamera, Rgb, Scene, Selection, Shade,
    lambert,
};
use rayon::prelude::*;

use crate::model::observer::{Observer, enclosing};
use crate::model::overlay_items::OverlayItems;
use crate::model::practice::answer_marks::AnswerMark;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::derive::memo::{Buffers, Fineness, Memo, Same};
use crate::view::derive::objects::{Enclosing, Objects};
use crate::view::derive::picture::{GoodPicture, Watch, Work, repainted, trace_picture, watched};
use crate::view::derive::{
    Derived, HighlightKey, Inputs, Purpose, Shown, answer_marks, highlight_key, opaque,
};
use crate::view::handles::{self, Stage};
use crate::view::overlay::{
    self, Backdrop, Below, CameraView, GhostCamera, Handles, Highlighted, Loupe, Style, WorldView,
};

/// Caches of the world view and of the pictures it is drawn over.
#[derive(Debug, Default)]
pub(super) struct WorldViews {
    pub(super) pictures: WorldPictures,
    view: Memo<WorldKey, Shown>,
    buffers: Buffers,
}

/// The world view, with what it was drawn from.
pub(super) struct SeenWorld {
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) subsampling: Subsampling,
    pub(super) view: Shown,
}

#[derive(Debug, PartialEq)]
struct WorldKey {
    world: Same<WorldPicture>,
    camera: Camera,
    observer: Observer,
    size: [u32; 2],
    picture: Option<u64>,
    scanned_pixels: Option<u64>,
    selection: Selection,
    items: OverlayItems,
    highlighted: Option<HighlightKey>,
    ray_point_t: Option<f64>,
    handles: Handles,
    ghost: Option<GhostCamera>,
    answer_marks: Arc<[AnswerMark]>,
    scale: f32,
    style: Style,
    purpose: Purpose,
    names_all: bool,
}

impl WorldViews {
    /// Returns the world view with the `number`th good picture on its viewport; `None` where it is
    /// not shown.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        objects: &mut Objects,
        last_good: Option<(&GoodPicture, u64)>,
    ) -> Option<SeenWorld> {
        let Inputs { document, session, sizes, watch } = inputs;
        let (size, observer, good) = (sizes.world?, session.observer?, objects.good()?.clone());
        let observer_camera = observer.camera(size[0], size[1]).resolve().ok()?;
        let color_of = |i: u32| good.colors.get(i as usize).copied().unwrap_or_default();
        let WorldViews { pictures, view, buffers } = self;
        let world = pictures.get(inputs, objects, observer_camera)?;
        let seen = last_good.filter(|_| derived.fault.is_none());
        let stage = Stage {
            document,
            resolved: derived.resolved.as_ref(),
            selection: session.shown_selection(),
            items: session.settings.items,
            observer: world.frame.camera(),
            scale: sizes.scale,
        };
        let key = WorldKey {
            world: Same(Arc::clone(&world)),
            camera: document.camera,
            observer,
            size,
            picture: seen.map(|(_, number)| number),
            scanned_pixels: session.scanned_pixels,
            selection: session.shown_selection(),
            items: session.settings.items,
            highlighted: highlight_key(session),
            ray_point_t: session.ray_point_t,
            handles: handles::drawn(&stage, &session.handles, &session.spoken_of()),
            ghost: answer_marks::ghost(inputs, derived),
            answer_marks: Arc::clone(&derived.answer_marks),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
            names_all: session.spoken.is_some() || sizes.purpose != Purpose::Window,
        };
        let (resolved, inspection) = (derived.resolved, derived.inspection.as_deref());
        let view = view.get(key, |key| {
            let view = WorldView {
                camera: &document.camera,
                resolved: resolved.as_ref(),
                picture: seen.map(|(seen, _)| &*seen.picture),
                inspection,
                scene: &good.scene,
                enclosing: &world.enclosing,
                color_of: &color_of,
                observer: &observer,
                frame: &world.frame,
                items: key.items,
                scale: key.scale,
                style: key.style,
                highlighted: key.highlighted.map(|(concept, digits, dims)| Highlighted {
                    concept,
                    camera: &document.camera,
                    scene: &good.scene,
                    digits,
                    dims,
                }),
                ray_point_t: key.ray_point_t,
                handles: &key.handles,
                ghost: key.ghost.as_ref(),
                answer_marks: &key.answer_marks,
                is_clear: key.purpose.is_clear(),
                names_all: key.names_all,
            };
            let backdrop = Backdrop::new(&view);
            let painted = pictures.painted(&world, &backdrop, watch);
            watched(watch, Work::Overlay, || {
                let mut pixels = buffers.take(size);
                let below = Below { traced: &world.pixels, painted: &painted };
                let draw = match key.purpose {
                    Purpose::Window => overlay::world,
                    Purpose::Figure { .. } => overlay::world_apart,
                };
                let drawing = draw(&view, &backdrop, below, &mut pixels);
                key.style.finish(&mut pixels);
                buffers.shown(size, pixels, drawing)
            })
        });
        Some(SeenWorld { frame: Arc::clone(&world.frame), subsampling: world.subsampling, view })
    }
}

/// A cache of the camera view.
#[derive(Debug, Default)]
pub(super) struct CameraViews {
    view: Memo<CameraKey, Shown>,
    buffers: Buffers,
}

#[derive(Debug, PartialEq)]
struct CameraKey {
    picture: u64,
    scanned_pixels: Option<u64>,
    resolved: ResolvedCamera,
    size: [u32; 2],
    selection: Selection,
    items: OverlayItems,
    highlighted: Option<HighlightKey>,
    loupe: Option<Arc<Loupe>>,
    scale: f32,
    style: Style,
    purpose: Purpose,
}

impl CameraViews {
    /// Returns the camera view, if it is shown, of the `number`th good picture.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        (good, number): (&GoodPicture, u64),
    ) -> Option<Shown> {
        let Inputs { document, session, sizes, watch } = inputs;
        let size = sizes.camera?;
        let key = CameraKey {
            picture: number,
            scanned_pixels: session.scanned_pixels,
            resolved: good.resolved,
            size,
            selection: good.selection,
            items: session.settings.items,
            // A highlighted concept belongs to the current document; an older picture does not show
            // it.
            highlighted: highlight_key(session).filter(|_| derived.fault.is_none()),
            loupe: good.loupe.clone(),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
        };
        let (scene, buffers) = (derived.scene.as_deref(), &mut self.buffers);
        let mut draw = |key: &CameraKey| {
            let view = CameraView {
                picture: &good.picture,
                resolved: &good.resolved,
                inspection: Some(&good.inspection),
                items: key.items,
                size: key.size.map(|n| n as usize),
                scale: key.scale,
                style: key.style,
                highlighted: scene.zip(key.highlighted).map(|(scene, (concept, digits, dims))| {
                    Highlighted { concept, camera: &document.camera, scene, digits, dims }
                }),
                loupe: key.loupe.as_deref(),
            };
            let mut pixels = buffers.take(size);
            let drawing = match key.purpose {
                Purpose::Window => overlay::camera(&view, &mut pixels),
                Purpose::Figure { .. } => overlay::camera_apart(&view, &mut pixels),
            };
            key.style.finish(&mut pixels);
            buffers.shown(size, pixels, drawing)
        };
        Some(self.view.get(key, |key| watched(watch, Work::Overlay, || draw(key))))
    }
}

/// The scene as the observer sees it.
#[derive(Debug)]
pub(super) struct WorldPicture {
    /// The frame with `t` and object, which the overlay reads.
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) pixels: Vec<Color32>,
    pub(super) enclosing: Enclosing,
    /// The picture's subsampling.
    pub(super) subsampling: Subsampling,
}

/// The inputs of a trace: the observer, the generation of the objects, and the hidden spheres.
type TraceKey = (ResolvedCamera, u64, Enclosing);

/// A cache of the observer's pictures.
#[derive(Debug, Default)]
pub(super) struct WorldPictures {
    enclosing: Memo<(u64, DVec3, DVec3), Enclosing>,
    fineness: Fineness<TraceKey>,
    /// Frames that can be recoloured without a trace.
    frame: Memo<(TraceKey, Subsampling), Arc<Frame<f32>>>,
    /// The picture; the last part of the key is the palette's number.
    picture: Memo<(TraceKey, Subsampling, u64), Arc<WorldPicture>>,
    backdrop: Memo<(Same<WorldPicture>, Backdrop), Arc<Vec<Color32>>>,
    /// Number of times the observer's view was traced.
    pub(super) traced: u64,
}

impl WorldPictures {
    /// Returns the observer's picture of the good objects, without those that would hide the camera;
    /// `None` if there have been no good objects yet.
    pub(super) fn get(
        &mut self,
        Inputs { document, sizes, watch, .. }: Inputs<'_>,
        objects: &mut Objects,
        observer: ResolvedCamera,
    ) -> Option<Arc<WorldPicture>> {
        let (good, eye) = (objects.good()?.clone(), document.camera.eye);
        let enclosing = self.enclosing.get((good.generation, eye, observer.eye()), |_| {
            Arc::new(enclosing(&good.scene, eye, observer.eye()))
        });
        let scene = objects.observed(&enclosing)?;
        let color_of = |i: u32| good.colors[i as usize];
        let colors = (Shade::Object, color_of);
        let (frame, traced) = (&mut self.frame, &mut self.traced);
        let seen = (observer, good.generation, enclosing);
        let subsampling = self.fineness.at_most(seen.clone(), sizes.subsampling);
        Some(self.picture.get((seen, subsampling, good.palette), |(seen, ..)| {
            let mut fresh = None;
            let frame = frame.get((seen.clone(), subsampling), |_| {
                *traced += 1;
                let image = observer.image();
                let raster = subsampling.raster(image, [image.width(), image.height()]);
                let mut traced = trace_picture(
                    &scene,
                    &observer,
                    &raster,
                    Outputs::default(),
                    colors,
                    (None, watch),
                );
                watched(watch, Work::Trace, || {
                    paint_key_light(&traced.0, &scene, color_of, &mut traced.1);
                });
                if subsampling == Subsampling::NONE {
                    fresh = Some(traced.1);
                    return Arc::new(traced.0);
                }
                // The overlay looks up the object at every dot.
                fresh = Some(raster.spread(image, &traced.1));
                Arc::new(traced.0.spread())
            });
            let pixels = fresh.unwrap_or_else(|| {
                let mut pixels = repainted(&frame, &scene, colors, watch);
                paint_key_light(&frame, &scene, color_of, &mut pixels);
                pixels
            });
            let enclosing = Arc::clone(&seen.2);
            Arc::new(WorldPicture { frame, pixels, enclosing, subsampling })
        }))
    }

    /// Returns the observer's picture with a backdrop painted over it.
    pub(super) fn painted(
        &mut self,
        world: &Arc<WorldPicture>,
        backdrop: &Backdrop,
        watch: Watch<'_>,
    ) -> Arc<Vec<Color32>> {
        let key = (Same(Arc::clone(world)), backdrop.clone());
        self.backdrop.get(key, |(world, backdrop)| {
            watched(watch, Work::Overlay, || {
                let mut dots = world.0.pixels.clone();
                backdrop.paint(&world.0.frame, &mut dots);
                Arc::new(dots)
            })
        })
    }
}

/// Direction of the light, in the observer's u, v, w.
const TOWARD: DVec3 = DVec3::new(-0.45, 0.65, 0.61);

/// Share of the light that comes from the observer's eye.
const FROM_EYE: f64 = 0.3;

/// Paints the spheres of a frame; all other pixels stay.
pub(super) fn paint_key_light(
    frame: &Frame<f32>,
    scene: &Scene,
    color_of: impl Fn(u32) -> Rgb + Sync,
    pixels: &mut [Color32],
) {
    let (camera, raster) = (frame.camera(), frame.raster());
    let width = raster.columns().len();
    if width == 0 || pixels.len() != frame.t.len() || frame.object.len() != frame.t.len() {
        return;
    }
    let toward = camera.basis().to_world_from_camera(TOWARD).normalize();
    pixels.par_chunks_mut(width).enumerate().for_each(|(index, pixels)| {
        let part = index * width..(index + 1) * width;
        let seen = frame.object[part.clone()].iter().zip(&frame.t[part]).zip(raster.columns());
        for (pixel, ((object, t), column)) in pixels.iter_mut().zip(seen) {
            if *object == NO_OBJECT {
                continue;
            }
            let position = Pixel { row: raster.rows()[index], column: *column };
            if let Some(sphere) = scene.spheres().get(*object as usize) {
                let light = light_on(camera, position, f64::from(*t), sphere.center, toward);
                *pixel = opaque(lambert(color_of(*object), light));
            }
        }
    });
}

/// Returns the light, 0 to 1, where a pixel's ray meets a sphere at `t`.
fn light_on(camera: &ResolvedCamera, pixel: Pixel, t: f64, center: DVec3, toward: DVec3) -> f64 {
    let ray = camera.ray_of_pixel(pixel);
    let out = (ray.at(t) - center).normalize_or_zero();
    let facing = -out.dot(ray.direction.normalize_or_zero());
    // From inside, the other side of the surface is seen.
    let wrapped = 0.5 + 0.5 * facing.signum() * out.dot(toward);
    (FROM_EYE * facing.abs() + (1.0 - FROM_EYE) * wrapped).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use pinhole_core::{Camera, Outputs, Raster, Sphere, trace_as};

    use super::*;

    #[test]
    fn a_ball_is_lighter_above_on_the_left_and_nowhere_black() {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.5 };
        let scene = Scene::new(vec![ball], vec![]).expect("a scene");
        let camera = Camera::CANONICAL.resolve().expect("a camera");
        let raster = Raster::full(camera.image());
        let frame = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
        let mut pixels = vec![Color32::BLACK; raster.len()];
        paint_key_light(&frame, &scene, |_| [200; 3], &mut pixels);
        let at = |u: f64, v: f64| {
            let (row, column) = ((0.5 - v) * 400.0, (0.5 + u) * 400.0);
            pixels[row as usize * 400 + column as usize].r()
        };
        assert!(at(-0.12, 0.15) > at(0.0, 0.0) && at(0.0, 0.0) > at(0.15, -0.18));
        assert!(at(0.15, -0.18) > 60);
        assert_eq!(at(0.45, 0.45), 0, "beside it");
    }
}
