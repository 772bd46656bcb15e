//! Tones, the three numbers from which a pixel's colour is made, computed for a single pixel or, by
//! SIMD, for a run (neighbouring pixels that show the same object).

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};
use glam::DVec3;

use crate::camera::ray::Ray;
use crate::exact::lanes::Lanes;
use crate::render::shade::normals::{
    Ball, Normals, PLAIN_T, Surface, far_normal, near_normal, plane_cosine, sphere_cosine,
};
use crate::render::shade::paint::{PARTS, Rgb, Shade, Srgb};
use crate::scene::Scene;

/// Number of pixels by which rows are padded: the number of `f32` lanes in the widest vector.
pub(crate) const PADDING: usize = 16;

/// The fraction of light that is ambient.
pub(crate) const AMBIENT: f64 = 0.15;
/// The fraction of light that comes from the eye.
pub(crate) const FROM_EYE: f64 = 0.85;

/// Red, green and blue of a pixel: linear light, from 0 to [`PARTS`], for [`Shade::Lambert`]; bytes
/// for all other shadings.
pub(crate) type Tones = [u32; 3];

/// Converts hits to colours like [`shade`](fn@crate::shade), but for any rays, not only those of a
/// frame.
pub struct HitShader<'a> {
    shade: Shade,
    /// The `t` that [`Shade::T`] shows as white.
    nearest: f64,
    normals: Normals<'a>,
    srgb: &'static Srgb,
}

/// Neighbouring pixels of one row that show the same object.
pub(crate) struct Run {
    pub(crate) start: usize,
    pub(crate) end: usize,
    pub(crate) object: u32,
    pub(crate) color: Rgb,
}

/// The rays of one row. Each direction is the sum of a term of the column and a term of the row.
#[derive(Clone, Copy)]
pub(crate) struct RowRays<'a> {
    pub(crate) eye: DVec3,
    /// The column's term of the direction, for each column (a structure of arrays), padded to whole SIMD
    /// vectors.
    pub(crate) columns: [&'a [f64]; 3],
    pub(crate) row: DVec3,
    /// True if all directions have lengths that need no scaling.
    pub(crate) is_plain: bool,
}

impl RowRays<'_> {
    fn ray(&self, column: usize) -> Ray {
        let [x, y, z] = self.columns.map(|part| part[column]);
        Ray { origin: self.eye, direction: DVec3::new(x, y, z) + self.row }
    }
}

/// A row's tones, padded, channel by channel.
pub(crate) type ToneRow = [Vec<u32>; 3];

impl<'a> HitShader<'a> {
    /// Makes a shader for hits on this scene's objects; `nearest` is the `t` that [`Shade::T`] shows as
    /// white.
    pub fn new(scene: &'a Scene, shade: Shade, nearest: f64) -> Self {
        HitShader { shade, nearest, normals: Normals::new(scene), srgb: Srgb::get() }
    }

    /// Returns the colour of the ray's first hit, which must be on `object` at `t`; `own` is the
    /// object's colour.
    pub fn color(&self, ray: &Ray, object: u32, t: f64, own: Rgb) -> Rgb {
        self.color_of(self.tones(ray, object, t, own))
    }

    /// Converts tones to a colour.
    #[inline(always)]
    pub(crate) fn color_of(&self, tones: Tones) -> Rgb {
        match self.shade {
            Shade::Lambert => tones.map(|linear| self.srgb.byte_of(linear)),
            _ => tones.map(|byte| byte as u8),
        }
    }

    /// Returns the tones of one ray's first hit. [`Shade::Lambert`] and [`Shade::Object`] do not use
    /// `t`.
    fn tones(&self, ray: &Ray, object: u32, t: f64, color: Rgb) -> Tones {
        let Some(surface) = self.normals.surface(object) else { return [0; 3] };
        match self.shade {
            Shade::Object => color.map(u32::from),
            Shade::T => [byte((255.0 * (self.nearest / t)) as f32); 3],
            Shade::Normal => {
                let normal: [f64; 3] = surface.normal(ray, t).into();
                normal.map(|x| byte(127.5 * (x as f32 + 1.0)))
            }
            Shade::Lambert => {
                let light = (AMBIENT + FROM_EYE * surface.cosine(ray)) as f32;
                color.map(|byte| (light * self.srgb.linear_of(byte) + 0.5) as u32)
            }
        }
    }

    /// Computes the tones of all runs of a row. If the shading needs `t`, `t` must be padded, too.
    pub(crate) fn row(
        &self,
        level: Level,
        rays: &RowRays,
        runs: &[Run],
        t: &[f64],
        tones: &mut ToneRow,
    ) {
        dispatch!(level, simd => self.row_in(simd, rays, runs, t, tones));
    }

