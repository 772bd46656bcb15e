//! The known ways to intersect rays with spheres, for comparison and teaching. Each has a name and a
//! source, and can be computed in `f32` and `f64`. Everything outside this module uses [the
//! ladder](crate#the-ladder); the other methods serve to show their errors.
//!
//! [`Formula`] lists the formulas with their sources. [`Method`] selects, at run time, the ladder or one
//! of the formulas. The loops over pixels and rays are compiled for each method.
//!
//! ```
//! use pinhole_core::methods::{Method, ray_kernel};
//! use pinhole_core::*;
//!
//! // A large sphere as the floor, seen from just above: the textbook's near root loses its digits.
//! let floor = Sphere::new([0.0, -5001.0, 0.0], 5000.0)?;
//! let scene = Scene::new(vec![floor], vec![])?;
//! let ray = Ray::new([0.0; 3], [0.25, -0.25, -1.0])?;
//! let t = |name| {
//!     let mut kernel = ray_kernel(Method::from_name(name)?, &[(scene.clone(), ray)])?;
//!     kernel.run();
//!     kernel.hit(0).map(|hit| hit.t)
//! };
//! let (right, textbook) = (t("ladder").unwrap(), t("textbook-f32").unwrap());
//! assert!((textbook - right).abs() > 1e-5 * right);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::fmt;

use serde::{Deserialize, Serialize};

pub use dispatch::{MethodHit, MethodKernel, Traced, frame_kernel, ray_kernel, trace_by};

mod dispatch;
mod formulas;
mod loops;
mod number;

