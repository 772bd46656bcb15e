//! Derivation of u, v, w from view and up, or the checks of a basis that is set by hand.

use pinhole_core::{BasisError, Camera, DVec3};
use pinhole_lecture::{BasisByHand, BasisDerivation, BasisFromUp, Cross};

use super::Line;
use super::names::{AT, EYE, U, UP, V, VIEW, W, dot, equation, joined, minus, normalize, times};
use super::numbers::{Numbers, related};
use crate::model::concept::Concept;
use crate::model::given::GivenVector;
use crate::model::letters;
use crate::view::formula::{Formula, Operator, fraction, negative, norm, parentheses, row, word};

pub(super) fn lines(camera: &Camera, numbers: Numbers) -> Vec<Line> {
    match BasisDerivation::new(camera) {
        BasisDerivation::FromUp(from_up) => derived(&from_up, numbers),
        BasisDerivation::ByHand(by_hand) => checked(&by_hand, numbers),
    }
}

fn derived(derivation: &BasisFromUp, numbers: Numbers) -> Vec<Line> {
    let mut lines = vec![given(EYE, GivenVector::Eye, derivation.eye, Concept::Eye, numbers)];
    let vector = |name, as_given, value, concept| given(name, as_given, value, concept, numbers);
    lines.extend(derivation.at.map(|at| vector(AT, GivenVector::At, at, Concept::At)));
    lines.extend(derivation.up.map(|up| vector(UP, GivenVector::Up, up.vector, Concept::Up)));
    if let Some(view) = derivation.view {
        lines.push(match derivation.at {
            Some(at) => {
                let put_in = minus(numbers.vector(at), numbers.vector(derivation.eye));
                let sides = [VIEW, minus(AT, EYE), put_in];
                Line::chain(Concept::View, sides, numbers.equals_vector(view.vector))
            }
            None => vector(VIEW, GivenVector::View, view.vector, Concept::View),
        });
    }
    if let Some(backwards) = derivation.backwards {
        let result = numbers.equals_vector(backwards);
        lines.push(Line::chain(Concept::Backwards, [negative(VIEW)], result));
    }
    lines.extend(normalized(derivation, numbers));
    if let Some(cross) = &derivation.up_cross_w {
        lines.extend(crossed(cross, numbers));
    }
    if let Some(cross) = &derivation.up_cross_w {
        let formula = equation(U, normalize(times(UP, W)));
        let quotient = quotient(cross.product, cross.area, numbers);
        lines.push(match derivation.u {
            Some(u) => Line::new(Concept::U, followed(formula, quotient, numbers.equals_vector(u))),
            None => failed(Concept::U, formula, derivation.basis.err()),
        });
    }
    if let Some(cross) = &derivation.w_cross_u {
        let put_in = times(numbers.vector(cross.first.vector), numbers.vector(cross.second.vector));
        let sides = [V, times(W, U), put_in];
        let line = Line::chain(Concept::WCrossU, sides, numbers.equals_vector(cross.product));
        lines.push(line.also(&[Concept::V]));
    }
    lines
}

/// Returns the line of a vector that is given.
fn given(
    name: Formula,
    as_given: GivenVector,
    value: DVec3,
    concept: Concept,
    numbers: Numbers,
) -> Line {
    Line::new(concept, equation(name, numbers.given_vector(as_given, value)))
}

/// Returns the line of w, or of the reason why there is none.
fn normalized(derivation: &BasisFromUp, numbers: Numbers) -> Option<Line> {
    let formula = equation(W, normalize(negative(VIEW)));
    let (Some(view), Some(backwards), Some(w)) =
        (derivation.view, derivation.backwards, derivation.w)
    else {
        return Some(failed(Concept::W, formula, derivation.basis.err()));
    };
    let quotient = quotient(backwards, view.length, numbers);
    Some(Line::new(Concept::W, followed(formula, quotient, numbers.equals_vector(w))))
}

