//! Where the views and what stands beside them lie, for every layout of the window.

use egui::{Key, Rect, Sense, Ui, Vec2, pos2, vec2};
use pinhole_core::ImageSize;

use crate::model::session::{Settings, ViewLayout};
use crate::ui::tools::accuracy;

/// Height of the strip above each view, in points.
pub(crate) const STRIP: f32 = 26.0;
/// Width of the handle between two areas.
const HANDLE: f32 = 8.0;
/// How far an arrow key pushes a handle, in points.
const PUSH: f32 = 16.0;
/// No view gets smaller than this.
const SMALLEST: f32 = 120.0;

/// Where everything in the middle of the window lies, in points, on whole physical pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Places {
    /// The world view's picture.
    pub world: Option<Rect>,
    /// The part that the camera view may fill.
    pub camera_area: Option<Rect>,
    /// The camera view's picture, in the image's proportions.
    pub camera: Option<Rect>,
    /// The part that the picture beside the camera view may fill: the error map, what a wrong camera
    /// sees, or where answers are wrong.
    pub beside_area: Option<Rect>,
    /// That picture, as large as the camera view's.
    pub beside: Option<Rect>,
    /// What stands below the pictures, or beside or instead of them: the readouts, or what the
    /// layout has in their place.
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
        ViewLayout::Lines | ViewLayout::Exercises | ViewLayout::LedgerAlone => {
            return Places::of([None; 3], area, image, 1.0, 0.0);
        }
        // Nothing but the views.
        ViewLayout::Both | ViewLayout::World | ViewLayout::Camera if presenting => {
            (area, Rect::from_min_size(area.left_bottom(), Vec2::ZERO))
        }
        ViewLayout::Ledger | ViewLayout::Translator => {
            split_across(ui, area, &mut settings.ledger_split, "ledger handle")
        }
        _ => split_at_bottom(ui, area, settings),
    };
    let parts = match settings.layout {
        ViewLayout::World => [Some(views), None, None],
        ViewLayout::Camera => [None, Some(views), None],
        ViewLayout::Accuracy => {
            // Below both, so that they are alike, room for the map's legend.
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
        ViewLayout::Ledger | ViewLayout::Translator => {
            let (top, bottom) = split_down(ui, views, &mut settings.stack_split);
            [Some(top), Some(bottom), None]
        }
        _ => {
            let (left, right) = split_across(ui, views, &mut settings.views_split, "views handle");
            [Some(left), Some(right), None]
        }
    };
    // What is beside the camera view has its title and legend before an audience, too.
    let strip = if presenting && parts[2].is_none() { 0.0 } else { STRIP };
    Places::of(parts, rest, image, ui.ctx().pixels_per_point(), strip)
}

impl Places {
    /// World view, camera view and what is beside it in these parts of the window, strips included.
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

/// The views, and below them what the layout has there, as high as it was last dragged to.
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

/// Left and right, with a handle between them.
fn split_across(ui: &Ui, area: Rect, share: &mut f32, name: &str) -> (Rect, Rect) {
    *share = within(*share, area.width());
    let x = area.left() + *share * area.width();
    let handle = Rect::from_x_y_ranges(x - HANDLE / 2.0..=x + HANDLE / 2.0, area.y_range());
    *share += drag(ui, handle, name).x / area.width().max(1.0);
    let left = Rect::from_min_max(area.min, pos2(handle.left(), area.bottom()));
    (left, Rect::from_min_max(pos2(handle.right(), area.top()), area.max))
}

/// Top and bottom, with a handle between them.
fn split_down(ui: &Ui, area: Rect, share: &mut f32) -> (Rect, Rect) {
    *share = within(*share, area.height());
    let y = area.top() + *share * area.height();
    let handle = Rect::from_x_y_ranges(area.x_range(), y - HANDLE / 2.0..=y + HANDLE / 2.0);
    *share += drag(ui, handle, "stack handle").y / area.height().max(1.0);
    let top = Rect::from_min_max(area.min, pos2(area.right(), handle.top()));
    (top, Rect::from_min_max(pos2(area.left(), handle.bottom()), area.max))
}

/// A share that leaves both sides large enough; where there is no room for two, both get half.
fn within(share: f32, length: f32) -> f32 {
    let least = SMALLEST / length.max(2.0 * SMALLEST);
    share.clamp(least, 1.0 - least)
}

/// Two areas of equal size.
fn halves(area: Rect) -> (Rect, Rect) {
    let x = area.center().x;
    let left = Rect::from_min_max(area.min, pos2(x - HANDLE / 2.0, area.bottom()));
    (left, Rect::from_min_max(pos2(x + HANDLE / 2.0, area.top()), area.max))
}

/// A handle that is dragged; how far it was just now.
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

/// How far the arrow keys push a handle that has the focus.
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

/// The rectangle with its corners on physical pixels, so that pictures stay sharp.
fn snapped(rect: Rect, per_point: f32) -> Rect {
    let snap = |x: f32| (x * per_point).round() / per_point;
    Rect::from_min_max(
        pos2(snap(rect.left()), snap(rect.top())),
        pos2(snap(rect.right()), snap(rect.bottom())),
    )
}

/// The largest rectangle in the image's proportions, centred; large pixels get a whole number of
/// physical ones each, so that all are alike.
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
