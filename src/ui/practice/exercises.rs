//! The exercises page: the list, and the question with its answer fields and verdicts. On the right are the
//! question's scene with the typed and the correct answers, and the derivation as the solution.

use egui::{
    Align, Color32, FontSelection, Key, Layout, Rect, RichText, ScrollArea, Stroke, TextEdit, Ui,
    pos2,
};
use pinhole_core::Selection;
use pinhole_exchange::document::Document;
use pinhole_lecture::exercises::{self, Asked, Exercise, Given, QuestionPart};
use pinhole_lecture::lines::{ImplicitLine, ParametricLine};

use crate::model::lines::{LinesLab, Window};
use crate::model::practice::{LARGEST_SEED, answer_marks, next_seed};
use crate::model::{
    DerivationSections, Exercises, Feedback, Hovered, Observer, OverlayItems, Session, Settings,
    TypedAnswer, ViewLayout, ViewSize,
};
use crate::ui::action::{Leave, MadeUp, ShareAction, request};
use crate::ui::derivation::DerivationPanel;
use crate::ui::practice::seed_field;
use crate::ui::scene::view_rects::strip_above;
use crate::ui::scene::views;
use crate::ui::widgets::{
    ResponseExt as _, ViewTexture, clipped, combo, inside, marked_text, sign, text_width,
    vector_color,
};
use crate::view::derive::{Derived, Deriver, ViewSizes};
use crate::view::lines::{draw_exercise, substitution};
use crate::view::typesetting::theme::{self, error_color};

/// Sizes of the text, in points. While presenting, everything is enlarged, and the text has the largest
/// of these sizes at which all answer fields are visible at once.
const SIZES: [f32; 3] = [17.0, 15.0, 13.0];

/// Height of a row of fields, including the space below it, in points.
const ROW: f32 = 41.0;

/// Describes what the user may type.
const HINT: &str = "You may type 5*sqrt(2), -1/sqrt(2) or 3/7, or a decimal of at least four digits. \
                    Nothing is sent anywhere.";

/// Returns the size of the text, in points.
fn text_size(ui: &Ui) -> f32 {
    ui.style().override_font_id.as_ref().map_or(SIZES[0], |font| font.size)
}

/// Returns the largest text size at which the question, its fields and the hint fit into the column.
fn size_with_room(ui: &Ui, exercises: &Exercises) -> f32 {
    let question = exercises.question();
    let has_room = |size: &f32| {
        let paragraphs = exercises::question(&question.given);
        let texts =
            paragraphs.iter().map(|text| (text.as_str(), *size)).chain([(HINT, size - 1.0)]);
        let text = texts
            .map(|(text, size)| marked_text::height_within(ui, text, size, ui.available_width()));
        let height = text.sum::<f32>() + (question.parts.len() as f32 + 0.5) * ROW;
        height <= ui.available_height() - BAR * size
    };
    let presenting = theme::installed(ui.ctx()).presenting;
    SIZES.into_iter().find(|size| !presenting || has_room(size)).unwrap_or(SIZES[2])
}

/// Width of the list, in points.
const LIST: f32 = 206.0;

/// Width of the page, in points, below which the list becomes a menu.
const NARROW: f32 = 940.0;

/// Space between the columns, in points.
const GAP: f32 = 18.0;

/// Indent of the fields and of the text below them, as a multiple of the text's size.
const INDENT: f32 = 4.94;

/// Height of the bar with the buttons, as a multiple of the text's size.
const BAR: f32 = 4.6;

/// Width of one answer field, in points.
const FIELD: f32 = 150.0;

/// Space on each side of the text in a field, in points.
const MARGIN: f32 = 4.0;

/// The names of a vector's coordinates: for screen readers, and as symbols.
const AXES: [(&str, &str); 3] = [("x", "𝑥"), ("y", "𝑦"), ("z", "𝑧")];

