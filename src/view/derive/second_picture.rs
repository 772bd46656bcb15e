//! The second picture, next to the camera's. It shows the errors of another method, the picture of a wrong
//! camera or of the ghost, or a student's wrong answers. The world view draws that camera, its ray, and the
//! student's answer together with the right answer.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{
    Camera, CameraDifference, ImageSize, NO_OBJECT, Outputs, Paint, Pixel, Raster, Ray,
    ResolvedCamera, Scene, Selection, Shade,
};
use pinhole_exchange::answers;
use pinhole_exchange::document::Document;
use pinhole_lecture::grading::{Answers, Cell, GivenHit, Graded, Truth, grade};
use pinhole_lecture::mistakes::{
    ComparedCamera, ComparedPicture, ComparedPixels, Mistake, WrongCamera,
};

use crate::model::inspection::Inspection;
use crate::model::overlay_items::Item;
use crate::model::practice::StudentAnswers;
use crate::model::practice::answer_marks::{AnswerMark, MarkShape};
use crate::model::session::ViewLayout;
use crate::model::session::resolve;
use crate::view::accuracy;
use crate::view::derive::memo::Memo;
use crate::view::derive::objects::GoodWorld;
use crate::view::derive::picture::{
    Compared, GoodPicture, OnWork, WorkKind, trace_picture, watched,
};
use crate::view::derive::{Derived, Inputs, Shown, blank, highlighted, opaque};
use crate::view::overlay::{self, CameraView, GhostCamera, Picture, Same};

/// The kind of a second picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondPicture {
    /// The map of the errors of another method.
    ErrorMap,
    /// The picture of a camera with a classic mistake, or the map of the pixels that differ.
    WrongCamera,
    /// The picture of the ghost, or the map of the pixels that differ.
    Ghost,
    /// The map of a student's right and wrong answers.
    Answers,
}

/// A second picture with the data behind it.
#[derive(Clone, Debug)]
pub struct Second {
    /// The data, or the reason why there is no picture.
    pub data: SecondData,
    /// The picture.
    pub view: Option<Shown>,
}

/// The data behind a second picture.
#[derive(Clone, Debug)]
pub enum SecondData {
    /// The method of the error map, and its errors.
    ErrorMap(Arc<Compared>),
    /// The wrong camera and the right one, or the reason why there is no wrong camera.
    WrongCamera(Arc<ComparedCamera>),
    /// The camera compared with the ghost.
    Ghost(Arc<AgainstGhost>),
    /// The grade of a student's answers.
    Answers(Grading),
}

/// The edited camera compared with the ghost.
#[derive(Clone, Debug, PartialEq)]
pub struct AgainstGhost {
    /// The ghost with the image size of the edited camera, so that the two are compared pixel by pixel.
    pub ghost: ResolvedCamera,
    /// The difference from the ghost to the edited camera.
    pub difference: CameraDifference,
    /// The number of compared pixels, and the number of those pixels in which the cameras see different
    /// objects.
    pub seen: ComparedPixels,
    /// The ghost's ray through the selected position.
    pub inspection: Arc<Inspection>,
}

/// A grade, or the reason why there is none.
pub type Grading = Result<Arc<Graded>, Arc<str>>;

impl Derived {
    /// Returns the second picture.
    pub fn second_view(&self) -> Option<&Shown> {
        self.second.as_ref()?.view.as_ref()
    }

    /// Returns the method of the error map, and its errors.
    pub fn compared(&self) -> Option<&Compared> {
        match &self.second.as_ref()?.data {
            SecondData::ErrorMap(compared) => Some(compared),
            _ => None,
        }
    }

    /// Returns the wrong camera and the right one.
    pub fn wrong_camera(&self) -> Option<&ComparedCamera> {
        match &self.second.as_ref()?.data {
            SecondData::WrongCamera(wrong) => Some(wrong),
            _ => None,
        }
    }

    /// Returns the camera compared with the ghost.
    pub fn against_ghost(&self) -> Option<&AgainstGhost> {
        match &self.second.as_ref()?.data {
            SecondData::Ghost(against) => Some(against),
            _ => None,
        }
    }

