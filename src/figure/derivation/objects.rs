//! Derivation of the intersection with one object: the ray is substituted into the object's implicit
//! equation, which then is an equation for t; its coefficients, its roots, the hit and the normal.

use pinhole_core::{Object, Plane, Ray, Root, Sphere};
use pinhole_exchange::document::Document;
use pinhole_lecture::{ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation};

use super::DerivedLine;
use super::camera::along;
use super::numbers::{CENTRE, D, HIT, N, NumberFormat, P, POINT, T, dot, equation, joined, minus};
use crate::EquationStep::{
    self, Coefficients, Coordinate, Discriminant, Offset, OffsetSquared, Solution, Substitution,
};
use crate::formula::{
    Formula, Operator, SymbolInk, fraction, index, negative, norm, number, parentheses, power, row,
    square_root,
};
use crate::{Concept, Given, GivenVector, Inspection};

const X: Formula = Formula::Vector("x", SymbolInk::Text);
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
    by_coordinate: bool,
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
            let rows = document.csv_spheres.iter();
            rows.filter_map(|csv| csv.items.spheres.get(index - document.spheres.len()))
                .flat_map(|Sphere { center, radius }| {
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
    (numbers, by_coordinate): (NumberFormat, bool),
) -> Vec<DerivedLine> {
    let lines = givens(document, object, numbers);
    let mut lines = ObjectLines { object, ray, inspection, numbers, by_coordinate, lines };
    match derivation {
        ObjectDerivation::Sphere(sphere) => lines.sphere(sphere),
        ObjectDerivation::Plane(plane) => lines.plane(plane),
    }
    lines.lines
}

impl ObjectLines<'_> {
    fn line<const N: usize>(&mut self, step: EquationStep, sides: [Formula; N]) {
        self.noted_line(step, sides, "");
    }

    /// Returns the concept of a step on the way to t.
    fn concept_of(&self, step: EquationStep) -> Concept {
        Concept::Equation { object: self.object, step }
    }

    /// Lets the line that was added last direct the figure to this concept in place of the object.
    fn directs_to(&mut self, concept: Concept) {
        if let Some(line) = self.lines.last_mut() {
            line.directs_to = Some(concept);
        }
    }

    fn noted_line<const N: usize>(&mut self, step: EquationStep, sides: [Formula; N], note: &str) {
        let concept = self.concept_of(step);
        self.lines.push(DerivedLine::chain(concept, sides).noted(note));
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
        self.sphere_substitution(&derivation.sphere);
        self.coefficients(derivation);
        self.discriminant(derivation);
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
            self.normal(hit, symbols, Some(substituted));
        }
    }

    /// Adds the lines that substitute the ray into the sphere's equation and multiply it out.
    fn sphere_substitution(&mut self, sphere: &Sphere) {
        let numbers = self.numbers;
        let squares = |of: Formula, radius| [power(norm(of), "2"), power(radius, "2")];
        let implicit = squares(minus(X, CENTRE), R);
        self.noted_line(Substitution, implicit, "implicit: 𝐱 is on the sphere");
        let symbols = squares(minus(along(P, T, D), CENTRE), R);
        self.noted_line(Substitution, symbols, "the ray put in");
        self.directs_to(Concept::Ray);
        let substituted = minus(self.ray_in_numbers(), numbers.vector(sphere.center));
        let radius = squared(numbers.scalar(sphere.radius));
        let sides = squares(substituted, radius);
        self.lines.push(DerivedLine::chain(Concept::Object(self.object), sides));
        let from_centre = minus(P, CENTRE);
        let terms = [
            row([power(T, "2"), dot(D, D)]),
            row([number("2"), T, dot(D, parentheses(from_centre.clone()))]),
            power(norm(from_centre), "2"),
        ];
        let sum = |[a, b, c]: [Formula; 3]| joined(joined(a, Operator::Plus, b), Operator::Plus, c);
        self.noted_line(Substitution, [sum(terms), power(R, "2")], "multiplied out");
        self.directs_to(Concept::Direction);
        let terms = [row([A, power(T, "2")]), row([number("2"), B, T]), C];
        self.noted_line(Substitution, [sum(terms), number("0")], "sorted by 𝑡");
        self.directs_to(Concept::Ray);
    }

    /// Returns `p + t d` with the ray's numbers.
    fn ray_in_numbers(&self) -> Formula {
        let Ray { origin, direction, .. } = self.ray;
        along(self.numbers.vector(origin), T, self.numbers.vector(direction))
    }

    /// Adds the lines that compute the coefficients a, b, c of the quadratic equation, and the equation.
    fn coefficients(&mut self, derivation: &SphereDerivation) {
        let (numbers, quadratic) = (self.numbers, &derivation.quadratic);
        let (p, c) = (numbers.vector(self.ray.origin), numbers.vector(derivation.sphere.center));
        let sides = [minus(P, CENTRE), minus(p, c), numbers.vector(derivation.from_center)];
        self.lines.push(DerivedLine::chain(Concept::Object(self.object), sides));
        self.directs_to(self.concept_of(Offset));
        let d = || numbers.vector(self.ray.direction);
        let oc = || numbers.vector(derivation.from_center);
        let from_centre = minus(P, CENTRE);
        let radius = numbers.scalar(derivation.sphere.radius);
        let squares = |derivation: Formula, minus_of: Formula| {
            minus(power(derivation, "2"), power(minus_of, "2"))
        };
        let parts = [
            (Concept::Direction, A, dot(D, D), dot(d(), d()), quadratic.a),
            (
                self.concept_of(Offset),
                B,
                dot(D, parentheses(from_centre.clone())),
                dot(d(), oc()),
                quadratic.b,
            ),
            (
                self.concept_of(OffsetSquared),
                C,
                squares(norm(from_centre), R),
                squares(norm(oc()), squared(radius)),
                quadratic.c,
            ),
        ];
        for (about, name, symbols, substituted, value) in parts {
            self.line(Coefficients, [name, symbols, substituted, numbers.scalar(value)]);
            self.directs_to(about);
        }
        let equation = numbers.quadratic([quadratic.a, 2.0 * quadratic.b, quadratic.c]);
        self.line(Coefficients, [equation, number("0")]);
        self.directs_to(Concept::Ray);
    }

    /// Adds the lines that solve the equation for t and compute the discriminant D. Their notes say why b is
    /// half of the linear coefficient, and what the sign of D means.
    fn discriminant(&mut self, derivation: &SphereDerivation) {
        let (numbers, quadratic) = (self.numbers, &derivation.quadratic);
        let two = |of: &Formula| row([number("2"), of.clone()]);
        let solved = |b: Formula, discriminant, a| {
            let above = [negative(b), Operator::MinusOrPlus.into(), square_root(discriminant)];
            fraction(row(above), a)
        };
        let four = minus(power(parentheses(two(&B)), "2"), row([number("4"), A, C]));
        let sides = [T, solved(two(&B), four, two(&A)), solved(B, DISCRIMINANT, A)];
        let note = "every factor 2 cancels: 𝑏 is half the coefficient of 𝑡";
        self.noted_line(Solution, sides, note);
        self.directs_to(Concept::Ray);
        let [a, b, c] = [quadratic.a, quadratic.b, quadratic.c].map(|x| numbers.scalar(x));
        let sides = [
            DISCRIMINANT,
            minus(power(B, "2"), row([A, C])),
            minus(power(squared(b), "2"), dot(a, c.guarded())),
            numbers.scalar(quadratic.discriminant),
        ];
        self.noted_line(Discriminant, sides, derivation.meeting.of_discriminant());
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

    /// Adds the lines that solve the coordinate along a plane's normal for t, such as `0 − t = −6` and `t = 6`.
    /// Returns false if the normal is along no axis.
    fn coordinate(&mut self, plane: &Plane, root: &Root) -> bool {
        let mut axes = (0..3).filter(|k| plane.normal[*k] != 0.0);
        let (Some(k), None) = (axes.next(), axes.next()) else { return false };
        let (numbers, d) = (self.numbers, self.ray.direction[k]);
        let size = Some(numbers.scalar(d.abs())).filter(|size| *size != number("1"));
        let sign = if d < 0.0 { Operator::Minus } else { Operator::Plus };
        let along =
            joined(numbers.scalar(self.ray.origin[k]), sign, row(size.into_iter().chain([T])));
        let note = format!("the {} of ray and plane", ["𝑥", "𝑦", "𝑧"][k]);
        self.noted_line(Coordinate, [along, numbers.scalar(plane.point[k])], &note);
        self.directs_to(Concept::Ray);
        self.root([T, numbers.scalar(root.t)], 0);
        self.hit(T, 0, root);
        true
    }

    fn plane(&mut self, derivation: &PlaneDerivation) {
        let root = derivation.root.filter(|_| self.by_coordinate);
        if root.is_some_and(|root| self.coordinate(&derivation.plane, &root)) {
            return;
        }
        let numbers = self.numbers;
        let n = || numbers.vector(derivation.plane.normal);
        let rate = || numbers.scalar(derivation.terms.rate);
        let (point, p) = (numbers.vector(derivation.plane.point), numbers.vector(self.ray.origin));
        let to_point = parentheses(minus(POINT, P));
        let zero = |n, of| [dot(n, parentheses(of)), number("0")];
        let implicit = zero(N, minus(X, POINT));
        self.noted_line(Substitution, implicit, "implicit: 𝐱 is on the plane");
        let sides = zero(N, minus(along(P, T, D), POINT));
        self.noted_line(Substitution, sides, "the ray put in");
        self.directs_to(Concept::Ray);
        self.line(Coefficients, zero(n(), minus(self.ray_in_numbers(), point.clone())));
        let sides = [row([T, parentheses(dot(N, D))]), dot(N, to_point.clone())];
        self.noted_line(Substitution, sides, "multiplied out");
        self.directs_to(self.concept_of(Offset));
        let sides = [dot(N, D), dot(n(), numbers.vector(self.ray.direction)), rate()];
        self.line(Coefficients, sides);
        let substituted = dot(n(), parentheses(minus(point, p)));
        let offset = numbers.scalar(derivation.terms.offset);
        self.line(Coefficients, [dot(N, to_point.clone()), substituted, offset.clone()]);
        self.directs_to(self.concept_of(Offset));
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
        let substituted = fraction(offset, rate());
        self.root([T, quotient, substituted, numbers.scalar(root.t)], 0);
        if derivation.hit().is_some() {
            self.hit(T, 0, &root);
            self.normal(&root, fraction(N, norm(N)), None);
        }
    }

    /// Returns true if the root's point is the ray's hit: no other object is in front of it.
    fn is_first_hit(&self, root: &Root) -> bool {
        let first = self.inspection.first_hit();
        first.is_some_and(|first| first.object == root.object && first.t == root.t)
    }

    /// Adds the line that computes the point where the ray first meets this object. Only the point of the
    /// ray's first hit is named *hit*.
    fn hit(&mut self, t: Formula, k: usize, hit: &Root) {
        let numbers = self.numbers;
        let substituted = along(
            numbers.vector(self.ray.origin),
            numbers.scalar(hit.t),
            numbers.vector(self.ray.direction),
        );
        let name = self.is_first_hit(hit).then_some(HIT);
        let sides = [along(P, t, D), substituted, numbers.vector(hit.point)];
        let formula = name.into_iter().chain(sides).reduce(equation).unwrap_or_else(|| row([]));
        self.lines.push(DerivedLine::new(self.root_concept(k), formula));
        if self.is_first_hit(hit) {
            self.directs_to(Concept::Ray);
        }
    }

    /// Adds the line that computes the normal at the ray's first hit.
    fn normal(&mut self, hit: &Root, symbols: Formula, substituted: Option<Formula>) {
        if !self.is_first_hit(hit) {
            return;
        }
        let normal = Formula::Vector("normal", SymbolInk::Text);
        let numbers = substituted.into_iter().chain([self.numbers.vector(hit.normal)]);
        let formula = numbers.fold(equation(normal, symbols), equation);
        self.lines.push(DerivedLine::new(Concept::Normal, formula));
    }
}

/// Returns a formula as the base of a power: in parentheses unless it is a name or an unsigned number.
fn squared(base: Formula) -> Formula {
    match base {
        plain @ (Formula::Number(_) | Formula::Rounded(_) | Formula::Scalar(_)) => plain,
        other => parentheses(other),
    }
}
