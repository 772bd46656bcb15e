//! The gallery of mistakes: a grid of thumbnails with names. Each shows the picture that a camera with the mistake
//! takes of a scene in which the mistake can be seen: of the open scene or else of a built-in one. A few pictures
//! are traced in each pass, while the scene rests.

use std::sync::Arc;
use std::time::Duration;

use egui::accesskit::Role;
use egui::{
    Align2, Color32, ColorImage, FontId, Image, Rect, Response, RichText, Sense, Ui, Vec2,
    WidgetInfo, vec2,
};
use pinhole_core::{NO_OBJECT, Paint, Raster, Shade};
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};
use pinhole_figure::overlay::{Style, opaque};
use pinhole_figure::typesetting::theme;
use pinhole_lecture::mistakes::{ComparedCamera, ComparedPicture, Mistake};

use crate::ui::action::Leave;
use crate::ui::widgets::{ResponseExt as _, ViewTexture};
use crate::view::adaptive_resolution::REST;

/// Maximum width and height of a picture, in pixels and in points.
const PICTURE: Vec2 = vec2(96.0, 72.0);
/// Size of a thumbnail with its name and the space around it, in points.
pub(crate) const CELL: Vec2 = vec2(120.0, 116.0);
/// Space around a thumbnail, and between its edge, its picture and its name, in points.
const GAP: f32 = 4.0;
/// Size of a name, in points.
const NAME: f32 = 12.5;
/// Size of the name of a scene that is not the open one, in points.
const SCENE: f32 = 11.0;
/// A scene shows a mistake if the wrong camera sees an object that is out of place in at least this share of the
/// pixels. An empty sky shows nothing.
const SHOWN: f64 = 0.02;
/// Weight of the pixels of a picture in which everything is the same object.
const UNIFORM: f64 = 0.1;
/// Maximum number of pictures that are traced in one pass.
const TRACES: usize = 4;
/// Maximum number of objects of an open scene whose thumbnails are traced.
const MOST_OBJECTS: usize = 10_000;

/// The shading and the colours of the pictures.
type Appearance = (Shade, Style);

/// The thumbnails, and for what they were traced.
#[derive(Default)]
pub(crate) struct Gallery {
    /// In the order of [`Mistake::GALLERY`].
    thumbnails: [Thumbnail; Mistake::GALLERY.len()],
    /// The open scene, without its note.
    scene: Document,
    /// The time since which the scene has been the same, in seconds.
    since: f64,
    appearance: Option<Appearance>,
    /// Number of thumbnails with a picture of the open scene as it is now.
    current: usize,
    /// Number of pictures of built-in scenes that were traced.
    of_builtin: usize,
}

/// The pictures of a mistake.
#[derive(Default)]
struct Thumbnail {
    /// The picture of the open scene.
    open: Candidate,
    /// The picture of the built-in scene, among those traced so far, that shows the mistake best.
    builtin: Candidate,
    texture: ViewTexture,
}

/// A wrong camera's picture of a scene, and how well it shows the mistake.
#[derive(Clone, Default)]
struct Candidate {
    /// The scene; `None` for the open one.
    scene: Option<&'static BuiltinScene>,
    /// The share of pixels in which the wrong camera sees an object that is out of place.
    share: f64,
    /// The pixels; `None` if there is no picture.
    image: Option<Arc<ColorImage>>,
}

impl Gallery {
    /// Traces some of the missing pictures, once the scene has rested: first of the open scene, then of each
    /// built-in one.
    pub(crate) fn step(&mut self, ui: &Ui, document: &Document, shade: Shade) {
        let (time, is_held) = ui.input(|i| (i.time, i.pointer.any_down()));
        let appearance = (shade, theme::style(ui));
        if self.appearance != Some(appearance) {
            *self = Gallery { appearance: Some(appearance), ..Gallery::default() };
        }
        let scene = Document { note: String::new(), observer: None, ..document.clone() };
        if scene != self.scene {
            (self.scene, self.since, self.current) = (scene, time, 0);
        }
        let left = REST - (time - self.since);
        for _ in 0..if is_held || left > 0.0 { 0 } else { TRACES } {
            self.trace_next(appearance);
        }
        let count = Mistake::GALLERY.len();
        let is_missing =
            self.current < count || self.of_builtin < count * BuiltinScene::all().len();
        if is_missing && !is_held {
            ui.ctx().request_repaint_after(Duration::from_secs_f64(left.max(0.02)));
        }
    }

    fn trace_next(&mut self, appearance: Appearance) {
        let count = Mistake::GALLERY.len();
        if self.current < count {
            let open = Some(&self.scene).filter(|open| open.object_count() <= MOST_OBJECTS);
            let mistake = Mistake::GALLERY[self.current];
            let picture = open.and_then(|open| Candidate::trace(open, mistake, appearance));
            self.thumbnails[self.current].open = picture.unwrap_or_default();
            self.current += 1;
        } else if let Some(scene) = BuiltinScene::all().get(self.of_builtin / count) {
            let k = self.of_builtin % count;
            self.of_builtin += 1;
            let document = scene.load().ok();
            let picture =
                document.and_then(|it| Candidate::trace(&it, Mistake::GALLERY[k], appearance));
            let best = &mut self.thumbnails[k].builtin;
            if let Some(picture) = picture.filter(|picture| picture.share > best.share) {
                *best = Candidate { scene: Some(scene), ..picture };
            }
        }
    }

