//! From the document to everything that is shown: pure, and remembered on its inputs, so that an
//! idle window does no work and one drag does only what it changes.

mod answers;
mod beside;
mod derived;
mod ghost;
mod ledgers;
mod memo;
mod objects;
mod picture;
mod plots;
mod scan;
mod watch;
mod world;
mod wrong;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::methods::Method;
use pinhole_core::{Camera, ResolvedCamera, Rgb, Scene};

use self::answers::GradedAnswers;
pub use self::answers::Grading;
pub use self::derived::{Derived, Fault, Purpose, Shown, ViewSizes};
use self::ghost::GhostPictures;
use self::ledgers::Ledgers;
use self::memo::{Memo, Same};
use self::objects::Objects;
pub use self::picture::{Compared, MOST_QUESTIONS, TooMany};
use self::picture::{GoodPicture, Pictures};
use self::plots::Plots;
use self::watch::watched;
pub use self::watch::{Watch, Work};
use self::world::{WorldPicture, WorldPictures};
use self::wrong::{Right, WrongPictures};
use crate::accuracy;
use crate::document::Document;
use crate::handles::{self, Stage};
use crate::observer::Observer;
use crate::overlay::{
    self, Backdrop, CameraView, Handles, Lit, Loupe, OverlayItems, Picture, Style, WorldView,
};
use crate::session::{Selection, Session};
use crate::thing::Thing;

/// Makes [`Derived`]s, each from its arguments alone; what it remembers only saves work.
#[derive(Debug, Default)]
pub struct Deriver {
    objects: Objects,
    pictures: Pictures,
    camera_view: Memo<CameraViewKey, Shown>,
    error_map: Memo<(Method, CameraViewKey), Shown>,
    world_pictures: WorldPictures,
    world_view: Memo<WorldViewKey, Shown>,
    ledgers: Ledgers,
    plots: Plots,
    wrong: WrongPictures,
    ghosts: GhostPictures,
    answers: GradedAnswers,
    /// What the camera saw before the document got a fault.
    last_good: Option<GoodPicture>,
}

#[derive(Debug, PartialEq)]
struct CameraViewKey {
    picture: u64,
    scanned: Option<u64>,
    resolved: ResolvedCamera,
    size: [u32; 2],
    selection: Selection,
    items: OverlayItems,
    lit: Option<(Thing, usize)>,
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
    scanned: Option<u64>,
    selection: Selection,
    items: OverlayItems,
    lit: Option<(Thing, usize)>,
    walked: Option<f64>,
    handles: Handles,
    ghost: Option<ResolvedCamera>,
    scale: f32,
    style: Style,
    purpose: Purpose,
}

impl CameraViewKey {
    /// What this is the key of.
    fn view<'a>(
        &'a self,
        picture: &'a Picture,
        good: &'a GoodPicture,
        lit: Option<Lit<'a>>,
    ) -> CameraView<'a> {
        CameraView {
            picture,
            resolved: &good.resolved,
            inspection: Some(&good.inspection),
            items: self.items,
            size: self.size.map(|n| n as usize),
            scale: self.scale,
            style: self.style,
            lit,
            loupe: self.loupe.as_deref(),
        }
    }
}

impl Deriver {
    /// How many pictures have been traced so far; an idle window traces none.
    pub fn traced(&self) -> u64 {
        self.pictures.traced()
            + self.world_pictures.traced()
            + self.wrong.count()
            + self.ghosts.count()
    }

    /// Everything to show of this document.
    ///
    /// Who keeps the last one's [`Derived::scene`] has it as it was, at the price of a copy where an
    /// object changed.
    pub fn derive(&mut self, document: &Document, session: &Session, sizes: &ViewSizes) -> Derived {
        self.derive_watched(document, session, sizes, &|_| ())
    }

    /// The same, telling what its time is spent on.
    pub fn derive_watched(
        &mut self,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) -> Derived {
        // On one of rayon's threads from the start: called from another one, each step that is
        // shared among them would wake them and wait.
        rayon::join(|| self.derived(document, session, sizes, watch), || ()).0
    }

