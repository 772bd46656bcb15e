//! The open scene: the document, the session that views it, and the lesson that it belongs to.

use std::path::Path;
use std::sync::Arc;

use egui::Context;
use pinhole_core::{Camera, Scene, Selection};
use pinhole_exchange::{FileError, SceneSource};
use pinhole_figure::concept::Directed;
use pinhole_figure::given::{self, Given};
use pinhole_figure::observer::{Drawn, ORDINARY_ASPECT};
use pinhole_figure::overlay::{GhostCamera, Under, drawn, drawn_of, subject};
use pinhole_figure::{Item, Observer, OverlayItems, ViewSize};
use pinhole_lecture::exercises::Asked;
use pinhole_lecture::mistakes::{Mistake, WrongCamera};

use super::lessons::Lessons;
use crate::features::play::state::Kind;
use crate::model::interaction::{FARTHEST, KEY_PAN, KEY_TURN, KEY_ZOOM, NEAREST, NEAREST_GROUND};
use crate::model::lessons::{self, OpenLesson, StepId, Which, apply};
use crate::model::{Ghost, Live, OpenDocument, Session, Shown, ViewLayout};
use crate::ui::action::{ObjectAction, Observe};
use crate::ui::dialogs::Question;
use crate::ui::panels::{camera, objects};

/// The open scene, and everything that undo restores when it returns to a scene.
#[derive(Clone, Debug)]
pub(super) struct OpenScene {
    pub(super) open: OpenDocument,
    pub(super) session: Session,
    pub(super) lessons: Lessons,
    /// Index of the object whose fields and handles are shown.
    pub(super) chosen_object: Option<usize>,
    /// The observer (the world view's camera) that was last fitted to the world view. If the current observer
    /// differs from it, the user has moved the observer.
    pub(super) framed: Option<Framed>,
}

/// An observer fitted to the world view's size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Framed {
    observer: Observer,
    size: ViewSize,
    /// The camera that was framed.
    camera: Camera,
    /// The observer that a lesson's step specifies, if any. The fitted observer has the same direction
    /// and target.
    named: Option<Observer>,
    /// The observer of the whole figure.
    whole: Observer,
    /// What the observer was directed to since.
    directed: Option<Directed>,
}

/// The work that the other parts of the window must do after a scene is opened.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Opened {
    /// True if a different scene was opened, so that nothing derived from the last scene may be shown.
    pub(super) is_another: bool,
    /// The animation to open once the ray's hit is known.
    pub(super) play: Option<Kind>,
}

impl OpenScene {
    pub(super) fn new(open: OpenDocument, mut session: Session) -> OpenScene {
        let stored = open.document.observer.map(Observer::from);
        session.shown.observer = session.shown.observer.or(stored);
        OpenScene { open, session, lessons: Lessons::default(), chosen_object: None, framed: None }
    }

    /// Opens a scene, or a lesson from a file.
    pub(super) fn load(&mut self, source: SceneSource) -> Result<Opened, Question> {
        if let SceneSource::File(path) = &source
            && lessons::is_lesson(path)
        {
            let problem = |error| Question::message("This lesson cannot be opened", error);
            let lesson = lessons::load(path).map_err(problem)?;
            let id = StepId { lesson: Which::File, step: 0 };
            return self.open_lesson(id, Some(Arc::new(lesson)));
        }
        let problem = |error| Question::message("This scene cannot be opened", error);
        Ok(self.replace(OpenDocument::open(source).map_err(problem)?, Selection::default()))
    }

    /// Reads the scene's file again and keeps the view.
    pub(super) fn reload(&mut self) -> Result<(), FileError> {
        let Some(path) = self.open.scene_file().map(Path::to_owned) else { return Ok(()) };
        let open = OpenDocument::open(SceneSource::File(path))?;
        self.session.follow_camera(&self.open.document.camera, &open.document.camera);
        self.open = open;
        Ok(())
    }

