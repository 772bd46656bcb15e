//! The known ways to intersect rays with spheres, side by side: named, sourced, each in `f32` and
//! `f64`. They serve comparison and teaching; pictures are made by [`Method::Ladder`] unless somebody
//! asks for another one to see what it does wrong.
//!
//! Where each formula is written down: [`Textbook`], [`ByQ`] with [`Plain`] (half-b), [`Kahan`],
//! [`Perpendicular`] and [`Lagrange`], [`ClosestPoint`], [`Recentred`]. [`Method`] is the choice among
//! them at run time; the loops over pixels and rays are compiled for each of them.
//!
//! ```
//! use pinhole_core::methods::{Method, first_hit_by};
//! use pinhole_core::*;
//!
//! // The course's floor, seen from just above: the textbook's near root loses its digits.
//! let floor = Sphere { center: DVec3::new(0.0, -5001.0, 0.0), radius: 5000.0 };
//! let scene = Scene::new(vec![floor], vec![])?;
//! let ray = Ray { origin: DVec3::ZERO, direction: DVec3::new(0.25, -0.25, -1.0) };
//! let t = |method| first_hit_by(method, &scene, &ray).map(|hit| hit.t);
//! let (right, textbook) = (t(Method::Ladder).unwrap(), t("textbook-f32".parse()?).unwrap());
//! assert!((textbook - right).abs() > 1e-5 * right);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::fmt;
use std::str::FromStr;

use crate::double_double::DoubleDouble;
pub use crate::method_kernel::{
    FrameKernel, MethodHit, RayKernel, Traced, first_hit_by, frame_kernel, ray_kernel, trace_by,
};
pub use crate::method_real::{
    Fused, Real, RoundedPlane, RoundedRay, RoundedScene, RoundedSphere, Vector,
};
pub use crate::method_sphere::{
    ByQ, ClosestPoint, Discriminant, Intersect, Kahan, Lagrange, Perpendicular, Plain,
    PlaneByTextbook, Quadratic, Recentred, Textbook, is_hit,
};

/// A formula for a ray and a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Formula {
    /// [`Textbook`]
    Textbook,
    /// [`ByQ`] with [`Plain`]
    HalfB,
    /// [`ByQ`] with [`Kahan`]
    Kahan,
    /// [`ByQ`] with [`Perpendicular`]
    Perpendicular,
    /// [`ClosestPoint`]
    ClosestPoint,
    /// [`Recentred`]
    Recentred,
    /// [`ByQ`] with [`Lagrange`]
    Lagrange,
}

/// What every operation is rounded to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 24 binary digits.
    F32,
    /// 53 binary digits.
    F64,
}

/// A way to find the first hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// What this crate decides by: [`Scene::first_hit`](crate::Scene::first_hit) and
    /// [`trace`](crate::trace).
    Ladder,
    /// [`ByQ`] with [`Plain`] in double-double, rounded at the end: no filter, no exact step.
    DoubleDouble,
    /// A known formula, every operation in one precision, no error bound.
    Known(Formula, Precision),
}

/// A name that no method has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod {
    /// The name.
    pub name: String,
}

impl fmt::Display for UnknownMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = Method::ALL.iter().map(|method| method.name()).collect();
        write!(f, "no method is called {:?}: there are {}", self.name, names.join(", "))
    }
}

impl std::error::Error for UnknownMethod {}

impl Method {
    /// All methods: the ladder, double-double, then the known formulas, from the plainest on, `f32`
    /// first.
    pub const ALL: [Method; 16] = {
        use Formula::*;
        use Precision::*;
        [
            Method::Ladder,
            Method::DoubleDouble,
            Method::Known(Textbook, F32),
            Method::Known(Textbook, F64),
            Method::Known(HalfB, F32),
            Method::Known(HalfB, F64),
            Method::Known(Kahan, F32),
            Method::Known(Kahan, F64),
            Method::Known(Perpendicular, F32),
            Method::Known(Perpendicular, F64),
            Method::Known(ClosestPoint, F32),
            Method::Known(ClosestPoint, F64),
            Method::Known(Recentred, F32),
            Method::Known(Recentred, F64),
            Method::Known(Lagrange, F32),
            Method::Known(Lagrange, F64),
        ]
    };

