//! Numbers and vectors, recognised.

use pinhole_core::*;
use pinhole_lecture::{BasisDerivation, NumberForm, RayDerivation, VectorForm};
use proptest::prelude::*;

use crate::common::{Numbers, ulps, vec3};
use crate::config;
use crate::derivation::{AT_45_DEGREES, EXERCISE};

fn text(x: f64) -> String {
    NumberForm::recognise(x).map_or("none".to_owned(), |form| form.to_string())
}

fn vector_text(v: DVec3) -> String {
    match VectorForm::recognise(v) {
        None => "none".to_owned(),
        Some(VectorForm::Entries([x, y, z])) => format!("({x}, {y}, {z})"),
        Some(VectorForm::Common { whole: [x, y, z], factor }) => {
            let factor = factor.to_string();
            let (before, after) = factor.split_once('/').unwrap_or((&factor, ""));
            let before = before.strip_prefix('1').unwrap_or(before);
            let after = if after.is_empty() { String::new() } else { format!("/{after}") };
            format!("{before}({x}, {y}, {z}){after}")
        }
    }
}

fn vector_value(form: VectorForm) -> DVec3 {
    DVec3::from_array(form.entries().map(NumberForm::value))
}

/// Returns the number shifted by some ulps.
fn off_by(x: f64, ulps: i64) -> f64 {
    if x == 0.0 { x } else { f64::from_bits((x.to_bits() as i64 + ulps) as u64) }
}

#[test]
fn one_canonical_form() {
    let root = f64::sqrt;
    let forms = [
        (0.0, "0"),
        (-0.0, "0"),
        (6.0, "6"),
        (-4.0, "−4"),
        (0.2, "1/5"),
        (201.0 / 800.0, "201/800"),
        (-1.0 / 800.0, "−1/800"),
        (5.0 * root(2.0), "5√2"),
        (-root(2.0), "−√2"),
        (root(2.0) / 2.0, "1/√2"),
        (-root(0.5), "−1/√2"),
        (5.0 / root(2.0), "5/√2"),
        (-0.8 * root(0.5), "−2√2/5"),
        (root(3.0) / 2.0, "√3/2"),
        (1.0 / root(3.0), "1/√3"),
        (root(2.0 / 3.0), "2/√6"),
        (2.0 / root(14.0), "2/√14"),
        (root(2.0) / 4.0, "√2/4"),
        (root(682.0), "√682"),
        (21.0 / root(682.0), "21/√682"),
        (-7.0 / root(74.0), "−7/√74"),
        (root(1.05), "√105/10"),
        (root(666.0 / 682.0), "111/√12617"),
    ];
    for (x, expected) in forms {
        assert_eq!(text(x), expected, "{x:?}");
    }
    for none in [f64::NAN, f64::INFINITY, 1e300, 1e-300, 5e-324, std::f64::consts::PI, 1f64.exp()] {
        assert_eq!(NumberForm::recognise(none), None, "{none:?}");
    }
}

#[test]
fn its_parts_for_typesetting() {
    let parts = |x: f64| {
        let form = NumberForm::recognise(x).unwrap();
        (form.numerator, form.root, form.denominator, form.is_root_below)
    };
    assert_eq!(parts(-12.5), (-25, 1, 2, false));
    assert_eq!(parts(-0.8 * 0.5_f64.sqrt()), (-2, 2, 5, false));
    assert_eq!(parts(-5.0 * 0.5_f64.sqrt()), (-5, 2, 1, true));
    let decimals = |x: f64| NumberForm::recognise(x).unwrap().decimals();
    assert_eq!([6.0, 0.2, -0.25, 201.0 / 800.0].map(decimals), [0, 1, 2, 5].map(Some));
    assert_eq!([1.0 / 3.0, 0.5_f64.sqrt()].map(decimals), [None; 2]);
}