/// Shows the current exercise.
pub(crate) fn ui(ui: &mut Ui, session: &mut Session, scene: &mut QuestionScene) {
    let whole = ui.available_rect_before_wrap().shrink(8.0);
    let is_narrow = whole.width() < NARROW;
    let list = if is_narrow { 0.0 } else { LIST + GAP };
    let from = whole.left() + list;
    let share = if is_narrow { 0.58 } else { 0.49 };
    let middle = from + share * (whole.right() - from);
    let column = |left: f32, right: f32| {
        Rect::from_min_max(pos2(left, whole.top()), pos2(right, whole.bottom()))
    };
    let exercises = &mut session.exercises;
    let size = inside(ui, column(from, middle - GAP), |ui| size_with_room(ui, exercises));
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(size));
    if !is_narrow {
        inside(ui, column(whole.left(), whole.left() + LIST), |ui| {
            ui.heading("Exercises");
            ui.add_space(4.0);
            ScrollArea::vertical().id_salt("exercises").show(ui, |ui| choose(ui, exercises));
        });
    }
    // The buttons stay in place, no matter how long the text above them is.
    let (above, bar) =
        column(from, middle - GAP).split_top_bottom_at_y(whole.bottom() - BAR * text_size(ui));
    let mut wants_check = false;
    inside(ui, above, |ui| {
        let presenting = theme::installed(ui.ctx()).presenting;
        if is_narrow && !presenting {
            let title = exercises.question().exercise.title();
            let width = ui.available_width().min(320.0);
            combo(ui, "exercise", width, title, |ui| choose(ui, exercises));
            ui.add_space(4.0);
        }
        ScrollArea::vertical().id_salt("exercise").auto_shrink(false).show(ui, |ui| {
            wants_check = exercise(ui, exercises, !is_narrow, !presenting);
        });
    });
    inside(ui, bar, |ui| {
        ui.separator();
        wants_check |= buttons(ui, exercises);
    });
    if wants_check {
        exercises.check();
        ui.ctx().request_discard("answers were checked after they were drawn");
    }
    scene.ui(ui, column(middle, whole.right()), session);
}

fn choose(ui: &mut Ui, exercises: &mut Exercises) {
    let chosen = exercises.question().exercise;
    for &exercise in Exercise::ALL {
        let text = RichText::new(exercise.title()).size(15.0);
        let response = ui.add(egui::Button::selectable(exercise == chosen, text).wrap());
        if response.clicked() && exercise != chosen {
            exercises.show(exercise, None);
        }
    }
}

/// Shows the question with its fields. Returns true if Enter was pressed in one of the fields.
fn exercise(ui: &mut Ui, exercises: &mut Exercises, has_title: bool, has_source: bool) -> bool {
    let question = exercises.question().clone();
    if has_title {
        ui.heading(RichText::new(question.exercise.title()).size(22.0).strong());
    }
    if has_source {
        source(ui, exercises);
        ui.add_space(8.0);
    }
    for paragraph in exercises::question(&question.given) {
        marked_text::label(ui, &paragraph, text_size(ui));
    }
    ui.add_space(10.0);
    let mut wants_check = false;
    for (part, typed) in question.parts.iter().zip(&mut exercises.answers) {
        wants_check |= answer(ui, part, typed);
        verdict(ui, part, typed);
        ui.add_space(8.0);
    }
    ui.label(RichText::new(HINT).size(text_size(ui) - 1.0).weak());
    wants_check
}

/// Shows the buttons and the number of right answers. Returns true if the answers must be checked.
fn buttons(ui: &mut Ui, exercises: &mut Exercises) -> bool {
    let mut wants_check = false;
    ui.horizontal(|ui| {
        wants_check = ui.button("Check").on_hover_text("Or Enter in a field").clicked();
        let text = if exercises.is_solved { "Hide the solution" } else { "Show the solution" };
        if ui.button(text).clicked() {
            exercises.toggle_solution();
        }
        let copy = ui.add_enabled(exercises.is_begun(), egui::Button::new("Copy my answer"));
        copy.on_hover_text("As a code that you can send").asks(ShareAction::CopyAnswer);
    });
    if exercises.is_right() {
        ui.horizontal(|ui| {
            sign(ui, true);
            ui.label(RichText::new("All correct.").strong());
        });
    }
    wants_check
}