crate::texts! {
    /// A formula for a ray and a sphere.
    ///
    /// For a ray `p + t d` and a sphere of radius r, with `oc = p - center` and `f(t) = |oc + t d|^2 - r^2`,
    /// all formulas solve `f(t) = 0`:
    ///
    /// ```text
    /// a t^2 + 2 b t + c = 0     a = d.d     b = d.oc     c = |oc|^2 - r^2     D = b^2 - a c
    /// ```
    ///
    /// The formulas agree in real arithmetic. They differ in how much rounding changes D; [`Method::about`]
    /// says where each formula fails. Each of them is combined with the textbook formula
    /// `t = n.(q - p) / n.d` for a plane with normal n through a point q (Glassner, section 2.2).
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Formula[4];
    {
        /// Returns the name of the formula in `f32`.
        single,
        /// Returns the name of the formula in `f64`.
        double,
        /// Returns the source in a line.
        source,
        /// Returns the formula in words, and where it fails.
        about,
    }
    /// The textbook formula, `t = (-b -+ sqrt(b^2 - 4 a c)) / (2 a)` with `b = 2 d.oc`, for both roots.
    ///
    /// Source: Glassner (ed.), *An Introduction to Ray Tracing*, Academic Press 1989, chapter 2,
    /// section 2.1; Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.4.1.
    Textbook: "textbook-f32", "textbook-f64",
        "Glassner (ed.), An Introduction to Ray Tracing (1989), section 2.1",
        "(-b -+ sqrt(b^2 - 4ac)) / 2a as it stands: loses the outline of distant spheres, and \
         the near root of a large sphere close to the eye.";
    /// Half-b: the quadratic with half the linear coefficient, and the roots `q / a` and `c / q` with
    /// `q = -(b + sign(b) sqrt D)`. Nothing cancels except in `D = b^2 - a c`.
    ///
    /// Source: Press, Teukolsky, Vetterling, Flannery, *Numerical Recipes*, 3rd ed., section 5.6,
    /// equations 5.6.4 and 5.6.5.
    HalfB: "half-b-f32", "half-b-f64",
        "Press et al., Numerical Recipes, 3rd ed. (2007), section 5.6",
        "Half of b, and q = -(b + sign(b) sqrt D) for both roots: keeps the near root of a \
         large sphere, still loses the outline of distant ones in b^2 - ac.";
    /// Half-b with Kahan's algorithm for `b^2 - a c`, which uses fused multiply-adds: `w = a c`,
    /// `D = (b b - w) + (w - a c)`, within 1.5 ulp of the exact value for the given a, b, c.
    ///
    /// Source: Jeannerod, Louvet, Muller, *Further analysis of Kahan's algorithm for the accurate
    /// computation of 2 x 2 determinants*, Mathematics of Computation 82 (2013), pages 2245-2264.
    Kahan: "kahan-f32", "kahan-f64",
        "Jeannerod, Louvet, Muller, Mathematics of Computation 82 (2013), pages 2245-2264",
        "b^2 - ac with fused multiply-adds, almost exact: but a, b and c are rounded before, \
         which costs the outline as much as the plain difference does.";
    /// Half-b with `D = a (r + l)(r - l)`, where l is the length of `oc - (b / a) d`, the vector from
    /// the centre to the ray at right angles to it.
    ///
    /// Source: Haines, Guenther, Akenine-Moeller, *Precision improvements for ray/sphere
    /// intersection*, Ray Tracing Gems (2019), chapter 7, pages 87-94; with r^2 - l^2 factored as in
    /// Pharr, Jakob, Humphreys, *Physically Based Rendering*, 4th ed., section 6.8.3.
    Perpendicular: "perpendicular-f32", "perpendicular-f64",
        "Haines, Guenther, Akenine-Moeller, Ray Tracing Gems (2019), chapter 7; Pharr, Jakob, \
         Humphreys, Physically Based Rendering, 4th ed. (2023), section 6.8.3",
        "D from the vector from the centre at right angles to the ray: fails for tiny far \
         spheres, whose perpendicular vector has few digits.";
    /// The ray's point closest to the centre, and half the chord: `t = -b / a -+ sqrt((r^2 - l^2) / a)`
    /// where l is the distance of that point from the centre.
    ///
    /// Source: Embree (Wald, Woop, Benthin, Johnson, Ernst, *Embree: a kernel framework for efficient
    /// CPU ray tracing*, ACM Transactions on Graphics 33(4), 2014),
    /// `kernels/geometry/sphere_intersector.h`.
    ClosestPoint: "closest-point-f32", "closest-point-f64",
        "Wald et al., Embree, ACM Transactions on Graphics 33(4) (2014), sphere_intersector.h",
        "From the ray's point closest to the centre half a chord back and forth: fails for \
         tiny far spheres, and at the near root of a large sphere close to the eye.";
    /// Moves the origin along the ray to the point nearest to the centre, `t0 = -b / a`, and solves the
    /// half-b equation with its coefficients b' and c', where b' is almost 0:
    /// `t = t0 + (-b' -+ sqrt(b'^2 - a c')) / a`.
    ///
    /// Source: Embree, which uses this for curves ("move ray closer to make intersection stable",
    /// `kernels/geometry/curve_intersector_sweep.h`).
    Recentred: "recentred-f32", "recentred-f64",
        "Wald et al., Embree, ACM Transactions on Graphics 33(4) (2014), \
         curve_intersector_sweep.h",
        "Moves the origin to the ray's point closest to the centre and solves from there: \
         fails where the closest-point formula does.";
    /// Half-b with `D = r^2 a - |oc x d|^2`, because `a |oc|^2 - b^2 = |oc x d|^2`.
    ///
    /// Source: Lagrange's identity, *Solutions analytiques de quelques problemes sur les pyramides
    /// triangulaires*, 1773 (Steele, *The Cauchy-Schwarz Master Class*, 2004, chapter 3).
    Lagrange: "lagrange-f32", "lagrange-f64",
        "Lagrange's identity (1773); Steele, The Cauchy-Schwarz Master Class (2004), chapter 3",
        "D as r^2 a - |oc x d|^2, in which little cancels far away: fails on near tangents, \
         and inside a sphere near its surface.";
}

/// The precision to which a method rounds every operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 24 binary digits.
    F32,
    /// 53 binary digits.
    F64,
}

