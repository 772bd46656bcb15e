//! Pictures: the first hit of every pixel's view ray, and its colour.
//!
//! # The plan of a frame
//!
//! All rays of a frame start at the eye. So a sphere's outline in the picture is a conic, and on one row
//! of pixels the hits form one interval. The interval is computed once per row. Only pixels closer to
//! its ends than a margin are in doubt; every other pixel inside is a hit.
//!
//! - [`plan`]: which objects are visible in which rows, and how each is drawn. Spheres behind the eye or
//!   outside the view are dropped. If there are many spheres, an index finds the visible ones ([`bvh`]).
//! - Then bands of rows are drawn in parallel ([`row_band`]), each in this order ([`fill`]):
//!   - spheres that are near or large, because they hide many of the others: their quadratic is
//!     evaluated as a polynomial in row and column ([`polynomial`]);
//!   - all other spheres, near to far and row by row ([`rows`]), in `f32`, several pixels at a time. If
//!     there are few, pixels are not cleared first: the first sphere that covers a SIMD vector of pixels
//!     writes it without reading it ([`rows::draw_row`]). If there are many, spheres that are small
//!     compared with their distance are drawn together ([`rows::small_spheres`]), and spheres hidden by
//!     nearer ones are skipped ([`bvh::occlusion`], [`rows::VectorBounds`]);
//!   - spheres that cannot be drawn by outlines, and the planes, by polynomials again.
//! - Every computation has an error bound. A pixel whose decision lies within the bound is *in doubt*,
//!   and is decided individually by [the ladder](crate#the-ladder), step by step in higher precision
//!   ([`row_band::fallback`]). So each pixel shows the object that exact arithmetic would find.
//! - Normals, if requested, and colours ([`shade`](mod@shade)), while the band is in the cache.
//!
//! Smooth edges are not part of a frame: [`edge_blends`](crate::edge_blends) finds, in a finished frame, how
//! much of a pixel lies on either side of a border ([`edges`]).
//!
//! Each pair of a pixel and a sphere that is in doubt costs 10 to 100 ns if `f64` decides it, as for
//! spheres that are equal, nearly equal or nested, or on whose surface the eye lies: their order follows
//! from their difference ([`PairOrder`](crate::scene::pair_order)), for eight pixels of a crowd at a time
//! ([`row_band::segments`]). It costs a quarter of a microsecond or more if double-double is needed, and 10 microseconds
//! or more if exact numbers are: for exact tangents, and for ties between unequal objects.
//! `cargo bench -p pinhole-core --bench worst` measures the worst families known. Those in which `f64`
//! decides all but single pixels take, with 1,000 objects and 320 x 180 pixels, about a second at most on
//! two cores. Those in which it does not take longer: spheres that touch in the eye, if all rays are
//! within 1e-15 rad of the plane in which they touch (4 s); spheres that meet in one circle, if a row of
//! pixels lies in the circle's plane (3 s); and planes that coincide, but for less than 1e-15, with a
//! sphere, which must be 1e15 times as large as its distance (9 s), because a plane and a sphere have no
//! such difference.
//!
//! A frame in `f64` is drawn in `f32` to find the objects; then the ladder computes each pixel's `t`
//! (`row_band::fallback::fill_exactly`).
//!
//! [`Counts`](frame::Counts) counts the work that was left out.

pub(crate) mod bvh;
pub(crate) mod edges;
pub(crate) mod frame;
pub(crate) mod outline;
pub(crate) mod plan;
pub(crate) mod polynomial;
pub(crate) mod row_band;
pub(crate) mod rows;
pub(crate) mod shade;

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use fearless_simd::Level;
use glam::DVec3;
use rayon::prelude::*;

use crate::camera::resolved::ResolvedCamera;
use crate::exact::steps::Steps;
use crate::render::frame::{
    Counts, Depth, Finish, Frame, Outputs, OwnBuffers, Raster, empty_frame, or_own, parts,
};
use crate::render::plan::{Plan, SLICE_ROWS};
use crate::render::row_band::RowBand;
use crate::render::row_band::fallback::fill_exactly;
use crate::render::shade::paint::{Paint, Rgb, Shade};
use crate::render::shade::painter::Painter;
use crate::render::shade::{nearest_t, shade_part};
use crate::scene::Scene;

