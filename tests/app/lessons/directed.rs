//! A revealed line of the derivation directs the figure: what it is about is large, in sight and lit.

use std::collections::BTreeSet;

use egui::{Key, Pos2, Rect, Vec2, vec2};
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::builtin;
use pinhole::model::session::{Preferences, Settings};
use pinhole::model::store::Remembered;
use pinhole_figure::concept::Directed;
use pinhole_figure::overlay::{Mark, Shape};
use pinhole_figure::{Concept, Item, Observer};

use super::{StepId, Which, Window};
use crate::harness::window_with;

/// A window that presents at this size in points, without glides, which take frames.
pub(super) fn presented(size: Vec2) -> Window {
    let preferences = Preferences { reduced_motion: true, ..Preferences::default() };
    let settings = Settings { preferences, ..Settings::default() };
    let mut window =
        window_with("canonical", Remembered { settings, ..Remembered::default() }, None);
    window.key_press(Key::F5);
    window.run();
    window.set_size(size);
    window.run();
    window
}

/// The greatest distance between two points of the marks of a concept, in pixels.
fn length(window: &Window, concept: Concept) -> f32 {
    let derived = window.state().derived();
    let marks = derived.world_view.as_ref().unwrap().marks.iter();
    let own = marks.filter(|mark| mark.concept == Some(concept));
    Rect::from_points(&own.flat_map(points).collect::<Vec<_>>()).size().length()
}

#[test]
fn an_arrow_grows_when_its_line_is_revealed_and_is_whole_in_the_end() {
    let mut window = window_with("canonical", Remembered::default(), None);
    window.key_press(Key::F5);
    window.run();
    window.set_size(SIZES[0]);
    open(&mut window, 7, 2);
    window.key_press(Key::PageDown);
    window.run();
    let lengths_after = |window: &mut Window, key: Key| {
        window.key_press(key);
        let lengths = (0..8).map(|_| {
            window.step();
            length(window, Concept::W)
        });
        lengths.collect::<Vec<_>>()
    };
    let grown = lengths_after(&mut window, Key::PageDown);
    window.run();
    let whole = length(&window, Concept::W);
    // w is −view, shortened, and becomes that again.
    assert!(grown.iter().any(|part| *part > 1.2 * whole), "{grown:?} of {whole}");
    let undone = lengths_after(&mut window, Key::PageUp);
    assert!(undone.iter().any(|part| *part > 1.2 * whole), "{undone:?} of {whole}");
    window.key_press(Key::PageDown);
    window.run();
    window.key_press(Key::End);
    window.run();
    assert!(whole > 60.0 && length(&window, Concept::W) > 20.0, "{whole}");
}

pub(super) fn open(window: &mut Window, lesson: usize, step: usize) {
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    window.state_mut().open_lesson(id, None);
    window.run();
}

fn directed(window: &Window) -> Option<Directed> {
    window.state().session().live.directed
}

fn points(mark: &Mark) -> Vec<Pos2> {
    match &mark.shape {
        Shape::Line { points, .. } | Shape::Polygon { points } => {
            points.iter().map(|[x, y]| Pos2::new(*x, *y)).collect()
        }
        Shape::Disc { center: [x, y], .. } => vec![Pos2::new(*x, *y)],
    }
}

/// The extent of the marks of what the lines have spoken of, as a fraction of the figure's shorter side, and whether
/// all of them are in sight.
fn extent(window: &Window, directed: Directed) -> Option<(f32, bool)> {
    let derived = window.state().derived();
    let view = derived.world_view.as_ref()?;
    let [width, height] = view.image.size.map(|n| n as f32);
    let marks = view.marks.iter().filter(|mark| {
        let own = mark.concept.map(|concept| concept.in_views());
        own.is_some_and(|concept| directed.spoken.contains(concept))
    });
    let picture = Rect::from_min_size(Pos2::ZERO, vec2(width, height)).expand(1.0);
    // A ray has no end.
    let (endless, whole): (Vec<_>, Vec<_>) = marks.partition(|mark| mark.item == Item::Ray);
    let points_of = |marks: Vec<&Mark>| marks.into_iter().flat_map(points).collect::<Vec<Pos2>>();
    let (endless, whole) = (points_of(endless), points_of(whole));
    let is_in_sight = whole.iter().all(|at| picture.contains(*at));
    if endless.is_empty() && whole.is_empty() {
        return None;
    }
    let area = Rect::from_points(&[endless, whole].concat()).intersect(picture);
    Some((area.width().max(area.height()) / width.min(height), is_in_sight))
}

/// The share of the figure's pixels that differ.
fn changed(before: &egui::ColorImage, now: &egui::ColorImage) -> f64 {
    if before.size != now.size {
        return 1.0;
    }
    let differ = before.pixels.iter().zip(&now.pixels).filter(|(a, b)| a != b).count();
    differ as f64 / now.pixels.len() as f64
}

/// The least share of the figure's pixels that a line changes.
const LEAST_CHANGED: f64 = 0.0035;

