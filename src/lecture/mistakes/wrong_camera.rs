//! The camera that a program calculates if it makes a mistake.

use pinhole_core::arithmetic::length;
use pinhole_core::{
    Camera, CameraError, DVec2, DVec3, ImageSize, Pixel, Ray, RayError, ResolvedCamera,
};

use super::pipeline::{BasisChoices, GivenCamera, Pipeline, PipelineCamera};
use super::table::Mistake;

/// A camera with a mistake in the calculation of its rays.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongCamera {
    pub(super) given: GivenCamera,
    pub(super) made: PipelineCamera,
}

/// Relative difference from which the numbers of a camera count as wrong. A mistake in a sign or an
/// order of factors changes the numbers by about their own size. A length that differs from 1 only by
/// rounding does so by at most 1e-15, and a difference below this limit changes no pixel of any image.
const DIFFERENT: f64 = 1e-12;

impl WrongCamera {
    /// Creates the wrong camera that a program calculates from `camera` if it makes `mistake`, one of
    /// [`Mistake::GALLERY`], in its most common variant.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if the camera is invalid, or if the mistake does not apply to
    /// it or has no effect.
    pub fn new(camera: &Camera, mistake: Mistake) -> Result<WrongCamera, String> {
        let right = WrongCamera::right(camera).map_err(|error| error.to_string())?;
        let pipeline = mistake.usual();
        if pipeline.basis != BasisChoices::RIGHT && right.given.by_hand {
            let why = "𝐮, 𝐯, 𝐰 are set by hand here, so this mistake has no place: give the camera by \
                       view and up, or by at and up.";
            return Err(why.to_owned());
        }
        if mistake == Mistake::WIsAtMinusEye && !camera.orientation.has_at() {
            let why = "The camera is given by view here, so there is no at − eye to mistake for 𝐰: give \
                       it by eye, at and up.";
            return Err(why.to_owned());
        }
        let wrong = WrongCamera { made: right.given.camera_of(pipeline), ..right };
        if !wrong.is_finite() {
            return Err("The wrong camera's numbers are beyond the range of f64.".to_owned());
        }
        if wrong.is_right() {
            return Err(format!("This changes nothing here. {}", mistake.hint()));
        }
        Ok(wrong)
    }

    /// Creates the camera that a program without mistakes calculates, which can be checked in the same
    /// way as a wrong one.
    ///
    /// # Errors
    /// Returns an error if the camera is invalid.
    pub fn right(camera: &Camera) -> Result<WrongCamera, CameraError> {
        let given = GivenCamera::new(camera)?;
        Ok(WrongCamera { made: given.camera_of(Pipeline::RIGHT), given })
    }

    /// Returns the camera without the mistake.
    pub fn right_camera(&self) -> &ResolvedCamera {
        &self.given.resolved
    }

    /// Returns the u of the wrong camera, which need not have length 1.
    pub fn u(&self) -> DVec3 {
        self.made.u
    }

    /// Returns the v of the wrong camera, which need not have length 1 or be perpendicular to w.
    pub fn v(&self) -> DVec3 {
        self.made.v
    }

    /// Returns the w of the wrong camera, which need not have length 1 or point backwards.
    pub fn w(&self) -> DVec3 {
        self.made.w
    }

    /// Returns true for each of u, v and w that differs from the right vector by more than rounding
    /// errors.
    pub fn wrong_vectors(&self) -> [bool; 3] {
        let right = self.given.resolved.basis();
        let is_wrong = |a: DVec3, b: DVec3| !is_near(a, b);
        [is_wrong(self.u(), right.u), is_wrong(self.v(), right.v), is_wrong(self.w(), right.w)]
    }

    /// Returns the viewport's distance that the rays use.
    pub fn distance(&self) -> f64 {
        self.made.distance_taken()
    }

    /// Returns the image's size W x H.
    pub fn image(&self) -> ImageSize {
        self.given.resolved.image()
    }

    /// Returns the (u, v) that the wrong camera calculates for a pixel.
    pub fn uv_of_pixel(&self, pixel: Pixel) -> DVec2 {
        self.made.uv(f64::from(pixel.row), f64::from(pixel.column))
    }

    /// Returns `u*U + v*V - distance*W` with the vectors of the wrong camera.
    pub fn direction_at(&self, uv: DVec2) -> DVec3 {
        self.made.direction_at(uv)
    }

    /// Returns the directions through the image's corners. They are clockwise in the image and begin at
    /// pixel (0, 0).
    pub fn corner_directions(&self) -> [DVec3; 4] {
        let (height, width) = (f64::from(self.image().height()), f64::from(self.image().width()));
        [(0.0, 0.0), (0.0, width), (height, width), (height, 0.0)]
            .map(|(row, column)| self.direction_at(self.made.uv(row - 0.5, column - 0.5)))
    }

    /// Returns the ray that the wrong camera generates for a pixel.
    ///
    /// # Errors
    /// Returns an error if the ray's numbers are outside the range of `f64`.
    pub fn ray(&self, pixel: Pixel) -> Result<Ray, RayError> {
        self.ray_at(self.uv_of_pixel(pixel))
    }

    /// Returns the ray that the wrong camera generates for a point (u, v).
    ///
    /// # Errors
    /// Returns an error if the ray's numbers are outside the range of `f64`.
    pub fn ray_at(&self, uv: DVec2) -> Result<Ray, RayError> {
        Ray::new(self.given.resolved.eye(), self.direction_at(uv))
    }

    fn is_finite(&self) -> bool {
        corners(self.image()).into_iter().all(|pixel| self.ray(pixel).is_ok())
    }

    /// Returns true if the basis and the rays differ from the right ones only by rounding errors.
    fn is_right(&self) -> bool {
        self.wrong_vectors() == [false; 3]
            && corners(self.image()).into_iter().all(|pixel| {
                let wrong = self.direction_at(self.uv_of_pixel(pixel));
                is_near(wrong, self.given.resolved.ray_of_pixel(pixel).direction)
            })
    }
}

fn is_near(a: DVec3, b: DVec3) -> bool {
    (a - b).length() <= DIFFERENT * length(b)
}

/// Returns the image's four corner pixels. If a camera's directions are right there, they are right
/// everywhere, because they are linear in row and column.
pub(super) fn corners(image: ImageSize) -> [Pixel; 4] {
    let (last_row, last_column) = (image.height() - 1, image.width() - 1);
    [(0, 0), (0, last_column), (last_row, 0), (last_row, last_column)]
        .map(|(row, column)| Pixel { row, column })
}
