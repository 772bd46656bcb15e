//! A table of the errors of every method in the lecture's ordinary cases, so that a change of accuracy
//! shows as a difference in the file.
//!
//! `UPDATE_EXPECT=1 cargo test -p pinhole-core --test core everyday` writes `everyday.txt` anew. No
//! number in it depends on the machine, since only the operations of IEEE 754 are used: `+ - * /`,
//! `sqrt` and fused multiply-add.

use std::fmt::Write;

use expect_test::expect_file;
use pinhole_core::methods::{Method, Precision};
use pinhole_core::*;
use pinhole_reference::{Camera as GivenCamera, Hit, Object, Orientation as Given};

use crate::common::{first_hit_by, given};

/// The ray of a case: given by its numbers, or through a point or a pixel of a camera's viewport.
#[derive(Clone, Copy)]
enum Asked {
    Ray([f64; 3], [f64; 3]),
    Uv(GivenCamera, f64, f64),
    Pixel(GivenCamera, u32, u32),
}

struct Case {
    name: &'static str,
    objects: Vec<Object>,
    asked: Asked,
}

const ORIGIN: [f64; 3] = [0.0; 3];

fn ball(center: [f64; 3], radius: f64) -> Object {
    Object::Sphere { center, radius }
}

fn wall(point: [f64; 3], normal: [f64; 3]) -> Object {
    Object::Plane { point, normal }
}

const CANONICAL: GivenCamera = GivenCamera {
    eye: ORIGIN,
    orientation: Given::At { at: [0.0, 0.0, -1.0], up: [0.0, 1.0, 0.0] },
    width: 1.0,
    height: 1.0,
    distance: 1.0,
    columns: 400,
    rows: 400,
};

const UP: [f64; 3] = [0.0, 1.0, 0.0];

fn lecture() -> Vec<Case> {
    let case = |name, object, asked| Case { name, objects: vec![object], asked };
    let the_ball = ball([0.0, 0.0, -5.0], 1.0);
    let the_wall = wall([0.0, 0.0, -6.0], [0.0, 0.0, 1.0]);
    let far = GivenCamera { distance: 2.0, ..CANONICAL };
    let turned = Given::View { view: [-1.0, 0.0, -1.0], up: UP };
    let turned = GivenCamera { orientation: turned, ..CANONICAL };
    let exercise = Given::At { at: [-1.0, 0.0, -5.0], up: UP };
    let exercise = GivenCamera { eye: [20.0, 4.0, 10.0], orientation: exercise, ..CANONICAL };
    let exercise_ball = ball([-1.0, 0.0, -5.0], 2.0);
    vec![
        case("ball, through (0, 0)", the_ball, Asked::Uv(CANONICAL, 0.0, 0.0)),
        case("ball, pixel in the middle", the_ball, Asked::Pixel(CANONICAL, 200, 200)),
        case("ball, last pixel on it", the_ball, Asked::Pixel(CANONICAL, 200, 281)),
        case("ball, first pixel beside it", the_ball, Asked::Pixel(CANONICAL, 200, 282)),
        case("warm-up 1a, ball", the_ball, Asked::Uv(CANONICAL, 0.2, -0.1)),
        case("warm-up 1b, wall", the_wall, Asked::Uv(CANONICAL, 0.2, -0.1)),
        case("warm-up, distance 2, wall", the_wall, Asked::Uv(far, 0.2, -0.1)),
        case("45 degrees, wall", the_wall, Asked::Uv(turned, 0.2, -0.1)),
        case("45 degrees, ball", ball([-5.0, 0.0, -5.0], 1.0), Asked::Uv(turned, 0.05, -0.1)),
        case("exercise, ball at at", exercise_ball, Asked::Uv(exercise, 0.0, 0.0)),
        case("exercise, ball's side", exercise_ball, Asked::Uv(exercise, 0.05, -0.02)),
        case("exercise, ball's edge", exercise_ball, Asked::Uv(exercise, 0.0765, 0.0)),
    ]
}

fn others() -> Vec<Case> {
    let of_ray = |name, object, direction| {
        let asked = Asked::Ray(ORIGIN, direction);
        Case { name, objects: vec![object], asked }
    };
    let at_the_wall = |name, z| {
        let objects = vec![ball([0.0, 0.0, -5.0], 1.0), wall([0.0, 0.0, z], [0.0, 0.0, 1.0])];
        Case { name, objects, asked: Asked::Ray(ORIGIN, [0.0, 0.0, -1.0]) }
    };
    let floor = ball([0.0, -5001.0, 0.0], 5000.0);
    let around = ball([0.0, 0.0, -1.0], 3.0);
    let ahead = [0.0, 0.0, -1.0];
    let beside = |y| ball([0.0, y, -5.0], 1.0);
    let (level, slanted) = (wall([0.0, -1.0, 0.0], UP), wall([0.0, -1.0, 0.0], [0.1, 1.0, 0.05]));
    vec![
        of_ray("course's floor, 45 degrees down", floor, [0.0, -1.0, -1.0]),
        of_ray("course's floor, 3 in 10 down", floor, [0.0, -0.3, -1.0]),
        of_ray("course's floor, 1 in 20 down", floor, [0.0, -0.05, -1.0]),
        of_ray("course's floor, at the horizon", floor, [0.0, -0.0201, -1.0]),
        of_ray("course's floor, above the horizon", floor, [0.0, -0.0199, -1.0]),
        of_ray("inside, ahead", around, ahead),
        of_ray("inside, aside", around, [0.3, 0.2, -1.0]),
        of_ray("radius 1 at 100", ball([0.0, 0.0, -100.0], 1.0), [0.003, 0.002, -1.0]),
        of_ray(
            "radius 1 at 100, near the edge",
            ball([0.0, 0.0, -100.0], 1.0),
            [0.0099, 0.0, -1.0],
        ),
        of_ray("radius 1 at 1000", ball([0.0, 0.0, -1000.0], 1.0), [0.0003, 0.0002, -1.0]),
        of_ray(
            "radius 1 at 1000, near the edge",
            ball([0.0, 0.0, -1000.0], 1.0),
            [0.00099, 0.0, -1.0],
        ),
        of_ray("1e-3 of the radius inside the edge", beside(1.0 - 1e-3), ahead),
        of_ray("1e-3 outside", beside(1.0 + 1e-3), ahead),
        of_ray("1e-6 inside", beside(1.0 - 1e-6), ahead),
        of_ray("1e-6 outside", beside(1.0 + 1e-6), ahead),
        of_ray("1e-8 inside", beside(1.0 - 1e-8), ahead),
        of_ray("1e-8 outside", beside(1.0 + 1e-8), ahead),
        of_ray("1e-6 inside, slanted", ball([1.0 - 1e-6, 1.5, -4.5], 1.0), [0.0, 0.1, -0.3]),
        of_ray("plane, 1e-6 from parallel", level, [0.3, -1e-6, -1.0]),
        of_ray("slanted plane, 1e-6 from parallel", slanted, [1.0, -0.100001, 0.0]),
        of_ray("slanted plane, 1e-6 on the other side", slanted, [1.0, -0.099999, 0.0]),
        at_the_wall("ball 1e-5 before a wall", -4.00001),
        at_the_wall("ball 1e-7 behind a wall", -3.9999999),
    ]
}

