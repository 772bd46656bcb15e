//! Derivation of the intersection with one object: the coefficients, the roots, the hit and the normal.

use pinhole_core::{Object, Plane, Ray, Root, Sphere};
use pinhole_exchange::document::{Document, Item};
use pinhole_lecture::{
    ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
};

use super::DerivedLine;
use super::camera::along;
use super::numbers::{CENTRE, D, HIT, N, NumberFormat, P, POINT, T, dot, equation, minus};
use crate::model::{Concept, Given, GivenVector, Inspection};
use crate::view::formula::{
    Formula, Operator, SymbolInk, fraction, index, negative, norm, number, parentheses, power, row,
    square_root,
};

const A: Formula = Formula::Scalar("a");
const B: Formula = Formula::Scalar("b");
const C: Formula = Formula::Scalar("c");
const R: Formula = Formula::Scalar("r");
const DISCRIMINANT: Formula = Formula::Scalar("D");

/// The lines of the derivation for one object, and the inputs from which they are built.
struct ObjectLines<'a> {
    object: u32,
    ray: Ray,
    inspection: &'a Inspection,
    numbers: NumberFormat,
    lines: Vec<DerivedLine>,
}

/// Returns the lines with an object's given numbers. Those of a sphere from a CSV file cannot be edited.
pub(super) fn givens(document: &Document, object: u32, numbers: NumberFormat) -> Vec<DerivedLine> {
    let index = object as usize;
    let line = |name, right| DerivedLine::new(Concept::Object(object), equation(name, right));
    match document.object(index) {
        Some(Object::Sphere(Sphere { center, radius })) => vec![
            line(CENTRE, numbers.given_vector(GivenVector::Center(object), center)),
            line(R, numbers.given(Given::Radius(object), radius)),
        ],
        Some(Object::Plane(Plane { point, normal })) => vec![
            line(POINT, numbers.given_vector(GivenVector::Point(object), point)),
            line(N, numbers.given_vector(GivenVector::Normal(object), normal)),
        ],
        None => {
            let row = document.csv_spheres.iter().flat_map(|csv| csv.items.iter());
            let row = row.skip(index - document.spheres.len()).take(1);
            row.flat_map(|Item { shape: Sphere { center, radius }, .. }| {
                [line(CENTRE, numbers.vector(*center)), line(R, numbers.scalar(*radius))]
            })
            .collect()
        }
    }
}

pub(super) fn lines(
    document: &Document,
    object: u32,
    derivation: &ObjectDerivation,
    ray: Ray,
    inspection: &Inspection,
    numbers: NumberFormat,
) -> Vec<DerivedLine> {
    let lines = givens(document, object, numbers);
    let mut lines = ObjectLines { object, ray, inspection, numbers, lines };
    match derivation {
        ObjectDerivation::Sphere(sphere) => lines.sphere(sphere),
        ObjectDerivation::Plane(plane) => lines.plane(plane),
    }
    lines.lines
}

