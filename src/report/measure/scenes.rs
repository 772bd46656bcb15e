//! The cases of one scene: the whole scene, and separate cases for objects that are handled by
//! other code.

use std::cmp::Ordering;
use std::sync::Arc;

use pinhole_core::methods::{Formula, Method};
use pinhole_core::{Camera, CameraError, Raster, ResolvedCamera, Scene};

use super::case::{CaseRun, CaseWork, Limits, Set};
use super::subject::{CaseSubject, MeasuredPicture, objects_of};
use crate::report::model::Case;

/// Maximum number of pixels per side when comparing with the truth.
const SIDE: u32 = 240;
/// Maximum number of pixels per side when timing.
const TIMED_SIDE: u32 = 256;
/// Maximum number of intersection tests that are timed at once, so that slices stay short.
const TIMED_TESTS: usize = 1 << 17;
/// A note for readers of a scene's numbers.
pub(super) const NOTE: &str = "an f32 method rounds the scene to f32 first, and what that changes is in \
     its error";

/// A part of a scene that is measured as a case.
struct Subset {
    title: String,
    part_of: Option<String>,
    scene: Scene,
    limits: Limits,
}

/// Returns the cases, and sentences about omitted measurements.
pub(super) fn cases(
    name: &str,
    scene: &Scene,
    camera: &Camera,
) -> Result<(Vec<CaseRun>, Vec<String>), CameraError> {
    let resolved = camera.resolve()?;
    let mut left_out = Vec::new();
    let subsets = subsets(name, scene, camera, &mut left_out);
    let camera = *camera;
    let run = |Subset { title, part_of, scene, limits }| {
        let case = Case { name: title.clone(), part_of, ..Case::default() };
        CaseRun::new(case, limits, move || make(&title, scene, &camera, &resolved))
    };
    Ok((subsets.into_iter().map(run).collect(), left_out))
}

/// Returns the scene, its planes, and the spheres around the eye if there are other spheres too.
fn subsets(name: &str, scene: &Scene, camera: &Camera, left_out: &mut Vec<String>) -> Vec<Subset> {
    let limits = |pieces| Limits { rounds: 41, pieces };
    let (title, whole) = (name.to_owned(), scene.clone());
    let mut subsets = vec![Subset { title, part_of: None, scene: whole, limits: limits(400) }];
    let (spheres, planes) = (scene.spheres(), scene.planes());
    let objects = objects_of(scene);
    let is_inside = |index: &usize| {
        camera.eye.is_finite() && objects[*index].side_of(camera.eye.to_array()) == Ordering::Less
    };
    let around: Vec<_> = (0..spheres.len()).filter(is_inside).map(|i| spheres[i]).collect();
    let mut alone = |what: &str, spheres: &[_], planes: &[_]| {
        if let Ok(scene) = Scene::new(spheres.to_vec(), planes.to_vec()) {
            let (title, part_of) = (format!("{name}: {what}"), Some(name.to_owned()));
            subsets.push(Subset { title, part_of, scene, limits: limits(100) });
        }
    };
    if !around.is_empty() && around.len() < objects.len() {
        alone("spheres around the eye, alone", &around, &[]);
    }
    if !planes.is_empty() && !spheres.is_empty() {
        alone("planes, alone", &[], planes);
    }
    let mut leave_out = |what: &str| left_out.push(format!("{name}: {what}"));
    if objects.is_empty() {
        leave_out("no sphere rows and no plane rows: the scene is empty");
    } else if spheres.is_empty() {
        leave_out(
            "no sphere rows: the scene has no spheres; all methods but the ladder share the textbook's plane",
        );
    } else if planes.is_empty() {
        leave_out("no plane rows: the scene has no planes");
    } else {
        leave_out(
            "planes, alone: one row a precision: all methods but the ladder share the textbook's plane",
        );
    }
    if around.is_empty() && !spheres.is_empty() {
        leave_out("no inside rows: the eye is outside every sphere");
    }
    subsets
}

/// Returns all methods; without spheres, returns one method for each way to intersect a plane.
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
) -> (CaseWork, Option<String>) {
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
    let timed = (*resolved, timed_raster(resolved, scene.len()));
    let picture = MeasuredPicture::new(scene, camera, resolved, raster, timed);
    let set = Set::new(CaseSubject::Frames(vec![picture]), methods);
    (CaseWork::new(vec![set]), left_out)
}

/// Returns the raster for timing: the image, or fewer of its pixels, in rows as long as possible.
fn timed_raster(resolved: &ResolvedCamera, objects: usize) -> Raster {
    let pixels = (TIMED_TESTS / objects.max(1)).clamp(1, (TIMED_SIDE * TIMED_SIDE) as usize) as u32;
    let columns = pixels.min(TIMED_SIDE).min(resolved.image().width());
    Raster::shown_on(resolved.image(), columns, (pixels / columns).min(TIMED_SIDE))
}
