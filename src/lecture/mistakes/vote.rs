//! A vote on a wrong picture: which of several mistakes was made.

use pinhole_core::{Camera, Raster, ResolvedCamera, Scene};

use super::wrong_picture::{WrongPicture, count_differing, right_objects};
use super::{Mistake, WrongCamera};

/// Number of rows and of columns that are compared to decide whether two pictures differ.
const SAMPLES: u32 = 72;

/// Two pictures differ if at least one in this many pixels shows another object.
const DIFFERS_FROM: usize = 50;

/// A multiple-choice question for an audience, which shows a wrong picture and asks which mistake was
/// made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vote {
    /// The mistakes to choose from: at least two, whose pictures all differ from each other.
    pub options: Vec<Mistake>,
    /// Index of the mistake that was made.
    pub right: usize,
}

impl Vote {
    /// The letters of the options. Keys, fields and texts of a vote are made from them.
    pub const LETTERS: [&str; 4] = ["A", "B", "C", "D"];

    /// Maximum number of options.
    pub const OPTIONS: usize = Vote::LETTERS.len();

    /// Creates the question for this seed. The same camera, scene and seed give the same question, and
    /// consecutive seeds give different mistakes. Returns `None` if there are no two mistakes that can
    /// be distinguished by their pictures of this scene.
    pub fn new(
        camera: &Camera,
        resolved: &ResolvedCamera,
        scene: &Scene,
        seed: u64,
    ) -> Option<Vote> {
        let pictures = different_pictures(camera, resolved, scene);
        let mut order: Vec<usize> = (0..pictures.len()).collect();
        // All seeds use the same order, so that consecutive seeds never choose the same mistake.
        shuffle(&mut order, 0);
        let right = *order.get((seed % pictures.len().max(1) as u64) as usize)?;
        shuffle(&mut order, seed.wrapping_add(1));
        let mut chosen = vec![right];
        for index in order {
            let is_new = |other: &usize| differ(&pictures[index].1, &pictures[*other].1);
            if chosen.len() < Vote::OPTIONS && chosen.iter().all(is_new) {
                chosen.push(index);
            }
        }
        if chosen.len() < 2 {
            return None;
        }
        shuffle(&mut chosen, !seed);
        let options = chosen.iter().map(|index| pictures[*index].0).collect();
        Some(Vote { options, right: chosen.iter().position(|index| *index == right)? })
    }

    /// Returns the mistake that was made in the picture.
    pub fn mistake(&self) -> Mistake {
        self.options[self.right]
    }
}

/// Returns the mistakes whose pictures differ from the right one, each with the objects that its
/// picture shows.
fn different_pictures(
    camera: &Camera,
    resolved: &ResolvedCamera,
    scene: &Scene,
) -> Vec<(Mistake, Vec<u32>)> {
    let raster = Raster::shown_on(camera.image, SAMPLES, SAMPLES);
    let right = right_objects(resolved, scene, &raster);
    let picture_of = |mistake: &Mistake| {
        let wrong = WrongCamera::new(camera, *mistake).ok()?;
        let picture = WrongPicture::trace(scene, &wrong, &raster).ok()?;
        differ(&picture.object, &right).then_some((*mistake, picture.object))
    };
    Mistake::GALLERY.iter().filter_map(picture_of).collect()
}

/// Returns true if two pictures differ visibly.
fn differ(a: &[u32], b: &[u32]) -> bool {
    count_differing(a, b) * DIFFERS_FROM >= a.len().max(1)
}

/// The random number generator SplitMix64, stored as its 64-bit state: Steele, Lea, Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014.
pub(crate) struct SplitMix64(pub(crate) u64);

impl SplitMix64 {
    /// Returns 64 random bits.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

/// Shuffles the items by the algorithm of Fisher and Yates. The resulting order depends only on the
/// seed.
fn shuffle<T>(items: &mut [T], seed: u64) {
    let mut random = SplitMix64(seed);
    for k in (1..items.len()).rev() {
        items.swap(k, (random.bits() % (k as u64 + 1)) as usize);
    }
}
