//! The derived values: everything that one frame shows.

use std::sync::Arc;

use egui::ColorImage;
use pinhole_core::{Counts, Frame, ResolvedCamera, Scene, Steps, UpAngle};
use pinhole_exchange::document::Document;

use super::picture::{Compared, TooMany};
use super::second_picture::{Second, SecondPicture};
use super::watch::Watch;
use crate::model::fault::Fault;
use crate::model::inspection::Inspection;
use crate::model::practice::answer_marks::AnswerMark;
use crate::model::session::Session;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::derivation::Derivation;
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
    /// The second picture, with its width and height.
    pub second: Option<(SecondPicture, [u32; 2])>,
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
    /// The derivation of all numbers, if the layout shows it.
    pub derivation: Option<Arc<Derivation>>,
    /// The functions f(p + t d) of all objects, if the layout shows them.
    pub plot: Option<Plot>,
    /// The second picture, if the page has one.
    pub second: Option<Second>,
    /// The answers that the world view draws: a student's, and the right ones.
    pub answer_marks: Arc<[AnswerMark]>,
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
