//! Tests that the benchmark's rivals see the same as `pinhole-core` (called the ladder), as far as
//! `f32` allows.

use std::path::Path;
use std::time::Duration;

use pinhole_core::*;

use super::bench::bvh::Bvh;
use super::bench::contest::{self, Limits};
use super::bench::frames::Buffers;
use super::bench::rig::Program;
use super::bench::{Setting, adversarial, check, scenes, textbook};

fn ladder(setting: &Setting) -> Frame<f32> {
    let camera = setting.camera(0);
    trace_as(&setting.scene, &camera, &Raster::full(camera.image()), Outputs::default())
}

/// Returns the share of pixels whose object, and whose t up to a relative error of 1e-3, are those of
/// `pinhole-core`.
fn agreement(setting: &Setting, buffers: &Buffers) -> f64 {
    let truth = ladder(setting);
    let pairs = truth.t.iter().zip(&truth.object).zip(buffers.t.iter().zip(&buffers.object));
    let is_same = |((t, object), (other_t, other)): &((&f32, &u32), (&f32, &u32))| {
        object == other && (t == other_t || (*t - *other_t).abs() < 1e-3 * *t)
    };
    pairs.filter(is_same).count() as f64 / truth.t.len() as f64
}

fn rivals(setting: &Setting) -> [Buffers; 2] {
    let mut both = [Buffers::new(setting.image()), Buffers::new(setting.image())];
    let camera = setting.camera(0);
    textbook::trace(&textbook::balls(&setting.scene), &camera, &mut both[0]);
    Bvh::new(&setting.scene).trace(&camera, &mut both[1]);
    both
}

#[test]
fn rivals_agree_with_the_ladder_on_nearly_all_pixels() {
    for count in [0, 1, 3, 10, 1000] {
        let setting = scenes::spheres_at(count, 0.6, 1.0).with_image(160, 90);
        let [plain, tree] = rivals(&setting);
        for buffers in [&plain, &tree] {
            let same = agreement(&setting, buffers);
            assert!(same > 0.995, "{count} spheres: {same}");
        }
        assert!(check::alike(&plain.object, &tree.object) > 0.9999);
    }
}

#[test]
fn a_tree_holds_spheres_of_all_sizes_and_many_in_one_place() {
    for name in ["eye-plane", "in-sphere", "planet"] {
        let setting = adversarial::all().into_iter().find(|listed| listed.name == name).unwrap();
        let setting = (setting.make)().with_image(60, 40);
        let [plain, tree] = rivals(&setting);
        assert!(check::alike(&plain.object, &tree.object) > 0.99, "{name}");
    }
    let same = vec![Sphere::new([0.0, 0.0, -5.0], 1.0).unwrap(); 1000];
    let setting = Setting::new(same, Camera::CANONICAL).with_image(20, 20);
    let [plain, tree] = rivals(&setting);
    assert_eq!(plain.object, tree.object);
    assert!(tree.object.contains(&0), "of equals the first listed");
}

/// Tests the C++ program that only writes a frame with streaming stores. Without a compiler, the test
/// passes.
#[test]
fn streaming_stores_reach_every_pixel_on_any_number_of_threads() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stores");
    let Ok(program) = Program::stores(&folder) else { return };
    let setting = scenes::spheres_at(1, 0.6, 1.0).with_image(37, 5);
    let mut rig = program.start(&setting).unwrap();
    let cameras = [setting.camera(0), setting.camera(1)];
    for threads in 1..4 {
        assert_eq!(rig.frames(0, threads, &cameras).unwrap().len(), 2);
        let lines: Vec<u32> = (0..37 * 5).map(|pixel| pixel / 16).collect();
        assert_eq!(rig.objects().unwrap(), lines);
    }
}

#[test]
fn embree_sees_what_the_ladder_sees_where_it_is_installed() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("embree");
    let Ok(program) = Program::embree(&folder) else { return };
    let setting = scenes::spheres_at(1000, 0.6, 1.0).with_image(161, 91);
    let (mut rig, truth) = (program.start(&setting).unwrap(), ladder(&setting));
    for mode in 0..rig.modes.len() {
        rig.frames(mode, 2, &[setting.camera(1), setting.camera(0)]).unwrap();
        let same = check::alike(&truth.object, &rig.objects().unwrap());
        assert!(same > 0.999, "{}: {same}", rig.modes[mode]);
    }
}

#[test]
fn a_contest_is_among_those_who_are_quick_enough() {
    let limits = Limits { share: Duration::from_millis(1), most: 3, ..Limits::default() };
    let names = |count: usize, limits: &Limits| -> Vec<&str> {
        let setting = scenes::spheres_at(count, 0.6, 1.0).with_image(40, 30);
        let outcome = contest::run(&setting, limits, &mut []);
        assert_eq!(outcome.frame.object.len(), 1200);
        assert!(outcome.rows.iter().all(|(_, times)| times.count > 0 && times.min > 0.0));
        outcome.rows.into_iter().map(|(name, _)| name).collect()
    };
    assert_eq!(names(10, &limits), ["ladder", "textbook"]);
    assert_eq!(names(1000, &limits), ["ladder", "textbook-bvh"]);
    assert_eq!(names(100, &limits)[1..3], ["textbook", "textbook-bvh"]);
    let impatient = Limits { patience: Duration::ZERO, ..limits };
    assert_eq!(names(100, &impatient), ["ladder"]);
}

#[test]
fn a_wrong_pixel_is_found() {
    let setting = scenes::spheres_at(3, 0.6, 1.0).with_image(64, 36);
    let frame = ladder(&setting);
    assert_eq!(check::sample(&setting.scene, &frame, 500, 1), Ok(()));
    let change = |change: &dyn Fn(&mut Frame<f32>, usize)| {
        let mut frame = frame.clone();
        let is_hit = |k: &usize| frame.t[*k].is_finite();
        let hits: Vec<usize> = (0..frame.t.len()).filter(is_hit).collect();
        hits.into_iter().for_each(|k| change(&mut frame, k));
        check::sample(&setting.scene, &frame, 100, 1)
    };
    assert_eq!(change(&|frame, k| frame.t[k] = frame.t[k].next_up()), Ok(()));
    assert!(change(&|frame, k| frame.t[k] = frame.t[k].next_up().next_up()).is_err());
    assert!(change(&|frame, k| frame.object[k] ^= 1).is_err());
    assert!(change(&|frame, k| frame.t[k] = f32::NAN).is_err());
    let mut frame = frame;
    frame.t.iter_mut().filter(|t| t.is_infinite()).for_each(|t| *t = f32::MAX);
    assert!(check::sample(&setting.scene, &frame, 500, 1).is_err());
}
