//! Tests of lines in two dimensions: the lecture's examples, decisions that rounding must not change,
//! and comparisons of the computed values with those of 5000-bit floating-point arithmetic.

use std::cmp::Ordering;

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use pinhole_core::DVec2;
use pinhole_lecture::lines::*;
use proptest::prelude::*;

use crate::config;

fn implicit(a: f64, b: f64, c: f64) -> ImplicitLine {
    ImplicitLine { a, b, c }
}

fn parametric(p: [f64; 2], d: [f64; 2]) -> ParametricLine {
    ParametricLine { p: p.into(), d: d.into() }
}

fn meeting(line: ImplicitLine, ray: ParametricLine) -> Meeting {
    Substitution::new(line, ray).unwrap().meeting
}

#[track_caller]
fn crossing(line: ImplicitLine, ray: ParametricLine) -> Crossing {
    let Meeting::At(crossing) = meeting(line, ray) else {
        panic!("{:?}", meeting(line, ray));
    };
    crossing
}

type Big = FBig<HalfEven, 2>;

fn big(x: f64) -> Big {
    Big::try_from(x).unwrap().with_precision(5000).value()
}

/// Generates random numbers with any significand and an exponent between -60 and 60.
fn number() -> impl Strategy<Value = f64> {
    (any::<u64>(), -60..60_i32).prop_map(|(bits, exponent)| {
        f64::from_bits(bits & !(0x7ff << 52) | (1023 << 52)) * 2_f64.powi(exponent)
    })
}

/// Generates numbers with few different values, so that coincidences are frequent.
fn small() -> impl Strategy<Value = f64> {
    (-3..=3).prop_map(f64::from)
}

#[test]
fn the_lecture_s_lines() {
    let ray = parametric([0.0, 0.0], [1.0, 1.0]);
    let hit = crossing(implicit(1.0, 1.0, -2.0), ray);
    assert_eq!(hit, Crossing { t: 1.0, point: DVec2::ONE, ray_hits: true });
    let missed = crossing(implicit(2.0, -1.0, 1.0), ray);
    assert_eq!(missed, Crossing { t: -1.0, point: -DVec2::ONE, ray_hits: false });
}

#[test]
fn both_terms_of_the_substitution() {
    let line = implicit(2.0, -3.0, 5.0);
    let ray = parametric([7.0, 11.0], [-1.0, 4.0]);
    let s = Substitution::new(line, ray).unwrap();
    assert_eq!((s.rate, s.offset), (-14.0, -14.0));
    assert_eq!(s.f(0.0), (-14.0, Ordering::Less));
    assert_eq!(s.f(-1.0), (0.0, Ordering::Equal));
    assert_eq!(s.f(-2.0), (14.0, Ordering::Greater));
    assert_eq!(line.f(ray.at(-2.0)), 14.0);
}

#[test]
fn parallel_and_coincident_are_told_apart_by_the_last_bit() {
    let line = implicit(0.1, 0.3, -0.7);
    let ray = |shift: f64| {
        // A point is on the line exactly if f is exactly 0; 0.1, 0.3 and 0.7 are not exact in f64.
        parametric([0.0, shift], [0.3, -0.1])
    };
    assert_eq!(meeting(line, ray(0.0)), Meeting::Parallel);
    assert_eq!(meeting(implicit(0.1, 0.3, 0.0), ray(0.0)), Meeting::Coincident);
    assert_eq!(meeting(implicit(0.1, 0.3, f64::from_bits(1)), ray(0.0)), Meeting::Parallel);
    let nearly = parametric([0.0, 0.0], [0.3, (-0.1_f64).next_up()]);
    assert!(crossing(line, nearly).ray_hits);
}

#[test]
fn a_line_through_p_itself_is_no_hit_of_the_ray() {
    let hit = crossing(implicit(1.0, 0.0, 0.0), parametric([0.0, 2.0], [1.0, 1.0]));
    assert_eq!((hit.t, hit.point, hit.ray_hits), (0.0, DVec2::new(0.0, 2.0), false));
}

#[test]
fn what_is_no_line_says_why() {
    let (line, ray) = (implicit(1.0, 1.0, 0.0), parametric([1.0, 2.0], [1.0, 0.0]));
    let why = |line, ray| Substitution::new(line, ray).unwrap_err().to_string();
    assert_eq!(
        why(implicit(0.0, 0.0, 3.0), ray),
        "a and b are both 0: f is 3 at every point, and no line is left"
    );
    assert_eq!(
        why(line, parametric([1.0, 2.0], [0.0, -0.0])),
        "d is (0, 0): every t gives the one point (1, 2)"
    );
    assert_eq!(why(implicit(f64::NAN, 1.0, 0.0), ray), "a is NaN: it must be a finite number");
    assert_eq!(
        why(line, parametric([0.0, f64::INFINITY], [1.0, 0.0])),
        "p y is inf: it must be a finite number"
    );
}

#[test]
fn a_meeting_beyond_all_numbers_is_no_infinity() {
    let far = meeting(implicit(1.0, 0.0, -1e300), parametric([0.0, 0.0], [1e-300, 1.0]));
    assert_eq!(far, Meeting::TooFar { ray_hits: true });
    let behind = meeting(implicit(1.0, 0.0, 1e300), parametric([0.0, 0.0], [1e-300, 1.0]));
    assert_eq!(behind, Meeting::TooFar { ray_hits: false });
}

