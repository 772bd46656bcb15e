//! A checked camera with its basis, which converts between pixels, positions (u, v), view rays and world
//! points.

use glam::{DVec2, DVec3};

use crate::camera::basis::Basis;
use crate::camera::fine_basis::{Aim, BigBasis, FineBasis};
use crate::camera::ray::Ray;
use crate::camera::selection::Selection;
use crate::camera::viewport::{ImageSize, Pixel, Viewport};
use crate::exact::big_ray::BigRay;
use crate::exact::bounded::{Vector, scaled};
use crate::exact::double_double::{DoubleDouble, difference_with_rest};
use crate::exact::dyadic::{Dyadic, exact3, times};
use crate::exact::scale::{exponent, ldexp};
use crate::exact::surd::{Radicands, Surd};

/// A [`Camera`](crate::Camera) that passed every check: eye, basis, viewport and image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolvedCamera {
    eye: DVec3,
    /// The view direction and up from which the basis was computed; `None` if the basis was given by
    /// hand.
    aim: Option<Aim>,
    basis: Basis,
    fine_basis: FineBasis,
    viewport: Viewport,
    image: ImageSize,
}

/// The pixel in which a position (u, v) lies, and the edges between pixels on which it lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelOfUv {
    /// The pixel. For a position on an edge, it is the pixel to the right of the edge or below it, if
    /// that lies in the image.
    pub pixel: Pixel,
    /// `k` if u is exactly on the edge between columns `k - 1` and `k` (0 and W for the borders of the
    /// image); otherwise `None`.
    pub column_edge: Option<u32>,
    /// `k` if v is exactly on the edge between rows `k - 1` and `k` (0 and H for the borders of the
    /// image); otherwise `None`.
    pub row_edge: Option<u32>,
}

/// The projection of a world point to the viewport.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// The position at which the line through the eye and the point meets the viewport's plane. It is
    /// not finite if the line is parallel to the plane (depth 0).
    pub uv: DVec2,
    /// Distance of the point in front of the eye, along -w, in world units. It is negative for a
    /// point behind the eye, and infinite if it overflows.
    pub depth: f64,
}

/// The view rays of a camera. The ray through (x, y), in pixels from the image's top left corner, has the
/// direction `x * across + y * down + corner`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRays {
    /// The origin of all rays.
    pub eye: DVec3,
    /// The change of the direction from one column to the next.
    pub across: DVec3,
    /// The change of the direction from one row to the next.
    pub down: DVec3,
    /// The direction of the ray through the image's top left corner.
    pub corner: DVec3,
}

impl Projection {
    /// Returns whether the point lies in front of the eye, so that a view ray can reach it.
    pub fn is_in_front(&self) -> bool {
        self.depth > 0.0
    }
}

impl PixelOfUv {
    /// Returns the pixel that contains the position, or `None` if the position is on an edge between
    /// pixels.
    pub fn only_pixel(&self) -> Option<Pixel> {
        (self.column_edge.is_none() && self.row_edge.is_none()).then_some(self.pixel)
    }

    /// Returns the pixels that the position touches, row by row: one if it lies inside a pixel, two on
    /// an edge, four at a corner, and fewer at the image's border.
    pub fn touching(&self, image: ImageSize) -> Vec<Pixel> {
        let around = |edge: Option<u32>, own: u32, count: u32| match edge {
            Some(k) => k.saturating_sub(1)..(k + 1).min(count),
            None => own..own + 1,
        };
        let columns = around(self.column_edge, self.pixel.column, image.width());
        around(self.row_edge, self.pixel.row, image.height())
            .flat_map(|row| columns.clone().map(move |column| Pixel { row, column }))
            .collect()
    }
}

impl ResolvedCamera {
    /// Creates the camera from parts that [`Camera::resolve`](crate::Camera::resolve) has checked.
    pub(crate) fn new(
        eye: DVec3,
        aim: Option<Aim>,
        fine_basis: FineBasis,
        viewport: Viewport,
        image: ImageSize,
    ) -> Self {
        ResolvedCamera { eye, aim, basis: fine_basis.rounded(), fine_basis, viewport, image }
    }

    /// Returns the origin of every view ray.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// Returns the vectors u, v, w.
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// Returns the viewport: width, height and distance.
    pub fn viewport(&self) -> &Viewport {
        &self.viewport
    }

    /// Returns the size of the image, W x H pixels.
    pub fn image(&self) -> ImageSize {
        self.image
    }

    /// Returns (u, v) of a pixel's centre:
    ///
    /// ```text
    /// u = width  * ((column + 0.5) / W - 0.5)
    /// v = height * (0.5 - (row + 0.5) / H)
    /// ```
    ///
    /// u is computed as `width * (2 column + 1 - W) / (2 W)`, in which `2 column + 1 - W` is exact, and
    /// v likewise.
    pub fn uv_of_pixel(&self, pixel: Pixel) -> DVec2 {
        DVec2::new(self.u_of_column(pixel.column), self.v_of_row(pixel.row))
    }