    /// Opens another document with this selection, and closes the lesson.
    pub(super) fn replace(&mut self, open: OpenDocument, selection: Selection) -> Opened {
        self.close_lesson();
        self.open = open;
        self.session.shown.observer = self.open.document.observer.map(Observer::from);
        self.session.shown.ghost = None;
        self.session.shown.selection = selection;
        self.chosen_object = None;
        Opened { is_another: true, play: None }
    }

    /// Returns two flags: whether there are unsaved changes, and whether anything differs from the lesson's
    /// step.
    pub(super) fn marks(&self) -> [bool; 2] {
        [self.open.has_changes(), self.differs_from_step()]
    }

    /// Frames the whole scene in a world view of this size if there is no observer (the world view's camera)
    /// yet. An observer that the user has not moved is fitted again in two cases: when the size changes, and
    /// when *eye* or *at* leaves its sight while nothing is dragged or played.
    pub(super) fn frame(&mut self, size: ViewSize, is_at_rest: bool) {
        let shown = self.session.shown.observer;
        let own = self.framed.filter(|framed| shown == Some(framed.observer));
        let lost = is_at_rest && own.is_some_and(|framed| self.is_lost_to(&framed));
        if own.is_some_and(|framed| framed.size == size) && !lost {
            return;
        }
        let document = &self.open.document;
        let camera = &document.camera;
        // If an object is invalid, all objects are ignored, but the camera is still framed.
        let scene = || document.scene().unwrap_or_default();
        let frame_all =
            |scene: &Scene, size: ViewSize| Observer::frame_all(&drawn_of(camera, scene), size);
        let step = self.lessons.open.as_ref().map(OpenLesson::step);
        let fitted = step.filter(|step| !step.keep_observer);
        let of_step = fitted.and_then(|step| step.shown.observer);
        let named = match (own, shown) {
            // If the camera is out of sight, the observer of the lesson's step no longer suits it.
            (Some(framed), _) => framed.named.filter(|_| !lost),
            (None, None) if self.session.shows_exercise() => {
                Some(frame_all(&scene(), ViewSize::of_aspect(ORDINARY_ASPECT)))
            }
            (None, None) => None,
            (None, Some(_)) if of_step == shown => shown,
            (None, Some(_)) => return,
        };
        let items = self.items_to_frame();
        let observer = match (named, own) {
            (Some(named), _) => named.framing_the_same(&self.drawn(&scene(), items), size),
            (None, Some(framed)) => framed.whole.refitted(&drawn_of(camera, &scene()), size),
            (None, None) => frame_all(&scene(), size),
        };
        // If it was framed before, the whole figure stays in sight until the next line.
        let (whole, directed) = (observer, self.framed.and(self.session.live.directed));
        self.framed = Some(Framed { observer, size, camera: *camera, named, whole, directed });
        self.session.shown.observer = Some(observer);
        self.lessons.framed(shown, observer);
    }

    /// Directs the observer of a world view of this size to what the newest revealed line is about or, without one, to the
    /// whole figure, unless it is in view. Does nothing if the user has moved the observer, or while something is dragged
    /// or played. Returns true if the observer moves.
    pub(super) fn direct(&mut self, size: ViewSize, is_at_rest: bool) -> bool {
        let (shown, directed) = (self.session.shown.observer, self.session.live.directed);
        let own = self.framed.filter(|framed| is_at_rest && shown == Some(framed.observer));
        let Some(framed) = own.filter(|framed| framed.directed != directed) else { return false };
        let size = ViewSize { is_directed: directed.is_some(), ..size };
        let scene = self.open.document.scene().unwrap_or_default();
        let observer = match directed {
            Some(directed) => {
                framed.whole.directed(&framed.observer, &self.subject(&scene, directed), size)
            }
            None if framed
                .observer
                .has_in_view(&self.drawn(&scene, self.items_to_frame()), size) =>
            {
                framed.observer
            }
            None => framed.whole,
        };
        self.framed = Some(Framed { observer, directed, ..framed });
        self.session.shown.observer = Some(observer);
        self.lessons.framed(shown, observer);
        observer != framed.observer
    }

