//! Tests of the index over spheres: every sphere has exactly one slot, every box contains its spheres,
//! whatever their sizes, and both remain true while spheres are replaced.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod certificate;
mod pair_order;

use glam::DVec3;
use proptest::prelude::*;

use crate::camera::ray::{ExactRay, Ray};
use crate::exact::dyadic::Dyadic;
use crate::exact::scale::exponent;
use crate::scene::Scene;
use crate::scene::error::SceneError;
use crate::scene::object::{Object, Roots};
use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::Bound;
use crate::scene::sphere_index::INDEX_FROM;
use crate::scene::sphere_index::{BLOCK, GROUP};
use crate::scene::sphere_index::{NO_SPHERE, SphereIndex};
use crate::test_seed::config;

/// Generates a coordinate: mostly from -100 to 100, sometimes any finite number.
fn coordinate() -> impl Strategy<Value = f64> {
    let any = any::<f64>().prop_filter("finite", |x| x.is_finite());
    prop_oneof![4 => -100.0..100.0f64, 1 => any, 1 => Just(1e308), 1 => Just(-1e308)]
}

fn sphere() -> impl Strategy<Value = Sphere> {
    let is_radius = |r: &f64| r.is_finite() && *r > 0.0;
    let any = any::<f64>().prop_map(f64::abs).prop_filter("a radius", is_radius);
    let radius = prop_oneof![4 => 0.01..10.0f64, 1 => any, 1 => Just(1e308), 1 => Just(5e-324)];
    (prop::array::uniform3(coordinate()), radius)
        .prop_map(|(center, radius)| Sphere { center: center.into(), radius })
}

/// Returns spheres scattered in a cube, each with a radius between the given powers of 10.
fn cloud(count: usize, (least, most): (f64, f64)) -> Vec<Sphere> {
    let part = |i: usize, by: f64| (i as f64 * by).fract();
    let sphere = |i| Sphere {
        center: 100.0 * DVec3::new(part(i, 0.618_034), part(i, 0.754_878), part(i, 0.569_840)),
        radius: 10_f64.powf(least + (most - least) * part(i, 0.819_173)),
    };
    (1..=count).map(sphere).collect()
}

/// Asserts, in real numbers, that the box contains `middle - half ..= middle + half` on an axis.
#[track_caller]
fn assert_contains([middle, half]: [f64; 2], [inner, inner_half]: [f64; 2]) {
    assert!(middle.is_finite() && half >= 0.0, "{middle:e} +- {half:e}");
    if half == f64::INFINITY {
        return;
    }
    let big = |x: f64| -> Dyadic { Dyadic::from(x) };
    let below = &(&big(inner) - &big(inner_half)) - &(&big(middle) - &big(half));
    let above = &(&big(middle) + &big(half)) - &(&big(inner) + &big(inner_half));
    let is_inside = below.sign().is_ge() && above.sign().is_ge();
    assert!(is_inside, "{inner:e} +- {inner_half:e} sticks out of {middle:e} +- {half:e}");
    assert!(middle - half <= inner - inner_half && inner + inner_half <= middle + half);
}

fn axes(bound: &Bound) -> [[f64; 2]; 3] {
    std::array::from_fn(|axis| [bound.middle[axis], bound.half[axis]])
}

/// Returns the spheres in these slots, as `(slot, sphere)`, without empty slots.
fn held(index: &SphereIndex, slots: std::ops::Range<usize>) -> Vec<(usize, Sphere)> {
    let own = slots.filter(|slot| index.ids[*slot] != NO_SPHERE);
    own.map(|slot| (slot, index.sphere(slot))).collect()
}

/// Asserts the invariants of an index over these spheres, whether it is new or updated.
fn assert_is_index_of(index: &SphereIndex, spheres: &[Sphere]) {
    assert_eq!(index.ids.len(), index.blocks.len() * BLOCK);
    let mut seen = vec![0; spheres.len()];
    let mut next_block = 0;
    for group in 0..index.groups.len() {
        let blocks = index.blocks_of(group);
        assert_eq!(blocks.start, next_block, "groups follow each other");
        assert!(!blocks.is_empty() && blocks.len() <= GROUP);
        next_block = blocks.end;
        let mut in_group = Vec::new();
        for block in blocks {
            let inside = held(index, SphereIndex::slots_of(block));
            for (slot, sphere) in &inside {
                let id = index.ids[*slot] as usize;
                assert_eq!(*sphere, spheres[id]);
                seen[id] += 1;
            }
            assert_box(&index.blocks[block], &inside);
            assert_filled_up(index, block);
            in_group.extend(inside);
        }
        assert_box(&index.groups[group], &in_group);
    }
    assert_eq!(next_block, index.blocks.len());
    assert!(seen.iter().all(|times| *times == 1), "a sphere has no slot, or two");
}

