//! Tests of the arithmetic that everything else rests on.

use std::cmp::Ordering;

use crate::camera::{Camera, Orientation};
use dashu_float::round::mode::{Down, Up};

use crate::dyadic::{Dyadic, Vector, cross, dot, minus, vector};
use crate::families::Draw;
use crate::object::Object;
use crate::quotient::Quotient;
use crate::real::Real;
use crate::surd::{Field, Surd};

#[allow(dead_code, reason = "other tests use more of it")]
#[path = "../core/tests/common/frames.rs"]
mod frames;

use frames::FrameCase;

fn any_f64(draw: &mut Draw) -> f64 {
    loop {
        let [high, low] = [(); 2].map(|()| draw.whole(0, (1 << 32) - 1) as u64);
        let x = f64::from_bits(high << 32 | low);
        if x.is_finite() {
            return x;
        }
    }
}

fn draw(name: &str) -> Draw {
    Draw::new(4, name, 0.0, 0)
}

fn exact(x: f64) -> Dyadic {
    Dyadic::from_f64(x)
}

fn whole(n: i64) -> Dyadic {
    Dyadic::new(n.into(), 0)
}

#[test]
fn arithmetic_rounds_as_the_processor_does() {
    let mut draw = draw("processor");
    for _ in 0..20_000 {
        let (a, mut b) = (any_f64(&mut draw), any_f64(&mut draw));
        if draw.once_in(2) {
            // Of a size that matters to a.
            b = f64::from_bits(b.to_bits() & !(0x7ff << 52) | a.to_bits() & 0x7ff << 52);
        }
        let same = |x: Dyadic, y: f64| {
            let x = Real(x).to_f64();
            assert!(x == y, "{a} {b}: {x} {y}");
        };
        same(exact(a), a);
        same(&exact(a) + &exact(b), a + b);
        same(&exact(a) - &exact(b), a - b);
        same(&exact(a) * &exact(b), a * b);
        assert_eq!(exact(a).cmp(&exact(b)), a.partial_cmp(&b).unwrap_or(Ordering::Equal));
        same(exact(a.abs()).sqrt::<Down>(200), a.abs().sqrt());
        same(exact(a.abs()).sqrt::<Up>(200), a.abs().sqrt());
        if b != 0.0 {
            // With 2500 bits, no quotient of doubles is close to the midpoint of two doubles without
            // being equal to it.
            same(exact(a).divided::<Down>(&exact(b), 2500), a / b);
            same(exact(a).divided::<Up>(&exact(b), 2500), a / b);
        }
    }
}

#[test]
fn directed_rounding_brackets_the_truth_tightly() {
    let mut draw = draw("bracket");
    for _ in 0..5_000 {
        let (a, b) = (exact(any_f64(&mut draw)), exact(any_f64(&mut draw)));
        let x = &(&a * &b) + &exact(any_f64(&mut draw));
        let bits = draw.whole(1, 120) as usize;
        let [low, high] = [x.rounded::<Down>(bits), x.rounded::<Up>(bits)];
        assert!(low <= x && x <= high && low.length() <= bits && high.length() <= bits);
        // Neighbours, and the number itself where it fits.
        assert_eq!(low == high, x.length() <= bits);
        let width = (&high - &low).log2().unwrap_or(i64::MIN);
        assert!(width <= x.log2().unwrap_or(0) + 1 - bits as i64);
        if !b.is_zero() {
            let [low, high] = [a.divided::<Down>(&b, bits), a.divided::<Up>(&b, bits)];
            let (mut low, mut high) = (&low * &b, &high * &b);
            if b.sign() == Ordering::Less {
                (low, high) = (high, low);
            }
            assert!(low <= a && a <= high);
        }
        let [low, high] = [x.abs().sqrt::<Down>(bits), x.abs().sqrt::<Up>(bits)];
        assert!(low.square() <= x.abs() && x.abs() <= high.square());
    }
}

#[test]
fn floats_at_the_ends_of_the_range() {
    let smallest = f64::from_bits(1);
    let half = exact(smallest).shifted(-1);
    let (a_little, to_f64) = (Dyadic::power_of_two(-3000), |x: &Dyadic| Real(x.clone()).to_f64());
    assert_eq!(to_f64(&half), 0.0);
    assert_eq!(to_f64(&(&half + &a_little)), smallest);
    assert_eq!(to_f64(&(&half - &a_little)), 0.0);
    // A number halfway between the first and the second subnormal is rounded to the even one, the
    // second.
    assert_eq!(to_f64(&(&half * &whole(3))), 2.0 * smallest);
    let beyond = &exact(f64::MAX) + &Dyadic::power_of_two(970);
    assert_eq!(to_f64(&beyond), f64::INFINITY);
    assert_eq!(to_f64(&(&beyond - &a_little)), f64::MAX);
    assert_eq!(to_f64(&Dyadic::power_of_two(5000)), f64::INFINITY);
    assert!(!Real(half).is_representable() && !Real(beyond).is_representable());
    assert!(Real::from(f64::MIN_POSITIVE).is_representable());
    assert!(!Real::from(1e-40).is_representable_f32() && Real::from(-1e38).is_representable_f32());
}

