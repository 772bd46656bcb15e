//! The answers that the world view draws beside the right ones, and the wrong camera beside the right
//! one.

use std::sync::Arc;

use pinhole_core::{Camera, Selection};
use pinhole_lecture::grading::Graded;
use pinhole_lecture::mistakes::{Mistake, WrongCamera};

use super::Derived;
use super::derived::Inputs;
use super::memo::{Memo, Same};
use crate::model::practice::twin::Twin;
use crate::model::session::ViewLayout;
use crate::view::answer_twins::{of_answers, of_mistake};
use crate::view::overlay::GhostCamera;

/// The inputs of a wrong camera's ray: the camera, the objects by number, the mistake, and the pixel.
type MistakeKey = (Camera, u64, Mistake, Selection);

/// The inputs of a student's answer: the grade, and the selected pixel.
type AnswersKey = (Same<Graded>, Selection);

/// A cache of the answers beside the right ones.
#[derive(Debug, Default)]
pub(super) struct Twins {
    mistake: Memo<MistakeKey, Arc<[Twin]>>,
    answers: Memo<AnswersKey, Arc<[Twin]>>,
}

impl Twins {
    /// Returns the answers of the page that is shown.
    pub(super) fn get(
        &mut self,
        inputs: Inputs<'_>,
        derived: &Derived,
        generation: u64,
    ) -> Arc<[Twin]> {
        let Inputs { document, session, sizes, .. } = inputs;
        let layout = session.settings.layout;
        if layout == ViewLayout::Exercises && sizes.world.is_some() {
            return session.exercises.twins().into();
        }
        let selection = session.shown_selection();
        let (Some(camera), Some(scene)) = (&derived.resolved, derived.scene.as_deref()) else {
            return Arc::default();
        };
        if let Some((mistake, wrong)) = wrong_camera(inputs, derived) {
            let key = (document.camera, generation, mistake, selection);
            return self.mistake.get(key, |_| of_mistake(wrong, scene, selection).into());
        }
        match &derived.answers {
            Some(Ok(graded)) if layout == ViewLayout::Answers => {
                let key = (Same(Arc::clone(graded)), selection);
                self.answers.get(key, |_| of_answers(graded, camera, scene, selection).into())
            }
            _ => Arc::default(),
        }
    }
}

/// Returns the mistake that is shown with its camera, unless that would tell what is to be guessed.
fn wrong_camera<'a>(
    Inputs { session, .. }: Inputs<'_>,
    derived: &'a Derived,
) -> Option<(Mistake, &'a WrongCamera)> {
    let is_shown = session.settings.layout == ViewLayout::Mistakes;
    let wrong = derived.wrong.as_ref().filter(|_| is_shown && derived.fault.is_none())?;
    let camera = wrong.camera.as_ref().ok()?;
    session.mistakes_view.is_revealed().then_some((wrong.mistake, camera))
}

/// Returns the camera to compare with in the world view: a mistake's, or the frozen one.
pub(super) fn ghost(inputs: Inputs<'_>, derived: &Derived) -> Option<GhostCamera> {
    if inputs.session.settings.layout == ViewLayout::Mistakes {
        // It shows what the class is asked for.
        if inputs.session.is_asking {
            return None;
        }
        return wrong_camera(inputs, derived).map(|(_, wrong)| GhostCamera::of_mistake(wrong));
    }
    derived.ghost.as_ref().map(GhostCamera::frozen)
}
