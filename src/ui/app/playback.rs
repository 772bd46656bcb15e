//! Animations: opening one, what it shows in each frame, what is left of it when it ends, and writing
//! one to a file, a frame a pass of the window, which so stays alive.

use std::path::PathBuf;

use egui::{Context, Panel, Ui};

use super::history::SceneHistory;
use super::scene::OpenScene;
use crate::figures::{Animation, Frames, Order, Recorder};
use crate::model::inspection::Inspection;
use crate::model::observer::Observer;
use crate::model::play::{Kind, Player, Start, Still, ray_point_end};
use crate::model::session::Session;
use crate::ui::action::{Action, PlayAction};
use crate::ui::dialogs::Dialog;
use crate::ui::panels::play;
use crate::view::derive::Derived;

/// The animation that is open, and the one that is being written.
#[derive(Default)]
pub(super) struct Playback {
    pub(super) player: Option<Player>,
    recorder: Option<Recorder>,
}

impl Playback {
    /// Moves the open animation on, shows its strip, and sets what it shows; before anything else is
    /// drawn of it.
    pub(super) fn go_on(
        &mut self,
        ui: &mut Ui,
        scene: &mut OpenScene,
        history: &mut SceneHistory,
        inspection: Option<&Inspection>,
        actions: &mut Vec<Action>,
    ) {
        let ctx = ui.ctx().clone();
        let Some(player) = &mut self.player else { return };
        let camera = &scene.open.document.camera;
        let moved =
            (camera.eye, camera.orientation) != (player.shown.eye, player.shown.orientation);
        if player.kind.moves_camera() && moved {
            // Who edits the camera has taken it over.
            self.keep(&ctx, scene, history);
            return;
        }
        player.start.camera.image = camera.image;
        player.start.camera.viewport = camera.viewport;
        player.start.end = ray_point_end(inspection);
        player.reduced = scene.session.settings.reduced_motion;
        player.go_on(ctx.input(|input| input.time));
        Panel::bottom("play").show(ui, |ui| play::ui(ui, player, actions));
        if player.running {
            ctx.request_repaint();
        }
        let still = player.still();
        show_still(player, &still, scene);
    }

    /// Does what the strip or a key asks for.
    pub(super) fn apply(
        &mut self,
        ctx: &Context,
        action: PlayAction,
        scene: &mut OpenScene,
        history: &mut SceneHistory,
        derived: &Derived,
        aspect: f64,
    ) {
        match (action, &mut self.player) {
            (PlayAction::Open(kind), _) => {
                self.give_back(scene);
                history.settle(ctx, &scene.open.document);
                self.player = Some(opened(kind, scene, derived, aspect));
            }
            (PlayAction::Toggle, Some(player)) => player.toggle(),
            (PlayAction::Step(by), Some(player)) => player.step(by),
            (PlayAction::Faster(by), Some(player)) => player.faster(by),
            (PlayAction::Loop, Some(player)) => player.loops ^= true,
            (PlayAction::Keep, Some(_)) => self.keep(ctx, scene, history),
            (PlayAction::Close, Some(_)) => self.give_back(scene),
            (_, None) => {}
        }
    }

    /// Ends the animation with everything as it was when it was opened.
    pub(super) fn give_back(&mut self, scene: &mut OpenScene) {
        let Some(mut player) = self.player.take() else { return };
        // Who has moved the observer since wants it there.
        let observer = &mut scene.session.observer;
        *observer = match player.stepped_back {
            Some([before, after]) if *observer == Some(after) => Some(before),
            _ => *observer,
        };
        let still = player.start.still();
        show_still(&mut player, &still, scene);
    }

