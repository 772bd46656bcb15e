//! The derivation of where a ray meets a sphere or a plane.

use std::cmp::Ordering;

use pinhole_core::{
    AlongRay, DVec3, ExactRay, LineRoots, Object, ObjectError, Plane, PlaneTerms, Root, Sphere,
    SphereQuadratic,
};

/// A ray and an object, with every value on the way to where they meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObjectDerivation {
    /// A sphere.
    Sphere(SphereDerivation),
    /// A plane.
    Plane(PlaneDerivation),
}

/// A ray and a sphere: `|p + t d - c|^2 - r^2 = 0` is a quadratic in t,
///
/// ```text
/// a t^2 + 2 b t + c = 0     t = (-b -+ sqrt D) / a     normal = (point - center) / r
/// ```
///
/// with a, b, c and D as in [`SphereQuadratic`] (b is half the linear coefficient). (Marschner,
/// Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.4.1.)
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SphereDerivation {
    /// The sphere.
    pub sphere: Sphere,
    /// `p - center`, each coordinate rounded once.
    pub from_center: DVec3,
    /// a, b, c and D.
    pub quadratic: SphereQuadratic,
    /// The ray's fate, decided exactly.
    pub meeting: SphereMeeting,
    /// The points at which the ray's line meets the sphere: the nearer one, then the farther one. A
    /// tangent stands once, as the nearer. Each `t` is the exact one, rounded.
    pub roots: [Option<Root>; 2],
    /// The hit: which of `roots` is the smallest `t > 0`.
    pub first: Option<usize>,
}

/// A ray's fate near a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SphereMeeting {
    /// D < 0: the line passes by.
    Missed,
    /// D = 0 and t > 0: the ray touches the sphere in one point, which is a hit.
    Tangent,
    /// D > 0 and both t > 0: in at one point, out at another.
    Through,
    /// The ray starts inside: one t is negative, the other one is the hit.
    FromInside,
    /// The ray starts on the sphere and goes through it: one t is 0, the other one is the hit.
    FromSurface,
    /// The line meets the sphere, the ray does not: no t is greater than 0.
    Behind,
}

/// A ray and a plane: `n . (p + t d - point) = 0` gives
///
/// ```text
/// t = n . (point - p) / n . d
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., sections 2.5.5 and 4.4.)
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlaneDerivation {
    /// The plane.
    pub plane: Plane,
    /// `n . d` and `n . (point - p)`.
    pub terms: PlaneTerms,
    /// The ray's fate, decided exactly.
    pub meeting: PlaneMeeting,
    /// The point at which the ray's line meets the plane, at whatever `t`; the normal is of length
    /// 1.
    pub root: Option<Root>,
}

/// A ray's fate near a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlaneMeeting {
    /// t > 0: a hit.
    Ahead,
    /// t < 0: the line meets the plane, the ray does not.
    Behind,
    /// t = 0: the ray starts in the plane and leaves it, which is no hit.
    AtOrigin,
    /// `n . d = 0`: the line never meets the plane.
    Parallel,
    /// `n . d = 0`, and the line lies in the plane: every t solves the equation, none is a hit.
    Within,
}

impl ObjectDerivation {
    /// The derivation for one ray and one object, which is given `index` in its roots.
    ///
    /// # Errors
    /// Returns an error if the object is none, see [`Object::check`].
    pub fn new(
        object: &Object,
        index: u32,
        ray: &ExactRay,
    ) -> Result<ObjectDerivation, ObjectError> {
        let meeting = object.line_roots(index, ray)?;
        Ok(match object {
            Object::Sphere(sphere) => {
                ObjectDerivation::Sphere(SphereDerivation::new(sphere, &meeting, ray))
            }
            Object::Plane(plane) => {
                ObjectDerivation::Plane(PlaneDerivation::new(plane, &meeting, ray))
            }
        })
    }

    /// The hit, the smallest `t > 0`, if there is one.
    pub fn hit(&self) -> Option<&Root> {
        match self {
            ObjectDerivation::Sphere(sphere) => sphere.hit(),
            ObjectDerivation::Plane(plane) => plane.hit(),
        }
    }

    /// The points at which the ray's line meets the object, by ascending `t`.
    pub fn roots(&self) -> impl Iterator<Item = &Root> {
        let [near, far] = match self {
            ObjectDerivation::Sphere(sphere) => sphere.roots.each_ref(),
            ObjectDerivation::Plane(plane) => [&plane.root, &None],
        };
        near.iter().chain(far)
    }
}

impl SphereDerivation {
    fn new(sphere: &Sphere, line: &LineRoots, ray: &ExactRay) -> SphereDerivation {
        let meeting = match (line.roots, line.first, line.side) {
            ([None, _], ..) => SphereMeeting::Missed,
            (_, None, _) => SphereMeeting::Behind,
            ([_, None], ..) => SphereMeeting::Tangent,
            (.., Ordering::Less) => SphereMeeting::FromInside,
            (.., Ordering::Equal) => SphereMeeting::FromSurface,
            (.., Ordering::Greater) => SphereMeeting::Through,
        };
        SphereDerivation {
            sphere: *sphere,
            from_center: ray.origin() - sphere.center,
            quadratic: sphere.quadratic_of(ray),
            meeting,
            roots: line.roots,
            first: line.first,
        }
    }

    /// The hit, the smallest `t > 0`, if there is one.
    pub fn hit(&self) -> Option<&Root> {
        self.roots[self.first?].as_ref()
    }
}

impl PlaneDerivation {
    fn new(plane: &Plane, line: &LineRoots, ray: &ExactRay) -> PlaneDerivation {
        let root = line.roots[0];
        let meeting = match (root, line.first, line.side) {
            (None, _, Ordering::Equal) => PlaneMeeting::Within,
            (None, ..) => PlaneMeeting::Parallel,
            (_, _, Ordering::Equal) => PlaneMeeting::AtOrigin,
            (_, Some(_), _) => PlaneMeeting::Ahead,
            (_, None, _) => PlaneMeeting::Behind,
        };
        PlaneDerivation { plane: *plane, terms: plane.terms_of(ray), meeting, root }
    }

    /// The hit, if `t > 0`.
    pub fn hit(&self) -> Option<&Root> {
        self.root.as_ref().filter(|_| self.meeting == PlaneMeeting::Ahead)
    }
}

/// The unit of an object's implicit function along a ray: with it, spheres and
/// planes of all sizes fit on one scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitUnit {
    /// A normal number greater than 0.
    pub value: f64,
    /// The number that it comes from.
    pub origin: UnitOrigin,
}

/// The number that an [`ImplicitUnit`] comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitOrigin {
    /// A sphere's `r^2`: f at the centre is minus that.
    SquaredRadius,
    /// A plane's `|f(0)|`, at the ray's origin.
    RayOrigin,
    /// `|f(1)|` of a plane through the ray's origin.
    OneStep,
    /// The number 1, where what should be the unit is 0 or out of range.
    One,
}

impl ImplicitUnit {
    /// The unit for an object and its function along a ray.
    pub fn new(object: &Object, along: &AlongRay) -> ImplicitUnit {
        let (value, origin) = match object {
            Object::Sphere(sphere) => (sphere.radius * sphere.radius, UnitOrigin::SquaredRadius),
            Object::Plane(_) => match along.value(0.0).abs() {
                0.0 => (along.value(1.0).abs(), UnitOrigin::OneStep),
                at_origin => (at_origin, UnitOrigin::RayOrigin),
            },
        };
        match value.is_normal() {
            true => ImplicitUnit { value, origin },
            false => ImplicitUnit { value: 1.0, origin: UnitOrigin::One },
        }
    }
}
