//! The measuring engine: what it counts, in slices, on small scenes.

use pinhole::report::measure::Measurement;
use pinhole::report::model::{Case, Digits, MethodRow, Report, SINGLE};
use pinhole_core::methods::Method;
use pinhole_core::{Camera, DVec3, ImageSize, Plane, Scene, Sphere, Viewport};

fn sphere(center: [f64; 3], radius: f64) -> Sphere {
    Sphere { center: DVec3::from_array(center), radius }
}

fn small_camera() -> Camera {
    Camera { image: ImageSize::new(24, 20).unwrap(), ..Camera::CANONICAL }
}

fn run_of(spheres: &[Sphere], planes: &[Plane]) -> Measurement {
    let scene = Scene::new(spheres.to_vec(), planes.to_vec()).unwrap();
    Measurement::of_scene("small", &scene, &small_camera()).unwrap()
}

fn finished(mut run: Measurement) -> Report {
    while !run.is_done() {
        run.step();
    }
    assert_eq!(run.done(), run.total());
    run.report()
}

fn row<'a>(case: &'a Case, name: &str) -> &'a MethodRow {
    case.methods.iter().find(|row| row.name == name).unwrap()
}

fn floor() -> Plane {
    Plane { point: DVec3::new(0.0, -1.0, 0.0), normal: DVec3::Y }
}

#[test]
fn a_small_scene_is_measured_whole() {
    let ball = sphere([0.25, 0.0, -5.0], 1.0);
    let report = finished(run_of(&[ball], &[]));
    let [case] = report.cases.as_slice() else { panic!("{report:?}") };
    assert_eq!((case.name.as_str(), case.knob), ("small", None));
    assert!((0.05..0.2).contains(&case.coverage), "{}", case.coverage);
    let names: Vec<_> = case.methods.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names, Method::of_frames().map(Method::name).collect::<Vec<_>>());
    for row in &case.methods {
        assert_eq!(row.decisions, 24 * 20, "{}", row.name);
        let (median, max) = (row.ulp.median.unwrap(), row.ulp.max.unwrap());
        assert!(median <= row.ulp.p99.unwrap() && row.ulp.p99.unwrap() <= max, "{row:?}");
        assert!(max < 1000.0 && row.ulp_f64.max.unwrap() >= max, "{row:?}");
        let times = row.ns_per_pixel;
        assert!(0.0 < times.min.unwrap() && times.min <= times.median, "{row:?}");
        assert!(
            row.normal_error_max.unwrap()
                < if row.digits() == Digits::Single { 1e-2 } else { 1e-10 }
        );
    }
    for ladder in [row(case, "ladder"), row(case, "ladder-f32")] {
        assert_eq!(ladder.wrong, 0);
        assert!(ladder.steps.is_some());
    }
    // What a method loses is told from what the problem does.
    let condition = case.condition.unwrap();
    assert!(1.0 < condition.median && condition.median < condition.max, "{condition:?}");
    for row in &case.methods {
        let bound = condition.max * row.backward_error_max.unwrap();
        assert!(row.ulp_f64.max.unwrap() <= 1.01 * bound, "{row:?} {bound}");
    }
    // Every t of the ladder is rounded from more digits than f64 has; the picture's comes with the
    // decision.
    let of_t = |name: &str| row(case, name).steps_of_t.unwrap();
    assert_eq!((of_t("ladder").f64, of_t("ladder").exact), (0, 0));
    assert_eq!(of_t("ladder").double_double, (case.coverage * 480.0).round() as u64);
    assert_eq!(of_t("ladder-f32"), Default::default());
    // An ulp of the picture's f32, on the scale of all others.
    let picture = row(case, "ladder-f32");
    assert!(picture.ulp.max.unwrap() <= 1.0, "{picture:?}");
    assert_eq!(picture.ulp_f64.max.unwrap(), picture.ulp.max.unwrap() * SINGLE);
    assert_eq!(row(case, "textbook-f64").ulp_f64, row(case, "textbook-f64").ulp);
    assert!(case.methods.iter().all(|row| row.pixels_timed == 24 * 20));
    assert!(report.cpu.contains(std::env::consts::ARCH), "{}", report.cpu);
    assert!(report.baseline.starts_with("textbook-f32"), "{}", report.baseline);
    assert!(report.reference.starts_with("arbitrary precision"), "{}", report.reference);
}

/// In f32 the eye is on the sphere, so that the root right ahead of it is lost, and the far one taken.
#[test]
fn another_root_of_the_same_object_is_a_wrong_decision() {
    let ball = sphere([0.0, 0.0, -1.0 - 1e-9], 1.0);
    let report = finished(run_of(&[ball], &[]));
    let case = &report.cases[0];
    let [single, double] = ["textbook-f32", "textbook-f64"].map(|name| row(case, name));
    assert!(single.wrong > 100, "{single:?}");
    assert!(double.wrong < 10 && double.ulp.max.unwrap() > 1e6, "{double:?}");
    assert_eq!(row(case, "ladder").wrong, 0);
}

/// No t of this scene is a number of f32, though the picture's every pixel is right.
#[test]
fn t_out_of_range_is_counted_and_in_no_error() {
    let ball = sphere([0.0, 0.0, -5e60], 1e60);
    let report = finished(run_of(&[ball], &[]));
    let case = &report.cases[0];
    let picture = row(case, "ladder-f32");
    assert_eq!((picture.wrong, picture.ulp.max, picture.backward_error_max), (0, None, None));
    assert_eq!(picture.t_out_of_range, (480.0 * case.coverage).round() as u64);
    assert_eq!(row(case, "ladder").t_out_of_range, 0);
}