    /// Shows the thumbnails, by which the user chooses a mistake.
    pub(crate) fn grid(&mut self, ui: &mut Ui, chosen: &mut Mistake) {
        ui.spacing_mut().item_spacing = Vec2::ZERO;
        let columns = (ui.available_width() / CELL.x).max(1.0) as usize;
        let rows = Mistake::GALLERY.chunks(columns).zip(self.thumbnails.chunks_mut(columns));
        for (mistakes, thumbnails) in rows {
            ui.horizontal(|ui| {
                for (mistake, thumbnail) in mistakes.iter().zip(thumbnails) {
                    let response = thumbnail.ui(ui, mistake.name(), mistake == chosen);
                    if response.clicked() {
                        *chosen = *mistake;
                        response.request_focus();
                    }
                }
            });
        }
    }

    /// If the open scene does not show the mistake, says so and offers to open one that does.
    pub(crate) fn elsewhere(&self, ui: &mut Ui, mistake: Mistake) {
        let index = Mistake::GALLERY.iter().position(|one| *one == mistake);
        let picture = index.map(|index| self.thumbnails[index].picture());
        let Some(Candidate { scene: Some(scene), share, .. }) = picture else { return };
        // Of a scene that was just opened, it is not known yet.
        let is_known = self.current == Mistake::GALLERY.len();
        if !is_known || self.scene.object_count() > MOST_OBJECTS {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new("Another scene shows this mistake better:").strong());
            let open = Leave::Open(SceneSource::Builtin(scene));
            ui.button(format!("Open the scene “{}”", scene.name)).asks(open);
        });
        if *share < SHOWN {
            ui.label(mistake.hint());
        }
    }
}

impl Thumbnail {
    /// Returns the picture of the open scene or, if that does not show the mistake, the built-in scene's.
    fn picture(&self) -> &Candidate {
        let shows = self.open.share >= self.builtin.share.min(SHOWN);
        if shows { &self.open } else { &self.builtin }
    }

    fn ui(&mut self, ui: &mut Ui, name: &str, is_chosen: bool) -> Response {
        let Candidate { scene, image, .. } = self.picture().clone();
        let (rect, response) = ui.allocate_exact_size(CELL, Sense::click());
        let hint =
            scene.map_or("In the open scene".into(), |it| format!("In the scene “{}”", it.name));
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_chosen, name));
        let response = response.described(&hint).on_hover_text(hint);
        if response.gained_focus() {
            response.scroll_to_me(None);
        }
        let visuals = ui.style().interact_selectable(&response, is_chosen);
        if is_chosen || response.hovered() {
            let (area, rounding) = (rect.shrink(0.5 * GAP), visuals.corner_radius);
            ui.painter().rect_filled(area, rounding, visuals.weak_bg_fill);
        }
        let rect = rect.shrink(1.5 * GAP);
        if let Some(image) = image {
            let size = Vec2::from(image.size.map(|n| n as f32));
            let size = size * (PICTURE / size).min_elem();
            let texture = self.texture.upload(ui.ctx(), &image);
            Image::new((texture, size)).paint_at(ui, Rect::from_min_size(rect.min, size));
            if let Some(scene) = scene {
                let at = rect.min + vec2(0.0, size.y);
                let font = FontId::proportional(SCENE);
                let text = ui.painter().layout_no_wrap(scene.name.into(), font, Color32::WHITE);
                let area = Align2::LEFT_BOTTOM.anchor_size(at, text.size());
                ui.painter().rect_filled(area, 0.0, Color32::from_black_alpha(200));
                ui.painter().galley(area.min, text, Color32::WHITE);
            }
        }
        let (font, color) = (FontId::proportional(NAME), visuals.text_color());
        let name = ui.painter().layout(name.to_owned(), font, color, rect.width());
        ui.painter().galley(rect.min + vec2(0.0, PICTURE.y + GAP), name, color);
        response
    }
}

impl Candidate {
    /// Traces a scene with the camera that has this mistake; returns `None` if there is no such picture.
    fn trace(
        document: &Document,
        mistake: Mistake,
        (shade, style): Appearance,
    ) -> Option<Candidate> {
        let (camera, scene) = (&document.camera, document.scene().ok()?);
        let resolved = camera.resolve().ok()?;
        let image = vec2(camera.image.width() as f32, camera.image.height() as f32);
        let size = image * (PICTURE / image).min_elem().min(1.0);
        let raster = Raster::shown_on(camera.image, size.x as u32, size.y as u32);
        let color_of = |i: u32| style.scheme().object(i, document.color_of(i));
        let paint = Paint { shade, color_of, to_pixel: opaque };
        let (_, compared) = ComparedCamera::new(camera, &resolved, &scene, mistake, &raster, paint);
        let ComparedPicture { mut pixels, wrong, right } = compared?;
        style.finish(&mut pixels);
        let is_shown = |(wrong, right): &(&u32, &u32)| wrong != right && **wrong != NO_OBJECT;
        let shown = wrong.iter().zip(&right).filter(is_shown).count();
        let is_uniform = wrong.iter().all(|object| *object == wrong[0]);
        let weight = if is_uniform { UNIFORM } else { 1.0 };
        let size = [raster.columns().len(), raster.rows().len()];
        let image = Some(Arc::new(ColorImage::new(size, pixels)));
        Some(Candidate { scene: None, share: weight * shown as f64 / raster.len() as f64, image })
    }
}
