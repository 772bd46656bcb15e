//! The exact values whose signs decide what a ray hits, computed with the reference's numbers of 440
//! bits.

use pinhole_reference::{Object, Real};

pub(crate) type Vector = [Real; 3];

fn vector(v: [f64; 3]) -> Vector {
    v.map(Real::from)
}

/// Returns `a - b`.
pub(crate) fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| a[i].minus(&b[i]))
}

/// Returns `a . b`.
pub(crate) fn dot(a: &Vector, b: &Vector) -> Real {
    let [x, y, z] = std::array::from_fn(|i| a[i].times(&b[i]));
    x.plus(&y).plus(&z)
}

/// Returns the cosine of the angle between two vectors; `None` if one of them is 0.
fn cosine(a: &Vector, b: &Vector) -> Option<f64> {
    let (product, squares) = (dot(a, b), dot(a, a).times(&dot(b, b)));
    let square = product.times(&product).over(&squares);
    square.is_finite().then(|| square.sqrt().copysign(product.to_f64()))
}

/// Returns how far a point `q` is from an object, as a relative number whose sign is its side: for a
/// sphere, `(|q - center|^2 - radius^2) / (|q - center|^2 + radius^2)`; for a plane, the cosine of the
/// angle between the normal and the vector from `q` to the plane's point, 0 if that vector is 0.
pub(crate) fn side(object: &Object, q: [f64; 3]) -> f64 {
    match *object {
        Object::Sphere { center, radius } => {
            let from_center = minus(&vector(q), &vector(center));
            let radius = Real::from(radius);
            dot(&from_center, &from_center).relative_difference(&radius.times(&radius))
        }
        Object::Plane { point, normal } => {
            cosine(&vector(normal), &minus(&vector(point), &vector(q))).unwrap_or(0.0)
        }
    }
}

/// Returns `((q.d)^2 - |d|^2 (|q|^2 - r^2)) / (|d|^2 |q|^2)`, with q the vector from the eye to a
/// sphere's centre, r its radius and d the direction: 0 if the line touches the sphere, positive if it
/// meets it. `None` for a plane, and for a sphere around the eye.
pub(crate) fn grazing(object: &Object, eye: [f64; 3], direction: &Vector) -> Option<f64> {
    let Object::Sphere { center, radius } = *object else { return None };
    let (q, radius) = (minus(&vector(center), &vector(eye)), Real::from(radius));
    let (a, b, square) = (dot(direction, direction), dot(direction, &q), dot(&q, &q));
    let discriminant = b.times(&b).minus(&a.times(&square.minus(&radius.times(&radius))));
    let share = discriminant.over(&a.times(&square));
    share.is_finite().then_some(share)
}

/// Returns the cosine of the angle between a direction and the vector from the eye to a sphere's
/// centre, or a plane's normal; `None` if one of them is 0.
pub(crate) fn ahead(object: &Object, eye: [f64; 3], direction: &Vector) -> Option<f64> {
    cosine(
        direction,
        &match *object {
            Object::Sphere { center, .. } => minus(&vector(center), &vector(eye)),
            Object::Plane { normal, .. } => vector(normal),
        },
    )
}
