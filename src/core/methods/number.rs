//! The kinds of numbers in which the [methods](crate::methods) compute, and vectors of such numbers.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;

use crate::camera::ray::Ray;
use crate::exact::double_double::DoubleDouble;
use crate::scene::Scene;
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

/// A floating-point number in which a method computes. Every operation rounds to this precision.
pub(crate) trait Real:
    Copy
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    const ZERO: Self;
    /// The `t` that stands for no hit, greater than every number.
    const INFINITY: Self;

    /// Returns the nearest number of this precision.
    fn from_f64(x: f64) -> Self;
    /// Returns the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns the square root, NaN for a negative number.
    fn sqrt(self) -> Self;
    /// Returns `|self|` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
}

/// A number with a fused multiply-add.
pub(crate) trait Fused: Real {
    /// Returns `self * factor + term`, rounded once.
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
        }

        impl Fused for $real {
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
        // The algorithm divides by the root; of 0, and of what has none, f64's is right. Choices of
        // numbers, not of ways, so that a loop over them can be vectorized.
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

/// A point or direction in a method's precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vector<R> {
    pub(crate) x: R,
    pub(crate) y: R,
    pub(crate) z: R,
}

impl<R: Real> Vector<R> {
    /// Returns the nearest vector of this precision.
    #[inline(always)]
    pub(crate) fn rounded(v: DVec3) -> Self {
        Vector { x: R::from_f64(v.x), y: R::from_f64(v.y), z: R::from_f64(v.z) }
    }

    /// Returns the nearest vector of `f64`.
    pub(crate) fn to_f64(self) -> DVec3 {
        DVec3::new(self.x.to_f64(), self.y.to_f64(), self.z.to_f64())
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Vector {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    #[inline(always)]
    pub(crate) fn times(self, factor: R) -> Self {
        Vector { x: factor * self.x, y: factor * self.y, z: factor * self.z }
    }

    #[inline(always)]
    pub(crate) fn divided_by(self, divisor: R) -> Self {
        Vector { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }
    }
}

impl<R: Real> Add for Vector<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Vector { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<R: Real> Sub for Vector<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Vector { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

/// A [`Ray`] rounded to a method's precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RoundedRay<R> {
    pub(crate) origin: Vector<R>,
    pub(crate) direction: Vector<R>,
}

impl<R: Real> RoundedRay<R> {
    #[inline(always)]
    pub(crate) fn new(ray: &Ray) -> Self {
        RoundedRay {
            origin: Vector::rounded(ray.origin),
            direction: Vector::rounded(ray.direction),
        }
    }
}

/// A [`Sphere`] rounded to a method's precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RoundedSphere<R> {
    pub(crate) center: Vector<R>,
    /// The radius; 0 if it is too small for the precision.
    pub(crate) radius: R,
}

/// A [`Plane`] rounded to a method's precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RoundedPlane<R> {
    pub(crate) point: Vector<R>,
    pub(crate) normal: Vector<R>,
}

/// A [`Scene`] rounded to a method's precision; objects are counted as in the scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RoundedScene<R> {
    pub(crate) spheres: Vec<RoundedSphere<R>>,
    pub(crate) planes: Vec<RoundedPlane<R>>,
}

impl<R: Real> RoundedSphere<R> {
    #[inline(always)]
    pub(crate) fn new(sphere: &Sphere) -> Self {
        let Sphere { center, radius } = *sphere;
        RoundedSphere { center: Vector::rounded(center), radius: R::from_f64(radius) }
    }

    /// Returns the outward unit normal where the ray meets the sphere at t, by the formula taught in
    /// courses: `(p + t d - center) / radius`.
    pub(crate) fn normal(&self, ray: &RoundedRay<R>, t: R) -> Vector<R> {
        let point = ray.origin + ray.direction.times(t);
        (point - self.center).divided_by(self.radius)
    }
}

impl<R: Real> RoundedPlane<R> {
    #[inline(always)]
    pub(crate) fn new(plane: &Plane) -> Self {
        RoundedPlane { point: Vector::rounded(plane.point), normal: Vector::rounded(plane.normal) }
    }

    /// Returns the unit normal, `n / |n|`.
    pub(crate) fn unit_normal(&self) -> Vector<R> {
        self.normal.divided_by(self.normal.dot(self.normal).sqrt())
    }
}

impl<R: Real> RoundedScene<R> {
    pub(crate) fn new(scene: &Scene) -> Self {
        RoundedScene {
            spheres: scene.spheres().iter().map(RoundedSphere::new).collect(),
            planes: scene.planes().iter().map(RoundedPlane::new).collect(),
        }
    }
}
