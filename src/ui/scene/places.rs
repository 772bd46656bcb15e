//! The rectangles of the views and of the content beside them, for every layout of the window.

use egui::{Key, Rect, Sense, Ui, Vec2, pos2, vec2};
use pinhole_core::ImageSize;

use crate::model::session::{Settings, ViewLayout};
use crate::ui::tools::accuracy;

/// Height of the strip above each view, in points.
pub(crate) const STRIP: f32 = 26.0;
/// Width of the handle between two areas, in points.
const HANDLE: f32 = 8.0;
/// Movement of a handle by an arrow key, in points.
const PUSH: f32 = 16.0;
/// Minimum size of a view, in points.
const SMALLEST: f32 = 120.0;

/// The rectangles in the middle of the window, in points, aligned to physical pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Places {
    /// The rectangle of the world view's picture.
    pub world: Option<Rect>,
    /// The area that the camera view may fill.
    pub camera_area: Option<Rect>,
    /// The rectangle of the camera view's picture, with the image's aspect ratio.
    pub camera: Option<Rect>,
    /// The area for the picture beside the camera view: the error map, a wrong camera's picture,
    /// the ghost's, or the map of wrong answers.
    pub beside_area: Option<Rect>,
    /// The rectangle of that picture, as large as the camera view's.
    pub beside: Option<Rect>,
    /// The rest below, beside or instead of the pictures: the readouts, or the layout's own
    /// content.
    pub rest: Rect,
}

/// Lays out views and readouts, with handles between them that change `settings`.
pub(crate) fn places(
    ui: &mut Ui,
    settings: &mut Settings,
    image: ImageSize,
    presenting: bool,
) -> Places {
    let area = ui.available_rect_before_wrap();
    let (views, rest) = match settings.layout {
        ViewLayout::Lines | ViewLayout::Exercises | ViewLayout::DerivationAlone => {
            return Places::of([None; 3], area, image, 1.0, 0.0);
        }
        // Only the views.
        ViewLayout::Both | ViewLayout::World | ViewLayout::Camera if presenting => {
            (area, Rect::from_min_size(area.left_bottom(), Vec2::ZERO))
        }
        ViewLayout::Derivation | ViewLayout::Translator => {
            split_across(ui, area, &mut settings.derivation_split, "derivation handle")
        }
        _ => split_at_bottom(ui, area, settings),
    };
    let parts = match settings.layout {
        ViewLayout::World => [Some(views), None, None],
        ViewLayout::Camera => [None, Some(views), None],
        ViewLayout::Accuracy => {
            // Both pictures have the same size, so both leave room for the map's legend.
            let bottom = (views.bottom() - accuracy::LEGEND).max(views.top() + STRIP + 1.0);
            let (left, right) = halves(Rect::from_min_max(views.min, pos2(views.right(), bottom)));
            [None, Some(left), Some(right)]
        }
        ViewLayout::Mistakes | ViewLayout::Answers => {
            let (left, right) = halves(views);
            [None, Some(left), Some(right)]
        }
        ViewLayout::Compare => {
            let (left, right) =
                split_across(ui, views, &mut settings.compare_split, "views handle");
            let (middle, right) = halves(right);
            [Some(left), Some(middle), Some(right)]
        }
        ViewLayout::Derivation | ViewLayout::Translator => {
            let (top, bottom) = split_down(ui, views, &mut settings.stack_split);
            [Some(top), Some(bottom), None]
        }
        _ => {
            let (left, right) = split_across(ui, views, &mut settings.views_split, "views handle");
            [Some(left), Some(right), None]
        }
    };
    // The picture beside the camera view keeps its title and legend while presenting.
    let strip = if presenting && parts[2].is_none() { 0.0 } else { STRIP };
    Places::of(parts, rest, image, ui.ctx().pixels_per_point(), strip)
}

impl Places {
    /// Returns the rectangles of the world view, the camera view and the picture beside it for
    /// these areas, which include the strips.
    fn of(
        parts: [Option<Rect>; 3],
        rest: Rect,
        image: ImageSize,
        per_point: f32,
        strip: f32,
    ) -> Places {
        let below_strip = |rect: Rect| {
            snapped(Rect::from_min_max(pos2(rect.left(), rect.top() + strip), rect.max), per_point)
        };
        let [world, camera_area, beside_area] = parts.map(|part| part.map(below_strip));
        let fitted = |area| fitted(area, image, per_point);
        let (camera, beside) = (camera_area.map(fitted), beside_area.map(fitted));
        Places { world, camera_area, camera, beside_area, beside, rest }
    }
}

/// Splits the area into the views and the layout's content below them, whose height the user drags.
fn split_at_bottom(ui: &Ui, area: Rect, settings: &mut Settings) -> (Rect, Rect) {
    let most = (area.height() - SMALLEST - STRIP).max(80.0);
    let height = match settings.layout {
        ViewLayout::Accuracy => &mut settings.accuracy_height,
        ViewLayout::Frame => &mut settings.frame_height,
        ViewLayout::Plot => &mut settings.plot_height,
        ViewLayout::Mistakes => &mut settings.mistakes_height,
        ViewLayout::Compare => &mut settings.compare_height,
        ViewLayout::Answers => &mut settings.answers_height,
        _ => &mut settings.readouts_height,
    };
    *height = height.clamp(80.0, most);
    let boundary = area.bottom() - *height;
    let handle = Rect::from_x_y_ranges(area.x_range(), boundary - HANDLE..=boundary);
    *height -= drag(ui, handle, "readouts handle").y;
    let views = Rect::from_min_max(area.min, pos2(area.right(), boundary - HANDLE));
    (views, Rect::from_min_max(pos2(area.left(), boundary), area.max))
}

