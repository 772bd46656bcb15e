//! Sheets of answers as students hand them in: what each wrong number comes from is found by hand,
//! and which mistakes are named, part by part.

use std::f64::consts::{FRAC_1_SQRT_2 as S, SQRT_2};

use Asked::{Direction, Hits, Normal, Origin, Point, T, U, V, W};
use pinhole_lecture::exercises::{Answer, Asked, Exercise, Question, Slip, Verdict};

/// A part, its numbers, and the mistakes that are named; none where the answer is right.
type Line<'a> = (Asked, &'a [f64], &'a [Slip]);

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
    for (asked, numbers, slips) in lines {
        let verdict = verdicts[index(*asked)].clone().unwrap();
        if slips.is_empty() {
            assert!(verdict.is_right(), "{exercise:?} {asked:?} {numbers:?}: {verdict:?}");
            continue;
        }
        let Verdict::Slips(named) = &verdict else {
            panic!("{exercise:?} {asked:?} {numbers:?}: {verdict:?}")
        };
        let first = !slips.contains(&Slip::ULeftwards) || named[0] == Slip::ULeftwards;
        let same =
            first && named.len() == slips.len() && slips.iter().all(|slip| named.contains(slip));
        assert!(same, "{exercise:?} {asked:?} {numbers:?}: {named:?} and not {slips:?}");
    }
}

#[test]
fn a_view_ray() {
    let origin = |p: [f64; 3]| sheet(Exercise::WarmUpRay, &[(Origin, &p, &[Slip::ViewportForEye])]);
    // The viewport's middle, the ray's place in it, and that place moved into the eye's plane.
    origin([0.0, 0.0, -1.0]);
    origin([0.2, -0.1, -1.0]);
    origin([0.2, -0.1, 0.0]);
    for (d, slip) in [
        ([0.2, -0.1, 1.0], Slip::SignOfZ),
        ([0.4, -0.2, 2.0], Slip::SignOfZ),
        ([0.2, -0.1, 0.0], Slip::FlatDirection),
        ([-0.1, 0.2, -1.0], Slip::UvSwapped),
        ([0.2, 0.1, -1.0], Slip::VDown),
        ([-0.2, -0.1, -1.0], Slip::ULeft),
        ([0.0, 0.0, -1.0], Slip::UvLeftOut),
    ] {
        sheet(Exercise::WarmUpRay, &[(Origin, &[0.0; 3], &[]), (Direction, &d, &[slip])]);
    }
    // Any positive multiple is the same ray, the unit vector among them.
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
    // z = -6 itself, or 6 with a minus; not d's z, which would have spoilt the point.
    let minus = [Slip::SignOfT, Slip::CoordinateForT];
    wall(&[(T, &[-6.0], &minus), point]);
    // 6 |d| = 6 sqrt 1.05, a sixth, and 6 less the 1 up to the viewport.
    wall(&[(T, &[6.0 * 1.05f64.sqrt()], &[Slip::TForDistance]), point]);
    wall(&[(T, &[1.0 / 6.0], &[Slip::TInverted]), point]);
    wall(&[(T, &[5.0], &[Slip::FromViewport])]);
    wall(&[(T, &[5.0], &[Slip::FromViewport]), (Point, &[1.0, -0.5, -5.0], &[Slip::FromViewport])]);
    // d = (0.2, -0.1, 1) gives -6 = t, and -6 d = (-1.2, 0.6, -6).
    wall(&[(T, &[-6.0], &[Slip::SignOfZ]), (Point, &[-1.2, 0.6, -6.0], &[Slip::SignOfZ])]);
    for (p, slip) in [
        ([1.2, -0.6, 6.0], Slip::SignOfZ),
        ([-0.6, 1.2, -6.0], Slip::UvSwapped),
        ([1.2, 0.6, -6.0], Slip::VDown),
        ([-1.2, -0.6, -6.0], Slip::ULeft),
        ([0.0, 0.0, -6.0], Slip::UvLeftOut),
        ([0.2, -0.1, -6.0], Slip::UvUnscaled),
    ] {
        wall(&[t, (Point, &p, &[slip])]);
    }
}

