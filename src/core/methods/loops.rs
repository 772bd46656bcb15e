//! Traces whole frames and lists of rays by a [method](crate::methods). Each loop is compiled for each
//! method.
//!
//! These pictures are to show the errors of a method, so every pixel's ray is intersected with every
//! object: there are no bounding volumes, and nothing is skipped.

use crate::camera::resolved::ResolvedCamera;
use crate::exact::bounded::Vector;
use crate::methods::formulas::{Intersect, Terms, plane_by_textbook};
use crate::methods::number::{Real, RoundedRay, RoundedScene, minus, plus, rounded, times};
use crate::render::frame::{NO_OBJECT, Raster};
use crate::scene::Scene;

/// A scene and the view rays of a raster, in a method's precision. The camera's basis, viewport and eye
/// are rounded to this precision first, and so is the result of every operation in a direction
/// `u*U + (v*V - distance*W)`.
pub(crate) struct RoundedFrame<R> {
    pub(crate) scene: RoundedScene<R>,
    origin: Vector<R>,
    /// The term `u*U` of each column, coordinate by coordinate.
    column_terms: [Vec<R>; 3],
    /// The term `v*V - distance*W` of each row.
    row_terms: Vec<Vector<R>>,
}

/// The directions of one row's rays, and the nearest hits so far.
pub(crate) struct Row<R> {
    directions: [Vec<R>; 3],
    pub(crate) t: Vec<R>,
    pub(crate) object: Vec<u32>,
}

impl<R: Real> Row<R> {
    /// Intersects every pixel's ray with one object. Objects must be added in ascending order: an object
    /// replaces the known one only if its hit is strictly nearer, so the first of equals is kept. NaN is
    /// never nearer.
    #[inline(always)]
    fn add(&mut self, object: u32, first_hit: impl Fn(Vector<R>) -> R) {
        let [x, y, z] = &self.directions;
        let nearest = self.t.iter_mut().zip(&mut self.object);
        for ((t, nearest_object), ((x, y), z)) in nearest.zip(x.iter().zip(y).zip(z)) {
            let hit = first_hit([*x, *y, *z]);
            let is_nearer = (hit > R::ZERO) & (hit < *t);
            *t = if is_nearer { hit } else { *t };
            *nearest_object = if is_nearer { object } else { *nearest_object };
        }
    }
}

impl<R: Real> RoundedFrame<R> {
    pub(crate) fn new(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Self {
        let (basis, viewport) = (camera.basis(), camera.viewport());
        let [u, v, w] = [basis.u, basis.v, basis.w].map(rounded::<R>);
        let [width, height, distance] =
            [viewport.width, viewport.height, viewport.distance].map(R::from_f64);
        let (columns, rows) = (camera.image().width(), camera.image().height());
        // The numerator and the count are small integers, exact in every precision.
        let share = |extent: R, numerator: f64, count: u32| {
            extent * (R::from_f64(numerator) / R::from_f64(2.0 * f64::from(count)))
        };
        let column_term = |column: &u32| {
            let odd = 2.0 * f64::from(*column) + 1.0;
            times(share(width, odd - f64::from(columns), columns), u)
        };
        let row_term = |row: &u32| {
            let odd = 2.0 * f64::from(*row) + 1.0;
            minus(times(share(height, f64::from(rows) - odd, rows), v), times(distance, w))
        };
        let terms: Vec<Vector<R>> = raster.columns().iter().map(column_term).collect();
        RoundedFrame {
            scene: RoundedScene::new(scene),
            origin: rounded(camera.eye()),
            column_terms: [0, 1, 2].map(|i| terms.iter().map(|term| term[i]).collect()),
            row_terms: raster.rows().iter().map(row_term).collect(),
        }
    }

    /// Returns the ray of the pixel with this index in the raster, row by row.
    pub(crate) fn ray(&self, index: usize) -> RoundedRay<R> {
        let width = self.column_terms[0].len();
        let column_term = self.column_terms.each_ref().map(|x| x[index % width]);
        let direction = plus(column_term, self.row_terms[index / width]);
        RoundedRay { origin: self.origin, direction }
    }

    /// Traces the raster's `index`th row.
    #[inline(always)]
    pub(crate) fn trace_row<M: Intersect<R>>(&self, index: usize, row: &mut Row<R>) {
        let of_rows = self.row_terms[index];
        for ((direction, of_columns), of_row) in
            row.directions.iter_mut().zip(&self.column_terms).zip(of_rows)
        {
            for (coordinate, of_column) in direction.iter_mut().zip(of_columns) {
                *coordinate = *of_column + of_row;
            }
        }
        row.t.fill(R::INFINITY);
        row.object.fill(NO_OBJECT);
        let (scene, origin) = (&self.scene, self.origin);
        for (object, &sphere) in (0..).zip(&scene.spheres) {
            row.add(object, move |direction| {
                M::first_hit(&Terms::new(&sphere, &RoundedRay { origin, direction }))
            });
        }
        for (object, &plane) in (scene.spheres.len() as u32..).zip(&scene.planes) {
            row.add(object, move |direction| {
                plane_by_textbook(&plane, &RoundedRay { origin, direction })
            });
        }
    }

    pub(crate) fn row(&self) -> Row<R> {
        let directions = self.column_terms.clone();
        let columns = directions[0].len();
        Row { directions, t: vec![R::INFINITY; columns], object: vec![NO_OBJECT; columns] }
    }
}

/// Returns the first hit of a rounded ray among rounded objects, or `None` if there is none.
#[inline(always)]
pub(crate) fn first_hit<M: Intersect<R>, R: Real>(
    scene: &RoundedScene<R>,
    ray: &RoundedRay<R>,
) -> Option<(u32, R)> {
    let of_spheres = scene.spheres.iter().map(|sphere| M::first_hit(&Terms::new(sphere, ray)));
    let of_planes = scene.planes.iter().map(|plane| plane_by_textbook(plane, ray));
    let mut first = None;
    let mut nearest = R::INFINITY;
    for (object, t) in (0..).zip(of_spheres.chain(of_planes)) {
        if t > R::ZERO && t < nearest {
            nearest = t;
            first = Some(object);
        }
    }
    first.map(|object| (object, nearest))
}
