//! A vote: a wrong picture, and the mistakes that may have made it.

use pinhole_core::{Camera, Raster, ResolvedCamera, Scene};

use super::table::Mistake;
use super::wrong_camera::WrongCamera;
use super::wrong_picture::{WrongPicture, right_objects};

/// Rows and columns that are looked at to see whether two pictures differ.
const SAMPLES: u32 = 72;

/// One pixel in so many has to see something else for two pictures to differ.
const DIFFERS_FROM: usize = 100;

/// The most options of a vote.
const OPTIONS: usize = 4;

/// A question that shows a wrong picture and asks which mistake made it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vote {
    /// Mistakes of which each makes a picture of its own, at least two.
    pub options: Vec<Mistake>,
    /// Index of the mistake that made the picture.
    pub right: usize,
}

impl Vote {
    /// Returns the vote of this seed: the same one for the same camera, scene and seed. Votes of
    /// neighbouring seeds are about different mistakes. Returns `None` where fewer than two mistakes
    /// can be told apart.
    pub fn new(
        camera: &Camera,
        resolved: &ResolvedCamera,
        scene: &Scene,
        seed: u64,
    ) -> Option<Vote> {
        let pictures = different_pictures(camera, resolved, scene);
        let mut order: Vec<usize> = (0..pictures.len()).collect();
        // One order for all seeds, so that none follows itself.
        shuffle(&mut order, 0);
        let right = *order.get((seed % pictures.len().max(1) as u64) as usize)?;
        shuffle(&mut order, seed.wrapping_add(1));
        let mut chosen = vec![right];
        for index in order {
            let is_new = |other: &usize| differ(&pictures[index].1, &pictures[*other].1);
            if chosen.len() < OPTIONS && chosen.iter().all(is_new) {
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

    /// Returns the mistake that made the picture.
    pub fn mistake(&self) -> Mistake {
        self.options[self.right]
    }
}

/// Returns the mistakes whose picture differs from the right one, with the objects that they see.
fn different_pictures(
    camera: &Camera,
    resolved: &ResolvedCamera,
    scene: &Scene,
) -> Vec<(Mistake, Vec<u32>)> {
    let raster = Raster::shown_on(camera.image, SAMPLES, SAMPLES);
    let right = right_objects(resolved, scene, &raster);
    let seen = |mistake: &Mistake| {
        let wrong = WrongCamera::new(camera, *mistake).ok()?;
        let picture = WrongPicture::trace(scene, &wrong, &raster).ok()?;
        differ(&picture.object, &right).then_some((*mistake, picture.object))
    };
    Mistake::GALLERY.iter().filter_map(seen).collect()
}

/// Returns whether one sees at a glance that two pictures differ.
fn differ(a: &[u32], b: &[u32]) -> bool {
    let differing = a.iter().zip(b).filter(|(a, b)| a != b).count();
    differing * DIFFERS_FROM >= a.len().max(1)
}

/// Shuffles (Fisher and Yates) by SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014.
fn shuffle<T>(items: &mut [T], seed: u64) {
    let mut state = seed;
    for k in (1..items.len()).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        items.swap(k, ((z ^ (z >> 31)) % (k as u64 + 1)) as usize);
    }
}
