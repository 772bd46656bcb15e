//! What is derived: everything that one frame shows.

use std::fmt;
use std::sync::Arc;

use egui::ColorImage;
use pinhole_core::{CameraError, Counts, Frame, PosedCamera, Scene, SceneError, Steps, UpAngle};
use pinhole_lecture::mistakes::ComparedCamera;

use super::answers::Grading;
use super::picture::{Compared, TooMany};
use crate::coarseness::Coarseness;
use crate::ghost::AgainstGhost;
use crate::inspection::Inspection;
use crate::ledger::Ledger;
use crate::overlay::{Drawing, Label, Mark, Style, Target};
use crate::plot::Plot;

/// How large the views are, in physical pixels; `None` where one is not shown.
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
    /// Width and height of the map of where a student's answers are wrong.
    pub answers: Option<[u32; 2]>,
    /// Physical pixels per point.
    pub scale: f32,
    /// Colours of the world view.
    pub style: Style,
    /// What the pictures are for.
    pub purpose: Purpose,
    /// How much is left out of new pictures of the scene.
    pub coarseness: Coarseness,
    /// A hand moves what is seen: what takes long and can wait does.
    pub under_hand: bool,
}

/// What pictures are for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    /// The window: marks are painted into them.
    #[default]
    Window,
    /// A figure: marks stay apart from them.
    Figure {
        /// Where no ray meets anything, they are transparent.
        clear: bool,
    },
}

impl Purpose {
    /// Whether pictures are transparent where no ray meets anything.
    pub(super) fn is_clear(self) -> bool {
        self == Purpose::Figure { clear: true }
    }
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
    /// How far up the ladder the camera's picture had to go.
    pub steps: Option<Steps>,
    /// What the camera's picture left out, and what was left to do.
    pub counts: Option<Counts>,
    /// How much was left out of the camera's and the observer's picture.
    pub coarseness: [Coarseness; 2],
    /// Why no other method than the ladder was let at the scene, where one should have been.
    pub too_many: Option<TooMany>,
    /// The ladder's answer for the pixels that are shown, where another method stands beside it.
    pub truth: Option<Arc<Frame>>,
    /// What drew the camera's picture, where the ladder did not.
    pub drawn_by: Option<Arc<Compared>>,
    /// The method of the error map, and where it errs.
    pub compared: Option<Arc<Compared>>,
    /// The error map.
    pub error_map: Option<Shown>,
    /// How every number comes about, where the layout shows it.
    pub ledger: Option<Arc<Ledger>>,
    /// Every object's f(p + t d), where the layout shows it.
    pub plot: Option<Plot>,
    /// The wrong camera beside the right one, or why there is none.
    pub wrong: Option<Arc<ComparedCamera>>,
    /// What it sees.
    pub wrong_view: Option<Shown>,
    /// The ghost, with the image that the camera has.
    pub ghost: Option<PosedCamera>,
    /// The camera against the ghost, where the layout shows it.
    pub against_ghost: Option<Arc<AgainstGhost>>,
    /// What the ghost sees, or where that differs.
    pub ghost_view: Option<Shown>,
    /// A student's answers graded, where the layout shows it, or why they cannot be; `None` where
    /// there are none, or nothing to grade by.
    pub answers: Option<Grading>,
    /// Where in the image they are wrong.
    pub answers_view: Option<Shown>,
    /// What the observer sees where in the world view.
    pub world_frame: Option<Arc<Frame<f32>>>,
}

/// A finished view: pixels to present and labels to write on them.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The pixels, at physical resolution.
    pub image: Arc<ColorImage>,
    /// Text, in physical pixels of the image.
    pub labels: Arc<Vec<Label>>,
    /// What can be pointed at, in physical pixels of the image.
    pub targets: Arc<Vec<Target>>,
    /// What is painted over the image, or is to be where that is left to a figure.
    pub marks: Arc<Vec<Mark>>,
}

impl Shown {
    /// A view of so many columns and rows, with what is drawn over it.
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