    /// Returns the grade of a student's answers; `None` if there are no answers, or no valid scene to
    /// grade them against.
    pub fn grading(&self) -> Option<&Grading> {
        match &self.second.as_ref()?.data {
            SecondData::Answers(grading) => Some(grading),
            _ => None,
        }
    }
}

/// The inputs of a second picture; the objects and their colours are identified by generation numbers.
#[derive(Debug, PartialEq)]
enum SecondKey {
    ErrorMap(Same<Compared>),
    WrongCamera(Camera, [u64; 2], Raster, Shade, Mistake),
    Ghost([Camera; 2], [u64; 2], Raster, Shade, Selection),
    Answers(Camera, [u64; 2], StudentAnswers),
}

/// The data of a second picture, and the picture itself. When two cameras are compared, there is also the map
/// of the pixels that differ. The map of answers depends on the size of the view, and so has its own cache.
type SecondMade = (SecondData, Vec<Arc<Picture>>);

/// A cache of the second pictures: the last one of each kind, and the view of the current one.
#[derive(Debug, Default)]
pub(super) struct SecondPictures {
    made: [Memo<SecondKey, Option<(u64, SecondMade)>>; 4],
    view: Memo<CameraView, Shown>,
    answers_map: Memo<(u64, [u32; 2]), Option<Arc<Picture>>>,
    marks: Memo<(u64, Selection), Arc<[AnswerMark]>>,
    /// Number of pictures made so far; it identifies the current one.
    pub(super) count: u64,
}

