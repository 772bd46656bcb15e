//! Intersections of a view ray and an object, computed in plain `f64` with generous error bounds, so
//! that each result is either certain or marked as unknown.

use pinhole_core::*;

use crate::common::oracle;

/// A ray's first hit with one object, as far as it is certain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Meeting {
    /// There is none.
    None,
    /// There certainly is a hit, whose `t` lies between these numbers.
    At(f64, f64),
    /// There may be one.
    Unknown,
}

/// Error bound of a sum of a few products, relative to their magnitudes: hundreds of rounding errors.
const SHARE: f64 = 1e-13;

/// One object as seen from the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Seen {
    /// A sphere.
    Sphere(SphereFromOrigin),
    /// A plane: its normal, `normal . (point - eye)`, and the error bound of that number.
    Plane(DVec3, f64, f64),
}

/// A sphere as seen from the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereFromOrigin {
    radius: f64,
    /// The vector from the eye to the centre.
    to_center: DVec3,
    distance: f64,
    /// `distance^2 - radius^2`, accurate enough for its sign to be right.
    power: f64,
}

impl Seen {
    pub(crate) fn new(object: &Object, eye: DVec3) -> Seen {
        match object {
            Object::Sphere(sphere) => Seen::Sphere(SphereFromOrigin::new(sphere, eye)),
            Object::Plane(plane) => {
                let to_point = plane.point - eye;
                let size = plane.normal.length() * (plane.point.length() + eye.length());
                Seen::Plane(plane.normal, plane.normal.dot(to_point), SHARE * size)
            }
        }
    }

    /// Finds the first hit (`t > 0`) of the ray from the eye in this direction with the object.
    pub(crate) fn meeting(&self, direction: DVec3) -> Meeting {
        match *self {
            Seen::Sphere(sphere) => sphere.meeting(direction),
            Seen::Plane(normal, offset, doubt) => {
                let slope = normal.dot(direction);
                let slope_doubt = SHARE * normal.length() * direction.length();
                if slope.abs() <= slope_doubt || offset.abs() <= doubt {
                    return Meeting::Unknown;
                }
                if (slope > 0.0) != (offset > 0.0) {
                    return Meeting::None;
                }
                let (offset, slope) = (offset.abs(), slope.abs());
                Meeting::At(
                    (offset - doubt) / (slope + slope_doubt) * (1.0 - SHARE),
                    (offset + doubt) / (slope - slope_doubt) * (1.0 + SHARE),
                )
            }
        }
    }
}

impl SphereFromOrigin {
    pub(crate) fn new(sphere: &Sphere, eye: DVec3) -> SphereFromOrigin {
        let to_center = sphere.center - eye;
        let (distance, radius) = (to_center.length(), sphere.radius);
        let mut power = (distance - radius) * (distance + radius);
        if (distance - radius).abs() < 0.01 * radius {
            let exact = oracle::Big3::from(sphere.center).minus(&eye.into());
            let square = oracle::big(radius) * oracle::big(radius);
            power = oracle::near(&(exact.dot(&exact) - square));
        }
        SphereFromOrigin { radius, to_center, distance, power }
    }

    /// Finds the first hit, with q the vector from the eye to the centre and d the direction, from the
    /// discriminant `D = (r |d|)^2 - |q x d|^2`, which is computed as a product to avoid cancellation,
    /// and the roots `t = power / (b + sqrt D)` with `b = q . d`.
    fn meeting(&self, direction: DVec3) -> Meeting {
        let SphereFromOrigin { radius, to_center, distance, power } = *self;
        let length = direction.length();
        let (reach, off) = (radius * length, to_center.cross(direction).length());
        let size = distance * length;
        let gap_doubt = SHARE * (size + reach);
        let gap = reach - off;
        let b = to_center.dot(direction);
        let b_doubt = SHARE * size;
        if gap < -gap_doubt || (power >= 0.0 && b < -b_doubt) {
            return Meeting::None;
        }
        if gap <= gap_doubt {
            return Meeting::Unknown;
        }
        let sum = reach + off;
        let root_low = ((gap - gap_doubt) * (sum - gap_doubt)).max(0.0).sqrt();
        let root_high = ((gap + gap_doubt) * (sum + gap_doubt)).sqrt();
        let (b_low, b_high) = (b - b_doubt, b + b_doubt);
        let (low, high) = if power > 0.0 {
            (power / (b_high + root_high), power / (b_low + root_low))
        } else if power == 0.0 {
            (2.0 * b_low / (length * length), 2.0 * b_high / (length * length))
        } else if b > 0.0 {
            let square = length * length;
            ((b_low + root_low) / square, (b_high + root_high) / square)
        } else {
            (-power / (root_high - b_low), -power / (root_low - b_high))
        };
        if low > 0.0 && high >= low && high.is_finite() {
            Meeting::At(low * (1.0 - SHARE), high * (1.0 + SHARE))
        } else {
            Meeting::Unknown
        }
    }

    /// Returns bounds of the slopes `x / z` and `y / z`, in the camera's coordinates, of all points of
    /// the sphere in front of the eye: from left to right, and from bottom to top. A bound is infinite
    /// if there is none.
    pub(crate) fn slopes(&self, basis: &Basis) -> [[f64; 2]; 2] {
        // A basis that is given by hand is orthonormal only to within 1e-9.
        let safe = 1.0001 * self.radius + 1e-8 * self.distance;
        let z = -self.to_center.dot(basis.w);
        let side = |axis: DVec3| {
            let x = self.to_center.dot(axis);
            let distance = x.hypot(z);
            if distance <= safe {
                return [f64::NEG_INFINITY, f64::INFINITY];
            }
            // Projected along the other axis, the sphere is a circle. Angles are measured from the view
            // direction.
            let (middle, half) = (x.atan2(z), (safe / distance).asin() + 1e-6);
            let (low, high) = (middle - half, middle + half);
            let quarter = std::f64::consts::FRAC_PI_2;
            let low = if low > -quarter { low.min(quarter).tan() } else { f64::NEG_INFINITY };
            [low, if high < quarter { high.max(-quarter).tan() } else { f64::INFINITY }]
        };
        [side(basis.u), side(basis.v)]
    }

    /// Returns a lower bound of the depth of the sphere's points in front of the eye.
    pub(crate) fn least_depth(&self, basis: &Basis) -> f64 {
        -self.to_center.dot(basis.w) - 1.0001 * self.radius - 1e-8 * self.distance
    }
}
