//! The cases of the stress families: each family at each setting of its knob.

use std::sync::Arc;
use std::time::Duration;

use pinhole_core::methods::{Method, Precision};
use pinhole_core::{
    Basis, Camera, DVec3, ImageSize, Orientation, Plane, Raster, Ray, ResolvedCamera, Scene,
    Sphere, Viewport,
};
use pinhole_reference::{self as reference, Family, FrameCase, Kind, Object, RayCase};

use super::case::{CaseRun, Limits, Made, Set};
use super::scenes::methods_for;
use super::subject::{Picture, Subject};
use crate::report::model::Case;

/// Rays for each setting of a knob.
const RAYS: usize = 1000;
/// Pictures for each setting of a knob.
const FRAMES: usize = 6;
/// Maximum number of pixels of a picture, a side.
const SIDE: u32 = 256;
/// Time that all cases together may take.
const BUDGET: Duration = Duration::from_secs(150);

/// The cases, and what they leave out.
pub(super) fn cases(seed: u64) -> (Vec<CaseRun>, Vec<String>) {
    let is_measured = |family: &&Family| family.kind() != Kind::Bases;
    let knobs: usize = Family::all().filter(is_measured).map(|family| family.knobs().len()).sum();
    let budget = BUDGET / knobs.max(1) as u32;
    let of_knobs = |family: &'static Family| {
        family.knobs().iter().map(move |knob| case(family, *knob, seed, budget))
    };
    let cases = Family::all().filter(is_measured).flat_map(of_knobs).collect();
    let bases: Vec<_> =
        Family::all().filter(|f| f.kind() == Kind::Bases).map(Family::name).collect();
    let planes = "families of planes alone: one row a precision: all methods but the ladder share \
                  the textbook's plane";
    let bases = format!(
        "{}: families of bases; the methods differ in intersecting, not in the basis",
        bases.join(", ")
    );
    (cases, vec![bases, planes.to_owned()])
}

fn case(family: &'static Family, knob: f64, seed: u64, budget: Duration) -> CaseRun {
    let case = Case {
        name: family.name().to_owned(),
        knob: Some(knob),
        knob_name: family.knob_name().to_owned(),
        ..Case::default()
    };
    let limits = Limits { rounds: 15, budget, pieces: 10 };
    CaseRun::new(case, limits, move || make(family, knob, seed))
}

/// The `f64` methods get the family's cases; the `f32` methods get those in numbers that are exact in
/// `f32`, so that their own errors are seen and not those of rounding the scene.
fn make(family: &Family, knob: f64, seed: u64) -> Made {
    let mut skipped = 0;
    let mut set = |precision: Precision| {
        let single = precision == Precision::F32;
        let (subject, methods) = match family.kind() {
            Kind::Rays => {
                let given = family.rays(knob, seed, RAYS, single);
                let cases: Vec<_> = given.iter().filter_map(ray_case).collect();
                skipped += given.len() - cases.len();
                let methods = methods_of(cases.iter().map(|(scene, _)| scene));
                (Subject::Rays(cases), methods)
            }
            Kind::Frames | Kind::Bases => {
                let given = family.frames(knob, seed, FRAMES, single);
                let pictures: Vec<_> = given.iter().filter_map(picture).collect();
                skipped += given.len() - pictures.len();
                let methods = methods_of(pictures.iter().map(|picture| &*picture.scene));
                (Subject::Frames(pictures), methods)
            }
        };
        let methods = methods.into_iter().filter(|method| method.precision() == precision);
        Set { methods: methods.collect(), subject }
    };
    let sets = vec![set(Precision::F64), set(Precision::F32)];
    let title = format!("{}, {} = {knob}", family.name(), family.knob_name());
    let all = sets[0].subject.len();
    let left_out = move |decided: usize| {
        let undecided = (decided < all)
            .then(|| format!("{} of {all} rays were not compared in time", all - decided));
        let refused = (skipped > 0)
            .then(|| format!("{skipped} cases that the program refuses with an error"));
        let parts: Vec<_> = undecided.into_iter().chain(refused).collect();
        (!parts.is_empty()).then(|| format!("{title}: {}", parts.join("; ")))
    };
    Made { sets, coverage: None, left_out: Box::new(left_out) }
}

/// The methods that differ in one of the scenes.
fn methods_of<'a>(mut scenes: impl Iterator<Item = &'a Scene>) -> Vec<Method> {
    match scenes.find(|scene| !scene.spheres().is_empty()) {
        Some(scene) => methods_for(scene),
        None => methods_for(&Scene::default()),
    }
}

fn scene_of(objects: &[Object]) -> Option<Scene> {
    let mut spheres = Vec::new();
    let mut planes = Vec::new();
    for object in objects {
        match *object {
            Object::Sphere { center, radius } => {
                spheres.push(Sphere { center: DVec3::from_array(center), radius });
            }
            Object::Plane { point, normal } => planes
                .push(Plane { point: DVec3::from_array(point), normal: DVec3::from_array(normal) }),
        }
    }
    Scene::new(spheres, planes).ok()
}

fn ray_case(case: &RayCase) -> Option<(Scene, Ray)> {
    let ray = Ray {
        origin: DVec3::from_array(case.origin),
        direction: DVec3::from_array(case.direction),
    };
    ray.check().ok()?;
    Some((scene_of(&case.objects)?, ray))
}

fn picture(case: &FrameCase) -> Option<Picture> {
    let camera = core_camera(&case.camera)?;
    let resolved: ResolvedCamera = camera.resolve().ok()?;
    let raster = Raster::shown_on(resolved.image(), SIDE, SIDE);
    let (rows, columns) = (raster.rows().len(), raster.columns().len());
    let scene = Arc::new(scene_of(&case.objects)?);
    let mut picture = Picture::new(&scene, &camera, &resolved, raster.clone(), raster);
    picture.pixels =
        (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))).collect();
    Some(picture)
}

fn core_camera(camera: &reference::Camera) -> Option<Camera> {
    let vector = DVec3::from_array;
    let reference::Camera { eye, orientation, width, height, distance, columns, rows } = *camera;
    let orientation = match orientation {
        reference::Orientation::At { at, up } => Orientation::At { at: vector(at), up: vector(up) },
        reference::Orientation::View { view, up } => {
            Orientation::View { view: vector(view), up: vector(up) }
        }
        reference::Orientation::Basis { u, v, w } => {
            Orientation::Basis(Basis { u: vector(u), v: vector(v), w: vector(w) })
        }
    };
    Some(Camera {
        eye: vector(eye),
        orientation,
        viewport: Viewport { width, height, distance },
        image: ImageSize::new(columns, rows).ok()?,
    })
}