    /// Returns u of the centre of a column, see [`ResolvedCamera::uv_of_pixel`].
    pub fn u_of_column(&self, column: u32) -> f64 {
        let (j, w) = (f64::from(column), f64::from(self.image.width()));
        self.viewport.width * ((2.0 * j + 1.0 - w) / (2.0 * w))
    }

    /// Returns v of the centre of a row, see [`ResolvedCamera::uv_of_pixel`].
    pub fn v_of_row(&self, row: u32) -> f64 {
        let (i, h) = (f64::from(row), f64::from(self.image.height()));
        self.viewport.height * ((h - 2.0 * i - 1.0) / (2.0 * h))
    }

    /// Returns u of the edge between columns `k - 1` and `k`, for `k` from 0 to W:
    /// `width * (k / W - 0.5)`.
    pub fn u_of_column_edge(&self, k: u32) -> f64 {
        let (k, w) = (f64::from(k), f64::from(self.image.width()));
        self.viewport.width * ((2.0 * k - w) / (2.0 * w))
    }

    /// Returns v of the edge between rows `k - 1` and `k`, for `k` from 0 to H:
    /// `height * (0.5 - k / H)`.
    pub fn v_of_row_edge(&self, k: u32) -> f64 {
        let (k, h) = (f64::from(k), f64::from(self.image.height()));
        self.viewport.height * ((h - 2.0 * k) / (2.0 * h))
    }

    /// Returns the pixel in which (u, v) lies, and whether it lies exactly on an edge between pixels.
    /// Returns `None` if (u, v) is outside the image.
    ///
    /// "Exactly" means to the precision of `f64`: within 4 ulp of the width or height. The decimal 0.2
    /// is not a binary fraction, but a user who types 0.2 means the edge.
    pub fn pixel_of_uv(&self, uv: DVec2) -> Option<PixelOfUv> {
        let Viewport { width, height, .. } = self.viewport;
        let (columns, rows) = (self.image.width(), self.image.height());
        let (column, column_edge) =
            cell_of(uv.x, 0.5 + uv.x / width, columns, width, |k| self.u_of_column_edge(k))?;
        let (row, row_edge) =
            cell_of(uv.y, 0.5 - uv.y / height, rows, height, |k| self.v_of_row_edge(k))?;
        Some(PixelOfUv { pixel: Pixel { row, column }, column_edge, row_edge })
    }

    /// Returns the view ray through (u, v). Its origin is the eye, and its direction is
    /// `u*U + v*V - distance*W`, not normalized, so that the viewport is at `t = 1`.
    pub fn ray(&self, uv: DVec2) -> Ray {
        let direction = self.column_term(uv.x) + self.row_term(uv.y);
        Ray { origin: self.eye, direction }
    }

    /// Returns the view ray through a pixel's centre.
    pub fn ray_of_pixel(&self, pixel: Pixel) -> Ray {
        self.ray(self.uv_of_pixel(pixel))
    }

    /// Returns the view rays by the position in the picture through which they pass.
    pub fn pixel_rays(&self) -> PixelRays {
        let Viewport { width, height, distance } = self.viewport;
        let Basis { u, v, w } = self.basis;
        PixelRays {
            eye: self.eye,
            across: u * (width / f64::from(self.image.width())),
            down: v * (-height / f64::from(self.image.height())),
            corner: -0.5 * width * u + 0.5 * height * v - distance * w,
        }
    }

    /// Returns the basis in double-double.
    pub(crate) fn fine_basis(&self) -> &FineBasis {
        &self.fine_basis
    }

    /// Returns u, v and the distance, each multiplied by the point's [stretch](Selection::stretch), a
    /// whole number that avoids divisions. Each value is a pair of numbers whose exact product it is.
    fn coordinates(&self, point: Selection) -> [(f64, f64); 3] {
        let Viewport { width, height, distance } = self.viewport;
        match point {
            Selection::Uv(uv) => [(uv.x, 1.0), (uv.y, 1.0), (distance, 1.0)],
            Selection::Pixel(pixel) => {
                let (w, h) = (f64::from(self.image.width()), f64::from(self.image.height()));
                let (row, column) = (f64::from(pixel.row), f64::from(pixel.column));
                [
                    (width, (2.0 * column + 1.0 - w) * h),
                    (height, (h - 2.0 * row - 1.0) * w),
                    (distance, 2.0 * w * h),
                ]
            }
        }
    }

    /// Returns the direction of the view ray through a point, times the point's
    /// [stretch](Selection::stretch), in double-double in units of `2^k`; and k.
    pub(crate) fn fine_direction(&self, point: Selection) -> (Vector<DoubleDouble>, i32) {
        let coordinates = self.coordinates(point);
        // The size of the products matters, not that of the width and height, which drop out at the
        // picture's centre.
        let size = |(x, n): &(f64, f64)| if *n == 0.0 { 0.0 } else { x.abs() };
        let largest = coordinates.iter().map(size).fold(0.0, f64::max);
        let (_, k) =
            scaled([DoubleDouble::from(largest), DoubleDouble::default(), DoubleDouble::default()]);
        let coordinates = coordinates.map(|(x, n)| DoubleDouble::product(ldexp(x, -k), n));
        (self.fine_basis.direction(coordinates), k)
    }