    /// The name in commands, files and tables.
    pub fn name(self) -> &'static str {
        use Formula::*;
        use Precision::*;
        match self {
            Method::Ladder => "ladder",
            Method::DoubleDouble => "double-double",
            Method::Known(Textbook, F32) => "textbook-f32",
            Method::Known(Textbook, F64) => "textbook-f64",
            Method::Known(HalfB, F32) => "half-b-f32",
            Method::Known(HalfB, F64) => "half-b-f64",
            Method::Known(Kahan, F32) => "kahan-f32",
            Method::Known(Kahan, F64) => "kahan-f64",
            Method::Known(Perpendicular, F32) => "perpendicular-f32",
            Method::Known(Perpendicular, F64) => "perpendicular-f64",
            Method::Known(ClosestPoint, F32) => "closest-point-f32",
            Method::Known(ClosestPoint, F64) => "closest-point-f64",
            Method::Known(Recentred, F32) => "recentred-f32",
            Method::Known(Recentred, F64) => "recentred-f64",
            Method::Known(Lagrange, F32) => "lagrange-f32",
            Method::Known(Lagrange, F64) => "lagrange-f64",
        }
    }

    /// The method of this name.
    pub fn from_name(name: &str) -> Option<Method> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }

    /// The precision of the answer, in whose ulps its error is counted.
    pub fn precision(self) -> Precision {
        match self {
            Method::Known(_, precision) => precision,
            Method::Ladder | Method::DoubleDouble => Precision::F64,
        }
    }

    /// Book or paper, in one line.
    pub fn source(self) -> &'static str {
        match self {
            Method::Ladder => {
                "Shewchuk, Discrete & Computational Geometry 18 (1997), for the idea of adaptive steps"
            }
            Method::DoubleDouble => {
                "Dekker, Numerische Mathematik 18 (1971); Joldes, Muller, Popescu, ACM Transactions on \
                 Mathematical Software 44 (2017)"
            }
            Method::Known(formula, _) => formula.source(),
        }
    }

    /// What it does and where it fails, in one sentence.
    pub fn about(self) -> &'static str {
        match self {
            Method::Ladder => {
                "Each decision in f64 with an error bound, where that leaves doubt in double-double, \
                 and where that does too, exactly."
            }
            Method::DoubleDouble => {
                "The half-b formula with about 106 digits, rounded at the end: fails where squares \
                 leave the range of f64, and on exact ties and tangents of rounded rays."
            }
            Method::Known(formula, _) => formula.about(),
        }
    }
}

impl Formula {
    fn source(self) -> &'static str {
        match self {
            Formula::Textbook => {
                "Glassner (ed.), An Introduction to Ray Tracing (1989), section 2.1"
            }
            Formula::HalfB => "Press et al., Numerical Recipes, 3rd ed. (2007), section 5.6",
            Formula::Kahan => {
                "Jeannerod, Louvet, Muller, Mathematics of Computation 82 (2013), pages 2245-2264"
            }
            Formula::Perpendicular => {
                "Haines, Guenther, Akenine-Moeller, Ray Tracing Gems (2019), chapter 7; Pharr, Jakob, \
                 Humphreys, Physically Based Rendering, 4th ed. (2023), section 6.8.3"
            }
            Formula::ClosestPoint => {
                "Wald et al., Embree, ACM Transactions on Graphics 33(4) (2014), sphere_intersector.h"
            }
            Formula::Recentred => {
                "Wald et al., Embree, ACM Transactions on Graphics 33(4) (2014), \
                 curve_intersector_sweep.h"
            }
            Formula::Lagrange => {
                "Lagrange's identity (1773); Steele, The Cauchy-Schwarz Master Class (2004), chapter 3"
            }
        }
    }

    fn about(self) -> &'static str {
        match self {
            Formula::Textbook => {
                "(-b -+ sqrt(b^2 - 4ac)) / 2a as it stands: loses the outline of distant spheres, and \
                 the near root of a large sphere close to the eye."
            }
            Formula::HalfB => {
                "Half of b, and q = -(b + sign(b) sqrt D) for both roots: keeps the near root of a \
                 large sphere, still loses the outline of distant ones in b^2 - ac."
            }
            Formula::Kahan => {
                "b^2 - ac with fused multiply-adds, almost exact: but a, b and c are rounded before, \
                 which costs the outline as much as the plain difference does."
            }
            Formula::Perpendicular => {
                "D from the vector from the centre at right angles to the ray: fails for tiny far \
                 spheres, whose perpendicular vector has few digits."
            }
            Formula::ClosestPoint => {
                "From the ray's point closest to the centre half a chord back and forth: fails for \
                 tiny far spheres, and at the near root of a large sphere close to the eye."
            }
            Formula::Recentred => {
                "Moves the origin to the ray's point closest to the centre and solves from there: \
                 fails where the closest-point formula does."
            }
            Formula::Lagrange => {
                "D as r^2 a - |oc x d|^2, in which little cancels far away: fails on near tangents, \
                 and inside a sphere near its surface."
            }
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Method, UnknownMethod> {
        Method::from_name(name).ok_or_else(|| UnknownMethod { name: name.to_owned() })
    }
}

/// What is done with a method at compile time, chosen at run time.
pub(crate) trait Visitor {
    type Out;
    fn ladder(self) -> Self::Out;
    fn known<M: Intersect>(self) -> Self::Out;
}

impl Method {
    pub(crate) fn accept<V: Visitor>(self, visitor: V) -> V::Out {
        use Precision::{F32, F64};
        match self {
            Method::Ladder => visitor.ladder(),
            Method::DoubleDouble => visitor.known::<ByQ<DoubleDouble, Plain>>(),
            Method::Known(formula, F32) => formula.accept::<f32, V>(visitor),
            Method::Known(formula, F64) => formula.accept::<f64, V>(visitor),
        }
    }
}

impl Formula {
    fn accept<R: Fused, V: Visitor>(self, visitor: V) -> V::Out {
        match self {
            Formula::Textbook => visitor.known::<Textbook<R>>(),
            Formula::HalfB => visitor.known::<ByQ<R, Plain>>(),
            Formula::Kahan => visitor.known::<ByQ<R, Kahan>>(),
            Formula::Perpendicular => visitor.known::<ByQ<R, Perpendicular>>(),
            Formula::ClosestPoint => visitor.known::<ClosestPoint<R>>(),
            Formula::Recentred => visitor.known::<Recentred<R>>(),
            Formula::Lagrange => visitor.known::<ByQ<R, Lagrange>>(),
        }
    }
}