    /// Returns the overlay items for which the observer is placed. Those that are switched on or off later must not move
    /// it.
    fn items_to_frame(&self) -> OverlayItems {
        let mut items = match &self.lessons.open {
            Some(open) => apply::items_to_frame(open.step(), &self.session.shown),
            None => self.session.shown.setup.items,
        };
        if self.session.shows_exercise() {
            // The solution has them, and must not move the observer.
            [Item::Basis, Item::Ray, Item::Hit].into_iter().for_each(|item| items.set(item, true));
        }
        items
    }

    /// Returns what is drawn of what the lines so far have spoken of.
    fn subject<'a>(&'a self, scene: &'a Scene, directed: Directed) -> Drawn<'a> {
        let (shown, camera) = (&self.session.shown, &self.open.document.camera);
        let ghost = self.session.frozen_ghost(camera);
        let ray = (shown.selection, shown.ray_point_t);
        // What a question hides is in sight from the start.
        subject(camera, scene, self.items_to_frame(), ray, directed, ghost.as_ref())
    }

    /// Returns what the world view draws with these items, including what is hidden while a question is open.
    fn drawn<'a>(&'a self, scene: &'a Scene, items: OverlayItems) -> Drawn<'a> {
        let (session, camera) = (&self.session, &self.open.document.camera);
        let ghost = if session.shows_exercise() {
            // *Show me* must not move the observer: most wrong cameras look the other way.
            let wrong = WrongCamera::new(camera, Mistake::WAsPrinted).ok();
            let is_asked = session.exercises.asks(Asked::W);
            wrong.filter(|_| is_asked).as_ref().map(GhostCamera::of_answer)
        } else if session.shown.setup.layout == ViewLayout::Mistakes {
            let wrong = WrongCamera::new(camera, session.shown.mistakes_view.shown()).ok();
            wrong.as_ref().map(GhostCamera::of_mistake)
        } else {
            session.frozen_ghost(camera)
        };
        let ray = (session.shown_selection(), session.shown.ray_point_t);
        drawn(camera, scene, items, Some(ray), session.shown.highlighted, ghost.as_ref())
    }

    /// Returns true if *eye* or *at* has moved out of this observer's sight since it was framed.
    fn is_lost_to(&self, framed: &Framed) -> bool {
        let camera = &self.open.document.camera;
        let sees = |camera| framed.observer.sees_eye_and_at(camera, framed.size);
        *camera != framed.camera && sees(&framed.camera) && !sees(camera)
    }

    /// Moves the observer of a world view of this size.
    pub(super) fn observe(&mut self, observe: Observe, size: ViewSize) {
        let camera = &self.open.document.camera;
        let Some(observer) = &mut self.session.shown.observer else { return };
        let everything =
            self.framed.map_or(observer.distance(), |framed| framed.observer.distance());
        let viewport = camera.viewport.width.max(camera.viewport.height);
        let limits = |of: Under| {
            let nearest = match of {
                Under::Camera => NEAREST * viewport,
                // The surface of a planet is the ground of all that stands on it.
                Under::Sphere(sphere) => NEAREST * sphere.radius.min(viewport),
                Under::Ground => NEAREST_GROUND * viewport,
            };
            [nearest, FARTHEST * everything]
        };
        match observe {
            Observe::Orbit(right, up) => {
                observer.orbit(KEY_TURN * f64::from(right), KEY_TURN * f64::from(up));
            }
            Observe::Pan(right, up) => {
                observer.pan(-KEY_PAN * f64::from(right), KEY_PAN * f64::from(up));
            }
            Observe::Zoom(steps) => {
                observer.zoom(observer.target(), KEY_ZOOM.powi(steps), limits(Under::Ground));
            }
            Observe::ZoomTo(shown, factor) => {
                observer.zoom(shown.point, factor, limits(shown.of));
            }
            Observe::Along(axis) => *observer = observer.along(axis),
            Observe::FrameSphere(sphere) => *observer = observer.framing_sphere(&sphere, size),
            Observe::FrameCamera => {
                // The point *at* need not be in the picture.
                let items = OverlayItems::default().with(Item::At, false);
                let scene = Scene::default();
                let drawn = drawn(camera, &scene, items, None, None, None);
                *observer = observer.framing_camera(&drawn, size);
            }
            // The next pass frames the whole scene, because it knows the view's aspect.
            Observe::FrameAll => self.session.shown.observer = None,
        }
    }

