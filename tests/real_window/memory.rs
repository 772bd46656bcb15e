//! The same window in memory: where each label is, and what a drag does there.

use std::path::Path;

use egui::accesskit::Role;
use egui::{Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::files::OpenDocument;
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_core::{ImageSize, Pixel};
use pinhole_exchange::scenes::SceneSource;

use crate::whole_window;
use crate::window::{Window, way};

/// The program on `scene`, in a window as large as a real one.
pub(crate) struct InMemory(pub(crate) Harness<'static, App>);

impl InMemory {
    pub(crate) fn like(window: &Window, scene: &Path) -> InMemory {
        let source = SceneSource::File(scene.to_owned());
        let open = OpenDocument::open(source).unwrap();
        let mut harness = Harness::builder()
            .with_size(window.size())
            .with_max_steps(30)
            .with_context_setup(|ctx| App::set_up(ctx, &Default::default()))
            .build_ui_state(whole_window::show, App::new(open, Remembered::default(), None));
        harness.run();
        InMemory(harness)
    }

    pub(crate) fn position(&self, role: Role, label: &str, share: Vec2) -> Pos2 {
        let rect = self.0.get_by_role_and_label(role, label).rect();
        rect.min + share * rect.size()
    }

    /// The pixel of the camera view at a position of the window.
    pub(crate) fn pixel_at(&self, at: Pos2, image: ImageSize) -> Pixel {
        let rect = self.0.get_by_role_and_label(Role::Image, "Camera view").rect();
        // That in the middle of the dot.
        let share = (at.floor() + Vec2::splat(0.5) - rect.min) / rect.size();
        Pixel {
            row: (share.y * image.height() as f32) as u32,
            column: (share.x * image.width() as f32) as u32,
        }
    }

    /// Drags as [`Window::drag`] does.
    pub(crate) fn drag(&mut self, from: Pos2, by: Vec2) {
        let [from, on_the_way @ ..] = way(from, by);
        self.0.hover_at(from);
        self.0.run();
        self.0.drag_at(from);
        self.0.run();
        for at in on_the_way {
            self.0.hover_at(at);
            self.0.run();
        }
        self.0.drop_at(on_the_way[on_the_way.len() - 1]);
        self.0.run();
    }
}