#[test]
fn the_slope_form() {
    assert_eq!(implicit(3.0, -1.0, -2.0).slope_form(), Some((3.0, -2.0)));
    assert_eq!(implicit(2.0, 4.0, -8.0).slope_form(), Some((-0.5, 2.0)));
    assert_eq!(implicit(1.0, 0.0, -8.0).slope_form(), None);
}

#[test]
fn t_generates_equal_steps() {
    let line = parametric([1.0, 0.0], [0.0, 2.0]);
    let points: Vec<_> = line.generated(0.5, -0.6, 1.2, 100).collect();
    let expected = [(-0.5, -1.0), (0.0, 0.0), (0.5, 1.0), (1.0, 2.0)];
    assert_eq!(points, expected.map(|(t, y)| (t, DVec2::new(1.0, y))));
    assert_eq!(line.generated(0.5, 0.0, 1e9, 7).count(), 7);
    assert_eq!(line.generated(0.5, 0.1, 0.2, 7).count(), 0);
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn values_are_the_nearest(
        [a, b, c] in [number(), number(), number()],
        [px, py, dx, dy] in [number(), number(), number(), number()],
    ) {
        let (line, ray) = (implicit(a, b, c), parametric([px, py], [dx, dy]));
        let [rate, offset] = [
            big(a) * big(dx) + big(b) * big(dy),
            big(a) * big(px) + big(b) * big(py) + big(c),
        ];
        let t = -offset.clone() / &rate;
        let s = Substitution::new(line, ray).unwrap();
        prop_assert_eq!(s.rate, rate.to_f64().value());
        prop_assert_eq!(s.offset, offset.to_f64().value());
        let Meeting::At(found) = s.meeting else { panic!("{:?}", s.meeting) };
        prop_assert_eq!(found.t, t.to_f64().value());
        prop_assert_eq!(found.ray_hits, t > big(0.0));
        prop_assert_eq!(found.point.x, (big(px) + &t * big(dx)).to_f64().value());
        prop_assert_eq!(found.point.y, (big(py) + &t * big(dy)).to_f64().value());
    }

    #[test]
    fn among_small_integers_the_verdict_is_the_determinant_s(
        [a, b, c] in [small(), small(), small()],
        [px, py, dx, dy] in [small(), small(), small(), small()],
    ) {
        let (line, ray) = (implicit(a, b, c), parametric([px, py], [dx, dy]));
        let Ok(s) = Substitution::new(line, ray) else {
            prop_assert!((a == 0.0 && b == 0.0) || (dx == 0.0 && dy == 0.0));
            return Ok(());
        };
        let (rate, offset) = (a * dx + b * dy, a * px + b * py + c);
        match s.meeting {
            Meeting::Parallel => prop_assert!(rate == 0.0 && offset != 0.0),
            Meeting::Coincident => {
                prop_assert!(rate == 0.0 && offset == 0.0);
                prop_assert_eq!(s.f(17.0), (0.0, Ordering::Equal));
            }
            Meeting::At(Crossing { t, ray_hits, .. }) => {
                prop_assert_eq!(t, -offset / rate + 0.0);
                prop_assert_eq!(ray_hits, t > 0.0);
            }
            Meeting::TooFar { .. } => prop_assert!(false, "nothing is far"),
        }
    }

    #[test]
    fn a_line_along_a_direction_has_both_points(
        [x1, y1, x2, y2] in [small(), small(), small(), small()],
    ) {
        let (first, second) = (DVec2::new(x1, y1), DVec2::new(x2, y2));
        prop_assume!(first != second);
        let line = ImplicitLine::along(second - first, first);
        for point in [first, second] {
            prop_assert_eq!(line.side(point), Ordering::Equal);
        }
        prop_assert_eq!(line.direction(), second - first);
        prop_assert_eq!(line.side(first + (second - first).perp()), Ordering::Greater);
    }

    #[test]
    fn nearest_points_are_on_the_line_and_across_from_it(
        [a, b, c, x, y] in [-9.0..9.0, -9.0..9.0, -9.0..9.0, -9.0..9.0, -9.0..9.0_f64],
        size in prop_oneof![Just(1.0), Just(1e-200), Just(1e200)],
    ) {
        prop_assume!(a.hypot(b) > 0.1);
        let (line, point) = (implicit(a * size, b * size, c * size), DVec2::new(x, y));
        let nearest = line.nearest_to(point);
        prop_assert!((a * nearest.x + b * nearest.y + c).abs() < 1e-11);
        prop_assert!((nearest - point).dot(DVec2::new(b, -a)).abs() < 1e-10);
        let ray = ParametricLine { p: nearest, d: line.direction() };
        prop_assert!((ray.nearest_t(point) * size).abs() < 1e-10);
        let ahead = nearest + 2.0 * DVec2::new(b, -a);
        prop_assert!((ray.nearest_t(ahead) * size - 2.0).abs() < 1e-10);
    }
}