/// The horizon of a sphere of radius 10,000, from 1/4096 above: in single precision the eye is on
/// it, and every ray below the horizontal hits.
#[test]
fn the_textbook_is_wrong_on_a_planet_and_the_ladder_is_not() {
    let height = 1.0 / 4096.0;
    let planet = Scene::new(vec![sphere([0.0, -1e4 - height, 0.0], 1e4)], vec![]).unwrap();
    let viewport = Viewport { width: 0.001, height: 0.001, distance: 1.0 };
    let camera = Camera { viewport, ..small_camera() };
    let report = finished(Measurement::of_scene("planet", &planet, &camera).unwrap());
    let case = &report.cases[0];
    let textbook = row(case, "textbook-f32");
    assert!(textbook.wrong > 20, "{textbook:?}");
    let ladder = row(case, "ladder");
    assert_eq!((ladder.wrong, ladder.decisions), (0, 480));
    assert!(ladder.ulp.max.unwrap() <= row(case, "textbook-f64").ulp.max.unwrap());
}

#[test]
fn what_a_scene_does_not_have_is_left_out_in_words() {
    let says = |report: &Report, what: &str| report.left_out == [format!("small: {what}")];
    let ball = sphere([0.0, 0.0, -5.0], 1.0);
    assert_eq!(finished(run_of(&[ball], &[floor()])).left_out, [""; 0]);

    let report = finished(run_of(&[], &[floor()]));
    let reason = "the scene has no spheres; all methods but the ladder share the textbook's plane";
    assert!(says(&report, &format!("no sphere rows: {reason}")), "{:?}", report.left_out);
    let planes: Vec<_> = report.cases[0].methods.iter().map(|row| row.name.as_str()).collect();
    assert!(planes.contains(&"ladder") && planes.contains(&"textbook-f32"), "{planes:?}");
    assert!(!planes.contains(&"kahan-f32"), "{planes:?}");

    let report = finished(run_of(&[], &[]));
    assert!(says(&report, "no sphere rows: the scene is empty"), "{:?}", report.left_out);
    assert_eq!(report.cases[0].coverage, 0.0);
}

#[test]
fn a_partial_report_is_one_too() {
    let mut run = run_of(&[sphere([0.0, 0.0, -5.0], 1.0)], &[floor()]);
    assert_eq!(run.report().cases, []);
    assert_eq!(run.done(), 0);
    let mut last = 0;
    for _ in 0..3 {
        run.step();
        let report = run.report();
        assert!(last <= run.done() && run.done() <= run.total());
        last = run.done();
        serde_json::to_string_pretty(&report).unwrap();
        for row in report.cases.iter().flat_map(|case| &case.methods) {
            assert!(row.wrong <= row.decisions, "{row:?}");
        }
    }
    let case = &run.report().cases[0];
    assert!((1..=480).contains(&case.methods[0].decisions), "{case:?}");
}

#[test]
fn a_camera_that_sees_nothing_is_refused() {
    let camera = Camera { eye: DVec3::NEG_Z, ..small_camera() };
    assert!(Measurement::of_scene("small", &Scene::default(), &camera).is_err());
}

#[test]
fn families_begin_with_the_ordinary_one() {
    let mut run = Measurement::of_families(1);
    while run.report().cases.len() < 2 {
        run.step();
    }
    assert!(0 < run.done() && run.done() < run.total());
    let report = run.report();
    let case = &report.cases[0];
    assert_eq!((case.name.as_str(), case.knob), ("ordinary", Some(0.0)));
    assert!(!case.knob_name.is_empty() && case.about.ends_with('.'), "{case:?}");
    assert!(case.condition.is_some());
    assert_eq!((report.seed, report.notes.len()), (Some(1), 1));
    assert!(report.notes[0].contains("rounds what it is given to f32"), "{:?}", report.notes);
    for row in &case.methods {
        assert!(row.decisions > 0 && row.wrong == 0, "{row:?}");
        assert!(row.ns_per_pixel.median.is_some(), "{row:?}");
    }
    // A frame's method has no single rays to follow, and the report says so.
    assert!(case.methods.iter().all(|row| row.name != "ladder-f32"));
    assert!(report.left_out.iter().any(|line| line.starts_with("ladder-f32 in the families")));
}

/// What is compared depends on the scene alone, not on how busy the machine is: all but the times is the
/// same again.
#[test]
fn a_second_run_says_the_same_of_everything_but_time() {
    let timeless = || {
        let mut report = finished(run_of(&[sphere([0.25, 0.0, -5.0], 1.0)], &[floor()]));
        let rows = report.cases.iter_mut().flat_map(|case| &mut case.methods);
        rows.for_each(|row| row.ns_per_pixel = Default::default());
        report
    };
    assert_eq!(timeless(), timeless());
}

/// Of a large picture, some pixels are compared, spread evenly, and the report says so.
#[test]
fn of_a_large_picture_some_pixels_are_compared() {
    let image = ImageSize::new(400, 400).unwrap();
    let viewport = Viewport { width: 0.006, height: 0.006, distance: 1.0 };
    let camera = Camera { image, viewport, ..Camera::CANONICAL };
    // A far, tiny ball: in f32 the textbook is wrong at its outline, if anywhere.
    let scene = Scene::new(vec![sphere([0.0, 0.0, -5000.0], 10.0)], vec![]).unwrap();
    let report = finished(Measurement::of_scene("far", &scene, &camera).unwrap());
    let textbook = row(&report.cases[0], "textbook-f32");
    assert_eq!(textbook.decisions, 240 * 240);
    let share = textbook.wrong as f64 / textbook.decisions as f64;
    assert!(textbook.wrong > 0 && textbook.wrong_share == Some(share), "{textbook:?}");
    assert!(report.left_out.iter().any(|line| line.contains("were not compared with the truth")));
}
