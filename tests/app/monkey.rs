//! A monkey at the window: clicks, drags, keys and numbers at random. Nothing panics, no text on the screen
//! is no number, and the scene stays one that can be saved and read again.
//!
//! A run takes ten seconds with the seed of `PROPTEST_RNG_SEED`; with `PINHOLE_MONKEY_SECONDS=600` it takes ten
//! minutes. Where it fails, what the monkey did last is printed, with the scene before and after it.
#![expect(clippy::print_stdout, reason = "a failure is found by what the monkey did")]

use std::fmt::Debug;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Key, Modifiers, Pos2, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use pinhole::ui::app::App;
use pinhole_exchange::scene_file;

use crate::harness::window;
use crate::mutants::{self, Random};

const SCENE: &str = "pinhole = 1\n[camera]\neye = [3, 2, 4]\nat = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [image]\nwidth = 60\nheight = 40\n[[sphere]]\nname = \"ball\"\n\
                     center = [0, 0, -5]\nradius = 1\n[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n";

/// What is typed into number fields.
const TYPED: [&str; 16] = [
    "0",
    "1",
    "-1",
    "3",
    "0.5",
    "90",
    "1e308",
    "-1e308",
    "5e-324",
    "1e155",
    "1e-155",
    "1/0",
    "sqrt(-1)",
    "sqrt(2)/2",
    "((",
    "",
];

/// Keys that write no file and do not close the window.
const KEYS: [Key; 28] = [
    Key::Tab,
    Key::Escape,
    Key::Space,
    Key::Enter,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::PageUp,
    Key::PageDown,
    Key::Home,
    Key::End,
    Key::Delete,
    Key::Backspace,
    Key::F,
    Key::G,
    Key::H,
    Key::K,
    Key::N,
    Key::P,
    Key::R,
    Key::X,
    Key::Y,
    Key::Z,
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::F5,
];

/// What is left alone: it would write a file, or close the window.
const LEFT_ALONE: [&str; 3] = ["Export", "Save", "Quit"];

/// What can be pressed or typed into.
const CONTROLS: [Role; 9] = [
    Role::Button,
    Role::CheckBox,
    Role::ComboBox,
    Role::Link,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::Image,
    Role::Unknown,
];

struct Monkey {
    harness: Harness<'static, App>,
    random: Random,
    /// What it did, the last things last.
    done: Vec<String>,
    /// The scene before the last of it.
    before: String,
}

impl Monkey {
    fn tell(&mut self, what: impl Debug) {
        self.done.push(format!("{what:?}"));
    }

    fn scene(&self) -> String {
        scene_file::to_text(self.harness.state().document(), None)
    }

    /// Does one thing.
    fn act(&mut self) {
        self.before = self.scene();
        let controls: Vec<(Role, String, Rect)> = self
            .harness
            .root()
            .children_recursive()
            .filter_map(|node| {
                let of = node.accesskit_node();
                let bounds = of.bounding_box().filter(|_| CONTROLS.contains(&of.role()))?;
                let corner = |x: f64, y: f64| Pos2::new(x as f32, y as f32);
                let (from, to) = (corner(bounds.x0, bounds.y0), corner(bounds.x1, bounds.y1));
                Some((of.role(), of.label().unwrap_or_default(), Rect::from_two_pos(from, to)))
            })
            .filter(|(_, label, _)| !LEFT_ALONE.iter().any(|word| label.contains(word)))
            .collect();
        let Some((role, label, rect)) = self.random.one_of(&controls).cloned() else { return };
        match self.random.below(10) {
            0 => self.press_key(),
            1 | 2 => self.drag(rect),
            3..=5 if role != Role::SpinButton => self.click(&label, rect.center()),
            _ => {
                let fields: Vec<_> =
                    controls.iter().filter(|(role, ..)| *role == Role::SpinButton).collect();
                match self.random.one_of(&fields) {
                    Some((_, label, rect)) => self.type_into(label, rect.center()),
                    None => self.click(&label, rect.center()),
                }
            }
        }
        self.harness.run_steps(2);
    }

    fn press_key(&mut self) {
        let key = *self.random.one_of(&KEYS).unwrap();
        let modifiers = match (self.random.below(4), key) {
            (0, Key::Z | Key::Y | Key::P) => Modifiers::COMMAND,
            (1, _) => Modifiers::SHIFT,
            _ => Modifiers::NONE,
        };
        self.tell(("key", modifiers, key));
        self.harness.key_press_modifiers(modifiers, key);
    }

    fn drag(&mut self, rect: Rect) {
        let mut share = || self.random.below(1001) as f32 / 1000.0;
        let from = rect.lerp_inside([share(), share()]);
        let by = 400.0 * egui::vec2(share() - 0.5, share() - 0.5);
        self.tell(("drag", from, by));
        self.harness.hover_at(from);
        self.harness.drag_at(from);
        self.harness.run_steps(1);
        self.harness.hover_at(from + by);
        self.harness.run_steps(1);
        self.harness.drop_at(from + by);
    }

    fn click(&mut self, label: &str, at: Pos2) {
        self.tell(("click", label, at));
        self.harness.hover_at(at);
        self.harness.drag_at(at);
        self.harness.drop_at(at);
    }

    fn type_into(&mut self, label: &str, at: Pos2) {
        let text = *self.random.one_of(&TYPED).unwrap();
        self.tell(("type", label, text));
        self.click(label, at);
        self.harness.run_steps(2);
        self.harness.event(egui::Event::Text(text.to_owned()));
        self.harness.run_steps(1);
        self.harness.key_press(Key::Enter);
    }

    /// Asserts what always holds.
    fn check(&self) {
        let nodes = self.harness.root().children_recursive();
        let texts = nodes.flat_map(|node| {
            let of = node.accesskit_node();
            [of.label(), of.value()]
        });
        for text in texts.flatten() {
            let is_number = |word: &str| !["NaN", "inf", "-inf"].contains(&word);
            let mut words = text.split([' ', ',', '(', ')', '[', ']', '\n']);
            assert!(words.all(is_number), "shown: {text}");
        }
        let scene = self.scene();
        let has =
            |word: &str| scene.lines().any(|line| line.contains(word) && line.contains(" = "));
        assert!(!has("inf") && !has("nan"), "the scene is not finite");
        let document = self.harness.state().document();
        if document.csv_spheres.is_none()
            && document.scene().is_ok()
            && document.camera.resolve().is_ok()
        {
            let text = scene_file::to_text(document, None);
            let read = scene_file::parse(&text, Path::new("saved.toml"), Path::new(""));
            assert_eq!(read.as_ref(), Ok(document), "{text}");
        }
    }
}

impl Drop for Monkey {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let last = self.done.len().saturating_sub(12);
            println!(
                "after {} things, the last of them:\n{}\nfrom the scene:\n{}\nto:\n{}",
                self.done.len(),
                self.done[last..].join("\n"),
                self.before,
                self.scene()
            );
        }
    }
}

/// Lets a monkey play for so long.
fn play(seed: u64, time: Duration) {
    println!("seed {seed}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, SCENE).unwrap();
    let (harness, random) = (window(&path), Random::new(seed));
    let mut monkey = Monkey { harness, random, done: Vec::new(), before: String::new() };
    let start = Instant::now();
    while start.elapsed() < time {
        monkey.act();
        monkey.check();
    }
    println!("{} things done", monkey.done.len());
}

#[test]
fn a_monkey_finds_no_fault() {
    let (seed, time) = mutants::play("PINHOLE_MONKEY_SECONDS", Duration::from_secs(10));
    play(seed, time);
}
