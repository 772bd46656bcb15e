//! The world view by mouse: zoomed to a ball, turned by the gizmo, and saved as the steps of a lesson, which
//! play as they were; and a ball that is deleted and brought back.

use std::path::Path;

use egui::{Pos2, vec2};
use pinhole::model::lessons::{Step, load};
use pinhole_core::DVec3;
use pinhole_exchange::scene_file;

use crate::hands::saved;
use crate::hearing::Heard;
use crate::memory::InMemory;
use crate::reader::{BUTTON, IMAGE};
use crate::screen::Screen;
use crate::window::built_in;

/// The pink ball of the scene "look-at".
const BALL: usize = 3;

/// Fails unless the ball's colour is on the screen here, once the pointer is gone.
#[track_caller]
fn assert_shows_ball(heard: &Heard, at: Pos2) {
    heard.window.point_at(at);
    let location = heard.window.screen.try_say(&["getmouselocation"]).unwrap();
    let number = |text: &str| text.split(':').nth(1).unwrap().parse::<usize>().unwrap();
    let [x, y] = [0, 1].map(|k| number(location.split(' ').nth(k).unwrap()));
    heard.window.point_at(Pos2::new(20.0, 20.0));
    let [r, g, b] = heard.window.screen.settled()[y][x].map(f32::from);
    assert!(r > 1.4 * g && b > 1.2 * g, "({r}, {g}, {b}) at {x}, {y}");
}

/// Saves the view as a step of the lesson that the dialog proposes, which then has this number of steps.
#[track_caller]
fn saved_step(heard: &Heard, lesson: &Path, number: usize) -> Step {
    heard.window.key("ctrl+p");
    heard.window.write("save this view");
    heard.window.key("Return");
    heard.window.key("Return");
    heard.wait_for_text(&format!("Saved step {number} to lesson.toml"));
    // The notice may be over the gizmo.
    heard.click(BUTTON, "Close");
    load(lesson).unwrap().steps.pop().unwrap()
}

pub(crate) fn zoom_turn_save_and_play() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, lesson) = (built_in(folder.path(), "look-at"), folder.path().join("lesson.toml"));
    let before = scene_file::load(&scene).unwrap();
    let screen = Screen::start();
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    let memory = InMemory::like(&heard.window, &scene);
    let observer = *memory.0.state().derived().world_frame.as_ref().unwrap().camera();
    let ball = before.spheres[BALL].shape;
    let uv = observer.project(ball.center).uv / observer.viewport().height;
    let view = heard.rect(IMAGE, "World view");
    let at = (view.center() + view.height() * vec2(uv.x as f32, -uv.y as f32)).floor();
    assert_shows_ball(&heard, at);

    heard.window.click(at);
    heard.window.key("Delete");
    let without = saved(&heard.window, &scene, &before);
    assert_eq!((without.spheres.len(), without.planes.len()), (3, 1));
    heard.window.key("ctrl+z");
    assert_eq!(saved(&heard.window, &scene, &without), before);

    (0..12).for_each(|_| heard.window.scroll(at, true));
    assert_shows_ball(&heard, at);
    let near = saved_step(&heard, &lesson, 1);
    let size = |step: &Step| ball.radius / step.shown.observer.unwrap().distance();
    heard.click(BUTTON, "Look along y, from above");
    let above = saved_step(&heard, &lesson, 2);
    let view = above.shown.observer.unwrap().camera(4, 3).view().normalize();
    assert!(view.dot(DVec3::NEG_Y) > 0.999, "{view}");
    assert!(size(&near) > 0.05 && size(&near) == size(&above), "{}", size(&near));
    heard.window.quit();

    let arguments = ["--lesson".as_ref(), lesson.as_os_str()];
    let mut heard = Heard::open(&screen, &arguments, folder.path());
    heard.wait_for_text("lesson · 1 of 2 · Step 1");
    let again = saved_step(&heard, &lesson, 3);
    assert_eq!(again.shown, near.shown);
    heard.key("Next");
    heard.wait_for_text("lesson · 2 of 3 · Step 2");
    assert_eq!(saved_step(&heard, &lesson, 4).shown, above.shown);
    heard.window.quit();
}
