//! The layout of the views and of the areas next to them, and the dividers that the user drags between them.

use egui::accesskit::Role;
use egui::{CursorIcon, Pos2, Rect, Sense, Ui, Vec2, pos2, vec2};
use pinhole_core::ImageSize;
use pinhole_figure::typesetting::theme::STACKED;

use crate::model::session::{Split, Splits};
use crate::ui::widgets::{ResponseExt as _, arrows, inside, keep_arrows};

/// Height of the strip above each view, in points.
pub(crate) const STRIP: f32 = 26.0;
/// Width of the draggable divider between two areas, in points.
const HANDLE: f32 = 8.0;
/// Distance of the content of a column or a page from its edges, in points.
const MARGIN: f32 = 10.0;
/// Aspect ratio of an area from which on the column is beside the main figure rather than below it.
pub(crate) const WIDE: f32 = 1.2;
/// Minimum height of the numbers below the camera view, in points.
const NUMBERS: f32 = 240.0;
/// Movement of a divider by one press of an arrow key, in points.
const PUSH: f32 = 16.0;
/// Minimum size of a view, in points.
const SMALLEST: f32 = 120.0;

/// The rectangles of the pictures and of the content around them, in the middle of the window. They are in
/// points, aligned to physical pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ViewRects {
    /// The rectangle of the world view's picture.
    pub world: Option<Rect>,
    /// The rectangle of the world view's title and buttons: above its picture, or over its upper edge.
    pub world_title: Option<Rect>,
    /// The area that the camera view may fill.
    pub camera_area: Option<Rect>,
    /// The rectangle of the camera view's picture, with the image's aspect ratio.
    pub camera: Option<Rect>,
    /// The area for the second picture, next to the camera view: the error map, the picture of a wrong camera
    /// or of the ghost (a frozen camera), or the map of wrong answers.
    pub second_area: Option<Rect>,
    /// The rectangle of the second picture. It is as large as the camera view's picture.
    pub second: Option<Rect>,
    /// The area for the readouts or the page's content. It is below the pictures, next to them, or in
    /// their place.
    pub rest: Rect,
}

/// The areas into which the middle of the window is divided. They include the strips above the pictures, with
/// their titles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Areas {
    pub(crate) world: Option<Rect>,
    pub(crate) camera: Option<Rect>,
    /// The area of the picture next to the camera view. It is as large as the camera view's area.
    pub(crate) second: Option<Rect>,
    pub(crate) rest: Rect,
}

/// Divides the middle of the window into areas. Dragging the dividers between the areas changes `splits`.
pub(crate) struct Divider<'a> {
    pub(crate) ui: &'a Ui,
    pub(crate) whole: Rect,
    pub(crate) splits: &'a mut Splits,
    /// Size of the camera's image.
    pub(crate) image: ImageSize,
    /// Height of the numbers at the foot of a view that fills the page, in points; 0 if there are none.
    pub(crate) band: f32,
    /// True if all numbers are shown rather than the most important ones.
    pub(crate) has_all_numbers: bool,
}

impl Divider<'_> {
    /// Lets a view, the world view or the camera view, fill the page, with the numbers at its foot.
    pub(crate) fn figure_and_foot(&self, is_world: bool) -> Areas {
        let boundary = (self.whole.bottom() - self.band).max(self.whole.top());
        let (view, rest) = self.whole.split_top_bottom_at_y(boundary);
        let (world, camera) = if is_world { (Some(view), None) } else { (None, Some(view)) };
        Areas { world, camera, second: None, rest }
    }

    /// Puts the world view, the camera view and a second picture side by side, above the rest. In a narrow area,
    /// the world view is above both pictures.
    pub(crate) fn three_above(&mut self, split: Split) -> Areas {
        let (views, rest) = self.above(split);
        let (left, right) = match views.width() < STACKED {
            true => self.down(views, Split::Stack),
            false => self.across(views, Split::PracticeViews, "views handle"),
        };
        let (middle, right) = halves(right);
        Areas { world: Some(left), camera: Some(middle), second: Some(right), rest }
    }

    /// Splits the whole into the views and the area below them, which has the height that the user has set.
    /// Returns both.
    pub(crate) fn above(&mut self, split: Split) -> (Rect, Rect) {
        let area = self.whole;
        // Pictures that are compared keep half of the height.
        let compares = matches!(split, Split::Mistakes | Split::Answers);
        let share = if compares { 0.5 } else { 1.0 };
        let most = (share * area.height() - STRIP).min(area.height() - SMALLEST - STRIP).max(80.0);
        let height = self.splits.get(split).clamp(80.0, most);
        let boundary = area.bottom() - height;
        let handle = area.with_min_y(boundary - HANDLE).with_max_y(boundary);
        self.move_by(split, height, -drag(self.ui, handle, "readouts handle").y);
        (area.with_max_y(boundary - HANDLE), area.with_min_y(boundary).shrink2(vec2(MARGIN, 0.0)))
    }

    /// Stores the new position of a divider that is shown at `shown` and is dragged by `by`. Without a drag,
    /// the stored position stays, because a window that is temporarily too small must not change the user's
    /// choice.
    fn move_by(&mut self, split: Split, shown: f32, by: f32) {
        if by != 0.0 {
            self.splits.set(split, shown + by);
        }
    }

    /// Splits an area into a left and a right part, with a draggable divider between them.
    pub(crate) fn across(&mut self, area: Rect, split: Split, name: &str) -> (Rect, Rect) {
        let share = within(self.splits.get(split), area.width());
        let x = area.left() + share * area.width();
        let handle = area.with_min_x(x - HANDLE / 2.0).with_max_x(x + HANDLE / 2.0);
        self.move_by(split, share, drag(self.ui, handle, name).x / area.width().max(1.0));
        (area.with_max_x(handle.left()), area.with_min_x(handle.right()))
    }

    /// Splits an area into a top and a bottom part, with a draggable divider between them.
    fn down(&mut self, area: Rect, split: Split) -> (Rect, Rect) {
        let share = within(self.splits.get(split), area.height());
        let y = area.top() + share * area.height();
        let handle = area.with_min_y(y - HANDLE / 2.0).with_max_y(y + HANDLE / 2.0);
        let dragged = drag(self.ui, handle, "stack handle").y;
        self.move_by(split, share, dragged / area.height().max(1.0));
        (area.with_max_y(handle.top()), area.with_min_y(handle.bottom()))
    }
}