    /// Adds an object, or deletes or copies the chosen one. If that fails, returns what failed and why.
    pub(super) fn change_objects(
        &mut self,
        action: ObjectAction,
    ) -> Result<(), (&'static str, String)> {
        let document = &mut self.open.document;
        let chosen = self.chosen_object.filter(|chosen| *chosen < document.object_count());
        self.chosen_object = match (action, chosen) {
            (ObjectAction::AddSphere, _) => Some(objects::add_sphere(document)),
            (ObjectAction::AddPlane, _) => Some(objects::add_plane(document)),
            (_, None) => return Ok(()),
            (ObjectAction::Delete, Some(chosen)) => {
                let problem = |reason| ("This object was not deleted", reason);
                objects::delete(document, chosen).map_err(problem)?;
                None
            }
            (ObjectAction::Duplicate, Some(chosen)) => {
                let problem = |reason| ("This object was not duplicated", reason);
                Some(objects::duplicate(document, chosen).map_err(problem)?)
            }
        };
        Ok(())
    }

    /// Replaces the camera. The selected pixel keeps its position in the image.
    pub(super) fn replace_camera(&mut self, camera: Camera) {
        let before = std::mem::replace(&mut self.open.document.camera, camera);
        self.session.follow_camera(&before, &camera);
    }

    /// Freezes the camera as the ghost, with which it is then compared.
    pub(super) fn freeze_ghost(&mut self) {
        let ghost = &mut self.session.shown.ghost;
        let shows_differences = ghost.is_some_and(|known| known.shows_differences);
        *ghost = Some(Ghost { camera: self.open.document.camera, shows_differences });
    }

    /// Removes the ghost. Half of the comparison would be empty without it.
    pub(super) fn drop_ghost(&mut self) {
        let Shown { ghost, setup, .. } = &mut self.session.shown;
        *ghost = None;
        if setup.layout == ViewLayout::Compare {
            setup.layout = ViewLayout::Both;
        }
    }

    /// Moves the selection by whole pixels.
    pub(super) fn step_selection(&mut self, rows: i64, columns: i64) {
        if let Ok(resolved) = self.open.document.camera.resolve() {
            let selection = &mut self.session.shown.selection;
            *selection = selection.stepped(&resolved, rows, columns);
        }
    }

    /// Sets an input number, which is given rather than computed, with the same effect as editing its field
    /// in the side panel.
    pub(super) fn give(&mut self, ctx: &Context, given: Given, value: f64) {
        let (document, session) = (&mut self.open.document, &mut self.session);
        let before = document.camera;
        // Editing a ray under the pointer selects it.
        let mut selection = session.shown_selection().inside(before.image);
        let shown = selection;
        let from_one = session.shown.setup.count_from_one;
        given::set(given, value, document, &mut selection, from_one);
        if selection != shown {
            session.shown.selection = selection;
        }
        camera::keep(ctx, &before, &mut document.camera, &session.settings());
        session.follow_camera(&before, &document.camera);
    }

    /// Returns to a scene or lesson step that was open before, with what was shown of it. All else,
    /// such as the theme, stays.
    pub(super) fn go_back(&mut self, to: OpenScene) {
        let Session { mut shown, exercises, .. } = to.session;
        let now = std::mem::take(&mut self.session);
        if shown.setup.layout == ViewLayout::Answers && now.answers.is_none() {
            shown.setup.layout = ViewLayout::Both;
        }
        let Live { mut pen, directed, .. } = now.live;
        let mut lessons = to.lessons;
        lessons.keep_ink(std::mem::take(&mut self.lessons), pen.as_mut());
        let live = Live { pen, directed, ..Live::default() };
        *self = OpenScene { session: Session { shown, live, exercises, ..now }, lessons, ..to };
    }
}