    /// Ends the animation with everything as it is now; a camera that it moved is a step of the
    /// history.
    pub(super) fn keep(
        &mut self,
        ctx: &Context,
        scene: &mut OpenScene,
        history: &mut SceneHistory,
    ) {
        let Some(player) = self.player.take() else { return };
        scene.session.scanned_pixels = None;
        if player.kind.moves_camera() {
            let edited = scene.open.document.camera;
            let camera = &mut scene.open.document.camera;
            (camera.eye, camera.orientation) = (player.shown.eye, player.shown.orientation);
            let name = player.kind.step_name();
            // The camera's place and orientation are all that has changed since the last step.
            let mut before = history.settled().clone();
            (before.camera.eye, before.camera.orientation) = (camera.eye, camera.orientation);
            let only_moved = before == scene.open.document;
            history.settle_as(ctx, &scene.open.document, only_moved.then_some(name));
            scene.open.document.camera = edited;
        }
    }

    /// Returns true if an animation moves the camera: its frames are no steps of the history.
    pub(super) fn plays_camera(&self) -> bool {
        self.player.as_ref().is_some_and(|player| player.kind.moves_camera())
    }

    /// Returns true if the camera is moving by itself just now.
    pub(super) fn is_running(&self) -> bool {
        self.plays_camera() && self.player.as_ref().is_some_and(|player| player.running)
    }

    /// Begins to write the animation that is open; the dialog that tells of it.
    pub(super) fn export(
        &mut self,
        order: Order,
        frames: Frames,
        path: PathBuf,
        scene: &OpenScene,
    ) -> Option<Dialog> {
        let player = self.player.as_ref()?;
        let session = Session { hovered: None, ..scene.session.clone() };
        let animation = Animation {
            kind: player.kind,
            start: player.start,
            loops: player.loops,
            scene: (scene.open.document.clone(), session),
            order,
            frames,
        };
        let recorder = scene.open.check_output(&path).and_then(|()| Recorder::new(animation, path));
        Some(match recorder {
            Ok(recorder) => {
                self.recorder = Some(recorder);
                Dialog::Progress { done: 0, frames: frames.count }
            }
            Err(problem) => Dialog::message("The animation was not exported", problem),
        })
    }

    /// Makes the next frame, if something is being written; nothing is left of it where its dialog was
    /// closed.
    pub(super) fn record(&mut self, ctx: &Context, dialog: &mut Option<Dialog>) {
        let Some(recorder) = &mut self.recorder else { return };
        let Some(Dialog::Progress { done, frames }) = dialog else {
            self.recorder = None;
            return;
        };
        let stepped = recorder.figure().and_then(|figure| recorder.push(&figure));
        (*done, *frames) = recorder.progress();
        ctx.request_repaint();
        let ended = match stepped {
            Ok(()) if *done < *frames => return,
            Ok(()) => self.recorder.take().map_or(Ok(()), Recorder::finish),
            Err(problem) => Err(problem),
        };
        self.recorder = None;
        let problem = |problem| Dialog::message("The animation was not exported", problem);
        *dialog = ended.err().map(problem);
    }
}

/// An animation at its start.
fn opened(kind: Kind, scene: &mut OpenScene, derived: &Derived, aspect: f64) -> Player {
    let (inspection, traced) = (derived.inspection.as_deref(), derived.scene.as_deref());
    let start = Start::new(&scene.open.document, &scene.session, inspection, traced);
    let mut player = Player::new(kind, start);
    player.stepped_back = step_back(kind, &start, scene, aspect);
    player
}

/// Takes the observer so far back that the camera stays in sight on its way; the observer before and
/// after. What a lesson's step plays is seen from where the step says.
fn step_back(
    kind: Kind,
    start: &Start,
    scene: &mut OpenScene,
    aspect: f64,
) -> Option<[Observer; 2]> {
    let of_step = scene.lessons.open.as_ref().and_then(|open| open.step().view.play);
    let before = scene.session.observer.filter(|_| of_step != Some(kind))?;
    let after = before.following(&start.camera, &start.cameras(kind), aspect);
    scene.session.observer = Some(after);
    (after != before).then_some([before, after])
}

/// Sets what the animation moves, and leaves alone what it does not.
fn show_still(player: &mut Player, still: &Still, scene: &mut OpenScene) {
    still.show(player.kind, &mut scene.open.document, &mut scene.session);
    player.shown = scene.open.document.camera;
}