/// Returns the areas of a page without views.
pub(crate) fn no_views(divider: &mut Divider<'_>) -> Areas {
    Areas { world: None, camera: None, second: None, rest: divider.whole.shrink(MARGIN) }
}

/// Makes the world view the main figure, which reaches the edges, as on a lesson's stage. Beside it, or
/// below it in an area that is not wide, is a column of the camera view and the rest.
pub(crate) fn figure_and_column(divider: &mut Divider<'_>) -> Areas {
    let whole = divider.whole;
    let is_beside = whole.width() >= WIDE * whole.height();
    let (main, column) = match is_beside {
        true => divider.across(whole, Split::Views, "views handle"),
        false => divider.down(whole, Split::Stack),
    };
    let column = column.shrink(MARGIN);
    let aspect = divider.image.width() as f32 / divider.image.height() as f32;
    let (camera, rest) = if is_beside {
        let height = STRIP + column.width() / aspect;
        let most = (column.height() - NUMBERS).max(0.5 * column.height());
        let (above, below) = column.split_top_bottom_at_y(column.top() + height.min(most));
        (above, below.with_min_y(below.top() + MARGIN))
    } else {
        let width = (column.height() - STRIP) * aspect;
        let (left, right) =
            column.split_left_right_at_x(column.left() + width.min(0.5 * column.width()));
        (left, right.with_min_x(right.left() + MARGIN))
    };
    Areas { world: Some(main), camera: Some(camera), second: None, rest }
}

/// Makes the world view the main figure, as [`figure_and_column`] does. All numbers, if they are shown, are side
/// by side below figure and column.
pub(crate) fn figure_and_numbers(divider: &mut Divider<'_>) -> Areas {
    if !divider.has_all_numbers {
        return figure_and_column(divider);
    }
    let (views, rest) = divider.above(Split::Readouts);
    divider.whole = views;
    Areas { rest, ..figure_and_column(divider) }
}

/// Stacks both views, with the rest to their right. In a narrow area, puts them side by side, with the rest
/// below.
pub(crate) fn stack_beside(divider: &mut Divider<'_>) -> Areas {
    if divider.whole.width() < STACKED {
        let (views, rest) = divider.down(divider.whole, Split::Derivation);
        let (left, right) = halves(views);
        let rest = rest.shrink2(vec2(MARGIN, 0.0));
        return Areas { world: Some(left), camera: Some(right), second: None, rest };
    }
    let (views, rest) = divider.across(divider.whole, Split::Derivation, "derivation handle");
    let (top, bottom) = divider.down(views, Split::Stack);
    Areas { world: Some(top), camera: Some(bottom), second: None, rest: rest.shrink(MARGIN) }
}

impl ViewRects {
    /// Returns true if the world view is an inset over the camera view.
    pub(crate) fn has_world_inset(&self) -> bool {
        self.world
            .zip(self.camera)
            .is_some_and(|(world, camera)| world.intersects(camera) && world.area() < camera.area())
    }

