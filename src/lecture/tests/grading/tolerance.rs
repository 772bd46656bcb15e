//! How far an answer may be off: just within the tolerance it is right, just beyond it is wrong.

use super::*;

/// Slightly less than all of the tolerance, and slightly more.
const WITHIN: f64 = 0.97;
const BEYOND: f64 = 1.03;

/// The tolerances that are tried; `None` stands for the default, 1e-5.
fn tolerances() -> impl Iterator<Item = (Option<f64>, f64)> {
    [(None, 1e-5), (Some(1e-3), 1e-3), (Some(1e-7), 1e-7)].into_iter()
}

/// A camera without special values and a scene of one object.
fn seeing(spheres: &[([f64; 3], f64)], planes: &[([f64; 3], [f64; 3])]) -> Exercise {
    Exercise { spheres: spheres.to_vec(), planes: planes.to_vec(), ..general() }
}

fn is_right(exercise: &Exercise, answers: &Answers, tolerance: Option<f64>) -> bool {
    let (camera, scene) = (camera_of(exercise), scene_of(exercise));
    let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [100, 150, 200] };
    grade(&truth, answers, tolerance).unwrap().all_agree()
}

/// Asserts that answers that are off by a share of what is allowed are right below 1 and wrong above.
#[track_caller]
fn assert_limit(
    exercise: &Exercise,
    tolerance: Option<f64>,
    answers: impl Fn(f64) -> Answers,
    what: &str,
) {
    for sign in [1.0, -1.0] {
        let right = |share: f64| is_right(exercise, &answers(sign * share), tolerance);
        assert!(right(WITHIN), "{what}, {tolerance:?}: {sign} within");
        assert!(!right(BEYOND), "{what}, {tolerance:?}: {sign} beyond");
    }
}

#[test]
fn a_basis_and_rays_may_be_off_by_the_tolerance() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let eye = DVec3::from(exercise.eye);
    for (given, tolerance) in tolerances() {
        for (k, axis) in axes.into_iter().enumerate() {
            for vector in 0..3 {
                let basis = |share: f64| {
                    let mut basis = student.basis().map(exactly);
                    basis[vector].value += share * tolerance * axis;
                    Answers::Basis(basis)
                };
                assert_limit(&exercise, given, basis, &format!("vector {vector}, axis {k}"));
            }
            let rays = |change: &dyn Fn(&mut RayAnswer)| {
                let mut rays = student.rays();
                change(&mut rays[217]);
                Answers::Rays(rays)
            };
            let origin = |share: f64| {
                rays(&|ray| ray.origin.value += share * tolerance * eye.length() * axis)
            };
            assert_limit(&exercise, given, origin, &format!("origin, axis {k}"));
            // A direction may have any length.
            let direction = |share: f64| {
                rays(&|ray| {
                    let unit = ray.direction.value.normalize();
                    let across = axis - axis.dot(unit) * unit;
                    // The largest coordinate counts, not the length.
                    let moved = across / across.abs().max_element();
                    ray.direction.value = 7.0 * (unit + share * tolerance * moved);
                })
            };
            assert_limit(&exercise, given, direction, &format!("direction, axis {k}"));
        }
    }
}

/// The viewport's distance is the scale of a ray's origin if the eye is nearer to the world's origin.
#[test]
fn at_the_origin_the_distance_is_the_scale_of_rays() {
    let exercise = Exercise { eye: [0.0; 3], ..general() };
    let student = Student { exercise: &exercise, mistakes: &[] };
    let origin = |share: f64| {
        let mut rays = student.rays();
        rays[5].origin.value.y += share * 1e-5 * exercise.viewport[2];
        Answers::Rays(rays)
    };
    assert_limit(&exercise, None, origin, "origin");
}

/// The hits of the student's program at one pixel, with a change.
fn hit_at(exercise: &Exercise, change: impl Fn(DVec3, &mut GivenHit)) -> Answers {
    let student = Student { exercise, mistakes: &[] };
    let (row, column) = (9, 14);
    let direction = DVec3::from(student.ray(row, column).1);
    let (t, point, object) = student.hit(row, column).unwrap();
    let (t, point) = (Some(Written::exactly(t)), Some(exactly(point)));
    let mut hit = GivenHit { t, point, object: Some(object) };
    change(direction, &mut hit);
    let pixel = Pixel { row, column };
    Answers::Hits(vec![HitAnswer { pixel, hit: Some(hit) }])
}

fn only_t_off(exercise: &Exercise, by: f64) -> Answers {
    hit_at(exercise, |_, hit| {
        let t = hit.t.unwrap().value;
        *hit = GivenHit { t: Some(Written::exactly(t + by)), ..GivenHit::default() };
    })
}

/// Returns the direction, t and point of the tested pixel's ray.
fn hit_of(exercise: &Exercise) -> (DVec3, f64, DVec3) {
    let student = Student { exercise, mistakes: &[] };
    let (t, point, _) = student.hit(9, 14).unwrap();
    (DVec3::from(student.ray(9, 14).1), t, DVec3::from(point))
}

