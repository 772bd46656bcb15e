//! Derivation of everything shown from the document: a pure function, with caches keyed by its
//! inputs, so that an idle window does no work and a drag recomputes only what it changes.

mod beside;
mod derivations;
mod derived;
mod ghost;
mod grading;
mod key_light;
mod memo;
mod objects;
mod picture;
mod plots;
mod scan;
mod twins;
mod watch;
mod world;
mod wrong;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::methods::Method;
use pinhole_core::{Camera, ResolvedCamera, Rgb};

use self::derivations::Derivations;
use self::derived::Inputs;
pub use self::derived::{Derived, Purpose, Shown, ViewSizes};
use self::ghost::GhostPictures;
use self::grading::GradedAnswers;
pub use self::grading::Grading;
use self::memo::{Memo, Same};
use self::objects::Objects;
pub use self::picture::{Compared, MOST_QUESTIONS, TooMany};
use self::picture::{GoodPicture, Pictures};
use self::plots::Plots;
use self::twins::Twins;
use self::watch::watched;
pub use self::watch::{Watch, Work};
use self::world::{WorldPicture, WorldPictures};
use self::wrong::WrongPictures;
use crate::model::concept::Concept;
use crate::model::fault::Fault;
use crate::model::observer::Observer;
use crate::model::overlay_items::OverlayItems;
use crate::model::practice::twin::Twin;
use crate::model::session::{Selection, Session};
use crate::view::accuracy;
use crate::view::handles::{self, Stage};
use crate::view::overlay::{
    self, Backdrop, CameraView, GhostCamera, Handles, Highlighted, Loupe, Picture, Style, WorldView,
};
use pinhole_exchange::document::Document;

/// Computes [`Derived`] values, each from its arguments alone; its caches only save work.
#[derive(Debug, Default)]
pub struct Deriver {
    objects: Objects,
    pictures: Pictures,
    camera_view: Memo<CameraViewKey, Shown>,
    error_map: Memo<(Method, CameraViewKey), Shown>,
    world_pictures: WorldPictures,
    world_view: Memo<WorldViewKey, Shown>,
    derivations: Derivations,
    plots: Plots,
    wrong: WrongPictures,
    ghosts: GhostPictures,
    answers: GradedAnswers,
    twins: Twins,
    /// The camera's picture from before the document got a fault.
    last_good: Option<GoodPicture>,
}

#[derive(Debug, PartialEq)]
struct CameraViewKey {
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

#[derive(Debug, PartialEq)]
struct WorldViewKey {
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
    twins: Arc<[Twin]>,
    scale: f32,
    style: Style,
    purpose: Purpose,
    names_all: bool,
}

impl Deriver {
    /// Returns the number of pictures traced so far; an idle window traces none.
    pub fn traced(&self) -> u64 {
        self.pictures.traced + self.world_pictures.traced + self.wrong.count + self.ghosts.count
    }

    /// Derives everything to show of a document.
    ///
    /// A caller who keeps the last [`Derived::scene`] keeps it unchanged, at the cost of a copy
    /// when an object changes.
    pub fn derive(&mut self, document: &Document, session: &Session, sizes: &ViewSizes) -> Derived {
        self.derive_watched(document, session, sizes, &|_| ())
    }

    /// Does the same as [`Deriver::derive`] and reports to `watch` what the time is spent on.
    pub fn derive_watched(
        &mut self,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) -> Derived {
        let inputs = Inputs { document, session, sizes, watch };
        // Runs on one of rayon's threads from the start: on another thread, each parallel step
        // would have to wake them and wait.
        rayon::join(|| self.derived(inputs), || ()).0
    }

    fn derived(&mut self, inputs: Inputs<'_>) -> Derived {
        let camera = &inputs.document.camera;
        let updated = self.objects.update(inputs.document, inputs.sizes.style.scheme());
        let world = self.objects.good().filter(|_| updated.is_ok()).cloned();
        let resolved = camera.resolve();
        let fault = match (&resolved, updated) {
            (Err(e), _) => Some(Fault::Camera(*e)),
            (_, Err(e)) => Some(Fault::Scene(e)),
            _ => None,
        };
        let mut derived = Derived {
            resolved: resolved.ok(),
            up_angle: camera.up_angle().ok(),
            scene: world.as_ref().map(|world| Arc::clone(&world.scene)),
            fault,
            ..Derived::default()
        };
        if let (Some(resolved), Some(world)) = (derived.resolved, &world) {
            let good = self.pictures.get(inputs, resolved, world);
            derived.inspection = Some(Arc::clone(&good.inspection));
            self.last_good = Some(good);
        }
        drop(world);
        self.camera_views(&mut derived, inputs);
        let world = self.objects.good().filter(|_| derived.fault.is_none());
        let good = self.last_good.as_ref().zip(world);
        if let Some(good) = good {
            self.answers.update(&mut derived, inputs, good);
        }
        self.wrong.update(&mut derived, inputs, good);
        self.ghosts.update(&mut derived, inputs, world);
        let generation = self.objects.good().map_or(0, |good| good.generation);
        derived.twins = self.twins.get(inputs, &derived, generation);
        self.world_view(&mut derived, inputs);
        derived.derivation = self.derivations.get(inputs, &derived);
        derived.plot = self.plots.get(inputs, &derived, generation);
        derived
    }

