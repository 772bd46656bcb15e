//! The dialog with the link to what the window shows, and the QR code of a link.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{
    Area, Color32, ColorImage, Context, FontId, Id, Label, Order, Rect, RichText, Sense, Ui, Vec2,
    pos2, vec2,
};
use pinhole_exchange::link;
use pinhole_figure::export::QrCode;

use crate::ui::action::{Action, ShareAction};
use crate::ui::widgets::{ResponseExt as _, ViewTexture, fault_text, line_field, text_width};

/// Side of the code in the dialog, in points.
const SIDE: f32 = 260.0;
/// Minimum and maximum size of the link below the code, in points. A link that would need smaller letters is
/// left out, since nobody would type it.
const WORDS: (f32, f32) = (16.0, 44.0);
/// Distance of the link from the figure's edges, in points.
const EDGE: f32 = 12.0;

/// A link with its code.
pub(crate) struct ShownCode {
    url: String,
    /// A pixel for each module, or the reason why there is no code.
    pub(crate) image: Result<Arc<ColorImage>, String>,
    texture: ViewTexture,
}

impl ShownCode {
    pub(crate) fn of(url: String) -> ShownCode {
        let image = QrCode::of(&url).map(|code| Arc::new(code.image(1)));
        ShownCode { url, image, texture: ViewTexture::default() }
    }

    /// Shows the code in the middle of an area. Its modules have a whole number of pixels, as many as fit.
    fn ui(&mut self, ui: &mut Ui, area: Rect) {
        let image = match &self.image {
            Ok(image) => image,
            Err(problem) => return drop(ui.label(fault_text(ui, problem))),
        };
        let (modules, scale) = (image.size[0] as f32, ui.ctx().pixels_per_point());
        let exact = area.size().min_elem() * scale / modules;
        let side = (if exact < 1.0 { exact } else { exact.floor() }) * modules / scale;
        let corner = ((area.center() - Vec2::splat(0.5 * side)) * scale).round() / scale;
        let rect = Rect::from_min_size(corner, Vec2::splat(side));
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let texture = self.texture.upload(ui.ctx(), image);
        ui.painter().image(texture, rect, whole, Color32::WHITE);
        let response = ui.interact(rect, Id::unique("QR code"), Sense::focusable_noninteractive());
        response.with_role(Role::Image).named("QR code").described(self.url.as_str());
    }

    /// Fills an area of the window, with the link in words below the code if it is short.
    pub(crate) fn fill(&mut self, ctx: &Context, area: Rect) {
        let over = Area::new(Id::unique("code")).order(Order::Middle).fixed_pos(area.min);
        over.constrain(false).show(ctx, |ui| {
            // Clicks do not reach what is below.
            ui.allocate_rect(area, Sense::CLICK | Sense::DRAG);
            ui.painter().rect_filled(area, 0.0, Color32::WHITE);
            let width = text_width(ui, &self.url, FontId::proportional(1.0));
            let size = ((area.width() - 2.0 * EDGE) / width.max(1.0)).min(WORDS.1);
            let foot = if size < WORDS.0 { 0.0 } else { 1.5 * size + EDGE };
            let (above, below) = area.split_top_bottom_at_y(area.bottom() - foot);
            self.ui(ui, above);
            if foot > 0.0 {
                let words = RichText::new(&self.url).size(size).color(Color32::BLACK);
                ui.put(below.shrink2(vec2(EDGE, 0.0)), Label::new(words).extend());
            }
        });
    }
}

/// The dialog.
pub(crate) struct ShareForm {
    /// The part of the link after the `#`.
    fragment: String,
    pub(crate) address: String,
    code: Option<ShownCode>,
}

impl ShareForm {
    pub(crate) fn new(fragment: String, address: String) -> ShareForm {
        ShareForm { fragment, address, code: None }
    }

    /// Shows the dialog. Returns the action of its button.
    pub(crate) fn ui(&mut self, ui: &mut Ui, close: &mut bool) -> Option<Action> {
        ui.heading("Share");
        let url = link::url(&self.address, &self.fragment);
        ui.label("This link opens what the window shows, in a browser or pasted into a window.");
        ui.add(line_field(&mut url.as_str()).desired_width(f32::INFINITY)).named("link");
        let field = line_field(&mut self.address).desired_width(f32::INFINITY);
        ui.label("Address of the page, where pinhole.html is on the web:");
        let field = field.hint_text("https://example.org/pinhole.html");
        ui.add(field).named("address of the page");
        if self.address.trim().is_empty() {
            ui.label("The address must stand before the link. Without it there is no QR code.");
        } else if !link::is_address(&self.address) {
            let problem = "This is not the address of a page. It begins with https://";
            ui.label(fault_text(ui, problem));
        } else {
            let known = self.code.take().filter(|code| code.url == url);
            let code = self.code.insert(known.unwrap_or_else(|| ShownCode::of(url.clone())));
            let size = vec2(ui.available_width(), if code.image.is_ok() { SIDE } else { 0.0 });
            let (area, _) = ui.allocate_exact_size(size, Sense::hover());
            code.ui(ui, area);
        }
        ui.add_space(8.0);
        let mut copies = false;
        ui.horizontal(|ui| {
            copies = ui.button("Copy link").clicked();
            *close |= ui.button("Close").clicked();
        });
        copies.then(|| ShareAction::Copy(url).into())
    }
}