/// A way to find a ray's first hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Method {
    /// [The ladder](crate#the-ladder) of `f64`, double-double and exact integers, by which this crate
    /// decides, as in [`Scene::first_hit`](crate::Scene::first_hit) and [`trace`](crate::trace).
    Ladder,
    /// The ladder with `t` in `f32`, as for pictures: [`trace_as::<f32>`](crate::trace_as). This method
    /// traces whole frames, not single rays.
    LadderF32,
    /// [`Formula::HalfB`] in double-double, rounded at the end, without error bounds and without an
    /// exact step.
    DoubleDouble,
    /// A known formula, with every operation in one precision and without error bounds.
    Known(Formula, Precision),
}

impl Method {
    /// Returns all methods for single rays: the ladder, double-double, then the known formulas,
    /// beginning with the simplest, each in `f32` before `f64`.
    pub fn all() -> impl Iterator<Item = Method> {
        let of = |formula| [Precision::F32, Precision::F64].map(|p| Method::Known(formula, p));
        [Method::Ladder, Method::DoubleDouble]
            .into_iter()
            .chain(Formula::ALL.into_iter().flat_map(of))
    }

    /// Returns all methods for whole frames: [`Method::LadderF32`], then [`Method::all`].
    pub fn of_frames() -> impl Iterator<Item = Method> {
        std::iter::once(Method::LadderF32).chain(Method::all())
    }

    /// Returns the method's name in commands, files and tables.
    pub fn name(self) -> &'static str {
        self.facts()[0]
    }

    /// Returns the method of this name, or `None` if there is none.
    pub fn from_name(name: &str) -> Option<Method> {
        Method::of_frames().find(|method| method.name() == name)
    }

    /// Returns the precision of the method's `t`. Its error is measured in ulps of this precision.
    pub fn precision(self) -> Precision {
        match self {
            Method::Known(_, precision) => precision,
            Method::LadderF32 => Precision::F32,
            Method::Ladder | Method::DoubleDouble => Precision::F64,
        }
    }

    /// Returns the book or paper that the method comes from, in one line.
    pub fn source(self) -> &'static str {
        self.facts()[1]
    }

    /// Returns a sentence that describes the method and where it fails.
    pub fn about(self) -> &'static str {
        self.facts()[2]
    }

    /// Returns the name, the source, and a description of the method and where it fails.
    fn facts(self) -> [&'static str; 3] {
        match self {
            Method::Ladder => [
                "ladder",
                "Shewchuk, Discrete & Computational Geometry 18 (1997), for the idea of adaptive steps",
                "Each decision in f64 with an error bound, where that leaves doubt in double-double, \
                 and where that does too, exactly; t from more digits than f64 has, rounded once.",
            ],
            Method::LadderF32 => [
                "ladder-f32",
                "Shewchuk, Discrete & Computational Geometry 18 (1997), for the idea of adaptive steps",
                "How pictures are drawn: each decision in f32 with an error bound, where that leaves \
                 doubt by the ladder; t within an ulp of f32.",
            ],
            Method::DoubleDouble => [
                "double-double",
                "Dekker, Numerische Mathematik 18 (1971); Joldes, Muller, Popescu, ACM Transactions on \
                 Mathematical Software 44 (2017)",
                "The half-b formula with about 106 digits, rounded at the end: fails where squares \
                 leave the range of f64, and on exact ties and tangents of rounded rays.",
            ],
            Method::Known(formula, precision) => {
                let [single, double, source, about] = formula.texts();
                [if precision == Precision::F32 { single } else { double }, source, about]
            }
        }
    }
}

impl From<Method> for &'static str {
    fn from(method: Method) -> &'static str {
        method.name()
    }
}

impl TryFrom<String> for Method {
    type Error = String;

    fn try_from(name: String) -> Result<Method, String> {
        Method::from_name(&name).ok_or_else(|| format!("no method is named {name}"))
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