/// All states of all steps in which a line directs the figure.
fn all_states(size: Vec2) {
    let mut window = presented(size);
    open(&mut window, 1, 1);
    let (mut shares, mut found, mut seen) = (Vec::new(), Vec::new(), BTreeSet::new());
    let mut small = Vec::new();
    let mut before: Option<(StepId, Directed, std::sync::Arc<egui::ColorImage>)> = None;
    loop {
        let id = window.state().lesson().unwrap().id();
        let Which::Builtin(lesson) = id.lesson else { panic!("{id:?}") };
        let name = format!("{}.{}", lesson + 1, id.step + 1);
        let image = window.state().derived().world_view.as_ref().map(|view| view.image.clone());
        let shown = (directed(&window), image, window.query_by_label("World view").is_some());
        // Without a camera there is nothing to see of what cannot be computed.
        let is_whole = window.state().derived().fault.is_none();
        if let (Some(directed), Some(image), true) = shown
            && is_whole
        {
            match extent(&window, directed) {
                Some((share, is_in_sight)) => {
                    shares.push(share);
                    if share < 0.6 {
                        small.push(format!("{name} {:?}: {share:.2}", directed.concept));
                    }
                    if share < 0.4 || !is_in_sight {
                        let about = directed.concept;
                        found
                            .push(format!("{name} {about:?}: {share:.2}, in sight: {is_in_sight}"));
                    }
                }
                None => {
                    found.push(format!("{name} {:?}: nothing of it is drawn", directed.concept))
                }
            }
            if let Some((step, last, picture)) = &before
                && (*step, last.concept) != (id, directed.concept)
                && *step == id
            {
                let share = changed(picture, &image);
                if share < LEAST_CHANGED {
                    found.push(format!("{name} {:?}: {share:.4} changed", directed.concept));
                }
            }
            before = Some((id, directed, image));
            seen.insert(name);
        }
        let state = |window: &Window| {
            let session = window.state().session();
            let shown = (session.shown.is_asking, session.shown.revealed_lines);
            (window.state().lesson().unwrap().id(), shown, session.exercises.clone())
        };
        let last = state(&window);
        window.key_press(Key::PageDown);
        window.run();
        if state(&window) == last {
            break;
        }
    }
    assert!(seen.len() > 8 && builtin::all().len() > 12, "{seen:?}");
    let large = shares.iter().filter(|share| **share >= 0.6).count();
    let few = large * 10 < shares.len() * 9;
    let (count, small, found) = (shares.len(), small.join("\n"), found.join("\n"));
    assert!(!few && found.is_empty(), "{large} of {count} are large, but not\n{small}\n{found}");
}

/// The sizes in points of windows of 1920 x 1080 and 1024 x 768 pixels at the zoom with which they present.
pub(super) const SIZES: [Vec2; 2] = [vec2(819.0, 461.0), vec2(737.0, 553.0)];

#[test]
fn what_a_line_is_about_is_large_and_in_sight_at_1920_x_1080() {
    all_states(SIZES[0]);
}

#[test]
fn what_a_line_is_about_is_large_and_in_sight_at_1024_x_768() {
    all_states(SIZES[1]);
}

#[test]
fn a_step_says_what_its_question_is_about() {
    let mut window = presented(SIZES[0]);
    open(&mut window, 7, 4);
    let asked = directed(&window).unwrap();
    assert!(asked.is_of_step && window.state().session().shown.is_asking);
    let arrow = length(&window, Concept::U);
    // What the question asks for is not there, but there is room for it.
    assert_eq!(length(&window, Concept::V), Rect::NOTHING.size().length());
    press(&mut window, Key::PageDown);
    assert!(!directed(&window).unwrap().is_of_step && length(&window, Concept::V) > 60.0);
    press(&mut window, Key::F5);
    open(&mut window, 7, 4);
    assert_eq!(directed(&window), None, "while nothing is presented");
    assert!(arrow > 1.3 * length(&window, Concept::U), "{arrow}");
}

/// A window with the derivation of step 8.5, of which two lines are revealed, and its observer.
fn recap() -> (Window, Option<Observer>) {
    let mut window = presented(SIZES[0]);
    open(&mut window, 8, 5);
    for _ in 0..2 {
        window.key_press(Key::PageDown);
        window.run();
    }
    assert!(directed(&window).is_some());
    let observer = observer(&window);
    (window, observer)
}

fn observer(window: &Window) -> Option<Observer> {
    window.state().session().shown.observer
}

fn press(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run();
}

#[test]
fn a_drag_keeps_the_observer_over_the_next_line_until_r_gives_it_back() {
    let (mut window, seen) = recap();
    let world = window.get_by_label("World view").rect();
    let corner = world.left_bottom() + vec2(60.0, -60.0);
    crate::harness::drag_from(&mut window, corner, vec2(40.0, 0.0));
    window.run();
    let dragged = observer(&window);
    assert_ne!(dragged, seen);
    press(&mut window, Key::PageDown);
    assert_eq!(observer(&window), dragged, "the lecturer overrules the line");
    press(&mut window, Key::R);
    assert_ne!(observer(&window), dragged);
}

#[test]
fn f_shows_the_whole_figure_until_the_next_line() {
    let (mut window, seen) = recap();
    press(&mut window, Key::F);
    let whole = observer(&window);
    assert_ne!(whole, seen);
    window.run();
    assert_eq!(observer(&window), whole);
    press(&mut window, Key::PageDown);
    assert_ne!(observer(&window), whole);
}

#[test]
fn pointing_at_another_pixel_moves_no_observer() {
    let (mut window, seen) = recap();
    let camera = window.get_by_label("Camera view").rect();
    for at in [camera.center(), camera.left_top() + vec2(8.0, 8.0)] {
        window.hover_at(at);
        window.run();
        assert_eq!(observer(&window), seen);
    }
}

#[test]
fn a_revealed_line_changes_nothing_that_r_would_give_back() {
    let (mut window, seen) = recap();
    press(&mut window, Key::R);
    assert_eq!(observer(&window), seen);
    press(&mut window, Key::PageDown);
    let next = observer(&window);
    press(&mut window, Key::R);
    assert_eq!(observer(&window), next);
}
