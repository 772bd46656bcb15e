//! Derives everything that the window shows from the document. The derivation is a pure function with
//! caches keyed by its inputs, so an idle window does no work and a drag recomputes only what it
//! changes.

use std::sync::Arc;

use egui::ColorImage;
use pinhole_core::{Counts, Ellipse, Frame, ResolvedCamera, Scene, Steps, UpAngle};
use pinhole_exchange::document::Document;
use pinhole_figure::derivation::Derivation;
use pinhole_figure::overlay::{self, CameraView, Highlighted, Label, Mark, Style, opaque};
use pinhole_figure::{AnswerMark, Fault, Inspection};
use pinhole_lecture::mistakes::ComparedCamera;

use crate::features::plot::curves::Plot;
use crate::model::Session;
use crate::view::adaptive_resolution::Subsampling;

pub use crate::view::derive::picture::{Compared, MOST_QUESTIONS, OnWork, TooMany, WorkKind};
pub use crate::view::derive::second_picture::{AgainstGhost, Grading, SecondPicture};

mod memo;
mod objects;
mod picture;
mod second_picture;
mod views;

use memo::{LastView, Memo, Spares};
use objects::{Enclosing, GoodWorld, Objects};
use picture::{GoodPicture, Pictures, repainted, trace_picture, watched};
use second_picture::{SecondPictures, ghost_camera};
use views::{LastDerivation, WorldViews, camera_view, derived_lines, plot};

/// Computes [`Derived`] values. The result depends only on the arguments; the caches only save time.
#[derive(Debug, Default)]
pub struct Deriver {
    objects: Objects,
    pictures: Pictures,
    camera_view: LastView<CameraView>,
    world_views: WorldViews,
    derivation: LastDerivation,
    second: SecondPictures,
    /// The camera's last picture from a document without a fault.
    last_good: Option<GoodPicture>,
}

impl Deriver {
    /// Returns the number of pictures traced so far; an idle window traces none.
    pub fn traced(&self) -> u64 {
        self.pictures.traced + self.world_views.pictures.traced + self.second.count
    }

    /// Derives everything that the window shows of a document.
    ///
    /// A caller may keep [`Derived::scene`], but the next edit of an object must then copy the whole
    /// scene.
    pub fn derive(&mut self, document: &Document, session: &Session, sizes: &ViewSizes) -> Derived {
        self.derive_watched(document, session, sizes, &|_| ())
    }

    /// Like [`Deriver::derive`], but also reports to `watch` which kind of work was just finished.
    pub fn derive_watched(
        &mut self,
        document: &Document,
        session: &Session,
        sizes: &ViewSizes,
        watch: OnWork<'_>,
    ) -> Derived {
        let inputs = Inputs { document, session, sizes, watch };
        // Runs on one of rayon's threads: from another thread, each parallel step would have to wake those
        // threads and wait for them.
        rayon::join(|| self.derived(inputs), || ()).0
    }

    fn derived(&mut self, inputs: Inputs<'_>) -> Derived {
        let camera = &inputs.document.camera;
        let updated = self.objects.update(inputs.document, inputs.sizes.style.scheme());
        let world = self.objects.good().filter(|_| updated.is_ok());
        let resolved = camera.resolve();
        let fault = match (&resolved, updated) {
            (Err(e), _) => Some(Fault::Camera(*e)),
            (_, Err(e)) => Some(Fault::Scene(e)),
            _ => None,
        };
        let mut derived = Derived {
            resolved: resolved.ok(),
            up_angle: camera.up_angle().ok(),
            scene: world.map(|world| Arc::clone(&world.scene)),
            fault,
            ..Derived::default()
        };
        if let (Some(resolved), Some(world)) = (derived.resolved, world) {
            let good = self.pictures.get(inputs, resolved, world);
            derived.inspection = Some(Arc::clone(&good.inspection));
            self.last_good = Some(good);
        }
        if inputs.session.shows_exercise() {
            derived.answer_marks = inputs.session.exercises.answer_marks().into();
        }
        if let Some(good) = &self.last_good {
            (derived.steps, derived.counts) = (Some(good.steps), Some(good.counts));
            derived.subsampling[0] = good.subsampling;
            derived.too_many =
                good.compared.as_ref().and_then(|found| found.as_ref().err().copied());
            let world = world.filter(|_| derived.fault.is_none());
            self.second.update(&mut derived, inputs, good, world);
        }
        self.views(&mut derived, inputs);
        derived
    }

