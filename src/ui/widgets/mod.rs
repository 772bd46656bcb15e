//! Widgets that several panels share: number fields, marked text, buttons for actions, signs for right and
//! wrong, error messages, and the textures of the views. They set their names for screen readers.

use std::fmt::Display;
use std::sync::Arc;
use std::time::Duration;

use egui::accesskit::{Node, Role};
use egui::{
    Align, Align2, Color32, ColorImage, ComboBox, Context, DragValue, EventFilter, FontId,
    FontSelection, Id, Key, Layout, Painter, Rect, Response, RichText, Sense, Stroke, TextBuffer,
    TextEdit, TextStyle, TextureHandle, TextureId, TextureOptions, Ui, UiBuilder, Vec2, vec2,
};
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::typesetting::theme::{self, WRITTEN, error_color};
use pinhole_figure::{Concept, HoverSource, Hovered};
use pinhole_lecture::LARGEST_SEED;

use crate::ui::action::{Action, request};

pub mod marked_text;
pub mod number;
pub mod path_field;

pub(crate) use number::{NumberField, vector_color, vector_row};

/// Sizes of the texts, in points, of which the largest is chosen at which everything fits.
pub(crate) const SIZES: [f32; 9] = [20.0, 19.0, 18.0, 17.0, 16.0, 15.0, 14.0, 13.0, WRITTEN];

/// Returns the largest of the [`SIZES`] of at most `most` that fits; the smallest one, if none does. A smaller one need
/// not fit: it may break a formula at another place.
pub(crate) fn largest_size(most: f32, fits: impl FnMut(&f32) -> bool) -> f32 {
    SIZES.into_iter().skip_while(|size| *size > most).find(fits).unwrap_or(WRITTEN)
}

/// Extends a widget's response with methods that set its accessible properties, and that request an action
/// when it is clicked.
pub(crate) trait ResponseExt: Sized {
    /// Changes the widget's node in the accessibility tree.
    fn node(self, change: impl FnOnce(&mut Node)) -> Self;

    /// Requests the action if the widget was clicked.
    fn asks(self, action: impl Into<Action>);

    /// Sets the accessible name.
    fn named(self, name: impl Into<String>) -> Self {
        self.node(|node| node.set_label(name.into()))
    }

    /// Sets the accessible value, which screen readers read instead of the widget's text.
    fn spoken(self, value: impl Into<String>) -> Self {
        self.node(|node| node.set_value(value.into()))
    }

    /// Sets the accessible description, such as what a picture shows or where a handle is. A value would not
    /// do, because AT-SPI, the accessibility interface of Linux desktops, passes on only numeric values for
    /// such widgets.
    fn described(self, text: impl Into<String>) -> Self {
        self.node(|node| node.set_description(text.into()))
    }

    /// Sets the kind of widget.
    fn with_role(self, role: Role) -> Self {
        self.node(|node| node.set_role(role))
    }
}

impl ResponseExt for Response {
    fn node(self, change: impl FnOnce(&mut Node)) -> Self {
        self.ctx.accesskit_node_builder(self.id, change);
        self
    }

    fn asks(self, action: impl Into<Action>) {
        if self.clicked() {
            request(&self.ctx, action);
        }
    }
}

/// The number of the last pass, and its widgets that were about a concept.
type AboutConcepts = (u64, Vec<(Id, Hovered)>);

fn about_concepts() -> Id {
    Id::unique("widgets about concepts")
}

/// Tells that a widget is about a concept, if there is one, and in which part of the window it is.
pub(crate) fn is_about(widget: &Response, concept: Option<Concept>, by: HoverSource) {
    let Some(concept) = concept else { return };
    let now = widget.ctx.cumulative_pass_nr();
    widget.ctx.data_mut(|data| {
        let (pass, widgets) = data.get_temp_mut_or_default::<AboutConcepts>(about_concepts());
        if std::mem::replace(pass, now) != now {
            widgets.clear();
        }
        widgets.push((widget.id, Hovered { concept, by }));
    });
}