/// An object's surface may be moved by the tolerance times its distance. On a surface that the ray meets
/// at an angle, t may so be off by more.
#[test]
fn t_may_be_off_as_if_the_object_were_moved() {
    let ahead = |exercise: &Exercise, away: f64| {
        let direction = DVec3::from(Student { exercise, mistakes: &[] }.ray(9, 14).1);
        DVec3::from(exercise.eye) + away * direction.normalize()
    };
    let none = seeing(&[], &[]);
    let direction = ahead(&none, 1.0) - DVec3::from(none.eye);
    let across = direction.any_orthonormal_vector();
    for (given, tolerance) in tolerances() {
        for (away, cosine) in [(3.0, 1.0), (3.0, 0.5), (40.0, 0.3), (0.2, -0.8)] {
            let normal = cosine * direction + f64::sqrt(1.0 - cosine * cosine) * across;
            let wall = (ahead(&none, away).to_array(), (2.5 * normal).to_array());
            let exercise = seeing(&[], &[wall]);
            let (_, t, _) = hit_of(&exercise);
            let off = |share: f64| only_t_off(&exercise, share * tolerance * t / cosine.abs());
            assert_limit(&exercise, given, off, &format!("wall, {away}, {cosine}"));
        }
        for (away, aside, radius) in [(6.0, 0.0, 1.0), (6.0, 0.5, 1.0), (90.0, 9.0, 20.0)] {
            let center = ahead(&none, away) + aside * across;
            let exercise = seeing(&[(center.to_array(), radius)], &[]);
            let (direction, t, _) = hit_of(&exercise);
            let reach = t * direction.length();
            // The near root of a sphere whose radius is changed by `by`.
            let near = |by: f64| {
                let half = ((radius + by).powi(2) - aside * aside).sqrt();
                (away - half) / direction.length()
            };
            let off = |share: f64| only_t_off(&exercise, near(share * tolerance * reach) - t);
            assert_limit(&exercise, given, off, &format!("ball, {away}, {aside}, {radius}"));
        }
        // From within, the far root is the first hit.
        let (away, radius) = (0.5, 2.0);
        let exercise = seeing(&[(ahead(&none, away).to_array(), radius)], &[]);
        let (_, t, _) = hit_of(&exercise);
        assert_limit(
            &exercise,
            given,
            |share| only_t_off(&exercise, share * tolerance * t),
            "from within",
        );
    }
}

/// Each coordinate of a point may be off by the tolerance times the distance from the eye, and the point
/// may in addition be anywhere on the ray where t is right.
#[test]
fn a_point_may_be_off_across_the_ray() {
    let exercise = general();
    let (direction, t, point) = hit_of(&exercise);
    let reach = t * direction.length();
    let across = direction.any_orthonormal_vector();
    let across = across / across.abs().max_element();
    for (given, tolerance) in tolerances() {
        let off = |share: f64| {
            hit_at(&exercise, |_, hit| {
                hit.point = Some(Written::exactly(point + share * tolerance * reach * across));
            })
        };
        assert!(is_right(&exercise, &off(0.9), given) && is_right(&exercise, &off(-0.9), given));
        assert!(!is_right(&exercise, &off(3.0), given) && !is_right(&exercise, &off(-3.0), given));
        let along = |share: f64| {
            hit_at(&exercise, |direction, hit| {
                hit.point = Some(Written::exactly(point + share * tolerance * t * direction));
            })
        };
        assert!(
            is_right(&exercise, &along(0.9), given) && is_right(&exercise, &along(-0.9), given)
        );
        assert!(!is_right(&exercise, &along(9.0), given));
        assert!(!is_right(&exercise, &along(-9.0), given));
    }
}

/// Half a unit in the last written digit may be off in addition, at the default tolerance.
#[test]
fn rounding_of_what_is_written_is_allowed_in_addition() {
    let student_scene = general();
    let student = Student { exercise: &student_scene, mistakes: &[] };
    let wall = ([0.0, 0.0, -9.0], [0.1, 0.2, 1.0]);
    let exercise = seeing(&[], &[wall]);
    let (direction, t, _) = hit_of(&exercise);
    let cosine = (DVec3::from(wall.1).normalize().dot(direction) / direction.length()).abs();
    // At a tenth of the default tolerance, a tenth of the rounding is allowed.
    for (given, tolerance, allowed) in [(None, 1e-5, 1.0), (Some(1e-6), 1e-6, 0.1)] {
        let rounding = 3.0 * tolerance;
        let t_off = |share: f64| {
            hit_at(&exercise, |_, hit| {
                let by = share * (tolerance * t / cosine + allowed * rounding);
                let t = Some(Written { value: t + by, rounding });
                *hit = GivenHit { t, ..GivenHit::default() };
            })
        };
        assert_limit(&exercise, given, t_off, "t");
        let basis = |share: f64| {
            let mut basis = student.basis().map(exactly);
            basis[1].value.z += share * (tolerance + allowed * rounding);
            basis[1].rounding = rounding;
            Answers::Basis(basis)
        };
        assert_limit(&student_scene, given, basis, "v");
        let origin = |share: f64| {
            let mut rays = student.rays();
            let size = DVec3::from(student_scene.eye).length();
            rays[7].origin.value.x += share * (tolerance * size + allowed * rounding);
            rays[7].origin.rounding = rounding;
            Answers::Rays(rays)
        };
        assert_limit(&student_scene, given, origin, "origin");
        let turned = |share: f64| {
            let mut rays = student.rays();
            let ray = &mut rays[7].direction;
            let (unit, length) = (ray.value.normalize(), ray.value.length());
            let across = unit.any_orthonormal_vector();
            let by = share * (tolerance + allowed * rounding / length);
            ray.value += by * length * across / across.abs().max_element();
            ray.rounding = rounding;
            Answers::Rays(rays)
        };
        assert_limit(&student_scene, given, turned, "direction");
    }
}

