//! Complete sets of answers to exercises, with the mistakes that students make. The wrong numbers were
//! calculated by hand; the tests check which mistakes the verdict on each part names.

use std::f64::consts::{FRAC_1_SQRT_2 as S, SQRT_2};

use pinhole_lecture::exercises::{Answer, Asked, Exercise, Question, Verdict};
use pinhole_lecture::mistakes::Mistake;

use Asked::{Direction, Hits, Normal, Origin, Point, T, U, V, W};

/// The quantity that a part of a question asks for, the answered numbers, and the mistakes that the
/// verdict names; none if the answer is right.
type Line<'a> = (Asked, &'a [f64], &'a [Mistake]);

#[track_caller]
fn sheet(exercise: Exercise, lines: &[Line<'_>]) {
    let question = Question::new(exercise, None);
    let mut answers = vec![None; question.parts.len()];
    let index = |asked| question.parts.iter().position(|part| part.asked == asked).unwrap();
    for (asked, numbers, _) in lines {
        answers[index(*asked)] = Some(match *asked {
            Hits => Answer::Yes(numbers[0] > 0.0),
            _ => Answer::Numbers(numbers.to_vec()),
        });
    }
    let verdicts = question.judge(&answers);
    for (asked, numbers, mistakes) in lines {
        let verdict = verdicts[index(*asked)].clone().unwrap();
        if mistakes.is_empty() {
            assert!(verdict.is_right(), "{exercise:?} {asked:?} {numbers:?}: {verdict:?}");
            continue;
        }
        let Verdict::Mistakes(named) = &verdict else {
            panic!("{exercise:?} {asked:?} {numbers:?}: {verdict:?}")
        };
        let first = !mistakes.contains(&Mistake::ULeftwards) || named[0] == Mistake::ULeftwards;
        let same = first
            && named.len() == mistakes.len()
            && mistakes.iter().all(|mistake| named.contains(mistake));
        assert!(same, "{exercise:?} {asked:?} {numbers:?}: {named:?} and not {mistakes:?}");
    }
}

#[test]
fn a_view_ray() {
    let origin =
        |p: [f64; 3]| sheet(Exercise::WarmUpRay, &[(Origin, &p, &[Mistake::ViewportForEye])]);
    // The viewport's middle, the ray's point in it, and that point moved into the eye's plane.
    origin([0.0, 0.0, -1.0]);
    origin([0.2, -0.1, -1.0]);
    origin([0.2, -0.1, 0.0]);
    for (d, mistake) in [
        ([0.2, -0.1, 1.0], Mistake::SignOfZ),
        ([0.4, -0.2, 2.0], Mistake::SignOfZ),
        ([0.2, -0.1, 0.0], Mistake::FlatDirection),
        ([-0.1, 0.2, -1.0], Mistake::UvSwapped),
        ([0.2, 0.1, -1.0], Mistake::VDown),
        ([-0.2, -0.1, -1.0], Mistake::ULeft),
        ([0.0, 0.0, -1.0], Mistake::UvLeftOut),
    ] {
        sheet(Exercise::WarmUpRay, &[(Origin, &[0.0; 3], &[]), (Direction, &d, &[mistake])]);
    }
    // Any positive multiple, such as the unit vector, is the same ray.
    let length = 1.05f64.sqrt();
    for times in [0.1, 5.0, 1.0 / length] {
        let d = [0.2 * times, -0.1 * times, -times];
        sheet(Exercise::WarmUpRay, &[(Direction, &d, &[])]);
    }
}

#[test]
fn the_wall() {
    let wall = |lines: &[Line<'_>]| sheet(Exercise::WarmUpPlane, lines);
    let point: Line<'_> = (Point, &[1.2, -0.6, -6.0], &[]);
    let t: Line<'_> = (T, &[6.0], &[]);
    // 6 with a minus, although z = -6, too, and a wrong sign of d's z gives the same.
    let minus = [Mistake::SignOfT];
    wall(&[(T, &[-6.0], &minus)]);
    wall(&[(T, &[-6.0], &minus), point]);
    wall(&[(T, &[-6.0], &minus), (Point, &[-1.2, 0.6, 6.0], &minus)]);
    // 6 |d| = 6 sqrt 1.05, a sixth, and 6 minus the 1 up to the viewport.
    wall(&[(T, &[6.0 * 1.05f64.sqrt()], &[Mistake::TForDistance]), point]);
    wall(&[(T, &[1.0 / 6.0], &[Mistake::TInverted]), point]);
    wall(&[(T, &[5.0], &[Mistake::FromViewport])]);
    wall(&[
        (T, &[5.0], &[Mistake::FromViewport]),
        (Point, &[1.0, -0.5, -5.0], &[Mistake::FromViewport]),
    ]);
    // d = (0.2, -0.1, 1) gives t = -6, and -6 d = (-1.2, 0.6, -6).
    wall(&[(T, &[-6.0], &[Mistake::SignOfZ]), (Point, &[-1.2, 0.6, -6.0], &[Mistake::SignOfZ])]);
    for (p, mistake) in [
        ([1.2, -0.6, 6.0], Mistake::SignOfZ),
        ([-0.6, 1.2, -6.0], Mistake::UvSwapped),
        ([1.2, 0.6, -6.0], Mistake::VDown),
        ([-1.2, -0.6, -6.0], Mistake::ULeft),
        ([0.0, 0.0, -6.0], Mistake::UvLeftOut),
        ([0.2, -0.1, -6.0], Mistake::UvUnscaled),
    ] {
        wall(&[t, (Point, &p, &[mistake])]);
    }
}

#[test]
fn another_distance() {
    let check = |d: [f64; 3], of_d: &[Mistake], t: f64, of_t: &[Mistake]| {
        sheet(Exercise::Distance, &[(Direction, &d, of_d), (T, &[t], of_t)]);
    };
    let dropped = [Mistake::DistanceDropped];
    // -6 = -t; -6 = -2 t; -6 = -t; the right line with -6 = -t.
    check([0.2, -0.1, -1.0], &dropped, 6.0, &dropped);
    check([0.4, -0.2, -2.0], &[Mistake::DistanceOnAll], 3.0, &[]);
    check([0.4, -0.2, -1.0], &[Mistake::DistanceOnUv], 6.0, &[Mistake::DistanceOnUv]);
    check([0.1, -0.05, -1.0], &[Mistake::ViewportAtOne], 6.0, &[Mistake::ViewportAtOne]);
    check([0.2, -0.1, 2.0], &[Mistake::SignOfZ], -3.0, &[Mistake::SignOfZ]);
    check([0.2, -0.1, 0.0], &[Mistake::FlatDirection], 3.0, &[]);
    check([-0.1, 0.2, -2.0], &[Mistake::UvSwapped], 3.0, &[]);
    check([0.2, 0.1, -2.0], &[Mistake::VDown], 3.0, &[]);
    let right = [0.2, -0.1, -2.0];
    check(right, &[], -6.0, &[Mistake::CoordinateForT]);
    check(right, &[], 6.0, &[Mistake::CoordinateForT]);
    check(right, &[], -3.0, &[Mistake::SignOfT]);
    // 3 |d| = 3 sqrt 4.05; 2 units and 2 d's, or 4 world units, from the viewport on.
    check(right, &[], 3.0 * 4.05f64.sqrt(), &[Mistake::TForDistance]);
    check(right, &[], 2.0, &[Mistake::FromViewport]);
    check(right, &[], 4.0, &[Mistake::FromViewport]);
    check(right, &[], 1.0 / 3.0, &[Mistake::TInverted]);
}

#[test]
fn a_turned_basis() {
    let (u, v, w) = ([S, 0.0, -S], [0.0, 1.0, 0.0], [S, 0.0, S]);
    // 0.2 u - 0.1 v - w = (0.2 s - s, -0.1, -0.2 s - s).
    let d = [-0.8 * S, -0.1, -1.2 * S];
    let all = |lines: [([f64; 3], &[Mistake]); 4], t: f64, of_t: &[Mistake]| {
        let [(u, of_u), (v, of_v), (w, of_w), (d, of_d)] = &lines;
        let lines: [Line<'_>; 5] =
            [(U, u, of_u), (V, v, of_v), (W, w, of_w), (Direction, d, of_d), (T, &[t], of_t)];
        sheet(Exercise::Turned, &lines);
    };
    let right: &[Mistake] = &[];
    // Not normalized: 0.2 (1, 0, -1) - 0.1 (0, 1, 0) - (1, 0, 1), and -6 = -1.2 t.
    let mistake: &[Mistake] = &[Mistake::BasisUnnormalized];
    let (long_u, long_w) = ([1.0, 0.0, -1.0], [1.0, 0.0, 1.0]);
    all(
        [(long_u, mistake), (v, right), (long_w, mistake), ([-0.8, -0.1, -1.2], mistake)],
        5.0,
        mistake,
    );
    // The axes' mean gives half of all numbers except v, and -6 = -0.6 t.
    let (short_u, short_w) = ([0.5, 0.0, -0.5], [0.5, 0.0, 0.5]);
    all(
        [(short_u, mistake), (v, right), (short_w, mistake), ([-0.4, -0.1, -0.6], mistake)],
        10.0,
        mistake,
    );
    // w forwards: 0.2 u - 0.1 v + w' with w' = (s, 0, s): z = 0.8 s, behind the eye.
    let mistake: &[Mistake] = &[Mistake::WForwards];
    let t = -6.0 / (0.8 * S);
    let minus_w = [-S, 0.0, -S];
    all(
        [(u, right), (v, right), (minus_w, mistake), ([1.2 * S, -0.1, 0.8 * S], mistake)],
        t,
        mistake,
    );
    // With the right w, the sign in front of it is wrong.
    let mistake: &[Mistake] = &[Mistake::DistanceAdded];
    all([(u, right), (v, right), (w, right), ([1.2 * S, -0.1, 0.8 * S], mistake)], t, mistake);
    // If everything else is right, the vector alone is wrong.
    all(
        [(u, right), (v, right), (minus_w, &[Mistake::WForwards]), (d, right)],
        5.0 * SQRT_2,
        right,
    );
    // u to the left: -0.2 u - 0.1 v - w, z = 0.2 s - s.
    let (mistake, t): (&[Mistake], f64) = (&[Mistake::ULeftwards], 6.0 / (0.8 * S));
    let minus_u = [-S, 0.0, S];
    all(
        [(minus_u, mistake), (v, right), (w, right), ([-1.2 * S, -0.1, -0.8 * S], mistake)],
        t,
        mistake,
    );
    // v = u x w = -y: the sign of -0.1 changes, t does not.
    let mistake: &[Mistake] = &[Mistake::VIsUCrossW];
    let down = [0.0, -1.0, 0.0];
    let turned_down = [-0.8 * S, 0.1, -1.2 * S];
    all([(u, right), (down, mistake), (w, right), (turned_down, mistake)], 5.0 * SQRT_2, right);
    let mistake: &[Mistake] = &[Mistake::VDown];
    all([(u, right), (v, right), (w, right), (turned_down, mistake)], 5.0 * SQRT_2, right);
    // u and w exchanged: 0.2 w - 0.1 v - u = (-0.8 s, -0.1, 1.2 s).
    let mistake: &[Mistake] = &[Mistake::UAndWSwapped];
    let swapped = [-0.8 * S, -0.1, 1.2 * S];
    all([(w, mistake), (v, right), (u, mistake), (swapped, mistake)], -5.0 * SQRT_2, mistake);
    // Right midway between +x and +z: u = (s, 0, s), w = (-s, 0, s), and d = (1.2 s, -0.1, -0.8 s).
    let (mistake, t): (&[Mistake], f64) = (&[Mistake::TurnedOtherWay], 6.0 / (0.8 * S));
    all(
        [(w, mistake), (v, right), (minus_u, mistake), ([1.2 * S, -0.1, -0.8 * S], mistake)],
        t,
        mistake,
    );
    let of_d = |d: [f64; 3], mistake: Mistake, t: f64, of_t: &[Mistake]| {
        all([(u, right), (v, right), (w, right), (d, &[mistake])], t, of_t);
    };
    // The basis, or only its z, is forgotten: -6 = -t.
    let mistake = Mistake::BasisForgotten;
    of_d([0.2, -0.1, -1.0], mistake, 6.0, &[mistake]);
    let mistake = Mistake::ZIsMinusDistance;
    of_d([-0.8 * S, -0.1, -1.0], mistake, 6.0, &[mistake]);
    // -0.1 u + 0.2 v - w = (-1.1 s, 0.2, -0.9 s).
    let mistake = Mistake::UvSwapped;
    of_d([-1.1 * S, 0.2, -0.9 * S], mistake, 6.0 / (0.9 * S), &[mistake]);
    let mistake = Mistake::FlatDirection;
    of_d([0.2 * S, -0.1, -0.2 * S], mistake, 6.0 / (0.2 * S), &[mistake]);
    let mistake = Mistake::UvLeftOut;
    of_d([-S, 0.0, -S], mistake, 6.0 * SQRT_2, &[mistake]);
    // |d|^2 = 1.05: u, v, w are orthonormal.
    let of_t = |t: f64, mistake| {
        all([(u, right), (v, right), (w, right), (d, right)], t, &[mistake]);
    };
    of_t(-6.0, Mistake::CoordinateForT);
    of_t(-5.0 * SQRT_2, Mistake::SignOfT);
    of_t(5.0 * SQRT_2 * 1.05f64.sqrt(), Mistake::TForDistance);
    of_t(0.2 * S, Mistake::TInverted);
    of_t(5.0 * SQRT_2 - 1.0, Mistake::FromViewport);
}

/// Checks the verdicts on the three vectors of a basis, each given by its numbers and the mistakes to
/// be named, in the order in which the exercise asks for them.
#[track_caller]
fn basis(exercise: Exercise, lines: [([f64; 3], &[Mistake]); 3]) {
    let [(w, of_w), (u, of_u), (v, of_v)] = &lines;
    sheet(exercise, &[(W, w, of_w), (U, u, of_u), (V, v, of_v)]);
}

#[test]
fn view_and_up() {
    let exercise = Exercise::ViewUp;
    let right: &[Mistake] = &[];
    // View (0, -2, 0), up (2, 2, 0).
    let (w, u, v) = ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let (left, down) = ([0.0, 0.0, -1.0], [-1.0, 0.0, 0.0]);
    basis(exercise, [(w, right), (u, right), (v, right)]);
    // w = view/|view| reverses u, and w x u is v again.
    let mistake = [Mistake::WAsPrinted];
    basis(exercise, [([0.0, -1.0, 0.0], &mistake), (left, &mistake), (v, right)]);
    // w as printed, but the rest found by hand: u is right nevertheless.
    basis(exercise, [([0.0, -1.0, 0.0], &mistake), (u, right), (v, right)]);
    // w = view; u = up x view normalized; v = (0, -2, 0) x (0, 0, -1).
    let mistake = [Mistake::WIsView];
    basis(exercise, [([0.0, -2.0, 0.0], &mistake), (left, &mistake), ([2.0, 0.0, 0.0], &mistake)]);
    // w = -view, u normalized, v = (0, 2, 0) x (0, 0, 1).
    let mistake = [Mistake::WNotNormalized];
    basis(exercise, [([0.0, 2.0, 0.0], &mistake), (u, right), ([2.0, 0.0, 0.0], &mistake)]);
    // up x w = (2, 2, 0) x (0, 1, 0), and v = w x u.
    let mistake = [Mistake::NotNormalized];
    basis(exercise, [(w, right), ([0.0, 0.0, 2.0], &mistake), ([2.0, 0.0, 0.0], &mistake)]);
    // Neither: (2, 2, 0) x (0, 2, 0) = (0, 0, 4), and (0, 2, 0) x (0, 0, 4) = (8, 0, 0).
    let mistake = [Mistake::NothingNormalized];
    basis(
        exercise,
        [([0.0, 2.0, 0.0], &mistake), ([0.0, 0.0, 4.0], &mistake), ([8.0, 0.0, 0.0], &mistake)],
    );
    // u = w x up and v = w x u with this u; both products exchanged; only the second exchanged.
    let mistake = [Mistake::UIsWCrossUp];
    basis(exercise, [(w, right), (left, &mistake), (down, &mistake)]);
    let mistake = [Mistake::ULeftwards, Mistake::LeftHanded];
    basis(exercise, [(w, right), (left, &mistake), (v, right)]);
    basis(exercise, [(w, right), (u, right), (down, &[Mistake::VIsUCrossW])]);
    let mistake = [Mistake::UpAsV];
    basis(exercise, [(w, right), (u, right), ([2.0, 2.0, 0.0], &mistake)]);
    basis(exercise, [(w, right), (u, right), ([S, S, 0.0], &mistake)]);
    let mistake = [Mistake::UAndVSwapped];
    basis(exercise, [(w, right), (v, &mistake), (u, &mistake)]);
}

#[test]
fn eye_at_and_up() {
    let exercise = Exercise::EyeAtUp;
    let right: &[Mistake] = &[];
    let over = |v: [f64; 3], length: f64| v.map(|x| x / length);
    let (r74, r682, r666) = (74f64.sqrt(), 682f64.sqrt(), 666f64.sqrt());
    // eye - at = (21, 4, 15); up x that = (15, 0, -21); (21, 4, 15) x (15, 0, -21) = (-84, 666, -60).
    let w = over([21.0, 4.0, 15.0], r682);
    let u = over([5.0, 0.0, -7.0], r74);
    let v = over([-84.0, 666.0, -60.0], r682 * r666);
    let minus = |v: [f64; 3]| v.map(|x| -x);
    basis(exercise, [(w, right), (u, right), (v, right)]);
    let mistake = [Mistake::WIsAtMinusEye];
    basis(exercise, [(minus(w), &mistake), (minus(u), &mistake), (v, right)]);
    // Nothing normalized; only w not normalized; only u not normalized: |up x w| = sqrt(666/682).
    let mistake = [Mistake::NothingNormalized];
    let all = [[21.0, 4.0, 15.0], [15.0, 0.0, -21.0], [-84.0, 666.0, -60.0]];
    basis(exercise, [(all[0], &mistake), (all[1], &mistake), (all[2], &mistake)]);
    let mistake = [Mistake::WNotNormalized];
    basis(exercise, [(all[0], &mistake), (u, right), (v.map(|x| x * r682), &mistake)]);
    let mistake = [Mistake::NotNormalized];
    basis(exercise, [(w, right), (over(all[1], r682), &mistake), (over(all[2], 682.0), &mistake)]);
    // w = at - eye; v = that x -u = (eye - at) x u.
    let mistake = [Mistake::WIsView];
    let long_v = over(all[2], r666);
    basis(exercise, [(minus(all[0]), &mistake), (minus(u), &mistake), (long_v, &mistake)]);
    let mistake = [Mistake::UIsWCrossUp];
    basis(exercise, [(w, right), (minus(u), &mistake), (minus(v), &mistake)]);
    let mistake = [Mistake::ULeftwards, Mistake::LeftHanded];
    basis(exercise, [(w, right), (minus(u), &mistake), (v, right)]);
    basis(exercise, [(w, right), (u, right), (minus(v), &[Mistake::VIsUCrossW])]);
    basis(exercise, [(w, right), (u, right), ([0.0, 1.0, 0.0], &[Mistake::UpAsV])]);
    basis(exercise, [(w, right), (v, &[Mistake::UAndVSwapped]), (u, &[Mistake::UAndVSwapped])]);
    // From at only: -(-1, 0, -5); from eye only; eye + at = (19, 4, 5).
    for (from, length, mistake) in [
        ([1.0, 0.0, 5.0], 26f64.sqrt(), Mistake::EyeForgotten),
        ([20.0, 4.0, 10.0], 516f64.sqrt(), Mistake::AtForgotten),
        ([19.0, 4.0, 5.0], 402f64.sqrt(), Mistake::EyePlusAt),
    ] {
        // up x (x, y, z) = (z, 0, -x).
        let [x, _, z] = from;
        let u = over([z, 0.0, -x], x.hypot(z));
        sheet(exercise, &[(W, &over(from, length), &[mistake]), (U, &u, &[mistake])]);
    }
}

/// If only one vector is answered, the verdict names the smaller of two mistakes that lead to it, not
/// one that includes it.
#[test]
fn one_vector_alone() {
    let w: Line<'_> = (W, &[21.0, 4.0, 15.0], &[Mistake::WNotNormalized]);
    sheet(Exercise::EyeAtUp, &[w]);
    let left = [Mistake::WAsPrinted, Mistake::UIsWCrossUp, Mistake::WIsView];
    sheet(Exercise::ViewUp, &[(U, &[0.0, 0.0, -1.0], &left)]);
    sheet(Exercise::ViewUp, &[(W, &[0.0, 1.0, 0.0], &[]), (U, &[0.0, 0.0, -1.0], &[left[1]])]);
}

#[test]
fn a_sphere() {
    // t^2 - 10 t + 24 = 0, or with half of b = -5: 5 -+ sqrt(25 - 24).
    let of_t = |t: f64, mistake: Mistake| {
        let (t, point) = ([t], [0.0, 0.0, -t]);
        sheet(Exercise::Sphere, &[(T, &t, &[mistake]), (Point, &point, &[mistake])]);
    };
    for (t, mistake) in [
        (6.0, Mistake::FarRoot),
        (-4.0, Mistake::SignOfT),
        // (10 - 2)/1 and (5 - 1)/2.
        (8.0, Mistake::DividedByA),
        (2.0, Mistake::DividedBy2A),
        // 10 - sqrt(100 - 24), -5 - 1, and 5 without the root.
        (10.0 - 76f64.sqrt(), Mistake::BForHalfB),
        (-6.0, Mistake::SignOfB),
        (5.0, Mistake::RootLeftOut),
    ] {
        of_t(t, mistake);
    }
    let normal = |n: [f64; 3], mistakes: &[Mistake]| {
        sheet(
            Exercise::Sphere,
            &[(T, &[4.0], &[]), (Point, &[0.0, 0.0, -4.0], &[]), (Normal, &n, mistakes)],
        );
    };
    normal([0.0, 0.0, 1.0], &[]);
    // The vector from the centre (0, 0, -5) to (0, 0, -6), although the point is right; and the
    // vector from the origin.
    normal([0.0, 0.0, -1.0], &[Mistake::NormalInwards, Mistake::NormalFromOrigin]);
    let far: Line<'_> = (Normal, &[0.0, 0.0, -1.0], &[Mistake::FarRoot]);
    let mistake = [Mistake::FarRoot];
    sheet(Exercise::Sphere, &[(T, &[6.0], &mistake), (Point, &[0.0, 0.0, -6.0], &mistake), far]);
    // The second root, although the point is that of the first root.
    sheet(Exercise::Sphere, &[(T, &[6.0], &mistake), (Point, &[0.0, 0.0, -4.0], &[])]);
}

#[test]
fn a_line() {
    // x + y - 2 = 0 and (t, t): 2 t = 2.
    let of_t = |t: f64, mistakes: &[Mistake]| {
        sheet(Exercise::Lines, &[(T, &[t], mistakes), (Point, &[t, t], mistakes)]);
    };
    // 2 t = -2 by a lost sign in c or in t; 2 t = 0; 2 not divided; t alone of 2 t.
    of_t(-1.0, &[Mistake::SignOfT, Mistake::SignOfC]);
    of_t(0.0, &[Mistake::CLeftOut]);
    of_t(2.0, &[Mistake::NotDivided, Mistake::TermLeftOut]);
    let parts: [Line<'_>; 2] = [(T, &[1.0], &[]), (Point, &[1.0, 1.0], &[])];
    sheet(Exercise::Lines, &[parts[0], parts[1], (Hits, &[1.0], &[])]);
    sheet(Exercise::Lines, &[parts[0], parts[1], (Hits, &[0.0], &[Mistake::LineForRay])]);
}
