//! Opens, plays, closes and exports animations. An export writes one frame per pass of the window, so that
//! the window keeps responding.

use std::path::PathBuf;

use egui::{Context, Panel, Ui};
use pinhole_figure::Observer;

use super::App;
use super::scene::OpenScene;
use crate::features::export::animation::{Animation, Frames, Recorder};
use crate::features::export::order::Order;
use crate::features::play::state::{Kind, Start, Still, ray_point_end};
use crate::features::play::{self, Player};
use crate::ui::action::PlayAction;
use crate::ui::dialogs::Dialog;

/// The open animation, and the one being exported.
#[derive(Default)]
pub(super) struct Playback {
    pub(super) player: Option<Player>,
    recorder: Option<Recorder>,
}

impl Playback {
    /// Returns true if an animation that moves the camera is open. Its frames are not undo steps.
    pub(super) fn plays_camera(&self) -> bool {
        self.player.as_ref().is_some_and(|player| player.kind.moves_camera())
    }

    /// Returns true if an animation is moving the camera.
    pub(super) fn is_running(&self) -> bool {
        self.plays_camera() && self.player.as_ref().is_some_and(|player| player.running)
    }
}

impl App {
    /// Advances the open animation, shows the strip with its controls, and updates the scene. This must
    /// happen before anything else draws the scene.
    pub(super) fn advance_animation(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let Some(player) = &mut self.playback.player else { return };
        let camera = &self.scene.open.document.camera;
        let moved =
            (camera.eye, camera.orientation) != (player.shown.eye, player.shown.orientation);
        if player.kind.moves_camera() && moved {
            // An edit of the camera ends the animation.
            return self.keep_animation(&ctx);
        }
        player.start.camera.image = camera.image;
        player.start.camera.viewport = camera.viewport;
        player.start.end = ray_point_end(self.views.derived.inspection.as_deref());
        player.reduced = self.scene.session.preferences.reduced_motion;
        player.go_on(ctx.input(|input| input.time));
        let is_presenting = self.scene.session.presenting.is_some();
        Panel::bottom("play").show(ui, |ui| play::ui::ui(ui, player, is_presenting));
        if player.running {
            ctx.request_repaint();
        }
        let still = player.still();
        self.scene.open.before_animation =
            player.kind.moves_camera().then_some(player.start.camera);
        show_still(player, &still, &mut self.scene);
    }

    /// Applies an action from the controls of the open animation, or from a key.
    pub(super) fn play(&mut self, ctx: &Context, action: PlayAction) {
        match (action, &mut self.playback.player) {
            (PlayAction::Open(kind), _) => {
                self.stop_animation();
                self.settle(ctx, None);
                self.open_animation(kind);
            }
            (PlayAction::Toggle, Some(player)) => player.toggle(),
            (PlayAction::Step(by), Some(player)) => player.step(by),
            (PlayAction::Loop, Some(player)) => player.loops ^= true,
            (PlayAction::Keep, _) => self.keep_animation(ctx),
            (PlayAction::Close, _) => self.stop_animation(),
            (_, None) => {}
        }
    }

    /// Opens an animation at its start. Moves the observer (the world view's camera) back far enough that the
    /// animated camera stays in sight throughout. The animation of a lesson's step does not move the
    /// observer, because the step has its own.
    fn open_animation(&mut self, kind: Kind) {
        if self.question.is_some() {
            self.say("Leave the exercise to play an animation of a scene".to_owned(), Vec::new());
            return;
        }
        let (scene, derived) = (&mut self.scene, &self.views.derived);
        let (inspection, traced) = (derived.inspection.as_deref(), derived.scene.as_deref());
        let start = Start::new(&scene.open.document, &scene.session, inspection, traced);
        let mut player = Player::new(kind, start);
        let of_step = scene.lessons.open.as_ref().and_then(|open| open.step().play);
        if let Some(before) = scene.session.shown.observer.filter(|_| of_step != Some(kind)) {
            let aspect = self.views.world_size().aspect();
            let after = before.following(&start.camera, &start.cameras(kind), aspect);
            scene.session.shown.observer = Some(after);
            player.stepped_back = (after != before).then_some([before, after]);
        }
        self.playback.player = Some(player);
    }

    /// Closes the animation and restores the state from before it.
    pub(super) fn stop_animation(&mut self) {
        let Some(mut player) = self.playback.player.take() else { return };
        self.scene.open.before_animation = None;
        // The observer stays if the user has moved it since.
        let observer: &mut Option<Observer> = &mut self.scene.session.shown.observer;
        *observer = match player.stepped_back {
            Some([before, after]) if *observer == Some(after) => Some(before),
            _ => *observer,
        };
        let still = player.start.still();
        show_still(&mut player, &still, &mut self.scene);
    }

    /// Closes the animation and keeps the current state. Records an undo step if the animation moved the
    /// camera.
    pub(super) fn keep_animation(&mut self, ctx: &Context) {
        let Some(player) = self.playback.player.take() else { return };
        self.scene.open.before_animation = None;
        self.scene.session.live.scanned_pixels = None;
        if player.kind.moves_camera() {
            let camera = &mut self.scene.open.document.camera;
            let edited = *camera;
            (camera.eye, camera.orientation) = (player.shown.eye, player.shown.orientation);
            let name = player.kind.step_name();
            // True if nothing but the camera's eye and orientation has changed since the last step.
            let mut before = self.history.settled.clone();
            (before.camera.eye, before.camera.orientation) = (camera.eye, camera.orientation);
            let only_moved = before == self.scene.open.document;
            self.settle(ctx, only_moved.then_some(name));
            self.scene.open.document.camera = edited;
        }
    }

    /// Starts to export the open animation, with a dialog that shows the progress.
    pub(super) fn export_animation(&mut self, order: Order, frames: Frames, path: PathBuf) {
        let (Some(player), scene) = (&self.playback.player, &self.scene) else { return };
        let mut session = scene.session.clone();
        (session.live.hovered, session.live.directed) = (None, None);
        let animation = Animation {
            kind: player.kind,
            start: player.start,
            loops: player.loops,
            scene: (scene.open.document.clone(), session),
            order,
            frames,
        };
        match scene.open.check_output(&path).and_then(|()| Recorder::new(animation, path)) {
            Ok(recorder) => {
                self.playback.recorder = Some(recorder);
                self.over.open(Dialog::Progress { done: 0, frames: frames.count });
            }
            Err(problem) => self.tell("The animation was not exported", problem),
        }
    }

    /// Writes the next frame of the export, if one is running. Cancels the export if its dialog was closed.
    pub(super) fn record_animation(&mut self, ctx: &Context) {
        let Some(recorder) = &mut self.playback.recorder else { return };
        let Some(Dialog::Progress { done, frames }) = &mut self.over.dialog else {
            self.playback.recorder = None;
            return;
        };
        let stepped = recorder.figure().and_then(|figure| recorder.push(&figure));
        (*done, *frames) = recorder.progress();
        ctx.request_repaint();
        if stepped.is_ok() && *done < *frames {
            return;
        }
        let recorder = self.playback.recorder.take();
        let ended = stepped.and_then(|()| recorder.map_or(Ok(()), Recorder::finish));
        let problem = |problem| Dialog::message("The animation was not exported", problem);
        self.over.dialog = ended.err().map(problem);
    }
}

/// Sets the parts of the scene that the animation changes to `still`, the state of the animation at one time.
fn show_still(player: &mut Player, still: &Still, scene: &mut OpenScene) {
    still.show(player.kind, &mut scene.open.document, &mut scene.session);
    player.shown = scene.open.document.camera;
}
