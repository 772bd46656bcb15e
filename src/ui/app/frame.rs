//! The order of a frame: inputs, actions, derivation, outputs.
//!
//! Panels edit the document while they are drawn, from the top of the window to the bottom. At the end of the
//! pass, the document and the session are compared with their state before the panels were drawn. If anything
//! on the screen is out of date, egui runs the pass again before it presents anything. If a pass panics, the
//! next one shows a page about the panic: the scene is kept, and the user chooses how to continue.

use egui::{
    CentralPanel, Context, Frame, Key, Modifiers, Panel, Popup, Rangef, Rect, RichText, ScrollArea,
    Ui, UiBuilder,
};
use pinhole_core::Camera;
use pinhole_exchange::document::Document;
use pinhole_figure::Hovered;
use pinhole_figure::typesetting::theme;
use pinhole_lecture::numbers::grouped;

use crate::features::translator;
use crate::model::fault::caught;
use crate::model::session::Split;
use crate::model::{Session, Shown, ViewLayout, Workspace};
use crate::ui::action::{
    Action, Available, FileUse, Leave, LookAction, Switch, VoteAction, is_any_requested, request,
    take_requested,
};
use crate::ui::app::scene::OpenScene;
use crate::ui::app::{App, apply, files, over};
use crate::ui::commands_table::{self, When};
use crate::ui::panels::{camera, objects, section, start_buttons, top_bar};
use crate::ui::scene::{Divider, ViewInput, ViewRects, readouts, views};
use crate::ui::stage::{Stage, navigation};
use crate::ui::widgets::{clipped, pointed_at};
use crate::ui::workspaces::{Page, page};
use crate::ui::{PageContext, second_picture};
use crate::view::derive::Deriver;

/// Width of the side panel, in points, and the range to which it can be dragged.
const PANEL_WIDTH: f32 = 336.0;
const PANEL_WIDTHS: Rangef = Rangef { min: 316.0, max: 560.0 };

/// Minimum width of the window in which the panel is beside the views, in points.
const LEAST_WINDOW: f32 = 640.0;

impl App {
    /// Runs one frame.
    fn frame(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.waiting.drain(..).for_each(|action| request(&ctx, action));
        let OpenScene { open, session, chosen_object, .. } =
            self.question.as_mut().unwrap_or(&mut self.scene);
        let (document, shown) = (&mut open.document, &self.views.derived);
        let mut input = ViewInput { ctx: &ctx, shown, document, session, chosen_object };
        self.dragging.take(&mut input, self.over.covers());
        self.window_inputs(&ctx);
        let (document, session) = (self.scene.open.document.clone(), self.scene.session.clone());
        let mut start = PassStart { document, session, marks: self.scene.marks() };
        self.panels(ui, &mut start);
        // The first pass has no layout yet.
        let mut is_old = !std::mem::replace(&mut self.is_laid_out, true);
        let frame = Frame::central_panel(ui.style()).inner_margin(0);
        CentralPanel::default().frame(frame).show(ui, |ui| {
            self.question = self.scene.question(self.question.take());
            let stage = self.stage(ui);
            let rects = self.rects(ui, stage.as_ref());
            self.view_inputs(ui, &rects);
            for action in take_requested(&ctx) {
                // Moving the camera or the observer changes only the views. Other actions may show in bars or
                // dialogs, which are already drawn.
                is_old |=
                    !matches!(action, Action::Steer(_) | Action::Observe(_) | Action::Figure(_));
                self.apply(&ctx, action);
            }
            if is_old {
                // An action may have opened or left an exercise.
                self.question = self.scene.question(self.question.take());
            }
            self.derive(ui, &rects);
            self.note_directed(&ctx);
            self.outputs(ui, &rects, stage.as_ref());
            self.code_over(ui, stage.as_ref());
            if self.scene.session.presenting.is_some() && theme::installed(&ctx).by_touch {
                navigation::for_fingers(&ctx, self.lesson().is_some());
            }
            is_old |= is_any_requested(&ctx);
            if let Some(pen) = &mut self.scene.session.live.pen {
                views::pen(ui, ui.max_rect(), pen);
            }
        });
        self.over.marks(ui);
        if let Some(presenting) = self.scene.session.presenting.as_mut().filter(|now| now.is_blank)
        {
            presenting.is_blank = !over::blank(&ctx);
        }
        self.end_pass(&ctx, start, is_old);
    }

