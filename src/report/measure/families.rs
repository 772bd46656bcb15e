//! The cases of the stress families, which are hard for intersection methods: one case for each setting
//! of each family's knob (the parameter that makes it easier or harder).

use pinhole_core::{Plane, Ray, Scene, Sphere};
use pinhole_reference::{Family, Object, RayCase};

use super::case::{CaseRun, Limits, Set};
use super::scenes::methods_for;
use super::subject::CaseSubject;
use crate::report::model::Case;

/// Number of rays for each setting of a knob.
const RAYS: usize = 600;

/// Returns the cases of all families, and sentences about measurements that are omitted.
pub(super) fn cases(seed: u64) -> (Vec<CaseRun>, Vec<String>) {
    let of_knobs =
        |family: &'static Family| family.knobs.iter().map(move |knob| case(family, *knob, seed));
    let cases = Family::all().flat_map(of_knobs).collect();
    let planes = "families of planes alone: one row a precision: all methods but the ladder share \
                  the textbook's plane";
    let frames = "ladder-f32 in the families: it traces frames alone, and a family has single rays";
    (cases, vec![planes.to_owned(), frames.to_owned()])
}

fn case(family: &'static Family, knob: f64, seed: u64) -> CaseRun {
    let case = Case {
        name: family.name.to_owned(),
        knob: Some(knob),
        knob_name: family.knob_name.to_owned(),
        about: family.about.to_owned(),
        ..Case::default()
    };
    let limits = Limits { rounds: 11, pieces: 10 };
    CaseRun::new(case, limits, move || make(family, knob, seed))
}

/// Creates the rays of a case, and prepares the methods. Also returns a sentence about cases that are left
/// out, if there are any.
fn make(family: &Family, knob: f64, seed: u64) -> (Set, Option<String>) {
    let given = family.rays(knob, seed, RAYS);
    let cases: Vec<_> = given.iter().filter_map(ray_case).collect();
    let skipped = given.len() - cases.len();
    let has_spheres = cases.iter().any(|(scene, _)| !scene.spheres().is_empty());
    let title = format!("{}, {} = {knob}", family.name, family.knob_name);
    let left_out = (skipped > 0)
        .then(|| format!("{title}: {skipped} cases that the program refuses with an error"));
    (Set::new(CaseSubject::Rays(cases), methods_for(has_spheres)), left_out)
}

fn scene_of(objects: &[Object]) -> Option<Scene> {
    let mut spheres = Vec::new();
    let mut planes = Vec::new();
    for object in objects {
        match *object {
            Object::Sphere { center, radius } => {
                spheres.push(Sphere::new(center, radius).ok()?);
            }
            Object::Plane { point, normal } => planes.push(Plane::new(point, normal).ok()?),
        }
    }
    Scene::new(spheres, planes).ok()
}

fn ray_case(case: &RayCase) -> Option<(Scene, Ray)> {
    Some((scene_of(&case.objects)?, Ray::new(case.origin, case.direction).ok()?))
}