impl Case {
    fn truth(&self) -> Option<Hit> {
        match self.asked {
            Asked::Ray(origin, direction) => {
                pinhole_reference::first_hit(&self.objects, origin, direction)
            }
            Asked::Uv(camera, u, v) => camera.prepare(&self.objects).ok()?.first_hit_of_uv(u, v),
            Asked::Pixel(camera, row, column) => {
                camera.prepare(&self.objects).ok()?.first_hit_of_pixel(row, column)
            }
        }
    }

    /// Returns the object and the t that a method finds. The ladder (this crate's exact method) gets
    /// the exact ray, the others the ray rounded to `f64`.
    fn found(&self, method: Method) -> Option<(u32, f64)> {
        let scene = given::scene(&self.objects);
        let hit = |exact: &ExactRay, rounded: &Ray| match method {
            Method::Ladder => scene.first_hit_of(exact).map(|hit| (hit.object, hit.t)),
            known => first_hit_by(known, &scene, rounded).map(|hit| (hit.object, hit.t)),
        };
        match self.asked {
            Asked::Ray(origin, direction) => {
                let ray = Ray::new(origin, direction).unwrap();
                hit(&ExactRay::from_ray(&ray).unwrap(), &ray)
            }
            Asked::Uv(camera, u, v) => {
                let (camera, uv) = (given::camera(&camera).resolve().unwrap(), DVec2::new(u, v));
                hit(&camera.exact_ray_at(uv).unwrap(), &camera.ray(uv))
            }
            Asked::Pixel(camera, row, column) => {
                let camera = given::camera(&camera).resolve().unwrap();
                let pixel = Pixel { row, column };
                hit(&camera.exact_ray(pixel), &camera.ray_of_pixel(pixel))
            }
        }
    }

    /// Returns the text of a table cell: the error of t in ulps of the method's own precision, `miss`
    /// for a right miss, or `wrong` for a wrong hit or miss.
    fn cell(&self, method: Method) -> String {
        let truth = self.truth();
        let (truth, t) = match (&truth, self.found(method)) {
            (None, None) => return "miss".to_owned(),
            (Some(truth), Some((object, t))) if truth.object == object as usize => (truth, t),
            _ => return "wrong".to_owned(),
        };
        let ulps = match method.precision() {
            Precision::F32 => truth.t.ulps_from_f32(t as f32),
            Precision::F64 => truth.t.ulps_from(t),
        };
        if ulps < 1000.0 { format!("{ulps:.3}") } else { format!("{ulps:.3e}") }
    }
}

/// Returns the table of one precision, with a column for each method and a row for each case.
fn table(precision: Precision, cases: &[Case]) -> String {
    let methods: Vec<Method> =
        Method::all().filter(|method| method.precision() == precision).collect();
    let mut text = format!("{:43} {:>12}", "", "t");
    let short = |method: &Method| {
        let name = method.name();
        name.trim_end_matches("-f32").trim_end_matches("-f64").to_owned()
    };
    for method in &methods {
        write!(text, " {:>13}", short(method)).unwrap();
    }
    for case in cases {
        let t =
            case.truth().map_or_else(|| "miss".to_owned(), |hit| format!("{:.4}", hit.t.to_f64()));
        write!(text, "\n{:43} {t:>12}", case.name).unwrap();
        for method in &methods {
            write!(text, " {:>13}", case.cell(*method)).unwrap();
        }
    }
    text
}

#[test]
fn everyday_cases() {
    let cases = [lecture(), others()].into_iter().flatten().collect::<Vec<_>>();
    for case in &cases {
        let cell = case.cell(Method::Ladder);
        let is_right = cell == "miss" || cell.parse().is_ok_and(|ulps: f64| ulps <= 0.5);
        assert!(is_right, "{}: {cell}", case.name);
    }
    let [single, double] =
        [Precision::F32, Precision::F64].map(|precision| table(precision, &cases));
    let text = format!(
        "Error of t in ulps of f64, of the methods in f64. \"wrong\" is a wrong decision.\n\n{double}\n\n\
         Error of t in ulps of f32, of the methods in f32: what is given is rounded to it, too.\n\n\
         {single}\n"
    );
    expect_file!["everyday.txt"].assert_eq(&text);
}