    /// Records what has changed in the pass. Asks for another pass if something on the screen is out of date.
    fn end_pass(&mut self, ctx: &Context, start: PassStart, is_old: bool) {
        // A drag is a single undo step. The frames of an animation are not recorded as steps.
        if !self.playback.plays_camera() && ctx.input(|i| !i.pointer.any_down()) {
            self.settle(ctx, None);
        }
        self.recovery.follow(ctx, &self.scene.open);
        if let Some(reason) = self.recovery.take_fault() {
            self.say("Unsaved changes cannot be recorded".to_owned(), vec![reason]);
        }
        self.record_animation(ctx);
        self.window.follow(ctx, &self.scene);
        if start.session.progress != self.scene.session.progress {
            // It must not be lost if the program does not end as it should.
            self.window.save_now();
        }
        if is_old || self.scene.has_changed_since(start) {
            ctx.request_discard("an edit changed what was drawn before it");
        }
    }

    pub(super) fn page(&self) -> Page {
        let session = &self.scene.session;
        let layout = session.shown.setup.layout;
        // While a question waits for the class's answer, the views take the space of the derivation or the
        // graph.
        let asks = session.shown.is_asking && layout.reveals_lines();
        page(if asks { ViewLayout::Both } else { layout })
    }

    /// Handles keys, the clipboard, dropped files and the close button.
    fn window_inputs(&mut self, ctx: &Context) {
        if self.over.dialog.is_none() && !is_any_requested(ctx) {
            self.over.dialog = self.recovery.offer();
        }
        // While a dialog is open, keys, pasted text and dropped files are ignored: the dialog's answer
        // would otherwise apply to another scene.
        let presenting = self.scene.session.presenting.as_mut();
        if let Some(blank) = presenting.map(|p| &mut p.is_blank).filter(|blank| **blank) {
            *blank = !over::took_key(ctx);
        } else if !self.over.covers() {
            self.keys(ctx);
            let dropped = ctx.input(|i| i.raw.dropped_files.first().map(|f| f.path().to_owned()));
            let dropped = dropped.map(|path| Action::Use(FileUse::Open, path));
            files::pasted(ctx).into_iter().chain(dropped).for_each(|action| request(ctx, action));
        }
        if self.window.is_to_close(ctx) {
            self.stop_animation();
            let has_changes = self.scene.open.has_changes();
            self.window.let_close(ctx, !has_changes);
            if has_changes {
                self.ask_about_changes(Leave::Quit);
            }
        }
        self.window.kept.window.update(ctx);
    }