impl SecondPictures {
    /// Updates the second picture, if the page has one. `world` is `None` while there is a fault.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: Option<&GoodWorld>,
    ) {
        let Some((kind, size)) = inputs.sizes.second else { return };
        let Some((number, made)) = self.made(kind, inputs, good, world) else { return };
        if let Some(world) = world {
            derived.answer_marks = self.marks(number, &made.0, inputs, good, world);
        }
        let view = self.view((number, &made), size, inputs, good, world);
        derived.second = Some(Second { data: made.0, view });
    }

    fn made(
        &mut self,
        kind: SecondPicture,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: Option<&GoodWorld>,
    ) -> Option<(u64, SecondMade)> {
        let Inputs { document, session, sizes, watch } = inputs;
        let memo = &mut self.made[kind as usize];
        let (camera, shade) = (document.camera, session.settings.shade);
        let mistake = session.mistakes_view.shown();
        let numbers = world.map(|world| [world.generation, world.palette]);
        let raster =
            || good.subsampling.raster(good.resolved.image(), sizes.second.map_or([1; 2], |s| s.1));
        let key = match (kind, numbers) {
            (SecondPicture::ErrorMap, _) => {
                SecondKey::ErrorMap(Same(good.others.compared.clone()?))
            }
            (SecondPicture::WrongCamera, Some(numbers)) => {
                SecondKey::WrongCamera(camera, numbers, raster(), shade, mistake)
            }
            // Shows an older picture only if it belongs to the same mistake.
            (SecondPicture::WrongCamera, None) => {
                let of_mistake = |key: &SecondKey| matches!(key, SecondKey::WrongCamera(.., of) if *of == mistake);
                return memo.known(of_mistake)?.clone();
            }
            (SecondPicture::Ghost, Some(numbers)) => {
                let cameras = [camera, session.ghost.as_ref()?.camera];
                SecondKey::Ghost(cameras, numbers, raster(), shade, session.selection)
            }
            (SecondPicture::Answers, Some(numbers)) => {
                let key = SecondKey::Answers(camera, numbers, session.answers.clone()?);
                // Grading traces many variants of the student's program, so it waits until the drag rests.
                if sizes.under_hand && memo.known(|known| *known == key).is_none() {
                    return None;
                }
                key
            }
            (SecondPicture::Ghost | SecondPicture::Answers, None) => return None,
        };
        let count = &mut self.count;
        memo.get(key, |key| {
            *count += 1;
            let made = match (key, world) {
                (SecondKey::ErrorMap(Same(compared)), _) => Some(error_map(compared)),
                (SecondKey::WrongCamera(.., raster, shade, mistake), Some(world)) => {
                    let camera = (&camera, &good.resolved, *mistake);
                    Some(wrong_camera(camera, world, raster, *shade, watch))
                }
                (SecondKey::Ghost([_, ghost], _, raster, shade, selection), Some(world)) => {
                    let cameras = ((&camera, &good.resolved), ghost);
                    ghost_picture(cameras, world, raster, *shade, *selection, watch)
                }
                (SecondKey::Answers(.., answers), Some(world)) => {
                    Some((SecondData::Answers(graded(document, world, answers)), Vec::new()))
                }
                (_, None) => None,
            };
            made.map(|made| (*count, made))
        })
    }

    /// Returns the answers and rays that the world view draws next to the right ones.
    fn marks(
        &mut self,
        number: u64,
        data: &SecondData,
        Inputs { session, .. }: Inputs<'_>,
        good: &GoodPicture,
        world: &GoodWorld,
    ) -> Arc<[AnswerMark]> {
        let selection = session.shown_selection();
        let camera = match data {
            SecondData::Answers(Ok(_)) => None,
            // A mark would give away the answer.
            SecondData::WrongCamera(wrong) if session.mistakes_view.is_revealed() => {
                wrong.camera.as_ref().ok()
            }
            _ => return Arc::default(),
        };
        self.marks.get((number, selection), |_| match (data, camera) {
            (SecondData::Answers(Ok(graded)), _) => {
                of_answers(graded, &good.resolved, &world.scene, selection).into()
            }
            (_, Some(wrong)) => of_mistake(wrong, &world.scene, selection).into(),
            _ => Arc::default(),
        })
    }

    /// Draws the picture at a size of `size` dots, with the overlay items that belong to its camera.
    fn view(
        &mut self,
        (number, (data, pictures)): (u64, &SecondMade),
        size: [u32; 2],
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: Option<&GoodWorld>,
    ) -> Option<Shown> {
        let Inputs { session, sizes, watch, .. } = inputs;
        let items = session.settings.items;
        let mut view = CameraView {
            resolved: good.resolved,
            picture: Same(Arc::clone(&good.picture)),
            inspection: Some(Same(Arc::clone(&good.inspection))),
            size: size.map(|n| n as usize),
            items,
            scale: sizes.scale,
            style: sizes.style,
            highlighted: None,
            loupe: None,
            is_apart: false,
        };
        let mut shows_differences = false;
        match data {
            // A highlighted concept belongs to the current document.
            SecondData::ErrorMap(_) => {
                view.highlighted = highlighted(inputs).filter(|_| world.is_some());
            }
            SecondData::WrongCamera(_) => {
                shows_differences = session.mistakes_view.shows_differences();
                // Both items belong to the right camera; in this picture their positions would be wrong.
                view.items = items.with(Item::UvAxes, false).with(Item::Hit, false);
            }
            SecondData::Ghost(against) => {
                shows_differences = session.ghost.is_some_and(|ghost| ghost.shows_differences);
                view.items = items.with(Item::Hit, items.shows(Item::Hit) && !shows_differences);
                view.resolved = against.ghost;
                view.inspection = Some(Same(Arc::clone(&against.inspection)));
            }
            SecondData::Answers(_) => {}
        }
        let picture = match data {
            SecondData::Answers(graded) => self.answers_map.get((number, size), |_| {
                Some(Arc::new(answers_map(graded.as_ref().ok()?, size)?))
            })?,
            _ => Arc::clone(pictures.get(usize::from(shows_differences))?),
        };
        view.picture = Same(picture);
        let scene = world.map(|world| &*world.scene);
        let shown = self.view.get(view, |view| {
            watched(watch, WorkKind::Overlay, || {
                let mut pixels = blank(size);
                let drawing = overlay::camera(view, scene, &mut pixels);
                if let SecondData::ErrorMap(compared) = data {
                    let (comparison, width) = (&compared.comparison, size[0] as usize);
                    let raster = &view.picture.raster;
                    accuracy::mark_wrong(comparison, raster, width, sizes.scale, &mut pixels);
                }
                view.style.finish(&mut pixels);
                Shown::new(size, pixels, drawing)
            })
        });
        Some(shown)
    }
}

