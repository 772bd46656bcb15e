//! Tests of the derivations for teaching: the lecture's own numbers, and accuracy against the
//! reference.

mod derived_basis;
mod derived_ray;
mod implicit_unit;
mod meetings;

use pinhole_core::*;
use proptest::prelude::*;

/// The lecture's exercise.
pub(crate) const EXERCISE: Camera = Camera {
    eye: DVec3::new(20.0, 4.0, 10.0),
    orientation: Orientation::At { at: DVec3::new(-1.0, 0.0, -5.0), up: DVec3::Y },
    ..Camera::CANONICAL
};

/// The lecture's camera between +x and -z, by view.
pub(crate) const AT_45_DEGREES: Camera = Camera {
    orientation: Orientation::View { view: DVec3::new(-1.0, 0.0, -1.0), up: DVec3::Y },
    ..Camera::CANONICAL
};

/// Returns vectors of any direction, whose length is about 10 to a power in the range.
fn vector(powers: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    let coordinate = || -1.0..1.0_f64;
    ((coordinate(), coordinate(), coordinate()), powers)
        .prop_map(|((x, y, z), power)| DVec3::new(x, y, z) * 10_f64.powf(power))
        .prop_filter("a zero vector points nowhere", |v| *v != DVec3::ZERO)
}
