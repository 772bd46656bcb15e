//! From the document to everything that is shown: pure, and remembered on its inputs, so that an
//! idle window does no work and one drag does only what it changes.

use std::fmt;
use std::sync::Arc;

use egui::{Color32, ColorImage};
use pinhole_core::{
    Camera, CameraError, DVec3, Frame, ImageSize, Outputs, Plane, PosedCamera, Raster, Rgb, Scene,
    SceneError, Shade, Sphere, UpAngle, shade, trace,
};

use crate::document::{CsvSpheres, Document, Item};
use crate::inspection::Inspection;
use crate::observer::{Observer, encloses, seen_scene};
use crate::overlay::{self, CameraView, Label, OverlayItems, Picture, Style, WorldView};
use crate::session::{Selection, Session};

/// How large the views are, in physical pixels; `None` where one is not shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewSizes {
    /// Width and height of the world view.
    pub world: Option<[u32; 2]>,
    /// Width and height of the picture in the camera view.
    pub camera: Option<[u32; 2]>,
    /// Physical pixels per point.
    pub scale: f32,
    /// Colours of the world view.
    pub style: Style,
}

/// Why there is no new picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The camera sees nothing.
    Camera(CameraError),
    /// An object is none.
    Scene(SceneError),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Camera(e) => e.fmt(f),
            Fault::Scene(e) => e.fmt(f),
        }
    }
}

/// One frame's worth of everything that is shown. Panels, views and readouts get this and cannot
/// write back, so all of them show the same frame.
#[derive(Clone, Debug, Default)]
pub struct Derived {
    /// The camera with its basis.
    pub posed: Option<PosedCamera>,
    /// How close up is to the view direction.
    pub up_angle: Option<UpAngle>,
    /// The selected ray.
    pub inspection: Option<Arc<Inspection>>,
    /// The scene, if every object is one.
    pub scene: Option<Arc<Scene>>,
    /// Why the pictures are older than the document, where they are.
    pub fault: Option<Fault>,
    /// What the camera sees.
    pub camera_view: Option<Shown>,
    /// The scene with the camera in it.
    pub world_view: Option<Shown>,
    /// What the observer sees where in the world view.
    pub world_frame: Option<Arc<Frame>>,
}

/// A finished view: pixels to present and labels to write on them.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The pixels, at physical resolution.
    pub image: Arc<ColorImage>,
    /// Text, in physical pixels of the image.
    pub labels: Arc<Vec<Label>>,
}

/// A value remembered with what it was made from.
#[derive(Debug)]
struct Memo<K, V>(Option<(K, V)>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Memo(None)
    }
}

impl<K: PartialEq, V: Clone> Memo<K, V> {
    fn get(&mut self, key: K, make: impl FnOnce(&K) -> V) -> V {
        match &self.0 {
            Some((known, value)) if *known == key => value.clone(),
            _ => {
                let value = make(&key);
                self.0 = Some((key, value.clone()));
                value
            }
        }
    }
}

/// Makes [`Derived`]s, each from its arguments alone; what it remembers only saves work.
#[derive(Debug, Default)]
pub struct Deriver {
    objects: Option<Objects>,
    camera_picture: Memo<(PosedCamera, u64, Raster, Shade), Arc<Picture>>,
    camera_view: Memo<CameraViewKey, Shown>,
    world_picture: Memo<WorldPictureKey, Arc<WorldPicture>>,
    world_view: Memo<WorldViewKey, Shown>,
    inspection: Memo<(PosedCamera, u64, Selection), Arc<Inspection>>,
    last_good: LastGood,
    /// How many pictures of the camera were traced, which tells one from the next.
    pictures: u64,
    /// How many pictures of the observer were traced.
    world_pictures: u64,
}

/// The scene of the document's objects, remade when one of them changes.
#[derive(Debug)]
struct Objects {
    spheres: Vec<Item<Sphere>>,
    csv_spheres: Option<CsvSpheres>,
    planes: Vec<Item<Plane>>,
    scene: Result<Arc<Scene>, SceneError>,
    colors: Arc<Vec<Rgb>>,
    generation: u64,
}

#[derive(Debug, PartialEq)]
struct CameraViewKey {
    picture: u64,
    posed: PosedCamera,
    size: [u32; 2],
    selection: Selection,
    items: OverlayItems,
    scale: f32,
    style: Style,
}