impl ObjectLines<'_> {
    fn line<const N: usize>(&mut self, sides: [Formula; N]) {
        self.lines.push(DerivedLine::chain(Concept::Object(self.object), sides));
    }

    fn root_concept(&self, number: usize) -> Concept {
        Concept::Root { object: self.object, number: number as u8 }
    }

    /// Adds the line that computes a root. Its note says where the root lies on the ray, such as "first
    /// hit".
    fn root<const N: usize>(&mut self, sides: [Formula; N], number: usize) {
        let index = self.inspection.index_of(self.object, number as u8);
        let verdict = index.map_or("", |index| self.inspection.verdict(index));
        let line = DerivedLine::chain(self.root_concept(number), sides);
        self.lines.push(line.noted(verdict));
    }

    fn sphere(&mut self, derivation: &SphereDerivation) {
        let numbers = self.numbers;
        let (p, c) = (numbers.vector(self.ray.origin), numbers.vector(derivation.sphere.center));
        self.line([minus(P, CENTRE), minus(p, c), numbers.vector(derivation.from_center)]);
        self.quadratic(derivation);
        let roots: Vec<Root> = derivation.roots.iter().flatten().copied().collect();
        for (k, root) in roots.iter().enumerate() {
            self.sphere_root(derivation, k, root, roots.len() == 1);
        }
        if let Some((k, hit)) = derivation.first.and_then(|k| Some((k, roots.get(k)?))) {
            let t = if roots.len() == 1 { T } else { index(T, number(&(k + 1).to_string())) };
            self.hit(t, k, hit);
            let above = minus(numbers.vector(hit.point), numbers.vector(derivation.sphere.center));
            let symbols = fraction(minus(HIT, CENTRE), R);
            let substituted = fraction(above, numbers.divisor(derivation.sphere.radius));
            self.normal(k, hit, symbols, Some(substituted));
        }
    }

    /// Adds the lines that compute the coefficients a, b, c of the quadratic equation and its discriminant
    /// D, with a note on what the sign of D means.
    fn quadratic(&mut self, derivation: &SphereDerivation) {
        let (numbers, quadratic) = (self.numbers, &derivation.quadratic);
        let d = || numbers.vector(self.ray.direction);
        let oc = || numbers.vector(derivation.from_center);
        let from_centre = minus(P, CENTRE);
        let radius = numbers.scalar(derivation.sphere.radius);
        let [a, b, c] = [quadratic.a, quadratic.b, quadratic.c].map(|x| numbers.scalar(x));
        let squares = |derivation: Formula, minus_of: Formula| {
            minus(power(derivation, "2"), power(minus_of, "2"))
        };
        let parts = [
            (A, dot(D, D), dot(d(), d()), quadratic.a),
            (B, dot(D, parentheses(from_centre.clone())), dot(d(), oc()), quadratic.b),
            (C, squares(norm(from_centre), R), squares(norm(oc()), squared(radius)), quadratic.c),
            (
                DISCRIMINANT,
                minus(power(B, "2"), row([A, C])),
                minus(power(squared(b), "2"), dot(a, c.guarded())),
                quadratic.discriminant,
            ),
        ];
        for (name, symbols, substituted, value) in parts {
            self.line([name, symbols, substituted, numbers.scalar(value)]);
        }
        if let Some(last) = self.lines.last_mut() {
            last.note = meaning(derivation.meeting).to_owned();
        }
    }

    fn sphere_root(&mut self, derivation: &SphereDerivation, k: usize, root: &Root, is_only: bool) {
        let numbers = self.numbers;
        let quadratic = &derivation.quadratic;
        let minus_b = numbers.scalar(0.0 - quadratic.b);
        let sign = if k == 0 { Operator::Minus } else { Operator::Plus };
        let name = if is_only { T } else { index(T, number(&(k + 1).to_string())) };
        let symbols = row([negative(B), sign.into(), square_root(DISCRIMINANT)]);
        let of_d = square_root(numbers.scalar(quadratic.discriminant));
        let substituted = row([minus_b, sign.into(), of_d]);
        let substituted = fraction(substituted, numbers.divisor(quadratic.a));
        self.root([name, fraction(symbols, A), substituted, numbers.scalar(root.t)], k);
    }

    fn plane(&mut self, derivation: &PlaneDerivation) {
        let numbers = self.numbers;
        let n = || numbers.vector(derivation.plane.normal);
        let rate = numbers.scalar(derivation.terms.rate);
        self.line([dot(N, D), dot(n(), numbers.vector(self.ray.direction)), rate]);
        let (point, p) = (numbers.vector(derivation.plane.point), numbers.vector(self.ray.origin));
        let to_point = parentheses(minus(POINT, P));
        let substituted = dot(n(), parentheses(minus(point, p)));
        let offset = numbers.scalar(derivation.terms.offset);
        self.line([dot(N, to_point.clone()), substituted, offset.clone()]);
        let quotient = fraction(dot(N, to_point), dot(N, D));
        let Some(root) = derivation.root else {
            let note = match derivation.meeting {
                PlaneMeeting::Within => "𝐧 · 𝐝 = 0, and the line lies in the plane: no hit",
                _ => "𝐧 · 𝐝 = 0: no t, the ray is parallel to the plane",
            };
            let line = DerivedLine::new(Concept::Object(self.object), equation(T, quotient));
            self.lines.push(line.noted(note));
            return;
        };
        let substituted = fraction(offset, numbers.divisor(derivation.terms.rate));
        self.root([T, quotient, substituted, numbers.scalar(root.t)], 0);
        if derivation.hit().is_some() {
            self.hit(T, 0, &root);
            self.normal(0, &root, fraction(N, norm(N)), None);
        }
    }

    /// Adds the line that computes the point where the ray first hits this object.
    fn hit(&mut self, t: Formula, k: usize, hit: &Root) {
        let numbers = self.numbers;
        let substituted = along(
            numbers.vector(self.ray.origin),
            numbers.scalar(hit.t),
            numbers.vector(self.ray.direction),
        );
        let sides = [HIT, along(P, t, D), substituted, numbers.vector(hit.point)];
        self.lines.push(DerivedLine::chain(self.root_concept(k), sides));
    }

    fn normal(&mut self, k: usize, hit: &Root, symbols: Formula, substituted: Option<Formula>) {
        let is_first = self
            .inspection
            .first_hit()
            .is_some_and(|first| first.object == hit.object && first.t == hit.t);
        let concept = if is_first { Concept::Normal } else { self.root_concept(k) };
        let normal = Formula::Vector("normal", SymbolInk::Text);
        let numbers = substituted.into_iter().chain([self.numbers.vector(hit.normal)]);
        let formula = numbers.fold(equation(normal, symbols), equation);
        self.lines.push(DerivedLine::new(concept, formula));
    }
}

/// Describes the meaning of the discriminant.
fn meaning(meeting: SphereMeeting) -> &'static str {
    match meeting {
        SphereMeeting::Missed => "𝐷 < 0: the line passes by",
        SphereMeeting::Tangent => "𝐷 = 0: the line touches the sphere",
        SphereMeeting::Through => "𝐷 > 0: two roots, in and out",
        SphereMeeting::FromInside => "𝐷 > 0, 𝑐 < 0: the eye is inside",
        SphereMeeting::FromSurface => "𝐷 > 0, 𝑐 = 0: the eye is on the sphere",
        SphereMeeting::Behind => "𝐷 ≥ 0, but no root is ahead of the eye",
    }
}

/// Returns a formula as the base of a power: in parentheses unless it is a name or an unsigned number.
fn squared(base: Formula) -> Formula {
    match base {
        plain @ (Formula::Number(_) | Formula::Rounded(_) | Formula::Scalar(_)) => plain,
        other => parentheses(other),
    }
}
