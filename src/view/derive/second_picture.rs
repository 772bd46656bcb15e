//! The second picture, shown next to the camera's picture: an error map, the picture of a wrong camera or
//! of the ghost (a frozen camera), or a map of a student's right and wrong answers. The world view draws
//! that camera and its ray.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{
    Camera, CameraDifference, NO_OBJECT, Outputs, Paint, Raster, ResolvedCamera, Scene, Selection,
};
use pinhole_exchange::{Document, answers};
use pinhole_figure::overlay::{self, CameraView, GhostCamera, Picture, Same};
use pinhole_figure::{AnswerMark, Inspection, Item, MarkShape};
use pinhole_lecture::grading::{Cell, Graded, Truth, grade};
use pinhole_lecture::mistakes::{
    ComparedCamera, ComparedPicture, ComparedPixels, Mistake, WrongCamera,
};

use crate::features::accuracy::comparison::mark_wrong;
use crate::features::answers::StudentAnswers;
use crate::model::session::{ViewLayout, resolve};
use crate::view::derive::{
    Derived, GoodPicture, GoodWorld, Inputs, LastView, Memo, WorkKind, camera_view, highlighted,
    opaque, trace_picture, watched,
};

pinhole_core::texts! {
    /// The kind of a second picture.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum SecondPicture[1];
    {
        /// Returns the picture's name, on the screen and for screen readers.
        name,
    }
    /// The map of the errors of another method.
    ErrorMap: "Error map";
    /// The picture of a camera with a classic mistake, or a map of the pixels in which it differs from the
    /// right one.
    WrongCamera: "Wrong camera";
    /// The picture of the ghost (the frozen camera), or a map of the pixels in which it differs from the
    /// edited camera's.
    Ghost: "Ghost";
    /// The map of a student's right and wrong answers.
    Answers: "Answers";
}

/// The edited camera compared with the ghost (the frozen camera).
#[derive(Clone, Debug, PartialEq)]
pub struct AgainstGhost {
    /// The ghost, with the image size of the edited camera, so that the pictures can be compared pixel by
    /// pixel.
    pub ghost: ResolvedCamera,
    /// The change from the ghost to the edited camera.
    pub difference: CameraDifference,
    /// The number of compared pixels, and in how many of them the two cameras see different objects.
    pub seen: ComparedPixels,
    /// The ghost's ray through the selected position.
    pub inspection: Arc<Inspection>,
    /// The ghost's picture, and the map of the pixels in which the edited camera's differs from it.
    pub pictures: [Arc<Picture>; 2],
}

/// A grade, or the reason why there is none.
pub type Grading = Result<Arc<Graded>, Arc<str>>;

/// The inputs of the pictures of another camera, which is compared with the edited one.
#[derive(Clone, Debug, PartialEq)]
struct OtherKey<O> {
    /// The edited camera.
    camera: Camera,
    /// The edited camera's picture: another scene or shading has another one.
    picture: Same<Picture>,
    /// What makes the other camera.
    other: O,
}

/// The inputs of the map of a student's answers: the graded answers, and the map's size in screen pixels.
type MapKey = (Same<Graded>, [u32; 2]);

/// The picture of another camera, and the map of the pixels in which it differs from the edited camera's
/// picture.
type Pair = [Arc<Picture>; 2];

/// A cache of the second pictures: the last picture of each kind, and the finished view of the current one.
#[derive(Debug, Default)]
pub(super) struct SecondPictures {
    wrong_camera: Memo<OtherKey<Mistake>, (Arc<ComparedCamera>, Option<Pair>)>,
    /// The other camera is the ghost, with the selected ray.
    ghost: Memo<OtherKey<(Camera, Selection)>, Option<Arc<AgainstGhost>>>,
    grading: Memo<(Document, StudentAnswers), Grading>,
    answers_map: Memo<MapKey, Option<Arc<Picture>>>,
    view: LastView<CameraView>,
    /// Number of pictures made so far.
    pub(super) count: u64,
}