    /// Derives the views, the derivation and the plot in parallel, since they do not depend on each
    /// other.
    fn views(&mut self, derived: &mut Derived, inputs: Inputs<'_>) {
        let Inputs { sizes, watch, .. } = inputs;
        let Deriver { camera_view: last, world_views, derivation, objects, .. } = self;
        let good = self.last_good.as_ref();
        let partial = &*derived;
        let (world, (camera, (derivation, plot))) = rayon::join(
            || world_views.get(partial, inputs, objects, good),
            || {
                rayon::join(
                    || {
                        let (size, good) = (sizes.camera?, good?);
                        let view = CameraView {
                            // The highlighted concept belongs to the current document, so it is not shown
                            // in an older picture.
                            highlighted: highlighted(inputs).filter(|_| partial.fault.is_none()),
                            loupe: good.loupe.clone(),
                            ..camera_view(inputs, good, size)
                        };
                        let scene = partial.scene.as_deref();
                        Some(last.get(view, size, sizes.style, watch, |view, pixels| {
                            overlay::camera(view, scene, pixels)
                        }))
                    },
                    || (derived_lines(derivation, inputs, partial), plot(inputs, partial)),
                )
            },
        );
        derived.camera_view = camera;
        (derived.derivation, derived.plot) = (derivation, plot);
        if let Some((world, view)) = world {
            derived.subsampling[1] = world.subsampling;
            derived.world_frame = Some(Arc::clone(&world.frame));
            derived.world_view = Some(view);
        }
    }
}

/// Returns the highlighted concept; `None` if no concept is highlighted.
fn highlighted(Inputs { document, session, .. }: Inputs<'_>) -> Option<Highlighted> {
    // While the pointer is over something else, the figure does not show the lines so far.
    let live = Some(&session.live).filter(|live| live.hovered.is_none());
    let line = live.and_then(|live| live.directed);
    Some(Highlighted {
        concept: session.highlighted()?.in_views(),
        camera: document.camera,
        digits: session.shown.setup.digits,
        dims: session.dims(),
        spoken: line.map(|line| line.spoken).unwrap_or_default(),
        is_of_step: line.is_some_and(|line| line.is_of_step),
        growth: live.and_then(|live| live.growth).unwrap_or(1.0),
    })
}

/// The arguments of [`Deriver::derive_watched`].
#[derive(Clone, Copy)]
struct Inputs<'a> {
    document: &'a Document,
    session: &'a Session,
    sizes: &'a ViewSizes,
    watch: OnWork<'a>,
}

/// The sizes of the views in physical pixels, and other settings of the views. A view that is not shown has
/// the size `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewSizes {
    /// Width and height of the world view.
    pub world: Option<[u32; 2]>,
    /// Width and height of the picture in the camera view.
    pub camera: Option<[u32; 2]>,
    /// The second picture, with its width and height.
    pub second: Option<(SecondPicture, [u32; 2])>,
    /// Physical pixels per point.
    pub scale: f32,
    /// Colours of the world view.
    pub style: Style,
    /// Whether the pictures are for the window or for a figure.
    pub purpose: Purpose,
    /// The rectangles of the world view, in physical pixels, that other content covers; see
    /// [`WorldView::covered`](pinhole_figure::overlay::WorldView).
    pub covered: [Option<[f32; 4]>; 4],
    /// The subsampling of new pictures of the scene.
    pub subsampling: Subsampling,
    /// True if the user is dragging something. Slow work is then postponed if possible.
    pub under_hand: bool,
}

