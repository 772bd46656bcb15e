//! Grading of a student's answers against the document, and the map of the wrong ones.

use std::sync::Arc;

use pinhole_core::{Camera, ImageSize, Raster};
use pinhole_exchange::answers;
use pinhole_exchange::document::Document;
use pinhole_lecture::grading::{Cell, Graded, Truth, grade};

use super::beside::BesideView;
use super::derived::Inputs;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::picture::GoodPicture;
use super::{Derived, opaque};
use crate::model::practice::student_answers::StudentAnswers;
use crate::view::overlay::Picture;

/// The inputs of a grade: the camera, the objects and their colours by number, and the answers.
type Key = (Camera, u64, u64, StudentAnswers);

/// A grade, or the reason why there is none.
pub type Grading = Result<Arc<Graded>, Arc<str>>;

/// A cache of the grade and its map.
#[derive(Debug, Default)]
pub(super) struct GradedAnswers {
    graded: Memo<Key, Grading>,
    view: BesideView,
    /// Number of gradings so far, which distinguishes one grade from the next.
    count: u64,
}

impl GradedAnswers {
    /// Grades again if something changed and the layout shows it. A grade never belongs to an older
    /// document: while the document has a fault, this is not called and there is no grade. During a
    /// drag there is no new grade, either.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        (good, world): (&GoodPicture, &GoodWorld),
    ) {
        let Inputs { document, session, sizes, .. } = inputs;
        let (Some(size), Some(at_hand)) = (sizes.answers, &session.answers) else { return };
        let key = (document.camera, world.generation, world.palette, at_hand.clone());
        // Grading traces many variants of the student's program, so it waits until the drag rests.
        if sizes.under_hand && self.graded.known(|known| *known == key).is_none() {
            return;
        }
        let count = &mut self.count;
        let graded = self.graded.get(key, |(camera, _, _, at_hand)| {
            *count += 1;
            graded(document, camera, world, at_hand)
        });
        if let Ok(graded) = &graded {
            let number = ((self.count, false), size);
            let camera = (&good.resolved, &*good.inspection, good.selection);
            let items = session.settings.items;
            derived.answers_view =
                self.view.get(inputs, number, camera, items, || picture(graded, size));
        }
        derived.answers = Some(graded);
    }
}

fn graded(
    document: &Document,
    camera: &Camera,
    world: &GoodWorld,
    at_hand: &StudentAnswers,
) -> Grading {
    let StudentAnswers { file, count_from } = at_hand;
    let answers = answers::parse(&file.path, &file.bytes, camera.image, *count_from)
        .map_err(|error| Arc::from(error.to_string()))?;
    // The document's colours, even if the window shows others.
    let color_of = |object| document.color_of(object);
    let truth = Truth { camera, scene: &world.scene, color_of: &color_of };
    let grade = grade(&truth, &answers, None).map_err(|error| Arc::from(error.to_string()))?;
    Ok(Arc::new(Graded { answers, grade, image: camera.image, count_from: *count_from }))
}

/// Returns the map as a picture with as many pixels as are shown. A pixel that stands for several
/// is wrong if one of them is.
fn picture(graded: &Graded, size: [u32; 2]) -> Option<Picture> {
    let cells = graded.map()?;
    let image: ImageSize = graded.image;
    let raster = Raster::shown_on(image, size[0], size[1]);
    let [rows, columns] = raster.nearest(image);
    let width = raster.columns().len();
    let mut worst = vec![Cell::Unanswered; raster.len()];
    for (index, cell) in cells.into_iter().enumerate() {
        let (row, column) = (index / image.width() as usize, index % image.width() as usize);
        let known = &mut worst[rows[row] * width + columns[column]];
        *known = (*known).max(cell);
    }
    let pixels = worst.into_iter().map(|cell| opaque(cell.color())).collect();
    Some(Picture { pixels, image, raster })
}
