//! Derivation of the camera: how u, v and w follow from the view direction and up, or the checks of a basis
//! that the user entered directly; then the view ray of a pixel or of a point (u, v).

use pinhole_core::{Camera, DVec3, Pixel, Ray, ResolvedCamera, Selection, Viewport};
use pinhole_lecture::{
    BasisByHand, BasisCheck, BasisDerivation, BasisFromUp, Cross, RayDerivation,
};

use crate::derivation::numbers::{
    AT, D, DISTANCE, EYE, NumberFormat, P, T, U, UP, V, VIEW, W, dot, equation, joined, minus,
    normalize, times,
};
use crate::derivation::{DerivedLine, failed};
use crate::formula::{
    Formula, Operator, fraction, negative, norm, number, parentheses, row, tuple, word,
};
use crate::{Concept, Given, GivenVector, Inspection};

pub(super) fn basis_lines(camera: &Camera, numbers: NumberFormat) -> Vec<DerivedLine> {
    match BasisDerivation::new(camera) {
        BasisDerivation::FromUp(from_up) => derived(&from_up, numbers),
        BasisDerivation::ByHand(by_hand) => checked(&by_hand, numbers),
    }
}

fn derived(derivation: &BasisFromUp, numbers: NumberFormat) -> Vec<DerivedLine> {
    let mut lines = vec![given_line(EYE, GivenVector::Eye, derivation.eye, Concept::Eye, numbers)];
    let vector =
        |name, as_given, value, concept| given_line(name, as_given, value, concept, numbers);
    lines.extend(derivation.at.map(|at| vector(AT, GivenVector::At, at, Concept::At)));
    lines.extend(derivation.up.map(|up| vector(UP, GivenVector::Up, up.vector, Concept::Up)));
    if let Some(view) = derivation.view {
        lines.push(match derivation.at {
            Some(at) => {
                let substituted = minus(numbers.vector(at), numbers.vector(derivation.eye));
                let view = numbers.vector(view.vector);
                DerivedLine::chain(Concept::View, [VIEW, minus(AT, EYE), substituted, view])
            }
            None => vector(VIEW, GivenVector::View, view.vector, Concept::View),
        });
    }
    if let Some(backwards) = derivation.backwards {
        let sides = [negative(VIEW), numbers.vector(backwards)];
        lines.push(DerivedLine::chain(Concept::Backwards, sides));
    }
    lines.extend(normalized(derivation, numbers));
    if let Some(cross) = &derivation.up_cross_w {
        lines.extend(crossed(cross, numbers));
        let formula = equation(U, normalize(times(UP, W)));
        let quotient = quotient(cross.product, cross.area, numbers);
        lines.push(match derivation.u {
            Some(u) => DerivedLine::new(Concept::U, followed(formula, quotient, numbers.vector(u))),
            None => failed(Concept::U, formula, derivation.basis.err()),
        });
    }
    if let Some(cross) = &derivation.w_cross_u {
        let sides = [V, times(W, U), factors(cross, numbers), numbers.vector(cross.product)];
        lines.push(DerivedLine::chain(Concept::WCrossU, sides).also(&[Concept::V]));
    }
    lines
}

/// Creates the line of a given vector.
fn given_line(
    name: Formula,
    as_given: GivenVector,
    value: DVec3,
    concept: Concept,
    numbers: NumberFormat,
) -> DerivedLine {
    DerivedLine::new(concept, equation(name, numbers.given_vector(as_given, value))).given()
}

/// Returns the line of the derivation that computes w. If there is no w, its note says why.
fn normalized(derivation: &BasisFromUp, numbers: NumberFormat) -> Option<DerivedLine> {
    let formula = equation(W, normalize(negative(VIEW)));
    let vectors = (derivation.view, derivation.backwards, derivation.w);
    let (Some(view), Some(backwards), Some(w)) = vectors else {
        return Some(failed(Concept::W, formula, derivation.basis.err()));
    };
    let quotient = quotient(backwards, view.length, numbers);
    Some(DerivedLine::new(Concept::W, followed(formula, quotient, numbers.vector(w))))
}

/// Returns the two factors of a cross product as numbers.
fn factors(cross: &Cross, numbers: NumberFormat) -> Formula {
    times(numbers.vector(cross.first.vector), numbers.vector(cross.second.vector))
}