/// Traces the first hit of every pixel of the raster, bands of rows in parallel.
///
/// Each pixel's object is the one that [`Scene::first_hit_of`] finds for the pixel's [exact
/// ray](ResolvedCamera::exact_ray), and its `t` is the exact value, rounded. The result is the same, bit
/// for bit, with any number of threads and on any processor. Terms that the rays share are computed
/// once, only visible objects are examined, and only pixels that are too close to call are decided by
/// [the ladder](crate#the-ladder), in higher precision. A scene without planes runs no plane code.
///
/// For a sequence of frames, use [`retrace`] for all but the first.
pub fn trace(scene: &Scene, camera: &ResolvedCamera, raster: &Raster, outputs: Outputs) -> Frame {
    trace_as(scene, camera, raster, outputs)
}

/// Traces like [`trace`], with `t` in the type T: correctly rounded in `f64`, or within an ulp in `f32`,
/// which takes a fraction of the time.
pub fn trace_as<T: Depth>(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
) -> Frame<T> {
    trace_at_level(Level::new(), scene, camera, raster, outputs, |_| ())
}

/// Traces like [`trace_as`], with the instructions of a given SIMD level, and reports progress: calls
/// `done`, from any thread, with the number of rows just finished. All levels give the same bits.
pub fn trace_at_level<T: Depth>(
    level: Level,
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
    done: impl Fn(usize) + Sync,
) -> Frame<T> {
    let mut frame = empty_frame(camera, raster, outputs);
    T::fill(&mut frame, level, scene, None, &done);
    frame
}

/// Traces and colours in one pass: writes to `pixels` what [`shade`](crate::shade) would return for the
/// frame, and keeps only the requested `outputs`. Each band of rows is coloured as soon as it is traced,
/// while it is still in the cache; only for [`Shade::T`] does colouring wait until the nearest `t` of
/// the whole frame is known.
///
/// # Panics
/// Panics unless `pixels` has one element for each pixel of the raster.
pub fn trace_painted<T: Depth, P: Send>(
    scene: &Scene,
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    pixels: &mut [P],
) -> Frame<T> {
    let needed = match paint.shade {
        Shade::T => Outputs { t: true, object: true, ..outputs },
        _ => outputs,
    };
    let mut frame = empty_frame(camera, raster, needed);
    retrace_painted(&mut frame, scene, camera, paint, pixels);
    if !outputs.t {
        (frame.t, frame.steps_of_t) = (Vec::new(), Steps::default());
    }
    if !outputs.object {
        frame.object = Vec::new();
    }
    frame
}

/// Traces another camera or scene into an existing frame, whose raster is kept, and colours it. The
/// result equals that of [`trace_painted`], but no memory is allocated for it.
///
/// # Panics
/// Panics unless `pixels` has one element for each pixel of the raster, or if the colours are those of
/// [`Shade::T`] and the frame lacks `t` or objects.
pub fn retrace_painted<T: Depth, P: Send>(
    frame: &mut Frame<T>,
    scene: &Scene,
    camera: &ResolvedCamera,
    paint: &Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    pixels: &mut [P],
) {
    let level = Level::new();
    assert_eq!(pixels.len(), frame.raster.len(), "a pixel for each of the raster's");
    frame.camera = *camera;
    if paint.shade == Shade::T {
        let is_whole = frame.t.len() == pixels.len() && frame.object.len() == pixels.len();
        assert!(is_whole, "colours by t need t and objects");
        T::fill(frame, level, scene, None, &|_| ());
        return shade_part(level, frame, scene, paint, nearest_t(frame), pixels);
    }
    let raster = frame.raster.clone();
    let painter = Painter::new(level, paint, scene, camera, &raster, f64::INFINITY);
    let slice = SLICE_ROWS * raster.columns().len().max(1);
    let slices: Vec<Mutex<&mut [P]>> = pixels.chunks_mut(slice).map(Mutex::new).collect();
    let finish = |rows: Range<usize>, t: &[T], object: &[u32]| {
        // Bands are whole slices, so no two threads want the same slice, and no thread waits for a lock.
        let slices = slices[rows.start / SLICE_ROWS..].iter();
        let hits = t.chunks(slice).zip(object.chunks(slice));
        for ((start, (t, object)), pixels) in rows.step_by(SLICE_ROWS).zip(hits).zip(slices) {
            let mut pixels = pixels.lock().unwrap_or_else(PoisonError::into_inner);
            painter.rows(start..start + SLICE_ROWS, t, object, &mut pixels);
        }
    };
    T::fill(frame, level, scene, Some(&finish), &|_| ());
}