#[test]
fn another_distance() {
    let of = |d: [f64; 3], of_d: &[Slip], t: f64, of_t: &[Slip]| {
        sheet(Exercise::Distance, &[(Direction, &d, of_d), (T, &[t], of_t)]);
    };
    let dropped = [Slip::DistanceDropped];
    // -6 = -t; -6 = -2 t; -6 = -t; the right line with -6 = -t.
    of([0.2, -0.1, -1.0], &dropped, 6.0, &dropped);
    of([0.4, -0.2, -2.0], &[Slip::DistanceOnAll], 3.0, &[]);
    of([0.4, -0.2, -1.0], &[Slip::DistanceOnUv], 6.0, &[Slip::DistanceOnUv]);
    of([0.1, -0.05, -1.0], &[Slip::ViewportAtOne], 6.0, &[Slip::ViewportAtOne]);
    of([0.2, -0.1, 2.0], &[Slip::SignOfZ], -3.0, &[Slip::SignOfZ]);
    of([0.2, -0.1, 0.0], &[Slip::FlatDirection], 3.0, &[]);
    of([-0.1, 0.2, -2.0], &[Slip::UvSwapped], 3.0, &[]);
    of([0.2, 0.1, -2.0], &[Slip::VDown], 3.0, &[]);
    let right = [0.2, -0.1, -2.0];
    of(right, &[], -6.0, &[Slip::CoordinateForT]);
    of(right, &[], 6.0, &[Slip::CoordinateForT]);
    of(right, &[], -3.0, &[Slip::SignOfT]);
    // 3 |d| = 3 sqrt 4.05; 2 units and 2 d's, or 4 world units, from the viewport on.
    of(right, &[], 3.0 * 4.05f64.sqrt(), &[Slip::TForDistance]);
    of(right, &[], 2.0, &[Slip::FromViewport]);
    of(right, &[], 4.0, &[Slip::FromViewport]);
    of(right, &[], 1.0 / 3.0, &[Slip::TInverted]);
}