impl SecondPictures {
    /// Updates the second picture and the data that belongs to it, if the page has one. `world` is `None`
    /// while the document is invalid.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: Option<&GoodWorld>,
    ) {
        let Inputs { sizes, watch, .. } = inputs;
        let Some((kind, size)) = sizes.second else { return };
        let mut view = CameraView { without_marks: false, ..camera_view(inputs, good, size) };
        let picture = match (kind, world) {
            (SecondPicture::ErrorMap, _) => {
                // The highlighted concept belongs to the current document, so it is not shown in an older
                // picture.
                view.highlighted = highlighted(inputs).filter(|_| world.is_some());
                derived.compared = good.compared.clone().and_then(Result::ok);
                derived.compared.as_ref().map(|compared| Arc::clone(&compared.picture))
            }
            (SecondPicture::WrongCamera, _) => {
                // These items show positions of the right camera, which would be wrong in the wrong
                // camera's picture.
                let of_right = [Item::UvAxes, Item::Hit, Item::UvLegs, Item::PixelNumbers];
                of_right.into_iter().for_each(|item| view.items.set(item, false));
                self.wrong_camera(derived, inputs, good, world)
            }
            (_, None) => None,
            (SecondPicture::Ghost, Some(world)) => {
                self.ghost(derived, inputs, good, world, &mut view)
            }
            (SecondPicture::Answers, Some(world)) => self.answers(derived, inputs, world),
        };
        let Some(picture) = picture else { return };
        view.picture = Same(picture);
        let (scene, compared) = (world.map(|world| &*world.scene), derived.compared.as_ref());
        let draw = |view: &CameraView, pixels: &mut [Color32]| {
            let drawing = overlay::camera(view, scene, pixels);
            if let Some(compared) = compared {
                let (raster, width) = (&view.picture.raster, size[0] as usize);
                mark_wrong(&compared.comparison, raster, width, sizes.scale, pixels);
            }
            drawing
        };
        derived.second_view = Some(self.view.get(view, size, sizes.style, watch, draw));
    }

    fn wrong_camera(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: Option<&GoodWorld>,
    ) -> Option<Arc<Picture>> {
        let (shown, camera) = (&inputs.session.shown, inputs.document.camera);
        let mistake = shown.mistakes_view.shown();
        let (wrong, pictures) = match world {
            // An older picture is shown only if it is of the same mistake.
            None => self.wrong_camera.known(|key| key.other == mistake)?.clone(),
            Some(world) => {
                let picture = Same(Arc::clone(&good.picture));
                let key = OtherKey { camera, picture, other: mistake };
                self.wrong_camera.get(key, |OtherKey { picture: beside, .. }| {
                    self.count += 1;
                    watched(inputs.watch, WorkKind::Trace, || {
                        let color_of = |i: u32| world.colors[i as usize];
                        let paint = Paint { shade: shown.setup.shade, color_of, to_pixel: opaque };
                        let (now, scene, raster) = (&good.resolved, &world.scene, &beside.raster);
                        let (wrong, compared) =
                            ComparedCamera::new(&camera, now, scene, mistake, raster, paint);
                        let pair = compared.map(|ComparedPicture { pixels, wrong, right }| {
                            pair(beside, pixels, [&wrong, &right])
                        });
                        (Arc::new(wrong), pair)
                    })
                })
            }
        };
        // The mark would give away the answer to a step's question or an open vote.
        let is_secret = shown.is_asking || !shown.mistakes_view.is_revealed();
        if let (Some(world), Ok(camera), false) = (world, &wrong.camera, is_secret) {
            let marks = of_mistake(camera, &world.scene, inputs.session.shown_selection());
            derived.answer_marks = marks.into();
        }
        derived.wrong_camera = Some(wrong);
        let [picture, differences] = pictures?;
        Some(if shown.mistakes_view.shows_differences() { differences } else { picture })
    }

    fn ghost(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: &GoodWorld,
        view: &mut CameraView,
    ) -> Option<Arc<Picture>> {
        let (shown, camera) = (&inputs.session.shown, inputs.document.camera);
        let ghost = shown.ghost.as_ref()?;
        let (picture, other) = (Same(Arc::clone(&good.picture)), (ghost.camera, shown.selection));
        let key = OtherKey { camera, picture, other };
        let against = self.ghost.get(key, |key| {
            self.count += 1;
            let OtherKey { picture: beside, other: (ghost, selection), .. } = key;
            // There is no picture if the ghost has no basis.
            let resolved = resolve(ghost, &camera).ok()?;
            let colors = (shown.setup.shade, |i: u32| world.colors[i as usize]);
            let outputs = Outputs { object: true, ..Outputs::NONE };
            let [now, (frame, pixels)] = [&good.resolved, &resolved].map(|camera| {
                let memory = (None, inputs.watch);
                trace_picture(&world.scene, camera, &beside.raster, outputs, colors, memory)
            });
            let objects = [&now.0.object[..], &frame.object];
            let pairs = objects[0].iter().zip(objects[1]);
            let differing = pairs.filter(|(a, b)| a != b).count();
            let selection = selection.inside(resolved.image());
            Some(Arc::new(AgainstGhost {
                ghost: resolved,
                difference: camera.difference_from(ghost).ok()?,
                seen: ComparedPixels { pixels: frame.object.len(), differing },
                inspection: Arc::new(Inspection::new(&resolved, &world.scene, selection)),
                pictures: pair(beside, pixels, objects),
            }))
        })?;
        let shows_hit = view.items.shows(Item::Hit) && !ghost.shows_differences;
        view.items = view.items.with(Item::Hit, shows_hit);
        view.resolved = against.ghost;
        view.inspection = Some(Same(Arc::clone(&against.inspection)));
        let picture = Arc::clone(&against.pictures[usize::from(ghost.shows_differences)]);
        derived.against_ghost = Some(against);
        Some(picture)
    }

    fn answers(
        &mut self,
        derived: &mut Derived,
        Inputs { document, session, sizes, .. }: Inputs<'_>,
        world: &GoodWorld,
    ) -> Option<Arc<Picture>> {
        // Grading uses the document's own colours, even if the window shows others. The scene's note is
        // left out of the key, because it does not affect the grade.
        let document = Document { note: String::new(), ..document.clone() };
        let key = (document, session.answers.clone()?);
        // Grading traces many variants of the student's program, so during a drag it is postponed.
        if sizes.under_hand && self.grading.known(|known| *known == key).is_none() {
            return None;
        }
        let grading = self.grading.get(key, |(document, answers)| {
            self.count += 1;
            graded(document, world, answers)
        });
        derived.grading = Some(grading.clone());
        let key = (Same(grading.ok()?), sizes.second?.1);
        self.answers_map.get(key, |(graded, size)| answers_map(graded, *size).map(Arc::new))
    }
}

