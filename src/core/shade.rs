//! From hits to colours.

use std::sync::LazyLock;

use glam::DVec3;
use rayon::prelude::*;

use crate::depth::Depth;
use crate::frame::{Frame, NO_OBJECT};
use crate::normals::Normals;
use crate::ray::Ray;
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
pub fn shade<T: Depth, P: Send>(
    frame: &Frame<T>,
    scene: &Scene,
    shade: Shade,
    color_of: impl Fn(u32) -> Rgb + Sync,
    to_pixel: impl Fn(Rgb) -> P + Sync,
) -> Vec<P> {
    let nearest = match shade {
        Shade::T => {
            let all = frame.t.par_iter().map(|t| t.widened());
            all.reduce(|| f64::INFINITY, f64::min)
        }
        _ => f64::INFINITY,
    };
    let (camera, raster) = (frame.camera(), frame.raster());
    let column_parts: Vec<DVec3> =
        raster.columns().iter().map(|c| camera.column_part(camera.u_of_column(*c))).collect();
    let row_parts: Vec<DVec3> =
        raster.rows().iter().map(|r| camera.row_part(camera.v_of_row(*r))).collect();
    let shader = Shader::new(scene, shade, nearest);
    // A frame has at most 2^28 pixels; dividing u32 takes half the time of usize.
    let width = column_parts.len() as u32;
    (0..frame.t.len() as u32)
        .into_par_iter()
        .with_min_len(4096)
        .map(|index| {
            let (row, column) = ((index / width) as usize, (index % width) as usize);
            let index = index as usize;
            let object = frame.object[index];
            if object == NO_OBJECT {
                return to_pixel(BACKGROUND);
            }
            let direction = column_parts[column] + row_parts[row];
            let ray = Ray { origin: camera.eye(), direction };
            to_pixel(shader.color(&ray, object, frame.t[index].widened(), &color_of))
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
    let shader = Shader::new(scene, shade, nearest);
    match scene.first_hit(ray) {
        None => BACKGROUND,
        Some(hit) => shader.color(ray, hit.object, hit.t, &color_of),
    }
}

/// What the pixels of a picture share.
struct Shader<'a> {
    shade: Shade,
    nearest: f64,
    normals: Normals<'a>,
    srgb: &'static Srgb,
}

impl<'a> Shader<'a> {
    fn new(scene: &'a Scene, shade: Shade, nearest: f64) -> Self {
        Shader { shade, nearest, normals: Normals::new(scene), srgb: &SRGB }
    }

    #[inline(always)]
    fn color(&self, ray: &Ray, object: u32, t: f64, color_of: &impl Fn(u32) -> Rgb) -> Rgb {
        match self.shade {
            Shade::Object => color_of(object),
            Shade::T => [rounded(255.0 * (self.nearest / t)); 3],
            Shade::Normal => {
                let n = self.normals.at(object, ray, t);
                [n.x, n.y, n.z].map(|x| rounded(127.5 * (x + 1.0)))
            }
            Shade::Lambert => {
                let light = 0.15 + 0.85 * self.normals.cosine(object, ray, t).min(1.0);
                let [r, g, b] = color_of(object);
                [r, g, b].map(|byte| self.srgb.dimmed(byte, light as f32))
            }
        }
    }
}

/// To the nearest byte; `x` is not negative.
fn rounded(x: f64) -> u8 {
    (x + 0.5) as u8
}

/// Tables of the sRGB transfer curve (IEC 61966-2-1).
struct Srgb {
    /// Byte to linear light.
    linear: [f32; 256],
    /// From linear light in parts of 1 to the byte nearest in linear light. Where the curve is
    /// steepest, at 0, a byte has 20 parts.
    bytes: Vec<u8>,
}

static SRGB: LazyLock<Srgb> = LazyLock::new(Srgb::new);

impl Srgb {
    const PARTS: usize = 1 << 16;

    fn new() -> Srgb {
        let linear: [f32; 256] = std::array::from_fn(|byte| {
            let s = byte as f32 / 255.0;
            if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
        });
        let half_way: Vec<f32> = linear.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let byte_of = |light: f32| half_way.partition_point(|end| *end <= light) as u8;
        let bytes = (0..=Srgb::PARTS).map(|part| byte_of(part as f32 / Srgb::PARTS as f32));
        Srgb { linear, bytes: bytes.collect() }
    }

    /// The byte's light times `factor`, from 0 to 1, as a byte.
    #[inline(always)]
    fn dimmed(&self, byte: u8, factor: f32) -> u8 {
        let light = factor * self.linear[usize::from(byte)];
        self.bytes[((light * Srgb::PARTS as f32 + 0.5) as usize).min(Srgb::PARTS)]
    }
}
