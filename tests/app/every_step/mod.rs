//! Every step of the lessons, before and after its answer, in windows of several sizes and in both
//! schemes: one walk for each size, on which all is looked at that holds in every step.

mod contrast;
mod figure;
mod in_sight;

use egui::accesskit::Role;
use egui::{Key, Rect, Theme, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{OpenLesson, StepId, Which, builtin};
use pinhole::model::session::{Preferences, Settings, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;

use super::scene::{framing, overlaps};
use crate::harness::window_with;

/// A step as it is shown.
struct Seen<'a> {
    window: &'a Harness<'static, App>,
    layout: ViewLayout,
    is_answered: bool,
    /// The rectangles of the main figure's pictures when the step was opened.
    opened: &'a [Option<Rect>],
}

impl Seen<'_> {
    fn app(&self) -> &App {
        self.window.state()
    }

    /// The rectangle of the picture of this name.
    fn rect(&self, name: &str) -> Option<Rect> {
        Some(self.window.query_by_role_and_label(Role::Image, name)?.rect())
    }
}

/// Something that holds in every step; returns where it does not.
type Check = fn(&Seen<'_>) -> Vec<String>;

/// What is looked at in one scheme, since it depends on none.
const ON_STAGE: &[(&str, Check)] = &[
    ("the figure fills the window", figure::too_small),
    ("nothing moves when the answer comes", figure::moved),
    ("every line on the card is whole", figure::cut_lines),
    ("every field and button is whole", figure::cut_widgets),
    ("text is large", contrast::small_texts),
    ("all that is drawn is in sight", in_sight::out_of_sight),
    ("no label covers another, a handle or a tip", in_sight::covered),
    ("the camera is framed", |seen| match seen.is_answered {
        // An exercise has a camera of its own, and a step may direct the figure to a part of it.
        true if seen.layout != ViewLayout::Exercises
            && seen.app().session().live.directed.is_none() =>
        {
            framing::misframed(seen.window).into_iter().collect()
        }
        _ => Vec::new(),
    }),
    ("nothing covers anything else", |seen| overlaps::offences(seen.window)),
];

/// What is looked at after each line, which directs the figure to a part of it.
const IN_EACH_LINE: &[(&str, Check)] = &[
    ("every field and button is whole", figure::cut_widgets),
    ("text is large", contrast::small_texts),
    ("no label covers another, a handle or a tip", in_sight::covered),
    ("nothing covers anything else", |seen| overlaps::offences(seen.window)),
];

/// What is looked at there in both schemes. What is not spoken of is faint.
const IN_EACH_LINE_IN_BOTH_SCHEMES: &[(&str, Check)] =
    &[("texts stand out", contrast::faint_lit_texts)];

/// What is looked at in a window that does not present.
const IN_WINDOW: &[(&str, Check)] = &[
    ("nothing covers anything else", |seen| overlaps::offences(seen.window)),
    ("the buttons stand beside the figure", figure::buttons_over_it),
];

/// What is looked at in both schemes.
const IN_BOTH_SCHEMES: &[(&str, Check)] =
    &[("texts stand out", contrast::faint_texts), ("marks stand out", contrast::faint_marks)];

/// A walk through all steps.
struct Walk {
    window: Harness<'static, App>,
    checks: &'static [(&'static str, Check)],
    in_both_schemes: &'static [(&'static str, Check)],
    found: Vec<String>,
}

impl Walk {
    fn in_window(size: Vec2) -> Walk {
        // A glide takes frames.
        let settings = Settings {
            preferences: Preferences { reduced_motion: true, ..Preferences::default() },
            ..Settings::default()
        };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut window = window_with("canonical", remembered, None);
        window.set_size(size);
        window.run();
        Walk { window, checks: IN_WINDOW, in_both_schemes: &[], found: Vec::new() }
    }

    fn on_stage(size: Vec2, presenting: bool) -> Walk {
        let mut walk = Walk::in_window(size);
        if presenting {
            walk.window.key_press(Key::F5);
            walk.window.run();
            walk.window.set_size(size);
            walk.window.run();
        }
        Walk { checks: ON_STAGE, in_both_schemes: IN_BOTH_SCHEMES, ..walk }
    }

