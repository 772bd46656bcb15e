//! Tests of the unit in which an object's implicit function along a ray is plotted.

use pinhole_core::*;
use pinhole_lecture::{ImplicitUnit, UnitOrigin};

use crate::common::{plane, sphere};

#[test]
fn units_are_of_the_objects_own_size() {
    let ray = Ray::new([0.0; 3], [0.0, 0.0, -2.0]).unwrap();
    let unit = |object: Object| {
        let along = AlongRay::new(&object, ExactRay::from_ray(&ray).unwrap()).unwrap();
        let unit = ImplicitUnit::new(&object, &along);
        (unit.value, unit.origin)
    };
    let ball = |radius| Object::Sphere(sphere([0.0, 0.0, -5.0], radius));
    assert_eq!(unit(ball(3.0)), (9.0, UnitOrigin::SquaredRadius));
    assert_eq!(unit(ball(1e-200)), (1.0, UnitOrigin::One));
    let wall = |z, n| Object::Plane(plane([0.0, 0.0, z], n));
    assert_eq!(unit(wall(-6.0, [0.0, 0.0, 2.0])), (12.0, UnitOrigin::RayOrigin));
    assert_eq!(unit(wall(0.0, [0.0, 0.0, 1.0])), (2.0, UnitOrigin::OneStep));
    // The ray runs in the plane: f is 0 everywhere.
    assert_eq!(unit(wall(0.0, [0.0, 1.0, 0.0])), (1.0, UnitOrigin::One));
}