#[test]
fn a_channel_may_be_off_by_its_levels() {
    let exercise = general();
    let (camera, scene) = (camera_of(&exercise), scene_of(&exercise));
    let color_of = |object: u32| pictures::COLORS[object as usize];
    let truth = Truth { camera: &camera, scene: &scene, color_of: &color_of };
    let student = Student { exercise: &exercise, mistakes: &[] };
    let Answers::Picture(right) = pictures::painted(&student, Shade::Object) else { panic!() };
    let ball = right.iter().position(|color| *color == pictures::COLORS[0]).unwrap();
    let graded = |channel: usize, by: i8, tolerance| {
        let mut pixels = right.clone();
        pixels[ball][channel] = pixels[ball][channel].saturating_add_signed(by);
        grade(&truth, &Answers::Picture(pixels), tolerance).unwrap()
    };
    // The ball has no blue, so that blue can only be too high.
    let changes = [(0, 1), (0, -1), (1, 1), (1, -1), (2, 1)];
    for (tolerance, levels) in [(None, 2), (Some(5.0), 5), (Some(0.0), 0)] {
        for (channel, sign) in changes {
            assert!(graded(channel, sign * levels, tolerance).all_agree(), "{levels} {channel}");
            let off = graded(channel, sign * (levels + 1), tolerance);
            assert!(!off.all_agree(), "{levels} {channel}");
            let worst = off.worst.unwrap();
            assert_eq!((worst.index, worst.error), (ball, f64::from(levels + 1)));
        }
    }
}

/// The error that is shown is relative to the right t and to the point's distance from the eye.
#[test]
fn the_greatest_error_is_relative() {
    let exercise = general();
    let (direction, t, point) = hit_of(&exercise);
    let worst = |answers: Answers| graded(&exercise, &answers).worst.unwrap().error;
    let of_t = worst(only_t_off(&exercise, 0.25 * t));
    assert!((of_t - 0.25).abs() < 1e-12, "{of_t}");
    let of_point = worst(hit_at(&exercise, |_, hit| {
        let moved = point + 0.5 * t * direction;
        *hit = GivenHit { point: Some(Written::exactly(moved)), ..GivenHit::default() };
    }));
    assert!((of_point - 0.5).abs() < 1e-12, "{of_point}");
    let of_object = worst(hit_at(&exercise, |_, hit| hit.object = hit.object.map(|k| k + 1)));
    assert_eq!(of_object, f64::INFINITY);
    let student = Student { exercise: &exercise, mistakes: &[] };
    let mut rays = student.rays();
    rays[3].origin.value.y += 0.125 * DVec3::from(exercise.eye).length();
    let of_origin = worst(Answers::Rays(rays));
    assert!((of_origin - 0.125).abs() < 1e-12, "{of_origin}");
    let mut basis = student.basis().map(exactly);
    basis[2].value += DVec3::new(0.3, 0.0, 0.4);
    let of_basis = worst(Answers::Basis(basis));
    assert!((of_basis - 0.5).abs() < 1e-12, "{of_basis}");
}

/// Rounding errors of `f64` are right without any tolerance, far from the world's origin, too.
#[test]
fn rounding_errors_need_no_tolerance() {
    for exercise in [general(), telling(), far_out()] {
        let student = Student { exercise: &exercise, mistakes: &[] };
        for answers in [rays_of(&student), hits_of(&student)] {
            assert!(is_right(&exercise, &answers, Some(0.0)), "{:?}", answers.kind());
        }
    }
}

/// What a program in `f32` gives is explained by its rounding errors, and larger errors are not.
#[test]
fn more_than_the_errors_of_f32_is_no_f32() {
    let exercise = far_out();
    let student = single::Student { exercise: &exercise, mistakes: &[] };
    let off = |by: f32| {
        let hits = student.hits().into_iter().map(|answer| {
            let far = |x: f64| f64::from(x as f32 * (1.0 + by));
            let hit = answer.hit.map(|hit| GivenHit {
                t: hit.t.map(|t| Written::exactly(far(t.value))),
                point: None,
                ..hit
            });
            HitAnswer { hit, ..answer }
        });
        found(&exercise, &Answers::Hits(hits.collect()))
    };
    assert_eq!(off(0.0), [["single-precision"]]);
    assert_eq!(off(0.02), [[""; 0]]);
}
