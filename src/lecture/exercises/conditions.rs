//! Conditions that an answer has to fulfil, and by how much it misses them.

use pinhole_core::{Basis, DVec2, DVec3, Ray, Sphere};

/// Largest relative difference between an answer and the truth that counts as rounding.
pub(super) const TOLERANCE: f64 = 1e-9;

/// A fault of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// It is (0, 0, 0).
    Zero,
    /// This coordinate, counted from 0, is another; the other coordinates are right.
    Coordinate(usize),
    /// The length should be 1, and is this.
    Length(f64),
    /// It should be at right angles to the named vector.
    NotOrthogonal {
        /// `up`, `u`, `w`, ...
        to: &'static str,
        /// The dot product, which should be 0.
        dot: f64,
    },
    /// It points elsewhere.
    Angle {
        /// Between it and the right direction.
        degrees: f64,
    },
    /// The point, or the ray's point at this t, is not on the wall.
    OffWall {
        /// The point's z.
        z: f64,
        /// The wall's.
        wall: f64,
    },
    /// The point, or the ray's point at this t, is not on the sphere.
    OffSphere {
        /// The point's, from the centre.
        distance: f64,
        /// The sphere's.
        radius: f64,
    },
    /// The point, or the ray's point at this t, is not on the line.
    OffLine {
        /// `a x + b y + c`, which should be 0.
        value: f64,
    },
    /// The point is not on the ray's line.
    OffRay {
        /// The distance to the line.
        distance: f64,
    },
    /// The origin is not the eye.
    OffEye {
        /// The distance to the eye.
        distance: f64,
    },
    /// The ray passes the viewport's plane elsewhere.
    OffUv {
        /// The position that it passes.
        uv: DVec2,
        /// The position that it should pass.
        wanted: DVec2,
    },
    /// The ray never comes to the viewport's plane.
    NotForwards {
        /// `d . w`, which should be below 0.
        along_w: f64,
    },
    /// The number is another one, or none.
    Another,
}

/// A condition that an answer has to fulfil.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Condition {
    /// The ray is on it at this t.
    Meets(Ray, Surface),
    /// The point is on it.
    On(Surface),
    /// The point is on the ray's line.
    OnRay(Ray),
    /// The ray begins here.
    Eye(DVec3),
    /// The direction leads from the eye through this place in the viewport.
    Through {
        /// The camera's.
        basis: Basis,
        /// The viewport's distance from the eye.
        distance: f64,
        /// The position.
        uv: DVec2,
    },
}

/// A surface that a ray meets. In two dimensions, z is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    /// The plane at this z.
    Wall(f64),
    /// A sphere.
    Sphere(Sphere),
    /// The line `a x + b y + c = 0` of (a, b, c).
    Line(DVec3),
}

impl Condition {
    /// Finds what is wrong with an answer of one, two or three numbers; `None` if it fulfils this.
    pub(super) fn missed_by(&self, given: &[f64]) -> Option<Finding> {
        let point = |given: &[f64]| match *given {
            [x, y] => Some(DVec3::new(x, y, 0.0)),
            [x, y, z] => Some(DVec3::new(x, y, z)),
            _ => None,
        };
        match (self, given) {
            (Condition::Meets(ray, surface), [t]) => surface.missed_by(ray.at(*t)),
            (Condition::Meets(..), _) => None,
            (Condition::On(surface), _) => surface.missed_by(point(given)?),
            (Condition::OnRay(ray), _) => {
                let from = point(given)? - ray.origin;
                let distance = from.cross(ray.direction).length() / ray.direction.length();
                is_off(distance, from.length()).then_some(Finding::OffRay { distance })
            }
            (Condition::Eye(eye), _) => {
                let distance = point(given)?.distance(*eye);
                is_off(distance, eye.length()).then_some(Finding::OffEye { distance })
            }
            (Condition::Through { basis, distance, uv }, _) => {
                let d = basis.to_camera_from_world(point(given)?);
                if d.z >= 0.0 {
                    return Some(Finding::NotForwards { along_w: d.z });
                }
                let passed = d.truncate() * (distance / -d.z);
                let is_elsewhere = is_off(passed.distance(*uv), passed.length());
                is_elsewhere.then_some(Finding::OffUv { uv: passed, wanted: *uv })
            }
        }
    }
}

impl Surface {
    fn missed_by(self, point: DVec3) -> Option<Finding> {
        let (off, finding) = match self {
            Surface::Wall(wall) => (point.z - wall, Finding::OffWall { z: point.z, wall }),
            Surface::Sphere(Sphere { center, radius }) => {
                let distance = point.distance(center);
                (distance - radius, Finding::OffSphere { distance, radius })
            }
            Surface::Line(DVec3 { x: a, y: b, z: c }) => {
                let value = a * point.x + b * point.y + c;
                (value, Finding::OffLine { value })
            }
        };
        is_off(off, point.length()).then_some(finding)
    }
}

/// Returns whether a difference is more than noise beside numbers of this size.
fn is_off(difference: f64, size: f64) -> bool {
    difference.abs() > TOLERANCE * size.max(1.0)
}

/// The length of some numbers as a vector; 1 for zeros.
pub(super) fn size(numbers: &[f64]) -> f64 {
    let size = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size == 0.0 { 1.0 } else { size }
}

/// Returns whether these are the true numbers, but for rounding in what was calculated.
pub(super) fn is_near(given: &[f64], truth: &[f64]) -> bool {
    let size = size(truth);
    given.iter().zip(truth).all(|(x, y)| (x - y).abs() <= TOLERANCE * size)
}