/// Shows the choice between the lecture's question and a question generated from a seed.
fn source(ui: &mut Ui, exercises: &mut Exercises) {
    let exercise = exercises.question().exercise;
    let seed = exercises.seed();
    ui.horizontal_wrapped(|ui| {
        if ui.selectable_label(seed.is_none(), "Lecture version").clicked() && seed.is_some() {
            exercises.show(exercise, None);
        }
        let hint = "The same question with other numbers";
        if ui.button("New numbers").on_hover_text(hint).clicked() {
            exercises.renew(seed.map_or(1, next_seed));
        }
        if let Some(seed) = seed {
            let hint = format!(
                "The number that the question's numbers are drawn from: the same seed, the same \
                 question; a whole number, 0 to {LARGEST_SEED}"
            );
            ui.label("seed").on_hover_text(&hint);
            let mut typed = seed;
            seed_field(ui, &mut typed, "exercise seed", &hint);
            if typed != seed {
                exercises.show(exercise, Some(typed));
            }
        }
    });
}

/// Shows the fields for the answer to one part of the question. Returns true if Enter was pressed in one of
/// the fields.
fn answer(ui: &mut Ui, part: &QuestionPart, typed: &mut TypedAnswer) -> bool {
    let mut entered = false;
    let name = part.asked.id();
    ui.horizontal(|ui| {
        // Without a frame, a field hardly stands out from a white or a black page.
        let frame = Stroke::new(1.0, ui.visuals().weak_text_color());
        ui.visuals_mut().widgets.inactive.bg_stroke = frame;
        if part.count() == 0 {
            ui.label(RichText::new(part.asked.symbol()).size(text_size(ui)));
            for (yes, text) in [(true, "yes"), (false, "no")] {
                if ui.radio(typed.yes == Some(yes), text).clicked() {
                    (typed.yes, typed.feedback) = (Some(yes), None);
                }
            }
            return;
        }
        let color = vector_color(ui, name).unwrap_or(Color32::PLACEHOLDER);
        let text = RichText::new(format!("{} =", part.asked.symbol())).size(text_size(ui) + 1.0);
        let wide = egui::vec2(INDENT * text_size(ui) - 6.0, 30.0);
        ui.allocate_ui_with_layout(wide, Layout::right_to_left(Align::Center), |ui| {
            ui.label(text.color(color));
        });
        // The fields share the row with their margins and the gaps between them.
        let between = ui.spacing().item_spacing.x + 2.0 * MARGIN + 1.0;
        let width = ui.available_width() / part.count() as f32 - between;
        let width = width.clamp(44.0, FIELD);
        let mut left = false;
        for ((axis, hint), text) in AXES.into_iter().zip(&mut typed.fields) {
            let (label, hint) = match part.count() {
                1 => (format!("answer {name}"), ""),
                _ => (format!("answer {name} {axis}"), hint),
            };
            let field = TextEdit::singleline(text).hint_text(hint).desired_width(width);
            let field = field.margin(egui::Margin::symmetric(MARGIN as i8, 2));
            let response =
                ui.add(field.font(egui::FontId::proportional(text_size(ui)))).named(label);
            if response.changed() {
                typed.feedback = None;
            }
            left |= response.lost_focus();
            entered |= response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
        }
        // A vector may be typed into one field, with its brackets, so its coordinates are distributed
        // only when the field loses focus.
        if left {
            typed.spread();
        }
    });
    entered
}

/// Shows the verdict on the answer to a part of the question, once it has been checked.
fn verdict(ui: &mut Ui, part: &QuestionPart, typed: &TypedAnswer) {
    let Some(said) = &typed.feedback else { return };
    let text = RichText::new(said.sentence(part)).size(text_size(ui) - 1.0).strong();
    let is_wrong = !said.is_good() && !matches!(said, Feedback::NotAnswered | Feedback::Missing);
    let text = if is_wrong { text.color(error_color(ui)) } else { text };
    ui.horizontal_top(|ui| {
        ui.add_space(INDENT * text_size(ui));
        if let Feedback::Judged(_) | Feedback::Follows(_) = said {
            sign(ui, said.is_good());
        }
        let spoken = format!("{}: {}", part.asked.id(), said.sentence(part));
        ui.add(egui::Label::new(text).wrap()).spoken(spoken);
    });
}

/// Height of the title above the scene, in points.
const TITLE: f32 = 26.0;