    /// Requests the actions of the pressed keys, except for keys that work only in the views: [`views`]
    /// handles those.
    fn keys(&mut self, ctx: &Context) {
        let is_typing = ctx.text_edit_focused();
        let has_focus = ctx.memory(|memory| memory.focused().is_some());
        let has_lesson = self.scene.lessons.open.is_some();
        let presenting = self.scene.session.presenting.is_some();
        let has_animation = self.playback.player.is_some();
        let is_voting = self.scene.session.is_voting();
        let pressed = commands_table::pressed(ctx, |when| match when {
            When::Anywhere => true,
            When::Untyped => !is_typing,
            When::Vote => is_voting,
            When::VoteUntyped => is_voting && !is_typing,
            When::VoteUnfocused => is_voting && !has_focus,
            When::Lesson => has_lesson,
            When::LessonUntyped => has_lesson && !is_typing,
            When::LessonUnfocused => has_lesson && !has_focus,
            When::Presenting => presenting && !is_typing,
            When::PresentingStill => presenting && !is_typing && !has_animation,
            When::View | When::CameraView | When::WorldView => false,
        });
        for (when, action) in pressed {
            let focused = ctx.memory(|memory| memory.focused());
            let ends_typing = matches!(when, When::Anywhere | When::Lesson | When::Vote);
            match focused.filter(|_| ends_typing) {
                // The field must lose the focus first, to accept the typed number; the action follows in the
                // next pass.
                Some(focused) => {
                    ctx.memory_mut(|memory| memory.surrender_focus(focused));
                    self.waiting.push(action);
                    ctx.request_repaint();
                }
                None => request(ctx, action),
            }
        }
        // Before Escape ends presenter mode, it ends a drag, closes a menu, releases the focus, ends a vote on a
        // step's question, or puts the code or the pen away.
        let is_busy = has_focus || Popup::is_any_open(ctx) || ctx.input(|i| i.pointer.any_down());
        if presenting && !is_busy && ctx.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape))
        {
            if self.over.code.take().is_some() {
                return;
            }
            let live = &self.scene.session.live;
            match (&live.vote, &live.pen) {
                (Some(_), _) => request(ctx, VoteAction::End),
                (None, Some(_)) => request(ctx, LookAction::Toggle(Switch::Pen)),
                (None, None) => request(ctx, LookAction::Present),
            }
        }
    }

    /// Returns which preconditions of commands hold.
    pub(super) fn available(&self) -> Available<'_> {
        Available {
            session: &self.scene.session,
            undo: self.history.steps.undo_name(),
            redo: self.history.steps.redo_name(),
            lesson: self.scene.lessons.open.is_some(),
            animation: self.playback.player.is_some(),
            object: self.page().has_panel
                && self.question.is_none()
                && self.scene.chosen_object.is_some(),
        }
    }

    /// Draws everything around the views, from the top.
    fn panels(&mut self, ui: &mut Ui, start: &mut PassStart) {
        self.overlays(ui.ctx());
        apply::follow_look(ui.ctx(), &self.scene.session);
        let presenting = self.scene.session.presenting.is_some();
        if !presenting {
            let (open, recent) = (&self.scene.open, &self.window.kept.recent);
            Panel::top("top bar").show(ui, |ui| top_bar::ui(ui, open, recent, self.available()));
        }
        // Another layout shows at once in what is drawn below.
        for action in take_requested(ui.ctx()) {
            match action {
                Action::Look(look @ LookAction::Layout(_)) => {
                    apply::change_look(&mut self.scene.session, look);
                }
                other => request(ui.ctx(), other),
            }
        }
        self.advance_animation(ui);
        let session = &self.scene.session;
        // The panels above do not show the values that an animation changes, so they need not be drawn
        // again.
        start.session.shown.ray_point_t = session.shown.ray_point_t;
        // On a phone the panel is below, and what is not about the scene has all the space.
        let is_narrow = ui.available_width() < LEAST_WINDOW;
        let is_scene = session.shown.setup.layout.workspace() == Some(Workspace::Scene);
        let is_alone = is_narrow && (self.scene.has_stage() || !is_scene);
        let hidden = presenting || is_alone || session.preferences.hides_panel;
        if !hidden && self.page().has_panel {
            let panel = match is_narrow {
                true => Panel::bottom("panel below").default_size(0.3 * ui.available_height()),
                false => Panel::left("panel").default_size(PANEL_WIDTH).size_range(PANEL_WIDTHS),
            };
            panel.resizable(true).show(ui, |ui| {
                if self.scene.lessons.open.is_none() {
                    let foot = Panel::bottom("start").show_separator_line(false).frame(Frame::NONE);
                    foot.show(ui, start_buttons);
                }
                // Content that is too wide is clipped, so that the panel keeps the width that the user has
                // set.
                let rect = ui.available_rect_before_wrap();
                let mut inside = ui.new_child(UiBuilder::new().max_rect(rect));
                ScrollArea::vertical().auto_shrink(false).show(&mut inside, |ui| {
                    self.left_panel(ui);
                });
                ui.advance_cursor_after_rect(rect);
            });
        }
    }

    fn left_panel(&mut self, ui: &mut Ui) {
        let scene = &mut self.scene;
        let document = &mut scene.open.document;
        ui.add_space(4.0);
        let before = document.camera;
        camera::ui(ui, &mut document.camera, &mut scene.session);
        scene.session.follow_camera(&before, &document.camera);
        let Session { shown, preferences: settings, .. } = &mut scene.session;
        let Shown { selection, setup, is_asking, .. } = shown;
        ui.separator();
        let resolved = document.camera.resolve().ok();
        // The ray's numbers may be the answer to the question.
        if !*is_asking {
            let uv = resolved.as_ref().map(|resolved| selection.uv(resolved));
            let uv = uv.map(|uv| setup.number_style().uv(uv));
            section(
                ui,
                "Selected ray",
                &uv.unwrap_or_default(),
                &mut settings.unfolded.ray,
                |ui| {
                    camera::selected_ray(ui, selection, resolved.as_ref(), setup.count_from_one);
                },
            );
            ui.separator();
        }
        let chosen = &mut scene.chosen_object;
        // If an object was chosen elsewhere, the section with its fields unfolds.
        let mut is_open = settings.unfolded.objects || chosen.is_some();
        let count = grouped(document.object_count() as u64);
        section(ui, "Objects", &count, &mut is_open, |ui| objects::ui(ui, document, chosen));
        if !is_open {
            *chosen = None;
        }
        settings.unfolded.objects = is_open;
        if !document.note.is_empty() {
            ui.separator();
            let beginning = document.note.replace('\n', " ");
            section(ui, "What to look for", &beginning, &mut settings.unfolded.note, |ui| {
                for paragraph in document.note.split("\n\n") {
                    ui.label(paragraph.replace('\n', " "));
                }
            });
        }
        ui.add_space(8.0);
    }

    /// Returns the stage of the open vote or of the lesson's step; `None` without either.
    fn stage(&self, ui: &Ui) -> Option<Stage> {
        let whole = ui.available_rect_before_wrap();
        let Session { shown, presenting, .. } = &self.scene.session;
        let is_flat = self.scene.session.shows_exercise() && self.question.is_none();
        let is_swapped = presenting.is_some_and(|now| now.is_swapped(shown.setup.layout));
        let stage = Stage::new(whole, shown.setup.layout, self.band(whole));
        // A question in two dimensions has no camera.
        let layout = if is_flat { ViewLayout::Lines } else { shown.setup.layout };
        self.scene.has_stage().then_some(Stage { is_swapped, layout, ..stage })
    }

    /// Returns the height of the numbers at the foot of the main figure.
    fn band(&self, whole: Rect) -> f32 {
        let Session { shown, presenting, preferences: settings, .. } = &self.scene.session;
        let has_room = whole.width() > readouts::LEAST;
        match (presenting, settings.unfolded.numbers) {
            _ if shown.setup.layout == ViewLayout::Exercises => 0.0,
            (None, true) if has_room => settings.splits.get(Split::Readouts),
            _ if settings.presents_numbers => readouts::BAND,
            _ => 0.0,
        }
    }

    /// Lays out the views and the rest of the page.
    fn rects(&mut self, ui: &mut Ui, stage: Option<&Stage>) -> ViewRects {
        let whole = ui.available_rect_before_wrap();
        let (areas, band) = (self.page().areas, self.band(whole));
        let session = &mut self.scene.session;
        let presenting = session.presenting.is_some();
        let image = self.scene.open.document.camera.image;
        let per_point = ui.ctx().pixels_per_point();
        if let Some(areas) = stage.and_then(|stage| stage.areas(image)) {
            return ViewRects::new(areas, image, per_point, true);
        }
        let whole = stage.map_or(whole, |stage| stage.main);
        let has_all_numbers = !presenting && session.preferences.unfolded.numbers;
        let splits = &mut session.preferences.splits;
        let areas = areas(&mut Divider { ui, whole, splits, image, band, has_all_numbers });
        ViewRects::new(areas, image, per_point, presenting)
    }

    /// Handles mouse and keys in the views, and determines what is under the pointer.
    fn view_inputs(&mut self, ui: &mut Ui, rects: &ViewRects) {
        let page = self.page();
        // If keys or a lesson's step change the selection while the pointer rests, the selected ray is shown
        // rather than the ray under the pointer.
        let (pointer, selection) =
            (ui.input(|i| i.pointer.latest_pos()), self.scene.session.shown.selection);
        if self.views.seen_selection.replace(selection) != Some(selection) {
            self.views.rested_at = pointer;
        }
        let rests = self.views.rested_at.is_some() && self.views.rested_at == pointer;
        let scene = self.question.as_mut().unwrap_or(&mut self.scene);
        let shown = &self.views.derived;
        if let Some(size) = views::world_size(rects) {
            let is_at_rest = !ui.input(|i| i.pointer.any_down()) && !self.playback.is_running();
            scene.frame(size, is_at_rest);
            if scene.direct(size, is_at_rest) {
                self.views.glide.begin(ui.ctx());
            }
        }
        let mut hovered: Option<Hovered> = None;
        let mut pointed_ray = None;
        if !self.over.covers() {
            let is_asking = scene.session.shown.is_asking;
            let second = page.second.map_or("", |second| second_picture::name(second, is_asking));
            views::inputs(ui, rects, second, &mut scene.session, shown);
            let is_free = scene.session.live.handles.over.is_none();
            let is_followed = page.follows_pointer && is_free && !rests;
            pointed_ray = is_followed.then(|| views::pointed_ray(ui, rects, shown)).flatten();
            hovered = views::hovered(ui, rects, shown, pointed_ray.is_some())
                .or_else(|| pointed_at(ui.ctx(), page.lights?));
        }
        scene.session.live.hovered = hovered;
        scene.session.live.pointed_ray = pointed_ray;
        scene.session.live.alt_dims = ui.input(|i| i.modifiers.alt);
        self.scene.session.live.hovered = hovered;
    }

    /// Shows the views and the rest of the page. Their changes to the session take effect in the next pass.
    fn outputs(&mut self, ui: &mut Ui, rects: &ViewRects, stage: Option<&Stage>) {
        let page = self.page();
        if let Some(stage) = stage {
            // Its pictures and graphs need not cover it.
            ui.painter().rect_filled(stage.main, 0.0, theme::style(ui).colors().background);
        }
        self.show_views(ui, rects, stage.is_some());
        let style = self.scene.session.number_style();
        let is_changed = self.scene.differs_from_step();
        // Practice has its own exercise, which is not the step's.
        let is_practice =
            self.scene.session.shows_exercise() && self.scene.step_of_exercise().is_none();
        let mut context = PageContext {
            open: &self.scene.open,
            session: &mut self.scene.session,
            derived: &self.views.derived,
            tools: &mut self.tools,
            style,
            step: self.scene.lessons.step(is_changed).filter(|_| !is_practice),
        };
        // A vote asks its own question, and reveals nothing about the step's question.
        let is_vote = context.session.shows_vote();
        if let (Some(second), Some(area), Some(rect)) =
            (page.second, rects.second_area, rects.second)
        {
            let on_stage = rects.camera_area.filter(|_| stage.is_some() && !is_vote);
            second_picture::show(ui, &mut context, second, [area, rect], on_stage);
        }
        match stage {
            Some(stage) if is_vote => {
                clipped(ui, stage.column, |ui| (page.rest)(ui, &mut context));
            }
            Some(stage) => stage.show(ui, rects.rest, &mut context),
            None => clipped(ui, rects.rest, |ui| (page.rest)(ui, &mut context)),
        }
        let OpenScene { open, session, .. } = &mut self.scene;
        translator::ui::notice(ui, &mut session.translator.notice, &open.document.camera);
    }
}