/// Returns the lines of `up x w` and of its length, which is the parallelogram's area.
fn crossed(cross: &Cross, numbers: Numbers) -> Vec<Line> {
    let put_in = times(numbers.vector(cross.first.vector), numbers.vector(cross.second.vector));
    let product = numbers.equals_vector(cross.product);
    let mut lines = vec![Line::chain(Concept::UpCrossW, [times(UP, W), put_in], product)];
    if let Some(angle) = cross.angle {
        let sine = |angle: Formula| row([word("sin"), parentheses(angle)]);
        let degrees = numbers.degrees(angle);
        let symbolic = row([norm(UP), sine(word("angle"))]);
        let put_in = joined(numbers.scalar(cross.first.length), Operator::Dot, sine(degrees));
        let sides = [norm(times(UP, W)), symbolic, put_in];
        lines.push(Line::chain(Concept::UpCrossW, sides, numbers.equals(cross.area)));
    }
    lines
}

/// Returns a vector divided by its length, with the numbers put in. A vector of length 1 whose
/// coordinates would be rounded stays in its exact form.
fn quotient(vector: DVec3, length: f64, numbers: Numbers) -> Formula {
    let (decimals, divisor) = (numbers.decimals(vector), numbers.divisor(length));
    if decimals.begins_rounded() && divisor == numbers.divisor(1.0) {
        return numbers.vector(vector);
    }
    fraction(decimals, divisor)
}

/// Returns the symbols, the numbers put in, and the result. The numbers are left out if they are
/// the same as the result.
fn followed(symbols: Formula, put_in: Formula, result: Formula) -> Formula {
    if result == related(put_in.clone()) {
        return row([symbols, result]);
    }
    row([equation(symbols, put_in), result])
}

/// Returns the line that fails, with the reason.
fn failed(concept: Concept, formula: Formula, why: Option<BasisError>) -> Line {
    let why = why.map_or_else(String::new, letters::typeset_message);
    Line { is_fault: true, ..Line::new(concept, formula).noted(why) }
}

fn checked(derivation: &BasisByHand, numbers: Numbers) -> Vec<Line> {
    let mut lines = vec![given(EYE, GivenVector::Eye, derivation.eye, Concept::Eye, numbers)];
    let names = || [(U, Concept::U), (V, Concept::V), (W, Concept::W)].into_iter();
    let values = [
        (GivenVector::U, derivation.u),
        (GivenVector::V, derivation.v),
        (GivenVector::W, derivation.w),
    ];
    for ((name, concept), (as_given, value)) in names().zip(values) {
        lines.push(given(name, as_given, value, concept, numbers).noted("set by hand"));
    }
    let verdict = |line: Line, passes: bool, right: &str, wrong: &str| Line {
        is_fault: !passes,
        ..line.noted(if passes { right } else { wrong })
    };
    for ((name, concept), check) in names().zip(derivation.lengths) {
        let Some(check) = check else { continue };
        let line = Line::chain(concept, [norm(name)], numbers.equals(check.value));
        lines.push(verdict(line, check.passes, "of length 1", "must be 1"));
    }
    let pairs = [(U, V, Concept::U), (V, W, Concept::V), (W, U, Concept::W)];
    for ((a, b, concept), check) in pairs.into_iter().zip(derivation.dots) {
        let Some(check) = check else { continue };
        let line = Line::chain(concept, [dot(a, b)], numbers.equals(check.value));
        lines.push(verdict(line, check.passes, "perpendicular", "must be 0"));
    }
    if let Some(check) = derivation.handedness {
        let formula = dot(parentheses(times(U, V)), W);
        let line = Line::chain(Concept::W, [formula], numbers.equals(check.value));
        let wrong = "left-handed: must be greater than 0";
        lines.push(verdict(line, check.passes, "right-handed", wrong));
    }
    if let Err(error) = derivation.basis {
        let line = Line { concept: None, ..Line::new(Concept::W, word("there is no basis")) };
        lines.push(Line { is_fault: true, ..line.noted(letters::typeset_message(error)) });
    }
    lines
}