    /// Goes through all steps, and fails if anything is wrong in one of them.
    fn through_all_steps(mut self) {
        for (index, lesson) in builtin::all().iter().enumerate() {
            for (k, step) in lesson.steps.iter().enumerate() {
                let id = StepId { lesson: Which::Builtin(index), step: k };
                self.window.state_mut().open_lesson(id, None);
                self.window.run();
                let layout = step.layout().unwrap_or(ViewLayout::Both);
                self.step(&format!("{}.{}", index + 1, k + 1), layout);
            }
        }
        let size = self.window.ctx.content_rect().size();
        assert!(self.found.is_empty(), "at {size}:\n{}", self.found.join("\n"));
    }

    /// Looks at what is shown, in a state of this name.
    fn look(
        &mut self,
        state: &str,
        (layout, is_answered, opened): (ViewLayout, bool, &[Option<Rect>]),
        [checks, in_both_schemes]: [&[(&str, Check)]; 2],
    ) {
        let mut look = |window: &Harness<'static, App>, checks: &[(&str, Check)]| {
            let seen = Seen { window, layout, is_answered, opened };
            let state = format!("{state}, {:?}", window.ctx.theme());
            for (check, wrong_in) in checks {
                let wrong = wrong_in(&seen).into_iter();
                self.found.extend(wrong.map(|it| format!("{state}: {check}: {it}")));
            }
        };
        look(&self.window, checks);
        if !in_both_schemes.is_empty() {
            look(&self.window, in_both_schemes);
            other_scheme(&mut self.window);
            look(&self.window, in_both_schemes);
        }
    }

    fn step(&mut self, name: &str, layout: ViewLayout) {
        let opened = figure::pictures(&self.window, layout);
        let checks = [self.checks, self.in_both_schemes];
        self.look(&format!("{name} opened"), (layout, false, &opened), checks);
        if self.window.state().session().presenting.is_some() {
            self.line_by_line(name, layout, &opened);
        }
        self.window.key_press(Key::End);
        self.window.run();
        self.look(&format!("{name} answered"), (layout, true, &opened), checks);
        if !self.in_both_schemes.is_empty() {
            let share = figure::ground(&mut self.window);
            if share > 0.45 {
                self.found.push(format!("{name}: {share} of the window is empty ground"));
            }
        }
    }

    /// Reveals the step's answer and lines one by one until the next step comes, and opens the step again.
    fn line_by_line(&mut self, name: &str, layout: ViewLayout, opened: &[Option<Rect>]) {
        let id = |walk: &Walk| walk.window.state().lesson().map(OpenLesson::id);
        let own = id(self);
        for line in 1.. {
            self.window.key_press(Key::PageDown);
            self.window.run();
            // After the last step nothing comes.
            if id(self) != own || line > MOST_LINES {
                break;
            }
            let state = format!("{name} after {line} presses");
            let checks = [IN_EACH_LINE, IN_EACH_LINE_IN_BOTH_SCHEMES];
            self.look(&state, (layout, true, opened), checks);
        }
        let own = own.expect("a lesson is open");
        self.window.state_mut().open_lesson(own, None);
        self.window.run();
    }
}

/// Maximum number of presses of a key in a step.
const MOST_LINES: usize = 12;

/// Changes from light to dark or back.
fn other_scheme(window: &mut Harness<'_, App>) {
    if window.state().session().presenting.is_some() {
        window.key_press(Key::T);
    } else {
        let is_dark = window.ctx.theme() == Theme::Dark;
        window.input_mut().system_theme = Some(if is_dark { Theme::Light } else { Theme::Dark });
    }
    window.run_steps(2);
}

// The sizes are in points, at the zoom with which a window of so many pixels is presented.

#[test]
fn presented_at_1920_x_1080() {
    Walk::on_stage(vec2(819.0, 461.0), true).through_all_steps();
}

#[test]
fn presented_at_1280_x_800() {
    Walk::on_stage(vec2(737.0, 461.0), true).through_all_steps();
}

#[test]
fn presented_at_1024_x_768() {
    Walk::on_stage(vec2(737.0, 553.0), true).through_all_steps();
}

#[test]
fn on_a_phone_of_390_x_844() {
    Walk::on_stage(vec2(390.0, 844.0), false).through_all_steps();
}

#[test]
fn in_a_window_that_does_not_present() {
    for size in [vec2(1024.0, 768.0), vec2(1280.0, 800.0), vec2(1920.0, 1080.0)] {
        Walk::in_window(size).through_all_steps();
    }
}