/// The document and the session at the start of a pass, before the panels are drawn.
struct PassStart {
    document: Document,
    session: Session,
    marks: [bool; 2],
}

impl OpenScene {
    /// Returns true if anything that panels show has changed since the start of the pass, in which case the
    /// pass must run again.
    fn has_changed_since(&self, start: PassStart) -> bool {
        let (before, now) = (&start.document, &self.open.document);
        // The observer and what is under the hand are set before the views are derived, and only the views
        // show them.
        let shown = Shown { observer: self.session.shown.observer, ..start.session.shown };
        let session = Session { shown, live: self.session.live.clone(), ..start.session };
        !is_same_but_for_pose(&before.camera, &now.camera)
            || before.spheres != now.spheres
            || before.planes != now.planes
            || start.marks != self.marks()
            || session != self.session
    }
}

/// Returns true if the cameras are equal, or if they differ only in *eye* and orientation, which only the
/// camera's own fields and the views show. In the latter case, both must also be valid and given in the same
/// way.
fn is_same_but_for_pose(before: &Camera, now: &Camera) -> bool {
    let moved = Camera { eye: now.eye, orientation: now.orientation, ..*before };
    let is_same_kind = before.orientation.kind() == now.orientation.kind();
    let can_see = || before.resolve().is_ok() && now.resolve().is_ok();
    before == now || (moved == *now && is_same_kind && can_see())
}

