//! Cameras: answers that are known without a computer.

use pinhole_reference::{Camera, Hit, Object, Orientation, Real, Status, angle_between, basis};

use crate::common::margins;

const UP: [f64; 3] = [0.0, 1.0, 0.0];

fn camera(eye: [f64; 3], orientation: Orientation) -> Camera {
    Camera { eye, orientation, width: 1.0, height: 1.0, distance: 1.0, columns: 400, rows: 400 }
}

fn canonical() -> Camera {
    camera([0.0; 3], Orientation::View { view: [0.0, 0.0, -1.0], up: UP })
}

fn turned() -> Camera {
    camera([0.0; 3], Orientation::View { view: [-3.0, 0.0, -3.0], up: UP })
}

fn wall() -> Object {
    Object::Plane { point: [0.0, 0.0, -6.0], normal: [0.0, 0.0, 1.0] }
}

fn hit_of_uv(camera: &Camera, object: Object, u: f64, v: f64) -> Option<Hit> {
    camera.prepare(&[object]).unwrap().first_hit_of_uv(u, v)
}

fn floats(v: &[Real; 3]) -> [f64; 3] {
    v.clone().map(|x| x.to_f64())
}

#[test]
fn the_lectures_warm_up() {
    let hit = hit_of_uv(&canonical(), wall(), 0.2, -0.1).unwrap();
    assert_eq!(hit.t.to_f64(), 6.0);
    assert_eq!(floats(&hit.point), [6.0 * 0.2, 6.0 * -0.1, -6.0]);
    let far = Camera { distance: 2.0, ..canonical() };
    let hit = hit_of_uv(&far, wall(), 0.2, -0.1).unwrap();
    assert_eq!(hit.t.to_f64(), 3.0);
    let ball = Object::Sphere { center: [0.0, 0.0, -5.0], radius: 1.0 };
    assert_eq!(hit_of_uv(&canonical(), ball, 0.0, 0.0).unwrap().t.to_f64(), 4.0);
    assert_eq!(hit_of_uv(&canonical(), ball, 0.2, -0.1), None);
}

#[test]
fn the_lectures_camera_at_45_degrees() {
    let s = 0.5_f64.sqrt();
    let [u, v, w] = basis([0.0; 3], &turned().orientation).unwrap();
    assert_eq!([floats(&u), floats(&v), floats(&w)], [[s, 0.0, -s], UP, [s, 0.0, s]]);
    // s itself is no double.
    assert!(u[0].ulps_from(s) > 0.0 && u[0].ulps_from(s) < 0.5);
    let hit = hit_of_uv(&turned(), wall(), 0.2, -0.1).unwrap();
    assert_eq!(hit.t.to_f64(), 50.0_f64.sqrt());
    // 0.2 as given is not 1/5: the point is only near (-4, -sqrt(2)/2, -6).
    for (x, known) in floats(&hit.point).into_iter().zip([-4.0, -s, -6.0]) {
        assert!((x - known).abs() < 1e-15 * 6.0, "{x} {known}");
    }
    assert_eq!(hit.point[2].ulps_from(-6.0), 0.0);
}

#[test]
fn a_pixels_centre_is_where_the_lecture_says() {
    let view = canonical().prepare(&[]).unwrap();
    let [x, y, z] = view.direction_of_pixel(99, 199);
    assert_eq!([x.to_f64(), y.to_f64(), z.to_f64()], [-1.0 / 800.0, 201.0 / 800.0, -1.0]);
    // Columns and rows are told apart, and neither has to be a power of two.
    let wide = Camera { columns: 3, rows: 5, width: 3.0, height: 10.0, ..canonical() };
    let view = wide.prepare(&[]).unwrap();
    assert_eq!(floats(&view.direction_of_pixel(0, 0)), [-1.0, 4.0, -1.0]);
    assert_eq!(floats(&view.direction_of_pixel(4, 2)), [1.0, -4.0, -1.0]);
}

#[test]
fn bases_known_from_the_lecture() {
    let down = Orientation::View { view: [0.0, -1.0, 0.0], up: [1.0, 1.0, 0.0] };
    let [u, v, w] = basis([0.0; 3], &down).unwrap();
    assert_eq!([floats(&u), floats(&v), floats(&w)], [[0., 0., 1.], [1., 0., 0.], [0., 1., 0.]]);
    let [u, _, w] =
        basis([20.0, 4.0, 10.0], &Orientation::At { at: [-1.0, 0.0, -5.0], up: UP }).unwrap();
    assert!(angle_between(&u, [5.0, 0.0, -7.0]) < 1e-130);
    assert!(angle_between(&w, [21.0, 4.0, 15.0]) < 1e-130);
    assert!(u[0].ulps_from(5.0 / 74.0_f64.sqrt()) < 1.5);
}

#[test]
fn where_there_is_no_basis() {
    let status = |eye, orientation| basis(eye, &orientation).err();
    let point = [1.0, 2.0, 3.0];
    assert_eq!(status(point, Orientation::At { at: point, up: UP }), Some(Status::EyeIsAt));
    let view = Orientation::View { view: [0.0, -0.0, 0.0], up: [0.0; 3] };
    assert_eq!(status(point, view), Some(Status::ViewIsZero));
    let view = Orientation::View { view: point, up: [0.0; 3] };
    assert_eq!(status(point, view), Some(Status::UpIsZero));
    let view = Orientation::View { view: point, up: [-2.0, -4.0, -6.0] };
    assert_eq!(status(point, view), Some(Status::UpParallelToView));
    // One unit in the last place is a basis; so is what cancels in f64.
    let view = Orientation::View { view: point, up: [2.0, 4.0, 6.0_f64.next_up()] };
    assert_eq!(status(point, view), None);
    let at = Orientation::At { at: [1e300, 1.0, 0.0], up: [1e300, 1.0, 0.0] };
    assert_eq!(status([1e-300, 0.0, 0.0], at), None);
}

#[test]
fn a_basis_by_hand_is_taken_as_it_is() {
    let by_hand = Orientation::Basis { u: [2.0, 0.0, 0.0], v: [0.0, 1.0, 0.5], w: [0.0, 0.0, 1.0] };
    let view = camera([0.0; 3], by_hand).prepare(&[wall()]).unwrap();
    let hit = view.first_hit_of_uv(1.0, 1.0).unwrap();
    assert_eq!(hit.t.to_f64(), 12.0);
    assert_eq!(floats(&hit.point), [24.0, 12.0, -6.0]);
}

#[test]
fn how_near_a_decision_is_of_the_canonical_ball() {
    let (ball, eye) = (Object::Sphere { center: [0.0, 0.0, -5.0], radius: 1.0 }, [0.0; 3]);
    let one_pixel = Camera { columns: 1, rows: 1, ..canonical() };
    let direction = one_pixel.prepare(&[]).unwrap().direction_of_pixel(0, 0);
    // sin^2 of the angular radius is 1/25, and the ray goes through the centre.
    assert_eq!(margins::grazing(&ball, eye, &direction), Some(0.04));
    assert_eq!(margins::grazing(&wall(), eye, &direction), None);
    assert_eq!(margins::ahead(&ball, eye, &direction), Some(1.0));
    assert_eq!(margins::ahead(&wall(), eye, &direction), Some(-1.0));
    assert_eq!(margins::side(&ball, eye), 24.0 / 26.0);
    assert_eq!(margins::side(&wall(), eye), -1.0);
    assert_eq!(margins::side(&wall(), [3.0, 0.0, -6.0]), 0.0);
    assert_eq!(Real::from(3.0).relative_difference(&Real::from(1.0)), 0.5);
}
