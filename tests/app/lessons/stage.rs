//! The observer's glide from step to step.

use egui::vec2;
use pinhole::model::lessons::{StepId, Which};

use super::Window;
use crate::harness::window;

fn open(window: &mut Window, id: StepId) {
    window.state_mut().open_lesson(id, None);
    window.run();
}

#[test]
fn the_observer_glides_to_the_next_step_unless_motion_is_reduced() {
    for reduced_motion in [false, true] {
        let mut window = window("canonical");
        if reduced_motion {
            crate::harness::command(&mut window, "Reduced motion");
        }
        let id = |step| StepId { lesson: Which::Builtin(6), step };
        open(&mut window, id(1));
        window.state_mut().open_lesson(id(2), None);
        window.set_size(vec2(1280.0, 800.0));
        let eye =
            |window: &Window| window.state().derived().world_frame.clone().unwrap().camera().eye();
        let from = eye(&window);
        window.step();
        let between = eye(&window);
        window.run();
        let to = eye(&window);
        assert!(from != to);
        assert_eq!(between == to, reduced_motion, "{from} {between} {to}");
    }
}
