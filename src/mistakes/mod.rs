//! The gallery of wrong cameras: which one is looked at, and which one is to be guessed. Pure.

use egui::Color32;
use pinhole_core::{
    Camera, CameraError, Outputs, PosedCamera, Raster, Rgb, Scene, Shade, trace_as,
};
use pinhole_lecture::mistakes::{Checked, Mistake, NoWrongCamera, WrongCamera, WrongPicture};

/// What the mistakes view shows. A lesson's step sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gallery {
    /// The mistake whose camera is shown.
    pub chosen: Mistake,
    /// The riddle in its place, if one is on.
    pub guess: Option<Guess>,
    /// The next riddle's seed.
    pub seed: u64,
    /// A riddle was asked for, and no mistake shows in the picture.
    pub nothing_shows: bool,
}

/// A wrong camera without its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guess {
    /// What was done wrong.
    pub mistake: Mistake,
    /// What the class says.
    pub answer: Option<Mistake>,
}

impl Default for Gallery {
    fn default() -> Self {
        Gallery { chosen: Mistake::WAsPrinted, guess: None, seed: 1, nothing_shows: false }
    }
}

impl Gallery {
    /// The mistake of the camera that is shown.
    pub fn shown(&self) -> Mistake {
        self.guess.map_or(self.chosen, |guess| guess.mistake)
    }

    /// Whether its name, and what would tell it, is to be seen.
    pub fn is_told(&self) -> bool {
        self.guess.is_none_or(|guess| guess.answer.is_some())
    }

    /// Asks for one of these mistakes, another than the last one if there is one.
    pub fn ask(&mut self, visible: &[Mistake]) {
        self.nothing_shows = visible.is_empty();
        let last = self.guess.map(|guess| guess.mistake);
        let others: Vec<Mistake> =
            visible.iter().copied().filter(|mistake| Some(*mistake) != last).collect();
        let from = if others.is_empty() { visible } else { &others };
        if from.is_empty() {
            return;
        }
        let mistake = from[(scrambled(self.seed) % from.len() as u64) as usize];
        self.seed += 1;
        self.guess = Some(Guess { mistake, answer: None });
    }
}

/// SplitMix64's output function: neighbouring seeds ask for unrelated mistakes.
fn scrambled(seed: u64) -> u64 {
    let z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// How many rows and columns are looked at to see whether a mistake shows.
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
pub struct Wrong {
    /// What was done wrong.
    pub mistake: Mistake,
    /// The camera that it makes, or why there is none.
    pub camera: Result<WrongCamera, NoWrongCamera>,
    /// Every check of the right camera.
    pub right_checks: Vec<Checked>,
    /// Every check of the wrong one; none where there is none.
    pub checks: Vec<Checked>,
    /// How many pixels are shown, and how many of them see something else.
    pub seen: Option<Seen>,
    /// Why the wrong camera sees nothing.
    pub blind: Option<CameraError>,
}

/// What the pixels of both pictures see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// How many are compared.
    pub pixels: usize,
    /// How many see another object, or nothing where the other sees something.
    pub differing: usize,
}

impl Wrong {
    /// The wrong camera with its numbers, and its picture, if it has one.
    pub fn new(
        camera: &Camera,
        posed: &PosedCamera,
        scene: &Scene,
        mistake: Mistake,
        raster: &Raster,
        (shade, color_of): (Shade, impl Fn(u32) -> Rgb + Sync),
    ) -> (Wrong, Option<Vec<Color32>>) {
        let mut wrong = Wrong {
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
                wrong.seen = Some(Seen { pixels: right.len(), differing });
                let to_pixel = |[r, g, b]: Rgb| Color32::from_rgb(r, g, b);
                (wrong, Some(picture.shaded(scene, shade, color_of, to_pixel)))
            }
            Err(error) => {
                wrong.blind = Some(error);
                (wrong, None)
            }
        }
    }

    /// Why there is no wrong picture, in words.
    pub fn why_not(&self) -> Option<String> {
        match &self.camera {
            Err(why) => Some(why.to_string()),
            Ok(_) => self.blind.map(|error| format!("The wrong camera sees nothing: {error}")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::builtin;

    #[test]
    fn riddles_are_of_what_shows_and_never_twice_the_same() {
        let document = builtin::find("look-at").expect("built in").load().expect("a scene");
        let (camera, scene) = (document.camera, document.scene().expect("a scene"));
        let visible = visible(&camera, &camera.posed().expect("a camera"), &scene);
        assert!(visible.contains(&Mistake::WAsPrinted) && visible.contains(&Mistake::VIsUCrossW));
        // Half a pixel of 400, and a distance of 1.
        assert!(!visible.contains(&Mistake::PixelCorner), "{visible:?}");
        assert!(!visible.contains(&Mistake::DistanceDropped), "{visible:?}");
        let mut gallery = Gallery::default();
        let mut last = None;
        let mut asked: Vec<Mistake> = Vec::new();
        for _ in 0..60 {
            gallery.ask(&visible);
            assert_ne!(Some(gallery.shown()), last);
            assert!(visible.contains(&gallery.shown()) && !gallery.is_told());
            last = Some(gallery.shown());
            asked.extend(last);
        }
        assert!(visible.iter().all(|mistake| asked.contains(mistake)), "{asked:?}");
        gallery.guess = None;
        gallery.ask(&[]);
        assert_eq!((gallery.guess, gallery.nothing_shows), (None, true));
    }
}
