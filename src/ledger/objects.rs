//! Where the selected ray meets one object: the numbers that decide, the roots, the hit, the normal.

use pinhole_core::lecture::{
    ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
};
use pinhole_core::{Ray, Root};

use super::Line;
use super::names::{CENTER, D, HIT, N, P, POINT, T, dot, equation, minus};
use super::numbers::Numbers;
use super::ray::along;
use crate::formula::{
    Formula, Operator, fraction, index, negative, norm, number, parentheses, power, root, row,
};
use crate::inspection::Inspection;
use crate::thing::Thing;

const A: Formula = Formula::Scalar("a");
const B: Formula = Formula::Scalar("b");
const C: Formula = Formula::Scalar("c");
const R: Formula = Formula::Scalar("r");
const DISCRIMINANT: Formula = Formula::Scalar("D");

/// One object's lines in the making.
struct Sheet<'a> {
    object: u32,
    ray: Ray,
    inspection: &'a Inspection,
    numbers: Numbers,
    lines: Vec<Line>,
}

pub(super) fn lines(
    object: u32,
    derivation: &ObjectDerivation,
    ray: Ray,
    inspection: &Inspection,
    numbers: Numbers,
) -> Vec<Line> {
    let mut sheet = Sheet { object, ray, inspection, numbers, lines: Vec::new() };
    match derivation {
        ObjectDerivation::Sphere(sphere) => sheet.sphere(sphere),
        ObjectDerivation::Plane(plane) => sheet.plane(plane),
    }
    sheet.lines
}

