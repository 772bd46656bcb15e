//! The textbook formula for one sphere in `f32` or `f64` SIMD vectors, with no error bounds: the
//! fastest plain loop to compare with.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};
use pinhole_core::{NO_OBJECT, ResolvedCamera, Sphere};

/// Which roots of the quadratic are computed.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Form {
    /// Both roots of `a t^2 + b t + c = 0`, `(-b -+ sqrt(b^2 - 4ac)) / 2a`, of which the smaller
    /// positive one is the hit.
    TwoRoots,
    /// Only the near root of `a t^2 + 2 b t + c = 0`, `c / (sqrt(b^2 - a c) - b)`, which is the hit if
    /// the eye is outside the sphere.
    OneRoot,
}

/// A frame with the buffers of a `Frame`.
pub(crate) struct Loop<R> {
    columns: Vec<[R; 3]>,
    column_x: Vec<R>,
    column_y: Vec<R>,
    column_z: Vec<R>,
    rows: Vec<[R; 3]>,
    from_center: [R; 3],
    c: R,
    pub(crate) t: Vec<R>,
    pub(crate) object: Vec<u32>,
}

macro_rules! textbook {
    ($real:ident, $vector:ident) => {
        impl Loop<$real> {
            pub(crate) fn new(camera: &ResolvedCamera, sphere: &Sphere) -> Self {
                let image = camera.image();
                let basis = camera.basis();
                let distance = camera.viewport().distance;
                let rounded = |v: pinhole_core::DVec3| v.to_array().map(|x| x as $real);
                let columns: Vec<_> =
                    (0..image.width()).map(|c| rounded(camera.u_of_column(c) * basis.u)).collect();
                let rows = (0..image.height())
                    .map(|r| rounded(camera.v_of_row(r) * basis.v - distance * basis.w))
                    .collect();
                let part = |i: usize| columns.iter().map(|c: &[$real; 3]| c[i]).collect();
                let from_center = rounded(camera.eye() - sphere.center);
                let [x, y, z] = from_center;
                let radius = sphere.radius as $real;
                let pixels = image.width() as usize * image.height() as usize;
                Loop {
                    column_x: part(0),
                    column_y: part(1),
                    column_z: part(2),
                    columns,
                    rows,
                    from_center,
                    c: x * x + y * y + z * z - radius * radius,
                    t: vec![0.0; pixels],
                    object: vec![0; pixels],
                }
            }

            pub(crate) fn run(&mut self, level: Level, form: Form) {
                dispatch!(level, simd => self.trace(simd, form));
            }

            #[inline(always)]
            fn trace<S: Simd>(&mut self, simd: S, form: Form) {
                let width = self.columns.len();
                for row in 0..self.rows.len() {
                    self.row(simd, row, width, form);
                }
            }

            #[inline(always)]
            fn row<S: Simd>(&mut self, simd: S, row: usize, width: usize, form: Form) {
                type V<S> = <S as Simd>::$vector;
                let n = V::<S>::LEN;
                let splat = |x: $real| V::<S>::splat(simd, x);
                let r = self.rows[row].map(splat);
                let oc = self.from_center.map(splat);
                let c = splat(self.c);
                let (none, zero) = (splat($real::INFINITY), splat(0.0));
                let t = &mut self.t[row * width..(row + 1) * width];
                let object = &mut self.object[row * width..(row + 1) * width];
                for i in (0..width).step_by(n) {
                    let x = V::<S>::from_slice(simd, &self.column_x[i..i + n]) + r[0];
                    let y = V::<S>::from_slice(simd, &self.column_y[i..i + n]) + r[1];
                    let z = V::<S>::from_slice(simd, &self.column_z[i..i + n]) + r[2];
                    let a = x * x + y * y + z * z;
                    let b = x * oc[0] + y * oc[1] + z * oc[2];
                    let found = match form {
                        Form::TwoRoots => {
                            let b = b * 2.0;
                            let discriminant = b * b - a * c * 4.0;
                            let root = discriminant.sqrt();
                            let two_a = a * 2.0;
                            let (near, far) = ((-b - root) / two_a, (root - b) / two_a);
                            let first = near.simd_gt(zero).select(near, far);
                            first.simd_gt(zero).select(first, none)
                        }
                        Form::OneRoot => {
                            let discriminant = b * b - a * c;
                            let near = c / (discriminant.sqrt() - b);
                            near.simd_gt(zero).select(near, none)
                        }
                    };
                    found.store_slice(&mut t[i..i + n]);
                }
                // The object indices are written in a separate loop, which the compiler vectorizes.
                for (t, object) in t.iter().zip(object) {
                    *object = if *t < $real::INFINITY { 0 } else { NO_OBJECT };
                }
            }
        }
    };
}

textbook!(f32, f32s);
textbook!(f64, f64s);
