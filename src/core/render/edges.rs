//! Smooth edges: how much of each pixel at the border between two objects belongs to either of them.
//!
//! A frame has one object per pixel, the one at its centre, so borders look like stairs. The outline of a
//! sphere is known exactly: it is the conic where the discriminant of the sphere's quadratic is zero, and
//! the discriminant divided by its gradient is the distance to it. So the covered fraction of a pixel needs
//! no further rays, and only pixels with a neighbour that shows another object are examined.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use glam::{DMat2, DVec2, DVec3};
use rayon::prelude::*;

use crate::camera::resolved::{PixelRays, ResolvedCamera};
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

/// The outline of a sphere in a camera's picture. Positions are in pixels from the picture's top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// The centre, which is not the projection of the sphere's centre.
    pub center: DVec2,
    /// The semi-axes, which are orthogonal to each other.
    pub axes: [DVec2; 2],
}

impl Ellipse {
    /// Returns the outline of a sphere; `None` unless all of the sphere is in front of the eye, where the
    /// outline is an ellipse.
    ///
    /// Inside it, the discriminant of the sphere's quadratic is positive: a quadratic form M of (x, y, 1).
    pub fn outline_of(camera: &ResolvedCamera, sphere: &Sphere) -> Option<Ellipse> {
        let (rays, ball) = (camera.pixel_rays(), Ball::new(camera.eye(), sphere));
        if ball.is_inside() || -ball.to_center.dot(camera.basis().w) <= 1.0 {
            return None;
        }
        let m = |a: DVec3, b: DVec3| {
            a.dot(ball.to_center) * b.dot(ball.to_center) - ball.tangent * a.dot(b)
        };
        let PixelRays { across, down, corner, .. } = rays;
        let slopes = DVec2::new(m(across, corner), m(down, corner));
        let [xx, xy, yy] = [m(across, across), m(across, down), m(down, down)];
        let form = DMat2::from_cols(DVec2::new(xx, xy), DVec2::new(xy, yy));
        let center = -(form.inverse() * slopes);
        let most = m(corner, corner) + slopes.dot(center);
        // The eigenvalues of M, and the angle of the first one's eigenvector.
        let (middle, apart) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        let axis = |value: f64, angle: f64| (-most / value).sqrt() * DVec2::from_angle(angle);
        let axes = [axis(middle + apart, angle), axis(middle - apart, angle + FRAC_PI_2)];
        let ellipse = Ellipse { center, axes };
        (center.is_finite() && axes.iter().all(|axis| axis.is_finite())).then_some(ellipse)
    }

    /// Returns the indices and centres of the pixels of a picture of this size that are at most `margin`
    /// pixels outside the rectangle around the outline.
    pub fn pixels(
        &self,
        [width, height]: [usize; 2],
        margin: f64,
    ) -> impl Iterator<Item = (usize, DVec2)> + use<> {
        let [a, b] = self.axes.map(|axis| axis * axis);
        let half = DVec2::new((a.x + b.x).sqrt(), (a.y + b.y).sqrt()) + margin;
        let (least, most) = (self.center - half, (self.center + half).ceil());
        let columns = (least.x as usize)..(most.x as usize).min(width);
        let rows = (least.y as usize)..(most.y as usize).min(height);
        let center = |k: usize| k as f64 + 0.5;
        rows.flat_map(move |row| {
            let pixel =
                move |column| (row * width + column, DVec2::new(center(column), center(row)));
            columns.clone().map(pixel)
        })
    }

    /// Returns, near the outline, the distance of a point from it, negative inside, and the direction
    /// outwards.
    pub fn distance(&self, at: DVec2) -> (f64, DVec2) {
        let from_center = at - self.center;
        let scaled = self.axes.map(|axis| axis / axis.length_squared());
        let along = scaled.map(|axis| axis.dot(from_center));
        let reach = along[0].hypot(along[1]);
        let slope = (along[0] * scaled[0] + along[1] * scaled[1]) / reach;
        ((reach - 1.0) / slope.length(), slope.normalize_or_zero())
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
    fn an_outline_is_where_the_pixels_of_a_finer_picture_end() {
        let (size, times) = (4 * SIZE as usize, 4.0);
        for (center, radius) in [([0.3, 0.2, -5.0], 1.1), ([1.3, 1.4, -4.6], 0.5)] {
            let ball = Sphere::new(center, radius).expect("a sphere");
            let scene = Scene::new(vec![ball], vec![]).expect("a scene");
            let outline = Ellipse::outline_of(traced(&scene, SIZE).camera(), &ball);
            let outline = outline.expect("a ball ahead");
            let [a, b] = outline.axes.map(|axis| times * axis);
            let outline = Ellipse { center: times * outline.center, axes: [a, b] };
            assert!(a.dot(b).abs() < 1e-9 * a.length_squared());
            let fine = traced(&scene, 4 * SIZE);
            let mut count = 0;
            for (pixel, at) in outline.pixels([size, size], 3.0) {
                let (distance, _) = outline.distance(at);
                count += usize::from(fine.object[pixel] == 0);
                let is_told = (fine.object[pixel] == 0) == (distance < 0.0);
                assert!(is_told || distance.abs() < 1e-6, "{at} {distance}");
            }
            let all = fine.object.iter().filter(|object| **object == 0).count();
            assert_eq!(count, all, "none is outside the rectangle around it");
        }
        let camera = Camera::CANONICAL.resolve().expect("a camera");
        for center in [[0.0, 0.0, 0.5], [0.0, 0.0, 4.0], [3.0, 0.0, -0.5]] {
            let ball = Sphere::new(center, 1.0).expect("a sphere");
            assert_eq!(Ellipse::outline_of(&camera, &ball), None, "{center:?}");
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
