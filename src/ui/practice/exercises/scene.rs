//! The scene of a question, with what was typed and what is right, and its derivation as the solution.

use egui::{Align, Layout, Rect, RichText, ScrollArea, Ui, UiBuilder, pos2};
use pinhole_core::Selection;
use pinhole_exchange::document::Document;
use pinhole_lecture::exercises::{self, Asked, Exercise, Given};
use pinhole_lecture::lines::{ImplicitLine, ParametricLine};

use super::text_size;
use crate::model::concept::Hovered;
use crate::model::derivation_sections::{DerivationSection, DerivationSections};
use crate::model::lines::{LinesLab, Window};
use crate::model::observer::{Observer, ViewSize};
use crate::model::overlay_items::OverlayItems;
use crate::model::practice::answer_marks;
use crate::model::practice::exercises::Exercises;
use crate::model::session::{Session, Settings, ViewLayout};
use crate::ui::action::{Action, Leave, MadeUp};
use crate::ui::derivation::DerivationPanel;
use crate::ui::scene::view_rects::strip_above;
use crate::ui::scene::views;
use crate::ui::widgets::ViewTexture;
use crate::view::derive::{Derived, Deriver, ViewSizes};
use crate::view::lines::{draw_exercise, substitution};
use crate::view::typesetting::theme;

/// Height of the title above the scene, in points.
const TITLE: f32 = 26.0;

/// The scene's share of the height while the solution is below it.
const SHARE: f32 = 0.52;

/// Name of the picture of a question in two dimensions.
const PLANE: &str = "Lines in the plane";

/// A question's own world view, which is looked at apart from the open scene.
#[derive(Default)]
pub(crate) struct QuestionScene {
    deriver: Deriver,
    derived: Derived,
    texture: ViewTexture,
    solution: DerivationPanel,
    seen: Option<Seen>,
}

/// The question that is looked at, and from where.
struct Seen {
    question: (Exercise, Option<u64>),
    observer: Observer,
    /// The observer that has everything in sight in a picture of this width by height.
    framed: (Observer, ViewSize),
}

impl QuestionScene {
    /// Shows the scene, and the solution below it if that is asked for.
    pub(crate) fn ui(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        session: &Session,
        actions: &mut Vec<Action>,
    ) {
        let exercises = &session.exercises;
        let height = if exercises.is_solved { SHARE * area.height() } else { area.height() };
        let (above, below) = area.split_top_bottom_at_y(area.top() + height);
        let picture = Rect::from_min_max(pos2(above.left(), above.top() + TITLE), above.max);
        if let Some(lab) = lab(exercises) {
            plane(ui, picture, session, &lab);
            solution(ui, exercises, below, |ui| {
                ScrollArea::vertical().id_salt("solution").auto_shrink(false).show(ui, |ui| {
                    substitution(ui, &lab, session.settings.digits);
                });
            });
        }
        let Some(document) = exercises.document() else { return };
        let own = self.world(ui, picture, session, &document);
        solution(ui, exercises, below, |ui| {
            if let Some(derivation) = &self.derived.derivation {
                self.solution.lines(ui, derivation, &document, &own, None);
            }
        });
        let has_yours = self.derived.answer_marks.iter().any(|mark| mark.is_dashed);
        world_title(ui, picture, has_yours, exercises, document, actions);
    }

    /// Shows the world view. Returns the session in which it was derived.
    fn world(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        session: &Session,
        document: &Document,
    ) -> Session {
        let response = views::view(ui, rect, views::WORLD);
        let observer = self.observer(&session.exercises, document, views::size_of(rect));
        views::observe(ui, &response, observer);
        let observer = *observer;
        let hovered = self.solution.hovered(ui.ctx()).filter(|_| session.exercises.is_solved);
        let own = own_session(session, observer, hovered);
        let sizes = ViewSizes {
            world: Some(views::physical(ui, rect)),
            scale: ui.ctx().pixels_per_point(),
            style: theme::style(ui),
            ..ViewSizes::default()
        };
        self.derived.scene = None;
        self.derived = self.deriver.derive(document, &own, &sizes);
        if let Some(shown) = &self.derived.world_view {
            views::show(ui, rect, shown, &mut self.texture, false);
        }
        let marks = &self.derived.answer_marks;
        views::speak(ui, views::WORLD, &answer_marks::spoken(marks));
        own
    }

