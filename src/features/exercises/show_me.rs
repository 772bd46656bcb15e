//! *Show me*: the camera with the mistake that a verdict names, as a ghost in the exercise's figure.

use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{Asked, Verdict};
use pinhole_lecture::mistakes::WrongCamera;

use crate::features::exercises::{Exercises, Feedback};

impl Exercises {
    /// Returns the mistake in this feedback whose camera may be shown; `None` if there is none.
    pub(crate) fn may_show(&self, said: &Feedback) -> Option<Mistake> {
        let Feedback::Judged(Verdict::Mistakes(named)) = said else { return None };
        named.iter().copied().find(|mistake| self.wrong_camera(*mistake).is_some())
    }

    /// Shows the camera with this mistake or, if it is shown, hides it.
    pub(crate) fn toggle_shown(&mut self, mistake: Mistake) {
        self.shown_mistake = Some(mistake).filter(|mistake| self.shown_mistake != Some(*mistake));
    }

    /// Returns the wrong camera that is shown. It goes once the answer with the mistake is changed.
    pub(crate) fn ghost(&self) -> Option<WrongCamera> {
        let said = self.answers.iter().filter_map(|typed| typed.feedback.as_ref());
        let mut named = said.filter_map(|said| self.may_show(said));
        self.wrong_camera(self.shown_mistake.filter(|shown| named.any(|named| named == *shown))?)
    }

    /// Returns the camera that results from the mistake and the question's numbers. Returns `None` if there is no such
    /// camera, if it would show a vector that the student has not answered yet, or if the answer is a point of the
    /// viewport, which has its own mark.
    fn wrong_camera(&self, mistake: Mistake) -> Option<WrongCamera> {
        let parts = self.question().parts.iter().zip(&self.answers);
        let is_shown_by = |(asked, said): (Asked, Option<&Feedback>)| match asked {
            Asked::U | Asked::V | Asked::W => match said {
                Some(Feedback::Judged(Verdict::Mistakes(named))) => named.contains(&mistake),
                Some(Feedback::Follows(_)) => true,
                said => said.is_some_and(Feedback::is_good),
            },
            asked => asked != Asked::Uv,
        };
        let is_own =
            parts.map(|(part, typed)| (part.asked, typed.feedback.as_ref())).all(is_shown_by);
        let camera = self.question().camera().filter(|_| is_own && mistake.is_in_gallery())?;
        WrongCamera::new(&camera, mistake).ok()
    }
}
