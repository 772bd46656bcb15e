//! Derives the views, adapts their resolution during drags, and shows their pictures.

use std::time::Duration;

use egui::{Context, Event, Key, Pos2, Ui, Vec2};
use pinhole_core::Selection;
use pinhole_figure::concept::Directed;
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::{Fault, ViewSize};

use super::App;
use super::glide::Glide;
use crate::features::exercises;
use crate::model::{Live, Session, Shown};
use crate::ui::frame_times::{FrameWork, Stopwatch};
use crate::ui::scene::{ViewRects, gizmo, views};
use crate::ui::widgets::ViewTexture;
use crate::view::adaptive_resolution::{AdaptiveResolution, REST, Subsampling};
use crate::view::derive::{Derived, Deriver, ViewSizes};

/// Keys that move the camera, the observer or a handle, and repeat while they are held.
const STEERING: [Key; 7] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Plus,
    Key::Equals,
    Key::Minus,
];

/// The derived values and the textures of the views.
#[derive(Default)]
pub(super) struct Views {
    pub(super) deriver: Deriver,
    pub(super) derived: Derived,
    pub(super) adaptive_resolution: AdaptiveResolution,
    /// The selection in the last pass.
    pub(super) seen_selection: Option<Selection>,
    /// The pointer's position when the selection last changed.
    pub(super) rested_at: Option<Pos2>,
    pub(super) frame_work: FrameWork,
    /// The observer's glide to another view.
    pub(super) glide: Glide,
    world_size: Option<ViewSize>,
    world: ViewTexture,
    camera: ViewTexture,
}

impl Views {
    /// Returns the size of the world view in the last pass that showed it.
    pub(super) fn world_size(&self) -> ViewSize {
        self.world_size.unwrap_or(ViewSize::of_aspect(1.25))
    }

    /// Shows the pictures with their labels. An inset is drawn over the other view.
    fn show(&mut self, ui: &Ui, rects: &ViewRects, spoken: &str) {
        self.world_size = views::world_size(rects).or(self.world_size);
        let Views { derived, world, camera, .. } = self;
        let has_world_inset = rects.has_world_inset();
        let both = rects.world.zip(rects.camera);
        let has_camera_inset = both.is_some_and(|(world, camera)| world.contains_rect(camera));
        let is_stale = matches!(derived.fault, Some(Fault::Scene(_)));
        let world = (rects.world, &derived.world_view, world, is_stale, views::WORLD);
        let camera =
            (rects.camera, &derived.camera_view, camera, derived.fault.is_some(), views::CAMERA);
        let in_order = match has_world_inset {
            true => [(camera, false), (world, true)],
            false => [(world, false), (camera, has_camera_inset)],
        };
        for ((rect, view, texture, is_stale, name), is_inset) in in_order {
            let (Some(rect), Some(view)) = (rect, view) else { continue };
            if is_inset {
                views::frame_inset(ui, rect);
            }
            views::show(ui, rect, view, texture, is_stale);
            views::speak(ui, name, spoken);
        }
    }
}

impl App {
    /// Notes what the newest revealed line of the derivation is about, to which the next pass directs the observer. While
    /// the pointer shows another ray, or the page has no derivation, that stays as it was.
    pub(super) fn note_directed(&mut self, ctx: &Context) {
        let session = &mut self.scene.session;
        let (shown, before) = (&session.shown, session.live.directed);
        let of_step = Directed::to(&shown.subject).filter(|_| session.presenting.is_some());
        session.live.directed = match (shown.revealed_lines, &self.views.derived.derivation) {
            _ if self.question.is_some() => None,
            // What a question asks for is not pointed at.
            _ if shown.is_asking || !shown.setup.layout.reveals_lines() => of_step,
            (None, _) => None,
            (Some(count), Some(lines)) if session.live.pointed_ray.is_none() => {
                lines.directed(count).or(of_step)
            }
            _ => before,
        };
        if session.live.directed != before {
            ctx.request_repaint();
        }
    }

