//! Smooth edges: how much of each pixel at the border between two objects belongs to either of them.
//!
//! A frame has one object per pixel, the one at its centre, so borders look like stairs. The outline of a
//! sphere is known exactly: it is the conic where the discriminant of the sphere's quadratic is zero, and
//! the discriminant divided by its gradient is the distance to it. So the covered fraction of a pixel needs
//! no further rays, and only pixels with a neighbour that shows another object are examined.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use crate::camera::resolved::PixelRays;
use crate::render::frame::{Frame, NO_OBJECT};
use crate::scene::Scene;
use crate::scene::sphere::Sphere;

/// A pixel at a border: a fraction `1 - share` of it shows what its neighbour `from` shows.
///
/// If several objects meet in a pixel, it has several blends, which follow one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeBlend {
    /// Index of the pixel in the frame.
    pub pixel: u32,
    /// Index of the neighbour.
    pub from: u32,
    /// Fraction of the pixel that its own object covers, from 0.5 to 1.
    pub share: f32,
}

/// Number of rows that one thread examines at a time.
const BAND: usize = 64;

/// Number of pixels of a row that are compared with one another at a time.
const CHUNK: usize = 32;

/// Finds the borders between objects in a frame, and how much of each pixel there belongs to either side.
/// Blends are in the order of their pixels. The borders of planes stay as they are: the world view draws
/// planes as layers. Returns no blends unless the frame has an object for every pixel of the image.
pub fn edge_blends<T: Sync>(frame: &Frame<T>, scene: &Scene) -> Vec<EdgeBlend> {
    let image = frame.camera.image();
    let (width, height) = (image.width() as usize, image.height() as usize);
    if frame.object.len() != width * height || frame.raster.len() != frame.object.len() {
        return Vec::new();
    }
    let borders =
        Borders { rays: frame.camera.pixel_rays(), scene, object: &frame.object, width, height };
    let bands = (0..height).into_par_iter().step_by(BAND);
    bands.map(|top| borders.band(top..height.min(top + BAND))).collect::<Vec<_>>().concat()
}

/// A sphere as a camera sees it. The vector from the eye to its centre is in units of the radius, so that
/// its square does not overflow.
struct Ball {
    to_center: DVec3,
    /// Square of the tangent's length from the eye to the sphere.
    tangent: f64,
    radius: f64,
}

impl Ball {
    fn new(eye: DVec3, sphere: &Sphere) -> Ball {
        let to_center = (sphere.center - eye) / sphere.radius;
        Ball { to_center, tangent: to_center.length_squared() - 1.0, radius: sphere.radius }
    }

    /// Returns the discriminant of the quadratic for a ray; it is negative if the ray misses.
    fn discriminant(&self, direction: DVec3) -> f64 {
        let along = direction.dot(self.to_center);
        along * along - direction.length_squared() * self.tangent
    }

    /// Returns true if the eye is inside the sphere, where each ray hits it from within.
    fn is_inside(&self) -> bool {
        self.tangent < 0.0
    }

    fn is_hit(&self, direction: DVec3) -> bool {
        let is_ahead = self.is_inside() || direction.dot(self.to_center) > 0.0;
        self.discriminant(direction) >= 0.0 && is_ahead
    }

    /// Returns the t of the hit, or of the point nearest to the sphere's centre if the ray misses.
    fn t(&self, direction: DVec3) -> f64 {
        let root = self.discriminant(direction).max(0.0).sqrt();
        let root = if self.is_inside() { -root } else { root };
        self.radius * (direction.dot(self.to_center) - root) / direction.length_squared()
    }

    /// Returns the fraction of a pixel that lies inside the outline. `direction` is that of the ray through
    /// the pixel's centre.
    fn covered(&self, rays: &PixelRays, direction: DVec3) -> f64 {
        let along = direction.dot(self.to_center);
        let slope = |step: DVec3| {
            2.0 * (along * step.dot(self.to_center) - direction.dot(step) * self.tangent)
        };
        covered(self.discriminant(direction), [slope(rays.across), slope(rays.down)])
    }
}

/// Returns the fraction of a pixel where a function is positive, from 0 to 1. `value` is the function's value at the
/// pixel's centre, and (x, y) its change per pixel; near a border, its zero is as good as a straight line.
fn covered(value: f64, [x, y]: [f64; 2]) -> f64 {
    let length = (x * x + y * y).sqrt();
    let (distance, most, least) =
        (value.abs() / length, x.abs().max(y.abs()) / length, x.abs().min(y.abs()) / length);
    // The line cuts off a triangle at one corner, or a trapezium.
    let corner = 0.5 * (most + least) - distance;
    let beyond = if distance < 0.5 * (most - least) {
        0.5 - distance / most
    } else {
        0.5 * corner.max(0.0).powi(2) / (most * least).max(f64::MIN_POSITIVE)
    };
    if value > 0.0 { 1.0 - beyond } else { beyond }
}

