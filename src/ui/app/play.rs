//! Animations: opening one, what it shows in each frame, and what is left of it when it ends.

use egui::{Context, Panel, Ui};

use super::App;
use crate::model::observer::Observer;
use crate::model::play::{Kind, Player, Start, Still, ray_point_end};
use crate::ui::action::{Action, HistoryAction, PlayAction, PlayEnd};
use crate::ui::panels::play;
use pinhole_exchange::document::Document;

impl App {
    /// Moves the open animation on, shows its strip, and sets what it shows; before anything else is
    /// drawn of it.
    pub(super) fn play_on(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) {
        let ctx = ui.ctx().clone();
        let Some(player) = &mut self.player else { return };
        let camera = &self.open.document.camera;
        let moved =
            (camera.eye, camera.orientation) != (player.shown.eye, player.shown.orientation);
        if player.kind.moves_camera() && moved {
            // Who edits the camera has taken it over.
            self.keep_play(&ctx);
            return;
        }
        player.start.camera.image = camera.image;
        player.start.camera.viewport = camera.viewport;
        player.start.end = ray_point_end(self.derived.inspection.as_deref());
        player.reduced = self.session.settings.reduced_motion;
        player.go_on(ctx.input(|input| input.time));
        Panel::bottom("play").show(ui, |ui| play::ui(ui, player, actions));
        let still = player.still();
        if player.running {
            ctx.request_repaint();
        }
        self.show_still(&still);
    }

    /// Sets what the animation moves, and leaves alone what it does not.
    fn show_still(&mut self, still: &Still) {
        let Some(player) = &mut self.player else { return };
        still.show(player.kind, &mut self.open.document, &mut self.session);
        player.shown = self.open.document.camera;
        // Nothing of this has been drawn yet, so nothing drawn is older than it.
        if let Some((_, looked_at, _)) = &mut self.known {
            looked_at.selection = self.session.selection;
            looked_at.ray_point_t = self.session.ray_point_t;
            looked_at.scanned_pixels = self.session.scanned_pixels;
        }
    }

    /// Does what the strip or a key asks for.
    pub(super) fn play(&mut self, ctx: &Context, play: PlayAction) {
        match (play, &mut self.player) {
            (PlayAction::Open(kind), _) => {
                self.give_back_play();
                self.settle(ctx);
                let inspection = self.derived.inspection.as_deref();
                let start = Start::of(&self.open.document, &self.session, inspection);
                let mut player = Player::new(kind, start);
                player.stepped_back = self.step_back(kind, &start);
                self.player = Some(player);
            }
            (PlayAction::Toggle, Some(player)) => player.toggle(),
            (PlayAction::Step(by), Some(player)) => player.step(by),
            (PlayAction::Faster(by), Some(player)) => player.faster(by),
            (PlayAction::Loop, Some(player)) => player.loops ^= true,
            (PlayAction::Keep, Some(_)) => self.keep_play(ctx),
            (PlayAction::Close, Some(_)) => self.give_back_play(),
            (_, None) => return,
        }
        ctx.request_repaint();
    }

    /// Takes the observer so far back that the camera stays in sight on its way; the observer before and
    /// after. What a lesson's step plays is seen from where the step says.
    fn step_back(&mut self, kind: Kind, start: &Start) -> Option<[Observer; 2]> {
        let of_step = self.lesson().and_then(|open| open.step().looks.play);
        let before = self.session.observer.filter(|_| of_step != Some(kind))?;
        let after = before.following(&start.camera, &start.cameras(kind), self.world_aspect());
        self.session.observer = Some(after);
        (after != before).then_some([before, after])
    }

    /// Ends the animation with everything as it was when it was opened.
    pub(super) fn give_back_play(&mut self) {
        let Some(player) = &self.player else { return };
        // Who has moved the observer since wants it there.
        let observer = &mut self.session.observer;
        *observer = match player.stepped_back {
            Some([before, after]) if *observer == Some(after) => Some(before),
            _ => *observer,
        };
        let still = player.start.still();
        self.show_still(&still);
        self.player = None;
    }

    /// Ends the animation with everything as it is now; a camera that it moved is a step of the
    /// history.
    pub(super) fn keep_play(&mut self, ctx: &Context) {
        let Some(player) = self.player.take() else { return };
        self.session.scanned_pixels = None;
        if player.kind.moves_camera() {
            let edited = self.open.document.camera;
            let camera = &mut self.open.document.camera;
            (camera.eye, camera.orientation) = (player.shown.eye, player.shown.orientation);
            let name = player.kind.step_name();
            let only_moved = self.is_only_moved();
            self.settle_as(ctx, only_moved.then_some(name));
            self.open.document.camera = edited;
        }
    }

    /// Whether the camera's place and orientation are all that has changed since the last step.
    fn is_only_moved(&self) -> bool {
        let mut before: Document = self.changes.settled().clone();
        let camera = &self.open.document.camera;
        (before.camera.eye, before.camera.orientation) = (camera.eye, camera.orientation);
        before == self.open.document
    }

    /// Whether an animation moves the camera: its frames are no steps of the history.
    pub(super) fn plays_camera(&self) -> bool {
        self.player.as_ref().is_some_and(|player| player.kind.moves_camera())
    }

    /// Ends the animation that is open where the action does. Whether that is all there is to undo.
    pub(super) fn end_play_for(&mut self, ctx: &Context, action: &Action) -> bool {
        let is_undone =
            matches!(action, Action::History(HistoryAction::Undo)) && self.plays_camera();
        match action.play_end() {
            PlayEnd::GoesOn => {}
            PlayEnd::Keeps => self.keep_play(ctx),
            PlayEnd::GivesBack => self.give_back_play(),
        }
        is_undone
    }

    /// The animation that is open.
    pub fn player(&self) -> Option<&Player> {
        self.player.as_ref()
    }
}
