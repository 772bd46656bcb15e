//! Derives every number on the way from a camera to a hit, step by step: the camera's basis, the view
//! ray through a pixel or a point (u, v), and the intersection of that ray with a sphere or a plane.

use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI};

use pinhole_core::arithmetic::{
    Dyadic, Exact3, cross, dot, exact3, is_orthogonal, is_unit, length, minus, over_root_rounded,
    root_of_quotient,
};
use pinhole_core::{
    AlongRay, Basis, BasisError, Camera, DVec2, DVec3, ExactRay, LineRoots, Object, ObjectError,
    Orientation, Pixel, Plane, PlaneTerms, Ray, RayError, ResolvedCamera, Root, Selection, Sphere,
    SphereQuadratic,
};

/// The derivation of a camera's basis, whose steps depend on how the camera is given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "made once a frame and read in place")]
pub enum BasisDerivation {
    /// The basis is derived from up and from a view direction or a point to look at.
    FromUp(BasisFromUp),
    /// The camera is given by u, v, w themselves, which are only checked, not derived.
    ByHand(BasisByHand),
}

/// The derivation of a basis from view and up, with the value of each step, in the lecture's order:
///
/// ```text
/// view (or at - eye)   -view   w = -view / |view|   up x w   u = up x w / |up x w|   v = w x u
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.3.) If a step is
/// impossible, its value and those of all later steps are `None`, and [`BasisFromUp::basis`] contains
/// the reason.
///
/// Every vector is computed exactly and rounded once; lengths, and the area of a cross product's
/// parallelogram, are accurate to within an ulp. u, v and w equal those of [`Camera::basis`]. A value
/// above the largest `f64` is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BasisFromUp {
    /// The camera's position.
    pub eye: DVec3,
    /// The point at which the camera looks; `None` if the camera is given by a direction.
    pub at: Option<DVec3>,
    /// The view direction, which is given or is `at - eye`; `None` if a coordinate is not finite.
    pub view: Option<VectorAndLength>,
    /// `-view`, which is normalized to w; `None` if there is no view.
    pub backwards: Option<DVec3>,
    /// `-view / |view|`; `None` if view is zero.
    pub w: Option<DVec3>,
    /// The up vector; `None` if a coordinate is not finite.
    pub up: Option<VectorAndLength>,
    /// `up x w` before it is normalized; the zero vector if up is parallel to view.
    pub up_cross_w: Option<Cross>,
    /// `up x w / |up x w|`; `None` if `up x w` is zero.
    pub u: Option<DVec3>,
    /// The cross product `w x u`, which is v. Its [area](Cross::area) is 1, because the factors are
    /// perpendicular unit vectors.
    pub w_cross_u: Option<Cross>,
    /// The basis, or the reason why there is none.
    pub basis: Result<Basis, BasisError>,
}

/// A vector and its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorAndLength {
    /// The vector, in world units.
    pub vector: DVec3,
    /// Its Euclidean length.
    pub length: f64,
}

/// A cross product `first x second`, with its factors and the angle between them. It is perpendicular
/// to both factors, and its length is the area of the parallelogram that they span,
/// `|first| |second| sin(angle)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cross {
    /// The factor on the left.
    pub first: VectorAndLength,
    /// The factor on the right.
    pub second: VectorAndLength,
    /// The angle between the factors in radians, 0 to pi; `None` if one factor is zero.
    pub angle: Option<f64>,
    /// The sine of the angle, accurate even for small angles; `None` if one factor is zero.
    pub sine: Option<f64>,
    /// `first x second`
    pub product: DVec3,
    /// `|first x second|`, the parallelogram's area.
    pub area: f64,
}

/// The checks that given vectors u, v, w must pass to be a camera's basis. [`Basis::by_hand`] decides
/// by the same results.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BasisByHand {
    /// The camera's position.
    pub eye: DVec3,
    /// u, as set.
    pub u: DVec3,
    /// v, as set.
    pub v: DVec3,
    /// w, as set.
    pub w: DVec3,
    /// `|u|`, `|v|`, `|w|`: each must be 1 within
    /// [`ORTHONORMAL_TOLERANCE`](pinhole_core::ORTHONORMAL_TOLERANCE). As in the other checks, `None`
    /// means that a coordinate is not finite.
    pub lengths: [Option<BasisCheck>; 3],
    /// `u . v`, `v . w`, `w . u`: each must be 0 within the same tolerance.
    pub dots: [Option<BasisCheck>; 3],
    /// `(u x v) . w`, which is 1 or -1 for perpendicular unit vectors. It must be positive, which means
    /// that u, v, w are right-handed.
    pub handedness: Option<BasisCheck>,
    /// The basis, or the first error.
    pub basis: Result<Basis, BasisError>,
}

