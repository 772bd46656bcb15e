//! The parts of the figure: all that is drawn of the camera, its selected ray, what is compared with them, the world's
//! axes, the spheres that are cut away, and a highlighted object. A part says what it is in space, to which overlay item
//! it belongs, which concept it stands for, and its label.
//!
//! The list is made without knowing who looks at it. The world view draws it as the observer sees it, the camera
//! view draws the highlighted parts as the camera sees them, and the observer is fitted to it.

pub(super) mod camera;
pub(super) mod compared;
pub(super) mod emphasis;
pub(super) mod ray;
pub(super) mod sight;
mod sphere_figure;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, DVec2, DVec3, ResolvedCamera, Scene, Sphere};

use crate::observer::{Length, Place};
use crate::overlay::{
    BUD, Colors, Emphasis, GhostCamera, Head, Highlighted, LabelFont, LineStyle, POINT, STRONG,
    Same, Style,
};
use crate::{AnswerMark, Concept, Inspection, Item, Observer, OverlayItems};

/// Maximum number of spheres that a mark takes into account: that a pane makes room for, that the frustum
/// reaches beyond, and among which the one closest to the ray is looked for.
pub(super) const ASKED_SPHERES: usize = 1024;

/// What a part makes of its places.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    /// A polyline.
    Line,
    /// An arrow.
    Arrow(Head),
    /// A line with an arrowhead at each end.
    Dimension,
    /// The sides of a polygon.
    Sides,
    /// A flat polygon through which one sees, with its sides.
    Area,
    /// A side of a solid, through which one sees. It is drawn if it faces the observer, unlike this point inside.
    Face(DVec3),
    /// A disc of this radius in points.
    Point(f32),
    /// A thin ring around this radius in points: a point of a student's answer.
    Ring(f32),
    /// A thick ring inside this radius in points: a root that is not the first hit.
    Hole(f32),
    /// The outline of a sphere as the observer sees it.
    Outline(Sphere),
    /// The box that stands for a camera too small to be seen.
    Body,
    /// The marks of the image's top edge and of pixel (0, 0).
    Marks,
    /// The numbers of rows and columns.
    PixelNumbers,
}

/// When a part is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum When {
    /// If its item is shown and, strongly, if its concept is highlighted.
    Shown,
    /// If its item is shown, but not while its concept is highlighted: other parts then stand for it.
    Unlit,
    /// While its concept is highlighted.
    Lit,
}

/// The label of a part.
#[derive(Clone, Debug)]
pub(crate) struct PartLabel {
    pub(crate) text: String,
    pub(crate) font: LabelFont,
    /// The point that the label names; `None` for the middle of a line, or the tip of an arrow.
    pub(crate) at: Option<Place>,
    pub(crate) toward: Toward,
}

/// The preferred direction from a part to its label.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Toward {
    /// A direction on the screen.
    Screen(DVec2),
    /// The sum of the directions on the screen that these vectors have there, each times a weight.
    World([(f64, DVec3); 2]),
    /// The direction of the arrow, or the side to which the part is moved.
    Onward,
}

/// A part of the figure.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) form: Form,
    pub(crate) places: Vec<Place>,
    pub(crate) pen: LineStyle,
    pub(crate) when: When,
    pub(crate) label: Option<PartLabel>,
    /// The width of its lines while its concept is highlighted.
    pub(crate) strong: f32,
    /// The length with which it begins to grow, as a share of its own; above 1 if it is shortened.
    pub(crate) bud: f64,
    /// Set if the part is drawn beside its place, as a dimension line is. If the vector is not zero, the part is on
    /// the other side.
    pub(crate) beside: Option<DVec3>,
    /// True if it need not be in sight as a whole.
    pub(crate) is_endless: bool,
}

impl Part {
    fn when(&mut self, when: When) -> &mut Part {
        self.when = when;
        self
    }

    /// Keeps the part's lines as wide as they are while its concept is highlighted.
    fn as_wide(&mut self) -> &mut Part {
        self.strong = self.pen.width;
        self
    }

    fn endless(&mut self) -> &mut Part {
        self.is_endless = true;
        self
    }

    /// Gives the part a label.
    fn labelled(&mut self, text: impl Into<String>, font: LabelFont, toward: Toward) -> &mut Part {
        self.label = Some(PartLabel { text: text.into(), font, at: None, toward });
        self
    }

    /// Puts the part's label at a place of its own.
    fn label_at(&mut self, at: impl Into<Place>) -> &mut Part {
        if let Some(label) = &mut self.label {
            label.at = Some(at.into());
        }
        self
    }

    /// Gives an arrow a label at its tip.
    fn named(&mut self, text: impl Into<String>, font: LabelFont) -> &mut Part {
        self.labelled(text, font, Toward::Onward)
    }

    /// Gives a point a label in this direction on the screen.
    fn named_toward(&mut self, text: impl Into<String>, x: f64, y: f64) -> &mut Part {
        self.labelled(text, POINT, Toward::Screen(DVec2::new(x, y)))
    }
}

impl Toward {
    /// The direction on the screen of one vector.
    fn along(vector: DVec3) -> Toward {
        Toward::World([(1.0, vector), (0.0, DVec3::ZERO)])
    }
}