/// Returns the lines of the derivation for `up x w` and for its length, which is the area of the
/// parallelogram spanned by up and w.
fn crossed(cross: &Cross, numbers: NumberFormat) -> Vec<DerivedLine> {
    let sides = [times(UP, W), factors(cross, numbers), numbers.vector(cross.product)];
    let mut lines = vec![DerivedLine::chain(Concept::UpCrossW, sides)];
    if let Some(angle) = cross.angle {
        let sine = |angle: Formula| row([word("sin"), parentheses(angle)]);
        let degrees = numbers.degrees(angle);
        let symbolic = row([norm(UP), sine(word("angle"))]);
        let substituted = joined(numbers.scalar(cross.first.length), Operator::Dot, sine(degrees));
        let sides = [norm(times(UP, W)), symbolic, substituted, numbers.scalar(cross.area)];
        lines.push(DerivedLine::chain(Concept::UpCrossW, sides));
    }
    lines
}

/// Returns the formula of a vector divided by its length, in numbers. If the length is 1 and the
/// coordinates would be rounded, returns the vector alone, in its exact form.
fn quotient(vector: DVec3, length: f64, numbers: NumberFormat) -> Formula {
    let (decimals, divisor) = (numbers.decimals(vector), numbers.divisor(length));
    if decimals.begins_rounded() && divisor == numbers.divisor(1.0) {
        return numbers.vector(vector);
    }
    fraction(decimals, divisor)
}

/// Returns the formula `symbols = substituted = result`; omits `substituted` if it equals the result, or if it
/// is rounded and the result is exact.
fn followed(symbols: Formula, substituted: Formula, result: Formula) -> Formula {
    let is_rounded = substituted.begins_rounded() || substituted.ends_rounded();
    if result == substituted || is_rounded && !result.begins_rounded() {
        return equation(symbols, result);
    }
    equation(equation(symbols, substituted), result)
}

fn checked(derivation: &BasisByHand, numbers: NumberFormat) -> Vec<DerivedLine> {
    let mut lines = vec![given_line(EYE, GivenVector::Eye, derivation.eye, Concept::Eye, numbers)];
    for (name, as_given, value, concept) in [
        (U, GivenVector::U, derivation.u, Concept::U),
        (V, GivenVector::V, derivation.v, Concept::V),
        (W, GivenVector::W, derivation.w, Concept::W),
    ] {
        lines.push(given_line(name, as_given, value, concept, numbers).noted("set by hand"));
    }
    let [u, v, w] = [norm(U), norm(V), norm(W)];
    lines.extend(checks([u, v, w], derivation.lengths, ["of length 1", "must be 1"], numbers));
    let pairs = [dot(U, V), dot(V, W), dot(W, U)];
    lines.extend(checks(pairs, derivation.dots, ["perpendicular", "must be 0"], numbers));
    if let Some(check) = derivation.handedness {
        let formula = dot(parentheses(times(U, V)), W);
        let line = DerivedLine::chain(Concept::W, [formula, numbers.scalar(check.value)]);
        let texts = ["right-handed", "left-handed: must be greater than 0"];
        lines.push(judged(line, check.passes, texts));
    }
    if let Err(error) = derivation.basis {
        lines.push(failed(None, word("there is no basis"), Some(error)));
    }
    lines
}

/// Adds to the line of a check what it means if the check passes, or if it does not.
fn judged(line: DerivedLine, passes: bool, [right, wrong]: [&str; 2]) -> DerivedLine {
    DerivedLine { is_fault: !passes, ..line.noted(if passes { right } else { wrong }) }
}

/// Returns the lines of three checks of the same kind, about u, v and w: a single one if all of them pass with
/// the same number.
fn checks(
    symbols: [Formula; 3],
    checks: [Option<BasisCheck>; 3],
    texts: [&str; 2],
    numbers: NumberFormat,
) -> Vec<DerivedLine> {
    if let [Some(a), Some(b), Some(c)] = checks {
        let value = numbers.scalar(a.value);
        let is_same = |other: BasisCheck| other.passes && numbers.scalar(other.value) == value;
        if a.passes && is_same(b) && is_same(c) {
            let [first, second, third] = symbols;
            let line = DerivedLine::chain(Concept::U, [first, second, third, value]);
            return vec![judged(line.also(&[Concept::V, Concept::W]), true, texts)];
        }
    }
    let concepts = [Concept::U, Concept::V, Concept::W];
    let each = concepts.into_iter().zip(symbols).zip(checks);
    let lines = each.filter_map(|((concept, symbol), check)| {
        let check = check?;
        let line = DerivedLine::chain(concept, [symbol, numbers.scalar(check.value)]);
        Some(judged(line, check.passes, texts))
    });
    lines.collect()
}

