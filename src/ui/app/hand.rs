//! Taking the camera and the scene in the hand, before anything is drawn.

use egui::{Context, Id, Rect, Ui};

use super::App;
use crate::ui::scene::handles::Edited;
use crate::ui::scene::places::Places;
use crate::ui::scene::views;

impl App {
    /// What mouse and keys do to handles, and in the camera view.
    pub(super) fn hand_inputs(&mut self, ctx: &Context) {
        let is_covered = self.is_covered();
        let mut edited = Edited {
            document: &mut self.open.document,
            session: &mut self.session,
            chosen_object: &mut self.chosen_object,
        };
        if is_covered {
            edited.session.hand.is_busy = false;
            self.hand.let_go(edited.session);
            self.navigation.let_go();
            return;
        }
        self.hand.take(ctx, &mut edited, &self.derived);
        self.navigation.take(ctx, &mut edited);
        self.drawn_as_it_is();
    }

    /// Nothing of this pass is drawn yet: what has changed until now makes nothing stale.
    fn drawn_as_it_is(&mut self) {
        let has_changed = self.known.as_ref().is_some_and(|(document, session, _)| {
            *document != self.open.document || *session != self.session
        });
        if has_changed {
            let marks = [self.open.has_changes(), self.differs_from_step()];
            self.known = Some((self.open.document.clone(), self.session.clone(), marks));
        }
    }

    /// What there is to say of that; where the views are now.
    pub(super) fn tell_hand(&mut self, ui: &Ui, places: &Places) {
        let place = |rect: Option<Rect>, name: &str| -> Option<(Rect, Id)> {
            Some((rect?, ui.scope_id().with(name)))
        };
        let (document, session) = (&self.open.document, &self.session);
        let world = place(places.world, views::WORLD);
        self.hand.tell(ui, world, &self.derived, document, session);
        let camera = place(places.camera, views::CAMERA);
        self.navigation.tell(ui, camera, &document.camera, session);
    }
}
