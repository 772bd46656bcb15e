//! The stage: the composition of a lesson's step and of an exercise, the same in the window and while
//! presenting, before and after the answer.
//!
//! The main figure fills the stage from edge to edge; a second picture is an inset in its corner, and the
//! numbers are a line at its foot. Beside it, or below it in a window that is not wide, a column has the
//! step's text, its question, the room for the answer, and a card of formulas. Nothing in it scrolls.

use egui::{Rect, Ui, Vec2, pos2, vec2};
use pinhole_core::ImageSize;

use crate::features::{exercises, lines, plot};
use crate::model::ViewLayout;
use crate::ui::PageContext;
use crate::ui::scene::view_rects::{Areas, STRIP, WIDE, halves};
use crate::ui::widgets::clipped;
use crate::ui::workspaces::{foot, hidden, page};

pub(crate) mod column;
pub(crate) mod navigation;

/// Width of the main figure, as a fraction of a wide window's.
const BESIDE_COLUMN: f32 = 0.58;
/// Height of the main figure, as a fraction of a window's that is not wide, of an upright window's, and of an
/// upright window's that has answer fields.
const ABOVE_COLUMN: [f32; 3] = [0.52, 0.525, 0.415];
/// Distance of an inset from the edges of the main figure, in points.
const MARGIN: f32 = 12.0;
/// Maximum size of an inset, as fractions of the main figure's width and height.
const INSET: Vec2 = vec2(0.3, 0.34);
/// Height of the world view above the graph of f(p + t d), as a fraction of the main figure's.
const ABOVE_GRAPH: f32 = 0.56;
/// Height of the pictures of two cameras, as a fraction of the main figure's.
const COMPARED: f32 = 0.47;

/// The rectangles of the stage, in points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stage {
    /// The area of the main figure.
    pub(crate) main: Rect,
    /// The area of the texts and formulas.
    pub(crate) column: Rect,
    /// The layout for which the areas were computed. A key may have chosen another one since.
    pub(crate) layout: ViewLayout,
    /// Height of the numbers at the foot of the main figure; 0 if there are none.
    pub(crate) band: f32,
    /// True if camera view and world view have changed places, as main figure and inset.
    pub(crate) is_swapped: bool,
}

impl Stage {
    /// Divides an area into figure and column.
    pub(crate) fn new(whole: Rect, layout: ViewLayout, band: f32) -> Stage {
        let aspect = whole.width() / whole.height().max(1.0);
        let (main, column) = if aspect >= WIDE {
            whole.split_left_right_at_x(whole.left() + BESIDE_COLUMN * whole.width())
        } else {
            let has_fields = layout == ViewLayout::Exercises;
            let upright = usize::from(aspect < 1.0);
            let share = ABOVE_COLUMN[upright * (1 + usize::from(has_fields))];
            whole.split_top_bottom_at_y(whole.top() + share * whole.height())
        };
        Stage { main, column, layout, band, is_swapped: false }
    }

    /// Returns the areas of the layout's views; `None` if the layout's page arranges the main figure itself.
    pub(crate) fn areas(&self, image: ImageSize) -> Option<Areas> {
        let Stage { main: whole, band, layout, .. } = *self;
        let (main, foot) = whole.split_top_bottom_at_y(whole.bottom() - band);
        let foot = foot.shrink2(vec2(MARGIN, 0.0));
        let picture = vec2(image.width() as f32, image.height() as f32);
        let areas = |world, camera, rest| Some(Areas { world, camera, second: None, rest });
        match layout {
            ViewLayout::Both | ViewLayout::Derivation => {
                let room = main.size() * INSET;
                areas(Some(main), Some(self.corner(picture * (room / picture).min_elem())), foot)
            }
            ViewLayout::World | ViewLayout::Exercises => areas(Some(main), None, foot),
            ViewLayout::Camera => {
                let inset = self.is_swapped.then(|| self.corner(main.size() * INSET));
                areas(inset, Some(main), foot)
            }
            ViewLayout::Plot => {
                let (world, graph) =
                    whole.split_top_bottom_at_y(whole.top() + ABOVE_GRAPH * whole.height());
                areas(Some(world), None, graph)
            }
            ViewLayout::Mistakes | ViewLayout::Compare => {
                let y = main.top() + COMPARED * main.height();
                let (camera, second) = halves(main.with_max_y(y));
                let world = Some(main.with_min_y(y - STRIP));
                let (camera, second) = (Some(camera), Some(second));
                Some(Areas { world, camera, second, rest: main.with_min_y(main.bottom()) })
            }
            ViewLayout::Lines => areas(None, None, whole),
            _ => None,
        }
    }

    /// Shows what belongs to the main figure beside its views, in `rest`, and the column.
    pub(crate) fn show(&self, ui: &mut Ui, rest: Rect, context: &mut PageContext<'_>) {
        let (layout, is_asking) = (self.layout, context.session.shown.is_asking);
        let is_composed = self.areas(context.open.document.camera.image).is_some();
        clipped(ui, rest, |ui| match layout {
            ViewLayout::Plot => plot::ui::graph(ui, context),
            ViewLayout::Lines if context.session.shows_exercise() => {
                exercises::ui::plane(ui, context.session);
            }
            ViewLayout::Lines if is_asking => {
                lines::view::draw_question(ui, &context.session.shown.lines)
            }
            ViewLayout::Lines => lines::ui::figure(ui, context),
            ViewLayout::Mistakes | ViewLayout::Compare | ViewLayout::Exercises => {}
            _ if is_composed && is_asking => {}
            _ if is_composed => foot(ui, context),
            _ if is_asking => hidden(ui),
            _ => (page(layout).rest)(ui, context),
        });
        column::show(ui, self, context);
    }

    /// Returns a rectangle of this size in the lower right corner of the main figure, above the numbers.
    fn corner(&self, size: Vec2) -> Rect {
        let end = self.main.max - Vec2::splat(MARGIN) - vec2(0.0, self.band);
        Rect::from_min_max(pos2(end.x - size.x, end.y - size.y), end)
    }
}
