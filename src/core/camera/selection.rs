//! The selected ray of a camera.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::camera::ray::{ExactRay, RayError};
use crate::camera::resolved::{PixelOfUv, ResolvedCamera};
use crate::camera::viewport::{ImageSize, Pixel, Viewport};

/// The selected view ray, given by a pixel or by a position (u, v) in the viewport.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Selection {
    /// The ray through a pixel's centre.
    Pixel(Pixel),
    /// The ray through a position in the viewport.
    Uv(DVec2),
}

impl Default for Selection {
    /// Returns (u, v) = (0.2, -0.1), the ray of the lecture's warm-up.
    fn default() -> Self {
        Selection::Uv(DVec2::new(0.2, -0.1))
    }
}

impl Selection {
    /// Returns a whole number by which the ray's direction is multiplied to avoid divisions: for a pixel
    /// `2 W H`, a common multiple of the denominators of u and v; 1 if (u, v) itself is given.
    pub(crate) fn stretch(self, image: ImageSize) -> f64 {
        match self {
            Selection::Pixel(_) => 2.0 * f64::from(image.width()) * f64::from(image.height()),
            Selection::Uv(_) => 1.0,
        }
    }

    /// Returns the position at which the selected ray passes through the viewport.
    pub fn uv(self, camera: &ResolvedCamera) -> DVec2 {
        match self {
            Selection::Pixel(pixel) => camera.uv_of_pixel(pixel),
            Selection::Uv(uv) => uv,
        }
    }

    /// Returns the selected pixel, moved back into the image if necessary, or the pixel in which the
    /// selected (u, v) lies. Returns `None` if that (u, v) is outside the image.
    pub fn pixel(self, camera: &ResolvedCamera) -> Option<Pixel> {
        match self.inside(camera.image()) {
            Selection::Pixel(pixel) => Some(pixel),
            Selection::Uv(uv) => camera.pixel_of_uv(uv).map(|position| position.pixel),
        }
    }

    /// Returns the selected view ray without rounding. A pixel must lie [inside](Selection::inside)
    /// the image.
    ///
    /// # Errors
    /// Returns the errors of [`ResolvedCamera::exact_ray_at`].
    pub fn exact_ray(self, camera: &ResolvedCamera) -> Result<ExactRay<'_>, RayError> {
        match self {
            Selection::Pixel(pixel) => Ok(camera.exact_ray(pixel)),
            Selection::Uv(uv) => camera.exact_ray_at(uv),
        }
    }

    /// Returns the selection, with a selected pixel moved back into the image if it lies outside, as it
    /// may after the image has become smaller.
    pub fn inside(self, image: ImageSize) -> Selection {
        match self {
            Selection::Pixel(Pixel { row, column }) => Selection::Pixel(Pixel {
                row: row.min(image.height() - 1),
                column: column.min(image.width() - 1),
            }),
            uv => uv,
        }
    }

    /// Returns the selection after a change of the image's size. A selected pixel becomes the pixel at
    /// the same position in the new image.
    pub fn in_another_image(self, before: ImageSize, now: ImageSize) -> Selection {
        let position = |k: u32, before: u32, now: u32| {
            let share = (f64::from(k) + 0.5) / f64::from(before);
            ((share * f64::from(now)) as u32).min(now - 1)
        };
        match self {
            Selection::Pixel(Pixel { row, column }) if before != now => Selection::Pixel(Pixel {
                row: position(row, before.height(), now.height()),
                column: position(column, before.width(), now.width()),
            }),
            same => same,
        }
    }

    /// Returns the selection after a change of the viewport's size. A selected (u, v) is scaled with the
    /// width and height.
    pub fn in_another_viewport(self, before: Viewport, now: Viewport) -> Selection {
        match self {
            Selection::Uv(uv) if before != now => {
                let scaled = uv * DVec2::new(now.width, now.height)
                    / DVec2::new(before.width, before.height);
                Selection::Uv(if scaled.is_finite() { scaled } else { uv })
            }
            same => same,
        }
    }

    /// Returns the selection moved by `rows` down and `columns` to the right, for the arrow keys. If a
    /// (u, v) is selected, the first step leads to the next pixel centre in that direction.
    pub fn stepped(self, camera: &ResolvedCamera, rows: i64, columns: i64) -> Selection {
        let (Pixel { row, column }, rows, columns) = match self.inside(camera.image()) {
            Selection::Pixel(pixel) => (pixel, rows, columns),
            Selection::Uv(uv) => {
                let Some(PixelOfUv { pixel, .. }) = camera.pixel_of_uv(uv) else { return self };
                let off = camera.uv_of_pixel(pixel) - uv;
                // A step towards the centre of the current pixel stops there.
                let beyond = |steps: i64, centre_is_ahead: bool| {
                    if centre_is_ahead { steps - steps.signum() } else { steps }
                };
                let down = if rows > 0 { -off.y } else { off.y };
                let right = if columns > 0 { off.x } else { -off.x };
                (pixel, beyond(rows, down > 0.0), beyond(columns, right > 0.0))
            }
        };
        let step = |from: u32, by: i64, count: u32| {
            (i64::from(from) + by).clamp(0, i64::from(count) - 1) as u32
        };
        Selection::Pixel(Pixel {
            row: step(row, rows, camera.image().height()),
            column: step(column, columns, camera.image().width()),
        })
    }
}
