//! The case of a scene, which is seen by a camera.

use std::sync::Arc;

use pinhole_core::methods::{Formula, Method};
use pinhole_core::{Camera, CameraError, Raster, ResolvedCamera, Scene};

use super::case::{CaseRun, Limits, Set};
use super::subject::{CaseSubject, MeasuredPicture};
use crate::report::model::Case;

/// Maximum number of pixels per side that are compared with the reference.
const SIDE: u32 = 240;
/// Maximum number of pixels per side that are timed.
const TIMED_SIDE: u32 = 256;
/// Maximum number of intersection tests in one time measurement, which limits the duration of
/// [`Measurement::step`](super::Measurement::step).
const TIMED_TESTS: usize = 1 << 17;
/// Returns the case of a scene, and sentences about measurements that are omitted.
pub(super) fn case(
    name: &str,
    scene: &Scene,
    camera: &Camera,
) -> Result<(CaseRun, Vec<String>), CameraError> {
    let (resolved, camera) = (camera.resolve()?, *camera);
    let left_out = match (scene.spheres(), scene.planes()) {
        ([], []) => Some("the scene is empty"),
        ([], _) => {
            Some("the scene has no spheres; all methods but the ladder share the textbook's plane")
        }
        _ => None,
    };
    let left_out = left_out.map(|what| format!("{name}: no sphere rows: {what}"));
    let case = Case { name: name.to_owned(), ..Case::default() };
    let (limits, scene, title) =
        (Limits { rounds: 41, pieces: 400 }, scene.clone(), name.to_owned());
    let run = CaseRun::new(case, limits, move || make(&title, scene, &camera, &resolved));
    Ok((run, left_out.into_iter().collect()))
}

/// Returns the methods to measure: all of them or, if there are only planes, one for each way of
/// intersecting a plane.
pub(super) fn methods_for(has_spheres: bool) -> impl Iterator<Item = Method> {
    Method::of_frames().filter(move |method| match method {
        Method::Known(formula, _) => has_spheres || *formula == Formula::Textbook,
        Method::Ladder | Method::LadderF32 | Method::DoubleDouble => true,
    })
}

fn make(
    title: &str,
    scene: Scene,
    camera: &Camera,
    resolved: &ResolvedCamera,
) -> (Set, Option<String>) {
    let image = resolved.image();
    let raster = Raster::shown_on(image, SIDE, SIDE);
    let (all, compared) = (Raster::full(image).len(), raster.len());
    let left_out = (compared < all).then(|| {
        format!(
            "{title}: of {all} pixels, {} were not compared with the truth; the {compared} that were are \
             spread evenly",
            all - compared
        )
    });
    let (methods, scene) = (methods_for(!scene.spheres().is_empty()), Arc::new(scene));
    let timed = timed_raster(resolved, scene.len());
    let picture = MeasuredPicture::new(scene, camera, resolved, raster, timed);
    (Set::new(CaseSubject::Frame(Box::new(picture)), methods), left_out)
}

/// Returns the pixels that are traced for timing: all of them or, if they are too many, evenly spaced
/// ones, in rows as long as possible.
fn timed_raster(resolved: &ResolvedCamera, objects: usize) -> Raster {
    let pixels = (TIMED_TESTS / objects.max(1)).clamp(1, (TIMED_SIDE * TIMED_SIDE) as usize) as u32;
    let columns = pixels.min(TIMED_SIDE).min(resolved.image().width());
    Raster::shown_on(resolved.image(), columns, (pixels / columns).min(TIMED_SIDE))
}