/// Tests that the numbers of the lecture's scenes are recognised even if they are off by 4 ulps in
/// either direction.
#[test]
fn the_lecture_s_numbers_are_recognised_through_noise() {
    let (s, root) = (0.5_f64.sqrt(), f64::sqrt);
    let mut numbers = vec![0.2, -0.1, -1.0, 6.0, 1.2, -0.6, 3.0, 0.3, s, 0.8 * s, 1.2 * s];
    numbers.extend([5.0 * root(2.0), root(2.0) / 2.0, 1.0 / 800.0, 201.0 / 800.0, 4.0, 20.0, 21.0]);
    for (whole, k) in [([5.0, 7.0, 1.0], 74.0), ([21.0, 4.0, 15.0], 682.0)] {
        numbers.extend(whole.map(|n| n / root(k)));
        numbers.push(root(k));
    }
    for x in numbers {
        let form = NumberForm::recognise(x).unwrap();
        assert!(ulps(form.value(), x) <= 2, "{x:?} is not {form}");
        for noise in -4..=4 {
            for sign in [-1.0, 1.0] {
                let found = NumberForm::recognise(off_by(sign * x, noise));
                let expected = if sign < 0.0 { form.negated() } else { form };
                assert_eq!(found, Some(expected), "{x:?} and {noise} ulps");
            }
        }
    }
}

proptest! {
    #![proptest_config(config(2000))]

    /// Tests that numbers `n sqrt k / m` with small n, k and m are recognised even if they are off by a
    /// few ulps.
    #[test]
    fn small_forms_are_recognised_through_noise(
        n in 1..40_i64, k in 1..25_u64, m in 1..25_u64, noise in -4..=4_i64, negative in any::<bool>(),
    ) {
        // The stated limit is on numerator times denominator of the number's square.
        prop_assume!((n * n) as u64 * k * m * m <= 1 << 20);
        let x = (n as f64) * (k as f64).sqrt() / m as f64;
        let x = if negative { -x } else { x };
        let form = NumberForm::recognise(x).unwrap();
        prop_assert!(ulps(form.value(), x) <= 3, "{} for {:?}", form, x);
        prop_assert_eq!(NumberForm::recognise(off_by(form.value(), noise)), Some(form));
        prop_assert_eq!(form.negated().value(), -form.value());
        // The form is unique: there is no common divisor and no square under the root.
        let (n, k, m) = (form.numerator.unsigned_abs(), form.root, form.denominator);
        prop_assert!((2..=m).all(|p| m % p != 0 || n % p != 0), "{}", form);
        prop_assert!((2..=k).all(|p| k % (p * p) != 0), "{}", form);
        prop_assert!(k > 1 || !form.is_root_below);
        prop_assert!(!form.is_root_below || m == 1);
    }

    /// Tests vectors with integer coordinates, scaled to length 1 as in a basis.
    #[test]
    fn unit_vectors_of_whole_directions_are_recognised(
        x in -60..=60_i64, y in -60..=60_i64, z in -60..=60_i64, noise in prop::array::uniform3(-4..=4_i64),
    ) {
        prop_assume!((x, y, z) != (0, 0, 0));
        let whole = vec3(x as f64, y as f64, z as f64);
        let unit = whole / whole.length();
        let noisy = DVec3::from_array(std::array::from_fn(|i| off_by(unit[i], noise[i])));
        let form = VectorForm::recognise(noisy);
        prop_assert!(form.is_some(), "{whole:?}");
        let form = form.unwrap();
        for i in 0..3 {
            prop_assert!(ulps(vector_value(form)[i], unit[i]) <= 3, "{:?} for {:?}", form, unit);
        }
        if let VectorForm::Common { whole, factor } = form {
            prop_assert!(factor.numerator == 1 && whole.iter().any(|n| n.abs() > 1));
        }
    }
}

/// Numbers with random digits are not recognised. Each one would be by chance with a probability of
/// 3e-9.
#[test]
fn random_numbers_are_not_recognised() {
    let mut numbers = Numbers(2024);
    for n in 0..1_000_000_u32 {
        let x = match n % 4 {
            0 => numbers.next(),
            1 => numbers.between(-10.0, 10.0),
            2 => numbers.between(-1000.0, 1000.0),
            _ => 10_f64.powf(numbers.between(-6.0, 6.0)),
        };
        assert_eq!(NumberForm::recognise(x), None, "{x:?} as {}", text(x));
    }
}

