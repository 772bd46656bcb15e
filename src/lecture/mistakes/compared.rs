//! A wrong camera beside the right one.

use pinhole_core::{
    Camera, CameraError, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, trace_as,
};

use super::checks::Checked;
use super::table::Mistake;
use super::wrong_camera::{NoWrongCamera, WrongCamera};
use super::wrong_picture::WrongPicture;

/// Returns the objects that the right camera sees, pixel by pixel.
pub(super) fn right_objects(resolved: &ResolvedCamera, scene: &Scene, raster: &Raster) -> Vec<u32> {
    let outputs = Outputs { object: true, ..Outputs::NONE };
    trace_as::<f32>(scene, resolved, raster, outputs).object
}

/// A wrong camera, next to the right one.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedCamera {
    /// The mistake that was made.
    pub mistake: Mistake,
    /// The camera that it makes, or why there is none.
    pub camera: Result<WrongCamera, NoWrongCamera>,
    /// Every check of the right camera.
    pub right_checks: Vec<Checked>,
    /// Every check of the wrong one; none where there is none.
    pub checks: Vec<Checked>,
    /// The pixels that are shown, and those of them that see something else.
    pub seen: Option<ComparedPixels>,
    /// The reason why the wrong camera sees nothing.
    pub blind: Option<CameraError>,
}

/// The pixels of both pictures, compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedPixels {
    /// The count of pixels that are compared.
    pub pixels: usize,
    /// The count of those that see another object, or nothing where the other sees something.
    pub differing: usize,
}

/// A wrong camera's picture, and what both cameras see in each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedPicture<P> {
    /// The colours of the wrong picture, row by row.
    pub pixels: Vec<P>,
    /// The objects that the wrong camera sees.
    pub wrong: Vec<u32>,
    /// The objects that the right camera sees.
    pub right: Vec<u32>,
}

impl ComparedCamera {
    /// The wrong camera with its numbers, and its picture, if it has one.
    pub fn new<P: Clone + Send + Sync>(
        camera: &Camera,
        resolved: &ResolvedCamera,
        scene: &Scene,
        mistake: Mistake,
        raster: &Raster,
        paint: Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    ) -> (ComparedCamera, Option<ComparedPicture<P>>) {
        let mut wrong = ComparedCamera {
            mistake,
            camera: WrongCamera::new(camera, mistake),
            right_checks: WrongCamera::right(camera).map(|c| c.checks()).unwrap_or_default(),
            checks: Vec::new(),
            seen: None,
            blind: None,
        };
        let Ok(camera) = &wrong.camera else { return (wrong, None) };
        wrong.checks = camera.checks();
        match WrongPicture::trace(scene, camera, raster) {
            Ok(picture) => {
                let right = right_objects(resolved, scene, raster);
                let differing = picture.differing(&right);
                wrong.seen = Some(ComparedPixels { pixels: right.len(), differing });
                let Paint { shade, color_of, to_pixel } = paint;
                let pixels = picture.shaded(scene, shade, color_of, to_pixel);
                (wrong, Some(ComparedPicture { pixels, wrong: picture.object, right }))
            }
            Err(error) => {
                wrong.blind = Some(error);
                (wrong, None)
            }
        }
    }

    /// The reason why there is no wrong picture, in words.
    pub fn why_not(&self) -> Option<String> {
        match &self.camera {
            Err(why) => Some(why.to_string()),
            Ok(_) => self.blind.map(|error| format!("The wrong camera sees nothing: {error}")),
        }
    }
}