/// Returns the concept of the widget of this part of the window that is under the mouse or, if there is none, that
/// has the keyboard focus.
pub(crate) fn pointed_at(ctx: &Context, by: HoverSource) -> Option<Hovered> {
    let (_, widgets) = ctx.data(|data| data.get_temp::<AboutConcepts>(about_concepts()))?;
    let focused = ctx.memory(|memory| memory.focused());
    let is_held = |response: Response| response.hovered() || response.dragged();
    let is_pointed = |id: Id| ctx.read_response(id).is_some_and(is_held);
    let own = || widgets.iter().rev().filter(|(_, hovered)| hovered.by == by);
    let pointed = own().find(|(id, _)| is_pointed(*id));
    let found = pointed.or_else(|| own().find(|(id, _)| focused == Some(*id)));
    found.map(|(_, hovered)| *hovered)
}

/// Keeps the horizontal or the vertical arrow keys from moving the focus away from a widget.
pub(crate) fn keep_arrows(response: &Response, horizontal: bool, vertical: bool) {
    let arrows = EventFilter {
        horizontal_arrows: horizontal,
        vertical_arrows: vertical,
        ..EventFilter::default()
    };
    response.ctx.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
}

/// Returns the number of presses of the arrow keys in this pass, to the right and down.
pub(crate) fn arrows(ctx: &Context) -> Vec2 {
    let presses = |key| ctx.input(|i| i.num_presses(key)) as f32;
    let right = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
    vec2(right, presses(Key::ArrowDown) - presses(Key::ArrowUp))
}

/// Time after a click in which tooltips appear while presenting, in seconds.
const EXPLAINS: f32 = 4.0;

/// Returns true if a tooltip may appear. While presenting, it waits for a click and the end of a drag, since it covers
/// what the class looks at.
pub(crate) fn may_explain(ctx: &Context) -> bool {
    if !theme::installed(ctx).presenting {
        return true;
    }
    let left = EXPLAINS - ctx.input(|input| input.pointer.time_since_last_click());
    if left > 0.0 {
        ctx.request_repaint_after(Duration::from_secs_f32(left));
    }
    left > 0.0 && !ctx.input(|input| input.pointer.any_down())
}

/// Shows content in a rectangle of the window.
pub(crate) fn inside<R>(ui: &mut Ui, rect: Rect, content: impl FnOnce(&mut Ui) -> R) -> R {
    ui.scope_builder(UiBuilder::new().max_rect(rect), content).inner
}

/// Shows content in a rectangle of the window, and cuts off what exceeds it.
pub(crate) fn clipped(ui: &mut Ui, rect: Rect, content: impl FnOnce(&mut Ui)) {
    inside(ui, rect, |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        content(ui);
    });
}

/// Shows a cell of fixed width in a row; its text wraps.
pub(crate) fn cell<R>(ui: &mut Ui, width: f32, content: impl FnOnce(&mut Ui) -> R) -> R {
    let layout = Layout::top_down(Align::LEFT);
    let font = FontSelection::Default.resolve(ui.style());
    // A row in whose middle the cell stands must know its height before its contents.
    let height = ui.fonts_mut(|fonts| fonts.row_height(&font));
    let inner = ui.allocate_ui_with_layout(vec2(width, height), layout, |ui| {
        ui.set_width(width);
        content(ui)
    });
    inner.inner
}

/// Returns the index of the column that shows group `k` of groups with these numbers of rows. All groups form one
/// long column, which is cut into `columns` equal parts. A group belongs to the part that contains its middle.
pub(crate) fn column_of(rows: &[usize], k: usize, columns: usize) -> usize {
    let middle = rows[..k].iter().sum::<usize>() + rows[k] / 2;
    (columns * middle / rows.iter().sum::<usize>().max(1)).min(columns - 1)
}

/// Shows a menu of choices with this accessible name.
pub(crate) fn combo(ui: &mut Ui, name: &str, width: f32, shown: &str, list: impl FnOnce(&mut Ui)) {
    let combo =
        ComboBox::from_id_salt((name, "menu")).width(width).height(520.0).selected_text(shown);
    combo.show_ui(ui, list).response.named(name);
}

/// Creates a field for a line of text, which stands in the middle of the field's height.
pub(crate) fn line_field(text: &mut dyn TextBuffer) -> TextEdit<'_> {
    TextEdit::singleline(text).align(Align2::LEFT_CENTER)
}

