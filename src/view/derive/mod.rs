//! Derivation of everything shown from the document: a pure function, with caches keyed by its
//! inputs, so that an idle window does no work and a drag recomputes only what it changes.

mod answer_marks;
mod buffers;
mod camera_views;
mod derivations;
mod derived;
mod key_light;
mod memo;
mod objects;
mod picture;
mod plots;
mod scan;
mod second_picture;
mod watch;
mod world;
mod world_views;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::Rgb;

use self::camera_views::CameraViews;
use self::derivations::Derivations;
use self::derived::Inputs;
pub use self::derived::{Derived, Purpose, Shown, ViewSizes};
use self::objects::Objects;
pub use self::picture::{Compared, MOST_QUESTIONS, TooMany};
use self::picture::{GoodPicture, Pictures};
use self::plots::Plots;
use self::second_picture::SecondPictures;
pub use self::second_picture::{AgainstGhost, Grading, Second, SecondData, SecondPicture};
pub use self::watch::{Watch, Work};
use self::world_views::WorldViews;
use crate::model::concept::Concept;
use crate::model::fault::Fault;
use crate::model::session::{Session, ViewLayout};
use pinhole_exchange::document::Document;

/// Computes [`Derived`] values, each from its arguments alone; its caches only save work.
#[derive(Debug, Default)]
pub struct Deriver {
    objects: Objects,
    pictures: Pictures,
    camera_views: CameraViews,
    world_views: WorldViews,
    derivations: Derivations,
    plots: Plots,
    second: SecondPictures,
    /// The camera's picture from before the document got a fault.
    last_good: Option<GoodPicture>,
}

impl Deriver {
    /// Returns the number of pictures traced so far; an idle window traces none.
    pub fn traced(&self) -> u64 {
        self.pictures.traced + self.world_views.pictures.traced + self.second.count
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
        if let Some(good) = &self.last_good {
            good.tell(&mut derived);
        }
        let world = self.objects.good().filter(|_| derived.fault.is_none());
        let exercises = &inputs.session.exercises;
        if inputs.session.settings.layout == ViewLayout::Exercises && inputs.sizes.world.is_some() {
            derived.answer_marks = exercises.answer_marks().into();
        }
        if let Some(good) = &self.last_good {
            self.second.update(&mut derived, inputs, good, world);
        }
        let generation = self.objects.good().map_or(0, |good| good.generation);
        self.views(&mut derived, inputs, generation);
        derived
    }

    /// Derives the views, the derivation and the plot, side by side: none reads another.
    fn views(&mut self, derived: &mut Derived, inputs: Inputs<'_>, generation: u64) {
        let Deriver { camera_views, world_views, derivations, plots, objects, .. } = self;
        let good = self.last_good.as_ref().map(|good| (good, self.pictures.made));
        let seen = &*derived;
        let (world, (camera_view, (derivation, plot))) = rayon::join(
            || world_views.get(seen, inputs, objects, good),
            || {
                rayon::join(
                    || camera_views.get(seen, inputs, good?),
                    || (derivations.get(inputs, seen), plots.get(inputs, seen, generation)),
                )
            },
        );
        derived.camera_view = camera_view;
        (derived.derivation, derived.plot) = (derivation, plot);
        if let Some(world) = world {
            derived.subsampling[1] = world.subsampling;
            (derived.world_frame, derived.world_view) = (Some(world.frame), Some(world.view));
        }
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
