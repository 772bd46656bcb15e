//! From hits to colours.

use std::sync::LazyLock;

use glam::DVec3;
use rayon::prelude::*;

use crate::frame::{Frame, NO_OBJECT};
use crate::ray::Ray;
use crate::scale::unit;
use crate::scene::Scene;

/// sRGB bytes.
pub type Rgb = [u8; 3];

/// The colour of a pixel whose ray hits nothing.
pub const BACKGROUND: Rgb = [0xc9, 0xd3, 0xdf];

/// How a hit becomes a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shade {
    /// Lit from the eye: the object's colour times `0.15 + 0.85 |n.d| / |d|`, in linear light.
    #[default]
    Lambert,
    /// The outward normal's x, y, z, from -1..1 to red, green, blue 0..255.
    Normal,
    /// Grey, `t_min / t` of the frame: the nearest hit is white.
    T,
    /// The object's colour, flat.
    Object,
}

impl Shade {
    /// All of them.
    pub const ALL: [Shade; 4] = [Shade::Lambert, Shade::Normal, Shade::T, Shade::Object];

    /// `lambert`, `normal`, `t`, `object`.
    pub fn name(self) -> &'static str {
        match self {
            Shade::Lambert => "lambert",
            Shade::Normal => "normal",
            Shade::T => "t",
            Shade::Object => "object",
        }
    }
}

/// The colours of a frame, row by row, in the pixel form that `to_pixel` makes; rows in parallel.
///
/// `color_of` gives each object's own colour. The frame must be one of the scene.
pub fn shade<P: Send>(
    frame: &Frame,
    scene: &Scene,
    shade: Shade,
    color_of: impl Fn(u32) -> Rgb + Sync,
    to_pixel: impl Fn(Rgb) -> P + Sync,
) -> Vec<P> {
    let nearest = match shade {
        Shade::T => frame.t.par_iter().copied().reduce(|| f64::INFINITY, f64::min),
        _ => f64::INFINITY,
    };
    let (camera, raster) = (frame.camera(), frame.raster());
    let column_parts: Vec<DVec3> =
        raster.columns().iter().map(|c| camera.column_part(camera.u_of_column(*c))).collect();
    let row_parts: Vec<DVec3> =
        raster.rows().iter().map(|r| camera.row_part(camera.v_of_row(*r))).collect();
    let width = column_parts.len();
    (0..frame.t.len())
        .into_par_iter()
        .with_min_len(4096)
        .map(|index| {
            let object = frame.object[index];
            if object == NO_OBJECT {
                return to_pixel(BACKGROUND);
            }
            let direction = column_parts[index % width] + row_parts[index / width];
            let ray = Ray { origin: camera.eye(), direction };
            to_pixel(shade_hit(scene, shade, &ray, object, frame.t[index], nearest, &color_of))
        })
        .collect()
}

/// The colour of one ray's first hit. `nearest` is the `t` that [`Shade::T`] shows white.
pub fn shade_pixel(
    scene: &Scene,
    shade: Shade,
    ray: &Ray,
    nearest: f64,
    color_of: impl Fn(u32) -> Rgb,
) -> Rgb {
    match scene.first_hit(ray) {
        None => BACKGROUND,
        Some(hit) => shade_hit(scene, shade, ray, hit.object, hit.t, nearest, &color_of),
    }
}

fn shade_hit(
    scene: &Scene,
    shade: Shade,
    ray: &Ray,
    object: u32,
    t: f64,
    nearest: f64,
    color_of: &impl Fn(u32) -> Rgb,
) -> Rgb {
    let normal = || scene.object(object).map_or(DVec3::ZERO, |o| o.normal(ray, t));
    match shade {
        Shade::Object => color_of(object),
        Shade::T => [(255.0 * (nearest / t)).round() as u8; 3],
        Shade::Normal => {
            let n = normal();
            [n.x, n.y, n.z].map(|x| (127.5 * (x + 1.0)).round() as u8)
        }
        Shade::Lambert => {
            let cosine = normal().dot(unit(ray.direction)).abs();
            let light = 0.15 + 0.85 * cosine.min(1.0);
            color_of(object).map(|byte| srgb_byte(light as f32 * LINEAR[usize::from(byte)]))
        }
    }
}

/// sRGB byte to linear light (IEC 61966-2-1).
static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| {
        let s = byte as f32 / 255.0;
        if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
    })
});

/// The linear light above which each sRGB byte begins: half way between it and the byte below. One
/// more stands at the end, which nothing reaches.
static BYTE_STARTS: LazyLock<[f32; 257]> = LazyLock::new(|| {
    std::array::from_fn(|b| match b {
        0 => 0.0,
        256 => f32::INFINITY,
        _ => 0.5 * (LINEAR[b] + LINEAR[b - 1]),
    })
});

/// In how many parts [`BYTE_OF_PART`] cuts linear light from 0 to 1: so many that no part holds the
/// start of two bytes (sRGB is steepest at 0, 12.92 * 255 bytes for 1).
const PARTS: usize = 4096;

/// The byte at the lower end of each part.
static BYTE_OF_PART: LazyLock<[u8; PARTS + 1]> = LazyLock::new(|| {
    std::array::from_fn(|part| {
        let linear = part as f32 / PARTS as f32;
        (BYTE_STARTS.partition_point(|start| *start <= linear) - 1) as u8
    })
});

/// The sRGB byte nearest in linear light, which is in `[0, 1]`.
fn srgb_byte(linear: f32) -> u8 {
    let byte = BYTE_OF_PART[((linear * PARTS as f32) as usize).min(PARTS)];
    byte + u8::from(linear >= BYTE_STARTS[usize::from(byte) + 1])
}