    #[inline(always)]
    fn row_in<S: Simd>(
        &self,
        simd: S,
        rays: &RowRays,
        runs: &[Run],
        t: &[f64],
        tones: &mut ToneRow,
    ) {
        for run in runs {
            let is_done = match self.shade {
                Shade::Object => true,
                Shade::T => self.run_of_t(simd, run, t, tones),
                Shade::Normal => self.run_of_normals(simd, rays, run, t, tones),
                Shade::Lambert => self.run_of_light(simd, rays, run, tones),
            };
            if !is_done {
                for column in run.start..run.end {
                    let t = t.get(column).copied().unwrap_or(f64::INFINITY);
                    let pixel = self.tones(&rays.ray(column), run.object, t, run.color);
                    for (channel, tone) in tones.iter_mut().zip(pixel) {
                        channel[column] = tone;
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn run_of_light<S: Simd>(
        &self,
        simd: S,
        rays: &RowRays,
        run: &Run,
        tones: &mut ToneRow,
    ) -> bool {
        let [r, g, b] = run.color;
        let linear = [self.srgb.linear_of(r), self.srgb.linear_of(g), self.srgb.linear_of(b)];
        match self.normals.surface(run.object) {
            Some(Surface::Plane(normal)) if rays.is_plain => {
                let plane = LitPlane { n: splat3(simd, normal) };
                light_of_run(simd, rays, run, linear, tones, &plane);
                true
            }
            Some(Surface::Sphere(sphere)) if rays.is_plain => {
                let Some(Ball { q, radius, .. }) = Ball::new(sphere, rays.eye) else {
                    return false;
                };
                let sphere = LitSphere {
                    q: splat3(simd, q),
                    r_squared: Lanes::splat(simd, radius * radius),
                    one: Lanes::splat(simd, 1.0),
                };
                light_of_run(simd, rays, run, linear, tones, &sphere);
                true
            }
            _ => false,
        }
    }

    #[inline(always)]
    fn run_of_normals<S: Simd>(
        &self,
        simd: S,
        rays: &RowRays,
        run: &Run,
        t: &[f64],
        tones: &mut ToneRow,
    ) -> bool {
        match self.normals.surface(run.object) {
            Some(Surface::Plane(normal)) => {
                let normal = normal.to_array();
                for (channel, x) in tones.iter_mut().zip(normal) {
                    channel[run.start..run.end].fill(byte(127.5 * (x as f32 + 1.0)));
                }
                true
            }
            Some(Surface::Sphere(sphere)) if rays.is_plain => {
                let Some(Ball { q, radius, is_near }) = Ball::new(sphere, rays.eye) else {
                    return false;
                };
                let q = splat3(simd, q);
                if !is_near {
                    let sphere = FarSphere { q, r: Lanes::splat(simd, radius) };
                    normals_of_run(simd, rays, run, tones, &sphere);
                } else if t[run.start..run.end].iter().all(|t| PLAIN_T.contains(t)) {
                    normals_of_run(simd, rays, run, tones, &NearSphere { q, t });
                } else {
                    return false;
                }
                true
            }
            _ => false,
        }
    }

    #[inline(always)]
    fn run_of_t<S: Simd>(&self, simd: S, run: &Run, t: &[f64], tones: &mut ToneRow) -> bool {
        if !self.nearest.is_finite() {
            return false;
        }
        let (nearest, white) = (S::f64s::splat(simd, self.nearest), S::f64s::splat(simd, 255.0));
        let half = S::f64s::LEN;
        for start in (run.start..run.end).step_by(S::f32s::LEN) {
            let low = S::f64s::from_slice(simd, &t[start..start + half]);
            let high = S::f64s::from_slice(simd, &t[start + half..start + 2 * half]);
            let share = (white * (nearest / low)).narrow(white * (nearest / high));
            let gray = bytes(simd, share);
            for channel in &mut *tones {
                gray.store_slice(&mut channel[start..start + S::f32s::LEN]);
            }
        }
        true
    }
}

/// Rounds to the nearest byte; `x` must not be negative.
fn byte(x: f32) -> u32 {
    u32::from((x + 0.5) as u8)
}

/// Rounds each lane of a SIMD vector to the nearest byte, at most 255.
#[inline(always)]
fn bytes<S: Simd>(simd: S, x: S::f32s) -> S::u32s {
    let most = S::f32s::splat(simd, 255.0);
    (x + S::f32s::splat(simd, 0.5)).min(most).to_int()
}

#[inline(always)]
fn splat3<S: Simd>(simd: S, v: DVec3) -> [Lanes<S>; 3] {
    [Lanes::splat(simd, v.x), Lanes::splat(simd, v.y), Lanes::splat(simd, v.z)]
}

/// Returns the directions of a SIMD vector of rays, in the row's columns from `start` on.
#[inline(always)]
fn directions<S: Simd>(simd: S, rays: &RowRays, start: usize) -> [Lanes<S>; 3] {
    let end = start + S::f64s::LEN;
    let row = splat3(simd, rays.row);
    [
        Lanes(S::f64s::from_slice(simd, &rays.columns[0][start..end])) + row[0],
        Lanes(S::f64s::from_slice(simd, &rays.columns[1][start..end])) + row[1],
        Lanes(S::f64s::from_slice(simd, &rays.columns[2][start..end])) + row[2],
    ]
}

/// A lit surface, for a SIMD vector of rays. It is a trait, not a closure, for the reason given in
/// `normals.rs`.
trait Lit<S: Simd> {
    /// Returns `|n.d| / |d|`, with the unit normal n where the ray of direction d hits the surface.
    fn cosine(&self, d: [Lanes<S>; 3]) -> Lanes<S>;
}

struct LitPlane<S: Simd> {
    n: [Lanes<S>; 3],
}

impl<S: Simd> Lit<S> for LitPlane<S> {
    #[inline(always)]
    fn cosine(&self, d: [Lanes<S>; 3]) -> Lanes<S> {
        plane_cosine(self.n, d)
    }
}

struct LitSphere<S: Simd> {
    q: [Lanes<S>; 3],
    r_squared: Lanes<S>,
    one: Lanes<S>,
}

impl<S: Simd> Lit<S> for LitSphere<S> {
    #[inline(always)]
    fn cosine(&self, d: [Lanes<S>; 3]) -> Lanes<S> {
        sphere_cosine(self.q, self.r_squared, d, self.one)
    }
}

/// A curved surface, for a SIMD vector of rays.
trait Curved<S: Simd> {
    /// Returns the normals at the hits of rays with the directions d, in the row's columns from `start`
    /// on.
    fn normal(&self, simd: S, start: usize, d: [Lanes<S>; 3]) -> [Lanes<S>; 3];
}

struct NearSphere<'a, S: Simd> {
    q: [Lanes<S>; 3],
    t: &'a [f64],
}

impl<S: Simd> Curved<S> for NearSphere<'_, S> {
    #[inline(always)]
    fn normal(&self, simd: S, start: usize, d: [Lanes<S>; 3]) -> [Lanes<S>; 3] {
        let t = S::f64s::from_slice(simd, &self.t[start..start + S::f64s::LEN]);
        near_normal(self.q, d, Lanes(t))
    }
}

struct FarSphere<S: Simd> {
    q: [Lanes<S>; 3],
    r: Lanes<S>,
}

impl<S: Simd> Curved<S> for FarSphere<S> {
    #[inline(always)]
    fn normal(&self, _: S, _: usize, d: [Lanes<S>; 3]) -> [Lanes<S>; 3] {
        far_normal(self.q, self.r, d)
    }
}

/// Computes the tones of a run of lit pixels. Tones past the end of the run are overwritten by the next
/// run.
#[inline(always)]
fn light_of_run<S: Simd>(
    simd: S,
    rays: &RowRays,
    run: &Run,
    linear: [f32; 3],
    tones: &mut ToneRow,
    lit: &impl Lit<S>,
) {
    let (ambient, from_eye) = (Lanes::<S>::splat(simd, AMBIENT), Lanes::splat(simd, FROM_EYE));
    let (rounding, most) = (S::f32s::splat(simd, 0.5), S::f32s::splat(simd, PARTS as f32));
    for start in (run.start..run.end).step_by(S::f32s::LEN) {
        let low = ambient + from_eye * lit.cosine(directions(simd, rays, start));
        let high = start + S::f64s::LEN;
        let high = ambient + from_eye * lit.cosine(directions(simd, rays, high));
        let light: S::f32s = low.0.narrow(high.0);
        for k in 0..3 {
            let linear = S::f32s::splat(simd, linear[k]);
            let tone: S::u32s = (light * linear + rounding).min(most).to_int();
            tone.store_slice(&mut tones[k][start..start + S::f32s::LEN]);
        }
    }
}

/// Computes the tones of a run of normals. Tones past the end of the run are overwritten by the next
/// run.
#[inline(always)]
fn normals_of_run<S: Simd>(
    simd: S,
    rays: &RowRays,
    run: &Run,
    tones: &mut ToneRow,
    curved: &impl Curved<S>,
) {
    let (one, half_white) = (S::f32s::splat(simd, 1.0), S::f32s::splat(simd, 127.5));
    for start in (run.start..run.end).step_by(S::f32s::LEN) {
        let high = start + S::f64s::LEN;
        let low = curved.normal(simd, start, directions(simd, rays, start));
        let high = curved.normal(simd, high, directions(simd, rays, high));
        for k in 0..3 {
            let x: S::f32s = low[k].0.narrow(high[k].0);
            let tone = bytes(simd, half_white * (x + one));
            tone.store_slice(&mut tones[k][start..start + S::f32s::LEN]);
        }
    }
}
