//! The light of the world view. A camera's own picture is lit from its eye, so a ball is brightest in
//! its middle and looks flat; the observer's is lit from above the observer's left shoulder, as in a
//! printed figure. Light goes round a ball and through others: there is no shadow, since no ray to
//! the light is traced.

use egui::Color32;
use pinhole_core::{DVec3, Frame, NO_OBJECT, Pixel, ResolvedCamera, Rgb, Scene, lambert};
use rayon::prelude::*;

use super::opaque;

/// Direction of the light, in the observer's u, v, w.
const TOWARD: DVec3 = DVec3::new(-0.45, 0.65, 0.61);

/// Share of the light that comes from the observer's eye.
const FROM_EYE: f64 = 0.3;

/// Paints the spheres of a frame; all other pixels stay.
pub(super) fn paint(
    frame: &Frame<f32>,
    scene: &Scene,
    color_of: impl Fn(u32) -> Rgb + Sync,
    pixels: &mut [Color32],
) {
    let (camera, raster) = (frame.camera(), frame.raster());
    let width = raster.columns().len();
    if width == 0 || pixels.len() != frame.t.len() || frame.object.len() != frame.t.len() {
        return;
    }
    let toward = camera.basis().to_world_from_camera(TOWARD).normalize();
    pixels.par_chunks_mut(width).enumerate().for_each(|(index, pixels)| {
        let part = index * width..(index + 1) * width;
        let seen = frame.object[part.clone()].iter().zip(&frame.t[part]).zip(raster.columns());
        for (pixel, ((object, t), column)) in pixels.iter_mut().zip(seen) {
            if *object == NO_OBJECT {
                continue;
            }
            let position = Pixel { row: raster.rows()[index], column: *column };
            if let Some(sphere) = scene.spheres().get(*object as usize) {
                let light = light_on(camera, position, f64::from(*t), sphere.center, toward);
                *pixel = opaque(lambert(color_of(*object), light));
            }
        }
    });
}

/// Returns the light, 0 to 1, where a pixel's ray meets a sphere at `t`.
fn light_on(camera: &ResolvedCamera, pixel: Pixel, t: f64, center: DVec3, toward: DVec3) -> f64 {
    let ray = camera.ray_of_pixel(pixel);
    let out = (ray.at(t) - center).normalize_or_zero();
    let facing = -out.dot(ray.direction.normalize_or_zero());
    // From inside, the other side of the surface is seen.
    let wrapped = 0.5 + 0.5 * facing.signum() * out.dot(toward);
    (FROM_EYE * facing.abs() + (1.0 - FROM_EYE) * wrapped).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use pinhole_core::{Camera, Outputs, Raster, Sphere, trace_as};

    use super::*;

    #[test]
    fn a_ball_is_lighter_above_on_the_left_and_nowhere_black() {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.5 };
        let scene = Scene::new(vec![ball], vec![]).expect("a scene");
        let camera = Camera::CANONICAL.resolve().expect("a camera");
        let raster = Raster::full(camera.image());
        let frame = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
        let mut pixels = vec![Color32::BLACK; raster.len()];
        paint(&frame, &scene, |_| [200; 3], &mut pixels);
        let at = |u: f64, v: f64| {
            let (row, column) = ((0.5 - v) * 400.0, (0.5 + u) * 400.0);
            pixels[row as usize * 400 + column as usize].r()
        };
        assert!(at(-0.12, 0.15) > at(0.0, 0.0) && at(0.0, 0.0) > at(0.15, -0.18));
        assert!(at(0.15, -0.18) > 60);
        assert_eq!(at(0.45, 0.45), 0, "beside it");
    }
}