#[test]
fn random_vectors_are_not_recognised() {
    let mut numbers = Numbers(7);
    for n in 0..300_000_u32 {
        let mut v = numbers.point(if n % 2 == 0 { 1.0 } else { 50.0 });
        if n % 3 == 0 {
            v.y = 0.0;
        }
        let v = if n % 5 == 0 { v.normalize() } else { v };
        assert_eq!(VectorForm::recognise(v), None, "{v:?} as {}", vector_text(v));
    }
}

#[test]
fn vectors_of_the_lecture() {
    let s = 0.5_f64.sqrt();
    let forms = [
        (DVec3::ZERO, "(0, 0, 0)"),
        (vec3(-21.0, -4.0, -15.0), "(−21, −4, −15)"),
        (vec3(s, 0.0, -s), "(1/√2, 0, −1/√2)"),
        (vec3(0.0, 1.0, 0.0), "(0, 1, 0)"),
        (vec3(-4.0, -s, -6.0), "(−4, −1/√2, −6)"),
        (vec3(0.2, -0.1, -1.0), "(2, -1, -10)/10"),
        (vec3(1.2, -0.6, -6.0), "(6, -3, -30)/5"),
        (vec3(-0.8 * s, -0.1, -1.2 * s), "(−2√2/5, −1/10, −3√2/5)"),
        (vec3(2.0, 4.0, 6.0) * 2_f64.sqrt(), "√2(2, 4, 6)"),
        (vec3(1.0, 2.0, 3.0) * 2_f64.sqrt() / 5.0, "√2(1, 2, 3)/5"),
        (vec3(0.5, -0.5, 0.0), "(1/2, −1/2, 0)"),
        (vec3(1.0, 2.0, 2.0) / 3.0, "(1, 2, 2)/3"),
        (vec3(f64::NAN, 0.0, 0.0), "none"),
        (vec3(1.0, std::f64::consts::PI, 0.0), "none"),
    ];
    for (v, expected) in forms {
        assert_eq!(vector_text(v), expected, "{v:?}");
    }
    let form = VectorForm::recognise(vec3(5.0, 0.0, -7.0) / 74_f64.sqrt()).unwrap();
    assert_eq!(form.entries().map(|entry| entry.to_string()), ["5/√74", "0", "−7/√74"]);
}

/// Tests the forms of vectors that are derived from a camera, with the rounding errors that occur on
/// the way.
#[test]
fn derived_vectors_have_their_forms() {
    let BasisDerivation::FromUp(derived) = BasisDerivation::new(&EXERCISE) else {
        panic!("given by at")
    };
    let v = derived.w_cross_u.unwrap().product;
    let across = derived.up_cross_w.unwrap();
    let found = [derived.w.unwrap(), across.product, derived.u.unwrap(), v].map(vector_text);
    let expected =
        ["(21, 4, 15)/√682", "(15, 0, -21)/√682", "(5, 0, -7)/√74", "(-14, 111, -10)/√12617"];
    assert_eq!(found, expected);
    assert_eq!(text(derived.view.unwrap().length), "√682");

    let resolved = AT_45_DEGREES.resolve().unwrap();
    let Basis { u, w, .. } = *resolved.basis();
    assert_eq!(vector_text(u), "(1/√2, 0, −1/√2)");
    assert_eq!(vector_text(w), "(1/√2, 0, 1/√2)");
    let ray = RayDerivation::new(&resolved, Selection::Uv(DVec2::new(0.2, -0.1))).unwrap();
    assert_eq!(vector_text(ray.along_u), "(√2/10, 0, −√2/10)");
    assert_eq!(vector_text(ray.ray.direction), "(−2√2/5, −1/10, −3√2/5)");
    assert_eq!(text(ray.length), "√105/10");
}
