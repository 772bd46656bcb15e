//! Whole frames and lists of rays by a [method](crate::methods), each loop compiled for one method.
//!
//! These pictures show the errors of a method, so every pixel's ray is intersected with every object: no
//! bounds are computed, and nothing is left out.

use crate::camera::resolved::ResolvedCamera;
use crate::methods::formulas::{Intersect, PlaneByTextbook, is_hit};
use crate::methods::number::{Real, RoundedPlane, RoundedRay, RoundedScene, RoundedSphere, Vector};
use crate::render::frame::{NO_OBJECT, Raster};
use crate::scene::Scene;

/// The view rays of a raster in a method's precision. The camera's basis, viewport and eye are rounded
/// to the precision first, and so is every operation of a direction `u*U + (v*V - distance*W)`.
pub(crate) struct ViewRays<R> {
    pub(crate) origin: Vector<R>,
    /// The term `u*U` of each column, coordinate by coordinate.
    column_terms: [Vec<R>; 3],
    /// The term `v*V - distance*W` of each row.
    row_terms: Vec<Vector<R>>,
}

impl<R: Real> ViewRays<R> {
    pub(crate) fn new(camera: &ResolvedCamera, raster: &Raster) -> Self {
        let (basis, viewport) = (camera.basis(), camera.viewport());
        let [u, v, w] = [basis.u, basis.v, basis.w].map(Vector::<R>::rounded);
        let [width, height, distance] =
            [viewport.width, viewport.height, viewport.distance].map(R::from_f64);
        let (columns, rows) = (camera.image().width(), camera.image().height());
        // Small integers, exact in every precision.
        let share = |extent: R, numerator: f64, count: u32| {
            extent * (R::from_f64(numerator) / R::from_f64(2.0 * f64::from(count)))
        };
        let column_term = |column: &u32| {
            let odd = 2.0 * f64::from(*column) + 1.0;
            u.times(share(width, odd - f64::from(columns), columns))
        };
        let row_term = |row: &u32| {
            let odd = 2.0 * f64::from(*row) + 1.0;
            v.times(share(height, f64::from(rows) - odd, rows)) - w.times(distance)
        };
        let parts: Vec<Vector<R>> = raster.columns().iter().map(column_term).collect();
        ViewRays {
            origin: Vector::rounded(camera.eye()),
            column_terms: [
                parts.iter().map(|p| p.x).collect(),
                parts.iter().map(|p| p.y).collect(),
                parts.iter().map(|p| p.z).collect(),
            ],
            row_terms: raster.rows().iter().map(row_term).collect(),
        }
    }

    /// Returns the ray of the raster's `row`th row and `column`th column.
    pub(crate) fn ray(&self, row: usize, column: usize) -> RoundedRay<R> {
        let [x, y, z] = &self.column_terms;
        let part = Vector { x: x[column], y: y[column], z: z[column] };
        RoundedRay { origin: self.origin, direction: part + self.row_terms[row] }
    }
}

/// The data that all rows of a frame share.
pub(crate) struct FrameBy<M: Intersect> {
    pub(crate) rays: ViewRays<M::Real>,
    spheres: Vec<M>,
    planes: Vec<PlaneByTextbook<M::Real>>,
}

/// One row's directions, and the nearest hits so far.
pub(crate) struct Row<R> {
    directions: [Vec<R>; 3],
    pub(crate) t: Vec<R>,
    pub(crate) object: Vec<u32>,
}

impl<R: Real> Row<R> {
    /// Intersects every pixel's ray with one object. Objects come in ascending order, so an object wins
    /// only if its hit is strictly nearer, and the first of equals is kept; NaN is never nearer.
    #[inline(always)]
    fn ask(&mut self, object: u32, first_hit: impl Fn(Vector<R>) -> R) {
        let [x, y, z] = &self.directions;
        let nearest = self.t.iter_mut().zip(&mut self.object);
        for ((t, nearest_object), ((x, y), z)) in nearest.zip(x.iter().zip(y).zip(z)) {
            let hit = first_hit(Vector { x: *x, y: *y, z: *z });
            let is_nearer = (hit > R::ZERO) & (hit < *t);
            *t = if is_nearer { hit } else { *t };
            *nearest_object = if is_nearer { object } else { *nearest_object };
        }
    }
}

impl<M: Intersect> FrameBy<M> {
    pub(crate) fn new(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Self {
        let rays = ViewRays::new(camera, raster);
        let origin = rays.origin;
        let sphere = |sphere| M::new(&RoundedSphere::new(sphere), origin);
        let plane = |plane| PlaneByTextbook::new(&RoundedPlane::new(plane), origin);
        FrameBy {
            spheres: scene.spheres().iter().map(sphere).collect(),
            planes: scene.planes().iter().map(plane).collect(),
            rays,
        }
    }

    /// Traces the raster's `index`th row.
    #[inline(always)]
    pub(crate) fn trace_row(&self, index: usize, row: &mut Row<M::Real>) {
        let part = self.rays.row_terms[index];
        let of_rows = [part.x, part.y, part.z];
        for ((direction, of_columns), of_row) in
            row.directions.iter_mut().zip(&self.rays.column_terms).zip(of_rows)
        {
            for (coordinate, of_column) in direction.iter_mut().zip(of_columns) {
                *coordinate = *of_column + of_row;
            }
        }
        row.t.fill(M::Real::INFINITY);
        row.object.fill(NO_OBJECT);
        for (object, sphere) in (0..).zip(&self.spheres) {
            row.ask(object, |direction| sphere.first_hit(direction));
        }
        for (object, plane) in (self.spheres.len() as u32..).zip(&self.planes) {
            row.ask(object, |direction| plane.first_hit(direction));
        }
    }

    pub(crate) fn row(&self) -> Row<M::Real> {
        let directions = self.rays.column_terms.clone();
        let columns = directions[0].len();
        let (t, object) = (vec![M::Real::INFINITY; columns], vec![NO_OBJECT; columns]);
        Row { directions, t, object }
    }
}

/// Returns the first hit of a rounded ray among rounded objects, or `None` if there is none.
#[inline(always)]
pub(crate) fn first_hit<M: Intersect>(
    scene: &RoundedScene<M::Real>,
    ray: &RoundedRay<M::Real>,
) -> Option<(u32, M::Real)> {
    let RoundedRay { origin, direction } = *ray;
    let of_spheres = scene.spheres.iter().map(|sphere| M::new(sphere, origin).first_hit(direction));
    let plane = |plane| PlaneByTextbook::new(plane, origin).first_hit(direction);
    let of_planes = scene.planes.iter().map(plane);
    let mut first = None;
    let mut nearest = M::Real::INFINITY;
    for (object, t) in (0..).zip(of_spheres.chain(of_planes)) {
        if is_hit(t) && t < nearest {
            nearest = t;
            first = Some(object);
        }
    }
    first.map(|object| (object, nearest))
}