/// Returns the width of a line of text in this font, in points.
pub(crate) fn text_width(ui: &Ui, text: &str, font: FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE).size().x
}

/// Returns the width of a button with this text, including the space after the button.
pub(crate) fn button_width(ui: &Ui, text: &str) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    text_width(ui, text, font) + 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x
}

/// Returns a message in the colour of errors.
pub(crate) fn fault_text(ui: &Ui, message: impl Display) -> RichText {
    RichText::new(typeset_message(message)).color(error_color(ui))
}

/// What a page says about its second picture: a description for screen readers, and the reason why there is no
/// picture, if there is none.
pub(crate) type Words = (String, Option<String>);

/// Shows, in place of a picture, the reason why there is none.
pub(crate) fn no_picture(ui: &mut Ui, rect: Rect, reason: &str) {
    ui.painter().rect_filled(rect, 4.0, ui.visuals().faint_bg_color);
    let inside = rect.shrink(16.0);
    let layout = Layout::top_down(Align::Center).with_main_align(Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(inside).layout(layout), |ui| {
        ui.set_clip_rect(rect);
        ui.add_space((0.5 * inside.height() - 40.0).max(0.0));
        ui.label(RichText::new(reason).size(17.0).strong());
    });
}

/// Shows a tick or a cross that is as high as the text next to it.
pub(crate) fn sign(ui: &mut Ui, is_right: bool) -> Response {
    let side = 14.0;
    let line = ui.text_style_height(&egui::TextStyle::Body).max(20.0);
    let (rect, response) = ui.allocate_exact_size(vec2(side, line), Sense::hover());
    let rect = Rect::from_center_size(rect.center(), vec2(side, side));
    if is_right {
        tick(ui.painter(), rect, ui.visuals().text_color());
    } else {
        cross(ui.painter(), rect, error_color(ui));
    }
    response
}

/// Draws a tick.
pub(crate) fn tick(painter: &Painter, rect: Rect, color: Color32) {
    draw(painter, rect, color, [[(0.1, 0.55), (0.4, 0.85)], [(0.4, 0.85), (0.9, 0.15)]]);
}

/// Draws a cross.
pub(crate) fn cross(painter: &Painter, rect: Rect, color: Color32) {
    draw(painter, rect, color, [[(0.15, 0.15), (0.85, 0.85)], [(0.85, 0.15), (0.15, 0.85)]]);
}

fn draw(painter: &Painter, rect: Rect, color: Color32, lines: [[(f32, f32); 2]; 2]) {
    let stroke = Stroke::new(0.16 * rect.width(), color);
    for line in lines {
        painter.line_segment(line.map(|(x, y)| rect.lerp_inside(vec2(x, y))), stroke);
    }
}

/// The texture of one view, uploaded only when its image changes.
#[derive(Default)]
pub(crate) struct ViewTexture {
    texture: Option<TextureHandle>,
    uploaded: Option<Arc<ColorImage>>,
}

impl ViewTexture {
    /// Returns the texture that holds `image`.
    pub(crate) fn upload(&mut self, ctx: &Context, image: &Arc<ColorImage>) -> TextureId {
        // One texel is one physical pixel, so nearest-neighbour filtering keeps the edges of pixels sharp.
        let options = TextureOptions::NEAREST;
        if self.uploaded.as_ref().is_none_or(|uploaded| !Arc::ptr_eq(uploaded, image)) {
            self.uploaded = Some(Arc::clone(image));
            match &mut self.texture {
                // A partial update of the same size avoids a reallocation.
                Some(texture) if texture.size() == image.size => {
                    texture.set_partial([0, 0], Arc::clone(image), options);
                }
                Some(texture) => texture.set(Arc::clone(image), options),
                None => self.texture = Some(ctx.load_texture("view", Arc::clone(image), options)),
            }
        }
        self.texture.as_ref().map(TextureHandle::id).unwrap_or_default()
    }
}

/// Shows the field for a seed. The seed takes effect once it is typed in full.
pub(crate) fn seed_field(ui: &mut Ui, seed: &mut u64, name: &str, hint: &str) {
    let field = DragValue::new(seed).speed(0.1).range(0..=LARGEST_SEED);
    ui.add(field.update_while_editing(false)).on_hover_text(hint).named(name);
}