/// A check of vectors set by hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasisCheck {
    /// The number that is checked.
    pub value: f64,
    /// True if the check passes.
    pub passes: bool,
}

impl BasisDerivation {
    /// Derives the basis of `camera` from the values by which its orientation is given.
    pub fn new(camera: &Camera) -> BasisDerivation {
        let eye = camera.eye;
        match camera.orientation {
            Orientation::At { at, up } => {
                let is_finite = eye.is_finite() && at.is_finite();
                let view = is_finite.then(|| minus(&exact3(at), &exact3(eye)));
                BasisDerivation::FromUp(BasisFromUp::new(camera, Some(at), view, up))
            }
            Orientation::View { view, up } => {
                let view = view.is_finite().then(|| exact3(view));
                BasisDerivation::FromUp(BasisFromUp::new(camera, None, view, up))
            }
            Orientation::Basis(basis) => BasisDerivation::ByHand(BasisByHand::new(camera, basis)),
        }
    }
}

impl BasisFromUp {
    fn new(camera: &Camera, at: Option<DVec3>, big_view: Option<Exact3>, up: DVec3) -> BasisFromUp {
        let basis = camera.basis();
        let view = big_view.as_ref().map(VectorAndLength::new);
        let not_zero = big_view.as_ref().filter(|_| view.is_some_and(|view| view.length > 0.0));
        let w_of = |view: &Exact3| match &basis {
            Ok(basis) => basis.w,
            Err(_) => DVec3::ZERO - over_root_rounded(view, &dot(view, view)),
        };
        let w = not_zero.map(w_of);
        let big_up = up.is_finite().then(|| exact3(up));
        let factors = not_zero.zip(big_up.as_ref()).zip(w);
        let found = basis.ok();
        BasisFromUp {
            eye: camera.eye,
            at,
            view,
            backwards: view.map(|view| DVec3::ZERO - view.vector),
            w,
            up: big_up.as_ref().map(VectorAndLength::new),
            up_cross_w: factors.map(|((view, up), w)| Cross::of_up_and_w(view, up, w)),
            u: found.map(|basis| basis.u),
            w_cross_u: found.map(|Basis { u, v, w }| Cross {
                first: VectorAndLength { vector: w, length: 1.0 },
                second: VectorAndLength { vector: u, length: 1.0 },
                angle: Some(FRAC_PI_2),
                sine: Some(1.0),
                product: v,
                area: 1.0,
            }),
            basis,
        }
    }
}

impl VectorAndLength {
    fn new(v: &Exact3) -> VectorAndLength {
        VectorAndLength {
            vector: rounded(v),
            length: root_of_quotient(&dot(v, v), &Dyadic::from(1.0)),
        }
    }
}

impl Cross {
    /// Returns the cross product `up x w` with `w = -f / |f|`, where f is the view. It is computed as
    /// `R / |f|` with `R = f x up`, which is exact.
    fn of_up_and_w(view: &Exact3, up: &Exact3, w: DVec3) -> Cross {
        let right = cross(view, up);
        let (ff, gg, rr) = (dot(view, view), dot(up, up), dot(&right, &right));
        let area = root_of_quotient(&rr, &ff);
        let is_zero = gg.is_zero();
        let sine = || root_of_quotient(&rr, &(&ff * &gg)).min(1.0);
        // The angle is `atan2(|R|, -f . up)`, because w points opposite to the view.
        let angle = || match dot(view, up) {
            along if along.sign().is_gt() => PI - root_of_quotient(&rr, &along.square()).atan(),
            along => root_of_quotient(&rr, &along.square()).atan(),
        };
        Cross {
            first: VectorAndLength::new(up),
            second: VectorAndLength { vector: w, length: 1.0 },
            angle: (!is_zero).then(angle),
            sine: (!is_zero).then(sine),
            product: if rr.is_zero() { DVec3::ZERO } else { over_root_rounded(&right, &ff) },
            area,
        }
    }
}