/// Asserts that a box contains the spheres inside it, and that its totals are theirs.
fn assert_box(bound: &Bound, inside: &[(usize, Sphere)]) {
    assert!(!inside.is_empty() && bound.count as usize == inside.len());
    for (_, sphere) in inside {
        for (outer, inner) in axes(bound).into_iter().zip(sphere.center.to_array()) {
            assert_contains(outer, [inner, sphere.radius]);
        }
    }
    let radii = || inside.iter().map(|(_, sphere)| sphere.radius);
    let area: f64 = radii().map(|r| r * r).sum();
    let found = bound.area;
    assert!(found == area || (found - area).abs() <= 1e-12 * area, "{found:e} for {area:e}");
    assert_eq!(bound.radius, radii().fold(0.0, f64::max));
}

/// Asserts that the empty slots of a block repeat its first sphere.
fn assert_filled_up(index: &SphereIndex, block: usize) {
    let slots = SphereIndex::slots_of(block);
    let first = slots.start;
    for slot in slots.filter(|slot| index.ids[*slot] == NO_SPHERE) {
        assert_eq!(index.sphere(slot), index.sphere(first));
    }
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn any_spheres_have_an_index_and_keep_it_while_they_are_replaced(
        mut spheres in prop::collection::vec(sphere(), 1..200),
        others in prop::collection::vec((any::<prop::sample::Index>(), sphere()), 0..20),
    ) {
        let mut index = SphereIndex::new(&spheres);
        assert_is_index_of(&index, &spheres);
        for (k, sphere) in others {
            let k = k.index(spheres.len());
            spheres[k] = sphere;
            index.replace(k as u32, &sphere);
        }
        assert_is_index_of(&index, &spheres);
    }
}

#[test]
fn boxes_are_tight_and_groups_are_of_one_size_class() {
    let spheres = cloud(5000, (-2.0, 1.0));
    let index = SphereIndex::new(&spheres);
    assert_is_index_of(&index, &spheres);
    for group in 0..index.groups.len() {
        let blocks = index.blocks_of(group);
        let inside = held(&index, blocks.start * BLOCK..blocks.end * BLOCK);
        let class = |sphere: &Sphere| exponent(sphere.radius).div_euclid(2);
        assert!(inside.windows(2).all(|two| class(&two[0].1) == class(&two[1].1)));
    }
    // A block's share of the volume is a cube of edge 15; the spheres stick out by 0.1.
    let spheres = cloud(5000, (-1.0, -1.0));
    let index = SphereIndex::new(&spheres);
    let edges: Vec<f64> = index.blocks.iter().map(|bound| 2.0 * bound.half[0]).collect();
    let mean = edges.iter().sum::<f64>() / edges.len() as f64;
    assert!(mean < 25.0, "{mean}");
    assert_eq!(edges.len(), 5000_usize.div_ceil(BLOCK), "blocks are full");
}

#[test]
fn replacing_a_sphere_by_itself_changes_nothing() {
    let spheres = cloud(3000, (-2.0, 2.0));
    let new = SphereIndex::new(&spheres);
    let mut index = new.clone();
    let other = Sphere { center: DVec3::splat(1e9), radius: 1e3 };
    for k in (0..3000).step_by(7) {
        index.replace(k, &other);
    }
    assert_ne!(index, new);
    for k in (0..3000).step_by(7) {
        index.replace(k, &spheres[k as usize]);
    }
    assert_eq!(index, new, "an updated box is what a new one is");
}

#[test]
fn the_index_is_the_same_for_any_number_of_threads() {
    // So many spheres that, three times in succession, halves of them are given to other threads.
    let spheres = cloud(70_000, (-1.0, 0.0));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| SphereIndex::new(&spheres))
    };
    assert_eq!(on(1), on(2));
    assert_eq!(on(1), on(3));
}

#[test]
fn a_scene_of_few_spheres_has_no_index() {
    let scene = |count| Scene::new(cloud(count, (0.0, 0.0)), vec![]).unwrap();
    assert!(scene(INDEX_FROM - 1).index().is_none());
    assert!(scene(INDEX_FROM).index().is_some());
}

