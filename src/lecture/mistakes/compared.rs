//! A wrong camera beside the right one, and the mistakes that one sees.

use pinhole_core::{
    Camera, CameraError, Outputs, Paint, PosedCamera, Raster, Rgb, Scene, trace_as,
};

use super::checks::Checked;
use super::table::Mistake;
use super::wrong_camera::{NoWrongCamera, WrongCamera};
use super::wrong_picture::WrongPicture;

/// Rows and columns that are looked at to see whether a mistake shows.
const SAMPLES: u32 = 72;

/// One pixel in so many has to see something else for a mistake to show.
const SHOWS_FROM: usize = 100;

/// The mistakes that one sees in the picture of this camera.
pub fn visible(camera: &Camera, posed: &PosedCamera, scene: &Scene) -> Vec<Mistake> {
    let raster = Raster::shown_on(camera.image, SAMPLES, SAMPLES);
    let right = right_objects(posed, scene, &raster);
    let shows = |mistake: &Mistake| {
        let wrong = WrongCamera::new(camera, *mistake).ok();
        let picture = wrong.and_then(|wrong| WrongPicture::trace(scene, &wrong, &raster).ok());
        picture.is_some_and(|picture| picture.differing(&right) * SHOWS_FROM >= right.len())
    };
    Mistake::GALLERY.iter().copied().filter(shows).collect()
}

fn right_objects(posed: &PosedCamera, scene: &Scene, raster: &Raster) -> Vec<u32> {
    let outputs = Outputs { object: true, ..Outputs::NONE };
    trace_as::<f32>(scene, posed, raster, outputs).object
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

impl ComparedCamera {
    /// The wrong camera with its numbers, and its picture, if it has one.
    pub fn new<P: Clone + Send + Sync>(
        camera: &Camera,
        posed: &PosedCamera,
        scene: &Scene,
        mistake: Mistake,
        raster: &Raster,
        paint: Paint<impl Fn(u32) -> Rgb + Sync, impl Fn(Rgb) -> P + Sync>,
    ) -> (ComparedCamera, Option<Vec<P>>) {
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
                let right = right_objects(posed, scene, raster);
                let differing = picture.differing(&right);
                wrong.seen = Some(ComparedPixels { pixels: right.len(), differing });
                let Paint { shade, color_of, to_pixel } = paint;
                (wrong, Some(picture.shaded(scene, shade, color_of, to_pixel)))
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