    fn derived(
        &mut self,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) -> Derived {
        let world = self
            .objects
            .update(document, sizes.style.scheme())
            .map(|()| self.objects.good().cloned());
        let resolved = document.camera.resolve();
        let fault = match (&resolved, &world) {
            (Err(e), _) => Some(Fault::Camera(*e)),
            (_, Err(e)) => Some(Fault::Scene(*e)),
            _ => None,
        };
        let mut derived = Derived {
            resolved: resolved.ok(),
            up_angle: document.camera.up_angle().ok(),
            scene: world.as_ref().ok().and_then(|world| Some(Arc::clone(&world.as_ref()?.scene))),
            fault,
            ..Derived::default()
        };
        if let (Some(resolved), Ok(Some(world))) = (derived.resolved, &world) {
            let good = self.pictures.of(resolved, world, session, sizes, watch);
            derived.inspection = Some(Arc::clone(&good.inspection));
            self.last_good = Some(good);
        }
        self.camera_views(&mut derived, document, session, sizes, watch);
        self.wrong_view(&mut derived, document, session, sizes, watch);
        let good = self.objects.good().filter(|_| derived.fault.is_none());
        self.ghosts.update(&mut derived, document, good, session, sizes, watch);
        self.world_view(&mut derived, document, session, sizes, watch);
        derived.ledger = self.ledgers.of(document, session, &derived);
        let generation = self.objects.good().map_or(0, |good| good.generation);
        derived.plot = self.plots.of(document, session, &derived, generation, sizes.style.scheme());
        derived
    }

    /// The camera's picture and, next to it, the error map.
    fn camera_views(
        &mut self,
        derived: &mut Derived,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) {
        let Some(good) = self.last_good.clone() else { return };
        // What is lit belongs to the document as it is; an older picture does not show it.
        let lit = lit_key(session).filter(|_| derived.fault.is_none());
        let scene = derived.scene.as_deref();
        let key = |size: [u32; 2]| CameraViewKey {
            picture: self.pictures.made(),
            scanned: session.scanned,
            resolved: good.resolved,
            size,
            selection: good.selection,
            items: session.settings.items,
            lit,
            loupe: good.loupe.clone(),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
        };
        let draw = |picture: &Picture, key: &CameraViewKey, pixels: &mut [Color32]| {
            let lit = scene.zip(key.lit).map(|(scene, lit)| lit_of(lit, document, scene));
            let view = key.view(picture, &good, lit);
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
        derived.coarseness[0] = good.coarseness;
        (derived.steps, derived.counts) = (Some(good.steps), Some(good.counts));
        derived.truth = good.truth;
    }

    /// The wrong camera's picture, next to the right one.
    fn wrong_view(
        &mut self,
        derived: &mut Derived,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) {
        let good = self.last_good.as_ref().filter(|_| derived.fault.is_none());
        let right = good.zip(self.objects.good()).map(|(good, world)| {
            let right = Right {
                camera: &document.camera,
                resolved: &good.resolved,
                inspection: &good.inspection,
                selection: good.selection,
                coarseness: good.coarseness,
            };
            (right, world)
        });
        if let Some((right, world)) = &right {
            self.answers.update(derived, document, (right, world), session, sizes, watch);
        }
        self.wrong.update(derived, right, session, sizes, watch);
    }

    fn world_view(
        &mut self,
        derived: &mut Derived,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) {
        let (Some(size), Some(good), Some(observer)) =
            (sizes.world, self.objects.good().cloned(), session.observer)
        else {
            return;
        };
        let Ok(observer_camera) = observer.camera(size[0], size[1]).resolve() else { return };
        let color_of = |i: u32| good.colors.get(i as usize).copied().unwrap_or_default();
        let eye = document.camera.eye;
        let pictures = &mut self.world_pictures;
        let coarseness = sizes.coarseness;
        let Some(world) = pictures.of(&mut self.objects, eye, observer_camera, coarseness, watch)
        else {
            return;
        };
        derived.coarseness[1] = world.coarseness;
        let seen = self.last_good.as_ref().filter(|_| derived.fault.is_none());
        let lit = lit_key(session);
        let stage = Stage {
            document,
            resolved: derived.resolved.as_ref(),
            selection: session.selection,
            items: session.settings.items,
            observer: world.frame.camera(),
            scale: sizes.scale,
        };
        let key = WorldViewKey {
            world: Same(Arc::clone(&world)),
            camera: document.camera,
            observer,
            size,
            picture: seen.map(|_| self.pictures.made()),
            scanned: session.scanned,
            selection: session.selection,
            items: session.settings.items,
            lit,
            walked: session.walked,
            handles: handles::drawn(&stage, &session.hand),
            ghost: derived.ghost,
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
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
                lit: key.lit.map(|lit| lit_of(lit, document, &good.scene)),
                walked: key.walked,
                handles: &key.handles,
                ghost: key.ghost.as_ref(),
                is_clear: key.purpose.is_clear(),
            };
            let backdrop = Backdrop::of(&view);
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

/// What is lit, and to how many digits it is labelled.
fn lit_key(session: &Session) -> Option<(Thing, usize)> {
    Some((session.lit()?, session.settings.digits))
}

fn lit_of<'a>(
    (thing, digits): (Thing, usize),
    document: &'a Document,
    scene: &'a Scene,
) -> Lit<'a> {
    Lit { thing, camera: &document.camera, scene, digits }
}