    /// Lays out everything in these areas, with a title above each picture. The title of a world view that is
    /// the main figure is over the picture.
    pub(crate) fn new(areas: Areas, image: ImageSize, per_point: f32, is_bare: bool) -> Self {
        // Pictures that are compared always have their titles and legends.
        let is_compared = areas.second.is_some();
        let has_titles = is_compared || !is_bare;
        let below =
            |strip: f32| move |rect: Rect| snapped(rect.with_min_y(rect.top() + strip), per_point);
        let world = areas.world.map(below(if is_compared { STRIP } else { 0.0 }));
        let world_title = areas.world.filter(|_| has_titles);
        let world_title = world_title.map(|rect| rect.with_max_y(rect.top() + STRIP));
        let below_title = below(if has_titles { STRIP } else { 0.0 });
        let [camera_area, second_area] =
            [areas.camera, areas.second].map(|part| part.map(below_title));
        // Two pictures that are compared have the same size, even if their areas were rounded differently.
        let both = camera_area.zip(second_area).map(|(a, b)| a.size().min(b.size()));
        let of_both = |area: Rect| Rect::from_min_size(area.min, both.unwrap_or(area.size()));
        let [camera_area, second_area] = [camera_area, second_area].map(|area| area.map(of_both));
        let fitted = |area| fitted(area, image, per_point, !is_bare);
        let (camera, second) = (camera_area.map(fitted), second_area.map(fitted));
        ViewRects { world, world_title, camera_area, camera, second_area, second, rest: areas.rest }
    }
}

/// Shows the title of a picture, above its area.
pub(crate) fn strip_above(ui: &mut Ui, area: Rect, content: impl FnOnce(&mut Ui)) {
    strip(ui, above(area), content);
}

/// Returns the rectangle of the title above a picture's area.
pub(crate) fn above(area: Rect) -> Rect {
    area.with_min_y(area.top() - STRIP).with_max_y(area.top())
}

/// Shows a title in this rectangle.
pub(crate) fn strip(ui: &mut Ui, rect: Rect, content: impl FnOnce(&mut Ui)) {
    inside(ui, rect.shrink2(vec2(4.0, 0.0)), |ui| {
        ui.spacing_mut().interact_size.y = ui.spacing().interact_size.y.min(STRIP);
        ui.horizontal_centered(content)
    });
}

/// Clamps a fraction of a length so that both parts are large enough. If the length is too small for
/// that, both get half of it.
fn within(share: f32, length: f32) -> f32 {
    let least = SMALLEST / length.max(2.0 * SMALLEST);
    share.clamp(least, 1.0 - least)
}

/// Splits an area into two of equal size.
pub(crate) fn halves(area: Rect) -> (Rect, Rect) {
    let x = area.center().x;
    (area.with_max_x(x - HANDLE / 2.0), area.with_min_x(x + HANDLE / 2.0))
}

/// Shows a divider. Returns its movement in this pass, by a drag or by arrow keys.
fn drag(ui: &Ui, rect: Rect, name: &str) -> Vec2 {
    let vertical = rect.height() > rect.width();
    let (cursor, line) = match vertical {
        true => (CursorIcon::ResizeHorizontal, vec2(2.0, 36.0)),
        false => (CursorIcon::ResizeVertical, vec2(36.0, 2.0)),
    };
    let response = ui.interact(rect, ui.scope_id().with(name), Sense::drag());
    let response = response.on_hover_cursor(cursor).with_role(Role::Splitter).named(name);
    let visuals = ui.style().interact(&response);
    let line = Rect::from_center_size(rect.center(), line);
    ui.painter().rect_filled(line, 1.0, visuals.fg_stroke.color.gamma_multiply(0.5));
    if !response.has_focus() {
        return response.drag_delta();
    }
    keep_arrows(&response, vertical, !vertical);
    let arrows = PUSH * arrows(ui.ctx());
    response.drag_delta() + if vertical { vec2(arrows.x, 0.0) } else { vec2(0.0, arrows.y) }
}

/// Returns the rectangle with its corners on physical pixels, so that pictures stay sharp.
fn snapped(rect: Rect, per_point: f32) -> Rect {
    let snap = |at: Pos2| (at * per_point).round() / per_point;
    Rect::from_min_max(snap(rect.min), snap(rect.max))
}

/// Returns the largest rectangle in the area that has the image's aspect ratio, in the middle or, if `at_top`
/// is true, at the upper edge. If an image pixel covers three or more physical pixels in each direction,
/// their number is whole, so that all image pixels look alike.
fn fitted(area: Rect, image: ImageSize, per_point: f32, at_top: bool) -> Rect {
    let available = area.size() * per_point;
    let pixels = vec2(image.width() as f32, image.height() as f32);
    let scale = (available / pixels).min_elem();
    let scale = if scale >= 3.0 { scale.floor() } else { scale };
    let size = (scale * pixels).round().max(Vec2::splat(1.0));
    let min = area.center() - 0.5 * size / per_point;
    let min = if at_top { pos2(min.x, area.top()) } else { min };
    Rect::from_min_size((min * per_point).round() / per_point, size / per_point)
}