/// The objects of a frame, and what is needed to find the borders between them.
struct Borders<'a> {
    rays: PixelRays,
    scene: &'a Scene,
    object: &'a [u32],
    width: usize,
    height: usize,
}

impl Borders<'_> {
    /// Finds the blends of a band of rows.
    fn band(&self, rows: Range<usize>) -> Vec<EdgeBlend> {
        let mut found = Vec::new();
        let chunks = |row: usize| self.chunks(row.min(self.height - 1));
        let (mut above, mut own) = (chunks(rows.start.saturating_sub(1)), chunks(rows.start));
        for row in rows {
            let below = chunks(row + 1);
            let objects = self.line(row);
            for (chunk, only) in own.iter().enumerate() {
                let columns = chunk * CHUNK..((chunk + 1) * CHUNK).min(self.width);
                let left = objects[columns.start.saturating_sub(1)];
                let right = objects[columns.end.min(self.width - 1)];
                // Most chunks show one object only, and so do those above and below.
                let is_plain = *only == Some(left)
                    && *only == Some(right)
                    && *only == above[chunk]
                    && *only == below[chunk];
                if !is_plain {
                    columns.for_each(|column| self.pixel(row, column, &mut found));
                }
            }
            (above, own) = (own, below);
        }
        found
    }

    /// Returns the object of each chunk of a row, or `None` if a chunk shows several.
    fn chunks(&self, row: usize) -> Vec<Option<u32>> {
        let only = |chunk: &[u32]| {
            // Without an early exit, the compiler compares several pixels at a time.
            let differences = chunk.iter().fold(0, |bits, object| bits | (object ^ chunk[0]));
            (differences == 0).then_some(chunk[0])
        };
        self.line(row).chunks(CHUNK).map(only).collect()
    }

    fn line(&self, row: usize) -> &[u32] {
        &self.object[row * self.width..][..self.width]
    }

    /// Adds the blends of a pixel, at most one for each other object that its neighbours show.
    fn pixel(&self, row: usize, column: usize, found: &mut Vec<EdgeBlend>) {
        let pixel = row * self.width + column;
        let own = self.object[pixel];
        let neighbours = [
            (pixel - usize::from(column > 0), [-1.0, 0.0]),
            (pixel + usize::from(column + 1 < self.width), [1.0, 0.0]),
            (if row > 0 { pixel - self.width } else { pixel }, [0.0, -1.0]),
            (if row + 1 < self.height { pixel + self.width } else { pixel }, [0.0, 1.0]),
        ];
        if neighbours.iter().all(|(from, _)| self.object[*from] == own) {
            return;
        }
        let first = found.len();
        let mut has_outline = false;
        for (from, step) in neighbours {
            let other = self.object[from];
            let is_known =
                found[first..].iter().any(|known| self.object[known.from as usize] == other);
            if other == own || is_known {
                continue;
            }
            let at = [column as f64 + 0.5, row as f64 + 0.5];
            let Some((share, is_own)) = self.share(at, step, [own, other]) else { continue };
            // The outline of the pixel's own object counts once, whatever lies behind it.
            if share < 1.0 && !(is_own && has_outline) {
                let share = share.max(0.5) as f32;
                found.push(EdgeBlend { pixel: pixel as u32, from: from as u32, share });
            }
            has_outline |= is_own;
        }
    }

    fn ball(&self, object: u32) -> Option<Ball> {
        let sphere = self.scene.spheres().get(object as usize)?;
        Some(Ball::new(self.rays.eye, sphere))
    }

    /// Returns the fraction of a pixel on its own side of the border to a neighbour, and whether this border
    /// is the outline of its own object. `at` is the pixel's centre, and `step` leads to the neighbour.
    /// Returns `None` if a plane is involved.
    fn share(
        &self,
        [x, y]: [f64; 2],
        [dx, dy]: [f64; 2],
        [own, other]: [u32; 2],
    ) -> Option<(f64, bool)> {
        let PixelRays { across, down, corner, .. } = self.rays;
        let here = x * across + y * down + corner;
        let there = here + dx * across + dy * down;
        let of_own = |ball: &Ball| (ball.covered(&self.rays, here), true);
        let of_other = |ball: &Ball| (1.0 - ball.covered(&self.rays, here), false);
        let (near, far) = match (own, other) {
            (_, NO_OBJECT) => return Some(of_own(&self.ball(own)?)),
            (NO_OBJECT, _) => return Some(of_other(&self.ball(other)?)),
            _ => (self.ball(own)?, self.ball(other)?),
        };
        let is_outline_of_own = match (near.is_hit(there), far.is_hit(here)) {
            (true, true) => {
                // The two spheres cut into each other.
                let gap = |direction: DVec3| far.t(direction) - near.t(direction);
                let slope = |step: DVec3| gap(here + step) - gap(here);
                return Some((covered(gap(here), [slope(across), slope(down)]), false));
            }
            (false, true) => true,
            (true, false) => false,
            (false, false) => near.t(here) <= far.t(here),
        };
        Some(if is_outline_of_own { of_own(&near) } else { of_other(&far) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, ImageSize, Outputs, Raster, trace_as};

    const SIZE: u32 = 120;
    /// Rays per pixel, along each axis, of the pictures that are compared with.
    const FINE: u32 = 16;

    fn traced(scene: &Scene, size: u32) -> Frame<f32> {
        let image = ImageSize::new(size, size).expect("a size");
        let camera = Camera { image, ..Camera::CANONICAL }.resolve().expect("a camera");
        trace_as(scene, &camera, &Raster::full(image), Outputs::default())
    }

    /// The colour of an object, far from that of the others, and exact in sums.
    fn grey(object: u32) -> f32 {
        [0.0, 1.0, 0.5][object.wrapping_add(1) as usize]
    }

    /// Returns the mean and the largest error of a picture at the pixels of borders, before and after they
    /// are blended. The correct picture has [`FINE`] x [`FINE`] rays per pixel.
    fn errors(spheres: &[([f64; 3], f64)]) -> [[f32; 2]; 2] {
        let spheres = spheres.iter().map(|(center, radius)| Sphere::new(*center, *radius));
        let scene = Scene::new(spheres.collect::<Result<_, _>>().expect("spheres"), vec![]);
        let scene = scene.expect("a scene");
        let (rough, fine) = (traced(&scene, SIZE), traced(&scene, SIZE * FINE));
        let (width, step) = (SIZE as usize, FINE as usize);
        let mean = |pixel: usize| {
            let (row, column) = (pixel / width * step, pixel % width * step);
            let row = |k: usize| &fine.object[(row + k) * width * step + column..][..step];
            let all = (0..step).flat_map(row).map(|object| grey(*object));
            all.sum::<f32>() / (step * step) as f32
        };
        let before: Vec<f32> = rough.object.iter().map(|object| grey(*object)).collect();
        let mut after = before.clone();
        for EdgeBlend { pixel, from, share } in edge_blends(&rough, &scene) {
            let own = &mut after[pixel as usize];
            *own = share * *own + (1.0 - share) * before[from as usize];
        }
        let wanted: Vec<f32> = (0..before.len()).map(mean).collect();
        let of = |picture: &[f32]| {
            let cut = wanted.iter().zip(&before).zip(picture).filter(|((w, b), _)| w != b);
            let errors: Vec<f32> = cut.map(|((wanted, _), own)| (wanted - own).abs()).collect();
            assert!(errors.len() > 100, "borders");
            let largest = errors.iter().copied().fold(0.0, f32::max);
            [errors.iter().sum::<f32>() / errors.len() as f32, largest]
        };
        [of(&before), of(&after)]
    }

    #[test]
    fn blended_borders_agree_with_many_rays_per_pixel() {
        let alone = vec![([0.3, 0.2, -5.0], 1.1)];
        let behind_one_another = vec![([0.3, 0.2, -5.0], 1.1), ([-0.6, 0.1, -6.0], 1.2)];
        let cutting = vec![([0.4, 0.2, -5.0], 1.1), ([-0.4, 0.0, -5.2], 1.2)];
        let around_the_eye = vec![([0.3, 0.2, -5.0], 1.1), ([0.5, 0.0, 3.0], 12.0)];
        let cases = [alone, behind_one_another, cutting, around_the_eye];
        let off_axis = vec![([2.0, 1.8, -4.6], 0.9), ([-0.9, -1.9, -5.0], 0.8)];
        for spheres in cases.into_iter().chain([off_axis]) {
            let [before, after] = errors(&spheres);
            assert!(before[0] > 0.1, "{spheres:?}: {before:?}");
            assert!(after[0] < 0.05 * before[0], "{spheres:?}: {before:?} {after:?}");
            assert!(after[1] < 0.5 * before[1], "{spheres:?}: {before:?} {after:?}");
        }
    }

    #[test]
    fn what_has_no_outline_has_no_blends() {
        let around = Sphere::new([0.0, 0.0, 0.0], 3.0).expect("a sphere");
        let scene = Scene::new(vec![around], vec![]).expect("a scene");
        let frame = traced(&scene, SIZE);
        assert!(frame.object.iter().all(|object| *object == 0));
        assert_eq!(edge_blends(&frame, &scene), []);
        let image = frame.camera().image();
        let part = Raster::shown_on(image, 7, 5);
        let rough = trace_as::<f32>(&scene, frame.camera(), &part, Outputs::default());
        assert_eq!(edge_blends(&rough, &scene), []);
    }
}