/// Returns the lines of the derivation with the given numbers that determine the ray. They are shown even
/// if there is no ray, so that the user can correct a number that was dragged too far.
pub(super) fn ray_givens(
    camera: &Camera,
    selection: Selection,
    note: Option<&str>,
    numbers: NumberFormat,
) -> Vec<DerivedLine> {
    let scalar = |name, as_given, value: f64| {
        equation(Formula::Scalar(name), numbers.given(as_given, value))
    };
    let Viewport { width, height, distance, .. } = camera.viewport;
    let distance =
        DerivedLine::new(Concept::Distance, scalar("distance", Given::Distance, distance)).given();
    match selection {
        Selection::Uv(uv) => {
            let symbols = tuple([Formula::Scalar("u"), Formula::Scalar("v")]);
            let values = [(Given::PositionU, uv.x), (Given::PositionV, uv.y)];
            let values = tuple(values.map(|(as_given, x)| numbers.given(as_given, x)));
            let position = DerivedLine::new(Concept::Pixel, equation(symbols, values));
            vec![distance, position.noted(note.unwrap_or_default()).given()]
        }
        Selection::Pixel(pixel) => {
            let (i, j) = numbers.counted(pixel);
            let list = |[a, b]: [Formula; 2]| row([a, Operator::Comma.into(), b]);
            let size = |name, as_given, count: u32| scalar(name, as_given, count.into());
            let index = |name: &str, letter, as_given, k: u32| {
                row([word(name), scalar(letter, as_given, k.into())])
            };
            let viewport =
                [scalar("width", Given::Width, width), scalar("height", Given::Height, height)];
            let (columns, rows) = (camera.image.width(), camera.image.height());
            let image =
                [size("W", Given::ImageWidth, columns), size("H", Given::ImageHeight, rows)];
            let pixel = [index("row", "i", Given::Row, i), index("column", "j", Given::Column, j)];
            let counted = if numbers.from_one { "counted from 1" } else { "counted from 0" };
            vec![
                DerivedLine::new(Concept::Viewport, list(viewport)).given(),
                DerivedLine::new(Concept::Viewport, list(image)).noted("pixels").given(),
                distance,
                DerivedLine::new(Concept::Pixel, list(pixel)).noted(counted).given(),
            ]
        }
    }
}

pub(super) fn ray_lines(
    camera: &Camera,
    resolved: &ResolvedCamera,
    ray: &RayDerivation,
    inspection: &Inspection,
    numbers: NumberFormat,
) -> Vec<DerivedLine> {
    let mut lines = match ray.pixel {
        Some(pixel) => {
            let given = ray_givens(camera, Selection::Pixel(pixel), None, numbers);
            given.into_iter().chain(of_pixel(resolved, pixel, ray, numbers)).collect()
        }
        None => {
            let note = position_note(resolved, inspection, numbers);
            ray_givens(camera, Selection::Uv(ray.uv), Some(&note), numbers)
        }
    };
    let (viewport, basis) = (resolved.viewport(), resolved.basis());
    let distance = negative(DISTANCE);
    let minus_distance = -viewport.distance;
    let parts = [
        (Concept::AlongU, Formula::Scalar("u"), U, ray.uv.x, basis.u, ray.along_u),
        (Concept::AlongV, Formula::Scalar("v"), V, ray.uv.y, basis.v, ray.along_v),
        (Concept::AlongW, distance, W, minus_distance, basis.w, ray.along_w),
    ];
    for (concept, scalar, vector, factor, value, product) in parts {
        let substituted = row([numbers.scalar(factor), numbers.vector(value)]);
        let sides = [row([scalar, vector]), substituted, numbers.vector(product)];
        let line = DerivedLine::chain(concept, sides);
        lines.push(match concept {
            Concept::AlongW => line.also(&[Concept::Distance]),
            _ => line,
        });
    }
    let sum = |[a, b, c]: [Formula; 3], sign| joined(joined(a, Operator::Plus, b), sign, c);
    let symbols =
        [(row([Formula::Scalar("u"), U])), row([Formula::Scalar("v"), V]), row([DISTANCE, W])];
    let substituted = [ray.along_u, ray.along_v, ray.along_w].map(|part| numbers.vector(part));
    let (symbols, substituted) = (sum(symbols, Operator::Minus), sum(substituted, Operator::Plus));
    let sides = [D, symbols, substituted, numbers.vector(ray.ray.direction)];
    lines.push(DerivedLine::chain(Concept::Direction, sides));
    let length = DerivedLine::chain(Concept::Direction, [norm(D), numbers.scalar(ray.length)]);
    lines.push(length.noted("the distance per unit of 𝑡"));
    let substituted = along(numbers.vector(ray.ray.origin), T, numbers.vector(ray.ray.direction));
    let formula = equation(along(P, T, D), substituted);
    lines.push(DerivedLine::new(Concept::Ray, formula).noted("𝐩 = eye; 𝑡 = 1 is on the viewport"));
    lines
}

