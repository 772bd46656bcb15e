//! Opens, plays, closes and exports animations. An export writes one frame per pass of the window, so that
//! the window keeps responding.

use std::path::PathBuf;

use egui::{Context, Panel, Ui};

use super::history::SceneHistory;
use super::scene::OpenScene;
use crate::figures::{Animation, Frames, Order, Recorder};
use crate::model::inspection::Inspection;
use crate::model::observer::Observer;
use crate::model::play::{Kind, Player, Start, Still, ray_point_end};
use crate::model::session::Session;
use crate::ui::action::PlayAction;
use crate::ui::dialogs::Dialog;
use crate::ui::panels::play;
use crate::view::derive::Derived;

/// The open animation, and the one being exported.
#[derive(Default)]
pub(super) struct Playback {
    pub(super) player: Option<Player>,
    recorder: Option<Recorder>,
}

impl Playback {
    /// Advances the open animation, shows its strip and updates the scene, before anything else draws the
    /// scene.
    pub(super) fn go_on(
        &mut self,
        ui: &mut Ui,
        scene: &mut OpenScene,
        history: &mut SceneHistory,
        inspection: Option<&Inspection>,
    ) {
        let ctx = ui.ctx().clone();
        let Some(player) = &mut self.player else { return };
        let camera = &scene.open.document.camera;
        let moved =
            (camera.eye, camera.orientation) != (player.shown.eye, player.shown.orientation);
        if player.kind.moves_camera() && moved {
            // An edit of the camera ends the animation.
            self.keep(&ctx, scene, history);
            return;
        }
        player.start.camera.image = camera.image;
        player.start.camera.viewport = camera.viewport;
        player.start.end = ray_point_end(inspection);
        player.reduced = scene.session.settings.reduced_motion;
        player.go_on(ctx.input(|input| input.time));
        Panel::bottom("play").show(ui, |ui| play::ui(ui, player));
        if player.running {
            ctx.request_repaint();
        }
        let still = player.still();
        show_still(player, &still, scene);
    }

    /// Applies an action of the strip or a key.
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

    /// Closes the animation and restores the state from before it.
    pub(super) fn give_back(&mut self, scene: &mut OpenScene) {
        let Some(mut player) = self.player.take() else { return };
        // The observer stays if the user has moved it since.
        let observer = &mut scene.session.observer;
        *observer = match player.stepped_back {
            Some([before, after]) if *observer == Some(after) => Some(before),
            _ => *observer,
        };
        let still = player.start.still();
        show_still(&mut player, &still, scene);
    }

    /// Closes the animation and keeps the current state. Records an undo step if the animation moved the
    /// camera.
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
            // True if nothing but the camera's eye and orientation has changed since the last step.
            let mut before = history.settled().clone();
            (before.camera.eye, before.camera.orientation) = (camera.eye, camera.orientation);
            let only_moved = before == scene.open.document;
            history.settle_as(ctx, &scene.open.document, only_moved.then_some(name));
            scene.open.document.camera = edited;
        }
    }

    /// Returns true if an animation that moves the camera is open. Its frames are not undo steps.
    pub(super) fn plays_camera(&self) -> bool {
        self.player.as_ref().is_some_and(|player| player.kind.moves_camera())
    }

    /// Returns true if an animation is moving the camera.
    pub(super) fn is_running(&self) -> bool {
        self.plays_camera() && self.player.as_ref().is_some_and(|player| player.running)
    }

    /// Starts to export the open animation. Returns the dialog that shows the progress or an error.
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

    /// Writes the next frame of the export, if one is running. Cancels the export if its dialog was closed.
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

/// Creates an animation at its start.
fn opened(kind: Kind, scene: &mut OpenScene, derived: &Derived, aspect: f64) -> Player {
    let (inspection, traced) = (derived.inspection.as_deref(), derived.scene.as_deref());
    let start = Start::new(&scene.open.document, &scene.session, inspection, traced);
    let mut player = Player::new(kind, start);
    player.stepped_back = step_back(kind, &start, scene, aspect);
    player
}

/// Moves the observer back until the camera stays in sight throughout the animation. Returns the observer
/// before and after, if it moved. An animation of a lesson's step keeps the step's observer.
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

/// Sets the parts of the scene that the animation changes.
fn show_still(player: &mut Player, still: &Still, scene: &mut OpenScene) {
    still.show(player.kind, &mut scene.open.document, &mut scene.session);
    player.shown = scene.open.document.camera;
}
