//! The comparison of a wrong camera with the right one, and the vote on a wrong one.

use pinhole_core::{Camera, ResolvedCamera, Scene};
use pinhole_lecture::{Mistake, Vote, next_seed};

use crate::features::vote::OpenVote;
use crate::model::with_defaults;

with_defaults! {
    /// The state of the mistakes view, which compares a camera with a classic mistake with the right one. A
    /// lesson's step sets this state.
    #[derive(Clone, Debug, PartialEq)]
    pub struct MistakesView {
        /// The chosen mistake.
        pub chosen: Mistake = Mistake::WAsPrinted,
        /// The open vote (the class names the mistake in a picture), which is shown in place of the chosen
        /// mistake.
        pub open_vote: Option<OpenVote> = None,
        /// The seed from which the open vote was made, or the next one will be made.
        pub seed: u64 = 1,
        /// True if a vote was requested, but in this scene no two mistakes give pictures that can be told
        /// apart.
        pub nothing_shows: bool = false,
        /// True if a vote was requested and opens as soon as there is a picture.
        pub wants_vote: bool = false,
        /// True if the user wants to see a map of the pixels that differ in place of the wrong picture.
        pub wants_differences: bool = false,
    }
}

impl MistakesView {
    /// Returns the mistake whose picture is shown.
    pub fn shown(&self) -> Mistake {
        let open = self.open_vote.as_ref();
        open.and_then(|open| open.options[open.right].mistake).unwrap_or(self.chosen)
    }

    /// Returns true if the name of the shown mistake may be revealed.
    pub fn is_revealed(&self) -> bool {
        self.open_vote.as_ref().is_none_or(|open| open.is_revealed)
    }

    /// Returns true if a map of the differing pixels is shown in place of the wrong picture.
    pub fn shows_differences(&self) -> bool {
        self.wants_differences && self.is_revealed()
    }

    /// Opens the vote that is made from the current seed.
    pub fn ask(&mut self, camera: &Camera, resolved: &ResolvedCamera, scene: &Scene) {
        let vote = Vote::new(camera, resolved, scene, self.seed);
        self.nothing_shows = vote.is_none();
        self.wants_vote = false;
        self.wants_differences = false;
        self.open_vote = vote.as_ref().map(OpenVote::on_mistake);
    }

    /// Closes the vote and returns to the list of mistakes. If the vote's mistake was revealed, that
    /// mistake becomes the chosen one.
    pub fn close_vote(&mut self) {
        if self.is_revealed() {
            self.chosen = self.shown();
        }
        self.open_vote = None;
        self.seed = next_seed(self.seed);
    }
}

#[cfg(test)]
mod tests {
    use pinhole_exchange::scenes::BuiltinScene;

    use super::*;

    #[test]
    fn a_vote_keeps_its_secret_and_the_gallery_follows_it() {
        let document = BuiltinScene::find("look-at").expect("built in").load().expect("a scene");
        let (camera, scene) = (document.camera, document.scene().expect("a scene"));
        let resolved = camera.resolve().expect("a camera");
        let mut view = MistakesView { wants_differences: true, ..MistakesView::default() };
        view.ask(&camera, &resolved, &scene);
        assert!(!view.is_revealed() && !view.shows_differences());
        view.close_vote();
        assert_eq!(view.chosen, MistakesView::default().chosen, "it was not revealed");
        view.ask(&camera, &resolved, &scene);
        view.open_vote.as_mut().expect("it was asked").is_revealed = true;
        let mistake = view.shown();
        view.close_vote();
        assert_eq!(view.chosen, mistake);
        view.ask(&camera, &resolved, &Scene::default());
        assert!(view.nothing_shows && view.open_vote.is_none());
    }
}