fn picture(raster: &Raster, image: ImageSize, pixels: Vec<Color32>) -> Arc<Picture> {
    Arc::new(Picture { raster: raster.clone(), image, pixels })
}

fn error_map(compared: &Arc<Compared>) -> SecondMade {
    let (raster, image) = (compared.frame.raster(), compared.frame.camera().image());
    let map = picture(raster, image, accuracy::colors(&compared.comparison));
    (SecondData::ErrorMap(Arc::clone(compared)), vec![map])
}

fn wrong_camera(
    (camera, resolved, mistake): (&Camera, &ResolvedCamera, Mistake),
    world: &GoodWorld,
    raster: &Raster,
    shade: Shade,
    watch: OnWork<'_>,
) -> SecondMade {
    watched(watch, WorkKind::Trace, || {
        let color_of = |i: u32| world.colors[i as usize];
        let paint = Paint { shade, color_of, to_pixel: opaque };
        let (wrong, compared) =
            ComparedCamera::new(camera, resolved, &world.scene, mistake, raster, paint);
        let pictures = compared.map_or(Vec::new(), |ComparedPicture { pixels, wrong, right }| {
            let differences = difference_map(&wrong, &right);
            [pixels, differences].map(|pixels| picture(raster, camera.image, pixels)).into()
        });
        (SecondData::WrongCamera(Arc::new(wrong)), pictures)
    })
}

/// Traces both cameras; `None` if the ghost sees nothing.
fn ghost_picture(
    ((camera, now), ghost): ((&Camera, &ResolvedCamera), &Camera),
    world: &GoodWorld,
    raster: &Raster,
    shade: Shade,
    selection: Selection,
    watch: OnWork<'_>,
) -> Option<SecondMade> {
    let resolved = resolve(ghost, camera).ok()?;
    let colors = (shade, |i: u32| world.colors[i as usize]);
    let outputs = Outputs { object: true, ..Outputs::NONE };
    let trace =
        |camera| trace_picture(&world.scene, camera, raster, outputs, colors, (None, watch));
    let ((now_frame, _), (frame, pixels)) = (trace(now), trace(&resolved));
    let pairs = now_frame.object.iter().zip(&frame.object);
    let differing = pairs.filter(|(a, b)| a != b).count();
    let against = AgainstGhost {
        ghost: resolved,
        difference: camera.difference_from(ghost).ok()?,
        seen: ComparedPixels { pixels: now_frame.object.len(), differing },
        inspection: Arc::new(Inspection::new(
            &resolved,
            &world.scene,
            selection.inside(resolved.image()),
        )),
    };
    let differences = difference_map(&now_frame.object, &frame.object);
    let pictures = [pixels, differences].map(|pixels| picture(raster, camera.image, pixels));
    Some((SecondData::Ghost(Arc::new(against)), pictures.into()))
}

