//! The derivation of the camera's basis, line by line.

use std::f64::consts::{FRAC_PI_2, PI};

use pinhole_core::arithmetic::{
    Dyadic, Exact3, cross, dot, exact3, is_orthogonal, is_unit, minus, over_root_rounded,
    root_of_quotient,
};
use pinhole_core::{Basis, BasisError, Camera, DVec3, Orientation};

/// The derivation of a camera's basis, by the way in which the camera is given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "made once a frame and read in place")]
pub enum BasisDerivation {
    /// Derived from a view direction, or a point to look at, and up.
    FromUp(BasisFromUp),
    /// u, v, w set by hand: there is nothing to derive, only to check.
    ByHand(BasisByHand),
}

/// The derivation from view and up, in the lecture's order:
///
/// ```text
/// view (or at - eye)   -view   w = -view / |view|   up x w   u = up x w / |up x w|   v = w x u
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.3.) It goes as far
/// as the numbers allow: what comes after the last step that exists is `None`, and
/// [`BasisFromUp::basis`] tells why.
///
/// Every number is computed exactly and rounded once (lengths and the area: within an ulp). u, v
/// and w are those of [`Camera::basis`]. What is above the largest `f64` is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BasisFromUp {
    /// The camera's position.
    pub eye: DVec3,
    /// The point it looks at, where the camera is given by one.
    pub at: Option<DVec3>,
    /// The view direction: as given, or `at - eye`. `None` where a coordinate is not finite.
    pub view: Option<VectorAndLength>,
    /// `-view`, what w is made of.
    pub backwards: Option<DVec3>,
    /// `-view / |view|`; `None` where view is zero.
    pub w: Option<DVec3>,
    /// The up vector. `None` where a coordinate is not finite.
    pub up: Option<VectorAndLength>,
    /// `up x w`, before it is normalized. The zero vector where up is parallel to view.
    pub up_cross_w: Option<Cross>,
    /// `up x w / |up x w|`; `None` where that is zero.
    pub u: Option<DVec3>,
    /// `w x u`, which is v: two unit vectors at a right angle, area 1.
    pub w_cross_u: Option<Cross>,
    /// The whole, or why there is none.
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

/// A cross product `first x second` with what it is made of: it is at right angles to both, and as
/// long as their parallelogram is large, `|first| |second| sin(angle)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cross {
    /// The factor on the left.
    pub first: VectorAndLength,
    /// The factor on the right.
    pub second: VectorAndLength,
    /// The angle between the two in radians, 0 to pi; `None` where one is zero.
    pub angle: Option<f64>,
    /// The angle's sine, with all digits of a small one; `None` where one is zero.
    pub sine: Option<f64>,
    /// `first x second`
    pub product: DVec3,
    /// `|first x second|`, the parallelogram's area.
    pub area: f64,
}

/// The checks that u, v, w set by hand have to pass, each with the verdict of [`Basis::by_hand`].
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
    /// `|u|`, `|v|`, `|w|`: each has to be 1 within
    /// [`ORTHONORMAL_TOLERANCE`](pinhole_core::ORTHONORMAL_TOLERANCE). `None` where a coordinate is
    /// not finite, as in all checks.
    pub lengths: [Option<BasisCheck>; 3],
    /// `u . v`, `v . w`, `w . u`: each has to be 0 within the same tolerance.
    pub dots: [Option<BasisCheck>; 3],
    /// `(u x v) . w`: 1 or -1 of unit vectors at right angles, and greater than 0 of right-handed ones.
    pub handedness: Option<BasisCheck>,
    /// The whole derivation, or the first error.
    pub basis: Result<Basis, BasisError>,
}

/// A check of vectors set by hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasisCheck {
    /// The number that is looked at.
    pub value: f64,
    /// The verdict.
    pub passes: bool,
}

impl BasisDerivation {
    /// The derivation of a camera's basis, by the way in which the camera is given.
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

    /// The basis, or why there is none: what [`Camera::basis`] says.
    pub fn basis(&self) -> Result<Basis, BasisError> {
        match self {
            BasisDerivation::FromUp(from_up) => from_up.basis,
            BasisDerivation::ByHand(by_hand) => by_hand.basis,
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
    /// `up x w` with `w = -f / |f|`: with `R = f x up` it is `R / |f|`, and R is exact.
    fn of_up_and_w(view: &Exact3, up: &Exact3, w: DVec3) -> Cross {
        let right = cross(view, up);
        let (ff, gg, rr) = (dot(view, view), dot(up, up), dot(&right, &right));
        let area = root_of_quotient(&rr, &ff);
        let is_zero = gg.is_zero();
        let sine = || root_of_quotient(&rr, &(&ff * &gg)).min(1.0);
        // `atan2(|R|, -f . up)`: w points away from the view.
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

/// Each coordinate rounded once.
fn rounded(v: &Exact3) -> DVec3 {
    DVec3::from_array(v.each_ref().map(|x| x.rounded_times(0)))
}