/// Returns another camera's picture with these pixels, beside that of the edited camera, and the map of the
/// pixels at which two cameras see different objects.
fn pair(beside: &Picture, pixels: Vec<Color32>, objects: [&[u32]; 2]) -> Pair {
    let Picture { raster, image, .. } = beside;
    [pixels, difference_map(objects)]
        .map(|pixels| Arc::new(Picture { raster: raster.clone(), image: *image, pixels }))
}

/// Returns the map of differences between the pictures of two cameras, given the objects at their pixels.
/// Pixels with the same object are pale, and pixels with different objects are dark.
fn difference_map([now, ghost]: [&[u32]; 2]) -> Vec<Color32> {
    let color = |(now, ghost): (&u32, &u32)| match (now == ghost, *now == NO_OBJECT) {
        (true, true) => Color32::from_gray(0xf0),
        (true, false) => Color32::from_gray(0xc4),
        // In this order: only the edited camera sees an object; only the ghost does; they see different
        // objects.
        (false, _) if *ghost == NO_OBJECT => Color32::from_rgb(0xc8, 0x10, 0x58),
        (false, true) => Color32::from_rgb(0x00, 0x4a, 0x86),
        (false, false) => Color32::from_rgb(0x3a, 0x18, 0x40),
    };
    now.iter().zip(ghost).map(color).collect()
}

fn graded(document: &Document, world: &GoodWorld, answers: &StudentAnswers) -> Grading {
    let StudentAnswers { file, count_from } = answers;
    let camera = &document.camera;
    let answers = answers::parse(&file.path, &file.bytes, camera.image, *count_from)
        .map_err(|error| Arc::from(error.to_string()))?;
    let color_of = |object| document.color_of(object);
    let truth = Truth { camera, scene: &world.scene, color_of: &color_of };
    let grade = grade(&truth, &answers, None).map_err(Arc::from)?;
    Ok(Arc::new(Graded { answers, grade, image: camera.image, count_from: *count_from }))
}

