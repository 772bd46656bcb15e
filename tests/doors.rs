//! One question, one answer: what a pixel shows, by whichever way it is asked.
//!
//! 2000 random scenes of twelve pixels for each of six kinds; `PINHOLE_DOOR_SCENES` sets another number.

use std::cell::Cell;
use std::path::Path;

use pinhole::model::digest::picture_digest;
use pinhole::model::lessons::{LessonArgument, OpenLesson};
use pinhole_core::Selection;
use pinhole_core::*;
use pinhole_exchange::document::Item;
use pinhole_exchange::{BuiltinScene, Document, scene_file};
use pinhole_figure::inspection::Inspection;
use pinhole_lecture::ObjectDerivation;
use pinhole_lecture::grading::{Answers, GivenHit, HitAnswer, Truth, Written, grade};
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// Every number that is told of a hit.
type Told = Option<(u32, u64, [u64; 3], [u64; 3])>;

fn told(root: Option<&Root>) -> Told {
    let bits = |v: DVec3| v.to_array().map(|x| (x + 0.0).to_bits());
    root.map(|root| (root.object, root.t.to_bits(), bits(root.point), bits(root.normal)))
}

/// Fails unless all ways to ask about the camera's pixels give the same answers. Returns the number of
/// hits.
fn ask(scene: &Scene, camera: &Camera) -> u32 {
    let Ok(resolved) = camera.resolve() else { return 0 };
    let raster = Raster::full(camera.image);
    let single = trace_as::<f32>(scene, &resolved, &raster, Outputs::default());
    let double = trace(scene, &resolved, &raster, Outputs { normal: true, ..Outputs::default() });
    let mut answers = Vec::new();
    for offset in 0..raster.len() {
        let (row, column) = (offset / raster.columns().len(), offset % raster.columns().len());
        let pixel = Pixel { row: row as u32, column: column as u32 };
        let ray = resolved.exact_ray(pixel);
        let first = scene.first_hit_of(&ray);
        let at = format!("{pixel:?} of {camera:?} in {scene:?}");

        let object = first.map(|hit| hit.object);
        assert_eq!(single.at(row, column).object, object, "the f32 frame, {at}");
        let traced = double.at(row, column);
        assert_eq!(traced.object, object, "the f64 frame, {at}");
        let t = first.map_or(f64::INFINITY, |hit| hit.t);
        assert_eq!(traced.t.to_bits(), t.to_bits(), "t of the f64 frame, {at}");
        let normal = first.map_or(DVec3::ZERO, |hit| hit.normal);
        assert_eq!(double.normal[offset], normal, "normals of the f64 frame, {at}");

        let inspection = Inspection::new(&resolved, scene, Selection::Pixel(pixel));
        assert_eq!(told(inspection.first_hit()), told(first.as_ref()), "inspect, {at}");
        let derivations = (0..).zip(scene.objects()).map(|(index, object)| {
            ObjectDerivation::new(&object, index, &ray).expect("an object of a scene")
        });
        for (index, derivation) in (0..).zip(derivations) {
            let own = inspection.roots.iter().filter(|root| root.object == index);
            let own: Vec<Told> = own.map(|root| told(Some(root))).collect();
            let derived: Vec<Told> = derivation.roots().map(|root| told(Some(root))).collect();
            assert_eq!(own, derived, "the derivation of object {index}, {at}");
            let is_hit = derivation.hit().is_some();
            let ahead = inspection.roots.iter().any(|root| root.object == index && root.t > 0.0);
            assert_eq!(is_hit, ahead, "the hit of object {index}, {at}");
        }
        let hit = first.map(|hit| GivenHit {
            t: Some(hit.t).filter(|t| t.is_finite()).map(Written::exactly),
            point: None,
            object: Some(hit.object),
        });
        answers.push(HitAnswer { pixel, hit });
    }
    let hits = answers.iter().filter(|answer| answer.hit.is_some()).count() as u32;
    let truth = Truth { camera, scene, color_of: &|_| [255; 3] };
    match grade(&truth, &Answers::Hits(answers), None) {
        Ok(grade) => {
            assert!(grade.wrong() == 0, "check: {} in {scene:?} by {camera:?}", grade.advice());
        }
        Err(error) => assert!(error.contains("is beyond the range of f64"), "{error}"),
    }
    hits
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => -3.0..3.0_f64,
        // Numbers that meet, touch and cancel exactly.
        2 => (-12..=12_i32).prop_map(|n| f64::from(n) / 4.0),
        1 => Just(0.0),
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

fn size() -> impl Strategy<Value = f64> {
    prop_oneof![0.1..4.0_f64, (1..=16_i32).prop_map(|n| f64::from(n) / 4.0)]
}

/// Objects that lie anywhere.
fn any_objects() -> impl Strategy<Value = (Vec<Sphere>, Vec<Plane>)> {
    let sphere = (point(), size()).prop_map(|(center, radius)| Sphere {
        center: center + DVec3::new(0.0, 0.0, -4.0),
        radius,
    });
    let plane = (point(), point()).prop_filter_map("a normal", |(point, normal)| {
        (normal != DVec3::ZERO).then_some(Plane { point, normal })
    });
    (prop::collection::vec(sphere, 1..6), prop::collection::vec(plane, 0..3))
}

/// Spheres that touch the view ray of some pixel: by Pythagoras, exactly, and within a rounding.
fn touching() -> impl Strategy<Value = (Vec<Sphere>, Vec<Plane>)> {
    let triples = vec![(3.0, 4.0, 5.0), (5.0, 12.0, 13.0), (8.0, 15.0, 17.0), (28.0, 45.0, 53.0)];
    let one = (prop::sample::select(triples), 1..4_i32, any::<bool>()).prop_map(
        |((radius, _, distance), shrunk, is_nudged)| {
            let scale = 2_f64.powi(-shrunk);
            let nudge = if is_nudged { 1.0 + f64::EPSILON } else { 1.0 };
            let center = DVec3::new(0.0, 0.0, -distance * scale);
            Sphere { center, radius: radius * scale * nudge }
        },
    );
    (prop::collection::vec(one, 1..5), Just(Vec::new()))
}

/// Spheres that differ by next to nothing.
fn alike() -> impl Strategy<Value = (Vec<Sphere>, Vec<Plane>)> {
    let nudge = || (-17..-8_i32, -1.0..1.0_f64).prop_map(|(k, x)| x * 10_f64.powi(k));
    let nudges = ([nudge(), nudge(), nudge()], prop_oneof![Just(0.0), nudge()]);
    (point(), size(), prop::collection::vec(nudges, 2..6)).prop_map(|(middle, radius, nudges)| {
        let one = |(offset, wider): ([f64; 3], f64)| Sphere {
            center: middle + DVec3::new(0.0, 0.0, -3.0) + DVec3::from_array(offset),
            radius: radius + wider,
        };
        (nudges.into_iter().map(one).collect(), Vec::new())
    })
}

/// Surfaces in one point, the eye or another: spheres that touch there, inside and outside, and the plane
/// between them, many of them equal and some 1 ulp apart.
fn meeting() -> impl Strategy<Value = (Vec<Sphere>, Vec<Plane>)> {
    let quadruples = vec![[0.0, 0.0, 1.0, 1.0], [3.0, 0.0, 4.0, 5.0], [2.0, -1.0, 2.0, 3.0]];
    let scale = || prop::sample::select(vec![-1.0, -0.5, 0.25, 0.5, 0.5, 1.0]);
    let sphere = (scale(), 0..8_usize, any::<bool>());
    let all = (prop::collection::vec(sphere, 1..5), prop::collection::vec(scale(), 0..3));
    let place = prop_oneof![Just(DVec3::ZERO), point()];
    (prop::sample::select(quadruples), place, all).prop_map(
        |([x, y, z, length], place, (spheres, planes))| {
            let normal = DVec3::new(x, y, z);
            let sphere = |(scale, nudged, is_up): (f64, usize, bool)| {
                let [x, y, z] = (place + scale * normal).to_array();
                let mut numbers = [x, y, z, scale.abs() * length];
                if let Some(x) = numbers.get_mut(nudged) {
                    *x = if is_up { x.next_up() } else { x.next_down() };
                }
                let [x, y, z, radius] = numbers;
                Sphere { center: DVec3::new(x, y, z), radius }
            };
            let plane = |scale: f64| Plane { point: place, normal: scale * normal };
            (spheres.into_iter().map(sphere).collect(), planes.into_iter().map(plane).collect())
        },
    )
}

/// The eye in the origin.
fn at_the_origin() -> impl Strategy<Value = DVec3> {
    Just(DVec3::ZERO)
}

/// Canonical and turned cameras, 4 x 3 pixels, with viewports of any size.
fn camera(eye: impl Strategy<Value = DVec3>) -> impl Strategy<Value = Camera> {
    let orientation = prop_oneof![
        Just(Camera::CANONICAL.orientation),
        (point(), point()).prop_map(|(view, up)| Orientation::View { view, up }),
        (point(), point()).prop_map(|(at, up)| Orientation::At { at, up }),
    ];
    let viewport = [size(), size(), size()];
    (eye, orientation, viewport).prop_map(|(eye, orientation, [width, height, distance])| Camera {
        eye,
        orientation,
        viewport: Viewport { width, height, distance },
        image: ImageSize::new(4, 3).unwrap(),
    })
}

/// Asks about random scenes and cameras, lengths times `world` and viewports times `view`.
fn ask_many(
    objects: impl Strategy<Value = (Vec<Sphere>, Vec<Plane>)>,
    eye: impl Strategy<Value = DVec3>,
    exponents: impl Strategy<Value = (i32, i32)>,
) {
    let number = |name| std::env::var(name).ok().and_then(|number| number.parse::<u64>().ok());
    let cases = number("PINHOLE_DOOR_SCENES").map_or(2000, |scenes| scenes / 6) as u32;
    let rng_seed = RngSeed::Fixed(number("PROPTEST_RNG_SEED").unwrap_or(1));
    let config = Config { cases, failure_persistence: None, rng_seed, ..Config::default() };
    let hits = Cell::new(0);
    let ask = |((spheres, planes), camera, (world, view)): ((Vec<_>, Vec<_>), Camera, _)| {
        let (world, view) = (2_f64.powi(world), 2_f64.powi(view));
        let sphere = |s: Sphere| Sphere { center: world * s.center, radius: world * s.radius };
        let plane = |p: Plane| Plane { point: world * p.point, ..p };
        let spheres = spheres.into_iter().map(sphere).collect();
        let Viewport { width, height, distance } = camera.viewport;
        let viewport =
            Viewport { width: view * width, height: view * height, distance: view * distance };
        let scene = Scene::new(spheres, planes.into_iter().map(plane).collect()).unwrap();
        let orientation = match camera.orientation {
            Orientation::At { at, up } => Orientation::At { at: world * at, up },
            other => other,
        };
        let camera = Camera { eye: world * camera.eye, orientation, viewport, ..camera };
        hits.set(hits.get() + ask(&scene, &camera));
        Ok(())
    };
    TestRunner::new(config).run(&(objects, camera(eye), exponents), ask).unwrap();
    assert!(hits.get() > cases / 2, "only {} hits", hits.get());
}

fn ordinary() -> impl Strategy<Value = (i32, i32)> {
    Just((0, 0))
}

#[test]
fn ordinary_scenes() {
    ask_many(any_objects(), point(), ordinary());
}

#[test]
fn scenes_that_touch_rays() {
    ask_many(touching(), at_the_origin(), ordinary());
}

#[test]
fn scenes_of_spheres_that_are_alike() {
    ask_many(alike(), point(), ordinary());
}

#[test]
fn scenes_of_surfaces_that_meet_in_a_point() {
    ask_many(meeting(), prop_oneof![at_the_origin(), point()], ordinary());
}

#[test]
fn huge_and_tiny_scenes() {
    ask_many(any_objects(), point(), (-900..900_i32, -1000..900_i32));
}

/// Where t leaves the range of `f32`, at both ends.
#[test]
fn scenes_at_the_ends_of_single_precision() {
    ask_many(any_objects(), at_the_origin(), (Just(0), prop_oneof![120..155_i32, -132..-120_i32]));
}

/// In no pixel of a built-in scene would a wrong answer pass.
#[test]
fn every_answer_about_a_built_in_scene_is_judged() {
    for document in BuiltinScene::all().iter().map(|scene| scene.load().unwrap()) {
        let (scene, resolved) = (document.scene().unwrap(), document.camera.resolve().unwrap());
        let raster = Raster::full(resolved.image());
        let single = trace_as::<f32>(&scene, &resolved, &raster, Outputs::default());
        let double = trace(&scene, &resolved, &raster, Outputs::default());
        let color_of = |object| document.color_of(object);
        let picture = shade(&double, &scene, Shade::Lambert, color_of, |color| color);
        let t = single.t.iter().map(|t| f64::from(*t)).chain(double.t);
        let hits = t.zip(single.object.into_iter().chain(double.object)).enumerate();
        let hits = hits.map(|(index, (t, object))| {
            let (index, width) = ((index % raster.len()) as u32, resolved.image().width());
            let pixel = Pixel { row: index / width, column: index % width };
            let given =
                GivenHit { t: Some(Written::exactly(t)), point: None, object: Some(object) };
            HitAnswer { pixel, hit: Some(given).filter(|_| object != NO_OBJECT) }
        });
        let truth = Truth { camera: &document.camera, scene: &scene, color_of: &color_of };
        for answers in [Answers::Hits(hits.collect()), Answers::Picture(picture)] {
            assert!(grade(&truth, &answers, None).unwrap().all_agree());
        }
    }
}

/// Scenes with their digests, for `tests/page/run.py`, which asks a page for the same: step 3 of lesson 7, the
/// built-in ones and 1000 random ones. `PINHOLE_PAGE_SCENES` names the file to write.
#[test]
fn pictures_have_the_digest_of_what_is_read_back() {
    let mut scenes: Vec<(String, String)> = Vec::new();
    let mut add = |document: &Document| {
        let Ok(digest) = picture_digest(document) else { return };
        let text = scene_file::to_text(document, None);
        let read = scene_file::parse(&text, Path::new("scene.toml"), Path::new("")).unwrap();
        assert_eq!(picture_digest(&read), Ok(digest), "{text}");
        scenes.push((text, format!("{digest:016x}")));
    };
    let (step, _) = LessonArgument::parse("7.3").unwrap().load().unwrap();
    add(&OpenLesson::at(step, None).unwrap().step().document);
    BuiltinScene::all().iter().for_each(|scene| add(&scene.load().unwrap()));
    let objects = prop_oneof![any_objects(), touching(), alike(), meeting()];
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1), ..Config::default() });
    for _ in 0..1000 {
        let drawn = (&objects, camera(point())).new_tree(&mut runner).unwrap().current();
        let ((spheres, planes), camera) = drawn;
        let image = ImageSize::new(64, 48).unwrap();
        add(&Document {
            camera: Camera { image, ..camera },
            spheres: spheres.into_iter().map(Item::plain).collect::<Vec<_>>().into(),
            planes: planes.into_iter().map(Item::plain).collect::<Vec<_>>().into(),
            ..Document::default()
        });
    }
    assert!(scenes.len() > 900, "only {} scenes", scenes.len());
    if let Some(path) = std::env::var_os("PINHOLE_PAGE_SCENES") {
        std::fs::write(path, serde_json::to_string(&scenes).unwrap()).unwrap();
    }
}