#[derive(Debug, PartialEq)]
struct WorldPictureKey {
    observer: PosedCamera,
    generation: u64,
    /// Indices of the spheres that would hide the camera.
    enclosing: Vec<usize>,
}

/// The scene as the observer sees it, before anything is drawn over it.
#[derive(Debug)]
struct WorldPicture {
    frame: Arc<Frame>,
    pixels: Vec<Color32>,
}

#[derive(Debug, PartialEq)]
struct WorldViewKey {
    camera: Camera,
    observer: Observer,
    size: [u32; 2],
    picture: Option<u64>,
    generation: u64,
    selection: Selection,
    items: OverlayItems,
    scale: f32,
    style: Style,
}

/// What is shown while the document has a fault.
#[derive(Debug, Default)]
struct LastGood {
    scene: Option<(Arc<Scene>, u64)>,
    picture: Option<Arc<Picture>>,
    camera_view: Option<Shown>,
}

impl Deriver {
    /// How many pictures have been traced so far; an idle window traces none.
    pub fn traced(&self) -> u64 {
        self.pictures + self.world_pictures
    }

    /// Everything to show of this document.
    pub fn derive(&mut self, document: &Document, session: &Session, sizes: &ViewSizes) -> Derived {
        let (scene, colors, generation) = self.scene_of(document);
        let posed = document.camera.posed();
        let fault = match (&posed, &scene) {
            (Err(e), _) => Some(Fault::Camera(*e)),
            (_, Err(e)) => Some(Fault::Scene(*e)),
            _ => None,
        };
        let mut derived = Derived {
            posed: posed.ok(),
            up_angle: document.camera.up_angle().ok(),
            scene: scene.as_ref().ok().cloned(),
            fault,
            ..Derived::default()
        };
        if let Ok(scene) = &scene {
            self.last_good.scene = Some((Arc::clone(scene), generation));
        }
        if let (Some(posed), Ok(scene)) = (derived.posed, &scene) {
            let selection = session.selection.inside(posed.image());
            let inspection = self.inspection.get((posed, generation, selection), |_| {
                Arc::new(match selection {
                    Selection::Pixel(pixel) => Inspection::of_pixel(&posed, scene, pixel),
                    Selection::Uv(uv) => Inspection::of_uv(&posed, scene, uv),
                })
            });
            derived.inspection = Some(inspection);
            self.camera_view(&mut derived, scene, &colors, generation, session, sizes);
        } else {
            derived.camera_view = self.last_good.camera_view.clone();
        }
        self.world_view(&mut derived, document, &colors, session, sizes);
        derived
    }

    fn scene_of(
        &mut self,
        document: &Document,
    ) -> (Result<Arc<Scene>, SceneError>, Arc<Vec<Rgb>>, u64) {
        let known = self.objects.as_ref().filter(|known| {
            known.spheres == document.spheres
                && known.csv_spheres == document.csv_spheres
                && known.planes == document.planes
        });
        if known.is_none() {
            let generation = self.objects.as_ref().map_or(0, |objects| objects.generation + 1);
            let colors = (0..document.object_count() as u32).map(|i| document.color_of(i));
            self.objects = Some(Objects {
                spheres: document.spheres.clone(),
                csv_spheres: document.csv_spheres.clone(),
                planes: document.planes.clone(),
                scene: document.scene().map(Arc::new),
                colors: Arc::new(colors.collect()),
                generation,
            });
        }
        match &self.objects {
            Some(objects) => {
                (objects.scene.clone(), Arc::clone(&objects.colors), objects.generation)
            }
            None => (Ok(Arc::default()), Arc::default(), 0),
        }
    }

    fn camera_view(
        &mut self,
        derived: &mut Derived,
        scene: &Scene,
        colors: &[Rgb],
        generation: u64,
        session: &Session,
        sizes: &ViewSizes,
    ) {
        let Some(posed) = derived.posed else { return };
        // With only the world view open, its viewport still shows the picture.
        let size = sizes.camera.or(sizes.world).unwrap_or([1, 1]);
        let raster = Raster::shown_on(posed.image(), size[0], size[1]);
        let mode = Shade::from(session.settings.shade);
        let pictures = &mut self.pictures;
        let picture = self.camera_picture.get((posed, generation, raster, mode), |key| {
            *pictures += 1;
            let frame = trace(scene, &posed, &key.2, Outputs::default());
            let pixels = shade(&frame, scene, mode, |i| colors[i as usize], opaque);
            Arc::new(Picture { raster: key.2.clone(), image: posed.image(), pixels })
        });
        self.last_good.picture = Some(Arc::clone(&picture));
        let Some(size) = sizes.camera else { return };
        let key = CameraViewKey {
            picture: *pictures,
            posed,
            size,
            selection: session.selection.inside(posed.image()),
            items: session.settings.items,
            scale: sizes.scale,
            style: sizes.style,
        };
        let inspection = derived.inspection.as_deref();
        let shown = self.camera_view.get(key, |key| {
            let mut pixels = blank(size);
            let view = CameraView {
                picture: &picture,
                posed: &posed,
                inspection,
                items: key.items,
                size: size.map(|n| n as usize),
                scale: key.scale,
                style: key.style,
            };
            let labels = overlay::camera(&view, &mut pixels);
            shown(size, pixels, labels)
        });
        self.last_good.camera_view = Some(shown.clone());
        derived.camera_view = Some(shown);
    }