impl App {
    /// Runs one frame, or shows the page about a panic in the last frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        let shown = match self.failure.take() {
            Some(failure) => caught(|| self.failure_page(ui, failure)),
            None => caught(|| self.frame(ui)),
        };
        if let Err(failure) = shown {
            self.failure = Some(failure);
            // Discard whatever the failed pass left unfinished.
            self.waiting.clear();
            take_requested(ui.ctx());
            self.over.dialog = None;
            self.views.deriver = Deriver::default();
            // The pass that failed did not get as far as saving the edit that caused the failure.
            self.recovery.write_changes(&self.scene.open);
            ui.ctx().request_repaint();
        }
    }

    fn failure_page(&mut self, ui: &mut Ui, failure: String) {
        let ctx = ui.ctx().clone();
        if self.window.is_to_close(&ctx) {
            // The next start offers the changes.
            self.window.let_close(&ctx, true);
        }
        // The last change may not be an undo step yet.
        self.settle(&ctx, None);
        let mut stays = true;
        CentralPanel::default().show(ui, |ui| {
            ui.heading("Pinhole ran into an internal error");
            ui.label("Your scene is kept, and unsaved changes are in a recovery file.");
            ui.add_space(8.0);
            ui.label(RichText::new(&failure).monospace());
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                stays &= !ui.button("Go on").clicked();
                let can_undo = self.history.steps.undo_name().is_some();
                let undo = ui.add_enabled(can_undo, egui::Button::new("Undo and go on"));
                if undo.on_hover_text("Goes on without the last change").clicked() {
                    self.undo_or_redo(&ctx, false);
                    stays = false;
                }
                if ui.button("Copy a report").clicked() {
                    ctx.copy_text(self.report_of(&failure));
                }
            });
        });
        if stays {
            self.failure = Some(failure);
        } else {
            ctx.request_repaint();
        }
    }

    /// Returns a bug report about the failure.
    fn report_of(&self, failure: &str) -> String {
        let (version, system) = (env!("CARGO_PKG_VERSION"), std::env::consts::OS);
        let scene = pinhole_exchange::scene_file::to_text(self.document(), None);
        let renderer = &self.window.kept.renderer;
        format!("Pinhole {version} on {system}, drawn by {renderer}\n{failure}\n\n{scene}")
    }
}
