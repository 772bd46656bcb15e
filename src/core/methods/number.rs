//! The number types in which the [methods](crate::methods) compute, and rays and objects rounded to
//! these types.

use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::Ray;
use crate::exact::bounded::{Arithmetic, Vector, dot};
use crate::exact::double_double::DoubleDouble;
use crate::scene::Scene;
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

/// A floating-point number in which a method computes. Every operation rounds to its precision.
pub(crate) trait Real: Arithmetic + PartialOrd + Send + Sync + 'static {
    const ZERO: Self;
    /// The value of `t` that stands for no hit, greater than every number.
    const INFINITY: Self;

    /// Returns the nearest number of this precision.
    fn from_f64(x: f64) -> Self;
    /// Returns the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns the square root, NaN for a negative number.
    fn sqrt(self) -> Self;
    /// Returns `|self|` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Returns `self * factor + term`, rounded only once in `f32` and `f64`.
    fn mul_add(self, factor: Self, term: Self) -> Self;
}

macro_rules! implement_real {
    ($real:ident) => {
        impl Real for $real {
            const ZERO: Self = 0.0;
            const INFINITY: Self = $real::INFINITY;

            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $real
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $real::sqrt(self)
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $real::copysign(self, sign)
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                $real::mul_add(self, factor, term)
            }
        }
    };
}

implement_real!(f32);
implement_real!(f64);

impl Real for DoubleDouble {
    const ZERO: Self = DoubleDouble { hi: 0.0, lo: 0.0 };
    const INFINITY: Self = DoubleDouble { hi: f64::INFINITY, lo: 0.0 };

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        DoubleDouble::from(x)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.hi
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // The algorithm divides by the root, so for 0 and negative numbers the root in `f64` is used
        // instead. Both are computed and one is selected, without a branch, so that a loop can be
        // vectorized.
        let (root, plain, has_root) = (self.square_root(), self.hi.sqrt(), self.hi > 0.0);
        DoubleDouble {
            hi: if has_root { root.hi } else { plain },
            lo: if has_root { root.lo } else { 0.0 },
        }
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        let turn = 1_f64.copysign(self.hi) * 1_f64.copysign(sign.hi);
        DoubleDouble { hi: self.hi * turn, lo: self.lo * turn }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}

/// Compares by value; NaN is not comparable.
impl PartialOrd for DoubleDouble {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi)? {
            Ordering::Equal => self.lo.partial_cmp(&other.lo),
            order => Some(order),
        }
    }

    #[inline(always)]
    fn lt(&self, other: &Self) -> bool {
        (self.hi < other.hi) | ((self.hi == other.hi) & (self.lo < other.lo))
    }

    #[inline(always)]
    fn gt(&self, other: &Self) -> bool {
        other.lt(self)
    }
}

/// Returns the nearest vector of a method's precision.
#[inline(always)]
pub(crate) fn rounded<R: Real>(v: DVec3) -> Vector<R> {
    [R::from_f64(v.x), R::from_f64(v.y), R::from_f64(v.z)]
}

/// Returns `a + b`.
#[inline(always)]
pub(crate) fn plus<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns `a - b`.
#[inline(always)]
pub(crate) fn minus<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns `x v`.
#[inline(always)]
pub(crate) fn times<R: Real>(x: R, v: Vector<R>) -> Vector<R> {
    [x * v[0], x * v[1], x * v[2]]
}

/// A [`Ray`] rounded to a method's precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundedRay<R> {
    pub(crate) origin: Vector<R>,
    pub(crate) direction: Vector<R>,
}

impl<R: Real> RoundedRay<R> {
    pub(crate) fn new(ray: &Ray) -> Self {
        RoundedRay { origin: rounded(ray.origin), direction: rounded(ray.direction) }
    }
}

/// A [`Sphere`] rounded to a method's precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundedSphere<R> {
    pub(crate) center: Vector<R>,
    /// The radius; 0 if it is too small for the precision.
    pub(crate) radius: R,
}

/// A [`Plane`] rounded to a method's precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundedPlane<R> {
    pub(crate) point: Vector<R>,
    pub(crate) normal: Vector<R>,
}

/// A [`Scene`] rounded to a method's precision; objects are counted as in the scene.
#[derive(Clone, Debug)]
pub(crate) struct RoundedScene<R> {
    pub(crate) spheres: Vec<RoundedSphere<R>>,
    pub(crate) planes: Vec<RoundedPlane<R>>,
}

impl<R: Real> RoundedScene<R> {
    pub(crate) fn new(scene: &Scene) -> Self {
        let sphere = |&Sphere { center, radius }: &Sphere| RoundedSphere {
            center: rounded(center),
            radius: R::from_f64(radius),
        };
        let plane = |&Plane { point, normal }: &Plane| RoundedPlane {
            point: rounded(point),
            normal: rounded(normal),
        };
        RoundedScene {
            spheres: scene.spheres().iter().map(sphere).collect(),
            planes: scene.planes().iter().map(plane).collect(),
        }
    }

    /// Returns an object's outward unit normal at a ray's point `p + t d`, by the textbook formulas:
    /// `(p + t d - center) / radius` for a sphere, `n / |n|` for a plane with normal n.
    pub(crate) fn normal(&self, object: u32, ray: &RoundedRay<R>, t: R) -> DVec3 {
        let (vector, length) = match self.spheres.get(object as usize) {
            Some(sphere) => {
                let point = plus(ray.origin, times(t, ray.direction));
                (minus(point, sphere.center), sphere.radius)
            }
            None => {
                let normal = self.planes[object as usize - self.spheres.len()].normal;
                (normal, dot(normal, normal).sqrt())
            }
        };
        DVec3::from_array(vector.map(|x| (x / length).to_f64()))
    }
}
