//! Cameras and the rays of their pixels, computed from eye, at and up without rounding.
//!
//! With the view `Z` (which is `at - eye`), `U = Z x up`, `A = |U|^2` and `B = |Z|^2`, all exact, the
//! basis is
//!
//! ```text
//! u = U / sqrt(A)      v = (U x Z) / sqrt(A B)      w = -Z / sqrt(B)
//! ```
//!
//! because `up x w = (Z x up) / |Z|`, and `v = w x u = -(Z x U) / (|Z| |U|)`. The ray through the point
//! (x, y) of the viewport has the direction `x*u + y*v - distance*w`, which, multiplied by `sqrt(A B)`,
//! is
//!
//! ```text
//! x sqrt(B) U  +  y (U x Z)  +  distance sqrt(A) Z
//! ```
//!
//! a vector whose coordinates have the form `p + q sqrt(A) + r sqrt(B)` with exact p, q, r. Multiplying
//! by `sqrt(A B)` does not change what the ray hits; it divides `t` by this factor, which is undone in
//! the result. (Basis: Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.3.)

use crate::dyadic::{Dyadic, Vector, cross, dot, is_zero, minus, vector};
use crate::object::Object;
use crate::real::Real;
use crate::surd::{Field, Surd};
use crate::trace::{Direction, Hit, SceneFromEye};

/// The orientation of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// The camera looks at a point: the view is `at - eye`, computed without rounding.
    At {
        /// The point at which the camera looks.
        at: [f64; 3],
        /// The up vector, which determines the roll of the camera.
        up: [f64; 3],
    },
    /// Looks along a vector of any length.
    View {
        /// The vector along which the camera looks.
        view: [f64; 3],
        /// The up vector, which determines the roll of the camera.
        up: [f64; 3],
    },
    /// The basis consists of these vectors, which are neither normalized nor made orthogonal.
    Basis {
        /// The vector to the right in the image.
        u: [f64; 3],
        /// The vector up in the image.
        v: [f64; 3],
        /// The vector opposite to the view direction.
        w: [f64; 3],
    },
}

/// The reason why a camera has no basis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// `at - eye` is 0.
    EyeIsAt,
    /// The view is 0.
    ViewIsZero,
    /// The up vector is 0, but the view is not.
    UpIsZero,
    /// `up x view` is 0, but neither `up` nor the view is 0.
    UpParallelToView,
}

/// A pinhole camera: its position and orientation, its viewport in world units, and its image's size in
/// pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The point at which all rays start.
    pub eye: [f64; 3],
    /// The orientation of the camera.
    pub orientation: Orientation,
    /// Extent of the viewport along u.
    pub width: f64,
    /// Extent of the viewport along v.
    pub height: f64,
    /// Distance from the eye to the viewport, along -w.
    pub distance: f64,
    /// Number of pixels in a row.
    pub columns: u32,
    /// Number of pixels in a column.
    pub rows: u32,
}

/// A camera and a list of objects, with the exact values that all rays from the eye share. Several
/// threads can use it at the same time.
#[derive(Debug)]
pub struct View {
    basis: ScaledBasis,
    camera: Camera,
    scene: SceneFromEye,
}

/// A camera's basis, whose three vectors are all multiplied by the factor `multiple`, so that they
/// contain no quotients.
#[derive(Debug)]
struct ScaledBasis {
    field: Field,
    u: [Surd; 3],
    v: [Surd; 3],
    w: [Surd; 3],
    multiple: Surd,
}

/// The indices of `sqrt(A)`, `sqrt(B)` and `sqrt(A B)` in a [`Surd`].
const ROOT_A: usize = 1;
const ROOT_B: usize = 2;
const ROOT_AB: usize = 3;

impl ScaledBasis {
    fn new(eye: [f64; 3], orientation: &Orientation) -> Result<ScaledBasis, Status> {
        let one = Dyadic::power_of_two(0);
        let (view, up, without_view) = match orientation {
            Orientation::At { at, up } => {
                (minus(&vector(*at), &vector(eye)), vector(*up), Status::EyeIsAt)
            }
            Orientation::View { view, up } => (vector(*view), vector(*up), Status::ViewIsZero),
            Orientation::Basis { u, v, w } => {
                let [u, v, w] = [u, v, w].map(|x| vector(*x).map(Surd::rational));
                let (field, multiple) = (Field::rational(), Surd::rational(one));
                return Ok(ScaledBasis { field, u, v, w, multiple });
            }
        };
        let right = cross(&view, &up);
        if is_zero(&view) {
            return Err(without_view);
        } else if is_zero(&up) {
            return Err(Status::UpIsZero);
        } else if is_zero(&right) {
            return Err(Status::UpParallelToView);
        }
        let above = cross(&right, &view);
        let times_root = |x: &Vector, index| x.clone().map(|x| Surd::with_root(x, index));
        Ok(ScaledBasis {
            field: Field::new(dot(&right, &right), dot(&view, &view)),
            u: times_root(&right, ROOT_B),
            v: above.map(Surd::rational),
            w: times_root(&view.map(|x| -&x), ROOT_A),
            multiple: Surd::with_root(one, ROOT_AB),
        })
    }