#[test]
fn a_scene_keeps_its_index_and_its_clones_keep_theirs() {
    let spheres = cloud(1000, (-1.0, 0.0));
    let mut scene = Scene::new(spheres.clone(), vec![]).unwrap();
    let first = std::ptr::from_ref(scene.index().unwrap());
    assert_eq!(first, std::ptr::from_ref(scene.index().unwrap()), "made once");
    let moved = Sphere { center: DVec3::new(3.0, 4.0, 5.0), radius: 2.0 };
    scene.replace(17, Object::Sphere(moved)).unwrap();
    assert_eq!(first, std::ptr::from_ref(scene.index().unwrap()), "updated in place");
    let clone = scene.clone();
    assert_eq!(first, std::ptr::from_ref(clone.index().unwrap()), "shared by clones");
    scene.replace(18, Object::Sphere(moved)).unwrap();
    assert_is_index_of(scene.index().unwrap(), scene.spheres());
    assert_is_index_of(clone.index().unwrap(), clone.spheres());
    assert_eq!(clone.spheres()[17], moved);
    assert_eq!(clone.spheres()[18], spheres[18]);
    assert_eq!(scene.spheres()[18], moved);
}

#[test]
fn what_is_no_sphere_changes_nothing() {
    let spheres = cloud(300, (-1.0, 0.0));
    let mut scene = Scene::new(spheres.clone(), vec![]).unwrap();
    let index = scene.index().unwrap().clone();
    let none = Sphere { center: DVec3::ZERO, radius: -1.0 };
    let refused = scene.replace(5, Object::Sphere(none));
    assert!(matches!(refused, Err(SceneError { index: 5, .. })), "{refused:?}");
    assert_eq!(scene.spheres(), spheres);
    assert_eq!(*scene.index().unwrap(), index);
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn the_spheres_around_a_point_are_those_that_contain_it(
        spheres in prop::collection::vec(sphere(), INDEX_FROM..400),
        point in prop::array::uniform3(coordinate()),
    ) {
        let point = DVec3::from(point);
        let mut scene = Scene::new(spheres, vec![]).unwrap();
        // So that there is one at least.
        let tiny = Sphere { center: point, radius: 1e-100 };
        scene.replace(7, Object::Sphere(tiny)).unwrap();
        let is_around = |sphere: &&Sphere| sphere.implicit(point) < 0.0;
        let around = scene.spheres_around(point);
        prop_assert!(around.contains(&7) && around.is_sorted());
        prop_assert_eq!(around.len(), scene.spheres().iter().filter(is_around).count());
        for index in around {
            prop_assert!(scene.spheres()[index as usize].implicit(point) < 0.0);
        }
    }
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn roots_are_those_of_each_sphere_by_itself(
        spheres in prop::collection::vec(sphere(), INDEX_FROM..400),
        touched in prop::collection::vec((prop::array::uniform3(coordinate()), -9.0..3.0f64), 8),
        origin in prop::array::uniform3(coordinate()),
        direction in prop::array::uniform3(-1.0..1.0f64),
        slopes in prop::array::uniform3(any::<bool>()),
    ) {
        // Some directions have coordinates of 0, so that they lie along axes or coordinate planes.
        let direction = DVec3::from_array(std::array::from_fn(|i| {
            if slopes[i] { direction[i] } else { 0.0 }
        }));
        let Ok(ray) = Ray::new(origin, direction) else { return Ok(()) };
        let mut scene = Scene::new(spheres, vec![]).unwrap();
        for (k, (point, size)) in (0..).zip(touched) {
            // About as far from the line as its radius.
            let point = DVec3::from(point).clamp(DVec3::splat(-1e3), DVec3::splat(1e3));
            let (t, radius) = (point.x, 10_f64.powf(size));
            let beside = radius * direction.any_orthogonal_vector().normalize_or_zero();
            let center = ray.origin + t * direction + beside;
            if let Ok(sphere) = Sphere::new(center, radius) {
                scene.replace(k, Object::Sphere(sphere)).unwrap();
            }
        }
        let ranked = scene.ranked_roots_of(&ExactRay::from_ray(&ray).unwrap());
        let mut found: Vec<(u32, u64)> =
            ranked.iter().map(|ranked| (ranked.root.object, ranked.root.t.to_bits())).collect();
        found.sort_unstable();
        let mut expected = Vec::new();
        for (index, sphere) in (0..).zip(scene.spheres()) {
            match sphere.roots(&ray) {
                Roots::None => (),
                Roots::One(t) => expected.push((index, t.to_bits())),
                Roots::Two(near, far) => {
                    expected.extend([(index, near.to_bits()), (index, far.to_bits())]);
                }
            }
        }
        expected.sort_unstable();
        prop_assert_eq!(found, expected);
    }
}
