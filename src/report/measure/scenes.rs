//! The cases of one scene: the whole scene, and separate cases for objects that are handled by
//! other code.

use std::cmp::Ordering;
use std::sync::Arc;

use pinhole_core::methods::{Formula, Method};
use pinhole_core::{Camera, CameraError, NO_OBJECT, Outputs, Raster, ResolvedCamera, Scene, trace};

use super::case::{CaseRun, CaseWork, Limits, Set};
use super::subject::{CaseSubject, MeasuredPicture, Sample, objects_of};
use crate::report::model::Case;

/// Maximum number of pixels per side when comparing with the truth.
const SIDE: u32 = 400;
/// Maximum number of pixels per side when timing.
const TIMED_SIDE: u32 = 256;
/// Maximum number of intersection tests that are timed at once, so that slices stay short.
const TIMED_TESTS: usize = 1 << 17;
/// Maximum number of pixels that are compared with the truth.
const MOST_PIXELS: usize = 60_000;
const SEED: u64 = 1;

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
    let raster = Raster::shown_on(resolved.image(), SIDE, SIDE);
    let frame = trace(&scene, resolved, &raster, Outputs::default());
    let covered = frame.object.iter().filter(|object| **object != NO_OBJECT).count();
    let sample = sample(&frame.object, raster.columns().len());
    let (methods, scene) = (methods_for(!scene.spheres().is_empty()), Arc::new(scene));
    let timed = timed_raster(resolved, scene.len());
    let (all, seen) = (frame.object.len(), sample.pixels.len());
    let outline = sample.strata.iter().filter(|stratum| **stratum == 0).count();
    let left_out = (seen < all).then(|| {
        format!(
            "{title}: of {all} pixels, {} were not compared with the truth; those that were: {outline} \
             beside an outline, of {}, {} others at random (seed {SEED}), each weighted by how many \
             there are of its kind",
            all - seen,
            sample.populations[0],
            seen - outline,
        )
    });
    let picture = MeasuredPicture::new(scene, camera, resolved, raster, sample, (*resolved, timed));
    let coverage = covered as f64 / all.max(1) as f64;
    let set = Set::new(CaseSubject::Frames(vec![picture]), methods);
    (CaseWork::new(vec![set], Some(coverage)), left_out)
}

/// Returns the raster for timing: the image, or fewer of its pixels, in rows as long as possible.
fn timed_raster(resolved: &ResolvedCamera, objects: usize) -> Raster {
    let pixels = (TIMED_TESTS / objects.max(1)).clamp(1, (TIMED_SIDE * TIMED_SIDE) as usize) as u32;
    let columns = pixels.min(TIMED_SIDE).min(resolved.image().width());
    Raster::shown_on(resolved.image(), columns, (pixels / columns).min(TIMED_SIDE))
}

/// Selects the pixels to compare with the truth, alternating between two strata: pixels next to an outline,
/// where a neighbour shows another object or none, and all others.
fn sample(object: &[u32], width: usize) -> Sample {
    let is_outline = |index: &usize| {
        let (row, column) = (index / width, index % width);
        let differs = |other: Option<&u32>| other.is_some_and(|other| *other != object[*index]);
        (column > 0 && differs(object.get(index - 1)))
            || (column + 1 < width && differs(object.get(index + 1)))
            || (row > 0 && differs(object.get(index - width)))
            || differs(object.get(index + width))
    };
    let mut order: Vec<usize> = (0..object.len()).collect();
    order.sort_by_key(|index| mixed(SEED ^ *index as u64));
    let (outline, others): (Vec<_>, Vec<_>) = order.into_iter().partition(is_outline);
    let populations = [outline.len(), others.len()];
    let (mut outline_left, mut others_left) = (outline.iter(), others.iter());
    let in_turn = std::iter::from_fn(|| match (outline_left.next(), others_left.next()) {
        (None, None) => None,
        (one, other) => Some(one.into_iter().chain(other)),
    });
    let indices: Vec<usize> = in_turn.flatten().copied().take(MOST_PIXELS).collect();
    Sample {
        strata: indices.iter().map(|index| usize::from(!is_outline(index))).collect(),
        pixels: indices.into_iter().map(|index| (index / width, index % width)).collect(),
        populations,
    }
}

/// Returns a pseudorandom number: the finalizer of SplitMix64 (Steele, Lea, Flood, *Fast splittable
/// pseudorandom number generators*, 2014).
fn mixed(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
