//! The gallery of wrong cameras: the one that is shown, and the one to be guessed.

use pinhole_lecture::mistakes::Mistake;

/// The state of the mistakes view. A lesson's step sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MistakesView {
    /// The chosen mistake.
    pub chosen: Mistake,
    /// The open riddle, shown in its place.
    pub guess: Option<Guess>,
    /// The next riddle's seed.
    pub seed: u64,
    /// True if a riddle was asked for, but no mistake changes the picture.
    pub nothing_shows: bool,
}

/// A wrong camera without its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guess {
    /// The mistake that was made.
    pub mistake: Mistake,
    /// The class's guess.
    pub answer: Option<Mistake>,
}

impl Default for MistakesView {
    fn default() -> Self {
        MistakesView { chosen: Mistake::WAsPrinted, guess: None, seed: 1, nothing_shows: false }
    }
}

impl MistakesView {
    /// Returns the mistake of the camera that is shown.
    pub fn shown(&self) -> Mistake {
        self.guess.map_or(self.chosen, |guess| guess.mistake)
    }

    /// Returns true if the mistake's name may be seen.
    pub fn is_revealed(&self) -> bool {
        self.guess.is_none_or(|guess| guess.answer.is_some())
    }

    /// Opens a riddle with one of these mistakes, if possible not the last one.
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

#[cfg(test)]
mod tests {
    use pinhole_lecture::mistakes::visible;

    use super::*;
    use pinhole_exchange::scenes::builtin;

    #[test]
    fn riddles_are_of_what_shows_and_never_twice_the_same() {
        let document = builtin::find("look-at").expect("built in").load().expect("a scene");
        let (camera, scene) = (document.camera, document.scene().expect("a scene"));
        let visible = visible(&camera, &camera.resolve().expect("a camera"), &scene);
        assert!(visible.contains(&Mistake::WAsPrinted) && visible.contains(&Mistake::VIsUCrossW));
        // Half a pixel of 400, and a distance of 1.
        assert!(!visible.contains(&Mistake::PixelCorner), "{visible:?}");
        assert!(!visible.contains(&Mistake::DistanceDropped), "{visible:?}");
        let mut mistakes_view = MistakesView::default();
        let mut last = None;
        let mut asked: Vec<Mistake> = Vec::new();
        for _ in 0..60 {
            mistakes_view.ask(&visible);
            assert_ne!(Some(mistakes_view.shown()), last);
            assert!(visible.contains(&mistakes_view.shown()) && !mistakes_view.is_revealed());
            last = Some(mistakes_view.shown());
            asked.extend(last);
        }
        assert!(visible.iter().all(|mistake| asked.contains(mistake)), "{asked:?}");
        mistakes_view.guess = None;
        mistakes_view.ask(&[]);
        assert_eq!((mistakes_view.guess, mistakes_view.nothing_shows), (None, true));
    }
}