impl BasisByHand {
    fn new(camera: &Camera, Basis { u, v, w }: Basis) -> BasisByHand {
        let finite = |a: DVec3| a.is_finite().then_some(a);
        let length_check = |value: DVec3| {
            let value = finite(value)?;
            let length = VectorAndLength::new(&exact3(value)).length;
            Some(BasisCheck { value: length, passes: is_unit(value) })
        };
        let dot_check = |(a, b): (DVec3, DVec3)| {
            let (a, b) = (finite(a)?, finite(b)?);
            let value = dot(&exact3(a), &exact3(b)).rounded_times(0);
            Some(BasisCheck { value, passes: is_orthogonal(a, b) })
        };
        let handedness = || {
            let (u, v, w) = (exact3(finite(u)?), exact3(finite(v)?), exact3(finite(w)?));
            let along = dot(&cross(&u, &v), &w);
            Some(BasisCheck { value: along.rounded_times(0), passes: along.sign().is_gt() })
        };
        BasisByHand {
            eye: camera.eye,
            u,
            v,
            w,
            lengths: [u, v, w].map(length_check),
            dots: [(u, v), (v, w), (w, u)].map(dot_check),
            handedness: handedness(),
            basis: camera.basis(),
        }
    }
}

/// Returns the vector with each exact coordinate rounded once.
fn rounded(v: &Exact3) -> DVec3 {
    DVec3::from_array(v.each_ref().map(|x| x.rounded_times(0)))
}

/// A view ray with every intermediate value:
///
/// ```text
/// u = width ((column + 0.5) / W - 0.5)     v = height (0.5 - (row + 0.5) / H)
/// p = eye     d = u U + v V - distance W
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., sections 4.3.1 and 4.3.2.) The
/// direction and its three components are computed from the exact basis and rounded once. The sum of
/// the components may therefore differ from the direction in the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RayDerivation {
    /// The pixel through which the ray passes; `None` for a ray that is given by (u, v).
    pub pixel: Option<Pixel>,
    /// The point (u, v) where the ray passes through the viewport, in world units; see
    /// [`ResolvedCamera::uv_of_pixel`].
    pub uv: DVec2,
    /// `u U`, in world units.
    pub along_u: DVec3,
    /// `v V`, in world units.
    pub along_v: DVec3,
    /// `-distance W`, in world units.
    pub along_w: DVec3,
    /// The ray p + t d, which equals [`ExactRay::rounded`](pinhole_core::ExactRay::rounded). p is the
    /// eye, and d is the sum of the three components.
    pub ray: Ray,
    /// `|d|`, the distance in the world that corresponds to one unit of t.
    pub length: f64,
}

impl RayDerivation {
    /// Derives the selected view ray.
    ///
    /// # Errors
    /// Returns an error if the selected u or v is not finite.
    pub fn new(camera: &ResolvedCamera, selection: Selection) -> Result<RayDerivation, RayError> {
        let ray = selection.exact_ray(camera)?.rounded();
        let [along_u, along_v, along_w] = camera.direction_terms(selection);
        let pixel = match selection {
            Selection::Pixel(pixel) => Some(pixel),
            Selection::Uv(_) => None,
        };
        let (uv, length) = (selection.uv(camera), length(ray.direction));
        Ok(RayDerivation { pixel, uv, along_u, along_v, along_w, ray, length })
    }
}

/// The intersection of a ray and an object, with every intermediate value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObjectDerivation {
    /// A sphere.
    Sphere(SphereDerivation),
    /// A plane.
    Plane(PlaneDerivation),
}

/// The intersection of a ray and a sphere: `|p + t d - c|^2 - r^2 = 0` is a quadratic equation in t,
///
/// ```text
/// a t^2 + 2 b t + c = 0     t = (-b -+ sqrt D) / a     normal = (point - center) / r
/// ```
///
/// with a, b, c and D as in [`SphereQuadratic`], where b is half the linear coefficient. (Marschner,
/// Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.4.1.)
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SphereDerivation {
    /// The sphere.
    pub sphere: Sphere,
    /// `p - center`, with each coordinate rounded once.
    pub from_center: DVec3,
    /// a, b, c and D.
    pub quadratic: SphereQuadratic,
    /// The kind of intersection, decided exactly.
    pub meeting: SphereMeeting,
    /// The points at which the ray's line meets the sphere, the nearer one first. A tangent point is
    /// stored only once, as the nearer one. Each `t` is the exact value, rounded.
    pub roots: [Option<Root>; 2],
    /// Index in `roots` of the hit, which has the smallest `t > 0`; `None` for a miss.
    pub first: Option<usize>,
}