    /// Derives the camera view and the error map beside it.
    fn camera_views(&mut self, derived: &mut Derived, inputs: Inputs<'_>) {
        let Inputs { document, session, sizes, watch } = inputs;
        let Some(good) = self.last_good.clone() else { return };
        // A highlighted concept belongs to the current document; an older picture does not show it.
        let highlighted = highlight_key(session).filter(|_| derived.fault.is_none());
        let scene = derived.scene.as_deref();
        let key = |size: [u32; 2]| CameraViewKey {
            picture: self.pictures.made,
            scanned_pixels: session.scanned_pixels,
            resolved: good.resolved,
            size,
            selection: good.selection,
            items: session.settings.items,
            highlighted,
            loupe: good.loupe.clone(),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
        };
        let draw = |picture: &Picture, key: &CameraViewKey, pixels: &mut [Color32]| {
            let view = CameraView {
                picture,
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
            match key.purpose {
                Purpose::Window => overlay::camera(&view, pixels),
                Purpose::Figure { .. } => overlay::camera_apart(&view, pixels),
            }
        };
        derived.camera_view = sizes.camera.map(|size| {
            self.camera_view.get(key(size), |key| {
                watched(watch, Work::Overlay, || {
                    let mut pixels = blank(size);
                    let drawing = draw(&good.picture, key, &mut pixels);
                    key.style.finish(&mut pixels);
                    Shown::new(size, pixels, drawing)
                })
            })
        });
        if let (Some((compared, map)), Some(size)) = (&good.compared, sizes.map) {
            let key = (compared.method, CameraViewKey { loupe: None, ..key(size) });
            derived.error_map = Some(self.error_map.get(key, |(_, key)| {
                let mut pixels = blank(size);
                let drawing = draw(map, key, &mut pixels);
                let (comparison, width) = (&compared.comparison, size[0] as usize);
                accuracy::mark_wrong(comparison, &map.raster, width, key.scale, &mut pixels);
                key.style.finish(&mut pixels);
                Shown::new(size, pixels, drawing)
            }));
            derived.compared = Some(Arc::clone(compared));
        }
        derived.drawn_by.clone_from(&good.drawn_by);
        derived.too_many = good.too_many;
        derived.subsampling[0] = good.subsampling;
        (derived.steps, derived.counts) = (Some(good.steps), Some(good.counts));
        derived.truth = good.truth;
    }

    fn world_view(&mut self, derived: &mut Derived, inputs: Inputs<'_>) {
        let Inputs { document, session, sizes, watch } = inputs;
        let (Some(size), Some(good), Some(observer)) =
            (sizes.world, self.objects.good().cloned(), session.observer)
        else {
            return;
        };
        let Ok(observer_camera) = observer.camera(size[0], size[1]).resolve() else { return };
        let color_of = |i: u32| good.colors.get(i as usize).copied().unwrap_or_default();
        let pictures = &mut self.world_pictures;
        let Some(world) = pictures.get(inputs, &mut self.objects, observer_camera) else { return };
        derived.subsampling[1] = world.subsampling;
        let seen = self.last_good.as_ref().filter(|_| derived.fault.is_none());
        let stage = Stage {
            document,
            resolved: derived.resolved.as_ref(),
            selection: session.shown_selection(),
            items: session.settings.items,
            observer: world.frame.camera(),
            scale: sizes.scale,
        };
        let key = WorldViewKey {
            world: Same(Arc::clone(&world)),
            camera: document.camera,
            observer,
            size,
            picture: seen.map(|_| self.pictures.made),
            scanned_pixels: session.scanned_pixels,
            selection: session.shown_selection(),
            items: session.settings.items,
            highlighted: highlight_key(session),
            ray_point_t: session.ray_point_t,
            handles: handles::drawn(&stage, &session.hand, &session.spoken_of()),
            ghost: twins::ghost(inputs, derived),
            twins: Arc::clone(&derived.twins),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
            names_all: session.spoken.is_some() || sizes.purpose != Purpose::Window,
        };
        let (resolved, inspection) = (derived.resolved, derived.inspection.as_deref());
        let shown = self.world_view.get(key, |key| {
            let view = WorldView {
                camera: &document.camera,
                resolved: resolved.as_ref(),
                picture: seen.map(|seen| &*seen.picture),
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
                twins: &key.twins,
                is_clear: key.purpose.is_clear(),
                names_all: key.names_all,
            };
            let backdrop = Backdrop::new(&view);
            let before = pictures.before(&world, &backdrop, watch);
            watched(watch, Work::Overlay, || {
                let mut pixels = before.to_vec();
                let draw = match key.purpose {
                    Purpose::Window => overlay::world,
                    Purpose::Figure { .. } => overlay::world_apart,
                };
                let drawing = draw(&view, &backdrop, &world.pixels, &mut pixels);
                key.style.finish(&mut pixels);
                Shown::new(size, pixels, drawing)
            })
        });
        derived.world_frame = Some(Arc::clone(&world.frame));
        derived.world_view = Some(shown);
    }
}

fn opaque([r, g, b]: Rgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn blank([width, height]: [u32; 2]) -> Vec<Color32> {
    vec![Color32::BLACK; width as usize * height as usize]
}

/// The highlighted concept, the number of digits of its labels, and whether it dims everything else.
type HighlightKey = (Concept, usize, bool);

fn highlight_key(session: &Session) -> Option<HighlightKey> {
    Some((session.highlighted()?, session.settings.digits, session.dims()))
}