/// Splits the area into left and right, with a handle between them.
fn split_across(ui: &Ui, area: Rect, share: &mut f32, name: &str) -> (Rect, Rect) {
    *share = within(*share, area.width());
    let x = area.left() + *share * area.width();
    let handle = Rect::from_x_y_ranges(x - HANDLE / 2.0..=x + HANDLE / 2.0, area.y_range());
    *share += drag(ui, handle, name).x / area.width().max(1.0);
    let left = Rect::from_min_max(area.min, pos2(handle.left(), area.bottom()));
    (left, Rect::from_min_max(pos2(handle.right(), area.top()), area.max))
}

/// Splits the area into top and bottom, with a handle between them.
fn split_down(ui: &Ui, area: Rect, share: &mut f32) -> (Rect, Rect) {
    *share = within(*share, area.height());
    let y = area.top() + *share * area.height();
    let handle = Rect::from_x_y_ranges(area.x_range(), y - HANDLE / 2.0..=y + HANDLE / 2.0);
    *share += drag(ui, handle, "stack handle").y / area.height().max(1.0);
    let top = Rect::from_min_max(area.min, pos2(area.right(), handle.top()));
    (top, Rect::from_min_max(pos2(area.left(), handle.bottom()), area.max))
}

/// Clamps a share so that both sides are large enough; if there is no room for two, both get half.
fn within(share: f32, length: f32) -> f32 {
    let least = SMALLEST / length.max(2.0 * SMALLEST);
    share.clamp(least, 1.0 - least)
}

/// Splits the area into two of equal size.
fn halves(area: Rect) -> (Rect, Rect) {
    let x = area.center().x;
    let left = Rect::from_min_max(area.min, pos2(x - HANDLE / 2.0, area.bottom()));
    (left, Rect::from_min_max(pos2(x + HANDLE / 2.0, area.top()), area.max))
}

/// Shows a handle. Returns its movement in this frame.
fn drag(ui: &Ui, rect: Rect, name: &str) -> Vec2 {
    let vertical = rect.height() > rect.width();
    let cursor = if vertical {
        egui::CursorIcon::ResizeHorizontal
    } else {
        egui::CursorIcon::ResizeVertical
    };
    let response =
        ui.interact(rect, ui.scope_id().with(name), Sense::drag()).on_hover_cursor(cursor);
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(egui::accesskit::Role::Splitter);
        node.set_label(name);
    });
    let visuals = ui.style().interact(&response);
    let line = if vertical {
        Rect::from_center_size(rect.center(), vec2(2.0, 36.0))
    } else {
        Rect::from_center_size(rect.center(), vec2(36.0, 2.0))
    };
    ui.painter().rect_filled(line, 1.0, visuals.fg_stroke.color.gamma_multiply(0.5));
    response.drag_delta() + pushed(ui, &response, vertical)
}

/// Returns the movement of a focused handle by the arrow keys.
fn pushed(ui: &Ui, response: &egui::Response, vertical: bool) -> Vec2 {
    if !response.has_focus() {
        return Vec2::ZERO;
    }
    let arrows = egui::EventFilter {
        horizontal_arrows: vertical,
        vertical_arrows: !vertical,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let presses = |key| ui.input(|i| i.num_presses(key)) as f32;
    let along = |back, forth| PUSH * (presses(forth) - presses(back));
    if vertical {
        vec2(along(Key::ArrowLeft, Key::ArrowRight), 0.0)
    } else {
        vec2(0.0, along(Key::ArrowUp, Key::ArrowDown))
    }
}

/// Returns the rectangle with its corners on physical pixels, so that pictures stay sharp.
fn snapped(rect: Rect, per_point: f32) -> Rect {
    let snap = |x: f32| (x * per_point).round() / per_point;
    Rect::from_min_max(
        pos2(snap(rect.left()), snap(rect.top())),
        pos2(snap(rect.right()), snap(rect.bottom())),
    )
}

/// Returns the largest centred rectangle with the image's aspect ratio. If pixels are large, each
/// gets a whole number of physical pixels, so that all are alike.
fn fitted(area: Rect, image: ImageSize, per_point: f32) -> Rect {
    let available = area.size() * per_point;
    let pixels = vec2(image.width() as f32, image.height() as f32);
    let scale = (available.x / pixels.x).min(available.y / pixels.y);
    let scale = if scale >= 3.0 { scale.floor() } else { scale };
    let size = vec2((pixels.x * scale).round().max(1.0), (pixels.y * scale).round().max(1.0));
    let min = area.center() - 0.5 * size / per_point;
    let min = pos2((min.x * per_point).round(), (min.y * per_point).round()) / per_point;
    Rect::from_min_size(min, size / per_point)
}