#[test]
fn ulps_are_spacings_at_the_truth() {
    let third = Real(exact(1.0).divided::<Down>(&exact(3.0), 500));
    // The doubles around 1/3 are 1/3 and 2/3 of a spacing away.
    let near = third.to_f64();
    assert!((third.ulps_from(near) - 1.0 / 3.0).abs() < 1e-15);
    assert!((third.ulps_from(near.next_up()) - 2.0 / 3.0).abs() < 1e-15);
    assert!((third.ulps_from_f32(1.0 / 3.0) - 1.0 / 3.0).abs() < 1e-15);
    assert_eq!(Real::from(1.0).ulps_from(1.0_f64.next_up()), 1.0);
    assert_eq!(Real::from(1.0).ulps_from(1.0_f64.next_down()), 0.5);
    assert_eq!(Real::from(0.0).ulps_from(f64::from_bits(3)), 3.0);
    assert_eq!(Real::from(-2.0).ulps_from(2.0), 2.0_f64.powi(53));
    assert_eq!(Real::from(1.0).ulps_from(f64::NAN), f64::INFINITY);
}

#[test]
fn signs_by_algebra_and_by_intervals_agree() {
    let mut draw = draw("signs");
    for _ in 0..3_000 {
        let [a, b] = [(); 2].map(|()| whole(draw.whole(1, 30) as i64));
        let field = Field::new(a, b);
        let x = Surd([(); 4].map(|()| whole(draw.whole(-20, 20) as i64)));
        let by_algebra = field.sign_by_algebra(&x);
        match field.interval(&x, 2).sign() {
            Some(sign) => assert_eq!(by_algebra, sign, "{x:?}"),
            // Numbers this small with four places below zero are 0.
            None => assert_eq!(by_algebra, Ordering::Equal, "{x:?}"),
        }
        // x times its conjugate over sqrt(B) has no sqrt(B) left.
        let [p, q, r, s] = x.0.clone();
        let product = field.times(&x, &Surd([p, q, -&r, -&s]));
        assert!(product.0[2].is_zero() && product.0[3].is_zero());
        assert_eq!(field.sign(&field.square(&x)) == Ordering::Equal, by_algebra == Ordering::Equal);
    }
}

#[test]
fn the_nearest_of_misses_is_told_from_zero() {
    // Pell's equation: p^2 - 2 q^2 = +-1, so that p - q sqrt(2) is about 1 / (2 p), however large.
    let field = Field::new(whole(2), whole(3));
    let (mut p, mut q) = (whole(1), whole(1));
    for step in 0..6_000 {
        let x = Surd([p.clone(), -&q, Dyadic::ZERO, Dyadic::ZERO]);
        let expected = if step % 2 == 0 { Ordering::Less } else { Ordering::Greater };
        if step < 300 || step % 100 < 2 {
            assert_eq!(field.sign(&x), expected, "{step}");
            // The same as a root of a quadratic: p - q sqrt(e) with e = 2, and times sqrt(3).
            let root = Quotient {
                p: Surd::with_root(p.clone(), 2),
                q: Surd::with_root(-&q, 2),
                e: Surd::rational(whole(2)),
                d: Surd::rational(whole(1)),
            };
            assert_eq!(root.sign(&field), expected, "{step}");
            // It is sqrt(3) (p^2 - 2 q^2) / (p + q sqrt(2)), in which nothing cancels.
            let [two, three] = [2, 3].map(|n| whole(n).sqrt::<Down>(BITS));
            let sum = &p + &(&q * &two);
            let known = three.divided::<Down>(&sum, BITS);
            let known = if expected == Ordering::Less { -&known } else { known };
            let off = (&root.value(&field).0 - &known).abs();
            assert!(off < known.abs().shifted(-440), "{step}");
        }
        (p, q) = (&p + &q.shifted(1), &p + &q);
    }
}

/// Number of significant bits of the plain arithmetic, without error bounds, with which the reference
/// is compared: more than twice the reference's own 440.
const BITS: usize = 1000;

fn rounded(v: Vector) -> Vector {
    v.map(|x| x.rounded::<Down>(BITS))
}

fn unit(v: &Vector) -> Vector {
    let length = dot(v, v).sqrt::<Down>(BITS);
    v.clone().map(|x| x.divided::<Down>(&length, BITS))
}