impl Sheet<'_> {
    fn line(&mut self, formula: Formula) -> &mut Line {
        self.push(Line::of(Thing::Object(self.object), formula))
    }

    fn push(&mut self, line: Line) -> &mut Line {
        self.lines.push(line);
        let last = self.lines.len() - 1;
        &mut self.lines[last]
    }

    fn root_thing(&self, number: usize) -> Thing {
        Thing::Root { object: self.object, number: number as u8 }
    }

    /// Why a root is, or is not, what the ray hits.
    fn verdict(&self, root: &Root) -> &'static str {
        match self.inspection.first_hit() {
            _ if root.t < 0.0 => "behind the eye: no hit",
            _ if root.t == 0.0 => "at the eye: no hit",
            Some(hit) if hit.object == root.object && hit.t == root.t => {
                "the hit: the smallest t > 0 of all"
            }
            Some(hit) if hit.t == root.t => "the same t, but listed later",
            _ => "farther than the hit",
        }
    }

    fn sphere(&mut self, of: &SphereDerivation) {
        let numbers = self.numbers;
        let (p, c) = (numbers.decimals(self.ray.origin), numbers.decimals(of.sphere.center));
        let given = equation(CENTER, c.clone());
        let radius = equation(R, numbers.decimal(of.sphere.radius));
        self.line(row([given, Operator::Comma.into(), radius]));
        let from_center = || parentheses(minus(P, CENTER));
        let difference = equation(minus(P, CENTER), minus(p, c));
        self.line(row([difference, numbers.equals_vector(of.from_center)]));
        let d = || numbers.vector(self.ray.direction);
        let oc = || numbers.vector(of.from_center);
        let quadratic = &of.quadratic;
        let parts = [
            (A, dot(D, D), dot(d(), d()), quadratic.a),
            (B, dot(D, from_center()), dot(d(), oc()), quadratic.b),
            (
                C,
                minus(power(norm(minus(P, CENTER)), "2"), power(R, "2")),
                minus(
                    power(norm(oc()), "2"),
                    power(numbers.decimal(of.sphere.radius).guarded(), "2"),
                ),
                quadratic.c,
            ),
            (
                DISCRIMINANT,
                minus(power(B, "2"), row([A, C])),
                minus(
                    power(squared(numbers.scalar(quadratic.b)), "2"),
                    dot(numbers.scalar(quadratic.a), numbers.scalar(quadratic.c).guarded()),
                ),
                quadratic.discriminant,
            ),
        ];
        for (name, symbols, put_in, value) in parts {
            let formula = equation(equation(name, symbols), put_in);
            self.line(row([formula, numbers.equals(value)]));
        }
        if let Some(last) = self.lines.last_mut() {
            last.note = match of.meeting {
                SphereMeeting::Missed => "D < 0: the line passes by",
                SphereMeeting::Tangent => "D = 0: the line touches the sphere",
                SphereMeeting::Through => "D > 0: two roots, in and out",
                SphereMeeting::FromInside => "D > 0, c < 0: the eye is inside",
                SphereMeeting::FromSurface => "D > 0, c = 0: the eye is on the sphere",
                SphereMeeting::Behind => "D ≥ 0, but all of it is behind the eye",
            }
            .to_owned();
        }
        let found: Vec<Root> = of.roots.iter().flatten().copied().collect();
        for (k, root) in found.iter().enumerate() {
            self.sphere_root(of, k, root, found.len() == 1);
        }
        if let Some((k, hit)) = of.first.and_then(|k| Some((k, found.get(k)?))) {
            let t = if found.len() == 1 { T } else { index(T, number(&(k + 1).to_string())) };
            self.hit(t, k, hit);
            let above = minus(numbers.vector(hit.point), numbers.decimals(of.sphere.center));
            let symbols = fraction(minus(HIT, CENTER), R);
            let put_in = fraction(above, numbers.divisor(of.sphere.radius));
            self.normal(k, hit, symbols, Some(put_in));
        }
    }

    fn sphere_root(&mut self, of: &SphereDerivation, k: usize, found: &Root, is_only: bool) {
        let numbers = self.numbers;
        let quadratic = &of.quadratic;
        let a = || numbers.divisor(quadratic.a);
        let minus_b = numbers.decimal(0.0 - quadratic.b);
        let sign = if k == 0 { Operator::Minus } else { Operator::Plus };
        let name = if is_only { T } else { index(T, number(&(k + 1).to_string())) };
        let symbols = row([negative(B), sign.into(), root(DISCRIMINANT)]);
        let of_d = root(numbers.decimal(quadratic.discriminant));
        let put_in = row([minus_b, sign.into(), of_d]);
        let formula = equation(name, equation(fraction(symbols, A), fraction(put_in, a())));
        let line = Line::of(self.root_thing(k), row([formula, numbers.equals(found.t)]));
        let verdict = self.verdict(found);
        self.push(line.noted(verdict));
    }

    fn plane(&mut self, of: &PlaneDerivation) {
        let numbers = self.numbers;
        let (p, point) = (numbers.decimals(self.ray.origin), numbers.decimals(of.plane.point));
        let given = equation(POINT, point.clone());
        let given = row([given, Operator::Comma.into(), N]);
        self.line(equation(given, numbers.decimals(of.plane.normal)));
        let n = || numbers.decimals(of.plane.normal);
        let rate = equation(dot(N, D), dot(n(), numbers.vector(self.ray.direction)));
        self.line(row([rate, numbers.equals(of.terms.rate)]));
        let to_point = parentheses(minus(POINT, P));
        let put_in = dot(n(), parentheses(minus(point, p)));
        let offset = equation(dot(N, to_point.clone()), put_in);
        self.line(row([offset, numbers.equals(of.terms.offset)]));
        let symbols = fraction(dot(N, to_point), dot(N, D));
        let Some(found) = of.root else {
            let note = match of.meeting {
                PlaneMeeting::Within => "n · d = 0, and the line lies in the plane: no hit",
                _ => "n · d = 0: the ray is parallel to the plane",
            };
            let line = Line::of(Thing::Object(self.object), equation(T, symbols)).noted(note);
            self.push(Line { formula: T, ..line });
            return;
        };
        let put_in = fraction(numbers.scalar(of.terms.offset), numbers.divisor(of.terms.rate));
        let formula = equation(equation(T, symbols), put_in);
        let line = Line::of(self.root_thing(0), row([formula, numbers.equals(found.t)]));
        let verdict = self.verdict(&found);
        self.push(line.noted(verdict));
        if of.hit().is_some() {
            self.hit(T, 0, &found);
            self.normal(0, &found, fraction(N, norm(N)), None);
        }
    }

    /// The point of the object's own hit.
    fn hit(&mut self, t: Formula, k: usize, hit: &Root) {
        let numbers = self.numbers;
        let put_in = along(
            numbers.decimals(self.ray.origin),
            numbers.scalar(hit.t),
            numbers.vector(self.ray.direction),
        );
        let formula = equation(equation(HIT, along(P, t, D)), put_in);
        let formula = row([formula, numbers.equals_vector(hit.point)]);
        self.push(Line::of(self.root_thing(k), formula));
    }

    fn normal(&mut self, k: usize, hit: &Root, symbols: Formula, put_in: Option<Formula>) {
        let is_first = self
            .inspection
            .first_hit()
            .is_some_and(|first| first.object == hit.object && first.t == hit.t);
        let thing = if is_first { Thing::Normal } else { self.root_thing(k) };
        let normal = Formula::Vector("normal", crate::formula::Ink::Text);
        let result = self.numbers.equals_vector(hit.normal);
        let formula = equation(normal, symbols);
        let formula = put_in.into_iter().fold(formula, equation);
        self.push(Line::of(thing, row([formula, result])));
    }
}

/// What a power is taken of: in parentheses unless it is a number or name without a sign.
fn squared(base: Formula) -> Formula {
    match base {
        plain @ (Formula::Number(_) | Formula::Scalar(_)) => plain,
        other => parentheses(other),
    }
}