    /// The observer of this question, which sees all of it until it is moved.
    fn observer(
        &mut self,
        exercises: &Exercises,
        document: &Document,
        size: ViewSize,
    ) -> &mut Observer {
        let question = (exercises.question().exercise, exercises.seed());
        let is_valid = |seen: &Seen| {
            let is_moved = seen.observer != seen.framed.0;
            seen.question == question && (is_moved || seen.framed.1 == size)
        };
        let seen = self.seen.take().filter(is_valid).unwrap_or_else(|| {
            let scene = document.scene().unwrap_or_default();
            let observer = Observer::frame_all(&document.camera, &scene, size);
            Seen { question, observer, framed: (observer, size) }
        });
        &mut self.seen.insert(seen).observer
    }
}

/// Shows the title above the world view, how answers are drawn in it once there are some, and the button
/// that opens its scene.
fn world_title(
    ui: &mut Ui,
    rect: Rect,
    has_yours: bool,
    open: &Exercises,
    document: Document,
    actions: &mut Vec<Action>,
) {
    strip_above(ui, rect, |ui| {
        ui.strong(views::WORLD);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let hint = "Opens this camera, and what its ray meets, as a scene of its own";
            if ui.small_button("Show this scene").on_hover_text(hint).clicked() {
                let question = open.question();
                let title = exercises::title(question.exercise).to_owned();
                let made_up = MadeUp { document, title, uv: question.uv() };
                actions.push(Leave::Show(Box::new(made_up)).into());
                ui.ctx().request_repaint();
            }
            if has_yours {
                ui.label(RichText::new("dashed: yours").size(text_size(ui)));
            }
        });
    });
}

/// Shows the solution, if it is asked for.
fn solution(ui: &mut Ui, open: &Exercises, area: Rect, content: impl FnOnce(&mut Ui)) {
    if open.is_solved {
        ui.scope_builder(UiBuilder::new().max_rect(area), |ui| {
            ui.set_clip_rect(area.intersect(ui.clip_rect()));
            ui.add_space(8.0);
            ui.heading("Solution");
            content(ui);
        });
    }
}

/// The session in which the question's scene is derived.
fn own_session(session: &Session, observer: Observer, hovered: Option<Hovered>) -> Session {
    let exercises = session.exercises.clone();
    let question = exercises.question();
    Session {
        selection: question.uv().map_or(Selection::default(), Selection::Uv),
        observer: Some(observer),
        hovered,
        presenting: session.presenting,
        sections: sections(&exercises),
        settings: Settings {
            layout: ViewLayout::Exercises,
            items: exercises.items(OverlayItems::default()),
            ..session.settings
        },
        exercises,
        ..Session::default()
    }
}

/// The sections of the derivation that answer the question.
fn sections(exercises: &Exercises) -> DerivationSections {
    let question = exercises.question();
    let asks = |asked: Asked| question.parts.iter().any(|part| part.asked == asked);
    let is_ray_given = matches!(question.given, Given::Sphere { .. });
    let sections = [
        (DerivationSection::Basis, asks(Asked::W)),
        (DerivationSection::PixelToRay, question.uv().is_some() && !is_ray_given),
        (DerivationSection::Objects, asks(Asked::T)),
    ];
    sections.into_iter().filter(|(_, is_shown)| *is_shown).map(|(section, _)| section).collect()
}

/// The lines of a question in two dimensions, where they meet.
fn lab(exercises: &Exercises) -> Option<LinesLab> {
    let Given::Lines { line, origin, direction } = exercises.question().given else { return None };
    let line = ImplicitLine { a: line.x, b: line.y, c: line.z };
    let ray = ParametricLine { p: origin, d: direction };
    let meeting = ray.at(exercises.right_t()?);
    let mut lab = LinesLab::new(line, ray, exercises.right_t()?);
    let reach = [origin, meeting].map(|point| point.abs().max_element());
    let half_extent = 1.5 * reach.into_iter().fold(2.0, f64::max);
    lab.window = Window { half_extent, ..lab.window };
    Some(lab)
}

/// Shows a question in two dimensions.
fn plane(ui: &mut Ui, rect: Rect, session: &Session, lab: &LinesLab) {
    let typed = session.exercises.points_in_plane();
    let seen = (session.exercises.shows_all(), session.settings.digits);
    let _ = views::view(ui, rect, PLANE);
    draw_exercise(ui, rect, lab, &typed, seen);
    let names: Vec<&str> = typed.iter().map(|(name, _)| name.as_str()).collect();
    views::speak(ui, PLANE, &format!("drawn: {}", names.join(", ")));
    strip_above(ui, rect, |ui| drop(ui.strong(PLANE)));
}