#[test]
fn a_turned_basis() {
    let (u, v, w) = ([S, 0.0, -S], [0.0, 1.0, 0.0], [S, 0.0, S]);
    // 0.2 u - 0.1 v - w = (0.2 s - s, -0.1, -0.2 s - s).
    let d = [-0.8 * S, -0.1, -1.2 * S];
    let all = |lines: [([f64; 3], &[Slip]); 4], t: f64, of_t: &[Slip]| {
        let [(u, of_u), (v, of_v), (w, of_w), (d, of_d)] = &lines;
        let lines: [Line<'_>; 5] =
            [(U, u, of_u), (V, v, of_v), (W, w, of_w), (Direction, d, of_d), (T, &[t], of_t)];
        sheet(Exercise::Turned, &lines);
    };
    let right: &[Slip] = &[];
    // Not normalized: 0.2 (1, 0, -1) - 0.1 (0, 1, 0) - (1, 0, 1), and -6 = -1.2 t.
    let slip: &[Slip] = &[Slip::BasisUnnormalized];
    let (long_u, long_w) = ([1.0, 0.0, -1.0], [1.0, 0.0, 1.0]);
    all([(long_u, slip), (v, right), (long_w, slip), ([-0.8, -0.1, -1.2], slip)], 5.0, slip);
    // The axes' mean: half of all that but of v, and -6 = -0.6 t.
    let (short_u, short_w) = ([0.5, 0.0, -0.5], [0.5, 0.0, 0.5]);
    all([(short_u, slip), (v, right), (short_w, slip), ([-0.4, -0.1, -0.6], slip)], 10.0, slip);
    // w forwards: 0.2 u - 0.1 v + w' with w' = (s, 0, s): z = 0.8 s, behind the eye.
    let slip: &[Slip] = &[Slip::WForwards];
    let t = -6.0 / (0.8 * S);
    let minus_w = [-S, 0.0, -S];
    all([(u, right), (v, right), (minus_w, slip), ([1.2 * S, -0.1, 0.8 * S], slip)], t, slip);
    // With the right w it is the sign in front of it.
    let slip: &[Slip] = &[Slip::PlusW];
    all([(u, right), (v, right), (w, right), ([1.2 * S, -0.1, 0.8 * S], slip)], t, slip);
    // And with all else right, the vector alone.
    all([(u, right), (v, right), (minus_w, &[Slip::WForwards]), (d, right)], 5.0 * SQRT_2, right);
    // u to the left: -0.2 u - 0.1 v - w, z = 0.2 s - s.
    let (slip, t): (&[Slip], f64) = (&[Slip::ULeftwards], 6.0 / (0.8 * S));
    let minus_u = [-S, 0.0, S];
    all([(minus_u, slip), (v, right), (w, right), ([-1.2 * S, -0.1, -0.8 * S], slip)], t, slip);
    // v = u x w = -y: the sign of -0.1 changes, t does not.
    let slip: &[Slip] = &[Slip::VIsUCrossW];
    let down = [0.0, -1.0, 0.0];
    let turned_down = [-0.8 * S, 0.1, -1.2 * S];
    all([(u, right), (down, slip), (w, right), (turned_down, slip)], 5.0 * SQRT_2, right);
    let slip: &[Slip] = &[Slip::VDown];
    all([(u, right), (v, right), (w, right), (turned_down, slip)], 5.0 * SQRT_2, right);
    // u and w exchanged: 0.2 w - 0.1 v - u = (-0.8 s, -0.1, 1.2 s).
    let slip: &[Slip] = &[Slip::UAndWSwapped];
    let swapped = [-0.8 * S, -0.1, 1.2 * S];
    all([(w, slip), (v, right), (u, slip), (swapped, slip)], -5.0 * SQRT_2, slip);
    // Right midway between +x and +z: u = (s, 0, s), w = (-s, 0, s), and d = (1.2 s, -0.1, -0.8 s).
    let (slip, t): (&[Slip], f64) = (&[Slip::TurnedOtherWay], 6.0 / (0.8 * S));
    all([(w, slip), (v, right), (minus_u, slip), ([1.2 * S, -0.1, -0.8 * S], slip)], t, slip);
    let of_d = |d: [f64; 3], slip: Slip, t: f64, of_t: &[Slip]| {
        all([(u, right), (v, right), (w, right), (d, &[slip])], t, of_t);
    };
    // The basis is forgotten, or its z: -6 = -t.
    let slip = Slip::BasisForgotten;
    of_d([0.2, -0.1, -1.0], slip, 6.0, &[slip]);
    let slip = Slip::ZIsMinusDistance;
    of_d([-0.8 * S, -0.1, -1.0], slip, 6.0, &[slip]);
    // -0.1 u + 0.2 v - w = (-1.1 s, 0.2, -0.9 s).
    let slip = Slip::UvSwapped;
    of_d([-1.1 * S, 0.2, -0.9 * S], slip, 6.0 / (0.9 * S), &[slip]);
    let slip = Slip::FlatDirection;
    of_d([0.2 * S, -0.1, -0.2 * S], slip, 6.0 / (0.2 * S), &[slip]);
    let slip = Slip::UvLeftOut;
    of_d([-S, 0.0, -S], slip, 6.0 * SQRT_2, &[slip]);
    // |d|^2 = 1.05: u, v, w are orthonormal.
    let of_t = |t: f64, slip| {
        all([(u, right), (v, right), (w, right), (d, right)], t, &[slip]);
    };
    of_t(-6.0, Slip::CoordinateForT);
    of_t(-5.0 * SQRT_2, Slip::SignOfT);
    of_t(5.0 * SQRT_2 * 1.05f64.sqrt(), Slip::TForDistance);
    of_t(0.2 * S, Slip::TInverted);
    of_t(5.0 * SQRT_2 - 1.0, Slip::FromViewport);
}

/// The three of a constructed basis, in the order in which they are asked for.
#[track_caller]
fn basis(exercise: Exercise, lines: [([f64; 3], &[Slip]); 3]) {
    let [(w, of_w), (u, of_u), (v, of_v)] = &lines;
    sheet(exercise, &[(W, w, of_w), (U, u, of_u), (V, v, of_v)]);
}

#[test]
fn view_and_up() {
    let exercise = Exercise::ViewUp;
    let right: &[Slip] = &[];
    // View (0, -2, 0), up (2, 2, 0).
    let (w, u, v) = ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let (left, down) = ([0.0, 0.0, -1.0], [-1.0, 0.0, 0.0]);
    basis(exercise, [(w, right), (u, right), (v, right)]);
    // w = view/|view| turns u round, and w x u is v again.
    let slip = [Slip::WAsPrinted];
    basis(exercise, [([0.0, -1.0, 0.0], &slip), (left, &slip), (v, right)]);
    // As printed and found by hand: u right all the same.
    basis(exercise, [([0.0, -1.0, 0.0], &slip), (u, right), (v, right)]);
    // w = view; u = up x view normalized; v = (0, -2, 0) x (0, 0, -1).
    let slip = [Slip::WIsView];
    basis(exercise, [([0.0, -2.0, 0.0], &slip), (left, &slip), ([2.0, 0.0, 0.0], &slip)]);
    // w = -view, u normalized, v = (0, 2, 0) x (0, 0, 1).
    let slip = [Slip::WNotNormalized];
    basis(exercise, [([0.0, 2.0, 0.0], &slip), (u, right), ([2.0, 0.0, 0.0], &slip)]);
    // up x w = (2, 2, 0) x (0, 1, 0), and v = w x u.
    let slip = [Slip::UNotNormalized];
    basis(exercise, [(w, right), ([0.0, 0.0, 2.0], &slip), ([2.0, 0.0, 0.0], &slip)]);
    // Neither: (2, 2, 0) x (0, 2, 0) = (0, 0, 4), and (0, 2, 0) x (0, 0, 4) = (8, 0, 0).
    let slip = [Slip::NothingNormalized];
    basis(exercise, [([0.0, 2.0, 0.0], &slip), ([0.0, 0.0, 4.0], &slip), ([8.0, 0.0, 0.0], &slip)]);
    // u = w x up, v = w x u of it; both the other way round; the second alone.
    let slip = [Slip::UIsWCrossUp];
    basis(exercise, [(w, right), (left, &slip), (down, &slip)]);
    let slip = [Slip::ULeftwards, Slip::LeftHanded];
    basis(exercise, [(w, right), (left, &slip), (v, right)]);
    basis(exercise, [(w, right), (u, right), (down, &[Slip::VIsUCrossW])]);
    let slip = [Slip::UpAsV];
    basis(exercise, [(w, right), (u, right), ([2.0, 2.0, 0.0], &slip)]);
    basis(exercise, [(w, right), (u, right), ([S, S, 0.0], &slip)]);
    let slip = [Slip::UAndVSwapped];
    basis(exercise, [(w, right), (v, &slip), (u, &slip)]);
}

#[test]
fn eye_at_and_up() {
    let exercise = Exercise::EyeAtUp;
    let right: &[Slip] = &[];
    let over = |v: [f64; 3], length: f64| v.map(|x| x / length);
    let (r74, r682, r666) = (74f64.sqrt(), 682f64.sqrt(), 666f64.sqrt());
    // eye - at = (21, 4, 15); up x that = (15, 0, -21); (21, 4, 15) x (15, 0, -21) = (-84, 666, -60).
    let w = over([21.0, 4.0, 15.0], r682);
    let u = over([5.0, 0.0, -7.0], r74);
    let v = over([-84.0, 666.0, -60.0], r682 * r666);
    let minus = |v: [f64; 3]| v.map(|x| -x);
    basis(exercise, [(w, right), (u, right), (v, right)]);
    let slip = [Slip::WIsAtMinusEye];
    basis(exercise, [(minus(w), &slip), (minus(u), &slip), (v, right)]);
    // Nothing normalized, w alone not, u alone not: |up x w| = sqrt(666/682).
    let slip = [Slip::NothingNormalized];
    let all = [[21.0, 4.0, 15.0], [15.0, 0.0, -21.0], [-84.0, 666.0, -60.0]];
    basis(exercise, [(all[0], &slip), (all[1], &slip), (all[2], &slip)]);
    let slip = [Slip::WNotNormalized];
    basis(exercise, [(all[0], &slip), (u, right), (v.map(|x| x * r682), &slip)]);
    let slip = [Slip::UNotNormalized];
    basis(exercise, [(w, right), (over(all[1], r682), &slip), (over(all[2], 682.0), &slip)]);
    // w = at - eye; v = that x -u = (eye - at) x u.
    let slip = [Slip::WIsView];
    let long_v = over(all[2], r666);
    basis(exercise, [(minus(all[0]), &slip), (minus(u), &slip), (long_v, &slip)]);
    let slip = [Slip::UIsWCrossUp];
    basis(exercise, [(w, right), (minus(u), &slip), (minus(v), &slip)]);
    let slip = [Slip::ULeftwards, Slip::LeftHanded];
    basis(exercise, [(w, right), (minus(u), &slip), (v, right)]);
    basis(exercise, [(w, right), (u, right), (minus(v), &[Slip::VIsUCrossW])]);
    basis(exercise, [(w, right), (u, right), ([0.0, 1.0, 0.0], &[Slip::UpAsV])]);
    basis(exercise, [(w, right), (v, &[Slip::UAndVSwapped]), (u, &[Slip::UAndVSwapped])]);
    // From at alone: -(-1, 0, -5); from eye alone; eye + at = (19, 4, 5).
    for (from, length, slip) in [
        ([1.0, 0.0, 5.0], 26f64.sqrt(), Slip::EyeForgotten),
        ([20.0, 4.0, 10.0], 516f64.sqrt(), Slip::AtForgotten),
        ([19.0, 4.0, 5.0], 402f64.sqrt(), Slip::EyePlusAt),
    ] {
        // up x (x, y, z) = (z, 0, -x).
        let [x, _, z] = from;
        let u = over([z, 0.0, -x], x.hypot(z));
        sheet(exercise, &[(W, &over(from, length), &[slip]), (U, &u, &[slip])]);
    }
}

/// With nothing else to tell them apart, the mistake that holds another and more is not named.
#[test]
fn one_vector_alone() {
    let w: Line<'_> = (W, &[21.0, 4.0, 15.0], &[Slip::WNotNormalized]);
    sheet(Exercise::EyeAtUp, &[w]);
    let left = [Slip::WAsPrinted, Slip::UIsWCrossUp, Slip::WIsView];
    sheet(Exercise::ViewUp, &[(U, &[0.0, 0.0, -1.0], &left)]);
    sheet(Exercise::ViewUp, &[(W, &[0.0, 1.0, 0.0], &[]), (U, &[0.0, 0.0, -1.0], &[left[1]])]);
}

#[test]
fn a_sphere() {
    // t^2 - 10 t + 24 = 0, or with half of b = -5: 5 -+ sqrt(25 - 24).
    let of_t = |t: f64, slip: Slip| {
        let (t, point) = ([t], [0.0, 0.0, -t]);
        sheet(Exercise::Sphere, &[(T, &t, &[slip]), (Point, &point, &[slip])]);
    };
    for (t, slip) in [
        (6.0, Slip::FarRoot),
        (-4.0, Slip::SignOfT),
        // (10 - 2)/1 and (5 - 1)/2.
        (8.0, Slip::DividedByA),
        (2.0, Slip::DividedBy2A),
        // 10 - sqrt(100 - 24), -5 - 1, and 5 without the root.
        (10.0 - 76f64.sqrt(), Slip::BForHalfB),
        (-6.0, Slip::SignOfB),
        (5.0, Slip::RootLeftOut),
    ] {
        of_t(t, slip);
    }
    let normal = |n: [f64; 3], slips: &[Slip]| {
        sheet(
            Exercise::Sphere,
            &[(T, &[4.0], &[]), (Point, &[0.0, 0.0, -4.0], &[]), (Normal, &n, slips)],
        );
    };
    normal([0.0, 0.0, 1.0], &[]);
    // From the centre (0, 0, -5) to (0, 0, -6), too, but the point is right; and from the origin.
    normal([0.0, 0.0, -1.0], &[Slip::NormalInwards, Slip::NormalFromOrigin]);
    let far: Line<'_> = (Normal, &[0.0, 0.0, -1.0], &[Slip::FarRoot]);
    let slip = [Slip::FarRoot];
    sheet(Exercise::Sphere, &[(T, &[6.0], &slip), (Point, &[0.0, 0.0, -6.0], &slip), far]);
    // The second root, although the point is that of the first.
    sheet(Exercise::Sphere, &[(T, &[6.0], &slip), (Point, &[0.0, 0.0, -4.0], &[])]);
}

#[test]
fn a_line() {
    // x + y - 2 = 0 and (t, t): 2 t = 2.
    let of_t = |t: f64, slips: &[Slip]| {
        sheet(Exercise::Lines, &[(T, &[t], slips), (Point, &[t, t], slips)]);
    };
    // 2 t = -2 by a lost sign in c or in t; 2 t = 0; 2 not divided; t alone of 2 t.
    of_t(-1.0, &[Slip::SignOfT, Slip::SignOfC]);
    of_t(0.0, &[Slip::CLeftOut]);
    of_t(2.0, &[Slip::NotDivided, Slip::TermLeftOut]);
    let parts: [Line<'_>; 2] = [(T, &[1.0], &[]), (Point, &[1.0, 1.0], &[])];
    sheet(Exercise::Lines, &[parts[0], parts[1], (Hits, &[1.0], &[])]);
    sheet(Exercise::Lines, &[parts[0], parts[1], (Hits, &[0.0], &[Slip::LineForRay])]);
}