/// What is drawn, from which the parts are made together with the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The edited camera as the user gives it; it may have no basis.
    pub camera: Camera,
    /// The edited camera, if it has a basis.
    pub resolved: Option<ResolvedCamera>,
    /// The selected ray and its hits.
    pub inspection: Option<Same<Inspection>>,
    /// The t of the point marked on the selected ray.
    pub ray_point_t: Option<f64>,
    /// The camera that is compared with the edited one.
    pub ghost: Option<GhostCamera>,
    /// The marks for answers: typed ones and the right ones.
    pub answers: Arc<[AnswerMark]>,
    /// The overlay items to draw.
    pub items: OverlayItems,
    /// The highlighted concept, if any.
    pub highlighted: Option<Highlighted>,
    /// True if the observer is directed to a part of the figure.
    pub is_directed: bool,
    /// True if all parts have labels, as in lessons and figures. Otherwise only the camera's main parts
    /// and the highlighted concept have labels.
    pub names_all: bool,
    /// True if the normal at the hit is drawn, as in figures and in lessons about it.
    pub shows_normal: bool,
    /// Length in the world of the up arrow while its tip is dragged; `None` at other times.
    pub up: Option<f64>,
    /// True for the camera view, where arrows from the eye have length 1 at most.
    pub is_flat: bool,
    /// The observer, on whose distance it depends how far endless lines go.
    pub observer: Observer,
    /// The colours.
    pub style: Style,
}

/// A part that is drawn, restyled by its emphasis.
pub(crate) struct DrawnPart {
    pub(crate) part: Part,
    pub(crate) emphasis: Emphasis,
    /// True if it belongs to the ghost or to a sphere that is cut away.
    pub(crate) is_behind: bool,
}

/// A sphere that is cut away, with its index and its colour.
pub(crate) type CutAway = (u32, Sphere, Color32);

/// The list of parts while it is made.
pub(crate) struct Parts<'a> {
    figure: &'a Figure,
    scene: &'a Scene,
    colors: &'static Colors,
    list: Vec<Part>,
}

impl Figure {
    /// Creates the figure of a camera alone, with the names of all its parts, in which no item is shown.
    pub fn new(camera: Camera, observer: Observer) -> Figure {
        Figure {
            camera,
            resolved: camera.resolve().ok(),
            inspection: None,
            ray_point_t: None,
            ghost: None,
            answers: Arc::default(),
            items: OverlayItems::NONE,
            highlighted: None,
            is_directed: false,
            names_all: true,
            shows_normal: true,
            up: None,
            is_flat: false,
            observer,
            style: Style::default(),
        }
    }

    /// Returns the parts that are drawn, from back to front.
    pub(crate) fn parts(&self, scene: &Scene, cut_away: &[CutAway]) -> Vec<DrawnPart> {
        let colors = self.style.colors();
        let mut parts = Parts { figure: self, scene, colors, list: Vec::new() };
        parts.cut_away(cut_away);
        // The camera's own marks cover those of the ghost.
        if let Some(ghost) = &self.ghost {
            parts.ghost(ghost);
        }
        let behind = parts.list.len();
        parts.camera();
        parts.answers();
        parts.object();
        let drawn = |(k, part): (usize, Part)| {
            let mut emphasis = part.emphasis(self.items, self.highlighted)?;
            // What a step's subject is compared with belongs to it.
            if k < behind && self.highlighted.is_some_and(|lit| lit.is_of_step) {
                emphasis = Emphasis::Plain;
            }
            let growth = self.highlighted.map_or(1.0, |lit| lit.growth);
            let part = part.emphasized(emphasis, growth);
            Some(DrawnPart { part, emphasis, is_behind: k < behind })
        };
        parts.list.into_iter().enumerate().filter_map(drawn).collect()
    }

    fn is_lit(&self, concept: Concept) -> bool {
        self.highlighted.is_some_and(|lit| lit.concept == concept)
    }

    /// Returns where an endless line ends.
    fn far(&self) -> f64 {
        100.0 * self.observer.distance()
    }

    /// Returns true if an item is shown.
    fn shows(&self, item: Item) -> bool {
        self.items.shows(item)
    }
}

impl Parts<'_> {
    fn add(&mut self, form: Form, places: &[Place], pen: LineStyle) -> &mut Part {
        let (places, when, strong, bud) = (places.to_vec(), When::Shown, STRONG, BUD);
        let (label, beside, is_endless) = (None, None, false);
        let part = Part { form, places, pen, when, label, strong, bud, beside, is_endless };
        self.list.push(part);
        let last = self.list.len() - 1;
        &mut self.list[last]
    }

    fn line<const N: usize>(&mut self, points: [impl Into<Place>; N], pen: LineStyle) -> &mut Part {
        self.add(Form::Line, &points.map(Into::into), pen)
    }

    fn arrow(&mut self, ends: [impl Into<Place>; 2], head: Head, pen: LineStyle) -> &mut Part {
        self.add(Form::Arrow(head), &ends.map(Into::into), pen)
    }

    /// Adds an arrow from a point, whose vector is in units of the basis arrows' length.
    fn arrow_from(&mut self, at: DVec3, along: DVec3, head: Head, pen: LineStyle) -> &mut Part {
        self.arrow([at.into(), Place { at, along, length: Length::Arrow }], head, pen)
    }

    fn dimension(&mut self, ends: [DVec3; 2], pen: LineStyle) -> &mut Part {
        self.add(Form::Dimension, &ends.map(Into::into), pen)
    }

    fn sides(&mut self, corners: [DVec3; 4], pen: LineStyle) -> &mut Part {
        self.add(Form::Sides, &corners.map(Into::into), pen)
    }

    fn point(&mut self, at: DVec3, radius: f32, pen: LineStyle) -> &mut Part {
        self.add(Form::Point(radius), &[at.into()], pen)
    }
}