/// Returns the map of differences between the pictures of two cameras. Pixels with equal objects are pale,
/// and pixels with different objects are dark.
fn difference_map(now: &[u32], ghost: &[u32]) -> Vec<Color32> {
    let color = |(now, ghost): (&u32, &u32)| match (now == ghost, *now == NO_OBJECT) {
        (true, true) => Color32::from_gray(0xf0),
        (true, false) => Color32::from_gray(0xc4),
        // The ghost sees nothing here; only the ghost sees an object; the two see different objects.
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
    // The document's colours, even if the window shows others.
    let color_of = |object| document.color_of(object);
    let truth = Truth { camera, scene: &world.scene, color_of: &color_of };
    let grade = grade(&truth, &answers, None).map_err(|error| Arc::from(error.to_string()))?;
    Ok(Arc::new(Graded { answers, grade, image: camera.image, count_from: *count_from }))
}

/// Returns the map of the answers, with as many pixels as the screen shows. A pixel that stands for several
/// answers is wrong if any of these is wrong.
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

/// Returns the camera with which the world view compares the edited one: a mistake's, or the frozen one.
pub(super) fn ghost_camera(
    Inputs { document, session, .. }: Inputs<'_>,
    derived: &Derived,
) -> Option<GhostCamera> {
    if session.settings.layout == ViewLayout::Mistakes {
        // The ghost would give away the answer to the class.
        let is_secret = session.is_asking || !session.mistakes_view.is_revealed();
        let wrong = derived.wrong_camera().filter(|_| !is_secret && derived.fault.is_none())?;
        return wrong.camera.as_ref().ok().map(GhostCamera::of_mistake);
    }
    let ghost = session.ghost.as_ref()?;
    resolve(&ghost.camera, &document.camera).ok().as_ref().map(GhostCamera::frozen)
}

/// Returns the wrong camera's ray for the selected pixel.
fn of_mistake(wrong: &WrongCamera, scene: &Scene, selection: Selection) -> Vec<AnswerMark> {
    let ray = match selection.inside(wrong.image()) {
        Selection::Pixel(pixel) => wrong.ray(pixel),
        Selection::Uv(uv) => wrong.ray_at(uv),
    };
    let Ok(ray) = ray else { return Vec::new() };
    let t = scene.first_hit(&ray).map(|hit| hit.t);
    vec![AnswerMark::yours(MarkShape::Ray(ray, t), "ray′")]
}

/// Returns the student's answer for the selected pixel if it is wrong. If the file has no answer for
/// that pixel, returns the worst answer together with the right one.
fn of_answers(
    graded: &Graded,
    camera: &ResolvedCamera,
    scene: &Scene,
    selection: Selection,
) -> Vec<AnswerMark> {
    if let Answers::Basis(vectors) = &graded.answers {
        let names = ["your u", "your v", "your w"];
        let is_wrong = |index: &usize| !graded.grade.is_right[*index];
        let mark = |index: usize| {
            AnswerMark::yours(MarkShape::BasisVector(index, vectors[index].value), names[index])
        };
        return (0..vectors.len()).filter(is_wrong).map(mark).collect();
    }
    let selected = match selection {
        Selection::Pixel(pixel) => index_of(graded, pixel),
        Selection::Uv(_) => None,
    };
    if let Some(index) = selected {
        let is_right = graded.grade.is_right.get(index).copied().unwrap_or(true);
        return match (is_right, graded.pixel(index)) {
            (false, Some(pixel)) => yours(graded, index, &camera.ray_of_pixel(pixel), scene),
            _ => Vec::new(),
        };
    }
    let (Some(worst), Some(pixel)) = (&graded.grade.worst, graded.worst_pixel()) else {
        return Vec::new();
    };
    let ray = camera.ray_of_pixel(pixel);
    let mut marks = yours(graded, worst.index, &ray, scene);
    if !marks.is_empty() {
        let t = scene.first_hit(&ray).map(|hit| hit.t);
        marks.push(AnswerMark::right(MarkShape::Ray(ray, t), "right ray"));
    }
    marks
}

fn index_of(graded: &Graded, pixel: Pixel) -> Option<usize> {
    let count = graded.grade.is_right.len();
    (0..count).find(|index| graded.pixel(*index) == Some(pixel))
}

/// Returns the ray or the hit that an answer gives. If the answer gives only t of a hit, the hit lies on the
/// right ray.
fn yours(graded: &Graded, index: usize, right: &Ray, scene: &Scene) -> Vec<AnswerMark> {
    let shape = match &graded.answers {
        Answers::Rays(rays) => {
            let Ok(ray) = Ray::new(rays[index].origin.value, rays[index].direction.value) else {
                return Vec::new();
            };
            let t = scene.first_hit(&ray).map(|hit| hit.t);
            return vec![AnswerMark::yours(MarkShape::Ray(ray, t), "your ray")];
        }
        Answers::Hits(hits) => match hits[index].hit {
            Some(GivenHit { point: Some(point), .. }) => MarkShape::Point(point.value),
            Some(GivenHit { t: Some(t), .. }) => MarkShape::OnRay(*right, t.value),
            _ => return Vec::new(),
        },
        Answers::Basis(_) | Answers::Picture(_) => return Vec::new(),
    };
    vec![AnswerMark::yours(shape, "your hit")]
}