/// Returns the map of right and wrong answers, with as many pixels as the screen shows. A pixel that
/// represents several answers shows the worst of them. Returns `None` if the answers have no map.
fn answers_map(graded: &Graded, [width, height]: [u32; 2]) -> Option<Picture> {
    let cells = graded.map()?;
    let image = graded.image;
    let raster = Raster::shown_on(image, width, height);
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

/// Returns the camera that the world view compares with the edited one: the camera with a mistake, or the
/// ghost (the frozen camera).
pub(super) fn ghost_camera(
    Inputs { document, session, .. }: Inputs<'_>,
    derived: &Derived,
) -> Option<GhostCamera> {
    if session.shows_exercise() {
        return session.exercises.ghost().as_ref().map(GhostCamera::of_answer);
    }
    if session.shown.setup.layout == ViewLayout::Mistakes {
        // Before the reveal, the wrong camera would give away the answer to the class.
        let is_secret = session.shown.is_asking || !session.shown.mistakes_view.is_revealed();
        let is_shown = !is_secret && derived.fault.is_none();
        let wrong = derived.wrong_camera.as_ref().filter(|_| is_shown)?;
        return wrong.camera.as_ref().ok().map(GhostCamera::of_mistake);
    }
    session.frozen_ghost(&document.camera)
}

/// Returns a mark for the wrong camera's ray through the selected pixel; none if there is no such ray.
fn of_mistake(wrong: &WrongCamera, scene: &Scene, selection: Selection) -> Vec<AnswerMark> {
    let ray = match selection.inside(wrong.image()) {
        Selection::Pixel(pixel) => wrong.ray(pixel),
        Selection::Uv(uv) => wrong.ray_at(uv),
    };
    let Ok(ray) = ray else { return Vec::new() };
    let t = scene.first_hit(&ray).map(|hit| hit.t);
    vec![AnswerMark::yours(MarkShape::Ray(ray, t), "ray′")]
}

#[cfg(test)]
mod tests {
    use pinhole_core::{DVec3, ImageSize, Shade, Sphere, shade, trace};
    use pinhole_exchange::document::Item as DocumentItem;
    use pinhole_exchange::images::png;

    use super::*;
    use crate::features::answers::AnswersFile;
    use crate::model::session::Session;
    use crate::view::derive::{Deriver, ViewSizes};
    use pinhole_figure::overlay::Style;

    #[test]
    fn a_grade_follows_a_colour_that_the_scheme_replaces() {
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, -3.0), radius: 1.0 };
        let red = DocumentItem { color: Some([200, 40, 40]), ..DocumentItem::plain(sphere) };
        let image = ImageSize::new(40, 40).expect("a size");
        let camera = Camera { image, ..Camera::CANONICAL };
        let mut document = Document { camera, spheres: vec![red].into(), ..Document::default() };
        let scene = document.scene().expect("a scene");
        let resolved = camera.resolve().expect("a camera");
        let frame = trace(&scene, &resolved, &Raster::full(image), Outputs::default());
        let color_of = |i: u32| document.color_of(i);
        let pixels = shade(&frame, &scene, Shade::Object, color_of, |[r, g, b]| [r, g, b, 255]);
        let mut bytes = Vec::new();
        png::encode(&mut bytes, [40, 40], &pixels, false).expect("a picture");
        let file = Arc::new(AnswersFile { path: "mine.png".into(), bytes, kind: None });
        let answers = Some(StudentAnswers { file, count_from: 0 });
        let session = Session { answers, ..Session::default() };
        let sizes = ViewSizes {
            camera: Some([40, 40]),
            second: Some((SecondPicture::Answers, [40, 40])),
            scale: 1.0,
            style: Style::ColourBlindLight,
            ..ViewSizes::default()
        };
        let mut deriver = Deriver::default();
        let mut is_right = |document: &Document| {
            let grading = deriver.derive(document, &session, &sizes).grading;
            let graded = grading.expect("answers").expect("a grade");
            graded.grade.is_right.iter().all(|is_right| *is_right)
        };
        assert!(is_right(&document));
        document.spheres[0].color = Some([40, 40, 200]);
        assert!(!is_right(&document), "the picture's red is wrong now");
    }
}
