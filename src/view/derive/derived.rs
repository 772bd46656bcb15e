//! The derived values: everything that one frame shows.

use std::sync::Arc;

use egui::ColorImage;
use pinhole_core::{Counts, Frame, ResolvedCamera, Scene, Steps, UpAngle};
use pinhole_exchange::document::Document;
use pinhole_lecture::mistakes::ComparedCamera;

use super::grading::Grading;
use super::picture::{Compared, TooMany};
use super::watch::Watch;
use crate::model::fault::Fault;
use crate::model::inspection::Inspection;
use crate::model::practice::twin::Twin;
use crate::model::session::Session;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::derivation::Derivation;
use crate::view::ghost::AgainstGhost;
use crate::view::overlay::{Drawing, Label, Mark, Style, Target};
use crate::view::plot::Plot;

/// The inputs of a derivation.
#[derive(Clone, Copy)]
pub(super) struct Inputs<'a> {
    pub(super) document: &'a Document,
    pub(super) session: &'a Session,
    pub(super) sizes: &'a ViewSizes,
    pub(super) watch: Watch<'a>,
}

/// Sizes of the views in physical pixels (`None` for views that are not shown), and other view
/// settings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewSizes {
    /// Width and height of the world view.
    pub world: Option<[u32; 2]>,
    /// Width and height of the picture in the camera view.
    pub camera: Option<[u32; 2]>,
    /// Width and height of the error map.
    pub map: Option<[u32; 2]>,
    /// Width and height of the wrong camera's picture.
    pub wrong: Option<[u32; 2]>,
    /// Width and height of the ghost's picture.
    pub ghost: Option<[u32; 2]>,
    /// Width and height of the map of a student's wrong answers.
    pub answers: Option<[u32; 2]>,
    /// Physical pixels per point.
    pub scale: f32,
    /// Colours of the world view.
    pub style: Style,
    /// The purpose of the pictures.
    pub purpose: Purpose,
    /// The subsampling of new pictures of the scene.
    pub subsampling: Subsampling,
    /// True if something is being dragged: slow work that can wait is put off.
    pub under_hand: bool,
}

/// The purpose of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    /// A view of the window: marks are painted into the picture.
    #[default]
    Window,
    /// A figure: marks stay apart from the picture.
    Figure {
        /// True if the picture is transparent where no ray hits anything.
        clear: bool,
    },
}

impl Purpose {
    /// Returns true if pictures are transparent where no ray hits anything.
    pub(super) fn is_clear(self) -> bool {
        self == Purpose::Figure { clear: true }
    }
}

/// Everything that one frame shows. Panels, views and readouts read it and cannot write to it, so
/// all of them show the same frame.
#[derive(Clone, Debug, Default)]
pub struct Derived {
    /// The camera with its basis.
    pub resolved: Option<ResolvedCamera>,
    /// The angle between up and the view direction.
    pub up_angle: Option<UpAngle>,
    /// The selected ray.
    pub inspection: Option<Arc<Inspection>>,
    /// The scene, if all objects are valid.
    pub scene: Option<Arc<Scene>>,
    /// The reason why the pictures are older than the document, if they are.
    pub fault: Option<Fault>,
    /// The camera view.
    pub camera_view: Option<Shown>,
    /// The world view: the scene with the camera in it.
    pub world_view: Option<Shown>,
    /// Number of decisions at each step of the ladder for the camera's picture.
    pub steps: Option<Steps>,
    /// Counts of the objects that the camera's picture dropped and looked at.
    pub counts: Option<Counts>,
    /// The subsampling of the camera's and of the observer's picture.
    pub subsampling: [Subsampling; 2],
    /// The reason why only the ladder drew the scene, if another method should have.
    pub too_many: Option<TooMany>,
    /// The ladder's answer for the shown pixels, if another method is compared with it.
    pub truth: Option<Arc<Frame>>,
    /// The method that drew the camera's picture, if it was not the ladder.
    pub drawn_by: Option<Arc<Compared>>,
    /// The method of the error map, and its errors.
    pub compared: Option<Arc<Compared>>,
    /// The error map.
    pub error_map: Option<Shown>,
    /// The derivation of all numbers, if the layout shows it.
    pub derivation: Option<Arc<Derivation>>,
    /// The functions f(p + t d) of all objects, if the layout shows them.
    pub plot: Option<Plot>,
    /// The wrong camera beside the right one, or the reason why there is none.
    pub wrong: Option<Arc<ComparedCamera>>,
    /// The wrong camera's picture.
    pub wrong_view: Option<Shown>,
    /// The ghost, with the camera's image.
    pub ghost: Option<ResolvedCamera>,
    /// The camera compared with the ghost, if the layout shows it.
    pub against_ghost: Option<Arc<AgainstGhost>>,
    /// The ghost's picture, or the map of differences.
    pub ghost_view: Option<Shown>,
    /// The grade of a student's answers, if the layout shows it, or the reason why they cannot be
    /// graded; `None` if there are no answers, or nothing to grade them by.
    pub answers: Option<Grading>,
    /// The map of the wrong answers in the image.
    pub answers_view: Option<Shown>,
    /// The answers that the world view draws, a student's beside the right ones.
    pub twins: Arc<[Twin]>,
    /// The observer's traced frame in the world view.
    pub world_frame: Option<Arc<Frame<f32>>>,
}

/// A finished view: pixels to present and labels to write on them.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The pixels, at physical resolution.
    pub image: Arc<ColorImage>,
    /// The labels, in physical pixels of the image.
    pub labels: Arc<Vec<Label>>,
    /// The regions that can be hovered, in physical pixels of the image.
    pub targets: Arc<Vec<Target>>,
    /// The marks painted over the image, or to be painted by a figure.
    pub marks: Arc<Vec<Mark>>,
}

impl Shown {
    /// Creates a view of `size` pixels from its pixels and its overlay.
    pub(super) fn new(size: [u32; 2], pixels: Vec<egui::Color32>, drawing: Drawing) -> Shown {
        let size = size.map(|n| n as usize);
        Shown {
            image: Arc::new(ColorImage::new(size, pixels)),
            targets: Arc::new(drawing.targets()),
            labels: Arc::new(drawing.labels),
            marks: Arc::new(drawing.marks),
        }
    }
}