pinhole_core::texts! {
    /// The ways in which a ray and a sphere can intersect.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum SphereMeeting[1];
    {
        /// Describes what the discriminant means.
        of_discriminant,
    }
    /// D < 0: the ray's line misses the sphere.
    Missed: "𝐷 < 0: the line passes by";
    /// D = 0 and t > 0: the ray touches the sphere at one point, which is the hit.
    Tangent: "𝐷 = 0: the line touches the sphere";
    /// D > 0 and both t > 0: the ray enters at one point and leaves at the other.
    Through: "𝐷 > 0: two roots, in and out";
    /// The ray starts inside the sphere: one t is negative, and the other one is the hit.
    FromInside: "𝐷 > 0, 𝑐 < 0: the eye is inside";
    /// The ray starts on the surface and passes through the sphere: one t is 0, and the other one is
    /// the hit.
    FromSurface: "𝐷 > 0, 𝑐 = 0: the eye is on the sphere";
    /// The ray's line meets the sphere, but the ray itself does not: no t is greater than 0.
    Behind: "𝐷 ≥ 0, but no root is ahead of the eye";
}

/// The intersection of a ray and a plane: `n . (p + t d - point) = 0` gives
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
    /// The kind of intersection, decided exactly.
    pub meeting: PlaneMeeting,
    /// The point at which the ray's line meets the plane, whatever the sign of `t`; `None` if it does
    /// not. The normal has length 1.
    pub root: Option<Root>,
}

/// The ways in which a ray and a plane can intersect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlaneMeeting {
    /// t > 0: a hit.
    Ahead,
    /// t < 0: the ray's line meets the plane, but the ray itself does not.
    Behind,
    /// t = 0: the ray starts on the plane and leaves it, which does not count as a hit.
    AtOrigin,
    /// `n . d = 0`: the line never meets the plane.
    Parallel,
    /// `n . d = 0`, and the line lies in the plane: every t solves the equation, but none counts as a hit.
    Within,
}

impl ObjectDerivation {
    /// Derives the intersection of a ray and an object. `index` is the object's index, which is stored
    /// in the roots.
    ///
    /// # Errors
    /// Returns an error if the object is invalid; see [`Object::check`].
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

    /// Returns the hit, which has the smallest `t > 0`; `None` for a miss.
    pub fn hit(&self) -> Option<&Root> {
        match self {
            ObjectDerivation::Sphere(sphere) => sphere.hit(),
            ObjectDerivation::Plane(plane) => plane.hit(),
        }
    }

    /// Returns the points at which the ray's line meets the object, by ascending `t`.
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

    /// Returns the hit, which has the smallest `t > 0`; `None` for a miss.
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

    /// Returns the hit, which has `t > 0`; `None` for a miss.
    pub fn hit(&self) -> Option<&Root> {
        self.root.as_ref().filter(|_| self.meeting == PlaneMeeting::Ahead)
    }
}

/// The unit in which the plot of f along a ray shows the values of f, an object's implicit function (0
/// on its surface). With such units, spheres and planes of all sizes fit on one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitUnit {
    /// The unit, a normal number greater than 0.
    pub value: f64,
    /// The quantity from which it is calculated.
    pub origin: UnitOrigin,
}

pinhole_core::texts! {
    /// The quantity from which an [`ImplicitUnit`] is calculated.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum UnitOrigin[2];
    {
        /// Returns the symbol.
        symbol,
        /// Returns the words that follow a quantity in this unit; empty for the number 1.
        words,
    }
    /// A sphere's `r^2`. At its centre, f is `-r^2`.
    SquaredRadius: "r²", ", in units of r²";
    /// A plane's `|f(0)|`: the value at the ray's origin.
    RayOrigin: "|f(p)|", ", in units of its size at the eye";
    /// A plane's `|f(1)|`, its value at t = 1, if the plane contains the ray's origin.
    OneStep: "|f(p + d)|", ", in units of its size at t = 1";
    /// The number 1, because the unit would otherwise be 0, subnormal or out of range.
    One: "1", "";
}

impl ImplicitUnit {
    /// Returns the unit for plotting an object's implicit function along a ray, which is `along`.
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