    /// Returns the terms `u U`, `v V` and `-distance W` of the direction of a pixel's view ray or of the
    /// ray through a finite (u, v), each coordinate rounded once.
    pub fn direction_terms(&self, point: Selection) -> [DVec3; 3] {
        let FineBasis { u, v, w, .. } = self.fine_basis;
        let [along_u, along_v, along_w] = self.coordinates(point);
        let stretch = DoubleDouble::from(point.stretch(self.image));
        let part = |(x, n): (f64, f64), sign: f64, axis: Vector<DoubleDouble>| {
            let (k, n) = (if x == 0.0 { 0 } else { exponent(x) }, DoubleDouble::from(sign * n));
            let factor = DoubleDouble::from(ldexp(x, -k)) * n / stretch;
            // Adding 0 turns a negative zero into 0.
            DVec3::from_array(axis.map(|a| ldexp((factor * a).hi, k) + 0.0))
        };
        [part(along_u, 1.0, u), part(along_v, 1.0, v), part(along_w, -1.0, w)]
    }

    /// Returns a view ray in exact numbers.
    pub(crate) fn big_ray(&self, point: Selection) -> BigRay {
        let coordinates = self.coordinates(point).map(|(x, n)| &Dyadic::from(x) * &Dyadic::from(n));
        let [x, y, z] = &coordinates;
        let stretch = Dyadic::from(point.stretch(self.image));
        match self.aim {
            Some(Aim { view, up }) => {
                // x R / sqrt B + y (R x f) / sqrt (A B) + z f / sqrt A, times sqrt (A B).
                let BigBasis { view, right, upward, radicands } = BigBasis::new(&view, up);
                let parts = [times(&upward, y), times(&right, x), times(&view, z)];
                let direction = std::array::from_fn(|i| {
                    let [rational, root_a, root_b] = parts.each_ref().map(|part| part[i].clone());
                    Surd([rational, root_a, root_b, Dyadic::zero()])
                });
                let scale = Radicands::root_of_product().scaled(&stretch);
                BigRay::new(self.eye, direction, scale, radicands)
            }
            None => {
                let Basis { u, v, w } = self.basis;
                let parts = [(u, x), (v, y), (w, z)].map(|(a, x)| times(&exact3(a), x));
                let direction = std::array::from_fn(|i| {
                    Surd::from(&(&parts[0][i] + &parts[1][i]) - &parts[2][i])
                });
                BigRay::new(self.eye, direction, Surd::from(stretch), Radicands::none())
            }
        }
    }

    /// Returns `u*U`, the term that the directions of a column's pixels share.
    pub(crate) fn column_term(&self, u: f64) -> DVec3 {
        u * self.basis.u
    }

    /// Returns `v*V - distance*W`, the term that the directions of a row's pixels share.
    pub(crate) fn row_term(&self, v: f64) -> DVec3 {
        v * self.basis.v - self.viewport.distance * self.basis.w
    }

    /// Returns where a point appears in the viewport: with `q = point - eye`,
    ///
    /// ```text
    /// depth = -q.W     (u, v) = (q.U, q.V) * distance / depth
    /// ```
    ///
    /// `project` is the inverse of [`ResolvedCamera::ray`]: the ray through that (u, v) passes through
    /// the point at `t = depth / distance`.
    pub fn project(&self, point: DVec3) -> Projection {
        let (mut to_point, _, mut k) = difference_with_rest(point, self.eye);
        if to_point.abs().max_element() > 1e300 {
            // Sums of three coordinates may overflow.
            (to_point, k) = (0.25 * to_point, k + 2);
        }
        let q = self.basis.to_camera_from_world(to_point);
        let uv = DVec2::new(q.x, q.y) / -q.z * self.viewport.distance;
        Projection { uv, depth: ldexp(-q.z, k) }
    }

    /// Returns the world position of (u, v) in the viewport: the view ray's point at `t = 1`.
    pub fn viewport_point(&self, uv: DVec2) -> DVec3 {
        self.ray(uv).at(1.0)
    }
}

/// Finds in which of `count` rows or columns across an `extent` a position lies, and on which edge, if
/// any. Returns `None` if the position is outside. `fraction` is the position as a fraction of the
/// extent, from 0 to 1; `edge` returns the position of an edge.
fn cell_of(
    position: f64,
    fraction: f64,
    count: u32,
    extent: f64,
    edge: impl Fn(u32) -> f64,
) -> Option<(u32, Option<u32>)> {
    let x = fraction * f64::from(count);
    let nearest = x.round();
    if !(0.0..=f64::from(count)).contains(&nearest) {
        return None;
    }
    let k = nearest as u32;
    if (position - edge(k)).abs() <= 4.0 * f64::EPSILON * extent {
        return Some((k.min(count - 1), Some(k)));
    }
    let inside = (0.0..f64::from(count)).contains(&x);
    inside.then(|| (x.floor() as u32, None))
}
