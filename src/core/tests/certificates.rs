//! Tests of certificates, which tell for each pixel how hard its hit was to decide, against the exact
//! reference.

use std::collections::BTreeSet;

use pinhole_core::*;
use pinhole_reference::View;

use crate::common::frames::{self, FrameCase};
use crate::common::{given, margins};

/// Returns the exact value whose sign answers the hardest question about a pixel, divided by the
/// denominator that [`Question`] gives; `None` if the reference finds no such value.
fn exact_value(case: &FrameCase, view: &View, pixel: Pixel, hardest: &Hardest) -> Option<f64> {
    let (object, Pixel { row, column }) = (hardest.object as usize, pixel);
    let (asked, eye) = (&case.objects[object], case.camera.eye);
    let direction = || view.direction_of_pixel(row, column);
    match hardest.question {
        Question::Side => Some(margins::side(asked, eye)),
        Question::Meets => margins::grazing(asked, eye, &direction()),
        Question::Ahead => margins::ahead(asked, eye, &direction()),
        Question::Order => {
            let first = view.first_hit_of_pixel(row, column)?.t;
            let roots = view.roots_of_pixel(object, row, column);
            let t = roots.iter().find(|t| t.to_f64() > 0.0)?;
            Some(t.relative_difference(&first))
        }
    }
}

/// Asserts that a certificate's margin is right. `exact` is the exact value whose sign was decided.
/// The computed value is `2^margin` times the error bound, and may differ from the exact one by at
/// most the error bound, so `|2^margin - |exact| / bound|` must be at most 1. If exact integers
/// decided, asserts instead that the margin is 0, and that `exact` is too close to 0 for double-double
/// to decide.
#[track_caller]
fn assert_margin(certificate: &Certificate, exact: f64, about: &str) {
    let Certificate { step, margin, hardest, .. } = *certificate;
    let bound = hardest.unwrap().bound;
    let ratio = exact.abs() / bound;
    match step {
        Step::Exact => {
            assert_eq!(margin, 0.0);
            assert!(ratio <= 3.0, "{about}: double-double knew it by {ratio} bounds");
        }
        _ => {
            let told = margin.exp2();
            // The unit is that of a rounded t.
            let slack = 1.0 + told * (1e-6 + 4.0 * bound);
            assert!((told - ratio).abs() <= slack, "{about}: {told} told, {ratio} is so");
        }
    }
}

/// Asserts that the exact value has the sign that was decided. `first` is the object that the
/// reference finds to be hit first.
#[track_caller]
fn assert_sign(certificate: &Certificate, first: Option<u32>, exact: f64, about: &str) {
    let Hardest { question, object, .. } = certificate.hardest.unwrap();
    match question {
        // Exactly touching and exactly tied values are 0 only to the reference's 440 bits.
        Question::Meets => assert_eq!(exact >= -1e-120, first == Some(object), "{about}"),
        Question::Order => assert!(exact >= -1e-120, "{about}: {exact}"),
        _ => {}
    }
}

/// Returns a scene of those objects of `scene` that have these indices, in their order.
fn some_of(scene: &Scene, mut indices: Vec<u32>) -> Scene {
    indices.sort_unstable();
    let (mut spheres, mut planes) = (Vec::new(), Vec::new());
    for index in indices {
        match scene.object(index).unwrap() {
            Object::Sphere(sphere) => spheres.push(sphere),
            Object::Plane(plane) => planes.push(plane),
        }
    }
    Scene::new(spheres, planes).unwrap()
}

fn is_less_sure(one: &Certificate, other: &Certificate) -> bool {
    (one.step, -one.margin) > (other.step, -other.margin)
}

