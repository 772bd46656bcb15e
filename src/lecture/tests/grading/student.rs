//! A student's ray tracer, as a beginner writes it: plain loops and the textbook's formulas, without
//! any code of the crate. Each mistake that it can be told to make changes one line. A macro generates
//! it in `f64` and in `f32`.

/// The exercise as the student reads it.
#[derive(Clone, Debug)]
pub(crate) struct Exercise {
    pub(crate) eye: [f64; 3],
    pub(crate) at: [f64; 3],
    pub(crate) up: [f64; 3],
    /// Width, height, distance.
    pub(crate) viewport: [f64; 3],
    /// Columns and rows.
    pub(crate) image: [u32; 2],
    /// Centre and radius.
    pub(crate) spheres: Vec<([f64; 3], f64)>,
    /// Point and normal.
    pub(crate) planes: Vec<([f64; 3], [f64; 3])>,
}

macro_rules! student {
    ($name:ident, $real:ident) => {
        pub(crate) mod $name {
            use pinhole_core::{DVec3, Pixel};
            use pinhole_lecture::grading::{GivenHit, HitAnswer, RayAnswer, Written};

            use super::Exercise;

            type Real = $real;
            type V = [Real; 3];

            fn real(v: [f64; 3]) -> V {
                v.map(|x| x as Real)
            }

            pub(crate) fn exactly(v: V) -> Written<DVec3> {
                Written::exactly(DVec3::from(v.map(f64::from)))
            }

            fn add(a: V, b: V) -> V {
                [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
            }

            fn sub(a: V, b: V) -> V {
                [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
            }

            fn mul(s: Real, a: V) -> V {
                [s * a[0], s * a[1], s * a[2]]
            }

            fn dot(a: V, b: V) -> Real {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            fn cross(a: V, b: V) -> V {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            }

            fn norm(a: V) -> Real {
                dot(a, a).sqrt()
            }

            fn normalize(a: V) -> V {
                mul(1.0 / norm(a), a)
            }

            /// The student's program, with the ids of the mistakes that it makes. An id may be followed
            /// by a slash and the name of a variant, as in `not-normalized/w`.
            pub(crate) struct Student<'a> {
                pub(crate) exercise: &'a Exercise,
                pub(crate) mistakes: &'a [&'a str],
            }

            /// t, point, object.
            pub(crate) type Hit = (Real, V, u32);

            impl Student<'_> {
                fn makes(&self, mistake: &str) -> bool {
                    self.mistakes.contains(&mistake)
                }

                pub(crate) fn basis(&self) -> [V; 3] {
                    let [eye, at, up] =
                        [self.exercise.eye, self.exercise.at, self.exercise.up].map(real);
                    let view = sub(at, eye);
                    let back = if self.makes("w-as-printed") { view } else { mul(-1.0, view) };
                    let keeps_w =
                        ["not-normalized/w", "not-normalized/all"].iter().any(|m| self.makes(m));
                    let w = if keeps_w { back } else { normalize(back) };
                    let across = if self.makes("left-handed") || self.makes("left-handed/u") {
                        cross(w, up)
                    } else {
                        cross(up, w)
                    };
                    let keeps_u =
                        ["not-normalized", "not-normalized/all"].iter().any(|m| self.makes(m));
                    let u = if keeps_u { across } else { normalize(across) };
                    // A left-handed cross product is reversed each time.
                    let v = if self.makes("up-as-v") {
                        up
                    } else if self.makes("v-is-u-cross-w") || self.makes("left-handed") {
                        cross(u, w)
                    } else {
                        cross(w, u)
                    };
                    [u, v, w]
                }

                pub(crate) fn ray(&self, row: u32, column: u32) -> (V, V) {
                    let [mut width, mut height, distance] = real(self.exercise.viewport);
                    if self.makes("viewport-swapped") {
                        (width, height) = (height, width);
                    }
                    if self.makes("viewport-scaled") {
                        (width, height) = (width / 2.0, height / 2.0);
                    }
                    if self.makes("viewport-scaled/twice") {
                        (width, height) = (2.0 * width, 2.0 * height);
                    }
                    let [columns, rows] = self.exercise.image;
                    let [u, v, w] = self.basis();
                    let (mut i, mut j) = (row as Real, column as Real);
                    if self.makes("rows-columns-swapped") {
                        (i, j) = (j, i);
                    }
                    let half = if self.makes("pixel-corner") { 0.0 } else { 0.5 };
                    let half_across = if self.makes("pixel-corner/across") { 0.0 } else { half };
                    let (mut columns_of_j, mut rows_of_i) = (columns, rows);
                    if self.makes("rows-columns-swapped/counts") {
                        (columns_of_j, rows_of_i) = (rows, columns);
                    }
                    if self.makes("counted-from-one") {
                        (i, j) = (i - 1.0, j - 1.0);
                    }
                    let wide = match self.makes("aspect-dropped/image") {
                        true => height * columns as Real / rows as Real,
                        false => width,
                    };
                    let across = wide * ((j + half_across) / columns_of_j as Real - 0.5);
                    let high = if self.makes("aspect-dropped") { width } else { height };
                    let mut upwards = high * (0.5 - (i + half) / rows_of_i as Real);
                    if self.makes("rows-from-bottom") {
                        upwards = high * ((i + half) / rows as Real - 0.5);
                    }
                    let back = if self.makes("distance-dropped") {
                        w
                    } else if self.makes("distance-dropped/left-out") {
                        [0.0; 3]
                    } else if self.makes("distance-added") {
                        mul(-distance, w)
                    } else {
                        mul(distance, w)
                    };
                    let d = sub(add(mul(across, u), mul(upwards, v)), back);
                    let d = if self.makes("ray-reversed") { mul(-1.0, d) } else { d };
                    let eye = real(self.exercise.eye);
                    let d = if self.makes("eye-in-direction") { add(eye, d) } else { d };
                    (eye, d)
                }

                fn roots(&self, p: V, d: V, (center, radius): (V, Real)) -> Option<[Real; 2]> {
                    let q = if self.makes("sign-of-b") {
                        sub(center, p)
                    } else if self.makes("center-left-out") {
                        p
                    } else if self.makes("origin-left-out") {
                        mul(-1.0, center)
                    } else {
                        sub(p, center)
                    };
                    let a = if self.makes("not-normalized/a") { 1.0 } else { dot(d, d) };
                    let mut b = dot(d, q);
                    let size =
                        if self.makes("radius-not-squared") { radius } else { radius * radius };
                    let c = dot(q, q) - size;
                    if self.makes("b-for-half-b") {
                        b *= 2.0;
                    }
                    let mut discriminant = b * b - a * c;
                    if self.makes("b-for-half-b/halved") {
                        discriminant = b * b - 4.0 * a * c;
                    }
                    if discriminant < 0.0 {
                        return None;
                    }
                    let below = if self.makes("b-for-half-b/halved") { 2.0 * a } else { a };
                    if self.makes("root-left-out") {
                        return Some([-b / below; 2]);
                    }
                    let root = if self.makes("root-left-out/d") {
                        discriminant
                    } else {
                        discriminant.sqrt()
                    };
                    Some([(-b - root) / below, (-b + root) / below])
                }

                pub(crate) fn hit(&self, row: u32, column: u32) -> Option<Hit> {
                    let (p, d) = self.ray(row, column);
                    let mut first: Option<(Real, u32)> = None;
                    let mut take = |t: Real, object: usize| {
                        let is_ahead = t > 0.0 || self.makes("negative-t");
                        let is_better = first.is_none_or(|(before, _)| {
                            if self.makes("last-object/farthest") {
                                t > before
                            } else {
                                self.makes("last-object") || t < before
                            }
                        });
                        if is_ahead && is_better {
                            first = Some((t, object as u32));
                        }
                    };
                    for (object, sphere) in self.exercise.spheres.iter().enumerate() {
                        if let Some([near, far]) =
                            self.roots(p, d, (real(sphere.0), sphere.1 as Real))
                        {
                            let is_ahead = near > 0.0 || self.makes("negative-t");
                            let chosen =
                                if is_ahead && !self.makes("far-root") { near } else { far };
                            take(chosen, object);
                        }
                    }
                    for (k, plane) in self.exercise.planes.iter().enumerate() {
                        let (point, normal) = (real(plane.0), real(plane.1));
                        let rate = dot(normal, d);
                        if rate != 0.0 {
                            take(
                                dot(normal, sub(point, p)) / rate,
                                self.exercise.spheres.len() + k,
                            );
                        }
                    }
                    let (t, object) = first?;
                    let point = if self.makes("t-for-distance/point") {
                        add(p, mul(t, normalize(d)))
                    } else {
                        add(p, mul(t, d))
                    };
                    let t = if self.makes("t-for-distance") { t * norm(d) } else { t };
                    Some((t, point, object))
                }

                fn pixels(&self) -> impl Iterator<Item = Pixel> + use<> {
                    let [columns, rows] = self.exercise.image;
                    (0..rows)
                        .flat_map(move |row| (0..columns).map(move |column| Pixel { row, column }))
                }

                pub(crate) fn rays(&self) -> Vec<RayAnswer> {
                    let answer = |pixel: Pixel| {
                        let (p, d) = self.ray(pixel.row, pixel.column);
                        let [origin, direction] = [p, d].map(|v| exactly(v));
                        RayAnswer { pixel, origin, direction }
                    };
                    self.pixels().map(answer).collect()
                }

                pub(crate) fn hits(&self) -> Vec<HitAnswer> {
                    let answer = |pixel: Pixel| {
                        let hit =
                            self.hit(pixel.row, pixel.column).map(|(t, point, object)| GivenHit {
                                t: Some(Written::exactly(f64::from(t))),
                                point: Some(exactly(point)),
                                object: Some(object),
                            });
                        HitAnswer { pixel, hit }
                    };
                    self.pixels().map(answer).collect()
                }
            }
        }
    };
}

student!(double, f64);
student!(single, f32);