/// The purpose of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    /// A view in the window. The marks are painted into the picture.
    #[default]
    Window,
    /// A figure. The marks stay separate from the picture.
    Figure {
        /// True if the picture is transparent where no ray hits anything.
        clear: bool,
    },
}

impl Purpose {
    /// Returns true if pictures are transparent where no ray hits anything.
    fn is_clear(self) -> bool {
        self == Purpose::Figure { clear: true }
    }
}

/// Everything that one frame shows. Panels, views and readouts all read from this value, so they agree with
/// each other.
#[derive(Clone, Debug, Default)]
pub struct Derived {
    /// The camera with its basis; `None` if it has no basis.
    pub resolved: Option<ResolvedCamera>,
    /// The angle between up and the view direction; `None` if it is undefined.
    pub up_angle: Option<UpAngle>,
    /// The selected ray and its hits; `None` if there is no ray.
    pub inspection: Option<Arc<Inspection>>,
    /// The scene; `None` if an object is invalid.
    pub scene: Option<Arc<Scene>>,
    /// The fault that prevents a picture of the current document, so that older pictures are shown; `None`
    /// if there is no fault.
    pub fault: Option<Fault>,
    /// The camera view.
    pub camera_view: Option<FinishedView>,
    /// The world view: the scene with the camera in it.
    pub world_view: Option<FinishedView>,
    /// How many intersection decisions for the camera's picture the exact method (the ladder) made at each
    /// of its steps: in `f64`, in double-double, and in exact arithmetic.
    pub steps: Option<Steps>,
    /// How many spheres and rows the renderer skipped in the camera's picture, and how many there are.
    pub counts: Option<Counts>,
    /// The subsampling of the camera's picture and of the observer's picture.
    pub subsampling: [Subsampling; 2],
    /// The reason why there is no error map.
    pub too_many: Option<TooMany>,
    /// The derivation of all numbers, if the layout shows it.
    pub derivation: Option<Arc<Derivation>>,
    /// The curves f(p + t d) of the objects, if the layout shows them.
    pub plot: Option<Plot>,
    /// The second picture, such as an error map, if the page has one and it could be made.
    pub second_view: Option<FinishedView>,
    /// The answers and errors of the method that the error map shows, if the second picture is an error
    /// map.
    pub compared: Option<Arc<Compared>>,
    /// The wrong camera compared with the right one, if the second picture is a wrong camera's.
    pub wrong_camera: Option<Arc<ComparedCamera>>,
    /// The edited camera compared with the ghost (a frozen camera), if the second picture is the ghost's.
    pub against_ghost: Option<Arc<AgainstGhost>>,
    /// The grade of a student's answers; `None` if there are no answers, or no valid scene to grade
    /// them with.
    pub grading: Option<Grading>,
    /// The marks in the world view: answers to an exercise, typed and right ones, or a wrong camera's ray.
    pub answer_marks: Arc<[AnswerMark]>,
    /// The observer's traced frame, over which the world view is drawn.
    pub world_frame: Option<Arc<Frame<f32>>>,
}

/// A finished view: the pixels to show, and the labels to write on them.
#[derive(Clone, Debug)]
pub struct FinishedView {
    /// The pixels, at physical resolution.
    pub image: Arc<ColorImage>,
    /// The labels, in physical pixels of the image.
    pub labels: Arc<Vec<Label>>,
    /// The marks, which are painted into the image or, for a figure, drawn separately. Those with a concept
    /// react to the pointer.
    pub marks: Arc<Vec<Mark>>,
    /// See [`Drawing::spheres`](pinhole_figure::overlay::Drawing).
    pub spheres: Arc<Vec<Ellipse>>,
}

impl FinishedView {
    /// Returns true if the picture shows nothing but its background.
    pub fn is_empty(&self) -> bool {
        let pixels = &self.image.pixels;
        pixels.iter().all(|pixel| *pixel == pixels[0])
    }
}