/// Computes a ray's certificate in small scenes: one with only the object that the ray hits first and,
/// for each other object, one with both. Returns the step and the margin of the least certain of these
/// certificates.
fn by_pairs(scene: &Scene, ray: &ExactRay) -> (Step, f64) {
    let first = scene.first_hit_of(ray).map(|hit| hit.object);
    let others = (0..scene.len() as u32).filter(|index| Some(*index) != first);
    let scenes = others.map(|index| vec![index]).chain([vec![]]).map(|mut indices| {
        indices.extend(first);
        some_of(scene, indices)
    });
    let all = scenes.map(|scene| scene.certificate_of(ray));
    let least = all.reduce(|a, b| if is_less_sure(&b, &a) { b } else { a }).unwrap();
    (least.step, least.margin)
}

/// Checks the certificate of every pixel of a frame, and adds to `seen` which steps decided which
/// questions.
fn check(case: &FrameCase, name: &str, seen: &mut BTreeSet<String>) {
    let (scene, camera) = (given::scene(&case.objects), given::camera(&case.camera));
    let (Ok(resolved), Ok(view)) = (camera.resolve(), case.camera.prepare(&case.objects)) else {
        return;
    };
    let raster = Raster::full(camera.image);
    let (rows, columns) = (raster.rows(), raster.columns());
    let certificates = scene.certificates(&resolved, rows, columns, |_| ());
    assert_eq!(certificates.len(), rows.len() * columns.len());
    for (k, certificate) in certificates.iter().enumerate() {
        let pixel = Pixel { row: rows[k / columns.len()], column: columns[k % columns.len()] };
        let about = format!("{name}, {pixel:?}, {certificate:?}");
        let ray = resolved.exact_ray(pixel);
        assert!((0.0..=Certificate::MOST).contains(&certificate.margin), "{about}");
        assert_eq!(by_pairs(&scene, &ray), (certificate.step, certificate.margin), "{about}");
        let Some(hardest) = certificate.hardest else {
            assert_eq!(certificate.margin, Certificate::MOST, "{about}");
            continue;
        };
        seen.insert(format!("{:?} {:?}", certificate.step, hardest.question));
        let Some(exact) = exact_value(case, &view, pixel, &hardest) else { continue };
        let first = view.first_hit_of_pixel(pixel.row, pixel.column).map(|hit| hit.object as u32);
        assert_margin(certificate, exact, &about);
        assert_sign(certificate, first, exact, &about);
    }
}

#[test]
fn each_margin_is_what_the_reference_says() {
    let mut seen = BTreeSet::new();
    for family in &frames::FAMILIES {
        for knob in family.knobs {
            for case in family.cases(*knob, 18, 2) {
                check(&case, &format!("{} {knob}", family.name), &mut seen);
            }
        }
    }
    for step in ["F64", "DoubleDouble", "Exact"] {
        for question in ["Meets", "Order"] {
            assert!(seen.contains(&format!("{step} {question}")), "{step} {question}: {seen:?}");
        }
    }
    assert!(seen.contains("F64 Ahead") && seen.contains("F64 Side"), "{seen:?}");
}

fn middle(scene: &Scene) -> Certificate {
    let ray = Ray::new([0.0; 3], [0.0, 0.0, -1.0]).unwrap();
    scene.certificate_of(&ExactRay::from_ray(&ray).unwrap())
}

#[test]
fn where_nothing_is_to_be_decided_the_margin_is_the_largest() {
    let certificate = middle(&Scene::default());
    assert_eq!((certificate.step, certificate.margin), (Step::F64, Certificate::MOST));
    assert_eq!(certificate.hardest, None);
    let far = Sphere::new([100.0, 0.0, -5.0], 1.0).unwrap();
    assert_eq!(middle(&Scene::new(vec![far], vec![]).unwrap()), certificate);
}

/// If the same sphere occurs twice, the one listed first is hit, which needs no computation, so the
/// certificate is that of a single sphere.
#[test]
fn a_sphere_given_twice_is_as_sure_as_once() {
    let ball = Sphere::new([0.0, 0.5, -5.0], 1.0).unwrap();
    let [once, twice] = [1, 2].map(|n| middle(&Scene::new(vec![ball; n], vec![]).unwrap()));
    assert_eq!(once, twice);
    assert_eq!(once.step, Step::F64);
}