/// Returns the line that computes the ray's point at this t.
pub(super) fn point_line(ray: Ray, t: f64, numbers: NumberFormat) -> DerivedLine {
    let [p, d] = [ray.origin, ray.direction].map(|of| numbers.vector(of));
    let factor = || numbers.scalar(t);
    let sides = [along(P, factor(), D), along(p, factor(), d), numbers.vector(ray.at(t))];
    DerivedLine::chain(Concept::Ray, sides)
}

/// Returns `p + t d`.
pub(super) fn along(p: Formula, t: Formula, d: Formula) -> Formula {
    joined(p, Operator::Plus, row([t, d]))
}

/// Derives the u and v of a pixel's centre from its position as fractions of the image's width and height.
fn of_pixel(
    resolved: &ResolvedCamera,
    pixel: Pixel,
    ray: &RayDerivation,
    numbers: NumberFormat,
) -> Vec<DerivedLine> {
    let (i, j) = numbers.counted(pixel);
    let half = || number("0.5");
    // With an index that counts from 0, a pixel's centre lies half a pixel after the index; with one that
    // counts from 1, half a pixel before it.
    let sign = if numbers.from_one { Operator::Minus } else { Operator::Plus };
    let share = |k: Formula, count: Formula| fraction(joined(k, sign, half()), count);
    let whole = |n: u32| number(&n.to_string());
    let (viewport, image) = (resolved.viewport(), resolved.image());
    let named = |k, count| share(Formula::Scalar(k), Formula::Scalar(count));
    let [of_j, of_i] = [
        [named("j", "W"), share(whole(j), whole(image.width()))],
        [named("i", "H"), share(whole(i), whole(image.height()))],
    ];
    let line = |name, [extent, size]: [Formula; 2], [symbols, substituted]: [Formula; 2], value| {
        let symbols = row([extent, parentheses(symbols)]);
        let substituted = row([size, parentheses(substituted)]);
        let sides = [Formula::Scalar(name), symbols, substituted, numbers.scalar(value)];
        DerivedLine::chain(Concept::Pixel, sides)
    };
    let width = [Formula::Scalar("width"), numbers.scalar(viewport.width)];
    let height = [Formula::Scalar("height"), numbers.scalar(viewport.height)];
    vec![
        line("u", width, of_j.map(|share| minus(share, half())), ray.uv.x),
        line("v", height, of_i.map(|share| minus(half(), share)), ray.uv.y),
    ]
}

/// Describes where a given (u, v) lies in the image.
fn position_note(resolved: &ResolvedCamera, found: &Inspection, numbers: NumberFormat) -> String {
    match found.image_position {
        None => "outside the image".to_owned(),
        Some(position) if position.touching(resolved.image()).len() == 4 => {
            "the corner of four pixels, no pixel's centre".to_owned()
        }
        Some(position) => match position.only_pixel() {
            Some(pixel) => {
                let (i, j) = numbers.counted(pixel);
                format!("in the pixel of row {i}, column {j}")
            }
            None => "on an edge between pixels".to_owned(),
        },
    }
}