    /// Returns the direction `(x*u + y*v - z*w) / share`.
    fn direction(&self, [x, y, z]: &Vector, share: &Dyadic) -> Direction<'_> {
        let multiple = std::array::from_fn(|i| {
            self.u[i].scaled(x).plus(&self.v[i].scaled(y)).minus(&self.w[i].scaled(z))
        });
        Direction { field: &self.field, multiple, per_multiple: self.multiple.scaled(share) }
    }
}

/// Returns the basis u, v, w of a camera at `eye` with at least 440 significant bits:
/// `w = -view / |view|`, `u = up x w / |up x w|`, `v = w x u`.
///
/// # Errors
/// Returns an error if and only if there is no basis, because the view, `up` or `up x view` is 0.
///
/// # Panics
/// Panics if a number is NaN or infinite.
pub fn basis(eye: [f64; 3], orientation: &Orientation) -> Result<[[Real; 3]; 3], Status> {
    let ScaledBasis { field, u, v, w, multiple } = ScaledBasis::new(eye, orientation)?;
    Ok([u, v, w].map(|vector| {
        let per_multiple = multiple.clone();
        Direction { field: &field, multiple: vector, per_multiple }.values()
    }))
}

impl Camera {
    /// Computes the values that all rays of the camera share, such as its basis.
    ///
    /// # Errors
    /// Returns an error if there is no basis.
    ///
    /// # Panics
    /// Panics if a number is NaN or infinite.
    pub fn prepare(&self, objects: &[Object]) -> Result<View, Status> {
        let basis = ScaledBasis::new(self.eye, &self.orientation)?;
        Ok(View { basis, camera: *self, scene: SceneFromEye::new(objects, vector(self.eye)) })
    }

    /// Returns the vector `(x, y, distance)`, multiplied by `2 rows columns` so that it is exact, and
    /// this factor. (x, y) is the position of the pixel's centre in the viewport:
    ///
    /// ```text
    /// x = width * ((column + 0.5) / columns - 0.5) = width * (2 column + 1 - columns) / (2 columns)
    /// y = height * (0.5 - (row + 0.5) / rows) = height * (rows - 2 row - 1) / (2 rows)
    /// ```
    fn pixel(&self, row: u32, column: u32) -> (Vector, Dyadic) {
        let [rows, columns, row, column] = [self.rows, self.columns, row, column].map(i64::from);
        let integer = |n: i64| Dyadic::new(n.into(), 0);
        let x = &integer((2 * column + 1 - columns) * rows) * &Dyadic::from_f64(self.width);
        let y = &integer((rows - 2 * row - 1) * columns) * &Dyadic::from_f64(self.height);
        let share = integer(2 * rows * columns);
        ([x, y, &share * &Dyadic::from_f64(self.distance)], share)
    }
}

impl View {
    fn of_pixel(&self, row: u32, column: u32) -> Direction<'_> {
        let (position, share) = self.camera.pixel(row, column);
        self.basis.direction(&position, &share)
    }

    /// Finds the first hit of the ray through the pixel's centre, as [`crate::first_hit`] does. Returns
    /// `None` if the ray hits nothing. Rows and columns are counted from 0, with row 0 at the top. The
    /// direction is `x*u + y*v - distance*w`, which is not normalized, so that `t = 1` is on the
    /// viewport.
    pub fn first_hit_of_pixel(&self, row: u32, column: u32) -> Option<Hit> {
        self.scene.first_hit(&self.of_pixel(row, column))
    }

    /// Finds the first hit of the ray through any point of the viewport, as
    /// [`View::first_hit_of_pixel`] does. The point is given in world units from the viewport's centre.
    ///
    /// # Panics
    /// Panics if a number is NaN or infinite.
    pub fn first_hit_of_uv(&self, u: f64, v: f64) -> Option<Hit> {
        let position = vector([u, v, self.camera.distance]);
        self.scene.first_hit(&self.basis.direction(&position, &Dyadic::power_of_two(0)))
    }

    /// Returns all `t` at which the line of the pixel's ray meets the object with index `object`, as
    /// [`crate::roots`] does.
    pub fn roots_of_pixel(&self, object: usize, row: u32, column: u32) -> Vec<Real> {
        self.scene.roots(object, &self.of_pixel(row, column))
    }

    /// Returns the direction of the pixel's ray.
    pub fn direction_of_pixel(&self, row: u32, column: u32) -> [Real; 3] {
        self.of_pixel(row, column).values()
    }
}