    fn world_view(
        &mut self,
        derived: &mut Derived,
        document: &Document,
        colors: &[Rgb],
        session: &Session,
        sizes: &ViewSizes,
    ) {
        let (Some(size), Some((scene, generation))) = (sizes.world, self.last_good.scene.clone())
        else {
            return;
        };
        let Some(observer) = session.observer else { return };
        let Some(observer_camera) = posed_observer(&observer, size) else { return };
        // While an object is at fault, the last good scene's indices still fit its own colours.
        let color_of = |i: u32| colors.get(i as usize).copied().unwrap_or_default();
        let world =
            self.world_picture(&scene, document.camera.eye, observer_camera, generation, color_of);
        let key = WorldViewKey {
            camera: document.camera,
            observer,
            size,
            picture: derived.posed.is_some().then_some(self.pictures),
            generation,
            selection: session.selection,
            items: session.settings.items,
            scale: sizes.scale,
            style: sizes.style,
        };
        let picture = self.last_good.picture.as_ref().filter(|_| derived.fault.is_none());
        let posed = derived.posed;
        let inspection = derived.inspection.as_deref();
        let shown = self.world_view.get(key, |key| {
            let mut pixels = world.pixels.clone();
            let view = WorldView {
                camera: &document.camera,
                posed: posed.as_ref(),
                picture: picture.map(|picture| &**picture),
                inspection,
                scene: &scene,
                color_of: &color_of,
                observer: &observer,
                frame: &world.frame,
                items: key.items,
                scale: key.scale,
                style: key.style,
            };
            let labels = overlay::world(&view, &mut pixels);
            shown(size, pixels, labels)
        });
        derived.world_frame = Some(Arc::clone(&world.frame));
        derived.world_view = Some(shown);
    }

    fn world_picture(
        &mut self,
        scene: &Scene,
        eye: DVec3,
        observer: PosedCamera,
        generation: u64,
        color_of: impl Fn(u32) -> Rgb + Sync,
    ) -> Arc<WorldPicture> {
        let encloses = |sphere: &Sphere| encloses(sphere, eye, observer.eye());
        let enclosing =
            (scene.spheres().iter().enumerate()).filter_map(|(i, s)| encloses(s).then_some(i));
        let key = WorldPictureKey { observer, generation, enclosing: enclosing.collect() };
        let world_pictures = &mut self.world_pictures;
        self.world_picture.get(key, |_| {
            *world_pictures += 1;
            let seen = seen_scene(scene, eye, observer.eye());
            let raster = Raster::full(observer.image());
            let frame = trace(&seen, &observer, &raster, Outputs::default());
            let pixels = shade(&frame, &seen, Shade::Lambert, color_of, opaque);
            Arc::new(WorldPicture { frame: Arc::new(frame), pixels })
        })
    }
}

/// The observer's camera for a view of this size.
pub fn posed_observer(observer: &Observer, size: [u32; 2]) -> Option<PosedCamera> {
    let clamp = |n: u32| n.clamp(1, ImageSize::MAX);
    observer.camera(clamp(size[0]), clamp(size[1])).posed().ok()
}

fn opaque([r, g, b]: Rgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn blank([width, height]: [u32; 2]) -> Vec<Color32> {
    vec![Color32::BLACK; width as usize * height as usize]
}

fn shown(size: [u32; 2], pixels: Vec<Color32>, labels: Vec<Label>) -> Shown {
    let size = size.map(|n| n as usize);
    Shown { image: Arc::new(ColorImage::new(size, pixels)), labels: Arc::new(labels) }
}