/// A sphere that the ray touches does not affect the certificate if it is hidden behind a wall.
#[test]
fn what_is_hidden_costs_no_bits() {
    let tangent = Sphere::new([0.0, 1.0, -5.0], 1.0).unwrap();
    let wall = |z: f64| Plane::new([0.0, 0.0, z], [0.0, 0.0, 1.0]).unwrap();
    let with = |z| middle(&Scene::new(vec![tangent], vec![wall(z)]).unwrap());
    assert_eq!(with(-6.0).step, Step::Exact);
    assert_eq!(with(-4.0).step, Step::F64);
    assert!(with(-4.0).margin > 20.0);
}

/// The closer a ray passes to a sphere's silhouette, the smaller its margin.
#[test]
fn the_margin_falls_towards_the_silhouette() {
    let beside = |gap: f64| {
        let ball = Sphere::new([0.0, 1.0 + gap, -5.0], 1.0).unwrap();
        middle(&Scene::new(vec![ball], vec![]).unwrap())
    };
    let certificates = [1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 0.0].map(beside);
    assert!(certificates.is_sorted_by(|a, b| is_less_sure(b, a)), "{certificates:?}");
    assert_eq!(certificates[5].step, Step::DoubleDouble);
    assert_eq!((certificates[6].step, certificates[6].margin), (Step::Exact, 0.0));
}

/// On which side of an object the eye is, if it lies on it, takes exact numbers: once in a frame, and in each
/// pixel's certificate. If it lies beside it by a rounding error, double-double decides.
#[test]
fn an_eye_on_objects_is_counted_as_it_is_certified() {
    let sphere = |k: f64| Sphere::new([-k, -2.0 * k, -2.0 * k], 3.0 * k).unwrap();
    let plane = |k: f64, off: f64| Plane::new([k + off, 2.0, 0.0], [2.0, -k, 16.0]).unwrap();
    let (ball, beside) = (Sphere::new([0.0, 0.0, -6.0], 1.0).unwrap(), plane(3.0, 1e-15));
    let [k, l, m] = [1.0, 2.0, 7.0];
    let cases: [(&[Sphere], &[Plane], Step, u64); 7] = [
        (&[ball], &[plane(k, 1.0)], Step::F64, 0),
        (&[sphere(k), sphere(l), sphere(m)], &[], Step::Exact, 3),
        (&[], &[plane(k, 0.0)], Step::Exact, 1),
        (&[ball], &[plane(k, 0.0), plane(l, 0.0), plane(m, 0.0)], Step::Exact, 3),
        (&[sphere(k), ball], &[plane(l, 0.0), beside], Step::Exact, 2),
        (&[ball], &[beside], Step::DoubleDouble, 1),
        (&[sphere(m), sphere(l)], &[plane(m, 0.0), plane(k, 0.0), plane(l, 1.0)], Step::Exact, 4),
    ];
    // 80 rows are drawn in three slices.
    for (width, height) in [(9, 9), (40, 80)] {
        let camera = Camera { image: ImageSize::new(width, height).unwrap(), ..Camera::CANONICAL };
        let resolved = camera.resolve().unwrap();
        let raster = Raster::full(resolved.image());
        for (spheres, planes, step, count) in cases {
            let scene = Scene::new(spheres.to_vec(), planes.to_vec()).unwrap();
            let found = scene.certificates(&resolved, raster.rows(), raster.columns(), |_| ());
            assert_eq!(
                found.iter().map(|one| one.step).max(),
                Some(step),
                "{spheres:?} {planes:?}"
            );
            let steps = trace(&scene, &resolved, &raster, Outputs::default()).steps;
            let expected = match step {
                Step::Exact => steps.exact,
                Step::DoubleDouble => steps.double_double,
                _ => steps.beyond_f64(),
            };
            assert_eq!(expected, count, "{steps:?} {spheres:?} {planes:?}");
            assert!(step == Step::Exact || steps.exact == 0, "{steps:?}");
        }
    }
}