/// Computes a pixel's first hit and its t by the textbook's formulas in [`BITS`] bits: basis,
/// direction, quadratic, smallest positive root.
fn by_the_textbook(case: &FrameCase, row: u32, column: u32) -> Option<(usize, Dyadic)> {
    let Camera { eye, width, height, distance, columns, rows, .. } = case.camera;
    let eye = vector(eye);
    let [u, v, w] = match case.camera.orientation {
        Orientation::Basis { u, v, w } => [u, v, w].map(vector),
        Orientation::At { up, .. } | Orientation::View { up, .. } => {
            let view = match case.camera.orientation {
                Orientation::At { at, .. } => minus(&vector(at), &eye),
                Orientation::View { view: v, .. } | Orientation::Basis { w: v, .. } => vector(v),
            };
            let w = unit(&view.map(|x| -&x));
            let u = unit(&cross(&vector(up), &w));
            [u.clone(), rounded(cross(&w, &u)), w]
        }
    };
    let centre = |index: u32, count: u32| {
        let (position, count) = (whole(2 * i64::from(index) + 1), whole(2 * i64::from(count)));
        &position.divided::<Down>(&count, BITS) - &exact(0.5)
    };
    let (x, y) = (&exact(width) * &centre(column, columns), &exact(-height) * &centre(row, rows));
    let direction: Vector =
        std::array::from_fn(|i| &(&(&x * &u[i]) + &(&y * &v[i])) - &(&exact(distance) * &w[i]));
    let mut first: Option<(usize, Dyadic)> = None;
    for (index, object) in case.objects.iter().enumerate() {
        let positive = textbook_roots(object, &eye, &direction);
        let Some(t) = positive.into_iter().filter(|t| t.sign() == Ordering::Greater).min() else {
            continue;
        };
        if first.as_ref().is_none_or(|(_, best)| t < *best) {
            first = Some((index, t));
        }
    }
    first
}

fn textbook_roots(object: &Object, eye: &Vector, direction: &Vector) -> Vec<Dyadic> {
    match object {
        Object::Sphere { center, radius } => {
            let from_center = minus(eye, &vector(*center));
            let a = dot(direction, direction);
            let b = dot(direction, &from_center).shifted(1);
            let c = &dot(&from_center, &from_center) - &exact(*radius).square();
            let discriminant = &b.square() - &(&a * &c).shifted(2);
            if discriminant.sign() == Ordering::Less {
                return Vec::new();
            }
            let root = discriminant.sqrt::<Down>(BITS);
            [-&(&b + &root), &root - &b].map(|x| x.divided::<Down>(&a.shifted(1), BITS)).to_vec()
        }
        Object::Plane { point, normal } => {
            let normal = vector(*normal);
            let rate = dot(&normal, direction);
            if rate.is_zero() {
                return Vec::new();
            }
            let offset = dot(&normal, &minus(&vector(*point), eye));
            vec![offset.divided::<Down>(&rate, BITS)]
        }
    }
}

#[test]
fn the_textbook_at_twice_the_precision_agrees() {
    // In all families but those with exact contact, a thousand bits are enough to decide what is hit.
    let on_no_edge = |name: &str| {
        name.starts_with("frame-") && !name.ends_with("ties") && !name.ends_with("touching")
    };
    for family in frames::FAMILIES.iter().filter(|family| on_no_edge(family.name)) {
        for &knob in family.knobs {
            // Exact tangents are excluded; those off by an ulp are not.
            if family.name == "frame-tangent" && knob == 0.0 {
                continue;
            }
            for case in family.cases(knob, 30, 2) {
                agrees_with_the_textbook(family.name, &case);
            }
        }
    }
}

fn agrees_with_the_textbook(name: &str, case: &FrameCase) {
    let Camera { rows, columns, .. } = case.camera;
    let Ok(view) = case.camera.prepare(&case.objects) else {
        panic!("{name}: {case:?} has no basis")
    };
    for row in (0..rows).step_by(1 + rows as usize / 8) {
        for column in (0..columns).step_by(1 + columns as usize / 8) {
            let hit = view.first_hit_of_pixel(row, column);
            let textbook = by_the_textbook(case, row, column);
            let object = hit.as_ref().map(|hit| hit.object);
            assert_eq!(object, textbook.as_ref().map(|x| x.0), "{name} {row} {column}: {case:?}");
            if let (Some(hit), Some((_, t))) = (hit, textbook) {
                let off = Real((&hit.t.0 - &t).divided::<Up>(&t, 64));
                let limit = Real(Dyadic::power_of_two(-430));
                assert!(off < limit && off > Real::from(-1e-129), "{name} {row} {column}: {off:?}");
            }
        }
    }
}
