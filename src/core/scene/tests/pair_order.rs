//! Tests that the order of two objects by their difference is that of exact numbers, and that the bound
//! of its error holds and is not much too large.

use std::borrow::Cow;
use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::{ExactRay, Ray};
use crate::exact::bounded::Number;
use crate::exact::dyadic::{Dyadic, dot, exact3, minus};
use crate::exact::quadratic::{DirectionTerms, Quadratic, SureRoot};
use crate::exact::steps::Steps;
use crate::scene::big_roots::big_c;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin};
use crate::scene::pair_order::PairOrder;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::{RootSide, SphereFromOrigin};

/// A generator of pseudorandom numbers (SplitMix64).
struct Random(u64);

impl Random {
    /// Returns a number from -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 10) as f64 / (1_u64 << 53) as f64 - 1.0
    }

    fn point(&mut self) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.next()))
    }

    /// Returns a whole number from -n to n.
    fn whole(&mut self, n: f64) -> f64 {
        (n * self.next()).round()
    }

    /// Returns a power of 10 between two powers.
    fn size(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.next().abs())
    }
}

fn ball(center: DVec3, radius: f64) -> Sphere {
    Sphere { center, radius: radius.abs().max(f64::MIN_POSITIVE) }
}

type Family = (&'static str, fn(&mut Random) -> [Sphere; 2]);

/// Families of pairs, seen from the origin.
const FAMILIES: [Family; 9] = [
    ("nearly equal", |random| {
        let (center, off) = (5.0 * random.point(), random.size(-18.0, -3.0));
        let radius = random.size(-1.0, 1.0);
        [ball(center, radius), ball(center + off * random.point(), radius + off * random.next())]
    }),
    ("1e-308 apart", |random| {
        let center = DVec3::new(0.0, 0.0, 4.0 * random.next());
        [ball(center, 1.0), ball(center + DVec3::new(1e-308 * random.next(), 1e-308, 0.0), 1.0)]
    }),
    ("1e300 apart", |random| {
        let [near, far] = [random.size(-10.0, 10.0), random.size(290.0, 300.0)];
        let center = DVec3::new(random.next(), random.next(), 2.0);
        [ball(near * center, near * random.size(-1.0, 1.0)), ball(far * center, far)]
    }),
    ("touching", |random| {
        let (contact, axis) =
            ([(); 3].map(|()| random.whole(99.0)), [[1.0, 2.0, 2.0], [2.0, 3.0, 6.0]]);
        let (axis, length) = if random.next() > 0.0 { (axis[0], 3.0) } else { (axis[1], 7.0) };
        let [k, l] = [random.whole(9.0), random.whole(9.0)];
        let sphere =
            |k: f64| ball(DVec3::from_array(contact) + k * DVec3::from_array(axis), k * length);
        [sphere(k), sphere(l)]
    }),
    ("nested", |random| {
        let (center, radius) = (3.0 * random.point(), random.size(-1.0, 1.0));
        let ulps = 1.0 + random.whole(9.0) * f64::EPSILON;
        [ball(center, radius), ball(center, ulps * radius)]
    }),
    ("the eye on both", |random| {
        let [k, l] = [random.whole(99.0), random.whole(99.0)];
        let tilt = random.whole(3.0);
        let sphere = |k: f64, axis: DVec3| ball(k * axis, k * axis.length());
        let other = if tilt > 0.0 { DVec3::new(2.0, 2.0, 1.0) } else { DVec3::new(1.0, 2.0, 2.0) };
        [sphere(k, DVec3::new(1.0, 2.0, 2.0)), sphere(l, other)]
    }),
    ("the eye on both, alike", |random| {
        let radius = 1.0 + random.whole(9.0) * f64::EPSILON;
        [ball(DVec3::Y, 1.0), ball(radius * DVec3::Y, radius)]
    }),
    ("the eye inside both", |random| {
        let off = random.size(-17.0, -1.0);
        let center = 0.5 * random.point();
        [ball(center, 1.0), ball(center + off * random.point(), 1.0 + off * random.next())]
    }),
    ("one circle", |random| {
        let triangle = |k: f64| {
            ball(DVec3::new(0.0, (720.0 / k - k) * 360.0, -3600.0), (720.0 / k + k) * 360.0)
        };
        [(); 2].map(|()| {
            triangle([1.0, 2.0, 3.0, 4.0, 5.0, 6.0][(2.5 * random.next().abs()) as usize])
        })
    }),
];

/// Returns a direction towards a random point of a sphere, or along a coordinate plane.
fn direction(random: &mut Random, sphere: &Sphere) -> DVec3 {
    let towards = sphere.center + sphere.radius * random.point();
    let size = towards.abs().max_element();
    let towards = if size > 1e100 { towards / size } else { towards };
    match random.whole(4.0) {
        0.0 => towards * DVec3::new(1.0, 0.0, 1.0),
        1.0 => towards * DVec3::new(1.0, 1e-17, 1.0),
        _ => towards,
    }
}

fn seen(sphere: Sphere) -> SphereFromOrigin {
    SphereFromOrigin::new(&sphere, DVec3::ZERO)
}

fn rough_hit(seen: &ObjectFromOrigin, ray: &ExactRay) -> Option<SureRoot<f64>> {
    let ObjectFromOrigin::Sphere(seen) = seen else { return None };
    let is_far = seen.root_of_hit() == RootSide::Far;
    Quadratic::new(&seen.rough, &ray.rough).sure_root(&seen.rough, is_far)
}

#[test]
fn the_order_by_the_difference_is_that_of_exact_numbers() {
    for (name, family) in FAMILIES {
        let (mut random, mut asked, mut decided) = (Random(1), 0, [0; 2]);
        for _ in 0..40_000 {
            let pair = family(&mut random);
            let direction = direction(&mut random, &pair[0]);
            let Ok(ray) = Ray::new(DVec3::ZERO, direction) else { continue };
            let ray = ExactRay::from_ray(&ray).unwrap();
            let seen = pair.map(|sphere| ObjectFromOrigin::Sphere(seen(sphere)));
            let Some(order) = PairOrder::new(&seen[0], &seen[1], DVec3::ZERO) else { continue };
            let steps = &mut Steps::default();
            let ObjectFromOrigin::Sphere(first) = &seen[0] else { continue };
            if seen.iter().any(|seen| seen.first_root(&ray, steps).is_none()) || pair[0] == pair[1]
            {
                continue;
            }
            let [one, other] = [0, 1].map(|index: usize| {
                let (object, root) = (Cow::Borrowed(&seen[index]), seen[index].root_of_hit());
                Hit { index: index as u32, object, root }
            });
            let found = [
                order.compare(&ray.rough, rough_hit(&seen[0], &ray)),
                order.compare(&ray.fine, first.fine_hit(&ray)),
            ];
            asked += 1;
            if found == [None; 2] {
                continue;
            }
            let exact = one.compare(&other, &ray, steps);
            for (found, decided) in found.into_iter().zip(&mut decided) {
                assert!(
                    found.is_none_or(|found| found == exact),
                    "{name}: {pair:?}, {direction:?}"
                );
                *decided += usize::from(found.is_some());
            }
        }
        assert!(asked > 2000, "{name}: {asked}");
        // What is so far apart is decided by t alone.
        let least = if name == "1e300 apart" { 0 } else { 3 * asked / 10 };
        assert!(decided[1] >= least, "{name}: {decided:?} of {asked}");
    }
}

/// Returns the largest ratio of the error of the difference to its bound.
fn largest_ratio<T: Number>(
    rounds: usize,
    terms: impl for<'a> Fn(&'a ExactRay, &SphereFromOrigin) -> Option<(DirectionTerms<T>, SureRoot<T>)>,
) -> f64 {
    let (mut random, mut largest) = (Random(7), 0.0_f64);
    for round in 0..rounds {
        let [one, other] = FAMILIES[if round % 2 == 0 { 0 } else { 7 }].1(&mut random);
        let direction = one.center + one.radius * random.point();
        let ray = ExactRay::from_ray(&Ray { origin: DVec3::ZERO, direction }).unwrap();
        let [first, second] = [seen(one), seen(other)];
        let Some((d, root)) = terms(&ray, &first) else { continue };
        let objects = [first.clone(), second].map(ObjectFromOrigin::Sphere);
        let Some(order) = PairOrder::new(&objects[0], &objects[1], DVec3::ZERO) else { continue };
        let Some((g, doubt, _)) = order.difference(&d, Some(root)) else { continue };
        // t to a hundred bits, everything else exactly.
        let big = ray.big();
        let t = big.t(&first.big_root(&big, first.root_of_hit()));
        let t =
            [t.value.hi, t.value.lo].map(|x| Dyadic::from(crate::exact::scale::ldexp(x, t.scale)));
        let t = &t[0] + &t[1];
        let e = minus(&exact3(other.center), &exact3(one.center));
        let origin = exact3(DVec3::ZERO);
        let c = &big_c(&other, &origin) - &big_c(&one, &origin);
        let swing = &(&dot(&e, &exact3(direction)) * &t) * &Dyadic::from(2.0);
        let exact = if first.side == Ordering::Greater { &c - &swing } else { &swing - &c };
        let off = &exact - &Dyadic::from(g);
        if doubt > 0.0 && order.scale == 0 {
            largest = largest.max(off.rounded_times(0).abs() / doubt);
        }
    }
    largest
}

#[test]
fn the_bound_of_the_difference_holds_and_is_close() {
    let rough = largest_ratio(100_000, |ray, seen| {
        let hit = rough_hit(&ObjectFromOrigin::Sphere(seen.clone()), ray)?;
        Some((ray.rough, hit))
    });
    assert!((0.4..1.0).contains(&rough), "{rough}");
}

#[test]
fn spheres_on_different_sides_and_other_kinds_have_no_order() {
    let [inside, outside] = [1.0, 0.1].map(|radius| seen(ball(0.5 * DVec3::X, radius)));
    assert_ne!(inside.side, outside.side);
    let pair = [inside, outside].map(ObjectFromOrigin::Sphere);
    assert!(PairOrder::new(&pair[0], &pair[1], DVec3::ZERO).is_none());
    let plane = crate::scene::plane::Plane { point: DVec3::X, normal: DVec3::X };
    let plane = ObjectFromOrigin::new(&Object::Plane(plane), DVec3::ZERO);
    assert!(PairOrder::new(&pair[0], &plane, DVec3::ZERO).is_none());
}