/// Traces another camera or scene into an existing frame, whose raster is kept. The result equals that
/// of [`trace_as`], but no memory is allocated for it. For a simple scene, the allocation takes several
/// times as long as everything else.
///
/// ```
/// use pinhole_core::*;
/// let scene = Scene::new(vec![Sphere::new([0.0, 0.0, -5.0], 1.0)?], vec![])?;
/// let at = |x| Camera { eye: DVec3::new(x, 0.0, 0.0), ..Camera::CANONICAL }.resolve();
/// let first = at(0.0)?;
/// let mut frame = trace_as::<f32>(&scene, &first, &Raster::full(first.image()), Outputs::default());
/// for step in 1..4 {
///     retrace(&mut frame, &scene, &at(0.1 * f64::from(step))?);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn retrace<T: Depth>(frame: &mut Frame<T>, scene: &Scene, camera: &ResolvedCamera) {
    retrace_at_level(Level::new(), frame, scene, camera);
}

/// Traces like [`retrace`], with the instructions of a given SIMD level. All levels give the same bits.
pub fn retrace_at_level<T: Depth>(
    level: Level,
    frame: &mut Frame<T>,
    scene: &Scene,
    camera: &ResolvedCamera,
) {
    frame.camera = *camera;
    T::fill(frame, level, scene, None, &|_| ());
}

/// Traces the frame band by band, into those of its buffers that are not empty. Calls `finish` for each
/// band while it is still in the cache.
pub(crate) fn fill<T: Depth>(
    frame: &mut Frame<T>,
    level: Level,
    scene: &Scene,
    finish: Option<Finish<'_, T>>,
    done: &(dyn Fn(usize) + Sync),
) {
    let Frame { camera, raster, t, object, normal, steps, counts, steps_of_t } = frame;
    if raster.is_empty() {
        return;
    }
    let plan = Plan::new(level, scene, camera, raster);
    let is_quick = T::IS_DRAWN && plan.is_quick && finish.is_none() && normal.is_empty();
    let (width, bands, keeps_t) = (raster.columns().len(), plan.bands(), !t.is_empty());
    let parts_of_t = parts(t, &bands, width).into_iter().zip(parts(object, &bands, width));
    let buffers = parts_of_t.zip(parts(normal, &bands, width));
    type Buffers<'a, T> = ((&'a mut [T], &'a mut [u32]), &'a mut [DVec3]);
    let draw = |own: &mut OwnBuffers<T>,
                (rows, ((t, object), normal)): (Range<usize>, Buffers<T>)| {
        let needs_t = !t.is_empty() || finish.is_some();
        let t = or_own(t, &mut own.t, rows.len() * width, T::ZERO);
        let object = or_own(object, &mut own.object, rows.len() * width, 0);
        let mut band = RowBand::new(&plan, rows.clone(), T::drawn(t, &mut own.drawn), object);
        band.draw_large();
        while band.draw_rows() {
            band.resolve_doubt();
        }
        band.draw_others();
        let (steps, left_out, untouched) = band.counted();
        let found = if needs_t { T::found(t) } else { &mut [] };
        let of_t = fill_exactly(&plan, rows.clone(), object, found, normal);
        let of_t = if keeps_t { of_t } else { Steps::default() };
        if let Some(finish) = finish {
            finish(rows.clone(), t, object);
        }
        done(rows.len());
        (steps, of_t, left_out, untouched)
    };
    let bands = bands.into_iter().zip(buffers);
    let new_buffers = || OwnBuffers { t: Vec::new(), object: Vec::new(), drawn: Vec::new() };
    let (left_out, rows_untouched);
    (*steps, *steps_of_t, left_out, rows_untouched) = if is_quick {
        let mut own = new_buffers();
        bands.map(|band| draw(&mut own, band)).fold(Default::default(), sums)
    } else {
        // A thread takes the next band when it has finished one.
        bands.par_bridge().map_init(new_buffers, draw).reduce(Default::default, sums)
    };
    *counts = Counts {
        spheres: scene.spheres().len() as u64,
        spheres_left_out: plan.left_out + left_out,
        rows: raster.rows().len() as u64,
        rows_untouched,
    };
}

/// The counts of a band: decisions by step, values of `t` by step, spheres left out, and rows that no
/// outline reaches.
type Counted = (Steps, Steps, u64, u64);

fn sums(a: Counted, b: Counted) -> Counted {
    (a.0 + b.0, a.1 + b.1, a.2 + b.2, a.3 + b.3)
}