/// Fraction of the height for the scene while the solution is below it.
const SHARE: f32 = 0.52;

/// Name of the picture of a question in two dimensions.
const PLANE: &str = "Lines in the plane";

/// The world view of a question. Its observer is separate from the open scene's.
#[derive(Default)]
pub(crate) struct QuestionScene {
    deriver: Deriver,
    derived: Derived,
    texture: ViewTexture,
    solution: DerivationPanel,
    seen: Option<QuestionObserver>,
}

/// The observer of a question's world view.
struct QuestionObserver {
    question: (Exercise, Option<u64>),
    observer: Observer,
    /// The observer that frames the whole scene, and the size of the picture for which it was computed.
    framed: (Observer, ViewSize),
}

impl QuestionScene {
    /// Shows the scene. Below it, shows the solution if the user has asked for it.
    pub(crate) fn ui(&mut self, ui: &mut Ui, area: Rect, session: &Session) {
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
                self.solution.ui(ui, derivation, &document, &own, false);
            }
        });
        let has_yours = self.derived.answer_marks.iter().any(|mark| mark.is_dashed);
        world_title(ui, picture, has_yours, exercises, document);
    }

    /// Shows the world view. Returns the session with which the view was derived.
    fn world(&mut self, ui: &Ui, rect: Rect, session: &Session, document: &Document) -> Session {
        let response = views::view(ui, rect, views::WORLD);
        let (size, exercises) = (views::size_of(rect), &session.exercises);
        let question = (exercises.question().exercise, exercises.seed());
        // The observer sees the whole scene until the user moves it.
        let is_valid = |seen: &QuestionObserver| {
            let is_moved = seen.observer != seen.framed.0;
            seen.question == question && (is_moved || seen.framed.1 == size)
        };
        let seen = self.seen.take().filter(is_valid).unwrap_or_else(|| {
            let scene = document.scene().unwrap_or_default();
            let observer = Observer::frame_all(&document.camera, &scene, size);
            QuestionObserver { question, observer, framed: (observer, size) }
        });
        let observer = &mut self.seen.insert(seen).observer;
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
}

/// Shows the title above the world view if there is room for it, the legend for the typed answers if there are any, and the
/// button that opens the question's scene.
fn world_title(ui: &mut Ui, rect: Rect, has_yours: bool, open: &Exercises, document: Document) {
    strip_above(ui, rect, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let hint = "Opens this camera and the objects that its ray meets as a scene";
            if ui.small_button("Show this scene").on_hover_text(hint).clicked() {
                let question = open.question();
                let title = question.exercise.title().to_owned();
                let made_up = MadeUp { document, title, uv: question.uv() };
                request(ui.ctx(), Leave::Show(Box::new(made_up)));
                ui.ctx().request_repaint();
            }
            if has_yours {
                ui.label(RichText::new("dashed: yours").size(text_size(ui)));
            }
            let font = FontSelection::Default.resolve(ui.style());
            if text_width(ui, views::WORLD, font) < ui.available_width() {
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| ui.strong(views::WORLD));
            }
        });
    });
}

/// Shows the solution, if the user has asked for it.
fn solution(ui: &mut Ui, open: &Exercises, area: Rect, content: impl FnOnce(&mut Ui)) {
    if open.is_solved {
        clipped(ui, area, |ui| {
            ui.add_space(8.0);
            ui.heading("Solution");
            content(ui);
        });
    }
}

/// Returns the session with which the question's scene is derived.
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
        // As in a lesson's step, everything that is drawn has its label.
        spoken: Some(Vec::new()),
        ..Session::default()
    }
}

/// Returns the sections of the derivation that answer the question.
fn sections(exercises: &Exercises) -> DerivationSections {
    let question = exercises.question();
    let asks = |asked: Asked| question.parts.iter().any(|part| part.asked == asked);
    let is_ray_given = matches!(question.given, Given::Sphere { .. });
    let has_pixel = question.uv().is_some() && !is_ray_given;
    DerivationSections([asks(Asked::W), has_pixel, asks(Asked::T)])
}

/// Returns the lab of lines, which draws two lines in the plane, for a question in two dimensions, with t at
/// the intersection of its lines. Returns `None` for other questions.
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