    /// Derives everything that is shown.
    pub(super) fn derive(&mut self, ui: &Ui, rects: &ViewRects) {
        let (ctx, second) = (ui.ctx(), self.page().second.zip(rects.second));
        let (scene, views) = (self.question.as_ref().unwrap_or(&self.scene), &mut self.views);
        let time = ctx.input(|i| i.time);
        let objects = scene.open.document.object_count();
        let moves = self.playback.is_running() || is_hand_moving(ctx);
        let subsampling = views.adaptive_resolution.now(moves, time, objects);
        let under_hand = views.adaptive_resolution.is_followed(time);
        let second = second.map(|(second, rect)| (second, views::physical(ui, rect)));
        let sizes = ViewSizes { subsampling, under_hand, second, ..views::sizes(ui, rects) };
        // Dropping this reference lets spheres be updated in place rather than copied.
        views.derived.scene = None;
        let stopwatch = Stopwatch::start();
        let watch = |work| stopwatch.record(work);
        let (document, session) = (&scene.open.document, &scene.session);
        let (step, is_still) =
            (self.scene.lessons.open.as_ref(), session.preferences.reduced_motion);
        let observer = views.glide.follow(ctx, step, session.shown.observer, is_still);
        // Where all lines are there at once, none is revealed or taken back.
        let is_whole = is_still || session.shown.revealed_lines.is_none();
        let growth = views.glide.growth(ctx, session.live.directed, is_whole);
        let gliding = (observer != session.shown.observer || growth.is_some()).then(|| {
            let shown = Shown { observer, ..session.shown.clone() };
            let mut live = Live { growth: growth.map(|(_, share)| share), ..session.live.clone() };
            live.directed = growth.map(|(directed, _)| directed).or(live.directed);
            Session { shown, live, ..session.clone() }
        });
        let session = gliding.as_ref().unwrap_or(session);
        views.derived = views.deriver.derive_watched(document, session, &sizes, &watch);
        let times = stopwatch.stop();
        let [traced, ..] = times;
        if !traced.is_zero() {
            views.adaptive_resolution.took(subsampling, traced);
        }
        views.frame_work.add(ctx.cumulative_frame_nr(), times);
        // Coarse pictures are refined once the drag pauses. Grading may also be postponed until then.
        let waits = views.adaptive_resolution.is_followed(time) && session.answers.is_some();
        let is_coarse = |shown: &Subsampling| views.adaptive_resolution.is_made_finer(*shown);
        if waits || views.derived.subsampling.iter().any(is_coarse) {
            ctx.request_repaint_after(Duration::from_secs_f64(REST));
        }
    }

    /// Returns what the views tell a screen reader.
    fn spoken_in_views(&self) -> String {
        match (&self.question, self.scene.session.shown.is_asking) {
            (Some(asked), _) => {
                let marks = exercises::marks::spoken(&self.views.derived.answer_marks);
                let has_ghost = asked.session.exercises.ghost().is_some();
                if has_ghost { format!("{marks}, wrong camera (dashed)") } else { marks }
            }
            (None, true) => String::new(),
            (None, false) => self.hit(),
        }
    }

    /// Shows the pictures with their labels.
    pub(super) fn show_views(&mut self, ui: &mut Ui, rects: &ViewRects, on_stage: bool) {
        let spoken = self.spoken_in_views();
        let App { scene, question, dragging, views: shown, .. } = self;
        let scene = question.as_mut().unwrap_or(scene);
        shown.show(ui, rects, &spoken);
        let derived = &shown.derived;
        let picture = rects.camera.or(rects.world);
        if scene.session.presenting.is_none() && !on_stage {
            let image = scene.open.document.camera.image;
            views::strips(ui, rects, &scene.session, image);
            if let (Some(area), Some(frame)) =
                (rects.world.and_then(|world| gizmo::area(ui, world)), &derived.world_frame)
            {
                gizmo::show(ui, area, frame.camera().basis());
            }
        }
        let (document, session) = (&scene.open.document, &scene.session);
        // The tooltip of the pointed ray and the text of a drag or step are not shown at the same time.
        let is_steered = dragging.has_step_text(session, ui.input(|i| i.time));
        if session.live.handles.over.is_none() && !is_steered && !session.shown.is_asking {
            views::show_pointed(ui, session, derived, document);
        }
        if let (Some(rect), Some(fault)) = (picture, derived.fault) {
            views::reason(ui, rect, &typeset_message(fault));
        }
        for (rect, subsampling) in [rects.camera, rects.world].into_iter().zip(derived.subsampling)
        {
            // A picture from before an error is marked as such and is not refined.
            let text = shown.adaptive_resolution.message(subsampling);
            let text = text.filter(|_| derived.fault.is_none());
            if let (Some(rect), Some(text)) = (rect, text) {
                views::badge(ui, rect, &text);
            }
        }
        if let (Some(rect), Some(world)) = (rects.world, &derived.world_view)
            && world.is_empty()
        {
            let text = "Nothing is in sight: Frame all in the menu View, or a double click, shows everything";
            views::badge(ui, rect, text);
        }
        dragging.show_text(ui, rects, (document, session), derived);
    }
}

/// Returns true if mouse or keys are moving the views.
fn is_hand_moving(ctx: &Context) -> bool {
    ctx.input(|i| {
        let drags = i.pointer.any_down() && i.pointer.delta() != Vec2::ZERO;
        let scrolls = i.smooth_scroll_delta() != Vec2::ZERO || i.zoom_delta() != 1.0;
        // The set of held keys is unreliable: if Shift is released before =, the key whose release is
        // reported is a different one.
        let is_steering = |event: &Event| {
            matches!(event, Event::Key { key, pressed: true, .. } if STEERING.contains(key))
        };
        let is_steered = i.events.iter().any(is_steering);
        drags || scrolls || is_steered
    })
}
